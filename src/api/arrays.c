/* Where vertex arrays lie (GL 1.5, 2.8 "Vertex Arrays"). Client state: never compiled into lists, and never
 * read here. */
#include "api/array_object.h"
#include "api/buffer.h"
#include "api/command.h"
#include "api/errors.h"

/* Types that an array accepts. */
enum {
    BYTE = 1 << 0,
    UBYTE = 1 << 1,
    SHORT = 1 << 2,
    USHORT = 1 << 3,
    INT = 1 << 4,
    UINT = 1 << 5,
    FLOAT = 1 << 6,
    DOUBLE = 1 << 7
};

static unsigned type_bit(GLenum type)
{
    switch (type) {
    case GL_BYTE: return BYTE;
    case GL_UNSIGNED_BYTE: return UBYTE;
    case GL_SHORT: return SHORT;
    case GL_UNSIGNED_SHORT: return USHORT;
    case GL_INT: return INT;
    case GL_UNSIGNED_INT: return UINT;
    case GL_FLOAT: return FLOAT;
    case GL_DOUBLE: return DOUBLE;
    default: return 0;
    }
}

static void place(struct context *ctx, int attr, unsigned types, GLint size, GLenum type,
                  GLsizei stride, const void *pointer)
{
    struct vertex_array *a = &ctx->client.arrays.array[attr];

    RETURN_ERROR_IF(ctx, stride < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, !(types & type_bit(type)), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, fgl_array_object_refuses(ctx, pointer), GL_INVALID_OPERATION);
    a->size = size;
    a->type = type;
    a->stride = stride;
    a->count = 0;
    a->pointer = pointer;
    fgl_buffer_refer(&a->buffer, ctx->client.arrays.array_buffer);
}

void fgl_exec_VertexPointer(struct context *ctx, GLint size, GLenum type, GLsizei stride,
                            const GLvoid *pointer)
{
    RETURN_ERROR_IF(ctx, size < 2 || size > 4, GL_INVALID_VALUE);
    place(ctx, ATTR_POSITION, SHORT | INT | FLOAT | DOUBLE, size, type, stride, pointer);
}

void fgl_exec_NormalPointer(struct context *ctx, GLenum type, GLsizei stride, const GLvoid *pointer)
{
    place(ctx, ATTR_NORMAL, BYTE | SHORT | INT | FLOAT | DOUBLE, 3, type, stride, pointer);
}

void fgl_exec_ColorPointer(struct context *ctx, GLint size, GLenum type, GLsizei stride,
                           const GLvoid *pointer)
{
    RETURN_ERROR_IF(ctx, size < 3 || size > 4, GL_INVALID_VALUE);
    place(ctx, ATTR_COLOR, BYTE | UBYTE | SHORT | USHORT | INT | UINT | FLOAT | DOUBLE, size, type, stride,
          pointer);
}

void fgl_exec_IndexPointer(struct context *ctx, GLenum type, GLsizei stride, const GLvoid *pointer)
{
    place(ctx, ATTR_INDEX, UBYTE | SHORT | INT | FLOAT | DOUBLE, 1, type, stride, pointer);
}

void fgl_exec_TexCoordPointer(struct context *ctx, GLint size, GLenum type, GLsizei stride,
                              const GLvoid *pointer)
{
    RETURN_ERROR_IF(ctx, size < 1 || size > 4, GL_INVALID_VALUE);
    place(ctx, ATTR_TEX0 + ctx->client.arrays.client_active_texture, SHORT | INT | FLOAT | DOUBLE, size, type,
          stride, pointer);
}

void fgl_exec_EdgeFlagPointer(struct context *ctx, GLsizei stride, const GLvoid *pointer)
{
    place(ctx, ATTR_EDGE_FLAG, UBYTE, 1, GL_UNSIGNED_BYTE, stride, pointer);
}

void fgl_exec_FogCoordPointer(struct context *ctx, GLenum type, GLsizei stride, const GLvoid *pointer)
{
    place(ctx, ATTR_FOG_COORD, FLOAT | DOUBLE, 1, type, stride, pointer);
}

