/* State of rasterization: points, lines, polygons, hints (GL 1.5, 3.3 "Points", 3.4 "Line Segments", 3.5
 * "Polygons", 5.6 "Hints"). */
#include "api/command.h"
#include "api/params.h"
#include "api/set.h"
#include "fixedgl.h"

void fgl_exec_PointSize(struct context *ctx, GLfloat size)
{
    RETURN_ERROR_IF(ctx, !(size > 0), GL_INVALID_VALUE);
    SET(ctx, DIRTY_RASTER | DIRTY_POINT, ctx->s.point.point_size, size);
}

void fgl_exec_PointParameterfv(struct context *ctx, GLenum pname, const GLfloat *params)
{
    const struct param *p = fgl_point_param(pname);
    RETURN_ERROR_IF(ctx, !p, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_param_allows(p, params), GL_INVALID_VALUE);
    fgl_param_set(ctx, DIRTY_RASTER | DIRTY_POINT, p, &ctx->s.point, params);
}

void GLAPIENTRY glPointParameteriv(GLenum pname, const GLint *params)
{
    float v[4];

    fgl_param_from_ints(fgl_point_param(pname), params, v);
    glPointParameterfv(pname, v);
}

/* Only parameters of one value have a form for one value. */
static GLenum scalar_point(GLenum pname)
{
    return fgl_count_point(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glPointParameterf(GLenum pname, GLfloat param)
{
    glPointParameterfv(scalar_point(pname), &param);
}
void GLAPIENTRY glPointParameteri(GLenum pname, GLint param)
{
    glPointParameteriv(scalar_point(pname), &param);
}

void fgl_exec_LineWidth(struct context *ctx, GLfloat width)
{
    RETURN_ERROR_IF(ctx, !(width > 0), GL_INVALID_VALUE);
    SET(ctx, DIRTY_RASTER, ctx->s.line.line_width, width);
}

void fgl_exec_LineStipple(struct context *ctx, GLint factor, GLushort pattern)
{
    SET(ctx, DIRTY_RASTER, ctx->s.line.line_stipple_repeat, fgl_clamp(factor, 1, 256));
    SET(ctx, DIRTY_RASTER, ctx->s.line.line_stipple_pattern, pattern);
}

static bool is_face(GLenum face)
{
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

void fgl_exec_CullFace(struct context *ctx, GLenum mode)
{
    RETURN_ERROR_IF(ctx, !is_face(mode), GL_INVALID_ENUM);
    SET(ctx, DIRTY_RASTER, ctx->s.polygon.cull_face_mode, mode);
}

void fgl_exec_FrontFace(struct context *ctx, GLenum mode)
{
    RETURN_ERROR_IF(ctx, mode != GL_CW && mode != GL_CCW, GL_INVALID_ENUM);
    SET(ctx, DIRTY_RASTER, ctx->s.polygon.front_face, mode);
}

void fgl_exec_PolygonMode(struct context *ctx, GLenum face, GLenum mode)
{
    RETURN_ERROR_IF(ctx, !is_face(face), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, mode != GL_POINT && mode != GL_LINE && mode != GL_FILL, GL_INVALID_ENUM);
    if (face != GL_BACK)
        SET(ctx, DIRTY_RASTER, ctx->s.polygon.polygon_mode[0], mode);
    if (face != GL_FRONT)
        SET(ctx, DIRTY_RASTER, ctx->s.polygon.polygon_mode[1], mode);
}

void fgl_exec_PolygonOffset(struct context *ctx, GLfloat factor, GLfloat units)
{
    SET(ctx, DIRTY_RASTER, ctx->s.polygon.polygon_offset_factor, factor);
    SET(ctx, DIRTY_RASTER, ctx->s.polygon.polygon_offset_units, units);
}

static GLenum *find_hint(struct hint_state *h, GLenum target)
{
    switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT: return &h->perspective_correction_hint;
    case GL_POINT_SMOOTH_HINT: return &h->point_smooth_hint;
    case GL_LINE_SMOOTH_HINT: return &h->line_smooth_hint;
    case GL_POLYGON_SMOOTH_HINT: return &h->polygon_smooth_hint;
    case GL_FOG_HINT: return &h->fog_hint;
    case GL_GENERATE_MIPMAP_HINT: return &h->generate_mipmap_hint;
    case GL_TEXTURE_COMPRESSION_HINT: return &h->texture_compression_hint;
    case GL_PHONG_HINT_WIN: return &h->phong_hint;
    default: return NULL;
    }
}

/* Hints are kept and have no effect, as in OSMesa, but for our own (fixedgl.h). */
void fgl_exec_Hint(struct context *ctx, GLenum target, GLenum mode)
{
    GLenum *hint = find_hint(&ctx->s.hint, target);
    const bool accuracy = target == GL_LIGHTING_ACCURACY_HINT_FIXEDGL;
    RETURN_ERROR_IF(ctx, !hint && !accuracy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE, GL_INVALID_ENUM);
    if (accuracy)
        fgl_set_accuracy(ctx, mode == GL_NICEST ? FIXEDGL_EXACT : FIXEDGL_COMPATIBLE);
    else
        SET(ctx, DIRTY_RASTER, *hint, mode);
}
