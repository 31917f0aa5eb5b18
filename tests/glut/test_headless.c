/* Whole programs in headless mode: each test runs one in a child process, with FIXEDGL_* variables set, and
 * looks at its exit status, at what it wrote to stdout and stderr, and at its pictures. */
#include "headless.h"

/* ---- a program that prints its callbacks and draws the left half red, green after a key ---- */

static float green;

static void display(void)
{
    printf("display %d;", glutGet(GLUT_ELAPSED_TIME));
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glColor3f(1 - green, green, 0);
    glRectf(-1, -1, 0, 1);
}

static void reshape(int width, int height)
{
    printf("reshape %d %d;", width, height);
    glViewport(0, 0, width, height);
}

static void keyboard(unsigned char key, int x, int y)
{
    printf("key %d %d %d %d;", key, x, y, glutGetModifiers());
    green = 1;
    glutPostRedisplay();
    if (key == 27)
        exit(7);
}

static void keyboard_up(unsigned char key, int x, int y)
{
    printf("up %d %d %d;", key, x, y);
}
static void special(int key, int x, int y)
{
    printf("special %d %d %d;", key, x, y);
}
static void mouse(int button, int down, int x, int y)
{
    printf("mouse %d %d %d %d;", button, down, x, y);
}
static void motion(int x, int y)
{
    printf("motion %d %d;", x, y);
}
static void passive(int x, int y)
{
    printf("passive %d %d;", x, y);
}
static void visibility(int shown)
{
    printf("visible %d;", shown);
}

static void open_window(void)
{
    glutInitWindowSize(8, 4);
    glutCreateWindow("test");
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutKeyboardUpFunc(keyboard_up);
    glutSpecialFunc(special);
    glutMouseFunc(mouse);
    glutMotionFunc(motion);
    glutPassiveMotionFunc(passive);
    glutVisibilityFunc(visibility);
}

static void printing_program(void)
{
    open_window();
    glutMainLoop();
}

static void test_first_frame(void **state)
{
    (void)state;
    expect_run(printing_program, VARIABLES("FIXEDGL_CAPTURE=a.pam"), 0, "reshape 8 4;visible 1;display 0;");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0xff0000ff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 4, 0), 0x0000ffff);
    expect_run(printing_program, VARIABLES("FIXEDGL_CAPTURE=a.pam", "FIXEDGL_SIZE=20x10"), 0,
               "reshape 20 10;visible 1;display 0;");
    assert_int_equal(pam_pixel("a.pam", 20, 10, 9, 9), 0xff0000ff);
    /* nothing posts a redisplay, so more frames draw nothing new */
    expect_run(printing_program, VARIABLES("FIXEDGL_FRAMES=5"), 0, "reshape 8 4;visible 1;display 0;");
}

#define FIRST "reshape 8 4;visible 1;display 0;"

static void test_events(void **state)
{
    (void)state;
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=key a;capture a.pam"), 0,
               FIRST "key 97 0 0 0;up 97 0 0;display 0;");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0x00ff00ff);
    expect_run(printing_program,
               VARIABLES("FIXEDGL_EVENTS=click left 3 2 2; special f1; drag right 1 1 2 2; move 4 1"), 0,
               FIRST "mouse 0 0 3 2;mouse 0 1 3 2;mouse 0 0 3 2;mouse 0 1 3 2;special 1 3 2;"
                     "mouse 2 0 1 1;motion 2 2;mouse 2 1 2 2;passive 4 1;");
    expect_run(printing_program,
               VARIABLES("FIXEDGL_EVENTS=press left 1 1;move 2 2;release left 3 3;move 3 0"), 0,
               FIRST "mouse 0 0 1 1;motion 2 2;mouse 0 1 3 3;passive 3 0;");
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=wheel up 1 2;wheel down 1 2"), 0,
               FIRST "mouse 3 0 1 2;mouse 3 1 1 2;mouse 4 0 1 2;mouse 4 1 1 2;");
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=modifiers shift ctrl;key A;quit;key b"), 0,
               FIRST "key 65 0 0 3;up 65 0 0;display 0;");
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=resize 6 2;capture a.pam"), 0,
               FIRST "reshape 6 2;display 0;");
    assert_int_equal(pam_pixel("a.pam", 6, 2, 2, 1), 0xff0000ff);
    /* a program that ends itself still leaves its last picture, and its own status */
    remove(path("a.pam"));
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=key escape", "FIXEDGL_CAPTURE=a.pam"), 7,
               FIRST "key 27 0 0 0;");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0xff0000ff);
}

