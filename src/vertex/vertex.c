/* Validation of the vertex plan, and the run of a batch through the kernels of this CPU. */
#include "vertex/vertex.h"

#include "framebuffer/framebuffer.h"
#include "state/matrix_exact.h"

#include <string.h>

/* Clip planes go from eye to clip space: plane * inverse(projection) (GL 1.5, 2.12 "Clipping"; OSMesa rule).
 */
static void derive_user_planes(struct vertex_plan *plan, const struct transform_state *transform,
                               const float inverse[16])
{
    plan->user_planes = transform->clip_plane_enabled;
    for (int i = 0; i < FGL_MAX_CLIP_PLANES; i++) {
        const float *p = transform->clip_plane[i];

        if (!(plan->user_planes >> i & 1))
            continue;
        memcpy(plan->exact.user_plane[i], transform->exact_clip_plane[i], sizeof plan->exact.user_plane[i]);
        for (int c = 0; c < 4; c++) {
            const float *column = inverse + 4 * c;
            plan->user_plane[i][c] =
                    p[0] * column[0] + p[1] * column[1] + p[2] * column[2] + p[3] * column[3];
        }
    }
}

/* GL 1.5, 2.11.1 "Controlling the Viewport"; y along the framebuffer's rows. OSMesa rule: depth range in
 * double from floats. */
static void derive_viewport(struct vertex_plan *plan, const struct viewport_state *state,
                            const struct framebuffer *fb)
{
    const float x = (float)state->viewport[0], y = (float)state->viewport[1];
    const float half_width = (float)state->viewport[2] * 0.5f, half_height = (float)state->viewport[3] * 0.5f;
    const double near = (double)state->depth_range[0], far = (double)state->depth_range[1];

    plan->viewport_scale[0] = half_width;
    plan->viewport_trans[0] = half_width + x;
    plan->viewport_scale[1] = fb->y_up ? half_height : -half_height;
    plan->viewport_trans[1] = fgl_turned_y(fb, half_height + y);
    plan->viewport_scale[2] = (float)(0.5 * (far - near));
    plan->viewport_trans[2] = (float)(0.5 * (near + far));
    for (int c = 0; c < 2; c++) { /* these are exact in float */
        plan->exact.viewport_scale[c] = (double)plan->viewport_scale[c];
        plan->exact.viewport_trans[c] = (double)plan->viewport_trans[c];
    }
    plan->exact.viewport_scale[2] = 0.5 * (far - near);
    plan->exact.viewport_trans[2] = 0.5 * (near + far);
}

static void derive_point_size(struct vertex_plan *plan, const struct point_state *state)
{
    const float *k = state->point_distance_attenuation;

    memcpy(plan->point_attenuation, k, sizeof plan->point_attenuation);
    plan->need_point_size = k[0] != 1.0f || k[1] != 0.0f || k[2] != 0.0f;
    plan->point_size = state->point_size;
    plan->point_size_min = state->point_size_min;
    plan->point_size_max = state->point_size_max;
}

static void validate_lighting(struct vertex_plan *plan, struct context *ctx)
{
    fgl_light_validate(plan, ctx);
    fgl_exact_light_validate(plan, ctx);
}

