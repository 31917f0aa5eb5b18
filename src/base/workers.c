#define _POSIX_C_SOURCE 200809L
#include "base/workers.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

struct worker {
    struct workers *pool;
    int index;
    pthread_t thread;
};

struct workers {
    int count; /* with the calling thread */
    struct worker worker[FGL_MAX_WORKERS];
    pthread_mutex_t lock;
    pthread_cond_t start, done;

    /* The job, written under the lock before `generation` rises. */
    fgl_task *task;
    void *job;
    int items;
    bool quit;
    atomic_int next;     /* the next item that nobody has taken */
    atomic_uint generation;
    atomic_int busy;     /* threads still at work, without the calling one */
};

enum { SPINS = 4000 }; /* some microseconds: a next job often follows at once */

static void pause_cpu(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

int fgl_workers_default(void)
{
    const char *wish = getenv("FIXEDGL_THREADS");
    const long n = wish ? strtol(wish, NULL, 10) : sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > FGL_MAX_WORKERS ? FGL_MAX_WORKERS : (int)n;
}

static void take_items(struct workers *w, int worker)
{
    for (;;) {
        const int item = atomic_fetch_add_explicit(&w->next, 1, memory_order_relaxed);
        if (item >= w->items)
            return;
        w->task(w->job, item, worker);
    }
}

/* Waits until the generation is no longer `seen`. */
static unsigned wait_for_job(struct workers *w, unsigned seen)
{
    for (int i = 0; i < SPINS; i++) {
        const unsigned g = atomic_load_explicit(&w->generation, memory_order_acquire);
        if (g != seen)
            return g;
        pause_cpu();
    }
    pthread_mutex_lock(&w->lock);
    while (atomic_load(&w->generation) == seen)
        pthread_cond_wait(&w->start, &w->lock);
    pthread_mutex_unlock(&w->lock);
    return atomic_load(&w->generation);
}

static void *thread_main(void *arg)
{
    struct worker *me = arg;
    struct workers *w = me->pool;
    unsigned seen = 0;
    for (;;) {
        seen = wait_for_job(w, seen);
        if (w->quit)
            return NULL;
        take_items(w, me->index);
        if (atomic_fetch_sub(&w->busy, 1) == 1) {
            pthread_mutex_lock(&w->lock);
            pthread_cond_signal(&w->done);
            pthread_mutex_unlock(&w->lock);
        }
    }
}

static void publish(struct workers *w)
{
    pthread_mutex_lock(&w->lock);
    atomic_store(&w->next, 0);
    atomic_store(&w->busy, w->count - 1);
    atomic_fetch_add(&w->generation, 1);
    pthread_cond_broadcast(&w->start);
    pthread_mutex_unlock(&w->lock);
}

struct workers *fgl_workers_create(int count)
{
    struct workers *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    pthread_mutex_init(&w->lock, NULL);
    pthread_cond_init(&w->start, NULL);
    pthread_cond_init(&w->done, NULL);
    sigset_t all, old;
    sigfillset(&all); /* the program's signals are not ours to take */
    pthread_sigmask(SIG_SETMASK, &all, &old);
    for (w->count = 1; w->count < count; w->count++) {
        struct worker *t = &w->worker[w->count];
        *t = (struct worker){.pool = w, .index = w->count};
        if (pthread_create(&t->thread, NULL, thread_main, t) != 0)
            break;
    }
    pthread_sigmask(SIG_SETMASK, &old, NULL);
    return w;
}

void fgl_workers_destroy(struct workers *w)
{
    if (!w)
        return;
    w->quit = true;
    publish(w);
    for (int i = 1; i < w->count; i++)
        pthread_join(w->worker[i].thread, NULL);
    pthread_cond_destroy(&w->done);
    pthread_cond_destroy(&w->start);
    pthread_mutex_destroy(&w->lock);
    free(w);
}

int fgl_workers_count(const struct workers *w) { return w->count; }

void fgl_workers_run(struct workers *w, int items, fgl_task *task, void *job)
{
    w->task = task;
    w->job = job;
    w->items = items;
    if (w->count == 1 || items == 1) {
        for (int i = 0; i < items; i++)
            task(job, i, 0);
        return;
    }
    publish(w);
    take_items(w, 0);
    for (int i = 0; i < SPINS && atomic_load_explicit(&w->busy, memory_order_acquire); i++)
        pause_cpu();
    if (atomic_load(&w->busy) == 0)
        return;
    pthread_mutex_lock(&w->lock);
    while (atomic_load(&w->busy))
        pthread_cond_wait(&w->done, &w->lock);
    pthread_mutex_unlock(&w->lock);
}
