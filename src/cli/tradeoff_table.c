/* The figures as text: lines on the terminal, the summary, CSV. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tradeoff.h"

static const double byte_step = 1.0 / 255;

static const struct tradeoff_figures *figures_of(const struct tradeoff_job *job, int renderer)
{
    return job->result[renderer].count > 0 ? job->result[renderer].figures : NULL;
}

static void print_figures(const struct tradeoff_job *job, const struct tradeoff_figures *f,
                          const char *renderer)
{
    printf("%-12s max %.1e  99.9%% %.1e  mean %.1e  bytes %5ld  NaN %4ld  ", renderer, f->max, f->p999,
           f->mean, f->bytes, f->invalid);
    if (job->kind == TRIANGLES)
        printf("coverage %ld + %ld  depth max %.1f  99.9%% %.1f  mean %.1f  %6.0f ns\n", f->coverage,
               f->corners, f->depth_max, f->depth_p999, f->depth_mean, f->ns);
    else
        printf("%6.1f ns\n", f->ns);
}

static double greatest(const struct tradeoff_result *result)
{
    double most = 0;
    for (int i = 0; i < result->count; i++)
        most = result->figures[i].max > most ? result->figures[i].max : most;
    return most;
}

void fgl_tradeoff_print(const struct tradeoff_job *job)
{
    const char *name = job->name;
    for (int r = 0; r < MEASURED_RENDERERS && job->kind != SPHERE; r++) {
        const struct tradeoff_figures *f = figures_of(job, r);
        if (f == NULL)
            continue;
        printf("%-46s ", name);
        name = "";
        if (job->kind == SWEEP)
            printf("%-12s max %.1e at the worst of %d points\n", fgl_tradeoff_renderers[r].name,
                   greatest(&job->result[r]), job->result[r].count);
        else
            print_figures(job, f, fgl_tradeoff_renderers[r].name);
    }
    fflush(stdout);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

struct tradeoff_summary fgl_tradeoff_summarize(const struct tradeoff *t, enum tradeoff_kind kind,
                                               int renderer)
{
    struct tradeoff_summary s = {0};
    double *ns = fgl_allocate((size_t)t->count + 1, sizeof *ns);
    for (int i = 0; i < t->count; i++) {
        const struct tradeoff_figures *f = figures_of(&t->jobs[i], renderer);
        if (f == NULL || t->jobs[i].kind != kind)
            continue;
        ns[s.categories++] = f->ns;
        s.wrong += f->max > byte_step;
        s.bytes += f->bytes;
        s.invalid += f->invalid;
        s.coverage += f->coverage;
        s.corners += f->corners;
        s.depth = f->depth_max > s.depth ? f->depth_max : s.depth;
    }
    qsort(ns, (size_t)s.categories, sizeof *ns, ascending);
    s.ns = s.categories > 0 ? ns[s.categories / 2] : 0;
    free(ns);
    return s;
}

/* One line: what is counted, then renderer and number of each. */
static void print_counts(const char *what, const struct tradeoff_summary *s,
                         double (*number)(const struct tradeoff_summary *), const char *format)
{
    const char *separator = " ";
    printf("  %-48s", what);
    for (int r = 0; r < MEASURED_RENDERERS; r++) {
        if (s[r].categories == 0)
            continue;
        printf("%s%s ", separator, fgl_tradeoff_renderers[r].name);
        printf(format, number(&s[r]));
        separator = ", ";
    }
    printf("\n");
}

static double wrong_of(const struct tradeoff_summary *s)
{
    return s->wrong;
}
static double bytes_of(const struct tradeoff_summary *s)
{
    return (double)s->bytes;
}
static double invalid_of(const struct tradeoff_summary *s)
{
    return (double)s->invalid;
}
static double ns_of(const struct tradeoff_summary *s)
{
    return s->ns;
}
static double coverage_of(const struct tradeoff_summary *s)
{
    return (double)(s->coverage + s->corners);
}
static double depth_of(const struct tradeoff_summary *s)
{
    return s->depth;
}

void fgl_tradeoff_print_summary(const struct tradeoff *t)
{
    static const char *const titles[] = {"lighting", "triangles"};
    for (int kind = LIGHTING; kind <= TRIANGLES; kind++) {
        struct tradeoff_summary s[MEASURED_RENDERERS];
        for (int r = 0; r < MEASURED_RENDERERS; r++)
            s[r] = fgl_tradeoff_summarize(t, (enum tradeoff_kind)kind, r);
        if (s[COMPATIBLE].categories == 0)
            continue;
        printf("\n%s, %d categories\n", titles[kind], s[COMPATIBLE].categories);
        print_counts("categories wrong by more than 1/255 somewhere:", s, wrong_of, "%.0f");
        print_counts("8-bit values that differ from the truth:", s, bytes_of, "%.0f");
        print_counts("NaN, infinite or outside [0,1]:", s, invalid_of, "%.0f");
        if (kind == TRIANGLES) {
            print_counts("pixels of wrong coverage:", s, coverage_of, "%.0f");
            print_counts("greatest error of depth, units of 2^-24:", s, depth_of, "%.1f");
        }
        print_counts(kind == LIGHTING ? "ns per vertex, median over the categories:"
                                      : "ns per triangle, median over the categories:",
                     s, ns_of, "%.1f");
    }
}

static void put_rows(FILE *file, const struct tradeoff_job *job, bool sweeps)
{
    for (int r = 0; r < MEASURED_RENDERERS; r++)
        for (int i = 0; i < job->result[r].count; i++) {
            const struct tradeoff_figures *f = &job->result[r].figures[i];
            fprintf(file, "\"%s\",%s,", job->name, fgl_tradeoff_renderers[r].name);
            if (sweeps)
                fprintf(file, "%g,", f->at);
            fprintf(file, "%g,%g,%g,%ld,%ld,%ld", f->max, f->p999, f->mean, f->bytes, f->invalid, f->count);
            if (!sweeps)
                fprintf(file, ",%g,%g,%g,%g,%ld,%ld", f->ns, f->depth_max, f->depth_p999, f->depth_mean,
                        f->coverage, f->corners);
            fprintf(file, "\n");
        }
}

static bool write_csv(const struct tradeoff *t, const char *name, bool sweeps, struct problem *problem)
{
    char *path = fgl_format("%s/%s", t->output, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fgl_problem_set(problem, "%s: %s", path, strerror(errno));
        free(path);
        return false;
    }
    fprintf(file, "category,renderer,%smax,p999,mean,wrong_bytes,invalid,count%s\n", sweeps ? "at," : "",
            sweeps ? "" : ",ns,depth_max,depth_p999,depth_mean,wrong_coverage,other_corners");
    for (int i = 0; i < t->count; i++)
        if ((t->jobs[i].kind == SWEEP) == sweeps && t->jobs[i].kind != SPHERE)
            put_rows(file, &t->jobs[i], sweeps);
    const bool good = fclose(file) == 0 || fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    free(path);
    return good;
}

bool fgl_tradeoff_write_csv(const struct tradeoff *t, struct problem *problem)
{
    return write_csv(t, "tradeoff.csv", false, problem) && write_csv(t, "sweeps.csv", true, problem);
}
