/* Texture objects (GL 1.5, 3.8.11 "Texture Objects") and the active unit (2.7, 3.8.14). */
#include "api/command.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "api/set.h"
#include "api/texture_target.h"
#include "state/share.h"

static struct texture_object *object_of(const struct context *ctx, GLuint name)
{
    struct texture_object *object = fgl_idmap_get(&ctx->textures->map, name);
    return object == &fgl_texture_unbound ? NULL : object;
}

/* ---- names ---- */

void fgl_exec_GenTextures(struct context *ctx, GLsizei n, GLuint *textures)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    const GLuint first = n ? fgl_idmap_find_free(&ctx->textures->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++)
        if (!fgl_idmap_put(&ctx->textures->map, first + i, &fgl_texture_unbound)) {
            while (i--)
                (void)fgl_idmap_remove(&ctx->textures->map, first + i);
            fgl_error(ctx, GL_OUT_OF_MEMORY);
            return;
        }
    for (GLsizei i = 0; first && i < n; i++)
        textures[i] = first + (GLuint)i;
}

/* A binding of a deleted texture reverts to the default one; in this context alone. */
static void unbind(struct context *ctx, struct texture_object *object)
{
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        struct texture_object **bound = &ctx->s.texture.unit[unit].bound[object->target];
        if (*bound == object)
            fgl_texture_bind(bound, ctx->textures->default_object[object->target]);
    }
}

void fgl_exec_DeleteTextures(struct context *ctx, GLsizei n, const GLuint *textures)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    fgl_flush_vertices(ctx, DIRTY_TEXTURE);
    for (GLsizei i = 0; i < n; i++) {
        struct texture_object *object = textures[i] ? fgl_idmap_remove(&ctx->textures->map, textures[i]) : NULL;
        if (!object || object == &fgl_texture_unbound)
            continue;
        unbind(ctx, object);
        fgl_framebuffer_detach(ctx, object, NULL);
        fgl_texture_release(object);
    }
}

GLboolean fgl_exec_IsTexture(struct context *ctx, GLuint texture)
{
    return texture && object_of(ctx, texture) ? GL_TRUE : GL_FALSE;
}

void fgl_exec_BindTexture(struct context *ctx, GLenum target, GLuint texture)
{
    enum texture_target t;
    RETURN_ERROR_IF(ctx, !fgl_texture_target(target, &t), GL_INVALID_ENUM);
    struct texture_object *object = fgl_texture_lookup(ctx->textures, texture, t);
    RETURN_ERROR_IF(ctx, !object, GL_OUT_OF_MEMORY);
    RETURN_ERROR_IF(ctx, object->target != t, GL_INVALID_OPERATION);
    struct texture_object **bound = &ctx->s.texture.unit[ctx->s.texture.active_texture].bound[t];
    if (*bound == object)
        return;
    fgl_flush_vertices(ctx, DIRTY_TEXTURE);
    fgl_texture_bind(bound, object);
}

/* ---- residence: all textures are resident ---- */

static void prioritize(struct context *ctx, GLsizei n, const GLuint *textures, const GLfloat *priorities)
{
    for (GLsizei i = 0; i < n; i++) {
        struct texture_object *object = object_of(ctx, textures[i]);
        if (object)
            object->parameters.priority = fgl_clamp01(priorities[i]);
    }
}

struct prioritize_node {
    GLuint texture;
    GLfloat priority;
};

void fgl_list_replay_prioritize(struct context *ctx, const void *payload)
{
    const struct prioritize_node *node = payload;
    prioritize(ctx, 1, &node->texture, &node->priority);
}

void GLAPIENTRY glPrioritizeTextures(GLsizei n, const GLuint *textures, const GLclampf *priorities)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (fgl_refused_inside(ctx))
        return;
    if (n < 0) {
        fgl_command_error(ctx, GL_INVALID_VALUE);
        return;
    }
    for (GLsizei i = 0; ctx->compiling && i < n; i++) {
        struct prioritize_node *node = fgl_list_record(ctx, OP_PRIORITIZE_TEXTURE, sizeof *node);
        if (node)
            *node = (struct prioritize_node){textures[i], priorities[i]};
    }
    if (ctx->compiling != GL_COMPILE)
        FGL_SHARED(ctx, prioritize(ctx, n, textures, priorities));
}

GLboolean fgl_exec_AreTexturesResident(struct context *ctx, GLsizei n, const GLuint *textures, GLboolean *residences)
{
    (void)residences; /* GL 1.5, 3.8.11: left alone when all are resident */
    RETURN_VALUE_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE, GL_FALSE);
    for (GLsizei i = 0; i < n; i++)
        RETURN_VALUE_ERROR_IF(ctx, !textures[i] || !fgl_idmap_get(&ctx->textures->map, textures[i]),
                              GL_INVALID_VALUE, GL_FALSE);
    return GL_TRUE;
}

/* ---- units ---- */

void fgl_exec_ActiveTexture(struct context *ctx, GLenum texture)
{
    RETURN_ERROR_IF(ctx, texture - GL_TEXTURE0 >= FGL_MAX_TEXTURE_UNITS, GL_INVALID_ENUM);
    ctx->s.texture.active_texture = (int)(texture - GL_TEXTURE0);
}

void fgl_exec_ClientActiveTexture(struct context *ctx, GLenum texture)
{
    RETURN_ERROR_IF(ctx, texture - GL_TEXTURE0 >= FGL_MAX_TEXTURE_UNITS, GL_INVALID_ENUM);
    ctx->client.arrays.client_active_texture = (int)(texture - GL_TEXTURE0);
}
