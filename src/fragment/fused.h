/* The fused kernels: depth test, interpolation and write in one pass, for plans with no other stage
 * (GL 1.5, 4.1.5 "Depth Buffer Test" and the write of 4.2); or with the general path's stages between, a function of its own
 * for all. One body; its flags are constants in each instance. */
#ifndef FGL_FRAGMENT_FUSED_H
#define FGL_FRAGMENT_FUSED_H

#include "fragment/general.h"

/* In place of a source: whatever the general path's stages make of colours. */
enum { COLOR_STAGED = COLOR_SOURCES };

/* One row of a primitive. depth and color point at pixel 0 of the row. */
struct fused_row {
    real y;
    int x0, x1;
    real depth_max;
    uint32_t flat_color;
    int32_t *depth;
    uint32_t *color;
    const uint32_t *image; /* by window x */
};

/* The depth test: writes the depth of the pixels that pass, marks them in live (all bits or none). Returns
 * whether any does. */
static FGL_ALWAYS_INLINE bool fused_depth(const struct planes *p, const struct fused_row *row, int x,
                                          int32_t *FGL_RESTRICT live, const enum depth_kind kind, const int n, const bool plain)
{
    int32_t *FGL_RESTRICT depth = kind != DEPTH_OFF ? row->depth + x : NULL;
    const struct plane plane = plane_of(p, LANE_Z);
    const real y = row->y, offset = PLANES(p)->z_offset, depth_max = row->depth_max;
    const int x0 = row->x0, x1 = row->x1;
    int32_t any = 0;
    FGL_INNER_VECTOR_LOOP for (int i = 0; i < n; i++) {
        const int32_t inside = -((x + i >= x0) & (x + i < x1));
        int32_t pass = inside;
        if (kind != DEPTH_OFF) {
            const real z = value_if(plain, plane, (real)(x + i), y) + offset;
            const int32_t new_depth = depth_from_z(z, depth_max), old_depth = depth[i];
            pass &= -(kind == DEPTH_LESS ? new_depth < old_depth : new_depth <= old_depth);
            depth[i] = pass ? new_depth : old_depth;
        }
        live[i] = pass;
        any |= pass;
    }
    return any != 0;
}

static FGL_ALWAYS_INLINE void fused_color(const struct planes *p, const struct fused_row *row, int x,
                                          const int32_t *FGL_RESTRICT live, const enum color_source source, const bool plain)
{
    uint32_t *FGL_RESTRICT color = row->color + x;
    const uint32_t *FGL_RESTRICT image = source == COLOR_IMAGE ? row->image + x : NULL;
    const struct plane oow = plane_of(p, LANE_OOW), r = plane_of(p, LANE_COLOR), g = plane_of(p, LANE_COLOR + 1),
                       b = plane_of(p, LANE_COLOR + 2), a = plane_of(p, LANE_COLOR + 3);
    const real y = row->y;
    const uint32_t flat = row->flat_color;
    FGL_INNER_VECTOR_LOOP for (int i = 0; i < FUSED_GROUP; i++) {
        uint32_t c = source == COLOR_IMAGE ? image[i] : flat;
        if (source == COLOR_SMOOTH) {
            const real fx = (real)(x + i), w = 1 / value_if(plain, oow, fx, y);
            c = pack_unorm8(value_if(plain, r, fx, y) * w, value_if(plain, g, fx, y) * w, value_if(plain, b, fx, y) * w,
                            value_if(plain, a, fx, y) * w);
        }
        color[i] = live[i] ? c : color[i];
    }
}

/* The colours of a group whose fragments are known, by the stages of the general path. */
static FGL_NOINLINE void staged_color(const struct fragment_plan *plan, const struct planes *p, int y, int x, const int32_t *live,
                                      uint32_t *FGL_RESTRICT color)
{
    struct fragments f;
    place_fragments(&f, y, x);
    FOR_GROUP(i) f.live[i] = live[i];
    find_colors(&f, plan, p);
    FOR_GROUP(i) {
        const uint32_t c = pack_unorm8(f.color[0][i], f.color[1][i], f.color[2][i], f.color[3][i]);
        color[i] = f.live[i] ? c : color[i];
    }
}

