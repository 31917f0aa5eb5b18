/* Colour index mode: fragment operations. */
#include "api/color_index_test.h"

/* 3.10: I = i_r + (1 - f) i_f, masked. */
static double fogged(double index, double fog_index, double f)
{
    const double clamped = f < 0 ? 0 : f > 1 ? 1 : f;
    return fmod(index + (1 - clamped) * fog_index, 256);
}

static void fog(void **state)
{
    (void)state;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 64, 0, 64, 0, 32);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_FOG);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 28);
    glFogf(GL_FOG_DENSITY, 0.06f);
    static const GLenum mode[] = {GL_LINEAR, GL_EXP, GL_EXP2};
    for (int m = 0; m < 3; m++)
        for (int k = 0; k < 2; k++) {
            const double fog_index = k ? 300 : 64;
            glFogi(GL_FOG_MODE, (GLint)mode[m]);
            glFogf(GL_FOG_INDEX, (GLfloat)fog_index);
            glBegin(GL_QUADS);
            glIndexi(40);
            glVertex3f(0, 0, -0.5f);
            glVertex3f(64, 0, -32.5f);
            glVertex3f(64, 8, -32.5f);
            glVertex3f(0, 8, -0.5f);
            glEnd();
            glFinish();
            for (int x = 0; x < 63; x++) {
                const double z = 0.5 + 32 * (x + 0.5) / 64, e = 0.06 * z;
                const double f = m == 0 ? (28 - z) / 24 : m == 1 ? exp(-e) : exp(-e * e);
                const double truth = fogged(40, fog_index, f);
                if (truth < 255.999) /* there it wraps around */
                    EXPECT_NEAR(index_of[4][x], truth < 255 ? truth : 255);
            }
        }
    EXPECT_VALUES(GL_FOG_INDEX, 300);
}

/* 4.1.10: logical operations on indexes; 4.2.2: the index mask. */
static void logic_op(void **state)
{
    (void)state;
    const int s = 0x5c, d = 0x3a;
    const int expected[16] = {0,        s & d,     s & ~d, s,         ~s & d, d,       s ^ d,  s | d,
                              ~(s | d), ~(s ^ d), ~d,     s | ~d, ~s,     ~s | d, ~(s & d), 255};
    EXPECT_INTS(GL_INDEX_LOGIC_OP, 0);
    for (int op = 0; op < 16; op++)
        for (int masked = 0; masked < 2; masked++) {
            const int mask = masked ? 0x3c : 0xff;
            glDisable(GL_LOGIC_OP);
            glIndexMask(~0u);
            glIndexi(d);
            point(3, 3);
            glEnable(GL_INDEX_LOGIC_OP);
            glIndexMask((GLuint)mask);
            glLogicOp(GL_CLEAR + (GLenum)op);
            glIndexi(s);
            point(3, 3);
            EXPECT_PIXEL(3, 3, (expected[op] & mask) | (d & ~mask & 255));
        }
    glDisable(GL_INDEX_LOGIC_OP);
    glEnable(GL_COLOR_LOGIC_OP); /* RGBA mode only */
    glIndexMask(~0u);
    glLogicOp(GL_CLEAR);
    point(3, 3);
    EXPECT_PIXEL(3, 3, s);
}

/* 4.1.4, 4.1.8, 4.2.2: alpha test, blending and colour mask are for RGBA alone. */
static void rgba_operations(void **state)
{
    (void)state;
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_NEVER, 0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE);
    glColorMask(0, 0, 0, 0);
    glEnable(GL_COLOR_SUM);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glIndexi(77);
    point(3, 3);
    EXPECT_PIXEL(3, 3, 77);
    glClearIndex(5);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_PIXEL(3, 3, 5);
    glDrawBuffer(GL_NONE);
    point(3, 3);
    EXPECT_PIXEL(3, 3, 5);
}

static void tests_of_fragments(void **state)
{
    (void)state;
    glEnable(GL_DEPTH_TEST);
    glIndexi(1);
    glBegin(GL_POINTS);
    glVertex3f(1.5f, 1.5f, 0.5f);
    glIndexi(2);
    glVertex3f(1.5f, 1.5f, 0.75f);
    glVertex3f(2.5f, 1.5f, 0.75f);
    glEnd();
    EXPECT_PIXEL(1, 1, 1);
    EXPECT_PIXEL(2, 1, 2);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glIndexi(3);
    point(4, 4);
    glIndexi(4);
    point(4, 4);
    EXPECT_PIXEL(4, 4, 3);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(20, 20, 4, 4);
    glIndexi(5);
    square(0, 0, 64, 64);
    EXPECT_PIXEL(19, 20, 0);
    EXPECT_PIXEL(20, 20, 5);
    EXPECT_PIXEL(23, 23, 5);
    EXPECT_PIXEL(24, 23, 0);
}

static void stipples(void **state)
{
    (void)state;
    GLubyte pattern[128];
    for (int i = 0; i < 128; i++)
        pattern[i] = i / 4 % 2 ? 0x55 : 0xaa;
    glPolygonStipple(pattern);
    glEnable(GL_POLYGON_STIPPLE);
    glIndexi(9);
    square(0, 0, 64, 32);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x00ff);
    glBegin(GL_LINES);
    glVertex2f(0.5f, 40.5f);
    glVertex2f(64.5f, 40.5f);
    glEnd();
    glFinish();
    for (int x = 0; x < 64; x++) {
        assert_int_equal(index_of[0][x], x % 2 ? 0 : 9);
        assert_int_equal(index_of[1][x], x % 2 ? 9 : 0);
        assert_int_equal(index_of[40][x], x / 16 % 2 ? 0 : 9);
    }
}

/* 3.2, 3.11: the low four bits of the index are the coverage. */
static void antialiasing(void **state)
{
    (void)state;
    glEnable(GL_LINE_SMOOTH);
    glLineWidth(5);
    glIndexi(0x53);
    glBegin(GL_LINES);
    glVertex2f(4, 20);
    glVertex2f(60, 20);
    glEnd();
    glFinish();
    int complete = 0, partial = 0;
    for (int y = 14; y < 27; y++) {
        const int v = index_of[y][32];
        complete += v == 0x5f;
        partial += v >= 0x50 && v < 0x5f;
        assert_true(v == 0 || (v & 0xf0) == 0x50);
    }
    assert_int_equal(complete, 4); /* rows 18 to 21: the line is 17.5 to 22.5 */
    assert_int_equal(partial, 2);
    assert_int_equal(index_of[17][32], index_of[22][32]);
    EXPECT_NEAR(index_of[17][32] & 15, 15 * 0.5);

    glEnable(GL_POINT_SMOOTH);
    glPointSize(9);
    glIndexi(0x60);
    point(40, 45);
    EXPECT_PIXEL(40, 45, 0x6f);
    EXPECT_PIXEL(40, 52, 0);
    glEnable(GL_POLYGON_SMOOTH);
    glIndexi(0x70);
    square(2, 50, 12, 60);
    EXPECT_PIXEL(5, 55, 0x7f);
    glDisable(GL_POLYGON_SMOOTH);
    square(2, 50, 12, 60);
    EXPECT_PIXEL(5, 55, 0x70);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            INDEX_TEST(fog),
            INDEX_TEST(logic_op),
            INDEX_TEST(rgba_operations),
            INDEX_TEST(tests_of_fragments),
            INDEX_TEST(stipples),
            INDEX_TEST(antialiasing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
