/*
 * Which texel GL_NEAREST takes (GL 1.5, 3.8.8), against texture coordinates in 113 bits: in exact mode it is the right one wherever
 * the coordinate is farther than 1e-6 of a texel from the next. Every texel's color is its place in the image.
 *
 * environment: FIXEDGL_SEED; FIXEDGL_TRIANGLES, triangles per category.
 */
#include "drawing.h"

#include <math.h>

static const double bound = 1e-6; /* texels */

static const struct category {
    const char *name;
    GLenum target;
    int dims, size[3];
    GLenum wrap;
    float most_w;      /* perspective: ratios of w up to its square */
    float most, shift; /* coordinates lie within most of shift */
    float most_q;
} categories[] = {
        {"1D, 64 texels", GL_TEXTURE_1D, 1, {64, 1, 1}, GL_REPEAT, 1, 1, 0, 1},
        {"1D, one texel", GL_TEXTURE_1D, 1, {1, 1, 1}, GL_CLAMP_TO_BORDER, 2, 2, 0, 1},
        {"2D, repeated", GL_TEXTURE_2D, 2, {64, 32, 1}, GL_REPEAT, 1, 3, 0, 1},
        {"2D, mirrored", GL_TEXTURE_2D, 2, {64, 32, 1}, GL_MIRRORED_REPEAT, 2, 5, 0, 1},
        {"2D, clamped", GL_TEXTURE_2D, 2, {16, 128, 1}, GL_CLAMP, 2, 2, 0, 1},
        {"2D, clamped to its edge", GL_TEXTURE_2D, 2, {256, 256, 1}, GL_CLAMP_TO_EDGE, 2, 2, 0, 1},
        {"2D, clamped to its border", GL_TEXTURE_2D, 2, {8, 2, 1}, GL_CLAMP_TO_BORDER, 2, 2, 0, 1},
        {"2D, sizes of no power of two", GL_TEXTURE_2D, 2, {100, 37, 1}, GL_REPEAT, 2, 3, 0, 1},
        {"3D, repeated", GL_TEXTURE_3D, 3, {16, 8, 32}, GL_REPEAT, 2, 2, 0, 1},
        {"3D, clamped to its edge", GL_TEXTURE_3D, 3, {5, 32, 3}, GL_CLAMP_TO_EDGE, 2, 2, 0, 1},
        {"strong perspective", GL_TEXTURE_2D, 2, {256, 64, 1}, GL_REPEAT, 31.6f, 1, 0, 1},
        {"strong perspective, clamped", GL_TEXTURE_2D, 2, {256, 64, 1}, GL_CLAMP_TO_EDGE, 31.6f, 1, 0, 1},
        {"projected, q from 1/4 to 4", GL_TEXTURE_2D, 2, {64, 64, 1}, GL_REPEAT, 2, 2, 0, 4},
        {"a thousand texels around 1e3", GL_TEXTURE_2D, 2, {64, 64, 1}, GL_REPEAT, 2, 8, 1e3f, 1},
        {"coordinates around 1e5", GL_TEXTURE_2D, 2, {256, 16, 1}, GL_REPEAT, 2, 4, 1e5f, 1},
        {"coordinates around -1e5, mirrored", GL_TEXTURE_2D, 2, {256, 16, 1}, GL_MIRRORED_REPEAT, 2, 4, -1e5f, 1},
        {"coordinates around 1e5, no power of two", GL_TEXTURE_2D, 2, {100, 3, 1}, GL_REPEAT, 2, 4, 1e5f, 1},
        {"coordinates to 1e8, repeated", GL_TEXTURE_2D, 2, {64, 256, 1}, GL_REPEAT, 1, 1e8f, 0, 1},
        {"coordinates to 1e8, mirrored", GL_TEXTURE_2D, 2, {64, 256, 1}, GL_MIRRORED_REPEAT, 1, 1e8f, 0, 1},
        {"coordinates to 1e9, clamped", GL_TEXTURE_2D, 2, {64, 64, 1}, GL_CLAMP, 1, 1e9f, 0, 1},
        {"coordinates to 1e9, clamped to the border", GL_TEXTURE_2D, 2, {64, 64, 1}, GL_CLAMP_TO_BORDER, 1, 1e9f, 0, 1},
        {"coordinates to 1e-6", GL_TEXTURE_2D, 2, {64, 64, 1}, GL_REPEAT, 2, 1e-6f, 0, 1},
};
enum { CATEGORIES = sizeof categories / sizeof *categories };

struct corner {
    float coordinate[4]; /* s, t, r, q */
};

struct figures {
    long pixels, wrong, near;
    double farthest; /* from the next texel, of those that are wrong, in texels */
};

