/* Colour index mode: buffers, current index, interpolation, and what else handles indexes. */
#include "api/color_index_test.h"

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

/* Framebuffer objects have colours. */
static void framebuffer_objects(void **state)
{
    GLuint framebuffer, renderbuffer;
    (void)state;
    glGenFramebuffersEXT(1, &framebuffer);
    glGenRenderbuffersEXT(1, &renderbuffer);
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, framebuffer);
    glBindRenderbufferEXT(GL_RENDERBUFFER_EXT, renderbuffer);
    glRenderbufferStorageEXT(GL_RENDERBUFFER_EXT, GL_RGBA8, 16, 16);
    glFramebufferRenderbufferEXT(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_RENDERBUFFER_EXT, renderbuffer);
    assert_int_equal(glCheckFramebufferStatusEXT(GL_FRAMEBUFFER_EXT), GL_FRAMEBUFFER_UNSUPPORTED_EXT);
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION_EXT, glClear(GL_COLOR_BUFFER_BIT));
    glBindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0);
    EXPECT_NO_ERROR(glClear(GL_COLOR_BUFFER_BIT));
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
            INDEX_TEST(framebuffer),
            GL_TEST(rgba_context),
            INDEX_TEST(row_layout),
            INDEX_TEST(clearing),
            INDEX_TEST(current_index),
            INDEX_TEST(arrays),
            INDEX_TEST(smooth_triangles),
            INDEX_TEST(clipped_triangle),
            INDEX_TEST(flat_shading),
            INDEX_TEST(smooth_line),
            INDEX_TEST(feedback),
            INDEX_TEST(selection),
            INDEX_TEST(evaluators),
            INDEX_TEST(lists_and_attributes),
            INDEX_TEST(textures),
            INDEX_TEST(framebuffer_objects),
            INDEX_TEST(polygon_modes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
