/* Renderbuffers (GL_ARB_framebuffer_object, "Renderbuffer Objects"): images without a texture, shared between contexts as textures are. */
#ifndef FGL_API_RENDERBUFFER_H
#define FGL_API_RENDERBUFFER_H

#include "texture/image.h"

struct renderbuffer {
    atomic_int references; /* the store's and one for each binding and attachment */
    GLuint name;
    bool created; /* bound once; until then only its name is taken */
    GLenum internal_format; /* as given */
    int samples; /* as given: 0 or 1 */
    struct texture_image image;
};

struct renderbuffer_store *fgl_renderbuffer_store_create(void);
void fgl_renderbuffer_store_retain(struct renderbuffer_store *store);
void fgl_renderbuffer_store_release(struct renderbuffer_store *store);

/* Makes *slot refer to the renderbuffer, or to none, in place of what it referred to. */
void fgl_renderbuffer_refer(struct renderbuffer **slot, struct renderbuffer *r);

/* The object of a name that was bound; NULL: none. */
struct renderbuffer *fgl_renderbuffer_lookup(const struct context *ctx, GLuint name);

/* Bits of red, green, blue or alpha (0 to 3) that an image has. OSMesa rule: luminance and intensity are none. */
int fgl_image_color_bits(const struct texture_image *image, int channel);

#endif
