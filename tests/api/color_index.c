/* Colour index mode, which Mesa's OSMesa does not have: the truth is computed here, in double, from the equations of
 * the specification (OpenGL 1.5). The window is 64 x 64; object coordinates are window coordinates unless a test
 * says otherwise. */
#include "api/gl_test.h"

#include <math.h>

static unsigned char index_of[TEST_SIZE][TEST_SIZE]; /* [y][x], as the buffer has it after glFinish */

static int make_index_context(void **state)
{
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_COLOR_INDEX, 24, 8, 16, NULL);
    *state = context;
    memset(index_of, 0xee, sizeof index_of);
    if (!context || !OSMesaMakeCurrent(context, index_of, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE))
        return -1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 0, -1); /* depth is z */
    glMatrixMode(GL_MODELVIEW);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return glGetError() == GL_NO_ERROR ? 0 : -1;
}

#define INDEX_TEST(function) cmocka_unit_test_setup_teardown(function, make_index_context, destroy_context)

static int pixel(int x, int y)
{
    glFinish();
    return index_of[y][x];
}

/* The pixel is the integer nearest to the value, either one at a tie. */
static void check_near(int got, double truth, const char *what, const char *file, int line)
{
    if (fabs(got - truth) <= 0.5 + 1e-3)
        return;
    print_error("%s:%d: %s: %d, expected %.9g\n", file, line, what, got, truth);
    _fail(file, line);
}
#define EXPECT_NEAR(got, truth) check_near((got), (truth), #got, __FILE__, __LINE__)
#define EXPECT_PIXEL(x, y, value) assert_int_equal(pixel(x, y), (value))

static void point(double x, double y)
{
    glBegin(GL_POINTS);
    glVertex2d(x + 0.5, y + 0.5);
    glEnd();
}

static void square(int x0, int y0, int x1, int y1)
{
    glRecti(x0, y0, x1, y1);
}

/* ---- the framebuffer ---- */

static void framebuffer(void **state)
{
    (void)state;
    EXPECT_INTS(GL_INDEX_MODE, 1);
    EXPECT_INTS(GL_RGBA_MODE, 0);
    EXPECT_INTS(GL_INDEX_BITS, 8);
    EXPECT_INTS(GL_RED_BITS, 0);
    EXPECT_INTS(GL_ALPHA_BITS, 0);
    EXPECT_INTS(GL_ACCUM_RED_BITS, 0);
    EXPECT_INTS(GL_DEPTH_BITS, 24);
    EXPECT_INTS(GL_STENCIL_BITS, 8);
    EXPECT_ERROR(GL_INVALID_OPERATION, glAccum(GL_LOAD, 1)); /* 4.2.4: RGBA mode only */
    GLint format = 0;
    OSMesaGetIntegerv(OSMESA_FORMAT, &format);
    assert_int_equal(format, OSMESA_COLOR_INDEX);
    assert_false(OSMesaMakeCurrent(*state, picture, GL_FLOAT, 4, 4));
    assert_false(OSMesaMakeCurrent(*state, picture, GL_UNSIGNED_SHORT, 4, 4));
}

static void rgba_context(void **state)
{
    unsigned char index;
    (void)state;
    EXPECT_INTS(GL_INDEX_MODE, 0);
    EXPECT_INTS(GL_RGBA_MODE, 1);
    EXPECT_INTS(GL_INDEX_BITS, 0);
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &index));
    glIndexi(7); /* state all the same */
    EXPECT_VALUES(GL_CURRENT_INDEX, 7);
}

static void row_layout(void **state)
{
    unsigned char rows[2][5];
    memset(rows, 9, sizeof rows);
    assert_true(OSMesaMakeCurrent(*state, rows, GL_UNSIGNED_BYTE, 3, 2));
    OSMesaPixelStore(OSMESA_ROW_LENGTH, 5);
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    glClearIndex(1);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(0, 0, 3, 2);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 3, 0, 2, -1, 1);
    glIndexi(4);
    square(0, 1, 1, 2); /* top left */
    glFinish();
    const unsigned char expected[2][5] = {{4, 1, 1, 9, 9}, {1, 1, 1, 9, 9}};
    assert_memory_equal(rows, expected, sizeof rows);
}

