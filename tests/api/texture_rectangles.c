/* Rectangle textures (GL_ARB_texture_rectangle). */
#include "api/gl_test.h"

#define TARGET GL_TEXTURE_RECTANGLE_ARB
enum { WIDTH = 5, HEIGHT = 3 };

/* Each texel has its column as red and its row as green. */
static void define(void)
{
    GLubyte texels[HEIGHT][WIDTH][4];
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            memcpy(texels[y][x], (GLubyte[4]){(GLubyte)x, (GLubyte)y, 0, 255}, 4);
    glTexImage2D(TARGET, 0, GL_RGBA, WIDTH, HEIGHT, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

static GLint parameter(GLenum pname)
{
    GLint v = -1;
    glGetTexParameteriv(TARGET, pname, &v);
    return v;
}

static void coordinates_are_texels(void **state)
{
    (void)state;
    define();
    glTexParameteri(TARGET, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(TARGET, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(TARGET);
    glTexCoord2f(3.5f, 1.5f);
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[0], 3);
    assert_int_equal(picture[1], 1);
    glTexCoord2f(100, -7); /* clamped */
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[0], WIDTH - 1);
    assert_int_equal(picture[1], 0);
}

/* They come before textures of two dimensions, behind those of three. */
static void precedence(void **state)
{
    const GLubyte white[4] = {255, 255, 255, 255};
    (void)state;
    define();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(TARGET);
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[2], 0);
    glEnable(GL_TEXTURE_3D);
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[2], 255);
}

static void no_mipmaps_and_no_repetition(void **state)
{
    (void)state;
    assert_int_equal(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
    assert_int_equal(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(TARGET, GL_TEXTURE_WRAP_S, GL_REPEAT));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(TARGET, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT));
    EXPECT_NO_ERROR(glTexParameteri(TARGET, GL_TEXTURE_WRAP_T, GL_CLAMP));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(TARGET, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexParameteri(TARGET, GL_TEXTURE_BASE_LEVEL, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexParameteri(TARGET, GL_TEXTURE_MAX_LEVEL, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage2D(TARGET, 1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexImage2D(TARGET, 0, GL_RGBA, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexImage1D(TARGET, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_ENUM, glGenerateMipmap(TARGET));
    GLint v = 0;
    EXPECT_ERROR(GL_INVALID_VALUE, glGetTexLevelParameteriv(TARGET, 1, GL_TEXTURE_WIDTH, &v));
}

static void proxies_and_queries(void **state)
{
    GLint v = -1;
    GLuint name;
    (void)state;
    EXPECT_NO_ERROR(glTexImage2D(GL_PROXY_TEXTURE_RECTANGLE_ARB, 0, GL_RGBA, 100, 7, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_RECTANGLE_ARB, 0, GL_TEXTURE_HEIGHT, &v);
    assert_int_equal(v, 7);
    EXPECT_NO_ERROR(glTexImage2D(GL_PROXY_TEXTURE_RECTANGLE_ARB, 0, GL_RGBA, 1 << 20, 7, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_RECTANGLE_ARB, 0, GL_TEXTURE_HEIGHT, &v);
    assert_int_equal(v, 0);
    glGetIntegerv(GL_MAX_RECTANGLE_TEXTURE_SIZE_ARB, &v);
    assert_true(v >= 64);
    glGenTextures(1, &name);
    glBindTexture(TARGET, name);
    EXPECT_INTS(GL_TEXTURE_BINDING_RECTANGLE_ARB, (GLint)name);
    EXPECT_ERROR(GL_INVALID_OPERATION, glBindTexture(GL_TEXTURE_2D, name));
    glDeleteTextures(1, &name);
    EXPECT_INTS(GL_TEXTURE_BINDING_RECTANGLE_ARB, 0);
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(TARGET);
    glPopAttrib();
    assert_false(glIsEnabled(TARGET));
}

static void rectangles_are_drawn_to(void **state)
{
    GLuint name, framebuffer;
    GLubyte got[WIDTH * HEIGHT * 4] = {0};
    (void)state;
    glGenTextures(1, &name);
    glBindTexture(TARGET, name);
    define();
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    EXPECT_NO_ERROR(glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, TARGET, name, 0));
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glGetTexImage(TARGET, 0, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_int_equal(got[4 * (WIDTH * HEIGHT - 1) + 2], 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(coordinates_are_texels), GL_TEST(precedence),           GL_TEST(no_mipmaps_and_no_repetition),
            GL_TEST(proxies_and_queries),    GL_TEST(rectangles_are_drawn_to),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
