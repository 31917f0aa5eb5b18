/* Colour index mode: drawn, read and copied pixels, bitmaps. */
#include "api/color_index_test.h"

static void draw_pixels(void **state)
{
    (void)state;
    static const GLubyte bytes[2][4] = {{1, 2, 3, 250}, {5, 6, 7, 8}};
    static const GLfloat floats[4] = {20, 300, 22.75f, -1};
    static const GLubyte bits[2] = {0xa0, 0x50};
    const float rgba[4] = {1, 1, 1, 1};
    glRasterPos2i(10, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(10, 10, 1);
    EXPECT_PIXEL(13, 10, 250);
    EXPECT_PIXEL(13, 11, 8);
    glRasterPos2i(20, 10);
    glDrawPixels(4, 1, GL_COLOR_INDEX, GL_FLOAT, floats);
    EXPECT_PIXEL(20, 10, 20);
    EXPECT_PIXEL(21, 10, 44);
    EXPECT_PIXEL(23, 10, 255);
    glPixelTransferi(GL_INDEX_SHIFT, 2);
    glPixelTransferi(GL_INDEX_OFFSET, 3);
    glRasterPos2i(10, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(10, 10, 7);
    EXPECT_PIXEL(13, 10, (250 * 4 + 3) & 255);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2i(30, 10);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_BITMAP, bits);
    EXPECT_PIXEL(30, 10, 7);
    EXPECT_PIXEL(31, 10, 3);
    EXPECT_PIXEL(30, 11, 3);
    EXPECT_PIXEL(31, 11, 7);
    const GLfloat map[4] = {90, 91, 92, 93};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_I, 4, map);
    glPixelTransferi(GL_MAP_COLOR, 1);
    glRasterPos2i(10, 10);
    glDrawPixels(4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes); /* 4 i + 3 is 3 in the map's size */
    EXPECT_PIXEL(10, 10, 93);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, rgba));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_LUMINANCE, GL_FLOAT, rgba));
    glPixelZoom(3, 2);
    glPixelTransferi(GL_MAP_COLOR, 0);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glRasterPos2i(40, 40);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(42, 41, 1);
    EXPECT_PIXEL(43, 41, 2);
    EXPECT_PIXEL(43, 42, 6);
    glLogicOp(GL_XOR);
    glEnable(GL_INDEX_LOGIC_OP);
    glDrawPixels(4, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes);
    EXPECT_PIXEL(43, 42, 0);
}

static void read_and_copy(void **state)
{
    (void)state;
    GLubyte got[4] = {0}, bits = 0;
    GLfloat real[2], rgba[4];
    GLushort wide[2];
    for (int i = 0; i < 4; i++) {
        glIndexi(100 + i);
        point(i, 0);
    }
    glReadPixels(0, 0, 4, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((GLubyte[]){100, 101, 102, 103}), 4);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_FLOAT, real);
    check_floats(real, (GLfloat[]){102, 103}, 2, "floats", __FILE__, __LINE__);
    glReadPixels(0, 0, 4, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    assert_int_equal(bits & 0xf0, 0x50);
    glPixelTransferi(GL_INDEX_SHIFT, 3);
    glPixelTransferi(GL_INDEX_OFFSET, -1);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_UNSIGNED_SHORT, wide);
    assert_int_equal(wide[0], 102 * 8 - 1);
    glReadPixels(2, 0, 2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0], (102 * 8 - 1) & 255);
    glReadPixels(2, 0, 1, 1, GL_COLOR_INDEX, GL_BYTE, got); /* table 4.8: masked with 2^7 - 1 */
    assert_int_equal(got[0], (102 * 8 - 1) & 127);
    glRasterPos2i(10, 5);
    glCopyPixels(0, 0, 4, 1, GL_COLOR); /* transfer applies once */
    EXPECT_PIXEL(11, 5, (101 * 8 - 1) & 255);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glRasterPos2i(10, 6);
    glCopyPixels(0, 0, 4, 1, GL_COLOR);
    EXPECT_PIXEL(13, 6, 103);

    /* 3.6.5 "Color Index Lookup": colours are read through the maps */
    const GLfloat red[2] = {0.25f, 0.5f}, green[4] = {0, 0.125f, 0.75f, 1}, blue[1] = {0.625f}, alpha[2] = {1, 0};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 4, green);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 1, blue);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, alpha);
    glPixelTransferf(GL_RED_SCALE, 0.5f); /* for groups that are RGBA from the start */
    glReadPixels(1, 0, 1, 1, GL_RGBA, GL_FLOAT, rgba);
    check_floats(rgba, (GLfloat[]){0.5f, 0.125f, 0.625f, 0}, 4, "rgba", __FILE__, __LINE__);
    glReadPixels(2, 0, 1, 1, GL_BGRA, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0], 159); /* 0.625 * 255 = 159.4 */
    assert_int_equal(got[1], 191); /* 191.25 */
    assert_int_equal(got[2], 64);  /* 63.75 */
    assert_int_equal(got[3], 255);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_FLOAT, rgba); /* .25 + 0 + .625 */
    check_floats(rgba, (GLfloat[]){0.875f}, 1, "luminance", __FILE__, __LINE__);
    EXPECT_NO_ERROR((void)0);
}

/* 3.7 and 2.13: bitmaps have the raster position's index. */
static void bitmaps(void **state)
{
    static const GLubyte bits[4] = {0xc0, 0, 0, 0};
    (void)state;
    glIndexf(333);
    glRasterPos2i(10, 10);
    glIndexi(5); /* too late */
    EXPECT_VALUES(GL_CURRENT_RASTER_INDEX, 333);
    glBitmap(2, 1, 0, 0, 3, 0, bits);
    EXPECT_PIXEL(10, 10, 333 & 255);
    EXPECT_PIXEL(11, 10, 333 & 255);
    EXPECT_PIXEL(12, 10, 0);
    glWindowPos2i(20, 20);
    glBitmap(2, 1, 0, 0, 3, 0, bits);
    EXPECT_PIXEL(20, 20, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            INDEX_TEST(draw_pixels),
            INDEX_TEST(read_and_copy),
            INDEX_TEST(bitmaps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
