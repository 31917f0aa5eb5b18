/* Between glBegin and glEnd (GL 1.5, 2.6.3 "GL Commands within Begin/End"): every command that is not allowed
 * there raises GL_INVALID_OPERATION and does nothing else. The calls are made from src/api/command.def. */
#include "api/gl_test.h"

#include "api/foreach.h"

/* Any argument: none of them may be looked at. */
static union {
    GLdouble d[16];
    GLubyte bytes[1024];
} memory;

#define ARGUMENT(type, name)                                                                                 \
    _Generic((type)0,                                                                                        \
            void *: (void *)&memory,                                                                         \
            const void *: (const void *)&memory,                                                             \
            void **: (void *)&memory,                                                                        \
            const GLvoid *const *: (const GLvoid *const *)(const void *)&memory,                             \
            const GLint *: (GLint *)(void *)&memory,                                                         \
            const GLuint *: (GLuint *)(void *)&memory,                                                       \
            GLuint *: (GLuint *)(void *)&memory,                                                             \
            const GLubyte *: memory.bytes,                                                                   \
            GLubyte *: memory.bytes,                                                                         \
            const GLfloat *: (GLfloat *)(void *)&memory,                                                     \
            GLfloat *: (GLfloat *)(void *)&memory,                                                           \
            const GLdouble *: memory.d,                                                                      \
            GLdouble *: memory.d,                                                                            \
            GLint *: (GLint *)(void *)&memory,                                                               \
            default: (type)0)

static int failures;

static void check(const char *name)
{
    glEnd();
    const GLenum error = glGetError();
    glBegin(GL_POINTS);
    if (error == GL_INVALID_OPERATION)
        return;
    print_error("gl%s between glBegin and glEnd: error 0x%x\n", name, error);
    failures++;
}

#define TRY(name, call)                                                                                      \
    call;                                                                                                    \
    check(#name);

#define CMD_LIST(name, ...) TRY(name, gl##name(FGL_LIST(ARGUMENT, __VA_ARGS__)))
#define CMD_LISTV(name, type, count, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_NOW(name, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_LIST0(name) TRY(name, gl##name())
#define CMD_NOW0(name) TRY(name, gl##name())
#define CMD_GET(ret, name, ...) TRY(name, assert_true(gl##name(FGL_LIST(ARGUMENT, __VA_ARGS__)) == (ret)0))
#define CMD_GET0(ret, name) TRY(name, assert_true(gl##name() == (ret)0))
#define CMD_ALIAS(name, old, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_ALIAS0(name, old) TRY(name, gl##name())
#define CMD_ALIAS_GET(ret, name, old, ...) CMD_GET(ret, name, __VA_ARGS__)
#define CMD_HAND(name)

static void every_generated_command(void **state)
{
    (void)state;
    failures = 0;
    glBegin(GL_POINTS);
#include "api/command.def"
    glEnd();
    assert_int_equal(failures, 0);
}

static void commands_written_by_hand(void **state)
{
    (void)state;
    GLfloat *const f = (GLfloat *)(void *)&memory;
    GLint *const i = (GLint *)(void *)&memory;
    failures = 0;
    glBegin(GL_POINTS);
    TRY(Begin, glBegin(GL_LINES))
    TRY(LoadMatrixd, glLoadMatrixd(memory.d))
    TRY(MultMatrixd, glMultMatrixd(memory.d))
    TRY(Rotated, glRotated(1, 0, 0, 1))
    TRY(Translated, glTranslated(1, 0, 0))
    TRY(Scaled, glScaled(1, 1, 1))
    TRY(Lightf, glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 10))
    TRY(Lighti, glLighti(GL_LIGHT0, GL_SPOT_CUTOFF, 10))
    TRY(Lightiv, glLightiv(GL_LIGHT0, GL_SPOT_CUTOFF, i))
    TRY(LightModelf, glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1))
    TRY(LightModeli, glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1))
    TRY(LightModeliv, glLightModeliv(GL_LIGHT_MODEL_TWO_SIDE, i))
    TRY(PolygonStipple, glPolygonStipple(memory.bytes))
    TRY(PixelStoref, glPixelStoref(GL_PACK_ALIGNMENT, 1))
    TRY(Fogf, glFogf(GL_FOG_DENSITY, 1))
    TRY(Fogi, glFogi(GL_FOG_DENSITY, 1))
    TRY(Fogiv, glFogiv(GL_FOG_DENSITY, i))
    TRY(Rectf, glRectf(0, 0, 1, 1))
    TRY(Rectd, glRectd(0, 0, 1, 1))
    TRY(Recti, glRecti(0, 0, 1, 1))
    TRY(Rectfv, glRectfv(f, f))
    TRY(NewList, glNewList(1, GL_COMPILE))
    TRY(EndList, glEndList())
    TRY(DrawArrays, glDrawArrays(GL_POINTS, 0, 1))
    TRY(DrawElements, glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, memory.bytes))
    TRY(DrawRangeElements, glDrawRangeElements(GL_POINTS, 0, 0, 1, GL_UNSIGNED_BYTE, memory.bytes))
    TRY(MultiDrawArrays, glMultiDrawArrays(GL_POINTS, i, i, 1))
    TRY(MultiDrawElements, glMultiDrawElements(GL_POINTS, i, GL_UNSIGNED_BYTE, (const void *const *)&memory, 1))
    TRY(LoadTransposeMatrixf, glLoadTransposeMatrixf(f))
    TRY(LoadTransposeMatrixd, glLoadTransposeMatrixd(memory.d))
    TRY(MultTransposeMatrixf, glMultTransposeMatrixf(f))
    TRY(MultTransposeMatrixd, glMultTransposeMatrixd(memory.d))
    TRY(PointParameterf, glPointParameterf(GL_POINT_SIZE_MIN, 1))
    TRY(PointParameteri, glPointParameteri(GL_POINT_SIZE_MIN, 1))
    TRY(PointParameteriv, glPointParameteriv(GL_POINT_SIZE_MIN, i))
    glEnd();
    assert_int_equal(failures, 0);
}

