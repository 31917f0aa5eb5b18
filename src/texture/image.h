/* The texels of an image: room for them, and quantising what comes (GL 1.5, 3.8.1 "Texture Image Specification"). Layer 2. */
#ifndef FGL_TEXTURE_IMAGE_H
#define FGL_TEXTURE_IMAGE_H

#include "texture/format.h"

enum { TEXTURE_RUN = 256 }; /* texels that are stored at once */

/* What an image is to be: sizes with the border, as given. */
struct image_shape {
    GLenum internal_format;
    const struct texture_format *format; /* of the texels */
    int width, height, depth, border;
};

/* Makes the image one of the given shape, in place of what it was; its texels are not set. No texels are kept for `proxy`. Returns false
 * when memory is short or the size overflows; the image is then unchanged. */
bool fgl_texture_image_define(struct texture_image *image, enum texture_target target, const struct image_shape *shape,
                              bool proxy);
/* No image. */
void fgl_texture_image_clear(struct texture_image *image);

static inline size_t fgl_texel_index(const struct texture_image *image, int x, int y, int z)
{
    return ((size_t)z * (size_t)image->height + (size_t)y) * (size_t)image->width + (size_t)x;
}

/* OSMesa rules: how colours in [0,1] become integers of the format's bits. */
enum texel_rounding {
    ROUND_GIVEN,         /* as pixels of programs: half up, but half to even for bytes */
    ROUND_THROUGH_BYTES, /* to bytes, which then get more or fewer bits */
    ROUND_DRAWN          /* as what is drawn: half to even; but 5 bits, and the 6 or 1 beside them, are cut from bytes, 10 and 2 from words */
};

/* n texels of a format that keeps bytes, from pixels `step` bytes apart. place: which byte of a pixel red, green, blue and alpha are; -1: none,
 * which is 0, but alpha 255. */
void fgl_texture_store_bytes(struct texture_image *image, int x, int y, int z, int n, const uint8_t *pixels, size_t step,
                             const int place[4]);

/* Stores n texels from (x, y, z) on. n <= TEXTURE_RUN. color: four planes, red to alpha. */
void fgl_texture_store_color(struct texture_image *image, int x, int y, int z, int n, const float *const color[4],
                             enum texel_rounding rounding);
void fgl_texture_store_depth(struct texture_image *image, int x, int y, int z, int n, const uint32_t *depth); /* of the format's bits */

/* n texels as colours, four planes: what drawing would see of them, but formats of less than 8 bits with all their precision (GL 1.5, 6.1.4
 * "Texture Queries", table 6.1: luminance and intensity are red alone). */
void fgl_texture_load_color(const struct texture_image *image, int x, int y, int z, int n, float *const color[4]);
/* The same as integers of 8 or 16 bits: of bytes, whatever the format's bits, or of a format of 16. Only normalized unsigned ones, and sRGB,
 * whose colours are those of the curve. */
void fgl_texture_load_integers(const struct texture_image *image, int x, int y, int z, int n, uint32_t *const color[4]);

#endif
