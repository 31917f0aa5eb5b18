/* Positions and normals (GL 1.5, 2.11 "Coordinate Transformations" and 2.12 "Clipping"): kernels.
 * Each runs over the vertices first .. first + n of a batch, or 0 .. n of the work space. */
#ifndef FGL_VERTEX_TRANSFORM_KERNEL_H
#define FGL_VERTEX_TRANSFORM_KERNEL_H

#include "vertex/work.h"

/* Clip coordinates, outcodes against the view volume, window coordinates (GL 1.5, 2.11.1 "Controlling the
 * Viewport"). */
static FGL_ALWAYS_INLINE void transform_positions(const struct vertex_plan *FGL_RESTRICT plan,
                                                  struct vertex_batch *FGL_RESTRICT b, int first, int n)
{
    const real *m = PLAN_NUMBERS(plan)->mvp;
    const real *scale = PLAN_NUMBERS(plan)->viewport_scale, *trans = PLAN_NUMBERS(plan)->viewport_trans;
    real_lanes4 *clip = &RESULTS(b)->clip, *win = &RESULTS(b)->win;

    for (int i = first, end = first + whole_groups(n); i < end; i++) {
        struct real4 p = load_position(b, i);
        real x = r_row4(p, m), y = r_row4(p, m + 1), z = r_row4(p, m + 2), w = r_row4(p, m + 3), oow = 1 / w;

        clip->c[0][i] = x;
        clip->c[1][i] = y;
        clip->c[2][i] = z;
        clip->c[3][i] = w;
        win->c[0][i] = r_fma(x * oow, scale[0], trans[0]);
        win->c[1][i] = r_fma(y * oow, scale[1], trans[1]);
        win->c[2][i] = r_fma(z * oow, scale[2], trans[2]);
        win->c[3][i] = oow;
        b->outcode[i] = (x > w ? CLIP_RIGHT : 0u) | (x + w < 0 ? CLIP_LEFT : 0u) | (y > w ? CLIP_TOP : 0u) |
                        (y + w < 0 ? CLIP_BOTTOM : 0u) | (z + w < 0 ? CLIP_NEAR : 0u) |
                        (z > w ? CLIP_FAR : 0u);
    }
}

/* GL 1.5, 2.12: the half-space of a client-defined plane. OSMesa rule: in clip space; exact: in eye space. */
static FGL_ALWAYS_INLINE void test_user_plane(const real plane[4], real_lanes4 *FGL_RESTRICT position, uint32_t bit,
                                              struct vertex_batch *FGL_RESTRICT b, int first, int n)
{
    for (int i = first, end = first + whole_groups(n); i < end; i++) {
        real xy = r_fma(plane[1], position->c[1][i], plane[0] * position->c[0][i]);
        real d = r_fma(plane[3], position->c[3][i], r_fma(plane[2], position->c[2][i], xy));
        b->outcode[i] |= d < 0 ? bit : 0u;
    }
}

/* Eye coordinates as they are, for user clip planes. */
#if R_EXACT
static FGL_ALWAYS_INLINE void keep_eye(const struct vertex_plan *FGL_RESTRICT plan, struct vertex_batch *FGL_RESTRICT b,
                                       int first, int n)
{
    const real *m = PLAN_NUMBERS(plan)->modelview;

    for (int i = first, end = first + whole_groups(n); i < end; i++) {
        struct real4 p = load_position(b, i);
        for (int row = 0; row < 4; row++)
            b->exact.eye.c[row][i] = r_row4(p, m + row);
    }
}
#endif

static FGL_ALWAYS_INLINE void transform_eye(const struct vertex_plan *FGL_RESTRICT plan,
                                            struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                            struct vertex_work *FGL_RESTRICT work)
{
    const real *m = PLAN_NUMBERS(plan)->modelview;

    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real4 p = load_position(b, first + i);
        struct real3 eye = r_vec3(r_row4(p, m), r_row4(p, m + 1), r_row4(p, m + 2));
        if (R_EXACT) { /* w = 0: a direction, as a point very far away */
            real w = r_row4(p, m + 3), divisor = r_select(w == 0, (real)0x1p-100, w);
            eye = r_vec3(eye.x / divisor, eye.y / divisor, eye.z / divisor);
        }
        store3(work->eye, i, eye);
    }
}

/* Marks vertices whose eye coordinates float cannot light: w is not 1, which OSMesa takes it for, or they are near the
 * viewer where that matters. Their rounding is some 2^-23 of the greatest term in their sums, so distances of 2^-7 of that
 * are wrong by 2^-16. */
