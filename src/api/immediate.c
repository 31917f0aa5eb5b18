/* Immediate mode: the vertex store and its format. See immediate.h for the rules that it follows. */
#include "api/immediate.h"
#include "api/errors.h"
#include "api/list.h"
#include "api/material.h"

#include <stdlib.h>
#include <string.h>

static const float attr_default[4] = {0.0f, 0.0f, 0.0f, 1.0f};

struct immediate *fgl_immediate_create(void)
{
    struct immediate *im = calloc(1, sizeof *im);
    if (!im)
        return NULL;
    im->capacity = IMMEDIATE_BYTES / (int)sizeof(float);
    im->store = malloc(((size_t)im->capacity + STORE_SLACK) * sizeof(float));
    if (!im->store) {
        free(im);
        return NULL;
    }
    im->mode = OUTSIDE_BEGIN_END;
    fgl_immediate_reset_format(im);
    return im;
}

void fgl_immediate_destroy(struct immediate *im)
{
    if (im)
        free(im->store);
    free(im);
}

void fgl_immediate_reset_format(struct immediate *im)
{
    memset(&im->format, 0, sizeof im->format);
    im->next = im->store;
    im->max_count = 0;
}

float *fgl_current_attr(struct context *ctx, int attr)
{
    if (attr < ATTR_MATERIAL)
        return ctx->s.current.attr[attr];
    return ctx->s.lighting.material[(attr - ATTR_MATERIAL) / 2][(attr - ATTR_MATERIAL) % 2];
}

void fgl_format_to_current(struct context *ctx, const struct vertex_format *format, const float *vertex)
{
    bool color_changed = false;
    for (int a = 1; a < ATTR_COUNT; a++) {
        if (!(format->active & (1u << a)))
            continue;
        float value[4];
        for (int i = 0; i < 4; i++)
            value[i] = i < format->size[a] ? vertex[format->offset[a] + i] : attr_default[i];
        float *current = fgl_current_attr(ctx, a);
        if (memcmp(current, value, sizeof value) == 0)
            continue;
        memcpy(current, value, sizeof value);
        ctx->dirty |= a < ATTR_MATERIAL ? DIRTY_CURRENT : DIRTY_MATERIAL;
        color_changed = color_changed || a == ATTR_COLOR;
    }
    if (color_changed && ctx->s.lighting.color_material)
        fgl_material_track_color(ctx);
}

void fgl_format_source(const struct vertex_format *format, const float *store, struct vertex_source *source)
{
    source->varying = format->active;
    source->compiled = source->arrays = false;
    for (int a = 0; a < ATTR_COUNT; a++) {
        if (format->active & (1u << a))
            source->attr[a] = (struct attr_source){.pointer = store + format->offset[a],
                                                   .type = GL_FLOAT,
                                                   .size = format->size[a],
                                                   .stride = format->floats * (int)sizeof(float)};
    }
}

/* ---- flushing ---- */

/* Saves the vertices that the open primitive, `n` vertices so far, needs again in the next store. Returns how many. */
static int copy_open_vertices(struct immediate *im, struct immediate_prim *prim)
{
    const int n = im->count - prim->first;
    int tail; /* vertices of the end that are needed again */
    bool head = false; /* and the first one */
    switch (prim->mode) {
    case GL_LINES: tail = n % 2; break;
    case GL_TRIANGLES: tail = n % 3; break;
    case GL_QUADS: tail = n % 4; break;
    case GL_LINE_STRIP: tail = n < 1 ? n : 1; break;
    case GL_LINE_LOOP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON:
        head = n > 1;
        tail = n < 1 ? n : 1;
        break;
    case GL_TRIANGLE_STRIP: /* the next store must start at an even triangle, and not draw one twice */
        tail = n < 2 ? n : 2 + n % 2;
        prim->count = n - (n >= 2 ? n % 2 : 0);
        break;
    case GL_QUAD_STRIP: tail = n < 2 ? n : 2 + n % 2; break;
    default: tail = 0; break;
    }
    const size_t bytes = (size_t)im->format.floats * sizeof(float);
    const float *first = im->store + (size_t)prim->first * (size_t)im->format.floats;
    int copied = 0;
    if (head)
        memcpy(im->copied[copied++], first, bytes);
    for (int i = n - tail; i < n; i++)
        memcpy(im->copied[copied++], first + (size_t)i * (size_t)im->format.floats, bytes);
    return copied;
}

