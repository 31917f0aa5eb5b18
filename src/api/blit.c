/* glBlitFramebuffer (GL_ARB_framebuffer_object, GL_EXT_framebuffer_blit): pixels from the read to the draw framebuffer, scaled and turned
 * over as the corners of the two rectangles say. The scissor test alone applies. */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "framebuffer/pixel_pack.h"
#include "framebuffer/pixel_unpack.h"
#include "raster/raster.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where a column, or a row, comes from. */
struct sample {
    int at[2];      /* the neighbours, at[1] only for GL_LINEAR; at[0] < 0: outside of the source, not written */
    float fraction; /* of the way from at[0] to at[1] */
    int weight;     /* the same in 256ths, where colours are bytes */
};

/* One direction: window coordinates, y up. */
struct axis {
    int first, end; /* destinations to be written */
    struct sample *sample; /* of each */
};

/* The centre of pixel i of the destination [d0,d1] in the source [s0,s1]. OSMesa rule: rounded to 256ths where colours are bytes. */
static struct sample sample_of(int i, int d0, int d1, int s0, int s1, int size, bool linear, bool bytes)
{
    double u = (double)s0 + (i + 0.5 - d0) * ((double)s1 - s0) / ((double)d1 - d0);
    if (!(u >= 0 && u < size))
        return (struct sample){{-1, -1}, 0, 0};
    if (!linear)
        return (struct sample){{(int)u, (int)u}, 0, 0};
    if (bytes)
        u = rint(u * 256) / 256;
    const double low = floor(u - 0.5);
    return (struct sample){{fgl_max((int)low, 0), fgl_min((int)low + 1, size - 1)}, (float)(u - 0.5 - low), (int)((u - 0.5 - low) * 256)};
}

/* The part of the destination [d0,d1] between `low` and `high`; false: there is none, or memory is short. size: of the source. */
static bool map_axis(struct axis *a, int d0, int d1, int low, int high, int s0, int s1, int size, bool linear,
                     bool bytes)
{
    a->first = fgl_max(fgl_min(d0, d1), low);
    a->end = fgl_min(fgl_max(d0, d1), high);
    if (a->first >= a->end)
        return false;
    a->sample = malloc((size_t)(a->end - a->first) * sizeof *a->sample);
    for (int i = a->first; a->sample && i < a->end; i++)
        a->sample[i - a->first] = sample_of(i, d0, d1, s0, s1, size, linear, bytes);
    return a->sample != NULL;
}

/* ---- depth and stencil: the nearest pixel ---- */

static void copy_plane(const struct framebuffer *from, const void *source, const struct framebuffer *to, void *destination, size_t bytes,
                       const struct axis *x, const struct axis *y)
{
    for (int j = y->first; j < y->end; j++) {
        const int row = y->sample[j - y->first].at[0];
        if (row < 0)
            continue;
        const char *in = (const char *)source + (size_t)fgl_row(from, row) * (size_t)from->stride * bytes;
        char *out = (char *)destination + (size_t)fgl_row(to, j) * (size_t)to->stride * bytes;
        for (int i = x->first; i < x->end; i++)
            if (x->sample[i - x->first].at[0] >= 0)
                memcpy(out + (size_t)i * bytes, in + (size_t)x->sample[i - x->first].at[0] * bytes, bytes);
    }
}

/* ---- colour ---- */

/* OSMesa rule: colours of 8 bits or less are filtered as bytes. */
static bool has_bytes(const struct framebuffer *fb)
{
    return fb->color_kind == COLOR_UNORM8 || fb->color_kind == COLOR_565 || (fb->image_bits[0] && fb->image_bits[0] < 8);
}

/* As many pixels as they become, all of them in the source. OSMesa rule: these are not filtered. */
static bool is_plain(int s0, int s1, int d0, int d1, int size)
{
    return llabs((int64_t)s1 - s0) == llabs((int64_t)d1 - d0) && fgl_min(s0, s1) >= 0 && fgl_max(s0, s1) <= size;
}

