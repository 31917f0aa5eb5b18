/* Feedback and selection: what takes primitives from the rasterizer. See feedback.h.
 *
 * Polygons arrive, and are written, as the triangles that they are made of. All take the longer road of
 * raster/polygon_kernel.h, which chooses faces, culls, offsets and turns polygons into lines and points, and flat
 * shading has copied the colours. */
#include "pipeline/feedback.h"
#include "pipeline/pipeline.h"

#include <math.h>

/* ---- feedback (GL 1.5, 5.3) ---- */

void fgl_feedback_value(struct feedback_state *f, float value)
{
    if (f->count < f->size)
        f->buffer[f->count] = value;
    if (f->count <= f->size)
        f->count++;
}

static void values(struct feedback_state *f, const float *v, int n)
{
    for (int i = 0; i < n; i++)
        fgl_feedback_value(f, v[i]);
}

void fgl_feedback_vertex(struct context *ctx, const float window[4], const float color[4],
                         const float texture_coords[4])
{
    struct feedback_state *f = &ctx->feedback;
    values(f, window, f->type == GL_2D ? 2 : f->type == GL_4D_COLOR_TEXTURE ? 4 : 3);
    if (f->type != GL_2D && f->type != GL_3D)
        values(f, color, ctx->color_index ? 1 : 4); /* table 5.1: k is 1 in colour index mode */
    if (f->type == GL_3D_COLOR_TEXTURE || f->type == GL_4D_COLOR_TEXTURE)
        values(f, texture_coords, 4);
}

/* A lane of a raster vertex, rounded to float. */
static float lane(const struct raster_plan *plan, const void *v, int i)
{
    return plan->fragment->arith == ARITH_EXACT ? (float)((const double *)v)[i] : ((const float *)v)[i];
}

/* A vertex in the middle of nowhere (w = 0, overflow) cannot be drawn, nor can its primitive. */
static bool is_somewhere(const struct raster_plan *plan, const void *v)
{
    return isfinite(lane(plan, v, LANE_X)) && isfinite(lane(plan, v, LANE_Y)) && isfinite(lane(plan, v, LANE_Z)) &&
           isfinite(lane(plan, v, LANE_OOW));
}

static void vertex(const struct raster_plan *plan, const void *v, const void *provoking)
{
    const struct fragment_plan *f = plan->fragment;
    const float window[4] = {lane(plan, v, LANE_X), fgl_turned_y(f->fb, lane(plan, v, LANE_Y)),
                             lane(plan, v, LANE_Z), 1.0f / lane(plan, v, LANE_OOW)};
    const void *given = plan->flat ? provoking : v;
    const bool constant = f->color_source == COLOR_CONSTANT;
    float color[4], texture_coords[4] = {0};
    for (int i = 0; i < 4; i++)
        color[i] = constant ? f->constant_color[i] : lane(plan, given, LANE_COLOR + i);
    for (int i = 0; i < 4 && !plan->taker->color_index; i++)
        color[i] = fgl_clamp01(color[i]);
    for (int i = 0; i < plan->lanes - LANE_TEX0 && i < 4; i++)
        texture_coords[i] = lane(plan, v, LANE_TEX0 + i);
    fgl_feedback_vertex(plan->taker, window, color, texture_coords);
}

static void feedback_point(const struct raster_plan *plan, const void *v, float size)
{
    (void)size;
    if (!is_somewhere(plan, v))
        return;
    fgl_feedback_value(&plan->taker->feedback, GL_POINT_TOKEN);
    vertex(plan, v, v);
}

