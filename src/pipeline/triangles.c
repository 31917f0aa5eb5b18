#include "pipeline/triangles.h"
#include "pipeline/pipeline.h"

#include <stdlib.h>

/* Fewer triangles, and less area, than this are not worth waking another thread for. */
enum { SHARED_TRIANGLES = 1024, SHARED_AREA = 1 << 16, BANDS_PER_WORKER = 4, MIN_BAND_ROWS = 8 };

bool fgl_triangles_init(struct triangle_list *t)
{
    if (!t->triangle)
        t->triangle = malloc(sizeof *t->triangle * TRIANGLES_MAX);
    return t->triangle;
}

void fgl_triangles_free(struct triangle_list *t)
{
    free(t->triangle);
    t->triangle = NULL;
}

void fgl_triangles_add_special(struct pipeline *p, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t *out = p->cache.outcode;
    struct triangle_list *t = &p->triangles;
    const struct rect *bounds = &p->plan.raster.bounds;
    if ((out[a] & out[b] & out[c]) || (out[a] | out[b] | out[c]) == 0) /* all outside of one plane, or too far away to draw */
        return;
    t->triangle[t->n++] = (struct listed_triangle){a, b, c, true, (int16_t)bounds->y0, (int16_t)bounds->y1};
    t->area += (int64_t)(bounds->x1 - bounds->x0) * (bounds->y1 - bounds->y0);
}

static void fill_triangle(struct pipeline *p, const struct raster_plan *raster, const struct listed_triangle *t)
{
    const struct vertex_cache *v = &p->cache;
    const struct emit_plan *emit = &p->plan.emit;
    const uint32_t a = t->a, b = t->b, c = t->c;
    const void *va = fgl_cache_record(v, emit, a), *vb = fgl_cache_record(v, emit, b), *vc = fgl_cache_record(v, emit, c);
    if (!t->clip) {
        fgl_raster_triangle(raster, va, vb, vc, vc);
        return;
    }
    const struct clip_vertices in = {.record = {va, vb, vc},
                                     .clip = {fgl_cache_clip(v, emit, a), fgl_cache_clip(v, emit, b), fgl_cache_clip(v, emit, c)},
                                     .provoking = vc,
                                     .outcode = v->outcode[a] | v->outcode[b] | v->outcode[c]};
    p->plan.clip->triangle(p, raster, &in);
}

/* Fills all triangles of the list within the rows of one band. */
struct fill_job {
    struct pipeline *p;
    int bands;
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
    for (int i = 0; i < t->n; i++)
        if (t->triangle[i].y0 < raster.bounds.y1 && t->triangle[i].y1 > raster.bounds.y0)
            fill_triangle(job->p, &raster, &t->triangle[i]);
}

/* One triangle after the other, each made known, for explain. */
static void fill_in_order(struct pipeline *p)
{
    struct triangle_list *t = &p->triangles;
    for (int i = 0; i < t->n; i++) {
        const struct listed_triangle *triangle = &t->triangle[i];
        p->primitive = (struct primitive){3, {triangle->a, triangle->b, triangle->c}};
        fill_triangle(p, &p->plan.raster, triangle);
    }
    t->n = 0;
    t->area = 0;
}

void fgl_triangles_flush(struct pipeline *p)
{
    struct triangle_list *t = &p->triangles;
    if (t->n == 0)
        return;
    if (p->unshaded)
        fgl_shade_listed(p);
    if (FGL_UNLIKELY(p->one_by_one)) {
        fill_in_order(p);
        return;
    }
    const bool worth = t->n > 1 && (t->n >= SHARED_TRIANGLES || t->area >= SHARED_AREA);
    struct workers *w = worth ? fgl_pipeline_workers(p) : NULL;
    struct fill_job job = {p, 1};
    if (w && fgl_workers_count(w) > 1) {
        const int height = p->plan.raster.bounds.y1 - p->plan.raster.bounds.y0;
        job.bands = fgl_clamp(height / MIN_BAND_ROWS, 1, fgl_workers_count(w) * BANDS_PER_WORKER);
        fgl_workers_run(w, job.bands, fill_band, &job);
    } else {
        fill_band(&job, 0, 0);
    }
    t->n = 0;
    t->area = 0;
}
