/* What the fused kernels do (fused.h), for pixels of small triangles: sixteen of as many planes at once. They are tested and written one
 * after the other, since two may be the same pixel. */
#ifndef FGL_FRAGMENT_SCATTER_H
#define FGL_FRAGMENT_SCATTER_H

#include "fragment/group.h"

/* The plane of a lane at pixel i, as value_at. */
static FGL_ALWAYS_INLINE real scattered_at(const struct scattered *s, int lane, int i)
{
    return r_fma(s->dady[lane][i], (real)s->y[i], r_fma(s->dadx[lane][i], (real)s->x[i], s->a00[lane][i]));
}

static FGL_ALWAYS_INLINE void scattered_color(const struct fragment_plan *plan, const struct scattered *s,
                                              uint32_t *FGL_RESTRICT color, const enum color_source source)
{
    const float *constant = plan->constant_color;
    const uint32_t all = pack_unorm8((real)constant[0], (real)constant[1], (real)constant[2], (real)constant[3]);

    for (int i = 0; i < SCATTERED_MAX; i++) {
        if (source == COLOR_CONSTANT) {
            color[i] = all;
        } else if (source == COLOR_FLAT) {
            color[i] = pack_unorm8(s->a00[LANE_COLOR][i], s->a00[LANE_COLOR + 1][i], s->a00[LANE_COLOR + 2][i],
                                   s->a00[LANE_COLOR + 3][i]);
        } else {
            const real w = 1 / scattered_at(s, LANE_OOW, i);
            color[i] = pack_unorm8(scattered_at(s, LANE_COLOR, i) * w, scattered_at(s, LANE_COLOR + 1, i) * w,
                                   scattered_at(s, LANE_COLOR + 2, i) * w, scattered_at(s, LANE_COLOR + 3, i) * w);
        }
    }
}

static FGL_ALWAYS_INLINE void scatter(const struct fragment_plan *plan, const struct scattered *s, const enum depth_kind kind,
                                      const enum color_source source)
{
    const struct framebuffer *fb = plan->fb;
    const real depth_max = (real)fb->depth_max;
    int32_t depth[SCATTERED_MAX];
    uint32_t color[SCATTERED_MAX];

    for (int i = 0; i < SCATTERED_MAX && kind != DEPTH_OFF; i++)
        depth[i] = depth_from_z(scattered_at(s, LANE_Z, i), depth_max);
    scattered_color(plan, s, color, source);
    for (int i = 0; i < s->n; i++) {
        const ptrdiff_t at = s->y[i] * (ptrdiff_t)fb->stride + s->x[i];
        if (kind != DEPTH_OFF) {
            int32_t *old = (int32_t *)fb->depth + at;
            if (kind == DEPTH_LESS ? depth[i] >= *old : depth[i] > *old)
                continue;
            *old = depth[i];
        }
        ((uint32_t *)fb->color)[at] = color[i];
    }
}

#define SCATTER(name, kind, source)                                                                          \
    static void name(const struct fragment_plan *plan, const struct scattered *pixels)                       \
    {                                                                                                        \
        scatter(plan, pixels, kind, source);                                                                 \
    }
SCATTER(scatter_constant, DEPTH_OFF, COLOR_CONSTANT)
SCATTER(scatter_flat, DEPTH_OFF, COLOR_FLAT)
SCATTER(scatter_smooth, DEPTH_OFF, COLOR_SMOOTH)
SCATTER(scatter_constant_less, DEPTH_LESS, COLOR_CONSTANT)
SCATTER(scatter_flat_less, DEPTH_LESS, COLOR_FLAT)
SCATTER(scatter_smooth_less, DEPTH_LESS, COLOR_SMOOTH)
SCATTER(scatter_constant_lequal, DEPTH_LEQUAL, COLOR_CONSTANT)
SCATTER(scatter_flat_lequal, DEPTH_LEQUAL, COLOR_FLAT)
SCATTER(scatter_smooth_lequal, DEPTH_LEQUAL, COLOR_SMOOTH)
#undef SCATTER

#endif