/* 4.2.3: the integer part of the clear index, masked; scissor and index mask apply. */
static void clearing(void **state)
{
    (void)state;
    glClearIndex(256 + 37.75f);
    EXPECT_VALUES(GL_INDEX_CLEAR_VALUE, 256 + 37.75f);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_PIXEL(0, 0, 37);
    EXPECT_PIXEL(63, 63, 37);
    glIndexMask(0xf0);
    EXPECT_INTS(GL_INDEX_WRITEMASK, 0xf0);
    glClearIndex(0x5a);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 20, 3, 2);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_PIXEL(10, 20, 0x50 | (37 & 0x0f));
    EXPECT_PIXEL(12, 21, 0x50 | (37 & 0x0f));
    EXPECT_PIXEL(13, 21, 37);
    EXPECT_PIXEL(12, 22, 37);
    glClearIndex(-1);
    glIndexMask(~0u);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_PIXEL(10, 20, 255);
}

/* ---- vertices ---- */

/* 2.7, 2.14.6: every form of glIndex; the integer part is masked with 255, the nearest index is written. */
static void current_index(void **state)
{
    (void)state;
    const GLshort s = 18;
    const GLint i = 19;
    const GLfloat f = 20.25f;
    const GLdouble d = 21.75;
    const GLubyte ub = 22;
    static const struct {
        float index;
        int stored;
    } masked[] = {{0, 0}, {255, 255}, {256, 0}, {300, 44}, {-1, 255}, {-256, 0}, {1000.75f, 233}, {255.75f, 255},
                  {65536 * 3 + 5, 5}, {-2147483648.0f, 0}, {3e38f, 0}, {-0.25f, 255}};
#define EXPECT_INDEX(call, current, stored)                                                                  \
    do {                                                                                                     \
        call;                                                                                                \
        EXPECT_VALUES(GL_CURRENT_INDEX, current);                                                            \
        point(5, 5);                                                                                         \
        EXPECT_PIXEL(5, 5, stored);                                                                          \
    } while (0)
    EXPECT_INDEX(glIndexs(13), 13, 13);
    EXPECT_INDEX(glIndexi(14), 14, 14);
    EXPECT_INDEX(glIndexf(15.25f), 15.25f, 15);
    EXPECT_INDEX(glIndexd(16.75), 16.75f, 17);
    EXPECT_INDEX(glIndexub(200), 200, 200);
    EXPECT_INDEX(glIndexsv(&s), 18, 18);
    EXPECT_INDEX(glIndexiv(&i), 19, 19);
    EXPECT_INDEX(glIndexfv(&f), 20.25f, 20);
    EXPECT_INDEX(glIndexdv(&d), 21.75f, 22);
    EXPECT_INDEX(glIndexubv(&ub), 22, 22);
    for (size_t k = 0; k < sizeof masked / sizeof *masked; k++)
        EXPECT_INDEX(glIndexf(masked[k].index), masked[k].index, masked[k].stored);
    glColor3f(1, 1, 1); /* no effect */
    point(6, 6);
    EXPECT_PIXEL(6, 6, 255);
    for (size_t k = 0; k < sizeof masked / sizeof *masked; k++) { /* differing by vertex */
        glBegin(GL_POINTS);
        glIndexf(masked[k].index);
        glVertex2f(7.5f, 7.5f);
        glIndexi(3);
        glVertex2f(8.5f, 8.5f);
        glEnd();
        EXPECT_PIXEL(7, 7, masked[k].stored);
        EXPECT_PIXEL(8, 8, 3);
    }
}

