/* Sampler objects (GL_ARB_sampler_objects). */
#include "api/gl_test.h"

#include "fixedgl.h"

static GLint binding(void)
{
    GLint v = -1;
    glGetIntegerv(GL_SAMPLER_BINDING, &v);
    return v;
}

static GLint parameter(GLuint sampler, GLenum pname)
{
    GLint v = -1;
    glGetSamplerParameteriv(sampler, pname, &v);
    return v;
}

static GLuint sampler(void)
{
    GLuint name = 0;
    glGenSamplers(1, &name);
    return name;
}

static void names_and_bindings(void **state)
{
    GLuint s[3];
    (void)state;
    glGenSamplers(3, s);
    assert_true(glIsSampler(s[0]) && glIsSampler(s[2]));
    assert_false(glIsSampler(0) || glIsSampler(77));
    glBindSampler(0, s[0]);
    glBindSampler(3, s[0]);
    assert_int_equal(binding(), s[0]);
    glPushAttrib(GL_TEXTURE_BIT);
    glBindSampler(0, s[1]);
    glPopAttrib(); /* not in a group, as on OSMesa */
    assert_int_equal(binding(), s[1]);
    glActiveTexture(GL_TEXTURE3);
    assert_int_equal(binding(), s[0]);
    glDeleteSamplers(1, s);
    assert_false(glIsSampler(s[0]));
    assert_int_equal(binding(), 0);
    EXPECT_NO_ERROR(glDeleteSamplers(3, (const GLuint[]){0, 77, s[0]}));
}

static void parameters_start_as_those_of_textures(void **state)
{
    static const GLenum pnames[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_LOD,
                                    GL_TEXTURE_MAX_LOD, GL_TEXTURE_LOD_BIAS, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC};
    static const GLint values[] = {GL_REPEAT, GL_REPEAT, GL_REPEAT, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, -1000, 1000, 0, GL_NONE, GL_LEQUAL};
    const GLuint s = sampler();
    GLfloat color[4] = {1, 1, 1, 1};
    (void)state;
    for (size_t i = 0; i < sizeof pnames / sizeof *pnames; i++)
        assert_int_equal(parameter(s, pnames[i]), values[i]);
    glGetSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, color);
    assert_true(color[0] == 0 && color[1] == 0 && color[2] == 0 && color[3] == 0);
}

static void parameters_in_every_form(void **state)
{
    const GLuint s = sampler();
    const GLfloat floats[4] = {2, -1, 0.5f, 0.25f}, clamp = GL_CLAMP;
    const GLint integers[4] = {5, 6, -7, 100000001}, nearest = GL_NEAREST;
    const GLuint linear = GL_LINEAR;
    GLfloat f[4];
    GLint v[4];
    GLuint u[4];
    (void)state;
    glSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, floats); /* not clamped */
    glGetSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, f);
    assert_memory_equal(f, floats, sizeof f);
    glSamplerParameterIiv(s, GL_TEXTURE_BORDER_COLOR, integers);
    glGetSamplerParameterIiv(s, GL_TEXTURE_BORDER_COLOR, v);
    assert_memory_equal(v, integers, sizeof v);
    glGetSamplerParameterIuiv(s, GL_TEXTURE_BORDER_COLOR, u);
    assert_int_equal(u[3], 100000001);
    glSamplerParameterfv(s, GL_TEXTURE_WRAP_S, &clamp);
    glSamplerParameterf(s, GL_TEXTURE_MIN_LOD, 1.5f);
    glSamplerParameteri(s, GL_TEXTURE_MAX_LOD, 3);
    glSamplerParameteriv(s, GL_TEXTURE_MAG_FILTER, &nearest);
    glSamplerParameterIuiv(s, GL_TEXTURE_MIN_FILTER, &linear);
    glGetSamplerParameterfv(s, GL_TEXTURE_MIN_LOD, f);
    assert_true(f[0] == 1.5f);
    assert_int_equal(parameter(s, GL_TEXTURE_WRAP_S), GL_CLAMP);
    assert_int_equal(parameter(s, GL_TEXTURE_MAX_LOD), 3);
    assert_int_equal(parameter(s, GL_TEXTURE_MAG_FILTER), GL_NEAREST);
    assert_int_equal(parameter(s, GL_TEXTURE_MIN_FILTER), GL_LINEAR);
}

