/* The record of one pixel: arming it, what happens to it, and writing it down. */
#include "pipeline/explain.h"

#include "base/color_index.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- arming ---- */

bool fgl_explain_start(struct pipeline *p, int x, int y)
{
    struct explain *e = p->explain ? p->explain : calloc(1, sizeof *e);
    if (!e)
        return false;
    e->x = x;
    e->y = y;
    e->draws = e->events = 0;
    e->seen = e->has_detail = false;
    e->agrees = true;
    e->out_vertex = -1;
    p->explain = e;
    return true;
}

void fgl_explain_stop(struct pipeline *p)
{
    if (!p->explain)
        return;
    struct framebuffer *scratch = &p->explain->scratch.fb;
    free(scratch->color);
    free(scratch->depth);
    free(scratch->stencil);
    fgl_text_free(&p->explain->text);
    free(p->explain);
    p->explain = NULL;
}

void fgl_explain_from_environment(struct pipeline *p)
{
    static atomic_flag taken = ATOMIC_FLAG_INIT;
    const char *pixel = getenv("FIXEDGL_EXPLAIN");
    int x, y, vertex = -1;
    if (!pixel || atomic_flag_test_and_set(&taken))
        return;
    if (sscanf(pixel, "%d,%d,%d", &x, &y, &vertex) < 2 || x < 0 || y < 0 || vertex < -1 || vertex > 2) {
        fprintf(stderr, "FixedGL: FIXEDGL_EXPLAIN=%s is not X,Y or X,Y,VERTEX\n", pixel);
        return;
    }
    if (!fgl_explain_start(p, x, y))
        return;
    p->explain->out = getenv("FIXEDGL_EXPLAIN_OUT");
    p->explain->out_vertex = vertex;
}

void fgl_explain_write(struct context *ctx)
{
    struct explain *e = ctx->pipeline->explain;
    if (!e->out || !ctx->framebuffer)
        return;
    if (!fgl_explain_look(ctx)) {
        fprintf(stderr, "FixedGL: pixel %d,%d is outside of the picture, %d x %d pixels\n", e->x, e->y,
                e->width, e->height);
        remove(e->out);
        return;
    }
    const char *end = strrchr(e->out, '.');
    if (end && strcmp(end, ".json") == 0)
        fgl_explain_json(e, ctx->framebuffer, e->out_vertex);
    else
        fgl_explain_text(e, ctx->framebuffer, e->out_vertex);
    if (!fgl_text_write(&e->text, e->out))
        fprintf(stderr, "FixedGL: cannot write %s\n", e->out);
}

/* ---- events ---- */

struct explain_event *fgl_explain_add(struct explain *e, enum explain_outcome outcome)
{
    struct explain_event *event = &e->event[fgl_min(e->events, EXPLAIN_EVENTS - 1)];
    e->events++;
    memset(event, 0, sizeof *event);
    event->outcome = outcome;
    return event;
}

const struct explain_event *fgl_explain_last(const struct explain *e)
{
    for (int i = fgl_min(e->events, EXPLAIN_EVENTS) - 1; i >= 0; i--) {
        const enum explain_outcome outcome = e->event[i].outcome;
        if (outcome == OUTCOME_DRAWN || outcome == OUTCOME_CLEARED || outcome == OUTCOME_OTHER)
            return &e->event[i];
    }
    return NULL;
}

/* A framebuffer of another size is another picture. */
static void take_size(struct explain *e, const struct framebuffer *fb)
{
    if (fb->width == e->width && fb->height == e->height)
        return;
    e->events = e->draws = 0;
    e->seen = e->has_detail = false;
    e->width = fb->width;
    e->height = fb->height;
}

bool fgl_explain_look(struct context *ctx)
{
    struct explain *e = ctx->pipeline->explain;
    const struct framebuffer *fb = ctx->framebuffer;
    take_size(e, fb);
    if (e->x >= fb->width || e->y >= fb->height)
        return false;
    const struct pixel_value now = fgl_explain_pixel(fb, fgl_row(fb, e->y), e->x);
    if (e->seen && memcmp(now.color, e->value.color, sizeof now.color) != 0) {
        struct explain_event *event = fgl_explain_add(e, OUTCOME_OTHER);
        event->before = e->value;
        event->after = now;
        e->has_detail = false;
    }
    e->value = now;
    e->seen = true;
    return true;
}

/* Which channels, or bits of an index, a clear writes: some, all? */
static void find_written(const struct context *ctx, bool *some, bool *all)
{
    const struct color_buffer_state *color = &ctx->s.color_buffer;
    const bool *write = color->color_writemask;
    const unsigned bits = color->index_writemask & FGL_INDEX_MAX;
    *some = ctx->color_index ? bits != 0 : write[0] || write[1] || write[2] || write[3];
    *all = ctx->color_index ? bits == FGL_INDEX_MAX : write[0] && write[1] && write[2] && write[3];
    *some = *some && color->draw_buffer != GL_NONE;
}

void fgl_explain_clear(struct context *ctx, GLbitfield mask, struct rect r)
{
    struct explain *e = ctx->pipeline->explain;
    const struct framebuffer *fb = ctx->framebuffer;
    const int row = fgl_row(fb, e->y);
    const struct color_buffer_state *color = &ctx->s.color_buffer;
    bool some, all;
    take_size(e, fb);
    if (e->x < r.x0 || e->x >= r.x1 || row < r.y0 || row >= r.y1)
        return;
    const struct pixel_value now = fgl_explain_pixel(fb, row, e->x);
    find_written(ctx, &some, &all);
    if (mask & GL_COLOR_BUFFER_BIT && some) {
        if (all)
            e->events = e->draws = 0; /* what was before no longer shows */
        struct explain_event *event = fgl_explain_add(e, OUTCOME_CLEARED);
        event->before = e->value;
        event->after = now;
        memcpy(event->fragment.smoothed, color->color_clear_value, sizeof event->fragment.smoothed);
        if (ctx->color_index)
            event->fragment.smoothed[0] = color->index_clear_value;
        e->has_detail = false;
    }
    e->value = now;
    e->seen = true;
}
