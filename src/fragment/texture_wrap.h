/* From texture coordinates to texels' indices along one axis (GL 1.5, 3.8.7 "Texture Wrap Modes", 3.8.8, 3.8.9). Kernels only.
 *
 * n is the size of the image along the axis, and scale takes coordinates to texels: n where an image is [0,1], 1 for rectangles. Index -1 or
 * n: the border. */
#ifndef FGL_FRAGMENT_TEXTURE_WRAP_H
#define FGL_FRAGMENT_TEXTURE_WRAP_H

#include "fragment/interpolate.h"

/* The two texels around a coordinate, and how far it is from the first to the second. */
struct texel_pair {
    int32_t i0[FRAGMENT_GROUP], i1[FRAGMENT_GROUP];
    real f[FRAGMENT_GROUP];         /* [0,1) */
    int32_t weight[FRAGMENT_GROUP]; /* OSMesa's fixed point: 0 to 255 */
};

/* To an integer towards zero. What is too large is the greatest or the least integer; OSMesa rule: what is too large, or not a
 * number, is the least. */
static FGL_ALWAYS_INLINE int32_t to_int(real v)
{
    const real limit = (real)2147483648.0;
    if (R_EXACT)
        return (int32_t)r_min(r_max(v, -limit), limit - 1);
    return (int32_t)r_select((v > -limit) & (v < limit), v, -limit); /* on bits: vectorises */
}

static FGL_ALWAYS_INLINE real round_even_of(real v)
{
    return R_EXACT ? (real)rint((double)v) : (real)rintf((float)v);
}

/* Whether GL_REPEAT may mask the integer part. It is exact only up to 2^31 texels. */
static FGL_ALWAYS_INLINE bool may_mask(int n)
{
    return !R_EXACT && (n & (n - 1)) == 0;
}

/* The part behind the point, less than 1 always. */
static FGL_ALWAYS_INLINE real fraction_of(real v)
{
    const real f = v - r_floor(v), below_one = R_EXACT ? (real)0.99999999999999989 : (real)0.99999994f;
    return r_min(f, below_one);
}

/* The distance from 0 in a row of images, every second of which is mirrored: [0,1]. */
static FGL_ALWAYS_INLINE real mirror(real s)
{
    const real half = s * (real)0.5;
    return r_abs((half - round_even_of(half)) * 2);
}

static FGL_ALWAYS_INLINE void wrap_nearest(const real *FGL_RESTRICT s, const int n, const real scale, const GLenum wrap,
                                           int32_t *FGL_RESTRICT index)
{
    switch (wrap) {
    case GL_REPEAT:
        if (may_mask(n))
            FOR_GROUP(i) index[i] = to_int(r_floor(s[i] * scale)) & (n - 1);
        else
            FOR_GROUP(i) index[i] = to_int(fraction_of(s[i]) * scale);
        break;
    case GL_MIRRORED_REPEAT:
        FOR_GROUP(i) index[i] = fgl_min(to_int(mirror(s[i]) * scale), n - 1);
        break;
    case GL_CLAMP_TO_BORDER:
        FOR_GROUP(i) index[i] = fgl_clamp(to_int(r_floor(s[i] * scale)), -1, n);
        break;
    default: /* GL_CLAMP, GL_CLAMP_TO_EDGE */
        FOR_GROUP(i) index[i] = fgl_clamp(to_int(r_floor(s[i] * scale)), 0, n - 1);
        break;
    }
}

/* Index and fraction of u, which counts texels from the centre of the first. */
static FGL_ALWAYS_INLINE void split(struct texel_pair *to, int i, real u)
{
    const real below = r_floor(u);
    to->i0[i] = to_int(below);
    to->f[i] = u - below;
}

/* GL_REPEAT and GL_CLAMP_TO_EDGE in OSMesa's fixed point of 8 bits. */
static FGL_ALWAYS_INLINE void wrap_linear_fixed(const real *FGL_RESTRICT s, const int n, const real scale, const GLenum wrap,
                                                struct texel_pair *FGL_RESTRICT to)
{
    const real fixed = scale * 256;
    const bool repeat = wrap == GL_REPEAT, masked = may_mask(n);
    FOR_GROUP(i) {
        const real folded = repeat && !masked ? fraction_of(s[i]) : s[i];
        const int32_t u = (int32_t)((uint32_t)to_int(round_even_of(folded * fixed)) - 128u), at = u >> 8;
        to->weight[i] = u & 255;
        if (repeat && masked) {
            to->i0[i] = at & (n - 1);
            to->i1[i] = (at + 1) & (n - 1);
        } else if (repeat) {
            to->i0[i] = at < 0 ? n - 1 : at;
            to->i1[i] = at + 1 < n ? at + 1 : 0;
        } else {
            to->i0[i] = fgl_clamp(at, 0, n - 1);
            to->i1[i] = fgl_clamp(at + 1, 0, n - 1);
        }
    }
}

static FGL_ALWAYS_INLINE void wrap_linear(const real *FGL_RESTRICT s, const int n, const real scale, const GLenum wrap,
                                          struct texel_pair *FGL_RESTRICT to)
{
    const real size = (real)n, half = (real)0.5;
    switch (wrap) {
    case GL_REPEAT:
        if (may_mask(n)) {
            FOR_GROUP(i) split(to, i, s[i] * scale - half);
            FOR_GROUP(i) to->i1[i] = (to->i0[i] + 1) & (n - 1);
            FOR_GROUP(i) to->i0[i] &= n - 1;
        } else {
            FOR_GROUP(i) split(to, i, fraction_of(s[i]) * scale - half);
            FOR_GROUP(i) to->i0[i] = to->i0[i] < 0 ? n - 1 : to->i0[i];
            FOR_GROUP(i) to->i1[i] = to->i0[i] + 1 < n ? to->i0[i] + 1 : 0;
        }
        break;
    case GL_MIRRORED_REPEAT:
        FOR_GROUP(i) split(to, i, mirror(s[i]) * scale - half);
        FOR_GROUP(i) to->i1[i] = fgl_min(to->i0[i] + 1, n - 1);
        FOR_GROUP(i) to->i0[i] = fgl_max(to->i0[i], 0);
        break;
    case GL_CLAMP_TO_EDGE:
        FOR_GROUP(i) split(to, i, r_max(r_min(s[i] * scale, size) - half, 0));
        FOR_GROUP(i) to->i1[i] = fgl_min(to->i0[i] + 1, n - 1);
        break;
    case GL_CLAMP:
        FOR_GROUP(i) split(to, i, r_max(r_min(s[i] * scale, size), 0) - half);
        FOR_GROUP(i) to->i1[i] = to->i0[i] + 1;
        break;
    default: /* GL_CLAMP_TO_BORDER */
        FOR_GROUP(i) split(to, i, r_max(r_min(s[i] * scale - half, size), -1));
        FOR_GROUP(i) to->i1[i] = fgl_min(to->i0[i] + 1, n);
        break;
    }
}

#endif
