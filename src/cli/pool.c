/* Threads that work through one numbered list. */
#define _POSIX_C_SOURCE 200809L
#include "pool.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "support.h"

struct pool {
    pthread_mutex_t lock; /* guards next, done and the terminal */
    int count, next, done;
    bool terminal;
    void (*work)(void *context, int index, char **line);
    void *context;
};

static void show_counter(const struct pool *pool)
{
    if (pool->terminal && pool->done < pool->count)
        printf("%d of %d", pool->done, pool->count);
    fflush(stdout);
}

static void print_line(struct pool *pool, const char *line)
{
    if (pool->terminal)
        fputs("\r\033[K", stdout);
    puts(line);
    pool->done++;
    show_counter(pool);
}

static void *run(void *argument)
{
    struct pool *pool = argument;
    pthread_mutex_lock(&pool->lock);
    while (pool->next < pool->count) {
        const int index = pool->next++;
        char *line = NULL;
        pthread_mutex_unlock(&pool->lock);
        pool->work(pool->context, index, &line);
        pthread_mutex_lock(&pool->lock);
        print_line(pool, line);
        free(line);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

void fgl_pool_run(int count, int jobs, void (*work)(void *context, int index, char **line), void *context)
{
    struct pool pool = {.count = count, .terminal = isatty(STDOUT_FILENO), .work = work, .context = context};
    pthread_mutex_init(&pool.lock, NULL);
    show_counter(&pool);
    pthread_t *threads = fgl_allocate((size_t)jobs, sizeof *threads);
    int started = 0;
    while (started < jobs - 1 && pthread_create(&threads[started], NULL, run, &pool) == 0)
        started++;
    run(&pool);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    free(threads);
    pthread_mutex_destroy(&pool.lock);
}
