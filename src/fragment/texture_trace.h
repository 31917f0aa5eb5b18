/* What sampling made of one pixel, for explain: the kernels' own values, of a group that is computed once more. Kernels only. */
#ifndef FGL_FRAGMENT_TEXTURE_TRACE_H
#define FGL_FRAGMENT_TEXTURE_TRACE_H

#include "fragment/texture_sample.h"

static void trace_texture(const struct fragment_plan *plan, const struct planes *planes, int stage, int row, int x,
                          struct texture_trace *to)
{
    const struct texture_stage *s = &plan->texture[stage];
    const int first = x & -FRAGMENT_GROUP, i = x - first;
    struct fragments f;
    struct level_choice choice;
    real at[3][FRAGMENT_GROUP], texel[4][FRAGMENT_GROUP];
    start_fragments(&f, plan, planes, row, first, x, x + 1);
    find_w(&f, planes);
    coordinates_at(s, planes, FRAGMENT_GROUP, f.fx, f.fy, f.w, 3, at);
    sample_texture(&f, planes, s, texel);
    *to = (struct texture_trace){.magnified = true};
    for (int c = 0; c < 3; c++)
        to->coordinate[c] = (double)at[c][i];
    for (int c = 0; c < 4; c++)
        to->texel[c] = (double)texel[c][i];
    if (!s->sampler.needs_lod)
        return;
    choose_levels(&f, planes, s, s->sampler.dimensions, at, &choice);
    to->magnified = choice.magnify[i];
    to->level = to->magnified ? 0 : choice.level[i];
    to->fraction = to->magnified ? 0 : (double)choice.f[i];
}

#endif
