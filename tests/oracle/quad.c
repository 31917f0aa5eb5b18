/* The oracle's own arithmetic: known values, identities, the whole range of exponents. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "oracle/quad.h"

/* 2^-105, the promise of quad.h. */
static const double bound = 0x1p-105;

static void assert_near(quad value, quad truth)
{
    const quad error = value < truth ? truth - value : value - truth;
    const quad size = truth < 0 ? -truth : truth;
    if (!(error <= size * (quad)bound))
        fail_msg("%.17g differs from %.17g by %g", (double)value, (double)truth, (double)error);
}

/* The digits after the decimal point, in two integers of 17 digits each. */
static quad decimal(int whole, int64_t first, int64_t second)
{
    const quad ten17 = (quad)100000000000000000;
    return (quad)whole + ((quad)first + (quad)second / ten17) / ten17;
}

static void test_sqrt(void **state)
{
    (void)state;
    assert_near(quad_sqrt(2), decimal(1, 41421356237309504, 88016887242096981));
    assert_near(quad_sqrt(3), decimal(1, 73205080756887729, 35274463415058724));
    for (quad x = (quad)0x1p-1000 * (quad)0x1p-1000; x < (quad)0x1p1000; x *= 3) {
        const quad root = quad_sqrt(x);
        assert_near(root * root, x);
    }
    assert_true(quad_sqrt(0) == 0);
}

static void test_log2(void **state)
{
    (void)state;
    assert_near(quad_log2(3), decimal(1, 58496250072115618, 14537389439478165));
    assert_near(quad_log2(10), decimal(3, 32192809488736234, 78703194294893901));
    assert_true(quad_log2(1) == 0);
    for (int e = -1000; e <= 1000; e += 125) {
        const quad x = quad_exp2(e);
        assert_true(quad_log2(x) == e);
        assert_near(quad_log2(x * 7), e + quad_log2(7));
    }
}

static void test_exp2(void **state)
{
    (void)state;
    assert_near(quad_exp2((quad)1 / 2), quad_sqrt(2));
    assert_near(quad_exp2((quad)1 / 3), decimal(1, 25992104989487316, 47672106072782283));
    assert_near(quad_exp2(-(quad)37 / 8) * quad_exp2((quad)37 / 8), 1);
    assert_true(quad_exp2(-20000) == 0);
    assert_true(quad_exp2(-3) == (quad)1 / 8);
    for (int k = -300; k <= 300; k++) { /* 2^(k/7) to the 7th is 2^k */
        const quad root = quad_exp2((quad)k / 7), square = root * root;
        assert_near(square * square * square * root, quad_exp2(k));
    }
}

static void test_pow(void **state)
{
    (void)state;
    assert_near(quad_pow((quad)9 / 10, 50) * quad_pow((quad)10 / 9, 50), 1);
    quad product = 1;
    for (int n = 0; n <= 128; n++, product *= (quad)0.7f)
        assert_near(quad_pow((quad)0.7f, n), product);
    assert_near(quad_pow((quad)1e-30f, (quad)1 / 2), quad_sqrt((quad)1e-30f));
    assert_true(quad_pow(0, 0) == 1);
    assert_true(quad_pow(0, 3) == 0);
}

static void test_cos(void **state)
{
    (void)state;
    assert_near(quad_cos_degrees(60), (quad)1 / 2);
    assert_near(quad_cos_degrees(120), -(quad)1 / 2);
    assert_near(quad_cos_degrees(45), quad_sqrt(2) / 2);
    assert_near(quad_cos_degrees(36), (1 + quad_sqrt(5)) / 4);
    assert_true(quad_cos_degrees(0) == 1);
    const quad right = quad_cos_degrees(90);
    assert_true(right < (quad)bound && -right < (quad)bound);
    for (int degrees = 1; degrees < 90; degrees++) { /* cos^2 a + cos^2 (90 - a) = 1 */
        const quad c = quad_cos_degrees(degrees), s = quad_cos_degrees(90 - degrees);
        assert_near(c * c + s * s, 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_sqrt), cmocka_unit_test(test_log2), cmocka_unit_test(test_exp2),
            cmocka_unit_test(test_pow),  cmocka_unit_test(test_cos),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
