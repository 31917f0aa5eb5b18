/* glTexGen, glGetTexGen (GL 1.5, 2.11.4 "Generating Texture Coordinates"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/plane.h"
#include "api/set.h"

#include <string.h>

int fgl_count_texgen(GLenum pname)
{
    switch (pname) {
    case GL_TEXTURE_GEN_MODE: return 1;
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE: return 4;
    default: return 0;
    }
}

/* The generation of a coordinate of the active unit; NULL for what is no coordinate. */
static struct texgen *find(struct context *ctx, GLenum coord)
{
    const unsigned i = coord - GL_S;
    return i < 4 ? &ctx->s.texture.unit[ctx->s.texture.active_texture].gen[i] : NULL;
}

/* Sphere mapping makes s and t, the cube's modes s, t and r. */
static bool mode_allowed(GLenum coord, GLenum mode)
{
    switch (mode) {
    case GL_OBJECT_LINEAR:
    case GL_EYE_LINEAR: return true;
    case GL_SPHERE_MAP: return coord == GL_S || coord == GL_T;
    case GL_REFLECTION_MAP:
    case GL_NORMAL_MAP: return coord != GL_Q;
    default: return false;
    }
}

void fgl_exec_TexGenfv(struct context *ctx, GLenum coord, GLenum pname, const GLfloat *params)
{
    struct texgen *gen = find(ctx, coord);
    RETURN_ERROR_IF(ctx, !gen || !fgl_count_texgen(pname), GL_INVALID_ENUM);
    if (pname == GL_TEXTURE_GEN_MODE) {
        const GLenum mode = fgl_enum_from_float(params[0]);
        RETURN_ERROR_IF(ctx, !mode_allowed(coord, mode), GL_INVALID_ENUM);
        SET(ctx, DIRTY_TEXTURE, gen->mode, mode);
    } else if (pname == GL_OBJECT_PLANE) {
        fgl_set_floats(ctx, DIRTY_TEXTURE, gen->object_plane, params, 4);
    } else {
        const double plane[4] = {(double)params[0], (double)params[1], (double)params[2], (double)params[3]};
        fgl_set_plane(ctx, DIRTY_TEXTURE, gen->eye_plane, gen->exact_eye_plane, plane);
    }
}

void GLAPIENTRY glTexGendv(GLenum coord, GLenum pname, const GLdouble *params)
{
    float v[4];
    for (int i = 0; i < fgl_count_texgen(pname); i++)
        v[i] = (float)params[i];
    glTexGenfv(coord, pname, v);
}

void GLAPIENTRY glTexGeniv(GLenum coord, GLenum pname, const GLint *params)
{
    float v[4];
    for (int i = 0; i < fgl_count_texgen(pname); i++)
        v[i] = (float)params[i];
    glTexGenfv(coord, pname, v);
}

/* The scalar forms take the mode only. */
static GLenum scalar(GLenum pname)
{
    return fgl_count_texgen(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glTexGend(GLenum coord, GLenum pname, GLdouble param)
{
    glTexGendv(coord, scalar(pname), &param);
}

void GLAPIENTRY glTexGenf(GLenum coord, GLenum pname, GLfloat param)
{
    glTexGenfv(coord, scalar(pname), &param);
}

void GLAPIENTRY glTexGeni(GLenum coord, GLenum pname, GLint param)
{
    glTexGeniv(coord, scalar(pname), &param);
}

/* The number of values; 0 after recording an error. */
static int get(struct context *ctx, GLenum coord, GLenum pname, float v[4])
{
    const struct texgen *gen = find(ctx, coord);
    RETURN_VALUE_ERROR_IF(ctx, !gen || !fgl_count_texgen(pname), GL_INVALID_ENUM, 0);
    if (pname == GL_TEXTURE_GEN_MODE)
        v[0] = (float)gen->mode;
    else
        memcpy(v, pname == GL_OBJECT_PLANE ? gen->object_plane : gen->eye_plane, 4 * sizeof *v);
    return fgl_count_texgen(pname);
}

void fgl_exec_GetTexGenfv(struct context *ctx, GLenum coord, GLenum pname, GLfloat *params)
{
    float v[4];
    memcpy(params, v, (size_t)get(ctx, coord, pname, v) * sizeof *v);
}

void fgl_exec_GetTexGendv(struct context *ctx, GLenum coord, GLenum pname, GLdouble *params)
{
    float v[4];
    const int n = get(ctx, coord, pname, v);
    for (int i = 0; i < n; i++)
        params[i] = (double)v[i];
}

void fgl_exec_GetTexGeniv(struct context *ctx, GLenum coord, GLenum pname, GLint *params)
{
    float v[4];
    const int n = get(ctx, coord, pname, v);
    for (int i = 0; i < n; i++)
        params[i] = fgl_int_round((double)v[i]);
}
