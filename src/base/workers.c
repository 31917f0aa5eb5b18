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

struct job {
    unsigned generation; /* jobs are numbered */
    int items;
    fgl_task *task;
    void *argument;
};

struct workers {
    int count; /* with the calling thread */
    struct worker worker[FGL_MAX_WORKERS];
    pthread_mutex_t lock;
    pthread_cond_t start, done;

    struct job job; /* written under the lock */
    bool quit;
    atomic_uint generation; /* the job's */
    atomic_ullong ticket;   /* generation << 32 | the next item that nobody has taken */
    atomic_int finished;    /* items that are done */
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

/* Works until no item of the job is left. A thread that comes late, to a job that is over, takes none: nobody has to wait for it. */
static void take_items(struct workers *w, const struct job *job, int worker)
{
    for (;;) {
        unsigned long long ticket = atomic_load(&w->ticket);
        do {
            if (ticket >> 32 != job->generation || (uint32_t)ticket >= (uint32_t)job->items)
                return;
        } while (!atomic_compare_exchange_weak(&w->ticket, &ticket, ticket + 1));
        job->task(job->argument, (int)(uint32_t)ticket, worker);
        if (atomic_fetch_add(&w->finished, 1) == job->items - 1 && worker != 0) {
            pthread_mutex_lock(&w->lock);
            pthread_cond_signal(&w->done);
            pthread_mutex_unlock(&w->lock);
        }
    }
}

/* Waits until the job is not number `seen`. Returns it. */
static struct job wait_for_job(struct workers *w, unsigned seen)
{
    for (int i = 0; i < SPINS && atomic_load_explicit(&w->generation, memory_order_acquire) == seen; i++)
        pause_cpu();
    pthread_mutex_lock(&w->lock);
    while (w->job.generation == seen)
        pthread_cond_wait(&w->start, &w->lock);
    const struct job job = w->job;
    pthread_mutex_unlock(&w->lock);
    return job;
}

static void *thread_main(void *arg)
{
    struct worker *me = arg;
    struct workers *w = me->pool;
    struct job job = {0};
    for (;;) {
        job = wait_for_job(w, job.generation);
        if (w->quit)
            return NULL;
        take_items(w, &job, me->index);
    }
}

static void publish(struct workers *w, int items, fgl_task *task, void *argument)
{
    pthread_mutex_lock(&w->lock);
    w->job = (struct job){w->job.generation + 1, items, task, argument};
    atomic_store(&w->finished, 0);
    atomic_store(&w->ticket, (unsigned long long)w->job.generation << 32);
    atomic_store(&w->generation, w->job.generation);
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
    publish(w, 0, NULL, NULL);
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
    if (w->count == 1 || items == 1) {
        for (int i = 0; i < items; i++)
            task(job, i, 0);
        return;
    }
    publish(w, items, task, job);
    take_items(w, &w->job, 0);
    for (int i = 0; i < SPINS && atomic_load_explicit(&w->finished, memory_order_acquire) < items; i++)
        pause_cpu();
    if (atomic_load(&w->finished) == items)
        return;
    pthread_mutex_lock(&w->lock);
    while (atomic_load(&w->finished) < items)
        pthread_cond_wait(&w->done, &w->lock);
    pthread_mutex_unlock(&w->lock);
}