void fgl_vertex_validate(struct vertex_plan *plan, struct context *ctx, uint32_t varying,
                         const struct framebuffer *fb)
{
    const unsigned dirty = ctx->dirty | (plan->varying != varying ? DIRTY_VARYING : 0);
    struct matrix *modelview = &ctx->modelview.entry[ctx->modelview.top];
    struct matrix *projection = &ctx->projection.entry[ctx->projection.top];

    if (dirty & (DIRTY_MODELVIEW | DIRTY_PROJECTION))
        fgl_matrix_product(plan->mvp, projection->m, modelview->m);
    plan->arith = fgl_context_arith(ctx);
    if (dirty & (DIRTY_MODELVIEW | DIRTY_PROJECTION))
        fgl_exact_product(plan->exact.mvp, projection->exact, modelview->exact);
    if (dirty & DIRTY_MODELVIEW) {
        if (plan->arith == ARITH_EXACT)
            memcpy(plan->exact.modelview, modelview->exact, sizeof plan->exact.modelview);
        else
            fgl_exact_load(plan->exact.modelview, modelview->m);
        (void)fgl_matrix_class(modelview); /* a use: the class is found now, not after later commands */
        memcpy(plan->modelview, modelview->m, sizeof plan->modelview);
    }
    if (dirty & (DIRTY_PROJECTION | DIRTY_CLIP_PLANE))
        derive_user_planes(plan, &ctx->s.transform, fgl_matrix_inverse(projection));
    if (dirty & (DIRTY_VIEWPORT | DIRTY_FRAMEBUFFER))
        derive_viewport(plan, &ctx->s.viewport, fb);
    if (dirty & DIRTY_CURRENT)
        memcpy(plan->constant, ctx->s.current.attr, sizeof plan->constant);
    if (dirty & DIRTY_POINT)
        derive_point_size(plan, &ctx->s.point);

    plan->varying = varying;
    plan->lighting = ctx->s.lighting.lighting;
    plan->light_fragments = plan->lighting && ctx->s.lighting.shade_model == GL_PHONG_WIN && !ctx->color_index &&
                            ctx->render_mode == GL_RENDER;
    plan->need_fog_z = ctx->s.fog.fog && ctx->s.fog.fog_coord_src != GL_FOG_COORDINATE;
    plan->need_fog_coord = ctx->s.fog.fog && !plan->need_fog_z;
    plan->secondary_is_varying =
            ctx->s.fog.color_sum && !ctx->color_index && !plan->lighting && (varying >> ATTR_SECONDARY_COLOR & 1);
    plan->color_index = ctx->color_index;
    plan->index_is_varying = plan->color_index && !plan->lighting && (varying >> ATTR_INDEX & 1);
    plan->color_is_varying = !plan->color_index && !plan->lighting && (varying >> ATTR_COLOR & 1);
    if (dirty & (DIRTY_TEXTURE | DIRTY_TEXTURE_MATRIX | DIRTY_VARYING))
        fgl_texture_plan_validate(plan, ctx, varying);
    if (!plan->lighting && plan->texgen_normal)
        fgl_normals_validate(plan, ctx);
    if (plan->lighting && dirty & (DIRTY_MODELVIEW | DIRTY_LIGHT | DIRTY_MATERIAL | DIRTY_CURRENT |
                                   DIRTY_NORMALIZE | DIRTY_POINT | DIRTY_VARYING | DIRTY_TEXTURE))
        validate_lighting(plan, ctx);
}

static void round_colors(struct vertex_batch *b, int i)
{
    for (int face = 0; face < 2; face++)
        for (int c = 0; c < 4; c++) {
            b->color[face].c[c][i] = (float)b->exact.color[face].c[c][i];
            b->secondary[face].c[c][i] = (float)b->exact.secondary[face].c[c][i];
        }
}

/* The batch's results for lighting per fragment. */
static void round_lit(struct vertex_batch *b, int i)
{
    for (int c = 0; c < 3; c++) {
        b->lit_normal.c[c][i] = (float)b->exact.lit_normal.c[c][i];
        b->lit_eye.c[c][i] = (float)b->exact.lit_eye.c[c][i];
    }
}

void fgl_vertex_round(const struct vertex_plan *plan, struct vertex_batch *b)
{
    for (int i = 0; plan->arith == ARITH_EXACT && i < b->n; i++) {
        for (int c = 0; c < 4; c++) {
            b->clip.c[c][i] = (float)b->exact.clip.c[c][i];
            b->win.c[c][i] = (float)b->exact.win.c[c][i];
        }
        b->fog_z[i] = (float)b->exact.fog_z[i];
        round_colors(b, i);
    }
}

/* Lights again, in double, the chunk's vertices that are extreme. */
static void light_extremes(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, bool general)
{
    fgl_vertex_kernels(ARITH_EXACT)->light(plan, b, first, n, general);
    for (int i = first; i < first + n; i++)
        if (plan->exact.needed || b->extreme[i])
            (plan->light_fragments ? round_lit : round_colors)(b, i);
}

static void gather_outcodes(struct vertex_batch *batch)
{
    uint32_t any = 0, all = ~(uint32_t)0;

    for (int i = 0; i < batch->n; i++) {
        any |= batch->outcode[i];
        all &= batch->outcode[i];
    }
    batch->outcode_any = any;
    batch->outcode_all = batch->n ? all : 0;
}