static void feedback_line(const struct raster_plan *plan, const void *v0, const void *v1,
                          const void *provoking, int *stipple_counter)
{
    if (!is_somewhere(plan, v0) || !is_somewhere(plan, v1))
        return;
    fgl_feedback_value(&plan->taker->feedback, *stipple_counter == 0 ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
    *stipple_counter = 1;
    vertex(plan, v0, provoking);
    vertex(plan, v1, provoking);
}

static void feedback_triangle(const struct raster_plan *plan, const void *v0, const void *v1,
                              const void *v2, const void *provoking)
{
    const void *const v[3] = {v0, v1, v2};
    if (!is_somewhere(plan, v0) || !is_somewhere(plan, v1) || !is_somewhere(plan, v2))
        return;
    fgl_feedback_value(&plan->taker->feedback, GL_POLYGON_TOKEN);
    fgl_feedback_value(&plan->taker->feedback, 3);
    for (int i = 0; i < 3; i++)
        vertex(plan, v[i], provoking);
}

void fgl_feedback_raster_position(struct context *ctx, GLenum token)
{
    const struct current_state *current = &ctx->s.current;
    if (ctx->render_mode != GL_FEEDBACK || !current->raster_position_valid)
        return;
    fgl_feedback_value(&ctx->feedback, (float)token);
    fgl_feedback_vertex(ctx, current->raster_position,
                        ctx->color_index ? &current->raster_index : current->raster_color,
                        current->raster_texture_coords[0]);
}

/* ---- selection (GL 1.5, 5.2) ---- */

void fgl_selection_hit(struct selection_state *s, float z)
{
    s->min_z = s->hit ? fminf(s->min_z, z) : z;
    s->max_z = s->hit ? fmaxf(s->max_z, z) : z;
    s->hit = true;
}

static void hit(const struct raster_plan *plan, const void *v)
{
    if (is_somewhere(plan, v))
        fgl_selection_hit(&plan->taker->selection, fgl_clamp01(lane(plan, v, LANE_Z)));
}

static void select_point(const struct raster_plan *plan, const void *v, float size)
{
    (void)size;
    hit(plan, v);
}

static void select_line(const struct raster_plan *plan, const void *v0, const void *v1,
                        const void *provoking, int *stipple_counter)
{
    (void)provoking, (void)stipple_counter;
    hit(plan, v0);
    hit(plan, v1);
}

static void select_triangle(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                            const void *provoking)
{
    (void)provoking;
    hit(plan, v0);
    hit(plan, v1);
    hit(plan, v2);
}

/* ---- validation ---- */

/* Raster vertices as long as feedback needs them: with the texture coordinates of the first unit. */
static void extend_vertices(struct plan *plan)
{
    struct emit_plan *e = &plan->emit;
    struct raster_plan *r = &plan->raster;
    const int back = (e->size_lane ? e->size_lane : e->stride) - e->lanes;
    r->lanes = r->back_lane = e->lanes = e->back_lane = LANE_TEX0 + 4;
    e->size_lane = r->size_lane = 0;
    e->textures = 0; /* fgl_feedback_emit hands over the first unit's */
    fgl_emit_layout(e, e->arith, e->lanes + back);
    r->stride = e->stride;
    plan->fetch |= 1u << ATTR_TEX0;
}

void fgl_feedback_validate(struct context *ctx, struct plan *plan)
{
    struct raster_plan *r = &plan->raster;
    const bool feedback = ctx->render_mode == GL_FEEDBACK;
    plan->polygon_fill = false; /* the longer road for all */
    plan->decomposed = true;
    plan->rasterize = true;     /* whatever scissor and draw buffer let through */
    plan->feedback.texture_coords = feedback;
    r->filled = feedback ? feedback_triangle : select_triangle;
    r->line = feedback ? feedback_line : select_line;
    r->point = feedback ? feedback_point : select_point;
    r->taker = ctx;
    if (feedback)
        extend_vertices(plan);
}

/* The first unit's coordinates, generated and transformed (GL 1.5, 2.11.2, 2.11.4) whether it draws a texture or not. */
void fgl_feedback_emit(const struct plan *plan, const struct vertex_batch *b, unsigned char *record)
{
    const struct vertex_plan *v = &plan->vertex;
    const bool computed = v->textures > 0 && v->texture[0].unit == 0 && v->texture[0].computed;
    const bool varying = b->varying & (1u << ATTR_TEX0), exact = plan->emit.arith == ARITH_EXACT;
    for (int i = 0; i < b->n; i++, record += plan->emit.record_bytes) {
        for (int c = 0; c < 4; c++) {
            const float given = varying ? b->in[ATTR_TEX0].c[c][i] : v->constant[ATTR_TEX0][c];
            if (exact)
                ((double *)(void *)record)[LANE_TEX0 + c] = computed ? b->exact.texture[0].c[c][i] : (double)given;
            else
                ((float *)(void *)record)[LANE_TEX0 + c] = computed ? b->texture[0].c[c][i] : given;
        }
    }
}
