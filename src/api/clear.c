/* glClear (GL 1.5, 4.2.3 "Clearing the Buffers"): obeys the scissor and the write masks. */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "framebuffer/accum.h"
#include "pipeline/explain.h"
#include "pipeline/pipeline.h"
#include "raster/raster.h"

#include <math.h>

/* OSMesa rules: a part of the framebuffer is cleared by drawing it, a part of the channels too, and depth together with a part of the
 * stencil's bits. */
struct drawn {
    bool color, depth;
};

static struct drawn drawn_buffers(const struct context *ctx, GLbitfield mask, const struct rect *r)
{
    const struct framebuffer *fb = ctx->framebuffer;
    const bool *write = ctx->s.color_buffer.color_writemask;
    const bool part = r->x0 > 0 || r->y0 > 0 || r->x1 < fb->width || r->y1 < fb->height;
    const bool stencil = fb->stencil_bits && (mask & GL_STENCIL_BUFFER_BIT) && (ctx->s.stencil.stencil_writemask & 255) != 255;
    return (struct drawn){part || !(write[0] && write[1] && write[2] && (write[3] || !fb->has_alpha)), part || stencil};
}

/* OSMesa rule: the colour of a clear that is not drawn is rounded to an image of few bits, what is drawn is cut off. */
static void clear_color(struct framebuffer *fb, struct rect r, const struct color_buffer_state *c, bool drawn)
{
    float color[4];
    for (int i = 0; i < 4; i++) {
        const float max = (float)((1u << fb->image_bits[i]) - 1), v = c->color_clear_value[i];
        color[i] = drawn || !fb->image_bits[i] ? v : floorf(fgl_clamp01(v) * max + 0.5f) / max;
    }
    fgl_clear_color(fb, r, color, c->color_writemask, drawn);
}

void fgl_exec_Clear(struct context *ctx, GLbitfield mask)
{
    const GLbitfield all = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
    RETURN_ERROR_IF(ctx, mask & ~all, GL_INVALID_VALUE);
    fgl_flush_vertices(ctx, 0);
    if (!fgl_draw_ready(ctx))
        return;
    struct framebuffer *fb = ctx->framebuffer;
    if (!fb || ctx->render_mode != GL_RENDER)
        return;
    fb->drawn = true;
    const struct rect r = fgl_raster_bounds(&ctx->s.scissor, fb);
    const struct color_buffer_state *c = &ctx->s.color_buffer;
    const struct drawn drawn = drawn_buffers(ctx, mask, &r);
    if ((mask & GL_COLOR_BUFFER_BIT) && c->draw_buffer != GL_NONE) {
        if (ctx->color_index)
            fgl_clear_index(fb, r, c->index_clear_value, c->index_writemask);
        else
            clear_color(fb, r, c, drawn.color);
    }
    if ((mask & GL_DEPTH_BUFFER_BIT) && ctx->s.depth.depth_writemask)
        fgl_clear_depth(fb, r, ctx->s.depth.depth_clear_value, drawn.depth);
    if (mask & GL_STENCIL_BUFFER_BIT)
        fgl_clear_stencil(fb, r, ctx->s.stencil.stencil_clear_value, ctx->s.stencil.stencil_writemask);
    if (FGL_UNLIKELY(ctx->pipeline->explain != NULL))
        fgl_explain_clear(ctx, mask, r);
    if ((mask & GL_ACCUM_BUFFER_BIT) && fb->accum_bits && !fgl_accum_clear(fb, r, ctx->s.accum.accum_clear_value))
        fgl_error(ctx, GL_OUT_OF_MEMORY);
}
