/* Raster positions, pixel rectangles, bitmaps, pixel transfer and maps, the accumulation buffer
 * (GL 1.5, 2.13, 3.6, 3.7, 4.2.4, 4.3.3). Expected values are OSMesa's, but where on_fixedgl() says
 * otherwise. */
#include "api/gl_test.h"

static const unsigned char black[4], white[4] = {255, 255, 255, 255};

static void start(void)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, TEST_SIZE, 0, TEST_SIZE, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

static void expect_pixel_at(int x, int y, const unsigned char expected[4], int line)
{
    unsigned char got[4];
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    if (memcmp(got, expected, 4) == 0)
        return;
    print_error("%s:%d: pixel (%d,%d) is %02x%02x%02x%02x, expected %02x%02x%02x%02x\n", __FILE__, line, x, y,
                got[0], got[1], got[2], got[3], expected[0], expected[1], expected[2], expected[3]);
    _fail(__FILE__, line);
}
#define EXPECT_PIXEL(x, y, expected) expect_pixel_at((x), (y), (expected), __LINE__)

/* The red values of the pixels (x0 .. x0+n, y). */
static void expect_row_at(int x0, int y, int n, const unsigned char *expected, int line)
{
    unsigned char got[TEST_SIZE];
    glReadPixels(x0, y, n, 1, GL_RED, GL_UNSIGNED_BYTE, got);
    for (int i = 0; i < n; i++)
        if (got[i] != expected[i]) {
            print_error("%s:%d: pixel (%d,%d) is %d, expected %d\n", __FILE__, line, x0 + i, y, got[i],
                        expected[i]);
            _fail(__FILE__, line);
        }
}
#define EXPECT_ROW(x0, y, ...)                                                                               \
    expect_row_at((x0), (y), sizeof((unsigned char[]){__VA_ARGS__}), (unsigned char[]){__VA_ARGS__}, __LINE__)

/* ---- 2.13 ---- */

static void test_raster_position(void **state)
{
    (void)state;
    start();
    glDepthRange(0.25, 0.75);
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    glRasterPos3f(10.5f, 20, -1);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 10.5f, 20, 0.75f, 1);
    EXPECT_VALUES(GL_CURRENT_RASTER_COLOR, 0.1f, 0.2f, 0.3f, 0.4f);
    EXPECT_VALUES(GL_CURRENT_RASTER_DISTANCE, 22.6108379f);
    EXPECT_INTS(GL_CURRENT_RASTER_POSITION_VALID, 1);
    glColor3f(1, 1, 1);
    EXPECT_VALUES(GL_CURRENT_RASTER_COLOR, 0.1f, 0.2f, 0.3f, 0.4f);

    glRasterPos2i(-1, 10);
    EXPECT_INTS(GL_CURRENT_RASTER_POSITION_VALID, 0);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glWindowPos2i(-3, 200);
    EXPECT_INTS(GL_CURRENT_RASTER_POSITION_VALID, 1);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, -3, 200, 0.25f, 1);
    EXPECT_VALUES(GL_CURRENT_RASTER_COLOR, 1, 1, 1, 1);
    glRasterPos2dv((GLdouble[]){4, 5});
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 4, 5, 0.5f, 1);
    glRasterPos4s(4, 6, 0, 2);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 2, 3, 0.5f, 2);
    EXPECT_PIXEL(0, 10, black);
}

/* OSMesa takes the object coordinates for eye coordinates here. */
/* Exact mode: from matrices that were never floats, whose sum here would lose the quarter. */
static void test_exact_raster_position(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    fixedglAccuracy(FIXEDGL_EXACT);
    glTranslatef(16777216, 0, 0);
    glTranslatef(0.25f, 0, 0);
    glTranslatef(-16777216, 0, 0);
    glRasterPos2i(0, 0);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 40, 32, 0.5f, 1);
    const GLdouble plane[4] = {-1, 0, 0, 0.125};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    glRasterPos2f(0.0625f, 0);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION_VALID, 1);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 42, 32, 0.5f, 1);
    glRasterPos2f(0.1875f, 0);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION_VALID, 0);
}

static void test_lit_raster_position(void **state)
{
    (void)state;
    start();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){0.5f, 1, 0.25f, 1});
    glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0, 0, 0, 1});
    glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5f, 1, 0.5f});
    glRasterPos2i(3, 3);
    EXPECT_VALUES(GL_CURRENT_RASTER_COLOR, 0.5f, 0.5f, 0.25f, 0.5f);
}

/* ---- 3.6.4 ---- */