void fgl_vertex_run(const struct vertex_plan *plan, struct vertex_batch *batch, bool general)
{
    const struct vertex_kernels *kernels = fgl_vertex_kernels(plan->arith);

    for (int first = 0; first < batch->n; first += VERTEX_CHUNK) {
        const int n = fgl_min(batch->n - first, VERTEX_CHUNK);
        const bool extreme = kernels->run(plan, batch, first, n, general);
        if (FGL_UNLIKELY(extreme || (plan->exact.needed && plan->lighting)))
            light_extremes(plan, batch, first, n, general);
    }
    gather_outcodes(batch);
}

void fgl_vertex_positions(const struct vertex_plan *plan, struct vertex_batch *batch)
{
    const struct vertex_kernels *kernels = fgl_vertex_kernels(plan->arith);

    for (int first = 0; first < batch->n; first += VERTEX_CHUNK)
        kernels->positions(plan, batch, first, fgl_min(batch->n - first, VERTEX_CHUNK));
    gather_outcodes(batch);
}

void fgl_vertex_shade(const struct vertex_plan *plan, struct vertex_batch *batch, bool general)
{
    const struct vertex_kernels *kernels = fgl_vertex_kernels(plan->arith);

    for (int first = 0; first < batch->n; first += VERTEX_CHUNK) {
        const int n = fgl_min(batch->n - first, VERTEX_CHUNK);
        const bool extreme = kernels->shade(plan, batch, first, n, general);
        if (FGL_UNLIKELY(extreme || (plan->exact.needed && plan->lighting)))
            light_extremes(plan, batch, first, n, general);
    }
}

void fgl_vertex_trace(const struct vertex_plan *plan, struct vertex_batch *batch, struct vertex_trace *trace)
{
    if (!fgl_vertex_kernels(plan->arith)->trace(plan, batch, trace) && !(plan->exact.needed && plan->lighting))
        return;
    (void)fgl_vertex_kernels(ARITH_EXACT)->trace(plan, batch, trace);
    (plan->light_fragments ? round_lit : round_colors)(batch, 0);
}

/* Fragments too are lit in double where float is not safe. */
void fgl_vertex_trace_fragment(const struct vertex_plan *plan, struct lit_fragments *f, struct face_trace *trace)
{
    const bool all = plan->exact.needed;
    struct lit_fragments exact = *f;
    uint32_t extreme[LIT_GROUP], unused[LIT_GROUP];

    if (!fgl_vertex_kernels(plan->arith)->light_fragments(plan, f, trace, extreme) && !all)
        return;
    fgl_vertex_kernels(ARITH_EXACT)->light_fragments(plan, &exact, all || extreme[0] ? trace : NULL, unused);
    for (int i = 0; i < LIT_GROUP; i++)
        for (int c = 0; c < 4 && (all || extreme[i]); c++) {
            f->color[c][i] = exact.color[c][i];
            if (c < 3 && plan->light.separate_specular)
                f->secondary[c][i] = exact.secondary[c][i];
        }
}

void fgl_vertex_light_fragments(const void *plan, struct lit_fragments *f)
{
    fgl_vertex_trace_fragment(plan, f, NULL);
}

void fgl_emit_layout(struct emit_plan *plan, enum fgl_arith arith, int stride)
{
    plan->arith = arith;
    plan->stride = stride;
    plan->record_bytes = (size_t)stride * (arith == ARITH_EXACT ? sizeof(double) : sizeof(float));
    plan->clip_bytes = arith == ARITH_EXACT ? EXACT_CLIP_LANES * sizeof(double) : CLIP_LANES * sizeof(float);
}

void fgl_emit(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip)
{
    fgl_vertex_kernels(plan->arith)->emit(plan, batch, record, clip);
}

void fgl_emit_positions(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip)
{
    fgl_vertex_kernels(plan->arith)->emit_positions(plan, batch, record, clip);
}

void fgl_emit_attributes(const struct emit_plan *plan, const struct vertex_batch *batch, void *record)
{
    fgl_vertex_kernels(plan->arith)->emit_attributes(plan, batch, record);
}

FGL_KERNEL_TABLE(vertex);

const struct vertex_kernels *fgl_vertex_kernels(enum fgl_arith arith)
{
    return kernels_of[fgl_cpu_isa()][arith];
}

const struct vertex_kernels *fgl_vertex_kernels_of(enum fgl_isa isa, enum fgl_arith arith)
{
    return fgl_cpu_has(isa) ? kernels_of[isa][arith] : NULL;
}
