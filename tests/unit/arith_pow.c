/* The powers of the compatible arithmetic: known values of OSMesa's polynomials, their error bounds, and the
 * ends of their range. */
#include "unit.h"

#include "base/arith.h"

static void known_values(void **state)
{
    (void)state;
    assert_true(same_float(r_pow(0.9f, 50.0f),
                           0x1.51c1aep-8f)); /* OSMesa's; rounded correctly it is 0x1.51c1e2p-8 */
    assert_true(same_float(r_exp2(0), 1));
    assert_true(same_float(r_exp2(-3), 0.125f));
    assert_true(same_float(r_log2(1), 0));
    assert_true(same_float(r_log2(8), 3));
}

static void errors_are_bounded(void **state)
{
    (void)state;
    random_seed(0);
    for (int i = 0; i < 1000000; i++) {
        const float x = between(-126, 127), y = ldexpf(between(1, 2), one_of(250) - 125),
                    base = between(0, 1), e = between(0, 128);
        assert_true(fabs((double)r_exp2(x) / exp2((double)x) - 1) < 2.6e-7);
        assert_true(fabs((double)r_log2(y) - log2((double)y)) < 9.5e-7 + fabs(log2((double)y)) * 6e-8);
        assert_true(fabs((double)r_pow(base, e) - pow((double)base, (double)e)) < 1.5e-5);
    }
}

static void ends_of_the_range(void **state)
{
    (void)state;
    assert_true(same_float(r_exp2(-127), 0));
    assert_true(same_float(r_exp2(-INFINITY), 0));
    assert_true(same_float(r_exp2(NAN), 0));
    assert_true(r_exp2(128) > 3.4e38f && isfinite(r_exp2(128)));
    assert_true(isfinite(r_exp2(INFINITY)));
    assert_true(same_float(r_pow(0, 0), 1));
    assert_true(same_float(r_pow(-1, 0), 1));
    assert_true(same_float(r_pow(0, 5), 0));
    assert_true(same_float(r_pow(-1, 2), 0));
    assert_true(same_float(r_pow(NAN, 2), 0));
    assert_true(same_float(r_pow(1, 128), 1));
    assert_true(isfinite(r_pow(40, 128))); /* so that a product with zero stays zero */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(known_values), cmocka_unit_test(errors_are_bounded),
                                       cmocka_unit_test(ends_of_the_range)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
