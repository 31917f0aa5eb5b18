/* Planes that are evaluated without the emulation of fused multiply-add (is_plain in fragment/group.h), against the C library's fmaf. */
#define FGL_ARITH_COMPATIBLE
#include "unit.h"

#include "fragment/group.h"

enum { PLANES = 400000, LARGEST = 16384 + 64 };

/* A number with an exponent around `exponent`; at times 0, at times with few bits. */
static float number(int exponent)
{
    const float v = ldexpf(between(1, 2), exponent + one_of(16) - 8);
    const float cut = one_of(4) ? v : ldexpf(1, exponent + one_of(16));
    return one_of(10) ? (one_of(2) ? cut : -cut) : 0;
}

/* The sum with a00 comes as near as it can to the middle between two floats. */
static struct plane near_a_tie(int x)
{
    const float half_step = ldexpf(1, -24);
    return (struct plane){1 + ldexpf((float)one_of(4), -22), half_step / (float)x, one_of(2) ? 0 : ldexpf(1, -one_of(60))};
}

static void plain_values_are_exact(void **state)
{
    int plain = 0;
    (void)state;
    random_seed(0);
    for (int i = 0; i < PLANES; i++) {
        const int x = 1 + one_of(LARGEST - 1), y = one_of(LARGEST), far = one_of(40) - 20;
        const struct plane plane = one_of(2) ? near_a_tie(x) : (struct plane){number(0), number(far), number(far + one_of(20) - 10)};
        const float expected = fmaf(plane.dady, (float)y, fmaf(plane.dadx, (float)x, plane.a00));
        const bool is = is_plain(plane);
        plain += is;
        if (!same_float(value_if(is, plane, (float)x, (float)y), expected))
            fail_msg("%s plane %a %a %a at %d %d", is ? "plain" : "other", (double)plane.a00, (double)plane.dadx, (double)plane.dady, x, y);
    }
    if (FGL_FMA_EMULATED) /* both ways were tried */
        assert_in_range(plain, PLANES / 20, PLANES - PLANES / 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(plain_values_are_exact)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