/* Positions are rounded half away from zero; pixels outside of the window are left out. */
static void test_draw_pixels_placement(void **state)
{
    (void)state;
    static const unsigned char image[6] = {10, 20, 30, 40, 50, 60};
    start();
    glWindowPos2f(10.49f, 5.5f);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(9, 5, 0, 0, 0, 0, 0);
    EXPECT_ROW(9, 6, 0, 10, 20, 30, 0);
    EXPECT_ROW(9, 7, 0, 40, 50, 60, 0);
    EXPECT_ROW(9, 8, 0, 0, 0, 0, 0);
    glWindowPos2f(-1, 20);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(0, 20, 20, 30, 0);
    glWindowPos2f(TEST_SIZE - 2, 30);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(TEST_SIZE - 3, 30, 0, 10, 20);
    glEnable(GL_SCISSOR_TEST);
    glScissor(41, 0, 1, TEST_SIZE);
    glWindowPos2f(40, 40);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(40, 40, 0, 20, 0);
}

/* One pixel of each format and type, as it arrives in an RGBA framebuffer. */
static const struct {
    GLenum format, type;
    unsigned char image[16], expected[4];
} one_pixel[] = {
        {GL_RGBA, GL_UNSIGNED_BYTE, {1, 2, 3, 4}, {1, 2, 3, 4}},
        {GL_BGRA, GL_UNSIGNED_BYTE, {1, 2, 3, 4}, {3, 2, 1, 4}},
        {GL_RGB, GL_UNSIGNED_BYTE, {1, 2, 3}, {1, 2, 3, 255}},
        {GL_BGR, GL_UNSIGNED_BYTE, {1, 2, 3}, {3, 2, 1, 255}},
        {GL_RED, GL_UNSIGNED_BYTE, {9}, {9, 0, 0, 255}},
        {GL_GREEN, GL_UNSIGNED_BYTE, {9}, {0, 9, 0, 255}},
        {GL_BLUE, GL_UNSIGNED_BYTE, {9}, {0, 0, 9, 255}},
        {GL_ALPHA, GL_UNSIGNED_BYTE, {9}, {0, 0, 0, 9}},
        {GL_LUMINANCE, GL_UNSIGNED_BYTE, {9}, {9, 9, 9, 255}},
        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, {9, 8}, {9, 9, 9, 8}},
        {GL_RGBA, GL_BYTE, {127, 64, 1, 0x80}, {255, 129, 2, 0}},
        {GL_RGB, GL_UNSIGNED_SHORT, {0xff, 0xff, 0, 0x80, 0, 1}, {255, 128, 1, 255}},
        {GL_RGB, GL_SHORT, {0xff, 0x7f, 0, 0x40, 0, 0x80}, {255, 128, 0, 255}},
        {GL_RGB, GL_UNSIGNED_INT, {255, 255, 255, 255, 0, 0, 0, 128, 0, 0, 0, 1}, {255, 128, 1, 255}},
        {GL_RGB, GL_INT, {255, 255, 255, 127, 0, 0, 0, 64, 0, 0, 0, 128}, {255, 128, 0, 255}},
        {GL_RGB, GL_FLOAT, {0, 0, 0x80, 0x3f, 0, 0, 0, 0x3f, 0, 0, 0, 0xc0}, {255, 128, 0, 255}},
        {GL_RGB, GL_UNSIGNED_BYTE_3_3_2, {0x6d}, {109, 109, 85, 255}},
        {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, {0x6d}, {182, 182, 85, 255}},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, {0x34, 0x12}, {16, 69, 165, 255}},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, {0x34, 0x12}, {165, 69, 16, 255}},
        {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, {0x34, 0x12}, {17, 34, 51, 68}},
        {GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4_REV, {0x34, 0x12}, {34, 51, 68, 17}},
        {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, {0x35, 0x12}, {16, 66, 214, 255}},
        {GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, {0x35, 0x12}, {33, 140, 173, 0}},
        {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, {4, 3, 2, 1}, {1, 2, 3, 4}},
        {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, {4, 3, 2, 1}, {2, 3, 4, 1}},
        {GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, {2, 0x80, 0, 0x80}, {128, 2, 0, 170}},
        {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, {0, 2, 8, 0x60}, {128, 128, 128, 85}},
};

static void test_draw_pixels_formats(void **state)
{
    (void)state;
    start();
    glWindowPos2i(7, 7);
    for (size_t i = 0; i < sizeof one_pixel / sizeof *one_pixel; i++) {
        EXPECT_NO_ERROR(glDrawPixels(1, 1, one_pixel[i].format, one_pixel[i].type, one_pixel[i].image));
        unsigned char got[4];
        glReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
        if (memcmp(got, one_pixel[i].expected, 4) != 0)
            fail_msg("format 0x%04x type 0x%04x: %d %d %d %d", one_pixel[i].format, one_pixel[i].type, got[0],
                     got[1], got[2], got[3]);
    }
}

