/* The vertices of an explained primitive: fetched anew and run, one at a time, through the kernels that note
 * their terms. */
#include "pipeline/explain.h"

#include <math.h>
#include <string.h>

/* An attribute of the batch's only vertex. */
static void take(const struct vertex_plan *plan, const struct vertex_batch *b, int attr, float v[4])
{
    for (int c = 0; c < 4; c++)
        v[c] = b->varying >> attr & 1 ? b->in[attr].c[c][0] : plan->constant[attr][c];
}

static void take_material(const struct lighting_plan *light, const struct vertex_batch *b, int face,
                          float material[MAT_COUNT][4])
{
    for (int m = 0; m < MAT_COUNT; m++)
        for (int c = 0; c < 4; c++) {
            const int source = light->source[m][face];
            material[m][c] = source >= 0 ? b->in[source].c[c][0] : light->material[m][face][c];
        }
}

static void take_results(const struct explain_detail *d, const struct vertex_batch *b, const struct framebuffer *fb,
                         struct explain_vertex *v)
{
    const struct vertex_plan *plan = &d->vertex_plan;
    const int face = d->two_sided && !d->front ? 1 : 0;
    for (int c = 0; c < 4; c++) {
        v->clip[c] = b->clip.c[c][0];
        v->color[c] = plan->lighting || plan->color_is_varying || plan->index_is_varying ? b->color[face].c[c][0]
                                                               : d->fragment_plan.constant_color[c];
        v->secondary[c] =
                plan->lighting && plan->light.separate_specular && c < 3 ? b->secondary[face].c[c][0] : 0.0f;
    }
    v->window[0] = b->win.c[0][0];
    v->window[1] = fgl_turned_y(fb, b->win.c[1][0]);
    v->window[2] = b->win.c[2][0];
    if (plan->lighting)
        take_material(&plan->light, b, face, v->material);
}

void fgl_explain_vertices(struct context *ctx, const struct vertex_source *source, struct explain_detail *d)
{
    struct vertex_batch *b = ctx->pipeline->batch[0]; /* the draw's vertices are in the cache: it is free */
    const struct vertex_plan *plan = &d->vertex_plan;
    for (int i = 0; i < d->n; i++) {
        struct explain_vertex *v = &d->vertex[i];
        float normal[4];
        fgl_fetch(b, source, ~(uint32_t)0, v->index, 1);
        take(plan, b, ATTR_POSITION, v->object);
        take(plan, b, ATTR_NORMAL, normal);
        take(plan, b, ATTR_COLOR, v->given_color);
        memcpy(v->normal, normal, sizeof v->normal);
        memset(&v->trace, 0, sizeof v->trace);
        fgl_vertex_trace(plan, b, &v->trace);
        fgl_vertex_round(plan, b);
        take_results(d, b, ctx->framebuffer, v);
    }
}

static double length_of(const float v[3])
{
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] + (double)v[2] * (double)v[2]);
}

/* Between vertices a normal must not become shorter, or the middle would be darker than it is. */
static void restore_length(struct vertex_batch *b, const struct explain_detail *d)
{
    float n[3];
    double length = 0;
    for (int c = 0; c < 3; c++)
        n[c] = b->in[ATTR_NORMAL].c[c][0];
    for (int i = 0; i < d->n; i++)
        length += d->vertex[i].weight * length_of(d->vertex[i].normal);
    for (int c = 0; length_of(n) > 0 && c < 3; c++)
        b->in[ATTR_NORMAL].c[c][0] = (float)((double)n[c] * length / length_of(n));
}

void fgl_explain_middle(struct vertex_batch *b, const struct vertex_source *source,
                        const struct explain_detail *d, struct vertex_trace *trace)
{
    double sum[ATTR_COUNT][4] = {{0}};
    for (int i = 0; i < d->n; i++) {
        fgl_fetch(b, source, ~(uint32_t)0, d->vertex[i].index, 1);
        for (int a = 0; a < ATTR_COUNT; a++)
            for (int c = 0; b->varying >> a & 1 && c < 4; c++)
                sum[a][c] += d->vertex[i].weight * (double)b->in[a].c[c][0];
    }
    for (int a = 0; a < ATTR_COUNT; a++)
        for (int c = 0; b->varying >> a & 1 && c < 4; c++)
            b->in[a].c[c][0] = (float)sum[a][c];
    if (b->varying >> ATTR_NORMAL & 1)
        restore_length(b, d);
    memset(trace, 0, sizeof *trace);
    fgl_vertex_trace(&d->vertex_plan, b, trace);
}
