/* Evaluators (GL 1.5, 5.1): values, read back through feedback, current values, grids, meshes, lists,
 * queries, errors. */
#include "api/gl_test.h"

#include <math.h>

enum { ROOM = 4096 };
static GLfloat buffer[ROOM];

static int start(void **state)
{
    if (make_context(state))
        return -1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 0, -1); /* window coordinates, depth is z */
    glMatrixMode(GL_MODELVIEW);
    return 0;
}

#define EVAL_TEST(function) cmocka_unit_test_setup_teardown(function, start, destroy_context)

static void begin(GLenum type)
{
    glFeedbackBuffer(ROOM, type, buffer);
    glRenderMode(GL_FEEDBACK);
}

#define EXPECT_BUFFER(...)                                                                                   \
    do {                                                                                                     \
        const GLfloat expected_[] = {__VA_ARGS__};                                                           \
        const int n_ = (int)(sizeof expected_ / sizeof *expected_);                                          \
        assert_int_equal(glRenderMode(GL_RENDER), n_);                                                       \
        check_floats(buffer, expected_, (size_t)n_, "feedback", __FILE__, __LINE__);                         \
        assert_int_equal(glGetError(), GL_NO_ERROR);                                                         \
    } while (0)

#define POINT GL_POINT_TOKEN
#define TRIANGLE GL_POLYGON_TOKEN, 3

static const GLfloat segment[2][3] = {{16, 32, 0.5f}, {48, 32, 0.5f}};
static const GLfloat plane[2][2][3] = {{{0, 0, 0}, {0, 64, 0}}, {{64, 0, 0}, {64, 64, 0}}}; /* [u][v] */

static void enable_segment(void)
{
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, segment[0]);
    glEnable(GL_MAP1_VERTEX_3);
}

static void enable_plane(void)
{
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, plane[0][0]);
    glEnable(GL_MAP2_VERTEX_3);
}

/* The sum of Bernstein polynomials, in double. */
static double bernstein(const GLfloat *p, int stride, int order, double t)
{
    double sum = 0, binomial = 1;
    for (int i = 0; i < order; i++) {
        sum += binomial * pow(t, i) * pow(1 - t, order - 1 - i) * (double)p[i * stride];
        binomial = binomial * (order - 1 - i) / (i + 1);
    }
    return sum;
}

static void fill(GLfloat *p, int n)
{
    unsigned seed = 12345;
    for (int i = 0; i < n; i++) {
        seed = seed * 1664525u + 1013904223u;
        p[i] = (GLfloat)(seed >> 16) / 65536.0f;
    }
}

/* Texture coordinates of an evaluated point: component k stands at buffer[8 + k]. */
static void curve_values(void **state)
{
    (void)state;
    GLfloat p[30 * 5];
    const GLenum target[4] = {GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_2, GL_MAP1_TEXTURE_COORD_3,
                              GL_MAP1_TEXTURE_COORD_4};
    fill(p, 30 * 5);
    enable_segment();
    for (int order = 1; order <= 30; order++) {
        const int size = order % 4 + 1;
        glMap1f(target[size - 1], -1, 3, 5, order, p);
        glMap1f(GL_MAP1_VERTEX_3, -1, 3, 3, 2, segment[0]);
        glEnable(target[size - 1]);
        for (int i = 0; i <= 8; i++) {
            begin(GL_3D_COLOR_TEXTURE);
            glBegin(GL_POINTS);
            glEvalCoord1f(-1 + 0.5f * (float)i);
            glEnd();
            assert_int_equal(glRenderMode(GL_RENDER), 12);
            assert_true(fabs((double)buffer[1] - 16 - 4 * i) < 1e-5);
            for (int k = 0; k < size; k++)
                assert_true(fabs((double)buffer[8 + k] - bernstein(p + k, 5, order, i / 8.0)) < 1e-5);
            assert_true(buffer[11] == 1 || size == 4);
        }
        glDisable(target[size - 1]);
    }
}

