/* Selection and feedback (GL 1.5, 5.2 "Selection", 5.3 "Feedback"): render modes, their buffers, the name
 * stack. What is drawn arrives through pipeline/feedback.c. */
#include "api/command.h"
#include "api/errors.h"
#include "pipeline/feedback.h"

/* ---- hit records ---- */

static void put(struct selection_state *s, unsigned value)
{
    if (s->count < s->size)
        s->buffer[s->count] = value;
    if (s->count <= s->size)
        s->count++;
}

/* Window depth as an unsigned integer. OSMesa rule: times 2^32, where GL says 2^32 - 1; 1.0, which OSMesa
 * makes 0, is the largest. */
static unsigned depth_value(float z)
{
    return z < 1.0f ? (unsigned)((double)z * 4294967296.0) : 0xffffffffu;
}

/* Ends what belongs to the present contents of the name stack: a record if anything was hit. */
static void finish_names(struct context *ctx)
{
    struct selection_state *s = &ctx->selection;
    fgl_flush_vertices(ctx, 0);
    if (!s->hit)
        return;
    s->hit = false;
    s->hits++;
    put(s, (unsigned)s->name_stack_depth);
    put(s, depth_value(s->min_z));
    put(s, depth_value(s->max_z));
    for (int i = 0; i < s->name_stack_depth; i++)
        put(s, s->name[i]);
}

/* ---- the name stack: commands do nothing in other modes ---- */

void fgl_exec_InitNames(struct context *ctx)
{
    if (ctx->render_mode != GL_SELECT)
        return;
    finish_names(ctx);
    ctx->selection.name_stack_depth = 0;
}

void fgl_exec_LoadName(struct context *ctx, GLuint name)
{
    struct selection_state *s = &ctx->selection;
    if (ctx->render_mode != GL_SELECT)
        return;
    RETURN_ERROR_IF(ctx, s->name_stack_depth == 0, GL_INVALID_OPERATION);
    finish_names(ctx);
    s->name[s->name_stack_depth - 1] = name;
}

void fgl_exec_PushName(struct context *ctx, GLuint name)
{
    struct selection_state *s = &ctx->selection;
    if (ctx->render_mode != GL_SELECT)
        return;
    RETURN_ERROR_IF(ctx, s->name_stack_depth >= FGL_MAX_NAME_DEPTH, GL_STACK_OVERFLOW);
    finish_names(ctx);
    s->name[s->name_stack_depth++] = name;
}

void fgl_exec_PopName(struct context *ctx)
{
    struct selection_state *s = &ctx->selection;
    if (ctx->render_mode != GL_SELECT)
        return;
    RETURN_ERROR_IF(ctx, s->name_stack_depth == 0, GL_STACK_UNDERFLOW);
    finish_names(ctx);
    s->name_stack_depth--;
}

/* ---- buffers ---- */

void fgl_exec_SelectBuffer(struct context *ctx, GLsizei size, GLuint *buffer)
{
    RETURN_ERROR_IF(ctx, size < 0 || (size > 0 && !buffer), GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, ctx->render_mode == GL_SELECT, GL_INVALID_OPERATION);
    ctx->selection.buffer = buffer;
    ctx->selection.size = size;
}

void fgl_exec_FeedbackBuffer(struct context *ctx, GLsizei size, GLenum type, GLfloat *buffer)
{
    RETURN_ERROR_IF(ctx, ctx->render_mode == GL_FEEDBACK, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, size < 0 || (size > 0 && !buffer), GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, type < GL_2D || type > GL_4D_COLOR_TEXTURE, GL_INVALID_ENUM);
    ctx->feedback.buffer = buffer;
    ctx->feedback.size = size;
    ctx->feedback.type = type;
}

void fgl_exec_PassThrough(struct context *ctx, GLfloat token)
{
    if (ctx->render_mode != GL_FEEDBACK)
        return;
    fgl_flush_vertices(ctx, 0);
    fgl_feedback_value(&ctx->feedback, GL_PASS_THROUGH_TOKEN);
    fgl_feedback_value(&ctx->feedback, token);
}

/* ---- render modes ---- */

/* Leaves the mode; what glRenderMode returns. */
static GLint finish_mode(struct context *ctx)
{
    struct selection_state *s = &ctx->selection;
    struct feedback_state *f = &ctx->feedback;
    GLint result = 0;
    if (ctx->render_mode == GL_SELECT) {
        finish_names(ctx);
        result = s->count > s->size ? -1 : s->hits;
    } else if (ctx->render_mode == GL_FEEDBACK) {
        result = f->count > f->size ? -1 : f->count;
    }
    f->count = s->count = s->hits = s->name_stack_depth = 0;
    s->hit = false;
    return result;
}

GLint fgl_exec_RenderMode(struct context *ctx, GLenum mode)
{
    const bool known = mode == GL_RENDER || mode == GL_SELECT || mode == GL_FEEDBACK;
    RETURN_VALUE_ERROR_IF(ctx, !known, GL_INVALID_ENUM, 0);
    RETURN_VALUE_ERROR_IF(ctx, mode == GL_SELECT && ctx->selection.size == 0, GL_INVALID_OPERATION, 0);
    RETURN_VALUE_ERROR_IF(ctx, mode == GL_FEEDBACK && ctx->feedback.size == 0, GL_INVALID_OPERATION, 0);
    fgl_flush_vertices(ctx, DIRTY_ALL);
    const GLint result = finish_mode(ctx);
    ctx->render_mode = mode;
    return result;
}