/* Texel (i, j, k) is (i, j, k) / 255; the border is white, with an alpha of none of them. */
static void make_image(const struct category *c)
{
    static const float border[4] = {1, 1, 1, 0.25f};
    uint8_t *image = malloc((size_t)c->size[0] * (size_t)c->size[1] * (size_t)c->size[2] * 4), *at = image;
    assert_non_null(image);
    for (int k = 0; k < c->size[2]; k++)
        for (int j = 0; j < c->size[1]; j++)
            for (int i = 0; i < c->size[0]; i++, at += 4) {
                at[0] = (uint8_t)i, at[1] = (uint8_t)j, at[2] = (uint8_t)k;
                at[3] = 255;
            }
    if (c->dims == 1)
        glTexImage1D(c->target, 0, GL_RGBA8, c->size[0], 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    else if (c->dims == 2)
        glTexImage2D(c->target, 0, GL_RGBA8, c->size[0], c->size[1], 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    else
        glTexImage3D(c->target, 0, GL_RGBA8, c->size[0], c->size[1], c->size[2], 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    free(image);
    glTexParameteri(c->target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(c->target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(c->target, GL_TEXTURE_WRAP_S, (GLint)c->wrap);
    glTexParameteri(c->target, GL_TEXTURE_WRAP_T, (GLint)c->wrap);
    glTexParameteri(c->target, GL_TEXTURE_WRAP_R, (GLint)c->wrap);
    glTexParameterfv(c->target, GL_TEXTURE_BORDER_COLOR, border);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(c->target);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void draw(const struct raster_triangle *triangle, const struct corner corner[3])
{
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        glTexCoord4fv(corner[i].coordinate);
        glVertex4fv(triangle->vertex[i].clip);
    }
    glEnd();
    glFinish();
}

static quad floor_of(quad x)
{
    /* |x| < 2^62 */
    const quad cut = (quad)(int64_t)x;
    return cut > x ? cut - 1 : cut;
}

/* GL 1.5, 3.8.7 "Texture Wrap Modes" and 3.8.8: the index along one axis, -1 or n in the border. *margin: how far the
 * coordinate, in texels, is from where the index would be another. */
static int true_index(quad s, int n, GLenum wrap, double *margin)
{
    const quad u = s * n, below = floor_of(u), part = u - below;
    *margin = (double)(part < (quad)0.5 ? part : 1 - part);
    if (wrap == GL_REPEAT)
        return (int)((int64_t)below - n * (int64_t)floor_of(below / n));
    if (wrap == GL_MIRRORED_REPEAT) {
        const int i = (int)((int64_t)below - 2 * n * (int64_t)floor_of(below / (2 * n)));
        return i < n ? i : 2 * n - 1 - i;
    }
    const int low = wrap == GL_CLAMP_TO_BORDER ? -1 : 0, high = wrap == GL_CLAMP_TO_BORDER ? n : n - 1;
    return below < low ? low : below > high ? high : (int)below;
}

static void compare_pixel(const struct category *c, const struct raster_setup *setup, const struct corner corner[3],
                          int x, int y, struct figures *figures)
{
    quad weight[3], value[4][3], q;
    bool border = false, right = true;
    double margin = 1;
    oracle_raster_weights(setup, x, y, weight);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            value[k][i] = (quad)corner[i].coordinate[k];
    q = interpolate(weight, value[3]);
    for (int k = 0; k < c->dims; k++) {
        double here;
        const int index = true_index(interpolate(weight, value[k]) / q, c->size[k], c->wrap, &here);
        margin = fmin(margin, here);
        border = border || index < 0 || index >= c->size[k];
        right = right && lrintf(window[y][x][k] * 255) == index;
    }
    if (border)
        right = window[y][x][3] == 0.25f;
    figures->pixels++;
    if (!right) {
        *(margin > bound ? &figures->wrong : &figures->near) += 1;
        figures->farthest = fmax(figures->farthest, margin);
    }
}

static struct figures measure(int number)
{
    const struct category *c = &categories[number];
    struct figures figures = {0, 0, 0, 0};
    const int triangles = triangles_of(40);
    make_image(c);
    for (int n = 0; n < triangles; n++) {
        struct random r = random_stream(seed_of(20260201), (uint64_t)number << 32 | (uint64_t)n);
        struct raster_triangle triangle;
        struct raster_setup setup;
        struct corner corner[3];
        random_triangle(&r, &triangle, c->most_w);
        for (int i = 0; i < 3; i++) {
            corner[i].coordinate[3] = random_magnitude(&r, 1 / c->most_q, c->most_q);
            for (int k = 0; k < 3; k++)
                corner[i].coordinate[k] = c->shift + random_between(&r, -c->most, c->most);
        }
        oracle_raster_setup(&triangle, &setup);
        draw(&triangle, corner);
        for (int y = 0; y < WINDOW; y++)
            for (int x = 0; x < WINDOW; x++)
                if (is_drawn(&setup, x, y))
                    compare_pixel(c, &setup, corner, x, y, &figures);
    }
    glDisable(c->target);
    return figures;
}

static void nearest_texel(void **state)
{
    const int number = *(const int *)*state;
    static const char *const names[] = {"compatible", "exact"};
    static const GLenum modes[] = {FIXEDGL_COMPATIBLE, FIXEDGL_EXACT};
    struct figures figures = {0, 0, 0, 0};
    for (int mode = 0; mode < 2; mode++) {
        assert_int_not_equal(fixedglAccuracy(modes[mode]), 0);
        figures = measure(number);
        printf("%-42s %-10s  pixels %6ld  wrong %6ld  and within 1e-6 of the next texel %3ld  farthest %.1e\n",
               categories[number].name, names[mode], figures.pixels, figures.wrong, figures.near, figures.farthest);
    }
    assert_true(figures.pixels > 1000);
    assert_int_equal(figures.wrong, 0);
}

int main(void)
{
    static int numbers[CATEGORIES];
    static struct CMUnitTest tests[CATEGORIES];
    for (int i = 0; i < CATEGORIES; i++) {
        numbers[i] = i;
        tests[i] = (struct CMUnitTest){categories[i].name, nearest_texel, NULL, NULL, &numbers[i]};
    }
    return _cmocka_run_group_tests("texels", tests, CATEGORIES, open_window, close_window);
}
