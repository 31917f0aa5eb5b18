/* The values of a call, and its memory. */
#include "call.h"

#include <stdint.h>
#include <string.h>

/* ---- memory that commands read: kept to the end of the script, since vertex arrays are read later ---- */

enum { ARENA = 1 << 22 };
static _Alignas(16) unsigned char arena[ARENA];
static size_t arena_used;
static unsigned char *kept;
static size_t kept_size;

void arena_clear(void)
{
    arena_used = kept_size = 0;
    memset(arena, 0, ARENA);
}

static void *arena_take(size_t bytes)
{
    bytes = (bytes + 15) & ~(size_t)15;
    if (arena_used + bytes > ARENA)
        arena_used = 0; /* a script that long only overwrites its own oldest data */
    void *memory = arena + arena_used;
    arena_used += bytes;
    return memory;
}

size_t type_size(GLenum type)
{
    switch (type) {
    case GL_BYTE: case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT: case GL_UNSIGNED_SHORT: case GL_2_BYTES: return 2;
    case GL_3_BYTES: return 3;
    case GL_DOUBLE: return 8;
    default: return 4;
    }
}

static void put(unsigned char *to, GLenum type, double value)
{
    const int64_t integer = (int64_t)value;
    const GLfloat f = (GLfloat)value;
    switch (type) {
    case GL_FLOAT: memcpy(to, &f, sizeof f); break;
    case GL_DOUBLE: memcpy(to, &value, sizeof value); break;
    case GL_2_BYTES: case GL_3_BYTES: case GL_4_BYTES: /* the most significant byte first */
        for (size_t n = type_size(type), i = 0; i < n; i++)
            to[i] = (unsigned char)(integer >> (8 * (n - 1 - i)));
        break;
    default: memcpy(to, &integer, type_size(type)); /* little-endian, as the libraries are */
    }
}

/* ---- the values of one op ---- */

double take(struct call *call)
{
    return call->next < call->op->values ? call->value[call->next++] : 0.0;
}

void *take_vector(struct call *call, GLenum type)
{
    const size_t size = type_size(type), count = (size_t)(call->op->values - call->next);
    unsigned char *memory = arena_take((count + 16) * size);
    memset(memory, 0, (count + 16) * size);
    for (size_t i = 0; i < count; i++)
        put(memory + i * size, type, take(call));
    return memory;
}

struct layout {
    int components;
    GLenum type[16];
    size_t offset[16], size;
};

static void add_components(struct layout *layout, int count, GLenum type)
{
    for (int i = 0; i < count && layout->components < 16; i++) {
        layout->type[layout->components] = type;
        layout->offset[layout->components++] = layout->size;
        layout->size += type_size(type);
    }
}

/* GL 1.5, 2.8, table 2.5: the number of texture coordinates, colors (-4: four bytes), normals, vertices. */
static void interleaved_layout(struct layout *layout, GLenum format)
{
    static const signed char counts[14][4] = {
            {0, 0, 0, 2}, {0, 0, 0, 3}, {0, -4, 0, 2}, {0, -4, 0, 3}, {0, 3, 0, 3}, {0, 0, 3, 3}, {0, 4, 3, 3},
            {2, 0, 0, 3}, {4, 0, 0, 4}, {2, -4, 0, 3}, {2, 3, 0, 3}, {2, 0, 3, 3}, {2, 4, 3, 3}, {4, 4, 3, 4}};
    const signed char *count = counts[(format - GL_V2F) % 14];
    add_components(layout, count[0], GL_FLOAT);
    add_components(layout, count[1] < 0 ? 4 : count[1], count[1] < 0 ? GL_UNSIGNED_BYTE : GL_FLOAT);
    add_components(layout, count[2] + count[3], GL_FLOAT);
}

void *take_array(struct call *call)
{
    const double *scalar = call->value;
    struct layout layout = {0};
    size_t stride = (size_t)scalar[call->next - 1];
    switch (call->op->command) {
    case CMD_NormalPointer: add_components(&layout, 3, (GLenum)scalar[0]); break;
    case CMD_EdgeFlagPointer: add_components(&layout, 1, GL_UNSIGNED_BYTE); break;
    case CMD_InterleavedArrays: interleaved_layout(&layout, (GLenum)scalar[0]); break;
    default: add_components(&layout, (int)scalar[0], (GLenum)scalar[1]);
    }
    if (stride < layout.size)
        stride = layout.size;
    const int count = layout.components ? (call->op->values - call->next) / layout.components : 0;
    unsigned char *memory = arena_take(((size_t)count + 1) * stride);
    memset(memory, 0, ((size_t)count + 1) * stride);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < layout.components; k++)
            put(memory + (size_t)i * stride + layout.offset[k], layout.type[k], take(call));
    }
    return memory;
}

void *take_room(struct call *call, size_t size)
{
    call->out_size = size;
    call->out = arena_take(size);
    memset(call->out, UNWRITTEN, size);
    return call->out;
}

void *take_out(struct call *call)
{
    enum { LARGEST_TEXTURE = 1 << 18 };
    const double *v = call->value;
    switch (call->op->command) {
    case CMD_ReadPixels: return take_room(call, v[2] > 0.0 && v[3] > 0.0 ? (size_t)(v[2] + 64.0) * (size_t)(v[3] + 8.0) * 16 : 256);
    case CMD_GetTexImage: return take_room(call, LARGEST_TEXTURE);
    case CMD_GetBufferSubData: return take_room(call, (size_t)v[2]);
    default: return take_room(call, 256);
    }
}

void *take_kept(struct call *call)
{
    kept_size = call->value[0] > 0.0 ? 4 * (size_t)call->value[0] : 0;
    kept = arena_take(kept_size);
    memset(kept, UNWRITTEN, kept_size);
    return kept;
}

void take_result(struct call *call, GLint value)
{
    call->out_size = sizeof value + kept_size;
    call->out = arena_take(call->out_size);
    memcpy(call->out, &value, sizeof value);
    if (kept_size > 0)
        memcpy(call->out + sizeof value, kept, kept_size);
}
