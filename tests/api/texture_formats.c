/* The storage formats of GL_ARB_texture_float, GL_ARB_texture_rg, GL_EXT_texture_snorm and GL_EXT_texture_sRGB: what is left of values, sizes and
 * types, and what is drawn. The same on OSMesa. */
#include "api/gl_test.h"

#include <math.h>

enum { N = 4 };
static const float given[N][4] = {
        {0.1f, 0.2f, 0.3f, 0.4f}, {1.5f, -2, 100.3f, 7}, {70000, -0.5f, 0.501f, -0.003f}, {0.0078125f, 1e9f, 0.0625f, 0.9999f}};

static void define(GLenum internal_format)
{
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal_format, N, 1, 0, GL_RGBA, GL_FLOAT, given);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void expect_texels(GLenum internal_format, const float expected[N][4])
{
    float got[N][4];
    define(internal_format);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, got);
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 4; c++)
            if (fabsf(got[i][c] - expected[i][c]) > 1e-7f * fabsf(expected[i][c]))
                fail_msg("format 0x%x, texel %d, channel %d: %.9g, expected %.9g", internal_format, i, c, (double)got[i][c],
                         (double)expected[i][c]);
}

static void floats(void **state)
{
    (void)state;
    expect_texels(GL_RGBA32F_ARB, given);
    expect_texels(GL_RGBA16F_ARB, (const float[N][4]){{0.0999755859f, 0.199951172f, 0.299804688f, 0.399902344f}, /* cut */
                                                      {1.5f, -2, 100.25f, 7},
                                                      {65504, -0.5f, 0.500976562f, -0.00299835205f},
                                                      {0.0078125f, 65504, 0.0625f, 0.999511719f}});
    expect_texels(GL_RGB32F_ARB, (const float[N][4]){{0.1f, 0.2f, 0.3f, 1}, {1.5f, -2, 100.3f, 1}, {70000, -0.5f, 0.501f, 1}, {0.0078125f, 1e9f, 0.0625f, 1}});
    expect_texels(GL_LUMINANCE_ALPHA32F_ARB, (const float[N][4]){{0.1f, 0, 0, 0.4f}, {1.5f, 0, 0, 7}, {70000, 0, 0, -0.003f}, {0.0078125f, 0, 0, 0.9999f}});
    expect_texels(GL_ALPHA32F_ARB, (const float[N][4]){{0, 0, 0, 0.4f}, {0, 0, 0, 7}, {0, 0, 0, -0.003f}, {0, 0, 0, 0.9999f}});
    expect_texels(GL_R32F, (const float[N][4]){{0.1f, 0, 0, 1}, {1.5f, 0, 0, 1}, {70000, 0, 0, 1}, {0.0078125f, 0, 0, 1}});
    expect_texels(GL_RG32F, (const float[N][4]){{0.1f, 0.2f, 0, 1}, {1.5f, -2, 0, 1}, {70000, -0.5f, 0, 1}, {0.0078125f, 1e9f, 0, 1}});
    expect_texels(GL_R11F_G11F_B10F_EXT, (const float[N][4]){{0.099609375f, 0.19921875f, 0.296875f, 1}, {1.5f, 0, 100, 1}, {65024, 0, 0.5f, 1}, {0.0078125f, 65024, 0.0625f, 1}});
    expect_texels(GL_RGB9_E5_EXT, (const float[N][4]){{0.099609375f, 0.200195312f, 0.299804688f, 1}, {1.5f, 0, 100.25f, 1}, {65408, 0, 0, 1}, {0, 65408, 0, 1}});
}

static void signed_integers(void **state)
{
    (void)state;
    const float a = 1.0f / 127.0f, b = 1.0f / 32767.0f; /* OSMesa rule: multiplied, not divided */
    expect_texels(GL_RGBA8_SNORM, (const float[N][4]){{13 * a, 25 * a, 38 * a, 51 * a}, {1, -1, 1, 1}, {1, -64 * a, 64 * a, 0}, {1 * a, 1, 8 * a, 1}});
    expect_texels(GL_RGBA16_SNORM, (const float[N][4]){{3277 * b, 6553 * b, 9830 * b, 13107 * b}, {1, -1, 1, 1}, {1, -16384 * b, 16416 * b, -98 * b}, {256 * b, 1, 2048 * b, 32764 * b}});
}

static void srgb(void **state)
{
    (void)state;
    expect_texels(GL_SRGB8_ALPHA8_EXT, (const float[N][4]){{26 / 255.0f, 51 / 255.0f, 76 / 255.0f, 102 / 255.0f}, {1, 0, 1, 1}, {1, 0, 128 / 255.0f, 0}, {2 / 255.0f, 1, 16 / 255.0f, 1}});
    GLubyte all[256], back[256];
    for (int i = 0; i < 256; i++)
        all[i] = (GLubyte)i;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SLUMINANCE8_EXT, 256, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, all);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, back);
    assert_memory_equal(back, all, sizeof all);
}

