/* The imaging subset: convolution (GL 1.5, 3.6.5). */
#include "api/imaging_test.h"

static void convolution_2d(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {3, 3}, {2, 5}, {4, 1}, {1, 7}, {8, 6}};
    struct image *const drawn = calloc(1, sizeof *drawn), *const truth = calloc(1, sizeof *truth);
    draw_source(11, 8, drawn);
    glEnable(GL_CONVOLUTION_2D);
    glConvolutionParameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, border_color);
    for (int s = 0; s < 6; s++)
        for (int b = 0; b < 6; b++)
            for (int m = 0; m < 3; m++) {
                const int w = sizes[s][0], h = sizes[s][1];
                make_weights(w * h);
                EXPECT_NO_ERROR(glConvolutionFilter2D(GL_CONVOLUTION_2D, bases[b], w, h, GL_RGBA, GL_FLOAT, given_weights));
                EXPECT_NO_ERROR(glConvolutionParameteri(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_MODE, (GLint)modes[m]));
                *truth = *drawn;
                true_convolution(truth, bases[b], (const double(*)[4])weights, w, h, modes[m], true_border);
                EXPECT_READ(11, 8, truth);
            }
    free(drawn);
    free(truth);
}

static void separable_filters(void **state)
{
    (void)state;
    enum { W = 4, H = 3 };
    static const double scale[4] = {.5, 2, 1, -1}, bias[4] = {.125, 0, -.5, 1};
    struct image *const drawn = calloc(1, sizeof *drawn), *const truth = calloc(1, sizeof *truth);
    GLfloat row[W][4], column[H][4];
    draw_source(10, 9, drawn);
    make_table(row, W);
    make_table(column, H);
    glEnable(GL_SEPARABLE_2D);
    for (int c = 0; c < 4; c++) {
        glPixelTransferf(GL_POST_CONVOLUTION_RED_SCALE + (GLenum)c, (GLfloat)scale[c]);
        glPixelTransferf(GL_POST_CONVOLUTION_RED_BIAS + (GLenum)c, (GLfloat)bias[c]);
    }
    glConvolutionParameterfv(GL_SEPARABLE_2D, GL_CONVOLUTION_BORDER_COLOR, border_color);
    for (int b = 0; b < 6; b++)
        for (int m = 0; m < 3; m++) {
            EXPECT_NO_ERROR(glSeparableFilter2D(GL_SEPARABLE_2D, bases[b], W, H, GL_RGBA, GL_FLOAT, row, column));
            glConvolutionParameterf(GL_SEPARABLE_2D, GL_CONVOLUTION_BORDER_MODE, (GLfloat)modes[m]);
            for (int i = 0; i < W * H; i++)
                for (int c = 0; c < 4; c++)
                    weights[i][c] = (double)row[i % W][c] * (double)column[i / W][c];
            *truth = *drawn;
            true_convolution(truth, bases[b], (const double(*)[4])weights, W, H, modes[m], true_border);
            true_scale_bias(truth, scale, bias);
            EXPECT_READ(10, 9, truth);
        }
    glDisable(GL_SEPARABLE_2D);
    EXPECT_READ(10, 9, drawn); /* scale and bias belong to convolution */
    GLfloat got_row[W][4], got_column[H][4];
    glGetSeparableFilter(GL_SEPARABLE_2D, GL_RGBA, GL_FLOAT, got_row, got_column, NULL);
    assert_memory_equal(got_row, row, sizeof row);
    assert_memory_equal(got_column, column, sizeof column);
    free(drawn);
    free(truth);
}

static void filter_state_and_errors(void **state)
{
    (void)state;
    static const GLfloat filter[3] = {.25f, -.5f, 2}, scale[4] = {2, 2, 2, 2}, bias[4] = {1, 1, 1, 1};
    static const GLint white[4] = {2147483647, 2147483647, 2147483647, 2147483647};
    GLfloat v[32 * 4];
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_MODE, got_), GL_REDUCE);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, got_), 0, 0, 0, 0);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_SEPARABLE_2D, GL_CONVOLUTION_FORMAT, got_), GL_RGBA);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_SEPARABLE_2D, GL_CONVOLUTION_WIDTH, got_), 0);
    glConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_FILTER_SCALE, scale);
    glConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_FILTER_BIAS, bias);
    EXPECT_NO_ERROR(glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_LUMINANCE16, 3, GL_LUMINANCE, GL_FLOAT, filter));
    EXPECT_FLOATS(glGetConvolutionFilter(GL_CONVOLUTION_1D, GL_LUMINANCE, GL_FLOAT, got_), 1.5f, 0, 5);
    EXPECT_FLOATS(glGetConvolutionFilter(GL_CONVOLUTION_1D, GL_RGBA, GL_FLOAT, got_), 1.5f, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_FORMAT, got_), GL_LUMINANCE16);
    glConvolutionParameteriv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, white);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, got_), 1, 1, 1, 1);

    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionFilter1D(GL_CONVOLUTION_2D, GL_RGBA, 3, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionFilter2D(GL_CONVOLUTION_1D, GL_RGBA, 3, 3, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glSeparableFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 3, 3, GL_RGBA, GL_FLOAT, v, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionFilter1D(GL_CONVOLUTION_1D, 3, 3, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 3, GL_DEPTH_COMPONENT, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_VALUE, glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, -1, GL_RGBA, GL_FLOAT, v));
    GLint max = 0;
    glGetConvolutionParameteriv(GL_CONVOLUTION_2D, GL_MAX_CONVOLUTION_HEIGHT, &max);
    assert_true(max >= 3);
    EXPECT_ERROR(GL_INVALID_VALUE, glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 1, max + 1, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionParameteri(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_MODE, GL_REPEAT));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionParameterf(GL_CONVOLUTION_2D, GL_CONVOLUTION_FILTER_SCALE, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glConvolutionParameterfv(GL_COLOR_TABLE, GL_CONVOLUTION_FILTER_SCALE, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetConvolutionFilter(GL_SEPARABLE_2D, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetConvolutionParameterfv(GL_CONVOLUTION_2D, GL_MINMAX_SINK, v));
}

static void copied_filters(void **state)
{
    (void)state;
    struct image *const drawn = calloc(1, sizeof *drawn);
    GLfloat got[6][4];
    draw_source(8, 3, drawn);
    EXPECT_NO_ERROR(glCopyConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 1, 1, 3, 2));
    glGetConvolutionFilter(GL_CONVOLUTION_2D, GL_RGBA, GL_FLOAT, got);
    for (int i = 0; i < 6; i++)
        EXPECT_NEAR((double)got[i][1], drawn->pixel[8 * (1 + i / 3) + 1 + i % 3][1], 1e-6);
    EXPECT_NO_ERROR(glCopyConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 2, 0, 6));
    glGetConvolutionFilter(GL_CONVOLUTION_1D, GL_RGBA, GL_FLOAT, got);
    for (int i = 0; i < 6; i++)
        EXPECT_NEAR((double)got[i][2], drawn->pixel[2 + i][2], 1e-6);
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyConvolutionFilter2D(GL_SEPARABLE_2D, GL_RGBA, 1, 1, 3, 2));
    free(drawn);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(convolution_2d),
            GL_TEST(separable_filters),
            GL_TEST(filter_state_and_errors),
            GL_TEST(copied_filters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