/* ---- time ---- */

static void tick(int value)
{
    printf("timer %d at %d;", value, glutGet(GLUT_ELAPSED_TIME));
    if (value == 10)
        glutTimerFunc(10, tick, value);
}

static void idle(void)
{
    printf("idle %d;", glutGet(GLUT_ELAPSED_TIME));
    glutPostRedisplay();
}

static void timer_program(void)
{
    open_window();
    glutTimerFunc(20, tick, 20);
    glutTimerFunc(10, tick, 10);
    glutTimerFunc(10, tick, 1);
    glutMainLoop();
}

static void idle_program(void)
{
    open_window();
    glutIdleFunc(idle);
    glutMainLoop();
}

/* Holds its rate of frames by waiting, as many programs do. */
static void wait_in_idle(void)
{
    int start = glutGet(GLUT_ELAPSED_TIME), asked = 0;
    for (; glutGet(GLUT_ELAPSED_TIME) < start + 3; asked++)
        if (asked > 1000000)
            exit(97);
    idle();
}

static void waiting_program(void)
{
    open_window();
    glutIdleFunc(wait_in_idle);
    glutMainLoop();
}

static void test_clock(void **state)
{
    (void)state;
    expect_run(timer_program, VARIABLES("FIXEDGL_FRAMES=3"), 0,
               FIRST "timer 10 at 10;timer 1 at 10;timer 20 at 20;timer 10 at 20;timer 10 at 30;");
    expect_run(timer_program, VARIABLES("FIXEDGL_EVENTS=time 15"), 0, FIRST "timer 10 at 10;timer 1 at 10;");
    expect_run(idle_program, VARIABLES("FIXEDGL_FRAMES=3"), 0,
               FIRST "idle 16;display 16;idle 32;display 32;");
    expect_run(idle_program, VARIABLES("FIXEDGL_EVENTS=wait 1;time 20"), 0,
               FIRST "idle 16;display 16;idle 32;display 32;idle 36;display 36;");
    expect_run(waiting_program, VARIABLES("FIXEDGL_FRAMES=3"), 0,
               FIRST "idle 19;display 19;idle 38;display 38;");
}

/* ---- menus and child windows ---- */

static void choose(int value)
{
    printf("menu %d;", value);
}

static void menu_program(void)
{
    open_window();
    int submenu = glutCreateMenu(choose);
    glutAddMenuEntry("one", 11);
    glutAddMenuEntry("two", 12);
    glutCreateMenu(choose);
    glutAddMenuEntry("first", 1);
    glutAddSubMenu("more", submenu);
    glutAddMenuEntry("gone", 3);
    glutRemoveMenuItem(3);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
}

static void test_menus(void **state)
{
    (void)state;
    expect_run(menu_program, VARIABLES("FIXEDGL_EVENTS=menu 1;menu 2 2;click right 1 1;click left 1 1"), 0,
               FIRST "menu 1;menu 12;mouse 0 0 1 1;mouse 0 1 1 1;");
    expect_run(menu_program, VARIABLES("FIXEDGL_EVENTS=menu 3"), 2,
               FIRST "fixedglut: FIXEDGL_EVENTS: statement 1: no such menu item\n");
    expect_run(menu_program, VARIABLES("FIXEDGL_EVENTS=menu 1 1"), 2,
               FIRST "fixedglut: FIXEDGL_EVENTS: statement 1: no such menu item\n");
    expect_run(menu_program, VARIABLES("FIXEDGL_EVENTS=menu 2"), 2,
               FIRST "fixedglut: FIXEDGL_EVENTS: statement 1: no such menu item\n");
}

