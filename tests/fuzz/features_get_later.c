/* Features: state of OpenGL 1.2 to 1.5 asked for. */
#include "generator.h"
#include "textures.h"

static void get_value(struct generator *g)
{
    static const double names[] = {
            GL_ACTIVE_TEXTURE, GL_CLIENT_ACTIVE_TEXTURE, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA,
            GL_BLEND_EQUATION, GL_SAMPLES, GL_SAMPLE_BUFFERS, GL_SAMPLE_COVERAGE_INVERT, GL_FOG_COORD_SRC, GL_ARRAY_BUFFER_BINDING,
            GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING, GL_PIXEL_PACK_BUFFER_BINDING, GL_PIXEL_UNPACK_BUFFER_BINDING,
            GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP, GL_LIGHT_MODEL_COLOR_CONTROL};
    static const double reals[] = {GL_BLEND_COLOR, GL_SAMPLE_COVERAGE_VALUE, GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE,
                                   GL_POINT_DISTANCE_ATTENUATION, GL_TRANSPOSE_MODELVIEW_MATRIX};
    if (chance(g, 60))
        EMIT(g, GetIntegerv, one_of(g, (int)(sizeof names / sizeof *names), names));
    else
        EMIT(g, GetFloatv, one_of(g, (int)(sizeof reals / sizeof *reals), reals));
}

static void get_of_texture(struct generator *g)
{
    const double target = texture_targets[random_target(g)];
    switch (below(g, 4)) {
    case 0:
        EMIT(g, GetTexParameteriv, target, ONE_OF(g, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER,
                                                  GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC,
                                                  GL_DEPTH_TEXTURE_MODE, GL_GENERATE_MIPMAP));
        break;
    case 1: EMIT(g, GetTexParameterfv, target, ONE_OF(g, GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_LOD_BIAS, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD)); break;
    case 2:
        EMIT(g, GetTexEnviv, GL_TEXTURE_ENV, ONE_OF(g, GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SOURCE0_RGB, GL_SOURCE2_ALPHA,
                                                    GL_OPERAND1_RGB, GL_OPERAND2_ALPHA, GL_RGB_SCALE));
        break;
    default: EMIT(g, GetTexGenfv, GL_S + below(g, 4), ONE_OF(g, GL_OBJECT_PLANE, GL_EYE_PLANE, GL_TEXTURE_GEN_MODE));
    }
}

void feature_get_later(struct generator *g)
{
    if (g->compiling)
        return;
    switch (below(g, 3)) {
    case 0: get_value(g); break;
    case 1:
        EMIT(g, IsEnabled, ONE_OF(g, GL_BLEND, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_COLOR_SUM, GL_RESCALE_NORMAL, GL_MULTISAMPLE,
                                  GL_SAMPLE_COVERAGE, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_TEXTURE_GEN_S));
        break;
    default: get_of_texture(g);
    }
}
