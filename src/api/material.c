/* Material commands. See material.h. */
#include "api/material.h"

#include "api/command.h"
#include "api/list.h"
#include "api/params.h"
#include "api/set.h"

#include <string.h>

enum { FRONT_BITS = 0x555, BACK_BITS = 0xaaa }; /* of every parameter */

static unsigned face_bits(GLenum face)
{
    switch (face) {
    case GL_FRONT: return FRONT_BITS;
    case GL_BACK: return BACK_BITS;
    case GL_FRONT_AND_BACK: return FRONT_BITS | BACK_BITS;
    default: return 0;
    }
}

static unsigned both(enum fgl_material m)
{
    return 3u << (2 * (int)m);
}

static unsigned parameter_bits(GLenum pname)
{
    switch (pname) {
    case GL_AMBIENT: return both(MAT_AMBIENT);
    case GL_DIFFUSE: return both(MAT_DIFFUSE);
    case GL_AMBIENT_AND_DIFFUSE: return both(MAT_AMBIENT) | both(MAT_DIFFUSE);
    case GL_SPECULAR: return both(MAT_SPECULAR);
    case GL_EMISSION: return both(MAT_EMISSION);
    case GL_SHININESS: return both(MAT_SHININESS);
    case GL_COLOR_INDEXES: return both(MAT_INDEXES);
    default: return 0;
    }
}

/* The material attributes that a face and a parameter name: bit 2 * enum fgl_material + (0 front, 1 back). */
static unsigned material_bits(GLenum face, GLenum pname)
{
    return face_bits(face) & parameter_bits(pname);
}

static unsigned tracked_bits(const struct lighting_state *s)
{
    return s->color_material ? material_bits(s->color_material_face, s->color_material_parameter) : 0;
}

void fgl_material_track_color(struct context *ctx)
{
    struct lighting_state *s = &ctx->s.lighting;
    const unsigned tracked = tracked_bits(s);

    for (int i = 0; i < 2 * MAT_COUNT; i++) {
        if (tracked >> i & 1)
            memcpy(s->material[i / 2][i % 2], ctx->s.current.attr[ATTR_COLOR], 4 * sizeof(float));
    }
    if (tracked)
        ctx->dirty |= DIRTY_MATERIAL;
}

bool fgl_material_is_tracked(const struct context *ctx, int attr)
{
    return attr >= ATTR_MATERIAL && (tracked_bits(&ctx->s.lighting) >> (attr - ATTR_MATERIAL) & 1);
}

/* Allowed between Begin and End: materials are attributes of the next vertices, as colours are. A parameter
 * that tracks the current colour follows that alone: glMaterial does not reach it. */
void GLAPIENTRY glMaterialfv(GLenum face, GLenum pname, const GLfloat *params)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    const struct param *p = fgl_material_param(pname);
    if (!face_bits(face) || !p) {
        fgl_command_error(ctx, GL_INVALID_ENUM);
        return;
    }
    if (!fgl_param_allows(p, params)) {
        fgl_command_error(ctx, GL_INVALID_VALUE);
        return;
    }
    const unsigned tracked = ctx->compiling ? 0 : tracked_bits(&ctx->s.lighting);
    const unsigned bits = material_bits(face, pname) & ~tracked;
    for (int i = 0; i < 2 * MAT_COUNT; i++) {
        if (bits >> i & 1)
            fgl_attr_set(ctx, (enum fgl_attr)(ATTR_MATERIAL + i), p->count, params);
    }
}

void GLAPIENTRY glMaterialiv(GLenum face, GLenum pname, const GLint *params)
{
    float v[4];

    fgl_param_from_ints(fgl_material_param(pname), params, v);
    glMaterialfv(face, pname, v);
}

static GLenum scalar_material(GLenum pname)
{
    return pname == GL_SHININESS ? pname : GL_NONE;
}

void GLAPIENTRY glMaterialf(GLenum face, GLenum pname, GLfloat param)
{
    glMaterialfv(face, scalar_material(pname), &param);
}
void GLAPIENTRY glMateriali(GLenum face, GLenum pname, GLint param)
{
    glMaterialiv(face, scalar_material(pname), &param);
}

/* What glGetMaterial accepts is what glMaterial sets one at a time. */
static const float *find_material(struct context *ctx, GLenum face, GLenum pname)
{
    const unsigned bits = material_bits(face, pname);

    for (int i = 0; i < 2 * MAT_COUNT; i++) {
        if (bits == 1u << i)
            return ctx->s.lighting.material[i / 2][i % 2];
    }
    return NULL;
}

void fgl_exec_GetMaterialfv(struct context *ctx, GLenum face, GLenum pname, GLfloat *params)
{
    const float *v = find_material(ctx, face, pname);
    RETURN_ERROR_IF(ctx, !v, GL_INVALID_ENUM);

    fgl_flush_vertices(ctx, 0);
    fgl_flush_current(ctx);
    memcpy(params, v, (size_t)fgl_material_param(pname)->count * sizeof *params);
}

void fgl_exec_GetMaterialiv(struct context *ctx, GLenum face, GLenum pname, GLint *params)
{
    const float *v = find_material(ctx, face, pname);
    RETURN_ERROR_IF(ctx, !v, GL_INVALID_ENUM);

    fgl_flush_vertices(ctx, 0);
    fgl_flush_current(ctx);
    fgl_param_to_ints(fgl_material_param(pname), v, params);
}

void fgl_exec_ColorMaterial(struct context *ctx, GLenum face, GLenum mode)
{
    struct lighting_state *s = &ctx->s.lighting;
    const bool color = mode == GL_EMISSION || mode == GL_AMBIENT || mode == GL_DIFFUSE ||
                       mode == GL_SPECULAR || mode == GL_AMBIENT_AND_DIFFUSE;
    RETURN_ERROR_IF(ctx, !face_bits(face) || !color, GL_INVALID_ENUM);

    if (face == s->color_material_face && mode == s->color_material_parameter)
        return;
    fgl_flush_vertices(ctx, DIRTY_MATERIAL);
    s->color_material_face = face;
    s->color_material_parameter = mode;
    if (s->color_material) {
        fgl_flush_current(ctx);
        fgl_material_track_color(ctx);
    }
}
