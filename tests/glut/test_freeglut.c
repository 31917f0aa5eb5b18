/* What freeglut adds to GLUT, but for the shapes (test_shapes.c). */
#include "headless.h"
#include <GL/freeglut.h>
#include <GLUT/glut.h> /* and the names of macOS, which are the same headers */
#include <OpenGL/gl.h>
#include <OpenGL/glext.h>
#include <OpenGL/glu.h>

static void display(void) {}

static void open_window(void)
{
    glutInitWindowSize(64, 64);
    glutCreateWindow("test");
    glutDisplayFunc(display);
    glViewport(0, 0, 64, 64);
}

static void print_raster(void)
{
    float at[4];
    glGetFloatv(GL_CURRENT_RASTER_POSITION, at);
    printf("%g %g;", (double)at[0], (double)at[1]);
}

/* A newline goes back to where the string began, one line down. */
static void strings(void)
{
    open_window();
    printf("%d %g;", glutBitmapHeight(GLUT_BITMAP_9_BY_15), (double)glutStrokeHeight(GLUT_STROKE_ROMAN));
    glOrtho(0, 64, 0, 64, -1, 1);
    glRasterPos2i(10, 40);
    glutBitmapString(GLUT_BITMAP_9_BY_15, (const unsigned char *)"ab\nc");
    print_raster();
    glutBitmapString(GLUT_BITMAP_9_BY_15, (const unsigned char *)"d");
    print_raster();
    glLoadIdentity();
    glutStrokeString(GLUT_STROKE_MONO_ROMAN, (const unsigned char *)"ab\nc");
    float m[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    printf("%g %g;", (double)m[12], (double)m[13]);
    printf("%g %g\n", (double)glutStrokeWidthf(GLUT_STROKE_MONO_ROMAN, 'x'),
           (double)glutStrokeLengthf(GLUT_STROKE_MONO_ROMAN, (const unsigned char *)"ab\nc"));
    exit(0);
}

static void test_strings(void **state)
{
    (void)state;
    expect_run(strings, VARIABLES("FIXEDGL_FRAMES=1"), 0, "16 152.381;19 24;28 24;104.76 -152.381;104.76 209.52\n");
}

static void menu_gone(void)
{
    printf("menu %d gone;", glutGetMenu());
}

static void nothing(int value)
{
    (void)value;
}

static void closing(void)
{
    printf("closed;");
}

static void data_and_ends(void)
{
    int mark, size = 7;
    open_window();
    printf("%d;", glutGetWindowData() == NULL);
    glutSetWindowData(&mark);
    glutWMCloseFunc(closing);
    glutCreateWindow("other");
    printf("%d;", glutGetWindowData() == NULL);
    glutSetWindow(1);
    printf("%d;", glutGetWindowData() == &mark);
    int menu = glutCreateMenu(nothing);
    glutSetMenuData(&mark);
    glutMenuDestroyFunc(menu_gone);
    printf("%d;", glutGetMenuData() == &mark);
    glutDestroyMenu(menu);
    printf("%d %d;", glutGetMenu(), glutGet(GLUT_INIT_STATE));
    printf("%d ", glutGetModeValues(GLUT_AUX, &size) == NULL);
    printf("%d;", size);
    glutExit();
    printf("%d\n", glutGet(GLUT_INIT_STATE));
    exit(0);
}

static void test_data_and_ends(void **state)
{
    (void)state;
    expect_run(data_and_ends, VARIABLES("FIXEDGL_FRAMES=1"), 0, "1;1;1;1;menu 1 gone;0 1;1 0;closed;0\n");
}

static void ends_itself(const char *format, va_list arguments)
{
    (void)format, (void)arguments;
    glutExit(); /* before glutInit: nothing to end */
    printf("ended\n");
    exit(3);
}

static void error_before_init(void)
{
    glutExit(); /* forgets glutInit */
    glutInitErrorFunc(ends_itself);
    glutCreateWindow("none");
}

static void test_error_before_init(void **state)
{
    (void)state;
    expect_run(error_before_init, VARIABLES("FIXEDGL_FRAMES=1"), 3, "ended\n");
}

static void called(void)
{
    printf("context;");
}

static void context(void)
{
    glutInitContextVersion(1, 5);
    glutInitContextProfile(GLUT_COMPATIBILITY_PROFILE);
    glutInitContextFlags(GLUT_DEBUG);
    open_window();
    glutInitContextFunc(called);
    printf("%d.%d %d %d;", glutGet(GLUT_INIT_MAJOR_VERSION), glutGet(GLUT_INIT_MINOR_VERSION),
           glutGet(GLUT_INIT_PROFILE), glutGet(GLUT_INIT_FLAGS));
    printf("%d %d\n", glutGetProcAddress("glVertex3f") == (GLUTproc)glVertex3f,
           glutGetProcAddress("glCreateShader") == NULL);
    exit(0);
}

static void test_context(void **state)
{
    (void)state;
    expect_run(context, VARIABLES("FIXEDGL_FRAMES=1"), 0, "context;1.5 2 1;1 1\n");
}

static void told(const char *format, va_list arguments)
{
    printf("told: ");
    vprintf(format, arguments);
    printf(";");
}

/* The program's functions get what would be printed; an error ends it all the same. */
static void reports(void)
{
    open_window();
    glutInitWarningFunc(told);
    glutInitErrorFunc(told);
    glutInitContextVersion(3, 2);
    glutSetOption(0x7777, 1);
    glutSetOption(GLUT_SKIP_STALE_MOTION_EVENTS, 1);
    glutDestroyWindow(1);
    glutSwapBuffers();
}

static void test_reports(void **state)
{
    (void)state;
    expect_run(reports, VARIABLES("FIXEDGL_FRAMES=1"), 1,
               "told: OpenGL 3.2 is not available: contexts are of OpenGL 1.5;"
               "told: glutSetOption: option 0x7777, value 1 not known;"
               "told: glutSwapBuffers called with no current window;");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_strings),
            cmocka_unit_test(test_data_and_ends), cmocka_unit_test(test_error_before_init),
            cmocka_unit_test(test_context),
            cmocka_unit_test(test_reports),
    };
    return cmocka_run_group_tests(tests, make_directory, remove_directory);
}