static FGL_ALWAYS_INLINE void fused_fill_if(const bool plain, const struct fragment_plan *plan, const struct planes *planes,
                                            const struct runs *runs, const enum depth_kind kind, const int source)
{
    const struct framebuffer *fb = plan->fb;
    const ptrdiff_t stride = fb->stride;
    const real *flat = PLANES(planes)->a00 + LANE_COLOR;
    const float *constant = plan->constant_color;
    struct fused_row row = {.depth_max = (real)fb->depth_max};
    if (source == COLOR_IMAGE)
        row.image = plan->pixels->unorm8;
    else if (source == COLOR_FLAT)
        row.flat_color = pack_unorm8(flat[0], flat[1], flat[2], flat[3]);
    else if (source == COLOR_CONSTANT)
        row.flat_color = pack_unorm8((real)constant[0], (real)constant[1], (real)constant[2], (real)constant[3]);

    for (int i = 0; i < runs->n; i++) {
        if (runs->x0[i] >= runs->x1[i])
            continue;
        row.y = (real)(runs->y + i);
        row.x0 = runs->x0[i];
        row.x1 = runs->x1[i];
        row.depth = kind != DEPTH_OFF ? (int32_t *)fb->depth + (runs->y + i) * stride : NULL;
        row.color = (uint32_t *)fb->color + (runs->y + i) * stride;
        const int n = source == COLOR_STAGED ? FRAGMENT_GROUP : FUSED_GROUP;
        for (int x = row.x0 & -n; x < row.x1; x += n) {
            _Alignas(64) int32_t live[FRAGMENT_GROUP];
            if (!fused_depth(planes, &row, x, live, kind, n, plain))
                continue;
            if (source == COLOR_STAGED)
                staged_color(plan, planes, runs->y + i, x, live, row.color + x);
            else
                fused_color(planes, &row, x, live, source, plain);
        }
    }
}

/* Whether all planes are plain that are evaluated here. */
static FGL_ALWAYS_INLINE bool are_plain(const struct planes *planes, const enum depth_kind kind, const int source)
{
    bool plain = kind == DEPTH_OFF || is_plain(plane_of(planes, LANE_Z));
    for (int lane = LANE_OOW; lane < LANE_COLOR + 4 && source == COLOR_SMOOTH; lane++)
        plain &= is_plain(plane_of(planes, lane));
    return plain;
}

static FGL_ALWAYS_INLINE void fused_fill(const struct fragment_plan *plan, const struct planes *planes,
                                         const struct runs *runs, const enum depth_kind kind, const int source)
{
    if (are_plain(planes, kind, source))
        fused_fill_if(true, plan, planes, runs, kind, source);
    else
        fused_fill_if(false, plan, planes, runs, kind, source);
}

#define FUSED(name, kind, source)                                                                            \
    static void name(const struct fragment_plan *plan, const struct planes *planes, const struct runs *runs) \
    {                                                                                                        \
        fused_fill(plan, planes, runs, kind, source);                                                        \
    }
FUSED(fill_constant, DEPTH_OFF, COLOR_CONSTANT)
FUSED(fill_flat, DEPTH_OFF, COLOR_FLAT)
FUSED(fill_smooth, DEPTH_OFF, COLOR_SMOOTH)
FUSED(fill_image, DEPTH_OFF, COLOR_IMAGE)
FUSED(fill_constant_less, DEPTH_LESS, COLOR_CONSTANT)
FUSED(fill_flat_less, DEPTH_LESS, COLOR_FLAT)
FUSED(fill_smooth_less, DEPTH_LESS, COLOR_SMOOTH)
FUSED(fill_image_less, DEPTH_LESS, COLOR_IMAGE)
FUSED(fill_constant_lequal, DEPTH_LEQUAL, COLOR_CONSTANT)
FUSED(fill_flat_lequal, DEPTH_LEQUAL, COLOR_FLAT)
FUSED(fill_smooth_lequal, DEPTH_LEQUAL, COLOR_SMOOTH)
FUSED(fill_image_lequal, DEPTH_LEQUAL, COLOR_IMAGE)
FUSED(fill_staged, DEPTH_OFF, COLOR_STAGED)
FUSED(fill_staged_less, DEPTH_LESS, COLOR_STAGED)
FUSED(fill_staged_lequal, DEPTH_LEQUAL, COLOR_STAGED)
#undef FUSED

#endif
