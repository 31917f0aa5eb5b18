/* The general path's first half: from planes to a colour (GL 1.5, 3.5.1 "Basic Polygon Rasterization", 3.9
 * "Color Sum", 3.10 "Fog"). */
#ifndef FGL_FRAGMENT_INTERPOLATE_H
#define FGL_FRAGMENT_INTERPOLATE_H

#include "fragment/group.h"

/* One group of fragments. live: all bits or none. Colours are neither clamped nor rounded. Aligned, so that no vector lies in two
 * cache lines. */
struct fragments {
    _Alignas(64) real fx[FRAGMENT_GROUP], w[FRAGMENT_GROUP];
    real color[4][FRAGMENT_GROUP];
    real secondary[3][FRAGMENT_GROUP]; /* of COLOR_LIT */
    _Alignas(64) int32_t live[FRAGMENT_GROUP], depth[FRAGMENT_GROUP];
    int x, row; /* of pixel 0 */
    real fy;
};

#define FOR_GROUP(i) FGL_VECTOR_LOOP for (int i = 0; i < FRAGMENT_GROUP; i++)

static inline bool any_live(const struct fragments *f)
{
    int32_t any = 0;
    FOR_GROUP(i) any |= f->live[i];
    return any != 0;
}

/* Where the group is. */
static FGL_ALWAYS_INLINE void place_fragments(struct fragments *f, int row, int x)
{
    f->x = x;
    f->row = row;
    f->fy = (real)row;
    FOR_GROUP(i) f->fx[i] = (real)(x + i);
}

/* What interpolates with perspective. */
static FGL_ALWAYS_INLINE void find_w(struct fragments *f, const struct planes *p)
{
    plane_values(p, LANE_OOW, FRAGMENT_GROUP, f->fx, f->fy, f->w);
    FOR_GROUP(i) f->w[i] = 1 / f->w[i];
}

/* The pixels of the run, less those that a polygon stipple leaves out (GL 1.5, 3.5.2: window coordinates
 * modulo 32, row 0 lowest). */
static inline void start_fragments(struct fragments *f, const struct fragment_plan *plan,
                                   const struct planes *p, int row, int x, int x0, int x1)
{
    uint32_t stipple = 0xffffffff;
    if (p->stipple)
        stipple = p->stipple->row[fgl_row(plan->fb, row) & 31];
    place_fragments(f, row, x);
    FOR_GROUP(i)
        f->live[i] = -((x + i >= x0) & (x + i < x1) & (int32_t)(stipple >> (31 - ((x + i) & 31)) & 1));
}

static FGL_ALWAYS_INLINE void interpolate_channel(const struct fragments *f, const struct planes *p, int lane, real *FGL_RESTRICT to)
{
    plane_values(p, lane, FRAGMENT_GROUP, f->fx, f->fy, to);
    FOR_GROUP(i) to[i] *= f->w[i];
}

static FGL_ALWAYS_INLINE void take_channel(struct fragments *f, const float *from, real *FGL_RESTRICT to)
{
    FOR_GROUP(i) to[i] = (real)from[f->x + i];
}

/* Pixel rectangles. Bytes are written as they came, and but for the alpha test nothing reads them before
 * (fgl_pixels_take_unorm8). */
static FGL_ALWAYS_INLINE void take_color(struct fragments *f, const struct pixel_inputs *pixels)
{
    if (pixels->unorm8) {
        FOR_GROUP(i) f->color[3][i] = from_unorm8(pixels->unorm8[f->x + i] >> 24);
        return;
    }
    take_channel(f, pixels->color[0], f->color[0]);
    take_channel(f, pixels->color[1], f->color[1]);
    take_channel(f, pixels->color[2], f->color[2]);
    take_channel(f, pixels->color[3], f->color[3]);
}

static inline void interpolate_color(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    if (plan->color_source == COLOR_SMOOTH) {
        interpolate_channel(f, p, LANE_COLOR + 0, f->color[0]);
        interpolate_channel(f, p, LANE_COLOR + 1, f->color[1]);
        interpolate_channel(f, p, LANE_COLOR + 2, f->color[2]);
        interpolate_channel(f, p, LANE_COLOR + 3, f->color[3]);
    } else if (plan->color_source == COLOR_IMAGE) {
        take_color(f, plan->pixels);
    } else {
        for (int c = 0; c < 4; c++) {
            const real flat = plan->color_source == COLOR_FLAT ? PLANES(p)->a00[LANE_COLOR + c] : (real)plan->constant_color[c];
            FOR_GROUP(i) f->color[c][i] = flat;
        }
    }
}

