/* The row kernels (framebuffer/rows.h) against what their comments say, over all values where there are few enough. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "framebuffer/rows.h"

#include <math.h>
#include <stdlib.h>

enum { N = 4096 };

static void depths_are_quotients(void **state)
{
    static uint32_t depth[N];
    static float out[N];
    const uint32_t max[2] = {(1u << 24) - 1, (1u << 16) - 1};
    (void)state;
    for (int k = 0; k < 2; k++)
        for (uint32_t first = 0; first <= max[k]; first += N) {
            for (uint32_t i = 0; i < N; i++)
                depth[i] = first + i;
            fgl_row_kernels(ARITH_COMPATIBLE)->depth_to_float(depth, N, max[k], out);
            for (uint32_t i = 0; i < N; i++)
                if (out[i] != (float)((double)depth[i] / (double)max[k]))
                    fail_msg("%u / %u", depth[i], max[k]);
        }
}

static float awkward(int i)
{
    const float special[] = {0.0f, -0.0f, 1.0f, -1.0f, 2.0f, INFINITY, -INFINITY, NAN, 0.5f / 255.0f, 1.5f / 255.0f};
    if (i % 16 < 10)
        return special[i % 16];
    return (float)(rand() % 100000) / 80000.0f - 0.1f;
}

static void floats_become_bytes(void **state)
{
    static float color[4 * N], plane[4][N];
    static uint32_t together[N], apart[N];
    const float *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    (void)state;
    for (int i = 0; i < 4 * N; i++)
        plane[i % 4][i / 4] = color[i] = awkward(i + i / 4);
    fgl_row_kernels(ARITH_COMPATIBLE)->float_to_unorm8(color, N, together);
    fgl_row_kernels(ARITH_COMPATIBLE)->planes_to_unorm8(planes, N, apart);
    for (int i = 0; i < 4 * N; i++) {
        const uint32_t expected = fgl_unorm(color[i], 255.0f);
        assert_int_equal(together[i / 4] >> (8 * (i % 4)) & 255, expected);
        assert_int_equal(apart[i / 4] >> (8 * (i % 4)) & 255, expected);
    }
}

/* A byte passes through a float unchanged: what lets pixel rectangles of bytes go straight to the buffer. */
static void bytes_survive_floats(void **state)
{
    uint32_t pixel[256], back[256];
    float color[1024];
    (void)state;
    for (uint32_t i = 0; i < 256; i++)
        pixel[i] = i | (255 - i) << 8 | (i ^ 0x55) << 16 | (i ^ 0xaa) << 24;
    fgl_row_kernels(ARITH_COMPATIBLE)->unorm8_to_float(pixel, 256, color);
    for (int i = 0; i < 1024; i++)
        assert_true(color[i] == (float)(pixel[i / 4] >> (8 * (i % 4)) & 255) * (1.0f / 255.0f));
    fgl_row_kernels(ARITH_COMPATIBLE)->float_to_unorm8(color, 256, back);
    assert_memory_equal(pixel, back, sizeof pixel);
}

static int16_t cut(float v)
{
    return v > -2147483648.0f && v < 2147483648.0f ? (int16_t)(uint16_t)(int32_t)v : 0;
}

static void accumulation_cuts_and_wraps(void **state)
{
    static const float scale[] = {0.5f, 32767.0f, -40000.0f, 1e9f, INFINITY, NAN};
    static float color[4 * N];
    static int16_t accum[4 * N], sum[4 * N], product[4 * N];
    static uint32_t pixel[N];
    const struct row_kernels *k = fgl_row_kernels(ARITH_COMPATIBLE);
    (void)state;
    for (int i = 0; i < 4 * N; i++) {
        color[i] = awkward(i);
        accum[i] = sum[i] = product[i] = (int16_t)(rand() % 65536 - 32768);
    }
    for (int s = 0; s < 6; s++) {
        for (int i = 0; i < 4 * N; i++)
            sum[i] = product[i] = accum[i];
        k->accumulate(sum, color, N, scale[s], true);
        k->accum_multiply(product, N, scale[s]);
        k->accum_to_unorm8(accum, N, scale[s] / 32767.0f, pixel);
        for (int i = 0; i < 4 * N; i++) {
            assert_int_equal(sum[i], (int16_t)(accum[i] + cut(color[i] * scale[s])));
            assert_int_equal(product[i], cut((float)accum[i] * scale[s]));
            assert_int_equal(pixel[i / 4] >> (8 * (i % 4)) & 255,
                             fgl_unorm((float)accum[i] * (scale[s] / 32767.0f), 255.0f));
        }
        k->accumulate(sum, color, N, scale[s], false);
        for (int i = 0; i < 4 * N; i++)
            assert_int_equal(sum[i], cut(color[i] * scale[s]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depths_are_quotients),
        cmocka_unit_test(floats_become_bytes),
        cmocka_unit_test(bytes_survive_floats),
        cmocka_unit_test(accumulation_cuts_and_wraps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
