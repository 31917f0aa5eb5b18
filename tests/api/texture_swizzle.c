/* GL_EXT_texture_swizzle: the components of texels exchanged, or 0 and 1. */
#include "api/gl_test.h"

static const GLenum pnames[] = {GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B, GL_TEXTURE_SWIZZLE_A};
static const GLint reversed[4] = {GL_ALPHA, GL_BLUE, GL_GREEN, GL_RED};

static GLint parameter(GLenum pname)
{
    GLint v = -1;
    glGetTexParameteriv(GL_TEXTURE_2D, pname, &v);
    return v;
}

static void assert_swizzle(GLint r, GLint g, GLint b, GLint a)
{
    const GLint wanted[4] = {r, g, b, a};
    GLint all[4] = {0};
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, all);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(parameter(pnames[i]), wanted[i]);
        assert_int_equal(all[i], wanted[i]);
    }
}

static void state(void **unused)
{
    const GLfloat floats[4] = {GL_ZERO, GL_ONE, GL_ALPHA, GL_RED};
    (void)unused;
    assert_swizzle(GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, reversed);
    assert_swizzle(GL_ALPHA, GL_BLUE, GL_GREEN, GL_RED);
    glPushAttrib(GL_TEXTURE_BIT);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, floats);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_BLUE);
    assert_swizzle(GL_ZERO, GL_BLUE, GL_ALPHA, GL_RED);
    glPopAttrib();
    assert_swizzle(GL_ALPHA, GL_BLUE, GL_GREEN, GL_RED);
}

static void errors(void **unused)
{
    const GLint last_wrong[4] = {GL_RED, GL_GREEN, GL_BLUE, GL_LUMINANCE};
    (void)unused;
    for (int i = 0; i < 4; i++)
        EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, pnames[i], GL_RGBA));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, last_wrong));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, GL_RED));
    assert_swizzle(GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA);
}

/* What a texture of one texel shows, in place of the fragment's colour. */
static void draw_one_texel(GLint internal_format, const GLubyte texel[4], const GLint swizzle[4])
{
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glRectf(-1, -1, 1, 1);
    glFinish();
}

static void assert_picture(GLubyte r, GLubyte g, GLubyte b, GLubyte a)
{
    const GLubyte wanted[4] = {r, g, b, a};
    assert_memory_equal(picture, wanted, 4);
}

static void texels_are_swizzled(void **unused)
{
    const GLubyte texel[4] = {10, 20, 30, 40};
    const GLint constants[4] = {GL_ZERO, GL_ONE, GL_RED, GL_ZERO};
    (void)unused;
    draw_one_texel(GL_RGBA, texel, reversed);
    assert_picture(40, 30, 20, 10);
    draw_one_texel(GL_RGBA, texel, constants);
    assert_picture(0, 255, 10, 0);
    draw_one_texel(GL_LUMINANCE_ALPHA, texel, reversed);
    assert_picture(40, 10, 10, 10);
    /* the environment is the base format's: without alpha, the fragment's stays */
    draw_one_texel(GL_RGB, texel, reversed);
    assert_picture(255, 30, 20, 255);
}

static void borders_are_swizzled(void **unused)
{
    const GLubyte texel[4] = {10, 20, 30, 40};
    const GLfloat border[4] = {0.2f, 0.4f, 0.6f, 0.8f};
    (void)unused;
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexCoord2f(5, 0.5f);
    draw_one_texel(GL_RGBA, texel, reversed);
    assert_picture(204, 153, 102, 51);
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(state), GL_TEST(errors), GL_TEST(texels_are_swizzled), GL_TEST(borders_are_swizzled)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
