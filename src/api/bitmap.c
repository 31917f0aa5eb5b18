/* glBitmap (GL 1.5, 3.7 "Bitmaps"). */
#include "api/command.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "api/pixel_image.h"
#include "api/set.h"
#include "framebuffer/pixel_unpack.h"
#include "pipeline/feedback.h"
#include "pipeline/pixels.h"
#include "state/share.h"

#include <math.h>
#include <string.h>

/* Takes the lowest run of ones out of *bits: from *x0 to *x1. Nothing from nothing. */
static void take_run(uint32_t *bits, int32_t *x0, int32_t *x1)
{
    const uint32_t lowest = *bits & -*bits, carry = *bits + lowest; /* the run's ones become zeros, the zero after them a one */
    *x0 = *bits ? fgl_lowest_bit(*bits) : 0;
    *x1 = carry ? fgl_lowest_bit(carry) : *bits ? BITMAP_CHUNK : 0;
    *bits &= carry;
}

/* The ones of n rows as fragments: the first run of each row together, then the second, and so on. bits: of the rows from row y
 * on; bit 0 is at window column x. */
static void draw_bits(const struct pixel_draw *draw, int x, int y, int n, uint32_t *bits)
{
    struct runs runs;
    runs.y = y;
    runs.n = n;
    for (;;) {
        uint32_t any = 0;
        for (int i = 0; i < n; i++) {
            any |= bits[i];
            take_run(&bits[i], &runs.x0[i], &runs.x1[i]);
            runs.x0[i] += x;
            runs.x1[i] += x;
        }
        if (!any)
            return;
        fgl_pixels_runs(draw, &runs);
    }
}

/* (x, y): the window position of the bitmap's lower left corner, y up. */
static void draw_bitmap(const struct pixel_draw *draw, const struct framebuffer *fb, const struct pixel_image *image, int x, int y, int width,
                        int height)
{
    const struct rect *bounds = &draw->bounds, covered = fgl_turned(fb, (struct rect){x, y, x + width, y + height});
    const int x0 = fgl_max(bounds->x0, covered.x0), x1 = fgl_min(bounds->x1, covered.x1);
    const int y0 = fgl_max(bounds->y0, covered.y0), y1 = fgl_min(bounds->y1, covered.y1);
    uint32_t bits[RUNS_MAX];
    for (int first = y0; first < y1; first += RUNS_MAX)
        for (int left = x0; left < x1; left += BITMAP_CHUNK) {
            const int n = fgl_min(RUNS_MAX, y1 - first), columns = fgl_min(BITMAP_CHUNK, x1 - left);
            for (int i = 0; i < n; i++)
                bits[i] = fgl_unpack_bits(image, fgl_row(fb, first + i) - y, left - x, columns);
            draw_bits(draw, left, first, n, bits);
        }
}

/* OSMesa rule: the lower left corner is floor(raster position + 0.0001 - origin), in float. */
static int corner(float position, float origin)
{
    const float limit = 1 << 24, v = floorf(position + 0.0001f - origin);
    return (int)(v < -limit ? -limit : v < limit ? v : limit);
}

void fgl_bitmap(struct context *ctx, int width, int height, const float origin[2], const float move[2],
                const struct pixel_store *store, const void *bits)
{
    struct current_state *current = &ctx->s.current;
    fgl_flush_vertices(ctx, 0);
    if (!fgl_draw_ready(ctx) || !current->raster_position_valid)
        return;
    fgl_feedback_raster_position(ctx, GL_BITMAP_TOKEN);
    if (ctx->render_mode == GL_RENDER && ctx->framebuffer && width > 0 && height > 0 && bits) {
        const struct pixel_image image = fgl_pixel_image(store, GL_COLOR_INDEX, GL_BITMAP, width, bits);
        const int x = corner(current->raster_position[0], origin[0]),
                  y = corner(current->raster_position[1], origin[1]);
        struct pixel_draw draw;
        fgl_pixels_begin(ctx, PIXELS_BITMAP, &draw);
        draw_bitmap(&draw, ctx->framebuffer, &image, x, y, width, height);
    }
    current->raster_position[0] += move[0];
    current->raster_position[1] += move[1];
}

struct bitmap_node {
    int32_t width, height;
    float origin[2], move[2];
    uint8_t bits[]; /* packed tightly */
};

static void record(struct context *ctx, int width, int height, const float origin[2], const float move[2],
                   const void *bitmap)
{
    if (!bitmap)
        width = height = 0;
    const size_t bytes = fgl_pixel_image_bytes(&fgl_packed_store, GL_COLOR_INDEX, GL_BITMAP, width, height);
    struct bitmap_node *node = fgl_list_record(ctx, OP_BITMAP, sizeof *node + bytes);
    if (!node)
        return;
    *node = (struct bitmap_node){width, height, {origin[0], origin[1]}, {move[0], move[1]}};
    fgl_pixel_copy(&ctx->client.unpack, GL_COLOR_INDEX, GL_BITMAP, width, height, bitmap, node->bits);
}

void fgl_list_replay_bitmap(struct context *ctx, const void *payload)
{
    const struct bitmap_node *n = payload;
    fgl_bitmap(ctx, n->width, n->height, n->origin, n->move, &fgl_packed_store, n->bits);
}

static void bitmap(struct context *ctx, GLsizei width, GLsizei height, const float origin[2], const float move[2], const void *bits)
{
    if (width < 0 || height < 0) {
        fgl_command_error(ctx, GL_INVALID_VALUE);
        return;
    }
    if (!fgl_buffer_image(ctx, &ctx->client.unpack, GL_COLOR_INDEX, GL_BITMAP, width, height, &bits))
        return;
    if (ctx->compiling)
        record(ctx, width, height, origin, move, bits);
    if (ctx->compiling != GL_COMPILE)
        fgl_bitmap(ctx, width, height, origin, move, &ctx->client.unpack, bits);
}

void GLAPIENTRY glBitmap(GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove,
                         GLfloat ymove, const GLubyte *bits)
{
    struct context *ctx = fgl_current;
    const float origin[2] = {xorig, yorig}, move[2] = {xmove, ymove};
    if (ctx && !fgl_refused_inside(ctx))
        FGL_SHARED(ctx, bitmap(ctx, width, height, origin, move, bits));
}
