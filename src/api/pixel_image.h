/* Images and bitmaps of the pixel commands, given or from a display list (GL 1.5, 3.6.4, 3.7, 5.4). */
#ifndef FGL_API_PIXEL_IMAGE_H
#define FGL_API_PIXEL_IMAGE_H

#include "framebuffer/pixel_format.h"

/* The execution of glBitmap: arguments checked. `store` says how `bits` lie in memory. */
void fgl_bitmap(struct context *ctx, int width, int height, const float origin[2], const float move[2],
                const struct pixel_store *store, const void *bits);

/* The execution of glDrawPixels: arguments checked. copied: the pixels are from the framebuffer. pixel_rectangle.c */
void fgl_draw_image(struct context *ctx, int width, int height, GLenum format, GLenum type, const struct pixel_store *store,
                    const void *pixels, bool copied);
/* The error of a format that asks for a buffer which the framebuffer does not have; colours cannot be drawn in colour index mode. */
GLenum fgl_draw_buffer_error(struct context *ctx, GLenum format);

/* The execution of glDrawPixels, glPixelMap and glBitmap from the payload of a node. */
void fgl_list_replay_draw_pixels(struct context *ctx, const void *payload);
void fgl_list_replay_pixel_map(struct context *ctx, const void *payload);
void fgl_list_replay_bitmap(struct context *ctx, const void *payload);

#endif
