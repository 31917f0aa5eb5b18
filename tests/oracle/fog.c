/*
 * Fog (GL 1.5, 3.10) and the color sum before it (3.9), against 113 bits: in exact mode each color is right within 1e-6.
 * Compatible mode is measured too, and only held to be finite.
 *
 * environment: FIXEDGL_SEED; FIXEDGL_TRIANGLES, triangles per category.
 */
#include "drawing.h"

#include <math.h>

static const double bound = 1e-6;

static const struct category {
    const char *name;
    GLenum mode;
    float density, start, end;
    bool given, summed; /* the fog coordinate in place of the distance; with secondary colors */
    float most_w;       /* of triangles with fog coordinates: ratios of w up to its square */
    float most;         /* fog coordinates */
} categories[] = {
        {"linear, distance", GL_LINEAR, 1, 1.5f, 6, false, false, 1, 0},
        {"exp, distance", GL_EXP, 0.35f, 0, 1, false, false, 1, 0},
        {"exp2, distance", GL_EXP2, 0.25f, 0, 1, false, false, 1, 0},
        {"linear, coordinate", GL_LINEAR, 1, 0.25f, 3, true, false, 2, 3},
        {"exp, coordinate", GL_EXP, 1, 0, 1, true, false, 2, 3},
        {"exp2, coordinate", GL_EXP2, 1, 0, 1, true, false, 2, 3},
        {"exp, strong perspective", GL_EXP, 1, 0, 1, true, false, 31.6f, 3},
        {"linear, start beyond end", GL_LINEAR, 1, 3, -1, true, false, 2, 3},
        {"linear, a thin layer", GL_LINEAR, 1, 1, 1.001f, true, false, 2, 3},
        {"exp, dense", GL_EXP, 100, 0, 1, true, false, 2, 0.5f},
        {"exp2, dense", GL_EXP2, 100, 0, 1, true, false, 2, 0.5f},
        {"exp, coordinates to 1e6", GL_EXP, 1e-6f, 0, 1, true, false, 2, 1e6f},
        {"exp2, density 1e-20", GL_EXP2, 1e-20f, 0, 1, true, false, 2, 1e20f},
        {"linear, color sum", GL_LINEAR, 1, 0.25f, 3, true, true, 2, 3},
        {"exp, color sum, distance", GL_EXP, 0.35f, 0, 1, false, true, 1, 0},
};
enum { CATEGORIES = sizeof categories / sizeof *categories };

struct corner {
    float fog, color[3], secondary[3];
};

static const float fog_color[4] = {0.25f, 0.75f, 0.5f, 1};

/* A projection whose clip coordinates are floats: z of the eye, multiples of 2^-8 within [-8, -1]. */
static const float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.25f, -1, 0, 0, -2.25f, 0};

