/* Unpacking colours for a buffer of 8 bits a channel. Bytes stay what they are: the float of a byte, times 255, rounds to
 * it. */
#include "framebuffer/pixel_unpack.h"
#include "framebuffer/rows.h"

#include <string.h>

static bool is_plain_bytes(const struct pixel_image *image)
{
    return image->type->type == GL_UNSIGNED_BYTE && image->format->channel[0] <= CHANNEL_LUMINANCE;
}

static bool is_plain_floats(const struct pixel_image *image, const uint8_t *from)
{
    return image->type->type == GL_FLOAT && image->format->format == GL_RGBA && !image->swap_bytes &&
           (uintptr_t)from % sizeof(float) == 0;
}

/* count components a pixel, component c for the channel that takes shift[c] of the buffer's pixel. */
static FGL_ALWAYS_INLINE void join_bytes(const uint8_t *FGL_RESTRICT from, int n, const int count, const int *shift,
                                         uint32_t rest, uint32_t *FGL_RESTRICT out)
{
    for (int i = 0; i < n; i++) {
        uint32_t pixel = rest;
        for (int c = 0; c < count; c++)
            pixel |= (uint32_t)from[count * i + c] << shift[c];
        out[i] = pixel;
    }
}

static void luminance(const uint8_t *FGL_RESTRICT from, int n, uint32_t *FGL_RESTRICT out)
{
    for (int i = 0; i < n; i++)
        out[i] = from[i] * 0x010101u | 0xff000000u;
}

static void luminance_alpha(const uint8_t *FGL_RESTRICT from, int n, uint32_t *FGL_RESTRICT out)
{
    for (int i = 0; i < n; i++)
        out[i] = from[2 * i] * 0x010101u | (uint32_t)from[2 * i + 1] << 24;
}

/* The bytes in memory of a pixel with red in its low byte: RGBA, unless the machine keeps the high byte first. */
static void rgba(const uint8_t *from, int n, uint32_t *out)
{
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    memcpy(out, from, (size_t)n * sizeof *out);
#else
    static const int shift[4] = {0, 8, 16, 24};
    join_bytes(from, n, 4, shift, 0, out);
#endif
}

static void unpack_bytes(GLenum format, int channel, const uint8_t *from, int n, uint32_t *out)
{
    static const int rgb[4] = {0, 8, 16, 24}, bgra[4] = {16, 8, 0, 24}, abgr[4] = {24, 16, 8, 0};
    const uint32_t opaque = 0xff000000u;
    switch (format) {
    case GL_RGBA: rgba(from, n, out); break;
    case GL_BGRA: join_bytes(from, n, 4, bgra, 0, out); break;
    case GL_ABGR_EXT: join_bytes(from, n, 4, abgr, 0, out); break;
    case GL_RG: join_bytes(from, n, 2, rgb, opaque, out); break;
    case GL_RGB: join_bytes(from, n, 3, rgb, opaque, out); break;
    case GL_BGR: join_bytes(from, n, 3, bgra, opaque, out); break;
    case GL_LUMINANCE: luminance(from, n, out); break;
    case GL_LUMINANCE_ALPHA: luminance_alpha(from, n, out); break;
    default: join_bytes(from, n, 1, &rgb[channel], channel == CHANNEL_ALPHA ? 0 : opaque, out); break;
    }
}

void fgl_unpack_unorm8(const struct pixel_unpack *unpack, int row, int column, int n, uint32_t *out)
{
    const struct pixel_image *image = &unpack->image;
    const uint8_t *from = fgl_pixel_row(image, row) + (size_t)column * image->pixel_bytes;
    const bool transfer = fgl_transfer_color_active(unpack->mode);
    if (!transfer && is_plain_bytes(image)) {
        unpack_bytes(image->format->format, (int)image->format->channel[0], from, n, out);
        return;
    }
    if (!transfer && is_plain_floats(image, from)) {
        fgl_row_kernels(unpack->arith)->float_to_unorm8((const float *)(const void *)from, n, out);
        return;
    }
    struct color_row colors;
    const float *const channel[4] = {colors.channel[0], colors.channel[1], colors.channel[2], colors.channel[3]};
    fgl_unpack_color(unpack, row, column, n, &colors);
    fgl_row_kernels(unpack->arith)->planes_to_unorm8(channel, n, out);
}
