/* Running fixedgl-measure, a process for each job and renderer, and reading what it prints. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "child.h"
#include "image.h"
#include "library.h"
#include "pngfile.h"
#include "tradeoff.h"

const struct tradeoff_renderer fgl_tradeoff_renderers[RENDERERS] = {
        [OSMESA] = {"OSMesa", "osmesa", "#d9711c", NULL, NULL},
        [PLAIN] = {"plain float", "plain", "#8a8f98", "--plain", NULL},
        [COMPATIBLE] = {"compatible", "compatible", "#2f6fd0", NULL, "FIXEDGL_ACCURACY=compatible"},
        [EXACT] = {"exact", "exact", "#1a9f5b", NULL, "FIXEDGL_ACCURACY=exact"},
        [TRUTH] = {"truth", "truth", "#000", "--truth", NULL},
};

static const char *const kinds[TRADEOFF_KINDS] = {"lighting", "triangles", "sweep", "sphere"};

static const double timeout = 600;

/* Runs fixedgl-measure with these words and hands each line it prints to `use`. */
static bool measure(const struct tradeoff *t, int renderer, const char *const words[4],
                    bool (*use)(char *, void *, struct problem *), void *context, struct problem *problem)
{
    const struct tradeoff_renderer *r = &fgl_tradeoff_renderers[renderer];
    char *program = fgl_library_beside("fixedgl-measure"), *vertices = fgl_format("%d", t->vertices);
    char *output = fgl_format("%s/measure.txt", t->output), *errors = fgl_format("%s/measure.err", t->output);
    char *preload = fgl_format("LD_PRELOAD=%s", t->osmesa != NULL ? t->osmesa : "");
    char *argv[12] = {program, "--vertices", vertices, "--seed", (char *)t->seed};
    const char *set[8] = {NULL};
    int words_given = 5, set_count = 0;
    if (strcmp(words[0], kinds[LIGHTING]) == 0)
        set[set_count++] = "FIXEDGL_THREADS=1"; /* as many as OSMesa has for vertices */
    if (r->option != NULL)
        argv[words_given++] = (char *)r->option;
    for (int i = 0; i < 4 && words[i] != NULL; i++)
        argv[words_given++] = (char *)words[i];
    if (r->set != NULL)
        set[set_count++] = r->set;
    if (renderer == OSMESA) {
        set[set_count++] = preload;
        set[set_count++] = "MESA_SHADER_CACHE_DISABLE=true";
        set[set_count++] = "ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0"; /* as in draw.c */
    }
    const struct child child = {argv, set, output, errors, timeout};
    const bool good = fgl_child_run(&child, problem) && fgl_read_lines(output, use, context, problem);
    remove(output);
    remove(errors);
    free(program), free(vertices), free(output), free(errors), free(preload);
    return good;
}

static bool take_job(char *line, void *context, struct problem *problem)
{
    struct tradeoff *t = context;
    struct tradeoff_job job = {.kind = TRADEOFF_KINDS};
    char *name = strchr(line, '\t');
    if (name == NULL)
        return fgl_problem_set(problem, "fixedgl-measure lists no jobs");
    *name++ = '\0';
    char *more = strchr(name, '\t');
    if (more != NULL)
        *more++ = '\0';
    for (int kind = 0; kind < TRADEOFF_KINDS; kind++)
        if (strcmp(line, kinds[kind]) == 0)
            job.kind = (enum tradeoff_kind)kind;
    job.logarithmic = more != NULL && strcmp(more, "1") == 0;
    snprintf(job.name, sizeof job.name, "%s", name);
    if (job.kind == TRADEOFF_KINDS || (t->only != NULL && strcmp(t->only, name) != 0))
        return true;
    t->jobs = fgl_grow(t->jobs, (size_t)t->count, sizeof *t->jobs);
    t->jobs[t->count++] = job;
    return true;
}

bool fgl_tradeoff_list(struct tradeoff *t, struct problem *problem)
{
    const char *words[4] = {"list"};
    return measure(t, COMPATIBLE, words, take_job, t, problem);
}

static bool take_figures(char *line, void *context, struct problem *problem)
{
    struct tradeoff_result *result = context;
    struct tradeoff_figures f = {0};
    (void)problem;
    if (strncmp(line, "point\t", 6) == 0)
        sscanf(line, "point %lf %lf %lf %lf %ld %ld %ld", &f.at, &f.max, &f.p999, &f.mean, &f.bytes,
               &f.invalid, &f.count);
    else if (sscanf(line, "error %lf %lf %lf %ld %ld %ld %lf %lf %lf %lf %ld %ld", &f.max, &f.p999, &f.mean,
                    &f.bytes, &f.invalid, &f.count, &f.ns, &f.depth_max, &f.depth_p999, &f.depth_mean,
                    &f.coverage, &f.corners) < 7)
        return true;
    result->figures = fgl_grow(result->figures, (size_t)result->count, sizeof f);
    result->figures[result->count++] = f;
    return true;
}

char *fgl_tradeoff_picture(const struct tradeoff *t, const struct tradeoff_job *job, int renderer)
{
    char *path = fgl_format("sphere-%d-%s.png", (int)(job - t->jobs), fgl_tradeoff_renderers[renderer].file);
    return path;
}

static bool convert(const char *pam, const char *png, struct problem *problem)
{
    struct image image = {0};
    const bool good = fgl_image_read_pam(pam, &image, problem) &&
                      fgl_pngfile_write(png, image.width, image.height, 4, image.rgba, NULL, problem);
    fgl_image_free(&image);
    return good;
}

bool fgl_tradeoff_run(const struct tradeoff *t, struct tradeoff_job *job, int renderer,
                      struct problem *problem)
{
    struct tradeoff_result *result = &job->result[renderer];
    if ((renderer == OSMESA && t->osmesa == NULL) || (renderer == PLAIN && job->kind == TRIANGLES) ||
        (renderer == TRUTH && job->kind != SPHERE))
        return true;
    char *pam = fgl_format("%s/sphere.pam", t->output);
    const char *words[4] = {kinds[job->kind], job->name, job->kind == SPHERE ? pam : NULL};
    bool good = measure(t, renderer, words, take_figures, result, problem);
    if (good && job->kind == SPHERE) {
        char *name = fgl_tradeoff_picture(t, job, renderer), *png = fgl_format("%s/%s", t->output, name);
        good = convert(pam, png, problem);
        result->count = good;
        remove(pam);
        free(name), free(png);
    }
    free(pam);
    return good;
}

static bool take_name(char *line, void *context, struct problem *problem)
{
    (void)problem;
    snprintf(context, 128, "%s", line);
    return true;
}

bool fgl_tradeoff_name_renderer(struct tradeoff *t, int renderer, struct problem *problem)
{
    const char *words[4] = {"renderer"};
    return measure(t, renderer, words, take_name, t->gl_renderer[renderer != OSMESA], problem);
}