static FGL_ALWAYS_INLINE void check_eye(const struct vertex_plan *FGL_RESTRICT plan,
                                        struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                        struct vertex_work *FGL_RESTRICT work)
{
    const real *m = PLAN_NUMBERS(plan)->modelview;
    const bool local_viewer = plan->need_view;
    const real nearest = (real)0x1p-7;
    real greatest = 0;

    for (int k = 0; k < 12; k++)
        greatest = r_max(greatest, k % 4 == 3 ? 0 : r_abs(m[k]));
    const real offset = r_max(r_max(r_abs(m[12]), r_abs(m[13])), r_abs(m[14]));
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real4 p = load_position(b, first + i);
        struct real3 eye = load3(work->eye, i);
        real distance = nearest * (greatest * (r_abs(p.x) + r_abs(p.y) + r_abs(p.z)) + offset);
        real square = local_viewer ? r_dot3(eye, eye) : 1;
        work->least[i] = r_max(distance * distance, SAFE_SQUARE_LEAST);
        work->extreme[i] |= (uint32_t)(r_row4(p, m + 3) != 1);
        work->extreme[i] |= local_viewer ? outside(square, work->least[i], SAFE_SQUARE_GREATEST) : 0u;
    }
}

static FGL_ALWAYS_INLINE void normalize_view(struct vertex_work *FGL_RESTRICT work, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++)
        store3(work->view, i, r_normalize3(load3(work->eye, i)));
}

static FGL_ALWAYS_INLINE void load_normals(const struct vertex_plan *FGL_RESTRICT plan,
                                           struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                           struct vertex_work *FGL_RESTRICT work)
{
    const bool varying = plan->varying >> ATTR_NORMAL & 1;

    for (int c = 0; c < 3; c++)
        if (varying)
            for (int i = 0, end = whole_groups(n); i < end; i++)
                work->normal[c][i] = (real)b->in[ATTR_NORMAL].c[c][first + i];
        else
            for (int i = 0, end = whole_groups(n); i < end; i++)
                work->normal[c][i] = (real)plan->constant[ATTR_NORMAL][c];
}

/* GL 1.5, 2.11.3 "Normal Transformation". */
static FGL_ALWAYS_INLINE void transform_normals(const struct vertex_plan *FGL_RESTRICT plan,
                                                struct vertex_work *FGL_RESTRICT work, int n,
                                                const bool to_eye, const enum normal_scaling scaling)
{
    const real(*m)[3] = PLAN_NUMBERS(plan)->normal_matrix;

    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real3 v = load3(work->normal, i);
        if (to_eye)
            v = r_vec3(r_row3(v, m[0]), r_row3(v, m[1]), r_row3(v, m[2]));
        if (!R_EXACT)
            work->extreme[i] |= outside(r_dot3(v, v), scaling == NORMAL_NORMALIZE ? SAFE_SQUARE_LEAST : 0,
                                        SAFE_SQUARE_GREATEST);
        if (scaling == NORMAL_NORMALIZE)
            v = r_normalize3(v);
        if (scaling == NORMAL_RESCALE)
            v = r_scale3(v, PLAN_NUMBERS(plan)->rescale_factor);
        store3(work->normal, i, v);
    }
}

/* |z| in eye space: the distance that fog and point attenuation use (GL 1.5, 3.10 "Fog"). */
static FGL_ALWAYS_INLINE void eye_distance(const struct vertex_plan *FGL_RESTRICT plan,
                                           struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                           real *FGL_RESTRICT distance)
{
    for (int i = first, end = first + whole_groups(n); i < end; i++)
        distance[i] = r_abs(r_row4_w_first(load_position(b, i), PLAN_NUMBERS(plan)->modelview + 2));
}

/* GL 1.5, 3.10: the fog coordinate as it was given. OSMesa rule: its magnitude. */
static FGL_ALWAYS_INLINE void given_fog_coord(const struct vertex_plan *FGL_RESTRICT plan,
                                              struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                              real *FGL_RESTRICT coord)
{
    const bool varying = plan->varying >> ATTR_FOG_COORD & 1;

    for (int i = first, end = first + whole_groups(n); i < end; i++) {
        const real c = varying ? (real)b->in[ATTR_FOG_COORD].c[0][i] : (real)plan->constant[ATTR_FOG_COORD][0];
        coord[i] = R_EXACT ? c : r_abs(c);
    }
}

/* GL 1.5, 3.3 "Points": the size attenuated by distance. */
static FGL_ALWAYS_INLINE void point_sizes(const struct vertex_plan *FGL_RESTRICT plan,
                                          struct vertex_batch *FGL_RESTRICT b, int first, int n)
{
    const real k[3] = {(real)plan->point_attenuation[0], (real)plan->point_attenuation[1],
                       (real)plan->point_attenuation[2]};

    for (int i = first, end = first + whole_groups(n); i < end; i++) {
        real d = r_abs(r_row4_w_first(load_position(b, i), PLAN_NUMBERS(plan)->modelview + 2));
        real size = (real)plan->point_size * r_rsqrt(k[0] + d * (k[1] + d * k[2]));
        b->point_size[i] = (float)r_min(r_max(size, (real)plan->point_size_min), (real)plan->point_size_max);
    }
}

#endif