static void sizes(void **state)
{
    (void)state;
    static const struct {
        GLenum internal_format;
        GLint size[6]; /* red, green, blue, alpha, luminance, intensity */
        GLenum type;   /* of those that there are */
    } formats[] = {
            {GL_RED, {8}, GL_UNSIGNED_NORMALIZED_ARB},
            {GL_RG16, {16, 16}, GL_UNSIGNED_NORMALIZED_ARB},
            {GL_RGBA8, {8, 8, 8, 8}, GL_UNSIGNED_NORMALIZED_ARB},
            {GL_RGB32F_ARB, {32, 32, 32}, GL_FLOAT},
            {GL_LUMINANCE_ALPHA16F_ARB, {0, 0, 0, 16, 16}, GL_FLOAT},
            {GL_INTENSITY32F_ARB, {0, 0, 0, 0, 0, 32}, GL_FLOAT},
            {GL_RG8_SNORM, {8, 8}, GL_SIGNED_NORMALIZED},
            {GL_ALPHA_SNORM, {0, 0, 0, 8}, GL_SIGNED_NORMALIZED},
            {GL_SLUMINANCE8_ALPHA8_EXT, {0, 0, 0, 8, 8}, GL_UNSIGNED_NORMALIZED_ARB},
            {GL_R11F_G11F_B10F_EXT, {11, 11, 10}, GL_FLOAT},
            {GL_RGB9_E5_EXT, {9, 9, 9}, GL_FLOAT},
    };
    static const GLenum names[6][2] = {{GL_TEXTURE_RED_SIZE, GL_TEXTURE_RED_TYPE_ARB},
                                       {GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_GREEN_TYPE_ARB},
                                       {GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_BLUE_TYPE_ARB},
                                       {GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_ALPHA_TYPE_ARB},
                                       {GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_LUMINANCE_TYPE_ARB},
                                       {GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_INTENSITY_TYPE_ARB}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        define(formats[i].internal_format);
        for (int c = 0; c < 6; c++) {
            GLint size, type;
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, names[c][0], &size);
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, names[c][1], &type);
            assert_int_equal(size, formats[i].size[c]);
            assert_int_equal(type, formats[i].size[c] ? formats[i].type : GL_NONE);
        }
    }
    GLint bits;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_SHARED_SIZE_EXT, &bits);
    assert_int_equal(bits, 5);
}

/* The texels of one row, modulated by one half. */
static void expect_drawn(GLenum internal_format, const GLuint expected[N])
{
    GLuint got[N];
    define(internal_format);
    glViewport(0, 0, N, 1);
    glBegin(GL_QUADS);
    glColor4f(0.5f, 0.5f, 0.5f, 0.5f);
    for (int i = 0; i < 4; i++) {
        const float s = i == 1 || i == 2, t = i >= 2;
        glTexCoord2f(s, t);
        glVertex2f(2 * s - 1, 2 * t - 1);
    }
    glEnd();
    glReadPixels(0, 0, N, 1, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, got);
    for (int i = 0; i < N; i++)
        if (got[i] != expected[i])
            fail_msg("format 0x%x, texel %d: %08x, expected %08x", internal_format, i, got[i], expected[i]);
}

static void drawing(void **state)
{
    (void)state;
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    expect_drawn(GL_RGBA32F_ARB, (const GLuint[N]){0x0d1a2633, 0xbf00ffff, 0xff004000, 0x01ff087f});
    expect_drawn(GL_RGBA8_SNORM, (const GLuint[N]){0x0d192633, 0x80008080, 0x80004000, 0x01800880});
    expect_drawn(GL_SRGB8_ALPHA8_EXT, (const GLuint[N]){0x01040933, 0x80008080, 0x80001c00, 0x00800180});
    expect_drawn(GL_RG16, (const GLuint[N]){0x0d1a0080, 0x80000080, 0x80000080, 0x01800080});
    expect_drawn(GL_LUMINANCE32F_ARB, (const GLuint[N]){0x0d0d0d80, 0xbfbfbf80, 0xffffff80, 0x01010180});
}

/* What an unsized format keeps of packed pixels, and of words (OSMesa rule): more or less than 8 bits, unless their bytes are swapped. */
static void bits_for_pixels(void **state)
{
    (void)state;
    static const struct {
        GLint internal_format;
        GLenum format, type;
        GLint red, alpha, swapped_red, swapped_alpha;
    } kept[] = {{GL_RGB, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 5, 0, 8, 0},
                {GL_RGB, GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 3, 0, 8, 0},
                {GL_RGB, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 5, 0, 5, 0},
                {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT, 16, 16, 8, 8},
                {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 4, 4, 8, 8},
                {GL_RGBA, GL_ABGR_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV, 4, 4, 8, 8},
                {GL_RGBA, GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8, 8, 8, 8, 8},
                {GL_RGBA, GL_BGRA, GL_UNSIGNED_SHORT_5_5_5_1, 5, 1, 5, 1},
                {GL_RGBA, GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, 5, 1, 8, 8},
                {GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 10, 2, 10, 2},
                {GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, 10, 2, 8, 8},
                {GL_RGBA8, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 8, 8, 8, 8}};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        for (GLint swap = 0; swap < 2; swap++) {
            GLint red = -1, alpha = -1;
            glPixelStorei(GL_UNPACK_SWAP_BYTES, swap);
            glTexImage2D(GL_TEXTURE_2D, 0, kept[i].internal_format, 1, 1, 0, kept[i].format, kept[i].type, given);
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE, &red);
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_ALPHA_SIZE, &alpha);
            if (red != (swap ? kept[i].swapped_red : kept[i].red) || alpha != (swap ? kept[i].swapped_alpha : kept[i].alpha))
                fail_msg("row %zu, swapped %d: %d bits of red, %d of alpha", i, swap, red, alpha);
        }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(floats), GL_TEST(signed_integers), GL_TEST(srgb), GL_TEST(sizes), GL_TEST(drawing), GL_TEST(bits_for_pixels)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
