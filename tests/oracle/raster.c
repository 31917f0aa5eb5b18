/*
 * Triangles against the oracle, category by category: coverage by integers, color and depth in 113 bits.
 *
 * environment: FIXEDGL_SEED, the seed (printed); FIXEDGL_TRIANGLES, triangles per category.
 * LD_PRELOAD=libOSMesa.so.8 measures OSMesa instead; argument --table: print the figures of all categories
 * and assert nothing.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/gl.h>

#include "fixedgl.h"
#include "oracle/raster_measure.h"

enum { MOST_CATEGORIES = 64 };

static uint64_t seed = 20260101;
static int triangles = 40;

static void read_environment(void)
{
    const char *given_seed = getenv("FIXEDGL_SEED"), *given_count = getenv("FIXEDGL_TRIANGLES");
    if (given_seed != NULL)
        seed = strtoull(given_seed, NULL, 0);
    if (given_count != NULL && atoi(given_count) > 0)
        triangles = atoi(given_count);
}

static struct raster_error measure(int category)
{
    const struct raster_error e = raster_measure(category, seed, triangles);
    printf("%-38s pixels %7ld  coverage %ld + %ld  color max %.1e  99.9%% %.1e  bytes %5ld  invalid %ld  "
           "depth max %.1f  99.9%% "
           "%.1f\n",
           raster_categories[category].name, e.pixels, e.wrong_coverage, e.other_corners, e.color.max,
           e.color.p999, e.wrong_bytes, e.invalid, e.depth.max, e.depth.p999);
    fflush(stdout);
    return e;
}

/* In every mode: no pixel too many or too few, no crack between triangles and no pixel twice, no NaN. In
 * compatible mode the corners are OSMesa's, floats, which may round to another 1/256 of a pixel. */
static struct raster_error check_coverage(int category)
{
    const struct raster_error error = measure(category);
    assert_true(error.pixels > 0);
    assert_int_equal(error.invalid, 0);
    assert_int_equal(error.wrong_coverage, 0);
    return error;
}

static void test_compatible(void **state)
{
    assert_int_not_equal(fixedglAccuracy(FIXEDGL_COMPATIBLE), 0);
    check_coverage(*(const int *)*state);
}

/* Also: corners exact, colors within 1e-6, depths rounded once. */
static void test_exact(void **state)
{
    assert_int_not_equal(fixedglAccuracy(FIXEDGL_EXACT), 0);
    const struct raster_error error = check_coverage(*(const int *)*state);
    assert_int_equal(error.other_corners, 0);
    assert_true(error.color.max <= 1e-6);
    assert_true(error.depth.max <= 0.5 + 1e-6);
    assert_int_equal(error.wrong_bytes, 0);
}

static int print_table(void)
{
    for (int i = 0; i < raster_category_count; i++)
        measure(i);
    return 0;
}

/* The oracle itself, where its answer can be had by hand. */
static void test_worked_example(void **unused)
{
    (void)unused;
    /* The lower left half of the window's quarter, w = 1, 2, 4 and red at the corner of w = 2. */
    const struct raster_triangle triangle = {
            {{{0, 0, 0, 1}, {0, 0, 0, 1}}, {{1, 0, 2, 2}, {1, 0, 0, 1}}, {{0, 2, -4, 4}, {0, 0, 0, 1}}}};
    struct raster_setup setup;
    oracle_raster_setup(&triangle, &setup);
    assert_false(setup.clipped);
    /* Corners at (64, 64), (96, 64), (64, 96): the diagonal goes through centers, which are not its own. */
    assert_int_equal(oracle_raster_coverage(&setup, 64, 64), RASTER_INSIDE);
    assert_int_equal(oracle_raster_coverage(&setup, 63, 64), RASTER_OUTSIDE);
    assert_int_equal(oracle_raster_coverage(&setup, 94, 64), RASTER_INSIDE);
    assert_int_equal(oracle_raster_coverage(&setup, 95, 64), RASTER_OUTSIDE);
    /* At (80.5, 72.5) the weights are 14, 33 and 17 of 64. */
    const struct raster_truth truth = oracle_raster_truth(&setup, 80, 72);
    const double a = 14 / 64.0, b = 33 / 64.0, c = 17 / 64.0;
    assert_true(fabs((double)truth.color[0] - b / 2 / (a + b / 2 + c / 4)) < 1e-15);
    assert_true(fabs((double)truth.depth - (a * 0.5 + b)) < 1e-15);
}

int main(int argc, char **argv)
{
    read_environment();
    if (!raster_open()) {
        fprintf(stderr, "raster: no context with a buffer of floats\n");
        return 1;
    }
    printf("%s, seed %llu (FIXEDGL_SEED), %d triangles per category (FIXEDGL_TRIANGLES)\n",
           (const char *)glGetString(GL_RENDERER), (unsigned long long)seed, triangles);
    if (argc > 1 && strcmp(argv[1], "--table") == 0)
        return print_table();
    static int number[MOST_CATEGORIES];
    static struct CMUnitTest tests[2 * MOST_CATEGORIES + 1];
    size_t count = 0;
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(test_worked_example);
    for (int i = 0; i < raster_category_count; i++) {
        const char *name = raster_categories[i].name;
        number[i] = i;
        tests[count++] = (struct CMUnitTest){name, test_compatible, NULL, NULL, &number[i]};
        tests[count++] = (struct CMUnitTest){name, test_exact, NULL, NULL, &number[i]};
    }
    const int result = _cmocka_run_group_tests("raster", tests, count, NULL, NULL);
    raster_close();
    return result;
}
