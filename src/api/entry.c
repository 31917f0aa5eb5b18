/* The public entry points that are alike, made from command.def: find the context, reject use inside Begin/End (GL 1.5, 2.6.3),
 * record into the display list that is being compiled (5.4), call the implementation.
 * Without a current context a command does nothing. */
#include "api/command.h"
#include "api/errors.h"
#include "api/list.h"
#include "state/share.h"

#include <string.h>

#define INSIDE(ctx) FGL_UNLIKELY((ctx)->begin_mode != OUTSIDE_BEGIN_END)

/* Of the commands that may be compiled. */
#define RETURN_IF_REFUSED(ctx)                                                                               \
    do {                                                                                                     \
        if (FGL_UNLIKELY(INSIDE(ctx) || (ctx)->compiling) && fgl_refused_inside(ctx))                        \
            return;                                                                                          \
    } while (0)

#define CMD_LIST(name, ...)                                                                                  \
    void GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                               \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return;                                                                                          \
        RETURN_IF_REFUSED(ctx);                                                                              \
        if (FGL_UNLIKELY(ctx->compiling)) {                                                                  \
            struct node_##name *node = fgl_list_record(ctx, OP_##name, sizeof *node);                        \
            if (node)                                                                                        \
                *node = (struct node_##name){FGL_LIST(FGL_NAME, __VA_ARGS__)};                               \
            if (ctx->compiling == GL_COMPILE)                                                                \
                return;                                                                                      \
        }                                                                                                    \
        FGL_SHARED(ctx, fgl_exec_##name(ctx, FGL_LIST(FGL_NAME, __VA_ARGS__)));                              \
    }

#define FGL_LAST_NAME(...) FGL_CAT(FGL_LAST, FGL_NARGS(__VA_ARGS__))(__VA_ARGS__)
#define FGL_LAST1(p) FGL_NAME p
#define FGL_LAST2(p, q) FGL_NAME q
#define FGL_LAST3(p, q, r) FGL_NAME r
#define FGL_LAST4(p, q, r, s) FGL_NAME s

#define CMD_LISTV(name, type, count, ...)                                                                    \
    void GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                               \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return;                                                                                          \
        RETURN_IF_REFUSED(ctx);                                                                              \
        if (FGL_UNLIKELY(ctx->compiling)) {                                                                  \
            const size_t head = FGL_ALIGN8(sizeof(struct node_##name));                                      \
            const size_t bytes = (size_t)(count) * sizeof(type);                                             \
            struct node_##name *node = fgl_list_record(ctx, OP_##name, head + bytes);                        \
            if (node) {                                                                                      \
                *node = (struct node_##name){FGL_LIST(FGL_NAME, __VA_ARGS__)};                               \
                if (bytes)                                                                                   \
                    memcpy((char *)node + head, FGL_LAST_NAME(__VA_ARGS__), bytes);                          \
            }                                                                                                \
            if (ctx->compiling == GL_COMPILE)                                                                \
                return;                                                                                      \
        }                                                                                                    \
        FGL_SHARED(ctx, fgl_exec_##name(ctx, FGL_LIST(FGL_NAME, __VA_ARGS__)));                              \
    }

#define CMD_LIST0(name)                                                                                      \
    void GLAPIENTRY gl##name(void)                                                                           \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return;                                                                                          \
        RETURN_IF_REFUSED(ctx);                                                                              \
        if (FGL_UNLIKELY(ctx->compiling)) {                                                                  \
            fgl_list_record(ctx, OP_##name, 0);                                                              \
            if (ctx->compiling == GL_COMPILE)                                                                \
                return;                                                                                      \
        }                                                                                                    \
        FGL_SHARED(ctx, fgl_exec_##name(ctx));                                                               \
    }

#define CMD_NOW(name, ...)                                                                                   \
    void GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                               \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return;                                                                                          \
        RETURN_ERROR_IF(ctx, INSIDE(ctx), GL_INVALID_OPERATION);                                             \
        FGL_SHARED(ctx, fgl_exec_##name(ctx, FGL_LIST(FGL_NAME, __VA_ARGS__)));                              \
    }

#define CMD_NOW0(name)                                                                                       \
    void GLAPIENTRY gl##name(void)                                                                           \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return;                                                                                          \
        RETURN_ERROR_IF(ctx, INSIDE(ctx), GL_INVALID_OPERATION);                                             \
        FGL_SHARED(ctx, fgl_exec_##name(ctx));                                                               \
    }

#define CMD_GET(ret, name, ...)                                                                              \
    ret GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                                \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return 0;                                                                                        \
        RETURN_VALUE_ERROR_IF(ctx, INSIDE(ctx), GL_INVALID_OPERATION, 0);                                    \
        const bool entered = fgl_share_enter(ctx);                                                           \
        ret const result = fgl_exec_##name(ctx, FGL_LIST(FGL_NAME, __VA_ARGS__));                            \
        fgl_share_leave(ctx, entered);                                                                       \
        return result;                                                                                       \
    }

#define CMD_GET0(ret, name)                                                                                  \
    ret GLAPIENTRY gl##name(void)                                                                            \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (!ctx)                                                                                            \
            return 0;                                                                                        \
        RETURN_VALUE_ERROR_IF(ctx, INSIDE(ctx), GL_INVALID_OPERATION, 0);                                    \
        const bool entered = fgl_share_enter(ctx);                                                           \
        ret const result = fgl_exec_##name(ctx);                                                             \
        fgl_share_leave(ctx, entered);                                                                       \
        return result;                                                                                       \
    }

#define CMD_ALIAS(name, old, ...)                                                                            \
    void GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                               \
    {                                                                                                        \
        gl##old(FGL_LIST(FGL_NAME, __VA_ARGS__));                                                            \
    }

#define CMD_ALIAS0(name, old)                                                                                \
    void GLAPIENTRY gl##name(void)                                                                           \
    {                                                                                                        \
        gl##old();                                                                                           \
    }

#define CMD_ALIAS_GET(ret, name, old, ...)                                                                   \
    ret GLAPIENTRY gl##name(FGL_LIST(FGL_PARAM, __VA_ARGS__))                                                \
    {                                                                                                        \
        return gl##old(FGL_LIST(FGL_NAME, __VA_ARGS__));                                                     \
    }

#define CMD_HAND(name)

#include "api/command.def"
