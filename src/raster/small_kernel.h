/* Pixels of small triangles: set-up as in setup.h, for sixteen pixels at once, each in a lane of its own. A triangle that covers more than one is
 * set up for each; most cover one. Kernels. */
#ifndef FGL_RASTER_SMALL_KERNEL_H
#define FGL_RASTER_SMALL_KERNEL_H

#include "raster/setup.h"

struct small_vertices {
    real lane[3][LANE_SECONDARY][SMALL_PIXELS];
};

/* From arrays of lanes to lanes of arrays. Lanes behind the last pixel repeat the first. */
static void load_small(struct small_vertices *FGL_RESTRICT to, const struct small_pixels *p, const int lanes)
{
    for (int i = 0; i < SMALL_PIXELS; i++) {
        const int from = i < p->n ? i : 0;
        for (int k = 0; k < 3; k++) {
            const real *v = p->vertex[k][from], *color = v + p->color[from];
            for (int lane = 0; lane < LANE_COLOR; lane++)
                to->lane[k][lane][i] = v[lane];
            for (int c = 0; c < lanes - LANE_COLOR; c++)
                to->lane[k][LANE_COLOR + c][i] = color[c];
        }
    }
}

static FGL_ALWAYS_INLINE struct window_vertex small_vertex(const struct small_vertices *v, int k, int i)
{
    return (struct window_vertex){v->lane[k][LANE_X][i], v->lane[k][LANE_Y][i], v->lane[k][LANE_OOW][i]};
}

/* struct gradients, an array for each number. */
struct small_gradients {
    real x01[SMALL_PIXELS], y01[SMALL_PIXELS], x20[SMALL_PIXELS], y20[SMALL_PIXELS], x0[SMALL_PIXELS], y0[SMALL_PIXELS];
};

static void small_gradients(struct small_gradients *FGL_RESTRICT to, const struct small_vertices *FGL_RESTRICT v)
{
    for (int i = 0; i < SMALL_PIXELS; i++) {
        const struct gradients g = gradients_of(small_vertex(v, 0, i), small_vertex(v, 1, i), small_vertex(v, 2, i));
        to->x01[i] = g.x01;
        to->y01[i] = g.y01;
        to->x20[i] = g.x20;
        to->y20[i] = g.y20;
        to->x0[i] = g.x0;
        to->y0[i] = g.y0;
    }
}

/* One lane's planes. attribute: multiplied by 1/w first, as in plane_lanes. */
static FGL_ALWAYS_INLINE void small_planes(struct scattered *FGL_RESTRICT s, const struct small_vertices *FGL_RESTRICT v,
                                           const struct small_gradients *FGL_RESTRICT at, int lane, const bool attribute)
{
    for (int i = 0; i < SMALL_PIXELS; i++) {
        const struct gradients g = {at->x01[i], at->y01[i], at->x20[i], at->y20[i], at->x0[i], at->y0[i], {0, 0, 0}};
        real a[3];
        for (int k = 0; k < 3; k++)
            a[k] = attribute ? v->lane[k][lane][i] * v->lane[k][LANE_OOW][i] : v->lane[k][lane][i];
        const struct plane p = plane_of(&g, a[0], a[1], a[2]);
        s->a00[lane][i] = p.a00;
        s->dadx[lane][i] = p.dadx;
        s->dady[lane][i] = p.dady;
    }
}

static void draw_small_pixels(const struct raster_plan *plan, struct small_pixels *p)
{
    struct small_vertices v;
    struct small_gradients g;
    struct scattered s;

    if (p->n == 0)
        return;
    s.n = p->n;
    memcpy(s.x, p->x, sizeof s.x);
    memcpy(s.y, p->y, sizeof s.y);
    if (plan->lanes > LANE_COLOR)
        load_small(&v, p, LANE_SECONDARY);
    else
        load_small(&v, p, LANE_COLOR);
    small_gradients(&g, &v);
    small_planes(&s, &v, &g, LANE_Z, false);
    small_planes(&s, &v, &g, LANE_OOW, false);
    if (plan->flat)
        memcpy(s.a00[LANE_COLOR], v.lane[2][LANE_COLOR], 4 * sizeof s.a00[0]);
    for (int lane = LANE_COLOR; lane < LANE_SECONDARY && plan->lanes > LANE_COLOR && !plan->flat; lane++)
        small_planes(&s, &v, &g, lane, true);
    plan->fragment->scatter(plan->fragment, &s);
    p->n = 0;
}

#endif