static void read_row(const struct framebuffer *fb, int y, bool bytes, void *row)
{
    static const struct pixel_mode_state no_transfer = {.scale = {1, 1, 1, 1}, .depth_scale = 1};
    const struct pixel_pack pack = {
            .image = fgl_pixel_image(&fgl_packed_store, GL_RGBA, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, fb->width, row),
            .mode = &no_transfer,
    };
    fgl_pack_row(&pack, fb, 0, fgl_row(fb, y), fb->width, 0, 0);
}

/* A component of 5 or 6 bits. OSMesa rule: of pixels that are not filtered the first bits are taken. */
static uint32_t few_bits(float c, int bits, bool cut)
{
    return (uint32_t)(cut ? fgl_unorm(c, 255) >> (8 - bits) : fgl_unorm(c, (float)((1 << bits) - 1)));
}

static void write_pixel(const struct framebuffer *fb, size_t at, const float c[4], bool cut)
{
    switch (fb->color_kind) {
    case COLOR_UNORM8:
        ((uint32_t *)fb->color)[at] = fgl_unorm(c[0], 255) | fgl_unorm(c[1], 255) << 8 | fgl_unorm(c[2], 255) << 16 |
                                      fgl_unorm(c[3], 255) << 24;
        break;
    case COLOR_UNORM16:
        for (int k = 0; k < 4; k++)
            ((uint16_t *)fb->color)[4 * at + (size_t)k] = (uint16_t)fgl_unorm(c[k], 65535);
        break;
    case COLOR_FLOAT: memcpy((float *)fb->color + 4 * at, c, 4 * sizeof(float)); break;
    case COLOR_565:
        ((uint16_t *)fb->color)[at] = (uint16_t)(few_bits(c[0], 5, cut) << 11 | few_bits(c[1], 6, cut) << 5 | few_bits(c[2], 5, cut));
        break;
    case COLOR_INDEX8: break;
    }
}

/* Between four pixels: of two rows, and two columns of them. */
static void blend(const float *const row[2], const struct sample *x, const struct sample *y, float color[4])
{
    for (int c = 0; c < 4; c++) {
        float v[2];
        for (int k = 0; k < 2; k++) {
            const float a = row[k][4 * x->at[0] + c], b = row[k][4 * x->at[1] + c];
            v[k] = a + (b - a) * x->fraction;
        }
        color[c] = v[0] + (v[1] - v[0]) * y->fraction;
    }
}

static int mix(int a, int b, int weight)
{
    return a + ((weight * (b - a) + 128) >> 8);
}

/* The same of bytes. OSMesa rule: rounded to bytes along each axis. */
static void blend_bytes(const uint8_t *const row[2], const struct sample *x, const struct sample *y, float color[4])
{
    for (int c = 0; c < 4; c++) {
        int v[2];
        for (int k = 0; k < 2; k++)
            v[k] = mix(row[k][4 * x->at[0] + c], row[k][4 * x->at[1] + c], x->weight);
        color[c] = (float)mix(v[0], v[1], y->weight) * (1.0f / 255.0f);
    }
}

static bool copy_color(const struct framebuffer *from, const struct framebuffer *to, const struct axis *x, const struct axis *y, bool bytes)
{
    const bool cut = !bytes && from->color_kind == COLOR_UNORM8;
    const size_t size = 4 * (bytes ? 1 : sizeof(float)) * (size_t)from->width;
    char *rows = malloc(2 * size);
    if (!rows)
        return false;
    const uint8_t *const byte_row[2] = {(const uint8_t *)rows, (const uint8_t *)rows + size};
    const float *const row[2] = {(const float *)(const void *)rows, (const float *)(const void *)(rows + size)};
    for (int j = y->first; j < y->end; j++) {
        const struct sample *s = &y->sample[j - y->first];
        if (s->at[0] < 0)
            continue;
        read_row(from, s->at[0], bytes, rows);
        read_row(from, s->at[1], bytes, rows + size);
        for (int i = x->first; i < x->end; i++) {
            const struct sample *column = &x->sample[i - x->first];
            float color[4];
            if (column->at[0] < 0)
                continue;
            if (bytes)
                blend_bytes(byte_row, column, s, color);
            else
                blend(row, column, s, color);
            write_pixel(to, (size_t)fgl_row(to, j) * (size_t)to->stride + (size_t)i, color, cut);
        }
    }
    free(rows);
    return true;
}

