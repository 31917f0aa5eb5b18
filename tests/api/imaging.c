/* The imaging subset: all stages in their order, the commands that they apply to, and their state. */
#include "api/imaging_test.h"

/* ---- all stages, in their order, and the commands that they apply to ---- */

enum { STAGES_W = 3, STAGES_H = 2 };

static void enable_all_stages(struct image *image)
{
    static const double s0[4] = {.75, 1.25, .5, 1}, b0[4] = {.1, -.1, .2, 0}, s1[4] = {.5, .25, .75, .5}, b1[4] = {.2, .3, .1, .4},
                        s2[4] = {.8, .9, 1.1, .7}, b2[4] = {.1, .05, 0, .1};
    static GLfloat table[3][32][4];
    GLfloat m[16], map[8];
    for (int c = 0; c < 4; c++) {
        static const GLenum scale[4] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE},
                            bias[4] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
        glPixelTransferf(scale[c], (GLfloat)s0[c]);
        glPixelTransferf(bias[c], (GLfloat)b0[c]);
        glPixelTransferf(GL_POST_CONVOLUTION_RED_SCALE + (GLenum)c, (GLfloat)s1[c]);
        glPixelTransferf(GL_POST_CONVOLUTION_RED_BIAS + (GLenum)c, (GLfloat)b1[c]);
        glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE + (GLenum)c, (GLfloat)s2[c]);
        glPixelTransferf(GL_POST_COLOR_MATRIX_RED_BIAS + (GLenum)c, (GLfloat)b2[c]);
        for (int i = 0; i < 8; i++)
            map[i] = (GLfloat)random_unit();
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R + (GLenum)c, 8, map);
        for (int i = 0; i < image->width * image->height; i++)
            image->pixel[i][c] = (double)map[(int)floor(clamp01(image->pixel[i][c] * s0[c] + b0[c]) * 7 + 0.5)];
    }
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    for (int t = 0; t < 3; t++) {
        make_table(table[t], 32);
        glColorTable(tables[t], GL_RGBA, 32, GL_RGBA, GL_FLOAT, table[t]);
        glEnable(tables[t]);
    }
    random_matrix(m);
    glMatrixMode(GL_COLOR);
    glLoadMatrixf(m);
    make_weights(STAGES_W * STAGES_H);
    glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, STAGES_W, STAGES_H, GL_RGBA, GL_FLOAT, given_weights);
    glEnable(GL_CONVOLUTION_2D);
    true_lookup(image, GL_RGBA, (const GLfloat(*)[4])table[0], 32);
    true_convolution(image, GL_RGBA, (const double(*)[4])weights, STAGES_W, STAGES_H, GL_REDUCE, true_border);
    true_scale_bias(image, s1, b1);
    true_lookup(image, GL_RGBA, (const GLfloat(*)[4])table[1], 32);
    true_matrix(image, m);
    true_scale_bias(image, s2, b2);
    true_lookup(image, GL_RGBA, (const GLfloat(*)[4])table[2], 32);
}

static void check_bytes(const GLubyte (*got)[4], const struct image *truth, const char *file, int line)
{
    for (int i = 0; i < truth->width * truth->height; i++)
        for (int c = 0; c < 4; c++)
            check_near(got[i][c], 255 * clamp01(truth->pixel[i][c]), 0.5 + 1e-3, "byte", file, line);
}
#define EXPECT_BYTES(got, truth) check_bytes((const GLubyte(*)[4])(got), (truth), __FILE__, __LINE__)

static void every_stage_in_every_command(void **state)
{
    (void)state;
    enum { W = 18, H = 9, OUT_W = W - STAGES_W + 1, OUT_H = H - STAGES_H + 1 };
    static GLubyte got[MAX_PIXELS][4];
    struct image *const truth = calloc(1, sizeof *truth);
    for (int command = 0; command < 7; command++) {
        glClear(GL_COLOR_BUFFER_BIT);
        draw_source(W, H, truth);
        glPushAttrib(GL_PIXEL_MODE_BIT);
        enable_all_stages(truth);
        glWindowPos2i(32, 32);
        switch (command) {
        case 0: EXPECT_READ(W, H, truth); break;
        case 1: glDrawPixels(W, H, GL_RGBA, GL_UNSIGNED_BYTE, source); break;
        case 2: glCopyPixels(0, 0, W, H, GL_COLOR); break;
        case 3: glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, W, H, 0, GL_RGBA, GL_UNSIGNED_BYTE, source); break;
        case 4: glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, W, H, GL_RGBA, GL_UNSIGNED_BYTE, source); break;
        case 5: glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, W, H, 0); break;
        case 6: glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, W, H); break;
        }
        assert_int_equal(glGetError(), GL_NO_ERROR);
        glPopAttrib();
        glLoadIdentity();
        if (command >= 3) {
            GLint width = 0, height = 0;
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
            assert_int_equal(width, OUT_W);
            assert_int_equal(height, OUT_H);
            glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
        } else {
            glReadPixels(32, 32, OUT_W, OUT_H, GL_RGBA, GL_UNSIGNED_BYTE, got);
        }
        if (command > 0)
            EXPECT_BYTES(got, truth);
    }
    free(truth);
}

