/* What contexts that share objects have in common: a lock. Contexts of different threads may use the same lists, textures, buffer objects and
 * renderbuffers at the same time; each command that touches any of them holds the lock from its beginning to its end, a draw until its last
 * fragment is written. A context that shares with no other takes no lock. Layer 1. */
#ifndef FGL_STATE_SHARE_H
#define FGL_STATE_SHARE_H

#include "state/context.h"

struct share_group {
    atomic_int contexts;
};

/* A group of one context; NULL: memory is short. And one more context, or fewer; the last one frees it. */
struct share_group *fgl_share_create(void);
void fgl_share_join(struct share_group *group);
void fgl_share_part(struct share_group *group);

void fgl_share_lock(struct context *ctx);
void fgl_share_unlock(struct context *ctx);

/* Around all that touches shared objects; these may be nested. What fgl_share_enter returns is for fgl_share_leave. */
static inline bool fgl_share_enter(struct context *ctx)
{
    if (FGL_LIKELY(atomic_load_explicit(&ctx->share->contexts, memory_order_relaxed) < 2))
        return false;
    fgl_share_lock(ctx);
    return true;
}

static inline void fgl_share_leave(struct context *ctx, bool entered)
{
    if (FGL_UNLIKELY(entered))
        fgl_share_unlock(ctx);
}

/* The same around one statement, which does not return. */
#define FGL_SHARED(ctx, statement)                                                                           \
    do {                                                                                                     \
        const bool entered_ = fgl_share_enter(ctx);                                                          \
        statement;                                                                                           \
        fgl_share_leave((ctx), entered_);                                                                    \
    } while (0)

#endif
