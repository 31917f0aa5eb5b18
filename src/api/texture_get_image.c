/* glGetTexImage (GL 1.5, 6.1.4 "Texture Queries"). */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/pixel_buffer.h"
#include "api/texture_image.h"
#include "framebuffer/pixel_pack.h"

static GLenum format_error(const struct texture_image *image, GLenum format, GLenum type)
{
    const GLenum error = fgl_pixel_check(format, type);
    if (error)
        return error;
    if (format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX)
        return GL_INVALID_ENUM;
    if (!image->format)
        return GL_NO_ERROR;
    if ((image->kind == TEXELS_DEPTH) != (format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL))
        return GL_INVALID_OPERATION;
    if (format == GL_DEPTH_STENCIL && image->format->base_format != GL_DEPTH_STENCIL)
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

/* Colours as integers where the texels are whole bytes or words; else as floats, but fields as bytes if that is all that is asked for. */
static void load_run(const struct texture_image *image, bool to_bytes, int x, int y, int z, int n, struct fetched_row *row)
{
    const struct texture_format *f = image->format;
    const int bits = f->base_format == GL_ALPHA ? f->bits[3] : f->bits[0];
    uint32_t *const integers[4] = {row->integer[0], row->integer[1], row->integer[2], row->integer[3]};
    float *const floats[4] = {row->color.channel[0], row->color.channel[1], row->color.channel[2], row->color.channel[3]};
    row->bits = f->encoding == ENCODED_SRGB ? 8 : f->encoding != ENCODED_UNORM ? 0 : bits == 16 ? 16 : bits == 8 || (bits < 8 && to_bytes) ? 8 : 0;
    if (row->bits)
        fgl_texture_load_integers(image, x, y, z, n, integers);
    else
        fgl_texture_load_color(image, x, y, z, n, floats);
}

/* n texels from (x, y, z) on. */
static void pack_run(const struct pixel_pack *pack, const struct texture_image *image, int x, int y, int z, int n)
{
    const struct pixel_type *type = pack->image.type;
    const bool to_bytes = type->type == GL_UNSIGNED_BYTE || (type->fields && type->bits[0] <= 8);
    struct fetched_row row;
    if (image->kind == TEXELS_DEPTH) {
        const size_t at = fgl_texel_index(image, x, y, z);
        fgl_pack_depths(pack, (const float *)image->texels + at, image->stencil ? image->stencil + at : NULL, n, y, x);
        return;
    }
    load_run(image, to_bytes, x, y, z, n, &row);
    fgl_pack_colors(pack, &row, image->format->base_format == GL_RGBA, n, y, x);
}

/* No pixel transfer takes place. */
void fgl_exec_GetTexImage(struct context *ctx, GLenum target, GLint level, GLenum format, GLenum type, GLvoid *pixels)
{
    struct image_target t;
    RETURN_ERROR_IF(ctx, !fgl_image_target(target, 0, &t) || t.proxy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, level < 0 || level >= fgl_texture_levels(t.target), GL_INVALID_VALUE);
    const struct texture_image *image = fgl_target_image(ctx, &t, level);
    const GLenum error = format_error(image, format, type);
    RETURN_ERROR_IF(ctx, error, error);
    const void *to = pixels;
    if (!image->texels || (!pixels && !ctx->client.pack.buffer) ||
        !fgl_buffer_volume(ctx, &ctx->client.pack, format, type, image->width, image->height, image->depth, &to))
        return;
    fgl_framebuffer_unload_texture(ctx, fgl_bound_texture(ctx, t.target));
    const struct pixel_store *store = &ctx->client.pack;
    const struct pixel_image whole = fgl_pixel_image(store, format, type, image->width, to);
    struct pixel_pack pack = {.mode = &ctx->s.pixel_mode, .maps = ctx->pixel_map};
    for (int z = 0; z < image->depth; z++) {
        pack.image = t.target == TEXTURE_3D ? fgl_pixel_slice(whole, store, image->height, z) : whole;
        for (int y = 0; y < image->height; y++)
            for (int x = 0; x < image->width; x += PIXEL_CHUNK)
                pack_run(&pack, image, x, y, z, fgl_min(PIXEL_CHUNK, image->width - x));
    }
}
