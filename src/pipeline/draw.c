/* Draws: the vertex stage over all vertices that the primitives name, batch by batch, then assembly. */
#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

struct pipeline *fgl_pipeline_create(void)
{
    struct pipeline *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    const char *path = getenv("FIXEDGL_PATH"), *debug = getenv("FIXEDGL_DEBUG");
    p->general = path && strcmp(path, "general") == 0;
    p->print_plan = debug && strcmp(debug, "plan") == 0;
    return p;
}

void fgl_pipeline_destroy(struct pipeline *p)
{
    if (!p)
        return;
    free(p->cache.record);
    free(p->cache.clip);
    free(p->cache.outcode);
    free(p->cache.edge_flag);
    free(p->elements);
    free(p);
}

static bool grow_array(void *array, size_t bytes)
{
    void **a = array;
    void *bigger = realloc(*a, bytes);
    if (bigger)
        *a = bigger;
    return bigger;
}

/* Room for n vertices and what the last batch writes beyond them. */
static bool reserve(struct vertex_cache *c, int n, int stride)
{
    if (n <= c->capacity && stride <= c->stride)
        return true;
    const int capacity = fgl_max(c->capacity, (n + FGL_BATCH_SIZE - 1) / FGL_BATCH_SIZE * FGL_BATCH_SIZE);
    const size_t room = (size_t)capacity + FGL_BATCH_PAD;
    if (!grow_array(&c->record, room * (size_t)fgl_max(stride, c->stride) * sizeof(float)) ||
        !grow_array(&c->clip, room * sizeof *c->clip) || !grow_array(&c->outcode, room * sizeof *c->outcode) ||
        !grow_array(&c->edge_flag, room * sizeof *c->edge_flag))
        return false;
    c->capacity = capacity;
    c->stride = fgl_max(stride, c->stride);
    return true;
}

/* The batch's results into the cache from vertex `at` on. */
static void store_batch(struct pipeline *p, int at)
{
    const struct vertex_batch *b = &p->batch;
    struct vertex_cache *c = &p->cache;
    fgl_emit(&p->plan.emit, b, c->record + (size_t)at * (size_t)p->plan.emit.stride);
    memcpy(c->outcode + at, b->outcode, (size_t)b->n * sizeof *c->outcode);
    if (b->outcode_any)
        for (int i = 0; i < b->n; i++)
            for (int k = 0; k < 4; k++)
                c->clip[at + i][k] = b->clip.c[k][i];
    if (p->plan.polygon_fill)
        return;
    const bool varying = b->varying & (1u << ATTR_EDGE_FLAG);
    for (int i = 0; i < b->n; i++)
        c->edge_flag[at + i] = varying ? b->in[ATTR_EDGE_FLAG].c[0][i] : p->plan.vertex.constant[ATTR_EDGE_FLAG][0];
}

/* The vertex stage over vertices first .. first+n of the source, to the cache's 0..n. */
static void run_vertices(struct pipeline *p, const struct vertex_source *source, uint32_t first, int n)
{
    for (int at = 0; at < n; at += FGL_BATCH_SIZE) {
        fgl_fetch(&p->batch, source, p->plan.fetch, first + (uint32_t)at, fgl_min(n - at, FGL_BATCH_SIZE));
        fgl_vertex_run(&p->plan.vertex, &p->batch, p->general);
        store_batch(p, at);
    }
}

void fgl_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims, int n,
              const uint32_t *elements, uint32_t min_index, uint32_t max_index)
{
    struct pipeline *p = ctx->pipeline;
    if (!ctx->framebuffer || !(source->varying & (1u << ATTR_POSITION)))
        return;
    fgl_pipeline_validate(ctx, source->varying);
    if (!p->plan.rasterize)
        return;
    const int vertices = (int)(max_index - min_index + 1);
    if (!reserve(&p->cache, vertices, p->plan.emit.stride)) {
        if (ctx->error == GL_NO_ERROR)
            ctx->error = GL_OUT_OF_MEMORY;
        return;
    }
    ctx->framebuffer->drawn = true;
    run_vertices(p, source, min_index, vertices);
    for (int i = 0; i < n; i++)
        fgl_assemble(p, &prims[i], elements, min_index, source->compiled);
}
