/* Selection (GL 1.5, 5.2): hit records and the name stack. Window depth is z. */
#include "api/gl_test.h"

enum { ROOM = 256 };
static GLuint hits[ROOM];

static int start(void **state)
{
    if (make_context(state))
        return -1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 0, -1);
    glMatrixMode(GL_MODELVIEW);
    memset(hits, 0, sizeof hits);
    glSelectBuffer(ROOM, hits);
    return 0;
}

#define SELECT_TEST(function) cmocka_unit_test_setup_teardown(function, start, destroy_context)

static void begin(void)
{
    assert_int_equal(glRenderMode(GL_SELECT), 0);
    glInitNames();
}

static void point(GLfloat x, GLfloat z)
{
    glBegin(GL_POINTS);
    glVertex3f(x, 32, z);
    glEnd();
}

/* Leaves selection mode with n records, which hold exactly these values. */
#define EXPECT_HITS(n, ...)                                                                                  \
    do {                                                                                                     \
        const GLuint expected_[] = {__VA_ARGS__};                                                            \
        assert_int_equal(glRenderMode(GL_RENDER), n);                                                        \
        for (size_t i_ = 0; i_ < sizeof expected_ / sizeof *expected_; i_++)                                 \
            assert_int_equal(hits[i_], expected_[i_]);                                                       \
        assert_int_equal(glGetError(), GL_NO_ERROR);                                                         \
    } while (0)

#define HALF 0x80000000u
#define QUARTER 0x40000000u

static void records(void **state)
{
    (void)state;
    begin();
    glPushName(5);
    point(32, 0.5f);
    point(16, 0.25f); /* the same record */
    glPushName(6);
    glPushName(7); /* nothing drawn: no record of 5 6 */
    point(16, 0.25f);
    point(99, 0.75f); /* outside */
    glLoadName(8);
    point(99, 0.5f); /* outside: no record */
    glPopName();
    glPopName();
    glLoadName(9);
    point(16, 0);
    EXPECT_HITS(3, 1, QUARTER, HALF, 5, 3, QUARTER, QUARTER, 5, 6, 7, 1, 0, 0, 9);
}

/* Depth 1.0 is the largest value; OSMesa makes it 0. */
static void depth(void **state)
{
    (void)state;
    begin();
    glPushName(1);
    glBegin(GL_LINES);
    glVertex3f(8, 8, 0.125f);
    glVertex3f(16, 16, 0.375f);
    glEnd();
    EXPECT_HITS(1, 1, 0x20000000u, 0x60000000u, 1);
    begin();
    glPushName(1);
    glBegin(GL_TRIANGLES);
    glVertex3f(8, 8, 0.5f);
    glVertex3f(16, 16, 0.75f);
    glVertex3f(8, 16, 0.25f);
    glEnd();
    EXPECT_HITS(1, 1, QUARTER, 0xc0000000u, 1);
    begin();
    point(32, 0.99999988f); /* 2^23 - 1 of 2^23 */
    if (on_fixedgl()) {
        glPushName(2);
        point(32, 1);
        EXPECT_HITS(2, 0, 0xfffffe00u, 0xfffffe00u, 1, 0xffffffffu, 0xffffffffu, 2);
    } else {
        EXPECT_HITS(1, 0, 0xfffffe00u, 0xfffffe00u);
    }
}

