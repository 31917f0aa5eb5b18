#include "pipeline/triangles.h"
#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

/* Fewer triangles than this are not worth waking another thread for, unless they are large. */
enum { SHARED_TRIANGLES = 1024, SHARED_SECTIONS = 4 };

bool fgl_triangles_init(struct triangle_list *t)
{
    if (!t->vertex)
        t->vertex = malloc(sizeof *t->vertex * TRIANGLES_MAX);
    if (!t->seen)
        t->seen = malloc(sizeof *t->seen * TRIANGLES_MAX);
    return t->vertex && t->seen;
}

void fgl_triangles_free(struct triangle_list *t)
{
    free(t->vertex);
    free(t->seen);
}

static void fill_triangle(struct pipeline *p, const struct raster_plan *raster, const struct seen_triangle *t)
{
    const struct vertex_cache *v = &p->cache;
    const struct emit_plan *emit = &p->plan.emit;
    const uint32_t a = t->vertex[0], b = t->vertex[1], c = t->vertex[2];
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

/* The pixels of a small triangle, to be drawn when a group is full. */
static void gather_pixels(struct pipeline *p, const struct raster_plan *raster, const struct seen_triangle *t, struct small_pixels *to)
{
    const void *v[3];
    for (int k = 0; k < 3; k++)
        v[k] = fgl_cache_record(&p->cache, &p->plan.emit, t->vertex[k]);
    for (uint32_t mask = t->mask; mask; mask &= mask - 1) {
        const int bit = fgl_lowest_bit(mask), y = t->y0 + bit / SMALL_SIDE;
        if (y < raster->bounds.y0 || y >= raster->bounds.y1)
            continue;
        const int i = to->n++;
        to->x[i] = t->x + bit % SMALL_SIDE;
        to->y[i] = y;
        to->vertex[0][i] = v[t->ccw ? 0 : 1];
        to->vertex[1][i] = v[t->ccw ? 1 : 0];
        to->vertex[2][i] = v[2];
        to->color[i] = raster->two_sided && t->ccw != raster->front_is_ccw ? raster->back_lane : LANE_COLOR;
        if (to->n == SMALL_PIXELS)
            raster->kernels->small_pixels(raster, to);
    }
}

static void fill_section(struct pipeline *p, const struct raster_plan *raster, const struct seen_triangle *t, int n, struct small_pixels *pixels)
{
    for (int i = 0; i < n; i++) {
        if (t[i].y0 >= raster->bounds.y1 || t[i].y1 <= raster->bounds.y0)
            continue;
        if (t[i].mask && raster->scatters) {
            gather_pixels(p, raster, &t[i], pixels);
        } else {
            raster->kernels->small_pixels(raster, pixels); /* in the order given */
            fill_triangle(p, raster, &t[i]);
        }
    }
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
    const struct raster_plan raster = fgl_raster_band(&job->p->plan.raster, band, job->bands);
    struct small_pixels pixels = {.n = 0};
    for (int k = 0; k < fgl_triangles_sections(t); k++)
        fill_section(job->p, &raster, t->seen + k * SECTION_TRIANGLES, t->section[k].n, &pixels);
    raster.kernels->small_pixels(&raster, &pixels);
}

/* One triangle after the other, each made known, for explain. */
static void fill_in_order(struct pipeline *p)
{
    const struct triangle_list *t = &p->triangles;
    for (int k = 0; k < fgl_triangles_sections(t); k++)
        for (int i = 0; i < t->section[k].n; i++) {
            const struct seen_triangle *seen = &t->seen[k * SECTION_TRIANGLES + i];
            p->primitive.n = 3;
            memcpy(p->primitive.vertex, seen->vertex, sizeof seen->vertex);
            fill_triangle(p, &p->plan.raster, seen);
        }
}

static void sieve_section(void *arg, int item, int worker)
{
    (void)worker;
    struct pipeline *p = arg;
    struct triangle_list *t = &p->triangles;
    const int first = item * SECTION_TRIANGLES;
    t->section[item] = p->plan.clip->sieve(p, t->vertex + first, fgl_min(t->n - first, SECTION_TRIANGLES), t->seen + first);
}

/* Sieves all sections. */
static void sieve(struct pipeline *p)
{
    struct triangle_list *t = &p->triangles;
    const int sections = fgl_triangles_sections(t);
    for (int i = t->n; i % SIEVE_GROUP; i++)
        memset(t->vertex[i], 0, sizeof t->vertex[i]);
    if (sections >= SHARED_SECTIONS && fgl_pipeline_workers(p)) {
        fgl_workers_run(p->workers, sections, sieve_section, p);
        return;
    }
    for (int i = 0; i < sections; i++)
        sieve_section(p, i, 0);
}

/* Fills what is seen: in bands of rows, if that is worth waking other threads. */
static void fill(struct pipeline *p)
{
    const struct triangle_list *t = &p->triangles;
    int64_t n = 0, area = 0;
    for (int k = 0; k < fgl_triangles_sections(t); k++) {
        n += t->section[k].n;
        area += t->section[k].area;
    }
    if (n == 0)
        return;
    const bool worth = n > 1 && (n >= SHARED_TRIANGLES || area >= SHARED_AREA);
    const struct rect *bounds = &p->plan.raster.bounds;
    struct fill_job job = {p, fgl_pipeline_bands(p, bounds->y1 - bounds->y0, worth)};
    if (job.bands > 1)
        fgl_workers_run(p->workers, job.bands, fill_band, &job);
    else
        fill_band(&job, 0, 0);
}

void fgl_triangles_flush(struct pipeline *p)
{
    struct triangle_list *t = &p->triangles;
    if (t->n == 0)
        return;
    sieve(p);
    if (p->unshaded)
        fgl_shade_listed(p);
    if (FGL_UNLIKELY(p->one_by_one))
        fill_in_order(p);
    else
        fill(p);
    t->n = 0;
}
