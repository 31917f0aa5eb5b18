/* Fragments in colour index mode: the general path's stages that there are for indexes (GL 1.5, 3.10 "Fog",
 * 3.11 "Antialiasing Application", 4.1). An index is the first component of the colour; the fourth serves as
 * the coverage. */
#ifndef FGL_FRAGMENT_INDEX_H
#define FGL_FRAGMENT_INDEX_H

#include "base/color_index.h"
#include "fragment/blend.h"

static inline void interpolate_index(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    const real flat = plan->color_source == COLOR_FLAT ? PLANES(p)->a00[LANE_COLOR] : (real)plan->constant_color[0];
    if (plan->pixels && plan->pixels->color[0])
        FOR_GROUP(i) f->color[0][i] = (real)plan->pixels->color[0][f->x + i];
    else if (plan->color_source == COLOR_SMOOTH)
        interpolate_channel(f, p, LANE_COLOR, f->color[0]);
    else
        FOR_GROUP(i) f->color[0][i] = flat;
    FOR_GROUP(i) f->color[3][i] = 1;
}

/* GL 1.5, 3.10 "Fog": I = i_r + (1 - f) i_f, masked. */
static inline void fog_index(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    const real fog = (real)plan->fog_index;
    real factor[FRAGMENT_GROUP];
    fog_factor(f, plan, p, factor);
    FOR_GROUP(i) f->color[0][i] = (real)fgl_index_mask((double)(f->color[0][i] + (1 - factor[i]) * fog));
}

/* GL 1.5, 4.1.9 "Dithering": the nearest index there is; dithered ones may be the same. */
static inline uint32_t nearest_index(real v)
{
    return (uint32_t)r_round_small(v > 0 ? (v < FGL_INDEX_MAX ? v : FGL_INDEX_MAX) : 0);
}

/* GL 1.5, 3.2 "Antialiasing": coverage is the low four bits of the index, all ones where it is complete. */
static inline uint32_t cover_index(uint32_t index, real coverage)
{
    return (index & ~15u) | (uint32_t)r_round_small(r_saturate(coverage) * 15);
}

static inline void write_index(const struct fragments *f, const struct fragment_plan *plan, bool smooth)
{
    uint8_t *pixel = (uint8_t *)plan->fb->color + pixel_index(plan->fb, f->row, f->x);
    const uint32_t mask = plan->color_buffer.index_writemask & FGL_INDEX_MAX;
    uint32_t src[FRAGMENT_GROUP], dst[FRAGMENT_GROUP];
    FOR_GROUP(i) dst[i] = pixel[i];
    FOR_GROUP(i) src[i] = nearest_index(f->color[0][i]);
    if (smooth)
        FOR_GROUP(i) src[i] = cover_index(src[i], f->color[3][i]);
    if (plan->logic_op)
        logic_op(plan->color_buffer.logic_op_mode, src, dst, FGL_INDEX_MAX);
    FOR_GROUP(i) {
        const uint32_t write = mask & (uint32_t)f->live[i];
        pixel[i] = (uint8_t)((dst[i] & ~write) | (src[i] & write));
    }
}

static void index_group(const struct fragment_plan *plan, const struct planes *planes, int row, int x, int x0,
                        int x1)
{
    struct fragments f;
    start_fragments(&f, plan, planes, row, x, x0, x1);
    find_w(&f, planes);
    interpolate_index(&f, plan, planes);
    if (plan->has_fog)
        fog_index(&f, plan, planes);
    if (planes->smoothing == SMOOTH_LINE || planes->smoothing == SMOOTH_POINT)
        apply_smoothing(&f, planes);
    if (plan->stencil_test || plan->depth_test)
        stencil_depth_test(&f, plan, planes);
    if (FGL_UNLIKELY(plan->samples_passed != NULL))
        count_samples(&f, plan);
    if (plan->color_write && any_live(&f))
        write_index(&f, plan, planes->smoothing != SMOOTH_NONE);
}

static void index_fill(const struct fragment_plan *plan, const struct planes *planes, const struct runs *runs)
{
    for (int i = 0; i < runs->n; i++) {
        const int x0 = runs->x0[i], x1 = runs->x1[i];
        for (int x = x0 & -FRAGMENT_GROUP; x < x1 && x0 < x1; x += FRAGMENT_GROUP)
            index_group(plan, planes, runs->y + i, x, x0, x1);
    }
}

#endif
