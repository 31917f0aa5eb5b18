/* fixedglExplainPixel, fixedglExplain: why a pixel has its colour (docs/explain.md). */
#include "pipeline/explain.h"
#include "api/errors.h"
#include "pipeline/pipeline.h"

#include "fixedgl.h"

void GLAPIENTRY fixedglExplainPixel(GLint x, GLint y)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    RETURN_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, y < 0 && x >= 0, GL_INVALID_VALUE);

    fgl_flush_vertices(ctx, 0); /* drawn before */
    if (x < 0)
        fgl_explain_stop(ctx->pipeline);
    else
        RETURN_ERROR_IF(ctx, !fgl_explain_start(ctx->pipeline, x, y), GL_OUT_OF_MEMORY);
}

const char *GLAPIENTRY fixedglExplain(GLenum form, GLint vertex)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return NULL;
    RETURN_VALUE_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION, NULL);
    RETURN_VALUE_ERROR_IF(ctx, form != FIXEDGL_TEXT && form != FIXEDGL_JSON, GL_INVALID_ENUM, NULL);
    RETURN_VALUE_ERROR_IF(ctx, vertex < -1 || vertex > 2, GL_INVALID_VALUE, NULL);

    fgl_flush_vertices(ctx, 0);
    struct explain *e = ctx->pipeline->explain;
    RETURN_VALUE_ERROR_IF(ctx, !e || !ctx->framebuffer || !fgl_explain_look(ctx), GL_INVALID_OPERATION, NULL);
    if (form == FIXEDGL_JSON)
        fgl_explain_json(e, ctx->framebuffer, vertex);
    else
        fgl_explain_text(e, ctx->framebuffer, vertex);
    RETURN_VALUE_ERROR_IF(ctx, !e->text.data, GL_OUT_OF_MEMORY, NULL);
    return e->text.data;
}
