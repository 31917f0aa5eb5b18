/* Executing display lists: CallList and CallLists (GL 1.5, 5.4). */
#include "api/errors.h"
#include "api/eval.h"
#include "api/eval_map.h"
#include "api/imaging.h"
#include "api/list_store.h"
#include "api/material.h"
#include "api/pixel_image.h"
#include "api/pixel_store.h"
#include "api/texture_image.h"
#include "state/share.h"

#include <stdlib.h>

static void execute_node(struct context *ctx, struct node *node);

static void execute_list(struct context *ctx, GLuint name)
{
    struct list *list = fgl_idmap_get(&ctx->lists->map, name);
    struct list_compiler *c = fgl_list_compiler(ctx);
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
