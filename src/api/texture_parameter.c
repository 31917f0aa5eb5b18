/* glTexParameter, glGetTexParameter, glGetTexLevelParameter (GL 1.5, 3.8.4 "Texture Parameters", 6.1.3 "Enumerated
 * Queries"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/params.h"
#include "api/set.h"
#include "api/texture_image.h"

#include <string.h>

/* ---- glTexParameter ---- */

static bool is_filter(GLenum v)
{
    return v == GL_NEAREST || v == GL_LINEAR;
}

static bool is_min_filter(GLenum v)
{
    return is_filter(v) || v == GL_NEAREST_MIPMAP_NEAREST || v == GL_NEAREST_MIPMAP_LINEAR ||
           v == GL_LINEAR_MIPMAP_NEAREST || v == GL_LINEAR_MIPMAP_LINEAR;
}

static bool is_wrap(GLenum v)
{
    return v == GL_CLAMP || v == GL_REPEAT || v == GL_CLAMP_TO_EDGE || v == GL_CLAMP_TO_BORDER || v == GL_MIRRORED_REPEAT;
}

static bool is_swizzle(GLenum v)
{
    return (v >= GL_RED && v <= GL_ALPHA) || v == GL_ZERO || v == GL_ONE;
}

/* Table 3.18: whether an enumerant is one of the parameter's values. */
static bool enum_allowed(GLenum pname, GLenum v)
{
    switch (pname) {
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R: return is_wrap(v);
    case GL_TEXTURE_MIN_FILTER: return is_min_filter(v);
    case GL_TEXTURE_MAG_FILTER: return is_filter(v);
    case GL_DEPTH_TEXTURE_MODE: return v == GL_LUMINANCE || v == GL_INTENSITY || v == GL_ALPHA;
    case GL_TEXTURE_COMPARE_MODE: return v == GL_NONE || v == GL_COMPARE_R_TO_TEXTURE;
    case GL_TEXTURE_COMPARE_FUNC: return v >= GL_NEVER && v <= GL_ALWAYS;
    case GL_TEXTURE_SWIZZLE_R:
    case GL_TEXTURE_SWIZZLE_G:
    case GL_TEXTURE_SWIZZLE_B:
    case GL_TEXTURE_SWIZZLE_A:
    case GL_TEXTURE_SWIZZLE_RGBA: return is_swizzle(v);
    default: return true;
    }
}

bool fgl_texture_enums_allowed(const struct param *p, const float *v)
{
    for (int i = 0; i < p->count && p->kind == PARAM_ENUM; i++)
        if (!enum_allowed(p->pname, fgl_enum_from_float(v[i])))
            return false;
    return true;
}

/* GL_ARB_texture_rectangle: the error of a value that other targets may have. */
static GLenum rectangle_error(GLenum pname, float value)
{
    const GLenum v = fgl_enum_from_float(value);
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER: return is_filter(v) ? GL_NO_ERROR : GL_INVALID_ENUM;
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R: return v == GL_REPEAT || v == GL_MIRRORED_REPEAT ? GL_INVALID_ENUM : GL_NO_ERROR;
    case GL_TEXTURE_BASE_LEVEL: return value != 0.0f ? GL_INVALID_OPERATION : GL_NO_ERROR;
    case GL_TEXTURE_MAX_LEVEL: return value > 0.0f ? GL_INVALID_VALUE : GL_NO_ERROR; /* OSMesa rule */
    default: return GL_NO_ERROR;
    }
}

void fgl_exec_TexParameterfv(struct context *ctx, GLenum target, GLenum pname, const GLfloat *params)
{
    enum texture_target t;
    const struct param *p = fgl_texture_param(pname);
    RETURN_ERROR_IF(ctx, !fgl_texture_target(target, &t) || !p, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_texture_enums_allowed(p, params), GL_INVALID_ENUM);
    const GLenum error = t == TEXTURE_RECTANGLE ? rectangle_error(pname, params[0]) : GL_NO_ERROR;
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_param_allows(p, params), GL_INVALID_VALUE);

    struct texture_object *object = fgl_bound_texture(ctx, t);
    fgl_param_set_clamped(ctx, DIRTY_TEXTURE, p, &object->parameters, params);
    fgl_texture_changed(object);
}

