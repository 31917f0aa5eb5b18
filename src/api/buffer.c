/* Buffer objects: names, data stores, queries (GL 1.5, 2.9 "Buffer Objects", 6.1.13 "Buffer Object Queries"). */
#include "api/buffer.h"

#include "api/command.h"
#include "api/errors.h"
#include "base/idmap.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

struct buffer_store {
    atomic_int references;
    struct idmap map; /* name -> struct buffer_object */
};

/* ---- references ---- */

static void release(void *value)
{
    struct buffer_object *b = value;
    if (!b || atomic_fetch_sub(&b->references, 1) != 1)
        return;
    free(b->data);
    free(b);
}

void fgl_buffer_refer(struct buffer_object **slot, struct buffer_object *b)
{
    if (b)
        atomic_fetch_add(&b->references, 1);
    release(*slot);
    *slot = b;
}

static void retain(struct buffer_object *b)
{
    if (b)
        atomic_fetch_add(&b->references, 1);
}

void fgl_buffer_retain_arrays(struct client_array_state *arrays)
{
    retain(arrays->array_buffer);
    retain(arrays->element_array_buffer);
    for (int a = 0; a < ATTR_MATERIAL; a++)
        retain(arrays->array[a].buffer);
}

void fgl_buffer_retain_pixels(struct client_state *client)
{
    retain(client->pack.buffer);
    retain(client->unpack.buffer);
}

void fgl_buffer_release_pixels(struct client_state *client)
{
    release(client->pack.buffer);
    release(client->unpack.buffer);
}

void fgl_buffer_release_arrays(struct client_array_state *arrays)
{
    release(arrays->array_buffer);
    release(arrays->element_array_buffer);
    for (int a = 0; a < ATTR_MATERIAL; a++)
        release(arrays->array[a].buffer);
}

struct buffer_store *fgl_buffer_store_create(void)
{
    struct buffer_store *store = calloc(1, sizeof *store);
    if (store)
        atomic_init(&store->references, 1);
    return store;
}

void fgl_buffer_store_retain(struct buffer_store *store) { atomic_fetch_add(&store->references, 1); }

void fgl_buffer_store_release(struct buffer_store *store)
{
    if (!store || atomic_fetch_sub(&store->references, 1) != 1)
        return;
    fgl_idmap_free(&store->map, release);
    free(store);
}

/* ---- names ---- */

/* A new object under a free name; its one reference is the name's. NULL after recording GL_OUT_OF_MEMORY. */
static struct buffer_object *add(struct context *ctx, GLuint name)
{
    struct buffer_object *b = calloc(1, sizeof *b);
    if (!b || !fgl_idmap_put(&ctx->buffers->map, name, b)) {
        free(b);
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return NULL;
    }
    atomic_init(&b->references, 1);
    b->name = name;
    b->usage = GL_STATIC_DRAW;
    b->access = GL_READ_WRITE;
    return b;
}

void fgl_exec_GenBuffers(struct context *ctx, GLsizei n, GLuint *buffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    const GLuint first = n ? fgl_idmap_find_free(&ctx->buffers->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++) {
        if (!add(ctx, first + i))
            return;
        buffers[i] = first + i;
    }
}

/* GL 1.5, 2.9: where a deleted object is bound in this context, 0 takes its place. */
static void unbind(struct client_state *client, const struct buffer_object *b)
{
    struct client_array_state *arrays = &client->arrays;
    if (client->pack.buffer == b)
        fgl_buffer_refer(&client->pack.buffer, NULL);
    if (client->unpack.buffer == b)
        fgl_buffer_refer(&client->unpack.buffer, NULL);
    if (arrays->array_buffer == b)
        fgl_buffer_refer(&arrays->array_buffer, NULL);
    if (arrays->element_array_buffer == b)
        fgl_buffer_refer(&arrays->element_array_buffer, NULL);
    for (int a = 0; a < ATTR_MATERIAL; a++)
        if (arrays->array[a].buffer == b)
            fgl_buffer_refer(&arrays->array[a].buffer, NULL);
}

void fgl_exec_DeleteBuffers(struct context *ctx, GLsizei n, const GLuint *buffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; i++) {
        struct buffer_object *b = fgl_idmap_remove(&ctx->buffers->map, buffers[i]);
        if (!b)
            continue;
        unbind(&ctx->client, b);
        fgl_buffer_unmap(b);
        release(b);
    }
}

GLboolean fgl_exec_IsBuffer(struct context *ctx, GLuint buffer)
{
    const struct buffer_object *b = fgl_idmap_get(&ctx->buffers->map, buffer);
    return b && b->created ? GL_TRUE : GL_FALSE;
}

