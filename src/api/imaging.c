/* What the commands of the imaging subset share: formats, images in and out, display lists (GL 1.5, 3.6.3, 5.4, 6.1.7). */
#include "api/imaging.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "framebuffer/pixel_pack.h"
#include "state/share.h"
#include "texture/format.h"

#include <stdlib.h>
#include <string.h>

/* ---- formats ---- */

bool fgl_imaging_format(GLenum internal_format, int width, struct imaging_format *out)
{
    const struct texture_format *f = fgl_texture_format(internal_format);
    if (!f || internal_format <= 4 || f->kind == TEXELS_DEPTH || fgl_texture_format_compressed(f))
        return false;
    *out = (struct imaging_format){internal_format, f->base_format, width};
    return true;
}

GLenum fgl_imaging_pixels_error(GLenum format, GLenum type)
{
    const GLenum error = fgl_pixel_check(format, type);
    if (error)
        return error;
    return fgl_pixel_format(format)->channel[0] <= CHANNEL_LUMINANCE ? GL_NO_ERROR : GL_INVALID_ENUM;
}

GLenum fgl_imaging_source_error(struct context *ctx, const struct imaging_call *call)
{
    if (!call->copy)
        return fgl_imaging_pixels_error(call->format, call->type);
    if (!fgl_read_ready(ctx))
        return GL_INVALID_FRAMEBUFFER_OPERATION;
    return ctx->read_framebuffer && fgl_framebuffer_reads_color(ctx) ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

int fgl_imaging_size(const struct imaging_format *format, unsigned component)
{
    const GLenum base = format->base_format;
    const bool luminance = base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA;
    const bool present = component == 4   ? luminance
                         : component == 5 ? base == GL_INTENSITY
                                          : fgl_imaging_has(base, (int)component) && (component == 3 || base == GL_RGB || base == GL_RGBA);
    return present && format->width ? 32 : 0;
}

/* ---- images in ---- */

static bool read_colors(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels, int which, int width,
                        int height, struct color_image *out)
{
    if (call->copy) {
        fgl_flush_vertices(ctx, 0);
        return fgl_colors_fetch(ctx->read_framebuffer, &fgl_no_transfer, ctx->pixel_map, call->x, call->y, width, height, out);
    }
    if (!pixels->image[which]) {
        const size_t n = (size_t)width * (size_t)height;
        *out = (struct color_image){width, height, calloc(n ? n : 1, 4 * sizeof(float))};
        return out->color != NULL;
    }
    const struct pixel_unpack unpack = {
            .image = fgl_pixel_image(pixels->store, call->format, call->type, width, pixels->image[which]),
            .mode = &fgl_no_transfer,
            .maps = ctx->pixel_map,
    };
    return fgl_colors_unpack(&unpack, width, height, out);
}

bool fgl_imaging_colors(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels, int which, int width,
                        int height, const struct scale_bias *transform, struct color_image *out)
{
    if (!read_colors(ctx, call, pixels, which, width, height, out)) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    for (size_t i = 0; i < 4 * (size_t)width * (size_t)height; i++)
        out->color[i] = out->color[i] * transform->scale[i % 4] + transform->bias[i % 4];
    return true;
}

/* ---- images out ---- */

bool fgl_imaging_return(struct context *ctx, GLenum base_format, GLenum format, GLenum type, const float *const value[4], int width,
                        int height, void *pixels)
{
    const void *to = pixels;
    if (!fgl_buffer_image(ctx, &ctx->client.pack, format, type, width, height, &to))
        return false;
    const struct pixel_pack pack = {.image = fgl_pixel_image(&ctx->client.pack, format, type, width, to)};
    struct fetched_row row = {.bits = 0};
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x += PIXEL_CHUNK) {
            const int n = fgl_min(PIXEL_CHUNK, width - x);
            row.bits = 0;
            for (int c = 0; c < 4; c++)
                for (int i = 0; i < n; i++)
                    row.color.channel[c][i] = fgl_imaging_has(base_format, c) ? value[c][y * width + x + i] : 0.0f;
            fgl_pack_colors(&pack, &row, true, n, y, x);
        }
    return true;
}

