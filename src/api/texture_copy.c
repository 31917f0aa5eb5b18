/* glCopyTexImage, glCopyTexSubImage (GL 1.5, 3.8.2 "Alternate Texture Image Specification Commands"): the framebuffer's
 * pixels, through pixel transfer. */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/texture_image.h"
#include "base/unorm.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_pack.h"
#include "framebuffer/pixel_unpack.h"

#include <stdlib.h>

/* A rectangle of the framebuffer: window coordinates, y up. */
struct source_rect {
    int x, y, width, height;
};

enum { FAR = 1 << 24 };

/* Where no framebuffer reaches one place is as good as another: at this one nothing overflows. */
static int nearest_place(int coordinate)
{
    return fgl_max(-FAR, fgl_min(coordinate, FAR));
}

static GLenum source_error(const struct context *ctx, GLenum internal_format)
{
    const struct framebuffer *fb = ctx->read_framebuffer;
    const struct texture_format *f = fgl_texture_format(internal_format);
    const bool depth = f && f->kind == TEXELS_DEPTH;
    if (!fb || (depth ? !fb->depth_bits : !fgl_framebuffer_reads_color(ctx)))
        return GL_INVALID_OPERATION;
    if (f && f->base_format == GL_DEPTH_STENCIL && !fb->stencil_bits)
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

static void copy_stencil(struct context *ctx, uint8_t *to, int x, int y, int n)
{
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, n, to),
            .mode = &ctx->s.pixel_mode,
            .maps = ctx->pixel_map,
    };
    fgl_pack_row(&pack, ctx->read_framebuffer, x, y, n, 0, 0);
}

/* n depths of the framebuffer to texels. Row y counts from the top. */
static void copy_depths(struct context *ctx, struct texture_image *image, int x, int y, int n, int to_x, int to_y, int to_z)
{
    uint32_t depth[PIXEL_CHUNK] = {0};
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, n, depth),
            .mode = &ctx->s.pixel_mode,
            .maps = ctx->pixel_map,
    };
    fgl_pack_row(&pack, ctx->read_framebuffer, x, y, n, 0, 0);
    const int have = ctx->read_framebuffer->depth_bits, bits = image->format->bits[0];
    const float max = (float)fgl_unorm_max(bits);
    for (int i = 0; i < n; i++) { /* OSMesa rule: through a float, as if drawn */
        const float f = fgl_clamp01(fgl_unorm_to_float(depth[i] >> (32 - have), have));
        depth[i] = bits == 24 ? (uint32_t)(f * max) : (uint32_t)((double)f * (double)fgl_unorm_max(bits) + 0.5);
    }
    fgl_texture_store_depth(image, to_x, to_y, to_z, n, depth);
    if (image->stencil)
        copy_stencil(ctx, image->stencil + fgl_texel_index(image, to_x, to_y, to_z), x, y, n);
}

static bool is_ten_bits(const struct texture_format *format)
{
    return format->bits[0] == 10;
}

/* The same with colours. OSMesa rule: bytes become 10 bits by repeating theirs. */
static void copy_colors(struct context *ctx, struct texture_image *image, int x, int y, int n, int to_x, int to_y, int to_z)
{
    float pixel[4 * PIXEL_CHUNK] = {0}, plane[4][PIXEL_CHUNK];
    const float *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, GL_RGBA, GL_FLOAT, n, pixel),
            .mode = &ctx->s.pixel_mode,
            .maps = ctx->pixel_map,
    };
    fgl_pack_row(&pack, ctx->read_framebuffer, x, y, n, 0, 0);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            plane[c][i] = pixel[4 * i + c];
    fgl_texture_store_color(image, to_x, to_y, to_z, n, planes,
                            is_ten_bits(image->format) ? ROUND_THROUGH_BYTES : ROUND_DRAWN);
}

/* Whether bytes of the framebuffer are texels as they stand: through floats and back, each is itself. */
static bool copies_bytes(const struct context *ctx, const struct texture_image *image)
{
    return ctx->read_framebuffer->color_kind == COLOR_UNORM8 && fgl_texture_format_keeps_bytes(image->format) &&
           !fgl_transfer_color_active(&ctx->s.pixel_mode);
}

