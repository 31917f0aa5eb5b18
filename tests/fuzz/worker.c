/* The worker processes, and the comparison of what they made. */
#include "worker.h"

#include <GL/gl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { TIMEOUT_MS = 20000, SCRIPTS_PER_PROCESS = 400, HIGHEST_INHERITED = 64 };

static struct worker {
    const char *path;
    pid_t pid; /* 0: not running */
    int to, from, scripts;
} workers[LIBRARIES];

static _Noreturn void serve(struct channel *channel, int which, int in, int out)
{
    for (int fd = 3; fd < HIGHEST_INHERITED; fd++) {
        if (fd != in && fd != out)
            close(fd); /* the other worker's, so that both see the driver end */
    }
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); /* cached code may be that of another processor */
    setenv("LP_NUM_THREADS", "0", 1);               /* the pictures are small */
    setenv("GALLIVM_PERF", "nopt", 1); /* OSMesa's code unoptimized: the same pictures, compiled in half the time */
    char byte = run_load(workers[which].path, channel->missing[which]) ? 'r' : 'x';
    while (write(out, &byte, 1) == 1 && byte == 'r' && read(in, &byte, 1) == 1) {
        run_script(&channel->script, &channel->result[which]);
        byte = 'r';
    }
    _exit(0);
}

/* True: the worker answered. False: it ended or, with *hung, did not answer in time. */
static bool await(struct worker *worker, bool *hung)
{
    struct pollfd poll_fd = {.fd = worker->from, .events = POLLIN};
    char byte = 0;
    *hung = poll(&poll_fd, 1, TIMEOUT_MS) == 0;
    return !*hung && read(worker->from, &byte, 1) == 1 && byte == 'r';
}

static void stop(struct worker *worker)
{
    if (worker->pid == 0)
        return;
    kill(worker->pid, SIGKILL);
    waitpid(worker->pid, NULL, 0);
    close(worker->to);
    close(worker->from);
    worker->pid = 0;
}

static bool start(struct channel *channel, int which)
{
    struct worker *worker = &workers[which];
    int to[2], from[2];
    if (pipe(to) != 0 || pipe(from) != 0)
        return false;
    worker->pid = fork();
    if (worker->pid == 0)
        serve(channel, which, to[0], from[1]);
    close(to[0]);
    close(from[1]);
    worker->to = to[1];
    worker->from = from[0];
    worker->scripts = 0;
    bool hung;
    return worker->pid > 0 && await(worker, &hung);
}

bool workers_start(struct channel *channel, const char *const path[LIBRARIES])
{
    signal(SIGPIPE, SIG_IGN);
    for (int i = 0; i < LIBRARIES; i++) {
        workers[i].path = path[i];
        if (!start(channel, i))
            return false;
    }
    return true;
}

void workers_stop(void)
{
    for (int i = 0; i < LIBRARIES; i++)
        stop(&workers[i]);
}

/* ---- comparison ---- */

static bool same_record(const struct channel *channel, int i)
{
    const struct result *a = &channel->result[OURS], *b = &channel->result[REFERENCE];
    const struct record *p = &a->record[i], *q = &b->record[i];
    return p->op == q->op && p->error == q->error && p->size == q->size &&
           memcmp(a->data + p->offset, b->data + q->offset, (size_t)p->size) == 0;
}

static void compare_records(const struct channel *channel, struct difference *d)
{
    const struct result *a = &channel->result[OURS], *b = &channel->result[REFERENCE];
    const int least = a->records < b->records ? a->records : b->records;
    int i = 0;
    while (i < least && same_record(channel, i))
        i++;
    if (i == a->records && i == b->records)
        return;
    const struct record *first = i < a->records ? &a->record[i] : &b->record[i];
    if (i < least && b->record[i].op < first->op)
        first = &b->record[i];
    d->record = i;
    d->op = first->op;
    d->outcome = first->error ? DIFFERS_IN_ERRORS : DIFFERS_IN_DATA;
}

static void compare_pictures(const struct channel *channel, struct difference *d)
{
    const struct result *a = &channel->result[OURS], *b = &channel->result[REFERENCE];
    const int width = channel->script.width, pixels = width * channel->script.height, size = a->pixel_bytes;
    int first = -1;
    for (int i = pixels - 1; i >= 0; i--) {
        const bool color = memcmp(a->color + size * i, b->color + size * i, (size_t)size) != 0;
        const bool depth = (a->depth[i] ^ b->depth[i]) & 0xffffff, stencil = (a->depth[i] ^ b->depth[i]) >> 24;
        d->color_pixels += color;
        d->depth_pixels += depth;
        d->stencil_pixels += stencil;
        if (color || ((depth || stencil) && d->color_pixels == 0))
            first = i;
    }
    if (first < 0)
        return;
    d->outcome = d->color_pixels ? DIFFERS_IN_COLOR : d->depth_pixels ? DIFFERS_IN_DEPTH : DIFFERS_IN_STENCIL;
    d->x = first % width;
    d->y = first / width;
}

struct difference workers_compare(struct channel *channel)
{
    struct difference d = {.outcome = IDENTICAL};
    for (int i = 0; i < LIBRARIES; i++) {
        struct worker *worker = &workers[i];
        if (worker->scripts++ >= SCRIPTS_PER_PROCESS)
            stop(worker);
        if (worker->pid == 0 && !start(channel, i)) {
            fprintf(stderr, "fuzz_diff: cannot start a worker\n");
            exit(2);
        }
        channel->result[i].op = 0;
        if (write(worker->to, "g", 1) != 1)
            stop(worker);
    }
    for (int i = LIBRARIES - 1; i >= 0; i--) {
        bool hung;
        if (!await(&workers[i], &hung)) {
            d.outcome = i == REFERENCE ? REFERENCE_FAILED : hung ? HUNG : CRASHED;
            d.op = channel->result[i].op;
            stop(&workers[i]);
        }
    }
    if (d.outcome == IDENTICAL)
        compare_pictures(channel, &d);
    if (d.outcome == IDENTICAL)
        compare_records(channel, &d);
    return d;
}