/* The binding that a target names, or NULL after recording GL_INVALID_ENUM. */
static struct buffer_object **binding(struct context *ctx, GLenum target)
{
    switch (target) {
    case GL_ARRAY_BUFFER: return &ctx->client.arrays.array_buffer;
    case GL_ELEMENT_ARRAY_BUFFER: return &ctx->client.arrays.element_array_buffer;
    case GL_PIXEL_PACK_BUFFER: return &ctx->client.pack.buffer;
    case GL_PIXEL_UNPACK_BUFFER: return &ctx->client.unpack.buffer;
    default: fgl_error(ctx, GL_INVALID_ENUM); return NULL;
    }
}

void fgl_exec_BindBuffer(struct context *ctx, GLenum target, GLuint buffer)
{
    struct buffer_object **slot = binding(ctx, target);
    if (!slot)
        return;
    struct buffer_object *b = fgl_idmap_get(&ctx->buffers->map, buffer);
    if (!b && buffer && !(b = add(ctx, buffer)))
        return;
    if (b)
        b->created = true;
    fgl_buffer_refer(slot, b);
}

struct buffer_object *fgl_buffer_bound(struct context *ctx, GLenum target)
{
    struct buffer_object **slot = binding(ctx, target);
    if (!slot)
        return NULL;
    RETURN_VALUE_ERROR_IF(ctx, !*slot, GL_INVALID_OPERATION, NULL);
    return *slot;
}

/* ---- data ---- */

static bool is_usage(GLenum usage)
{
    switch (usage) {
    case GL_STREAM_DRAW: case GL_STREAM_READ: case GL_STREAM_COPY:
    case GL_STATIC_DRAW: case GL_STATIC_READ: case GL_STATIC_COPY:
    case GL_DYNAMIC_DRAW: case GL_DYNAMIC_READ: case GL_DYNAMIC_COPY: return true;
    default: return false;
    }
}

void fgl_exec_BufferData(struct context *ctx, GLenum target, GLsizeiptr size, const GLvoid *data, GLenum usage)
{
    struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return;
    RETURN_ERROR_IF(ctx, !is_usage(usage), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, size < 0, GL_INVALID_VALUE);
    fgl_flush_vertices(ctx, 0);
    uint8_t *store = size ? calloc(1, (size_t)size) : NULL; /* what the program leaves undefined is 0 */
    RETURN_ERROR_IF(ctx, size && !store, GL_OUT_OF_MEMORY);
    if (data && size)
        memcpy(store, data, (size_t)size);
    free(b->data);
    b->data = store;
    b->size = (size_t)size;
    b->usage = usage;
    fgl_buffer_unmap(b);
}

/* The object, if `size` bytes from offset on lie in it and may be touched; NULL after recording an error. */
static struct buffer_object *part(struct context *ctx, GLenum target, GLintptr offset, GLsizeiptr size)
{
    struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return NULL;
    RETURN_VALUE_ERROR_IF(ctx, offset < 0 || size < 0, GL_INVALID_VALUE, NULL);
    RETURN_VALUE_ERROR_IF(ctx, (size_t)offset > b->size || (size_t)size > b->size - (size_t)offset, GL_INVALID_VALUE, NULL);
    RETURN_VALUE_ERROR_IF(ctx, b->mapped, GL_INVALID_OPERATION, NULL);
    return b;
}

void fgl_exec_BufferSubData(struct context *ctx, GLenum target, GLintptr offset, GLsizeiptr size, const GLvoid *data)
{
    struct buffer_object *b = part(ctx, target, offset, size);
    if (b && size)
        memcpy(b->data + offset, data, (size_t)size);
}

void fgl_exec_GetBufferSubData(struct context *ctx, GLenum target, GLintptr offset, GLsizeiptr size, GLvoid *data)
{
    const struct buffer_object *b = part(ctx, target, offset, size);
    if (b && size)
        memcpy(data, b->data + offset, (size_t)size);
}

/* ---- queries ---- */

void fgl_exec_GetBufferParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    const struct buffer_object *b = fgl_buffer_bound(ctx, target);
    if (!b)
        return;
    switch (pname) {
    case GL_BUFFER_SIZE: *params = b->size < INT_MAX ? (GLint)b->size : INT_MAX; break;
    case GL_BUFFER_USAGE: *params = (GLint)b->usage; break;
    case GL_BUFFER_ACCESS: *params = (GLint)b->access; break;
    case GL_BUFFER_MAPPED: *params = b->mapped; break;
    case GL_BUFFER_ACCESS_FLAGS: *params = (GLint)b->access_flags; break;
    case GL_BUFFER_MAP_OFFSET: *params = (GLint)b->map_offset; break;
    case GL_BUFFER_MAP_LENGTH: *params = (GLint)b->map_length; break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}
