/* Draws: the vertex stage over all vertices that the primitives name, batch by batch, then assembly. */
#include "pipeline/explain.h"
#include "pipeline/pipeline.h"
#include "pipeline/plan_report.h"
#include "state/share.h"

#include <stdlib.h>
#include <string.h>

enum { PARALLEL_BATCHES = 4, BANDS_PER_WORKER = 4, MIN_BAND_ROWS = 8 };

struct pipeline *fgl_pipeline_create(void)
{
    struct pipeline *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    const char *path = getenv("FIXEDGL_PATH"), *debug = getenv("FIXEDGL_DEBUG");
    p->general = path && strcmp(path, "general") == 0;
    p->print_plan = debug && strcmp(debug, "plan") == 0;
    fgl_explain_from_environment(p);
    fgl_plan_report_from_environment(p);
    return p;
}

void fgl_pipeline_destroy(struct pipeline *p)
{
    if (!p)
        return;
    free(p->cache.record);
    free(p->cache.clip);
    free(p->cache.outcode);
    free(p->cache.snapped);
    free(p->cache.edge_flag);
    free(p->cache.chunk);
    free(p->elements);
    fgl_triangles_free(&p->triangles);
    fgl_explain_stop(p);
    fgl_plan_report_free(p);
    fgl_workers_destroy(p->workers);
    for (int i = 0; i < FGL_MAX_WORKERS; i++)
        free(p->batch[i]);
    free(p);
}

struct workers *fgl_pipeline_workers(struct pipeline *p)
{
    if (!p->workers)
        p->workers = fgl_workers_create(fgl_workers_default());
    return p->workers;
}

