/* Lights, light model, shade model (GL 1.5, 2.14.1 "Lighting", 2.14.2 "Lighting Parameter
 * Specification", 2.14.7 "Flatshading"). */
#include "api/command.h"
#include "api/params.h"
#include "api/set.h"
#include "fixedgl.h"
#include "state/matrix_exact.h"

#include <string.h>

/* Object space to eye space: positions by the modelview matrix, directions by its upper left 3x3; floats,
 * left to right. */
static void transform_position(float out[4], const float m[16], const float v[4])
{
    for (int r = 0; r < 4; r++)
        out[r] = v[0] * m[r] + v[1] * m[4 + r] + v[2] * m[8 + r] + v[3] * m[12 + r];
}

static void transform_direction(float out[3], const float m[16], const float v[3])
{
    for (int r = 0; r < 3; r++)
        out[r] = v[0] * m[r] + v[1] * m[4 + r] + v[2] * m[8 + r];
}

/* The eye coordinates in double, after those in float: where only they differ, nothing but FIXEDGL_EXACT sees it. */
static void set_exact(struct context *ctx, double field[4], const double v[4])
{
    if (ctx->accuracy == FIXEDGL_EXACT && memcmp(field, v, 4 * sizeof *v) != 0)
        fgl_flush_vertices(ctx, DIRTY_LIGHT);
    memcpy(field, v, 4 * sizeof *v);
}

void fgl_exec_Lightfv(struct context *ctx, GLenum light, GLenum pname, const GLfloat *params)
{
    const unsigned i = light - GL_LIGHT0;
    const struct param *p = fgl_light_param(pname);
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_LIGHTS || !p, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_param_allows(p, params), GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, pname == GL_SPOT_CUTOFF && params[0] > 90.0f && params[0] != 180.0f,
                    GL_INVALID_VALUE);

    const float *m = fgl_matrix_top(&ctx->modelview)->m;
    struct light *l = &ctx->s.lighting.light[i];
    float eye[4];
    double exact[4];
    double modelview[16];
    fgl_exact_load(modelview, m);
    fgl_exact_transform(exact, ctx->accuracy == FIXEDGL_EXACT ? fgl_matrix_top(&ctx->modelview)->exact : modelview, params,
                        pname == GL_POSITION ? 4 : pname == GL_SPOT_DIRECTION ? 3 : 0);
    if (pname == GL_POSITION) {
        transform_position(eye, m, params);
        params = eye;
    } else if (pname == GL_SPOT_DIRECTION) {
        (void)fgl_matrix_class(fgl_matrix_top(&ctx->modelview)); /* OSMesa rule: a use, which classifies the matrix */
        transform_direction(eye, m, params);
        params = eye;
    }
    if (pname == GL_POSITION)
        l->placed_under_identity = fgl_matrix_is_identity(fgl_matrix_top(&ctx->modelview));
    fgl_param_set(ctx, DIRTY_LIGHT, p, l, params);
    if (params == eye)
        set_exact(ctx, pname == GL_POSITION ? l->exact_position : l->exact_spot_direction, exact);
}

void GLAPIENTRY glLightiv(GLenum light, GLenum pname, const GLint *params)
{
    float v[4];

    fgl_param_from_ints(fgl_light_param(pname), params, v);
    glLightfv(light, pname, v);
}

/* The scalar forms take single-valued parameters only: any other pname is none of theirs. */
static GLenum scalar_light(GLenum pname)
{
    return fgl_count_light(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glLightf(GLenum light, GLenum pname, GLfloat param)
{
    glLightfv(light, scalar_light(pname), &param);
}
void GLAPIENTRY glLighti(GLenum light, GLenum pname, GLint param)
{
    glLightiv(light, scalar_light(pname), &param);
}

void fgl_exec_GetLightfv(struct context *ctx, GLenum light, GLenum pname, GLfloat *params)
{
    const unsigned i = light - GL_LIGHT0;
    const struct param *p = fgl_light_param(pname);
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_LIGHTS || !p, GL_INVALID_ENUM);

    memcpy(params, (const char *)&ctx->s.lighting.light[i] + p->offset, (size_t)p->count * sizeof *params);
}

void fgl_exec_GetLightiv(struct context *ctx, GLenum light, GLenum pname, GLint *params)
{
    const struct param *p = fgl_light_param(pname);
    RETURN_ERROR_IF(ctx, light - GL_LIGHT0 >= FGL_MAX_LIGHTS || !p, GL_INVALID_ENUM);

    float v[4];
    fgl_exec_GetLightfv(ctx, light, pname, v);
    fgl_param_to_ints(p, v, params);
}

void fgl_exec_LightModelfv(struct context *ctx, GLenum pname, const GLfloat *params)
{
    const struct param *p = fgl_light_model_param(pname);
    RETURN_ERROR_IF(ctx, !p, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx,
                    pname == GL_LIGHT_MODEL_COLOR_CONTROL && params[0] != (float)GL_SINGLE_COLOR &&
                            params[0] != (float)GL_SEPARATE_SPECULAR_COLOR,
                    GL_INVALID_ENUM);

    fgl_param_set(ctx, DIRTY_LIGHT, p, &ctx->s.lighting, params);
}

void GLAPIENTRY glLightModeliv(GLenum pname, const GLint *params)
{
    float v[4];

    fgl_param_from_ints(fgl_light_model_param(pname), params, v);
    glLightModelfv(pname, v);
}

static GLenum scalar_light_model(GLenum pname)
{
    return fgl_count_light_model(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glLightModelf(GLenum pname, GLfloat param)
{
    glLightModelfv(scalar_light_model(pname), &param);
}
void GLAPIENTRY glLightModeli(GLenum pname, GLint param)
{
    glLightModeliv(scalar_light_model(pname), &param);
}

void fgl_exec_ShadeModel(struct context *ctx, GLenum mode)
{
    RETURN_ERROR_IF(ctx, mode != GL_FLAT && mode != GL_SMOOTH && mode != GL_PHONG_WIN, GL_INVALID_ENUM);
    SET(ctx, DIRTY_LIGHT, ctx->s.lighting.shade_model, mode);
}
