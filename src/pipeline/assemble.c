/* Primitive assembly (GL 1.5, 2.6.1 "Begin and End Objects"): the ten primitives as points, lines and triangles.
 *
 * The last vertex of a triangle, as passed on here, is the provoking one (table 2.12). Which diagonal splits a quad, and where a
 * triangle's vertices begin, decide last bits of its interpolation, so OSMesa's orders are kept. Edge numbers: bit i of `edges` is the
 * edge from the triangle's vertex i to the next; only edges of the primitive itself are boundaries (2.6.2 "Polygon Edges"). */
#include "pipeline/pipeline.h"

/* filled, and whether there are elements, are constants where it matters: see the end of the file. */
struct assembly {
    struct pipeline *p;
    const uint32_t *elements;
    int first;
    uint32_t base;
    bool filled;
    uint32_t (*next)[3]; /* filled: where in the list the next triangle goes */
    const struct raster_plan *raster; /* points and lines: the plan, or that for a band of rows */
};

static FGL_ALWAYS_INLINE uint32_t number(const struct assembly *a, int i)
{
    const uint32_t n = (uint32_t)(a->first + i);
    return (a->elements ? a->elements[n] : n) - a->base;
}

static inline const void *record(const struct pipeline *p, uint32_t v)
{
    return fgl_cache_record(&p->cache, &p->plan.emit, v);
}

static inline const void *clip(const struct pipeline *p, uint32_t v)
{
    return fgl_cache_clip(&p->cache, &p->plan.emit, v);
}

/* A filled triangle: into the list. */
static FGL_ALWAYS_INLINE void add_filled(struct assembly *as, uint32_t a, uint32_t b, uint32_t c)
{
    struct triangle_list *t = &as->p->triangles;
    if (FGL_UNLIKELY(as->next == t->vertex + TRIANGLES_MAX)) {
        t->n = TRIANGLES_MAX;
        fgl_triangles_flush(as->p);
        as->next = t->vertex;
    }
    uint32_t *vertex = *as->next++;
    vertex[0] = a;
    vertex[1] = b;
    vertex[2] = c;
}

/* Makes it known to explain. */
static inline void note_primitive(struct pipeline *p, const struct primitive *primitive)
{
    if (FGL_UNLIKELY(p->one_by_one))
        p->primitive = *primitive;
}

/* A triangle some face of which is drawn as lines or points. */
static FGL_NOINLINE void polygon_mode(struct pipeline *p, uint32_t a, uint32_t b, uint32_t c, unsigned edges)
{
    const struct vertex_cache *v = &p->cache;
    const void *va = record(p, a), *vb = record(p, b), *vc = record(p, c);
    note_primitive(p, &(struct primitive){3, {a, b, c}});
    const struct clip_vertices in = {
        .record = {va, vb, vc},
        .clip = {clip(p, a), clip(p, b), clip(p, c)},
        .provoking = vc,
        .outcode = v->outcode[a] | v->outcode[b] | v->outcode[c],
        .edges = edges,
    };
    if (v->outcode[a] & v->outcode[b] & v->outcode[c])
        return;
    if (in.outcode)
        p->plan.clip->triangle(p, &p->plan.raster, &in);
    else
        fgl_raster_polygon_mode(&p->plan.raster, va, vb, vc, vc, edges, &p->stipple_counter);
}

static FGL_ALWAYS_INLINE void triangle(struct assembly *as, int i0, int i1, int i2, unsigned edges)
{
    struct pipeline *p = as->p;
    const uint32_t a = number(as, i0), b = number(as, i1), c = number(as, i2);
    if (as->filled)
        add_filled(as, a, b, c);
    else
        polygon_mode(p, a, b, c, edges);
}

static void line(const struct assembly *as, int i0, int i1, int *stipple_counter)
{
    struct pipeline *p = as->p;
    const uint32_t a = number(as, i0), b = number(as, i1);
    const struct vertex_cache *v = &p->cache;
    const void *va = record(p, a), *vb = record(p, b);
    note_primitive(p, &(struct primitive){2, {a, b, 0}});
    if ((v->outcode[a] | v->outcode[b]) == 0) {
        fgl_raster_line(as->raster, va, vb, vb, stipple_counter);
    } else if ((v->outcode[a] & v->outcode[b]) == 0) {
        const struct clip_vertices in = {.record = {va, vb},
                                         .clip = {clip(p, a), clip(p, b)},
                                         .provoking = vb,
                                         .outcode = v->outcode[a] | v->outcode[b]};
        p->plan.clip->line(p, as->raster, &in, stipple_counter);
    }
}