static double bernstein2(const GLfloat *p, const int stride[2], const int order[2], double u, double v)
{
    GLfloat row[30];
    for (int i = 0; i < order[0]; i++)
        row[i] = (GLfloat)bernstein(p + i * stride[0], stride[1], order[1], v);
    return bernstein(row, 1, order[0], u);
}

static void surface_values(void **state)
{
    (void)state;
    static GLfloat p[30 * 30 * 4];
    static GLdouble d[30 * 30 * 4];
    fill(p, 30 * 30 * 4);
    for (int i = 0; i < 30 * 30 * 4; i++)
        d[i] = (GLdouble)p[i];
    enable_plane();
    glEnable(GL_MAP2_TEXTURE_COORD_4);
    const int orders[][2] = {{1, 1}, {1, 4}, {4, 1},  {2, 2},  {3, 5},
                             {5, 3}, {4, 4}, {30, 2}, {2, 30}, {30, 30}};
    for (int n = 0; n < 10; n++) {
        const int stride[2] = {4, 4 * 30};
        if (n % 2)
            glMap2f(GL_MAP2_TEXTURE_COORD_4, 0, 1, stride[0], orders[n][0], 0, 1, stride[1], orders[n][1], p);
        else
            glMap2d(GL_MAP2_TEXTURE_COORD_4, 0, 1, stride[0], orders[n][0], 0, 1, stride[1], orders[n][1], d);
        for (int i = 0; i <= 4; i++) {
            begin(GL_3D_COLOR_TEXTURE);
            glBegin(GL_POINTS);
            glEvalCoord2d(i / 4.0, 1 - i / 8.0);
            glEnd();
            assert_int_equal(glRenderMode(GL_RENDER), 12);
            for (int k = 0; k < 4; k++)
                assert_true(fabs((double)buffer[8 + k] -
                                 bernstein2(p + k, stride, orders[n], i / 4.0, 1 - i / 8.0)) < 1e-5);
        }
    }
}

/* The last bits depend on the direction that is evaluated first: the one of lower order, the second one of
 * two equal ones. */
static void surface_bits(void **state)
{
    (void)state;
    static GLfloat p[5 * 5 * 4];
    const int orders[3][2] = {{3, 5}, {5, 3}, {4, 4}};
    const GLfloat expected[3][4] = {{0x1.51cf34p-1f, 0x1.1401a2p-1f, 0x1.2fb086p-1f, 0x1.221e2p-1f},
                                    {0x1.10e6fap-1f, 0x1.f40f1p-2f, 0x1.18c822p-1f, 0x1.e1facap-2f},
                                    {0x1.3a850ep-1f, 0x1.e5bed2p-2f, 0x1.29df9p-1f, 0x1.0c7caep-1f}};
    fill(p, 5 * 5 * 4);
    enable_plane();
    glEnable(GL_MAP2_TEXTURE_COORD_4);
    for (int i = 0; i < 3; i++) {
        glMap2f(GL_MAP2_TEXTURE_COORD_4, 0, 1, 4, orders[i][0], 0, 1, 20, orders[i][1], p);
        begin(GL_3D_COLOR_TEXTURE);
        glBegin(GL_POINTS);
        glEvalCoord2f(0.3f, 0.6f);
        glEnd();
        assert_int_equal(glRenderMode(GL_RENDER), 12);
        check_floats(buffer + 8, expected[i], 4, "surface", __FILE__, __LINE__);
    }
}

