/* Blending (GL 1.5, 4.1.8 "Blending") for one type of channel. Before each inclusion define CHANNEL, the
 * type, T(name), which makes the names below its own, and, for values a and b, MUL(a, b), COMPLEMENT(a) = 1 -
 * a, ADD(a, b) and SUB(a, b); `max` is the value of 1.0. FACTOR_OUT: a factor that source and destination
 * have in common multiplies their sum. Alpha is channel 3. */

/* The factor of channel c, for each fragment. */
static inline void T(factor)(GLenum factor, int c, const CHANNEL src[4][FRAGMENT_GROUP],
                             const CHANNEL dst[4][FRAGMENT_GROUP], const CHANNEL constant[4], CHANNEL max,
                             CHANNEL *FGL_RESTRICT f)
{
    /* clang-format off */
    switch (factor) {
    case GL_ZERO:                     FOR_GROUP(i) f[i] = 0; break;
    case GL_SRC_COLOR:                FOR_GROUP(i) f[i] = src[c][i]; break;
    case GL_ONE_MINUS_SRC_COLOR:      FOR_GROUP(i) f[i] = COMPLEMENT(src[c][i]); break;
    case GL_DST_COLOR:                FOR_GROUP(i) f[i] = dst[c][i]; break;
    case GL_ONE_MINUS_DST_COLOR:      FOR_GROUP(i) f[i] = COMPLEMENT(dst[c][i]); break;
    case GL_SRC_ALPHA:                FOR_GROUP(i) f[i] = src[3][i]; break;
    case GL_ONE_MINUS_SRC_ALPHA:      FOR_GROUP(i) f[i] = COMPLEMENT(src[3][i]); break;
    case GL_DST_ALPHA:                FOR_GROUP(i) f[i] = dst[3][i]; break;
    case GL_ONE_MINUS_DST_ALPHA:      FOR_GROUP(i) f[i] = COMPLEMENT(dst[3][i]); break;
    case GL_CONSTANT_COLOR:           FOR_GROUP(i) f[i] = constant[c]; break;
    case GL_ONE_MINUS_CONSTANT_COLOR: FOR_GROUP(i) f[i] = COMPLEMENT(constant[c]); break;
    case GL_CONSTANT_ALPHA:           FOR_GROUP(i) f[i] = constant[3]; break;
    case GL_ONE_MINUS_CONSTANT_ALPHA: FOR_GROUP(i) f[i] = COMPLEMENT(constant[3]); break;
    case GL_SRC_ALPHA_SATURATE:
        FOR_GROUP(i) {
            const CHANNEL room = COMPLEMENT(dst[3][i]);
            f[i] = c == 3 ? max : src[3][i] < room ? src[3][i] : room;
        }
        break;
    default: FOR_GROUP(i) f[i] = max; break; /* GL_ONE */
    }
    /* clang-format on */
}

/* One channel of the blend equation. A function of its own: GCC unrolls loops inside of another loop before it can make vectors of
 * them. */
static FGL_NOINLINE void T(blend_channel)(const struct color_buffer_state *s, int c,
                                    const CHANNEL src[4][FRAGMENT_GROUP],
                                    const CHANNEL dst[4][FRAGMENT_GROUP], const CHANNEL constant[4],
                                    CHANNEL max, CHANNEL *FGL_RESTRICT out)
{
    CHANNEL sf[FRAGMENT_GROUP], df[FRAGMENT_GROUP];
    const GLenum equation = s->blend_equation[c == 3];
    if (equation == GL_MIN) { /* factors do not apply */
        FOR_GROUP(i) out[i] = src[c][i] < dst[c][i] ? src[c][i] : dst[c][i];
        return;
    }
    if (equation == GL_MAX) {
        FOR_GROUP(i) out[i] = src[c][i] > dst[c][i] ? src[c][i] : dst[c][i];
        return;
    }
    const GLenum src_factor = c == 3 ? s->blend_src_alpha : s->blend_src_rgb,
                 dst_factor = c == 3 ? s->blend_dst_alpha : s->blend_dst_rgb;
    const bool common =
            FACTOR_OUT && s->blend_src_rgb == s->blend_dst_rgb && s->blend_src_alpha == s->blend_dst_alpha;
    T(factor)(src_factor, c, src, dst, constant, max, sf);
    T(factor)(dst_factor, c, src, dst, constant, max, df);
    CHANNEL a[FRAGMENT_GROUP], b[FRAGMENT_GROUP];
    FOR_GROUP(i) a[i] = common ? src[c][i] : MUL(src[c][i], sf[i]);
    FOR_GROUP(i) b[i] = common ? dst[c][i] : MUL(dst[c][i], df[i]);
    if (equation == GL_FUNC_ADD)
        FOR_GROUP(i) out[i] = ADD(a[i], b[i]);
    else if (equation == GL_FUNC_SUBTRACT)
        FOR_GROUP(i) out[i] = SUB(a[i], b[i]);
    else
        FOR_GROUP(i) out[i] = SUB(b[i], a[i]);
    if (common)
        FOR_GROUP(i) out[i] = MUL(out[i], sf[i]);
}

static inline void T(blend)(const struct color_buffer_state *s, CHANNEL src[4][FRAGMENT_GROUP],
                            const CHANNEL dst[4][FRAGMENT_GROUP], const CHANNEL constant[4], CHANNEL max)
{
    CHANNEL out[4][FRAGMENT_GROUP];
    for (int c = 0; c < 4; c++)
        T(blend_channel)(s, c, src, dst, constant, max, out[c]);
    memcpy(src, out, sizeof out);
}

#undef CHANNEL
#undef FACTOR_OUT
#undef T
#undef MUL
#undef COMPLEMENT
#undef ADD
#undef SUB