static void arrays(void **state)
{
    static const GLfloat position[3][2] = {{1.5f, 1.5f}, {2.5f, 2.5f}, {3.5f, 3.5f}};
    static const GLubyte bytes[3] = {200, 201, 202};
    static const GLshort shorts[6] = {-1, 0, 5, 0, 6, 0};
    static const GLint ints[3] = {7, 8, 9};
    static const GLfloat floats[3] = {10.25f, 11, 12};
    static const GLdouble doubles[3] = {13, 14, 15};
    static const struct {
        GLenum type;
        GLsizei stride;
        const void *pointer;
        int expected[3];
    } array[] = {{GL_UNSIGNED_BYTE, 0, bytes, {200, 201, 202}}, {GL_SHORT, 4, shorts, {255, 5, 6}},
                 {GL_INT, 0, ints, {7, 8, 9}}, {GL_FLOAT, 0, floats, {10, 11, 12}},
                 {GL_DOUBLE, 0, doubles, {13, 14, 15}}};
    (void)state;
    glVertexPointer(2, GL_FLOAT, 0, position);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_INDEX_ARRAY);
    for (size_t k = 0; k < sizeof array / sizeof *array; k++) {
        glIndexPointer(array[k].type, array[k].stride, array[k].pointer);
        glDrawArrays(GL_POINTS, 0, 3);
        for (int i = 0; i < 3; i++)
            EXPECT_PIXEL(1 + i, 1 + i, array[k].expected[i]);
    }
    glBegin(GL_POINTS);
    glArrayElement(2);
    glEnd();
    EXPECT_VALUES(GL_CURRENT_INDEX, 15);
    EXPECT_ERROR(GL_INVALID_ENUM, glIndexPointer(GL_BYTE, 0, bytes));
}

/* ---- interpolation ---- */

/* Barycentric coordinates of the centre of pixel (x, y); false outside. */
static bool inside(const double v[3][2], int x, int y, double b[3])
{
    const double px = x + 0.5, py = y + 0.5;
    const double area = (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[2][0] - v[0][0]) * (v[1][1] - v[0][1]);
    for (int i = 0; i < 3; i++) {
        const double *p = v[(i + 1) % 3], *q = v[(i + 2) % 3];
        b[i] = ((q[0] - p[0]) * (py - p[1]) - (px - p[0]) * (q[1] - p[1])) / area;
    }
    return b[0] > 1e-6 && b[1] > 1e-6 && b[2] > 1e-6;
}

/* 3.5.1, equation 3.6: a triangle whose corners have the clip coordinate w. */
static void check_triangle(const double v[3][2], const double index[3], const double w[3])
{
    int checked = 0;
    glFinish();
    for (int y = 0; y < TEST_SIZE; y++)
        for (int x = 0; x < TEST_SIZE; x++) {
            double b[3];
            if (!inside(v, x, y, b))
                continue;
            const double over = b[0] / w[0] + b[1] / w[1] + b[2] / w[2];
            const double sum = b[0] * index[0] / w[0] + b[1] * index[1] / w[1] + b[2] * index[2] / w[2];
            EXPECT_NEAR(index_of[y][x], sum / over);
            checked++;
        }
    assert_true(checked > 500);
}

static void draw_triangle(const double v[3][2], const double index[3], const double w[3])
{
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        glIndexd(index[i]);
        glVertex4d(v[i][0] * w[i], v[i][1] * w[i], 0, w[i]);
    }
    glEnd();
}

static void smooth_triangles(void **state)
{
    static const double v[3][2] = {{3, 2}, {61, 9}, {22, 62}}, index[3] = {16.25, 250.5, 90};
    static const double one[3] = {1, 1, 1}, w[3] = {1, 3, 0.5};
    (void)state;
    draw_triangle(v, index, one);
    check_triangle(v, index, one);
    draw_triangle(v, index, w);
    check_triangle(v, index, w);
}

/* 2.12: what is clipped off changes nothing else. */
static void clipped_triangle(void **state)
{
    static const double v[3][2] = {{-40, -10}, {120, 8}, {20, 150}}, index[3] = {0, 255, 100}, one[3] = {1, 1, 1};
    (void)state;
    draw_triangle(v, index, one);
    check_triangle(v, index, one);
}

static void flat_shading(void **state)
{
    (void)state;
    glShadeModel(GL_FLAT);
    static const double v[3][2] = {{3, 2}, {61, 9}, {22, 62}}, index[3] = {16, 250, 90.25}, one[3] = {1, 1, 1};
    draw_triangle(v, index, one);
    EXPECT_PIXEL(25, 20, 90); /* 2.14.7: the last vertex's */
    glBegin(GL_LINES);
    glIndexi(1);
    glVertex2f(0.5f, 60.5f);
    glIndexi(2);
    glVertex2f(60.5f, 60.5f);
    glEnd();
    EXPECT_PIXEL(5, 60, 2);
    EXPECT_PIXEL(50, 60, 2);
}