/* OSMesa mixes up current values that were not given between the same Begin and End. */
static void current_values(void **state)
{
    (void)state;
    const GLfloat color[2][4] = {{0, 0, 0, 0}, {1, 1, 1, 1}}, texcoord[2] = {8, 16};
    enable_segment();
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, color[0]);
    glMap1f(GL_MAP1_TEXTURE_COORD_1, 0, 1, 1, 2, texcoord);
    glEnable(GL_MAP1_COLOR_4);
    glEnable(GL_MAP1_TEXTURE_COORD_1);
    glColor4f(0.25f, 0.5f, 0.75f, 0.5f);
    glTexCoord4f(1, 2, 3, 4);
    begin(GL_3D_COLOR);
    glBegin(GL_POINTS);
    glColor4f(1, 0, 0, 1);
    glVertex2f(0, 0);
    glEvalCoord1f(0.5f);
    glEnd();
    EXPECT_BUFFER(POINT, 0, 0, 0, 1, 0, 0, 1, POINT, 32, 32, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f);
    EXPECT_VALUES(GL_CURRENT_COLOR, 1, 0, 0, 1);
    if (!on_fixedgl())
        return;
    EXPECT_VALUES(GL_CURRENT_TEXTURE_COORDS, 1, 2, 3, 4);
    glColor4f(0.25f, 0.5f, 0.75f, 0.5f);
    begin(GL_3D_COLOR_TEXTURE);
    glBegin(GL_POINTS);
    glEvalCoord1f(0);
    glVertex2f(0, 0);
    glEnd();
    EXPECT_BUFFER(POINT, 16, 32, 0.5f, 0, 0, 0, 0, 8, 0, 0, 1, POINT, 0, 0, 0, 0.25f, 0.5f, 0.75f, 0.5f, 1, 2,
                  3, 4);
    EXPECT_VALUES(GL_CURRENT_COLOR, 0.25f, 0.5f, 0.75f, 0.5f);
}

static void which_map_counts(void **state)
{
    (void)state;
    const GLfloat flat[4] = {64, 64, 0, 2}, one[1] = {7}, two[2] = {8, 9};
    enable_segment();
    glMap1f(GL_MAP1_VERTEX_4, 0, 1, 4, 1, flat);
    glMap1f(GL_MAP1_TEXTURE_COORD_1, 0, 1, 1, 1, one);
    glMap1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 1, two);
    glEnable(GL_MAP1_VERTEX_4);
    glEnable(GL_MAP1_TEXTURE_COORD_1);
    glEnable(GL_MAP1_TEXTURE_COORD_2);
    begin(GL_4D_COLOR_TEXTURE);
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f);
    glEnd();
    EXPECT_BUFFER(POINT, 32, 32, 0, 2, 1, 1, 1, 1, 8, 9, 0, 1);
    glDisable(GL_MAP1_VERTEX_3);
    glDisable(GL_MAP1_VERTEX_4);
    begin(GL_2D);
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f); /* no map for positions: no vertex */
    glEvalCoord2f(0.5f, 0.5f);
    glEnd();
    glMapGrid1f(1, 0, 1);
    glEvalMesh1(GL_LINE, 0, 1);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
}

/* The lit colour shows the normal: red is x, green is y, blue is z. */
static void auto_normal(void **state)
{
    (void)state;
    const GLfloat black[4] = {0, 0, 0, 1}, white[4] = {1, 1, 1, 1};
    const GLfloat bilinear[2][2][3] = {{{16, 16, 0}, {16, 48, 0}},
                                       {{48, 16, 24}, {48, 48, 24}}}; /* u goes 32 right, 24 up */
    const GLfloat rational[2][2][4] = {{{16, 16, 0, 1}, {32, 96, 0, 2}},
                                       {{48, 16, 24, 1}, {96, 96, 48, 2}}}; /* the same plane */
    const GLfloat normal[3] = {0, 1, 0};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, white);
    for (int i = 0; i < 3; i++) {
        GLfloat color[4] = {0, 0, 0, 1}, direction[4] = {0, 0, 0, 0};
        color[i] = 1;
        direction[i] = i == 0 ? -1 : 1;
        glLightfv(GL_LIGHT0 + (GLenum)i, GL_DIFFUSE, color);
        glLightfv(GL_LIGHT0 + (GLenum)i, GL_POSITION, direction);
        glEnable(GL_LIGHT0 + (GLenum)i);
    }
    glEnable(GL_LIGHTING);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 64, -64);
    glEnable(GL_AUTO_NORMAL);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, bilinear[0][0]);
    glMap2f(GL_MAP2_VERTEX_4, 0, 1, 8, 2, 0, 1, 4, 2, rational[0][0]);
    glMap2f(GL_MAP2_NORMAL, 0, 1, 3, 1, 0, 1, 3, 1, normal);
    glEnable(GL_MAP2_VERTEX_3);
    for (int i = 0; i < 2; i++) {
        begin(GL_3D_COLOR);
        glBegin(GL_POINTS);
        glEvalCoord2f(0.5f, 0.5f);
        glEnd();
        assert_int_equal(glRenderMode(GL_RENDER), 8);
        assert_true(fabs((double)buffer[4] - 0.6) < 1e-6); /* (-24, 0, 32) / 40 */
        assert_true(buffer[5] == 0);
        assert_true(fabs((double)buffer[6] - 0.8) < 1e-6);
        glEnable(GL_MAP2_VERTEX_4);
        glEnable(GL_MAP2_NORMAL); /* the automatic one counts */
    }
    glDisable(GL_AUTO_NORMAL);
    begin(GL_3D_COLOR);
    glBegin(GL_POINTS);
    glEvalCoord2f(0.5f, 0.5f);
    glEnd();
    assert_int_equal(glRenderMode(GL_RENDER), 8);
    assert_true(buffer[4] == 0 && buffer[5] == 1 && buffer[6] == 0);
}

