/* glPushAttrib and glPopAttrib with GL_TEXTURE_BIT: environments, texgen, bindings, and the parameters of the
 * bound textures (GL 1.5, 6.1.14 "Saving and Restoring State", table 6.15). */
#include "api/texture_attrib.h"

#include "api/errors.h"
#include "texture/texture.h"

#include <string.h>

void fgl_textures_save(const struct context *ctx, struct attrib_entry *e)
{
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        for (int t = 0; t < TEXTURE_TARGETS; t++) {
            const struct texture_object *bound = ctx->s.texture.unit[unit].bound[t];
            e->texture[unit][t] = (struct saved_texture){bound->name, bound->parameters};
        }
}

/* OSMesa rule: a texture that was deleted since the push comes back, with its parameters but no image. */
static void restore_texture(struct context *ctx, struct texture_object **bound, enum texture_target target,
                            const struct saved_texture *saved)
{
    struct texture_object *object = fgl_texture_lookup(ctx->textures, saved->name, target);
    RETURN_ERROR_IF(ctx, !object, GL_OUT_OF_MEMORY);
    if (object->target != target) /* the name means another texture now */
        return;
    fgl_texture_bind(bound, object);
    object->parameters = saved->parameters;
    fgl_texture_changed(object);
}

void fgl_textures_restore(struct context *ctx, const struct attrib_entry *e)
{
    struct texture_state *now = &ctx->s.texture;
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        struct texture_unit *u = &now->unit[unit], saved = e->state.texture.unit[unit];
        memcpy(saved.bound, u->bound, sizeof saved.bound);
        saved.sampler = u->sampler; /* OSMesa rule: stays as it is */
        *u = saved;
        for (enum texture_target t = 0; t < TEXTURE_TARGETS; t++)
            restore_texture(ctx, &u->bound[t], t, &e->texture[unit][t]);
    }
    now->active_texture = e->state.texture.active_texture;
    ctx->dirty |= DIRTY_TEXTURE;
}
