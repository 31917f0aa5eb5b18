/* Blending (GL 1.5, 4.1.8 "Blending") for one type of channel. Before each inclusion define CHANNEL, the type, T(name), which makes the
 * names below its own, and COMPLEMENT(a) = 1 - a; `max` is the value of 1.0. A group is computed with as an array of ELEMENTS numbers of
 * type ELEMENT, either the channel's own or the bytes packed in it, for which define MUL(a, b), ADD(a, b), SUB(a, b) and LERP(a, b, f),
 * which is f a + (1 - f) b. FACTOR_OUT: a factor that source and destination have in common multiplies their sum. Alpha is channel 3. */

#define FOR_ELEMENTS(i) FGL_VECTOR_LOOP for (int i = 0; i < ELEMENTS; i++)

/* Where the factors of channel c are, one for each fragment: an operand itself, or `f` with what is computed there. */
static inline const CHANNEL *T(factor)(GLenum factor, int c, const CHANNEL *const src[4], const CHANNEL *const dst[4],
                                       const CHANNEL constant[4], CHANNEL max, CHANNEL *FGL_RESTRICT f)
{
    /* clang-format off */
    switch (factor) {
    case GL_SRC_COLOR: return src[c];
    case GL_DST_COLOR: return dst[c];
    case GL_SRC_ALPHA: return src[3];
    case GL_DST_ALPHA: return dst[3];
    case GL_ZERO:                     FOR_GROUP(i) f[i] = 0; break;
    case GL_ONE_MINUS_SRC_COLOR:      FOR_GROUP(i) f[i] = COMPLEMENT(src[c][i]); break;
    case GL_ONE_MINUS_DST_COLOR:      FOR_GROUP(i) f[i] = COMPLEMENT(dst[c][i]); break;
    case GL_ONE_MINUS_SRC_ALPHA:      FOR_GROUP(i) f[i] = COMPLEMENT(src[3][i]); break;
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
    return f;
}

/* One channel of the blend equation. A function of its own: GCC unrolls loops inside of another loop before it can make vectors of
 * them. */
static FGL_NOINLINE void T(blend_channel)(const struct color_buffer_state *s, bool lerp, int c, const CHANNEL *const src[4],
                                          const CHANNEL *const dst[4], const CHANNEL constant[4], CHANNEL max,
                                          CHANNEL *FGL_RESTRICT result)
{
    _Alignas(64) CHANNEL src_factors[FRAGMENT_GROUP], dst_factors[FRAGMENT_GROUP];
    const ELEMENT *a = (const ELEMENT *)src[c], *b = (const ELEMENT *)dst[c];
    ELEMENT *FGL_RESTRICT out = (ELEMENT *)result;
    const GLenum equation = s->blend_equation[c == 3];
    if (equation == GL_MIN) { /* factors do not apply */
        FOR_ELEMENTS(i) out[i] = a[i] < b[i] ? a[i] : b[i];
        return;
    }
    if (equation == GL_MAX) {
        FOR_ELEMENTS(i) out[i] = a[i] > b[i] ? a[i] : b[i];
        return;
    }
    const GLenum src_factor = c == 3 ? s->blend_src_alpha : s->blend_src_rgb,
                 dst_factor = c == 3 ? s->blend_dst_alpha : s->blend_dst_rgb;
    if (src_factor == GL_ZERO && dst_factor == GL_ZERO) {
        FOR_ELEMENTS(i) out[i] = 0;
        return;
    }
    const ELEMENT *fa = (const ELEMENT *)T(factor)(src_factor, c, src, dst, constant, max, src_factors),
                  *fb = (const ELEMENT *)T(factor)(dst_factor, c, src, dst, constant, max, dst_factors);
#if FACTOR_OUT
    if (s->blend_src_rgb == s->blend_dst_rgb && s->blend_src_alpha == s->blend_dst_alpha) {
        FOR_ELEMENTS(i) out[i] = MUL(equation == GL_FUNC_ADD        ? ADD(a[i], b[i])
                                     : equation == GL_FUNC_SUBTRACT ? SUB(a[i], b[i])
                                                                    : SUB(b[i], a[i]), fa[i]);
        return;
    }
#endif
    if (lerp)
        FOR_ELEMENTS(i) out[i] = (ELEMENT)LERP(a[i], b[i], fa[i]);
    else if (src_factor == GL_ZERO && equation != GL_FUNC_SUBTRACT) /* OSMesa rule: ZERO's product is left out, so -0 stays -0 */
        FOR_ELEMENTS(i) out[i] = (ELEMENT)MUL(b[i], fb[i]);
    else if (dst_factor == GL_ZERO && equation != GL_FUNC_REVERSE_SUBTRACT)
        FOR_ELEMENTS(i) out[i] = (ELEMENT)MUL(a[i], fa[i]);
#if FACTOR_OUT
    else if (dst_factor == GL_ZERO) /* or +0 */
        FOR_ELEMENTS(i) out[i] = 0 - MUL(a[i], fa[i]);
#endif
    else if (equation == GL_FUNC_ADD)
        FOR_ELEMENTS(i) out[i] = (ELEMENT)ADD(MUL(a[i], fa[i]), MUL(b[i], fb[i]));
    else if (equation == GL_FUNC_SUBTRACT)
        FOR_ELEMENTS(i) out[i] = (ELEMENT)SUB(MUL(a[i], fa[i]), MUL(b[i], fb[i]));
    else
        FOR_ELEMENTS(i) out[i] = (ELEMENT)SUB(MUL(b[i], fb[i]), MUL(a[i], fa[i]));
}

#undef CHANNEL
#undef ELEMENT
#undef ELEMENTS
#undef FACTOR_OUT
#undef T
#undef MUL
#undef LERP
#undef COMPLEMENT
#undef ADD
#undef SUB
#undef FOR_ELEMENTS