/* ---- the command ---- */

static GLenum blit_error(GLbitfield mask, GLenum filter)
{
    if (mask & ~(GLbitfield)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT))
        return GL_INVALID_VALUE;
    if (filter != GL_NEAREST && filter != GL_LINEAR)
        return GL_INVALID_ENUM;
    if (filter == GL_LINEAR && mask & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT))
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

/* Depths are copied as they are: GL_INVALID_OPERATION unless both framebuffers have the same bits. Buffers that one of them lacks are left
 * out of *mask. */
static GLenum buffers_error(const struct context *ctx, GLbitfield *mask)
{
    const struct framebuffer *from = ctx->read_framebuffer, *to = ctx->framebuffer;
    if (ctx->color_index || !fgl_framebuffer_reads_color(ctx) || ctx->s.color_buffer.draw_buffer == GL_NONE)
        *mask &= ~(GLbitfield)GL_COLOR_BUFFER_BIT;
    if (!from->depth || !to->depth)
        *mask &= ~(GLbitfield)GL_DEPTH_BUFFER_BIT;
    if (!from->stencil_bits || !to->stencil_bits)
        *mask &= ~(GLbitfield)GL_STENCIL_BUFFER_BIT;
    return *mask & GL_DEPTH_BUFFER_BIT && from->depth_bits != to->depth_bits ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

static bool copy(struct context *ctx, GLbitfield mask, const struct axis *x, const struct axis *y, bool bytes)
{
    struct framebuffer *from = ctx->read_framebuffer, *to = ctx->framebuffer;
    to->drawn = true;
    if (mask & GL_DEPTH_BUFFER_BIT)
        copy_plane(from, from->depth, to, to->depth, sizeof *to->depth, x, y);
    if (mask & GL_STENCIL_BUFFER_BIT) {
        if (!fgl_framebuffer_need_stencil(from) || !fgl_framebuffer_need_stencil(to))
            return false;
        copy_plane(from, from->stencil, to, to->stencil, 1, x, y);
    }
    return !(mask & GL_COLOR_BUFFER_BIT) || copy_color(from, to, x, y, bytes);
}

void fgl_exec_BlitFramebuffer(struct context *ctx, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0, GLint dstY0,
                              GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter)
{
    fgl_flush_vertices(ctx, 0);
    if (!fgl_draw_ready(ctx) || !fgl_read_ready(ctx) || !ctx->framebuffer || !ctx->read_framebuffer)
        return;
    GLenum error = blit_error(mask, filter);
    RETURN_ERROR_IF(ctx, error, error);
    error = buffers_error(ctx, &mask);
    RETURN_ERROR_IF(ctx, error, error);
    const struct framebuffer *from = ctx->read_framebuffer, *to = ctx->framebuffer;
    const struct rect r = fgl_turned(to, fgl_raster_bounds(&ctx->s.scissor, to));
    const bool linear = filter == GL_LINEAR;
    const bool plain = is_plain(srcX0, srcX1, dstX0, dstX1, from->width) && is_plain(srcY0, srcY1, dstY0, dstY1, from->height);
    const bool bytes = has_bytes(from) && !plain;
    struct axis x = {0}, y = {0};
    if (mask && srcX0 != srcX1 && srcY0 != srcY1 && map_axis(&x, dstX0, dstX1, r.x0, r.x1, srcX0, srcX1, from->width, linear, bytes) &&
        map_axis(&y, dstY0, dstY1, r.y0, r.y1, srcY0, srcY1, from->height, linear, bytes) &&
        !copy(ctx, mask, &x, &y, bytes))
        fgl_error(ctx, GL_OUT_OF_MEMORY);
    free(x.sample);
    free(y.sample);
}