/* 3.4.1: t along the line from the centre of the pixel. */
static void smooth_line(void **state)
{
    (void)state;
    glBegin(GL_LINES);
    glIndexi(20);
    glVertex2f(2.5f, 10.5f);
    glIndexi(221);
    glVertex2f(62.5f, 10.5f);
    glEnd();
    glFinish();
    for (int x = 2; x < 62; x++)
        EXPECT_NEAR(index_of[10][x], 20 + 201.0 * (x - 2) / 60);
}

/* ---- lighting ---- */

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

/* ---- fragments ---- */

/* 3.10: I = i_r + (1 - f) i_f, masked. */
static double fogged(double index, double fog_index, double f)
{
    const double clamped = f < 0 ? 0 : f > 1 ? 1 : f;
    return fmod(index + (1 - clamped) * fog_index, 256);
}

static void fog(void **state)
{
    (void)state;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 64, 0, 64, 0, 32);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_FOG);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 28);
    glFogf(GL_FOG_DENSITY, 0.06f);
    static const GLenum mode[] = {GL_LINEAR, GL_EXP, GL_EXP2};
    for (int m = 0; m < 3; m++)
        for (int k = 0; k < 2; k++) {
            const double fog_index = k ? 300 : 64;
            glFogi(GL_FOG_MODE, (GLint)mode[m]);
            glFogf(GL_FOG_INDEX, (GLfloat)fog_index);
            glBegin(GL_QUADS);
            glIndexi(40);
            glVertex3f(0, 0, -0.5f);
            glVertex3f(64, 0, -32.5f);
            glVertex3f(64, 8, -32.5f);
            glVertex3f(0, 8, -0.5f);
            glEnd();
            glFinish();
            for (int x = 0; x < 63; x++) {
                const double z = 0.5 + 32 * (x + 0.5) / 64, e = 0.06 * z;
                const double f = m == 0 ? (28 - z) / 24 : m == 1 ? exp(-e) : exp(-e * e);
                const double truth = fogged(40, fog_index, f);
                if (truth < 255.999) /* there it wraps around */
                    EXPECT_NEAR(index_of[4][x], truth < 255 ? truth : 255);
            }
        }
    EXPECT_VALUES(GL_FOG_INDEX, 300);
}

/* 4.1.10: logical operations on indexes; 4.2.2: the index mask. */
static void logic_op(void **state)
{
    (void)state;
    const int s = 0x5c, d = 0x3a;
    const int expected[16] = {0,        s & d,     s & ~d, s,         ~s & d, d,       s ^ d,  s | d,
                              ~(s | d), ~(s ^ d), ~d,     s | ~d, ~s,     ~s | d, ~(s & d), 255};
    EXPECT_INTS(GL_INDEX_LOGIC_OP, 0);
    for (int op = 0; op < 16; op++)
        for (int masked = 0; masked < 2; masked++) {
            const int mask = masked ? 0x3c : 0xff;
            glDisable(GL_LOGIC_OP);
            glIndexMask(~0u);
            glIndexi(d);
            point(3, 3);
            glEnable(GL_INDEX_LOGIC_OP);
            glIndexMask((GLuint)mask);
            glLogicOp(GL_CLEAR + (GLenum)op);
            glIndexi(s);
            point(3, 3);
            EXPECT_PIXEL(3, 3, (expected[op] & mask) | (d & ~mask & 255));
        }
    glDisable(GL_INDEX_LOGIC_OP);
    glEnable(GL_COLOR_LOGIC_OP); /* RGBA mode only */
    glIndexMask(~0u);
    glLogicOp(GL_CLEAR);
    point(3, 3);
    EXPECT_PIXEL(3, 3, s);
}

/* 4.1.4, 4.1.8, 4.2.2: alpha test, blending and colour mask are for RGBA alone. */
static void rgba_operations(void **state)
{
    (void)state;
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_NEVER, 0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE);
    glColorMask(0, 0, 0, 0);
    glEnable(GL_COLOR_SUM);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glIndexi(77);
    point(3, 3);
    EXPECT_PIXEL(3, 3, 77);
    glClearIndex(5);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_PIXEL(3, 3, 5);
    glDrawBuffer(GL_NONE);
    point(3, 3);
    EXPECT_PIXEL(3, 3, 5);
}

