/* The general path: everything that a plan can ask for, a stage after the other in the order of
 * GL 1.5, 3.8-3.10 and 4.1, a group at a time; stencil and depth before all colours where these decide nothing.
 * Whatever the fused kernels draw, it draws to the same bytes. */
#ifndef FGL_FRAGMENT_GENERAL_H
#define FGL_FRAGMENT_GENERAL_H

#include "fragment/blend.h"
#include "fragment/light.h"
#include "fragment/texture_environment.h"

/* Whether any fragment is left to be written. */
static inline bool pass_tests(struct fragments *f, const struct fragment_plan *plan, const struct planes *planes)
{
    const bool any = plan->stencil_test || plan->depth_test ? stencil_depth_test(f, plan, planes) : any_live(f);
    if (FGL_UNLIKELY(plan->samples_passed != NULL))
        count_samples(f, plan);
    return plan->color_write && any;
}

static FGL_ALWAYS_INLINE void find_colors(struct fragments *f, const struct fragment_plan *plan, const struct planes *planes)
{
    find_w(f, planes);
    if (FGL_UNLIKELY(plan->color_source == COLOR_LIT))
        light_group(f, plan, planes);
    else
        interpolate_color(f, plan, planes);
    if (plan->textures)
        apply_textures(f, plan, planes);
    if (plan->has_secondary)
        add_secondary_color(f, plan, planes);
    if (plan->has_fog)
        apply_fog(f, plan, planes);
}

static void general_group(const struct fragment_plan *plan, const struct planes *planes, int row, int x,
                          int x0, int x1)
{
    struct fragments f;
    const bool color_decides = plan->alpha_test || planes->smoothing == SMOOTH_POINT; /* else the tests may come first */
    start_fragments(&f, plan, planes, row, x, x0, x1);
    if (!color_decides && !pass_tests(&f, plan, planes))
        return;
    find_colors(&f, plan, planes);
    if (planes->smoothing)
        apply_smoothing(&f, planes);
    if (plan->alpha_test)
        alpha_test(&f, plan);
    if (color_decides && !pass_tests(&f, plan, planes))
        return;
    if (plan->fb->color_kind == COLOR_FLOAT)
        write_float(&f, plan);
    else if (plan->fb->color_kind == COLOR_UNORM16)
        write_words(&f, plan);
    else
        write_packed(&f, plan);
}

static void general_fill(const struct fragment_plan *plan, const struct planes *planes,
                         const struct runs *runs)
{
    for (int i = 0; i < runs->n; i++) {
        const int x0 = runs->x0[i], x1 = runs->x1[i];
        for (int x = x0 & -FRAGMENT_GROUP; x < x1 && x0 < x1; x += FRAGMENT_GROUP)
            general_group(plan, planes, runs->y + i, x, x0, x1);
    }
}

#endif