/* ---- display lists ---- */

struct imaging_node {
    struct imaging_call call;
    uint32_t offset[2]; /* of each image in `pixels`, bytes */
    bool has_image[2];
    uint64_t pixels[]; /* packed tightly */
};

static bool is_proxy(const struct imaging_call *call)
{
    return call->target >= GL_PROXY_COLOR_TABLE && call->target <= GL_PROXY_POST_COLOR_MATRIX_COLOR_TABLE;
}

/* Bytes of an image when packed; 0 when there is none, or the call will only raise an error. */
static size_t image_bytes(const struct imaging_call *call, const void *image, int width, int height)
{
    if (!image || call->copy || fgl_imaging_pixels_error(call->format, call->type) || width < 0 || width > FGL_MAX_COLOR_TABLE ||
        height < 0 || height > FGL_MAX_CONVOLUTION)
        return 0;
    return FGL_ALIGN8(fgl_pixel_image_bytes(&fgl_packed_store, call->format, call->type, width, height));
}

static void record(struct context *ctx, const struct imaging_call *call, const void *const image[2])
{
    const bool separable = call->image == IMAGE_FILTER_SEPARABLE;
    const int width[2] = {call->width, call->height}, height[2] = {separable ? 1 : call->height, 1};
    const size_t bytes[2] = {image_bytes(call, image[0], width[0], height[0]), image_bytes(call, image[1], width[1], height[1])};
    struct imaging_node *node = fgl_list_record(ctx, OP_IMAGING_IMAGE, sizeof *node + bytes[0] + bytes[1]);
    if (!node)
        return;
    *node = (struct imaging_node){*call, {0, (uint32_t)bytes[0]}, {bytes[0] > 0, bytes[1] > 0}};
    for (int i = 0; i < 2; i++)
        if (bytes[i])
            fgl_pixel_copy(&ctx->client.unpack, call->format, call->type, width[i], height[i], image[i],
                           (char *)node->pixels + node->offset[i]);
}

static void execute(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels)
{
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    if (call->image <= IMAGE_COLOR_SUB_TABLE)
        fgl_color_table_execute(ctx, call, pixels);
    else
        fgl_filter_execute(ctx, call, pixels);
}

void fgl_list_replay_imaging(struct context *ctx, const void *payload)
{
    const struct imaging_node *node = payload;
    struct imaging_pixels pixels = {.store = &fgl_packed_store};
    for (int i = 0; i < 2; i++)
        pixels.image[i] = node->has_image[i] ? (const char *)node->pixels + node->offset[i] : NULL;
    execute(ctx, &node->call, &pixels);
}

/* Images in a buffer object. A call that raises another error, or reads no image, is left to raise it. */
static bool find_images(struct context *ctx, const struct imaging_call *call, const void *images[2])
{
    const struct pixel_store *store = &ctx->client.unpack;
    const bool separable = call->image == IMAGE_FILTER_SEPARABLE;
    if (call->copy || is_proxy(call) || call->width < 0 || call->height < 0 || fgl_imaging_pixels_error(call->format, call->type))
        return true;
    return fgl_buffer_image(ctx, store, call->format, call->type, call->width, separable ? 1 : call->height, &images[0]) &&
           (!separable || fgl_buffer_image(ctx, store, call->format, call->type, call->height, 1, &images[1]));
}

static void record_and_execute(struct context *ctx, const struct imaging_call *call, const void *image, const void *column)
{
    const void *images[2] = {image, column};
    if (!find_images(ctx, call, images))
        return;
    if (ctx->compiling && !is_proxy(call))
        record(ctx, call, images);
    if (ctx->compiling == GL_COMPILE && !is_proxy(call))
        return;
    const struct imaging_pixels pixels = {&ctx->client.unpack, {images[0], images[1]}};
    execute(ctx, call, &pixels);
}

void fgl_imaging_command(const struct imaging_call *call, const void *image, const void *column)
{
    struct context *ctx = fgl_current;
    if (ctx && !fgl_refused_inside(ctx))
        FGL_SHARED(ctx, record_and_execute(ctx, call, image, column));
}