void fgl_exec_SecondaryColorPointer(struct context *ctx, GLint size, GLenum type, GLsizei stride,
                                    const GLvoid *pointer)
{
    RETURN_ERROR_IF(ctx, size != 3, GL_INVALID_VALUE);
    place(ctx, ATTR_SECONDARY_COLOR, BYTE | UBYTE | SHORT | USHORT | INT | UINT | FLOAT | DOUBLE, size, type, stride,
          pointer);
}

/* ---- GL_EXT_vertex_array: the same with the number of elements, which is only kept ---- */

#define PLACE_EXT(ctx, count, attr, call)                                                                    \
    do {                                                                                                     \
        RETURN_ERROR_IF(ctx, (count) < 0, GL_INVALID_VALUE);                                                 \
        call;                                                                                                \
        (ctx)->client.arrays.array[attr].count = (count);                                                    \
    } while (0)

void fgl_exec_VertexPointerEXT(struct context *ctx, GLint size, GLenum type, GLsizei stride, GLsizei count,
                               const GLvoid *pointer)
{
    PLACE_EXT(ctx, count, ATTR_POSITION, fgl_exec_VertexPointer(ctx, size, type, stride, pointer));
}

void fgl_exec_NormalPointerEXT(struct context *ctx, GLenum type, GLsizei stride, GLsizei count, const GLvoid *pointer)
{
    PLACE_EXT(ctx, count, ATTR_NORMAL, fgl_exec_NormalPointer(ctx, type, stride, pointer));
}

void fgl_exec_ColorPointerEXT(struct context *ctx, GLint size, GLenum type, GLsizei stride, GLsizei count,
                              const GLvoid *pointer)
{
    PLACE_EXT(ctx, count, ATTR_COLOR, fgl_exec_ColorPointer(ctx, size, type, stride, pointer));
}

void fgl_exec_IndexPointerEXT(struct context *ctx, GLenum type, GLsizei stride, GLsizei count, const GLvoid *pointer)
{
    PLACE_EXT(ctx, count, ATTR_INDEX, fgl_exec_IndexPointer(ctx, type, stride, pointer));
}

void fgl_exec_TexCoordPointerEXT(struct context *ctx, GLint size, GLenum type, GLsizei stride, GLsizei count,
                                 const GLvoid *pointer)
{
    PLACE_EXT(ctx, count, ATTR_TEX0 + ctx->client.arrays.client_active_texture,
              fgl_exec_TexCoordPointer(ctx, size, type, stride, pointer));
}

void fgl_exec_EdgeFlagPointerEXT(struct context *ctx, GLsizei stride, GLsizei count, const GLboolean *pointer)
{
    PLACE_EXT(ctx, count, ATTR_EDGE_FLAG, fgl_exec_EdgeFlagPointer(ctx, stride, pointer));
}

/* ---- enabling ---- */

static struct vertex_array *find_array(struct context *ctx, GLenum array)
{
    switch (array) {
    case GL_VERTEX_ARRAY: return &ctx->client.arrays.array[ATTR_POSITION];
    case GL_NORMAL_ARRAY: return &ctx->client.arrays.array[ATTR_NORMAL];
    case GL_COLOR_ARRAY: return &ctx->client.arrays.array[ATTR_COLOR];
    case GL_INDEX_ARRAY: return &ctx->client.arrays.array[ATTR_INDEX];
    case GL_TEXTURE_COORD_ARRAY:
        return &ctx->client.arrays.array[ATTR_TEX0 + ctx->client.arrays.client_active_texture];
    case GL_FOG_COORDINATE_ARRAY: return &ctx->client.arrays.array[ATTR_FOG_COORD];
    case GL_SECONDARY_COLOR_ARRAY: return &ctx->client.arrays.array[ATTR_SECONDARY_COLOR];
    case GL_EDGE_FLAG_ARRAY: return &ctx->client.arrays.array[ATTR_EDGE_FLAG];
    default: return NULL;
    }
}

static void enable(struct context *ctx, GLenum array, bool on)
{
    struct vertex_array *a = find_array(ctx, array);
    RETURN_ERROR_IF(ctx, !a, GL_INVALID_ENUM);
    a->enabled = on;
}

void fgl_exec_EnableClientState(struct context *ctx, GLenum array)
{
    enable(ctx, array, true);
}
void fgl_exec_DisableClientState(struct context *ctx, GLenum array)
{
    enable(ctx, array, false);
}

