/* glTexImage and glTexSubImage in all their dimensions, as one call; also what a display list keeps of them. */
#ifndef FGL_API_TEXTURE_IMAGE_H
#define FGL_API_TEXTURE_IMAGE_H

#include "api/texture_target.h"
#include "texture/image.h"

struct texture_call {
    int dimensions; /* 1, 2 or 3 */
    bool sub;       /* glTexSubImage */
    GLenum target, format, type;
    int level, internal_format, border; /* the last two: of glTexImage */
    int x, y, z;                        /* of glTexSubImage */
    int width, height, depth;           /* height and depth are 1 where the command has none */
};

/* Where pixels lie: given, or in a display list. */
struct pixel_source {
    const struct pixel_store *store;
    const void *pixels;
    int width, height; /* as given: the texture's when no convolution reduces it */
};

/* The error of defining an image with this call's internal format, size, border and level (GL 1.5, 3.8.1); format and type are not looked at.
 * Sizes that are only too large set *too_large instead, which a proxy answers and anything else refuses with GL_INVALID_VALUE. */
GLenum fgl_texture_define_error(const struct texture_call *call, const struct image_target *t, bool *too_large);

/* GL_ARB_texture_storage: no level may be made anew. */
bool fgl_texture_is_immutable(const struct context *ctx, const struct image_target *t);

/* The error of a part of the image that is not inside of it, or of no image (GL 1.5, 3.8.2). */
GLenum fgl_texture_part_error(const struct texture_call *call, const struct texture_image *image);

/* Makes the image anew, without texels set, for pixels with or without swapped bytes; false after recording GL_OUT_OF_MEMORY. */
bool fgl_texture_define(struct context *ctx, const struct texture_call *call, bool swap_bytes, const struct image_target *t);

/* Texels from pixels: of the whole image, or of the part that a glTexSubImage names. texture_store.c */
void fgl_texture_store_image(struct context *ctx, const struct texture_call *call, const struct pixel_source *source,
                             struct texture_image *image);

/* After texels of a level have changed: mipmaps, if they are to follow (GL 1.5, 3.8.8 "Automatic Mipmap Generation"). */
void fgl_texture_after_change(struct context *ctx, const struct image_target *t, int level);

/* Executes the payload of a node. */
void fgl_list_replay_texture_image(struct context *ctx, const void *payload);

#endif
