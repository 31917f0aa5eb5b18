/* A few threads that share the items of one job: fork, join, nothing else. Layer 0.
 *
 * The calling thread works too, as worker 0. Which worker takes which item is left to chance, so items must be independent
 * of each other, and of the worker but for scratch space: the result is then the same for every number of threads. */
#ifndef FGL_BASE_WORKERS_H
#define FGL_BASE_WORKERS_H

#include "base/fgl.h"

enum { FGL_MAX_WORKERS = 16 };

typedef void fgl_task(void *job, int item, int worker);

struct workers;

/* The number of workers to use: FIXEDGL_THREADS, or the processors of the machine; 1..FGL_MAX_WORKERS. */
int fgl_workers_default(void);

/* Starts count - 1 threads, fewer where the system refuses. NULL when memory is short. */
struct workers *fgl_workers_create(int count);
void fgl_workers_destroy(struct workers *w); /* NULL is allowed */
int fgl_workers_count(const struct workers *w);

/* Runs task(job, i, worker) once for each i in 0..items-1 and returns when all are done. */
void fgl_workers_run(struct workers *w, int items, fgl_task *task, void *job);

#endif
