/* glCopyPixels (GL 1.5, 4.3.3 "Copying Pixels"): read as the buffer stores it, then drawn. */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/pixel_image.h"
#include "framebuffer/pixel_pack.h"
#include "framebuffer/pixel_unpack.h"
#include "pipeline/feedback.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static GLenum copied_format(const struct context *ctx, GLenum type)
{
    if (type == GL_COLOR)
        return ctx->color_index ? GL_COLOR_INDEX : GL_RGBA;
    return type == GL_DEPTH ? GL_DEPTH_COMPONENT : type == GL_STENCIL ? GL_STENCIL_INDEX : GL_DEPTH_STENCIL;
}

static GLenum copied_type(const struct framebuffer *fb, GLenum type)
{
    if (type == GL_STENCIL)
        return GL_UNSIGNED_BYTE;
    if (type == GL_DEPTH)
        return GL_UNSIGNED_INT;
    if (type == GL_DEPTH_STENCIL)
        return GL_UNSIGNED_INT_24_8;
    return fb->color_kind == COLOR_FLOAT     ? GL_FLOAT
           : fb->color_kind == COLOR_UNORM16 ? GL_UNSIGNED_SHORT
                                             : GL_UNSIGNED_BYTE;
}

/* Of one rectangle: sizes that are mistakes do not fill the machine's memory first. */
enum { MAX_BYTES = 1 << 30 };

/* The rectangle into new memory; what lies outside of the framebuffer is 0. NULL when memory is short. */
static void *read_rectangle(const struct context *ctx, int x, int y, int width, int height, GLenum format,
                            GLenum type)
{
    const struct framebuffer *fb = ctx->read_framebuffer;
    const size_t bytes = fgl_pixel_image_bytes(&fgl_packed_store, format, type, width, height);
    void *pixels = bytes <= MAX_BYTES ? calloc(1, bytes) : NULL;
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, format, type, width, pixels),
            .mode = &fgl_no_transfer,
            .maps = ctx->pixel_map,
    };
    const int64_t right = (int64_t)x + width, top = (int64_t)y + height;
    const int x0 = fgl_max(x, 0), x1 = right < fb->width ? (int)right : fb->width;
    for (int64_t row = fgl_max(y, 0); pixels && x0 < x1 && row < top && row < fb->height; row++)
        fgl_pack_row(&pack, fb, x0, fgl_row(fb, (int)row), x1 - x0, (int)(row - y), x0 - x);
    return pixels;
}

/* The depths of a rectangle to floats, in place. OSMesa rule: they pass through a texture of the buffer's
 * steps, and each way multiplies by the reciprocal of the greatest depth, which may end a step beside; depths of 24 bits
 * without a stencil pass through clip space in place of the second. */
static void copied_depths(const struct framebuffer *fb, uint32_t *depth, size_t n)
{
    const float max = (float)fb->depth_max, step = 1.0f / max;
    const bool clipped = fb->depth_bits == 24 && !fb->stencil_bits;
    for (size_t i = 0; i < n; i++) {
        const float in_texture = (float)(depth[i] >> (32 - fb->depth_bits)) * step, clip_z = in_texture * 2.0f - 1.0f;
        const float shown = clipped ? clip_z * 0.5f + 0.5f : rintf(in_texture * max) * step;
        memcpy(&depth[i], &shown, sizeof shown);
    }
}

static bool lacks_buffer(const struct framebuffer *fb, GLenum type)
{
    const bool depth = type == GL_DEPTH || type == GL_DEPTH_STENCIL, stencil = type == GL_STENCIL || type == GL_DEPTH_STENCIL;
    return (depth && !fb->depth) || (stencil && !fb->stencil_bits);
}

void fgl_exec_CopyPixels(struct context *ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type)
{
    RETURN_ERROR_IF(ctx, width < 0 || height < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, type != GL_COLOR && type != GL_DEPTH && type != GL_STENCIL && type != GL_DEPTH_STENCIL, GL_INVALID_ENUM);
    const GLenum format = copied_format(ctx, type);
    RETURN_ERROR_IF(ctx, fgl_draw_buffer_error(ctx, format), GL_INVALID_OPERATION);
    if (!fgl_draw_ready(ctx) || !fgl_read_ready(ctx))
        return;
    RETURN_ERROR_IF(ctx, type == GL_COLOR && !fgl_framebuffer_reads_color(ctx), GL_INVALID_OPERATION);
    const struct framebuffer *from = ctx->read_framebuffer;
    RETURN_ERROR_IF(ctx, from && lacks_buffer(from, type), GL_INVALID_OPERATION);
    fgl_flush_vertices(ctx, 0);
    if (!ctx->framebuffer || !ctx->read_framebuffer || !ctx->s.current.raster_position_valid || width == 0 || height == 0)
        return;
    fgl_feedback_raster_position(ctx, GL_COPY_PIXEL_TOKEN);
    if (ctx->render_mode != GL_RENDER)
        return;
    const GLenum component = copied_type(ctx->read_framebuffer, type);
    void *pixels = read_rectangle(ctx, x, y, width, height, format, component);
    RETURN_ERROR_IF(ctx, !pixels, GL_OUT_OF_MEMORY);
    if (type == GL_DEPTH)
        copied_depths(ctx->read_framebuffer, pixels, (size_t)width * (size_t)height);
    fgl_draw_image(ctx, width, height, format, type == GL_DEPTH ? GL_FLOAT : component, &fgl_packed_store, pixels,
               true);
    free(pixels);
}
