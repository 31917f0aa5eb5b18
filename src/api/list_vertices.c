/* Vertices in display lists: recorded as a ready batch, drawn straight from the list (GL 1.5, 5.4).
 * A batch whose primitives begin or end outside the list, or that is called inside Begin/End, is replayed vertex by vertex. */
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/list.h"

#include <string.h>

struct compiled_vertices {
    struct vertex_format format;
    int count, prim_count;
    bool whole; /* every primitive begins and ends here */
    bool keeps_current; /* current values are afterwards as before: OSMesa rule if the last primitive is one of vertex arrays */
    int unset[ATTR_COUNT]; /* vertices before the attribute's first value: theirs is the current one */
    struct immediate_prim prim[IMMEDIATE_MAX_PRIMS];
    float last[VERTEX_MAX_FLOATS]; /* current values afterwards */
    float vertex[];
};

/* Gives vertices recorded before an attribute's first value in the list the current value. */
static void fill_unset(struct context *ctx, struct compiled_vertices *c)
{
    for (int a = 1; a < ATTR_COUNT; a++)
        for (int v = 0; v < c->unset[a]; v++)
            memcpy(c->vertex + (size_t)v * (size_t)c->format.floats + c->format.offset[a], fgl_current_attr(ctx, a),
                   c->format.size[a] * sizeof(float));
}

static void replay_vertex(struct context *ctx, const struct compiled_vertices *c, int v)
{
    const float *from = c->vertex + (size_t)v * (size_t)c->format.floats;
    for (int a = 1; a < ATTR_COUNT; a++)
        if ((c->format.active & (1u << a)) && v >= c->unset[a])
            fgl_attr_set(ctx, (enum fgl_attr)a, c->format.size[a], from + c->format.offset[a]);
    fgl_vertex(ctx, c->format.size[ATTR_POSITION], from + c->format.before_position);
}

static void replay_by_vertex(struct context *ctx, const struct compiled_vertices *c)
{
    for (int i = 0; i < c->prim_count; i++) {
        const struct immediate_prim *p = &c->prim[i];
        if (p->begin) {
            RETURN_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
            fgl_begin(ctx, p->mode);
        }
        for (int v = p->first; v < p->first + p->count; v++)
            replay_vertex(ctx, c, v);
        if (p->end) {
            RETURN_ERROR_IF(ctx, ctx->begin_mode == OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
            fgl_end(ctx);
        }
    }
}

void fgl_list_record_vertices(struct context *ctx, struct immediate *im)
{
    const size_t bytes = (size_t)im->count * (size_t)im->format.floats * sizeof(float);
    struct compiled_vertices *node = fgl_list_record(ctx, OP_VERTICES, sizeof *node + bytes);
    if (!node)
        return;
    node->format = im->format;
    node->count = im->count;
    node->prim_count = im->prim_count;
    node->whole = im->count > 0;
    for (int i = 0; i < im->prim_count; i++)
        node->whole = node->whole && im->prim[i].begin && im->prim[i].end;
    node->keeps_current = im->of_arrays;
    memcpy(node->unset, im->unset, sizeof node->unset);
    memcpy(node->prim, im->prim, sizeof node->prim);
    memcpy(node->last, im->vertex, sizeof node->last);
    memcpy(node->vertex, im->store, bytes);
    if (ctx->compiling == GL_COMPILE_AND_EXECUTE) { /* OSMesa rule: drawn in the immediate way, unlike the list */
        ctx->compiling = 0;
        ctx->vertices = ctx->immediate;
        replay_by_vertex(ctx, node);
        ctx->compiling = GL_COMPILE_AND_EXECUTE;
        ctx->vertices = im;
    }
}

void fgl_list_replay_vertices(struct context *ctx, void *payload)
{
    struct compiled_vertices *c = payload;
    if (!fgl_draw_ready(ctx))
        return;
    if (!c->whole || ctx->begin_mode != OUTSIDE_BEGIN_END) {
        replay_by_vertex(ctx, c);
        return;
    }
    fgl_flush_for_arrays(ctx);
    fill_unset(ctx, c);
    struct draw_prim prims[IMMEDIATE_MAX_PRIMS];
    for (int i = 0; i < c->prim_count; i++)
        prims[i] = (struct draw_prim){c->prim[i].mode, c->prim[i].first, c->prim[i].count, false};
    struct vertex_source source;
    fgl_format_source(&c->format, c->vertex, &source);
    source.compiled = true;
    fgl_draw(ctx, &source, prims, c->prim_count, NULL, 0, (uint32_t)c->count - 1);
    if (!c->keeps_current) {
        fgl_flush_all(ctx); /* what was set before the list must not come back */
        fgl_format_to_current(ctx, &c->format, c->last);
    }
}
