#include "pipeline/pixels.h"

#include "base/color_index.h"
#include "pipeline/pipeline.h"

#include <stddef.h>
#include <string.h>

/* OSMesa rules: z goes through clip space (not in exact mode); pixel rectangles have the fog coordinate 0, and no secondary
 * colour; the raster colours are clamped. */
static void set_planes(struct planes *p, enum fgl_arith arith, const struct current_state *current)
{
    const float z = current->raster_position[2], clip_z = z * 2.0f - 1.0f;
    for (int lane = 0; lane < LANE_TEX0; lane++) /* no other is read */
        fgl_plane_set(p, arith, lane, 0);
    fgl_plane_set(p, arith, LANE_OOW, 1);
    fgl_plane_set(p, arith, LANE_Z, (double)(arith == ARITH_EXACT ? z : clip_z * 0.5f + 0.5f));
    if (arith == ARITH_EXACT)
        p->exact.z_offset = 0;
    else
        p->z_offset = 0;
    p->smoothing = SMOOTH_NONE;
    p->stipple = NULL;
}

/* GL 1.5, 3.9 "Color Sum". */
static bool color_sum(const struct server_state *s)
{
    return s->lighting.lighting ? s->lighting.light_model_color_control == GL_SEPARATE_SPECULAR_COLOR
                                : s->fog.color_sum;
}

void fgl_pixels_begin(struct context *ctx, enum pixel_kind kind, struct pixel_draw *draw)
{
    struct fragment_plan *f = &draw->fragment;

    memset(f, 0, offsetof(struct fragment_plan, texture));
    memset(&draw->inputs, 0, sizeof draw->inputs);
    f->arith = fgl_context_arith(ctx);
    f->color_source = kind == PIXELS_COLOR ? COLOR_IMAGE : COLOR_CONSTANT;
    for (int c = 0; c < 4; c++)
        f->constant_color[c] = fgl_clamp01(ctx->s.current.raster_color[c]);
    if (ctx->color_index)
        f->constant_color[0] = (float)fgl_index_mask((double)ctx->s.current.raster_index);
    f->has_secondary = kind == PIXELS_BITMAP && color_sum(&ctx->s);
    for (int c = 0; c < 3; c++)
        f->constant_secondary[c] = fgl_clamp01(ctx->s.current.raster_secondary_color[c]);
    f->samples_passed = ctx->count_samples ? &ctx->samples_passed : NULL;
    fgl_fragment_validate(f, &ctx->s, ctx->framebuffer, ctx->pipeline->general);
    if (kind != PIXELS_BITMAP)
        f->pixels = &draw->inputs;
    if (kind == PIXELS_DEPTH) {
        f->fill = f->general;
        f->has_fog = false; /* OSMesa rules */
        f->textures = 0;
    }
    draw->bounds = fgl_raster_bounds(&ctx->s.scissor, ctx->framebuffer);
    set_planes(&draw->planes, f->arith, &ctx->s.current);
    if (ctx->color_index) /* GL 1.5, 3.6.4: the data of the raster position, its distance too */
        fgl_plane_set(&draw->planes, f->arith, LANE_FOG, (double)ctx->s.current.raster_distance);
    ctx->framebuffer->drawn = true;
}

bool fgl_pixels_take_unorm8(const struct pixel_draw *draw)
{
    const struct fragment_plan *f = &draw->fragment;
    const bool drawn = f->color_buffer.draw_buffer != GL_NONE; /* else the alpha test is not of bytes */
    return f->color_source == COLOR_IMAGE && f->fb->color_kind == COLOR_UNORM8 && drawn && !f->textures && !f->has_fog;
}

void fgl_pixels_runs(const struct pixel_draw *draw, const struct runs *runs)
{
    draw->fragment.fill(&draw->fragment, &draw->planes, runs);
}

void fgl_pixels_run(const struct pixel_draw *draw, int y, int x0, int x1)
{
    struct runs runs; /* but for one not initialised, which would take longer than to draw it */
    runs.y = y;
    runs.n = 1;
    runs.x0[0] = x0;
    runs.x1[0] = x1;
    fgl_pixels_runs(draw, &runs);
}
