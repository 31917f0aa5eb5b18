/* The enabled vertex arrays as a source of vertices (GL 1.5, 2.8 "Vertex Arrays", 2.9.1 "Vertex Arrays in Buffer Objects"). */
#include "api/array_source.h"

#include "api/buffer.h"
#include "api/convert.h"
#include "api/immediate.h"
#include "pipeline/pipeline.h"

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

/* An array in a buffer object: only whole elements inside of it are read, the others are 0. */
static void place_in_buffer(struct attr_source *a, const struct vertex_array *v)
{
    const struct buffer_object *b = v->buffer;
    const size_t offset = (size_t)(uintptr_t)v->pointer, element = (size_t)(v->size * type_bytes(v->type));
    const bool any = offset <= b->size && element <= b->size - offset;
    const size_t count = any ? (b->size - offset - element) / (size_t)a->stride + 1 : 0;
    a->bounded = true;
    a->count = count < UINT32_MAX ? (uint32_t)count : UINT32_MAX;
    a->pointer = any ? b->data + offset : b->data;
}

void fgl_array_source(const struct context *ctx, struct vertex_source *source)
{
    source->varying = 0;
    source->compiled = false;
    source->arrays = true;
    for (int a = 0; a < ATTR_MATERIAL; a++) {
        const struct vertex_array *v = &ctx->client.arrays.array[a];
        if (!v->enabled)
            continue;
        source->varying |= 1u << a;
        source->attr[a] = (struct attr_source){.pointer = v->pointer,
                                               .type = v->type,
                                               .size = v->size,
                                               .stride = v->stride ? v->stride : v->size * type_bytes(v->type)};
        if (v->buffer)
            place_in_buffer(&source->attr[a], v);
        else if (!v->pointer) /* enabled, but never given: nothing is read, as of an empty buffer object */
            source->attr[a].bounded = true;
    }
}

uint32_t fgl_array_source_count(const struct vertex_source *source)
{
    uint32_t count = 0;
    for (int a = 0; a < ATTR_MATERIAL; a++) {
        if (!(source->varying & (1u << a)))
            continue;
        if (!source->attr[a].bounded)
            return UINT32_MAX;
        count = source->attr[a].count > count ? source->attr[a].count : count;
    }
    return count;
}

bool fgl_arrays_mapped(const struct context *ctx)
{
    for (int a = 0; a < ATTR_MATERIAL; a++) {
        const struct vertex_array *v = &ctx->client.arrays.array[a];
        if (v->enabled && v->buffer && v->buffer->mapped)
            return true;
    }
    return false;
}

/* OSMesa rule: an element that is no draw's is converted as glColor and glNormal convert. */
static void convert_as_command(const struct attr_source *a, uint32_t i, float v[4])
{
    if (a->bounded && i >= a->count)
        return;
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

void fgl_array_element(struct context *ctx, const struct vertex_source *source, uint32_t i, bool drawn)
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
