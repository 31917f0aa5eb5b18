/*
 * fixedgl-measure: measures one renderer at one job, for `fixedgl tradeoff`, which runs it in a process of
 * its own for each. The renderer is the GL that the program finds (FixedGL in the mode of FIXEDGL_ACCURACY,
 * or a preloaded OSMesa), or one of its own: --plain, --truth. Output: a line for each figure, fields
 * separated by tabs.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/measure.h"
#include "oracle/plain.h"
#include "oracle/raster_measure.h"
#include "oracle/spheres.h"
#include "oracle/sweeps.h"

static const char usage[] =
        "usage: fixedgl-measure [--plain | --truth] [--vertices N] [--seed N] JOB [NAME]\n"
        "\n"
        "  list             the jobs and their names\n"
        "  renderer         what draws\n"
        "  lighting NAME    the error of lit colors in a category, and the time per vertex\n"
        "  triangles NAME   the errors of coverage, color and depth in a category, and the time per "
        "triangle\n"
        "  sweep NAME       the error at each point from one extreme to the other\n"
        "  sphere NAME FILE a picture of what an extreme does, as PAM\n";

struct settings {
    oracle_renderer *render;
    int vertices;
    uint64_t seed;
};

static void render_truth(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4])
{
    for (int i = 0; i < scene->count; i++) {
        const struct oracle_color color = oracle_shade(&scene->state, &scene->vertex[i]);
        for (int k = 0; k < 4; k++)
            rgba[i][k] = color.drawn ? (float)color.component[k] : 0;
    }
}

static int scenes_of(int vertices)
{
    return (vertices + ORACLE_VERTICES - 1) / ORACLE_VERTICES;
}

static void print_error(const struct oracle_error *e)
{
    printf("\t%.6g\t%.6g\t%.6g\t%ld\t%ld\t%ld", e->max, e->p999, e->mean, e->wrong_bytes, e->invalid,
           e->components);
}

static bool measure_lighting(const struct settings *settings, const char *name)
{
    for (int i = 0; i < oracle_category_count; i++) {
        if (strcmp(oracle_categories[i].name, name) != 0)
            continue;
        const struct oracle_measurement m = oracle_measurement_of(i, settings->seed, scenes_of(settings->vertices));
        const struct oracle_error error = oracle_measure(&m, settings->render);
        printf("error");
        print_error(&error);
        printf("\t%.4g\n", oracle_time(&m, settings->render));
        return true;
    }
    return false;
}

/* A twentieth as many triangles as vertices: each has hundreds of pixels. */
static bool measure_triangles(const struct settings *settings, const char *name)
{
    for (int i = 0; i < raster_category_count; i++) {
        if (strcmp(raster_categories[i].name, name) != 0)
            continue;
        if (!raster_open())
            return false;
        const struct raster_error e = raster_measure(i, settings->seed, (settings->vertices + 19) / 20);
        printf("error\t%.6g\t%.6g\t%.6g\t%ld\t%ld\t%ld\t%.4g\t%.6g\t%.6g\t%.6g\t%ld\t%ld\n", e.color.max,
               e.color.p999, e.color.mean, e.wrong_bytes, e.invalid, e.pixels, e.ns, e.depth.max,
               e.depth.p999, e.depth.mean, e.wrong_coverage, e.other_corners);
        raster_close();
        return true;
    }
    return false;
}

/* A tenth as many vertices at each point as in a category. */
static bool measure_sweep(const struct settings *settings, const char *name)
{
    for (int i = 0; i < oracle_sweep_count; i++) {
        const struct oracle_sweep *sweep = &oracle_sweeps[i];
        if (strcmp(sweep->name, name) != 0)
            continue;
        for (int step = 0; step < sweep->steps; step++) {
            const double at = oracle_sweep_at(sweep, step);
            const uint64_t stream = (uint64_t)(1000 * (i + 1) + step);
            const struct oracle_measurement m = {sweep->generate,     at, settings->seed, stream,
                                                 scenes_of(settings->vertices / 10 + 1), 0};
            const struct oracle_error error = oracle_measure(&m, settings->render);
            printf("point\t%.6g", at);
            print_error(&error);
            printf("\n");
        }
        return true;
    }
    return false;
}

static bool draw_sphere(const struct settings *settings, const char *name, const char *path)
{
    for (int i = 0; i < oracle_sphere_count; i++)
        if (strcmp(oracle_spheres[i].name, name) == 0)
            return oracle_sphere_write(&oracle_spheres[i], settings->render, path);
    return false;
}

static bool list(void)
{
    for (int i = 0; i < oracle_category_count; i++)
        printf("lighting\t%s\n", oracle_categories[i].name);
    for (int i = 0; i < raster_category_count; i++)
        printf("triangles\t%s\n", raster_categories[i].name);
    for (int i = 0; i < oracle_sweep_count; i++)
        printf("sweep\t%s\t%d\n", oracle_sweeps[i].name, oracle_sweeps[i].logarithmic);
    for (int i = 0; i < oracle_sphere_count; i++)
        printf("sphere\t%s\n", oracle_spheres[i].name);
    return true;
}

static bool run(const struct settings *settings, int count, char **word)
{
    if (strcmp(word[0], "list") == 0)
        return count == 1 && list();
    if (strcmp(word[0], "renderer") == 0)
        return count == 1 && printf("%s\n", (const char *)glGetString(GL_RENDERER)) > 0;
    if (strcmp(word[0], "lighting") == 0)
        return count == 2 && measure_lighting(settings, word[1]);
    if (strcmp(word[0], "triangles") == 0)
        return count == 2 && settings->render == oracle_draw && measure_triangles(settings, word[1]);
    if (strcmp(word[0], "sweep") == 0)
        return count == 2 && measure_sweep(settings, word[1]);
    return strcmp(word[0], "sphere") == 0 && count == 3 && draw_sphere(settings, word[1], word[2]);
}

/* Reads the options; returns the index of the job, 0 if they are wrong. */
static int read_options(int argc, char **argv, struct settings *settings)
{
    int i = 1;
    for (; i < argc && strncmp(argv[i], "--", 2) == 0; i++) {
        if (strcmp(argv[i], "--plain") == 0)
            settings->render = oracle_plain;
        else if (strcmp(argv[i], "--truth") == 0)
            settings->render = render_truth;
        else if (strcmp(argv[i], "--vertices") == 0 && i + 1 < argc && atoi(argv[i + 1]) > 0)
            settings->vertices = atoi(argv[++i]);
        else if (strcmp(argv[i], "--seed") == 0 && i + 1 < argc)
            settings->seed = strtoull(argv[++i], NULL, 0);
        else
            return 0;
    }
    return i < argc ? i : 0;
}

int main(int argc, char **argv)
{
    struct settings settings = {.render = oracle_draw, .vertices = 1280, .seed = 20260101};
    const int job = read_options(argc, argv, &settings);
    if (job == 0) {
        fputs(usage, stderr);
        return 2;
    }
    if (!oracle_open()) {
        fprintf(stderr, "fixedgl-measure: no context with a buffer of floats\n");
        return 2;
    }
    const bool done = run(&settings, argc - job, argv + job);
    oracle_close();
    if (!done)
        fprintf(stderr, "fixedgl-measure: cannot do '%s%s%s'\n", argv[job], job + 1 < argc ? " " : "",
                job + 1 < argc ? argv[job + 1] : "");
    return done ? 0 : 2;
}
