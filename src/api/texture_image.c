/* glTexImage and glTexSubImage (GL 1.5, 3.8.1 "Texture Image Specification", 3.8.2 "Alternate Texture Image Specification
 * Commands"). */
#include "api/texture_image.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_unpack.h"
#include "state/share.h"
#include "texture/mipmap.h"

#include <stdlib.h>
#include <string.h>

/* ---- errors ---- */

static bool is_depth(GLenum internal_format)
{
    const struct texture_format *f = fgl_texture_format(internal_format);
    return f && f->kind == TEXELS_DEPTH;
}

/* Whether a level may have this size in one dimension. */
static bool size_fits(const struct texture_call *call, enum texture_target target, int size)
{
    const int levels = target == TEXTURE_RECTANGLE ? FGL_MAX_TEXTURE_LEVELS : fgl_texture_levels(target);
    return size - 2 * call->border <= 1 << (levels - 1 - call->level);
}

/* OSMesa rule: images of more than 2^31 bytes, the faces of a cube map together, are refused. */
static bool is_beyond_memory(const struct texture_call *call, enum texture_target target)
{
    const double texel_bytes = (double)fgl_texel_bytes(fgl_texture_format((GLenum)call->internal_format)->kind), most = 0x1p31;
    return texel_bytes * fgl_texture_faces(target) * call->width * fgl_max(call->height, 1) * fgl_max(call->depth, 1) > most;
}

GLenum fgl_texture_define_error(const struct texture_call *call, const struct image_target *t, bool *too_large)
{
    const int levels = fgl_texture_levels(t->target);
    const int smallest = 2 * call->border;
    if (call->level < 0 || call->level >= levels || call->border < 0 || call->border > (t->target == TEXTURE_RECTANGLE ? 0 : 1))
        return GL_INVALID_VALUE;
    if (call->width < smallest || (call->dimensions > 1 && call->height < smallest) ||
        (call->dimensions > 2 && call->depth < smallest))
        return GL_INVALID_VALUE;
    if (!fgl_texture_format((GLenum)call->internal_format))
        return GL_INVALID_VALUE;
    if (t->target == TEXTURE_CUBE_MAP && call->width != call->height)
        return GL_INVALID_VALUE;
    *too_large = !size_fits(call, t->target, call->width) || (call->dimensions > 1 && !size_fits(call, t->target, call->height)) ||
                 (call->dimensions > 2 && !size_fits(call, t->target, call->depth));
    *too_large |= t->proxy && is_beyond_memory(call, t->target);
    return *too_large && !t->proxy ? GL_INVALID_VALUE : GL_NO_ERROR;
}

static bool part_fits(int offset, int size, int whole)
{
    return offset >= 0 && size >= 0 && (int64_t)offset + size <= whole;
}

GLenum fgl_texture_part_error(const struct texture_call *call, const struct texture_image *image)
{
    if (call->width < 0 || call->height < 0 || call->depth < 0)
        return GL_INVALID_VALUE;
    if (!image->format)
        return GL_INVALID_OPERATION;
    const bool fits = part_fits(call->x, call->width, image->width) && part_fits(call->y, call->height, image->height) &&
                      part_fits(call->z, call->depth, image->depth);
    return fits ? GL_NO_ERROR : GL_INVALID_VALUE;
}

