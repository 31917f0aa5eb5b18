/* Pixels in buffer objects (GL_ARB_pixel_buffer_object): while one is bound to GL_PIXEL_UNPACK_BUFFER or GL_PIXEL_PACK_BUFFER, the pointers of
 * commands that read or write pixels are offsets in it. The binding is the store's: context.client.unpack, context.client.pack. */
#ifndef FGL_API_PIXEL_BUFFER_H
#define FGL_API_PIXEL_BUFFER_H

#include "framebuffer/pixel_format.h"

/* Each of these makes *pixels an address: it is one, or an offset in the store's buffer object. False after recording GL_INVALID_OPERATION: the
 * object is mapped, the pixels are not all in it, or the offset is no multiple of the type's size. To be called once the command's own errors
 * are found, and before it is recorded in a display list. */

/* An image of two dimensions, format and type checked. */
bool fgl_buffer_image(struct context *ctx, const struct pixel_store *store, GLenum format, GLenum type, int width, int height,
                      const void **pixels);
/* The same with slices. */
bool fgl_buffer_volume(struct context *ctx, const struct pixel_store *store, GLenum format, GLenum type, int width, int height, int depth,
                       const void **pixels);
/* n elements one after the other: no parameter of pixel storage applies. */
bool fgl_buffer_elements(struct context *ctx, const struct pixel_store *store, int n, int bytes, const void **pixels);

#endif
