/* Feedback (GL 1.5, 5.3): what comes back in the buffer. The window is 64 x 64; object coordinates are window
 * coordinates. */
#include "api/gl_test.h"

enum { ROOM = 512 };
static GLfloat buffer[ROOM];

static int start(void **state)
{
    if (make_context(state))
        return -1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 0, -1); /* depth is z */
    glMatrixMode(GL_MODELVIEW);
    return 0;
}

#define FEEDBACK_TEST(function) cmocka_unit_test_setup_teardown(function, start, destroy_context)

static void begin(GLenum type)
{
    memset(buffer, 0, sizeof buffer);
    glFeedbackBuffer(ROOM, type, buffer);
    assert_int_equal(glRenderMode(GL_FEEDBACK), 0);
}

/* Leaves feedback mode; the buffer holds exactly these values. */
#define EXPECT_BUFFER(...)                                                                                   \
    do {                                                                                                     \
        const GLfloat expected_[] = {__VA_ARGS__};                                                           \
        const int n_ = (int)(sizeof expected_ / sizeof *expected_);                                          \
        assert_int_equal(glRenderMode(GL_RENDER), n_);                                                       \
        check_floats(buffer, expected_, (size_t)n_, "feedback", __FILE__, __LINE__);                         \
        assert_int_equal(glGetError(), GL_NO_ERROR);                                                         \
    } while (0)

#define LINE GL_LINE_TOKEN
#define RESET GL_LINE_RESET_TOKEN
#define TRIANGLE GL_POLYGON_TOKEN, 3

static void vertices(GLenum mode, int n, const GLfloat (*v)[3])
{
    glBegin(mode);
    for (int i = 0; i < n; i++)
        glVertex3fv(v[i]);
    glEnd();
}

static const GLfloat square[4][3] = {{16, 16, 0.5f}, {48, 16, 0.5f}, {48, 48, 0.5f}, {16, 48, 0.5f}};

static void types(void **state)
{
    (void)state;
    glColor4f(0.25f, 0.5f, 0.75f, 1);
    glTexCoord4f(1, 2, 3, 4);
    const GLfloat v[1][3] = {{16, 32, 0.25f}};
    begin(GL_2D);
    vertices(GL_POINTS, 1, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32);
    begin(GL_3D);
    vertices(GL_POINTS, 1, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32, 0.25f);
    begin(GL_3D_COLOR);
    vertices(GL_POINTS, 1, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32, 0.25f, 0.25f, 0.5f, 0.75f, 1);
    glColor4f(2, -1, 0.5f, 0.25f);
    begin(GL_3D_COLOR);
    vertices(GL_POINTS, 1, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32, 0.25f, 1, 0, 0.5f, 0.25f);
    glColor4f(0.25f, 0.5f, 0.75f, 1);
    begin(GL_3D_COLOR_TEXTURE);
    vertices(GL_POINTS, 1, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32, 0.25f, 0.25f, 0.5f, 0.75f, 1, 1, 2, 3, 4);
    begin(GL_4D_COLOR_TEXTURE);
    glBegin(GL_POINTS);
    glTexCoord2f(5, 6);
    glColor4f(2, -1, 0.5f, 0.25f); /* comes back clamped */
    glVertex4f(32, 64, 0.5f, 2);
    glEnd();
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 32, 0.25f, 2, 1, 0, 0.5f, 0.25f, 5, 6, 0, 1);
}

