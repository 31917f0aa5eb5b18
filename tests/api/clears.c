/* glClear of the whole framebuffer, and of parts of it, where the last bit may differ: values that OSMesa gave (GL 1.5, 4.2.3). And
 * signed depths drawn, which are rounded as there. */
#include "api/gl_test.h"

/* The depth of the lowest left pixel, as it is stored. */
static GLuint stored_depth(OSMesaContext context)
{
    GLint width, height, bytes;
    void *depth;
    glFinish();
    assert_true(OSMesaGetDepthBuffer(context, &width, &height, &bytes, &depth));
    return bytes == 2 ? *(const GLushort *)depth : *(const GLuint *)depth & 0xffffff;
}

static void depth_of_a_part(void **state)
{
    static const struct {
        double depth;
        GLuint whole, part;
    } clears[] = {{0.45393891094901551, 7615831, 7615830}, {0.66053684365960619, 11081969, 11081968}, {0.393, 6593445, 6593446},
                  {0.0, 0, 0}, {1.0, 0xffffff, 0xffffff}, {0.5, 0x800000, 0x800000}};
    for (size_t i = 0; i < sizeof clears / sizeof *clears; i++) {
        glClearDepth(clears[i].depth);
        glClear(GL_DEPTH_BUFFER_BIT);
        assert_int_equal(stored_depth(*state), clears[i].whole);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        assert_int_equal(stored_depth(*state), clears[i].whole);
        glStencilMask(15);
        glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        assert_int_equal(stored_depth(*state), clears[i].part);
        glStencilMask(255);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 5, 5);
        glClear(GL_DEPTH_BUFFER_BIT);
        assert_int_equal(stored_depth(*state), clears[i].part);
        glDisable(GL_SCISSOR_TEST);
    }
}

static void color_of_a_part(void **state)
{
    (void)state;
    static GLushort pixel565[8 * 8], pixel16[8 * 8 * 4];
    OSMesaContext packed = OSMesaCreateContextExt(OSMESA_RGB_565, 24, 0, 0, NULL);
    OSMesaMakeCurrent(packed, pixel565, GL_UNSIGNED_SHORT_5_6_5, 8, 8);
    glClearColor(0.084416531f, 0.134920642f, 0.635294139f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    assert_int_equal(pixel565[0], 0x1934);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 5, 5);
    glClearColor(0.579365075f, 0.78316164f, 0.374509811f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    assert_int_equal(pixel565[0], 0x964c);
    OSMesaDestroyContext(packed);

    OSMesaContext deep = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    OSMesaMakeCurrent(deep, pixel16, GL_UNSIGNED_SHORT, 8, 8);
    glClearColor(0.3f, 0, 1, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    assert_int_equal(pixel16[0], 19661);
    glColorMask(1, 1, 1, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    assert_int_equal(pixel16[0], 19660);
    OSMesaDestroyContext(deep);
}

static void signed_depths(void **state)
{
    static const GLbyte bytes[] = {0, 1, 116, 127, -1};
    static const GLshort shorts[] = {0, 1, 32767};
    static const GLint ints[] = {151594376, 1709266623, 0x7fffffff};
    static const GLuint of_bytes[] = {0, 197379, 15329771, 16777215, 0}, of_shorts[] = {0, 768, 16777215},
                        of_ints[] = {1184330, 13353645, 16777215};
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (int i = 0; i < 5; i++) {
        glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_BYTE, &bytes[i]);
        assert_int_equal(stored_depth(*state), of_bytes[i]);
    }
    for (int i = 0; i < 3; i++) {
        glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_SHORT, &shorts[i]);
        assert_int_equal(stored_depth(*state), of_shorts[i]);
        glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_INT, &ints[i]);
        assert_int_equal(stored_depth(*state), of_ints[i]);
    }
}

/* What GL_RETURN makes of the accumulation buffer's red at (x, 0), of 255. */
static int accumulated(int x)
{
    GLubyte pixel[4];
    glAccum(GL_RETURN, 1);
    glReadPixels(x, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return pixel[0];
}

static void clear_accum(float red)
{
    glClearAccum(red, 0, 0, 1);
    glClear(GL_ACCUM_BUFFER_BIT);
}

/* A clear of the whole is put off until the buffer is used; no order of clears and uses shows it. */
static void accumulation(void **state)
{
    clear_accum(1);
    glClearAccum(0.25f, 0, 0, 1); /* of no clear yet */
    assert_int_equal(accumulated(9), 255);
    clear_accum(0.5f);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 5, 5);
    clear_accum(1);
    glDisable(GL_SCISSOR_TEST);
    assert_int_equal(accumulated(4), 255);
    assert_int_equal(accumulated(5), 127);
    glAccum(GL_ADD, 0.25f);
    assert_int_equal(accumulated(5), 191);
    clear_accum(0.5f);
    clear_accum(0);
    assert_int_equal(accumulated(4), 0);
    clear_accum(1);
    assert_true(OSMesaMakeCurrent(*state, picture, GL_UNSIGNED_BYTE, TEST_SIZE / 2, TEST_SIZE)); /* a new buffer */
    assert_int_equal(accumulated(9), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(depth_of_a_part), GL_TEST(color_of_a_part), GL_TEST(signed_depths),
                                       GL_TEST(accumulation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
