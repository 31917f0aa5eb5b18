/* glTexEnv, glGetTexEnv (GL 1.5, 3.8.13 "Texture Environments and Texture Functions"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/params.h"
#include "api/set.h"

#include <string.h>

/* Whether the parameter belongs to the target: each of the two others has one of its own. */
static bool target_has(GLenum target, GLenum pname)
{
    switch (pname) {
    case GL_TEXTURE_LOD_BIAS: return target == GL_TEXTURE_FILTER_CONTROL;
    case GL_COORD_REPLACE_ARB: return target == GL_POINT_SPRITE_ARB;
    default: return target == GL_TEXTURE_ENV;
    }
}

static bool is_mode(GLenum v)
{
    return v == GL_MODULATE || v == GL_DECAL || v == GL_BLEND || v == GL_REPLACE || v == GL_ADD || v == GL_COMBINE;
}

/* Tables 3.23, 3.24; dot products are for colours only. */
static bool is_combine(GLenum v, bool alpha)
{
    switch (v) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT: return true;
    case GL_DOT3_RGB:
    case GL_DOT3_RGBA:
    case GL_DOT3_RGB_EXT:
    case GL_DOT3_RGBA_EXT: return !alpha;
    default: return false;
    }
}

/* Table 3.25; a texture of any unit, by GL_ARB_texture_env_crossbar. */
static bool is_source(GLenum v)
{
    return v == GL_TEXTURE || v == GL_CONSTANT || v == GL_PRIMARY_COLOR || v == GL_PREVIOUS ||
           v - GL_TEXTURE0 < FGL_MAX_TEXTURE_UNITS;
}

static bool is_operand(GLenum v, bool alpha)
{
    return v == GL_SRC_ALPHA || v == GL_ONE_MINUS_SRC_ALPHA ||
           (!alpha && (v == GL_SRC_COLOR || v == GL_ONE_MINUS_SRC_COLOR));
}

static bool enum_allowed(GLenum pname, GLenum v)
{
    switch (pname) {
    case GL_TEXTURE_ENV_MODE: return is_mode(v);
    case GL_COMBINE_RGB: return is_combine(v, false);
    case GL_COMBINE_ALPHA: return is_combine(v, true);
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA: return is_source(v);
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB: return is_operand(v, false);
    default: return is_operand(v, true);
    }
}

/* What of the active unit the parameter's field belongs to. */
static void *active_env(struct context *ctx, GLenum pname)
{
    const int unit = ctx->s.texture.active_texture;
    return pname == GL_COORD_REPLACE_ARB ? (void *)&ctx->s.point.coord_replace[unit] : &ctx->s.texture.unit[unit].env;
}

void fgl_exec_TexEnvfv(struct context *ctx, GLenum target, GLenum pname, const GLfloat *params)
{
    const struct param *p = fgl_texture_env_param(pname);
    RETURN_ERROR_IF(ctx, !p || !target_has(target, pname), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, p->kind == PARAM_ENUM && !enum_allowed(pname, fgl_enum_from_float(params[0])), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_param_allows(p, params), GL_INVALID_VALUE);
    const bool scale = pname == GL_RGB_SCALE || pname == GL_ALPHA_SCALE, boolean = p->kind == PARAM_BOOL;
    RETURN_ERROR_IF(ctx, scale && params[0] != 1.0f && params[0] != 2.0f && params[0] != 4.0f, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, boolean && params[0] != 0.0f && params[0] != 1.0f, GL_INVALID_VALUE);
    fgl_param_set_clamped(ctx, DIRTY_TEXTURE, p, active_env(ctx, pname), params);
}

void GLAPIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint *params)
{
    float v[4];
    fgl_param_from_ints(fgl_texture_env_param(pname), params, v);
    glTexEnvfv(target, pname, v);
}

void GLAPIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param)
{
    glTexEnvfv(target, fgl_param_scalar(fgl_texture_env_param(pname)), &param);
}

void GLAPIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param)
{
    glTexEnviv(target, fgl_param_scalar(fgl_texture_env_param(pname)), &param);
}

/* The row with its value; NULL after recording an error. */
static const struct param *get(struct context *ctx, GLenum target, GLenum pname, float v[4])
{
    const struct param *p = fgl_texture_env_param(pname);
    RETURN_VALUE_ERROR_IF(ctx, !p || !target_has(target, pname), GL_INVALID_ENUM, NULL);
    fgl_param_get(p, active_env(ctx, pname), v);
    return p;
}

void fgl_exec_GetTexEnvfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    float v[4];
    const struct param *p = get(ctx, target, pname, v);
    if (p)
        memcpy(params, v, (size_t)p->count * sizeof *v);
}

void fgl_exec_GetTexEnviv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    float v[4];
    const struct param *p = get(ctx, target, pname, v);
    if (p)
        fgl_param_to_ints(p, v, params);
}