/* The edge flag of vertex i as bit `bit`. */
static FGL_ALWAYS_INLINE unsigned edge(const struct assembly *as, int i, int bit)
{
    return as->filled ? 0 : (as->p->cache.edge_flag[number(as, i)] != 0.0f ? 1u << bit : 0);
}

/* The size of the point at vertex v. */
static float point_size(const struct pipeline *p, uint32_t v)
{
    const int lane = p->plan.raster.size_lane;
    if (!lane)
        return p->plan.raster.point_size;
    return p->plan.emit.arith == ARITH_EXACT ? (float)((const double *)record(p, v))[lane] : ((const float *)record(p, v))[lane];
}

static void points(const struct assembly *as, int n)
{
    struct pipeline *p = as->p;
    for (int i = 0; i < n; i++) {
        const uint32_t v = number(as, i);
        note_primitive(p, &(struct primitive){1, {v, 0, 0}});
        if (p->cache.outcode[v] == 0)
            fgl_raster_point(as->raster, record(p, v), point_size(p, v));
    }
}

/* The counter of line stipple goes on along strips and loops and starts anew for each of GL_LINES (3.4.2 "Line Stipple"). */
static void lines(const struct assembly *as, const struct draw_prim *prim, int *counter)
{
    const int n = prim->count;
    if (!prim->goes_on)
        *counter = 0;
    if (prim->mode == GL_LINES) {
        for (int i = 0; i + 1 < n; i += 2, *counter = 0)
            line(as, i, i + 1, counter);
        return;
    }
    for (int i = 0; i + 1 < n; i++)
        line(as, i, i + 1, counter);
    if (prim->mode == GL_LINE_LOOP && n > 1)
        line(as, n - 1, 0, counter);
}

/* Lines in bands of rows that workers share. Points are not: to find out which a band has would take as long as to draw them. */
struct line_job {
    const struct assembly *as;
    const struct draw_prim *prim;
    int bands, stipple_counter; /* which runs alike in all of them */
};

static void line_band(void *arg, int band, int worker)
{
    (void)worker;
    struct line_job *job = arg;
    struct assembly as = *job->as;
    const struct raster_plan raster = fgl_raster_band(as.raster, band, job->bands);
    int counter = as.p->stipple_counter;
    as.raster = &raster;
    lines(&as, job->prim, &counter);
    if (band == 0)
        job->stipple_counter = counter;
}

/* Fewer vertices than this are not worth waking another thread for. */
enum { SHARED_VERTICES = 1024 };

static void share_lines(const struct assembly *as, const struct draw_prim *prim)
{
    struct pipeline *p = as->p;
    const struct raster_plan *raster = as->raster;
    const bool drawn = raster->line == raster->kernels->line; /* not taken by feedback or selection */
    const bool worth = prim->count >= SHARED_VERTICES && drawn && !p->one_by_one;
    struct line_job job = {as, prim, fgl_pipeline_bands(p, raster->bounds.y1 - raster->bounds.y0, worth), 0};
    if (job.bands > 1)
        fgl_workers_run(p->workers, job.bands, line_band, &job);
    else
        line_band(&job, 0, 0);
    p->stipple_counter = job.stipple_counter;
}

static FGL_ALWAYS_INLINE void triangles(struct assembly *as, int n)
{
    for (int i = 0; i + 2 < n; i += 3)
        triangle(as, i, i + 1, i + 2, edge(as, i, 0) | edge(as, i + 1, 1) | edge(as, i + 2, 2));
}

static FGL_ALWAYS_INLINE void triangle_strip(struct assembly *as, int n)
{
    for (int i = 0; i + 2 < n; i++)
        triangle(as, i + (i & 1), i + 1 - (i & 1), i + 2, 7);
}

static FGL_ALWAYS_INLINE void triangle_fan(struct assembly *as, int n)
{
    for (int i = 2; i < n; i++)
        triangle(as, 0, i - 1, i, 7);
}

static FGL_ALWAYS_INLINE void polygon(struct assembly *as, int n)
{
    for (int i = 2; i < n; i++)
        triangle(as, i - 1, i, 0,
                 edge(as, i - 1, 0) | (i == n - 1 ? edge(as, i, 1) : 0) | (i == 2 ? edge(as, 0, 2) : (unsigned)EDGES_GO_ON));
}

/* Whether a vertex from start to end lies outside the volume. OSMesa rule: with elements that are no fewer than the vertices of their range, any of
 * the range, where that is known. */
