/* Texture images (GL 1.5, 3.8.1 to 3.8.3, 6.1.3, 6.1.4): errors, storage, sub-images, copies, proxies, mipmaps. */
#include "api/gl_test.h"

#include <math.h>

static GLubyte pixels[64 * 64 * 4];

static GLint level_value(GLenum target, GLint level, GLenum pname)
{
    GLint v = -1;
    glGetTexLevelParameteriv(target, level, pname, &v);
    return v;
}

static void fill_pixels(void)
{
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (GLubyte)(i * 7 + i / 251);
}

static void image_2d(GLint internal_format, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type)
{
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, border, format, type, pixels);
}

/* ---- errors ---- */

static void images_are_checked(void **state)
{
    (void)state;
    static const struct {
        GLenum error, target;
        GLint level, internal_format;
        GLsizei width, height;
        GLint border;
        GLenum format, type;
    } wrong[] = {
            {GL_INVALID_ENUM, GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_ENUM, GL_TEXTURE_1D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 15, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, GL_RGBA, -1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, GL_RGBA, 4, -1, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, GL_RGBA, 16385, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 3, GL_RGBA, 4096, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_2D, 0, 77, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_VALUE, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGBA, 4, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
            {GL_INVALID_ENUM, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_LIGHT0, GL_UNSIGNED_BYTE},
            {GL_INVALID_ENUM, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_LIGHT0},
            {GL_INVALID_ENUM, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BITMAP},
            {GL_INVALID_OPERATION, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5},
            {GL_INVALID_OPERATION, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE},
            {GL_INVALID_OPERATION, GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE},
    };
    EXPECT_NO_ERROR(image_2d(GL_RGB, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        EXPECT_ERROR(wrong[i].error, glTexImage2D(wrong[i].target, wrong[i].level, wrong[i].internal_format, wrong[i].width,
                                                  wrong[i].height, wrong[i].border, wrong[i].format, wrong[i].type, pixels));
    if (on_fixedgl()) { /* GL 1.5, 3.8.1; OSMesa raises GL_INVALID_OPERATION, and has depth on cube maps */
        EXPECT_ERROR(GL_INVALID_ENUM, image_2d(GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE));
        EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_DEPTH_COMPONENT, 4, 4, 0,
                                                        GL_DEPTH_COMPONENT, GL_FLOAT, NULL));
    }
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 4, 4, 4, 0, GL_DEPTH_COMPONENT,
                                                    GL_FLOAT, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4096, 0, GL_RGBA, GL_FLOAT, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, -4, 0, GL_RGBA, GL_FLOAT, NULL));
    GLint most = 0; /* without the border */
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    EXPECT_NO_ERROR(glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, most + 2, 1, GL_RGBA, GL_FLOAT, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, most + 3, 1, GL_RGBA, GL_FLOAT, NULL));
    EXPECT_NO_ERROR(glTexImage1D(GL_TEXTURE_1D, 1, GL_RGBA, most / 2, 0, GL_RGBA, GL_FLOAT, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage1D(GL_TEXTURE_1D, 1, GL_RGBA, most / 2 + 1, 0, GL_RGBA, GL_FLOAT, NULL));
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 2); /* nothing has changed */
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT), GL_RGB);
}

static void parts_are_checked(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels));
    image_2d(GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    static const GLint wrong[][4] = {{-1, 0, 1, 1}, {0, -1, 1, 1}, {8, 0, 1, 1}, {0, 4, 1, 1}, {0, 0, 9, 1},
                                     {0, 0, 1, 5},  {0, 0, -1, 1}, {0, 0, 1, -1}, {1, 0, 0x7fffffff, 1}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const GLint *w = wrong[i];
        EXPECT_ERROR(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, w[0], w[1], w[2], w[3], GL_RGBA, GL_UNSIGNED_BYTE,
                                                       pixels));
        EXPECT_ERROR(GL_INVALID_VALUE, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, w[0], w[1], 0, 0, w[2], w[3]));
    }
    EXPECT_ERROR(GL_INVALID_ENUM, glTexSubImage2D(GL_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 20, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_OPERATION,
                 glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyTexImage2D(GL_TEXTURE_2D, 0, 4, 0, 0, 4, 4, 0));
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0));
    EXPECT_ERROR(GL_INVALID_VALUE, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, -4, 4, 0));
}

