/* Pixel rectangles on their way to the framebuffer (GL 1.5, 3.6.4 "Rasterization of Pixel Rectangles"): of glDrawPixels and
 * glCopyPixels. */
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/pixel_image.h"
#include "framebuffer/imaging.h"
#include "framebuffer/pixel_unpack.h"
#include "pipeline/feedback.h"
#include "pipeline/pipeline.h"
#include "pipeline/pixels.h"
#include "pipeline/zoom_clip.h"
#include "raster/zoom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A pixel rectangle on its way to the framebuffer. Rows are unpacked whole; columns of the window choose from
 * them. Each worker has one, with rows of its own. */
struct rectangle {
    struct pixel_unpack unpack;
    struct zoom zoom;
    struct pixel_draw draw;
    struct rect area;            /* window pixels that it covers and may draw */
    enum { RGBA_FLOATS, RGBA_UNORM8, COLOR_INDEXES, DEPTH, STENCIL, DEPTH_STENCIL } kind;
    int planes;                       /* numbers of a pixel: 4 of RGBA_FLOATS, 2 of DEPTH_STENCIL, else 1 */
    int first, columns;               /* the image's columns that are seen */
    bool straight;                    /* window columns show neighbouring columns of the image */
    int row;                          /* of the image, in `shown`; -1: none yet */
    int *column;                      /* by window x: which of the columns */
    union number *source[4], *shown[4]; /* the image's row; by window x */
    struct framebuffer *fb;
    uint8_t stencil_mask;
    bool depth_mask;
};

/* What a plane consists of, by kind. */
union number {
    float f;         /* RGBA_FLOATS, COLOR_INDEXES, DEPTH */
    uint32_t unorm8; /* RGBA_UNORM8 */
    uint32_t depth;  /* DEPTH_STENCIL, the first: as in the framebuffer */
    int32_t index;   /* STENCIL; DEPTH_STENCIL, the second */
};

/* OSMesa rule: the position is rounded half away from zero. */
static int round_position(float v)
{
    const float limit = 1 << 24;
    const float c = v < -limit ? -limit : v < limit ? v : limit;
    return (int)(c < 0.0f ? c - 0.5f : c + 0.5f);
}

static bool place(const struct context *ctx, int width, int height, const struct rect *bounds, bool copied,
                  struct zoom *zoom, struct rect *area)
{
    const struct framebuffer *fb = ctx->framebuffer;
    const float *position = ctx->s.current.raster_position;
    fgl_zoom_setup(zoom, round_position(position[0]), round_position(position[1]), width, height,
                   ctx->s.pixel_mode.zoom_x, ctx->s.pixel_mode.zoom_y, fb, copied && !ctx->read_framebuffer->y_up);
    area->x0 = fgl_max(zoom->covered.x0, bounds->x0);
    area->y0 = fgl_max(zoom->covered.y0, bounds->y0);
    area->x1 = fgl_min(zoom->covered.x1, bounds->x1);
    area->y1 = fgl_min(zoom->covered.y1, bounds->y1);
    return area->x0 < area->x1 && area->y0 < area->y1;
}

/* The columns of the image that the area shows, or all. */
static bool choose_columns(struct rectangle *r, bool all)
{
    const int a = all ? 0 : fgl_zoom_column(&r->zoom, r->area.x0),
              b = all ? r->zoom.width - 1 : fgl_zoom_column(&r->zoom, r->area.x1 - 1);
    r->first = fgl_min(a, b);
    r->columns = fgl_max(a, b) - r->first + 1;
    r->straight = !all && b - a == r->area.x1 - 1 - r->area.x0;
    r->column = malloc((size_t)r->fb->stride * sizeof *r->column);
    for (int x = r->area.x0; r->column && x < r->area.x1; x++)
        r->column[x] = fgl_zoom_column(&r->zoom, x) - r->first;
    return r->column != NULL;
}

