/* Images of textures and renderbuffers as buffers to draw to (GL_ARB_framebuffer_object). Layer 5.
 *
 * Nothing is drawn into an image itself: its pixels are loaded into the planes of a framebuffer and stored when somebody else may want to
 * see them. Row 0 of an image is the bottom, that of a framebuffer the top. */
#ifndef FGL_PIPELINE_SURFACE_H
#define FGL_PIPELINE_SURFACE_H

#include "framebuffer/framebuffer.h"
#include "texture/image.h"

/* One two-dimensional slice of an image; image NULL: none. */
struct surface {
    struct texture_image *image;
    int slice;
};

/* Whether such pixels are all that the image keeps: RGB or RGBA of bytes or words. Others are read as floats, as they were rounded. */
bool fgl_surface_is_plain(const struct texture_image *image);

/* Makes *fb a framebuffer of this size, which all the surfaces have at least, and their pixels. reading: nothing will be
 * drawn to it. Returns false when memory is short. */
bool fgl_surface_load(struct framebuffer *fb, int width, int height, const struct surface *color, const struct surface *depth,
                      const struct surface *stencil, bool reading);

/* The pixels back into the surfaces, each of them rounded to its format. */
void fgl_surface_store(const struct framebuffer *fb, const struct surface *color, const struct surface *depth,
                       const struct surface *stencil);

#endif