/* GL_EXT_compiled_vertex_array: a promise, which changes nothing here. */
void fgl_exec_LockArraysEXT(struct context *ctx, GLint first, GLsizei count)
{
    RETURN_ERROR_IF(ctx, first < 0 || count <= 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, ctx->client.arrays.lock_count, GL_INVALID_OPERATION);
    ctx->client.arrays.lock_first = first;
    ctx->client.arrays.lock_count = count;
}

void fgl_exec_UnlockArraysEXT(struct context *ctx)
{
    RETURN_ERROR_IF(ctx, !ctx->client.arrays.lock_count, GL_INVALID_OPERATION);
    ctx->client.arrays.lock_first = ctx->client.arrays.lock_count = 0;
}

/* GL 1.5, table 2.5 "Variables that direct the execution of InterleavedArrays": components (0: array
 * disabled) and offsets. */
struct interleaved {
    GLenum format;
    int8_t texcoord, color, normal, vertex;
    bool color_ubyte;
    int8_t color_at, normal_at, vertex_at; /* bytes */
    int8_t stride;
};

static const struct interleaved interleaved[] = {
        {GL_V2F, 0, 0, 0, 2, false, 0, 0, 0, 8},
        {GL_V3F, 0, 0, 0, 3, false, 0, 0, 0, 12},
        {GL_C4UB_V2F, 0, 4, 0, 2, true, 0, 0, 4, 12},
        {GL_C4UB_V3F, 0, 4, 0, 3, true, 0, 0, 4, 16},
        {GL_C3F_V3F, 0, 3, 0, 3, false, 0, 0, 12, 24},
        {GL_N3F_V3F, 0, 0, 3, 3, false, 0, 0, 12, 24},
        {GL_C4F_N3F_V3F, 0, 4, 3, 3, false, 0, 16, 28, 40},
        {GL_T2F_V3F, 2, 0, 0, 3, false, 0, 0, 8, 20},
        {GL_T4F_V4F, 4, 0, 0, 4, false, 0, 0, 16, 32},
        {GL_T2F_C4UB_V3F, 2, 4, 0, 3, true, 8, 0, 12, 24},
        {GL_T2F_C3F_V3F, 2, 3, 0, 3, false, 8, 0, 20, 32},
        {GL_T2F_N3F_V3F, 2, 0, 3, 3, false, 0, 8, 20, 32},
        {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3, false, 8, 24, 36, 48},
        {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4, false, 16, 32, 44, 60},
};

static void interleave(struct context *ctx, GLenum array, int size, GLenum type, GLsizei stride,
                       const void *pointer)
{
    struct vertex_array *a = find_array(ctx, array);

    a->enabled = size != 0;
    if (!size)
        return;
    a->size = size;
    a->type = type;
    a->stride = stride;
    a->pointer = pointer;
    fgl_buffer_refer(&a->buffer, ctx->client.arrays.array_buffer);
}

void fgl_exec_InterleavedArrays(struct context *ctx, GLenum format, GLsizei stride, const GLvoid *pointer)
{
    const struct interleaved *f = NULL;
    for (size_t i = 0; i < FGL_COUNTOF(interleaved); i++) {
        if (interleaved[i].format == format)
            f = &interleaved[i];
    }
    RETURN_ERROR_IF(ctx, !f, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, stride < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, fgl_array_object_refuses(ctx, pointer), GL_INVALID_OPERATION);

    const uintptr_t p = (uintptr_t)pointer;
    const GLenum color_type = f->color_ubyte ? GL_UNSIGNED_BYTE : GL_FLOAT;
    if (stride == 0)
        stride = f->stride;
    enable(ctx, GL_EDGE_FLAG_ARRAY, false);
    enable(ctx, GL_INDEX_ARRAY, false);
    interleave(ctx, GL_TEXTURE_COORD_ARRAY, f->texcoord, GL_FLOAT, stride, pointer);
    interleave(ctx, GL_COLOR_ARRAY, f->color, color_type, stride, (const void *)(p + (uintptr_t)f->color_at));
    interleave(ctx, GL_NORMAL_ARRAY, f->normal, GL_FLOAT, stride,
               (const void *)(p + (uintptr_t)f->normal_at));
    interleave(ctx, GL_VERTEX_ARRAY, f->vertex, GL_FLOAT, stride,
               (const void *)(p + (uintptr_t)f->vertex_at));
}
