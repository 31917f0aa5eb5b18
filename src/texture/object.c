/* Texture objects: names, references, bindings (GL 1.5, 3.8.11 "Texture Objects"). */
#include "texture/image.h"

#include <stdlib.h>

struct texture_object fgl_texture_unbound;

/* ---- objects ---- */

void fgl_texture_init_parameters(struct texture_parameters *p)
{
    *p = (struct texture_parameters){
            .min_filter = GL_NEAREST_MIPMAP_LINEAR,
            .mag_filter = GL_LINEAR,
            .wrap = {GL_REPEAT, GL_REPEAT, GL_REPEAT},
            .compare_mode = GL_NONE,
            .compare_func = GL_LEQUAL,
            .depth_mode = GL_LUMINANCE,
            .swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA},
            .priority = 1,
            .min_lod = -1000,
            .max_lod = 1000,
            .max_level = 1000,
    };
}

/* GL_ARB_texture_rectangle: neither mipmaps nor repetition. */
static void init_rectangle(struct texture_parameters *p)
{
    p->min_filter = GL_LINEAR;
    for (int i = 0; i < 3; i++)
        p->wrap[i] = GL_CLAMP_TO_EDGE;
}

static struct texture_object *create(unsigned name, enum texture_target target)
{
    struct texture_object *object = calloc(1, sizeof *object);
    if (!object)
        return NULL;
    object->name = name;
    object->target = target;
    fgl_texture_init_parameters(&object->parameters);
    if (target == TEXTURE_RECTANGLE)
        init_rectangle(&object->parameters);
    atomic_init(&object->references, 1);
    return object;
}

void fgl_texture_release(struct texture_object *object)
{
    if (!object || atomic_fetch_sub(&object->references, 1) != 1)
        return;
    for (int face = 0; face < TEXTURE_MAX_FACES; face++)
        for (int level = 0; level < FGL_MAX_TEXTURE_LEVELS; level++)
            fgl_texture_image_clear(&object->image[face][level]);
    free(object);
}

/* ---- the store ---- */

struct texture_store *fgl_texture_store_create(void)
{
    struct texture_store *store = calloc(1, sizeof *store);
    if (!store)
        return NULL;
    atomic_init(&store->references, 1);
    bool whole = true;
    for (enum texture_target t = 0; t < TEXTURE_TARGETS; t++)
        whole &= (store->default_object[t] = create(0, t)) != NULL;
    if (whole)
        return store;
    fgl_texture_store_release(store);
    return NULL;
}

void fgl_texture_store_retain(struct texture_store *store)
{
    atomic_fetch_add(&store->references, 1);
}

static void release_named(void *value)
{
    if (value != &fgl_texture_unbound)
        fgl_texture_release(value);
}

void fgl_texture_store_release(struct texture_store *store)
{
    if (!store || atomic_fetch_sub(&store->references, 1) != 1)
        return;
    fgl_idmap_free(&store->map, release_named);
    for (int t = 0; t < TEXTURE_TARGETS; t++)
        fgl_texture_release(store->default_object[t]);
    free(store);
}

struct texture_object *fgl_texture_lookup(struct texture_store *store, unsigned name,
                                          enum texture_target target)
{
    if (name == 0)
        return store->default_object[target];
    struct texture_object *object = fgl_idmap_get(&store->map, name);
    if (object && object != &fgl_texture_unbound)
        return object;
    object = create(name, target);
    if (object && fgl_idmap_put(&store->map, name, object))
        return object;
    free(object);
    return NULL;
}

/* ---- bindings ---- */

void fgl_texture_bind(struct texture_object **bound, struct texture_object *object)
{
    struct texture_object *old = *bound;
    atomic_fetch_add(&object->references, 1);
    *bound = object;
    fgl_texture_release(old);
}

void fgl_sampler_release(struct sampler_object *object)
{
    if (object && atomic_fetch_sub(&object->references, 1) == 1)
        free(object);
}

void fgl_sampler_bind(struct sampler_object **bound, struct sampler_object *object)
{
    struct sampler_object *old = *bound;
    if (object)
        atomic_fetch_add(&object->references, 1);
    *bound = object;
    fgl_sampler_release(old);
}

bool fgl_texture_context_init(struct context *ctx)
{
    bool whole = true;
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        for (int t = 0; t < TEXTURE_TARGETS; t++)
            fgl_texture_bind(&ctx->s.texture.unit[unit].bound[t], ctx->textures->default_object[t]);
    for (enum texture_target t = 0; t < TEXTURE_TARGETS; t++)
        whole &= (ctx->proxy_texture[t] = create(0, t)) != NULL;
    return whole;
}

void fgl_texture_context_free(struct context *ctx)
{
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        fgl_sampler_bind(&ctx->s.texture.unit[unit].sampler, NULL);
        for (int t = 0; t < TEXTURE_TARGETS; t++) {
            fgl_texture_release(ctx->s.texture.unit[unit].bound[t]);
            ctx->s.texture.unit[unit].bound[t] = NULL;
        }
    }
    for (int t = 0; t < TEXTURE_TARGETS; t++)
        fgl_texture_release(ctx->proxy_texture[t]);
}
