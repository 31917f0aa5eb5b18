/* The imaging subset: histogram and minmax (GL 1.5, 3.6.5). */
#include "api/imaging_test.h"

static void histograms(void **state)
{
    (void)state;
    struct image *const drawn = calloc(1, sizeof *drawn);
    enum { N = 16, PIXELS = 12 * 11 };
    GLuint expected[N][4] = {0}, got[N][4];
    draw_source(12, 11, drawn);
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 4; c++)
            expected[(int)floor(drawn->pixel[i][c] * (N - 1) + 0.5)][c]++;
    GLubyte pixels[PIXELS][4];
    EXPECT_NO_ERROR(glHistogram(GL_HISTOGRAM, N, GL_RGBA, GL_FALSE));
    glEnable(GL_HISTOGRAM);
    glReadPixels(0, 0, 12, 11, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    assert_memory_equal(pixels, source, sizeof pixels);
    glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_INT, got);
    assert_memory_equal(got, expected, sizeof got);

    /* Pixels that the window does not show are counted too: half of these. */
    glWindowPos2i(TEST_SIZE - 6, 0);
    glDrawPixels(12, 11, GL_RGBA, GL_UNSIGNED_BYTE, source);
    glGetHistogram(GL_HISTOGRAM, GL_TRUE, GL_RGBA, GL_UNSIGNED_INT, got);
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 4; c++)
            assert_int_equal(got[i][c], 2 * expected[i][c]);
    glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_INT, got);
    for (int i = 0; i < 4 * N; i++)
        assert_int_equal(got[i / 4][i % 4], 0);

    /* A sink lets nothing through; luminance counts red; counters are cut off at the type's greatest value. */
    EXPECT_NO_ERROR(glHistogram(GL_HISTOGRAM, 1, GL_LUMINANCE, GL_TRUE));
    memset(pixels, 0x55, sizeof pixels);
    for (int i = 0; i < 2; i++)
        glReadPixels(0, 0, 12, 11, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int i = 0; i < PIXELS; i++)
        assert_int_equal(pixels[i][i % 4], 0x55);
    GLubyte count[4];
    GLfloat exact[4];
    glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_BYTE, count);
    glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_FLOAT, exact);
    assert_int_equal(count[0], 255);
    assert_true(exact[0] == 2 * PIXELS && exact[1] == 0 && exact[3] == 0);
    EXPECT_NO_ERROR(glResetHistogram(GL_HISTOGRAM));
    EXPECT_FLOATS(glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_FLOAT, got_), 0, 0, 0, 0);
    EXPECT_FLOATS(glGetHistogramParameterfv(GL_HISTOGRAM, GL_HISTOGRAM_SINK, got_), GL_TRUE);
    EXPECT_FLOATS(glGetHistogramParameterfv(GL_HISTOGRAM, GL_HISTOGRAM_FORMAT, got_), GL_LUMINANCE);
    free(drawn);
}

static void histogram_errors(void **state)
{
    (void)state;
    GLfloat v[4];
    GLint i = -1;
    EXPECT_ERROR(GL_INVALID_ENUM, glHistogram(GL_MINMAX, 4, GL_RGBA, GL_FALSE));
    EXPECT_ERROR(GL_INVALID_ENUM, glHistogram(GL_HISTOGRAM, 4, GL_INTENSITY, GL_FALSE));
    EXPECT_ERROR(GL_INVALID_VALUE, glHistogram(GL_HISTOGRAM, 5, GL_RGBA, GL_FALSE));
    EXPECT_ERROR(GL_INVALID_VALUE, glHistogram(GL_HISTOGRAM, -4, GL_RGBA, GL_FALSE));
    EXPECT_ERROR(GL_TABLE_TOO_LARGE, glHistogram(GL_HISTOGRAM, 1 << 20, GL_RGBA, GL_FALSE));
    EXPECT_NO_ERROR(glHistogram(GL_PROXY_HISTOGRAM, 64, GL_RGB, GL_FALSE));
    glGetHistogramParameteriv(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH, &i);
    assert_int_equal(i, 64);
    EXPECT_NO_ERROR(glHistogram(GL_PROXY_HISTOGRAM, 1 << 20, GL_RGB, GL_FALSE));
    glGetHistogramParameteriv(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH, &i);
    assert_int_equal(i, 0);
    EXPECT_ERROR(GL_INVALID_ENUM, glGetHistogramParameterfv(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_SINK, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetHistogram(GL_PROXY_HISTOGRAM, GL_FALSE, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_DEPTH_COMPONENT, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glResetHistogram(GL_PROXY_HISTOGRAM));
    EXPECT_ERROR(GL_INVALID_ENUM, glMinmax(GL_HISTOGRAM, GL_RGBA, GL_FALSE));
    EXPECT_ERROR(GL_INVALID_ENUM, glMinmax(GL_MINMAX, GL_INTENSITY8, GL_FALSE));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetMinmax(GL_MINMAX, GL_FALSE, GL_COLOR_INDEX, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetMinmaxParameterfv(GL_MINMAX, GL_HISTOGRAM_SINK, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glResetMinmax(GL_HISTOGRAM));
}

static void minmax(void **state)
{
    (void)state;
    static const GLfloat pixels[3][4] = {{-2, .5f, .25f, 1}, {3, .75f, .25f, 0}, {0, 1, .5f, .5f}};
    EXPECT_FLOATS(glGetMinmax(GL_MINMAX, GL_FALSE, GL_RED, GL_FLOAT, got_), FLT_MAX, -FLT_MAX);
    glEnable(GL_MINMAX);
    glWindowPos2i(0, 0);
    glDrawPixels(3, 1, GL_RGBA, GL_FLOAT, pixels);
    EXPECT_FLOATS(glGetMinmax(GL_MINMAX, GL_TRUE, GL_RGBA, GL_FLOAT, got_), -2, .5f, .25f, 0, 3, 1, .5f, 1);
    EXPECT_FLOATS(glGetMinmax(GL_MINMAX, GL_FALSE, GL_RED, GL_FLOAT, got_), FLT_MAX, -FLT_MAX);
    EXPECT_NO_ERROR(glMinmax(GL_MINMAX, GL_LUMINANCE_ALPHA, GL_TRUE));
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawPixels(3, 1, GL_RGBA, GL_FLOAT, pixels);
    EXPECT_FLOATS(glGetMinmax(GL_MINMAX, GL_FALSE, GL_LUMINANCE_ALPHA, GL_FLOAT, got_), -2, 0, 3, 1);
    EXPECT_FLOATS(glGetMinmaxParameterfv(GL_MINMAX, GL_MINMAX_FORMAT, got_), GL_LUMINANCE_ALPHA);
    glDisable(GL_MINMAX);
    GLubyte drawn[4] = {1, 1, 1, 1};
    glReadPixels(1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, drawn);
    assert_int_equal(drawn[0], 0); /* the sink took the pixels */
    EXPECT_NO_ERROR(glResetMinmax(GL_MINMAX));
    EXPECT_FLOATS(glGetMinmax(GL_MINMAX, GL_FALSE, GL_LUMINANCE, GL_FLOAT, got_), FLT_MAX, -FLT_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(histograms),
            GL_TEST(histogram_errors),
            GL_TEST(minmax),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
