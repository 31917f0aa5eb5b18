/* The edge of a spot's cone (GL 1.5, 2.14.1 "Lighting"): a vertex is lit when the cosine of its angle to the axis is not
 * less than the cutoff's. Layer 3. */
#ifndef FGL_VERTEX_CONE_H
#define FGL_VERTEX_CONE_H

#include "base/pair.h"

#include <stdbool.h>

/* The square of the cosine of a cutoff, 0 to 90 degrees; exact where it is a fraction: 0, 30, 45, 60, 90. */
struct pair fgl_cone_cos_square(float cutoff);

/* Whether the vertex is inside or on the edge. from_light is the vector from the light at `from` to the vertex at `to`;
 * axis may have any length. A zero vector has the cosine 0. */
bool fgl_cone_contains(const double from[3], const double to[3], const double axis[3], struct pair cos_square);

#endif