void GLAPIENTRY glTexParameteriv(GLenum target, GLenum pname, const GLint *params)
{
    float v[4];
    fgl_param_from_ints(fgl_texture_param(pname), params, v);
    glTexParameterfv(target, pname, v);
}

void GLAPIENTRY glTexParameterf(GLenum target, GLenum pname, GLfloat param)
{
    glTexParameterfv(target, fgl_param_scalar(fgl_texture_param(pname)), &param);
}

void GLAPIENTRY glTexParameteri(GLenum target, GLenum pname, GLint param)
{
    glTexParameteriv(target, fgl_param_scalar(fgl_texture_param(pname)), &param);
}

/* ---- glGetTexParameter ---- */

/* Reads a parameter; NULL after recording an error. GL_TEXTURE_RESIDENT and GL_TEXTURE_IMMUTABLE_FORMAT can only be asked for: all textures are
 * resident. */
static const struct param *get(struct context *ctx, GLenum target, GLenum pname, float v[4])
{
    static const struct param resident = {.pname = GL_TEXTURE_RESIDENT, .kind = PARAM_BOOL, .count = 1};
    static const struct param immutable = {.pname = GL_TEXTURE_IMMUTABLE_FORMAT, .kind = PARAM_BOOL, .count = 1};
    enum texture_target t;
    const struct param *p = pname == GL_TEXTURE_RESIDENT           ? &resident
                            : pname == GL_TEXTURE_IMMUTABLE_FORMAT ? &immutable
                                                                   : fgl_texture_param(pname);
    RETURN_VALUE_ERROR_IF(ctx, !fgl_texture_target(target, &t) || !p, GL_INVALID_ENUM, NULL);
    if (p == &resident)
        v[0] = 1.0f;
    else if (p == &immutable)
        v[0] = fgl_bound_texture(ctx, t)->immutable_levels ? 1.0f : 0.0f;
    else
        fgl_param_get(p, &fgl_bound_texture(ctx, t)->parameters, v);
    return p;
}

void fgl_exec_GetTexParameterfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    float v[4];
    const struct param *p = get(ctx, target, pname, v);
    if (p)
        memcpy(params, v, (size_t)p->count * sizeof *v);
}

void fgl_exec_GetTexParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    float v[4];
    const struct param *p = get(ctx, target, pname, v);
    if (p)
        fgl_param_to_ints(p, v, params);
}

/* ---- glGetTexLevelParameter ---- */

/* Bits of a channel that the format has (table 6.16). */
static int channel_size(const struct texture_format *f, GLenum pname)
{
    const GLenum base = f->base_format;
    switch (pname) {
    case GL_TEXTURE_RED_SIZE: return base == GL_RED || base == GL_RG || base == GL_RGB || base == GL_RGBA ? f->bits[0] : 0;
    case GL_TEXTURE_GREEN_SIZE: return f->bits[1];
    case GL_TEXTURE_BLUE_SIZE: return f->bits[2];
    case GL_TEXTURE_ALPHA_SIZE: return f->bits[3];
    case GL_TEXTURE_LUMINANCE_SIZE: return base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA ? f->bits[0] : 0;
    case GL_TEXTURE_INTENSITY_SIZE: return base == GL_INTENSITY ? f->bits[0] : 0;
    case GL_TEXTURE_STENCIL_SIZE: return base == GL_DEPTH_STENCIL ? 8 : 0;
    default: return f->kind == TEXELS_DEPTH ? f->bits[0] : 0;
    }
}

