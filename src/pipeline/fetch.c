/* Fetching: the arrays that a draw names, as the floats of a batch (GL 1.5, 2.8 "Vertex Arrays"; conversions of table 2.9).
 * OSMesa rule: they are multiplied by the reciprocal of the type's largest value, where glColor divides. */
#include "pipeline/pipeline.h"

#include <string.h>

/* Attributes whose integers are fractions of the type's range. */
static bool is_normalized(int attr)
{
    return attr == ATTR_COLOR || attr == ATTR_SECONDARY_COLOR || attr == ATTR_NORMAL;
}

static inline float snorm(float v, double max)
{
    const float f = v * (float)(1.0 / max);
    return f < -1.0f ? -1.0f : f;
}

/* The upper 23 bits of 32 alone. */
static inline float unorm32(GLuint v)
{
    return (float)(v >> 9) * 0x1p-23f * (float)(8388608.0 / 8388607.0);
}

#define FETCH(name, T, normalized, plain)                                                                    \
    static void fetch_##name(float *FGL_RESTRICT to, const char *from, ptrdiff_t stride, int n, bool norm)   \
    {                                                                                                        \
        for (int i = 0; i < n; i++) {                                                                        \
            T v;                                                                                             \
            memcpy(&v, from + i * stride, sizeof v);                                                         \
            to[i] = norm ? (normalized) : (plain);                                                           \
        }                                                                                                    \
    }
FETCH(ubyte, GLubyte, (float)v * (1.0f / 255.0f), (float)v)
FETCH(byte, GLbyte, snorm((float)v, 127.0), (float)v)
FETCH(ushort, GLushort, (float)v * (1.0f / 65535.0f), (float)v)
FETCH(short, GLshort, snorm((float)v, 32767.0), (float)v)
FETCH(uint, GLuint, unorm32(v), (float)v)
FETCH(int, GLint, snorm((float)v, 2147483647.0), (float)v)
FETCH(double, GLdouble, (float)v, (float)v)
FETCH(float, GLfloat, v, v)

static int component_bytes(GLenum type)
{
    switch (type) {
    case GL_BYTE: case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT: case GL_UNSIGNED_SHORT: return 2;
    case GL_DOUBLE: return 8;
    default: return 4;
    }
}

static void fetch_component(float *to, const char *from, const struct attr_source *a, int n, bool norm)
{
    switch (a->type) {
    case GL_FLOAT: fetch_float(to, from, a->stride, n, norm); break;
    case GL_DOUBLE: fetch_double(to, from, a->stride, n, norm); break;
    case GL_UNSIGNED_BYTE: fetch_ubyte(to, from, a->stride, n, norm); break;
    case GL_BYTE: fetch_byte(to, from, a->stride, n, norm); break;
    case GL_UNSIGNED_SHORT: fetch_ushort(to, from, a->stride, n, norm); break;
    case GL_SHORT: fetch_short(to, from, a->stride, n, norm); break;
    case GL_UNSIGNED_INT: fetch_uint(to, from, a->stride, n, norm); break;
    default: fetch_int(to, from, a->stride, n, norm); break;
    }
}

void fgl_fetch_one(const struct attr_source *a, int attr, uint32_t i, float v[4])
{
    const char *from = (const char *)a->pointer + (size_t)i * (size_t)a->stride;
    const int size = a->bounded && i >= a->count ? 0 : a->size;
    for (int c = 0; c < 4; c++) {
        v[c] = c == 3 && a->size < 4 ? 1.0f : 0.0f;
        if (c < size)
            fetch_component(&v[c], from + c * component_bytes(a->type), a, 1, is_normalized(attr));
    }
}

/* Elements 0 .. n of one array from `from` on, and defaults for components that it has not. */
static void fetch_attr(struct lanes4 *in, const char *from, const struct attr_source *a, int n, bool norm)
{
    if (a->type == GL_FLOAT)
        fgl_clip_kernels(ARITH_COMPATIBLE)->fetch_floats(in, from, a->stride, n, a->size);
    for (int c = a->type == GL_FLOAT ? a->size : 0; c < 4; c++) {
        float *to = in->c[c];
        if (c < a->size)
            fetch_component(to, from + c * component_bytes(a->type), a, n, norm);
        else
            for (int i = 0; i < n; i++)
                to[i] = c == 3 ? 1.0f : 0.0f;
    }
}

/* Elements present .. n, which lie beyond their buffer object's end: 0. */
static void clear_attr(struct lanes4 *in, const struct attr_source *a, int present, int n)
{
    for (int c = 0; c < 4; c++)
        for (int i = present; i < n; i++)
            in->c[c][i] = c >= a->size && c == 3 ? 1.0f : 0.0f;
}

void fgl_fetch(struct vertex_batch *batch, const struct vertex_source *source, uint32_t attributes, uint32_t first, int n)
{
    batch->n = n;
    batch->varying = source->varying & attributes;
    for (int attr = 0; attr < ATTR_COUNT; attr++) {
        if (!(batch->varying & (1u << attr)))
            continue;
        const struct attr_source *a = &source->attr[attr];
        const uint32_t left = a->count > first ? a->count - first : 0;
        const int present = !a->bounded || left >= (uint32_t)n ? n : (int)left;
        if (present)
            fetch_attr(&batch->in[attr], (const char *)a->pointer + (size_t)first * (size_t)a->stride, a, present,
                       is_normalized(attr));
        if (present < n)
            clear_attr(&batch->in[attr], a, present, n);
    }
}