/* The arrays from which the fragments are made. */
static void set_inputs(struct rectangle *r)
{
    struct pixel_inputs *inputs = &r->draw.inputs;
    r->draw.fragment.pixels = inputs;
    if (r->kind == DEPTH)
        inputs->depth = &r->shown[0]->f;
    else if (r->kind == RGBA_UNORM8)
        inputs->unorm8 = &r->shown[0]->unorm8;
    else if (r->kind == RGBA_FLOATS || r->kind == COLOR_INDEXES)
        for (int c = 0; c < r->planes; c++)
            inputs->color[c] = &r->shown[c]->f;
}

/* A rectangle like the one given, with room for rows of the columns. */
static bool make_room(struct rectangle *r, const struct rectangle *like)
{
    const size_t columns = (size_t)like->columns + PIXEL_CHUNK, stride = (size_t)like->fb->stride;
    union number *room = calloc((size_t)like->planes * (columns + stride), sizeof *room);
    *r = *like;
    r->source[0] = room;
    if (!room)
        return false;
    for (int i = 0; i < r->planes; i++) {
        r->source[i] = room + (size_t)i * (columns + stride);
        r->shown[i] = r->source[i] + columns;
    }
    r->row = -1;
    set_inputs(r);
    return true;
}

/* Depths of 24 bits to those of the framebuffer. OSMesa rule: they are drawn as floats, which may end a step beside. */
static void drawn_depths(const struct framebuffer *fb, union number *depth, int n)
{
    for (int i = 0; i < n; i++)
        depth[i].depth = (uint32_t)rintf((float)depth[i].depth * (1.0f / 16777215.0f) * (float)fb->depth_max);
}

/* Columns at .. at+n of those that are seen, into to[]. */
static void unpack_chunk(struct rectangle *r, int row, int at, int n, union number *const to[4])
{
    const int column = r->first + at;
    struct color_row colors;
    switch (r->kind) {
    case DEPTH: fgl_unpack_depth(&r->unpack, row, column, n, &to[0][at].f); break;
    case STENCIL: fgl_unpack_stencil(&r->unpack, row, column, n, &to[0][at].index); break;
    case DEPTH_STENCIL:
        fgl_unpack_depth_texels(&r->unpack, row, column, n, 24, &to[0][at].depth);
        drawn_depths(r->fb, &to[0][at], n);
        fgl_unpack_stencil(&r->unpack, row, column, n, &to[1][at].index);
        break;
    case COLOR_INDEXES: fgl_unpack_color_index(&r->unpack, row, column, n, &to[0][at].f); break;
    case RGBA_UNORM8: fgl_unpack_unorm8(&r->unpack, row, column, n, &to[0][at].unorm8); break;
    case RGBA_FLOATS:
        fgl_unpack_color(&r->unpack, row, column, n, &colors);
        for (int c = 0; c < 4; c++)
            memcpy(&to[c][at].f, colors.channel[c], (size_t)n * sizeof(float));
        break;
    }
}

static void unpack_row(struct rectangle *r, int row, union number *const to[4])
{
    for (int at = 0; at < r->columns; at += PIXEL_CHUNK)
        unpack_chunk(r, row, at, fgl_min(PIXEL_CHUNK, r->columns - at), to);
}

/* Makes `shown` a row of the image. */
static void show_row(struct rectangle *r, int row)
{
    union number *to[4];
    if (row == r->row)
        return;
    for (int c = 0; c < r->planes; c++)
        to[c] = r->straight ? r->shown[c] + r->area.x0 : r->source[c];
    unpack_row(r, row, to);
    for (int c = 0; c < r->planes && !r->straight; c++)
        for (int x = r->area.x0; x < r->area.x1; x++)
            r->shown[c][x] = r->source[c][r->column[x]];
    r->row = row;
}

/* Straight into the buffers (3.6.4 "Final Conversion": scissor and masks alone apply). */
static void write_stencil(const struct rectangle *r, const union number *index, int y, int x0, int x1)
{
    uint8_t *s = r->fb->stencil + (size_t)y * (size_t)r->fb->stride;
    const uint8_t mask = r->stencil_mask;
    for (int x = x0; x < x1; x++)
        s[x] = (uint8_t)((s[x] & ~mask) | (index[x].index & mask));
}