static void grids(void **state)
{
    (void)state;
    enable_segment();
    begin(GL_2D);
    glEvalMesh1(GL_POINT, 0, 1); /* on the initial grid, whose step is 0 in OSMesa */
    if (on_fixedgl())
        EXPECT_BUFFER(POINT, 16, 32, POINT, 48, 32);
    else
        EXPECT_BUFFER(POINT, 16, 32, POINT, 16, 32);
    glMapGrid1d(4, 0, 1);
    begin(GL_2D);
    glBegin(GL_POINTS);
    for (int i = -1; i <= 4; i += 5)
        glEvalPoint1(i);
    glEnd();
    EXPECT_BUFFER(POINT, 8, 32, POINT, 48, 32);
    begin(GL_2D);
    glEvalMesh1(GL_POINT, 1, 3);
    EXPECT_BUFFER(POINT, 24, 32, POINT, 32, 32, POINT, 40, 32);
    begin(GL_2D);
    glEvalMesh1(GL_POINT, 3, 1); /* empty */
    assert_int_equal(glRenderMode(GL_RENDER), 0);
    begin(GL_2D);
    glEvalMesh1(GL_LINE, 0, 2);
    assert_int_equal(glRenderMode(GL_RENDER), 10);
    assert_true(buffer[1] == 16 && buffer[3] == 24 && buffer[6] == 24 && buffer[8] == 32);

    enable_plane();
    glMapGrid2d(2, 0, 1, 4, 0, 1);
    begin(GL_2D);
    glBegin(GL_POINTS);
    glEvalPoint2(1, 3);
    glEnd();
    EXPECT_BUFFER(POINT, 32, 48);
    begin(GL_2D);
    glEvalMesh2(GL_POINT, 0, 1, 1, 2);
    EXPECT_BUFFER(POINT, 0, 16, POINT, 32, 16, POINT, 0, 32, POINT, 32, 32);
    begin(GL_2D);
    glEvalMesh2(GL_FILL, 0, 1, 1, 2);
    EXPECT_BUFFER(TRIANGLE, 0, 16, 0, 32, 32, 16, TRIANGLE, 32, 16, 0, 32, 32, 32);
    begin(GL_2D);
    glEvalMesh2(GL_LINE, 0, 1, 1, 2); /* two lines along u, two along v */
    assert_int_equal(glRenderMode(GL_RENDER), 20);
    const GLfloat ends[16] = {0, 16, 32, 16, 0, 32, 32, 32, 0, 16, 0, 32, 32, 16, 32, 32};
    for (int i = 0; i < 4; i++)
        check_floats(buffer + 5 * i + 1, ends + 4 * i, 4, "lines", __FILE__, __LINE__);
}