/* ---- in words ---- */

static void print_op(FILE *file, const struct channel *channel, int op)
{
    if (op < channel->script.ops)
        script_print_op(file, &channel->script, op);
    else
        fputs("the end\n", file);
}

static void print_pixel(FILE *file, const struct channel *channel, int x, int y, const char *name, int which)
{
    const int i = y * channel->script.width + x;
    const struct result *result = &channel->result[which];
    const unsigned char *c = result->color + result->pixel_bytes * i;
    fprintf(file, "  %-9s color", name);
    for (int k = 0; k < result->pixel_bytes; k++)
        fprintf(file, " %3d", c[k]);
    fprintf(file, "  depth %8u  stencil %3u\n", (unsigned)(result->depth[i] & 0xffffff), (unsigned)(result->depth[i] >> 24));
}

static void print_record(FILE *file, const struct channel *channel, int index, const char *name, int which)
{
    const struct result *result = &channel->result[which];
    fprintf(file, "  %-9s ", name);
    if (index >= result->records) {
        fputs("nothing\n", file);
        return;
    }
    const struct record *record = &result->record[index];
    if (record->error) {
        fprintf(file, "error 0x%04x at %s", record->error, record->op < channel->script.ops ? "" : "the end\n");
        if (record->op < channel->script.ops)
            script_print_op(file, &channel->script, record->op);
        return;
    }
    fprintf(file, "%d bytes:", record->size);
    for (int i = 0; i + 4 <= record->size && i < 64; i += 4) {
        int32_t integer;
        float real;
        memcpy(&integer, result->data + record->offset + i, 4);
        memcpy(&real, result->data + record->offset + i, 4);
        fprintf(file, " %08x (%g)", (unsigned)integer, (double)real);
    }
    fputc('\n', file);
}

/* The first byte at which two records of data differ. */
static void print_data_difference(FILE *file, const struct channel *channel, int index)
{
    const struct result *a = &channel->result[OURS], *b = &channel->result[REFERENCE];
    if (index >= a->records || index >= b->records)
        return;
    const struct record *p = &a->record[index], *q = &b->record[index];
    for (int i = 0; i < p->size && i < q->size; i++) {
        const int ours = a->data[p->offset + i], theirs = b->data[q->offset + i];
        if (ours != theirs) {
            fprintf(file, "  first differing byte %d: %d, reference %d\n", i, ours, theirs);
            return;
        }
    }
}

void difference_print(FILE *file, const struct channel *channel, const struct difference *d)
{
    switch (d->outcome) {
    case IDENTICAL: fputs("identical\n", file); return;
    case CRASHED: fputs("the library under test crashed in ", file); break;
    case HUNG: fputs("the library under test hung in ", file); break;
    case REFERENCE_FAILED: fputs("the reference crashed or hung in ", file); break;
    case DIFFERS_IN_DATA: fputs("other data from ", file); break;
    case DIFFERS_IN_ERRORS: fputs("other errors from ", file); break;
    default:
        fprintf(file, "%d pixels differ in color, %d in depth, %d in stencil; the first at (%d, %d):\n", d->color_pixels,
                d->depth_pixels, d->stencil_pixels, d->x, d->y);
        print_pixel(file, channel, d->x, d->y, "ours", OURS);
        print_pixel(file, channel, d->x, d->y, "reference", REFERENCE);
        return;
    }
    print_op(file, channel, d->op);
    if (d->outcome == DIFFERS_IN_DATA || d->outcome == DIFFERS_IN_ERRORS) {
        print_record(file, channel, d->record, "ours", OURS);
        print_record(file, channel, d->record, "reference", REFERENCE);
        print_data_difference(file, channel, d->record);
    }
}

/* The pixel whose color most others have in the reference: the background. */
static const unsigned char *background(const struct channel *channel)
{
    const struct result *b = &channel->result[REFERENCE];
    const int pixels = channel->script.width * channel->script.height, size = b->pixel_bytes;
    int best = 0, most = 0;
    for (int i = 0; i < pixels; i += 7) {
        int n = 0;
        for (int k = 0; k < pixels; k++)
            n += memcmp(b->color + size * i, b->color + size * k, (size_t)size) == 0;
        if (n > most) {
            most = n;
            best = i;
        }
    }
    return b->color + size * best;
}

void difference_print_map(FILE *file, const struct channel *channel)
{
    const struct result *a = &channel->result[OURS], *b = &channel->result[REFERENCE];
    const int width = channel->script.width, pixel = a->pixel_bytes;
    const size_t size = (size_t)pixel;
    const unsigned char *empty = background(channel);
    fputs("  . the background in both, # both the same, o only ours, r only the reference, x other values\n", file);
    for (int y = channel->script.height - 1; y >= 0; y--) {
        fprintf(file, "%3d ", y);
        for (int i = y * width; i < (y + 1) * width; i++) {
            const unsigned char *p = a->color + pixel * i, *q = b->color + pixel * i;
            const bool ours = memcmp(p, empty, size) != 0, theirs = memcmp(q, empty, size) != 0;
            const bool same = memcmp(p, q, size) == 0 && a->depth[i] == b->depth[i];
            fputc(same ? (ours ? '#' : '.') : ours == theirs ? 'x' : ours ? 'o' : 'r', file);
        }
        fputc('\n', file);
    }
}
