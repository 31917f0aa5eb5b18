#include "oracle/measure.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COMPONENTS = 4 * ORACLE_VERTICES };

struct tally {
    struct oracle_error error;
    float *errors; /* of each component, for the percentile */
};

static int to_byte(double x)
{
    return (int)floor(x * 255 + 0.5);
}

/* The float nearest to the truth may lie beyond the value at which the byte changes: no float is nearer. */
static bool is_wrong_byte(double truth, double drawn)
{
    return to_byte(truth) != to_byte(drawn) && (float)truth != (float)drawn;
}

static void count(struct tally *tally, double error, struct oracle_worst where)
{
    struct oracle_error *e = &tally->error;
    tally->errors[e->components++] = (float)error;
    e->mean += error;
    if (error > e->max) {
        e->max = error;
        e->worst = where;
    }
}

/* Of a float of this magnitude, not below the normal range. */
static double last_place(double x)
{
    int exponent;
    frexp(fmax(fabs(x), (double)FLT_MIN), &exponent);
    return ldexp(1, exponent - FLT_MANT_DIG);
}

static void compare_vertex(struct tally *tally, const struct oracle_color *truth, const float drawn[4],
                           bool sum_of_two, struct oracle_worst where)
{
    for (where.component = 0; where.component < 4; where.component++) {
        where.truth = truth->drawn ? (double)truth->component[where.component] : 0;
        where.drawn = (double)drawn[where.component];
        if (sum_of_two && where.drawn > 1 && where.drawn <= 2)
            where.drawn = 1; /* a buffer of floats holds the sum before it is clamped */
        const bool valid = where.drawn >= 0 && where.drawn <= 1;
        tally->error.invalid += !valid;
        tally->error.wrong_bytes += !valid || is_wrong_byte(where.truth, where.drawn);
        const bool both = truth->drawn || where.drawn == 0;
        const quad exact = truth->drawn ? truth->component[where.component] : 0;
        const double error = fabs((double)((quad)where.drawn - exact));
        count(tally, valid && both ? error : 1, where);
        tally->error.ulps = fmax(tally->error.ulps, (valid && both ? error : 1) / last_place((double)exact));
    }
}

static void compare_scene(struct tally *tally, const struct oracle_scene *scene, int number, double margin,
                          oracle_renderer *render)
{
    float rgba[ORACLE_VERTICES][4];
    render(scene, rgba);
    for (int i = 0; i < scene->count; i++) {
        const struct oracle_color truth = oracle_shade(&scene->state, &scene->vertex[i]);
        if (truth.to_horizon < (quad)margin) {
            tally->error.at_edge += 4;
            continue;
        }
        const struct oracle_worst where = {.scene = number, .vertex = i};
        compare_vertex(tally, &truth, rgba[i], scene->state.separate_specular, where);
    }
}

static int ascending(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

struct oracle_measurement oracle_measurement_of(int category, uint64_t seed, int scenes)
{
    const struct oracle_category *c = &oracle_categories[category];
    return (struct oracle_measurement){c->generate, c->parameter, seed, (uint64_t)category, scenes, 0};
}

static void generate(const struct oracle_measurement *m, int number, struct oracle_scene *scene)
{
    struct random random = random_stream(m->seed, m->stream << 32 | (uint64_t)number);
    memset(scene, 0, sizeof *scene);
    m->generate(&random, scene, m->parameter);
}

struct oracle_error oracle_measure(const struct oracle_measurement *m, oracle_renderer *render)
{
    struct tally tally = {.errors = malloc((size_t)m->scenes * COMPONENTS * sizeof(float))};
    if (tally.errors == NULL)
        abort();
    for (int i = 0; i < m->scenes; i++) {
        struct oracle_scene scene;
        generate(m, i, &scene);
        compare_scene(&tally, &scene, i, m->margin, render);
    }
    struct oracle_error *e = &tally.error;
    if (e->components > 0) {
        qsort(tally.errors, (size_t)e->components, sizeof(float), ascending);
        e->p999 = (double)tally.errors[(e->components - 1) * 999 / 1000];
        e->mean /= (double)e->components;
    }
    free(tally.errors);
    return tally.error;
}

double oracle_time(const struct oracle_measurement *m, oracle_renderer *render)
{
    struct oracle_scene scene;
    generate(m, 0, &scene);
    return render == oracle_draw ? oracle_time_strip(&scene) : oracle_time_renderer(&scene, render);
}
