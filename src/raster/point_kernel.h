/* Points (GL 1.5, 3.3 "Points"), in OSMesa's way: a square of whole pixels. Kernels. */
#ifndef FGL_RASTER_POINT_KERNEL_H
#define FGL_RASTER_POINT_KERNEL_H

#include "raster/coverage.h"
#include "raster/setup.h"

/* Half away from zero. */
static int nearest(real v)
{
    return (int)(v >= 0 ? v + (real)0.5 : v - (real)0.5);
}

/* Attributes do not change over a point. */
static void point_planes(const struct raster_plan *plan, struct planes *p, const real *v)
{
    for (int lane = LANE_Z; lane < plan->lanes; lane++)
        plane_constant(p, lane, lane < LANE_COLOR ? v[lane] : v[lane] * v[LANE_OOW]);
    if (plan->flat)
        flat_planes(p, v + LANE_COLOR, plan->secondary);
    PLANES(p)->z_offset = 0;
    p->smoothing = SMOOTH_NONE;
    p->stipple = NULL;
}

/* The first column or row of n that has the centre v, in 1/256 pixel. */
static int first_pixel(int v, int n)
{
    return n & 1 ? (v >> 8) - (n - 1) / 2 : ((v + 128) >> 8) - n / 2;
}

static void aliased_point(const struct raster_plan *plan, const real *v, float size)
{
    const int n = (int)(round_even(256.0 * (double)fmaxf(1.0f, size)) + 127) >> 8; /* halves go down */
    const int x = first_pixel(nearest(v[LANE_X] * 256), n),
              y = first_pixel(nearest(v[LANE_Y] * 256) - 1 + plan->first_row_owned, n);
    const struct rect b = {fgl_max(plan->bounds.x0, x), fgl_max(plan->bounds.y0, y),
                           fgl_min(plan->bounds.x1, x + n), fgl_min(plan->bounds.y1, y + n)};
    struct planes planes;
    struct runs runs;
    if (b.x0 >= b.x1 || b.y0 >= b.y1)
        return;
    point_planes(plan, &planes, v);
    for (runs.y = b.y0; runs.y < b.y1; runs.y += runs.n) {
        runs.n = fgl_min(RUNS_MAX, b.y1 - runs.y);
        for (int i = 0; i < runs.n; i++) {
            runs.x0[i] = b.x0;
            runs.x1[i] = b.x1;
        }
        plan->fragment->fill(plan->fragment, &planes, &runs);
    }
}

/* GL_ARB_point_sprite: over a point of `width` pixels s goes from 0 at its left to 1, t from 0 at its top. r is 0, q is 1. */
static void sprite_coordinates(const struct raster_plan *plan, struct planes *p, const real *v, int lane, real width)
{
    const real oow = v[LANE_OOW];
    for (int c = 0; c < 2; c++) {
        const real step = c && plan->fragment->fb->y_up ? -1 / width : 1 / width, center = v[LANE_X + c] - (real)0.5;
        plane_constant(p, lane + c, ((real)0.5 - step * center) * oow);
        (c ? PLANES(p)->dady : PLANES(p)->dadx)[lane + c] = step * oow;
    }
    plane_constant(p, lane + 2, 0);
    plane_constant(p, lane + 3, oow);
}

/* GL_ARB_point_sprite: the square itself, whose edges need not be whole pixels. */
static void point_sprite(const struct raster_plan *plan, const real *v, float size)
{
    const int64_t width = nearest((real)fmaxf(1.0f, size) * 256), half = width / 2;
    const int64_t x = nearest((v[LANE_X] - (real)0.5) * 256) - half, y = nearest((v[LANE_Y] - (real)0.5) * 256) - half;
    const struct polygon square = {{x + width, x, x, x + width}, {y, y, y + width, y + width}};
    struct planes planes;

    point_planes(plan, &planes, v);
    for (int i = 0; i < plan->fragment->textures; i++)
        if (plan->fragment->texture[i].across_sprite)
            sprite_coordinates(plan, &planes, v, plan->fragment->texture[i].lane, R_EXACT ? (real)fmaxf(1.0f, size) : (real)width / 256);
    quad(plan, &square, &planes);
}

/* A square of two triangles around a disc; the fragment stage drops what lies outside the disc. OSMesa rule: its radius is at least 1, or
 * 0.5 where sizes are attenuated. */
static void smooth_point(const struct raster_plan *plan, const real *v, float size)
{
    const real radius = (real)fmaxf(plan->size_lane ? 0.5f : 1.0f, size * 0.5f), pixel = 1 / radius,
                inner2 = 1 - 2 * pixel + pixel * pixel;
    real corner[4][LANE_MAX];
    for (int i = 0; i < 4; i++) {
        const real x = i == 1 || i == 2 ? 1 : -1, y = i >= 2 ? 1 : -1;
        memcpy(corner[i], v, (size_t)plan->lanes * sizeof(real));
        corner[i][LANE_X] += x * radius;
        corner[i][LANE_Y] += y * radius;
        corner[i][LANE_SMOOTH + 0] = x;
        corner[i][LANE_SMOOTH + 1] = y;
        corner[i][LANE_SMOOTH + 2] = inner2;
        corner[i][LANE_SMOOTH + 3] = 1;
    }
    smooth_triangle(plan, corner[0], corner[1], corner[2], v, SMOOTH_POINT);
    smooth_triangle(plan, corner[0], corner[2], corner[3], v, SMOOTH_POINT);
}

static void draw_point(const struct raster_plan *plan, const void *v, float size)
{
    if (!within_limit(v))
        return;
    if (plan->point_sprite)
        point_sprite(plan, v, size);
    else if (plan->point_smooth)
        smooth_point(plan, v, size);
    else
        aliased_point(plan, v, size);
}

#endif
