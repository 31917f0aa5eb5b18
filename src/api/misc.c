/* Errors, flushing, and what FixedGL adds (GL 1.5, 2.5 "GL Errors", 5.5 "Flush and Finish"). */
#include "api/command.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"

#include "fixedgl.h"
#include "pipeline/explain.h"
#include "pipeline/pipeline.h"
#include "pipeline/plan_report.h"

GLenum GLAPIENTRY glGetError(void)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return GL_NO_ERROR;
    RETURN_VALUE_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION, GL_NO_ERROR);

    const GLenum error = ctx->error;
    ctx->error = GL_NO_ERROR;
    return error;
}

void fgl_exec_Flush(struct context *ctx)
{
    fgl_framebuffer_store(ctx);
    if (ctx->present)
        ctx->present(ctx);
    if (FGL_UNLIKELY(ctx->pipeline->explain != NULL))
        fgl_explain_write(ctx);
    if (FGL_UNLIKELY(ctx->pipeline->report != NULL))
        fgl_plan_report_write(ctx->pipeline);
}

void fgl_exec_Finish(struct context *ctx)
{
    fgl_exec_Flush(ctx);
}

const char *GLAPIENTRY fixedglVersion(void)
{
    return FIXEDGL_VERSION;
}

/* All of the plan depends on it. */
void fgl_set_accuracy(struct context *ctx, GLenum mode)
{
    if (mode == ctx->accuracy)
        return;
    fgl_flush_vertices(ctx, DIRTY_ALL);
    ctx->accuracy = mode;
}

GLenum GLAPIENTRY fixedglAccuracy(GLenum mode)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return 0;
    RETURN_VALUE_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION, 0);
    RETURN_VALUE_ERROR_IF(ctx, mode != FIXEDGL_EXACT && mode != FIXEDGL_COMPATIBLE, GL_INVALID_ENUM, 0);

    const GLenum before = ctx->accuracy;
    fgl_set_accuracy(ctx, mode);
    return before;
}
