/* Renderbuffers: names, storage, queries (GL_ARB_framebuffer_object). */
#include "api/renderbuffer.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"

#include <stdlib.h>

struct renderbuffer_store {
    atomic_int references;
    struct idmap map; /* name -> struct renderbuffer */
};

/* ---- references ---- */

static void release(void *value)
{
    struct renderbuffer *r = value;
    if (!r || atomic_fetch_sub(&r->references, 1) != 1)
        return;
    fgl_texture_image_clear(&r->image);
    free(r);
}

void fgl_renderbuffer_refer(struct renderbuffer **slot, struct renderbuffer *r)
{
    if (r)
        atomic_fetch_add(&r->references, 1);
    release(*slot);
    *slot = r;
}

struct renderbuffer_store *fgl_renderbuffer_store_create(void)
{
    struct renderbuffer_store *store = calloc(1, sizeof *store);
    if (store)
        atomic_init(&store->references, 1);
    return store;
}

void fgl_renderbuffer_store_retain(struct renderbuffer_store *store)
{
    atomic_fetch_add(&store->references, 1);
}

void fgl_renderbuffer_store_release(struct renderbuffer_store *store)
{
    if (!store || atomic_fetch_sub(&store->references, 1) != 1)
        return;
    fgl_idmap_free(&store->map, release);
    free(store);
}

/* ---- names ---- */

struct renderbuffer *fgl_renderbuffer_lookup(const struct context *ctx, GLuint name)
{
    struct renderbuffer *r = fgl_idmap_get(&ctx->renderbuffers->map, name);
    return r && r->created ? r : NULL;
}

/* A new object under a free name; its one reference is the name's. NULL after recording GL_OUT_OF_MEMORY. */
static struct renderbuffer *add(struct context *ctx, GLuint name)
{
    struct renderbuffer *r = calloc(1, sizeof *r);
    if (!r || !fgl_idmap_put(&ctx->renderbuffers->map, name, r)) {
        free(r);
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return NULL;
    }
    atomic_init(&r->references, 1);
    r->name = name;
    r->internal_format = GL_RGBA;
    return r;
}

void fgl_exec_GenRenderbuffers(struct context *ctx, GLsizei n, GLuint *renderbuffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    const GLuint first = n ? fgl_idmap_find_free(&ctx->renderbuffers->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++) {
        if (!add(ctx, first + i))
            return;
        renderbuffers[i] = first + i;
    }
}

void fgl_exec_DeleteRenderbuffers(struct context *ctx, GLsizei n, const GLuint *renderbuffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; i++) {
        struct renderbuffer *r = fgl_idmap_get(&ctx->renderbuffers->map, renderbuffers[i]);
        if (!r)
            continue;
        fgl_framebuffer_detach(ctx, NULL, r);
        if (ctx->framebuffers && ctx->framebuffers->renderbuffer == r)
            fgl_renderbuffer_refer(&ctx->framebuffers->renderbuffer, NULL);
        release(fgl_idmap_remove(&ctx->renderbuffers->map, renderbuffers[i]));
    }
}

GLboolean fgl_exec_IsRenderbuffer(struct context *ctx, GLuint renderbuffer)
{
    return fgl_renderbuffer_lookup(ctx, renderbuffer) ? GL_TRUE : GL_FALSE;
}

/* OSMesa rule: as in GL_EXT_framebuffer_object a program may choose names. */
void fgl_exec_BindRenderbuffer(struct context *ctx, GLenum target, GLuint name)
{
    RETURN_ERROR_IF(ctx, target != GL_RENDERBUFFER, GL_INVALID_ENUM);
    struct framebuffers *f = fgl_framebuffers(ctx);
    struct renderbuffer *r = name ? fgl_idmap_get(&ctx->renderbuffers->map, name) : NULL;
    if (!f || (name && !r && !(r = add(ctx, name))))
        return;
    if (r)
        r->created = true;
    fgl_renderbuffer_refer(&f->renderbuffer, r);
}

/* ---- storage ---- */

static const struct texture_format stencil_format = {GL_STENCIL_INDEX8, GL_STENCIL_INDEX, TEXELS_DEPTH, ENCODED_UNORM, {0}};

