/* The probe: a draw's primitives, one after the other, drawn to one pixel alone; see explain.h. */
#include "pipeline/explain.h"

#include <stdlib.h>
#include <string.h>

/* One assembly of a primitive for the pixel. */
struct probe {
    struct fragment_plan
            plan; /* what the rasterizer sees: its kernels are the functions below. First member */
    struct pipeline *p;
    struct explain *e;
    struct fragment_plan real;
    int row;
    struct explain_event about; /* draw, call, mode and prim of the events */
    const struct draw_prim *prim;
    uint32_t base;

    int covered;                /* fragments so far */
    int drawn;                  /* which of them wrote colour last, or -1 */
    struct primitive primitive; /* that one's, and its event */
    struct explain_event event;
    struct vertex_trace lit; /* its terms, for COLOR_LIT */
    float weight[4];
};

/* A vertex's number in its primitive. */
static int number_in(const struct probe *probe, uint32_t vertex)
{
    return (int)(vertex + probe->base) - probe->prim->first;
}

/* Which triangle, quad or line of glBegin .. glEnd the vertices are. */
static int part_number(const struct probe *probe)
{
    const struct primitive *v = &probe->p->primitive;
    int low = number_in(probe, v->vertex[0]), high = low;
    for (int i = 1; i < v->n; i++) {
        const int number = number_in(probe, v->vertex[i]);
        low = fgl_min(low, number);
        high = fgl_max(high, number);
    }
    switch (probe->prim->mode) {
    case GL_LINES: return low / 2;
    case GL_LINE_LOOP: return low == 0 && high > 1 ? high : low;
    case GL_TRIANGLES: return low / 3;
    case GL_TRIANGLE_FAN: return high - 2;
    case GL_QUADS: return low / 4;
    case GL_QUAD_STRIP: return low / 2;
    case GL_POLYGON: return 0;
    default: return low; /* points, line strips, triangle strips */
    }
}

/* A fragment at the pixel: notes its stages, then draws it. */
static void note_fragment(struct probe *probe, const struct planes *planes, const struct runs *runs,
                          fragment_fill_fn *fill)
{
    struct explain *e = probe->e;
    const struct framebuffer *fb = probe->real.fb;
    struct explain_event event = probe->about;
    if (runs->n < 1 || runs->x0[0] >= runs->x1[0])
        return;
    const int which = probe->covered++;
    fgl_explain_stages(&e->scratch, &probe->real, planes, probe->row, e->x, &event.fragment);
    event.before = fgl_explain_pixel(fb, probe->row, e->x);
    fill(&probe->real, planes, runs);
    event.after = fgl_explain_pixel(fb, probe->row, e->x);
    if (!event.fragment.covered)
        return;
    event.outcome = event.fragment.outcome;
    event.number = part_number(probe);
    *fgl_explain_add(e, event.outcome) = event;
    if (event.outcome != OUTCOME_DRAWN)
        return;
    probe->drawn = which;
    probe->primitive = probe->p->primitive;
    probe->event = event;
    if (probe->real.color_source == COLOR_LIT)
        fgl_explain_lit(&e->scratch, &probe->real, planes, probe->row, e->x, &probe->lit);
}

static struct probe *probe_of(const struct fragment_plan *plan)
{
    return (struct probe *)(uintptr_t)plan; /* its first member */
}

static void note_fill(const struct fragment_plan *plan, const struct planes *planes, const struct runs *runs)
{
    note_fragment(probe_of(plan), planes, runs, probe_of(plan)->real.fill);
}

static void note_general(const struct fragment_plan *plan, const struct planes *planes,
                         const struct runs *runs)
{
    note_fragment(probe_of(plan), planes, runs, probe_of(plan)->real.general);
}

/* The weights of the vertices, which are red, green and blue, in the fragment that was drawn. */
static void weigh_fill(const struct fragment_plan *plan, const struct planes *planes, const struct runs *runs)
{
    struct probe *probe = probe_of(plan);
    if (runs->n < 1 || runs->x0[0] >= runs->x1[0])
        return;
    if (probe->covered++ == probe->drawn)
        fgl_explain_color(&probe->e->scratch, &probe->real, planes, probe->row, probe->e->x, probe->weight);
}

/* The plan of the rasterizer for this pixel alone, with its fragments going to the probe. */
static void aim(struct probe *probe, fragment_fill_fn *fill, fragment_fill_fn *general)
{
    struct raster_plan *raster = &probe->p->plan.raster;
    probe->plan = probe->real;
    probe->plan.fill = fill;
    probe->plan.general = general;
    probe->covered = 0;
    raster->fragment = &probe->plan;
    raster->bounds = (struct rect){probe->e->x, probe->row, probe->e->x + 1, probe->row + 1};
}

static void assemble(struct probe *probe, const uint32_t *elements, bool compiled)
{
    struct pipeline *p = probe->p;
    p->one_by_one = true;
    fgl_assemble_all(p, probe->prim, 1, elements, probe->base, compiled);
    p->one_by_one = false;
}

