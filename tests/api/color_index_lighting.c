/* Colour index mode: lit indexes (GL 1.5, 2.14.5). */
#include "api/color_index_test.h"

static uint32_t random_state;

static double uniform(double low, double high)
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (random_state >> 8) / 16777216.0;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit(double v[3])
{
    const double length = sqrt(dot(v, v));
    for (int c = 0; c < 3; c++)
        v[c] /= length;
}

/* A light as the equations of 2.14.1 name its parts. */
struct test_light {
    float diffuse[4], specular[4], position[4], spot_direction[3], spot_exponent, spot_cutoff, k[3];
};

static double intensity(const float color[4])
{
    return 0.30 * (double)color[0] + 0.59 * (double)color[1] + 0.11 * (double)color[2];
}

/* 2.14.5 "Color Index Lighting" at the eye-space point V with unit normal n. */
static double lit_index(const struct test_light *lights, int count, const double V[3], const double n[3],
                        bool local_viewer, double shininess, const float index[3])
{
    double s = 0, d = 0;
    for (int i = 0; i < count; i++) {
        const struct test_light *L = &lights[i];
        const bool positional = L->position[3] != 0.0f;
        double VP[3], h[3], att = 1, spot = 1;
        for (int c = 0; c < 3; c++)
            VP[c] = positional ? (double)L->position[c] / (double)L->position[3] - V[c] : (double)L->position[c];
        const double distance = sqrt(dot(VP, VP));
        unit(VP);
        if (positional)
            att = 1 / ((double)L->k[0] + (double)L->k[1] * distance + (double)L->k[2] * distance * distance);
        if (L->spot_cutoff != 180.0f) {
            double axis[3] = {(double)L->spot_direction[0], (double)L->spot_direction[1],
                              (double)L->spot_direction[2]};
            unit(axis);
            const double cosine = -dot(VP, axis);
            spot = cosine >= cos((double)L->spot_cutoff * acos(-1.0) / 180) ? pow(cosine, (double)L->spot_exponent)
                                                                             : 0;
        }
        double view[3] = {local_viewer ? -V[0] : 0, local_viewer ? -V[1] : 0, local_viewer ? -V[2] : 1};
        unit(view);
        for (int c = 0; c < 3; c++)
            h[c] = VP[c] + view[c];
        unit(h);
        const double n_dot_VP = dot(n, VP), n_dot_h = dot(n, h);
        if (n_dot_VP > 0)
            s += att * spot * intensity(L->specular) * (n_dot_h > 0 ? pow(n_dot_h, shininess) : 0);
        d += att * spot * intensity(L->diffuse) * (n_dot_VP > 0 ? n_dot_VP : 0);
    }
    const double a = (double)index[0], dm = (double)index[1], sm = (double)index[2], cut = s < 1 ? s : 1;
    const double c = a + d * (1 - cut) * (dm - a) + cut * (sm - a);
    return c < sm ? c : sm;
}

static void random_light(struct test_light *L)
{
    for (int c = 0; c < 4; c++) {
        L->diffuse[c] = (float)uniform(0, 1.2);
        L->specular[c] = (float)uniform(0, 1);
        L->position[c] = (float)uniform(-3, 3);
    }
    L->position[2] = (float)uniform(1, 4);
    L->position[3] = uniform(0, 1) < 0.5 ? 0.0f : 1.0f;
    L->spot_cutoff = uniform(0, 1) < 0.6 ? 180.0f : (float)uniform(30, 80);
    L->spot_exponent = (float)uniform(0, 8);
    for (int c = 0; c < 3; c++) {
        L->spot_direction[c] = -L->position[c];
        L->k[c] = (float)uniform(c ? 0 : 0.5, c ? 0.2 : 1.5);
    }
}

static void set_light(int i, const struct test_light *L)
{
    const GLenum light = GL_LIGHT0 + (GLenum)i;
    glEnable(light);
    glLightfv(light, GL_AMBIENT, (GLfloat[]){0.3f, 0.7f, 0.2f, 1}); /* no part of the equation */
    glLightfv(light, GL_DIFFUSE, L->diffuse);
    glLightfv(light, GL_SPECULAR, L->specular);
    glLightfv(light, GL_POSITION, L->position);
    glLightfv(light, GL_SPOT_DIRECTION, L->spot_direction);
    glLightf(light, GL_SPOT_EXPONENT, L->spot_exponent);
    glLightf(light, GL_SPOT_CUTOFF, L->spot_cutoff);
    for (int c = 0; c < 3; c++)
        glLightf(light, GL_CONSTANT_ATTENUATION + (GLenum)c, L->k[c]);
}

/* Random lights, materials and vertices: a point for each vertex, all over the window. varying: the material is
 * given between Begin and End. */