/* Polygons come back as the triangles that they are drawn as. */
static void primitives(void **state)
{
    (void)state;
    begin(GL_2D);
    vertices(GL_TRIANGLES, 4, square);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 48, 48);
    begin(GL_2D);
    vertices(GL_QUADS, 4, square);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 16, 48, TRIANGLE, 48, 16, 48, 48, 16, 48);
    begin(GL_2D);
    vertices(GL_POLYGON, 4, square);
    EXPECT_BUFFER(TRIANGLE, 48, 16, 48, 48, 16, 16, TRIANGLE, 48, 48, 16, 48, 16, 16);
    begin(GL_2D);
    vertices(GL_TRIANGLE_STRIP, 4, square);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 48, 48, TRIANGLE, 48, 48, 48, 16, 16, 48);
    begin(GL_2D);
    vertices(GL_TRIANGLE_FAN, 4, square);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 48, 48, TRIANGLE, 16, 16, 48, 48, 16, 48);
    begin(GL_2D);
    vertices(GL_QUAD_STRIP, 4, square);
    EXPECT_BUFFER(TRIANGLE, 48, 48, 16, 16, 16, 48, TRIANGLE, 16, 16, 48, 16, 16, 48);
    begin(GL_2D);
    glRectf(16, 16, 48, 48);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 16, 48, TRIANGLE, 48, 16, 48, 48, 16, 48);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, square);
    begin(GL_2D);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, (const GLubyte[]){2, 1, 0});
    EXPECT_BUFFER(TRIANGLE, 48, 48, 48, 16, 16, 16);
}

/* The first line of a strip or loop, and each of GL_LINES, resets the stipple (5.3); OSMesa forgets to say
 * so. */
static void lines(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    begin(GL_2D);
    vertices(GL_LINES, 4, square);
    EXPECT_BUFFER(RESET, 16, 16, 48, 16, RESET, 48, 48, 16, 48);
    begin(GL_2D);
    vertices(GL_LINE_STRIP, 3, square);
    EXPECT_BUFFER(RESET, 16, 16, 48, 16, LINE, 48, 16, 48, 48);
    begin(GL_2D);
    vertices(GL_LINE_LOOP, 3, square);
    EXPECT_BUFFER(RESET, 16, 16, 48, 16, LINE, 48, 16, 48, 48, LINE, 48, 48, 16, 16);
}

static void clipping(void **state)
{
    (void)state;
    const GLfloat v[3][3] = {{-32, 16, 0.5f}, {32, 16, 0.5f}, {32, 48, 0.5f}};
    begin(GL_2D);
    vertices(GL_POINTS, 3, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 32, 16, GL_POINT_TOKEN, 32, 48);
    begin(GL_2D);
    vertices(GL_TRIANGLES, 3, v);
    EXPECT_BUFFER(TRIANGLE, 32, 16, 32, 48, 0, 16, TRIANGLE, 32, 48, 0, 32, 0, 16);
    const GLdouble plane[4] = {1, 0, 0, -16};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    begin(GL_2D);
    vertices(GL_POINTS, 3, v);
    vertices(GL_TRIANGLES, 3, v);
    EXPECT_BUFFER(GL_POINT_TOKEN, 32, 16, GL_POINT_TOKEN, 32, 48, TRIANGLE, 32, 16, 32, 48, 16, 16, TRIANGLE,
                  32, 48, 16, 40, 16, 16);
}

static void culling_and_polygon_modes(void **state)
{
    (void)state;
    const GLfloat back[3][3] = {{16, 16, 0}, {16, 48, 0}, {48, 16, 0}},
                  flat[3][3] = {{16, 16, 0}, {32, 16, 0}, {48, 16, 0}};
    begin(GL_2D);
    vertices(GL_TRIANGLES, 3, flat); /* without area */
    EXPECT_BUFFER(TRIANGLE, 16, 16, 32, 16, 48, 16);
    glEnable(GL_CULL_FACE);
    begin(GL_2D);
    vertices(GL_TRIANGLES, 3, square);
    vertices(GL_TRIANGLES, 3, back);
    vertices(GL_TRIANGLES, 3, flat);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 48, 16, 48, 48);
    glCullFace(GL_FRONT_AND_BACK);
    begin(GL_2D);
    vertices(GL_TRIANGLES, 3, square);
    vertices(GL_LINE_STRIP, 1, square);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
    glDisable(GL_CULL_FACE);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    begin(GL_2D);
    vertices(GL_TRIANGLES, 3, square);
    vertices(GL_TRIANGLES, 3, back);
    EXPECT_BUFFER(RESET, 48, 48, 16, 16, LINE, 16, 16, 48, 16, LINE, 48, 16, 48, 48, GL_POINT_TOKEN, 16, 16,
                  GL_POINT_TOKEN, 16, 48, GL_POINT_TOKEN, 48, 16);
    begin(GL_2D);
    vertices(GL_QUADS, 4, square); /* the diagonal is no edge, and the stipple goes on around the polygon */
    EXPECT_BUFFER(RESET, 16, 48, 16, 16, LINE, 16, 16, 48, 16, LINE, 48, 16, 48, 48, LINE, 48, 48, 16, 48);
}