/* Primitives as draw.c wants them: adjoining QUADS are one if they have ended; a line loop that is spread over stores is strips. */
static int collect_prims(struct immediate *im, struct draw_prim *out)
{
    int n = 0;
    for (int i = 0; i < im->prim_count; i++) {
        const struct immediate_prim *p = &im->prim[i];
        struct draw_prim d = {p->mode, p->first, p->count, !p->begin && p->mode >= GL_LINE_LOOP && p->mode <= GL_LINE_STRIP};
        if (p->mode == GL_LINE_LOOP && !(p->begin && p->end)) {
            d.mode = GL_LINE_STRIP;
            if (!p->begin) { /* [first vertex of the loop, last vertex drawn, ...]: the first is only for closing */
                d.first++;
                d.count--;
            }
        }
        if (d.count == 0)
            continue;
        struct draw_prim *last = n ? &out[n - 1] : NULL;
        if (last && p->end && d.mode == GL_QUADS && last->mode == GL_QUADS && last->count % 4 == 0 &&
            last->first + last->count == d.first)
            last->count += d.count;
        else
            out[n++] = d;
    }
    return n;
}

static void draw_store(struct context *ctx, struct immediate *im)
{
    struct draw_prim prims[IMMEDIATE_MAX_PRIMS];
    const int n = collect_prims(im, prims);
    if (n == 0)
        return;
    struct vertex_source source;
    fgl_format_source(&im->format, im->store, &source);
    fgl_draw(ctx, &source, prims, n, NULL, 0, (uint32_t)im->count - 1);
}

/* Whether the store has anything to draw or, for a list, to tell: a Begin or an End counts there, as other commands may stand between. */
static bool is_worth_flushing(const struct immediate *im)
{
    for (int i = 0; im->compiling && i < im->prim_count; i++)
        if (im->prim[i].begin || im->prim[i].end)
            return true;
    return im->count > 0;
}

void fgl_immediate_flush(struct context *ctx, struct immediate *im)
{
    struct immediate_prim *open = im->mode != OUTSIDE_BEGIN_END && im->prim_count ? &im->prim[im->prim_count - 1] : NULL;
    struct immediate_prim next = {OUTSIDE_BEGIN_END, 0, 0, false, false};
    im->copied_count = 0;
    if (open) {
        open->count = im->count - open->first;
        /* A loop of one vertex, which is copied once, has not begun to be drawn. */
        const bool whole = open->count == 0 || (open->count == 1 && open->mode == GL_LINE_LOOP);
        next = (struct immediate_prim){open->mode, 0, 0, open->begin && whole && !im->compiling, false};
        if (!im->compiling) /* a list's primitive in several nodes is replayed vertex by vertex */
            im->copied_count = copy_open_vertices(im, open);
    }
    if (is_worth_flushing(im)) {
        if (im->compiling)
            fgl_list_record_vertices(ctx, im);
        else
            draw_store(ctx, im);
    }
    im->prim_count = 0;
    if (open)
        im->prim[im->prim_count++] = next;
    im->count = 0;
    im->next = im->store;
    memset(im->unset, 0, sizeof im->unset);
}

/* Puts the copied vertices, saved in format `from`, at the start of the store. */
static void restore_copied(struct context *ctx, struct immediate *im, const struct vertex_format *from)
{
    for (int v = 0; v < im->copied_count; v++) {
        float *to = im->next;
        for (int a = 0; a < ATTR_COUNT; a++) {
            if (!(im->format.active & (1u << a)))
                continue;
            const bool had = from->active & (1u << a);
            const float *src = had ? im->copied[v] + from->offset[a] : fgl_current_attr(ctx, a);
            for (int i = 0; i < im->format.size[a]; i++)
                to[im->format.offset[a] + i] = had && i >= from->size[a] ? attr_default[i] : src[i];
        }
        im->next += im->format.floats;
        im->count++;
    }
    im->copied_count = 0;
}

/* Makes room for as many vertices again. */
static bool grow(struct context *ctx, struct immediate *im)
{
    float *store = realloc(im->store, ((size_t)im->capacity * 2 + STORE_SLACK) * sizeof(float));
    if (!store) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    im->store = store;
    im->next = store + (size_t)im->count * (size_t)im->format.floats;
    im->capacity *= 2;
    im->max_count = im->capacity / im->format.floats - 1;
    return true;
}

/* The store is full: a list's grows, another is drawn. */
static void wrap(struct context *ctx, struct immediate *im)
{
    if (im->compiling && grow(ctx, im))
        return;
    fgl_immediate_flush(ctx, im);
    restore_copied(ctx, im, &im->format);
}

/* ---- format ---- */

static void lay_out(struct vertex_format *f)
{
    int at = 0;
    for (int a = 1; a < ATTR_COUNT; a++) {
        f->offset[a] = (uint8_t)at;
        at += f->size[a];
    }
    f->before_position = at;
    f->offset[ATTR_POSITION] = (uint8_t)at;
    f->floats = at + f->size[ATTR_POSITION];
}