static void tests_of_fragments(void **state)
{
    (void)state;
    glEnable(GL_DEPTH_TEST);
    glIndexi(1);
    glBegin(GL_POINTS);
    glVertex3f(1.5f, 1.5f, 0.5f);
    glIndexi(2);
    glVertex3f(1.5f, 1.5f, 0.75f);
    glVertex3f(2.5f, 1.5f, 0.75f);
    glEnd();
    EXPECT_PIXEL(1, 1, 1);
    EXPECT_PIXEL(2, 1, 2);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glIndexi(3);
    point(4, 4);
    glIndexi(4);
    point(4, 4);
    EXPECT_PIXEL(4, 4, 3);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(20, 20, 4, 4);
    glIndexi(5);
    square(0, 0, 64, 64);
    EXPECT_PIXEL(19, 20, 0);
    EXPECT_PIXEL(20, 20, 5);
    EXPECT_PIXEL(23, 23, 5);
    EXPECT_PIXEL(24, 23, 0);
}

static void stipples(void **state)
{
    (void)state;
    GLubyte pattern[128];
    for (int i = 0; i < 128; i++)
        pattern[i] = i / 4 % 2 ? 0x55 : 0xaa;
    glPolygonStipple(pattern);
    glEnable(GL_POLYGON_STIPPLE);
    glIndexi(9);
    square(0, 0, 64, 32);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x00ff);
    glBegin(GL_LINES);
    glVertex2f(0.5f, 40.5f);
    glVertex2f(64.5f, 40.5f);
    glEnd();
    glFinish();
    for (int x = 0; x < 64; x++) {
        assert_int_equal(index_of[0][x], x % 2 ? 0 : 9);
        assert_int_equal(index_of[1][x], x % 2 ? 9 : 0);
        assert_int_equal(index_of[40][x], x / 16 % 2 ? 0 : 9);
    }
}

/* 3.2, 3.11: the low four bits of the index are the coverage. */
static void antialiasing(void **state)
{
    (void)state;
    glEnable(GL_LINE_SMOOTH);
    glLineWidth(5);
    glIndexi(0x53);
    glBegin(GL_LINES);
    glVertex2f(4, 20);
    glVertex2f(60, 20);
    glEnd();
    glFinish();
    int complete = 0, partial = 0;
    for (int y = 14; y < 27; y++) {
        const int v = index_of[y][32];
        complete += v == 0x5f;
        partial += v >= 0x50 && v < 0x5f;
        assert_true(v == 0 || (v & 0xf0) == 0x50);
    }
    assert_int_equal(complete, 4); /* rows 18 to 21: the line is 17.5 to 22.5 */
    assert_int_equal(partial, 2);
    assert_int_equal(index_of[17][32], index_of[22][32]);
    EXPECT_NEAR(index_of[17][32] & 15, 15 * 0.5);

    glEnable(GL_POINT_SMOOTH);
    glPointSize(9);
    glIndexi(0x60);
    point(40, 45);
    EXPECT_PIXEL(40, 45, 0x6f);
    EXPECT_PIXEL(40, 52, 0);
    glEnable(GL_POLYGON_SMOOTH);
    glIndexi(0x70);
    square(2, 50, 12, 60);
    EXPECT_PIXEL(5, 55, 0x7f);
    glDisable(GL_POLYGON_SMOOTH);
    square(2, 50, 12, 60);
    EXPECT_PIXEL(5, 55, 0x70);
}

/* ---- pixels ---- */

