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

/* Where a vertex is. */
struct window_vertex {
    real x, y, oow;
};

static FGL_ALWAYS_INLINE struct window_vertex window_vertex(const real *v)
{
    return (struct window_vertex){v[LANE_X], v[LANE_Y], v[LANE_OOW]};
}

static FGL_ALWAYS_INLINE struct gradients gradients_of(struct window_vertex v0, struct window_vertex v1, struct window_vertex v2)
{
    const real x01 = v0.x - v1.x, y01 = v0.y - v1.y, x20 = v2.x - v0.x, y20 = v2.y - v0.y;
    const real e = x01 * y20, f = y01 * x20, ooa = R_EXACT && e == f ? 0 : 1 / (e - f);
    return (struct gradients){x01 * ooa,         y01 * ooa,         x20 * ooa,
                              y20 * ooa,         v0.x - (real)0.5, v0.y - (real)0.5,
                              {v0.oow, v1.oow, v2.oow}};
}

static FGL_ALWAYS_INLINE struct gradients gradients_of_triangle(const real *const v[3])
{
    return gradients_of(window_vertex(v[0]), window_vertex(v[1]), window_vertex(v[2]));
}

struct plane {
    real a00, dadx, dady;
};

/* The plane of a value that is linear in window space, from its values at the vertices. */
static FGL_ALWAYS_INLINE struct plane plane_of(const struct gradients *g, real a0, real a1, real a2)
{
    const real d01 = a0 - a1, d20 = a2 - a0;
    const real dx = d01 * g->y20 - d20 * g->y01, dy = d20 * g->x01 - d01 * g->x20;
    return (struct plane){a0 - (dx * g->x0 + dy * g->y0), dx, dy};
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
        const struct plane plane = plane_of(g, a0, a1, a2);
        a00[i] = plane.a00;
        dadx[i] = plane.dadx;
        dady[i] = plane.dady;
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
