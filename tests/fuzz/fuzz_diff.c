/*
 * Draws random command streams with two OSMesa libraries and compares every byte: color, depth, stencil, errors, and
 * what queries and glReadPixels return.
 *
 *   fuzz_diff [option...] LIBRARY_UNDER_TEST REFERENCE_LIBRARY      paths or sonames
 *
 *   --seed N           of the first frame (1); frame i has seed N + i
 *   --count N          frames (1000)
 *   --seconds N        stop after so much time, whatever the count
 *   --only a,b,...     of the features only these (and Begin, End, colors, views); --list prints all
 *   --without a,b,...  all but these; "objects" are all that features.def has from buffer objects on
 *   --show N           differing frames that are shortened and printed (10)
 *   --tries N          runs that may be spent on shortening one frame (400)
 *   --save DIR         writes the shortened scripts to DIR/seed-N.txt
 *   --script FILE      runs the script in FILE instead
 *   --shorten          and shortens it
 *   --map              prints where the frames differ, too
 *   --print            prints the scripts and runs nothing
 *
 * A frame is a script of GL calls made from its seed (generator.h). The exit status is 1 if a frame differs or the
 * library under test crashes or hangs, 2 if nothing could be run.
 */
#include "generator.h"
#include "minimize.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

static struct options {
    unsigned long seed, count;
    double seconds;
    int show, tries;
    const char *save, *script, *path[LIBRARIES];
    bool enabled[FEATURES], print, map, shorten;
} options = {.seed = 1, .count = 1000, .seconds = 1e9, .show = 10, .tries = 400};

static struct tally {
    unsigned long frames, differing, reference_failed, of[FEATURES], differing_of[FEATURES];
} tally;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static _Noreturn void fail(const char *what, const char *detail)
{
    fprintf(stderr, "fuzz_diff: %s%s%s\n", what, detail ? " " : "", detail ? detail : "");
    exit(2);
}

/* ---- options ---- */

static void set_features(const char *list, bool value)
{
    while (*list) {
        const size_t length = strcspn(list, ",");
        int i = 0;
        while (i < FEATURES && (strlen(features[i].name) != length || strncmp(features[i].name, list, length)))
            i++;
        if (length == strlen("objects") && strncmp(list, "objects", length) == 0) {
            for (i = FEATURE_buffer_object; i < FEATURES; i++)
                options.enabled[i] = value;
            i = FEATURE_buffer_object;
        }
        if (i == FEATURES)
            fail("unknown feature in", list);
        options.enabled[i] = value;
        list += length + (list[length] == ',');
    }
}

static void only_features(const char *list)
{
    for (int i = 0; i < FEATURES; i++)
        options.enabled[i] = i == FEATURE_view || i == FEATURE_immediate || i == FEATURE_color_inside;
    set_features(list, true);
}

static void list_features(void)
{
    static const char *const kinds[] = {"state", "draw", "query", "inside"};
    for (int i = 0; i < FEATURES; i++)
        printf("%-20s %s\n", features[i].name, kinds[features[i].kind]);
}

static void read_option(const char *name, const char *value)
{
    if (!value)
        fail("no value after", name);
    if (strcmp(name, "--seed") == 0)
        options.seed = strtoul(value, NULL, 0);
    else if (strcmp(name, "--count") == 0)
        options.count = strtoul(value, NULL, 0);
    else if (strcmp(name, "--seconds") == 0)
        options.seconds = strtod(value, NULL);
    else if (strcmp(name, "--show") == 0)
        options.show = atoi(value);
    else if (strcmp(name, "--tries") == 0)
        options.tries = atoi(value);
    else if (strcmp(name, "--save") == 0)
        options.save = value;
    else if (strcmp(name, "--script") == 0)
        options.script = value;
    else if (strcmp(name, "--only") == 0)
        only_features(value);
    else if (strcmp(name, "--without") == 0)
        set_features(value, false);
    else
        fail("unknown option", name);
}

static void read_options(int argc, char **argv)
{
    int paths = 0;
    for (int i = 0; i < FEATURES; i++)
        options.enabled[i] = true;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--list") == 0) {
            list_features();
            exit(0);
        } else if (strcmp(argv[i], "--print") == 0) {
            options.print = true;
        } else if (strcmp(argv[i], "--map") == 0) {
            options.map = true;
        } else if (strcmp(argv[i], "--shorten") == 0) {
            options.shorten = true;
        } else if (strncmp(argv[i], "--", 2) == 0) {
            read_option(argv[i], argv[i + 1]);
            i++;
        } else if (paths < LIBRARIES) {
            options.path[paths++] = argv[i];
        }
    }
    if (paths != LIBRARIES)
        fail("usage: fuzz_diff [option...] LIBRARY_UNDER_TEST REFERENCE_LIBRARY", NULL);
}

