/* Pixels of programs, given or in a display list, to texels (GL 1.5, 3.8.1 "Texture Image Specification"). */
#include "api/command.h"
#include "api/errors.h"
#include "api/texture_image.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_unpack.h"

#include <stdlib.h>

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

/* Depths, and with them stencil indexes if both the pixels and the image have any. */
static void store_depths(const struct pixel_unpack *unpack, struct texture_image *image, int row, int column, int n, int x, int y, int z)
{
    uint32_t depth[PIXEL_CHUNK];
    int32_t index[PIXEL_CHUNK];
    fgl_unpack_depth_texels(unpack, row, column, n, image->format->bits[0], depth);
    fgl_texture_store_depth(image, x, y, z, n, depth);
    if (!image->stencil || unpack->image.format->format != GL_DEPTH_STENCIL)
        return;
    fgl_unpack_stencil(unpack, row, column, n, index);
    uint8_t *out = image->stencil + fgl_texel_index(image, x, y, z);
    for (int i = 0; i < n; i++)
        out[i] = (uint8_t)index[i];
}

/* n pixels of a row, from `column` on, to texels from x on. */
static void store_pixels(const struct pixel_unpack *unpack, struct texture_image *image, int row, int column, int n, int x,
                         int y, int z, enum texel_rounding rounding)
{
    struct color_row colors;
    if (image->kind == TEXELS_DEPTH) {
        store_depths(unpack, image, row, column, n, x, y, z);
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
void fgl_texture_store_image(struct context *ctx, const struct texture_call *call, const struct pixel_source *source,
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
