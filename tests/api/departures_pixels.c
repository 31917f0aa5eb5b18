/* Where lines, pixel rectangles and what is read back are the specification's and OSMesa's are not
 * (docs/departures.md). On OSMesa this test shows that it still differs. */
#include "api/gl_test.h"

static unsigned char before[sizeof picture];

static const unsigned char *pixel(int x, int y)
{
    glFinish();
    return picture + 4 * (y * TEST_SIZE + x);
}

static void keep_picture(void)
{
    glFinish();
    memcpy(before, picture, sizeof picture);
    glClear(GL_COLOR_BUFFER_BIT);
}

static bool same_picture(void)
{
    glFinish();
    return memcmp(before, picture, sizeof picture) == 0;
}

/* Column of pixel k of a strip that goes to and fro, row by row, from the center of one pixel to the next. */
static int column(int k)
{
    const int x = k % TEST_SIZE;
    return k / TEST_SIZE % 2 ? TEST_SIZE - 1 - x : x;
}

static void strip_through_all_pixels(void)
{
    glBegin(GL_LINE_STRIP);
    for (int k = 0; k < TEST_SIZE * TEST_SIZE; k++) {
        const int row = k / TEST_SIZE;
        for (int unit = 0; unit < 8; unit++) /* large vertices, which fill a buffer soon */
            glMultiTexCoord4f((GLenum)(GL_TEXTURE0 + unit), (float)k, 0, 0, 1);
        glVertex2f((float)(2 * column(k) + 1) / TEST_SIZE - 1, (float)(2 * row + 1) / TEST_SIZE - 1);
    }
    glEnd();
}

/* stipple-over-buffers. GL 1.5, 3.4.2: the counter starts anew at glBegin alone. */
static void the_stipple_of_a_long_strip_goes_on(void **state)
{
    const int pattern = 0x1f7;
    bool right = true;
    (void)state;
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, (GLushort)pattern);
    strip_through_all_pixels();
    for (int k = 0; k < TEST_SIZE * TEST_SIZE - 1; k++)
        right = right && (pixel(column(k), k / TEST_SIZE)[0] == 255) == (pattern >> k % 16 & 1);
    assert_int_equal(right, on_fixedgl());
}

static void front_and_back_triangle(void)
{
    glBegin(GL_TRIANGLES);
    glColor4f(1, 0, 0, 0.5f);
    glVertex2f(-0.9f, -0.9f);
    glColor4f(0, 1, 0, 0.5f);
    glVertex2f(-0.1f, -0.9f);
    glColor4f(0, 0, 1, 0.5f);
    glVertex2f(-0.5f, 0.9f);
    glVertex2f(0.1f, -0.9f);
    glVertex2f(0.5f, 0.9f);
    glVertex2f(0.9f, -0.9f);
    glEnd();
}

/* smooth-with-fill. GL 1.5, 3.4.2, 3.5.6: coverage scales the alpha of smooth lines and points alone. OSMesa's alpha is
 * arbitrary, and it may read where nothing is. */
static void filled_triangles_beside_smooth_lines_keep_their_alpha(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    glPolygonMode(GL_BACK, GL_LINE);
    glEnable(GL_LINE_SMOOTH);
    front_and_back_triangle();
    assert_in_range(pixel(16, 16)[3], 127, 128);
}

/* smooth-with-fill. GL 1.5, 2.14.7: the shade model is that of the draw. */
static void smooth_edges_have_this_draws_shade_model(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    glPolygonMode(GL_BACK, GL_LINE);
    glEnable(GL_LINE_SMOOTH);
    glShadeModel(GL_FLAT);
    front_and_back_triangle();
    keep_picture();
    glShadeModel(GL_SMOOTH);
    front_and_back_triangle();
    assert_false(same_picture());
    glClear(GL_COLOR_BUFFER_BIT);
    glShadeModel(GL_FLAT);
    front_and_back_triangle();
    assert_true(same_picture());
}

/* Four texels: red, green, blue, white. */
static void four_texels(void)
{
    static const GLubyte image[4][4] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static void textured_rectangle(void)
{
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        const float x = i == 1 || i == 2, y = i > 1;
        glTexCoord2f(x, y);
        glVertex2f(-1 + x / 4, -1 + y / 4);
    }
    glEnd();
}

