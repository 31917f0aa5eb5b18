/* Matrix commands, stacks and clip planes as queries show them (GL 1.5, 2.11.2 "Matrices", 2.12 "Clipping").
 */
#include "api/gl_test.h"

static const GLfloat numbered[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

#define EXPECT_MODELVIEW(...) EXPECT_VALUES(GL_MODELVIEW_MATRIX, __VA_ARGS__)

static void load_and_multiply(void **state)
{
    (void)state;
    GLdouble d[16];
    for (int i = 0; i < 16; i++)
        d[i] = (double)numbered[i];
    glLoadMatrixf(numbered);
    EXPECT_MODELVIEW(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
    glMultMatrixd(d); /* M M */
    EXPECT_MODELVIEW(90, 100, 110, 120, 202, 228, 254, 280, 314, 356, 398, 440, 426, 484, 542, 600);
    glLoadIdentity();
    EXPECT_MODELVIEW(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    glLoadMatrixd(d);
    EXPECT_MODELVIEW(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
}

/* Each is applied to the object before what the matrix held. */
static void translate_scale_rotate(void **state)
{
    (void)state;
    glTranslatef(1, 2, 3);
    glScaled(2, 4, 8);
    EXPECT_MODELVIEW(2, 0, 0, 0, 0, 4, 0, 0, 0, 0, 8, 0, 1, 2, 3, 1);
    glTranslated(1, 1, 1);
    EXPECT_MODELVIEW(2, 0, 0, 0, 0, 4, 0, 0, 0, 0, 8, 0, 3, 6, 11, 1);
    glLoadIdentity();
    glRotatef(0, 0, 0, 1);
    EXPECT_MODELVIEW(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    GLfloat m[16];
    glRotated(90, 0, 0, 5); /* x to y; the axis need not be a unit vector */
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    assert_true(m[0] < 1e-6f && m[0] > -1e-6f && m[1] == 1 && m[4] == -1 && m[10] == 1);
}

static void projections(void **state)
{
    (void)state;
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 3, -1, 1, 1, 3);
    EXPECT_VALUES(GL_PROJECTION_MATRIX, 0.5f, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0, -2, -1, 0, 0, -3, 0);
    glLoadIdentity();
    glOrtho(-1, 3, -1, 1, 1, 3);
    EXPECT_VALUES(GL_PROJECTION_MATRIX, 0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, -0.5f, 0, -2, 1);
    EXPECT_MODELVIEW(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
}

static void try_stack(GLenum mode, GLenum depth, GLenum matrix, int limit)
{
    glMatrixMode(mode);
    for (int i = 1; i < limit; i++) {
        glTranslatef(1, 0, 0);
        EXPECT_NO_ERROR(glPushMatrix());
        EXPECT_INTS(depth, i + 1);
    }
    EXPECT_ERROR(GL_STACK_OVERFLOW, glPushMatrix());
    for (int i = limit - 1; i >= 1; i--) {
        glTranslatef(0, 7, 0);
        EXPECT_NO_ERROR(glPopMatrix());
        EXPECT_VALUES(matrix, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, (GLfloat)i, 0, 0, 1);
    }
    EXPECT_ERROR(GL_STACK_UNDERFLOW, glPopMatrix());
    EXPECT_INTS(depth, 1);
}

static void stacks(void **state)
{
    (void)state;
    try_stack(GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_MATRIX, 32);
    try_stack(GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_PROJECTION_MATRIX, 32);
    try_stack(GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_TEXTURE_MATRIX, 10);
}

static void modes_are_separate(void **state)
{
    (void)state;
    const GLenum modes[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
    const GLenum names[] = {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX};
    for (int i = 0; i < 3; i++) {
        glMatrixMode(modes[i]);
        EXPECT_INTS(GL_MATRIX_MODE, (GLint)modes[i]);
        glTranslatef((GLfloat)i + 1, 0, 0);
    }
    for (int i = 0; i < 3; i++)
        EXPECT_VALUES(names[i], 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, (GLfloat)i + 1, 0, 0, 1);
}

static void matrices_in_a_list(void **state)
{
    (void)state;
    GLfloat m[16];
    memcpy(m, numbered, sizeof m);
    glNewList(1, GL_COMPILE);
    glLoadMatrixf(m);
    glFrustum(0, 0, 0, 0, 0, 0);
    glEndList();
    memset(m, 0, sizeof m); /* the list keeps its own copy */
    EXPECT_MODELVIEW(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glCallList(1);
    EXPECT_MODELVIEW(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
    assert_int_equal(glGetError(), GL_INVALID_VALUE);
    glDeleteLists(1, 1);
}

static void expect_plane(int i, double a, double b, double c, double d)
{
    GLdouble got[4] = {0};
    glGetClipPlane(GL_CLIP_PLANE0 + i, got);
    assert_true(got[0] == a && got[1] == b && got[2] == c && got[3] == d);
}

/* To eye coordinates by the inverse of the modelview matrix of the call. */
static void clip_planes(void **state)
{
    (void)state;
    const GLdouble plane[4] = {1, 2, 4, 8};
    for (int i = 0; i < 8; i++) {
        expect_plane(i, 0, 0, 0, 0);
        glClipPlane(GL_CLIP_PLANE0 + i, plane);
        expect_plane(i, 1, 2, 4, 8);
    }
    glTranslatef(1, 2, 3);
    glClipPlane(GL_CLIP_PLANE1, plane);
    expect_plane(1, 1, 2, 4, 8 - 1 - 4 - 12);
    glScalef(2, 2, 4);
    glClipPlane(GL_CLIP_PLANE2, plane);
    expect_plane(2, 0.5, 1, 1, 8 - 0.5 - 2 - 3);
    glLoadIdentity();
    expect_plane(1, 1, 2, 4, 8 - 1 - 4 - 12);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(load_and_multiply),  GL_TEST(translate_scale_rotate),
            GL_TEST(projections),        GL_TEST(stacks),
            GL_TEST(modes_are_separate), GL_TEST(matrices_in_a_list),
            GL_TEST(clip_planes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
