/* Whole images as RGBA floats: from the caller's memory, from the framebuffer, and back into the form of memory. */
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_pack.h"

#include <stdlib.h>

static bool make(int width, int height, struct color_image *out)
{
    const size_t n = (size_t)width * (size_t)height;
    *out = (struct color_image){width, height, calloc(n ? n : 1, 4 * sizeof(float))};
    return out->color != NULL;
}

bool fgl_colors_unpack(const struct pixel_unpack *unpack, int width, int height, struct color_image *out)
{
    struct pixel_unpack source = *unpack;
    struct color_row row;
    source.steps = UNPACK_FLOAT;
    if (!make(width, height, out))
        return false;
    float *to = out->color;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x += PIXEL_CHUNK) {
            const int n = fgl_min(PIXEL_CHUNK, width - x);
            fgl_unpack_color(&source, y, x, n, &row);
            for (int i = 0; i < n; i++, to += 4)
                for (int c = 0; c < 4; c++)
                    to[c] = row.channel[c][i];
        }
    return true;
}

bool fgl_colors_fetch(const struct framebuffer *fb, const struct pixel_mode_state *mode, const struct pixel_map *maps, int x, int y,
                      int width, int height, struct color_image *out)
{
    if (!make(width, height, out))
        return false;
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, GL_RGBA, GL_FLOAT, width, out->color),
            .mode = mode,
            .maps = maps,
    };
    const int64_t right = (int64_t)x + width, top = (int64_t)y + height;
    const int x0 = fgl_max(x, 0), x1 = right < fb->width ? (int)right : fb->width;
    const int y0 = fgl_max(y, 0), y1 = top < fb->height ? (int)top : fb->height;
    for (int row = y0; x0 < x1 && row < y1; row++)
        fgl_pack_row(&pack, fb, x0, fgl_row(fb, row), x1 - x0, row - y, x0 - x);
    return true;
}

struct pixel_unpack fgl_color_image_unpack(const struct color_image *image, const struct pixel_unpack *like)
{
    struct pixel_unpack unpack = *like;
    unpack.image = fgl_pixel_image(&fgl_packed_store, GL_RGBA, GL_FLOAT, image->width, image->color);
    unpack.mode = &fgl_no_transfer;
    return unpack;
}
