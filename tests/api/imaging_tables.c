/* The imaging subset: colour tables (GL 1.5, 3.6.3) and the colour matrix. */
#include "api/imaging_test.h"

/* ---- color tables ---- */

static void tables_of_every_format(void **state)
{
    (void)state;
    struct image *const drawn = calloc(1, sizeof *drawn), *const truth = calloc(1, sizeof *truth);
    GLfloat table[256][4];
    draw_source(13, 7, drawn);
    for (int t = 0; t < 3; t++)
        for (int b = 0; b < 6; b++)
            for (int n = 1; n <= 256; n *= 4) {
                make_table(table, n);
                EXPECT_NO_ERROR(glColorTable(tables[t], bases[b], n, GL_RGBA, GL_FLOAT, table));
                glEnable(tables[t]);
                *truth = *drawn;
                true_lookup(truth, bases[b], (const GLfloat(*)[4])table, n);
                EXPECT_READ(13, 7, truth);
                glDisable(tables[t]);
            }
    EXPECT_READ(13, 7, drawn);
    glEnable(GL_COLOR_TABLE);
    EXPECT_NO_ERROR(glColorTable(GL_COLOR_TABLE, GL_RGBA, 0, GL_RGBA, GL_FLOAT, table));
    EXPECT_READ(13, 7, drawn); /* an empty table changes nothing */
    free(drawn);
    free(truth);
}

static void tables_are_scaled_clamped_and_returned(void **state)
{
    (void)state;
    static const GLfloat given[2][4] = {{.25f, .5f, .75f, 1}, {1, 0, .5f, .25f}}, scale[4] = {2, -1, 1, .5f}, bias[4] = {0, .5f, .5f, .25f};
    static const GLint integers[4] = {2, 0, 1, 1};
    GLfloat got[8];
    glColorTableParameterfv(GL_POST_CONVOLUTION_COLOR_TABLE, GL_COLOR_TABLE_SCALE, scale);
    glColorTableParameterfv(GL_POST_CONVOLUTION_COLOR_TABLE, GL_COLOR_TABLE_BIAS, bias);
    EXPECT_NO_ERROR(glColorTable(GL_POST_CONVOLUTION_COLOR_TABLE, GL_RGBA8, 2, GL_RGBA, GL_FLOAT, given));
    glGetColorTable(GL_POST_CONVOLUTION_COLOR_TABLE, GL_RGBA, GL_FLOAT, got);
    for (int i = 0; i < 8; i++)
        EXPECT_NEAR((double)got[i], clamp01((double)given[i / 4][i % 4] * (double)scale[i % 4] + (double)bias[i % 4]), 1e-6);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_POST_CONVOLUTION_COLOR_TABLE, GL_COLOR_TABLE_SCALE, got_), 2, -1, 1, .5f);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, got_), 1, 1, 1, 1);
    glColorTableParameteriv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, integers);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, got_), 2, 0, 1, 1);

    EXPECT_NO_ERROR(glColorSubTable(GL_POST_CONVOLUTION_COLOR_TABLE, 1, 1, GL_RGBA, GL_FLOAT, given));
    EXPECT_FLOATS(glGetColorTable(GL_POST_CONVOLUTION_COLOR_TABLE, GL_RGBA, GL_FLOAT, got_), .5f, 0, 1, .75f, .5f, 0, 1, .75f);
    EXPECT_NO_ERROR(glColorTable(GL_COLOR_TABLE, GL_LUMINANCE, 2, GL_RGBA, GL_FLOAT, given));
    EXPECT_FLOATS(glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_FLOAT, got_), .5f, 0, 0, 0, 1, 0, 0, 0);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_FORMAT, got_), GL_LUMINANCE);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, got_), 2);
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_RED_SIZE, got_), 0);
    GLint bits = 0;
    glGetColorTableParameteriv(GL_COLOR_TABLE, GL_COLOR_TABLE_LUMINANCE_SIZE, &bits);
    assert_true(bits >= 8);
}

