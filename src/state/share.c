/* The lock of contexts that share objects. See share.h. */
#define _XOPEN_SOURCE 700 /* recursive mutexes */
#include "state/share.h"

#include <pthread.h>
#include <stdlib.h>

struct group {
    struct share_group shared;
    pthread_mutex_t lock;
    const struct context *last; /* that held it */
};

static struct group *group_of(struct share_group *shared)
{
    return (struct group *)shared;
}

struct share_group *fgl_share_create(void)
{
    struct group *g = calloc(1, sizeof *g);
    pthread_mutexattr_t recursive;
    if (!g || pthread_mutexattr_init(&recursive) != 0) {
        free(g);
        return NULL;
    }
    pthread_mutexattr_settype(&recursive, PTHREAD_MUTEX_RECURSIVE);
    pthread_mutex_init(&g->lock, &recursive);
    pthread_mutexattr_destroy(&recursive);
    atomic_init(&g->shared.contexts, 1);
    return &g->shared;
}

void fgl_share_join(struct share_group *group)
{
    atomic_fetch_add(&group->contexts, 1);
}

void fgl_share_part(struct share_group *group)
{
    if (!group || atomic_fetch_sub(&group->contexts, 1) != 1)
        return;
    pthread_mutex_destroy(&group_of(group)->lock);
    free(group_of(group));
}

/* Where another context may have changed textures, all that was derived from them is derived anew. */
void fgl_share_lock(struct context *ctx)
{
    struct group *g = group_of(ctx->share);
    pthread_mutex_lock(&g->lock);
    if (g->last != ctx)
        ctx->dirty |= DIRTY_TEXTURE;
    g->last = ctx;
}

void fgl_share_unlock(struct context *ctx)
{
    pthread_mutex_unlock(&group_of(ctx->share)->lock);
}
