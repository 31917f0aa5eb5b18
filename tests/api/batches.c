/* Which commands draw the vertices that immediate mode still holds. It can be seen: a colour that is part of
 * stored vertices stays an attribute of those that follow, is interpolated, and falls from 128 to 127 here
 * and there; after the vertices are drawn a colour set outside glBegin and glEnd is a constant, and exact. A
 * batch that ends elsewhere than OSMesa's therefore changes pixels. (OSMesa rule: measured; the specification
 * knows no batches.) */
#include "api/gl_test.h"

static void begin_batch(void)
{
    glFinish();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(0.25f, 0.25f, 0.25f);
    glBegin(GL_QUADS); /* out of sight */
    glColor3f(0.5f, 0.5f, 0.5f);
    for (int i = 0; i < 4; i++)
        glVertex3f(100, 100, -3);
    glEnd();
}

/* A grey quad in perspective. True if its colour was a constant. */
static bool batch_has_ended(void)
{
    glBegin(GL_QUADS);
    glVertex3f(-3, -3, -3);
    glVertex3f(4, -3, -5);
    glVertex3f(4, 4, -9);
    glVertex3f(-3, 3, -6);
    glEnd();
    glFinish();
    int exact = 0, lower = 0;
    for (int i = 0; i < TEST_SIZE * TEST_SIZE; i++) {
        exact += picture[4 * i] == 128;
        lower += picture[4 * i] == 127;
    }
    assert_true(exact > 1000);
    return lower == 0;
}

static int failures;

static void check(const char *call, bool expected)
{
    if (batch_has_ended() != expected) {
        print_error("%s: the batch %s\n", call, expected ? "goes on" : "ends");
        failures++;
    }
    glGetError();
}

/* In a state of its own, so that every row stands alone. */
#define ROW(call, ends)                                                                                      \
    glPushAttrib(GL_ALL_ATTRIB_BITS);                                                                        \
    begin_batch();                                                                                           \
    call;                                                                                                    \
    check(#call, ends);                                                                                      \
    glPopAttrib();
#define ENDS(call) ROW(call, true)
#define GOES_ON(call) ROW(call, false)

#define TEST_BEGIN                                                                                           \
    (void)state;                                                                                             \
    failures = 0;
#define TEST_END assert_int_equal(failures, 0);

static void nothing_between(void **state)
{
    TEST_BEGIN
    GOES_ON((void)0)
    ENDS(glFlush())
    ENDS(glFinish())
    TEST_END
}

static void values_that_are_there_already(void **state)
{
    TEST_BEGIN
    const GLfloat black[4] = {0, 0, 0, 1}, sun[4] = {0, 0, 1, 0};
    const GLdouble no_plane[4] = {0};
    GOES_ON(glEnable(GL_DITHER))
    GOES_ON(glDisable(GL_BLEND))
    GOES_ON(glDepthFunc(GL_LESS))
    GOES_ON(glViewport(0, 0, TEST_SIZE, TEST_SIZE))
    GOES_ON(glDepthRange(0, 1))
    GOES_ON(glScissor(0, 0, TEST_SIZE, TEST_SIZE))
    GOES_ON(glShadeModel(GL_SMOOTH))
    GOES_ON(glLightfv(GL_LIGHT1, GL_AMBIENT, black))
    GOES_ON(glLightfv(GL_LIGHT1, GL_POSITION, sun))
    GOES_ON(glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0))
    GOES_ON(glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE))
    GOES_ON(glClipPlane(GL_CLIP_PLANE0, no_plane))
    GOES_ON(glFogf(GL_FOG_DENSITY, 1))
    GOES_ON(glHint(GL_FOG_HINT, GL_DONT_CARE))
    GOES_ON(glAlphaFunc(GL_ALWAYS, 0))
    GOES_ON(glStencilMask(0xff))
    GOES_ON(glColorMask(1, 1, 1, 1))
    GOES_ON(glPointSize(1))
    GOES_ON(glLineStipple(1, 0xffff))
    GOES_ON(glPolygonMode(GL_FRONT_AND_BACK, GL_FILL))
    GOES_ON(glPolygonOffset(0, 0))
    GOES_ON(glIndexMask(~0u))
    TEST_END
}

static void new_values(void **state)
{
    TEST_BEGIN
    const GLfloat grey[4] = {0.5f, 0.5f, 0.5f, 1};
    const GLdouble plane[4] = {0, 0, 0, 1};
    ENDS(glEnable(GL_NORMALIZE))
    ENDS(glEnable(GL_COLOR_MATERIAL))
    ENDS(glDepthFunc(GL_LEQUAL))
    ENDS(glViewport(0, 0, TEST_SIZE - 1, TEST_SIZE))
    ENDS(glDepthRange(0, 0.5))
    ENDS(glScissor(0, 0, TEST_SIZE - 1, TEST_SIZE))
    ENDS(glLightfv(GL_LIGHT1, GL_AMBIENT, grey))
    ENDS(glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1))
    ENDS(glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE))
    ENDS(glClipPlane(GL_CLIP_PLANE0, plane))
    ENDS(glFogf(GL_FOG_DENSITY, 2))
    ENDS(glHint(GL_FOG_HINT, GL_NICEST))
    ENDS(glAlphaFunc(GL_ALWAYS, 0.5f))
    ENDS(glStencilMask(1))
    ENDS(glColorMask(1, 1, 1, 0))
    ENDS(glPointSize(2))
    ENDS(glLineStipple(1, 0x0fff))
    ENDS(glPolygonOffset(1, 0))
    ENDS(glIndexMask(1))
    TEST_END
}

