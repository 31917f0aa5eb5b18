/* Display lists (GL 1.5, 5.4 "Display Lists"): recording, storage shared between contexts, replay.
 *
 * A list is a chain of blocks of nodes; a node is an opcode and a payload. Commands of command.def record themselves (entry.c).
 * Vertices between Begin and End gather in a vertex store of the compiler's own and become one node, a ready batch, when
 * another command comes. */
#ifndef FGL_API_LIST_H
#define FGL_API_LIST_H

#include "api/command.h"
#include "api/immediate.h"

/* Appends a node to the list being compiled and returns its payload (8-byte aligned, `bytes` long), or NULL after recording
 * GL_OUT_OF_MEMORY. Vertices that wait in the compiler become a node of their own before it. */
void *fgl_list_record(struct context *ctx, enum fgl_opcode op, size_t bytes);

/* The vertices in the compiler's store, as a node; executed at once in GL_COMPILE_AND_EXECUTE. */
void fgl_list_record_vertices(struct context *ctx, struct immediate *im);
/* A current value set outside Begin/End. */
void fgl_list_record_attribute(struct context *ctx, enum fgl_attr attr, int size, const float *v);

/* Recording is off between these: what a command does in terms of other commands is not recorded in their place. */
struct list_pause {
    GLenum compiling;
    struct immediate *vertices;
};

static inline struct list_pause fgl_list_pause(struct context *ctx)
{
    const struct list_pause pause = {ctx->compiling, ctx->vertices};
    ctx->compiling = 0;
    ctx->vertices = ctx->immediate;
    return pause;
}

static inline void fgl_list_resume(struct context *ctx, struct list_pause pause)
{
    ctx->compiling = pause.compiling;
    ctx->vertices = pause.vertices;
}

/* Raises an error of a command that may be compiled: now, or, while compiling, when the list is executed. */
void fgl_command_error(struct context *ctx, GLenum error);

/* For commands that may be compiled but not stand between Begin and End (GL 1.5, 2.6.3): whether this one does, there or in the list that is
 * being compiled. Its error is then raised, as fgl_command_error does. */
bool fgl_refused_inside(struct context *ctx);

/* The generated part of replay: executes the node of a command of command.def. */
void fgl_list_replay_command(struct context *ctx, enum fgl_opcode op, void *payload);
void fgl_list_replay_vertices(struct context *ctx, void *payload);

/* The number of the list being compiled, 0 if none: GL_LIST_INDEX. */
GLuint fgl_list_index(const struct context *ctx);

struct list_store *fgl_list_store_create(void);
void fgl_list_store_retain(struct list_store *store);
void fgl_list_store_release(struct list_store *store);
/* Abandons a list that is being compiled and frees the compiler. */
void fgl_list_compiler_destroy(struct context *ctx);

#endif