/* Of format and type alone, and together with the internal format. */
static GLenum pixels_error(const struct texture_call *call, const struct image_target *t, GLenum internal_format)
{
    const GLenum error = fgl_pixel_check(call->format, call->type);
    if (error)
        return error;
    if (call->format == GL_STENCIL_INDEX)
        return GL_INVALID_ENUM;
    if (is_depth(internal_format) != (call->format == GL_DEPTH_COMPONENT || call->format == GL_DEPTH_STENCIL))
        return GL_INVALID_OPERATION;
    if (is_depth(internal_format) && (t->target == TEXTURE_3D || t->target == TEXTURE_CUBE_MAP))
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

static GLenum image_error(const struct texture_call *call, struct image_target *t, bool *too_large)
{
    if (!fgl_image_target(call->target, call->dimensions, t))
        return GL_INVALID_ENUM;
    const GLenum error = fgl_texture_define_error(call, t, too_large);
    return error ? error : pixels_error(call, t, (GLenum)call->internal_format);
}

static GLenum sub_image_error(struct context *ctx, const struct texture_call *call, struct image_target *t)
{
    if (!fgl_image_target(call->target, call->dimensions, t) || t->proxy)
        return GL_INVALID_ENUM;
    if (call->level < 0 || call->level >= fgl_texture_levels(t->target))
        return GL_INVALID_VALUE;
    const struct texture_image *image = fgl_target_image(ctx, t, call->level);
    const GLenum error = fgl_texture_part_error(call, image);
    return error ? error : pixels_error(call, t, image->internal_format);
}

bool fgl_texture_is_immutable(const struct context *ctx, const struct image_target *t)
{
    return !t->proxy && fgl_bound_texture(ctx, t->target)->immutable_levels;
}

/* ---- images ---- */

bool fgl_texture_define(struct context *ctx, const struct texture_call *call, bool swap_bytes, const struct image_target *t)
{
    const GLenum internal_format = (GLenum)call->internal_format;
    const struct texture_format *kept = fgl_texture_format_for(internal_format, call->format, call->type, swap_bytes);
    const struct image_shape shape = {internal_format, kept, call->width, call->height, call->depth, call->border};
    if (!t->proxy)
        fgl_texture_touch(ctx, fgl_bound_texture(ctx, t->target));
    if (fgl_texture_image_define(fgl_target_image(ctx, t, call->level), t->target, &shape, t->proxy))
        return true;
    fgl_error(ctx, GL_OUT_OF_MEMORY);
    return false;
}

void fgl_texture_after_change(struct context *ctx, const struct image_target *t, int level)
{
    struct texture_object *object = fgl_bound_texture(ctx, t->target);
    if (object->parameters.generate_mipmap && level == fgl_texture_base_level(object) &&
        !fgl_texture_generate_mipmaps(object, t->face))
        fgl_error(ctx, GL_OUT_OF_MEMORY);
}

/* ---- executing ---- */

/* Pixels in a buffer object, of a call without other errors. */
static bool find_pixels(struct context *ctx, const struct texture_call *call, struct pixel_source *source)
{
    return call->dimensions < 3 ? fgl_buffer_image(ctx, source->store, call->format, call->type, source->width, source->height, &source->pixels)
                                : fgl_buffer_volume(ctx, source->store, call->format, call->type, source->width, source->height, call->depth,
                                                    &source->pixels);
}

static void execute_image(struct context *ctx, const struct texture_call *call, struct pixel_source *source)
{
    struct image_target t;
    bool too_large = false;
    const GLenum error = image_error(call, &t, &too_large);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, fgl_texture_is_immutable(ctx, &t), GL_INVALID_OPERATION);
    if (too_large) {
        fgl_texture_image_clear(fgl_target_image(ctx, &t, call->level));
        return;
    }
    RETURN_ERROR_IF(ctx, !t.proxy && is_beyond_memory(call, t.target), GL_OUT_OF_MEMORY);
    if (!t.proxy && !find_pixels(ctx, call, source))
        return;
    if (!fgl_texture_define(ctx, call, source->store->swap_bytes, &t) || t.proxy)
        return;
    if (source->pixels)
        fgl_texture_store_image(ctx, call, source, fgl_target_image(ctx, &t, call->level));
    fgl_texture_after_change(ctx, &t, call->level);
}

static void execute_sub_image(struct context *ctx, const struct texture_call *call, struct pixel_source *source)
{
    struct image_target t;
    const GLenum error = sub_image_error(ctx, call, &t);
    RETURN_ERROR_IF(ctx, error, error);
    if (!find_pixels(ctx, call, source) || !source->pixels)
        return;
    fgl_texture_touch_image(ctx, fgl_bound_texture(ctx, t.target));
    fgl_texture_store_image(ctx, call, source, fgl_target_image(ctx, &t, call->level));
    fgl_texture_after_change(ctx, &t, call->level);
}

/* GL 1.5, 3.6.5 "Convolution": errors are those of the sizes that it leaves. */
static void execute(struct context *ctx, const struct texture_call *given, const struct pixel_store *store, const void *pixels)
{
    struct texture_call call = *given;
    struct pixel_source source = {store, pixels, given->width, given->height};
    if (given->format != GL_DEPTH_COMPONENT && given->format != GL_DEPTH_STENCIL)
        fgl_convolved_size(ctx, call.dimensions, &call.width, &call.height);
    if (call.sub)
        execute_sub_image(ctx, &call, &source);
    else
        execute_image(ctx, &call, &source);
}

/* ---- display lists ---- */

struct texture_node {
    struct texture_call call;
    bool has_pixels;
    uint64_t pixels[]; /* slices packed tightly */
};