static void allowed_commands(void **state)
{
    (void)state;
    const GLfloat v[4] = {0, 0, 0, 1};
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glColor3f(1, 0, 0);
    glEndList();

    glBegin(GL_POINTS);
    glVertex2i(0, 0);
    glColor4fv(v);
    glIndexi(1);
    glNormal3fv(v);
    glTexCoord2f(0, 0);
    glEdgeFlag(GL_TRUE);
    glSecondaryColor3f(1, 0, 0);
    glFogCoordf(1);
    glMultiTexCoord2f(GL_TEXTURE1, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT, v);
    glMaterialf(GL_FRONT, GL_SHININESS, 1);
    glCallList(list);
    glCallLists(1, GL_UNSIGNED_INT, &list);
    glArrayElement(0);
    glEnd();
    EXPECT_VALUES(GL_CURRENT_COLOR, 1, 0, 0, 1);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void get_error_inside(void **state)
{
    (void)state;
    glCullFace(GL_POINT);
    glBegin(GL_POINTS);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glEnd();
    assert_int_equal(glGetError(), GL_INVALID_ENUM); /* the first error is the one that is kept */
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* The same in display lists, where the errors come when they are executed (GL 1.5, 5.4). */
static GLuint compiled(void (*commands)(void))
{
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    commands();
    glEndList();
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return list;
}

static void cull(void)
{
    glCullFace(GL_FRONT);
}
static void bitmap(void)
{
    glBitmap(1, 1, 0, 0, 0, 0, memory.bytes);
}
static void rectangle(void)
{
    glVertex2f(0, 0);
    glRectf(0, 0, 1, 1);
}
static void arrays(void)
{
    glDrawArrays(GL_QUADS, 0, 4);
}

static void refused(void (*commands)(void))
{
    const GLuint list = compiled(commands);
    glBegin(GL_QUADS);
    glCallList(list);
    glEnd();
    assert_int_equal(glGetError(), GL_INVALID_OPERATION);
    EXPECT_ERROR(GL_NO_ERROR, glBegin(GL_QUADS); glEnd()); /* the list has not ended the caller's primitive, nor begun one */

    const GLuint around = glGenLists(1);
    glNewList(around, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_QUADS);
    commands();
    glEnd();
    glEndList();
    assert_int_equal(glGetError(), GL_INVALID_OPERATION);
    glCallList(around);
    assert_int_equal(glGetError(), GL_INVALID_OPERATION);
}

static void lists_inside(void **state)
{
    (void)state;
    refused(cull);
    refused(bitmap);
    refused(rectangle);
    refused(arrays);
    GLint face;
    glGetIntegerv(GL_CULL_FACE_MODE, &face);
    assert_int_equal(face, GL_BACK);
    compiled(rectangle); /* is no error while it is compiled */
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_POLYGON + 100);
    glEnd();
    glEndList();
    assert_int_equal(glGetError(), GL_INVALID_ENUM);
    EXPECT_ERROR(GL_INVALID_ENUM, glCallList(1));
}

static void end_without_begin(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, glEnd());
    EXPECT_ERROR(GL_INVALID_ENUM, glBegin(GL_POLYGON + 100));
    EXPECT_ERROR(GL_INVALID_OPERATION, glEnd());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(every_generated_command), GL_TEST(commands_written_by_hand), GL_TEST(allowed_commands),
            GL_TEST(get_error_inside),        GL_TEST(end_without_begin),
            GL_TEST(lists_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
