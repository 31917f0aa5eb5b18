/* Immutable textures: all levels at once (GL_ARB_texture_storage). */
#include "api/command.h"
#include "api/errors.h"
#include "api/texture_image.h"

/* Targets that a command of these dimensions may give storage: those of whole textures, and proxies. */
static bool find_target(GLenum target, int dimensions, struct image_target *t)
{
    enum texture_target whole;
    if (target == GL_TEXTURE_CUBE_MAP && dimensions == 2) {
        *t = (struct image_target){.target = TEXTURE_CUBE_MAP};
        return true;
    }
    return fgl_image_target(target, dimensions, t) && (t->proxy || fgl_texture_target(target, &whole));
}

/* Formats that leave the precision to the library have no storage. */
static bool is_sized(GLenum internal_format)
{
    const struct texture_format *f = internal_format > 4 ? fgl_texture_format(internal_format) : NULL;
    if (!f || fgl_texture_format_compressed(f))
        return false;
    switch (internal_format) {
    case GL_ALPHA:
    case GL_LUMINANCE:
    case GL_LUMINANCE_ALPHA:
    case GL_INTENSITY:
    case GL_RED:
    case GL_RG:
    case GL_RGB:
    case GL_RGBA:
    case GL_SRGB_EXT:
    case GL_SRGB_ALPHA_EXT:
    case GL_SLUMINANCE_EXT:
    case GL_SLUMINANCE_ALPHA_EXT:
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_STENCIL: return false;
    default: return true;
    }
}

/* One more than the largest level that a texture of these sizes can have. */
static int most_levels(const struct texture_call *call, enum texture_target target)
{
    int size = fgl_max(fgl_max(call->width, call->height), call->depth), levels = 1;
    while (target != TEXTURE_RECTANGLE && (size >>= 1) > 0)
        levels++;
    return levels;
}

/* The call's level is the number of them. */
static GLenum storage_error(struct context *ctx, const struct texture_call *call, struct image_target *t)
{
    if (!find_target(call->target, call->dimensions, t) || !is_sized((GLenum)call->internal_format))
        return GL_INVALID_ENUM;
    if (call->level < 1 || call->width < 1 || call->height < 1 || call->depth < 1)
        return GL_INVALID_VALUE;
    if (call->level > most_levels(call, t->target))
        return GL_INVALID_OPERATION;
    const bool depth = fgl_texture_format((GLenum)call->internal_format)->kind == TEXELS_DEPTH;
    if (depth && (t->target == TEXTURE_3D || t->target == TEXTURE_CUBE_MAP))
        return GL_INVALID_OPERATION;
    const struct texture_object *object = fgl_bound_texture(ctx, t->target);
    return !t->proxy && (object->name == 0 || object->immutable_levels) ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

static void clear_images(struct texture_object *object)
{
    for (int face = 0; face < TEXTURE_MAX_FACES; face++)
        for (int level = 0; level < FGL_MAX_TEXTURE_LEVELS; level++)
            fgl_texture_image_clear(&object->image[face][level]);
}

static bool define_levels(struct texture_object *object, const struct texture_call *call, const struct image_target *t)
{
    const GLenum internal_format = (GLenum)call->internal_format;
    for (int face = 0; face < fgl_texture_faces(t->target); face++)
        for (int level = 0; level < call->level; level++) {
            const struct image_shape shape = {internal_format, fgl_texture_format(internal_format), fgl_max(call->width >> level, 1),
                                              fgl_max(call->height >> level, 1), fgl_max(call->depth >> level, 1), 0};
            if (!fgl_texture_image_define(&object->image[face][level], t->target, &shape, t->proxy))
                return false;
        }
    return true;
}

static void storage(struct context *ctx, const struct texture_call *call)
{
    struct image_target t;
    bool too_large;
    const GLenum error = storage_error(ctx, call, &t);
    RETURN_ERROR_IF(ctx, error, error);
    struct texture_call base = *call;
    base.level = 0;
    const GLenum size_error = fgl_texture_define_error(&base, &t, &too_large);
    RETURN_ERROR_IF(ctx, size_error, size_error);
    struct texture_object *object = t.proxy ? ctx->proxy_texture[t.target] : fgl_bound_texture(ctx, t.target);
    if (!t.proxy)
        fgl_texture_touch(ctx, object);
    clear_images(object);
    if (too_large)
        return;
    if (!define_levels(object, call, &t)) {
        clear_images(object);
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return;
    }
    if (!t.proxy)
        object->immutable_levels = call->level;
}

void fgl_exec_TexStorage1D(struct context *ctx, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width)
{
    const struct texture_call call = {.dimensions = 1, .target = target, .level = levels, .internal_format = (int)internalformat,
                                      .width = width, .height = 1, .depth = 1};
    storage(ctx, &call);
}

void fgl_exec_TexStorage2D(struct context *ctx, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width, GLsizei height)
{
    const struct texture_call call = {.dimensions = 2, .target = target, .level = levels, .internal_format = (int)internalformat,
                                      .width = width, .height = height, .depth = 1};
    storage(ctx, &call);
}

void fgl_exec_TexStorage3D(struct context *ctx, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width, GLsizei height,
                           GLsizei depth)
{
    const struct texture_call call = {.dimensions = 3, .target = target, .level = levels, .internal_format = (int)internalformat,
                                      .width = width, .height = height, .depth = depth};
    storage(ctx, &call);
}
