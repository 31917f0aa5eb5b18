/* Unpacking: rows of the caller's memory into floats or indexes (GL 1.5, 3.6.4 "Rasterization of Pixel Rectangles"). The mirror of
 * pixel_pack.h. Layer 2. */
#ifndef FGL_FRAMEBUFFER_PIXEL_UNPACK_H
#define FGL_FRAMEBUFFER_PIXEL_UNPACK_H

#include "base/cpu.h"
#include "framebuffer/pixel_format.h"
#include "framebuffer/pixel_transfer.h"

/* The precision that integer colours are brought to before they are floats. */
enum unpack_steps {
    UNPACK_DRAWN,   /* as for glDrawPixels: at most 16 bits, packed ones at least 8 */
    UNPACK_UNORM8,  /* 8 bits */
    UNPACK_UNORM16, /* 16 bits, but packed ones none */
    UNPACK_FLOAT    /* none */
};

/* The state that unpacking depends on. */
struct pixel_unpack {
    struct pixel_image image;
    const struct pixel_mode_state *mode;
    const struct pixel_map *maps;
    enum fgl_arith arith;    /* of fgl_unpack_unorm8 */
    enum unpack_steps steps; /* of fgl_unpack_color, when pixel transfer does nothing; otherwise there are none but for UNPACK_DRAWN */
};

/* n pixels of row `row` from pixel `column` on, after pixel transfer; n <= PIXEL_CHUNK.
 * Colours: formats with colour channels and GL_COLOR_INDEX, which goes through the maps. Not clamped. */
void fgl_unpack_color(const struct pixel_unpack *unpack, int row, int column, int n, struct color_row *out);
/* The same as pixels of COLOR_UNORM8: clamped, rounded half to even. */
void fgl_unpack_unorm8(const struct pixel_unpack *unpack, int row, int column, int n, uint32_t *out);
/* GL_COLOR_INDEX for a framebuffer of indexes: masked whole numbers (3.6.4 "Final Conversion"). */
void fgl_unpack_color_index(const struct pixel_unpack *unpack, int row, int column, int n, float *out);
/* GL_DEPTH_COMPONENT: in [0,1]. */
void fgl_unpack_depth(const struct pixel_unpack *unpack, int row, int column, int n, float *out);
/* The same for texels: integers of 16, 24 or 32 bits. */
void fgl_unpack_depth_texels(const struct pixel_unpack *unpack, int row, int column, int n, int bits, uint32_t *out);
/* GL_STENCIL_INDEX. */
void fgl_unpack_stencil(const struct pixel_unpack *unpack, int row, int column, int n, int32_t *out);

/* n <= 32 pixels of a bitmap: bit i is pixel column + i. */
enum { BITMAP_CHUNK = 32 };
uint32_t fgl_unpack_bits(const struct pixel_image *image, int row, int column, int n);

/* Copies an image of width x height pixels to `out`, as a display list keeps it: tightly packed, bytes in our order, first bit
 * highest. Room: fgl_pixel_image_bytes(&fgl_packed_store, ...). */
extern const struct pixel_store fgl_packed_store;
void fgl_pixel_copy(const struct pixel_store *store, GLenum format, GLenum type, int width, int height, const void *pixels,
                    void *out);

#endif
