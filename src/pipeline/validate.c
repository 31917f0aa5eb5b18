/* Validation: from dirty state to the plan (docs/pipeline.md). The one place that decides which stages a draw runs.
 * Each update names the state that it depends on; unchanged state costs one comparison. */
#include "base/color_index.h"
#include "pipeline/pipeline.h"

#include <string.h>

enum {
    VERTEX_DEPS = DIRTY_MODELVIEW | DIRTY_PROJECTION | DIRTY_TEXTURE_MATRIX | DIRTY_LIGHT | DIRTY_MATERIAL | DIRTY_CURRENT |
                  DIRTY_NORMALIZE | DIRTY_CLIP_PLANE | DIRTY_VIEWPORT | DIRTY_VARYING | DIRTY_FOG | DIRTY_FRAMEBUFFER | DIRTY_TEXTURE |
                  DIRTY_POINT,
    FRAGMENT_DEPS = DIRTY_LIGHT | DIRTY_CURRENT | DIRTY_VARYING | DIRTY_FRAGMENT | DIRTY_FOG | DIRTY_FRAMEBUFFER | DIRTY_SCISSOR |
                    DIRTY_RASTER | DIRTY_TEXTURE | DIRTY_TEXTURE_MATRIX
};

/* The attribute that is the colour of a vertex. */
static uint32_t color_bit(bool color_index)
{
    return 1u << (color_index ? ATTR_INDEX : ATTR_COLOR);
}

/* Where fragments get their colour from. */
static enum color_source color_source(const struct context *ctx, uint32_t varying)
{
    const struct server_state *s = &ctx->s;
    if (ctx->pipeline->plan.vertex.light_fragments)
        return COLOR_LIT;
    if (!s->lighting.lighting && !(varying & color_bit(ctx->color_index)))
        return COLOR_CONSTANT;
    return s->lighting.shade_model == GL_FLAT ? COLOR_FLAT : COLOR_SMOOTH;
}

/* The attributes that some stage of the plan reads. */
static uint32_t fetch_mask(const struct plan *plan)
{
    uint32_t mask = 1u << ATTR_POSITION;
    const struct vertex_plan *v = &plan->vertex;
    if (v->need_normal || v->texgen_normal)
        mask |= 1u << ATTR_NORMAL;
    if (!v->lighting)
        mask |= color_bit(v->color_index);
    if (v->secondary_is_varying)
        mask |= 1u << ATTR_SECONDARY_COLOR;
    if (v->need_fog_coord)
        mask |= 1u << ATTR_FOG_COORD;
    for (int m = 0; v->lighting && m < MAT_COUNT; m++)
        for (int face = 0; face < 2; face++)
            if (v->light.source[m][face] >= 0)
                mask |= 1u << v->light.source[m][face];
    for (int k = 0; k < v->textures; k++)
        mask |= 1u << (ATTR_TEX0 + v->texture[k].unit);
    if (!plan->polygon_fill)
        mask |= 1u << ATTR_EDGE_FLAG;
    return mask;
}

/* OSMesa rule: on the longer road polygons are split there only if one of its stages for polygons has work. */
static bool decomposed(const struct raster_plan *r)
{
    const bool offset = r->offset_point || r->offset_line || r->offset_fill;
    return r->polygon_mode[0] != GL_FILL || r->polygon_mode[1] != GL_FILL || r->polygon_stipple ||
           (r->longer_road && (offset || r->two_sided));
}

/* GL_WIN_phong_shading: what lighting reads, interpolated in lanes of its own, and the vertex stage to light it. */
static void add_lit_lanes(struct plan *plan)
{
    struct emit_plan *e = &plan->emit;
    struct lit_lanes *lit = &plan->fragment.lit;
    const struct lighting_plan *light = &plan->vertex.light;
    e->lit_lane = lit->normal = e->lanes;
    e->lit_eye = plan->vertex.need_eye;
    e->lanes += LANE_GROUP;
    lit->eye = e->lit_eye ? e->lanes : 0;
    e->lanes += e->lit_eye ? LANE_GROUP : 0;
    lit->attribute = e->lanes;
    e->lit_attributes = lit->attributes = light->attributes;
    e->lanes += LANE_GROUP * light->attributes;
    memcpy(e->lit_attribute, light->attribute, sizeof e->lit_attribute);
    lit->light = fgl_vertex_light_fragments;
    lit->lights = &plan->vertex;
}

