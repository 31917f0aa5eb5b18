/* Pixel rectangles (GL 1.5, 3.6.4 "Rasterization of Pixel Rectangles"): which window pixels a zoomed rectangle covers, and which
 * pixel of the image each shows. Layer 3.
 *
 * OSMesa rule: the rectangle is two triangles with the image as a texture, nearest texel; (x0, y1) (x1, y1) (x1, y0) and (x0, y1) (x1, y0)
 * (x0, y0), where (x0, y0) is the raster position. Where a pixel's centre falls on the boundary of two texels, as every centre does when
 * the zoom is 1/2, the last bits of the texture coordinates decide, so they are computed here as there. The texture of a copied
 * rectangle has the order of rows of what is read: the highest first, but of framebuffer objects the lowest. A framebuffer object is taken
 * for a window that is upside down, in which the rectangle begins at its other end, cut off to an integer. */
#ifndef FGL_RASTER_ZOOM_H
#define FGL_RASTER_ZOOM_H

#include "framebuffer/framebuffer.h"

struct zoom {
    struct rect covered; /* pixels inside the framebuffer */
    int width, height;   /* of the image */
    float x[2], y[2];    /* the rectangle's corners in pixels, against the rows; 0: at the raster position, or turned over */
    float t_at[2];       /* t at y[0] and y[1]: 0 or 1 */
    bool top_first;      /* the texture's rows are the image's from its last to its first */
    float s0, sx;        /* s of column X is fma(sx, X, s0); 0..1 over the image */
    float t0[2], ty;     /* t of row Y in the first and the second triangle */
    double a, b, c;      /* pixel (X, Y) is in the first triangle where c - 256 a X + 256 b Y > 0 */
};

/* (x, y): the raster position in pixels, y up. fb: what is drawn to. top_first: as in
 * struct zoom. */
void fgl_zoom_setup(struct zoom *z, int x, int y, int width, int height, float zoom_x, float zoom_y,
                    const struct framebuffer *fb, bool top_first);

/* The image's column and row at s and t, each 0..1 over the image. */
int fgl_zoom_texel_column(const struct zoom *z, float s);
int fgl_zoom_texel_row(const struct zoom *z, float t);
/* The image's column that window column X shows. */
int fgl_zoom_column(const struct zoom *z, int x);
/* The image's row that row Y shows in triangle 0 or 1. */
int fgl_zoom_row(const struct zoom *z, int y, int triangle);
/* Whether pixel (X, Y) is in the first triangle. */
bool fgl_zoom_in_first(const struct zoom *z, int x, int y);

#endif