/* 3.6.5: a one-dimensional filter is for one-dimensional textures alone, a two-dimensional one for the rest. */
static void one_dimension(void **state)
{
    (void)state;
    enum { W = 18, F = 3 };
    static GLubyte got[W][4];
    struct image *const drawn = calloc(1, sizeof *drawn), *const truth = calloc(1, sizeof *truth);
    draw_source(W, 1, drawn);
    make_weights(F);
    glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGB, F, GL_RGBA, GL_FLOAT, given_weights);
    glEnable(GL_CONVOLUTION_1D);
    EXPECT_READ(W, 1, drawn);
    *truth = *drawn;
    true_convolution(truth, GL_RGB, (const double(*)[4])weights, F, 1, GL_REDUCE, true_border);
    EXPECT_NO_ERROR(glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, W, 0, GL_RGBA, GL_UNSIGNED_BYTE, source));
    glGetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    EXPECT_BYTES(got, truth);
    EXPECT_NO_ERROR(glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 0, 0, W, 0));
    glGetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    EXPECT_BYTES(got, truth);
    /* The size that is left decides: 2 pixels convolved are none. */
    EXPECT_NO_ERROR(glTexSubImage1D(GL_TEXTURE_1D, 0, 16, 2, GL_RGBA, GL_UNSIGNED_BYTE, source));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexSubImage1D(GL_TEXTURE_1D, 0, 16, 3, GL_RGBA, GL_UNSIGNED_BYTE, source));
    free(drawn);
    free(truth);
}

/* Images smaller than the filter, filters without size, images given as NULL. */
static void sizes_at_the_edge(void **state)
{
    (void)state;
    struct image *const truth = calloc(1, sizeof *truth);
    GLint width = -1, height = -1;
    draw_source(4, 4, truth);
    make_weights(32);
    glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 5, 3, GL_RGBA, GL_FLOAT, given_weights);
    glEnable(GL_CONVOLUTION_2D);
    truth->width = 0;
    EXPECT_READ(4, 4, truth);
    glWindowPos2i(0, 0);
    EXPECT_NO_ERROR(glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, source));
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 12, 10, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    assert_true(width == 8 && height == 8);
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, -1, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glReadPixels(0, 0, -1, 4, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_NO_ERROR(glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 0, 0, GL_RGBA, GL_FLOAT, given_weights));
    truth->width = 4;
    memset(truth->pixel, 0, sizeof truth->pixel);
    EXPECT_READ(4, 4, truth);
    free(truth);
}

/* 3.6.5: the stages apply to RGBA groups, among them those that come from color indexes. */
static void groups(void **state)
{
    (void)state;
    static const GLfloat to_red[2] = {0, 1}, table[2][4] = {{.2f, .4f, .6f, .8f}, {1, .8f, .4f, .2f}};
    static const GLubyte indexes[2] = {1, 0};
    GLubyte got[2][4];
    GLfloat depth[2] = {.25f, .75f};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, to_red);
    glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_RGBA, GL_FLOAT, table);
    glEnable(GL_COLOR_TABLE);
    glWindowPos2i(0, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    EXPECT_NO_ERROR(glDrawPixels(2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indexes));
    glDisable(GL_COLOR_TABLE);
    glReadPixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0][0], 255); /* index 1: red 1, entry 1; green, blue and alpha 0: entry 0 */
    assert_int_equal(got[0][1], 102);
    assert_int_equal(got[1][0], 51);

    glHistogram(GL_HISTOGRAM, 4, GL_RGBA, GL_TRUE);
    glEnable(GL_HISTOGRAM);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    EXPECT_NO_ERROR(glDrawPixels(2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth));
    depth[0] = depth[1] = -1;
    EXPECT_NO_ERROR(glReadPixels(0, 0, 2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth));
    EXPECT_NEAR((double)depth[0], .25, 1e-6);
    EXPECT_NEAR((double)depth[1], .75, 1e-6);
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 2, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth));
    EXPECT_NO_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 2, 1, 0));
    GLfloat texels[2];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, texels);
    EXPECT_NEAR((double)texels[1], .75, 1e-5);
    EXPECT_FLOATS(glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RED, GL_FLOAT, got_), 0, 0, 0, 0);
}