/* What is culled, clipped away or without edges is not hit; scissor and draw buffer do not matter. */
static void what_is_hit(void **state)
{
    (void)state;
    glEnable(GL_CULL_FACE);
    begin();
    glRectf(16, 16, 32, 32);
    EXPECT_HITS(1, 0, 0, 0);
    glFrontFace(GL_CW);
    begin();
    glRectf(16, 16, 32, 32);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
    glDisable(GL_CULL_FACE);
    begin();
    glRectf(-16, -16, -8, -8);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glDrawBuffer(GL_NONE);
    begin();
    glRectf(-16, -16, 32, 32);
    assert_int_equal(glRenderMode(GL_RENDER), 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEdgeFlag(GL_FALSE);
    begin();
    glBegin(GL_TRIANGLES);
    glVertex2f(1, 1);
    glVertex2f(9, 1);
    glVertex2f(1, 9);
    glEnd();
    assert_int_equal(glRenderMode(GL_RENDER), 0);
}

static void raster_position(void **state)
{
    (void)state;
    begin();
    glPushName(1);
    glRasterPos3f(16, 32, 0.25f);
    glBitmap(0, 0, 0, 0, 1, 1, NULL); /* hits nothing */
    glLoadName(2);
    glRasterPos2f(99, 32); /* not valid */
    glBitmap(0, 0, 0, 0, 1, 1, NULL);
    EXPECT_HITS(1, 1, QUARTER, QUARTER, 1);
}

static void name_stack(void **state)
{
    (void)state;
    EXPECT_NO_ERROR(glPushName(1)); /* in GL_RENDER mode they do nothing */
    EXPECT_NO_ERROR(glPopName());
    EXPECT_NO_ERROR(glLoadName(1));
    EXPECT_INTS(GL_NAME_STACK_DEPTH, 0);
    glRenderMode(GL_SELECT);
    EXPECT_ERROR(GL_STACK_UNDERFLOW, glPopName());
    EXPECT_ERROR(GL_INVALID_OPERATION, glLoadName(1));
    for (GLuint i = 0; i < 64; i++)
        EXPECT_NO_ERROR(glPushName(i));
    EXPECT_ERROR(GL_STACK_OVERFLOW, glPushName(64));
    EXPECT_INTS(GL_NAME_STACK_DEPTH, 64);
    point(32, 0);
    glInitNames(); /* writes the record */
    EXPECT_INTS(GL_NAME_STACK_DEPTH, 0);
    glPushName(3);
    assert_int_equal(glRenderMode(GL_SELECT), 1); /* starts anew */
    EXPECT_INTS(GL_NAME_STACK_DEPTH, 0);
    assert_int_equal(hits[0], 64);
    for (GLuint i = 0; i < 64; i++)
        assert_int_equal(hits[3 + i], i);
    assert_int_equal(glRenderMode(GL_RENDER), 0);
}

static void lists(void **state)
{
    (void)state;
    glNewList(1, GL_COMPILE);
    glInitNames();
    glPushName(4);
    glLoadName(6);
    point(32, 0.5f);
    glPopName();
    glPopName(); /* underflow, when executed */
    glEndList();
    EXPECT_INTS(GL_NAME_STACK_DEPTH, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glRenderMode(GL_SELECT);
    glCallList(1);
    assert_int_equal(glGetError(), GL_STACK_UNDERFLOW);
    EXPECT_HITS(1, 1, HALF, HALF, 6);
}

static void overflow(void **state)
{
    (void)state;
    glSelectBuffer(6, hits);
    hits[6] = 77;
    begin();
    glPushName(1);
    point(32, 0.5f);
    glPushName(2);
    point(32, 0.5f);
    EXPECT_HITS(-1, 1, HALF, HALF, 1, 2, HALF, 77);
    begin(); /* nothing is left of it */
    glPushName(1);
    point(32, 0.5f);
    EXPECT_HITS(1, 1, HALF, HALF, 1);
}

static void errors(void **state)
{
    (void)state;
    void *pointer;
    EXPECT_ERROR(GL_INVALID_VALUE, glSelectBuffer(-1, hits));
    EXPECT_NO_ERROR(glRenderMode(GL_SELECT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glSelectBuffer(1, hits));
    EXPECT_ERROR(GL_INVALID_ENUM, glRenderMode(GL_TRIANGLES));
    EXPECT_INTS(GL_RENDER_MODE, GL_SELECT);
    EXPECT_INTS(GL_SELECTION_BUFFER_SIZE, ROOM);
    glGetPointerv(GL_SELECTION_BUFFER_POINTER, &pointer);
    assert_ptr_equal(pointer, hits);
    glRenderMode(GL_RENDER);
    if (on_fixedgl()) { /* OSMesa raises the last error and goes into the mode; it writes through the null
                           pointer */
        EXPECT_ERROR(GL_INVALID_VALUE, glSelectBuffer(1, NULL));
        EXPECT_NO_ERROR(glSelectBuffer(0, NULL));
        EXPECT_ERROR(GL_INVALID_OPERATION, glRenderMode(GL_SELECT));
        EXPECT_INTS(GL_RENDER_MODE, GL_RENDER);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            SELECT_TEST(records),         SELECT_TEST(depth),  SELECT_TEST(what_is_hit),
            SELECT_TEST(name_stack),      SELECT_TEST(lists),  SELECT_TEST(overflow),
            SELECT_TEST(raster_position), SELECT_TEST(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
