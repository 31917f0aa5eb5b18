/* glReadPixels (GL 1.5, 4.3.2): every format and type, pixel store, clipping, errors. Expected bytes are
 * OSMesa's, little-endian. */
#include "api/gl_test.h"

enum { GUARD = 0xcd, MEMORY = 4096 };

static unsigned char memory[MEMORY];

static void fill_buffers(void)
{
    glClearColor(0x11 / 255.0f, 0x52 / 255.0f, 0x5b / 255.0f, 0xe4 / 255.0f);
    glClearDepth(0.3);
    glClearStencil(0xa5);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/* One pixel of every format and type, and no byte after it. */
static const struct {
    GLenum format, type;
    const char *bytes;
} one_pixel[] = {
        {GL_RED, GL_UNSIGNED_BYTE, "11"},
        {GL_RED, GL_BYTE, "08"},
        {GL_RED, GL_UNSIGNED_SHORT, "1111"},
        {GL_RED, GL_SHORT, "8808"},
        {GL_RED, GL_UNSIGNED_INT, "11111111"},
        {GL_RED, GL_INT, "88888808"},
        {GL_RED, GL_FLOAT, "8988883d"},
        {GL_GREEN, GL_UNSIGNED_BYTE, "52"},
        {GL_GREEN, GL_BYTE, "29"},
        {GL_GREEN, GL_UNSIGNED_SHORT, "5252"},
        {GL_GREEN, GL_SHORT, "2929"},
        {GL_GREEN, GL_UNSIGNED_INT, "52525252"},
        {GL_GREEN, GL_INT, "29292929"},
        {GL_GREEN, GL_FLOAT, "a5a4a43e"},
        {GL_BLUE, GL_UNSIGNED_BYTE, "5b"},
        {GL_BLUE, GL_BYTE, "2d"},
        {GL_BLUE, GL_UNSIGNED_SHORT, "5b5b"},
        {GL_BLUE, GL_SHORT, "ad2d"},
        {GL_BLUE, GL_UNSIGNED_INT, "5b5b5b5b"},
        {GL_BLUE, GL_INT, "adadad2d"},
        {GL_BLUE, GL_FLOAT, "b7b6b63e"},
        {GL_ALPHA, GL_UNSIGNED_BYTE, "e4"},
        {GL_ALPHA, GL_BYTE, "72"},
        {GL_ALPHA, GL_UNSIGNED_SHORT, "e4e4"},
        {GL_ALPHA, GL_SHORT, "7272"},
        {GL_ALPHA, GL_UNSIGNED_INT, "e4e4e4e4"},
        {GL_ALPHA, GL_INT, "72727272"},
        {GL_ALPHA, GL_FLOAT, "e6e4643f"},
        {GL_RGB, GL_UNSIGNED_BYTE, "11525b"},
        {GL_RGB, GL_BYTE, "08292d"},
        {GL_RGB, GL_UNSIGNED_SHORT, "111152525b5b"},
        {GL_RGB, GL_SHORT, "88082929ad2d"},
        {GL_RGB, GL_UNSIGNED_INT, "11111111525252525b5b5b5b"},
        {GL_RGB, GL_INT, "8888880829292929adadad2d"},
        {GL_RGB, GL_FLOAT, "8988883da5a4a43eb7b6b63e"},
        {GL_RGB, GL_UNSIGNED_BYTE_3_3_2, "09"},
        {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, "50"},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, "8b12"},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, "825a"},
        {GL_RGBA, GL_UNSIGNED_BYTE, "11525be4"},
        {GL_RGBA, GL_BYTE, "08292d72"},
        {GL_RGBA, GL_UNSIGNED_SHORT, "111152525b5be4e4"},
        {GL_RGBA, GL_SHORT, "88082929ad2d7272"},
        {GL_RGBA, GL_UNSIGNED_INT, "11111111525252525b5b5b5be4e4e4e4"},
        {GL_RGBA, GL_INT, "8888880829292929adadad2d72727272"},
        {GL_RGBA, GL_FLOAT, "8988883da5a4a43eb7b6b63ee6e4643f"},
        {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, "5d15"},
        {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, "51d5"},
        {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, "9712"},
        {GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV, "42ad"},
        {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, "e45b5211"},
        {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, "11525be4"},
        {GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, "b7951411"},
        {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, "4424d5d6"},
        {GL_BGR, GL_UNSIGNED_BYTE, "5b5211"},
        {GL_BGR, GL_BYTE, "2d2908"},
        {GL_BGR, GL_UNSIGNED_SHORT, "5b5b52521111"},
        {GL_BGR, GL_SHORT, "ad2d29298808"},
        {GL_BGR, GL_UNSIGNED_INT, "5b5b5b5b5252525211111111"},
        {GL_BGR, GL_INT, "adadad2d2929292988888808"},
        {GL_BGR, GL_FLOAT, "b7b6b63ea5a4a43e8988883d"},
        {GL_BGRA, GL_UNSIGNED_BYTE, "5b5211e4"},
        {GL_BGRA, GL_BYTE, "2d290872"},
        {GL_BGRA, GL_UNSIGNED_SHORT, "5b5b52521111e4e4"},
        {GL_BGRA, GL_SHORT, "ad2d292988087272"},
        {GL_BGRA, GL_UNSIGNED_INT, "5b5b5b5b5252525211111111e4e4e4e4"},
        {GL_BGRA, GL_INT, "adadad2d292929298888880872727272"},
        {GL_BGRA, GL_FLOAT, "b7b6b63ea5a4a43e8988883de6e4643f"},
        {GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4, "1d55"},
        {GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4_REV, "55d1"},
        {GL_BGRA, GL_UNSIGNED_SHORT_5_5_5_1, "855a"},
        {GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, "4b89"},
        {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8, "e411525b"},
        {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, "5b5211e4"},
        {GL_BGRA, GL_UNSIGNED_INT_10_10_10_2, "1391545b"},
        {GL_BGRA, GL_UNSIGNED_INT_2_10_10_10_REV, "6d2545c4"},
        {GL_LUMINANCE, GL_UNSIGNED_BYTE, "be"},
        {GL_LUMINANCE, GL_BYTE, "5f"},
        {GL_LUMINANCE, GL_UNSIGNED_SHORT, "bebe"},
        {GL_LUMINANCE, GL_SHORT, "5f5f"},
        {GL_LUMINANCE, GL_UNSIGNED_INT, "00bfbebe"},
        {GL_LUMINANCE, GL_INT, "805f5f5f"},
        {GL_LUMINANCE, GL_FLOAT, "bfbe3e3f"},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, "bee4"},
        {GL_LUMINANCE_ALPHA, GL_BYTE, "5f72"},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, "bebee4e4"},
        {GL_LUMINANCE_ALPHA, GL_SHORT, "5f5f7272"},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_INT, "00bfbebe00e6e4e4"},
        {GL_LUMINANCE_ALPHA, GL_INT, "805f5f5f00737272"},
        {GL_LUMINANCE_ALPHA, GL_FLOAT, "bfbe3e3fe6e4643f"},
        {GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, "4c"},
        {GL_DEPTH_COMPONENT, GL_BYTE, "25"},
        {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, "cc4c"},
        {GL_DEPTH_COMPONENT, GL_SHORT, "6526"},
        {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, "4ccccc4c"},
        {GL_DEPTH_COMPONENT, GL_INT, "3f666626"},
        {GL_DEPTH_COMPONENT, GL_FLOAT, "9999993e"},
        {GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, "a5"},
        {GL_STENCIL_INDEX, GL_BYTE, "25"},
        {GL_STENCIL_INDEX, GL_UNSIGNED_SHORT, "a500"},
        {GL_STENCIL_INDEX, GL_SHORT, "a500"},
        {GL_STENCIL_INDEX, GL_UNSIGNED_INT, "a5000000"},
        {GL_STENCIL_INDEX, GL_INT, "a5000000"},
        {GL_STENCIL_INDEX, GL_FLOAT, "00002543"},
};