/* Moves `n` vertices at src in format `from` to dst in format `to`; what `from` lacks is 0, 0, 0, 1. */
static void convert_vertices(const struct vertex_format *from, const float *src, const struct vertex_format *to, float *dst, int n)
{
    for (int v = 0; v < n; v++, src += from->floats, dst += to->floats)
        for (int a = 0; a < ATTR_COUNT; a++)
            for (int i = 0; i < to->size[a]; i++)
                dst[to->offset[a] + i] = i < from->size[a] ? src[from->offset[a] + i] : attr_default[i];
}

/* While compiling, stored vertices get the new format in place; those before the attribute's first value are noted as unset. */
static bool reformat_store(struct context *ctx, struct immediate *im, const struct vertex_format *from, enum fgl_attr attr)
{
    const size_t floats = (size_t)im->count * (size_t)im->format.floats;
    if (floats == 0)
        return true;
    float *copy = malloc(floats * sizeof(float));
    if (!copy) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    convert_vertices(from, im->store, &im->format, copy, im->count);
    memcpy(im->store, copy, floats * sizeof(float));
    free(copy);
    if (!from->size[attr])
        im->unset[attr] = im->count;
    return true;
}

/* While compiling, before the format grows: primitives that have ended are recorded in the format that they have. OSMesa rule. */
static void record_ended(struct context *ctx, struct immediate *im)
{
    struct immediate_prim open = im->prim[im->prim_count - 1];
    const GLenum mode = im->mode;
    im->prim_count--;
    im->mode = OUTSIDE_BEGIN_END;
    fgl_immediate_flush(ctx, im);
    im->mode = mode;
    open.first = 0;
    im->prim[im->prim_count++] = open;
}

/* Gives `attr` room for `size` floats in the format. */
static FGL_NOINLINE void upgrade(struct context *ctx, struct immediate *im, enum fgl_attr attr, int size)
{
    const int drawn = im->count;
    const bool is_new = im->format.size[attr] == 0;
    bool keep = im->compiling;
    if (keep && im->count && im->prim_count && im->prim[im->prim_count - 1].first == im->count)
        record_ended(ctx, im);
    while (keep && (im->count + 2) * (im->format.floats + size) > im->capacity)
        keep = grow(ctx, im);
    if (im->count && !keep)
        fgl_immediate_flush(ctx, im);
    if (im->mode == OUTSIDE_BEGIN_END && is_new && drawn > 8 && im->format.floats && !im->compiling) {
        fgl_format_to_current(ctx, &im->format, im->vertex);
        fgl_immediate_reset_format(im);
    }
    const struct vertex_format from = im->format;
    float old[VERTEX_MAX_FLOATS];
    memcpy(old, im->vertex, sizeof old);
    im->format.active |= 1u << attr;
    im->format.size[attr] = (uint8_t)size;
    lay_out(&im->format);
    convert_vertices(&from, old, &im->format, im->vertex, 1);
    im->max_count = im->capacity / im->format.floats - 1; /* one spare: the vertex that closes a loop */
    if (!reformat_store(ctx, im, &from, attr))
        im->count = 0;
    im->next = im->store + (size_t)im->count * (size_t)im->format.floats;
    restore_copied(ctx, im, &from);
}

void fgl_attr_set(struct context *ctx, enum fgl_attr attr, int size, const float *v)
{
    if (ctx->compiling && ctx->vertices->mode == OUTSIDE_BEGIN_END) {
        fgl_list_record_attribute(ctx, attr, size, v);
        if (ctx->compiling == GL_COMPILE)
            return;
    }
    struct immediate *im = ctx->vertices->mode == OUTSIDE_BEGIN_END ? ctx->immediate : ctx->vertices;
    if (FGL_UNLIKELY(im->format.size[attr] < size))
        upgrade(ctx, im, attr, size);
    im->pending = true;
    float *to = im->vertex + im->format.offset[attr];
    for (int i = 0; i < im->format.size[attr]; i++)
        to[i] = i < size ? v[i] : attr_default[i];
}

void fgl_vertex(struct context *ctx, int size, const float *v)
{
    struct immediate *im = ctx->vertices;
    if (im->mode == OUTSIDE_BEGIN_END) { /* undefined by GL: ignored, but a list may be called inside Begin/End */
        if (!im->compiling)
            return;
        fgl_begin(ctx, CONTINUED_PRIMITIVE);
    }
    if (FGL_UNLIKELY(im->format.size[ATTR_POSITION] < size))
        upgrade(ctx, im, ATTR_POSITION, size);
    float *to = im->next;
    const int before = im->format.before_position;
    for (int i = 0; i < before; i++)
        to[i] = im->vertex[i];
    to += before;
    for (int i = 0; i < im->format.size[ATTR_POSITION]; i++)
        to[i] = i < size ? v[i] : attr_default[i];
    im->next += im->format.floats;
    if (FGL_UNLIKELY(++im->count >= im->max_count))
        wrap(ctx, im);
}