static void light_points(uint32_t seed, bool varying)
{
    enum { POINTS = 256 };
    static double truth[POINTS];
    struct test_light lights[3];
    random_state = seed;
    const int count = 1 + (int)uniform(0, 2.99);
    const bool local_viewer = uniform(0, 1) < 0.5;
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-1, 1, -1, 1, 0, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (int i = 0; i < count; i++) {
        random_light(&lights[i]);
        set_light(i, &lights[i]);
    }
    glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){0.1f, 0.9f, 0.3f, 1}); /* no part of the equation */
    glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.9f, 0.9f, 0.9f, 1});
    glTranslatef(0, 0, -3);
    float index[3] = {17, 130, 240}, shininess = 12;
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, index);
    glMaterialf(GL_FRONT, GL_SHININESS, shininess);
    glBegin(GL_POINTS);
    for (int i = 0; i < POINTS; i++) {
        const double x = (i % 16 - 8) / 8.0 + 1.0 / 64, y = (i / 16 - 8) / 8.0 + 1.0 / 64;
        float normal[3] = {(float)uniform(-1, 1), (float)uniform(-1, 1), (float)uniform(0.2, 1)};
        double n[3] = {(double)normal[0], (double)normal[1], (double)normal[2]};
        const double V[3] = {x, y, -3};
        unit(n);
        if (varying) {
            index[0] = (float)uniform(0, 60);
            index[1] = (float)uniform(60, 200);
            index[2] = (float)uniform(150, 255);
            shininess = (float)uniform(1, 60);
            glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, index);
            glMaterialf(GL_FRONT, GL_SHININESS, shininess);
        }
        glNormal3d(n[0], n[1], n[2]);
        glVertex2d(x, y);
        truth[i] = lit_index(lights, count, V, n, local_viewer, (double)shininess, index);
    }
    glEnd();
    glFinish();
    for (int i = 0; i < POINTS; i++)
        if (fabs(index_of[4 * (i / 16)][4 * (i % 16)] - truth[i]) > 0.5 + 1e-2) {
            print_error("seed %u, vertex %d: %d, expected %.9g\n", seed, i, index_of[4 * (i / 16)][4 * (i % 16)],
                        truth[i]);
            fail();
        }
    glPopAttrib();
    for (int i = 0; i < count; i++)
        glDisable(GL_LIGHT0 + (GLenum)i);
}

static void lit_indexes(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 40; seed++) {
        light_points(seed, false);
        light_points(seed, true);
    }
}

static void lit_indexes_exact(void **state)
{
    (void)state;
    fixedglAccuracy(FIXEDGL_EXACT);
    for (uint32_t seed = 41; seed <= 60; seed++) {
        light_points(seed, false);
        light_points(seed, true);
    }
}

/* The intensities are not clamped, the result is: c' = min(c, s_m), then masked. */
static void lit_extremes(void **state)
{
    (void)state;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){3, 3, 3, 1}); /* d = 3 */
    glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){0, 0, 0, 1});
    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});
    glNormal3f(0, 0, 1);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){10, 40, 250});
    point(1, 1);
    EXPECT_PIXEL(1, 1, 10 + 3 * 30);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){10, 40, 70});
    point(1, 1);
    EXPECT_PIXEL(1, 1, 70);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){266, 296, 1000});
    point(1, 1);
    EXPECT_PIXEL(1, 1, (266 + 3 * 30) & 255);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){10, 40, 200});
    glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){2, 2, 2, 1}); /* s' = 1 */
    point(1, 1);
    EXPECT_PIXEL(1, 1, 200);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){10, 10, 10, 1}); /* nothing of it: 1 - s' is 0, not -1 */
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){10, 160, 200});
    point(1, 1);
    EXPECT_PIXEL(1, 1, 200);
    glDisable(GL_LIGHT0);
    point(1, 1);
    EXPECT_PIXEL(1, 1, 10);
    glEnable(GL_COLOR_MATERIAL); /* RGBA materials only */
    glIndexi(99);
    glColor3f(1, 1, 1);
    point(1, 1);
    EXPECT_PIXEL(1, 1, 10);
}

/* The default material: 0, 1, 1. */
static void two_sided(void **state)
{
    (void)state;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){0, 0, 0, 1});
    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){10, 40, 250});
    glMaterialfv(GL_BACK, GL_COLOR_INDEXES, (GLfloat[]){100, 140, 250});
    glNormal3f(0, 0, 1);
    square(0, 0, 10, 10);
    square(30, 10, 20, 0); /* the same direction */
    square(50, 0, 40, 10); /* clockwise: its normal turns away from the light */
    EXPECT_PIXEL(5, 5, 40);
    EXPECT_PIXEL(25, 5, 40);
    EXPECT_PIXEL(45, 5, 100);
    glNormal3f(0, 0, -1);
    square(0, 0, 10, 10);
    square(50, 0, 40, 10);
    EXPECT_PIXEL(5, 5, 10);
    EXPECT_PIXEL(45, 5, 140);
}

/* 2.13: the raster position's index is lit, and bitmaps have it. */
static void lit_raster_position(void **state)
{
    static const GLubyte bits[4] = {0xc0, 0, 0, 0};
    (void)state;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const struct test_light L = {.diffuse = {1, 0.5f, 0.25f, 1}, .position = {0, 0.6f, 0.8f, 0},
                                 .spot_cutoff = 180, .k = {1, 0, 0}};
    set_light(0, &L);
    const float index[3] = {20, 120, 250};
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, index);
    glNormal3f(0, 0, 1);
    glRasterPos2i(30, 30);
    const double truth = lit_index(&L, 1, (double[]){30, 30, 0}, (double[]){0, 0, 1}, false, 0, index);
    GLfloat raster = 0;
    glGetFloatv(GL_CURRENT_RASTER_INDEX, &raster);
    assert_true(fabs((double)raster - truth) < 1e-3);
    glBitmap(2, 1, 0, 0, 3, 0, bits);
    EXPECT_NEAR(pixel(30, 30), truth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            INDEX_TEST(lit_indexes),
            INDEX_TEST(lit_indexes_exact),
            INDEX_TEST(lit_extremes),
            INDEX_TEST(two_sided),
            INDEX_TEST(lit_raster_position),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
