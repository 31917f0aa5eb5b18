/* Texture objects and their images (GL 1.5, 3.8 "Texturing"). Layer 2.
 *
 * An image holds what OSMesa would hold: texels are quantised to their internal format when they come, and kept expanded to RGBA, ready to
 * be sampled. OSMesa rule: the texels of a border are dropped, and what is left is an image without border. */
#ifndef FGL_TEXTURE_TEXTURE_H
#define FGL_TEXTURE_TEXTURE_H

#include "base/idmap.h"
#include "state/context.h"

#include <stdatomic.h>

enum { TEXTURE_MAX_FACES = 6 }; /* of a cube map: +x, -x, +y, -y, +z, -z; other targets have one */

/* How texels are kept. Row 0 is t = 0; rows and slices follow one another without gaps. */
enum texel_kind {
    TEXELS_UNORM8, /* uint8_t[4]: formats of at most 8 bits a channel, each expanded to 8 bits by repeating its bits */
    TEXELS_FLOAT,  /* float[4]: formats of more bits, or other encodings, after quantisation */
    TEXELS_DEPTH   /* float: depth after quantisation */
};

/* Texels are RGBA by base format: GL_LUMINANCE -> LLL1, GL_ALPHA -> 000A, GL_INTENSITY -> IIII, GL_LUMINANCE_ALPHA -> LLLA,
 * GL_RED -> R001, GL_RG -> RG01, GL_RGB -> RGB1. */
struct texture_image {
    int width, height, depth; /* texels */
    GLenum internal_format;   /* as given; of a generic compressed format, its base format */
    const struct texture_format *format; /* texture/format.h; its base_format is the texels' */
    enum texel_kind kind;
    void *texels; /* NULL: no image, or one without texels */
    uint8_t *stencil; /* of GL_DEPTH_STENCIL, one for each texel; NULL: no stencil */
};

struct texture_object {
    unsigned name;
    enum texture_target target;
    struct texture_parameters parameters;
    struct texture_image image[TEXTURE_MAX_FACES][FGL_MAX_TEXTURE_LEVELS]; /* [face][level] */
    int immutable_levels; /* GL_ARB_texture_storage: how many; 0: not immutable */
    bool complete[2], complete_known[2]; /* fgl_texture_complete's answers, [mipmapped], until something changes */
    atomic_int references;         /* the store's and one for each binding */
};

/* GL_ARB_sampler_objects: how a unit samples, in place of what its texture says. */
struct sampler_object {
    unsigned name;
    struct texture_parameters parameters; /* those that GL_ARB_sampler_objects names */
    atomic_int references; /* the store's and one for each binding */
};

/* Texture objects by name, shared by contexts. A name that glGenTextures gave and nobody has bound yet stands for fgl_texture_unbound. */
struct texture_store {
    atomic_int references;
    struct idmap map;
    struct texture_object *default_object[TEXTURE_TARGETS]; /* name 0. OSMesa rule: shared, too */
};

extern struct texture_object fgl_texture_unbound;

static inline size_t fgl_texel_bytes(enum texel_kind kind)
{
    return kind == TEXELS_FLOAT ? 4 * sizeof(float) : 4;
}

static inline int fgl_texture_faces(enum texture_target target)
{
    return target == TEXTURE_CUBE_MAP ? TEXTURE_MAX_FACES : 1;
}

struct texture_store *fgl_texture_store_create(void); /* NULL: memory is short */
void fgl_texture_store_retain(struct texture_store *store);
void fgl_texture_store_release(struct texture_store *store);

/* The object of a name, made at the first call (GL 1.5, 3.8.11 "Texture Objects"); name 0: the default object. NULL: memory is short. */
struct texture_object *fgl_texture_lookup(struct texture_store *store, unsigned name, enum texture_target target);

/* Binds every unit's targets to the default objects of ctx->textures and makes the proxies; and gives all of it back. */
bool fgl_texture_context_init(struct context *ctx);
void fgl_texture_context_free(struct context *ctx);
/* Puts an object in the place of the one that is bound. */
void fgl_texture_bind(struct texture_object **bound, struct texture_object *object);
void fgl_texture_release(struct texture_object *object);
/* What table 6.15 says of a new object. */
void fgl_texture_init_parameters(struct texture_parameters *p);
/* Puts a sampler object, or none, in the place of the one that is bound. */
void fgl_sampler_bind(struct sampler_object **bound, struct sampler_object *object);
void fgl_sampler_release(struct sampler_object *object);

/* To be called whenever an image or a parameter of the object changed. */
static inline void fgl_texture_changed(struct texture_object *object)
{
    object->complete_known[0] = object->complete_known[1] = false;
}

/* The base and the last level that the parameters allow. GL_ARB_texture_storage: of an immutable texture, within its levels. */
static inline int fgl_texture_base_level(const struct texture_object *object)
{
    const int base = object->parameters.base_level, levels = object->immutable_levels;
    return levels ? fgl_min(base, levels - 1) : base;
}
static inline int fgl_texture_max_level(const struct texture_object *object)
{
    const int max = object->parameters.max_level, levels = object->immutable_levels;
    return levels ? fgl_max(fgl_texture_base_level(object), fgl_min(max, levels - 1)) : max;
}

/* Whether the object can be drawn with, by filters that mipmap or others (GL 1.5, 3.8.10 "Texture Completeness"). */
bool fgl_texture_complete(struct texture_object *object, bool mipmapped);

/* The parameters by which a unit samples an object: filters, wrap modes, border, levels of detail, comparison. */
static inline const struct texture_parameters *fgl_texture_sampling(const struct texture_unit *unit, const struct texture_object *object)
{
    return unit->sampler ? &unit->sampler->parameters : &object->parameters;
}

/* The texture that a unit draws with. OSMesa rule: of the targets that are enabled and complete the one of highest precedence; NULL: none. */
struct texture_object *fgl_texture_current(const struct texture_unit *unit);

/* The last level that mipmapping filters use: q of 3.8.8. The object is complete for filters that mipmap. */
int fgl_texture_last_level(const struct texture_object *object);

#endif