static void test_unpack_store(void **state)
{
    (void)state;
    unsigned char image[64];
    for (int i = 0; i < 64; i++)
        image[i] = (unsigned char)i;
    start();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    glWindowPos2i(4, 4);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(4, 4, 18, 19, 20);
    EXPECT_ROW(4, 5, 34, 35, 36);
}

/* OSMesa rule: where a pixel's centre lies on the boundary of two of the image's, the texture coordinates'
 * last bit decides. */
static void test_pixel_zoom(void **state)
{
    (void)state;
    static const unsigned char image[8] = {10, 20, 30, 40, 50, 60, 70, 80};
    start();
    glWindowPos2i(10, 1);
    glPixelZoom(2, 1);
    glDrawPixels(2, 1, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(9, 1, 0, 10, 10, 20, 20, 0);
    glWindowPos2i(10, 2);
    glPixelZoom(1.5f, 1);
    glDrawPixels(8, 1, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(10, 2, 10, 10, 20, 30, 30, 40, 50, 50, 60, 70, 80, 80, 0);
    glWindowPos2i(10, 3);
    glPixelZoom(0.5f, 1);
    glDrawPixels(8, 1, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(10, 3, 20, 40, 60, 80, 0);
    glWindowPos2i(30, 4);
    glPixelZoom(-1, 1);
    glDrawPixels(8, 1, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(21, 4, 0, 80, 70, 60, 50, 40, 30, 20, 10, 0);
    glWindowPos2i(40, 10);
    glPixelZoom(1, -2);
    glDrawPixels(1, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    EXPECT_ROW(40, 10, 0);
    EXPECT_ROW(40, 9, 10);
    EXPECT_ROW(40, 8, 10);
    EXPECT_ROW(40, 7, 20);
    EXPECT_ROW(40, 6, 20);
    EXPECT_ROW(40, 5, 0);
}

/* A pixel rectangle's fragments pass the fragment operations, with the raster position's depth. */
static void test_draw_pixels_fragments(void **state)
{
    (void)state;
    static const unsigned char half[4] = {200, 100, 50, 128};
    start();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO);
    glWindowPos2i(1, 1);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, half);
    EXPECT_PIXEL(1, 1, ((unsigned char[]){100, 50, 25, 64}));
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glWindowPos3f(2, 1, 0.5f);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, half);
    glWindowPos3f(2, 1, 0.6f);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    EXPECT_PIXEL(2, 1, half);
    GLuint depth;
    glReadPixels(2, 1, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
    assert_int_equal(depth >> 8, 0x800000);
}

static void test_draw_depth_and_stencil(void **state)
{
    (void)state;
    static const float depths[2] = {0.25f, 0.75f};
    static const unsigned char indexes[2] = {0xab, 0x12};
    unsigned char stencil[2];
    GLuint depth[2];
    start();
    glColor3f(1, 1, 1);
    glEnable(GL_DEPTH_TEST);
    glWindowPos2i(5, 5);
    glDrawPixels(2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    EXPECT_PIXEL(5, 5, white);
    glReadPixels(5, 5, 2, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    assert_int_equal(depth[0] >> 8, 0x400000);
    assert_int_equal(depth[1] >> 8, 0xbfffff);
    glStencilMask(0xf0);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 0); /* does not matter */
    glDrawPixels(2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indexes);
    glReadPixels(5, 5, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    assert_int_equal(stencil[0], 0xa0);
    assert_int_equal(stencil[1], 0x10);
}

static void test_copy_pixels(void **state)
{
    (void)state;
    static const unsigned char image[4] = {10, 20, 30, 40};
    start();
    glWindowPos2i(10, 10);
    glDrawPixels(4, 1, GL_RED, GL_UNSIGNED_BYTE, image);
    glWindowPos2i(11, 10); /* onto itself */
    glCopyPixels(10, 10, 4, 1, GL_COLOR);
    EXPECT_ROW(10, 10, 10, 10, 20, 30, 40, 0);
    glPixelZoom(2, 2);
    glWindowPos2i(20, 20);
    glCopyPixels(11, 10, 2, 1, GL_COLOR);
    EXPECT_ROW(20, 21, 10, 10, 20, 20, 0);
}

/* OSMesa rule: where a pixel's centre lies between two rows of the image, the last bits of a texture
 * coordinate decide, and a copied image's texture has the highest row first. */
static void test_copy_ties(void **state)
{
    (void)state;
    static const unsigned char image[6] = {10, 20, 30, 40, 50, 60};
    start();
    glWindowPos2i(10, 10);
    glDrawPixels(1, 6, GL_RED, GL_UNSIGNED_BYTE, image);
    glPixelZoom(1, 0.5f);
    glWindowPos2i(12, 15);
    glDrawPixels(1, 6, GL_RED, GL_UNSIGNED_BYTE, image);
    glWindowPos2i(13, 15);
    glCopyPixels(10, 10, 1, 6, GL_COLOR);
    EXPECT_ROW(12, 15, 20, 20, 0);
    EXPECT_ROW(12, 16, 40, 30, 0);
    EXPECT_ROW(12, 17, 60, 50, 0);
}

/* OSMesa rule: copied depths are multiplied by 1 / (2^24 - 1) and by 2^24 - 1 twice, in floats. */
static void test_copy_depth(void **state)
{
    (void)state;
    static const GLuint depths[3] = {0x400000, 0xe49541, 0xfe37b8},
                        expected[3] = {0x400000, 0xe49543, 0xfe37ba};
    GLfloat image[3];
    GLuint depth[3];
    start();
    for (int i = 0; i < 3; i++)
        image[i] = (GLfloat)(depths[i] / 16777215.0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glWindowPos2i(5, 5);
    glDrawPixels(3, 1, GL_DEPTH_COMPONENT, GL_FLOAT, image);
    glWindowPos2i(5, 6);
    glCopyPixels(5, 5, 3, 1, GL_DEPTH);
    glReadPixels(5, 5, 3, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    for (int i = 0; i < 3; i++)
        assert_int_equal(depth[i] >> 8, depths[i]);
    glReadPixels(5, 6, 3, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    for (int i = 0; i < 3; i++)
        assert_int_equal(depth[i] >> 8, expected[i]);
}

/* ---- 3.6.3 ---- */

static void test_pixel_transfer(void **state)
{
    (void)state;
    static const unsigned char pixel[4] = {100, 100, 100, 100};
    unsigned char got[4];
    start();
    glPixelTransferf(GL_RED_SCALE, 2);
    glPixelTransferf(GL_GREEN_BIAS, 0.25f);
    glPixelTransferf(GL_BLUE_SCALE, -1);
    glPixelTransferi(GL_ALPHA_SCALE, 3);
    EXPECT_VALUES(GL_RED_SCALE, 2);
    EXPECT_VALUES(GL_GREEN_BIAS, 0.25f);
    glWindowPos2i(3, 3);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((unsigned char[]){255, 228, 0, 255}), 4);
    EXPECT_ERROR(GL_INVALID_ENUM, glPixelTransferf(GL_PIXEL_MAP_I_TO_I, 1));
}

static void test_pixel_maps(void **state)
{
    (void)state;
    static const float map[4] = {0, 1, 0.5f, 0.25f};
    static const unsigned char index[5] = {0, 1, 2, 3, 5};
    static const unsigned char pixel[4] = {0, 90, 255, 170};
    unsigned char got[4];
    float floats[4];
    start();
    for (int i = 0; i < 4; i++) {
        glPixelMapfv(GL_PIXEL_MAP_I_TO_R + (GLenum)i, 4, map);
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R + (GLenum)i, 4, map);
    }
    EXPECT_INTS(GL_PIXEL_MAP_I_TO_R_SIZE, 4);
    EXPECT_INTS(GL_PIXEL_MAP_S_TO_S_SIZE, 1);
    glGetPixelMapfv(GL_PIXEL_MAP_I_TO_G, floats);
    assert_memory_equal(floats, map, sizeof map);
    glWindowPos2i(3, 3);
    glDrawPixels(5, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, index);
    EXPECT_ROW(3, 3, 0, 255, 128, 64, 255);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((unsigned char[]){0, 255, 64, 128}), 4);
    EXPECT_ERROR(GL_INVALID_VALUE, glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, map));
    EXPECT_ERROR(GL_INVALID_VALUE, glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 257, map));
    EXPECT_ERROR(GL_INVALID_VALUE, glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 3, map));
    EXPECT_ERROR(GL_INVALID_ENUM, glPixelMapfv(GL_RED, 4, map));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetPixelMapfv(GL_RED, floats));
}

/* ---- 3.7 ---- */

static void test_bitmap(void **state)
{
    (void)state;
    static const GLubyte bits[2] = {0xa0, 0xe0}; /* 101, 111 */
    start();
    glColor3f(1, 1, 1);
    glWindowPos2f(10.99f, 10);
    glColor3f(0, 0, 0); /* too late */
    glBitmap(3, 2, 0, 0, 4, 1, bits);
    EXPECT_ROW(9, 10, 0, 255, 0, 255, 0);
    EXPECT_ROW(9, 11, 0, 255, 255, 255, 0);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 14.99f, 11, 0, 1);
    glWindowPos2f(20.5f, 10);
    glBitmap(3, 2, 0.75f, 0, 0, 0, bits); /* at 19, black */
    glBitmap(0, 0, 0, 0, 5, -2, NULL);
    EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 25.5f, 8, 0, 1);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    glColor3f(1, 1, 1);
    glWindowPos2i(30, 30);
    glBitmap(8, 1, 0, 0, 0, 0, bits);
    EXPECT_ROW(29, 30, 0, 0, 0, 0, 0, 0, 255, 0, 255, 0);
}

