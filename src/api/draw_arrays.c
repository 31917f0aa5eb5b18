/* Drawing from vertex arrays (GL 1.5, 2.8 "Vertex Arrays", 2.9.2 "Array Indices in Buffer Objects"). */
#include "api/array_source.h"
#include "api/buffer.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/immediate.h"
#include "api/list.h"
#include "pipeline/pipeline.h"
#include "state/share.h"

#include <stdlib.h>

/* Vertices beyond the end of all arrays that a draw may have and still be drawn: they are zeros, as many as anyone asks for. */
enum { MAX_BEYOND = 1 << 16 };

void GLAPIENTRY glArrayElement(GLint i)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    RETURN_ERROR_IF(ctx, i < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, fgl_arrays_mapped(ctx), GL_INVALID_OPERATION);
    struct vertex_source source;
    const bool entered = fgl_share_enter(ctx);
    fgl_array_source(ctx, &source);
    fgl_array_element(ctx, &source, (uint32_t)i, false);
    fgl_share_leave(ctx, entered);
}

void GLAPIENTRY glArrayElementEXT(GLint i)
{
    glArrayElement(i);
}

static uint32_t element(GLenum type, const void *indices, int i)
{
    switch (type) {
    case GL_UNSIGNED_BYTE: return ((const GLubyte *)indices)[i];
    case GL_UNSIGNED_SHORT: return ((const GLushort *)indices)[i];
    default: return ((const GLuint *)indices)[i];
    }
}

/* While a list is compiled, arrays are dereferenced now (GL 1.5, 5.4): as Begin, vertices, End; those two also without vertices, since the
 * list may be called where a draw is an error. */
static void compile_elements(struct context *ctx, GLenum mode, int first, int count, GLenum type, const void *indices)
{
    struct vertex_source source;
    fgl_array_source(ctx, &source);
    if (!(source.varying & (1u << ATTR_POSITION)))
        count = 0;
    fgl_begin(ctx, mode);
    ctx->vertices->of_arrays = true;
    for (int i = 0; i < count; i++)
        fgl_array_element(ctx, &source, indices ? element(type, indices, i) : (uint32_t)(first + i), false);
    fgl_end(ctx);
}

/* Errors of all draws; false when one was raised. */
static bool check_draw(struct context *ctx, GLenum mode, GLsizei count)
{
    if (fgl_refused_inside(ctx))
        return false;
    if (mode > GL_POLYGON)
        fgl_command_error(ctx, GL_INVALID_ENUM);
    else if (count < 0)
        fgl_command_error(ctx, GL_INVALID_VALUE);
    else if (fgl_arrays_mapped(ctx))
        fgl_command_error(ctx, GL_INVALID_OPERATION);
    else
        return true;
    return false;
}

static void draw_arrays(struct context *ctx, GLenum mode, GLint first, GLsizei count)
{
    struct vertex_source source;
    fgl_array_source(ctx, &source);
    const uint32_t last = (uint32_t)first + (uint32_t)count - 1, present = fgl_array_source_count(&source);
    if (count == 0 || (last >= present && last - present >= MAX_BEYOND))
        return;
    if (ctx->compiling) {
        compile_elements(ctx, mode, first, count, 0, NULL);
        return;
    }
    if (!fgl_draw_ready(ctx))
        return;
    fgl_flush_for_arrays(ctx);
    const struct draw_prim prim = {mode, first, count, false};
    fgl_draw(ctx, &source, &prim, 1, NULL, (uint32_t)first, last);
}

void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    struct context *ctx = fgl_current;
    if (!ctx || !check_draw(ctx, mode, count))
        return;
    if (first < 0)
        fgl_command_error(ctx, GL_INVALID_VALUE);
    else
        FGL_SHARED(ctx, draw_arrays(ctx, mode, first, count));
}

void GLAPIENTRY glMultiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count, GLsizei drawcount)
{
    struct context *ctx = fgl_current;
    if (!ctx || !check_draw(ctx, mode, drawcount))
        return;
    for (GLsizei i = 0; i < drawcount; i++) {
        if (first[i] < 0 || count[i] < 0) { /* nothing is drawn */
            fgl_command_error(ctx, GL_INVALID_VALUE);
            return;
        }
    }
    for (GLsizei i = 0; i < drawcount; i++)
        FGL_SHARED(ctx, draw_arrays(ctx, mode, first[i], count[i]));
}

/* ---- elements ---- */

#define WIDEN(name, T)                                                                                       \
    static void widen_##name(uint32_t *FGL_RESTRICT to, const T *FGL_RESTRICT from, int n, uint32_t *min, uint32_t *max) \
    {                                                                                                        \
        uint32_t lo = UINT32_MAX, hi = 0;                                                                    \
        for (int i = 0; i < n; i++) {                                                                        \
            const uint32_t e = from[i];                                                                      \
            to[i] = e;                                                                                       \
            lo = e < lo ? e : lo;                                                                            \
            hi = e > hi ? e : hi;                                                                            \
        }                                                                                                    \
        *min = lo;                                                                                           \
        *max = hi;                                                                                           \
    }
WIDEN(ubyte, GLubyte)
WIDEN(ushort, GLushort)
WIDEN(uint, GLuint)

