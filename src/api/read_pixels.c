/* glReadPixels (GL 1.5, 4.3.2 "Reading Pixels"). */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/pixel_buffer.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_pack.h"

#include <stdlib.h>

/* Whether the framebuffer has what the format asks for. */
static bool buffer_exists(const struct context *ctx, GLenum format)
{
    const struct framebuffer *fb = ctx->read_framebuffer;
    switch (format) {
    case GL_DEPTH_COMPONENT: return fb->depth_bits > 0;
    case GL_STENCIL_INDEX: return fb->stencil_bits > 0;
    case GL_DEPTH_STENCIL: return fb->depth_bits > 0 && fb->stencil_bits > 0;
    case GL_COLOR_INDEX: return ctx->color_index && fgl_framebuffer_reads_color(ctx);
    default: return fgl_framebuffer_reads_color(ctx);
    }
}

/* Colours that imaging stages may change or discard: the whole rectangle, or what convolution leaves of it. */
static void read_imaged(struct context *ctx, int x, int y, int width, int height, GLenum format, GLenum type,
                        const void *pixels)
{
    struct color_image image;
    int left_width = width, left_height = height;
    fgl_convolved_size(ctx, 2, &left_width, &left_height);
    if (!fgl_buffer_image(ctx, &ctx->client.pack, format, type, left_width, left_height, &pixels))
        return;
    RETURN_ERROR_IF(ctx, !fgl_imaging_fetch(ctx, x, y, width, height, 2, &image), GL_OUT_OF_MEMORY);
    const struct pixel_pack pack = {.image = fgl_pixel_image(&ctx->client.pack, format, type, image.width, pixels)};
    const float *from = image.color;
    struct color_row colors;
    for (int row = 0; row < image.height; row++)
        for (int column = 0; column < image.width; column += PIXEL_CHUNK) {
            const int n = fgl_min(PIXEL_CHUNK, image.width - column);
            for (int i = 0; i < n; i++, from += 4)
                for (int c = 0; c < 4; c++)
                    colors.channel[c][i] = from[c];
            fgl_pack_transferred(&pack, &colors, n, row, column);
        }
    free(image.color);
}

/* Pixels outside the framebuffer are undefined: their memory stays as it was. */
void fgl_exec_ReadPixels(struct context *ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, GLvoid *pixels)
{
    RETURN_ERROR_IF(ctx, width < 0 || height < 0, GL_INVALID_VALUE);
    const GLenum error = fgl_pixel_check(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    fgl_flush_vertices(ctx, 0);
    if (ctx->dirty & DIRTY_MODELVIEW) /* OSMesa rule: reading validates, and validation classifies the matrix */
        (void)fgl_matrix_class(fgl_matrix_top(&ctx->modelview));
    if (!fgl_read_ready(ctx))
        return;
    const struct framebuffer *fb = ctx->read_framebuffer;
    RETURN_ERROR_IF(ctx, !fb || !buffer_exists(ctx, format), GL_INVALID_OPERATION);

    if (fgl_pixel_format(format)->channel[0] <= CHANNEL_LUMINANCE && fgl_imaging_active(ctx)) {
        read_imaged(ctx, x, y, width, height, format, type, pixels);
        return;
    }

    const void *to = pixels;
    if (!fgl_buffer_image(ctx, &ctx->client.pack, format, type, width, height, &to))
        return;
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&ctx->client.pack, format, type, width, to),
            .mode = &ctx->s.pixel_mode,
            .maps = ctx->pixel_map,
            .clamps = true, /* OSMesa rule */
    };
    const int64_t right = (int64_t)x + width, top = (int64_t)y + height;
    const int x0 = fgl_max(x, 0), x1 = right < fb->width ? (int)right : fb->width;
    const int y0 = fgl_max(y, 0), y1 = top < fb->height ? (int)top : fb->height;
    for (int row = y0; x0 < x1 && row < y1; row++)
        fgl_pack_row(&pack, fb, x0, fgl_row(fb, row), x1 - x0, row - y, x0 - x);
}
