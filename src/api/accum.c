/* glAccum (GL 1.5, 4.2.4 "The Accumulation Buffer"). */
#include "api/command.h"
#include "api/framebuffer_object.h"
#include "api/set.h"
#include "framebuffer/accum.h"
#include "raster/raster.h"

void fgl_exec_ClearAccum(struct context *ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    const float given[4] = {red, green, blue, alpha};
    float value[4];
    for (int c = 0; c < 4; c++)
        value[c] = given[c] > -1.0f ? (given[c] < 1.0f ? given[c] : 1.0f) : -1.0f;
    fgl_set_floats(ctx, 0, ctx->s.accum.accum_clear_value, value, 4);
}

void fgl_exec_Accum(struct context *ctx, GLenum op, GLfloat value)
{
    RETURN_ERROR_IF(ctx, op != GL_ACCUM && op != GL_LOAD && op != GL_ADD && op != GL_MULT && op != GL_RETURN,
                    GL_INVALID_ENUM);
    if (!fgl_draw_ready(ctx))
        return;
    struct framebuffer *fb = ctx->framebuffer;
    RETURN_ERROR_IF(ctx, !fb || !fb->accum_bits, GL_INVALID_OPERATION);
    fgl_flush_vertices(ctx, 0);
    if (ctx->render_mode != GL_RENDER)
        return;
    RETURN_ERROR_IF(ctx, !fgl_accum_ready(fb), GL_OUT_OF_MEMORY);
    const struct rect r = fgl_raster_bounds(&ctx->s.scissor, fb);
    switch (op) {
    case GL_ACCUM:
    case GL_LOAD:
        if (ctx->s.pixel_mode.read_buffer != GL_NONE)
            fgl_accum_color(fb, r, value, op == GL_ACCUM);
        break;
    case GL_ADD: fgl_accum_add(fb, r, value); break;
    case GL_MULT: fgl_accum_multiply(fb, r, value); break;
    default:
        if (ctx->s.color_buffer.draw_buffer != GL_NONE) {
            fgl_accum_return(fb, r, value, ctx->s.color_buffer.color_writemask);
            fb->drawn = true;
        }
        break;
    }
}