static void update_emit(struct plan *plan)
{
    struct emit_plan *e = &plan->emit;
    const enum fgl_arith arith = plan->vertex.arith;
    const bool lit = plan->vertex.light_fragments;
    e->color = (plan->fragment.color_source != COLOR_CONSTANT || plan->fragment.primary_interpolated) && !lit;
    e->secondary = plan->fragment.has_secondary && plan->fragment.secondary_source != COLOR_CONSTANT && !lit;
    e->fog = plan->fragment.has_fog;
    e->two_sided = plan->vertex.lighting && plan->vertex.light.two_sided && !lit;
    e->textures = plan->vertex.textures;
    for (int k = 0; k < e->textures; k++)
        e->texture_unit[k] = plan->vertex.texture[k].computed ? -1 : plan->vertex.texture[k].unit;
    e->texture_lane = e->fog || e->secondary ? LANE_TEX0 : e->color ? LANE_SECONDARY : LANE_COLOR;
    e->lanes = e->texture_lane + 4 * e->textures;
    e->lit_lane = 0;
    if (lit)
        add_lit_lanes(plan);
    e->back_lane = e->lanes;
    const int faces_end = e->lanes + (e->two_sided ? (e->secondary ? 8 : 4) : 0);
    e->size_lane = plan->vertex.need_point_size ? faces_end : 0;
    fgl_emit_layout(e, arith, faces_end + (e->size_lane ? LANE_GROUP : 0));
    plan->clip = fgl_clip_kernels(arith);
    struct raster_plan *r = &plan->raster;
    r->stride = e->stride;
    r->lanes = e->lanes;
    r->back_lane = e->back_lane;
    r->two_sided = e->two_sided;
    r->flat = plan->fragment.color_source == COLOR_FLAT || (e->secondary && plan->fragment.secondary_source == COLOR_FLAT);
    r->face_lane = lit && plan->vertex.light.two_sided ? plan->fragment.lit.normal + 3 : 0;
    r->secondary = e->secondary;
    r->size_lane = e->size_lane;
    plan->decomposed = decomposed(r);
}

/* GL 1.5, 3.9 "Color Sum". */
static void update_secondary(const struct context *ctx, struct fragment_plan *f, uint32_t varying)
{
    const struct lighting_state *l = &ctx->s.lighting;
    const bool by_vertex = l->lighting || (varying & (1u << ATTR_SECONDARY_COLOR));
    f->has_secondary = l->lighting ? l->light_model_color_control == GL_SEPARATE_SPECULAR_COLOR : ctx->s.fog.color_sum;
    f->secondary_source = f->color_source == COLOR_LIT ? COLOR_LIT : !by_vertex ? COLOR_CONSTANT : l->shade_model == GL_FLAT ? COLOR_FLAT : COLOR_SMOOTH;
    f->flat_sum = l->lighting && ctx->s.fog.color_sum && l->shade_model == GL_FLAT;
    for (int i = 0; i < 3; i++)
        f->constant_secondary[i] = fgl_clamp01(ctx->s.current.attr[ATTR_SECONDARY_COLOR][i]);
}

static void update_fragment(struct context *ctx, struct pipeline *p, uint32_t varying)
{
    struct plan *plan = &p->plan;
    struct fragment_plan *f = &plan->fragment;
    f->arith = fgl_context_arith(ctx);
    f->color_source = color_source(ctx, varying);
    for (int i = 0; i < 4; i++) /* GL 1.5, 2.14.6 "Clamping or Masking" */
        f->constant_color[i] = fgl_clamp01(ctx->s.current.attr[ATTR_COLOR][i]);
    if (ctx->color_index)
        f->constant_color[0] = (float)fgl_index_mask((double)ctx->s.current.attr[ATTR_INDEX][0]);
    update_secondary(ctx, f, varying);
    f->primary_interpolated = f->arith != ARITH_EXACT && f->color_source == COLOR_CONSTANT && !ctx->color_index &&
                              ctx->s.lighting.shade_model != GL_FLAT;
    f->keeps_color = ctx->render_mode != GL_RENDER;
    f->texture_varying = 0;
    for (int k = 0; k < plan->vertex.textures; k++)
        f->texture_varying |= 1u << plan->vertex.texture[k].unit;
    f->samples_passed = ctx->count_samples ? &ctx->samples_passed : NULL;
    fgl_fragment_validate(f, &ctx->s, ctx->framebuffer, p->general);
    fgl_raster_validate(&plan->raster, &ctx->s, f);
    plan->polygon_fill = plan->raster.polygon_mode[0] == GL_FILL && plan->raster.polygon_mode[1] == GL_FILL;
    const struct rect *b = &plan->raster.bounds;
    plan->rasterize = b->x0 < b->x1 && b->y0 < b->y1;
}

void fgl_pipeline_validate(struct context *ctx, uint32_t varying)
{
    struct pipeline *p = ctx->pipeline;
    if (varying != p->plan.varying)
        ctx->dirty |= DIRTY_VARYING;
    if (!ctx->dirty)
        return;
    if (ctx->dirty & VERTEX_DEPS)
        fgl_vertex_validate(&p->plan.vertex, ctx, varying, ctx->framebuffer);
    if (ctx->dirty & FRAGMENT_DEPS)
        update_fragment(ctx, p, varying);
    p->plan.vertex.color_is_spread = p->plan.fragment.primary_interpolated;
    update_emit(&p->plan);
    p->plan.fetch = fetch_mask(&p->plan);
    p->plan.varying = varying;
    p->plan.seen_first = p->plan.polygon_fill && p->plan.emit.lanes > LANE_COLOR && ctx->render_mode == GL_RENDER;
    if (ctx->render_mode != GL_RENDER)
        fgl_feedback_validate(ctx, &p->plan);
    else
        p->plan.feedback.texture_coords = false;
    ctx->dirty = 0;
    if (p->print_plan)
        fgl_plan_print(&p->plan);
}
