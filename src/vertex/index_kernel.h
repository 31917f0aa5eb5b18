/* Colours of vertices in colour index mode: one lane, the first, of what RGBA mode calls colour. Kernels. */
#ifndef FGL_VERTEX_INDEX_KERNEL_H
#define FGL_VERTEX_INDEX_KERNEL_H

#include "base/color_index.h"
#include "vertex/light_kernel.h"

/* GL 1.5, 2.14.6 "Clamping or Masking". */
static FGL_ALWAYS_INLINE void mask_lane(const float *FGL_RESTRICT in, real *FGL_RESTRICT out, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++)
        out[i] = (real)fgl_index_mask((double)in[i]);
}

/* GL 1.5, 2.14.5 "Color Index Lighting": with d the diffuse and s the specular sum of the lights, s' = min(s, 1),
 *   c = a_m + d (1 - s') (d_m - a_m) + s' (s_m - a_m),  c' = min(c, s_m)
 * where a_m, d_m, s_m are the material's colour indexes. The sums stand in the first channel of work->color and
 * work->specular. */
static FGL_ALWAYS_INLINE void light_indexes(const struct lighting_plan *FGL_RESTRICT plan,
                                            struct vertex_batch *FGL_RESTRICT b, int first, int n, int face,
                                            struct vertex_work *FGL_RESTRICT work)
{
    real(*index)[VERTEX_CHUNK] = work->material[0]; /* a_m, d_m, s_m: the sums are complete, this room is free */
    real *out = RESULTS(b)->color[face].c[0] + first;

    for (int k = 0; k < 3; k++)
        load_parameter(plan, b, first, n, MAT_INDEXES, face, k, index[k]);
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        real am = index[0][i], dm = index[1][i], sm = index[2][i];
        real d = work->color[0][i], s = r_min(work->specular[0][i], 1);
        real c = am + d * (1 - s) * (dm - am) + s * (sm - am);
        out[i] = (real)fgl_index_mask((double)r_min(c, sm));
    }
}

#endif
