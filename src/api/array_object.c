/* Vertex array objects: names, bindings (GL_ARB_vertex_array_object). */
#include "api/array_object.h"

#include "api/buffer.h"
#include "api/command.h"
#include "api/errors.h"
#include "base/idmap.h"

#include <stdlib.h>
#include <string.h>

struct array_object {
    bool created;                             /* bound once; until then only its name is taken */
    struct vertex_array array[ATTR_MATERIAL]; /* while the object is not bound */
    struct buffer_object *element_array_buffer;
};

struct array_objects {
    struct idmap map;         /* name -> struct array_object */
    struct array_object none; /* the context's own arrays, while an object is bound */
};

/* ---- objects ---- */

static struct array_objects *objects(struct context *ctx)
{
    if (!ctx->array_objects)
        ctx->array_objects = calloc(1, sizeof *ctx->array_objects);
    if (!ctx->array_objects)
        fgl_error(ctx, GL_OUT_OF_MEMORY);
    return ctx->array_objects;
}

/* NULL for a name that is none. Name 0 is the context's own. */
static struct array_object *find(struct context *ctx, GLuint name)
{
    if (!ctx->array_objects)
        return NULL;
    return name ? fgl_idmap_get(&ctx->array_objects->map, name) : &ctx->array_objects->none;
}

static void release_content(struct array_object *o)
{
    fgl_buffer_refer(&o->element_array_buffer, NULL);
    for (int a = 0; a < ATTR_MATERIAL; a++)
        fgl_buffer_refer(&o->array[a].buffer, NULL);
}

static void destroy(void *value)
{
    release_content(value);
    free(value);
}

void fgl_array_objects_destroy(struct context *ctx)
{
    if (!ctx->array_objects)
        return;
    fgl_idmap_free(&ctx->array_objects->map, destroy);
    release_content(&ctx->array_objects->none);
    free(ctx->array_objects);
    ctx->array_objects = NULL;
}

/* Moves arrays and references between an object and the client state: one of the two has them at a time. */
static void put_away(struct client_array_state *arrays, struct array_object *o)
{
    memcpy(o->array, arrays->array, sizeof o->array);
    o->element_array_buffer = arrays->element_array_buffer;
}

static void take_out(struct client_array_state *arrays, struct array_object *o)
{
    memcpy(arrays->array, o->array, sizeof o->array);
    arrays->element_array_buffer = o->element_array_buffer;
    memset(o->array, 0, sizeof o->array);
    o->element_array_buffer = NULL;
}

static void bind(struct context *ctx, GLuint name, struct array_object *o)
{
    struct client_array_state *arrays = &ctx->client.arrays;
    struct array_object *bound = find(ctx, arrays->object);
    if (name == arrays->object || !bound) /* there is one always */
        return;
    put_away(arrays, bound);
    if (name && !o->created)
        fgl_state_init_arrays(o->array);
    o->created = true;
    take_out(arrays, o);
    arrays->object = name;
}

void fgl_array_object_restore(struct context *ctx, struct client_array_state *saved)
{
    struct client_array_state *arrays = &ctx->client.arrays;
    struct array_object *o = find(ctx, saved->object);
    if (saved->object && !o) {
        fgl_buffer_release_arrays(saved);
        return;
    }
    if (saved->object != arrays->object)
        bind(ctx, saved->object, o);
    fgl_buffer_release_arrays(arrays);
    *arrays = *saved;
}

/* ---- commands ---- */

static bool add(struct context *ctx, struct array_objects *all, GLuint name)
{
    struct array_object *o = calloc(1, sizeof *o);
    if (o && fgl_idmap_put(&all->map, name, o))
        return true;
    free(o);
    fgl_error(ctx, GL_OUT_OF_MEMORY);
    return false;
}

void fgl_exec_GenVertexArrays(struct context *ctx, GLsizei n, GLuint *arrays)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    struct array_objects *all = objects(ctx);
    const GLuint first = all && n ? fgl_idmap_find_free(&all->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++) {
        if (!add(ctx, all, first + i))
            return;
        arrays[i] = first + i;
    }
}

void fgl_exec_BindVertexArray(struct context *ctx, GLuint array)
{
    struct array_object *o = find(ctx, array);
    RETURN_ERROR_IF(ctx, array && !o, GL_INVALID_OPERATION);
    if (o)
        bind(ctx, array, o);
}

void fgl_exec_DeleteVertexArrays(struct context *ctx, GLsizei n, const GLuint *arrays)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; i++) {
        if (!arrays[i] || !find(ctx, arrays[i]))
            continue;
        if (arrays[i] == ctx->client.arrays.object)
            bind(ctx, 0, &ctx->array_objects->none);
        destroy(fgl_idmap_remove(&ctx->array_objects->map, arrays[i]));
    }
}

GLboolean fgl_exec_IsVertexArray(struct context *ctx, GLuint array)
{
    const struct array_object *o = array ? find(ctx, array) : NULL;
    return o && o->created ? GL_TRUE : GL_FALSE;
}
