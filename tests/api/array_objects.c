/* Vertex array objects (GL_ARB_vertex_array_object): names, what they keep, errors. The same on OSMesa, but for the size that a refused call
 * leaves there (docs/departures.md, refused-pointers). */
#include "api/gl_test.h"

static const GLfloat corners[] = {-1, -1, 1, -1, 1, 1, -1, 1};

static GLint integer(GLenum name)
{
    GLint v = -1;
    glGetIntegerv(name, &v);
    return v;
}

/* A buffer object, bound to GL_ARRAY_BUFFER. */
static GLuint buffer(const void *data, GLsizeiptr size)
{
    GLuint b;
    glGenBuffers(1, &b);
    glBindBuffer(GL_ARRAY_BUFFER, b);
    glBufferData(GL_ARRAY_BUFFER, size, data, GL_STATIC_DRAW);
    return b;
}

static void names(void **state)
{
    (void)state;
    GLuint a[3];
    EXPECT_ERROR(GL_INVALID_VALUE, glGenVertexArrays(-1, a));
    EXPECT_ERROR(GL_INVALID_VALUE, glDeleteVertexArrays(-1, a));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBindVertexArray(77));
    glGenVertexArrays(3, a);
    assert_true(a[0] && a[1] && a[2] && a[0] != a[1] && a[1] != a[2]);
    assert_false(glIsVertexArray(a[0]));
    assert_false(glIsVertexArray(0));
    EXPECT_NO_ERROR(glBindVertexArray(a[0]));
    assert_true(glIsVertexArray(a[0]));
    assert_int_equal(integer(GL_VERTEX_ARRAY_BINDING), a[0]);
    EXPECT_NO_ERROR(glDeleteVertexArrays(3, a));
    assert_int_equal(integer(GL_VERTEX_ARRAY_BINDING), 0);
    assert_false(glIsVertexArray(a[0]));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBindVertexArray(a[0]));
}

static void contents(void **state)
{
    (void)state;
    GLuint a[2];
    glVertexPointer(3, GL_SHORT, 8, corners);
    glEnableClientState(GL_COLOR_ARRAY);
    glGenVertexArrays(2, a);
    glBindVertexArray(a[0]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_SIZE), 4); /* a new object has initial values */
    assert_int_equal(integer(GL_NORMAL_ARRAY_TYPE), GL_FLOAT);
    assert_false(glIsEnabled(GL_COLOR_ARRAY));

    const GLuint vertices = buffer(corners, sizeof corners), elements = buffer(corners, sizeof corners);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glEnableClientState(GL_VERTEX_ARRAY);
    glClientActiveTexture(GL_TEXTURE1);

    glBindVertexArray(a[1]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_SIZE), 4);
    assert_int_equal(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
    assert_int_equal(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
    assert_false(glIsEnabled(GL_VERTEX_ARRAY));
    assert_int_equal(integer(GL_ARRAY_BUFFER_BINDING), vertices); /* not of an object, */
    assert_int_equal(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE1); /* nor is this */

    glBindVertexArray(a[0]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_SIZE), 2);
    assert_int_equal(integer(GL_VERTEX_ARRAY_BUFFER_BINDING), vertices);
    assert_int_equal(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), elements);
    assert_true(glIsEnabled(GL_VERTEX_ARRAY));

    glBindVertexArray(0);
    assert_int_equal(integer(GL_VERTEX_ARRAY_SIZE), 3);
    assert_int_equal(integer(GL_VERTEX_ARRAY_TYPE), GL_SHORT);
    assert_true(glIsEnabled(GL_COLOR_ARRAY));
    glDeleteVertexArrays(2, a);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Arrays of an object lie in buffer objects. */
static void client_memory(void **state)
{
    (void)state;
    GLuint a;
    glGenVertexArrays(1, &a);
    glBindVertexArray(a);
    EXPECT_ERROR(GL_INVALID_OPERATION, glVertexPointer(2, GL_FLOAT, 0, corners));
    assert_int_equal(integer(GL_VERTEX_ARRAY_SIZE), 4);
    EXPECT_ERROR(GL_INVALID_OPERATION, glColorPointer(3, GL_FLOAT, 0, corners));
    EXPECT_NO_ERROR(glVertexPointer(2, GL_FLOAT, 0, NULL));
    glBindVertexArray(0);
    EXPECT_NO_ERROR(glVertexPointer(2, GL_FLOAT, 0, corners));
}

static void drawing(void **state)
{
    (void)state;
    static const GLubyte order[] = {0, 1, 2, 3}, red[] = {255, 0, 0, 255};
    GLuint a, b;
    GLubyte pixel[4];
    glGenVertexArrays(1, &a);
    glBindVertexArray(a);
    b = buffer(corners, sizeof corners);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glEnableClientState(GL_VERTEX_ARRAY);
    glGenBuffers(1, &b);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, b);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof order, order, GL_STATIC_DRAW);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 0, 0);
    glBindVertexArray(a);
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, NULL);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    assert_memory_equal(pixel, red, 4);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void pushed(void **state)
{
    (void)state;
    GLuint a[2];
    glGenVertexArrays(2, a);
    glBindVertexArray(a[0]);
    buffer(corners, sizeof corners);
    glVertexPointer(2, GL_FLOAT, 16, NULL);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glVertexPointer(4, GL_FLOAT, 32, NULL);
    glBindVertexArray(a[1]);
    glVertexPointer(3, GL_FLOAT, 24, NULL);
    glPopClientAttrib();
    assert_int_equal(integer(GL_VERTEX_ARRAY_BINDING), a[0]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_STRIDE), 16);
    glBindVertexArray(a[1]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_STRIDE), 24);

    glBindVertexArray(a[0]);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glBindVertexArray(a[1]);
    glDeleteVertexArrays(1, a);
    glPopClientAttrib(); /* to an object that is gone: nothing is restored */
    assert_int_equal(integer(GL_VERTEX_ARRAY_BINDING), a[1]);
    assert_int_equal(integer(GL_VERTEX_ARRAY_STRIDE), 24);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(names), GL_TEST(contents), GL_TEST(client_memory), GL_TEST(drawing), GL_TEST(pushed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
