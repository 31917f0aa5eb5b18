/* Colour index windows: indexes in the buffer, colours in the colormap, both in the picture. */
#include "headless.h"

static void display(void)
{
    glClearIndex(3);
    glClear(GL_COLOR_BUFFER_BIT);
    glIndexi(200);
    glRectf(-1, -1, 0, 1); /* the left half */
}

static void print_color(int cell)
{
    printf("%g %g %g;", (double)glutGetColor(cell, GLUT_RED), (double)glutGetColor(cell, GLUT_GREEN),
           (double)glutGetColor(cell, GLUT_BLUE));
}

static void recolor(unsigned char key, int x, int y)
{
    (void)key, (void)x, (void)y;
    glutSetColor(200, 0, 1, 0.6f); /* without drawing anew */
}

static void open_window(void)
{
    glutInitDisplayMode(GLUT_INDEX | GLUT_DEPTH);
    glutInitWindowSize(8, 4);
    glutCreateWindow("test");
    glutDisplayFunc(display);
    glutKeyboardFunc(recolor);
}

static void two_colors(void)
{
    open_window();
    glutSetColor(3, 0.2f, 0.4f, 1);
    glutSetColor(200, 7, -1, 0.5f);
    print_color(3);
    print_color(200);
    print_color(4);
    glutMainLoop();
}

static void test_picture(void **state)
{
    (void)state;
    const char *const printed = "0.2 0.4 1;1 0 0.5;0 0 0;";
    expect_run(two_colors, VARIABLES("FIXEDGL_CAPTURE=a.pam"), 0, printed);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0xff0080ff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 4, 0), 0x3366ffff);
    expect_run(two_colors, VARIABLES("FIXEDGL_CAPTURE=a.pam", "FIXEDGL_EVENTS=key c"), 0, printed);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 3), 0x00ff99ff);
    expect_run(two_colors, VARIABLES("FIXEDGL_CAPTURE=a.pam", "FIXEDGL_EVENTS=resize 6 2"), 0, printed);
    assert_int_equal(pam_pixel("a.pam", 6, 2, 2, 1), 0xff0080ff);
}

/* Every colour is black until it is set, and what does not exist is -1. */
static void queries(void)
{
    open_window();
    printf("%d %d %d %d;", glutGet(GLUT_WINDOW_RGBA), glutGet(GLUT_WINDOW_COLORMAP_SIZE),
           glutGet(GLUT_WINDOW_BUFFER_SIZE), glutGet(GLUT_WINDOW_RED_SIZE));
    print_color(255);
    print_color(256);
    printf("%g;", (double)glutGetColor(0, 3));
    glutSetColor(256, 1, 1, 1);
    glutSetColor(-1, 1, 1, 1);
    glutMainLoop();
}

static void rgba_window(void)
{
    glutInitDisplayMode(GLUT_RGB);
    glutCreateWindow("test");
    printf("%d %d %d;", glutGet(GLUT_WINDOW_RGBA), glutGet(GLUT_WINDOW_COLORMAP_SIZE),
           glutGet(GLUT_WINDOW_BUFFER_SIZE));
    print_color(0);
    glutSetColor(0, 1, 1, 1);
    glutCopyColormap(1);
    glutDisplayFunc(display);
    glutMainLoop();
}

static void test_queries(void **state)
{
    (void)state;
    expect_run(queries, VARIABLES("FIXEDGL_CAPTURE=a.pam"), 0,
               "0 256 8 0;0 0 0;-1 -1 -1;-1;"
               "fixedglut: glutSetColor: no color 256 in a colormap of 256\n"
               "fixedglut: glutSetColor: no color -1 in a colormap of 256\n");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0x000000ff);
    expect_run(rgba_window, VARIABLES("FIXEDGL_FRAMES=1"), 0,
               "1 0 32;-1 -1 -1;"
               "fixedglut: glutSetColor: the window has no colormap, as it was created without GLUT_INDEX\n"
               "fixedglut: glutCopyColormap: window 1 or the current one has no colormap\n");
}

/* A colormap for each window; a copy of another's stays what it was. */
static void two_windows(void)
{
    open_window();
    glutSetColor(3, 1, 0, 0);
    glutCreateSubWindow(1, 4, 0, 4, 2);
    glutDisplayFunc(display);
    glutCopyColormap(1);
    glutSetColor(200, 0, 0, 1);
    glutSetWindow(1);
    glutSetColor(3, 0, 1, 0);
    glutMainLoop();
}

static void test_copies(void **state)
{
    (void)state;
    expect_run(two_windows, VARIABLES("FIXEDGL_CAPTURE=a.pam"), 0, "");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 2, 0), 0x000000ff); /* index 200 of the parent */
    assert_int_equal(pam_pixel("a.pam", 8, 4, 6, 3), 0x00ff00ff); /* index 3 of it */
    assert_int_equal(pam_pixel("a.pam", 8, 4, 4, 0), 0x0000ffff); /* index 200 of the child */
    assert_int_equal(pam_pixel("a.pam", 8, 4, 7, 1), 0xff0000ff);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_picture),
            cmocka_unit_test(test_queries),
            cmocka_unit_test(test_copies),
    };
    return cmocka_run_group_tests(tests, make_directory, remove_directory);
}