static void queries_are_checked(void **state)
{
    (void)state;
    GLint v;
    GLfloat f;
    image_2d(GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    EXPECT_ERROR(GL_INVALID_VALUE, glGetTexLevelParameteriv(GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, &v));
    EXPECT_ERROR(GL_INVALID_VALUE, glGetTexLevelParameteriv(GL_TEXTURE_2D, 15, GL_TEXTURE_WIDTH, &v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetTexLevelParameteriv(GL_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH, &v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_LIGHT0, &f));
    EXPECT_ERROR(GL_INVALID_OPERATION,
                 glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &v));
    EXPECT_ERROR(GL_INVALID_ENUM, glGetTexImage(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_VALUE, glGetTexImage(GL_TEXTURE_2D, 20, GL_RGBA, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, pixels));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetCompressedTexImage(GL_TEXTURE_2D, 0, pixels));
    EXPECT_ERROR(GL_INVALID_ENUM, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 4, 4, 0, 64, pixels));
    EXPECT_ERROR(GL_INVALID_ENUM, glCompressedTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB, 4, 0, 64, pixels));
    if (on_fixedgl())
        EXPECT_INTS(GL_NUM_COMPRESSED_TEXTURE_FORMATS, 0);
}

/* ---- storage ---- */

static void bytes_come_back(void **state)
{
    (void)state;
    static GLubyte got[16 * 8 * 4];
    fill_pixels();
    image_2d(GL_RGBA, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, pixels, sizeof got);
}

/* GL 1.5, 3.8.1: a channel of b bits is within half a step of what was given, and base formats take their channels. */
static void channels_are_kept_by_their_bits(void **state)
{
    (void)state;
    static const struct {
        GLint internal_format;
        int bits[4]; /* 0: reads as 0, -1: as 1, red's value otherwise where `luminance` */
    } formats[] = {
            {GL_RGBA8, {8, 8, 8, 8}},    {GL_RGB5_A1, {5, 5, 5, 1}},     {GL_RGBA4, {4, 4, 4, 4}},
            {GL_R3_G3_B2, {3, 3, 2, -1}}, {GL_RGB10_A2, {10, 10, 10, 2}}, {GL_RGBA16, {16, 16, 16, 16}},
            {GL_LUMINANCE8, {8, 0, 0, -1}}, {GL_LUMINANCE8_ALPHA8, {8, 0, 0, 8}}, {GL_ALPHA16, {0, 0, 0, 16}},
            {GL_INTENSITY8, {8, 0, 0, -1}}, {3, {8, 8, 8, -1}},           {GL_COMPRESSED_RGB, {8, 8, 8, -1}},
    };
    GLfloat given[16][4], got[16][4];
    for (int i = 0; i < 16; i++)
        for (int c = 0; c < 4; c++)
            given[i][c] = (GLfloat)((i * 37 + c * 11) % 101) / 100.0f;
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        glTexImage2D(GL_TEXTURE_2D, 0, formats[k].internal_format, 4, 4, 0, GL_RGBA, GL_FLOAT, given);
        if (!on_fixedgl() && formats[k].internal_format == GL_COMPRESSED_RGB)
            continue; /* OSMesa really compresses */
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, got);
        for (int i = 0; i < 16; i++)
            for (int c = 0; c < 4; c++) {
                const int bits = formats[k].bits[c];
                const float expected = bits > 0 ? given[i][c] : bits ? 1.0f : 0.0f;
                const float step = bits > 0 ? 1.0f / (float)((1 << bits) - 1) : 0.0f;
                assert_true(fabsf(got[i][c] - expected) <= 0.5001f * step);
            }
    }
}

static void a_border_is_dropped(void **state)
{
    (void)state;
    GLubyte got[4 * 2 * 4];
    fill_pixels();
    EXPECT_NO_ERROR(image_2d(GL_RGBA, 6, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE));
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 4);
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER), 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, pixels + (6 + 1) * 4, 16);
    assert_memory_equal(got + 16, pixels + (12 + 1) * 4, 16);
}

static void slices_follow_the_pixel_store(void **state)
{
    (void)state;
    GLubyte got[2 * 2 * 3];
    fill_pixels();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 4);
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    EXPECT_NO_ERROR(glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE, 2, 2, 3, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels));
    glGetTexImage(GL_TEXTURE_3D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, got);
    for (int z = 0; z < 3; z++)
        for (int y = 0; y < 2; y++)
            for (int x = 0; x < 2; x++)
                assert_int_equal(got[(z * 2 + y) * 2 + x], pixels[((z + 1) * 4 + y + 2) * 5 + x + 1]);
}