static void test_formats_and_types(void **state)
{
    (void)state;
    fill_buffers();
    for (size_t i = 0; i < sizeof one_pixel / sizeof *one_pixel; i++) {
        memset(memory, GUARD, sizeof memory);
        glReadPixels(5, 9, 1, 1, one_pixel[i].format, one_pixel[i].type, memory);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        char got[2 * 16 + 1] = "";
        const size_t n = strlen(one_pixel[i].bytes) / 2;
        for (size_t b = 0; b < n; b++)
            snprintf(got + 2 * b, 3, "%02x", memory[b]);
        if (strcmp(got, one_pixel[i].bytes) != 0)
            fail_msg("format 0x%04x type 0x%04x: %s, expected %s", one_pixel[i].format, one_pixel[i].type,
                     got, one_pixel[i].bytes);
        assert_int_equal(memory[n], GUARD);
    }
}

/* The framebuffer's pixel (x, y) is (x, y, x ^ y, 255). */
static void fill_gradient(void)
{
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < TEST_SIZE; y++)
        for (int x = 0; x < TEST_SIZE; x++) {
            glScissor(x, y, 1, 1);
            glClearColor((float)x / 255.0f, (float)y / 255.0f, (float)(x ^ y) / 255.0f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT);
        }
    glDisable(GL_SCISSOR_TEST);
}

