/* Features: occlusion queries, multisampling, equations and factors of colors and alpha apart. */
#include "generator.h"

enum { QUERIES = 3 };

void feature_occlusion_query(struct generator *g)
{
    if (g->compiling || g->querying)
        return;
    const double id = 1 + below(g, QUERIES);
    EMIT(g, BeginQuery, GL_SAMPLES_PASSED, id);
    g->querying = true;
    for (int n = integer(g, 1, 3); n > 0; n--) {
        if (chance(g, 30))
            random_state(g);
        random_draw(g);
    }
    g->querying = false;
    if (chance(g, 20))
        EMIT(g, GetQueryiv, GL_SAMPLES_PASSED, GL_CURRENT_QUERY);
    EMIT(g, EndQuery, GL_SAMPLES_PASSED);
    EMIT(g, GetQueryObjectuiv, id, GL_QUERY_RESULT);
    if (chance(g, 20))
        EMIT(g, GetQueryObjectuiv, id, GL_QUERY_RESULT_AVAILABLE);
    if (chance(g, 10))
        EMIT(g, IsQuery, 1 + below(g, QUERIES + 1));
}

void feature_multisample(struct generator *g)
{
    static const unsigned caps[] = {GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE};
    for (int i = 0; i < 4; i++) {
        if (chance(g, 50))
            toggle(g, caps[i], 60);
    }
    if (chance(g, 60))
        EMIT(g, SampleCoverage, real(g, -0.2, 1.2), below(g, 2));
}

static double random_factor(struct generator *g, bool source)
{
    const double f = ONE_OF(g, GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA,
                            GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                            GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_ALPHA_SATURATE);
    return f == GL_SRC_ALPHA_SATURATE && !source ? GL_SRC_ALPHA : f;
}

void feature_blend_separate(struct generator *g)
{
    double c[4];
    random_color(g, c);
    toggle(g, GL_BLEND, 85);
    EMIT(g, BlendColor, c[0], c[1], c[2], c[3]);
    EMIT(g, BlendFuncSeparate, random_factor(g, true), random_factor(g, false), random_factor(g, true), random_factor(g, false));
    if (chance(g, 60))
        EMIT(g, BlendEquationSeparateEXT, ONE_OF(g, GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX),
             ONE_OF(g, GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX));
}