/* The format of colours or depths, and whether there is a stencil; NULL: no format of renderbuffers. Table 3.16 and the stencil formats. */
static const struct texture_format *format_of(GLenum internal_format, bool *stencil)
{
    *stencil = true;
    switch (internal_format) {
    case GL_STENCIL_INDEX:
    case GL_STENCIL_INDEX1:
    case GL_STENCIL_INDEX4:
    case GL_STENCIL_INDEX8:
    case GL_STENCIL_INDEX16: return &stencil_format;
    default: break;
    }
    const struct texture_format *f = internal_format > 4 ? fgl_texture_format(internal_format) : NULL;
    *stencil = f && f->base_format == GL_DEPTH_STENCIL;
    return f && (f->kind == TEXELS_DEPTH || fgl_texture_format_drawable(f)) ? f : NULL;
}

/* Makes an image without texels or stencil what it says. */
static bool allocate(struct texture_image *image, const struct texture_format *format, bool stencil, int width, int height)
{
    const size_t pixels = (size_t)width * (size_t)height; /* at most 2^28 */
    *image = (struct texture_image){.width = width, .height = height, .depth = 1, .format = format, .kind = format->kind};
    if (format != &stencil_format)
        image->texels = calloc(pixels ? pixels : 1, fgl_texel_bytes(format->kind));
    if (stencil)
        image->stencil = calloc(pixels ? pixels : 1, 1);
    if ((format == &stencil_format || image->texels) && (!stencil || image->stencil))
        return true;
    fgl_texture_image_clear(image);
    return false;
}

/* OSMesa rule: sizes are compared before the format. */
static void storage(struct context *ctx, GLenum target, GLsizei samples, GLenum internal_format, GLsizei width, GLsizei height)
{
    struct renderbuffer *r = ctx->framebuffers ? ctx->framebuffers->renderbuffer : NULL;
    bool stencil;
    const struct texture_format *format = format_of(internal_format, &stencil);
    RETURN_ERROR_IF(ctx, target != GL_RENDERBUFFER, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !format, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, width < 0 || height < 0 || width > FGL_MAX_TEXTURE_SIZE || height > FGL_MAX_TEXTURE_SIZE, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, !r, GL_INVALID_OPERATION);
    struct texture_image image;
    RETURN_ERROR_IF(ctx, !allocate(&image, format, stencil, width, height), GL_OUT_OF_MEMORY);
    fgl_framebuffer_unload(ctx);
    fgl_texture_image_clear(&r->image);
    r->image = image;
    r->internal_format = internal_format;
    r->samples = samples;
}

void fgl_exec_RenderbufferStorage(struct context *ctx, GLenum target, GLenum internalformat, GLsizei width, GLsizei height)
{
    storage(ctx, target, 0, internalformat, width, height);
}

void fgl_exec_RenderbufferStorageMultisample(struct context *ctx, GLenum target, GLsizei samples, GLenum internalformat, GLsizei width,
                                             GLsizei height)
{
    RETURN_ERROR_IF(ctx, target != GL_RENDERBUFFER, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, samples < 0 || samples > FGL_MAX_SAMPLES, GL_INVALID_VALUE);
    storage(ctx, target, samples, internalformat, width, height);
}

int fgl_image_color_bits(const struct texture_image *image, int channel)
{
    if (!image->format || image->kind == TEXELS_DEPTH)
        return 0;
    const GLenum base = image->format->base_format;
    const bool shown = channel == 3 || base == GL_RED || base == GL_RG || base == GL_RGB || base == GL_RGBA;
    return shown ? image->format->bits[channel] : 0;
}

void fgl_exec_GetRenderbufferParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    const struct renderbuffer *r = ctx->framebuffers ? ctx->framebuffers->renderbuffer : NULL;
    RETURN_ERROR_IF(ctx, target != GL_RENDERBUFFER, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !r, GL_INVALID_OPERATION);
    const struct texture_image *image = &r->image;
    switch (pname) {
    case GL_RENDERBUFFER_WIDTH: *params = image->width; break;
    case GL_RENDERBUFFER_HEIGHT: *params = image->height; break;
    case GL_RENDERBUFFER_INTERNAL_FORMAT: *params = (GLint)r->internal_format; break;
    case GL_RENDERBUFFER_RED_SIZE:
    case GL_RENDERBUFFER_GREEN_SIZE:
    case GL_RENDERBUFFER_BLUE_SIZE:
    case GL_RENDERBUFFER_ALPHA_SIZE: *params = fgl_image_color_bits(image, (int)(pname - GL_RENDERBUFFER_RED_SIZE)); break;
    case GL_RENDERBUFFER_DEPTH_SIZE: *params = image->format && image->kind == TEXELS_DEPTH ? image->format->bits[0] : 0; break;
    case GL_RENDERBUFFER_STENCIL_SIZE: *params = image->stencil ? 8 : 0; break;
    case GL_RENDERBUFFER_SAMPLES: *params = r->samples; break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}