int fgl_pipeline_bands(struct pipeline *p, int rows, bool worth)
{
    const struct workers *w = worth ? fgl_pipeline_workers(p) : NULL;
    const int count = w ? fgl_workers_count(w) : 1;
    return count > 1 ? fgl_clamp(rows / MIN_BAND_ROWS, 1, count * BANDS_PER_WORKER) : 1;
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
static bool reserve(struct vertex_cache *c, int n, const struct emit_plan *emit)
{
    if (n <= c->capacity && emit->record_bytes <= c->record_bytes && emit->clip_bytes <= c->clip_bytes)
        return true;
    const size_t record = emit->record_bytes > c->record_bytes ? emit->record_bytes : c->record_bytes;
    const size_t clip = emit->clip_bytes > c->clip_bytes ? emit->clip_bytes : c->clip_bytes;
    const int capacity = fgl_max(c->capacity, (n + FGL_BATCH_SIZE - 1) / FGL_BATCH_SIZE * FGL_BATCH_SIZE);
    const size_t room = (size_t)capacity + FGL_BATCH_PAD;
    if (!grow_array(&c->record, room * record) || !grow_array(&c->clip, room * clip) ||
        !grow_array(&c->outcode, room * sizeof *c->outcode) ||
        !grow_array(&c->edge_flag, room * sizeof *c->edge_flag) || !grow_array(&c->snapped, room * sizeof *c->snapped))
        return false;
    c->capacity = capacity;
    c->record_bytes = record;
    c->clip_bytes = clip;
    return true;
}

/* The batch's results into the cache from vertex `at` on. */
static void store_batch(struct pipeline *p, const struct vertex_batch *b, int at)
{
    struct vertex_cache *c = &p->cache;
    unsigned char *record = c->record + (size_t)at * p->plan.emit.record_bytes,
                  *clip = c->clip + (size_t)at * p->plan.emit.clip_bytes;
    if (p->unshaded)
        fgl_emit_positions(&p->plan.emit, b, record, clip);
    else
        fgl_emit(&p->plan.emit, b, record, clip);
    if (FGL_UNLIKELY(p->plan.feedback.texture_coords))
        fgl_feedback_emit(&p->plan, b, record);
    memcpy(c->outcode + at, b->outcode, (size_t)b->n * sizeof *c->outcode);
    if (p->plan.polygon_fill) {
        p->plan.raster.kernels->snap(b, c->snapped + at);
        return;
    }
    const bool varying = b->varying & (1u << ATTR_EDGE_FLAG);
    for (int i = 0; i < b->n; i++)
        c->edge_flag[at + i] = varying ? b->in[ATTR_EDGE_FLAG].c[0][i] : p->plan.vertex.constant[ATTR_EDGE_FLAG][0];
}

static void run_batch(void *arg, int item, int worker)
{
    const struct vertex_job *job = arg;
    struct pipeline *p = job->p;
    struct vertex_batch *b = p->batch[worker];
    const int at = item * FGL_BATCH_SIZE;
    const uint32_t attributes = p->unshaded ? 1u << ATTR_POSITION : p->plan.fetch;
    fgl_fetch(b, job->source, attributes, job->first + (uint32_t)at, fgl_min(job->n - at, FGL_BATCH_SIZE));
    if (p->unshaded)
        fgl_vertex_positions(&p->plan.vertex, b);
    else
        fgl_vertex_run(&p->plan.vertex, b, p->general);
    store_batch(p, b, at);
}

int fgl_pipeline_share(struct pipeline *p, bool worth)
{
    const struct workers *w = worth ? fgl_pipeline_workers(p) : NULL;
    const int count = w ? fgl_workers_count(w) : 1;
    for (int i = 0; i < count; i++)
        if (!p->batch[i] && !(p->batch[i] = calloc(1, sizeof *p->batch[i])))
            return i > 0; /* those that have a batch */
    return count;
}

static bool run_vertices(struct pipeline *p, struct vertex_job *job)
{
    const int batches = (job->n + FGL_BATCH_SIZE - 1) / FGL_BATCH_SIZE;
    const int workers = fgl_pipeline_share(p, batches >= PARALLEL_BATCHES);
    if (workers > 1) {
        fgl_workers_run(p->workers, batches, run_batch, job);
        return true;
    }
    for (int i = 0; workers && i < batches; i++)
        run_batch(job, i, 0);
    return workers > 0;
}

static void out_of_memory(struct context *ctx)
{
    if (ctx->error == GL_NO_ERROR)
        ctx->error = GL_OUT_OF_MEMORY;
}

void fgl_assemble_all(struct pipeline *p, const struct draw_prim *prims, int n, const uint32_t *elements, uint32_t base, bool compiled)
{
    for (int i = 0; i < n; i++)
        fgl_assemble(p, &prims[i], elements, base, compiled);
    fgl_triangles_flush(p);
}

/* Whether the draw's vertices may be shaded when it is known which are seen (shade.c). */
static bool may_wait(const struct pipeline *p, const struct draw_prim *prims, int n)
{
    bool filled = p->plan.seen_first && !p->report && !p->explain;
    for (int i = 0; i < n; i++)
        filled &= prims[i].mode >= GL_TRIANGLES;
    return filled;
}

static void draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims, int n,
                 const uint32_t *elements, uint32_t min_index, uint32_t max_index)
{
    struct pipeline *p = ctx->pipeline;
    if (!ctx->framebuffer || !(source->varying & (1u << ATTR_POSITION)))
        return;
    fgl_pipeline_validate(ctx, source->varying);
    if (!p->plan.rasterize)
        return;
    const int vertices = (int)(max_index - min_index + 1);
    if (!reserve(&p->cache, vertices, &p->plan.emit) || !fgl_triangles_init(&p->triangles)) {
        out_of_memory(ctx);
        return;
    }
    ctx->framebuffer->drawn = true;
    p->cache.used = vertices;
    p->cache.range_unknown = elements && source->range_unknown;
    struct vertex_job job = {p, source, min_index, vertices};
    p->unshaded = may_wait(p, prims, n) && fgl_shade_later(p, &job) ? &job : NULL;
    if (!run_vertices(p, &job)) {
        p->unshaded = NULL;
        out_of_memory(ctx);
        return;
    }
    if (FGL_UNLIKELY(p->report != NULL))
        fgl_plan_report_note(ctx, source, min_index, vertices);
    if (FGL_UNLIKELY(p->explain != NULL))
        fgl_explain_draw(ctx, source, prims, n, elements, min_index);
    else
        fgl_assemble_all(p, prims, n, elements, min_index, source->compiled);
    p->unshaded = NULL;
}

void fgl_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims, int n,
              const uint32_t *elements, uint32_t min_index, uint32_t max_index)
{
    FGL_SHARED(ctx, draw(ctx, source, prims, n, elements, min_index, max_index));
}