static void copy_bytes(struct context *ctx, struct texture_image *image, int x, int y, int n, int to_x, int to_y, int to_z)
{
    const struct framebuffer *fb = ctx->read_framebuffer;
    const uint32_t *pixels = (const uint32_t *)fb->color + (ptrdiff_t)y * fb->stride + x;
    const uint32_t low = 1;
    const int flip = *(const uint8_t *)&low ? 0 : 3; /* red is the low byte */
    const int place[4] = {0 ^ flip, 1 ^ flip, 2 ^ flip, fb->has_alpha ? 3 ^ flip : -1};
    fgl_texture_store_bytes(image, to_x, to_y, to_z, n, (const uint8_t *)pixels, sizeof *pixels, place);
}

/* What lies outside of the framebuffer is undefined: its texels stay as they are. */
static void copy(struct context *ctx, struct texture_image *image, struct source_rect from, int to_x, int to_y, int to_z)
{
    const struct framebuffer *fb = ctx->read_framebuffer;
    const int x0 = fgl_max(from.x, 0), x1 = fgl_min(from.x + from.width, fb->width);
    const int y0 = fgl_max(from.y, 0), y1 = fgl_min(from.y + from.height, fb->height);
    void (*const run)(struct context *, struct texture_image *, int, int, int, int, int, int) =
            image->kind == TEXELS_DEPTH ? copy_depths : copies_bytes(ctx, image) ? copy_bytes : copy_colors;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x += PIXEL_CHUNK)
            run(ctx, image, x, fgl_row(fb, y), fgl_min(PIXEL_CHUNK, x1 - x), to_x + x - from.x, to_y + y - from.y,
                to_z);
}

/* ---- through the imaging stages ---- */

static void copy_image_row(struct texture_image *image, const float *from, int n, int to_x, int to_y, int to_z)
{
    float plane[4][PIXEL_CHUNK];
    const float *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    for (int x = 0; x < n; x += PIXEL_CHUNK) {
        const int count = fgl_min(PIXEL_CHUNK, n - x);
        for (int i = 0; i < count; i++, from += 4)
            for (int c = 0; c < 4; c++)
                plane[c][i] = from[c];
        fgl_texture_store_color(image, to_x + x, to_y, to_z, count, planes, ROUND_GIVEN);
    }
}

/* `from` is the whole rectangle, of whose result the border is left out. A sink leaves nothing. */
static void copy_imaged(struct context *ctx, struct texture_image *image, const struct texture_call *call, struct source_rect from)
{
    const int border = call->border, border_y = call->dimensions > 1 ? border : 0, width = call->width - 2 * border;
    struct color_image pixels;
    RETURN_ERROR_IF(ctx, !fgl_imaging_fetch(ctx, from.x, from.y, from.width, from.height, fgl_min(call->dimensions, 2), &pixels),
                    GL_OUT_OF_MEMORY);
    for (int y = border_y; y < pixels.height - border_y; y++)
        copy_image_row(image, pixels.color + 4 * ((size_t)y * (size_t)pixels.width + (size_t)border), width, call->x,
                       call->y + y - border_y, call->z);
    free(pixels.color);
}

/* The sizes that convolution leaves of a rectangle of colours (GL 1.5, 3.6.5). */
static void reduce(struct context *ctx, struct texture_call *call, GLenum internal_format)
{
    const struct texture_format *f = fgl_texture_format(internal_format);
    if (f && f->kind != TEXELS_DEPTH)
        fgl_convolved_size(ctx, fgl_min(call->dimensions, 2), &call->width, &call->height);
}

static bool is_imaged(const struct context *ctx, const struct texture_image *image)
{
    return image->kind != TEXELS_DEPTH && fgl_imaging_active(ctx);
}

/* ---- commands ---- */

