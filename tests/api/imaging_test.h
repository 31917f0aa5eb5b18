/* What the tests of the imaging subset (OpenGL 1.5, 3.6.3, 3.6.5, 6.1.7 to 6.1.10) share. Mesa's OSMesa does not have it: the truth is computed
 * here, in double, from the equations of the specification. Images are RGBA, the bottom row first. */
#ifndef TESTS_API_IMAGING_TEST_H
#define TESTS_API_IMAGING_TEST_H

#include "api/gl_test.h"

#include <float.h>
#include <math.h>

enum { MAX_PIXELS = TEST_SIZE * TEST_SIZE };

struct image {
    int width, height;
    double pixel[MAX_PIXELS][4];
};

static unsigned seed = 1;

static inline unsigned random_bits(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed >> 8;
}

static inline double random_unit(void)
{
    return (double)(random_bits() % 1001) / 1000.0;
}

static GLubyte source[MAX_PIXELS][4];

/* Random bytes in the window's lower left corner. */
static inline void draw_source(int width, int height, struct image *truth)
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

static inline void check_near(double got, double truth, double bound, const char *what, const char *file, int line)
{
    if (fabs(got - truth) <= bound)
        return;
    print_error("%s:%d: %s: %.9g, expected %.9g\n", file, line, what, got, truth);
    _fail(file, line);
}
#define EXPECT_NEAR(got, truth, bound) check_near((got), (truth), (bound), #got, __FILE__, __LINE__)

/* What glReadPixels gives of a rectangle of this size is the truth, and no more is written. */
static inline void check_read(int width, int height, const struct image *truth, const char *file, int line)
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

static inline double clamp01(double v)
{
    return v < 0 ? 0 : v > 1 ? 1 : v;
}

/* Table 3.12 to 3.14: the component of a format that changes a channel; -1: none. */
static inline int component(GLenum base, int c)
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

static inline void true_lookup(struct image *image, GLenum base, const GLfloat (*table)[4], int n)
{
    for (int i = 0; i < image->width * image->height; i++)
        for (int c = 0; c < 4; c++)
            if (component(base, c) >= 0)
                image->pixel[i][c] = (double)table[(int)floor(clamp01(image->pixel[i][c]) * (n - 1) + 0.5)][component(base, c)];
}

static inline void true_scale_bias(struct image *image, const double scale[4], const double bias[4])
{
    for (int i = 0; i < image->width * image->height; i++)
        for (int c = 0; c < 4; c++)
            image->pixel[i][c] = image->pixel[i][c] * scale[c] + bias[c];
}

static inline const double *source_pixel(const struct image *image, int x, int y, GLenum mode, const double border[4])
{
    const bool inside = x >= 0 && x < image->width && y >= 0 && y < image->height;
    if (!inside && mode == GL_CONSTANT_BORDER)
        return border;
    x = x < 0 ? 0 : x >= image->width ? image->width - 1 : x;
    y = y < 0 ? 0 : y >= image->height ? image->height - 1 : y;
    return image->pixel[y * image->width + x];
}

/* 3.6.5 "Convolution": filter[m * w + n]. */
static inline void true_convolution(struct image *image, GLenum base, const double (*filter)[4], int w, int h, GLenum mode,
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

static inline void true_matrix(struct image *image, const GLfloat m[16])
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

/* ---- random tables, matrices and filters ---- */

static const GLenum bases[6] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
static const GLenum tables[3] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE, GL_POST_COLOR_MATRIX_COLOR_TABLE};

static inline void make_table(GLfloat (*table)[4], int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            table[i][c] = (GLfloat)random_unit();
}

static inline void random_matrix(GLfloat m[16])
{
    for (int i = 0; i < 16; i++)
        m[i] = (GLfloat)(2 * random_unit() - 1);
}

static double weights[32 * 32][4];
static GLfloat given_weights[32 * 32][4]; /* the same */

static inline void make_weights(int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            weights[i][c] = (double)(given_weights[i][c] = (GLfloat)(2 * random_unit() - 1));
}

static const GLenum modes[3] = {GL_REDUCE, GL_CONSTANT_BORDER, GL_REPLICATE_BORDER};
static const GLfloat border_color[4] = {.5f, -1, .25f, 2};
static const double true_border[4] = {.5, -1, .25, 2};

#endif