/* Records of position and colour, and of the point's size if it differs by vertex, where the drawn primitive's
 * vertices are red, green and blue and all others black. */
static unsigned char *make_weight_records(const struct probe *probe, const struct emit_plan *emit, int n)
{
    const struct pipeline *p = probe->p;
    const size_t lane = emit->arith == ARITH_EXACT ? sizeof(double) : sizeof(float);
    const size_t size_from = (size_t)p->plan.emit.size_lane * lane, size_to = (size_t)emit->size_lane * lane;
    unsigned char *record = calloc((size_t)n, emit->record_bytes);
    if (!record)
        return NULL;
    for (int i = 0; i < n; i++) {
        const unsigned char *drawn = fgl_cache_record(&p->cache, &p->plan.emit, (uint32_t)i);
        unsigned char *v = record + (size_t)i * emit->record_bytes;
        memcpy(v, drawn, LANE_COLOR * lane);
        if (size_to)
            memcpy(v + size_to, drawn + size_from, lane);
    }
    for (int i = 0; i < probe->primitive.n; i++) {
        unsigned char *v = record + probe->primitive.vertex[i] * emit->record_bytes + (size_t)(LANE_COLOR + i) * lane;
        if (emit->arith == ARITH_EXACT)
            *(double *)(void *)v = 1;
        else
            *(float *)(void *)v = 1;
    }
    return record;
}

static bool weigh(struct probe *probe, const uint32_t *elements, bool compiled, int n)
{
    struct pipeline *p = probe->p;
    const struct plan plan = p->plan;
    struct emit_plan emit = plan.emit;
    emit.size_lane = plan.emit.size_lane ? LANE_SECONDARY : 0;
    fgl_emit_layout(&emit, emit.arith, LANE_SECONDARY + (emit.size_lane ? LANE_GROUP : 0));
    unsigned char *const record = p->cache.record, *weights = make_weight_records(probe, &emit, n);
    if (!weights)
        return false;
    aim(probe, weigh_fill, weigh_fill);
    probe->plan.has_secondary = false;
    p->cache.record = weights;
    p->plan.emit = emit;
    p->plan.raster.stride = emit.stride;
    p->plan.raster.lanes = LANE_SECONDARY;
    p->plan.raster.two_sided = p->plan.raster.flat = p->plan.raster.secondary = false;
    p->plan.raster.size_lane = emit.size_lane;
    p->plan.raster.face_lane = 0;
    assemble(probe, elements, compiled);
    p->cache.record = record;
    p->plan = plan;
    free(weights);
    return true;
}

/* ---- what the drawn primitive was ---- */

/* Which way a triangle faces, from clip coordinates, of vertices behind the eye too: the sign of the volume
 * of their x, y and w. */
static bool faces_front(const struct raster_plan *raster, const struct explain_detail *d)
{
    double m[3][3];
    if (d->n < 3)
        return true;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = (double)d->vertex[i].clip[k == 2 ? 3 : k];
    const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return (volume > 0) == (raster->front_is_ccw != raster->fragment->fb->y_up);
}

/* The pixel as what was lit: its materials are the vertices', weighted. */
static void fill_lit(struct explain_detail *d, const struct vertex_trace *lit)
{
    struct explain_vertex *at = &d->at;
    const struct face_trace *face = &lit->face[d->two_sided && !d->front ? 1 : 0];
    d->lit = true;
    at->trace = *lit;
    at->weight = 1;
    for (int i = 0; i < d->n; i++) {
        const struct explain_vertex *v = &d->vertex[i];
        for (int c = 0; c < 3; c++)
            at->normal[c] += (float)(v->weight * (double)v->normal[c]);
        for (int m = 0; m < MAT_COUNT; m++)
            for (int c = 0; c < 4; c++)
                at->material[m][c] += (float)(v->weight * (double)v->material[m][c]);
    }
    memcpy(at->color, d->event.fragment.interpolated, sizeof at->color);
    for (int c = 0; c < 3; c++)
        at->secondary[c] = fgl_clamp01((float)face->specular_sum[c]);
}

static void fill_detail(struct context *ctx, const struct probe *probe, const struct vertex_source *source,
                        const uint32_t *elements)
{
    const struct pipeline *p = probe->p;
    struct explain_detail *d = &probe->e->detail;
    memset(d, 0, sizeof *d);
    d->vertex_plan = p->plan.vertex;
    d->fragment_plan = p->plan.fragment;
    d->event = probe->event;
    d->flat = p->plan.raster.flat;
    d->two_sided = p->plan.vertex.lighting && p->plan.vertex.light.two_sided;
    d->n = probe->primitive.n;
    for (int i = 0; i < d->n; i++) {
        const uint32_t v = probe->primitive.vertex[i];
        d->vertex[i].number = number_in(probe, v);
        d->vertex[i].index = elements ? elements[v] : v + probe->base;
        d->vertex[i].weight = (double)probe->weight[i];
        d->is_clipped |= p->cache.outcode[v] != 0;
    }
    fgl_explain_vertices(ctx, source, d); /* clip coordinates, which say */
    d->front = faces_front(&p->plan.raster, d);
    fgl_explain_vertices(ctx, source, d); /* the values of the face that is seen */
    if (d->fragment_plan.color_source == COLOR_LIT)
        fill_lit(d, &probe->lit);
    fgl_explain_warn(ctx, source, d);
    probe->e->has_detail = true;
}

