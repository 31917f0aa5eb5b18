/* Display lists: their storage, NewList to CallLists. What a node holds is known to entry.c, list_vertices.c and list_replay.c. */
#include "api/errors.h"
#include "api/eval.h"
#include "api/eval_map.h"
#include "api/imaging.h"
#include "api/list.h"
#include "api/material.h"
#include "api/pixel_image.h"
#include "api/pixel_store.h"
#include "api/texture_image.h"
#include "base/idmap.h"
#include "state/share.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK_BYTES = 4096 };

struct node {
    uint32_t op, bytes; /* of the payload, a multiple of 8, which follows */
};

struct block {
    struct block *next;
    size_t used, capacity;
    max_align_t data[];
};

struct list {
    struct block *first, *last;
};

struct list_store {
    atomic_int references;
    struct idmap map; /* list number -> struct list */
};

struct list_compiler {
    GLuint name;
    struct list *list;
    struct immediate *vertices;
    int depth; /* of CallList */
};

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

static struct list_compiler *compiler(struct context *ctx)
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
    struct list_compiler *c = compiler(ctx);
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
    fgl_flush_all(ctx);
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
    FGL_SHARED(ctx, keep(ctx, c->name, c->list));
    c->list = NULL;
}

/* ---- executing ---- */

static void execute_node(struct context *ctx, struct node *node);

static void execute_list(struct context *ctx, GLuint name)
{
    struct list *list = fgl_idmap_get(&ctx->lists->map, name);
    struct list_compiler *c = compiler(ctx);
    if (!list || !c || c->depth >= FGL_MAX_LIST_NESTING)
        return;
    c->depth++;
    for (struct block *b = list->first; b; b = b->next) {
        for (size_t at = 0; at < b->used;) {
            struct node *node = (struct node *)(void *)((char *)b->data + at);
            execute_node(ctx, node);
            at += sizeof *node + node->bytes;
        }
    }
    c->depth--;
}

struct call_lists {
    GLsizei n;
    int32_t offset[]; /* added to the list base when executed */
};

struct attribute_node {
    int32_t attr, size;
    float v[4];
};

/* Commands that may stand between Begin and End (GL 1.5, 2.6.3), or raise their errors themselves. */
static bool is_allowed_inside(uint32_t op)
{
    switch (op) {
    case OP_END_OF_LIST: case OP_VERTICES: case OP_ATTRIBUTE: case OP_CALL_LIST: case OP_CALL_LISTS: case OP_EVAL: case OP_ERROR: return true;
    default: return false;
    }
}

static void execute_node(struct context *ctx, struct node *node)
{
    void *payload = node + 1;
    RETURN_ERROR_IF(ctx, ctx->begin_mode != OUTSIDE_BEGIN_END && !is_allowed_inside(node->op), GL_INVALID_OPERATION);
    switch (node->op) {
    case OP_END_OF_LIST: break;
    case OP_VERTICES: fgl_list_replay_vertices(ctx, payload); break;
    case OP_ATTRIBUTE: {
        const struct attribute_node *a = payload;
        if (!fgl_material_is_tracked(ctx, a->attr))
            fgl_attr_set(ctx, (enum fgl_attr)a->attr, a->size, a->v);
        break;
    }
    case OP_CALL_LIST: execute_list(ctx, *(GLuint *)payload); break;
    case OP_CALL_LISTS: {
        const struct call_lists *l = payload;
        for (GLsizei i = 0; i < l->n; i++)
            execute_list(ctx, ctx->s.list.list_base + (GLuint)l->offset[i]);
        break;
    }
    case OP_BITMAP: fgl_list_replay_bitmap(ctx, payload); break;
    case OP_DRAW_PIXELS: fgl_list_replay_draw_pixels(ctx, payload); break;
    case OP_TEXTURE_IMAGE: fgl_list_replay_texture_image(ctx, payload); break;
    case OP_IMAGING_IMAGE: fgl_list_replay_imaging(ctx, payload); break;
    case OP_HISTOGRAM: fgl_list_replay_histogram(ctx, payload); break;
    case OP_PRIORITIZE_TEXTURE: fgl_list_replay_prioritize(ctx, payload); break;
    case OP_PIXEL_MAP: fgl_list_replay_pixel_map(ctx, payload); break;
    case OP_POLYGON_STIPPLE: fgl_polygon_stipple_set(ctx, payload); break;
    case OP_MAP: fgl_map_replay(ctx, payload); break;
    case OP_EVAL: fgl_eval_replay(ctx, payload); break;
    case OP_ERROR: fgl_error(ctx, *(GLenum *)payload); break;
    default: fgl_list_replay_command(ctx, (enum fgl_opcode)node->op, payload); break;
    }
}

