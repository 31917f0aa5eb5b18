/* The imaging subset (OpenGL 1.5, 3.6.3, 3.6.5, 6.1.7 to 6.1.10), which Mesa's OSMesa does not have: the truth is computed here, in double,
 * from the equations of the specification. Images are RGBA, the bottom row first. */
#include "api/gl_test.h"

#include <float.h>
#include <math.h>

enum { MAX_PIXELS = TEST_SIZE * TEST_SIZE };

struct image {
    int width, height;
    double pixel[MAX_PIXELS][4];
};

static unsigned seed = 1;

static unsigned random_bits(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed >> 8;
}

static double random_unit(void)
{
    return (double)(random_bits() % 1001) / 1000.0;
}

static GLubyte source[MAX_PIXELS][4];

/* Random bytes in the window's lower left corner. */
static void draw_source(int width, int height, struct image *truth)
{
    truth->width = width;
    truth->height = height;
    for (int i = 0; i < width * height; i++)
        for (int c = 0; c < 4; c++) {
            source[i][c] = (GLubyte)random_bits();
            truth->pixel[i][c] = source[i][c] / 255.0;
        }
    glWindowPos2i(0, 0);
    glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, source);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void check_near(double got, double truth, double bound, const char *what, const char *file, int line)
{
    if (fabs(got - truth) <= bound)
        return;
    print_error("%s:%d: %s: %.9g, expected %.9g\n", file, line, what, got, truth);
    _fail(file, line);
}
#define EXPECT_NEAR(got, truth, bound) check_near((got), (truth), (bound), #got, __FILE__, __LINE__)

/* What glReadPixels gives of a rectangle of this size is the truth, and no more is written. */
static void check_read(int width, int height, const struct image *truth, const char *file, int line)
{
    static GLfloat got[MAX_PIXELS + 1][4];
    for (int i = 0; i <= MAX_PIXELS; i++)
        for (int c = 0; c < 4; c++)
            got[i][c] = -77;
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, got);
    check_error(GL_NO_ERROR, "glReadPixels", file, line);
    const int n = truth->width * truth->height;
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 4; c++)
            check_near((double)got[i][c], i < n ? truth->pixel[i][c] : -77, 1e-5, "pixel read", file, line);
}
#define EXPECT_READ(width, height, truth) check_read((width), (height), (truth), __FILE__, __LINE__)

/* ---- the equations ---- */

static double clamp01(double v)
{
    return v < 0 ? 0 : v > 1 ? 1 : v;
}

/* Table 3.12 to 3.14: the component of a format that changes a channel; -1: none. */
static int component(GLenum base, int c)
{
    switch (base) {
    case GL_ALPHA: return c == 3 ? 3 : -1;
    case GL_LUMINANCE: return c < 3 ? 0 : -1;
    case GL_LUMINANCE_ALPHA: return c < 3 ? 0 : 3;
    case GL_INTENSITY: return 0;
    case GL_RGB: return c < 3 ? c : -1;
    default: return c;
    }
}

static void true_lookup(struct image *image, GLenum base, const GLfloat (*table)[4], int n)
{
    for (int i = 0; i < image->width * image->height; i++)
        for (int c = 0; c < 4; c++)
            if (component(base, c) >= 0)
                image->pixel[i][c] = (double)table[(int)floor(clamp01(image->pixel[i][c]) * (n - 1) + 0.5)][component(base, c)];
}

static void true_scale_bias(struct image *image, const double scale[4], const double bias[4])
{
    for (int i = 0; i < image->width * image->height; i++)
        for (int c = 0; c < 4; c++)
            image->pixel[i][c] = image->pixel[i][c] * scale[c] + bias[c];
}

static const double *source_pixel(const struct image *image, int x, int y, GLenum mode, const double border[4])
{
    const bool inside = x >= 0 && x < image->width && y >= 0 && y < image->height;
    if (!inside && mode == GL_CONSTANT_BORDER)
        return border;
    x = x < 0 ? 0 : x >= image->width ? image->width - 1 : x;
    y = y < 0 ? 0 : y >= image->height ? image->height - 1 : y;
    return image->pixel[y * image->width + x];
}

/* 3.6.5 "Convolution": filter[m * w + n]. */
static void true_convolution(struct image *image, GLenum base, const double (*filter)[4], int w, int h, GLenum mode,
                             const double border[4])
{
    static struct image out;
    const bool reduce = mode == GL_REDUCE;
    out.width = image->width - (reduce ? w - 1 : 0);
    out.height = image->height - (reduce ? h - 1 : 0);
    for (int y = 0; y < out.height; y++)
        for (int x = 0; x < out.width; x++)
            for (int c = 0; c < 4; c++) {
                const int x0 = x - (reduce ? 0 : w / 2), y0 = y - (reduce ? 0 : h / 2);
                double sum = 0;
                for (int m = 0; m < h; m++)
                    for (int n = 0; n < w; n++)
                        sum += source_pixel(image, x0 + n, y0 + m, mode, border)[c] *
                               filter[m * w + n][component(base, c) < 0 ? 0 : component(base, c)];
                if (component(base, c) < 0)
                    sum = source_pixel(image, x0 + w / 2, y0 + h / 2, mode, border)[c];
                out.pixel[y * out.width + x][c] = sum;
            }
    *image = out;
}

static void true_matrix(struct image *image, const GLfloat m[16])
{
    for (int i = 0; i < image->width * image->height; i++) {
        double v[4];
        for (int c = 0; c < 4; c++) {
            v[c] = 0;
            for (int k = 0; k < 4; k++)
                v[c] += (double)m[4 * k + c] * image->pixel[i][k];
        }
        memcpy(image->pixel[i], v, sizeof v);
    }
}

/* ---- color tables ---- */

static const GLenum bases[6] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
static const GLenum tables[3] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE, GL_POST_COLOR_MATRIX_COLOR_TABLE};

static void make_table(GLfloat (*table)[4], int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            table[i][c] = (GLfloat)random_unit();
}

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

static void random_matrix(GLfloat m[16])
{
    for (int i = 0; i < 16; i++)
        m[i] = (GLfloat)(2 * random_unit() - 1);
}

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

/* ---- convolution ---- */

static double weights[32 * 32][4];
static GLfloat given_weights[32 * 32][4];

static void make_weights(int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            weights[i][c] = (double)(given_weights[i][c] = (GLfloat)(2 * random_unit() - 1));
}

static const GLenum modes[3] = {GL_REDUCE, GL_CONSTANT_BORDER, GL_REPLICATE_BORDER};
static const GLfloat border_color[4] = {.5f, -1, .25f, 2};
static const double true_border[4] = {.5, -1, .25, 2};

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

/* ---- histogram and minmax ---- */

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

static void extension_is_named(void **state)
{
    (void)state;
    assert_non_null(strstr((const char *)glGetString(GL_EXTENSIONS), "GL_ARB_imaging"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(tables_of_every_format),
            GL_TEST(tables_are_scaled_clamped_and_returned),
            GL_TEST(table_errors_and_proxies),
            GL_TEST(copied_tables),
            GL_TEST(color_matrix),
            GL_TEST(convolution_2d),
            GL_TEST(separable_filters),
            GL_TEST(filter_state_and_errors),
            GL_TEST(copied_filters),
            GL_TEST(histograms),
            GL_TEST(histogram_errors),
            GL_TEST(minmax),
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