static void draw_pixels(void **state)
{
    (void)state;
    static const GLubyte bytes[2][4] = {{1, 2, 3, 250}, {5, 6, 7, 8}};
    static const GLfloat floats[4] = {20, 300, 22.75f, -1};
    static const GLubyte bits[2] = {0xa0, 0x50};
    const float rgba[4] = {1, 1, 1, 1};
    glRasterPos2i(10, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(10, 10, 1);
    EXPECT_PIXEL(13, 10, 250);
    EXPECT_PIXEL(13, 11, 8);
    glRasterPos2i(20, 10);
    glDrawPixels(4, 1, GL_COLOR_INDEX, GL_FLOAT, floats);
    EXPECT_PIXEL(20, 10, 20);
    EXPECT_PIXEL(21, 10, 44);
    EXPECT_PIXEL(23, 10, 255);
    glPixelTransferi(GL_INDEX_SHIFT, 2);
    glPixelTransferi(GL_INDEX_OFFSET, 3);
    glRasterPos2i(10, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(10, 10, 7);
    EXPECT_PIXEL(13, 10, (250 * 4 + 3) & 255);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2i(30, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_BITMAP, bits);
    EXPECT_PIXEL(30, 10, 7);
    EXPECT_PIXEL(31, 10, 3);
    EXPECT_PIXEL(30, 11, 3);
    EXPECT_PIXEL(31, 11, 7);
    const GLfloat map[4] = {90, 91, 92, 93};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_I, 4, map);
    glPixelTransferi(GL_MAP_COLOR, 1);
    glRasterPos2i(10, 10);
    glDrawPixels(4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes); /* 4 i + 3 is 3 in the map's size */
    EXPECT_PIXEL(10, 10, 93);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, rgba));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_LUMINANCE, GL_FLOAT, rgba));
    glPixelZoom(3, 2);
    glPixelTransferi(GL_MAP_COLOR, 0);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glRasterPos2i(40, 40);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(42, 41, 1);
    EXPECT_PIXEL(43, 41, 2);
    EXPECT_PIXEL(43, 42, 6);
    glLogicOp(GL_XOR);
    glEnable(GL_INDEX_LOGIC_OP);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(43, 42, 0);
}

static void read_and_copy(void **state)
{
    (void)state;
    GLubyte got[4] = {0}, bits = 0;
    GLfloat real[2], rgba[4];
    GLushort wide[2];
    for (int i = 0; i < 4; i++) {
        glIndexi(100 + i);
        point(i, 0);
    }
    glReadPixels(0, 0, 4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((GLubyte[]){100, 101, 102, 103}), 4);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_FLOAT, real);
    check_floats(real, (GLfloat[]){102, 103}, 2, "floats", __FILE__, __LINE__);
    glReadPixels(0, 0, 4, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    assert_int_equal(bits & 0xf0, 0x50);
    glPixelTransferi(GL_INDEX_SHIFT, 3);
    glPixelTransferi(GL_INDEX_OFFSET, -1);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_UNSIGNED_SHORT, wide);
    assert_int_equal(wide[0], 102 * 8 - 1);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0], (102 * 8 - 1) & 255);
    glReadPixels(2, 0, 1, 1, GL_COLOR_INDEX, GL_BYTE, got); /* table 4.8: masked with 2^7 - 1 */
    assert_int_equal(got[0], (102 * 8 - 1) & 127);
    glRasterPos2i(10, 5);
    glCopyPixels(0, 0, 4, 1, GL_COLOR); /* transfer applies once */
    EXPECT_PIXEL(11, 5, (101 * 8 - 1) & 255);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glRasterPos2i(10, 6);
    glCopyPixels(0, 0, 4, 1, GL_COLOR);
    EXPECT_PIXEL(13, 6, 103);

    /* 3.6.5 "Color Index Lookup": colours are read through the maps */
    const GLfloat red[2] = {0.25f, 0.5f}, green[4] = {0, 0.125f, 0.75f, 1}, blue[1] = {0.625f}, alpha[2] = {1, 0};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 4, green);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 1, blue);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, alpha);
    glPixelTransferf(GL_RED_SCALE, 0.5f); /* for groups that are RGBA from the start */
    glReadPixels(1, 0, 1, 1, GL_RGBA, GL_FLOAT, rgba);
    check_floats(rgba, (GLfloat[]){0.5f, 0.125f, 0.625f, 0}, 4, "rgba", __FILE__, __LINE__);
    glReadPixels(2, 0, 1, 1, GL_BGRA, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0], 159); /* 0.625 * 255 = 159.4 */
    assert_int_equal(got[1], 191); /* 191.25 */
    assert_int_equal(got[2], 64);  /* 63.75 */
    assert_int_equal(got[3], 255);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_FLOAT, rgba); /* .25 + 0 + .625 */
    check_floats(rgba, (GLfloat[]){0.875f}, 1, "luminance", __FILE__, __LINE__);
    EXPECT_NO_ERROR((void)0);
}