/* Of three dimensions: no convolution, but the rest; and the parts that copies replace. */
static void three_dimensions(void **state)
{
    (void)state;
    enum { W = 4, H = 4, D = 2, N = W * H * D };
    static const GLfloat inverse[2][4] = {{1, 1, 1, 1}, {0, 0, 0, 0}};
    static GLubyte given[N][4], got[N][4];
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 4; c++)
            given[i][c] = random_bits() % 2 ? 255 : 0;
    make_weights(9);
    glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 3, 3, GL_RGBA, GL_FLOAT, given_weights);
    glEnable(GL_CONVOLUTION_2D);
    glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_RGBA, GL_FLOAT, inverse);
    glEnable(GL_COLOR_TABLE);
    glHistogram(GL_HISTOGRAM, 1, GL_RGBA, GL_FALSE);
    glEnable(GL_HISTOGRAM);
    EXPECT_NO_ERROR(glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, W, H, D, 0, GL_RGBA, GL_UNSIGNED_BYTE, given));
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    for (int i = 0; i < 4 * N; i++)
        assert_int_equal(got[i / 4][i % 4], 255 - given[i / 4][i % 4]);
    EXPECT_FLOATS(glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RED, GL_FLOAT, got_), N);

    struct image *const truth = calloc(1, sizeof *truth);
    glDisable(GL_COLOR_TABLE);
    glDisable(GL_CONVOLUTION_2D);
    draw_source(W, H, truth);
    glEnable(GL_CONVOLUTION_2D);
    true_convolution(truth, GL_RGBA, (const double(*)[4])weights, 3, 3, GL_REDUCE, true_border);
    EXPECT_NO_ERROR(glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 1, 1, 1, 0, 0, W, H)); /* 2 x 2 are left */
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 4; c++)
            EXPECT_NEAR(got[W * H + W * (1 + i / 2) + 1 + i % 2][c], 255 * clamp01(truth->pixel[i][c]), 0.5 + 1e-3);
    assert_int_equal(got[W * H][0], 255 - given[W * H][0]);
    free(truth);
}

/* A texture's border is convolved with it. */
static void bordered_texture(void **state)
{
    (void)state;
    enum { W = 12, H = 11 };
    static GLubyte got[MAX_PIXELS][4];
    struct image *const truth = calloc(1, sizeof *truth);
    draw_source(W, H, truth);
    make_weights(6);
    glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 3, 2, GL_RGBA, GL_FLOAT, given_weights);
    glEnable(GL_CONVOLUTION_2D);
    true_convolution(truth, GL_RGBA, (const double(*)[4])weights, 3, 2, GL_REDUCE, true_border); /* to 10 x 10 */
    for (int copied = 0; copied < 2; copied++) {
        if (copied)
            EXPECT_NO_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, W, H, 1));
        else
            EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, W, H, 1, GL_RGBA, GL_UNSIGNED_BYTE, source));
        GLint width = 0, border = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER, &border);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
        const int inner = width == 8 ? 8 : 10, skip = (10 - inner) / 2; /* images are kept without their borders */
        for (int y = 0; y < 8; y++)
            for (int x = 0; x < 8; x++)
                EXPECT_NEAR(got[(y + 1 - skip) * inner + x + 1 - skip][2], 255 * clamp01(truth->pixel[(y + 1) * 10 + x + 1][2]),
                            0.5 + 1e-3);
    }
    free(truth);
}

/* ---- state ---- */