static void write_depth(const struct rectangle *r, int y, int x0, int x1)
{
    uint32_t *depth = r->fb->depth + (size_t)y * (size_t)r->fb->stride;
    for (int x = x0; x < x1 && r->depth_mask; x++)
        depth[x] = r->shown[0][x].depth;
}

static void draw_run(const struct rectangle *r, int y, int x0, int x1)
{
    switch (r->kind) {
    case STENCIL: write_stencil(r, r->shown[0], y, x0, x1); break;
    case DEPTH_STENCIL:
        write_depth(r, y, x0, x1);
        write_stencil(r, r->shown[1], y, x0, x1);
        break;
    default: fgl_pixels_run(&r->draw, y, x0, x1); break;
    }
}

/* Where the row passes from one triangle into the other: the first pixel that is not in the triangle of pixel
 * x0. */
static int triangle_end(const struct rectangle *r, int y)
{
    const bool first = fgl_zoom_in_first(&r->zoom, r->area.x0, y);
    int x = r->area.x0 + 1;
    while (x < r->area.x1 && fgl_zoom_in_first(&r->zoom, x, y) == first)
        x++;
    return x;
}

static void draw_rows(struct rectangle *r, int y0, int y1)
{
    const struct rect *area = &r->area;
    for (int y = y0; y < y1; y++) {
        const int rows[2] = {fgl_zoom_row(&r->zoom, y, 0), fgl_zoom_row(&r->zoom, y, 1)};
        if (rows[0] == rows[1]) {
            show_row(r, rows[0]);
            draw_run(r, y, area->x0, area->x1);
            continue;
        }
        const int left = fgl_zoom_in_first(&r->zoom, area->x0, y) ? 0 : 1, end = triangle_end(r, y);
        show_row(r, rows[left]);
        draw_run(r, y, area->x0, end);
        show_row(r, rows[1 - left]);
        draw_run(r, y, end, area->x1);
    }
}

/* The pixels of a run, which show any pixels of the image. */
static void draw_zoomed_run(void *rectangle, int y, int x0, int x1, const int *column, const int *row)
{
    struct rectangle *r = rectangle;
    for (int x = x0; x < x1; x++) {
        if (row[x] != r->row)
            unpack_row(r, row[x], r->source);
        r->row = row[x];
        for (int c = 0; c < r->planes; c++)
            r->shown[c][x] = r->source[c][column[x]];
    }
    draw_run(r, y, x0, x1);
}

/* Whether the window cuts it; where a column of the image is one of the window, that does not matter. */
static bool is_cut(const struct context *ctx, const struct zoom *z)
{
    const float w = (float)ctx->framebuffer->width, h = (float)ctx->framebuffer->height;
    if (ctx->s.pixel_mode.zoom_x == 1.0f && ctx->s.pixel_mode.zoom_y == 1.0f)
        return false;
    return fminf(z->x[0], z->x[1]) < 0.0f || fmaxf(z->x[0], z->x[1]) > w || fminf(z->y[0], z->y[1]) < 0.0f ||
           fmaxf(z->y[0], z->y[1]) > h;
}

/* All rows, in bands that workers share: each_worker has their rectangles. */
struct band_job {
    struct rectangle *each_worker;
    int bands;
};

static void draw_band(void *arg, int band, int worker)
{
    const struct band_job *job = arg;
    struct rectangle *r = &job->each_worker[worker];
    const int top = r->area.y0, height = r->area.y1 - top;
    draw_rows(r, top + height * band / job->bands, top + height * (band + 1) / job->bands);
}

/* False when memory is short. */
static bool draw_area(struct context *ctx, const struct rectangle *r, bool cut)
{
    const int width = r->area.x1 - r->area.x0, height = r->area.y1 - r->area.y0;
    struct pipeline *p = ctx->pipeline;
    struct band_job job = {.bands = fgl_pipeline_bands(p, height, !cut && height >= SHARED_AREA / width)};
    const int workers = job.bands > 1 ? fgl_workers_count(p->workers) : 1;
    struct rectangle *each = job.each_worker = calloc((size_t)workers, sizeof *each);
    bool ok = each != NULL;
    for (int i = 0; i < workers && ok; i++)
        ok = make_room(&each[i], r);
    if (ok && cut)
        ok = fgl_zoom_clip(&r->zoom, r->fb, &r->draw.bounds, draw_zoomed_run, each);
    else if (ok && job.bands > 1)
        fgl_workers_run(p->workers, job.bands, draw_band, &job);
    else if (ok)
        draw_band(&job, 0, 0);
    for (int i = 0; i < workers && each; i++)
        free(each[i].source[0]);
    free(each);
    return ok;
}

