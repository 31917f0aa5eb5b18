/* Fragments that are lit one by one (GL_WIN_phong_shading): their normals, eye coordinates and materials are interpolated,
 * and the equation is asked for their colours. Pixels that are not covered take the place of one that is. */
#ifndef FGL_FRAGMENT_LIGHT_H
#define FGL_FRAGMENT_LIGHT_H

#include "fragment/interpolate.h"

static inline void lit_lane(const struct fragments *f, const struct planes *p, int lane, const int from[LIT_GROUP],
                            double to[LIT_GROUP])
{
    for (int i = 0; i < LIT_GROUP; i++)
        to[i] = (double)(value_at(plane_of(p, lane), f->fx[from[i]], f->fy) * f->w[from[i]]);
}

static FGL_NOINLINE void light_group(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    const struct lit_lanes *lit = &plan->lit;
    struct lit_fragments group;
    int from[LIT_GROUP], covered = 0;
    while (covered < FRAGMENT_GROUP - 1 && !f->live[covered])
        covered++;
    for (int i = 0; i < LIT_GROUP; i++)
        from[i] = i < FRAGMENT_GROUP && f->live[i] ? i : covered;
    for (int c = 0; c < 3; c++)
        lit_lane(f, p, lit->normal + c, from, group.normal[c]);
    for (int c = 0; lit->eye && c < 3; c++)
        lit_lane(f, p, lit->eye + c, from, group.eye[c]);
    for (int k = 0; k < lit->attributes; k++)
        for (int c = 0; c < 4; c++)
            lit_lane(f, p, lit->attribute + 4 * k + c, from, group.attribute[k][c]);
    group.back = value_at(plane_of(p, lit->normal + 3), f->fx[covered], f->fy) > 0;
    lit->light(lit->lights, &group);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) f->color[c][i] = (real)group.color[c][i];
    for (int c = 0; c < 3 && plan->secondary_source == COLOR_LIT; c++)
        FOR_GROUP(i) f->secondary[c][i] = (real)group.secondary[c][i];
}

#endif
