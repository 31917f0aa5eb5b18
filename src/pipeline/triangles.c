#include "pipeline/triangles.h"
#include "pipeline/pipeline.h"

#include <stdlib.h>

/* Fewer triangles, and less area, than this are not worth waking another thread for. */
enum { SHARED_TRIANGLES = 2048, SHARED_AREA = 1 << 16, BANDS_PER_WORKER = 4, MIN_BAND_ROWS = 8 };

bool fgl_triangles_init(struct triangle_list *t)
{
    if (t->a)
        return true;
    uint32_t *words = malloc(sizeof *words * 5 * TRIANGLES_MAX);
    if (!words)
        return false;
    t->a = words;
    t->b = words + TRIANGLES_MAX;
    t->c = words + 2 * TRIANGLES_MAX;
    t->visible = words + 3 * TRIANGLES_MAX;
    t->y0 = (int16_t *)(words + 4 * TRIANGLES_MAX);
    t->y1 = t->y0 + TRIANGLES_MAX;
    return true;
}

void fgl_triangles_free(struct triangle_list *t)
{
    free(t->a);
    t->a = NULL;
}

static void cull_item(void *job, int item, int worker)
{
    (void)worker;
    struct pipeline *p = job;
    struct triangle_list *t = &p->triangles;
    const int at = item * TRIANGLES_ITEM;
    const struct cull_input in = {p->cache.record, p->plan.emit.stride, t->a + at, t->b + at, t->c + at, TRIANGLE_CLIP,
                                  fgl_min(t->n - at, TRIANGLES_ITEM)};
    t->visible_count[item] = p->plan.raster.kernels->cull(&p->plan.raster, &in, t->y0 + at, t->y1 + at, t->visible + at, &t->area[item]);
}

static void fill_triangle(struct pipeline *p, const struct raster_plan *raster, uint32_t a, uint32_t b, uint32_t c)
{
    const struct vertex_cache *v = &p->cache;
    const size_t stride = (size_t)p->plan.emit.stride;
    const bool clip = a & TRIANGLE_CLIP;
    a &= ~(uint32_t)TRIANGLE_CLIP;
    const float *va = v->record + a * stride, *vb = v->record + b * stride, *vc = v->record + c * stride;
    if (!clip) {
        fgl_raster_triangle(raster, va, vb, vc, vc);
        return;
    }
    const struct clip_vertices in = {.record = {va, vb, vc},
                                     .clip = {v->clip[a], v->clip[b], v->clip[c]},
                                     .provoking = vc,
                                     .outcode = v->outcode[a] | v->outcode[b] | v->outcode[c]};
    fgl_clip_triangle(p, raster, &in);
}

/* Fills all triangles of the list within the rows of one band. */
struct fill_job {
    struct pipeline *p;
    int items, bands;
};

static void fill_band(void *arg, int band, int worker)
{
    (void)worker;
    const struct fill_job *job = arg;
    const struct triangle_list *t = &job->p->triangles;
    struct raster_plan raster = job->p->plan.raster;
    const int height = raster.bounds.y1 - raster.bounds.y0, top = raster.bounds.y0;
    raster.bounds.y0 = top + height * band / job->bands;
    raster.bounds.y1 = top + height * (band + 1) / job->bands;
    for (int item = 0; item < job->items; item++) {
        const uint32_t *visible = t->visible + item * TRIANGLES_ITEM;
        for (int k = 0; k < t->visible_count[item]; k++) {
            const uint32_t i = (uint32_t)(item * TRIANGLES_ITEM) + visible[k];
            if (t->y0[i] < raster.bounds.y1 && t->y1[i] > raster.bounds.y0)
                fill_triangle(job->p, &raster, t->a[i], t->b[i], t->c[i]);
        }
    }
}

static void share(struct pipeline *p, bool worth, int items, fgl_task *task, void *job)
{
    struct workers *w = worth ? fgl_pipeline_workers(p) : NULL;
    if (w) {
        fgl_workers_run(w, items, task, job);
        return;
    }
    for (int i = 0; i < items; i++)
        task(job, i, 0);
}

void fgl_triangles_flush(struct pipeline *p)
{
    struct triangle_list *t = &p->triangles;
    if (t->n == 0)
        return;
    const int items = (t->n + TRIANGLES_ITEM - 1) / TRIANGLES_ITEM;
    share(p, t->n >= SHARED_TRIANGLES, items, cull_item, p);
    int64_t area = 0;
    int visible = 0;
    for (int i = 0; i < items; i++) {
        area += t->area[i];
        visible += t->visible_count[i];
    }
    if (visible) {
        const bool worth = visible > 1 && (visible >= SHARED_TRIANGLES || area >= SHARED_AREA);
        const int height = p->plan.raster.bounds.y1 - p->plan.raster.bounds.y0;
        const struct workers *w = worth ? fgl_pipeline_workers(p) : NULL;
        const int workers = w ? fgl_workers_count(w) : 1;
        struct fill_job job = {p, items, workers == 1 ? 1 : fgl_clamp(height / MIN_BAND_ROWS, 1, workers * BANDS_PER_WORKER)};
        share(p, workers > 1, job.bands, fill_band, &job);
    }
    t->n = 0;
}