/* ---- frames ---- */

static struct channel *channel;

static void disable_missing(void)
{
    for (int i = 0; i < FEATURES; i++) {
        for (int library = 0; library < LIBRARIES; library++) {
            if (options.enabled[i] && channel->missing[library][features[i].needs]) {
                if (!options.script)
                    fprintf(stderr, "fuzz_diff: no %s: %s has no %s\n", features[i].name, options.path[library],
                            commands[features[i].needs].name);
                options.enabled[i] = false;
            }
        }
    }
}

static void save_script(unsigned long seed, const struct difference *difference)
{
    char name[1024];
    snprintf(name, sizeof name, "%s/seed-%lu.txt", options.save, seed);
    FILE *file = fopen(name, "w");
    if (!file)
        fail("cannot write", name);
    (void)difference;
    script_print(file, &channel->script);
    fclose(file);
}

static void show(unsigned long seed, struct difference difference)
{
    const int ops = channel->script.ops;
    if (options.tries > 0 && difference.outcome != HUNG)
        difference = minimize(channel, difference.outcome, options.tries);
    printf("seed %lu: ", seed);
    difference_print(stdout, channel, &difference);
    printf("  %d of %d commands:\n", channel->script.ops, ops);
    script_print(stdout, &channel->script);
    if (options.map)
        difference_print_map(stdout, channel);
    putchar('\n');
    fflush(stdout);
    if (options.save)
        save_script(seed, &difference);
}

static void count(const struct generator *g, const struct difference *difference)
{
    if (difference->outcome == REFERENCE_FAILED) {
        tally.reference_failed++;
        return;
    }
    tally.frames++;
    tally.differing += difference->outcome != IDENTICAL;
    for (int i = 0; i < FEATURES; i++) {
        tally.of[i] += g->used[i];
        tally.differing_of[i] += g->used[i] && difference->outcome != IDENTICAL;
    }
}

static void run_seeds(void)
{
    static struct generator g;
    memcpy(g.selected, options.enabled, sizeof g.selected);
    const double start = now();
    int shown = 0;
    for (unsigned long i = 0; i < options.count && now() - start < options.seconds; i++) {
        generate(&g, &channel->script, options.seed + i);
        if (options.print) {
            script_print(stdout, &channel->script);
            continue;
        }
        const struct difference difference = workers_compare(channel);
        count(&g, &difference);
        if (difference.outcome != IDENTICAL && difference.outcome != REFERENCE_FAILED) {
            if (shown++ < options.show)
                show(options.seed + i, difference);
            else
                printf("seed %lu differs\n", options.seed + i);
        }
        if ((i + 1) % 100 == 0)
            fprintf(stderr, "fuzz_diff: %lu frames, %lu differ, %.1f frames/s\n", tally.frames, tally.differing,
                    (double)(i + 1) / (now() - start));
    }
}

static void print_summary(void)
{
    printf("%-20s %8s %9s %10s\n", "feature", "frames", "differing", "identical");
    for (int i = 0; i < FEATURES; i++) {
        if (tally.of[i])
            printf("%-20s %8lu %9lu %9.2f%%\n", features[i].name, tally.of[i], tally.differing_of[i],
                   100.0 * (double)(tally.of[i] - tally.differing_of[i]) / (double)tally.of[i]);
    }
    if (tally.reference_failed)
        printf("%lu frames that the reference could not draw\n", tally.reference_failed);
    const unsigned long identical = tally.frames - tally.differing;
    printf("seeds %lu-%lu: %lu frames, %lu identical (%.2f %%)\n", options.seed,
           options.seed + tally.frames + tally.reference_failed - 1, tally.frames, identical,
           100.0 * (double)identical / (double)(tally.frames ? tally.frames : 1));
}

static int run_file(void)
{
    FILE *file = fopen(options.script, "r");
    if (!file || !script_read(file, &channel->script))
        fail("cannot read", options.script);
    fclose(file);
    const struct difference difference = workers_compare(channel);
    if (options.shorten && difference.outcome != IDENTICAL) {
        show(0, difference);
        return 1;
    }
    difference_print(stdout, channel, &difference);
    if (options.map)
        difference_print_map(stdout, channel);
    return difference.outcome != IDENTICAL;
}

int main(int argc, char **argv)
{
    read_options(argc, argv);
    channel = mmap(NULL, sizeof *channel, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (channel == MAP_FAILED)
        fail("out of memory", NULL);
    if (!workers_start(channel, options.path))
        return 2;
    disable_missing();
    int status = 0;
    if (options.script) {
        status = run_file();
    } else {
        run_seeds();
        if (!options.print)
            print_summary();
        status = tally.differing > 0;
    }
    workers_stop();
    return status;
}