/* ---- draws ---- */

static const char *call_name(const struct vertex_source *source, bool indexed)
{
    return indexed            ? "glDrawElements"
           : source->arrays   ? "glDrawArrays"
           : source->compiled ? "glCallList"
                              : "glBegin";
}

/* Notes what one primitive of the draw does to the pixel. order: NULL, or 0, 1, 2, ...; n: vertices in the
 * cache. */
static void probe_prim(struct context *ctx, struct probe *probe, const struct vertex_source *source,
                       const uint32_t *order, const uint32_t *elements, int n)
{
    struct pipeline *p = probe->p;
    const struct plan plan = p->plan;
    const int counter = p->stipple_counter;
    probe->drawn = -1;
    aim(probe, note_fill, note_general);
    assemble(probe, order, source->compiled);
    p->plan = plan;
    if (probe->drawn < 0)
        return;
    const int counted = p->stipple_counter;
    p->stipple_counter = counter; /* the same fragments once more */
    if (weigh(probe, order, source->compiled, n))
        fill_detail(ctx, probe, source, elements);
    p->stipple_counter = counted;
}

static void probe_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims,
                       int n, const uint32_t *elements, uint32_t base, const uint32_t *order, int vertices)
{
    struct pipeline *p = ctx->pipeline;
    struct explain *e = p->explain;
    struct probe probe = {.p = p,
                          .e = e,
                          .real = p->plan.fragment,
                          .row = fgl_row(ctx->framebuffer, e->y),
                          .base = base};
    const int counter = p->stipple_counter;
    const struct pixel_value before = fgl_explain_pixel(ctx->framebuffer, probe.row, e->x);
    probe.about = (struct explain_event){.draw = ++e->draws, .call = call_name(source, elements)};
    for (int i = 0; i < n; i++) {
        probe.prim = &prims[i];
        probe.about.mode = prims[i].mode;
        probe.about.prim = i;
        probe_prim(ctx, &probe, source, order, elements, vertices);
    }
    e->value = fgl_explain_pixel(ctx->framebuffer, probe.row, e->x);
    fgl_explain_put_pixel(ctx->framebuffer, probe.row, e->x, &before);
    p->stipple_counter = counter;
}

/* Indexed: the probe sees the vertices one for each element. */
static void probe_elements(struct context *ctx, const struct vertex_source *source,
                           const struct draw_prim *prims, int n, const uint32_t *elements, uint32_t base)
{
    struct pipeline *p = ctx->pipeline;
    const struct vertex_cache cache = p->cache;
    struct vertex_cache gathered;
    int count = 0;
    for (int i = 0; i < n; i++)
        count = fgl_max(count, prims[i].first + prims[i].count);
    uint32_t *order = malloc((size_t)count * sizeof *order);
    for (int i = 0; order && i < count; i++)
        order[i] = (uint32_t)i;
    if (fgl_explain_gather(p, &gathered, elements, count, base) && order) {
        p->cache = gathered;
        probe_draw(ctx, source, prims, n, elements, 0, order, count);
        p->cache = cache;
    }
    fgl_explain_free_gathered(&gathered);
    free(order);
}

void fgl_explain_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims,
                      int n, const uint32_t *elements, uint32_t base)
{
    struct pipeline *p = ctx->pipeline;
    struct explain *e = p->explain;
    const struct rect *b = &p->plan.raster.bounds;
    const bool inside = fgl_explain_look(ctx);
    const int row = fgl_row(ctx->framebuffer, e->y);
    const bool visible = inside && ctx->render_mode == GL_RENDER && e->x >= b->x0 && e->x < b->x1 &&
                         row >= b->y0 && row < b->y1 && fgl_explain_scratch(&e->scratch, ctx->framebuffer);
    int vertices = 0;
    for (int i = 0; i < n; i++)
        vertices = fgl_max(vertices, prims[i].first - (int)base + prims[i].count);
    if (visible && elements)
        probe_elements(ctx, source, prims, n, elements, base);
    else if (visible)
        probe_draw(ctx, source, prims, n, NULL, base, NULL, vertices);
    fgl_assemble_all(p, prims, n, elements, base, source->compiled);
    if (!visible)
        return;
    const struct pixel_value drawn = fgl_explain_pixel(ctx->framebuffer, row, e->x);
    e->agrees = e->agrees && fgl_explain_same(&drawn, &e->value);
    e->value = drawn;
}