/* Executes lists with recording off: what a called list contains is not recorded again. */
static void execute_lists(struct context *ctx, GLsizei n, const int32_t *offset, GLuint base)
{
    const GLenum compiling = ctx->compiling;
    struct immediate *vertices = ctx->vertices;
    ctx->compiling = 0;
    ctx->vertices = ctx->immediate;
    if (ctx->begin_mode == OUTSIDE_BEGIN_END)
        fgl_flush_current(ctx);
    for (GLsizei i = 0; i < n; i++)
        execute_list(ctx, base + (GLuint)offset[i]);
    ctx->compiling = compiling;
    ctx->vertices = vertices;
}

void fgl_list_record_attribute(struct context *ctx, enum fgl_attr attr, int size, const float *v)
{
    struct attribute_node *node = fgl_list_record(ctx, OP_ATTRIBUTE, sizeof *node);
    if (!node)
        return;
    *node = (struct attribute_node){.attr = (int32_t)attr, .size = size};
    memcpy(node->v, v, (size_t)size * sizeof(float));
}

/* ---- CallList, CallLists ---- */

void GLAPIENTRY glCallList(GLuint list)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (ctx->compiling) {
        GLuint *node = fgl_list_record(ctx, OP_CALL_LIST, sizeof *node);
        if (node)
            *node = list;
        if (ctx->compiling == GL_COMPILE)
            return;
    }
    const int32_t offset = (int32_t)list;
    FGL_SHARED(ctx, execute_lists(ctx, 1, &offset, 0));
}

/* Bytes of one list number of the given type (GL 1.5, 5.4), 0 if the type is not accepted. */
static int name_bytes(GLenum type)
{
    switch (type) {
    case GL_BYTE: case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT: case GL_UNSIGNED_SHORT: case GL_2_BYTES: return 2;
    case GL_3_BYTES: return 3;
    case GL_INT: case GL_UNSIGNED_INT: case GL_FLOAT: case GL_4_BYTES: return 4;
    default: return 0;
    }
}

static int32_t read_name(GLenum type, const void *lists, GLsizei i)
{
    const uint8_t *b = (const uint8_t *)lists + (size_t)i * (size_t)name_bytes(type);
    switch (type) {
    case GL_BYTE: return ((const GLbyte *)lists)[i];
    case GL_UNSIGNED_BYTE: return b[0];
    case GL_SHORT: return ((const GLshort *)lists)[i];
    case GL_UNSIGNED_SHORT: return ((const GLushort *)lists)[i];
    case GL_FLOAT: return (int32_t)((const GLfloat *)lists)[i];
    case GL_2_BYTES: return b[0] << 8 | b[1];
    case GL_3_BYTES: return b[0] << 16 | b[1] << 8 | b[2];
    case GL_4_BYTES: return (int32_t)((uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3]);
    default: return ((const GLint *)lists)[i];
    }
}

void GLAPIENTRY glCallLists(GLsizei n, GLenum type, const GLvoid *lists)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (n < 0 || !name_bytes(type)) {
        fgl_command_error(ctx, n < 0 ? GL_INVALID_VALUE : GL_INVALID_ENUM);
        return;
    }
    const size_t bytes = sizeof(struct call_lists) + (size_t)n * sizeof(int32_t);
    const bool record = ctx->compiling;
    struct call_lists *l = record ? fgl_list_record(ctx, OP_CALL_LISTS, bytes) : malloc(bytes);
    RETURN_ERROR_IF(ctx, !l, GL_OUT_OF_MEMORY);
    l->n = n;
    for (GLsizei i = 0; i < n; i++)
        l->offset[i] = read_name(type, lists, i);
    if (ctx->compiling != GL_COMPILE)
        FGL_SHARED(ctx, execute_lists(ctx, n, l->offset, ctx->s.list.list_base));
    if (!record)
        free(l);
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
    const GLuint last = ctx->lists->map.highest; /* an enormous range ends where names end */
    for (GLuint i = 0; i < (GLuint)range && list + i >= list && list + i <= last; i++) {
        struct list *l = fgl_idmap_remove(&ctx->lists->map, list + i);
        if (l)
            list_destroy(l);
    }
}

void fgl_exec_ListBase(struct context *ctx, GLuint base)
{
    fgl_flush_vertices(ctx, 0);
    ctx->s.list.list_base = base;
}