static void errors(void **state)
{
    static const GLenum others[] = {GL_TEXTURE_PRIORITY, GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_DEPTH_TEXTURE_MODE, GL_GENERATE_MIPMAP,
                                    GL_TEXTURE_SWIZZLE_R, GL_LIGHT0};
    const GLuint s = sampler();
    GLint v[4];
    GLfloat f[4];
    (void)state;
    EXPECT_ERROR(GL_INVALID_VALUE, glGenSamplers(-1, &(GLuint){0}));
    EXPECT_ERROR(GL_INVALID_VALUE, glDeleteSamplers(-1, &s));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBindSampler(0, 77));
    EXPECT_ERROR(GL_INVALID_VALUE, glBindSampler(100000, s));
    EXPECT_ERROR(GL_INVALID_OPERATION, glSamplerParameteri(77, GL_TEXTURE_WRAP_S, GL_REPEAT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glSamplerParameterf(0, GL_TEXTURE_WRAP_S, GL_REPEAT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetSamplerParameteriv(77, GL_TEXTURE_WRAP_S, v));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetSamplerParameterfv(77, GL_TEXTURE_WRAP_S, f));
    EXPECT_ERROR(GL_INVALID_ENUM, glSamplerParameteri(s, GL_TEXTURE_WRAP_S, GL_LIGHT0));
    EXPECT_ERROR(GL_INVALID_ENUM, glSamplerParameteri(s, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    EXPECT_ERROR(GL_INVALID_ENUM, glSamplerParameteri(s, GL_TEXTURE_BORDER_COLOR, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glSamplerParameterf(s, GL_TEXTURE_BORDER_COLOR, 1));
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        EXPECT_ERROR(GL_INVALID_ENUM, glSamplerParameteri(s, others[i], 1));
        EXPECT_ERROR(GL_INVALID_ENUM, glGetSamplerParameteriv(s, others[i], v));
    }
    assert_int_equal(parameter(s, GL_TEXTURE_WRAP_S), GL_REPEAT);
}

static void lists_compile_them(void **state)
{
    const GLuint s = sampler(), list = glGenLists(1);
    const GLfloat color[4] = {0.5f, 0.25f, 0, 1};
    GLfloat got[4];
    (void)state;
    glNewList(list, GL_COMPILE);
    glBindSampler(0, s);
    glSamplerParameteri(s, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, color);
    glEndList();
    assert_int_equal(binding(), 0);
    assert_int_equal(parameter(s, GL_TEXTURE_WRAP_S), GL_REPEAT);
    glCallList(list);
    assert_int_equal(binding(), s);
    assert_int_equal(parameter(s, GL_TEXTURE_WRAP_S), GL_CLAMP);
    glGetSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, got);
    assert_memory_equal(got, color, sizeof got);
}

/* A texture of one red level that its own filter would have mipmapped, which it is incomplete for. */
static void define(GLenum target)
{
    const GLubyte red[4] = {255, 0, 0, 255};
    glTexImage2D(target, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, red);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (const GLubyte[8]){255, 0, 0, 255, 255, 0, 0, 255});
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(target);
}

static void draw_and_expect(GLubyte r, GLubyte g, GLubyte b)
{
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[0], r);
    assert_int_equal(picture[1], g);
    assert_int_equal(picture[2], b);
}

static void a_sampler_decides_how_and_whether_to_draw(void **state)
{
    const GLuint s = sampler();
    const GLfloat green[4] = {0, 1, 0, 1};
    (void)state;
    define(GL_TEXTURE_2D);
    draw_and_expect(255, 255, 255); /* incomplete */
    glBindSampler(0, s);
    draw_and_expect(255, 255, 255);
    glSamplerParameteri(s, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(s, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    draw_and_expect(255, 0, 0);
    glSamplerParameteri(s, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(s, GL_TEXTURE_BORDER_COLOR, green);
    glTexCoord2f(5, 0);
    draw_and_expect(0, 255, 0);
    glBindSampler(0, 0);
    draw_and_expect(255, 255, 255);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    draw_and_expect(255, 0, 0);
    glSamplerParameteri(s, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glBindSampler(0, s);
    draw_and_expect(255, 255, 255);
    glDeleteSamplers(1, &s);
    draw_and_expect(255, 0, 0);
}

/* What rectangles may not be asked for draws nothing. */
static void rectangles(void **state)
{
    const GLuint s = sampler();
    (void)state;
    define(GL_TEXTURE_RECTANGLE_ARB);
    glBindSampler(0, s);
    glSamplerParameteri(s, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    draw_and_expect(255, 255, 255);
    glSamplerParameteri(s, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(s, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    draw_and_expect(255, 0, 0);
    glSamplerParameteri(s, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    draw_and_expect(255, 255, 255);
}

static void contexts_share_them(void **state)
{
    static GLubyte other[TEST_SIZE * TEST_SIZE * 4];
    const GLuint s = sampler();
    OSMesaContext first = OSMesaGetCurrentContext(), second = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, first);
    (void)state;
    assert_true(OSMesaMakeCurrent(second, other, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE));
    assert_true(glIsSampler(s));
    glBindSampler(0, s);
    glSamplerParameteri(s, GL_TEXTURE_WRAP_T, GL_CLAMP);
    OSMesaMakeCurrent(first, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
    assert_int_equal(parameter(s, GL_TEXTURE_WRAP_T), GL_CLAMP);
    assert_int_equal(binding(), 0);
    glDeleteSamplers(1, &s); /* the other context still uses it */
    OSMesaMakeCurrent(second, other, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
    assert_int_equal(binding(), s);
    assert_false(glIsSampler(s));
    glRectf(-1, -1, 1, 1);
    OSMesaDestroyContext(second);
    OSMesaMakeCurrent(first, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(names_and_bindings), GL_TEST(parameters_start_as_those_of_textures), GL_TEST(parameters_in_every_form),
            GL_TEST(errors),             GL_TEST(lists_compile_them),                    GL_TEST(a_sampler_decides_how_and_whether_to_draw),
            GL_TEST(rectangles),         GL_TEST(contexts_share_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
