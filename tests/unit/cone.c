/* The edge of a spot's cone: decided right for vertices that miss it by less than double can tell. */
#include "unit.h"

#include "vertex/cone.h"

/* c * c as a pair, and its distance from a fraction. */
static double off_square(struct pair c, double square)
{
    const struct pair difference = pair_sum(pair_multiply(c, c), pair_of(-square));
    return fabs(difference.hi);
}

/* 4 cos^2 - 2 = 2 cos 2x: the roots of 3 and 2. */
static struct pair twice_cosine_of_twice(float cutoff)
{
    const struct pair square = fgl_cone_cos_square(cutoff);
    return pair_sum((struct pair){4 * square.hi, 4 * square.lo}, pair_of(-2));
}

static void squares_of_cosines(void **state)
{
    (void)state;
    assert_true(fgl_cone_cos_square(0).hi == 1 && fgl_cone_cos_square(90).hi == 0);
    assert_true(fgl_cone_cos_square(60).hi == 0.25 && fgl_cone_cos_square(60).lo == 0);
    assert_true(fgl_cone_cos_square(45).hi == 0.5 && fgl_cone_cos_square(30).hi == 0.75);
    assert_true(off_square(twice_cosine_of_twice(15), 3) < 1e-29);
    assert_true(off_square(twice_cosine_of_twice(75), 3) < 1e-29);
    assert_true(off_square(twice_cosine_of_twice(22.5f), 2) < 1e-29);
    assert_true(off_square(twice_cosine_of_twice(67.5f), 2) < 1e-29);
    const struct pair near_90 = fgl_cone_cos_square(89.999f);
    assert_true(near_90.hi > 3.0e-10 && near_90.hi < 3.1e-10);
}

static bool contains(double x, double y, double z, float cutoff)
{
    const double light[3] = {0, 0, 0}, vertex[3] = {x, y, z}, axis[3] = {1, 1, 0};
    return fgl_cone_contains(light, vertex, axis, fgl_cone_cos_square(cutoff));
}

/* About (1, 1, 0) the cone of 60 degrees is 2 (x + y)^2 = x^2 + y^2 + z^2: with integers, in integers. */
static void lattice_points_about_the_edge(void **state)
{
    (void)state;
    int near = 0;
    for (int64_t y = 0; y < 3000; y++) {
        const int64_t x = (1 << 26) - 31 * y, square = x * x + 4 * x * y + y * y;
        int64_t z = (int64_t)sqrt((double)square) - 2;
        for (int k = 0; k < 5; k++, z++) {
            assert_int_equal(contains((double)x, (double)y, (double)z, 60), z * z <= square);
            near += (z * z < square ? square - z * z : z * z - square) < 1 << 12; /* cosines apart by 2^-43 */
        }
    }
    assert_true(near > 0);
    assert_true(contains(1, 0, 1, 60) && contains(0x1p26, 0, 0x1p26, 60));
    assert_false(contains(1, 0, 1 + 0x1p-52, 60));
    assert_true(contains(1, 0, 1 - 0x1p-52, 60));
}

static void special_cases(void **state)
{
    (void)state;
    assert_true(contains(2, 2, 0, 0));
    assert_false(contains(2, 2, 1e-14, 0));
    assert_true(contains(1, -1, 5, 90));
    assert_false(contains(1, -1 - 0x1p-52, 5, 90));
    assert_false(contains(0, 0, 0, 60)); /* a zero vector has the cosine 0 */
    assert_true(contains(0, 0, 0, 90));
    assert_false(contains(-1, 0, 1, 60));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(squares_of_cosines),
                                       cmocka_unit_test(lattice_points_about_the_edge),
                                       cmocka_unit_test(special_cases)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
