/* Packing rows in the commonest cases: without pixel transfer, from the 8-bit buffer to bytes and floats, from the depth
 * and stencil buffers to their own types. What pixel_pack.c does, to the same bytes. */
#include "framebuffer/pixel_pack.h"
#include "framebuffer/rows.h"

#include <string.h>

/* ---- colour ---- */

/* n is the number of components; shift[c] is where the byte of component c lies in a pixel of the buffer. */
static FGL_ALWAYS_INLINE void copy_bytes(uint8_t *FGL_RESTRICT out, const uint32_t *FGL_RESTRICT pixel,
                                         uint32_t alpha, int count, const int n, const int *shift)
{
    for (int i = 0; i < count; i++)
        for (int c = 0; c < n; c++)
            out[n * i + c] = (uint8_t)((pixel[i] | alpha) >> shift[c]);
}

/* Whether the bytes of a pixel lie in memory as red, green, blue, alpha. */
static bool is_little_endian(void)
{
    const uint32_t one = 1;
    return *(const uint8_t *)&one == 1;
}

static void pack_bytes(const struct pixel_format *format, bool has_alpha, const uint32_t *pixel, int n, uint8_t *out)
{
    static const int rgba[4] = {0, 8, 16, 24}, bgra[4] = {16, 8, 0, 24}, abgr[4] = {24, 16, 8, 0};
    const uint32_t alpha = has_alpha ? 0 : 0xff000000u;
    if (format->format == GL_RGBA && has_alpha && is_little_endian()) {
        memcpy(out, pixel, 4 * (size_t)n);
        return;
    }
    switch (format->format) {
    case GL_RGBA: copy_bytes(out, pixel, alpha, n, 4, rgba); break;
    case GL_BGRA: copy_bytes(out, pixel, alpha, n, 4, bgra); break;
    case GL_ABGR_EXT: copy_bytes(out, pixel, alpha, n, 4, abgr); break;
    case GL_RG: copy_bytes(out, pixel, alpha, n, 2, rgba); break;
    case GL_RGB: copy_bytes(out, pixel, alpha, n, 3, rgba); break;
    case GL_BGR: copy_bytes(out, pixel, alpha, n, 3, bgra); break;
    default: copy_bytes(out, pixel, alpha, n, 1, &rgba[format->channel[0]]); break;
    }
}

static bool pack_color(const struct pixel_pack *pack, const struct framebuffer *fb, size_t at, int n, uint8_t *out)
{
    const struct pixel_image *image = &pack->image;
    const uint32_t *pixel = (const uint32_t *)fb->color + at;
    if (fb->color_kind != COLOR_UNORM8 || fgl_transfer_color_active(pack->mode))
        return false;
    if (image->type->type == GL_UNSIGNED_BYTE)
        pack_bytes(image->format, fb->has_alpha, pixel, n, out);
    else if (image->type->type == GL_FLOAT && image->format->format == GL_RGBA && fb->has_alpha)
        fgl_row_kernels(ARITH_COMPATIBLE)->unorm8_to_float(pixel, n, (float *)(void *)out);
    else
        return false;
    return true;
}

/* ---- depth and stencil ---- */

static bool pack_depth(const struct pixel_pack *pack, const struct framebuffer *fb, size_t at, int n, uint8_t *out)
{
    const GLenum type = pack->image.type->type;
    const uint32_t *z = fb->depth + at;
    uint32_t *to = (uint32_t *)(void *)out;
    if (fb->depth_bits != 24 || fgl_transfer_depth_active(pack->mode) || (type != GL_UNSIGNED_INT && type != GL_FLOAT))
        return false;
    if (type == GL_FLOAT)
        fgl_row_kernels(ARITH_COMPATIBLE)->depth_to_float(z, n, fb->depth_max, (float *)(void *)out);
    else
        for (int i = 0; i < n; i++)
            to[i] = z[i] << 8 | z[i] >> 16;
    return true;
}

static bool pack_stencil(const struct pixel_pack *pack, const struct framebuffer *fb, size_t at, int n, uint8_t *out)
{
    if (pack->image.type->type != GL_UNSIGNED_BYTE || fgl_transfer_stencil_active(pack->mode))
        return false;
    if (fb->stencil)
        memcpy(out, fb->stencil + at, (size_t)n);
    else
        memset(out, 0, (size_t)n);
    return true;
}

bool fgl_pack_row_plain(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, int row,
                        int column)
{
    const struct pixel_image *image = &pack->image;
    const size_t at = (size_t)y * (size_t)fb->stride + (size_t)x;
    uint8_t *out = fgl_pixel_row(image, row) + (size_t)column * image->pixel_bytes;
    const size_t alignment = image->type->bytes ? (size_t)image->type->bytes : 1;
    if (image->type->kind == COMPONENT_BITMAP || (alignment > 1 && (image->swap_bytes || (uintptr_t)out % alignment)))
        return false;
    switch (image->format->channel[0]) {
    case CHANNEL_DEPTH: return pack_depth(pack, fb, at, n, out);
    case CHANNEL_STENCIL: return pack_stencil(pack, fb, at, n, out);
    case CHANNEL_RED:
    case CHANNEL_GREEN:
    case CHANNEL_BLUE:
    case CHANNEL_ALPHA: return pack_color(pack, fb, at, n, out);
    default: return false;
    }
}
