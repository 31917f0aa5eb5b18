#include "pipeline/raster_position.h"

#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

/* The colours, or the index, that lighting gives the position as a vertex. */
static bool light(struct context *ctx, const float object[4], struct current_state *current)
{
    struct pipeline *p = ctx->pipeline;
    if (!p->batch[0] && !(p->batch[0] = calloc(1, sizeof *p->batch[0])))
        return false;
    struct vertex_batch *b = p->batch[0];
    fgl_pipeline_validate(ctx, 1u << ATTR_POSITION);
    b->n = 1;
    b->varying = 1u << ATTR_POSITION;
    for (int c = 0; c < 4; c++)
        b->in[ATTR_POSITION].c[c][0] = object[c];
    const bool light_fragments = p->plan.vertex.light_fragments;
    p->plan.vertex.light_fragments = false; /* this vertex has no fragments */
    fgl_vertex_run(&p->plan.vertex, b, p->general);
    p->plan.vertex.light_fragments = light_fragments;
    fgl_vertex_round(&p->plan.vertex, b);
    if (ctx->color_index) {
        current->raster_index = b->color[0].c[0][0];
        return true;
    }
    for (int c = 0; c < 4; c++)
        current->raster_color[c] = b->color[0].c[c][0];
    for (int c = 0; c < 3; c++)
        current->raster_secondary_color[c] =
                p->plan.vertex.light.separate_specular ? b->secondary[0].c[c][0] : 0.0f;
    return true;
}

/* The current values. OSMesa rule: window positions clamp the colours. */
static void take_current(struct context *ctx, bool clamp)
{
    struct current_state *current = &ctx->s.current;
    for (int c = 0; c < 4; c++) {
        const float color = current->attr[ATTR_COLOR][c], secondary = current->attr[ATTR_SECONDARY_COLOR][c];
        current->raster_color[c] = clamp ? fgl_clamp01(color) : color;
        current->raster_secondary_color[c] = clamp ? fgl_clamp01(secondary) : secondary;
    }
    current->raster_index = current->attr[ATTR_INDEX][0];
}

void fgl_raster_position_set(struct context *ctx, const float object[4])
{
    struct current_state *current = &ctx->s.current;

    current->raster_position_valid = fgl_clip_kernels(fgl_context_arith(ctx))->place(ctx, object);
    if (!current->raster_position_valid)
        return;
    if (ctx->s.fog.fog_coord_src == GL_FOG_COORDINATE)
        current->raster_distance = current->attr[ATTR_FOG_COORD][0];
    take_current(ctx, false);
    if (ctx->s.lighting.lighting && ctx->framebuffer)
        light(ctx, object, current);
}

void fgl_raster_position_set_window(struct context *ctx, float x, float y, float z)
{
    struct current_state *current = &ctx->s.current;
    const float near = ctx->s.viewport.depth_range[0], far = ctx->s.viewport.depth_range[1];

    current->raster_position[0] = x;
    current->raster_position[1] = y;
    current->raster_position[2] = fgl_clamp01(z) * (far - near) + near;
    current->raster_position[3] = 1.0f;
    current->raster_position_valid = true;
    current->raster_distance =
            ctx->s.fog.fog_coord_src == GL_FOG_COORDINATE ? current->attr[ATTR_FOG_COORD][0] : 0.0f;
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        memcpy(current->raster_texture_coords[unit], current->attr[ATTR_TEX0 + unit], 4 * sizeof(float));
    take_current(ctx, true);
}
