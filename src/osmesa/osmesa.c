/* The OSMesa API: contexts and the buffers that they draw to. Behaviour as Mesa 22.3's (docs/departures.md has the differences). */
#include "osmesa/osmesa.h"
#include "api/array_object.h"
#include "api/attrib.h"
#include "api/buffer.h"
#include "api/errors.h"
#include "api/eval_map.h"
#include "api/framebuffer_object.h"
#include "api/immediate.h"
#include "api/list.h"
#include "api/proc_address.h"
#include "api/query.h"
#include "api/sampler.h"
#include "fixedgl.h"
#include "framebuffer/imaging.h"
#include "pipeline/explain.h"
#include "pipeline/pipeline.h"
#include "state/share.h"
#include "texture/texture.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_SIZE = FGL_MAX_VIEWPORT };

/* ---- creating ---- */

static bool known_format(GLenum format)
{
    return format == OSMESA_RGBA || format == OSMESA_BGRA || format == OSMESA_ARGB || format == OSMESA_RGB ||
           format == OSMESA_BGR || format == OSMESA_RGB_565 || format == OSMESA_COLOR_INDEX;
}

/* OSMesa has 16-bit depth when asked for 16..23 bits without stencil, else 24, or none. */
static int choose_depth_bits(int depth, int stencil)
{
    if (stencil > 0)
        return depth > 0 ? 24 : 0;
    return depth >= 24 ? 24 : depth >= 16 ? 16 : 0;
}

/* glFlush and glFinish. */
static void present(struct context *ctx)
{
    struct osmesa_context *c = ctx->osmesa;
    if (!c->buffer || !c->fb.drawn)
        return;
    c->fb.drawn = false;
    fgl_osmesa_copy_color(c);
    if (c->depth_snapshot)
        fgl_osmesa_copy_depth(c);
}

static bool init_context(struct osmesa_context *c, OSMesaContext share)
{
    struct context *ctx = &c->gl;
    fgl_state_init(ctx);
    ctx->osmesa = c;
    ctx->color_index = c->format == OSMESA_COLOR_INDEX;
    ctx->present = present;
    ctx->immediate = fgl_immediate_create();
    ctx->vertices = ctx->immediate;
    ctx->pipeline = fgl_pipeline_create();
    if (share) {
        fgl_share_join(share->gl.share);
        fgl_list_store_retain(share->gl.lists);
        fgl_buffer_store_retain(share->gl.buffers);
        fgl_texture_store_retain(share->gl.textures);
        fgl_renderbuffer_store_retain(share->gl.renderbuffers);
        fgl_sampler_store_retain(share->gl.samplers);
    }
    ctx->share = share ? share->gl.share : fgl_share_create();
    ctx->buffers = share ? share->gl.buffers : fgl_buffer_store_create();
    ctx->lists = share ? share->gl.lists : fgl_list_store_create();
    ctx->renderbuffers = share ? share->gl.renderbuffers : fgl_renderbuffer_store_create();
    ctx->samplers = share ? share->gl.samplers : fgl_sampler_store_create();
    ctx->textures = share ? share->gl.textures : fgl_texture_store_create();
    return ctx->immediate && ctx->pipeline && ctx->share && ctx->lists && ctx->buffers && ctx->textures && ctx->samplers &&
           ctx->renderbuffers && fgl_texture_context_init(ctx);
}

static OSMesaContext create(GLenum format, int depth, int stencil, int accum, OSMesaContext share)
{
    if (!known_format(format))
        return NULL;
    struct osmesa_context *c = calloc(1, sizeof *c);
    if (!c)
        return NULL;
    c->format = format;
    c->y_up = true;
    c->fb.depth_bits = choose_depth_bits(depth, stencil);
    c->fb.depth_max = (uint32_t)((1u << c->fb.depth_bits) - 1);
    c->fb.stencil_bits = stencil > 0 ? 8 : 0;
    c->fb.accum_bits = accum > 0 && format != OSMESA_COLOR_INDEX ? 16 : 0; /* GL 1.5, 4.2.4: RGBA mode only */
    c->fb.has_alpha = format == OSMESA_RGBA || format == OSMESA_BGRA || format == OSMESA_ARGB;
    c->fb.reordered = format != OSMESA_RGBA;
    if (!init_context(c, share)) {
        OSMesaDestroyContext(c);
        return NULL;
    }
    return c;
}

OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist)
{
    return create(format, 24, 8, 0, sharelist);
}

OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits,
                                                OSMesaContext sharelist)
{
    return create(format, depthBits, stencilBits, accumBits, sharelist);
}

OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int *attribList, OSMesaContext sharelist)
{
    int format = OSMESA_RGBA, profile = OSMESA_COMPAT_PROFILE, major = 1, minor = 0;
    int bits[3] = {0, 0, 0};
    for (const int *a = attribList; a && *a; a += 2) {
        switch (a[0]) {
        case OSMESA_FORMAT: format = a[1]; break;
        case OSMESA_DEPTH_BITS:
        case OSMESA_STENCIL_BITS:
        case OSMESA_ACCUM_BITS:
            if (a[1] < 0)
                return NULL;
            bits[a[0] - OSMESA_DEPTH_BITS] = a[1];
            break;
        case OSMESA_PROFILE: profile = a[1]; break;
        case OSMESA_CONTEXT_MAJOR_VERSION: major = a[1]; break;
        case OSMESA_CONTEXT_MINOR_VERSION: minor = a[1]; break;
        default: return NULL;
        }
    }
    if (profile != OSMESA_COMPAT_PROFILE || major > 1 || minor > 5)
        return NULL;
    return create((GLenum)format, bits[0], bits[1], bits[2], sharelist);
}

void GLAPIENTRY OSMesaDestroyContext(OSMesaContext c)
{
    if (!c)
        return;
    if (fgl_current == &c->gl)
        fgl_current = NULL;
    fgl_list_compiler_destroy(&c->gl);
    fgl_list_store_release(c->gl.lists);
    fgl_framebuffers_destroy(&c->gl);
    fgl_renderbuffer_store_release(c->gl.renderbuffers);
    fgl_texture_context_free(&c->gl);
    fgl_texture_store_release(c->gl.textures);
    fgl_sampler_store_release(c->gl.samplers);
    fgl_queries_destroy(&c->gl);
    fgl_client_attrib_destroy(&c->gl);
    fgl_array_objects_destroy(&c->gl);
    fgl_buffer_store_release(c->gl.buffers);
    fgl_eval_maps_destroy(&c->gl);
    fgl_imaging_destroy(&c->gl);
    fgl_immediate_destroy(c->gl.immediate);
    fgl_pipeline_destroy(c->gl.pipeline);
    fgl_framebuffer_free(&c->fb);
    fgl_share_part(c->gl.share);
    free(c->gl.attrib_stack);
    free(c->depth_snapshot);
    free(c);
}

/* ---- making current ---- */

/* How colour is kept for a buffer of this type; false when format and type do not go together. */
static bool choose_kind(GLenum format, GLenum type, enum color_kind *kind)
{
    if (format == OSMESA_RGB_565) {
        *kind = COLOR_565;
        return type == GL_UNSIGNED_SHORT_5_6_5;
    }
    if (format == OSMESA_COLOR_INDEX) {
        *kind = COLOR_INDEX8;
        return type == GL_UNSIGNED_BYTE;
    }
    switch (type) {
    case GL_UNSIGNED_BYTE: *kind = COLOR_UNORM8; return true;
    case GL_UNSIGNED_SHORT: *kind = COLOR_UNORM16; return format != OSMESA_BGR;
    case GL_FLOAT: *kind = COLOR_FLOAT; return format != OSMESA_BGR;
    default: return false;
    }
}

/* GL 1.5, 2.11.1 and 4.1.2: viewport and scissor box are the window's size when a context is first made current. */
static void set_initial_window(struct context *ctx, int width, int height)
{
    if (ctx->viewport_set)
        return;
    ctx->viewport_set = true;
    const int box[4] = {0, 0, width, height};
    memcpy(ctx->s.viewport.viewport, box, sizeof box);
    memcpy(ctx->s.scissor.scissor_box, box, sizeof box);
}

GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext c, void *buffer, GLenum type, GLsizei width, GLsizei height)
{
    if (!c && !buffer) {
        if (fgl_current)
            FGL_SHARED(fgl_current, fgl_framebuffer_store(fgl_current));
        fgl_current = NULL;
        return GL_TRUE;
    }
    enum color_kind kind;
    if (!c || !buffer || width < 1 || height < 1 || width > MAX_SIZE || height > MAX_SIZE || !choose_kind(c->format, type, &kind))
        return GL_FALSE;
    if (fgl_current)
        FGL_SHARED(fgl_current, fgl_framebuffer_store(fgl_current));
    if (!fgl_framebuffer_resize(&c->fb, width, height, kind))
        return GL_FALSE;
    free(c->depth_snapshot);
    c->depth_snapshot = NULL;
    c->buffer = buffer;
    c->type = type;
    fgl_framebuffer_set_window(&c->gl, &c->fb);
    set_initial_window(&c->gl, width, height);
    c->gl.dirty = DIRTY_ALL;
    fgl_current = &c->gl;
    return GL_TRUE;
}

OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void) { return fgl_current ? fgl_current->osmesa : NULL; }

/* ---- parameters and buffers ---- */

void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value)
{
    struct osmesa_context *c = OSMesaGetCurrentContext();
    if (!c)
        return;
    if (pname == OSMESA_ROW_LENGTH && value >= 0)
        c->row_length = value;
    else if (pname == OSMESA_Y_UP)
        c->y_up = value != 0;
}

void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint *value)
{
    const struct osmesa_context *c = OSMesaGetCurrentContext();
    if (!c)
        return;
    switch (pname) {
    case OSMESA_WIDTH: *value = c->fb.width; break;
    case OSMESA_HEIGHT: *value = c->fb.height; break;
    case OSMESA_FORMAT: *value = (GLint)c->format; break;
    case OSMESA_TYPE: *value = (GLint)c->type; break;
    case OSMESA_ROW_LENGTH: *value = c->row_length; break;
    case OSMESA_Y_UP: *value = c->y_up; break;
    case OSMESA_MAX_WIDTH: case OSMESA_MAX_HEIGHT: *value = MAX_SIZE; break;
    default: break;
    }
}

GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext c, GLint *width, GLint *height, GLint *bytesPerValue, void **buffer)
{
    const int bytes = c && c->fb.depth_bits == 16 ? 2 : 4;
    if (c && c->fb.depth && !c->depth_snapshot)
        c->depth_snapshot = malloc((size_t)c->fb.width * (size_t)c->fb.height * (size_t)bytes);
    const bool ok = c && c->fb.depth && c->depth_snapshot;
    if (ok) {
        if (fgl_current == &c->gl)
            fgl_flush_vertices(&c->gl, 0);
        fgl_osmesa_copy_depth(c);
    }
    *width = ok ? c->fb.width : 0;
    *height = ok ? c->fb.height : 0;
    *bytesPerValue = ok ? bytes : 0;
    *buffer = ok ? c->depth_snapshot : NULL;
    return ok;
}

GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext c, GLint *width, GLint *height, GLint *format, void **buffer)
{
    const bool ok = c && c->buffer;
    *width = ok ? c->fb.width : 0;
    *height = ok ? c->fb.height : 0;
    *format = ok ? (GLint)c->format : 0;
    *buffer = ok ? c->buffer : NULL;
    return ok;
}

void GLAPIENTRY OSMesaColorClamp(GLboolean enable) { (void)enable; } /* changes no picture of Mesa's */

void GLAPIENTRY OSMesaPostprocess(OSMesaContext osmesa, const char *filter, unsigned enable_value)
{
    (void)osmesa;
    (void)filter;
    (void)enable_value;
}

static const struct {
    const char *name;
    OSMESAproc proc;
} osmesa_procs[] = {
#define PROC(name) {#name, (OSMESAproc)name}
    PROC(OSMesaCreateContext),    PROC(OSMesaCreateContextExt), PROC(OSMesaCreateContextAttribs),
    PROC(OSMesaDestroyContext),   PROC(OSMesaMakeCurrent),      PROC(OSMesaGetCurrentContext),
    PROC(OSMesaPixelStore),       PROC(OSMesaGetIntegerv),      PROC(OSMesaGetDepthBuffer),
    PROC(OSMesaGetColorBuffer),   PROC(OSMesaGetProcAddress),   PROC(OSMesaColorClamp),
    PROC(OSMesaPostprocess),      PROC(fixedglVersion),         PROC(fixedglAccuracy),
    PROC(fixedglExplainPixel),    PROC(fixedglExplain),
#undef PROC
};

OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char *funcName)
{
    if (!funcName)
        return NULL;
    for (size_t i = 0; i < FGL_COUNTOF(osmesa_procs); i++)
        if (strcmp(osmesa_procs[i].name, funcName) == 0)
            return osmesa_procs[i].proc;
    return fgl_proc_address(funcName);
}