static void display_child(void)
{
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void child_program(void)
{
    open_window();
    glutCreateSubWindow(glutGetWindow(), 6, 1, 4, 2); /* two of its columns are outside the parent */
    glutDisplayFunc(display_child);
    glutMouseFunc(mouse);
    glutMainLoop();
}

static void test_child_window(void **state)
{
    (void)state;
    expect_run(child_program, VARIABLES("FIXEDGL_EVENTS=click left 7 2", "FIXEDGL_CAPTURE=a.pam"), 0,
               FIRST "mouse 0 0 1 1;mouse 0 1 1 1;");
    assert_int_equal(pam_pixel("a.pam", 8, 4, 5, 1), 0x0000ffff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 6, 1), 0xffffffff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 7, 2), 0xffffffff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 6, 0), 0x0000ffff);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 6, 3), 0x0000ffff);
}

/* ---- depth, faults ---- */

static void test_depth(void **state)
{
    unsigned char bytes[160];
    (void)state;
    expect_run(printing_program, VARIABLES("FIXEDGL_CAPTURE_DEPTH=a.depth"), 0, FIRST);
    FILE *file = fopen(path("a.depth"), "rb");
    assert_non_null(file);
    assert_int_equal(fread(bytes, 1, sizeof bytes, file), 16 + 4 * 8 * 4);
    fclose(file);
    assert_memory_equal(bytes, "FGLDEPTH 8 4 24\n", 16);
    /* z = 0 is depth 0.5, 8388607.5 rounded to even; the clear depth is 2^24 - 1 */
    assert_memory_equal(bytes + 16 + 4 * 3, "\x00\x00\x80\x00", 4);
    assert_memory_equal(bytes + 16 + 4 * 4, "\xff\xff\xff\x00", 4);
}

static void destroying_program(void)
{
    open_window();
    glutMainLoopEvent();
    glutDestroyWindow(glutGetWindow());
    exit(3);
}

static void no_window_program(void)
{
    glutSwapBuffers();
}

static void no_display_program(void)
{
    glutCreateWindow("");
    glutMainLoop();
}

static void test_ends(void **state)
{
    (void)state;
    remove(path("a.pam"));
    expect_run(destroying_program, VARIABLES("FIXEDGL_CAPTURE=a.pam"), 3, FIRST);
    assert_int_equal(pam_pixel("a.pam", 8, 4, 3, 0), 0xff0000ff);
    expect_run(printing_program, VARIABLES("FIXEDGL_HEADLESS=1"), 0,
               FIRST
               "fixedglut: no window: drawing one frame; set FIXEDGL_CAPTURE=out.png to keep the picture, or "
               "DISPLAY to see it\n");
}

static void test_faults(void **state)
{
    (void)state;
    expect_run(printing_program, VARIABLES("FIXEDGL_EVENTS=key a;hop"), 2,
               "fixedglut: FIXEDGL_EVENTS: statement 2, \"hop\", is not a statement\n");
    expect_run(printing_program, VARIABLES("FIXEDGL_SIZE=4y4"), 2,
               "fixedglut: FIXEDGL_SIZE=4y4 is not WIDTHxHEIGHT, each from 1 to 16384\n");
    expect_run(printing_program, VARIABLES("FIXEDGL_FRAMES=0"), 2,
               "fixedglut: FIXEDGL_FRAMES=0 is not a number of frames\n");
    expect_run(printing_program, VARIABLES("FIXEDGL_CAPTURE=no/such/a.png"), 1,
               FIRST "fixedglut: cannot write no/such/a.png: No such file or directory\n");
    expect_run(printing_program, VARIABLES("FIXEDGL_CAPTURE=no/such/a.png", "FIXEDGL_EVENTS=key escape"), 1,
               FIRST "key 27 0 0 0;fixedglut: cannot write no/such/a.png: No such file or directory\n");
    expect_run(no_window_program, VARIABLES("FIXEDGL_FRAMES=1"), 1,
               "fixedglut: glutSwapBuffers called with no current window\n");
    expect_run(no_display_program, VARIABLES("FIXEDGL_FRAMES=1"), 1,
               "fixedglut: window 1 has no display callback\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_first_frame),  cmocka_unit_test(test_events),
            cmocka_unit_test(test_clock),        cmocka_unit_test(test_menus),
            cmocka_unit_test(test_child_window), cmocka_unit_test(test_depth),
            cmocka_unit_test(test_ends),         cmocka_unit_test(test_faults),
    };
    return cmocka_run_group_tests(tests, make_directory, remove_directory);
}
