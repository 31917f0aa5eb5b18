/* Texture coordinates (GL 1.5, 2.11.4 "Generating Texture Coordinates" and the texture matrices of 2.11.2): kernels.
 * Each runs over the vertices first .. first + n of a batch. */
#ifndef FGL_VERTEX_TEXGEN_KERNEL_H
#define FGL_VERTEX_TEXGEN_KERNEL_H

#include "vertex/transform_kernel.h"

#if R_EXACT
#define PLAN_TEXTURE(plan, k) (&(plan)->exact.texture[k])
#else
#define PLAN_TEXTURE(plan, k) (&(plan)->texture[k].numbers)
#endif

/* A plane's distance. OSMesa rule: summed from w on. */
static FGL_ALWAYS_INLINE real plane_distance(struct real4 p, const real plane[4])
{
    return ((p.w * plane[3] + p.z * plane[2]) + p.y * plane[1]) + p.x * plane[0];
}

/* The given coordinate c of each vertex. */
static FGL_ALWAYS_INLINE void given_coordinate(const struct vertex_plan *plan, struct vertex_batch *b, int unit, int c, int first,
                                               int n, real *FGL_RESTRICT to)
{
    const float *from = b->in[ATTR_TEX0 + unit].c[c] + first;
    const real constant = (real)plan->constant[ATTR_TEX0 + unit][c];
    if (plan->varying >> (ATTR_TEX0 + unit) & 1)
        for (int i = 0, end = whole_groups(n); i < end; i++)
            to[i] = (real)from[i];
    else
        for (int i = 0, end = whole_groups(n); i < end; i++)
            to[i] = constant;
}

static FGL_ALWAYS_INLINE void linear_coordinate(const struct vertex_plan *plan, struct vertex_batch *b, const real plane[4],
                                                const bool eye, int first, int n, real *FGL_RESTRICT to)
{
    const real *m = PLAN_NUMBERS(plan)->modelview;
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real4 p = load_position(b, first + i);
        if (eye)
            p = (struct real4){r_row4(p, m), r_row4(p, m + 1), r_row4(p, m + 2), r_row4(p, m + 3)};
        to[i] = plane_distance(p, plane);
    }
}

/* The direction from the eye, reflected at the normal. */
static FGL_ALWAYS_INLINE struct real3 reflection(struct vertex_work *work, int i)
{
    const struct real3 u = r_normalize3(load3(work->eye, i)), normal = load3(work->normal, i);
    const real d = r_dot3(normal, u), twice = d + d;
    return r_sub3(u, r_scale3(normal, twice));
}

/* Coordinate c of GL_SPHERE_MAP: 0 or 1. */
static FGL_ALWAYS_INLINE void sphere_coordinate(struct vertex_work *work, int c, int n, real *FGL_RESTRICT to)
{
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        const struct real3 u = r_normalize3(load3(work->eye, i)), normal = load3(work->normal, i);
        const real d = r_dot3(normal, u), twice = d + d;
        const real x = u.x - twice * normal.x, y = u.y - twice * normal.y, z = (1 - twice * normal.z) + u.z;
        const real scale = r_rsqrt((z * z + y * y) + x * x) * (real)0.5;
        to[i] = (c ? y : x) * scale + (real)0.5;
    }
}

static FGL_ALWAYS_INLINE void vector_coordinate(struct vertex_work *work, int c, const bool reflected, int n, real *FGL_RESTRICT to)
{
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        const struct real3 v = reflected ? reflection(work, i) : load3(work->normal, i);
        to[i] = c == 0 ? v.x : c == 1 ? v.y : v.z;
    }
}

static FGL_NOINLINE void generate_coordinate(const struct vertex_plan *plan, struct vertex_batch *b, int k, int c,
                                             struct vertex_work *work, int first, int n, real *FGL_RESTRICT to)
{
    const struct vertex_texture *texture = &plan->texture[k];
    switch (texture->gen[c]) {
    case GL_OBJECT_LINEAR: linear_coordinate(plan, b, PLAN_TEXTURE(plan, k)->plane[c], false, first, n, to); break;
    case GL_EYE_LINEAR: linear_coordinate(plan, b, PLAN_TEXTURE(plan, k)->plane[c], true, first, n, to); break;
    case GL_SPHERE_MAP: sphere_coordinate(work, c, n, to); break;
    case GL_REFLECTION_MAP: vector_coordinate(work, c, true, n, to); break;
    case GL_NORMAL_MAP: vector_coordinate(work, c, false, n, to); break;
    default: given_coordinate(plan, b, texture->unit, c, first, n, to); break;
    }
}

static FGL_ALWAYS_INLINE void transform_coordinates(const real m[16], struct vertex_work *FGL_RESTRICT work, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        const struct real4 p = {work->texture[0][i], work->texture[1][i], work->texture[2][i], work->texture[3][i]};
        for (int c = 0; c < 4; c++)
            work->texture[c][i] = r_row4(p, m + c);
    }
}

/* Texture k of the plan: its coordinates into the batch. */
static FGL_NOINLINE void run_texture(const struct vertex_plan *plan, struct vertex_batch *b, int k, struct vertex_work *work,
                                     int first, int n)
{
    for (int c = 0; c < 4; c++)
        generate_coordinate(plan, b, k, c, work, first, n, work->texture[c]);
    if (plan->texture[k].transformed)
        transform_coordinates(PLAN_TEXTURE(plan, k)->matrix, work, n);
    for (int c = 0; c < 4; c++)
        for (int i = 0, end = whole_groups(n); i < end; i++)
            RESULTS(b)->texture[k].c[c][first + i] = work->texture[c][i];
}

#endif
