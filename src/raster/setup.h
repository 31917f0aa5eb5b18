/* Set-up: the planes of a primitive's attributes (GL 1.5, 3.5.1 "Basic Polygon Rasterization"), OSMesa's
 * operations in its order. Kernels. */
#ifndef FGL_RASTER_SETUP_H
#define FGL_RASTER_SETUP_H

#include "fragment/planes.h"
#include "raster/raster.h"

/* Window-space differences of a triangle's vertices, unsnapped, divided by twice its area. */
struct gradients {
    real x01, y01, x20, y20;
    real x0, y0; /* of v0, from the centre of the framebuffer's top left pixel */
    real oow[3]; /* 1/w of the vertices */
};

static FGL_ALWAYS_INLINE struct gradients gradients_of(const real *const v[3])
{
    const real *const v0 = v[0], *const v1 = v[1], *const v2 = v[2];
    const real x01 = v0[LANE_X] - v1[LANE_X], y01 = v0[LANE_Y] - v1[LANE_Y];
    const real x20 = v2[LANE_X] - v0[LANE_X], y20 = v2[LANE_Y] - v0[LANE_Y];
    const real e = x01 * y20, f = y01 * x20, ooa = R_EXACT && e == f ? 0 : 1 / (e - f);
    return (struct gradients){x01 * ooa,
                              y01 * ooa,
                              x20 * ooa,
                              y20 * ooa,
                              v0[LANE_X] - (real)0.5,
                              v0[LANE_Y] - (real)0.5,
                              {v0[LANE_OOW], v1[LANE_OOW], v2[LANE_OOW]}};
}

/* The planes of lanes first .. first + n, whose values stand in the vertices from lane `from` on. Attributes
 * are multiplied by their vertex's 1/w first: what is linear in window space is attribute/w (GL 1.5,
 * equation 3.6). */
static FGL_ALWAYS_INLINE void plane_lanes(struct planes *p, int first, const int n, const bool attribute,
                                          const struct gradients *g, const real *const v[3], int from)
{
    const real *v0 = v[0] + from, *v1 = v[1] + from, *v2 = v[2] + from;
    real *FGL_RESTRICT a00 = PLANES(p)->a00 + first, *FGL_RESTRICT dadx = PLANES(p)->dadx + first,
                        *FGL_RESTRICT dady = PLANES(p)->dady + first;
    for (int i = 0; i < n; i++) {
        const real a0 = attribute ? v0[i] * g->oow[0] : v0[i], a1 = attribute ? v1[i] * g->oow[1] : v1[i],
                    a2 = attribute ? v2[i] * g->oow[2] : v2[i];
        const real d01 = a0 - a1, d20 = a2 - a0;
        const real dx = d01 * g->y20 - d20 * g->y01, dy = d20 * g->x01 - d01 * g->x20;
        dadx[i] = dx;
        dady[i] = dy;
        a00[i] = a0 - (dx * g->x0 + dy * g->y0);
    }
}

/* A value that is the same all over the primitive. */
static FGL_ALWAYS_INLINE void plane_constant(struct planes *p, int lane, real value)
{
    PLANES(p)->a00[lane] = value;
    PLANES(p)->dadx[lane] = PLANES(p)->dady[lane] = 0;
}

/* Flat shading: colour, and after it secondary colour, of the provoking vertex. */
static FGL_ALWAYS_INLINE void flat_planes(struct planes *p, const real *color, bool secondary)
{
    for (int i = 0; i < (secondary ? 7 : 4); i++)
        plane_constant(p, LANE_COLOR + i, color[i]);
}

/* Polygon offset (GL 1.5, 3.5.5 "Depth Offset"). OSMesa rule: from unsnapped window coordinates, after the
 * swap that makes the triangle counter-clockwise. */
static inline real polygon_offset(const struct raster_plan *plan, const real *const v[3])
{
    const real *const v0 = v[0], *const v1 = v[1], *const v2 = v[2];
    const real x01 = v0[LANE_X] - v1[LANE_X], y01 = v0[LANE_Y] - v1[LANE_Y], z01 = v0[LANE_Z] - v1[LANE_Z];
    const real x20 = v2[LANE_X] - v0[LANE_X], y20 = v2[LANE_Y] - v0[LANE_Y], z20 = v2[LANE_Z] - v0[LANE_Z];
    const real det = x01 * y20 - y01 * x20, inv_det = 1 / det;
    const real dzdx = r_abs((z20 * y01 - y20 * z01) * inv_det),
                dzdy = r_abs((x20 * z01 - z20 * x01) * inv_det);
    const real m = dzdx > dzdy ? dzdx : dzdy;
    return (real)plan->offset_units + m * (real)plan->offset_factor;
}

#endif
