/* Mapping buffer objects (GL 1.5, 2.9.1 "Mapping and Unmapping Buffer Data"; GL_ARB_map_buffer_range). */
#include "api/buffer.h"
#include "api/command.h"
#include "api/errors.h"

enum {
    INVALIDATE = GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT,
    ALL_ACCESS = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | INVALIDATE | GL_MAP_FLUSH_EXPLICIT_BIT | GL_MAP_UNSYNCHRONIZED_BIT
};

static void *map(struct buffer_object *b, size_t offset, size_t length, GLbitfield flags, GLenum access)
{
    b->access = access;
    b->access_flags = flags;
    b->map_offset = offset;
    b->map_length = length;
    b->mapped = true;
    return b->data + offset;
}

/* OSMesa rule: an empty buffer cannot be mapped. */
GLvoid *fgl_exec_MapBuffer(struct context *ctx, GLenum target, GLenum access)
{
    RETURN_VALUE_ERROR_IF(ctx, access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE, GL_INVALID_ENUM, NULL);
    struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return NULL;
    RETURN_VALUE_ERROR_IF(ctx, b->mapped, GL_INVALID_OPERATION, NULL);
    RETURN_VALUE_ERROR_IF(ctx, !b->size, GL_INVALID_OPERATION, NULL);
    const GLbitfield flags = (access != GL_WRITE_ONLY ? GL_MAP_READ_BIT : 0u) | (access != GL_READ_ONLY ? GL_MAP_WRITE_BIT : 0u);
    return map(b, 0, b->size, flags, access);
}

static GLenum range_error(GLintptr offset, GLsizeiptr length, GLbitfield access)
{
    if (offset < 0 || length < 0)
        return GL_INVALID_VALUE;
    if (length == 0)
        return GL_INVALID_OPERATION;
    if (access & ~(GLbitfield)ALL_ACCESS)
        return GL_INVALID_VALUE;
    if (!(access & (GL_MAP_READ_BIT | GL_MAP_WRITE_BIT)))
        return GL_INVALID_OPERATION;
    if (access & GL_MAP_READ_BIT && access & (INVALIDATE | GL_MAP_UNSYNCHRONIZED_BIT))
        return GL_INVALID_OPERATION;
    return access & GL_MAP_FLUSH_EXPLICIT_BIT && !(access & GL_MAP_WRITE_BIT) ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

GLvoid *fgl_exec_MapBufferRange(struct context *ctx, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access)
{
    struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return NULL;
    const GLenum error = range_error(offset, length, access);
    RETURN_VALUE_ERROR_IF(ctx, error, error, NULL);
    RETURN_VALUE_ERROR_IF(ctx, (size_t)offset > b->size || (size_t)length > b->size - (size_t)offset, GL_INVALID_VALUE, NULL);
    RETURN_VALUE_ERROR_IF(ctx, b->mapped, GL_INVALID_OPERATION, NULL);
    const bool reads = access & GL_MAP_READ_BIT, writes = access & GL_MAP_WRITE_BIT;
    return map(b, (size_t)offset, (size_t)length, access, reads && writes ? GL_READ_WRITE : reads ? GL_READ_ONLY : GL_WRITE_ONLY);
}

/* What is written is there at once: only errors are left. */
void fgl_exec_FlushMappedBufferRange(struct context *ctx, GLenum target, GLintptr offset, GLsizeiptr length)
{
    const struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return;
    RETURN_ERROR_IF(ctx, offset < 0 || length < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, !b->mapped || !(b->access_flags & GL_MAP_FLUSH_EXPLICIT_BIT), GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, (size_t)offset > b->map_length || (size_t)length > b->map_length - (size_t)offset, GL_INVALID_VALUE);
}

void fgl_buffer_unmap(struct buffer_object *b)
{
    b->mapped = false;
    b->access = GL_READ_WRITE; /* OSMesa rule */
    b->access_flags = 0;
    b->map_offset = b->map_length = 0;
}

GLboolean fgl_exec_UnmapBuffer(struct context *ctx, GLenum target)
{
    struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return GL_FALSE;
    RETURN_VALUE_ERROR_IF(ctx, !b->mapped, GL_INVALID_OPERATION, GL_FALSE);
    fgl_buffer_unmap(b);
    return GL_TRUE;
}

void fgl_exec_GetBufferPointerv(struct context *ctx, GLenum target, GLenum pname, GLvoid **params)
{
    RETURN_ERROR_IF(ctx, pname != GL_BUFFER_MAP_POINTER, GL_INVALID_ENUM);
    const struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (b)
        *params = b->mapped ? b->data + b->map_offset : NULL;
}
