/*
 * Times scenes on two OSMesa libraries, side by side.
 *
 *   bench [-r ROUNDS] FIXEDGL_LIB OSMESA_LIB [TEXT...]     paths or sonames; only scenes whose name contains one of the texts
 *
 * Each library lives in a worker process of its own, which loads it with dlopen and keeps one context per scene. The driver asks the two in
 * turn, scene by scene, so that both meet the same noise of the machine, and prints the medians over the rounds, the median of the rounds'
 * ratios and, as noise only ever adds, the ratio of the least times. A frame is clear, draw and glFinish. Start-up is from fork to the first
 * finished frame of a fresh process. Nothing here passes or fails by time: the exit status is 1 only if something does not run.
 */
#define _XOPEN_SOURCE 700
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scene.h"
#include "worker.h"

enum { DEFAULT_ROUNDS = 7, MAX_ROUNDS = 1000, LIBRARIES = 2 };

static const char start_up_name[] = "start-up to the first frame";

static struct library {
    const char *label, *path;
    char renderer[MAX_RENDERER];
    int requests, answers; /* pipes to and from its worker */
    double *ms;            /* [scene * rounds + round]; the start-up follows the last scene */
} libraries[LIBRARIES] = {{.label = "FixedGL"}, {.label = "OSMesa"}};

static int rounds = DEFAULT_ROUNDS;

static void start_worker(struct library *library)
{
    int down[2], up[2];

    if (pipe(down) != 0 || pipe(up) != 0)
        fail("cannot make a pipe", NULL);
    const pid_t child = fork();
    if (child < 0)
        fail("cannot fork", NULL);
    if (child == 0) {
        close(down[1]);
        close(up[0]);
        work(library->path, down[0], up[1]);
    }
    close(down[0]);
    close(up[1]);
    library->requests = down[1];
    library->answers = up[0];
    if (read(library->answers, library->renderer, MAX_RENDERER) != MAX_RENDERER)
        fail("no picture from", library->path);
}

static double ask_worker(const struct library *library, int index)
{
    double ms = 0;
    if (write(library->requests, &index, sizeof index) != sizeof index ||
        read(library->answers, &ms, sizeof ms) != sizeof ms)
        fail(scene_at(index)->name, library->path);
    return ms;
}

/* A fresh process draws one frame of the first scene and then writes one byte to its standard output. */
static double time_start_up(const struct library *library, const char *program)
{
    int up[2];
    char byte;

    if (pipe(up) != 0)
        fail("cannot make a pipe", NULL);
    const double start = now_ms();
    const pid_t child = fork();
    if (child == 0) {
        dup2(up[1], STDOUT_FILENO);
        execlp(program, program, "--first-frame", library->path, (char *)NULL);
        _exit(1);
    }
    close(up[1]);
    if (child < 0 || read(up[0], &byte, 1) != 1)
        fail("no first frame from", library->path);
    const double elapsed = now_ms() - start;
    close(up[0]);
    waitpid(child, NULL, 0);
    return elapsed;
}

static const char *name_of(int index)
{
    return index == scene_count() ? start_up_name : scene_at(index)->name;
}

static bool is_wanted(int index, char **texts)
{
    bool wanted = *texts == NULL;
    for (; *texts && !wanted; texts++)
        wanted = strstr(name_of(index), *texts) != NULL;
    return wanted;
}

static void measure(const char *program, char **texts)
{
    const int measured = scene_count() + 1;

    for (int k = 0; k < LIBRARIES; k++)
        libraries[k].ms = allocate((size_t)measured * (size_t)rounds, sizeof(double));
    for (int round = 0; round < rounds; round++) {
        fprintf(stderr, "round %d of %d\n", round + 1, rounds);
        for (int i = 0; i < measured; i++)
            for (int k = 0; k < LIBRARIES && is_wanted(i, texts); k++) {
                struct library *library = &libraries[(round + k) % LIBRARIES];
                library->ms[i * rounds + round] =
                    i == scene_count() ? time_start_up(library, program) : ask_worker(library, i);
            }
    }
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_row(int index)
{
    double ratio[MAX_ROUNDS], *ms[LIBRARIES];

    for (int k = 0; k < LIBRARIES; k++)
        ms[k] = libraries[k].ms + index * rounds;
    for (int round = 0; round < rounds; round++)
        ratio[round] = ms[0][round] / ms[1][round];
    qsort(ratio, (size_t)rounds, sizeof ratio[0], compare_doubles);
    for (int k = 0; k < LIBRARIES; k++)
        qsort(ms[k], (size_t)rounds, sizeof ms[k][0], compare_doubles);
    printf("%-44s %9.3f %9.3f %7.2f %7.2f\n", name_of(index), ms[0][rounds / 2], ms[1][rounds / 2], ratio[rounds / 2],
           ms[0][0] / ms[1][0]);
}

static void print_table(char **texts)
{
    for (int k = 0; k < LIBRARIES; k++)
        printf("%-8s %s (%s)\n", libraries[k].label, libraries[k].path, libraries[k].renderer);
    printf("\nmilliseconds per frame, medians of %d rounds; ratios: median, and of the least times\n", rounds);
    printf("%-44s %9s %9s %7s %7s\n", "", "FixedGL", "OSMesa", "ratio", "least");
    for (int i = 0; i <= scene_count(); i++)
        if (is_wanted(i, texts))
            print_row(i);
}

int main(int argc, char **argv)
{
    char **arguments = argv + 1;

    if (argc == 3 && strcmp(argv[1], "--first-frame") == 0) {
        draw_first_frame(argv[2]);
        return write(STDOUT_FILENO, "", 1) != 1;
    }
    if (argc > 2 && strcmp(argv[1], "-r") == 0) {
        rounds = atoi(argv[2]);
        arguments += 2;
    }
    if (argv + argc - arguments < LIBRARIES || rounds < 1 || rounds > MAX_ROUNDS)
        fail("usage", "bench [-r ROUNDS] FIXEDGL_LIB OSMESA_LIB [TEXT...]");
    for (int k = 0; k < LIBRARIES; k++) {
        libraries[k].path = arguments[k];
        start_worker(&libraries[k]);
    }
    measure(argv[0], arguments + LIBRARIES);
    print_table(arguments + LIBRARIES);
    return 0;
}
