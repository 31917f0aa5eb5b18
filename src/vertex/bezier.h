/* Bezier curves and surfaces (GL 1.5, 5.1 "Evaluators"). Layer 3.
 *
 * A net has order[0] x order[1] control points of `size` floats, the second direction running fastest; a
 * curve's order[1] is 1. Parameters are 0..1 over the net. Every result is one of float operations in a fixed
 * order: OSMesa's. */
#ifndef FGL_VERTEX_BEZIER_H
#define FGL_VERTEX_BEZIER_H

#include "base/fgl.h"
#include "base/limits.h"

enum { BEZIER_MAX_SIZE = 4 };

struct bezier_net {
    const float *points;
    int order[2]; /* 1..FGL_MAX_EVAL_ORDER each */
    int size;     /* 1..BEZIER_MAX_SIZE */
};

/* The point at t of a curve. */
void fgl_bezier_curve(const struct bezier_net *net, float t, float *point);

/* The point at (u, v) of a surface. */
void fgl_bezier_surface(const struct bezier_net *net, float u, float v, float *point);

/* The same, by de Casteljau's scheme, with the directions of the partial derivatives (the derivatives divided
 * by the degree). */
void fgl_bezier_tangents(const struct bezier_net *net, float u, float v, float *point, float *du, float *dv);

#endif