static void attribute_groups(void **state)
{
    (void)state;
    static const GLenum caps[] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE, GL_POST_COLOR_MATRIX_COLOR_TABLE, GL_CONVOLUTION_1D,
                                  GL_CONVOLUTION_2D, GL_SEPARABLE_2D, GL_HISTOGRAM, GL_MINMAX};
    static const GLfloat v[4] = {3, 4, 5, 6};
    static const GLbitfield groups[2] = {GL_ENABLE_BIT, GL_PIXEL_MODE_BIT};
    for (int g = 0; g < 2; g++) {
        glPushAttrib(groups[g]);
        for (int i = 0; i < 8; i++) {
            assert_false(glIsEnabled(caps[i]));
            EXPECT_NO_ERROR(glEnable(caps[i]));
            assert_true(glIsEnabled(caps[i]));
        }
        glPopAttrib();
        for (int i = 0; i < 8; i++)
            assert_false(glIsEnabled(caps[i]));
    }
    glPushAttrib(GL_PIXEL_MODE_BIT);
    for (GLenum p = GL_POST_CONVOLUTION_RED_SCALE; p <= GL_POST_CONVOLUTION_ALPHA_BIAS; p++)
        EXPECT_NO_ERROR(glPixelTransferf(p, 7));
    for (GLenum p = GL_POST_COLOR_MATRIX_RED_SCALE; p <= GL_POST_COLOR_MATRIX_ALPHA_BIAS; p++)
        EXPECT_NO_ERROR(glPixelTransferf(p, 8));
    EXPECT_VALUES(GL_POST_CONVOLUTION_BLUE_BIAS, 7);
    EXPECT_VALUES(GL_POST_COLOR_MATRIX_GREEN_SCALE, 8);
    glColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, v);
    glConvolutionParameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_FILTER_SCALE, v);
    glConvolutionParameteri(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_MODE, GL_REPLICATE_BORDER);
    glPopAttrib();
    for (GLenum i = 0; i < 4; i++) {
        EXPECT_VALUES(GL_POST_CONVOLUTION_RED_SCALE + i, 1);
        EXPECT_VALUES(GL_POST_CONVOLUTION_RED_BIAS + i, 0);
        EXPECT_VALUES(GL_POST_COLOR_MATRIX_RED_SCALE + i, 1);
        EXPECT_VALUES(GL_POST_COLOR_MATRIX_RED_BIAS + i, 0);
    }
    EXPECT_FLOATS(glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, got_), 0, 0, 0, 0);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_FILTER_SCALE, got_), 1, 1, 1, 1);
    EXPECT_FLOATS(glGetConvolutionParameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_MODE, got_), GL_REDUCE);
}

static void display_lists(void **state)
{
    (void)state;
    GLfloat table[3][4] = {{.25f, .5f, .75f, 1}, {1, .5f, .25f, 0}}, row[3] = {1, 2, 3}, column[2] = {4, 5};
    GLint width = -1;
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glColorTable(GL_COLOR_TABLE, GL_RGBA, 2, GL_RGBA, GL_FLOAT, table);
    glColorSubTable(GL_COLOR_TABLE, 1, 1, GL_RGBA, GL_FLOAT, table);
    glColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA, 8, GL_RGBA, GL_FLOAT, NULL); /* at once */
    glSeparableFilter2D(GL_SEPARABLE_2D, GL_LUMINANCE, 3, 2, GL_LUMINANCE, GL_FLOAT, row, column);
    glHistogram(GL_HISTOGRAM, 4, GL_RGB, GL_TRUE);
    glHistogram(GL_PROXY_HISTOGRAM, 16, GL_RGB, GL_TRUE); /* at once */
    glMinmax(GL_MINMAX, GL_RGB, GL_TRUE);
    glColorTable(GL_COLOR_TABLE, GL_RGBA, 3, GL_RGBA, GL_FLOAT, table); /* an error when executed */
    glEndList();
    assert_int_equal(glGetError(), GL_NO_ERROR);
    memset(table, 0, sizeof table);
    memset(row, 0, sizeof row);
    memset(column, 0, sizeof column);
    glGetColorTableParameteriv(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &width);
    assert_int_equal(width, 0);
    glGetColorTableParameteriv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &width);
    assert_int_equal(width, 8);
    glGetHistogramParameteriv(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH, &width);
    assert_int_equal(width, 16);
    EXPECT_ERROR(GL_INVALID_VALUE, glCallList(list));
    EXPECT_FLOATS(glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_FLOAT, got_), .25f, .5f, .75f, 1, .25f, .5f, .75f, 1);
    GLfloat got_row[3], got_column[2];
    glGetSeparableFilter(GL_SEPARABLE_2D, GL_LUMINANCE, GL_FLOAT, got_row, got_column, NULL);
    assert_true(got_row[0] == 1 && got_row[2] == 3 && got_column[0] == 4 && got_column[1] == 5);
    glGetHistogramParameteriv(GL_HISTOGRAM, GL_HISTOGRAM_WIDTH, &width);
    assert_int_equal(width, 4);
    EXPECT_FLOATS(glGetMinmaxParameterfv(GL_MINMAX, GL_MINMAX_SINK, got_), GL_TRUE);
}

static void extension_is_named(void **state)
{
    (void)state;
    assert_non_null(strstr((const char *)glGetString(GL_EXTENSIONS), "GL_ARB_imaging"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(every_stage_in_every_command),
            GL_TEST(one_dimension),
            GL_TEST(sizes_at_the_edge),
            GL_TEST(groups),
            GL_TEST(three_dimensions),
            GL_TEST(bordered_texture),
            GL_TEST(attribute_groups),
            GL_TEST(display_lists),
            GL_TEST(extension_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
