/* Occlusion queries (GL 1.5, 4.1.7 "Occlusion Queries", 6.1.12 "Asynchronous Queries"). Counting is the fragment stage's
 * (fragment/tests.h); drawing is over when EndQuery returns, so that a result is always there. */
#include "api/query.h"

#include "api/command.h"
#include "api/errors.h"
#include "base/idmap.h"

#include <limits.h>
#include <stdlib.h>

struct query {
    uint64_t result;
    bool created; /* begun once; until then only its name is taken */
};

struct queries {
    struct idmap map; /* name -> struct query */
    GLuint current;   /* the running one, or 0 */
};

void fgl_queries_destroy(struct context *ctx)
{
    if (ctx->queries)
        fgl_idmap_free(&ctx->queries->map, free);
    free(ctx->queries);
    ctx->queries = NULL;
}

/* The context's queries, made when first used; NULL after recording GL_OUT_OF_MEMORY. */
static struct queries *queries(struct context *ctx)
{
    if (!ctx->queries)
        ctx->queries = calloc(1, sizeof *ctx->queries);
    if (!ctx->queries)
        fgl_error(ctx, GL_OUT_OF_MEMORY);
    return ctx->queries;
}

static struct query *add(struct context *ctx, struct queries *q, GLuint name)
{
    struct query *query = calloc(1, sizeof *query);
    if (query && fgl_idmap_put(&q->map, name, query))
        return query;
    free(query);
    fgl_error(ctx, GL_OUT_OF_MEMORY);
    return NULL;
}

void fgl_exec_GenQueries(struct context *ctx, GLsizei n, GLuint *ids)
{
    struct queries *q = queries(ctx);
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    const GLuint first = q && n ? fgl_idmap_find_free(&q->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++) {
        if (!add(ctx, q, first + i))
            return;
        ids[i] = first + i;
    }
}

/* What was drawn so far belongs to the counter that runs now. */
static void set_counting(struct context *ctx, bool on)
{
    fgl_flush_vertices(ctx, DIRTY_FRAGMENT);
    ctx->count_samples = on;
}

static void end(struct context *ctx, struct queries *q)
{
    struct query *query = fgl_idmap_get(&q->map, q->current);
    set_counting(ctx, false);
    query->result = atomic_load(&ctx->samples_passed);
    q->current = 0;
}

void fgl_exec_DeleteQueries(struct context *ctx, GLsizei n, const GLuint *ids)
{
    struct queries *q = queries(ctx);
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    for (GLsizei i = 0; q && i < n; i++) {
        if (ids[i] && ids[i] == q->current)
            end(ctx, q);
        free(fgl_idmap_remove(&q->map, ids[i]));
    }
}

GLboolean fgl_exec_IsQuery(struct context *ctx, GLuint id)
{
    const struct query *query = ctx->queries ? fgl_idmap_get(&ctx->queries->map, id) : NULL;
    return query && query->created ? GL_TRUE : GL_FALSE;
}

void fgl_exec_BeginQuery(struct context *ctx, GLenum target, GLuint id)
{
    struct queries *q = queries(ctx);
    RETURN_ERROR_IF(ctx, target != GL_SAMPLES_PASSED, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, id == 0, GL_INVALID_OPERATION);
    if (!q)
        return;
    RETURN_ERROR_IF(ctx, q->current, GL_INVALID_OPERATION);
    struct query *query = fgl_idmap_get(&q->map, id);
    if (!query && !(query = add(ctx, q, id)))
        return;
    query->created = true;
    q->current = id;
    set_counting(ctx, true);
    atomic_store(&ctx->samples_passed, 0);
}

void fgl_exec_EndQuery(struct context *ctx, GLenum target)
{
    RETURN_ERROR_IF(ctx, target != GL_SAMPLES_PASSED, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !ctx->queries || !ctx->queries->current, GL_INVALID_OPERATION);
    end(ctx, ctx->queries);
}

void fgl_exec_GetQueryiv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    RETURN_ERROR_IF(ctx, target != GL_SAMPLES_PASSED, GL_INVALID_ENUM);
    switch (pname) {
    case GL_CURRENT_QUERY: *params = ctx->queries ? (GLint)ctx->queries->current : 0; break;
    case GL_QUERY_COUNTER_BITS: *params = 64; break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}

/* A property of an object that is not running; false after recording an error. */
static bool property(struct context *ctx, GLuint id, GLenum pname, uint64_t *value)
{
    const struct query *query = ctx->queries ? fgl_idmap_get(&ctx->queries->map, id) : NULL;
    RETURN_VALUE_ERROR_IF(ctx, !query || !query->created || id == ctx->queries->current, GL_INVALID_OPERATION, false);
    switch (pname) {
    case GL_QUERY_RESULT: *value = query->result; return true;
    case GL_QUERY_RESULT_AVAILABLE: *value = 1; return true;
    default: fgl_error(ctx, GL_INVALID_ENUM); return false;
    }
}

/* GL 1.5, 6.1.12: more than the type holds is its largest value. */
void fgl_exec_GetQueryObjectiv(struct context *ctx, GLuint id, GLenum pname, GLint *params)
{
    uint64_t value;
    if (property(ctx, id, pname, &value))
        *params = value < INT_MAX ? (GLint)value : INT_MAX;
}

void fgl_exec_GetQueryObjectuiv(struct context *ctx, GLuint id, GLenum pname, GLuint *params)
{
    uint64_t value;
    if (property(ctx, id, pname, &value))
        *params = value < UINT_MAX ? (GLuint)value : UINT_MAX;
}