static void set_up(const struct category *c)
{
    glFogi(GL_FOG_MODE, (GLint)c->mode);
    glFogf(GL_FOG_DENSITY, c->density);
    glFogf(GL_FOG_START, c->start);
    glFogf(GL_FOG_END, c->end);
    glFogfv(GL_FOG_COLOR, fog_color);
    glFogi(GL_FOG_COORD_SRC, c->given ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
    glEnable(GL_FOG);
    (c->summed ? glEnable : glDisable)(GL_COLOR_SUM);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (!c->given)
        glLoadMatrixf(projection);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void place(struct random *r, const struct category *c, struct raster_triangle *t, struct corner corner[3])
{
    random_triangle(r, t, c->most_w);
    for (int i = 0; i < 3; i++) {
        corner[i].fog = random_between(r, 0, c->most);
        for (int k = 0; k < 3; k++) {
            corner[i].color[k] = random_between(r, 0, 1);
            corner[i].secondary[k] = random_between(r, 0, 1);
        }
        if (!c->given) {
            const float z = -1 - (float)random_below(r, 7 * 256) / 256;
            float *clip = t->vertex[i].clip;
            corner[i].fog = -z;
            clip[0] *= -z, clip[1] *= -z;
            clip[2] = -1.25f * z - 2.25f;
            clip[3] = -z;
        }
    }
}

static void draw(const struct category *c, const struct raster_triangle *t, const struct corner corner[3])
{
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        const float *clip = t->vertex[i].clip;
        glColor3fv(corner[i].color);
        glSecondaryColor3fv(corner[i].secondary);
        glFogCoordf(corner[i].fog);
        if (c->given)
            glVertex4fv(clip);
        else
            glVertex3f(clip[0], clip[1], -clip[3]);
    }
    glEnd();
    glFinish();
}

static quad clamp01(quad x)
{
    return !(x > 0) ? 0 : x > 1 ? 1 : x;
}

/* f of equations 3.24 to 3.26. */
static quad factor_of(const struct category *c, quad z)
{
    static const quad log2_e = (quad)1.4426950408889634 + (quad)2.0355273740931033e-17;
    const quad density = (quad)c->density * z;
    if (c->mode == GL_LINEAR)
        return clamp01(((quad)c->end - z) / ((quad)c->end - (quad)c->start));
    return clamp01(quad_exp2(-(c->mode == GL_EXP ? density : density * density) * log2_e));
}

static double error_at(const struct category *c, const struct raster_setup *setup, const struct corner corner[3], int x, int y)
{
    quad weight[3], worst = 0;
    oracle_raster_weights(setup, x, y, weight);
    const quad fog[3] = {(quad)corner[0].fog, (quad)corner[1].fog, (quad)corner[2].fog};
    const quad f = factor_of(c, interpolate(weight, fog));
    for (int k = 0; k < 3; k++) {
        quad value[3];
        for (int i = 0; i < 3; i++)
            value[i] = (quad)corner[i].color[k] + (c->summed ? (quad)corner[i].secondary[k] : 0);
        const quad truth = f * clamp01(interpolate(weight, value)) + (1 - f) * (quad)fog_color[k];
        const quad difference = (quad)window[y][x][k] - truth;
        if (!isfinite(window[y][x][k]))
            return HUGE_VAL;
        worst = difference > worst ? difference : -difference > worst ? -difference : worst;
    }
    return (double)worst;
}

static double measure(int number, long *pixels)
{
    const struct category *c = &categories[number];
    const int triangles = triangles_of(40);
    double worst = 0;
    *pixels = 0;
    set_up(c);
    for (int n = 0; n < triangles; n++) {
        struct random r = random_stream(seed_of(20260301), (uint64_t)number << 32 | (uint64_t)n);
        struct raster_triangle triangle;
        struct raster_setup setup;
        struct corner corner[3];
        place(&r, c, &triangle, corner);
        oracle_raster_setup(&triangle, &setup);
        draw(c, &triangle, corner);
        for (int y = 0; y < WINDOW; y++)
            for (int x = 0; x < WINDOW; x++)
                if (is_drawn(&setup, x, y)) {
                    worst = fmax(worst, error_at(c, &setup, corner, x, y));
                    ++*pixels;
                }
    }
    return worst;
}

static void fog(void **state)
{
    const int number = *(const int *)*state;
    long pixels;
    assert_int_not_equal(fixedglAccuracy(FIXEDGL_COMPATIBLE), 0);
    const double compatible = measure(number, &pixels);
    assert_int_not_equal(fixedglAccuracy(FIXEDGL_EXACT), 0);
    const double exact = measure(number, &pixels);
    printf("%-28s  pixels %6ld  compatible %.1e  exact %.1e\n", categories[number].name, pixels, compatible, exact);
    assert_true(pixels > 1000);
    assert_true(compatible <= 2);
    assert_true(exact <= bound);
}

int main(void)
{
    static int numbers[CATEGORIES];
    static struct CMUnitTest tests[CATEGORIES];
    for (int i = 0; i < CATEGORIES; i++) {
        numbers[i] = i;
        tests[i] = (struct CMUnitTest){categories[i].name, fog, NULL, NULL, &numbers[i]};
    }
    return _cmocka_run_group_tests("fog", tests, CATEGORIES, open_window, close_window);
}