/* Bytes of a slice when packed; 0 when the call will only raise an error. */
static size_t slice_bytes(const struct texture_call *call)
{
    const int largest = FGL_MAX_TEXTURE_SIZE + 2;
    if (fgl_pixel_check(call->format, call->type) || call->width < 0 || call->width > largest ||
        call->height < 0 || call->height > largest || call->depth < 0 || call->depth > largest)
        return 0;
    return fgl_pixel_image_bytes(&fgl_packed_store, call->format, call->type, call->width, call->height);
}

/* False after recording an error: that of a buffer object is raised at once. */
static bool record(struct context *ctx, const struct texture_call *call, const void *given)
{
    struct pixel_source source = {&ctx->client.unpack, given, call->width, call->height};
    const size_t slice = slice_bytes(call);
    if (slice && !find_pixels(ctx, call, &source))
        return false;
    const void *pixels = source.pixels;
    const size_t bytes = pixels ? slice : 0, room = UINT32_MAX - sizeof(struct texture_node) - 8;
    RETURN_VALUE_ERROR_IF(ctx, bytes && (size_t)call->depth > room / bytes, GL_OUT_OF_MEMORY, false);
    struct texture_node *node = fgl_list_record(ctx, OP_TEXTURE_IMAGE, sizeof *node + bytes * (size_t)call->depth);
    if (!node)
        return false;
    *node = (struct texture_node){*call, bytes > 0};
    const struct pixel_store *store = &ctx->client.unpack;
    const struct pixel_image image = bytes ? fgl_pixel_image(store, call->format, call->type, call->width, NULL) : (struct pixel_image){0};
    for (int z = 0; bytes && z < call->depth; z++) {
        const size_t offset = call->dimensions < 3 ? 0 : fgl_pixel_slice(image, store, call->height, z).first - image.first;
        fgl_pixel_copy(store, call->format, call->type, call->width, call->height, (const char *)pixels + offset,
                       (char *)node->pixels + (size_t)z * bytes);
    }    return true;
}

void fgl_list_replay_texture_image(struct context *ctx, const void *payload)
{
    const struct texture_node *node = payload;
    execute(ctx, &node->call, &fgl_packed_store, node->has_pixels ? node->pixels : NULL);
}

/* GL 1.5, 5.4: proxies are never compiled. */
static void record_and_execute(struct context *ctx, const struct texture_call *call, const void *pixels)
{
    struct image_target t;
    const bool proxy = fgl_image_target(call->target, 0, &t) && t.proxy;
    if (ctx->compiling && !proxy && !record(ctx, call, pixels))
        return;
    if (ctx->compiling == GL_COMPILE && !proxy)
        return;
    execute(ctx, call, &ctx->client.unpack, pixels);
}

static void command(const struct texture_call *call, const void *pixels)
{
    struct context *ctx = fgl_current;
    if (ctx && !fgl_refused_inside(ctx))
        FGL_SHARED(ctx, record_and_execute(ctx, call, pixels));
}

/* ---- commands ---- */

void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border, GLenum format,
                             GLenum type, const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 1, .target = target, .format = format, .type = type, .level = level,
                                      .internal_format = internalformat, .border = border, .width = width, .height = 1,
                                      .depth = 1};
    command(&call, pixels);
}

void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                             GLint border, GLenum format, GLenum type, const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 2, .target = target, .format = format, .type = type, .level = level,
                                      .internal_format = internalformat, .border = border, .width = width,
                                      .height = height, .depth = 1};
    command(&call, pixels);
}

void GLAPIENTRY glTexImage3D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                             GLsizei depth, GLint border, GLenum format, GLenum type, const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 3, .target = target, .format = format, .type = type, .level = level,
                                      .internal_format = internalformat, .border = border, .width = width,
                                      .height = height, .depth = depth};
    command(&call, pixels);
}

void GLAPIENTRY glTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLenum type,
                                const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 1, .sub = true, .target = target, .format = format, .type = type,
                                      .level = level, .x = xoffset, .width = width, .height = 1, .depth = 1};
    command(&call, pixels);
}

void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height,
                                GLenum format, GLenum type, const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 2, .sub = true, .target = target, .format = format, .type = type,
                                      .level = level, .x = xoffset, .y = yoffset, .width = width, .height = height,
                                      .depth = 1};
    command(&call, pixels);
}

void GLAPIENTRY glTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width,
                                GLsizei height, GLsizei depth, GLenum format, GLenum type, const GLvoid *pixels)
{
    const struct texture_call call = {.dimensions = 3, .sub = true, .target = target, .format = format, .type = type,
                                      .level = level, .x = xoffset, .y = yoffset, .z = zoffset, .width = width,
                                      .height = height, .depth = depth};
    command(&call, pixels);
}
