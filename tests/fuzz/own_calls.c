/* The commands whose values a script gives in another way than the library takes them. */
#include "call.h"

#include <GL/glext.h>
#include <stdint.h>
#include <string.h>

enum { MOST_DRAWS = 16 };

/* The values that are left, as the last parameter's type says; their size. */
static void *take_data(struct call *call, size_t *size)
{
    const GLenum type = (GLenum)call->value[call->next - 1];
    *size = (size_t)(call->op->values - call->next) * type_size(type);
    return take_vector(call, type);
}

void call_BufferData(struct call *call)
{
    const GLenum target = (GLenum)take(call), usage = (GLenum)take(call);
    size_t size;
    take(call);
    const void *data = take_data(call, &size);
    ((void (*)(GLenum, GLsizeiptr, const void *, GLenum))procs[CMD_BufferData])(target, (GLsizeiptr)size, data, usage);
}

void call_BufferSubData(struct call *call)
{
    const GLenum target = (GLenum)take(call);
    const GLintptr offset = (GLintptr)take(call);
    size_t size;
    take(call);
    const void *data = take_data(call, &size);
    ((void (*)(GLenum, GLintptr, GLsizeiptr, const void *))procs[CMD_BufferSubData])(target, offset, (GLsizeiptr)size, data);
}

static unsigned char *map(enum command command, GLenum target, GLenum access)
{
    return ((void *(*)(GLenum, GLenum))procs[command])(target, access);
}

static void unmap(GLenum target)
{
    ((GLboolean(*)(GLenum))procs[CMD_UnmapBuffer])(target);
}

/* Maps the buffer, writes the data into it, unmaps it. */
void call_WriteMapped(struct call *call)
{
    const GLenum target = (GLenum)take(call), access = (GLenum)take(call);
    const size_t offset = (size_t)take(call);
    size_t size;
    take(call);
    const void *data = take_data(call, &size);
    unsigned char *memory = map(CMD_WriteMapped, target, access);
    if (!memory)
        return;
    memcpy(memory + offset, data, size);
    unmap(target);
}

/* Maps the buffer; its first bytes belong to the result. */
void call_ReadMapped(struct call *call)
{
    const GLenum target = (GLenum)take(call), access = (GLenum)take(call);
    const size_t size = (size_t)take(call);
    const unsigned char *memory = map(CMD_ReadMapped, target, access);
    void *out = take_room(call, size);
    if (!memory)
        return;
    memcpy(out, memory, size);
    unmap(target);
}

/* Of pairs of a first vertex and a count. */
void call_MultiDrawArrays(struct call *call)
{
    const GLenum mode = (GLenum)take(call);
    GLint first[MOST_DRAWS];
    GLsizei count[MOST_DRAWS], n = 0;
    for (; n < MOST_DRAWS && call->next + 1 < call->op->values; n++) {
        first[n] = (GLint)take(call);
        count[n] = (GLsizei)take(call);
    }
    ((void (*)(GLenum, const GLint *, const GLsizei *, GLsizei))procs[CMD_MultiDrawArrays])(mode, first, count, n);
}

typedef void (*multi_draw_elements)(GLenum, const GLsizei *, GLenum, const void *const *, GLsizei);

/* Of each draw the number of indices and these. */
void call_MultiDrawElements(struct call *call)
{
    const GLenum mode = (GLenum)take(call), type = (GLenum)take(call);
    const int begin = call->next;
    const double *value = call->value;
    const unsigned char *data = take_vector(call, type);
    const void *indices[MOST_DRAWS];
    GLsizei count[MOST_DRAWS], n = 0;
    for (int at = begin; n < MOST_DRAWS && at < call->op->values; n++) {
        count[n] = (GLsizei)value[at];
        indices[n] = data + (size_t)(at + 1 - begin) * type_size(type);
        at += 1 + (count[n] > 0 ? count[n] : 0);
    }
    ((multi_draw_elements)procs[CMD_MultiDrawElements])(mode, count, type, indices, n);
}

/* Of pairs of an offset into the element buffer and a count. */
void call_MultiDrawElementsOffset(struct call *call)
{
    const GLenum mode = (GLenum)take(call), type = (GLenum)take(call);
    const void *indices[MOST_DRAWS];
    GLsizei count[MOST_DRAWS], n = 0;
    for (; n < MOST_DRAWS && call->next + 1 < call->op->values; n++) {
        indices[n] = (const void *)(intptr_t)take(call);
        count[n] = (GLsizei)take(call);
    }
    ((multi_draw_elements)procs[CMD_MultiDrawElementsOffset])(mode, count, type, indices, n);
}
