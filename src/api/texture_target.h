/* The targets of texture commands, and the object that each means. */
#ifndef FGL_API_TEXTURE_TARGET_H
#define FGL_API_TEXTURE_TARGET_H

#include "texture/texture.h"

struct image_target {
    enum texture_target target;
    int face;
    bool proxy;
};

/* A target of glBindTexture and glTexParameter; false: none. */
bool fgl_texture_target(GLenum target, enum texture_target *out);

/* A target of glTexImage and its kin with images of `dimensions`; 0: of any. Cube maps by their faces. */
bool fgl_image_target(GLenum target, int dimensions, struct image_target *out);

struct param;
/* Whether the enumerants v are values of a texture's or a sampler's parameter (GL 1.5, table 3.18). */
bool fgl_texture_enums_allowed(const struct param *p, const float *v);

/* The object bound to a target of the active unit. */
struct texture_object *fgl_bound_texture(const struct context *ctx, enum texture_target target);

/* The image of a target and a checked level; of a proxy, the context's proxy image. */
struct texture_image *fgl_target_image(struct context *ctx, const struct image_target *t, int level);

/* Levels that a target can have. */
int fgl_texture_levels(enum texture_target target);

/* Before an image or a parameter of the object changes: what waits is drawn with the old, what follows with the new. */
void fgl_texture_touch(struct context *ctx, struct texture_object *object);
/* The same when no more than texels change. */
void fgl_texture_touch_image(struct context *ctx, const struct texture_object *object);

/* Executes the payload of a node of glPrioritizeTextures. */
void fgl_list_replay_prioritize(struct context *ctx, const void *payload);

#endif