/* GL 1.5, 3.8.2: the formats of glTexImage but 1, 2, 3 and 4. */
static void copy_image(struct context *ctx, struct texture_call *call, int x, int y)
{
    struct image_target t;
    bool too_large;
    const GLenum format = (GLenum)call->internal_format;
    x = nearest_place(x);
    y = nearest_place(y);
    const struct source_rect from = {x, y, call->width, call->height};
    reduce(ctx, call, format);
    RETURN_ERROR_IF(ctx, !fgl_image_target(call->target, call->dimensions, &t) || t.proxy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, format <= 4 || !fgl_texture_format(format), GL_INVALID_ENUM);
    GLenum error = fgl_texture_define_error(call, &t, &too_large);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, fgl_texture_is_immutable(ctx, &t), GL_INVALID_OPERATION);
    if (!fgl_read_ready(ctx))
        return;
    error = source_error(ctx, format);
    RETURN_ERROR_IF(ctx, error, error);
    fgl_flush_vertices(ctx, 0);
    if (!fgl_texture_define(ctx, call, false, &t))
        return;
    const int border = call->border, border_y = call->dimensions > 1 ? border : 0;
    struct texture_image *image = fgl_target_image(ctx, &t, call->level);
    if (is_imaged(ctx, image))
        copy_imaged(ctx, image, call, from);
    else
        copy(ctx, image, (struct source_rect){x + border, y + border_y, call->width - 2 * border, call->height - 2 * border_y}, 0, 0, 0);
    fgl_texture_after_change(ctx, &t, call->level);
}

static void copy_sub_image(struct context *ctx, struct texture_call *call, int x, int y)
{
    struct image_target t;
    const struct source_rect from = {nearest_place(x), nearest_place(y), call->width, call->height};
    RETURN_ERROR_IF(ctx, !fgl_image_target(call->target, call->dimensions, &t) || t.proxy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, call->level < 0 || call->level >= fgl_texture_levels(t.target), GL_INVALID_VALUE);
    struct texture_image *image = fgl_target_image(ctx, &t, call->level);
    reduce(ctx, call, image->internal_format);
    GLenum error = fgl_texture_part_error(call, image);
    RETURN_ERROR_IF(ctx, error, error);
    if (!fgl_read_ready(ctx))
        return;
    error = source_error(ctx, image->internal_format);
    RETURN_ERROR_IF(ctx, error, error);
    fgl_texture_touch_image(ctx, fgl_bound_texture(ctx, t.target));
    if (is_imaged(ctx, image))
        copy_imaged(ctx, image, call, from);
    else
        copy(ctx, image, from, call->x, call->y, call->z);
    fgl_texture_after_change(ctx, &t, call->level);
}

void fgl_exec_CopyTexImage1D(struct context *ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                             GLsizei width, GLint border)
{
    struct texture_call call = {.dimensions = 1, .target = target, .level = level,
                                      .internal_format = (int)internalformat, .border = border, .width = width,
                                      .height = 1, .depth = 1};
    copy_image(ctx, &call, x, y);
}

void fgl_exec_CopyTexImage2D(struct context *ctx, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                             GLsizei width, GLsizei height, GLint border)
{
    struct texture_call call = {.dimensions = 2, .target = target, .level = level,
                                      .internal_format = (int)internalformat, .border = border, .width = width,
                                      .height = height, .depth = 1};
    copy_image(ctx, &call, x, y);
}

void fgl_exec_CopyTexSubImage1D(struct context *ctx, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                                GLsizei width)
{
    struct texture_call call = {.dimensions = 1, .target = target, .level = level, .x = xoffset, .width = width,
                                      .height = 1, .depth = 1};
    copy_sub_image(ctx, &call, x, y);
}

void fgl_exec_CopyTexSubImage2D(struct context *ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                                GLint y, GLsizei width, GLsizei height)
{
    struct texture_call call = {.dimensions = 2, .target = target, .level = level, .x = xoffset, .y = yoffset,
                                      .width = width, .height = height, .depth = 1};
    copy_sub_image(ctx, &call, x, y);
}

void fgl_exec_CopyTexSubImage3D(struct context *ctx, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height)
{
    struct texture_call call = {.dimensions = 3, .target = target, .level = level, .x = xoffset, .y = yoffset,
                                      .z = zoffset, .width = width, .height = height, .depth = 1};
    copy_sub_image(ctx, &call, x, y);
}