/* GL 1.5, 3.9 "Color Sum": the sum is clamped, which shows where fog follows. OSMesa rule: it is not. */
static inline void add_secondary_color(struct fragments *f, const struct fragment_plan *plan,
                                       const struct planes *p)
{
    real smooth[FRAGMENT_GROUP];
    for (int c = 0; c < 3; c++) {
        const bool constant = plan->secondary_source == COLOR_CONSTANT;
        const real flat = constant ? (real)plan->constant_secondary[c] : PLANES(p)->a00[LANE_SECONDARY + c];
        if (plan->secondary_source == COLOR_LIT)
            FOR_GROUP(i) f->color[c][i] += f->secondary[c][i];
        else if (plan->secondary_source != COLOR_SMOOTH)
            FOR_GROUP(i) f->color[c][i] += flat;
        else {
            interpolate_channel(f, p, LANE_SECONDARY + c, smooth);
            FOR_GROUP(i) f->color[c][i] += smooth[i];
        }
        if (R_EXACT)
            FOR_GROUP(i) f->color[c][i] = r_saturate(f->color[c][i]);
    }
}

/* How much of itself each fragment keeps: f of GL 1.5, 3.10, in [0,1]. */
static inline void fog_factor(const struct fragments *f, const struct fragment_plan *plan, const struct planes *p,
                              real *FGL_RESTRICT factor)
{
    interpolate_channel(f, p, LANE_FOG, factor);
    const real k = FOG_NUMBERS(plan)->k, fog_p = FOG_NUMBERS(plan)->p, fog_q = FOG_NUMBERS(plan)->q;
    if (plan->fog_mode == GL_LINEAR)
        FOR_GROUP(i) factor[i] = factor[i] * fog_p + fog_q;
    else if (plan->fog_mode == GL_EXP)
        FOR_GROUP(i) factor[i] = r_exp2(-(factor[i] * k));
    else
        FOR_GROUP(i) factor[i] = r_exp2(-(factor[i] * k * (factor[i] * k)));
    FOR_GROUP(i) factor[i] = r_saturate(factor[i]);
}

/* One channel. A function of its own: GCC unrolls loops inside of another loop before it can make vectors of them. */
static FGL_NOINLINE void mix_fog(real *FGL_RESTRICT color, const real *FGL_RESTRICT factor, real fog)
{
    FOR_GROUP(i) color[i] = fog * (1 - factor[i]) + color[i] * factor[i];
}

static inline void apply_fog(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    real factor[FRAGMENT_GROUP];
    fog_factor(f, plan, p, factor);
    for (int c = 0; c < 3; c++)
        mix_fog(f->color[c], factor, (real)plan->fog_color[c]);
}

/* Antialiased lines and points: alpha times coverage (GL 1.5, 3.3.2, 3.4.3). OSMesa rules: a line's coverage
 * falls to 0 over the outermost pixel of its rectangle; a point is a disc without soft edge, and alpha is
 * raised towards its centre. */
static inline void apply_smoothing(struct fragments *f, const struct planes *p)
{
    real s[4][FRAGMENT_GROUP];
    interpolate_channel(f, p, LANE_SMOOTH + 0, s[0]);
    interpolate_channel(f, p, LANE_SMOOTH + 1, s[1]);
    interpolate_channel(f, p, LANE_SMOOTH + 2, s[2]);
    interpolate_channel(f, p, LANE_SMOOTH + 3, s[3]);
    if (p->smoothing == SMOOTH_LINE) {
        FOR_GROUP(i)
            f->color[3][i] *= r_saturate(s[1][i] - r_abs(s[0][i])) * r_saturate(s[3][i] - r_abs(s[2][i]));
    } else {
        FOR_GROUP(i) {
            const real d2 = s[0][i] * s[0][i] + s[1][i] * s[1][i], inner2 = s[2][i], one = s[3][i];
            f->live[i] &= -(d2 <= one);
            f->color[3][i] *= d2 < inner2 ? (one - d2) * (1 / (one - inner2)) : one;
        }
    }
}

#endif
