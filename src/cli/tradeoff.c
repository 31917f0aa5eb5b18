/* fixedgl tradeoff. */
#define _POSIX_C_SOURCE 200809L
#include "tradeoff.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "library.h"

static const char usage[] =
        "usage: fixedgl tradeoff [OPTION...]\n"
        "\n"
        "Measures what each mode of FixedGL, Mesa's OSMesa and straightforward float are off the "
        "specification, "
        "and\n"
        "what a vertex costs: a table, two CSV files, and a page with plots.\n"
        "\n"
        "  --only NAME        one category, sweep or sphere; `fixedgl-measure list` has the names\n"
        "  --vertices N       vertices per category                         (1280)\n"
        "  --seed N           seed of the random scenes                     (20260101)\n"
        "  --out DIR          tradeoff.csv, sweeps.csv, index.html          (build/tradeoff)\n"
        "  --osmesa LIBRARY   the library to compare with                   (libOSMesa.so.8)\n"
        "\n"
        "Exit status: 0, 1 if something could not be measured, 2 if it could not start.\n";

static const struct option options[] = {
        {"only", required_argument, NULL, 'n'},
        {"vertices", required_argument, NULL, 'v'},
        {"seed", required_argument, NULL, 's'},
        {"out", required_argument, NULL, 'o'},
        {"osmesa", required_argument, NULL, 'm'},
        {"help", no_argument, NULL, 'h'},
        {NULL, 0, NULL, 0},
};

static bool is_number(const char *text, unsigned long long most)
{
    char *end;
    return *text >= '0' && *text <= '9' && strtoull(text, &end, 0) <= most && *end == '\0';
}

static bool store(struct tradeoff *t, int option, const char *value)
{
    switch (option) {
    case 'n': t->only = value; return true;
    case 'o': t->output = value; return true;
    case 'm': t->osmesa = value; return true;
    case 's': t->seed = value; return is_number(value, (unsigned long long)-1);
    default: t->vertices = is_number(value, 1000000) ? atoi(value) : 0; return t->vertices > 0;
    }
}

/* Leaves OSMesa out if it cannot be loaded. */
static void look_for_osmesa(struct tradeoff *t)
{
    struct library_facts facts;
    struct problem problem;
    if (fgl_library_query(t->osmesa, &facts, &problem))
        return;
    printf("OSMesa is left out: %s\n", problem.text);
    t->osmesa = NULL;
}

static void show_progress(const struct tradeoff *t, int job, int renderer)
{
    static bool terminal, asked;
    if (!asked)
        terminal = isatty(STDERR_FILENO);
    asked = true;
    if (terminal)
        fprintf(stderr, "\r\033[K[%d of %d] %s, %s", job + 1, t->count, t->jobs[job].name,
                fgl_tradeoff_renderers[renderer].name);
    else if (renderer == COMPATIBLE && job % 20 == 0)
        fprintf(stderr, "%d of %d\n", job + 1, t->count);
    if (terminal && renderer == RENDERERS - 1)
        fprintf(stderr, "\r\033[K");
}

/* How many measurements failed. */
static int run_all(struct tradeoff *t)
{
    int failures = 0;
    struct problem problem;
    for (int i = 0; i < t->count; i++) {
        for (int r = 0; r < RENDERERS; r++) {
            show_progress(t, i, r);
            if (!fgl_tradeoff_run(t, &t->jobs[i], r, &problem)) {
                failures++;
                fprintf(stderr, "fixedgl: tradeoff: %s, %s: %s\n", t->jobs[i].name,
                        fgl_tradeoff_renderers[r].name, problem.text);
            }
        }
        fgl_tradeoff_print(&t->jobs[i]);
    }
    return failures;
}

static bool prepare(struct tradeoff *t, struct problem *problem)
{
    if (!fgl_make_folder(t->output, problem))
        return false;
    look_for_osmesa(t);
    if (!fgl_tradeoff_list(t, problem))
        return false;
    if (t->count == 0)
        return fgl_problem_set(problem, "there is no '%s'; `fixedgl-measure list` has the names", t->only);
    return (t->osmesa == NULL || fgl_tradeoff_name_renderer(t, OSMESA, problem)) &&
           fgl_tradeoff_name_renderer(t, COMPATIBLE, problem);
}

static void free_jobs(struct tradeoff *t)
{
    for (int i = 0; i < t->count; i++)
        for (int r = 0; r < RENDERERS; r++)
            free(t->jobs[i].result[r].figures);
    free(t->jobs);
}

int fgl_cli_tradeoff(int argc, char **argv)
{
    struct tradeoff t = {
            .output = "build/tradeoff", .osmesa = "libOSMesa.so.8", .vertices = 1280, .seed = "20260101"};
    struct problem problem;
    opterr = 0;
    for (int option, which = 0; (option = getopt_long(argc, argv, "", options, &which)) != -1;) {
        if (option == 'h') {
            fputs(usage, stdout);
            return EXIT_SAME;
        }
        if (option == '?')
            return fgl_complain("tradeoff: `%s` is not an option or lacks its value", argv[optind - 1]);
        if (!store(&t, option, optarg))
            return fgl_complain("tradeoff: --%s cannot be '%s'", options[which].name, optarg);
    }
    if (optind < argc)
        return fgl_complain("tradeoff: what is '%s'? `fixedgl tradeoff --help` says more", argv[optind]);
    if (!prepare(&t, &problem))
        return fgl_complain("tradeoff: %s", problem.text);
    printf("seed %s, %d vertices per category\n", t.seed, t.vertices);
    const int failures = run_all(&t);
    fgl_tradeoff_print_summary(&t);
    const bool written = fgl_tradeoff_write_csv(&t, &problem) && fgl_tradeoff_write_page(&t, &problem);
    free_jobs(&t);
    if (!written)
        return fgl_complain("tradeoff: %s", problem.text);
    printf("\n%s/index.html, tradeoff.csv, sweeps.csv\n", t.output);
    return failures > 0 ? EXIT_DIFFERS : EXIT_SAME;
}