static void parts_replace_parts(void **state)
{
    (void)state;
    const GLubyte part[2] = {201, 202};
    GLubyte got[16], expected[16];
    fill_pixels();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 2, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part);
    memcpy(expected, pixels, sizeof expected);
    memcpy(expected + 9, part, 2);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, expected, sizeof got);
}

static void the_framebuffer_is_copied(void **state)
{
    (void)state;
    GLubyte got[8 * 8 * 4], expected[8 * 8 * 4];
    fill_pixels();
    glWindowPos2i(0, 0);
    glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    EXPECT_NO_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 3, 5, 8, 8, 0));
    glReadPixels(3, 5, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, expected);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, expected, sizeof got);
    EXPECT_NO_ERROR(glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 40, 41, 1, 1));
    glReadPixels(40, 41, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, expected + (3 * 8 + 2) * 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, expected, sizeof got);
}

/* A bias that changes nothing, but is pixel transfer, takes the colours through floats. */
static void copied_bytes_are_those_of_copied_floats(void **state)
{
    static const GLenum formats[] = {GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8};
    (void)state;
    GLubyte bytes[40 * 30 * 4], floats[40 * 30 * 4];
    fill_pixels();
    glWindowPos2i(0, 0);
    glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        EXPECT_NO_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, formats[i], 3, 5, 40, 30, 0));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        glPixelTransferf(GL_ALPHA_BIAS, 1e-30f);
        EXPECT_NO_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, formats[i], 3, 5, 40, 30, 0));
        glPixelTransferf(GL_ALPHA_BIAS, 0);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, floats);
        assert_memory_equal(bytes, floats, sizeof bytes);
    }
}

static void proxies_answer(void **state)
{
    (void)state;
    EXPECT_NO_ERROR(glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB5, 64, 32, 0, GL_RGBA, GL_FLOAT, NULL));
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 64);
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_GREEN_SIZE), 5);
    EXPECT_NO_ERROR(glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 20000, 1, 0, GL_RGBA, GL_FLOAT, NULL));
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 0);
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_GREEN_SIZE), 0);
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage2D(GL_PROXY_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_FLOAT, NULL));
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 0);
}

static void mipmaps_are_generated(void **state)
{
    (void)state;
    const GLubyte image[4][4] = {{10, 20, 30, 40}, {10, 20, 30, 40}, {50, 60, 70, 80}, {50, 60, 70, 81}};
    GLubyte got[4];
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, image);
    assert_int_equal(level_value(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH), 2);
    assert_int_equal(level_value(GL_TEXTURE_2D, 2, GL_TEXTURE_HEIGHT), 1);
    assert_int_equal(level_value(GL_TEXTURE_2D, 3, GL_TEXTURE_WIDTH), 0);
    glGetTexImage(GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, got);
    const GLubyte half[4] = {15, 35, 55, 76}; /* each mean of two is rounded up: 75.25 becomes 76 */
    assert_memory_equal(got, half, 4);
    glGetTexImage(GL_TEXTURE_2D, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[0], 46);
}

static void lists_keep_images(void **state)
{
    (void)state;
    GLubyte got[16 * 4], copy[16 * 4];
    fill_pixels();
    memcpy(copy, pixels, sizeof copy);
    glNewList(1, GL_COMPILE);
    image_2d(GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL); /* at once */
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels));
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0x7fffffff, 0x7fffffff, 0, GL_RGBA, GL_FLOAT, pixels));
    glEndList();
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 8);
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 0);
    memset(pixels, 0, sizeof pixels);
    EXPECT_ERROR(GL_INVALID_VALUE, glCallList(1));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_memory_equal(got, copy, sizeof got);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(images_are_checked),
            GL_TEST(parts_are_checked),
            GL_TEST(queries_are_checked),
            GL_TEST(bytes_come_back),
            GL_TEST(channels_are_kept_by_their_bits),
            GL_TEST(a_border_is_dropped),
            GL_TEST(slices_follow_the_pixel_store),
            GL_TEST(parts_replace_parts),
            GL_TEST(the_framebuffer_is_copied),
            GL_TEST(copied_bytes_are_those_of_copied_floats),
            GL_TEST(proxies_answer),
            GL_TEST(mipmaps_are_generated),
            GL_TEST(lists_keep_images),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
