/* What the terms of a plan cost: the kernels timed with the plan as it is and with one term less. The
 * vertices are the draw's own, repeated to a whole batch; the pixels are those of a small framebuffer of the
 * same format, all covered, all passing the depth test. */
#include "pipeline/plan_report.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { RUNS = 9 /* the quickest counts */, PIXEL_WIDTH = 256, PIXEL_ROWS = RUNS_MAX, PIXEL_REPEATS = 4 };
static const double least_time = 50e-6; /* seconds in one run over vertices */

static double seconds(void)
{
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void line(struct text *t, int indent, const char *name, double ns)
{
    fgl_text_add(t, "%*s%-*s %8.2f\n", indent, "", 40 - indent, name, ns);
}

/* ---- vertices ---- */

struct vertex_timing {
    struct pipeline *p;
    struct vertex_batch *b;
    const struct vertex_source *source;
    uint32_t first;
    int n; /* of the draw, at most a batch */
    unsigned char *record, *clip;
};

enum vertex_work { WORK_FETCH, WORK_VERTEX, WORK_EMIT };

static void work(const struct vertex_timing *v, const struct vertex_plan *plan, enum vertex_work kind)
{
    switch (kind) {
    case WORK_FETCH: fgl_fetch(v->b, v->source, v->p->plan.fetch, v->first, v->n); break;
    case WORK_VERTEX: fgl_vertex_run(plan, v->b, v->p->general); break;
    case WORK_EMIT: fgl_emit(&v->p->plan.emit, v->b, v->record, v->clip); break;
    }
}

/* Nanoseconds for one vertex. */
static double time_work(const struct vertex_timing *v, const struct vertex_plan *plan, enum vertex_work kind)
{
    double best = 1;
    int repeats = 1;
    for (int run = 0; run < RUNS;) {
        const double start = seconds();
        for (int i = 0; i < repeats; i++)
            work(v, plan, kind);
        const double taken = seconds() - start;
        if (taken < least_time && repeats < 1 << 20) {
            repeats *= 2;
            continue;
        }
        best = taken / repeats < best ? taken / repeats : best;
        run++;
    }
    return 1e9 * best / v->b->n;
}

/* The batch's vertices, repeated until it is full. */
static void fill_batch(struct vertex_batch *b)
{
    for (int a = 0; a < ATTR_COUNT; a++)
        for (int c = 0; b->varying >> a & 1 && c < 4; c++)
            for (int i = b->n; i < FGL_BATCH_SIZE; i++)
                b->in[a].c[c][i] = b->in[a].c[c][i - b->n];
    b->n = FGL_BATCH_SIZE;
}

static double without_key(const struct vertex_timing *v, int light, unsigned key)
{
    struct vertex_plan plan = v->p->plan.vertex;
    plan.light.light[light].key &= ~key;
    return time_work(v, &plan, WORK_VERTEX);
}

static double without_light(const struct vertex_timing *v, int light)
{
    struct vertex_plan plan = v->p->plan.vertex;
    plan.light.n--;
    memmove(&plan.light.light[light], &plan.light.light[light + 1],
            (size_t)(plan.light.n - light) * sizeof plan.light.light[0]);
    memmove(&plan.exact.light[light], &plan.exact.light[light + 1],
            (size_t)(plan.light.n - light) * sizeof plan.exact.light[0]);
    return time_work(v, &plan, WORK_VERTEX);
}

static void time_light(struct text *t, const struct vertex_timing *v, int i, double all)
{
    static const struct {
        unsigned key, with; /* of the term; and those that go with it */
        const char *name;
    } term[] = {
            {LIGHT_POSITIONAL, LIGHT_ATTENUATED, "vector to it"},
            {LIGHT_ATTENUATED, 0, "attenuation"},
            {LIGHT_SPOT, 0, "spot"},
            {LIGHT_SPECULAR, LIGHT_LOCAL_VIEWER | LIGHT_SEPARATE | LIGHT_ZERO_SHININESS | LIGHT_REFLECTION, "highlight"},
            {LIGHT_LOCAL_VIEWER, 0, "for the local viewer"},
    };
    const struct light_derived *light = &v->p->plan.vertex.light.light[i];
    char name[] = "GL_LIGHT0";
    name[8] = (char)('0' + light->number);
    line(t, 6, name, all - without_light(v, i));
    for (size_t k = 0; k < FGL_COUNTOF(term); k++)
        if (light->key & term[k].key)
            line(t, 8, term[k].name, all - without_key(v, i, term[k].key | term[k].with));
}

static void time_lighting(struct text *t, const struct vertex_timing *v, double all)
{
    struct vertex_plan plan = v->p->plan.vertex;
    plan.lighting = false;
    line(t, 4, "lighting", all - time_work(v, &plan, WORK_VERTEX));
    plan = v->p->plan.vertex;
    plan.normal_in_eye_space = false;
    if (plan.need_normal && v->p->plan.vertex.normal_in_eye_space)
        line(t, 6, "normals to eye space", all - time_work(v, &plan, WORK_VERTEX));
    plan = v->p->plan.vertex;
    plan.normal_scaling = NORMAL_AS_IS;
    if (plan.need_normal && v->p->plan.vertex.normal_scaling != NORMAL_AS_IS)
        line(t, 6, "their scaling", all - time_work(v, &plan, WORK_VERTEX));
    plan = v->p->plan.vertex;
    plan.light.two_sided = false;
    if (v->p->plan.vertex.light.two_sided)
        line(t, 6, "back faces", all - time_work(v, &plan, WORK_VERTEX));
    for (int i = 0; i < v->p->plan.vertex.light.n; i++)
        time_light(t, v, i, all);
}

static void time_vertices(struct text *t, const struct vertex_timing *v)
{
    const double fetch = time_work(v, NULL, WORK_FETCH);
    fill_batch(v->b);
    const struct vertex_plan *whole = &v->p->plan.vertex;
    const double all = time_work(v, whole, WORK_VERTEX), emit = time_work(v, NULL, WORK_EMIT);
    struct vertex_plan plan = *whole;
    plan.lighting = plan.color_is_varying = plan.need_fog_z = plan.need_point_size = false;
    plan.user_planes = 0;
    line(t, 2, "ns per vertex", fetch + all + emit);
    line(t, 4, "fetch", fetch);
    line(t, 4, "clip and window coordinates", time_work(v, &plan, WORK_VERTEX));
    plan = *whole;
    plan.user_planes = 0;
    if (whole->user_planes)
        line(t, 4, "clip planes", all - time_work(v, &plan, WORK_VERTEX));
    plan = *whole;
    plan.need_fog_z = false;
    if (whole->need_fog_z)
        line(t, 4, "fog's distance", all - time_work(v, &plan, WORK_VERTEX));
    if (whole->lighting)
        time_lighting(t, v, all);
    line(t, 4, "to the rasterizer", emit);
}

/* ---- pixels ---- */

static void set_slope(struct planes *p, enum fgl_arith arith, int lane, double slope)
{
    if (arith == ARITH_EXACT)
        p->exact.dadx[lane] = slope;
    else
        p->dadx[lane] = (float)slope;
}

static void add_offset(struct planes *p, enum fgl_arith arith, double step)
{
    if (arith == ARITH_EXACT)
        p->exact.z_offset += step;
    else
        p->z_offset += (float)step;
}

static bool nearer(const struct fragment_plan *f)
{
    return f->depth_func == GL_LESS || f->depth_func == GL_LEQUAL;
}

/* Planes whose z passes the test each time: nearer, or farther, with each repetition. */
static void start_planes(struct planes *planes, const struct fragment_plan *f)
{
    memset(planes, 0, sizeof *planes);
    for (int lane = LANE_COLOR; lane < LANE_MAX; lane++) {
        fgl_plane_set(planes, f->arith, lane, 0.25);
        set_slope(planes, f->arith, lane, 0.5 / PIXEL_WIDTH);
    }
    fgl_plane_set(planes, f->arith, LANE_OOW, 1);
    fgl_plane_set(planes, f->arith, LANE_Z, nearer(f) ? 0.9 : 0.1);
    set_slope(planes, f->arith, LANE_Z, 1e-5);
}

/* Nanoseconds for one pixel of the plan that the state makes. */
static double time_pixels(const struct context *ctx, const struct server_state *s, enum color_source source,
                          bool secondary, struct framebuffer *fb)
{
    struct fragment_plan f = ctx->pipeline->plan.fragment;
    struct planes planes;
    struct runs runs = {.y = 0, .n = PIXEL_ROWS};
    double best = 1;
    f.color_source = source;
    f.has_secondary = secondary;
    f.secondary_source = source == COLOR_FLAT ? COLOR_FLAT : COLOR_SMOOTH;
    fgl_fragment_validate(&f, s, fb, ctx->pipeline->general);
    start_planes(&planes, &f);
    const double step = nearer(&f) ? -0.01 : 0.01;
    for (int i = 0; i < PIXEL_ROWS; i++)
        runs.x1[i] = PIXEL_WIDTH + (runs.x0[i] = 0);
    fgl_clear_depth(fb, (struct rect){0, 0, PIXEL_WIDTH, PIXEL_ROWS}, step < 0 ? 1.0 : 0.0, false);
    for (int run = 0; run < RUNS; run++) {
        const double start = seconds();
        for (int i = 0; i < PIXEL_REPEATS; i++, add_offset(&planes, f.arith, step))
            f.fill(&f, &planes, &runs);
        const double taken = seconds() - start;
        best = taken < best ? taken : best;
    }
    return 1e9 * best / (PIXEL_REPEATS * PIXEL_WIDTH * PIXEL_ROWS);
}

static void time_stages(struct text *t, const struct context *ctx, struct framebuffer *fb,
                        struct server_state *s)
{
    const struct fragment_plan *f = &ctx->pipeline->plan.fragment;
    const double all = time_pixels(ctx, &ctx->s, f->color_source, f->has_secondary, fb);
    const struct {
        bool used, *enable;
        const char *name;
    } stage[] = {
            {f->has_fog, &s->fog.fog, "fog"},
            {f->alpha_test, &s->color_buffer.alpha_test, "alpha test"},
            {f->stencil_test, &s->stencil.stencil_test, "stencil test"},
            {f->depth_test, &s->depth.depth_test, "depth test"},
            {f->blend, &s->color_buffer.blend, "blending"},
            {f->logic_op, &s->color_buffer.color_logic_op, "logical operation"},
    };
    line(t, 2, "ns per pixel", all);
    if (f->color_source == COLOR_SMOOTH)
        line(t, 4, "colour interpolation",
             all - time_pixels(ctx, &ctx->s, COLOR_CONSTANT, f->has_secondary, fb));
    if (f->has_secondary)
        line(t, 4, "colour sum", all - time_pixels(ctx, &ctx->s, f->color_source, false, fb));
    for (size_t i = 0; i < FGL_COUNTOF(stage); i++)
        if (stage[i].used) {
            *stage[i].enable = false;
            line(t, 4, stage[i].name, all - time_pixels(ctx, s, f->color_source, f->has_secondary, fb));
            *stage[i].enable = true;
        }
}

void fgl_plan_time(struct text *t, struct context *ctx, const struct vertex_source *source, uint32_t first,
                   int vertices)
{
    struct pipeline *p = ctx->pipeline;
    const struct framebuffer *like = ctx->framebuffer;
    struct framebuffer fb = {.has_alpha = like->has_alpha,
                             .depth_bits = like->depth_bits,
                             .depth_max = like->depth_max,
                             .stencil_bits = like->stencil_bits};
    struct server_state *s = malloc(sizeof *s);
    const struct vertex_timing v = {p,
                                    p->batch[0],
                                    source,
                                    first,
                                    fgl_min(vertices, FGL_BATCH_SIZE),
                                    malloc(p->plan.emit.record_bytes * FGL_BATCH_CAPACITY),
                                    malloc(p->plan.emit.clip_bytes * FGL_BATCH_CAPACITY)};
    if (v.record && v.clip && v.b)
        time_vertices(t, &v);
    if (s && fgl_framebuffer_resize(&fb, PIXEL_WIDTH, PIXEL_ROWS, like->color_kind) &&
        (!like->stencil || fgl_framebuffer_need_stencil(&fb))) {
        *s = ctx->s;
        time_stages(t, ctx, &fb, s);
    }
    fgl_framebuffer_free(&fb);
    free(v.record);
    free(v.clip);
    free(s);
}
