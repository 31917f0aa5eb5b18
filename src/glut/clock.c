/* Time and timers. Headless, time is virtual: it moves when the main loop says so, and for a program that waits for it, so
 * that every run sees the same times. */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <time.h>
#include <GL/glut.h>
#include "internal.h"

struct timer {
    int due; /* milliseconds on the clock */
    void (*func)(int);
    int value;
};

static struct {
    int virtual_now;
    int asked; /* times since virtual_now moved */
    struct timespec start;
    struct timer *timers; /* earliest first; of equal times the first set */
    int count, capacity;
} state;

void fgl_clock_start(void)
{
    clock_gettime(CLOCK_MONOTONIC, &state.start);
}

static void move_virtual(int now)
{
    if (now > state.virtual_now) {
        state.virtual_now = now;
        state.asked = 0;
    }
}

/* Who asks so often in one callback waits there for the time to come. */
static int ask_virtual(void)
{
    const int a_wait = 100000;
    if (++state.asked > a_wait)
        move_virtual(state.virtual_now + 1);
    return state.virtual_now;
}

int fgl_clock_now(void)
{
    if (fgl_glut.headless)
        return ask_virtual();
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int)((now.tv_sec - state.start.tv_sec) * 1000 + (now.tv_nsec - state.start.tv_nsec) / 1000000);
}

/* A timer is due a millisecond from now at the earliest: one that sets itself again cannot stop the clock. */
void glutTimerFunc(unsigned int milliseconds, void (*func)(int), int value)
{
    fgl_glut_require_init("glutTimerFunc");
    if (state.count == state.capacity) {
        int capacity = state.capacity ? 2 * state.capacity : 8;
        struct timer *timers = realloc(state.timers, (size_t)capacity * sizeof *timers);
        if (!timers)
            fgl_glut_fail(1, "no memory for a timer");
        state.timers = timers;
        state.capacity = capacity;
    }
    const int farthest = 0x3fffffff; /* twelve days */
    int delay = milliseconds > (unsigned int)farthest ? farthest : milliseconds ? (int)milliseconds : 1;
    int due = fgl_clock_now() + delay, i = state.count++;
    for (; i > 0 && state.timers[i - 1].due > due; i--)
        state.timers[i] = state.timers[i - 1];
    state.timers[i] = (struct timer){due, func, value};
}

static void run_first_timer(void)
{
    struct timer first = state.timers[0];
    state.count--;
    for (int i = 0; i < state.count; i++)
        state.timers[i] = state.timers[i + 1];
    first.func(first.value);
}

void fgl_clock_run_timers(void)
{
    int now = fgl_clock_now();
    while (state.count && state.timers[0].due <= now)
        run_first_timer();
}

void fgl_clock_advance(int ms)
{
    int end = state.virtual_now + ms;
    while (state.count && state.timers[0].due <= end) {
        move_virtual(state.timers[0].due);
        run_first_timer();
    }
    move_virtual(end);
}

int fgl_clock_next_timer(void)
{
    if (!state.count)
        return -1;
    int wait = state.timers[0].due - fgl_clock_now();
    return wait > 0 ? wait : 0;
}