/* The elements as 32-bit numbers in the pipeline's work space, and their range. NULL when memory is short. */
static const uint32_t *widen(struct pipeline *p, GLsizei count, GLenum type, const void *indices, uint32_t *min, uint32_t *max)
{
    if (count > p->elements_capacity) {
        uint32_t *bigger = realloc(p->elements, (size_t)count * sizeof *bigger);
        if (!bigger)
            return NULL;
        p->elements = bigger;
        p->elements_capacity = count;
    }
    switch (type) {
    case GL_UNSIGNED_BYTE: widen_ubyte(p->elements, indices, count, min, max); break;
    case GL_UNSIGNED_SHORT: widen_ushort(p->elements, indices, count, min, max); break;
    default: widen_uint(p->elements, indices, count, min, max); break;
    }
    return p->elements;
}

/* Elements scattered over a wide range: only the vertices named, one by one, through immediate mode. */
static void draw_scattered(struct context *ctx, const struct vertex_source *source, GLenum mode, GLsizei count, const uint32_t *e)
{
    fgl_begin(ctx, mode);
    for (int i = 0; i < count; i++)
        fgl_array_element(ctx, source, e[i], true);
    fgl_end(ctx);
    fgl_flush_vertices(ctx, 0);
}

/* Errors that elements add. */
static bool check_elements(struct context *ctx, GLenum mode, GLsizei count, GLenum type)
{
    const struct buffer_object *b = ctx->client.arrays.element_array_buffer;
    if (!check_draw(ctx, mode, count))
        return false;
    if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT)
        fgl_command_error(ctx, GL_INVALID_ENUM);
    else if (b && b->mapped)
        fgl_command_error(ctx, GL_INVALID_OPERATION);
    else
        return true;
    return false;
}

/* Where the indexes lie; with a buffer object bound, *count is cut to those that it holds. NULL: nowhere. */
static const void *find_indices(const struct context *ctx, GLenum type, const void *indices, GLsizei *count)
{
    const struct buffer_object *b = ctx->client.arrays.element_array_buffer;
    if (!b)
        return indices;
    const size_t offset = (size_t)(uintptr_t)indices;
    const size_t bytes = type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
    if (offset >= b->size)
        return NULL;
    const size_t present = (b->size - offset) / bytes;
    if ((size_t)*count > present)
        *count = (GLsizei)present;
    return b->data + offset;
}

/* The range of vertices that glDrawRangeElements named. */
struct range {
    GLuint start, end;
};

/* OSMesa rule: with elements that are no fewer than the vertices of the range, the whole range counts (pipeline/assemble.c). */
static void widen_range(const struct range *range, GLsizei count, uint32_t *min, uint32_t *max)
{
    if (range && range->start <= *min && range->end >= *max && range->end - range->start < (uint32_t)count) {
        *min = range->start;
        *max = range->end;
    }
}

/* range: NULL when the program named none. */
static void draw_elements(struct context *ctx, GLenum mode, GLsizei count, GLenum type, const GLvoid *given, const struct range *range)
{
    const void *indices = find_indices(ctx, type, given, &count);
    if (count == 0 || !indices)
        return;
    if (ctx->compiling) {
        compile_elements(ctx, mode, 0, count, type, indices);
        return;
    }
    if (!fgl_draw_ready(ctx))
        return;
    fgl_flush_for_arrays(ctx);
    struct vertex_source source;
    fgl_array_source(ctx, &source);
    uint32_t min, max;
    const uint32_t *e = widen(ctx->pipeline, count, type, indices, &min, &max);
    RETURN_ERROR_IF(ctx, !e, GL_OUT_OF_MEMORY);
    source.range_unknown = !range && fgl_array_source_count(&source) != UINT32_MAX;
    widen_range(range, count, &min, &max);
    if (max - min > 8 * (uint32_t)count + FGL_BATCH_SIZE) {
        draw_scattered(ctx, &source, mode, count, e);
        return;
    }
    const struct draw_prim prim = {mode, 0, count, false};
    fgl_draw(ctx, &source, &prim, 1, e, min, max);
}

void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const GLvoid *indices)
{
    struct context *ctx = fgl_current;
    if (ctx && check_elements(ctx, mode, count, type))
        FGL_SHARED(ctx, draw_elements(ctx, mode, count, type, indices, NULL));
}

void GLAPIENTRY glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const GLvoid *indices)
{
    struct context *ctx = fgl_current;
    const struct range range = {start, end};
    if (!ctx || !check_elements(ctx, mode, count, type))
        return;
    if (end < start)
        fgl_command_error(ctx, GL_INVALID_VALUE);
    else
        FGL_SHARED(ctx, draw_elements(ctx, mode, count, type, indices, &range));
}

void GLAPIENTRY glMultiDrawElements(GLenum mode, const GLsizei *count, GLenum type, const GLvoid *const *indices, GLsizei drawcount)
{
    struct context *ctx = fgl_current;
    if (!ctx || !check_elements(ctx, mode, drawcount, type))
        return;
    for (GLsizei i = 0; i < drawcount; i++) {
        if (count[i] < 0) { /* nothing is drawn */
            fgl_command_error(ctx, GL_INVALID_VALUE);
            return;
        }
    }
    for (GLsizei i = 0; i < drawcount; i++)
        FGL_SHARED(ctx, draw_elements(ctx, mode, count[i], type, indices[i], NULL));
}