/* Where a 3-byte RGB image of w x h pixels at window position (x, y) must land in memory, byte by byte. */
static void check_rgb(int x, int y, int w, int h, size_t row_bytes, size_t offset)
{
    static unsigned char expected[MEMORY];
    memset(expected, GUARD, sizeof expected);
    for (int r = 0; r < h; r++)
        for (int c = 0; c < w; c++) {
            const int wx = x + c, wy = y + r;
            if (wx < 0 || wy < 0 || wx >= TEST_SIZE || wy >= TEST_SIZE)
                continue;
            unsigned char *p = expected + offset + (size_t)r * row_bytes + 3 * (size_t)c;
            p[0] = (unsigned char)wx;
            p[1] = (unsigned char)wy;
            p[2] = (unsigned char)(wx ^ wy);
        }
    memset(memory, GUARD, sizeof memory);
    EXPECT_NO_ERROR(glReadPixels(x, y, w, h, GL_RGB, GL_UNSIGNED_BYTE, memory));
    assert_memory_equal(memory, expected, sizeof memory);
}

/* GL 1.5, 3.6.4: rows begin at multiples of the alignment; row length and skips. */
static void test_pixel_store(void **state)
{
    (void)state;
    fill_gradient();
    check_rgb(3, 5, 7, 4, 24, 0); /* 21 bytes, aligned to 4 */
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    check_rgb(3, 5, 7, 4, 21, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    check_rgb(3, 5, 9, 4, 32, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glPixelStorei(GL_PACK_ROW_LENGTH, 11);
    check_rgb(3, 5, 7, 4, 34, 0);
    glPixelStorei(GL_PACK_SKIP_ROWS, 2);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
    check_rgb(3, 5, 7, 4, 34, 2 * 34 + 9);
}

/* What lies outside of the framebuffer leaves its memory untouched. */
static void test_clipping(void **state)
{
    (void)state;
    fill_gradient();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    check_rgb(-3, -2, 8, 8, 24, 0);
    check_rgb(60, 61, 10, 10, 30, 0);
    check_rgb(-40, 3, 40, 2, 120, 0);
    check_rgb(TEST_SIZE, 0, 4, 4, 12, 0);
    check_rgb(10, 10, 0, 5, 0, 0);
    check_rgb(10, 10, 5, 0, 15, 0);
}

static void test_swap_bytes(void **state)
{
    (void)state;
    static const unsigned char rgb_565[] = {0x12, 0x8b}, rgb_short[] = {0x11, 0x11, 0x52, 0x52},
                               depth[] = {0x4c, 0xcc, 0xcc, 0x7f};
    fill_buffers();
    glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
    EXPECT_NO_ERROR(glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, memory));
    assert_memory_equal(memory, rgb_565, sizeof rgb_565);
    EXPECT_NO_ERROR(glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT, memory));
    assert_memory_equal(memory, rgb_short, sizeof rgb_short);
    EXPECT_NO_ERROR(glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, memory));
    assert_memory_equal(memory, depth, sizeof depth);
}