static void draw_rectangle(struct context *ctx, int width, int height, const struct pixel_unpack *unpack, bool copied)
{
    const enum channel channel = unpack->image.format->channel[0];
    const bool both = unpack->image.format->format == GL_DEPTH_STENCIL;
    struct rectangle r = {.unpack = *unpack, .fb = ctx->framebuffer, .depth_mask = ctx->s.depth.depth_writemask};
    r.stencil_mask = (uint8_t)ctx->s.stencil.stencil_writemask;
    RETURN_ERROR_IF(ctx, (channel == CHANNEL_STENCIL || both) && !fgl_framebuffer_need_stencil(r.fb), GL_OUT_OF_MEMORY);
    fgl_pixels_begin(ctx, channel <= CHANNEL_LUMINANCE || channel == CHANNEL_INDEX ? PIXELS_COLOR : PIXELS_DEPTH, &r.draw);
    r.kind = both                              ? DEPTH_STENCIL
             : channel == CHANNEL_DEPTH        ? DEPTH
             : channel == CHANNEL_STENCIL      ? STENCIL
             : ctx->color_index                ? COLOR_INDEXES
             : fgl_pixels_take_unorm8(&r.draw) ? RGBA_UNORM8
                                               : RGBA_FLOATS;
    r.planes = r.kind == RGBA_FLOATS ? 4 : both ? 2 : 1;
    if (!place(ctx, width, height, &r.draw.bounds, copied, &r.zoom, &r.area))
        return;
    const bool cut = is_cut(ctx, &r.zoom);
    if (!choose_columns(&r, cut) || !draw_area(ctx, &r, cut))
        fgl_error(ctx, GL_OUT_OF_MEMORY);
    free(r.column);
}

/* Colours that imaging stages may change or discard, as an image of their own. */
static void draw_imaged(struct context *ctx, int width, int height, const struct pixel_unpack *unpack, bool copied)
{
    struct color_image image;
    RETURN_ERROR_IF(ctx, !fgl_imaging_unpack(ctx, unpack, width, height, 2, &image), GL_OUT_OF_MEMORY);
    const struct pixel_unpack ready = fgl_color_image_unpack(&image, unpack);
    if (image.width > 0 && image.height > 0)
        draw_rectangle(ctx, image.width, image.height, &ready, copied);
    free(image.color);
}

/* Whether the imaging stages apply: to RGBA groups alone (GL 1.5, 3.6.5). */
static bool is_imaged(const struct context *ctx, const struct pixel_format *format)
{
    return (format->channel[0] <= CHANNEL_LUMINANCE || format->channel[0] == CHANNEL_INDEX) && !ctx->color_index &&
           fgl_imaging_active(ctx);
}

/* ---- the command ---- */

void fgl_draw_image(struct context *ctx, int width, int height, GLenum format, GLenum type,
                    const struct pixel_store *store, const void *pixels, bool copied)
{
    fgl_flush_vertices(ctx, 0);
    if (!fgl_draw_ready(ctx) || !ctx->framebuffer || !ctx->s.current.raster_position_valid || width == 0 || height == 0)
        return;
    fgl_feedback_raster_position(ctx, GL_DRAW_PIXEL_TOKEN);
    if (ctx->render_mode != GL_RENDER)
        return;
    const struct pixel_unpack unpack = {
            .image = fgl_pixel_image(store, format, type, width, pixels),
            .mode = &ctx->s.pixel_mode,
            .maps = ctx->pixel_map,
            .arith = fgl_context_arith(ctx),
    };
    if (is_imaged(ctx, unpack.image.format))
        draw_imaged(ctx, width, height, &unpack, copied);
    else
        draw_rectangle(ctx, width, height, &unpack, copied);
}