/* 5.4: images and bitmaps are kept as they were when the command was compiled. */
static void test_display_list(void **state)
{
    (void)state;
    unsigned char image[8] = {0, 10, 20, 30, 0, 40, 50, 60};
    GLubyte bits[1] = {0xc0};
    start();
    glColor3f(1, 1, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 4);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    glNewList(1, GL_COMPILE);
    glDrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE, image);
    glBitmap(1, 1, 0, -4, 0, 0, bits);
    glEndList();
    memset(image, 0, sizeof image);
    bits[0] = 0;
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glWindowPos2i(5, 5);
    glCallList(1);
    EXPECT_ROW(5, 5, 10, 20, 30, 0);
    EXPECT_ROW(5, 6, 40, 50, 60, 0);
    EXPECT_ROW(5, 9, 255, 0);
}

/* ---- 4.2.4 ---- */

static void test_accumulation(void **state)
{
    (void)state;
    unsigned char got[4];
    start();
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT);
    glAccum(GL_LOAD, 1);
    glAccum(GL_ADD, 0.1f);
    glAccum(GL_MULT, 0.5f);
    glAccum(GL_RETURN, 2);
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((unsigned char[]){76, 127, 178, 229}), 4);
    glClearAccum(0.5f, 0.25f, -0.5f, 1);
    glClear(GL_ACCUM_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glAccum(GL_RETURN, 1);
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, ((unsigned char[]){127, 64, 0, 229}), 4);
}

