/* GL errors (GL 1.5, 2.5 "GL Errors"), and what every setter does before it stores. api is the only layer that records errors. */
#ifndef FGL_API_ERRORS_H
#define FGL_API_ERRORS_H

#include "state/context.h"

/* Records `error` unless an earlier one waits for glGetError. */
static inline void fgl_error(struct context *ctx, GLenum error)
{
    if (ctx->error == GL_NO_ERROR)
        ctx->error = error;
}

/* One line per rule, in the specification's order, before any state is touched. */
#define RETURN_ERROR_IF(ctx, condition, code)                                                                \
    do {                                                                                                     \
        if (condition) {                                                                                     \
            fgl_error((ctx), (code));                                                                        \
            return;                                                                                          \
        }                                                                                                    \
    } while (0)
#define RETURN_VALUE_ERROR_IF(ctx, condition, code, value)                                                   \
    do {                                                                                                     \
        if (condition) {                                                                                     \
            fgl_error((ctx), (code));                                                                        \
            return (value);                                                                                  \
        }                                                                                                    \
    } while (0)

/* Draws the vertices that immediate mode still holds, since the state they were given under is about to change, and makes
 * attributes set outside Begin/End the current values; then marks `dirty`. A setter calls it only when a value really changes:
 * OSMesa's batches end in the same places, and some pixels depend on where they end. (api/begin_end.c) */
void fgl_flush_vertices(struct context *ctx, unsigned dirty);

/* The arithmetic that later draws use: FIXEDGL_EXACT, ... (api/misc.c) */
void fgl_set_accuracy(struct context *ctx, GLenum mode);

/* The same in any case: before what is drawn otherwise than by immediate mode. (api/begin_end.c) */
void fgl_flush_all(struct context *ctx);

/* Makes attributes that immediate mode still holds the current values, and draws nothing; for queries of current values.
 * (api/begin_end.c) */
void fgl_flush_current(struct context *ctx);
/* Before vertices that are not immediate mode's are drawn: stored ones are drawn, attributes become current values. */
void fgl_flush_for_arrays(struct context *ctx);

#endif