/* 3.6.4 "Special Interpretations", 3.6.2: one bit a pixel. OSMesa cannot. */
static void test_stencil_bitmap(void **state)
{
    (void)state;
    if (!on_fixedgl())
        skip();
    glClearStencil(1);
    glClear(GL_STENCIL_BUFFER_BIT);
    glClearStencil(2);
    glEnable(GL_SCISSOR_TEST);
    glScissor(2, 0, 3, 1);
    glClear(GL_STENCIL_BUFFER_BIT);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    memset(memory, GUARD, sizeof memory);
    EXPECT_NO_ERROR(glReadPixels(0, 0, 6, 1, GL_STENCIL_INDEX, GL_BITMAP, memory));
    assert_int_equal(memory[0], 0xc4 | (GUARD & 3)); /* 110001.. */
    glPixelStorei(GL_PACK_LSB_FIRST, GL_TRUE);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 9);
    EXPECT_NO_ERROR(glReadPixels(0, 0, 6, 1, GL_STENCIL_INDEX, GL_BITMAP, memory));
    assert_int_equal(memory[1], 0x46 | (GUARD & 0x81));
    assert_int_equal(memory[2], GUARD);
}

/* OSMesa gives 0 where a luminance of 1 is read as 32 bits. */
static void test_white_luminance(void **state)
{
    (void)state;
    GLuint unsigned_int = 0;
    GLint signed_int = 0;
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_INT, &unsigned_int);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_INT, &signed_int);
    assert_int_equal(unsigned_int, on_fixedgl() ? 0xffffffffu : 0);
    assert_int_equal(signed_int, on_fixedgl() ? 0x7fffffff : INT32_MIN);
}

static void test_errors(void **state)
{
    (void)state;
    memset(memory, GUARD, sizeof memory);
    EXPECT_ERROR(GL_INVALID_VALUE, glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory));
    EXPECT_ERROR(GL_INVALID_VALUE, glReadPixels(0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, memory));
    EXPECT_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, GL_TEXTURE, GL_UNSIGNED_BYTE, memory));
    EXPECT_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_DOUBLE, memory));
    EXPECT_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_BITMAP, memory));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, memory));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, memory));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_BGR, GL_UNSIGNED_BYTE_3_3_2, memory));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, memory));
    glReadBuffer(GL_NONE);
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory));
    EXPECT_NO_ERROR(glReadPixels(0, 0, 0, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL));
    glBegin(GL_POINTS);
    glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, memory);
    EXPECT_ERROR(GL_INVALID_OPERATION, glEnd());
    for (size_t i = 0; i < sizeof memory; i++)
        assert_int_equal(memory[i], GUARD);
}

static void test_missing_buffers(void **state)
{
    (void)state;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    assert_true(OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, memory));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, memory));
    OSMesaDestroyContext(context);
}

/* What was drawn before is seen. */
static void test_reads_after_drawing(void **state)
{
    (void)state;
    unsigned char pixel[4] = {0};
    glColor3f(1, 0, 1);
    glRectf(-1, -1, 1, 1);
    glReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    assert_memory_equal(pixel, ((unsigned char[]){255, 0, 255, 255}), 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(test_formats_and_types),
            GL_TEST(test_pixel_store),
            GL_TEST(test_clipping),
            GL_TEST(test_swap_bytes),
            GL_TEST(test_stencil_bitmap),
            GL_TEST(test_white_luminance),
            GL_TEST(test_errors),
            GL_TEST(test_missing_buffers),
            GL_TEST(test_reads_after_drawing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
