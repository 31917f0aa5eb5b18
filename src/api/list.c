/* Display lists: their storage and names, recording, NewList and EndList. What a node holds is known to entry.c, list_vertices.c and
 * list_replay.c; list_call.c executes lists. */
#include "api/errors.h"
#include "api/list_store.h"
#include "state/share.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK_BYTES = 4096 };

/* ---- storage ---- */

static void list_destroy(void *value)
{
    struct list *list = value;
    for (struct block *b = list->first; b;) {
        struct block *next = b->next;
        free(b);
        b = next;
    }
    free(list);
}

struct list_store *fgl_list_store_create(void)
{
    struct list_store *store = calloc(1, sizeof *store);
    if (store)
        atomic_init(&store->references, 1);
    return store;
}

void fgl_list_store_retain(struct list_store *store) { atomic_fetch_add(&store->references, 1); }

void fgl_list_store_release(struct list_store *store)
{
    if (!store || atomic_fetch_sub(&store->references, 1) != 1)
        return;
    fgl_idmap_free(&store->map, list_destroy);
    free(store);
}

struct list_compiler *fgl_list_compiler(struct context *ctx)
{
    if (!ctx->list)
        ctx->list = calloc(1, sizeof *ctx->list);
    if (!ctx->list)
        fgl_error(ctx, GL_OUT_OF_MEMORY);
    return ctx->list;
}

void fgl_list_compiler_destroy(struct context *ctx)
{
    if (!ctx->list)
        return;
    if (ctx->list->list)
        list_destroy(ctx->list->list);
    fgl_immediate_destroy(ctx->list->vertices);
    free(ctx->list);
    ctx->list = NULL;
}

GLuint fgl_list_index(const struct context *ctx) { return ctx->compiling ? ctx->list->name : 0; }

/* ---- recording ---- */

static struct block *block_with_room(struct context *ctx, struct list *list, size_t bytes)
{
    struct block *b = list->last;
    if (b && b->capacity - b->used >= bytes)
        return b;
    const size_t capacity = bytes > BLOCK_BYTES ? bytes : BLOCK_BYTES;
    b = malloc(sizeof *b + capacity);
    if (!b) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return NULL;
    }
    *b = (struct block){NULL, 0, capacity};
    if (list->last)
        list->last->next = b;
    else
        list->first = b;
    list->last = b;
    return b;
}

/* Appends a node without looking at waiting vertices. */
static void *append(struct context *ctx, enum fgl_opcode op, size_t bytes)
{
    bytes = FGL_ALIGN8(bytes);
    struct block *b = block_with_room(ctx, ctx->list->list, sizeof(struct node) + bytes);
    if (!b)
        return NULL;
    struct node *node = (struct node *)(void *)((char *)b->data + b->used);
    *node = (struct node){op, (uint32_t)bytes};
    b->used += sizeof *node + bytes;
    return node + 1;
}

void *fgl_list_record(struct context *ctx, enum fgl_opcode op, size_t bytes)
{
    struct immediate *im = ctx->list->vertices;
    if (op != OP_VERTICES && (im->format.floats || im->prim_count)) {
        fgl_immediate_flush(ctx, im);
        if (im->mode == OUTSIDE_BEGIN_END)
            fgl_immediate_reset_format(im);
    }
    return append(ctx, op, bytes);
}

void fgl_list_record_attribute(struct context *ctx, enum fgl_attr attr, int size, const float *v)
{
    struct attribute_node *node = fgl_list_record(ctx, OP_ATTRIBUTE, sizeof *node);
    if (!node)
        return;
    *node = (struct attribute_node){.attr = (int32_t)attr, .size = size};
    memcpy(node->v, v, (size_t)size * sizeof(float));
}

void fgl_command_error(struct context *ctx, GLenum error)
{
    if (ctx->compiling) {
        GLenum *node = fgl_list_record(ctx, OP_ERROR, sizeof *node);
        if (node)
            *node = error;
    }
    if (ctx->compiling != GL_COMPILE)
        fgl_error(ctx, error);
}

