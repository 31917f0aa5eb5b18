/* Texture targets. See texture_target.h. */
#include "api/texture_target.h"

#include "api/errors.h"
#include "api/framebuffer_object.h"

bool fgl_texture_target(GLenum target, enum texture_target *out)
{
    switch (target) {
    case GL_TEXTURE_1D: *out = TEXTURE_1D; return true;
    case GL_TEXTURE_2D: *out = TEXTURE_2D; return true;
    case GL_TEXTURE_RECTANGLE_ARB: *out = TEXTURE_RECTANGLE; return true;
    case GL_TEXTURE_3D: *out = TEXTURE_3D; return true;
    case GL_TEXTURE_CUBE_MAP: *out = TEXTURE_CUBE_MAP; return true;
    default: return false;
    }
}

static bool find(GLenum target, struct image_target *out)
{
    *out = (struct image_target){0};
    switch (target) {
    case GL_PROXY_TEXTURE_1D: out->proxy = true; out->target = TEXTURE_1D; return true;
    case GL_PROXY_TEXTURE_2D: out->proxy = true; out->target = TEXTURE_2D; return true;
    case GL_PROXY_TEXTURE_RECTANGLE_ARB: out->proxy = true; out->target = TEXTURE_RECTANGLE; return true;
    case GL_PROXY_TEXTURE_3D: out->proxy = true; out->target = TEXTURE_3D; return true;
    case GL_PROXY_TEXTURE_CUBE_MAP: out->proxy = true; out->target = TEXTURE_CUBE_MAP; return true;
    default: break;
    }
    out->face = (int)target - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    if (out->face >= 0 && out->face < TEXTURE_MAX_FACES) {
        out->target = TEXTURE_CUBE_MAP;
        return true;
    }
    out->face = 0;
    return target != GL_TEXTURE_CUBE_MAP && fgl_texture_target(target, &out->target);
}

bool fgl_image_target(GLenum target, int dimensions, struct image_target *out)
{
    static const int dimensions_of[TEXTURE_TARGETS] = {1, 2, 2, 3, 2};
    return find(target, out) && (!dimensions || dimensions == dimensions_of[out->target]);
}

struct texture_object *fgl_bound_texture(const struct context *ctx, enum texture_target target)
{
    return ctx->s.texture.unit[ctx->s.texture.active_texture].bound[target];
}

struct texture_image *fgl_target_image(struct context *ctx, const struct image_target *t, int level)
{
    if (t->proxy)
        return &ctx->proxy_texture[t->target]->image[0][level];
    return &fgl_bound_texture(ctx, t->target)->image[t->face][level];
}

int fgl_texture_levels(enum texture_target target)
{
    return target == TEXTURE_RECTANGLE ? 1 : target == TEXTURE_3D ? FGL_MAX_3D_TEXTURE_LEVELS : FGL_MAX_TEXTURE_LEVELS;
}

void fgl_texture_touch_image(struct context *ctx, const struct texture_object *object)
{
    fgl_framebuffer_unload_texture(ctx, object);
    fgl_flush_vertices(ctx, DIRTY_TEXTURE);
}

void fgl_texture_touch(struct context *ctx, struct texture_object *object)
{
    fgl_texture_touch_image(ctx, object);
    fgl_texture_changed(object);
}