static int texels_of_bitmap(void)
{
    static const GLubyte bits[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    int other = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexCoord2f(0.25f, 0.25f);
    glWindowPos2i(32, 32);
    glBitmap(8, 8, 0, 0, 0, 0, bits);
    for (int y = 32; y < 40; y++)
        for (int x = 32; x < 40; x++)
            other += memcmp(pixel(x, y), "\xff\0\0\xff", 4) != 0;
    return other;
}

/* textured-pixels. GL 1.5, 3.7: a bitmap's fragments have the texture coordinates of one point. */
static void bitmaps_have_one_texture_coordinate(void **state)
{
    (void)state;
    four_texels();
    glEnable(GL_TEXTURE_2D);
    textured_rectangle();
    if (on_fixedgl())
        assert_int_equal(texels_of_bitmap(), 0);
    else
        assert_int_not_equal(texels_of_bitmap(), 0);
}

/* textured-pixels. GL 1.5, 3.6.4, 4.3.3: what is copied becomes fragments, which are textured. */
static void copied_pixels_are_textured(void **state)
{
    (void)state;
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    four_texels();
    glEnable(GL_TEXTURE_2D);
    glTexCoord2f(0.25f, 0.25f);
    glWindowPos2i(32, 32);
    glCopyPixels(0, 0, 8, 8, GL_COLOR);
    assert_int_equal(pixel(35, 35)[0], 255);
    assert_int_equal(pixel(35, 35)[1], on_fixedgl() ? 0 : 255);
}

/* textured-pixels. GL 1.5, 3.8.8: one texture coordinate for all fragments, and so no minification. */
static void drawn_pixels_of_a_later_unit_are_magnified(void **state)
{
    static const GLubyte base[4][4] = {{10, 0, 0, 255}, {10, 0, 0, 255}, {10, 0, 0, 255}, {10, 0, 0, 255}}, least[4] = {200, 0, 0, 255};
    static const GLubyte white[4] = {255, 255, 255, 255};
    (void)state;
    glActiveTexture(GL_TEXTURE1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, base);
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, least);
    glEnable(GL_TEXTURE_2D);
    glWindowPos2i(3, 3);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    assert_int_equal(pixel(3, 3)[0], on_fixedgl() ? 10 : 200);
}

/* copied-images. GL 1.5, 3.8.2: the lower left pixel is the first of the image, with pixel transfer too. */
static void images_are_copied_from_where_they_are(void **state)
{
    GLubyte image[8][8][4];
    (void)state;
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < TEST_SIZE; y++) {
        glScissor(0, y, TEST_SIZE, 1);
        glClearColor(1, (float)y / 255, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glPixelTransferf(GL_RED_SCALE, 0.2f);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 7, 8, 8, 0);
    glPixelTransferf(GL_RED_SCALE, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    assert_int_equal(image[0][0][0], 51);
    assert_int_equal(image[0][0][1], on_fixedgl() ? 7 : 14);
    assert_int_equal(image[7][0][1] == 14, on_fixedgl());
}

/* pixel-transfer. GL 1.5, 3.6.5 "Index Arithmetic": stencil indexes are shifted and offset. */
static void drawn_stencils_are_shifted_and_offset(void **state)
{
    static const GLubyte three = 3;
    GLubyte got = 0;
    (void)state;
    glClear(GL_STENCIL_BUFFER_BIT);
    glPixelTransferi(GL_INDEX_SHIFT, 2);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    glWindowPos2i(0, 0);
    glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &three);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &got);
    assert_int_equal(got, on_fixedgl() ? 13 : 3);
}

/* pixel-transfer. GL 1.5, 4.2.2: the mask holds for copies. */
static void copied_pixels_obey_the_color_mask(void **state)
{
    (void)state;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 8, 8);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glWindowPos2i(32, 32);
    glCopyPixels(0, 0, 8, 8, GL_COLOR);
    assert_int_equal(pixel(35, 35)[0], 255);
    assert_int_equal(pixel(35, 35)[1], on_fixedgl() ? 0 : 255);
}

/* pixel-transfer. GL 1.5, 3.6.4: bytes are swapped wherever the rectangle begins. */
static void swapped_bytes_are_swapped_beside_the_window(void **state)
{
    static GLushort image[8];
    bool right = true;
    (void)state;
    for (int i = 0; i < 8; i++)
        image[i] = (GLushort)(16 * (i + 1)); /* as it is, nearly black */
    glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 8);
    glWindowPos2i(TEST_SIZE - 4, 0);
    glDrawPixels(6, 1, GL_LUMINANCE, GL_UNSIGNED_SHORT, image);
    for (int i = 0; i < 4; i++)
        right = right && abs(pixel(TEST_SIZE - 4 + i, 0)[0] - 16 * (i + 3)) <= 1;
    assert_int_equal(right, on_fixedgl());
}