bool fgl_refused_inside(struct context *ctx)
{
    if (ctx->begin_mode == OUTSIDE_BEGIN_END && (!ctx->compiling || ctx->vertices->mode > GL_POLYGON))
        return false;
    fgl_command_error(ctx, GL_INVALID_OPERATION);
    return true;
}

/* ---- NewList, EndList ---- */

static bool begin_list(struct context *ctx, GLuint name)
{
    struct list_compiler *c = fgl_list_compiler(ctx);
    if (!c)
        return false;
    if (!c->vertices && (c->vertices = fgl_immediate_create()) != NULL)
        c->vertices->compiling = true;
    c->list = calloc(1, sizeof *c->list);
    if (!c->list || !c->vertices) {
        free(c->list);
        c->list = NULL;
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    c->name = name;
    return true;
}

void GLAPIENTRY glNewList(GLuint list, GLenum mode)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    RETURN_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, list == 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, ctx->compiling, GL_INVALID_OPERATION);
    fgl_flush_current(ctx); /* OSMesa rule: vertices wait until the list ends; those that it executes join them */
    if (!begin_list(ctx, list))
        return;
    ctx->compiling = mode;
    ctx->vertices = ctx->list->vertices;
}

/* The list under its name, in place of the one that was there. */
static void keep(struct context *ctx, GLuint name, struct list *list)
{
    struct list *old = fgl_idmap_get(&ctx->lists->map, name);
    if (!fgl_idmap_put(&ctx->lists->map, name, list)) {
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        list_destroy(list);
    } else if (old) {
        list_destroy(old);
    }
}

void GLAPIENTRY glEndList(void)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    RETURN_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, !ctx->compiling, GL_INVALID_OPERATION);
    struct list_compiler *c = ctx->list;
    if (ctx->compiling == GL_COMPILE_AND_EXECUTE && c->vertices->mode <= GL_POLYGON)
        fgl_error(ctx, GL_INVALID_OPERATION); /* OSMesa rule: the list ends all the same */
    if (c->vertices->mode != OUTSIDE_BEGIN_END) { /* the primitive goes on after the list */
        fgl_immediate_flush(ctx, c->vertices);
        c->vertices->mode = OUTSIDE_BEGIN_END;
        c->vertices->prim_count = 0;
        fgl_immediate_reset_format(c->vertices);
    }
    fgl_list_record(ctx, OP_END_OF_LIST, 0);
    ctx->compiling = 0;
    ctx->vertices = ctx->immediate;
    fgl_flush_all(ctx);
    FGL_SHARED(ctx, keep(ctx, c->name, c->list));
    c->list = NULL;
}

/* ---- GenLists, IsList, DeleteLists, ListBase ---- */

GLuint fgl_exec_GenLists(struct context *ctx, GLsizei range)
{
    fgl_flush_vertices(ctx, 0);
    RETURN_VALUE_ERROR_IF(ctx, range < 0, GL_INVALID_VALUE, 0);
    const GLuint first = range ? fgl_idmap_find_free(&ctx->lists->map, (uint32_t)range) : 0;
    for (GLuint i = 0; first && i < (GLuint)range; i++) { /* empty lists, so that the names are taken */
        struct list *list = calloc(1, sizeof *list);
        if (!list || !fgl_idmap_put(&ctx->lists->map, first + i, list)) {
            free(list);
            fgl_exec_DeleteLists(ctx, first, (GLsizei)i);
            fgl_error(ctx, GL_OUT_OF_MEMORY);
            return 0;
        }
    }
    return first;
}

GLboolean fgl_exec_IsList(struct context *ctx, GLuint list)
{
    fgl_flush_vertices(ctx, 0);
    return fgl_idmap_get(&ctx->lists->map, list) ? GL_TRUE : GL_FALSE;
}

void fgl_exec_DeleteLists(struct context *ctx, GLuint list, GLsizei range)
{
    fgl_flush_vertices(ctx, 0);
    RETURN_ERROR_IF(ctx, range < 0, GL_INVALID_VALUE);
    fgl_idmap_remove_range(&ctx->lists->map, list, (uint32_t)range, list_destroy);
}

void fgl_exec_ListBase(struct context *ctx, GLuint base)
{
    fgl_flush_vertices(ctx, 0);
    ctx->s.list.list_base = base;
}
