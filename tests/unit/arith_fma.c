/* fgl_fma and its emulation against the C library's fmaf, which is correctly rounded. */
#include "unit.h"

#include "base/arith.h"

static const uint32_t edge[] = {0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x007fffff,
                                0x00800000, 0x00800001, 0x3f800000, 0x3f800001, 0x3f7fffff,
                                0xbf800000, 0x4b800000, 0x7f7fffff, 0xff7fffff, 0x7f800000,
                                0xff800000, 0x7fc00000, 0x33800000, 0xb3800001, 0x1f000001};
enum { EDGES = sizeof edge / sizeof *edge };

static void check(float a, float b, float c)
{
    const float expected = fmaf(a, b, c), emulated = fgl_fma_emulated(a, b, c), used = fgl_fma(a, b, c);

    if (!same_float(emulated, expected) || !same_float(used, expected))
        fail_msg("fma(%a, %a, %a): %a, emulated %a, used %a", (double)a, (double)b, (double)c,
                 (double)expected, (double)emulated, (double)used);
}

static void edges_are_exact(void **state)
{
    (void)state;
    for (int i = 0; i < EDGES; i++)
        for (int j = 0; j < EDGES; j++)
            for (int k = 0; k < EDGES; k++)
                check(fgl_bits_float(edge[i]), fgl_bits_float(edge[j]), fgl_bits_float(edge[k]));
}

/* Any bits; ordinary numbers; short ones, whose sums come near to ties; and sums that cancel. */
static float operand(int kind)
{
    const uint32_t bits = random_bits();

    switch (kind) {
    case 0: return fgl_bits_float(bits);
    case 1: return fgl_bits_float(edge[bits % EDGES]);
    case 2: return fgl_bits_float((bits & 0xfffff000) % 0x10000000 + 0x38000000);
    default: return between(-4, 4);
    }
}

static void random_operands_are_exact(void **state)
{
    (void)state;
    random_seed(0);
    for (int i = 0; i < 3000000; i++) {
        const float a = operand(one_of(6)), b = operand(one_of(6)), c = operand(one_of(6));
        check(a, b, one_of(3) ? c : -(a * b) * (1.0f + (float)one_of(3) * 1e-7f));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_exact),
                                       cmocka_unit_test(random_operands_are_exact)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
