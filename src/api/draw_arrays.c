/* Drawing from vertex arrays (GL 1.5, 2.8 "Vertex Arrays"): DrawArrays, DrawElements, ArrayElement. */
#include "api/convert.h"
#include "api/errors.h"
#include "api/immediate.h"
#include "api/list.h"
#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

static int type_bytes(GLenum type)
{
    switch (type) {
    case GL_BYTE: case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT: case GL_UNSIGNED_SHORT: return 2;
    case GL_DOUBLE: return 8;
    default: return 4;
    }
}

/* The enabled arrays as a source. */
static void array_source(const struct context *ctx, struct vertex_source *source)
{
    source->varying = 0;
    source->compiled = false;
    source->arrays = true;
    for (int a = 0; a < ATTR_MATERIAL; a++) {
        const struct vertex_array *v = &ctx->client.arrays.array[a];
        if (!v->enabled)
            continue;
        source->varying |= 1u << a;
        source->attr[a] = (struct attr_source){v->pointer, v->type, v->size, v->stride ? v->stride : v->size * type_bytes(v->type)};
    }
}

/* OSMesa rule: an element that is no draw's is converted as glColor and glNormal convert. */
static void convert_as_command(const struct attr_source *a, uint32_t i, float v[4])
{
#define CONVERT(T, f)                                                                                        \
    for (int k = 0; k < a->size; k++) {                                                                      \
        T c;                                                                                                 \
        memcpy(&c, from + (size_t)k * sizeof c, sizeof c);                                                   \
        v[k] = f(c);                                                                                         \
    }                                                                                                        \
    break
    const char *from = (const char *)a->pointer + (size_t)i * (size_t)a->stride;
    switch (a->type) {
    case GL_BYTE: CONVERT(GLbyte, fgl_norm_b);
    case GL_SHORT: CONVERT(GLshort, fgl_norm_s);
    case GL_INT: CONVERT(GLint, fgl_norm_i);
    case GL_UNSIGNED_BYTE: CONVERT(GLubyte, fgl_norm_ub);
    case GL_UNSIGNED_SHORT: CONVERT(GLushort, fgl_norm_us);
    case GL_UNSIGNED_INT: CONVERT(GLuint, fgl_norm_ui);
    default: break;
    }
#undef CONVERT
}

/* One element of every enabled array through the commands of immediate mode, the position last. */
static void array_element(struct context *ctx, const struct vertex_source *source, uint32_t i, bool drawn)
{
    float v[4];
    for (int a = ATTR_COUNT - 1; a >= 0; a--) {
        if (!(source->varying & (1u << a)))
            continue;
        fgl_fetch_one(&source->attr[a], a, i, v);
        if (!drawn && (a == ATTR_COLOR || a == ATTR_SECONDARY_COLOR || a == ATTR_NORMAL))
            convert_as_command(&source->attr[a], i, v);
        if (a == ATTR_POSITION)
            fgl_vertex(ctx, source->attr[a].size, v);
        else
            fgl_attr_set(ctx, (enum fgl_attr)a, source->attr[a].size, v);
    }
}

void GLAPIENTRY glArrayElement(GLint i)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    RETURN_ERROR_IF(ctx, i < 0, GL_INVALID_VALUE);
    struct vertex_source source;
    array_source(ctx, &source);
    array_element(ctx, &source, (uint32_t)i, false);
}

static uint32_t element(GLenum type, const void *indices, int i)
{
    switch (type) {
    case GL_UNSIGNED_BYTE: return ((const GLubyte *)indices)[i];
    case GL_UNSIGNED_SHORT: return ((const GLushort *)indices)[i];
    default: return ((const GLuint *)indices)[i];
    }
}

/* While a list is compiled, arrays are dereferenced now (GL 1.5, 5.4): as Begin, vertices, End. */
static void compile_elements(struct context *ctx, GLenum mode, int first, int count, GLenum type, const void *indices)
{
    struct vertex_source source;
    array_source(ctx, &source);
    if (!(source.varying & (1u << ATTR_POSITION)))
        return;
    fgl_begin(ctx, mode);
    for (int i = 0; i < count; i++)
        array_element(ctx, &source, indices ? element(type, indices, i) : (uint32_t)(first + i), false);
    fgl_end(ctx);
}

/* Errors of both draws; false when one was raised. */
static bool check_draw(struct context *ctx, GLenum mode, GLsizei count)
{
    if (ctx->vertices->mode <= GL_POLYGON)
        fgl_error(ctx, GL_INVALID_OPERATION);
    else if (mode > GL_POLYGON)
        fgl_command_error(ctx, GL_INVALID_ENUM);
    else if (count < 0)
        fgl_command_error(ctx, GL_INVALID_VALUE);
    else
        return true;
    return false;
}

void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    struct context *ctx = fgl_current;
    if (!ctx || !check_draw(ctx, mode, count))
        return;
    if (first < 0) {
        fgl_command_error(ctx, GL_INVALID_VALUE);
        return;
    }
    if (count == 0)
        return;
    if (ctx->compiling) {
        compile_elements(ctx, mode, first, count, 0, NULL);
        return;
    }
    fgl_flush_all(ctx);
    struct vertex_source source;
    array_source(ctx, &source);
    const struct draw_prim prim = {mode, first, count};
    fgl_draw(ctx, &source, &prim, 1, NULL, (uint32_t)first, (uint32_t)(first + count - 1));
}

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
        array_element(ctx, source, e[i], true);
    fgl_end(ctx);
    fgl_flush_vertices(ctx, 0);
}

void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const GLvoid *indices)
{
    struct context *ctx = fgl_current;
    if (!ctx || !check_draw(ctx, mode, count))
        return;
    if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT) {
        fgl_command_error(ctx, GL_INVALID_ENUM);
        return;
    }
    if (count == 0 || !indices)
        return;
    if (ctx->compiling) {
        compile_elements(ctx, mode, 0, count, type, indices);
        return;
    }
    fgl_flush_all(ctx);
    struct vertex_source source;
    array_source(ctx, &source);
    uint32_t min, max;
    const uint32_t *e = widen(ctx->pipeline, count, type, indices, &min, &max);
    RETURN_ERROR_IF(ctx, !e, GL_OUT_OF_MEMORY);
    if (max - min > 8 * (uint32_t)count + FGL_BATCH_SIZE) {
        draw_scattered(ctx, &source, mode, count, e);
        return;
    }
    const struct draw_prim prim = {mode, 0, count};
    fgl_draw(ctx, &source, &prim, 1, e, min, max);
}