static void table_errors_and_proxies(void **state)
{
    (void)state;
    GLfloat v[4096 * 4] = {0};
    GLint i = -1;
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTable(GL_HISTOGRAM, GL_RGBA, 2, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTable(GL_COLOR_TABLE, 4, 2, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTable(GL_COLOR_TABLE, GL_DEPTH_COMPONENT, 2, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_COLOR_INDEX, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_RGBA, GL_BITMAP, v));
    EXPECT_ERROR(GL_INVALID_OPERATION, glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, v));
    EXPECT_ERROR(GL_INVALID_VALUE, glColorTable(GL_COLOR_TABLE, GL_RGBA, 3, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_VALUE, glColorTable(GL_COLOR_TABLE, GL_RGBA, -1, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_TABLE_TOO_LARGE, glColorTable(GL_COLOR_TABLE, GL_RGBA, 1 << 20, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA, 0, 0, 2));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorSubTable(GL_PROXY_COLOR_TABLE, 0, 0, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTableParameterfv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_SCALE, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetColorTableParameterfv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_SCALE, v));

    EXPECT_NO_ERROR(glColorTable(GL_COLOR_TABLE, GL_RGBA, 32, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_VALUE, glColorSubTable(GL_COLOR_TABLE, 31, 2, GL_RGBA, GL_FLOAT, v));
    EXPECT_ERROR(GL_INVALID_VALUE, glColorSubTable(GL_COLOR_TABLE, -1, 2, GL_RGBA, GL_FLOAT, v));
    EXPECT_NO_ERROR(glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB, 64, GL_RGBA, GL_FLOAT, NULL));
    glGetColorTableParameteriv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &i);
    assert_int_equal(i, 64);
    EXPECT_NO_ERROR(glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB, 1 << 20, GL_RGBA, GL_FLOAT, NULL));
    glGetColorTableParameteriv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &i);
    assert_int_equal(i, 0);
    glGetColorTableParameteriv(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &i);
    assert_int_equal(i, 32);
}

static void copied_tables(void **state)
{
    (void)state;
    struct image *const drawn = calloc(1, sizeof *drawn);
    GLfloat got[8][4];
    draw_source(8, 2, drawn);
    EXPECT_NO_ERROR(glCopyColorTable(GL_COLOR_TABLE, GL_RGBA, 0, 1, 8));
    EXPECT_NO_ERROR(glCopyColorSubTable(GL_COLOR_TABLE, 2, 0, 0, 3));
    glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_FLOAT, got);
    for (int i = 0; i < 8; i++)
        for (int c = 0; c < 4; c++)
            EXPECT_NEAR((double)got[i][c], drawn->pixel[i >= 2 && i < 5 ? i - 2 : 8 + i][c], 1e-6);
    free(drawn);
}

/* ---- the color matrix ---- */

static void color_matrix(void **state)
{
    (void)state;
    static const double scale[4] = {2, .5, -1, 1}, bias[4] = {.25, 0, 1, -.5};
    struct image *const truth = calloc(1, sizeof *truth);
    GLfloat m[16], got[16];
    draw_source(9, 5, truth);
    random_matrix(m);
    EXPECT_INTS(GL_COLOR_MATRIX_STACK_DEPTH, 1);
    EXPECT_NO_ERROR(glMatrixMode(GL_COLOR));
    EXPECT_INTS(GL_MATRIX_MODE, GL_COLOR);
    EXPECT_NO_ERROR(glPushMatrix());
    EXPECT_INTS(GL_COLOR_MATRIX_STACK_DEPTH, 2);
    glLoadMatrixf(m);
    glGetFloatv(GL_COLOR_MATRIX, got);
    assert_memory_equal(got, m, sizeof m);
    glGetFloatv(GL_TRANSPOSE_COLOR_MATRIX, got);
    assert_true(got[1] == m[4] && got[11] == m[14]);
    for (int c = 0; c < 4; c++) {
        glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE + (GLenum)c, (GLfloat)scale[c]);
        glPixelTransferf(GL_POST_COLOR_MATRIX_RED_BIAS + (GLenum)c, (GLfloat)bias[c]);
    }
    true_matrix(truth, m);
    true_scale_bias(truth, scale, bias);
    EXPECT_READ(9, 5, truth);
    EXPECT_NO_ERROR(glPopMatrix());
    EXPECT_ERROR(GL_STACK_UNDERFLOW, glPopMatrix());
    EXPECT_VALUES(GL_COLOR_MATRIX, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    GLint depth = 0;
    glGetIntegerv(GL_MAX_COLOR_MATRIX_STACK_DEPTH, &depth);
    assert_true(depth >= 2);
    free(truth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(tables_of_every_format),
            GL_TEST(tables_are_scaled_clamped_and_returned),
            GL_TEST(table_errors_and_proxies),
            GL_TEST(copied_tables),
            GL_TEST(color_matrix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
