/* glTexImage and glTexSubImage (GL 1.5, 3.8.1 "Texture Image Specification", 3.8.2 "Alternate Texture Image Specification
 * Commands"). */
#include "api/texture_image.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/list.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_unpack.h"
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
static bool size_fits(const struct texture_call *call, int levels, int size)
{
    return size - 2 * call->border <= 1 << (levels - 1 - call->level);
}

/* OSMesa rule: proxies refuse images of more than 2^30 bytes. */
static bool is_beyond_memory(const struct texture_call *call)
{
    const double texel_bytes = (double)fgl_texel_bytes(fgl_texture_format((GLenum)call->internal_format)->kind), most = 1 << 30;
    return texel_bytes * call->width * fgl_max(call->height, 1) * fgl_max(call->depth, 1) > most;
}

GLenum fgl_texture_define_error(const struct texture_call *call, const struct image_target *t, bool *too_large)
{
    const int levels = fgl_texture_levels(t->target);
    const int smallest = 2 * call->border;
    if (call->level < 0 || call->level >= levels || call->border < 0 || call->border > 1)
        return GL_INVALID_VALUE;
    if (call->width < smallest || (call->dimensions > 1 && call->height < smallest) ||
        (call->dimensions > 2 && call->depth < smallest))
        return GL_INVALID_VALUE;
    if (!fgl_texture_format((GLenum)call->internal_format))
        return GL_INVALID_VALUE;
    if (t->target == TEXTURE_CUBE_MAP && call->width != call->height)
        return GL_INVALID_VALUE;
    *too_large = !size_fits(call, levels, call->width) || (call->dimensions > 1 && !size_fits(call, levels, call->height)) ||
                 (call->dimensions > 2 && !size_fits(call, levels, call->depth));
    *too_large |= t->proxy && is_beyond_memory(call);
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
    if (is_depth(internal_format) != (call->format == GL_DEPTH_COMPONENT))
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

/* ---- texels ---- */

/* Where pixels lie: given, or in a display list. */
struct pixel_source {
    const struct pixel_store *store;
    const void *pixels;
    int width, height; /* as given: the texture's when no convolution reduces it */
};

/* OSMesa rule: integers are brought to the texels' precision before anything else: 16 bits to 16, at most 8 through 8, 10 as floats. */
static enum unpack_steps steps_of(const struct texture_format *format)
{
    if (format->kind == TEXELS_UNORM8 || format->encoding == ENCODED_SRGB)
        return UNPACK_UNORM8;
    if (format->encoding != ENCODED_UNORM)
        return UNPACK_FLOAT;
    return format->bits[0] == 10 ? UNPACK_FLOAT : UNPACK_UNORM16;
}

/* OSMesa rule: what indexes become is bytes; and so is, on the way to fields of at most 8 bits, everything but floats as GL_RGBA, and on the
 * way to 10 bits only RGBA bytes in this order. */
static bool through_bytes(const struct context *ctx, const struct texture_format *texels, GLenum format, GLenum type)
{
    if (format == GL_COLOR_INDEX)
        return true;
    if (fgl_transfer_color_active(&ctx->s.pixel_mode) || texels->encoding != ENCODED_UNORM)
        return false;
    if (texels->kind == TEXELS_UNORM8)
        return texels->bits[0] != 8 && !(format == GL_RGBA && type == GL_FLOAT);
    return format == GL_RGBA && (type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_INT_8_8_8_8_REV);
}

/* Whether pixels are bytes that become texels as they are. */
static bool are_texels(const struct pixel_unpack *unpack, const struct texture_format *format)
{
    return unpack->image.type->type == GL_UNSIGNED_BYTE && unpack->image.format->format != GL_COLOR_INDEX &&
           fgl_texture_format_keeps_bytes(format) && !fgl_transfer_color_active(unpack->mode);
}

static void store_bytes(const struct pixel_unpack *unpack, struct texture_image *image, int row, int column, int n, int x,
                        int y, int z)
{
    const struct pixel_format *format = unpack->image.format;
    const size_t step = unpack->image.pixel_bytes;
    int place[4] = {-1, -1, -1, -1};
    for (int c = 0; c < format->components; c++) {
        if (format->channel[c] == CHANNEL_LUMINANCE)
            place[0] = place[1] = place[2] = c;
        else
            place[format->channel[c]] = c;
    }
    fgl_texture_store_bytes(image, x, y, z, n, fgl_pixel_row(&unpack->image, row) + (size_t)column * step, step, place);
}

/* n pixels of a row, from `column` on, to texels from x on. */
static void store_pixels(const struct pixel_unpack *unpack, struct texture_image *image, int row, int column, int n, int x,
                         int y, int z, enum texel_rounding rounding)
{
    struct color_row colors;
    if (image->kind == TEXELS_DEPTH) {
        uint32_t depth[PIXEL_CHUNK];
        fgl_unpack_depth_texels(unpack, row, column, n, image->format->bits[0], depth);
        fgl_texture_store_depth(image, x, y, z, n, depth);
        return;
    }
    if (are_texels(unpack, image->format)) {
        store_bytes(unpack, image, row, column, n, x, y, z);
        return;
    }
    fgl_unpack_color(unpack, row, column, n, &colors);
    const float *const planes[4] = {colors.channel[0], colors.channel[1], colors.channel[2], colors.channel[3]};
    fgl_texture_store_color(image, x, y, z, n, planes, rounding);
}

/* Makes `unpack` the slice after the imaging stages; *image is then to be freed. A sink leaves no pixels: false, as when memory is
 * short. */
static bool image_slice(struct context *ctx, const struct texture_call *call, const struct pixel_source *source,
                        struct pixel_unpack *unpack, struct color_image *image)
{
    if (!fgl_imaging_unpack(ctx, unpack, source->width, source->height, call->dimensions, image)) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    *unpack = fgl_color_image_unpack(image, unpack);
    return image->width > 0;
}

/* OSMesa rule: of a border nothing is read. */
static void store_image(struct context *ctx, const struct texture_call *call, const struct pixel_source *source,
                        struct texture_image *image)
{
    const int border = call->sub ? 0 : call->border, border_y = call->dimensions > 1 ? border : 0,
              border_z = call->dimensions > 2 ? border : 0;
    const int width = call->width - 2 * border, height = call->height - 2 * border_y, depth = call->depth - 2 * border_z;
    const struct pixel_image whole = fgl_pixel_image(source->store, call->format, call->type, source->width, source->pixels);
    const struct pixel_unpack given = {.mode = &ctx->s.pixel_mode, .maps = ctx->pixel_map, .steps = steps_of(image->format)};
    const bool imaged = image->kind != TEXELS_DEPTH && fgl_imaging_active(ctx);
    const enum texel_rounding rounding =
            !imaged && through_bytes(ctx, image->format, call->format, call->type) ? ROUND_THROUGH_BYTES : ROUND_GIVEN;
    for (int z = 0; z < depth; z++) {
        struct color_image slice = {0};
        struct pixel_unpack unpack = given;
        unpack.image = call->dimensions < 3 ? whole : fgl_pixel_slice(whole, source->store, call->height, z + border_z);
        const bool present = !imaged || image_slice(ctx, call, source, &unpack, &slice);
        for (int y = 0; present && y < height; y++)
            for (int x = 0; x < width; x += PIXEL_CHUNK)
                store_pixels(&unpack, image, y + border_y, x + border, fgl_min(PIXEL_CHUNK, width - x), call->x + x,
                             call->y + y, call->z + z, rounding);
        free(slice.color);
    }
}

bool fgl_texture_define(struct context *ctx, const struct texture_call *call, const struct image_target *t)
{
    const GLenum internal_format = (GLenum)call->internal_format;
    const struct image_shape shape = {internal_format, fgl_texture_format_for(internal_format, call->format, call->type), call->width, call->height, call->depth, call->border};
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
    if (object->parameters.generate_mipmap && level == object->parameters.base_level &&
        !fgl_texture_generate_mipmaps(object, t->face))
        fgl_error(ctx, GL_OUT_OF_MEMORY);
}

/* ---- executing ---- */

static void execute_image(struct context *ctx, const struct texture_call *call, const struct pixel_source *source)
{
    struct image_target t;
    bool too_large = false;
    const GLenum error = image_error(call, &t, &too_large);
    RETURN_ERROR_IF(ctx, error, error);
    if (too_large) {
        fgl_texture_image_clear(fgl_target_image(ctx, &t, call->level));
        return;
    }
    if (!fgl_texture_define(ctx, call, &t) || t.proxy)
        return;
    if (source->pixels)
        store_image(ctx, call, source, fgl_target_image(ctx, &t, call->level));
    fgl_texture_after_change(ctx, &t, call->level);
}

static void execute_sub_image(struct context *ctx, const struct texture_call *call, const struct pixel_source *source)
{
    struct image_target t;
    const GLenum error = sub_image_error(ctx, call, &t);
    RETURN_ERROR_IF(ctx, error, error);
    if (!source->pixels)
        return;
    fgl_texture_touch_image(ctx, fgl_bound_texture(ctx, t.target));
    store_image(ctx, call, source, fgl_target_image(ctx, &t, call->level));
    fgl_texture_after_change(ctx, &t, call->level);
}

/* GL 1.5, 3.6.5 "Convolution": errors are those of the sizes that it leaves. */
static void execute(struct context *ctx, const struct texture_call *given, const struct pixel_store *store, const void *pixels)
{
    struct texture_call call = *given;
    const struct pixel_source source = {store, pixels, given->width, given->height};
    if (given->format != GL_DEPTH_COMPONENT)
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

/* Bytes of a slice when packed; 0 when there are no pixels to keep, or the call will only raise an error. */
static size_t slice_bytes(const struct texture_call *call, const void *pixels)
{
    const int largest = FGL_MAX_TEXTURE_SIZE + 2;
    if (!pixels || fgl_pixel_check(call->format, call->type) || call->width < 0 || call->width > largest ||
        call->height < 0 || call->height > largest || call->depth < 0 || call->depth > largest)
        return 0;
    return fgl_pixel_image_bytes(&fgl_packed_store, call->format, call->type, call->width, call->height);
}

static void record(struct context *ctx, const struct texture_call *call, const void *pixels)
{
    const size_t bytes = slice_bytes(call, pixels), room = UINT32_MAX - sizeof(struct texture_node) - 8;
    RETURN_ERROR_IF(ctx, bytes && (size_t)call->depth > room / bytes, GL_OUT_OF_MEMORY);
    struct texture_node *node = fgl_list_record(ctx, OP_TEXTURE_IMAGE, sizeof *node + bytes * (size_t)call->depth);
    if (!node)
        return;
    *node = (struct texture_node){*call, bytes > 0};
    if (!bytes)
        return;
    const struct pixel_store *store = &ctx->client.unpack;
    const struct pixel_image image = fgl_pixel_image(store, call->format, call->type, call->width, NULL);
    for (int z = 0; z < call->depth; z++) {
        const size_t offset = call->dimensions < 3 ? 0 : fgl_pixel_slice(image, store, call->height, z).first - image.first;
        fgl_pixel_copy(store, call->format, call->type, call->width, call->height, (const char *)pixels + offset,
                       (char *)node->pixels + (size_t)z * bytes);
    }
}

void fgl_list_replay_texture_image(struct context *ctx, const void *payload)
{
    const struct texture_node *node = payload;
    execute(ctx, &node->call, &fgl_packed_store, node->has_pixels ? node->pixels : NULL);
}

/* GL 1.5, 5.4: proxies are never compiled. */
static void command(const struct texture_call *call, const void *pixels)
{
    struct context *ctx = fgl_current;
    struct image_target t;
    if (!ctx)
        return;
    if (fgl_refused_inside(ctx))
        return;
    const bool proxy = fgl_image_target(call->target, 0, &t) && t.proxy;
    if (ctx->compiling && !proxy)
        record(ctx, call, pixels);
    if (ctx->compiling == GL_COMPILE && !proxy)
        return;
    execute(ctx, call, &ctx->client.unpack, pixels);
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
