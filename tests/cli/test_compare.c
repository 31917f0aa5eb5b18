/* The comparison behind `fixedgl diff`: every kind of difference is counted where it belongs, once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../../src/cli/compare.h"

enum { WIDTH = 5, HEIGHT = 4, PIXELS = WIDTH * HEIGHT, FAR = 0xffffff };

struct pair {
    uint8_t rgba[2][4 * PIXELS];
    uint32_t depth[2][PIXELS];
    struct image a, b;
};

/* Two identical pictures: a gray scene on all pixels but the last row, which nothing drew on. */
static void make_pair(struct pair *pair)
{
    for (int side = 0; side < 2; side++) {
        memset(pair->rgba[side], 100, sizeof pair->rgba[side]);
        for (int i = 0; i < PIXELS; i++)
            pair->depth[side][i] = i < PIXELS - WIDTH ? 1000u + (uint32_t)i : FAR;
    }
    pair->a = (struct image){WIDTH, HEIGHT, pair->rgba[0], pair->depth[0], 24, ""};
    pair->b = (struct image){WIDTH, HEIGHT, pair->rgba[1], pair->depth[1], 24, ""};
}

static struct difference compare(const struct pair *pair)
{
    struct difference difference;
    struct problem problem;
    assert_true(fgl_compare_images(&pair->a, &pair->b, &difference, &problem));
    assert_int_equal(difference.pixels, PIXELS);
    return difference;
}

static void assert_counts(struct difference d, long differ, long by_1, long by_2_to_8, long by_more,
                          long coverage, long depth)
{
    assert_int_equal(d.differ, differ);
    assert_int_equal(d.by_1, by_1);
    assert_int_equal(d.by_2_to_8, by_2_to_8);
    assert_int_equal(d.by_more, by_more);
    assert_int_equal(d.coverage, coverage);
    assert_int_equal(d.depth, depth);
}

static void test_identical(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    const struct difference d = compare(&pair);
    assert_counts(d, 0, 0, 0, 0, 0, 0);
    assert_int_equal(d.first_x, -1);
    assert_int_equal(d.first_y, -1);
}

/* The classes meet between 1 and 2 and between 8 and 9, and the sign does not matter. */
static void test_color_classes(void **state)
{
    (void)state;
    static const struct {
        int change;
        long by_1, by_2_to_8, by_more;
    } rows[] = {{1, 1, 0, 0},  {-1, 1, 0, 0}, {2, 0, 1, 0},  {5, 0, 1, 0},   {8, 0, 1, 0},
                {-8, 0, 1, 0}, {9, 0, 0, 1},  {-9, 0, 0, 1}, {155, 0, 0, 1}, {-100, 0, 0, 1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        for (int channel = 0; channel < 4; channel++) {
            struct pair pair;
            make_pair(&pair);
            pair.rgba[1][4 * 7 + channel] = (uint8_t)(100 + rows[i].change);
            const struct difference d = compare(&pair);
            assert_counts(d, 1, rows[i].by_1, rows[i].by_2_to_8, rows[i].by_more, 0, 0);
            assert_int_equal(d.largest_channel, rows[i].change < 0 ? -rows[i].change : rows[i].change);
            assert_int_equal(d.first_x, 7 % WIDTH);
            assert_int_equal(d.first_y, 7 / WIDTH);
        }
    }
}

static void test_largest_channel_decides(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.rgba[1][0] = 101;
    pair.rgba[1][1] = 105;
    pair.rgba[1][2] = 120;
    assert_counts(compare(&pair), 1, 0, 0, 1, 0, 0);
}

static void test_full_range(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.rgba[0][2] = 0;
    pair.rgba[1][2] = 255;
    assert_int_equal(compare(&pair).largest_channel, 255);
}

static void test_depth_alone(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.depth[0][3] += 1;
    pair.depth[1][4] += 70;
    const struct difference d = compare(&pair);
    assert_counts(d, 2, 0, 0, 0, 0, 2);
    assert_int_equal(d.largest_depth, 70);
    assert_int_equal(d.first_x, 3);
    assert_int_equal(d.first_y, 0);
}

/* Drawn in one picture only, either way round, is coverage as well as depth. */
static void test_coverage(void **state)
{
    (void)state;
    for (int side = 0; side < 2; side++) {
        struct pair pair;
        make_pair(&pair);
        pair.depth[side][PIXELS - 1] = 5;
        pair.rgba[side][4 * (PIXELS - 1)] = 101;
        const struct difference d = compare(&pair);
        assert_counts(d, 1, 1, 0, 0, 1, 1);
        assert_int_equal(d.first_x, WIDTH - 1);
        assert_int_equal(d.first_y, HEIGHT - 1);
    }
}

/* What counts as far follows the depth bits: 16777215 is an ordinary value of 32 bits. */
static void test_far_of_32_bits(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.a.depth_bits = pair.b.depth_bits = 32;
    pair.depth[0][PIXELS - 1] = 5;
    assert_counts(compare(&pair), 1, 0, 0, 0, 0, 1);
    pair.depth[1][0] = UINT32_MAX;
    assert_counts(compare(&pair), 2, 0, 0, 0, 1, 2);
}

static void test_far_of_16_bits(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.a.depth_bits = pair.b.depth_bits = 16;
    pair.depth[1][0] = 0xffff;
    assert_counts(compare(&pair), 1, 0, 0, 0, 1, 1);
}

static void test_without_depth(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    pair.a.depth = pair.b.depth = NULL;
    pair.a.depth_bits = pair.b.depth_bits = 0;
    pair.rgba[1][4 * 19] = 99;
    assert_counts(compare(&pair), 1, 1, 0, 0, 0, 0);
}

static void test_all_pixels_counted(void **state)
{
    (void)state;
    struct pair pair;
    make_pair(&pair);
    for (int i = 0; i < PIXELS; i++) {
        pair.rgba[1][4 * i + 3] = 103;
        pair.depth[1][i] -= 1;
    }
    assert_counts(compare(&pair), PIXELS, 0, PIXELS, 0, WIDTH, PIXELS);
}

static void test_refused(void **state)
{
    (void)state;
    struct difference difference;
    struct problem problem;
    struct pair pair;
    make_pair(&pair);
    pair.b.width = HEIGHT;
    pair.b.height = WIDTH;
    assert_false(fgl_compare_images(&pair.a, &pair.b, &difference, &problem));
    assert_string_equal(problem.text, "FixedGL drew 5x4, the reference 4x5");
    assert_int_equal(difference.differ, 0);
    make_pair(&pair);
    pair.b.depth = NULL;
    pair.b.depth_bits = 0;
    assert_false(fgl_compare_images(&pair.a, &pair.b, &difference, &problem));
    assert_string_equal(problem.text, "FixedGL has 24 bits of depth, the reference 0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_identical),
            cmocka_unit_test(test_color_classes),
            cmocka_unit_test(test_largest_channel_decides),
            cmocka_unit_test(test_full_range),
            cmocka_unit_test(test_depth_alone),
            cmocka_unit_test(test_coverage),
            cmocka_unit_test(test_far_of_32_bits),
            cmocka_unit_test(test_far_of_16_bits),
            cmocka_unit_test(test_without_depth),
            cmocka_unit_test(test_all_pixels_counted),
            cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