/* The size that goes with a type. */
static GLenum size_of(GLenum type)
{
    switch (type) {
    case GL_TEXTURE_RED_TYPE_ARB: return GL_TEXTURE_RED_SIZE;
    case GL_TEXTURE_GREEN_TYPE_ARB: return GL_TEXTURE_GREEN_SIZE;
    case GL_TEXTURE_BLUE_TYPE_ARB: return GL_TEXTURE_BLUE_SIZE;
    case GL_TEXTURE_ALPHA_TYPE_ARB: return GL_TEXTURE_ALPHA_SIZE;
    case GL_TEXTURE_LUMINANCE_TYPE_ARB: return GL_TEXTURE_LUMINANCE_SIZE;
    case GL_TEXTURE_INTENSITY_TYPE_ARB: return GL_TEXTURE_INTENSITY_SIZE;
    default: return GL_TEXTURE_DEPTH_SIZE;
    }
}

/* GL_ARB_texture_float: what the bits of a channel mean; GL_NONE for one that the format has not. */
static GLenum channel_type(const struct texture_format *f, GLenum size)
{
    if (!channel_size(f, size))
        return GL_NONE;
    if (!fgl_texture_format_leaves_unit(f))
        return GL_UNSIGNED_NORMALIZED_ARB;
    return f->encoding == ENCODED_SNORM ? GL_SIGNED_NORMALIZED : GL_FLOAT;
}

/* Table 6.16; false for a pname that is not in it. */
static bool level_value(const struct texture_image *image, bool proxy, GLenum pname, int *v)
{
    switch (pname) {
    case GL_TEXTURE_WIDTH: *v = image->width; return true;
    case GL_TEXTURE_HEIGHT: *v = image->height; return true;
    case GL_TEXTURE_DEPTH: *v = image->depth; return true;
    case GL_TEXTURE_BORDER: *v = 0; return true;
    case GL_TEXTURE_INTERNAL_FORMAT: *v = image->format ? (int)image->internal_format : proxy ? 0 : 1; return true;
    case GL_TEXTURE_COMPRESSED: *v = 0; return true;
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
    case GL_TEXTURE_STENCIL_SIZE:
    case GL_TEXTURE_DEPTH_SIZE: *v = image->format ? channel_size(image->format, pname) : 0; return true;
    case GL_TEXTURE_SHARED_SIZE_EXT: *v = image->format && image->format->encoding == ENCODED_SHARED_EXPONENT ? 5 : 0; return true;
    case GL_TEXTURE_RED_TYPE_ARB:
    case GL_TEXTURE_GREEN_TYPE_ARB:
    case GL_TEXTURE_BLUE_TYPE_ARB:
    case GL_TEXTURE_ALPHA_TYPE_ARB:
    case GL_TEXTURE_LUMINANCE_TYPE_ARB:
    case GL_TEXTURE_INTENSITY_TYPE_ARB:
    case GL_TEXTURE_DEPTH_TYPE_ARB: *v = image->format ? (int)channel_type(image->format, size_of(pname)) : GL_NONE; return true;
    default: return false;
    }
}

void fgl_exec_GetTexLevelParameteriv(struct context *ctx, GLenum target, GLint level, GLenum pname, GLint *params)
{
    struct image_target t;
    int v = 0;
    RETURN_ERROR_IF(ctx, !fgl_image_target(target, 0, &t), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, level < 0 || level >= fgl_texture_levels(t.target), GL_INVALID_VALUE);
    const struct texture_image *image = fgl_target_image(ctx, &t, level);
    /* No image is compressed. GL 1.5, 6.1.3 */
    RETURN_ERROR_IF(ctx, pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, !level_value(image, t.proxy, pname, &v), GL_INVALID_ENUM);
    *params = v;
}

void fgl_exec_GetTexLevelParameterfv(struct context *ctx, GLenum target, GLint level, GLenum pname, GLfloat *params)
{
    GLint v = -1; /* no value is */
    fgl_exec_GetTexLevelParameteriv(ctx, target, level, pname, &v);
    if (v >= 0)
        *params = (float)v;
}
