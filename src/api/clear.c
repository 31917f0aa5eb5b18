/* glClear (GL 1.5, 4.2.3 "Clearing the Buffers"): obeys the scissor and the write masks. */
#include "api/command.h"
#include "api/errors.h"
#include "framebuffer/framebuffer.h"

/* The pixels that the scissor lets through, y down. */
static struct rect scissored(const struct context *ctx)
{
    const struct framebuffer *fb = ctx->framebuffer;
    struct rect r = {0, 0, fb->width, fb->height};
    if (!ctx->s.scissor.scissor_test)
        return r;
    const int *box = ctx->s.scissor.scissor_box;
    const int64_t right = (int64_t)box[0] + box[2], top = (int64_t)box[1] + box[3];
    r.x0 = fgl_clamp(box[0], 0, fb->width);
    r.x1 = (int)(right < 0 ? 0 : right > fb->width ? fb->width : right);
    r.y0 = fb->height - (int)(top < 0 ? 0 : top > fb->height ? fb->height : top);
    r.y1 = fb->height - fgl_clamp(box[1], 0, fb->height);
    return r;
}

void fgl_exec_Clear(struct context *ctx, GLbitfield mask)
{
    const GLbitfield all = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
    RETURN_ERROR_IF(ctx, mask & ~all, GL_INVALID_VALUE);
    fgl_flush_vertices(ctx, 0);
    struct framebuffer *fb = ctx->framebuffer;
    if (!fb || ctx->render_mode != GL_RENDER)
        return;
    fb->drawn = true;
    const struct rect r = scissored(ctx);
    const struct color_buffer_state *c = &ctx->s.color_buffer;
    if ((mask & GL_COLOR_BUFFER_BIT) && c->draw_buffer != GL_NONE)
        fgl_clear_color(fb, r, c->color_clear_value, c->color_writemask);
    if ((mask & GL_DEPTH_BUFFER_BIT) && ctx->s.depth.depth_writemask)
        fgl_clear_depth(fb, r, ctx->s.depth.depth_clear_value);
    if (mask & GL_STENCIL_BUFFER_BIT)
        fgl_clear_stencil(fb, r, ctx->s.stencil.stencil_clear_value, ctx->s.stencil.stencil_writemask);
}
