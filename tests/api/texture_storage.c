/* Immutable textures (GL_ARB_texture_storage). */
#include "api/gl_test.h"

static GLuint bind_new(GLenum target)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    return name;
}

static GLint level_value(GLenum target, GLint level, GLenum pname)
{
    GLint v = -1;
    glGetTexLevelParameteriv(target, level, pname, &v);
    return v;
}

static GLint immutable(GLenum target)
{
    GLint v = -1;
    glGetTexParameteriv(target, GL_TEXTURE_IMMUTABLE_FORMAT, &v);
    return v;
}

static void all_levels_are_made(void **state)
{
    (void)state;
    bind_new(GL_TEXTURE_2D);
    assert_int_equal(immutable(GL_TEXTURE_2D), GL_FALSE);
    EXPECT_NO_ERROR(glTexStorage2D(GL_TEXTURE_2D, 3, GL_RGBA8, 9, 4));
    assert_int_equal(immutable(GL_TEXTURE_2D), GL_TRUE);
    for (int level = 0; level < 3; level++) {
        assert_int_equal(level_value(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH), 9 >> level);
        assert_int_equal(level_value(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT), 4 >> level);
        assert_int_equal(level_value(GL_TEXTURE_2D, level, GL_TEXTURE_INTERNAL_FORMAT), GL_RGBA8);
    }
    assert_int_equal(level_value(GL_TEXTURE_2D, 3, GL_TEXTURE_WIDTH), 0);
    bind_new(GL_TEXTURE_CUBE_MAP);
    EXPECT_NO_ERROR(glTexStorage2D(GL_TEXTURE_CUBE_MAP, 2, GL_RGB5, 4, 4));
    assert_int_equal(level_value(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 1, GL_TEXTURE_WIDTH), 2);
    bind_new(GL_TEXTURE_1D);
    EXPECT_NO_ERROR(glTexStorage1D(GL_TEXTURE_1D, 4, GL_LUMINANCE8, 8));
    assert_int_equal(level_value(GL_TEXTURE_1D, 3, GL_TEXTURE_WIDTH), 1);
    bind_new(GL_TEXTURE_3D);
    EXPECT_NO_ERROR(glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA16, 2, 3, 4));
    assert_int_equal(level_value(GL_TEXTURE_3D, 0, GL_TEXTURE_DEPTH), 4);
}

static void proxies(void **state)
{
    (void)state;
    EXPECT_NO_ERROR(glTexStorage2D(GL_PROXY_TEXTURE_2D, 2, GL_RGBA8, 8, 8));
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 1, GL_TEXTURE_WIDTH), 4);
    EXPECT_NO_ERROR(glTexStorage2D(GL_PROXY_TEXTURE_2D, 1, GL_RGBA8, 1 << 20, 8));
    assert_int_equal(level_value(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 0);
}

static void errors(void **state)
{
    static const GLenum unsized[] = {4, GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL,
                                     GL_RED, GL_RG, GL_SRGB_EXT, GL_LIGHT0};
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4)); /* the default texture */
    bind_new(GL_TEXTURE_2D);
    for (size_t i = 0; i < sizeof unsized / sizeof *unsized; i++)
        EXPECT_ERROR(GL_INVALID_ENUM, glTexStorage2D(GL_TEXTURE_2D, 1, unsized[i], 4, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexStorage2D(GL_TEXTURE_1D, 1, GL_RGBA8, 4, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexStorage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1, GL_RGBA8, 4, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexStorage1D(GL_TEXTURE_2D, 1, GL_RGBA8, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexStorage3D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4, 4));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexStorage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 0, 4));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, -1));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 1 << 20, 4));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexStorage2D(GL_TEXTURE_2D, 4, GL_RGBA8, 4, 4));
    assert_int_equal(immutable(GL_TEXTURE_2D), GL_FALSE);
    bind_new(GL_TEXTURE_CUBE_MAP);
    EXPECT_ERROR(GL_INVALID_VALUE, glTexStorage2D(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA8, 4, 2));
    bind_new(GL_TEXTURE_3D);
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexStorage3D(GL_TEXTURE_3D, 1, GL_DEPTH_COMPONENT24, 4, 4, 4));
    bind_new(GL_TEXTURE_RECTANGLE_ARB);
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexStorage2D(GL_TEXTURE_RECTANGLE_ARB, 2, GL_RGBA8, 4, 4));
    EXPECT_NO_ERROR(glTexStorage2D(GL_TEXTURE_RECTANGLE_ARB, 1, GL_RGBA8, 4, 4));
}

static void storage_stays(void **state)
{
    const GLubyte green[4] = {0, 255, 0, 255};
    (void)state;
    bind_new(GL_TEXTURE_2D);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 1, 1);
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 2, 2));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 2, 2, 0));
    assert_int_equal(level_value(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 1);
    EXPECT_NO_ERROR(glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glRectf(-1, -1, 1, 1); /* mipmapped, by one level: complete */
    glFinish();
    assert_memory_equal(picture, green, 4);
}

/* Levels beyond those that there are count as the last one. */
static void levels_are_limited(void **state)
{
    const GLubyte blue[4] = {0, 0, 255, 255};
    (void)state;
    bind_new(GL_TEXTURE_2D);
    glTexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 2, 2);
    glTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, blue);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 7);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_memory_equal(picture, blue, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(all_levels_are_made), GL_TEST(proxies), GL_TEST(errors), GL_TEST(storage_stays), GL_TEST(levels_are_limited),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