/* OSMesa loses edge flags, flat shading, the units of polygon offset and the texture matrix in feedback mode.
 */
static void what_osmesa_loses(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    begin(GL_2D);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        glEdgeFlag(i != 1);
        glVertex3fv(square[i]);
    }
    glEnd();
    EXPECT_BUFFER(RESET, 48, 48, 16, 16, LINE, 16, 16, 48, 16);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glShadeModel(GL_FLAT);
    begin(GL_3D_COLOR);
    glBegin(GL_LINES);
    glColor4f(1, 0, 0, 1);
    glVertex3fv(square[0]);
    glColor4f(0, 1, 0, 0.5f);
    glVertex3fv(square[1]);
    glEnd();
    EXPECT_BUFFER(RESET, 16, 16, 0.5f, 0, 1, 0, 0.5f, 48, 16, 0.5f, 0, 1, 0, 0.5f);
    glMatrixMode(GL_TEXTURE);
    glTranslatef(10, 20, 30);
    glColor4f(1, 1, 1, 1);
    glTexCoord4f(1, 2, 3, 2);
    begin(GL_3D_COLOR_TEXTURE);
    vertices(GL_POINTS, 1, square);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 16, 0.5f, 1, 1, 1, 1, 21, 42, 63, 2);
}

static void lighting(void **state)
{
    (void)state;
    const GLfloat black[4] = {0, 0, 0, 1}, front[4] = {0.5f, 0, 0, 1}, back[4] = {0, 0.25f, 0, 0.5f};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, front);
    glMaterialfv(GL_BACK, GL_DIFFUSE, back);
    begin(GL_3D_COLOR);
    glNormal3f(0, 0, 1);
    vertices(GL_TRIANGLES, 3, square);
    glNormal3f(0, 0, -1);
    const GLfloat turned[3][3] = {{16, 16, 0}, {16, 48, 0}, {48, 16, 0}};
    vertices(GL_TRIANGLES, 3, turned);
    EXPECT_BUFFER(TRIANGLE, 16, 16, 0.5f, 0.5f, 0, 0, 1, 48, 16, 0.5f, 0.5f, 0, 0, 1, 48, 48, 0.5f, 0.5f, 0,
                  0, 1, TRIANGLE, 16, 16, 0, 0, 0.25f, 0, 0.5f, 16, 48, 0, 0, 0.25f, 0, 0.5f, 48, 16, 0, 0,
                  0.25f, 0, 0.5f);
}

static void pass_through(void **state)
{
    (void)state;
    glPassThrough(7); /* nothing in GL_RENDER mode */
    begin(GL_2D);
    glPassThrough(1.5f);
    vertices(GL_POINTS, 1, square);
    glPassThrough(-2);
    EXPECT_BUFFER(GL_PASS_THROUGH_TOKEN, 1.5f, GL_POINT_TOKEN, 16, 16, GL_PASS_THROUGH_TOKEN, -2);
    glNewList(1, GL_COMPILE);
    glPassThrough(3);
    glRenderMode(GL_RENDER); /* executed at once, GL 1.5, 5.4 */
    glEndList();
    begin(GL_2D);
    glCallList(1);
    EXPECT_BUFFER(GL_PASS_THROUGH_TOKEN, 3);
}

static void raster_position(void **state)
{
    (void)state;
    const GLubyte bits[4] = {0};
    glColor4f(0.25f, 0.5f, 0.75f, 1);
    begin(GL_3D_COLOR);
    glRasterPos3f(16, 32, 0.5f);
    glBitmap(1, 1, 0, 0, 2, 3, bits);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bits);
    glCopyPixels(0, 0, 1, 1, GL_COLOR);
    glRasterPos2f(99, 32); /* outside: not valid */
    glBitmap(1, 1, 0, 0, 2, 3, bits);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bits);
    EXPECT_BUFFER(GL_BITMAP_TOKEN, 16, 32, 0.5f, 0.25f, 0.5f, 0.75f, 1, GL_DRAW_PIXEL_TOKEN, 18, 35, 0.5f,
                  0.25f, 0.5f, 0.75f, 1, GL_COPY_PIXEL_TOKEN, 18, 35, 0.5f, 0.25f, 0.5f, 0.75f, 1);
}

