/* Features: tests, blending, masks, fog, clears. */
#include "generator.h"

static double compare_function(struct generator *g)
{
    return ONE_OF(g, GL_LESS, GL_LEQUAL, GL_LEQUAL, GL_GREATER, GL_GEQUAL, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_ALWAYS, GL_NEVER);
}

void feature_depth_test(struct generator *g)
{
    toggle(g, GL_DEPTH_TEST, 85);
    if (chance(g, 50))
        EMIT(g, DepthFunc, compare_function(g));
    if (chance(g, 15))
        EMIT(g, DepthMask, below(g, 2));
}

void feature_scissor(struct generator *g)
{
    const int width = g->script->width, height = g->script->height;
    toggle(g, GL_SCISSOR_TEST, 75);
    EMIT(g, Scissor, integer(g, -5, width / 2), integer(g, -5, height / 2), integer(g, 0, width + 5), integer(g, 0, height + 5));
}

void feature_alpha_test(struct generator *g)
{
    toggle(g, GL_ALPHA_TEST, 75);
    EMIT(g, AlphaFunc, compare_function(g), chance(g, 90) ? real(g, 0.0, 1.0) : real(g, -1.0, 2.0));
}

static double stencil_op(struct generator *g)
{
    return ONE_OF(g, GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP);
}

void feature_stencil(struct generator *g)
{
    toggle(g, GL_STENCIL_TEST, 80);
    EMIT(g, StencilFunc, compare_function(g), chance(g, 90) ? below(g, 256) : integer(g, -5, 300),
         chance(g, 60) ? 255 : below(g, 256));
    EMIT(g, StencilOp, stencil_op(g), stencil_op(g), stencil_op(g));
    if (chance(g, 30))
        EMIT(g, StencilMask, below(g, 256));
}

static double blend_factor(struct generator *g, bool source)
{
    const int n = below(g, source ? 10 : 8);
    static const double shared[] = {GL_ZERO, GL_ONE, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};
    static const double of_source[] = {GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA_SATURATE, GL_SRC_ALPHA};
    static const double of_destination[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR};
    return n < 6 ? shared[n] : source ? of_source[n - 6] : of_destination[n - 6];
}

void feature_blend(struct generator *g)
{
    toggle(g, GL_BLEND, 85);
    EMIT(g, BlendFunc, blend_factor(g, true), blend_factor(g, false));
}

void feature_blend_equation(struct generator *g)
{
    double c[4];
    random_color(g, c);
    toggle(g, GL_BLEND, 85);
    EMIT(g, BlendEquation, ONE_OF(g, GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX));
    EMIT(g, BlendColor, c[0], c[1], c[2], c[3]);
    EMIT(g, BlendFunc, ONE_OF(g, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_COLOR, GL_ONE),
         ONE_OF(g, GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_COLOR, GL_DST_COLOR, GL_ONE));
}

void feature_logic_op(struct generator *g)
{
    toggle(g, GL_COLOR_LOGIC_OP, 75);
    EMIT(g, LogicOp, GL_CLEAR + below(g, 16));
}

void feature_color_mask(struct generator *g)
{
    if (chance(g, 30))
        EMIT(g, ColorMask, 1, 1, 1, 1);
    else
        EMIT(g, ColorMask, chance(g, 70), chance(g, 70), chance(g, 70), chance(g, 70));
}

void feature_fog(struct generator *g)
{
    double c[4];
    const double far_out = g->space == EYE_SPACE ? 10.0 : 1.0;
    random_color(g, c);
    toggle(g, GL_FOG, 80);
    EMIT(g, Fogi, GL_FOG_MODE, ONE_OF(g, GL_LINEAR, GL_EXP, GL_EXP2));
    EMIT(g, Fogfv, GL_FOG_COLOR, c[0], c[1], c[2], c[3]);
    if (chance(g, 60))
        EMIT(g, Fogf, GL_FOG_DENSITY, real(g, 0.0, 3.0 / far_out));
    if (chance(g, 60)) {
        EMIT(g, Fogf, GL_FOG_START, real(g, -0.2 * far_out, 0.4 * far_out));
        EMIT(g, Fogf, GL_FOG_END, real(g, 0.5 * far_out, far_out));
    }
}

void feature_dither(struct generator *g)
{
    toggle(g, GL_DITHER, 50);
}

void feature_draw_buffer(struct generator *g)
{
    EMIT(g, DrawBuffer, ONE_OF(g, GL_FRONT, GL_FRONT, GL_NONE));
}

void feature_clear(struct generator *g)
{
    double c[4];
    random_color(g, c);
    if (chance(g, 60))
        EMIT(g, ClearColor, c[0], c[1], c[2], c[3]);
    if (chance(g, 30))
        EMIT(g, ClearDepth, real(g, -0.1, 1.1));
    if (chance(g, 30))
        EMIT(g, ClearStencil, integer(g, -3, 300));
    EMIT(g, Clear, ONE_OF(g, GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                          GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, 0));
}

void feature_flush(struct generator *g)
{
    if (chance(g, 50))
        EMIT0(g, Flush);
    else
        EMIT0(g, Finish);
}
