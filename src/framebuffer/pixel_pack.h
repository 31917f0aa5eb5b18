/* Packing: rows of the framebuffer into the caller's memory (GL 1.5, 4.3.2 "Reading Pixels"). Layer 2. */
#ifndef FGL_FRAMEBUFFER_PIXEL_PACK_H
#define FGL_FRAMEBUFFER_PIXEL_PACK_H

#include "framebuffer/framebuffer.h"
#include "framebuffer/pixel_format.h"
#include "framebuffer/pixel_transfer.h"

/* The state that packing depends on. */
struct pixel_pack {
    struct pixel_image image;
    const struct pixel_mode_state *mode;
    const struct pixel_map *maps;
    bool clamps; /* colours of a float buffer, after their transfer */
};

/* Packs n pixels from column x of framebuffer row y into the image's row `row` from pixel `column`
 * on. The pixels are all in the framebuffer, and the framebuffer has the buffer that the format names. Writes
 * those pixels and no other byte; of a bitmap, those bits. */
void fgl_pack_row(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, int row,
                  int column);

/* pixel_pack_plain.c: the same for the commonest cases, in which nothing is changed but the type; false, and nothing
 * written, for others. */
bool fgl_pack_row_plain(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, int row,
                        int column);

/* A chunk of colours on their way: integers of `bits` bits, or floats when bits is 0. */
struct fetched_row {
    int bits;
    uint32_t integer[4][PIXEL_CHUNK];
    struct color_row color;
};

/* The same with n colours of a texture, and no pixel transfer; luminance is red. OSMesa rule: colours pass through bytes
 * on the way to packed pixels of no more, and through floats to those of more, unless `direct`. `fetched` may change. */
void fgl_pack_colors(const struct pixel_pack *pack, struct fetched_row *fetched, bool direct, int n, int row, int column);
/* The same with colours of a framebuffer after pixel transfer: floats, luminance is the sum. They may change. */
void fgl_pack_transferred(const struct pixel_pack *pack, struct color_row *colors, int n, int row, int column);
/* The same with counters: integers as they are, cut off at the type's greatest value; luminance is red. */
void fgl_pack_counts(const struct pixel_pack *pack, const uint32_t *const count[4], int n, int row, int column);
/* The same with depths, and stencil for GL_DEPTH_STENCIL, else NULL. */
void fgl_pack_depths(const struct pixel_pack *pack, const float *depth, const uint8_t *stencil, int n, int row, int column);

#endif