/* 3.7 and 2.13: bitmaps have the raster position's index. */
static void bitmaps(void **state)
{
    static const GLubyte bits[4] = {0xc0, 0, 0, 0};
    (void)state;
    glIndexf(333);
    glRasterPos2i(10, 10);
    glIndexi(5); /* too late */
    EXPECT_VALUES(GL_CURRENT_RASTER_INDEX, 333);
    glBitmap(2, 1, 0, 0, 3, 0, bits);
    EXPECT_PIXEL(10, 10, 333 & 255);
    EXPECT_PIXEL(11, 10, 333 & 255);
    EXPECT_PIXEL(12, 10, 0);
    glWindowPos2i(20, 20);
    glBitmap(2, 1, 0, 0, 3, 0, bits);
    EXPECT_PIXEL(20, 20, 5);

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

/* ---- what else handles indexes ---- */

/* 5.3, table 5.1: the colour of a vertex is one value. */
static void feedback(void **state)
{
    static GLfloat buffer[64];
    (void)state;
    glFeedbackBuffer(64, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_LINES);
    glIndexf(12.25f);
    glVertex3f(1, 2, 0.5f);
    glIndexi(300);
    glVertex3f(3, 4, 0.25f);
    glEnd();
    glIndexi(7);
    glRasterPos2i(5, 6);
    glBitmap(0, 0, 0, 0, 0, 0, NULL);
    assert_int_equal(glRenderMode(GL_RENDER), 14);
    const GLfloat expected[14] = {GL_LINE_RESET_TOKEN, 1, 2, 0.5f, 12.25f, 3, 4, 0.25f, 300 & 255,
                                  GL_BITMAP_TOKEN,     5, 6, 0,    7};
    check_floats(buffer, expected, 14, "feedback", __FILE__, __LINE__);
}

static void selection(void **state)
{
    GLuint buffer[16] = {0};
    (void)state;
    glSelectBuffer(16, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(6);
    square(1, 1, 5, 5);
    assert_int_equal(glRenderMode(GL_RENDER), 1);
    assert_int_equal(buffer[3], 6);
    EXPECT_PIXEL(2, 2, 0);
}

/* 5.1: index(u) = 40 (1-u) + 200 u; evaluated indexes are not current values. */
static void evaluators(void **state)
{
    static const GLfloat index[2] = {40, 200}, line[2][3] = {{2.5f, 3.5f, 0}, {58.5f, 3.5f, 0}};
    static const GLfloat corner_index[4] = {0, 80, 160, 240},
                         corner[4][3] = {{0, 8, 0}, {0, 64, 0}, {64, 8, 0}, {64, 64, 0}};
    (void)state;
    glIndexi(11);
    glMap1f(GL_MAP1_INDEX, 0, 1, 1, 2, index);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, &line[0][0]);
    glEnable(GL_MAP1_INDEX);
    glEnable(GL_MAP1_VERTEX_3);
    glBegin(GL_POINTS);
    for (int i = 0; i < 8; i++)
        glEvalCoord1f((GLfloat)i / 7);
    glEnd();
    glFinish();
    for (int i = 0; i < 8; i++)
        EXPECT_NEAR(index_of[3][2 + 8 * i], 40 + 160 * i / 7.0);
    EXPECT_VALUES(GL_CURRENT_INDEX, 11);
    glMap2f(GL_MAP2_INDEX, 0, 1, 2, 2, 0, 1, 1, 2, corner_index);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, &corner[0][0]);
    glEnable(GL_MAP2_INDEX);
    glEnable(GL_MAP2_VERTEX_3);
    glMapGrid2f(4, 0, 1, 4, 0, 1);
    glEvalMesh2(GL_FILL, 0, 4, 0, 4);
    glFinish();
    for (int y = 9; y < 63; y += 3)
        for (int x = 1; x < 63; x++)
            EXPECT_NEAR(index_of[y][x], 160 * (x + 0.5) / 64 + 80 * (y + 0.5 - 8) / 56);
}

