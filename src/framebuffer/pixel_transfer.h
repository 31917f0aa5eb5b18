/* Pixel transfer (GL 1.5, 3.6.5 "Pixel Transfer Operations"): scale and bias, colour maps, index arithmetic,
 * on rows of pixels between the framebuffer and the caller's memory, in either direction. Layer 2. */
#ifndef FGL_FRAMEBUFFER_PIXEL_TRANSFER_H
#define FGL_FRAMEBUFFER_PIXEL_TRANSFER_H

#include "base/fgl.h"
#include "state/context.h"

/* Modes under which nothing changes. */
extern const struct pixel_mode_state fgl_no_transfer;

enum { PIXEL_CHUNK = 256 }; /* pixels of a row that are worked on at once */

/* A row of RGBA pixels, one plane for each channel. */
struct color_row {
    float channel[4][PIXEL_CHUNK];
};

/* Whether colours change at all. */
bool fgl_transfer_color_active(const struct pixel_mode_state *mode);
/* Scale and bias, then the maps GL_PIXEL_MAP_R_TO_R.. when GL_MAP_COLOR is on. Results are not clamped. */
void fgl_transfer_color(const struct pixel_mode_state *mode, const struct pixel_map *maps,
                        struct color_row *row, int n);

bool fgl_transfer_stencil_active(const struct pixel_mode_state *mode);

bool fgl_transfer_depth_active(const struct pixel_mode_state *mode);
/* Scale and bias, clamped to [0,1]. */
void fgl_transfer_depth(const struct pixel_mode_state *mode, float *depth, int n);

/* An index that comes as a float, cut; 0 when it is no 32-bit integer. */
static inline int32_t fgl_index_of(float v)
{
    return v > -2147483648.0f && v < 2147483648.0f ? (int32_t)v : 0;
}

/* Shift and offset of indexes (stencil or colour), then GL_PIXEL_MAP_S_TO_S when `stencil` and GL_MAP_STENCIL
 * is on. */
void fgl_transfer_index(const struct pixel_mode_state *mode, const struct pixel_map *maps, bool stencil,
                        int32_t *index, int n);

/* Colour indexes that stay indexes: through GL_PIXEL_MAP_I_TO_I when GL_MAP_COLOR is on (3.6.5 "Color Index
 * Lookup"), after fgl_transfer_index. */
void fgl_transfer_color_index(const struct pixel_mode_state *mode, const struct pixel_map *maps, int32_t *index,
                              int n);

/* Colour indexes to RGBA through GL_PIXEL_MAP_I_TO_R.. (3.6.4 "Conversion to RGB"). */
void fgl_transfer_index_to_color(const struct pixel_map *maps, const int32_t *index, struct color_row *row,
                                 int n);

#endif