/* pixel-transfer. GL 1.5, 3.7: each bitmap is drawn before the next. */
static void bitmaps_blend_one_after_the_other(void **state)
{
    static const GLubyte bit = 128;
    (void)state;
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3f(0.25f, 0.25f, 0.25f);
    glWindowPos2i(5, 5);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int i = 0; i < 2; i++)
        glBitmap(1, 1, 0, 0, 0, 0, &bit);
    assert_int_equal(pixel(5, 5)[0], on_fixedgl() ? 128 : 64);
}

/* The color of the raster position, and that of a point there. */
static void raster_position_and_vertex(float raster[4], float vertex[4])
{
    static const GLfloat position[4] = {1, 0, 1, 1}, white[4] = {1, 1, 1, 1};
    GLubyte drawn[4];
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, white);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(-0.75f, 0, 0.5f);
    glNormal3f(0, 0, 1);
    glRasterPos3f(0.75f, 0, -0.25f);
    glGetFloatv(GL_CURRENT_RASTER_COLOR, raster);
    glPointSize(5);
    glBegin(GL_POINTS);
    glVertex3f(0.75f, 0, -0.25f);
    glEnd();
    memcpy(drawn, pixel(TEST_SIZE / 2, TEST_SIZE / 2), 4);
    for (int i = 0; i < 4; i++)
        vertex[i] = (float)drawn[i] / 255;
}

/* lit-raster-positions. GL 1.5, 2.13: the raster position is lit as a vertex is. */
static void a_raster_position_is_lit_as_a_vertex(void **state)
{
    float raster[4], vertex[4];
    (void)state;
    raster_position_and_vertex(raster, vertex);
    const float difference = raster[0] - vertex[0];
    assert_int_equal(difference > -0.003f && difference < 0.003f, on_fixedgl());
}

/* Green of a red bitmap whose raster position has a green secondary color. */
static int secondary_green_of_bitmap(void)
{
    static const GLubyte bits[4] = {255, 255, 255, 255};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glColor3f(1, 0, 0);
    glSecondaryColor3f(0, 1, 0);
    glWindowPos2i(0, 0);
    glSecondaryColor3f(0, 0, 1);
    glBitmap(4, 4, 0, 0, 0, 0, bits);
    return pixel(1, 1)[1];
}

/* raster-secondary-color. GL 1.5, 2.13, 3.7: a bitmap's fragments have the colors of the raster position. */
static void bitmaps_have_the_secondary_color_of_the_raster_position(void **state)
{
    (void)state;
    glEnable(GL_COLOR_SUM);
    assert_int_equal(secondary_green_of_bitmap(), on_fixedgl() ? 255 : 0);
    glDisable(GL_COLOR_SUM);
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glClear(GL_COLOR_BUFFER_BIT);
    assert_int_equal(secondary_green_of_bitmap(), on_fixedgl() ? 255 : 0);
}

/* reads-of-one. GL 1.5, table 4.7: 1.0 is the greatest integer. */
static void one_is_the_greatest_integer(void **state)
{
    GLint luminance = 0;
    GLuint red = 0;
    (void)state;
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_INT, &luminance);
    glPixelTransferf(GL_GREEN_BIAS, 0.5f);
    glReadPixels(0, 0, 1, 1, GL_RED, GL_UNSIGNED_INT, &red);
    if (on_fixedgl()) {
        assert_int_equal(luminance, 0x7fffffff);
        assert_int_equal(red, 0xffffffff);
    } else {
        assert_int_not_equal(luminance, 0x7fffffff);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(the_stipple_of_a_long_strip_goes_on),
            GL_TEST(filled_triangles_beside_smooth_lines_keep_their_alpha),
            GL_TEST(smooth_edges_have_this_draws_shade_model),
            GL_TEST(bitmaps_have_one_texture_coordinate),
            GL_TEST(copied_pixels_are_textured),
            GL_TEST(drawn_pixels_of_a_later_unit_are_magnified),
            GL_TEST(images_are_copied_from_where_they_are),
            GL_TEST(drawn_stencils_are_shifted_and_offset),
            GL_TEST(copied_pixels_obey_the_color_mask),
            GL_TEST(swapped_bytes_are_swapped_beside_the_window),
            GL_TEST(bitmaps_blend_one_after_the_other),
            GL_TEST(a_raster_position_is_lit_as_a_vertex),
            GL_TEST(bitmaps_have_the_secondary_color_of_the_raster_position),
            GL_TEST(one_is_the_greatest_integer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