/* Whatever the value. */
static void always(void **state)
{
    TEST_BEGIN
    const GLubyte ones[128] = {0xff};
    GLfloat v[4];
    ENDS(glPolygonStipple(ones))
    ENDS(glDrawBuffer(GL_FRONT))
    ENDS(glReadBuffer(GL_FRONT))
    ENDS(glDrawBuffer(GL_POINTS + 3))
    ENDS(glListBase(0))
    ENDS(glDeleteLists(glGenLists(1), 1))
    ENDS(glIsList(1))
    ENDS(glClear(0))
    ENDS(glGetMaterialfv(GL_FRONT, GL_AMBIENT, v))
    ENDS(glNewList(1, GL_COMPILE); glEndList(); glDeleteLists(1, 1))
    TEST_END
}

static void matrices(void **state)
{
    TEST_BEGIN
    const GLfloat identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ENDS(glLoadIdentity())
    ENDS(glTranslatef(0, 0, 0))
    ENDS(glScalef(1, 1, 1))
    ENDS(glRotatef(0, 0, 0, 1))
    ENDS(glPushMatrix(); glTranslatef(0, 0, 0); glPopMatrix())
    GOES_ON(glLoadMatrixf(identity))
    GOES_ON(glMultMatrixf(identity))
    GOES_ON(glPushMatrix(); glPopMatrix())
    const GLdouble no_plane[4] = {0};
    GOES_ON(glPushMatrix(); glClipPlane(GL_CLIP_PLANE0, no_plane);
            glPopMatrix()) /* uses the matrix, but does not change it */
    GOES_ON(glMatrixMode(GL_PROJECTION))
    GOES_ON(glOrtho(0, 0, 0, 1, 1, 2))
    GOES_ON(glPopMatrix())
    TEST_END
}

static void queries_and_errors(void **state)
{
    TEST_BEGIN
    GLfloat v[16];
    GLint n[4];
    GOES_ON(glEnable(0x1234))
    GOES_ON(glDepthFunc(0x1234))
    GOES_ON(glGetError())
    GOES_ON(glGetString(GL_VERSION))
    GOES_ON(glIsEnabled(GL_FOG))
    GOES_ON(glGetIntegerv(GL_DEPTH_BITS, n))
    GOES_ON(glGetFloatv(GL_MODELVIEW_MATRIX, v))
    GOES_ON(glGetFloatv(GL_CURRENT_COLOR, v))
    GOES_ON(glGetLightfv(GL_LIGHT0, GL_AMBIENT, v))
    TEST_END
}

static void what_does_not_touch_drawing(void **state)
{
    TEST_BEGIN
    const GLfloat v[4] = {0};
    GOES_ON(glClearColor(0, 0, 0, 1))
    GOES_ON(glClearDepth(1))
    GOES_ON(glClearStencil(1))
    GOES_ON(glPixelStorei(GL_PACK_SKIP_ROWS, 0))
    GOES_ON(glVertexPointer(3, GL_FLOAT, 0, v))
    GOES_ON(glEnableClientState(GL_NORMAL_ARRAY); glDisableClientState(GL_NORMAL_ARRAY))
    GOES_ON(glCallList(77))
    TEST_END
}

static void attribute_stacks(void **state)
{
    TEST_BEGIN
    GOES_ON(glPushClientAttrib(~0u); glPopClientAttrib())
    const GLbitfield masks[] = {0, GL_CURRENT_BIT, GL_LIGHTING_BIT, GL_ENABLE_BIT, GL_ALL_ATTRIB_BITS};
    for (int i = 0; i < 5; i++) {
        GOES_ON(glPushAttrib(masks[i]))
        ENDS(glPopAttrib())
    }
    TEST_END
}

/* The colour that a list sets last is the current one, whatever was current before it. OSMesa agrees. */
static void lists_leave_their_last_color(void **state)
{
    (void)state;
    glNewList(1, GL_COMPILE);
    glColor3f(1, 0, 0);
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glColor3f(0, 1, 0);
    glVertex2f(0.5f, 0);
    glEnd();
    glEndList();
    glCallList(1);
    glBegin(GL_POINTS);
    glVertex2f(-0.5f, -0.5f);
    glEnd();
    EXPECT_VALUES(GL_CURRENT_COLOR, 0, 1, 0, 1);
    glFinish();
    assert_memory_equal(picture + 4 * (TEST_SIZE / 4 * TEST_SIZE + TEST_SIZE / 4), "\0\xff\0\xff", 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(nothing_between),
            GL_TEST(values_that_are_there_already),
            GL_TEST(new_values),
            GL_TEST(always),
            GL_TEST(what_does_not_touch_drawing),
            GL_TEST(queries_and_errors),
            GL_TEST(matrices),
            GL_TEST(attribute_stacks),
            GL_TEST(lists_leave_their_last_color),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