static void test_errors(void **state)
{
    (void)state;
    start();
    glWindowPos2i(3, 3);
    EXPECT_ERROR(GL_INVALID_VALUE, glDrawPixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white));
    EXPECT_ERROR(GL_INVALID_ENUM, glDrawPixels(1, 1, GL_TEXTURE, GL_UNSIGNED_BYTE, white));
    EXPECT_ERROR(GL_INVALID_ENUM, glDrawPixels(1, 1, GL_RGBA, GL_BITMAP, white));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, white));
    EXPECT_ERROR(GL_INVALID_VALUE, glBitmap(-1, 1, 0, 0, 0, 0, white));
    EXPECT_ERROR(GL_INVALID_VALUE, glCopyPixels(0, 0, -1, 1, GL_COLOR));
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyPixels(0, 0, 1, 1, GL_RGBA));
    EXPECT_ERROR(GL_INVALID_ENUM, glAccum(GL_RED, 1));
    glBegin(GL_POINTS);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    EXPECT_ERROR(GL_INVALID_OPERATION, glEnd());
    EXPECT_PIXEL(3, 3, black);

    OSMesaContext bare = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    assert_true(OSMesaMakeCurrent(bare, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, white));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, white));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyPixels(0, 0, 1, 1, GL_DEPTH));
    EXPECT_ERROR(GL_INVALID_OPERATION, glAccum(GL_LOAD, 1));
    OSMesaDestroyContext(bare);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(test_raster_position),
            GL_TEST(test_exact_raster_position),
            GL_TEST(test_lit_raster_position),
            GL_TEST(test_draw_pixels_placement),
            GL_TEST(test_draw_pixels_formats),
            GL_TEST(test_unpack_store),
            GL_TEST(test_pixel_zoom),
            GL_TEST(test_draw_pixels_fragments),
            GL_TEST(test_draw_depth_and_stencil),
            GL_TEST(test_copy_pixels),
            GL_TEST(test_copy_ties),
            GL_TEST(test_copy_depth),
            GL_TEST(test_pixel_transfer),
            GL_TEST(test_pixel_maps),
            GL_TEST(test_bitmap),
            GL_TEST(test_display_list),
            GL_TEST(test_accumulation),
            GL_TEST(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
