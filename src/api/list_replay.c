/* Replay of the nodes that entry.c records: the recorded arguments to the implementation (GL 1.5, 5.4). */
#include "api/errors.h"
#include "api/list.h"

#define CMD_LIST(name, ...)                                                                                  \
    case OP_##name: {                                                                                        \
        struct node_##name *node = payload;                                                                  \
        fgl_exec_##name(ctx, FGL_LIST(FGL_FROM_NODE, __VA_ARGS__));                                          \
        break;                                                                                               \
    }
/* The recorded pointer is the caller's of long ago: the vector stands behind the struct. */
#define FGL_SET_LAST(...) FGL_CAT(FGL_SET_LAST, FGL_NARGS(__VA_ARGS__))(__VA_ARGS__)
#define FGL_SET_LAST1(p) FGL_FROM_NODE p
#define FGL_SET_LAST2(p, q) FGL_FROM_NODE q
#define FGL_SET_LAST3(p, q, r) FGL_FROM_NODE r
#define CMD_LISTV(name, type, count, ...)                                                                    \
    case OP_##name: {                                                                                        \
        struct node_##name *node = payload;                                                                  \
        FGL_SET_LAST(__VA_ARGS__) = (const type *)(const void *)((char *)payload + FGL_ALIGN8(sizeof *node)); \
        fgl_exec_##name(ctx, FGL_LIST(FGL_FROM_NODE, __VA_ARGS__));                                          \
        break;                                                                                               \
    }
#define CMD_LIST0(name)                                                                                      \
    case OP_##name: fgl_exec_##name(ctx); break;
#define CMD_NOW(name, ...)
#define CMD_NOW0(name)
#define CMD_GET(ret, name, ...)
#define CMD_GET0(ret, name)
#define CMD_HAND(name)
#define CMD_ALIAS(name, ...)
#define CMD_ALIAS0(name, ...)
#define CMD_ALIAS_GET(ret, name, ...)

void fgl_list_replay_command(struct context *ctx, enum fgl_opcode op, void *payload)
{
    switch (op) {
#include "api/command.def"
    default: assert(false); break; /* every opcode without a case of its own in list_call.c has one here */
    }
}
