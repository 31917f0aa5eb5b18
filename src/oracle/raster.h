/*
 * The oracle for triangles: which pixels GL 1.5, 3.5.1 "Basic Polygon Rasterization" colors, and the color
 * and depth of each, from the floats that a program gives. All matrices are identities, the viewport is the
 * window, the depth range [0,1]. It shares nothing with the library.
 *
 * Coverage is arithmetic on integers: vertices are rounded to 1/256 of a pixel, half to even; a pixel whose
 * center lies exactly on an edge belongs to the triangle on the edge's right or upper side (the left and
 * bottom edges of a triangle are its own). Their rounding is decided in 113 bits, which is enough: with w = m
 * 2^e, |m| < 2^24, no quotient x / w is nearer to a tie than 2^-26 of it but the tie itself, which is exact.
 *
 * A triangle that is clipped has corners where the specification does not say how they are rounded. A pixel
 * nearer to an edge than 1/128 is then undecided.
 */
#ifndef ORACLE_RASTER_H
#define ORACLE_RASTER_H

#include <stdbool.h>
#include <stdint.h>

#include "oracle/quad.h"

enum { ORACLE_WINDOW = 128 }; /* pixels in each direction */

struct raster_vertex {
    float clip[4], color[4];
};

struct raster_triangle {
    struct raster_vertex vertex[3];
};

enum raster_coverage { RASTER_OUTSIDE, RASTER_UNDECIDED, RASTER_INSIDE };

/* What is constant over a triangle. */
struct raster_setup {
    const struct raster_triangle *triangle;
    bool clipped;       /* a vertex lies outside of the view volume */
    int64_t x[3], y[3]; /* corners in 1/256 of a pixel, counterclockwise; not if clipped */
    quad edge[3][3]; /* a, b, c: edge i at the point (x, y) in device coordinates is a x + b y + c; their sum
                        is positive where w is */
    bool flat;       /* no area: colors and depths are not defined */
};

struct raster_truth {
    quad color[4]; /* clamped to [0,1] */
    quad depth;    /* in [0,1] */
};

void oracle_raster_setup(const struct raster_triangle *triangle, struct raster_setup *setup);

/* x, y: the pixel, from the lower left. RASTER_UNDECIDED in clipped triangles only. */
enum raster_coverage oracle_raster_coverage(const struct raster_setup *setup, int x, int y);

/* The same for whoever rounds corners otherwise: RASTER_UNDECIDED nearer to an edge than 1/128 of a pixel. */
enum raster_coverage oracle_raster_loose_coverage(const struct raster_setup *setup, int x, int y);

/* How much of each vertex there is at the center of the pixel, up to a common factor: what vertices have is
 * interpolated as sum(weight[i] f[i]) / sum(weight[i]) (GL 1.5, 3.5.1, equation 3.6). */
void oracle_raster_weights(const struct raster_setup *setup, int x, int y, quad weight[3]);

/* At the center of the pixel: GL 1.5, 3.5.1, equations 3.6 (perspective) and 3.7 (depth). Where rounding of
 * the corners lets the triangle cover the center of a pixel outside of it, the planes go on. */
struct raster_truth oracle_raster_truth(const struct raster_setup *setup, int x, int y);

#endif
