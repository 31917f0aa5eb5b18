/* What the tests of colour index mode share. Mesa's OSMesa does not have this mode: the truth is computed in the tests, in double, from the
 * equations of the specification (OpenGL 1.5). The window is 64 x 64; object coordinates are window coordinates unless a test says
 * otherwise. */
#ifndef TESTS_API_COLOR_INDEX_TEST_H
#define TESTS_API_COLOR_INDEX_TEST_H

#include "api/gl_test.h"

#include <math.h>

static unsigned char index_of[TEST_SIZE][TEST_SIZE]; /* [y][x], as the buffer has it after glFinish */

static inline int make_index_context(void **state)
{
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_COLOR_INDEX, 24, 8, 16, NULL);
    *state = context;
    memset(index_of, 0xee, sizeof index_of);
    if (!context || !OSMesaMakeCurrent(context, index_of, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE))
        return -1;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, 0, -1); /* depth is z */
    glMatrixMode(GL_MODELVIEW);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return glGetError() == GL_NO_ERROR ? 0 : -1;
}

#define INDEX_TEST(function) cmocka_unit_test_setup_teardown(function, make_index_context, destroy_context)

static inline int pixel(int x, int y)
{
    glFinish();
    return index_of[y][x];
}

/* The pixel is the integer nearest to the value, either one at a tie. */
static inline void check_near(int got, double truth, const char *what, const char *file, int line)
{
    if (fabs(got - truth) <= 0.5 + 1e-3)
        return;
    print_error("%s:%d: %s: %d, expected %.9g\n", file, line, what, got, truth);
    _fail(file, line);
}
#define EXPECT_NEAR(got, truth) check_near((got), (truth), #got, __FILE__, __LINE__)
#define EXPECT_PIXEL(x, y, value) assert_int_equal(pixel(x, y), (value))

static inline void point(double x, double y)
{
    glBegin(GL_POINTS);
    glVertex2d(x + 0.5, y + 0.5);
    glEnd();
}

static inline void square(int x0, int y0, int x1, int y1)
{
    glRecti(x0, y0, x1, y1);
}

#endif