/* In lists evaluated vertices stand among others; a list may be part of a primitive. */
static void lists(void **state)
{
    (void)state;
    enable_segment();
    glMapGrid1f(2, 0, 1);
    glNewList(1, GL_COMPILE);
    glBegin(GL_POINTS);
    glEvalCoord1f(0);
    glVertex2f(1, 1);
    glEvalPoint1(1);
    glEnd();
    glEvalMesh1(GL_POINT, 1, 2);
    glMapGrid1f(1, 0, 1);
    glEndList();
    EXPECT_INTS(GL_MAP1_GRID_SEGMENTS, 2);
    begin(GL_2D);
    glCallList(1);
    EXPECT_BUFFER(POINT, 16, 32, POINT, 1, 1, POINT, 32, 32, POINT, 32, 32, POINT, 48, 32);
    EXPECT_INTS(GL_MAP1_GRID_SEGMENTS, 1);

    begin(GL_2D);
    glNewList(2, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_POINTS);
    glEvalCoord1f(0);
    glEnd();
    glEvalMesh1(GL_POINT, 0, 0);
    glEndList();
    glBegin(GL_POINTS);
    glVertex2f(1, 1);
    glEnd();
    glCallList(2);
    if (on_fixedgl()) /* OSMesa's executed list has one point more */
        EXPECT_BUFFER(POINT, 16, 32, POINT, 16, 32, POINT, 1, 1, POINT, 16, 32, POINT, 16, 32);
    else
        glRenderMode(GL_RENDER);

    const GLfloat moved[2][3] = {{0, 0, 0}, {64, 64, 0}};
    GLfloat scratch[6];
    memcpy(scratch, moved, sizeof scratch);
    glNewList(3, GL_COMPILE);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, scratch); /* points are read now */
    glMap1f(GL_MAP1_VERTEX_3, 0, 0, 3, 2, scratch); /* an error when executed */
    glEndList();
    memset(scratch, 0, sizeof scratch);
    glCallList(3);
    if (on_fixedgl())
        EXPECT_ERROR(GL_INVALID_VALUE, (void)0);
    glGetError();
    begin(GL_2D);
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f);
    glEnd();
    EXPECT_BUFFER(POINT, 32, 32);
}

static void split_primitives(void **state)
{
    (void)state;
    enable_segment();
    glNewList(1, GL_COMPILE);
    glEvalCoord1f(0);
    glEvalCoord1f(1);
    glEndList();
    glNewList(2, GL_COMPILE);
    glEnd();
    glEndList();
    begin(GL_2D);
    glBegin(GL_LINES);
    glCallList(1);
    glCallList(2);
    assert_int_equal(glRenderMode(GL_RENDER), 5);
    assert_true(buffer[1] == 16 && buffer[3] == 48);
    EXPECT_NO_ERROR(glEvalCoord1f(0)); /* outside Begin/End: nothing */
}

