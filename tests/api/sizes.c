/* Line widths and point sizes beyond the range that is told are the range's ends (GL 1.5, 3.3 "Points", 3.4 "Line Segments"). */
#include "api/gl_test.h"

enum { WIDTH = 8, HEIGHT = 400 };

static unsigned char tall[HEIGHT][WIDTH][4];

/* How many pixels of the middle column are not black. */
static int drawn(GLenum mode)
{
    int n = 0;
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(mode);
    glVertex2f(mode == GL_LINES ? -0.9f : 0, 0);
    glVertex2f(mode == GL_LINES ? 0.9f : 0, 0);
    glEnd();
    glFinish();
    for (int y = 0; y < HEIGHT; y++)
        n += tall[y][WIDTH / 2][0] > 0;
    return n;
}

static void widths(void **state)
{
    static const GLfloat width[] = {256, 300, 1e6f, 1e30f};
    GLfloat range[2];
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    assert_true(range[1] < HEIGHT - 2);
    assert_true(OSMesaMakeCurrent(*state, tall, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    glViewport(0, 0, WIDTH, HEIGHT);
    for (int smooth = 0; smooth < 2; smooth++) {
        (smooth ? glEnable : glDisable)(GL_LINE_SMOOTH);
        glLineWidth(0.001f);
        assert_int_equal(drawn(GL_LINES), 1 + smooth);
        glLineWidth(range[1]);
        const int widest = drawn(GL_LINES);
        assert_int_equal(widest, (int)range[1] + smooth);
        for (size_t i = 0; i < sizeof width / sizeof *width; i++) {
            glLineWidth(width[i]);
            assert_int_equal(drawn(GL_LINES), widest);
            EXPECT_VALUES(GL_LINE_WIDTH, width[i]);
        }
    }
}

static void sizes(void **state)
{
    static const GLfloat size[] = {256, 300, 1e6f, 1e30f};
    GLfloat range[2];
    glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range);
    assert_true(OSMesaMakeCurrent(*state, tall, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    glViewport(0, 0, WIDTH, HEIGHT);
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        glPointSize(size[i]);
        assert_int_equal(drawn(GL_POINTS), (int)range[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(widths), GL_TEST(sizes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