static bool any_outside(const struct assembly *as, int start, int end)
{
    uint32_t outside = 0;
    const struct vertex_cache *c = &as->p->cache;
    if (as->elements && !as->p->cache.range_unknown && c->used <= end - start) {
        for (int i = 0; i < c->used; i++)
            outside |= c->outcode[i];
        return outside != 0;
    }
    for (int i = start; i < end; i++)
        outside |= as->p->cache.outcode[number(as, i)];
    return outside != 0;
}

/* OSMesa rule: which half of a quad comes first, which shows where the halves overlap, depends on whether a vertex of the segment has to be
 * clipped, or all are decomposed. */
static FGL_ALWAYS_INLINE void quad_strip(struct assembly *as, int n)
{
    n -= n % 2;
    for (int start = 0; start + 3 < n; start += FGL_BATCH_SIZE - 2) {
        const int end = fgl_min(n, start + FGL_BATCH_SIZE);
        const bool simple = !as->p->plan.decomposed && !any_outside(as, start, end);
        for (int i = start; i + 3 < end; i += 2) {
            if (simple)
                triangle(as, i, i + 1, i + 3, 0);
            triangle(as, i + 2, i, i + 3, 1 | 4);
            if (!simple)
                triangle(as, i, i + 1, i + 3, 1 | 2 | EDGES_GO_ON);
        }
    }
}

static FGL_ALWAYS_INLINE void quad_by_first_diagonal(struct assembly *as, int i)
{
    triangle(as, i, i + 1, i + 2, 0);
    triangle(as, i, i + 2, i + 3, 0);
}

static FGL_ALWAYS_INLINE void quad_by_second_diagonal(struct assembly *as, int i)
{
    triangle(as, i, i + 1, i + 3, edge(as, i, 0) | edge(as, i + 3, 2));
    triangle(as, i + 1, i + 2, i + 3, edge(as, i + 1, 0) | edge(as, i + 2, 1) | EDGES_GO_ON);
}

/* OSMesa rule: a quad's diagonal is from its first vertex when the draw is smooth, not decomposed, neither indexed nor from a display list, and none of
 * the vertices of its segment, 1024 of them, lies outside the volume; else from its second. */
static FGL_ALWAYS_INLINE void quads(struct assembly *as, int n, bool compiled)
{
    const struct pipeline *p = as->p;
    const bool simple = !p->plan.decomposed && !p->plan.raster.flat && !p->plan.fragment.flat_sum && !as->elements && !compiled;
    n -= n % 4; /* the vertices of an incomplete quad do not count */
    for (int start = 0; start + 3 < n; start += FGL_BATCH_SIZE) {
        const int end = fgl_min(n, start + FGL_BATCH_SIZE);
        const bool first = simple && !any_outside(as, start, end);
        for (int i = start; i + 3 < end; i += 4) {
            if (first)
                quad_by_first_diagonal(as, i);
            else
                quad_by_second_diagonal(as, i);
        }
    }
}

static FGL_ALWAYS_INLINE void polygons(struct assembly *as, GLenum mode, int n, bool compiled)
{
    switch (mode) {
    case GL_TRIANGLES: triangles(as, n); break;
    case GL_TRIANGLE_STRIP: triangle_strip(as, n); break;
    case GL_TRIANGLE_FAN: triangle_fan(as, n); break;
    case GL_QUADS: quads(as, n, compiled); break;
    case GL_QUAD_STRIP: quad_strip(as, n); break;
    case GL_POLYGON: polygon(as, n); break;
    default: break;
    }
}

/* Polygons that are filled, into the list. */
static FGL_ALWAYS_INLINE void filled(struct pipeline *p, const struct draw_prim *prim, const uint32_t *elements, uint32_t base, bool compiled)
{
    struct triangle_list *t = &p->triangles;
    struct assembly as = {p, elements, prim->first, base, true, t->vertex + t->n, NULL};
    polygons(&as, prim->mode, prim->count, compiled);
    t->n = (int)(as.next - t->vertex);
}

void fgl_assemble(struct pipeline *p, const struct draw_prim *prim, const uint32_t *elements, uint32_t base, bool compiled)
{
    struct assembly as = {p, elements, prim->first, base, false, NULL, &p->plan.raster};
    if (prim->mode < GL_TRIANGLES)
        fgl_triangles_flush(p); /* in the order given */
    if (prim->mode == GL_POINTS)
        points(&as, prim->count);
    else if (prim->mode < GL_TRIANGLES)
        share_lines(&as, prim);
    else if (!p->plan.polygon_fill)
        polygons(&as, prim->mode, prim->count, compiled);
    else if (elements)
        filled(p, prim, elements, base, false);
    else
        filled(p, prim, NULL, base, compiled);
}