/* Scissor and draw buffer do not matter; nothing is drawn or cleared. */
static void framebuffer(void **state)
{
    (void)state;
    GLubyte pixel[4];
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glDrawBuffer(GL_NONE);
    begin(GL_2D);
    vertices(GL_POINTS, 1, square);
    EXPECT_BUFFER(GL_POINT_TOKEN, 16, 16);
    glDisable(GL_SCISSOR_TEST);
    glDrawBuffer(GL_FRONT);
    glClearColor(1, 0, 0, 1);
    begin(GL_2D);
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(0, 0, 64, 64);
    glRenderMode(GL_RENDER);
    glReadPixels(20, 20, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    assert_int_equal(pixel[0], 0);
    glRectf(0, 0, 64, 64);
    glReadPixels(20, 20, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    assert_int_equal(pixel[0], 255);
}

static void overflow(void **state)
{
    (void)state;
    for (int room = 1; room <= 6; room++) {
        for (int i = 0; i < 8; i++)
            buffer[i] = -1;
        glFeedbackBuffer(room, GL_2D, buffer);
        glRenderMode(GL_FEEDBACK);
        vertices(GL_POINTS, 2, square);
        assert_int_equal(glRenderMode(GL_RENDER), room < 6 ? -1 : 6);
        assert_true(buffer[room - 1] >= 0);
        assert_true(buffer[room] < 0); /* nothing beyond */
    }
}

static void errors(void **state)
{
    (void)state;
    void *pointer;
    EXPECT_ERROR(GL_INVALID_ENUM, assert_int_equal(glRenderMode(GL_LINE), 0));
    EXPECT_ERROR(GL_INVALID_VALUE, glFeedbackBuffer(-1, GL_2D, buffer));
    EXPECT_ERROR(GL_INVALID_VALUE, glFeedbackBuffer(1, GL_2D, NULL));
    EXPECT_ERROR(GL_INVALID_ENUM, glFeedbackBuffer(1, GL_2D - 1, buffer));
    EXPECT_ERROR(GL_INVALID_ENUM, glFeedbackBuffer(1, GL_4D_COLOR_TEXTURE + 1, buffer));
    EXPECT_INTS(GL_FEEDBACK_BUFFER_SIZE, 0);
    if (on_fixedgl()) { /* OSMesa raises the error and goes into the mode */
        EXPECT_ERROR(GL_INVALID_OPERATION, glRenderMode(GL_FEEDBACK));
        EXPECT_INTS(GL_RENDER_MODE, GL_RENDER);
    }
    EXPECT_NO_ERROR(glFeedbackBuffer(7, GL_3D_COLOR, buffer));
    EXPECT_NO_ERROR(glRenderMode(GL_FEEDBACK));
    EXPECT_ERROR(GL_INVALID_OPERATION, glFeedbackBuffer(5, GL_2D, buffer));
    EXPECT_INTS(GL_RENDER_MODE, GL_FEEDBACK);
    EXPECT_INTS(GL_FEEDBACK_BUFFER_SIZE, 7);
    EXPECT_INTS(GL_FEEDBACK_BUFFER_TYPE, GL_3D_COLOR);
    glGetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
    assert_ptr_equal(pointer, buffer);
    glBegin(GL_POINTS);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
    glPassThrough(1);
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            FEEDBACK_TEST(types),
            FEEDBACK_TEST(primitives),
            FEEDBACK_TEST(lines),
            FEEDBACK_TEST(clipping),
            FEEDBACK_TEST(culling_and_polygon_modes),
            FEEDBACK_TEST(what_osmesa_loses),
            FEEDBACK_TEST(lighting),
            FEEDBACK_TEST(pass_through),
            FEEDBACK_TEST(framebuffer),
            FEEDBACK_TEST(overflow),
            FEEDBACK_TEST(raster_position),
            FEEDBACK_TEST(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
