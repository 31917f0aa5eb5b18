/*
 * Lit colors against the oracle, category by category, each a test of its name.
 *
 * Each in every mode of fixedglAccuracy; --table has the mode of FIXEDGL_ACCURACY.
 * environment: FIXEDGL_SEED, the seed (printed); FIXEDGL_SCENES, scenes per category, 64 vertices each.
 * LD_PRELOAD=libOSMesa.so.8 measures OSMesa instead; argument --table: print the figures of all categories
 * and assert nothing.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "fixedgl.h"
#include "oracle/measure.h"

enum { MOST_CATEGORIES = 256 };

/* On ordinary scenes, compatible mode has f_i right unless the cosine is this close to where it jumps. */
static const double margin = 1e-6, ordinary = 2.3e-5;

static uint64_t seed = 20260101;
static int scenes = 40; /* over a million components of all categories in each mode */

static void read_environment(void)
{
    const char *given_seed = getenv("FIXEDGL_SEED"), *given_scenes = getenv("FIXEDGL_SCENES");
    if (given_seed != NULL)
        seed = strtoull(given_seed, NULL, 0);
    if (given_scenes != NULL && atoi(given_scenes) > 0)
        scenes = atoi(given_scenes);
}

static double bound_of(int category, bool exact)
{
    const struct oracle_bounds *bounds = &oracle_categories[category].bounds;
    return exact ? bounds->exact : bounds->compatible;
}

static struct oracle_error measure(int category, bool exact)
{
    struct oracle_measurement m = oracle_measurement_of(category, seed, scenes);
    m.margin = !exact && bound_of(category, false) == ordinary ? margin : 0;
    return oracle_measure(&m, oracle_draw);
}

static void print_error_line(int category, const struct oracle_error *e)
{
    printf("%-46s max %.1e (%.4f ulp)  99.9%% %.1e  mean %.1e  bytes %5ld  invalid %5ld  of %ld",
           oracle_categories[category].name, e->max, e->ulps, e->p999, e->mean, e->wrong_bytes, e->invalid,
           e->components);
    if (e->max > 0)
        printf("  worst: scene %d vertex %d component %d, %.9g for %.9g", e->worst.scene, e->worst.vertex,
               e->worst.component, e->worst.drawn, e->worst.truth);
    printf("\n");
    fflush(stdout);
}

static void test_category(void **state)
{
    const int category = *(const int *)*state;
    const struct oracle_error error = measure(category, false);
    const double bound = bound_of(category, false);
    print_error_line(category, &error);
    assert_true(error.components > 0);
    assert_int_equal(error.invalid, 0);
    if (bound > 0)
        assert_true(error.max <= bound);
}

static void test_category_exact(void **state)
{
    const int category = *(const int *)*state;
    const double bound = bound_of(category, true);
    assert_int_not_equal(fixedglAccuracy(FIXEDGL_EXACT), 0);
    const struct oracle_error error = measure(category, true);
    fixedglAccuracy(FIXEDGL_COMPATIBLE);
    print_error_line(category, &error);
    assert_true(error.components > 0);
    assert_int_equal(error.invalid, 0);
    assert_int_equal(error.wrong_bytes, 0);
    assert_true(error.ulps <= bound);
}

/* The oracle itself, where its answer can be had by hand. */
static void test_worked_example(void **unused)
{
    (void)unused;
    struct oracle_state state = {.lights = 1};
    for (int i = 0; i < 4; i++)
        state.modelview[5 * i] = state.light_modelview[5 * i] = 1;
    struct oracle_light *light = &state.light[0];
    *light = (struct oracle_light){.position = {0, 3, 4, 1}, .spot_cutoff = 180, .attenuation = {1, 0.2f, 0}};
    light->diffuse[0] = light->specular[1] = light->ambient[2] = 1;
    state.front.diffuse[0] = state.front.specular[1] = state.front.ambient[2] = 1;
    state.front.shininess = 2;
    state.front.diffuse[3] = 0.5f;
    const struct oracle_vertex vertex = {.position = {0, 0, 0, 1}, .normal = {0, 0, 1}};
    const struct oracle_color color = oracle_shade(&state, &vertex);
    /* VP = (0, .6, .8), distance 5, att = 1 / (1 + .2 * 5); h = (0, .6, 1.8) / sqrt(3.6), (n.h)^2 = .9 */
    const double truth[4] = {0.8 / 2, 0.9 / 2, 1.0 / 2, 0.5};
    for (int i = 0; i < 4; i++)
        assert_float_equal((double)color.component[i], truth[i], 1e-8); /* .2f is not .2 */
    assert_true(color.drawn);
}

static int print_table(void)
{
    const char *mode = getenv("FIXEDGL_ACCURACY");
    const bool exact = mode != NULL && strcmp(mode, "exact") == 0;
    for (int i = 0; i < oracle_category_count; i++) {
        const struct oracle_error error = measure(i, exact);
        print_error_line(i, &error);
    }
    return 0;
}

static int test_all(void)
{
    static int number[MOST_CATEGORIES];
    static struct CMUnitTest tests[MOST_CATEGORIES];
    size_t count = 0;
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(test_worked_example);
    for (int i = 0; i < oracle_category_count && 2 * i + 2 < MOST_CATEGORIES; i++) {
        number[i] = i;
        tests[count++] =
                (struct CMUnitTest){oracle_categories[i].name, test_category, NULL, NULL, &number[i]};
        tests[count++] =
                (struct CMUnitTest){oracle_categories[i].name, test_category_exact, NULL, NULL, &number[i]};
    }
    return _cmocka_run_group_tests("lighting", tests, count, NULL, NULL);
}

int main(int argc, char **argv)
{
    read_environment();
    if (argc == 1)
        unsetenv("FIXEDGL_ACCURACY"); /* the tests choose */
    if (!oracle_open()) {
        fprintf(stderr, "lighting: no context with a buffer of floats\n");
        return 1;
    }
    printf("%s, seed %llu (FIXEDGL_SEED), %d scenes per category (FIXEDGL_SCENES)\n",
           (const char *)glGetString(GL_RENDERER), (unsigned long long)seed, scenes);
    const int result = argc > 1 && strcmp(argv[1], "--table") == 0 ? print_table() : test_all();
    oracle_close();
    return result;
}