static void lists_and_attributes(void **state)
{
    static const GLubyte bytes[2] = {60, 61};
    (void)state;
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glIndexi(50);
    glBegin(GL_POINTS);
    glVertex2f(1.5f, 1.5f);
    glIndexi(51);
    glVertex2f(2.5f, 1.5f);
    glEnd();
    glIndexMask(0x0f);
    glClearIndex(3);
    glRasterPos2i(5, 5);
    glDrawPixels(2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    glEndList();
    EXPECT_VALUES(GL_CURRENT_INDEX, 1);
    glPushAttrib(GL_CURRENT_BIT | GL_COLOR_BUFFER_BIT);
    glCallList(list);
    EXPECT_VALUES(GL_CURRENT_INDEX, 51);
    EXPECT_INTS(GL_INDEX_WRITEMASK, 0x0f);
    glEnable(GL_INDEX_LOGIC_OP);
    glPopAttrib();
    EXPECT_VALUES(GL_CURRENT_INDEX, 1);
    EXPECT_INTS(GL_INDEX_WRITEMASK, -1);
    EXPECT_VALUES(GL_INDEX_CLEAR_VALUE, 0);
    EXPECT_INTS(GL_INDEX_LOGIC_OP, 0);
    EXPECT_PIXEL(1, 1, 50);
    EXPECT_PIXEL(2, 1, 51);
    EXPECT_PIXEL(5, 5, 60 & 0x0f);
    EXPECT_PIXEL(6, 5, 61 & 0x0f);
    glFogf(GL_FOG_INDEX, 8);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){4, 5, 6});
    glPushAttrib(GL_FOG_BIT | GL_LIGHTING_BIT);
    glFogf(GL_FOG_INDEX, 9);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){7, 8, 9});
    glPopAttrib();
    EXPECT_VALUES(GL_FOG_INDEX, 8);
    EXPECT_MATERIAL(GL_FRONT, GL_COLOR_INDEXES, 4, 5, 6);
}

/* 3.8: textures are for RGBA mode. */
static void textures(void **state)
{
    static const GLubyte white[4] = {255, 255, 255, 255};
    (void)state;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        glIndexi(40 + i);
        glTexCoord2i(i, i);
        glVertex2i(i == 1 ? 60 : 2, i == 2 ? 60 : 2);
    }
    glEnd();
    assert_in_range(pixel(20, 20), 40, 42);
}

static void polygon_modes(void **state)
{
    (void)state;
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glIndexi(21);
    glBegin(GL_QUADS);
    glVertex2f(4.5f, 4.5f);
    glVertex2f(20.5f, 4.5f);
    glVertex2f(20.5f, 20.5f);
    glVertex2f(4.5f, 20.5f);
    glEnd();
    EXPECT_PIXEL(12, 4, 21);
    EXPECT_PIXEL(12, 12, 0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    square(30, 30, 40, 40);
    EXPECT_PIXEL(35, 30, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            INDEX_TEST(framebuffer),      GL_TEST(rgba_context),        INDEX_TEST(row_layout),
            INDEX_TEST(clearing),         INDEX_TEST(current_index),    INDEX_TEST(arrays),
            INDEX_TEST(smooth_triangles), INDEX_TEST(clipped_triangle), INDEX_TEST(flat_shading),
            INDEX_TEST(smooth_line),      INDEX_TEST(lit_indexes),      INDEX_TEST(lit_indexes_exact),
            INDEX_TEST(lit_extremes),     INDEX_TEST(two_sided),        INDEX_TEST(fog),
            INDEX_TEST(logic_op),         INDEX_TEST(rgba_operations),  INDEX_TEST(tests_of_fragments),
            INDEX_TEST(stipples),         INDEX_TEST(antialiasing),     INDEX_TEST(draw_pixels),
            INDEX_TEST(read_and_copy),    INDEX_TEST(bitmaps),          INDEX_TEST(feedback),
            INDEX_TEST(selection),        INDEX_TEST(evaluators),       INDEX_TEST(lists_and_attributes),
            INDEX_TEST(textures),         INDEX_TEST(polygon_modes),    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