static void queries(void **state)
{
    (void)state;
    GLfloat f[18];
    GLdouble d[4];
    GLint n[4];
    for (GLenum i = 0; i <= GL_MAP1_VERTEX_4 - GL_MAP1_COLOR_4; i++) { /* table 6.26 */
        static const GLfloat initial[9][4] = {{1, 1, 1, 1}, {1},          {0, 0, 1}, {0},         {0, 0},
                                              {0, 0, 0},    {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}};
        static const size_t size[9] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
        glGetMapfv(GL_MAP1_COLOR_4 + i, GL_COEFF, f);
        check_floats(f, initial[i], size[i], "initial map", __FILE__, __LINE__);
        glGetMapfv(GL_MAP2_COLOR_4 + i, GL_COEFF, f);
        check_floats(f, initial[i], size[i], "initial map", __FILE__, __LINE__);
        glGetMapiv(GL_MAP1_COLOR_4 + i, GL_ORDER, n);
        glGetMapiv(GL_MAP2_COLOR_4 + i, GL_ORDER, n + 1);
        assert_true(n[0] == 1 && n[1] == 1 && n[2] == 1);
        glGetMapdv(GL_MAP2_COLOR_4 + i, GL_DOMAIN, d);
        assert_true(d[0] == 0 && d[1] == 1 && d[2] == 0 && d[3] == 1);
    }
    const GLfloat p[2][3][3] = {{{1, -0.5f, 1.5f}, {4, 5, 6}, {7, 8, 9}},
                                {{10, 11, 12}, {13, 14, 15}, {16, 17, 18}}};
    const GLfloat v_first[6] = {1, -0.5f, 1.5f, 10, 11, 12};
    glMap2f(GL_MAP2_NORMAL, -1, 2, 3, 3, 5, 3, 9, 2, p[0][0]);
    glGetMapfv(GL_MAP2_NORMAL, GL_COEFF, f);
    check_floats(f, v_first, 6, "coefficients, v fastest", __FILE__, __LINE__);
    glGetMapiv(GL_MAP2_NORMAL, GL_COEFF, (GLint *)(void *)f);
    assert_int_equal(((GLint *)(void *)f)[2], 2);
    glGetMapiv(GL_MAP2_NORMAL, GL_ORDER, n);
    assert_true(n[0] == 3 && n[1] == 2);
    glGetMapiv(GL_MAP2_NORMAL, GL_DOMAIN, n);
    assert_true(n[0] == -1 && n[1] == 2 && n[2] == 5 && n[3] == 3);
}

static void errors(void **state)
{
    (void)state;
    GLfloat f[16];
    GLint n[4] = {77};
    const GLdouble d[6] = {0};
    EXPECT_ERROR(GL_INVALID_ENUM, glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, segment[0]));
    EXPECT_ERROR(GL_INVALID_ENUM, glMap1d(GL_MAP1_VERTEX_4 + 1, 0, 1, 4, 1, d));
    EXPECT_ERROR(GL_INVALID_ENUM, glMap2f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 2, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap1f(GL_MAP1_VERTEX_3, 2, 2, 3, 2, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap1d(GL_MAP1_VERTEX_3, 0, 1, 3, 31, d));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 1, 1, 3, 1, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 2, 1, segment[0]));
    EXPECT_ERROR(GL_INVALID_VALUE, glMap2d(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 3, 31, d));
    glGetMapiv(GL_MAP1_VERTEX_3, GL_ORDER, n);
    assert_int_equal(n[0], 1); /* nothing was stored */

    EXPECT_ERROR(GL_INVALID_VALUE, glMapGrid1f(0, 0, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glMapGrid1d(-1, 0, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glMapGrid2f(0, 0, 1, 1, 0, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glMapGrid2d(1, 0, 1, 0, 0, 1));
    EXPECT_NO_ERROR(glMapGrid1f(1, 2, 2));
    EXPECT_ERROR(GL_INVALID_ENUM, glEvalMesh1(GL_FILL, 0, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glEvalMesh2(GL_LINES, 0, 1, 0, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetMapfv(GL_MAP1_COLOR_4 - 1, GL_COEFF, f));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetMapiv(GL_MAP2_COLOR_4, GL_MAP1_GRID_DOMAIN, n));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetMapdv(GL_MAP2_VERTEX_4 + 1, GL_ORDER, (GLdouble *)(void *)f));

    glBegin(GL_POINTS);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, segment[0]);
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    glBegin(GL_POINTS);
    glEvalMesh1(GL_POINT, 0, 1);
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    glBegin(GL_POINTS);
    glEvalCoord1f(0);
    glEvalPoint2(0, 0);
    glEnd();
    EXPECT_NO_ERROR((void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            EVAL_TEST(curve_values),
            EVAL_TEST(surface_values),
            EVAL_TEST(surface_bits),
            EVAL_TEST(current_values),
            EVAL_TEST(which_map_counts),
            EVAL_TEST(auto_normal),
            EVAL_TEST(grids),
            EVAL_TEST(lists),
            EVAL_TEST(split_primitives),
            EVAL_TEST(queries),
            EVAL_TEST(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
