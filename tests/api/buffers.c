/* Buffer objects and occlusion queries (GL 1.5, 2.9, 4.1.7): names, errors, bounds, sharing. */
#include "api/gl_test.h"

static const GLfloat square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

static GLint get(GLenum name)
{
    GLint v = -1;
    glGetIntegerv(name, &v);
    return v;
}

static int pixels_drawn(void)
{
    int n = 0;
    glFinish();
    for (int i = 0; i < TEST_SIZE * TEST_SIZE; i++)
        n += picture[4 * i] != 0;
    glClear(GL_COLOR_BUFFER_BIT);
    return n;
}

static GLuint make_square(void)
{
    GLuint name;
    glGenBuffers(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, sizeof square, square, GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glEnableClientState(GL_VERTEX_ARRAY);
    return name;
}

static void names(void **state)
{
    (void)state;
    GLuint name[2];
    glGenBuffers(2, name);
    assert_int_not_equal(name[0], name[1]);
    assert_false(glIsBuffer(name[0])); /* not before it is bound */
    glBindBuffer(GL_ARRAY_BUFFER, name[0]);
    assert_true(glIsBuffer(name[0]));
    assert_int_equal(get(GL_ARRAY_BUFFER_BINDING), name[0]);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    assert_int_equal(get(GL_VERTEX_ARRAY_BUFFER_BINDING), name[0]);
    glDeleteBuffers(2, name);
    assert_int_equal(get(GL_ARRAY_BUFFER_BINDING), 0);
    assert_int_equal(get(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
    assert_false(glIsBuffer(name[0]));
}

static void data_and_mapping(void **state)
{
    (void)state;
    GLuint name = make_square();
    GLfloat back[8] = {0}, one = 7;
    glBufferSubData(GL_ARRAY_BUFFER, 4, sizeof one, &one);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof back, back);
    assert_true(back[0] == -1 && back[1] == 7);
    const GLfloat *mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
    assert_true(mapped && mapped[1] == 7);
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBufferSubData(GL_ARRAY_BUFFER, 0, 4, &one));
    EXPECT_ERROR(on_fixedgl() ? GL_INVALID_OPERATION : GL_NO_ERROR, glDrawArrays(GL_QUADS, 0, 4));
    assert_true(glUnmapBuffer(GL_ARRAY_BUFFER));
    EXPECT_ERROR(GL_INVALID_OPERATION, glUnmapBuffer(GL_ARRAY_BUFFER));
    glDeleteBuffers(1, &name);
}

static void errors(void **state)
{
    (void)state;
    GLint v;
    EXPECT_ERROR(GL_INVALID_OPERATION, glBufferData(GL_ARRAY_BUFFER, 4, NULL, GL_STATIC_DRAW)); /* none is bound */
    EXPECT_ERROR(GL_INVALID_ENUM, glBindBuffer(GL_VERTEX_ARRAY, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glGenBuffers(-1, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glDeleteBuffers(-1, NULL));
    GLuint name = make_square();
    EXPECT_ERROR(GL_INVALID_VALUE, glBufferData(GL_ARRAY_BUFFER, -1, NULL, GL_STATIC_DRAW));
    EXPECT_ERROR(GL_INVALID_ENUM, glBufferData(GL_ARRAY_BUFFER, 4, NULL, GL_READ_ONLY));
    EXPECT_ERROR(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, 29, 4, square));
    EXPECT_ERROR(GL_INVALID_VALUE, glBufferSubData(GL_ARRAY_BUFFER, -1, 4, square));
    EXPECT_ERROR(GL_INVALID_ENUM, glMapBuffer(GL_ARRAY_BUFFER, GL_STATIC_DRAW));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &v));
    EXPECT_ERROR(GL_INVALID_VALUE, glDrawRangeElements(GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE, NULL));
    glDeleteBuffers(1, &name);
}

/* Nothing outside of a buffer is ever read: valgrind and the sanitizers watch, and what is missing counts as 0. */
static void draws_beyond_the_end(void **state)
{
    (void)state;
    GLuint name = make_square();
    static const GLuint far[] = {0, 1, 4000000000u, 3};
    glDrawArrays(GL_QUADS, 0, 4);
    assert_int_equal(pixels_drawn(), TEST_SIZE * TEST_SIZE);
    if (!on_fixedgl())
        return;
    glDrawArrays(GL_TRIANGLES, 0, 6);
    glDrawArrays(GL_TRIANGLES, 0, 2000000000);
    glDrawArrays(GL_TRIANGLES, 2000000000, 3);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, far + 1);
    glVertexPointer(4, GL_DOUBLE, 0, (const GLvoid *)(uintptr_t)24);
    glDrawArrays(GL_QUADS, 0, 4);
    glVertexPointer(2, GL_FLOAT, 0, (const GLvoid *)UINTPTR_MAX);
    glDrawArrays(GL_QUADS, 0, 4);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glDrawElements(GL_TRIANGLES, 3000, GL_UNSIGNED_BYTE, (const GLvoid *)(uintptr_t)20);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, (const GLvoid *)(uintptr_t)32);
    glArrayElement(77);
    glDeleteBuffers(1, &name);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void saved_bindings(void **state)
{
    (void)state;
    GLuint name = make_square();
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glVertexPointer(3, GL_FLOAT, 0, NULL);
    glPopClientAttrib();
    assert_int_equal(get(GL_ARRAY_BUFFER_BINDING), name);
    assert_int_equal(get(GL_VERTEX_ARRAY_BUFFER_BINDING), name);
    assert_int_equal(get(GL_VERTEX_ARRAY_SIZE), 2);
    glDeleteBuffers(1, &name);
}

static GLuint counted(GLuint query)
{
    GLuint n = 0;
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &n);
    return n;
}

static void occlusion(void **state)
{
    (void)state;
    GLuint query;
    glGenQueries(1, &query);
    assert_false(glIsQuery(query)); /* not before it is begun */
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    glRectf(-1, -1, 1, 1); /* before the query, and not drawn yet */
    glBeginQuery(GL_SAMPLES_PASSED, query);
    EXPECT_ERROR(GL_INVALID_OPERATION, glBeginQuery(GL_SAMPLES_PASSED, query + 1));
    GLuint n, available = 0;
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetQueryObjectuiv(query, GL_QUERY_RESULT, &n));
    glRectf(-1, -1, 1, 1); /* no deeper: fails the test */
    assert_int_equal(counted(query), 0);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glRectf(-1, -1, 0, 1);
    assert_int_equal(counted(query), TEST_SIZE * TEST_SIZE / 2);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glRectf(-1, -1, 1, 1);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
    assert_int_equal(available, GL_TRUE);
    EXPECT_ERROR(GL_INVALID_OPERATION, glEndQuery(GL_SAMPLES_PASSED));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBeginQuery(GL_SAMPLES_PASSED, 0));
    EXPECT_ERROR(GL_INVALID_ENUM, glBeginQuery(GL_QUERY_RESULT, query));
    glDeleteQueries(1, &query);
    assert_false(glIsQuery(query));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(names),         GL_TEST(data_and_mapping), GL_TEST(errors), GL_TEST(draws_beyond_the_end),
            GL_TEST(saved_bindings), GL_TEST(occlusion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
