#include "pipeline/raster_position.h"

#include "pipeline/pipeline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* OSMesa rule: raster positions are transformed by modelview and projection one after the other, each sum
 * left to right. */
static void transform(float out[4], const float m[16], const float v[4])
{
    for (int r = 0; r < 4; r++)
        out[r] = m[r] * v[0] + m[4 + r] * v[1] + m[8 + r] * v[2] + m[12 + r] * v[3];
}

static bool inside(const struct context *ctx, const float eye[4], const float clip[4])
{
    const struct transform_state *t = &ctx->s.transform;
    for (int c = 0; c < 3; c++)
        if (!(clip[c] <= clip[3] && -clip[c] <= clip[3]))
            return false;
    for (int i = 0; i < FGL_MAX_CLIP_PLANES; i++) {
        const float *p = t->clip_plane[i];
        if ((t->clip_plane_enabled >> i & 1) &&
            p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2] + p[3] * eye[3] < 0.0f)
            return false;
    }
    return true;
}

static void to_window(const struct viewport_state *s, const float clip[4], float window[4])
{
    const float inverse_w = clip[3] == 0.0f ? 1.0f : 1.0f / clip[3];
    const float half_width = (float)s->viewport[2] * 0.5f, half_height = (float)s->viewport[3] * 0.5f;
    const double near = (double)s->depth_range[0], far = (double)s->depth_range[1];
    const float scale[3] = {half_width, half_height, (float)(0.5 * (far - near))};
    const float trans[3] = {half_width + (float)s->viewport[0], half_height + (float)s->viewport[1],
                            (float)(0.5 * (near + far))};
    for (int c = 0; c < 3; c++)
        window[c] = clip[c] * inverse_w * scale[c] + trans[c];
    window[3] = clip[3];
}

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
    fgl_vertex_run(&p->plan.vertex, b, p->general);
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
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        memcpy(current->raster_texture_coords[unit], current->attr[ATTR_TEX0 + unit], 4 * sizeof(float));
}

void fgl_raster_position_set(struct context *ctx, const float object[4])
{
    struct current_state *current = &ctx->s.current;
    float eye[4], clip[4];

    transform(eye, fgl_matrix_top(&ctx->modelview)->m, object);
    transform(clip, fgl_matrix_top(&ctx->projection)->m, eye);
    current->raster_position_valid = inside(ctx, eye, clip);
    if (!current->raster_position_valid)
        return;
    to_window(&ctx->s.viewport, clip, current->raster_position);
    current->raster_distance = ctx->s.fog.fog_coord_src == GL_FOG_COORDINATE
                                       ? current->attr[ATTR_FOG_COORD][0]
                                       : sqrtf(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    take_current(ctx, false);
    if (ctx->s.lighting.lighting && ctx->framebuffer)
        light(ctx, object, current);
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        transform(current->raster_texture_coords[unit], fgl_matrix_top(&ctx->texture_matrix[unit])->m,
                  current->attr[ATTR_TEX0 + unit]);
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
    take_current(ctx, true);
}
