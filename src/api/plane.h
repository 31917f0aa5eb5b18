/* Planes that are given in object space and live in eye space: of glClipPlane and glTexGen. */
#ifndef FGL_API_PLANE_H
#define FGL_API_PLANE_H

#include "state/context.h"

/* Stores a plane, transformed by the inverse modelview matrix: in float, and in double. */
void fgl_set_plane(struct context *ctx, unsigned dirty, float field[4], double exact_field[4], const double plane[4]);

#endif
