/* glDrawPixels, glPixelZoom (GL 1.5, 3.6.4 "Rasterization of Pixel Rectangles"). */
#include "api/command.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "api/pixel_image.h"
#include "api/set.h"
#include "framebuffer/pixel_unpack.h"
#include "state/share.h"

GLenum fgl_draw_buffer_error(struct context *ctx, GLenum format)
{
    fgl_framebuffer_update(ctx);
    const struct framebuffer *fb = ctx->framebuffer;
    const bool both = format == GL_DEPTH_STENCIL, depth = format == GL_DEPTH_COMPONENT || both, stencil = format == GL_STENCIL_INDEX || both;
    if (ctx->color_index && format != GL_COLOR_INDEX && !depth && !stencil)
        return GL_INVALID_OPERATION;
    return fb && ((depth && !fb->depth_bits) || (stencil && !fb->stencil_bits)) ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

static GLenum draw_pixels_error(struct context *ctx, GLsizei width, GLsizei height, GLenum format,
                                GLenum type)
{
    if (width < 0 || height < 0)
        return GL_INVALID_VALUE;
    const GLenum error = fgl_pixel_check(format, type);
    return error ? error : fgl_draw_buffer_error(ctx, format);
}

struct image_node {
    int32_t width, height;
    GLenum format, type;
    uint64_t pixels[]; /* packed tightly */
};

static void record(struct context *ctx, GLsizei width, GLsizei height, GLenum format, GLenum type,
                   const GLvoid *pixels)
{
    const size_t bytes = fgl_pixel_image_bytes(&fgl_packed_store, format, type, width, height);
    struct image_node *node = fgl_list_record(ctx, OP_DRAW_PIXELS, sizeof *node + bytes);
    if (!node)
        return;
    *node = (struct image_node){width, height, format, type};
    fgl_pixel_copy(&ctx->client.unpack, format, type, width, height, pixels, node->pixels);
}

void fgl_list_replay_draw_pixels(struct context *ctx, const void *payload)
{
    const struct image_node *n = payload;
    const GLenum error = draw_pixels_error(ctx, n->width, n->height, n->format, n->type);
    RETURN_ERROR_IF(ctx, error, error);
    fgl_draw_image(ctx, n->width, n->height, n->format, n->type, &fgl_packed_store, n->pixels, false);
}

static void draw_pixels(struct context *ctx, GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid *pixels)
{
    const GLenum error = draw_pixels_error(ctx, width, height, format, type);
    if (error) {
        fgl_command_error(ctx, error);
        return;
    }
    if (!fgl_buffer_image(ctx, &ctx->client.unpack, format, type, width, height, &pixels))
        return;
    if (ctx->compiling)
        record(ctx, width, height, format, type, pixels);
    if (ctx->compiling != GL_COMPILE)
        fgl_draw_image(ctx, width, height, format, type, &ctx->client.unpack, pixels, false);
}

void GLAPIENTRY glDrawPixels(GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid *pixels)
{
    struct context *ctx = fgl_current;
    if (ctx && !fgl_refused_inside(ctx))
        FGL_SHARED(ctx, draw_pixels(ctx, width, height, format, type, pixels));
}

void fgl_exec_PixelZoom(struct context *ctx, GLfloat xfactor, GLfloat yfactor)
{
    SET(ctx, 0, ctx->s.pixel_mode.zoom_x, xfactor);
    SET(ctx, 0, ctx->s.pixel_mode.zoom_y, yfactor);
}
