/* Framebuffer objects and renderbuffers (GL_ARB_framebuffer_object, GL_EXT_framebuffer_object, GL_EXT_framebuffer_blit). */
#include "api/gl_test.h"

enum { WIDTH = 20, HEIGHT = 12 };

static GLuint texture_of(GLenum internal_format, GLenum format)
{
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal_format, WIDTH, HEIGHT, 0, format, GL_FLOAT, NULL);
    return texture;
}

static GLuint renderbuffer_of(GLenum internal_format, int width, int height)
{
    GLuint name;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, internal_format, width, height);
    return name;
}

static GLuint bind_new_framebuffer(void)
{
    GLuint name;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    return name;
}

static void attach_texture(GLenum point, GLuint texture)
{
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, 0);
}

static void attach_renderbuffer(GLenum point, GLuint name)
{
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
}

/* A framebuffer of a texture, which is returned, and a depth renderbuffer. */
static GLuint draw_to_texture(void)
{
    const GLuint texture = texture_of(GL_RGBA8, GL_RGBA);
    bind_new_framebuffer();
    attach_texture(GL_COLOR_ATTACHMENT0, texture);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, renderbuffer_of(GL_DEPTH_COMPONENT24, WIDTH, HEIGHT));
    glViewport(0, 0, WIDTH, HEIGHT);
    return texture;
}

static void clear(float r, float g, float b, float a)
{
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

static void rectangle(float x0, float y0, float x1, float y1, float z)
{
    glBegin(GL_QUADS);
    glVertex3f(x0, y0, z);
    glVertex3f(x1, y0, z);
    glVertex3f(x1, y1, z);
    glVertex3f(x0, y1, z);
    glEnd();
}

#define EXPECT_PIXEL(x, y, ...)                                                                              \
    do {                                                                                                     \
        const GLubyte expected_[] = {__VA_ARGS__};                                                           \
        GLubyte got_[4];                                                                                     \
        EXPECT_NO_ERROR(glReadPixels((x), (y), 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got_));                      \
        assert_memory_equal(got_, expected_, 4);                                                             \
    } while (0)

#define EXPECT_STATUS(status) assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), (status))

/* ---- names ---- */

static void names_become_objects_when_bound(void **state)
{
    (void)state;
    GLuint f[2], r[2];
    EXPECT_ERROR(GL_INVALID_VALUE, glGenFramebuffers(-1, f));
    EXPECT_ERROR(GL_INVALID_VALUE, glGenRenderbuffers(-1, r));
    EXPECT_NO_ERROR(glGenFramebuffers(2, f));
    EXPECT_NO_ERROR(glGenRenderbuffers(2, r));
    assert_true(f[0] && f[1] && f[0] != f[1] && r[0] && r[1] && r[0] != r[1]);
    assert_false(glIsFramebuffer(f[0]));
    assert_false(glIsRenderbuffer(r[0]));
    EXPECT_NO_ERROR(glBindFramebuffer(GL_FRAMEBUFFER, f[0]));
    EXPECT_NO_ERROR(glBindRenderbuffer(GL_RENDERBUFFER, r[0]));
    assert_true(glIsFramebuffer(f[0]) && !glIsFramebuffer(f[1]) && !glIsFramebuffer(0));
    assert_true(glIsRenderbuffer(r[0]) && !glIsRenderbuffer(r[1]) && !glIsRenderbuffer(0));
    EXPECT_INTS(GL_FRAMEBUFFER_BINDING, (GLint)f[0]);
    EXPECT_INTS(GL_READ_FRAMEBUFFER_BINDING, (GLint)f[0]);
    EXPECT_INTS(GL_RENDERBUFFER_BINDING, (GLint)r[0]);
    EXPECT_ERROR(GL_INVALID_ENUM, glBindFramebuffer(GL_TEXTURE_2D, f[1]));
    EXPECT_ERROR(GL_INVALID_ENUM, glBindRenderbuffer(GL_FRAMEBUFFER, r[1]));
    EXPECT_NO_ERROR(glBindFramebuffer(GL_FRAMEBUFFER, 77)); /* any name will do */
    EXPECT_NO_ERROR(glBindRenderbufferEXT(GL_RENDERBUFFER, 77));
    EXPECT_INTS(GL_FRAMEBUFFER_BINDING, 77);
    EXPECT_NO_ERROR(glDeleteFramebuffers(1, (const GLuint[]){77}));
    EXPECT_NO_ERROR(glDeleteRenderbuffers(1, (const GLuint[]){77}));
    EXPECT_INTS(GL_FRAMEBUFFER_BINDING, 0);
    EXPECT_INTS(GL_RENDERBUFFER_BINDING, 0);
}

static void reading_and_drawing_are_bound_apart(void **state)
{
    (void)state;
    const GLuint f = bind_new_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_NO_ERROR(glBindFramebuffer(GL_READ_FRAMEBUFFER, f));
    EXPECT_INTS(GL_DRAW_FRAMEBUFFER_BINDING, 0);
    EXPECT_INTS(GL_READ_FRAMEBUFFER_BINDING, (GLint)f);
    EXPECT_INTS(GL_READ_BUFFER, GL_COLOR_ATTACHMENT0);
    EXPECT_INTS(GL_DRAW_BUFFER, GL_FRONT);
}

/* ---- renderbuffers ---- */

static void renderbuffers_keep_their_format(void **state)
{
    (void)state;
    GLint v;
    EXPECT_ERROR(GL_INVALID_OPERATION, glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &v));
    renderbuffer_of(GL_DEPTH24_STENCIL8, 6, 3);
    static const struct {
        GLenum name;
        GLint value;
    } expected[] = {
            {GL_RENDERBUFFER_WIDTH, 6},      {GL_RENDERBUFFER_HEIGHT, 3},       {GL_RENDERBUFFER_INTERNAL_FORMAT, GL_DEPTH24_STENCIL8},
            {GL_RENDERBUFFER_RED_SIZE, 0},   {GL_RENDERBUFFER_DEPTH_SIZE, 24},  {GL_RENDERBUFFER_STENCIL_SIZE, 8},
            {GL_RENDERBUFFER_ALPHA_SIZE, 0}, {GL_RENDERBUFFER_SAMPLES, 0},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        EXPECT_NO_ERROR(glGetRenderbufferParameteriv(GL_RENDERBUFFER, expected[i].name, &v));
        assert_int_equal(v, expected[i].value);
    }
    EXPECT_ERROR(GL_INVALID_ENUM, glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RED_BITS, &v));
    EXPECT_ERROR(GL_INVALID_ENUM, glRenderbufferStorage(GL_RENDERBUFFER, GL_COMPRESSED_RGBA, 4, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glRenderbufferStorage(GL_RENDERBUFFER, 4, 4, 4));
    EXPECT_ERROR(GL_INVALID_VALUE, glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, -1, 4));
    EXPECT_ERROR(GL_INVALID_VALUE, glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 1 << 20));
    EXPECT_ERROR(GL_INVALID_ENUM, glRenderbufferStorage(GL_FRAMEBUFFER, GL_RGBA8, 4, 4));
}

/* ---- attachments and completeness ---- */

static void attaching_checks_its_arguments(void **state)
{
    (void)state;
    const GLuint texture = texture_of(GL_RGBA8, GL_RGBA);
    EXPECT_ERROR(GL_INVALID_OPERATION, attach_texture(GL_COLOR_ATTACHMENT0, texture)); /* the window is bound */
    bind_new_framebuffer();
    EXPECT_ERROR(GL_INVALID_ENUM, glFramebufferTexture2D(GL_TEXTURE_2D, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0));
    EXPECT_ERROR(GL_INVALID_ENUM, attach_texture(GL_FRONT, texture));
    EXPECT_ERROR(GL_INVALID_OPERATION, attach_texture(GL_COLOR_ATTACHMENT0, 999));
    EXPECT_ERROR(GL_INVALID_VALUE, glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, -1));
    EXPECT_ERROR(GL_INVALID_OPERATION,
                 glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X, texture, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, glFramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, texture, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, attach_renderbuffer(GL_COLOR_ATTACHMENT0, 999));
    EXPECT_ERROR(GL_INVALID_ENUM, glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0));
    EXPECT_NO_ERROR(attach_texture(GL_COLOR_ATTACHMENT0, texture));
    GLint v;
    EXPECT_NO_ERROR(glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &v));
    assert_int_equal(v, GL_TEXTURE);
    EXPECT_NO_ERROR(glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &v));
    assert_int_equal(v, texture);
    EXPECT_ERROR(GL_INVALID_ENUM, glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RED_BITS, &v));
}

static GLint attachment_value(GLenum attachment, GLenum pname)
{
    GLint v = -1;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, pname, &v);
    return v;
}

static void the_window_has_attachments_of_its_own(void **state)
{
    (void)state;
    assert_int_equal(attachment_value(GL_BACK_LEFT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_FRAMEBUFFER_DEFAULT);
    assert_int_equal(attachment_value(GL_FRONT_RIGHT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), GL_NONE);
    assert_int_equal(attachment_value(GL_FRONT, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE), 8);
    assert_int_equal(attachment_value(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 24);
    assert_int_equal(attachment_value(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), 8);
    assert_int_equal(attachment_value(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING), GL_LINEAR);
    assert_int_equal(attachment_value(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), GL_UNSIGNED_NORMALIZED);
    EXPECT_NO_ERROR((void)0);
    EXPECT_ERROR(GL_INVALID_ENUM, attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE));
    EXPECT_ERROR(GL_INVALID_ENUM, attachment_value(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    EXPECT_ERROR(GL_INVALID_ENUM, attachment_value(GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL));
    EXPECT_ERROR(GL_INVALID_OPERATION, attachment_value(GL_FRONT_RIGHT, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE));
}

static void all_attachments_have_as_many_samples(void **state)
{
    GLint v = -1;
    (void)state;
    bind_new_framebuffer();
    glGetIntegerv(GL_MAX_SAMPLES, &v);
    assert_true(v >= 1);
    const GLuint one = renderbuffer_of(GL_RGBA8, 4, 4);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 1, GL_RGBA8, 4, 4);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &v);
    assert_true(v >= 1);
    const GLuint none = renderbuffer_of(GL_DEPTH24_STENCIL8, 4, 4);
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, one);
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, none);
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
    EXPECT_ERROR(GL_INVALID_VALUE, glRenderbufferStorageMultisample(GL_RENDERBUFFER, -1, GL_RGBA8, 4, 4));
    EXPECT_ERROR(GL_INVALID_ENUM, glRenderbufferStorageMultisample(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4));
}

/* They are drawn to as if they were not encoded; textures of them are decoded. */
static void srgb_images_are_drawn_to(void **state)
{
    GLubyte got[4];
    (void)state;
    const GLuint texture = texture_of(GL_SRGB8_ALPHA8_EXT, GL_RGBA);
    bind_new_framebuffer();
    attach_texture(GL_COLOR_ATTACHMENT0, texture);
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    assert_int_equal(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING), GL_SRGB_EXT);
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_true(got[0] == 51 && got[1] == 102 && got[2] == 153 && got[3] == 204);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glRectf(-1, -1, 1, 1);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    assert_true(got[0] == 8 && got[1] == 34 && got[2] == 81 && got[3] == 204); /* 0.2, 0.4, 0.6 by the curve */
}

/* The red of an image that was cleared to one colour, on which another was blended. */
static int blended_red(GLenum internal_format, float cleared, float red, float alpha, GLenum source, GLenum destination)
{
    GLubyte got[4] = {0};
    const GLuint texture = texture_of(internal_format, GL_RGBA);
    bind_new_framebuffer();
    attach_texture(GL_COLOR_ATTACHMENT0, texture);
    glClearColor(cleared, cleared, cleared, cleared);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(source, destination);
    glColor4f(red, red, red, alpha);
    glRectf(-1, -1, 1, 1);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, got);
    return got[0];
}

/* OSMesa rules: one component is blended with one rounding; a clear is rounded to 5 bits, what is drawn is cut off; formats without
 * alpha have 1. */
static void blending_depends_on_the_format(void **state)
{
    (void)state;
    assert_int_equal(blended_red(GL_RGBA8, 0.2f, 0.5f, 0.7f, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), 104);
    assert_int_equal(blended_red(GL_R8, 0.2f, 0.5f, 0.7f, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), 105);
    assert_int_equal(blended_red(GL_LUMINANCE8, 0.2f, 0.5f, 0.7f, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), 105);
    assert_int_equal(blended_red(GL_RGB5, 0.47f, 0.02f, 1, GL_ONE, GL_ONE), 132);
    assert_int_equal(blended_red(GL_RG8, 0.2f, 0.6f, 0.7f, GL_DST_ALPHA, GL_ZERO), 153);
    assert_int_equal(blended_red(GL_INTENSITY8, 0.2f, 0.6f, 0.7f, GL_DST_ALPHA, GL_ZERO), 153);
}

static void completeness_depends_on_attachments(void **state)
{
    (void)state;
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    bind_new_framebuffer();
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    attach_texture(GL_COLOR_ATTACHMENT0, texture_of(GL_RGBA8, GL_RGBA));
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION, glClear(GL_COLOR_BUFFER_BIT));
    GLuint empty;
    glGenTextures(1, &empty);
    glBindTexture(GL_TEXTURE_2D, empty);
    attach_texture(GL_COLOR_ATTACHMENT0, empty);
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION, glClear(GL_COLOR_BUFFER_BIT));
    attach_texture(GL_COLOR_ATTACHMENT0, 0);
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    attach_renderbuffer(GL_DEPTH_ATTACHMENT, renderbuffer_of(GL_DEPTH_COMPONENT16, 4, 4));
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    attach_renderbuffer(GL_STENCIL_ATTACHMENT, renderbuffer_of(GL_DEPTH_COMPONENT16, 4, 4));
    EXPECT_STATUS(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    GLubyte pixel[4];
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION, glClear(GL_COLOR_BUFFER_BIT));
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION, glRectf(0, 0, 1, 1));
    EXPECT_ERROR(GL_INVALID_FRAMEBUFFER_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel));
    EXPECT_ERROR(GL_INVALID_ENUM, glCheckFramebufferStatus(GL_TEXTURE_2D));
}

/* ---- drawing ---- */

static void drawing_goes_to_the_texture(void **state)
{
    (void)state;
    clear(0, 0, 1, 1);
    const GLuint texture = draw_to_texture();
    clear(0.2f, 0.4f, 0.6f, 0.8f);
    glEnable(GL_DEPTH_TEST);
    glColor4f(1, 0, 0, 1);
    rectangle(-1, -1, 0, 0, 0);
    glColor4f(0, 1, 0, 1);
    rectangle(-1, -1, 1, 0, 0.5f); /* behind the red one */
    EXPECT_PIXEL(0, 0, 255, 0, 0, 255);
    EXPECT_PIXEL(WIDTH - 1, 0, 0, 255, 0, 255);
    EXPECT_PIXEL(0, HEIGHT - 1, 51, 102, 153, 204);
    GLubyte texels[HEIGHT][WIDTH][4];
    EXPECT_NO_ERROR(glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels));
    assert_int_equal(texels[0][0][0], 255);
    assert_int_equal(texels[0][WIDTH - 1][1], 255);
    assert_int_equal(texels[HEIGHT - 1][0][3], 204);

    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_DEPTH_TEST);
    EXPECT_PIXEL(0, 0, 0, 0, 255, 255);
    glViewport(0, 0, TEST_SIZE, TEST_SIZE);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexCoord2f(0.01f, 0.01f);
    rectangle(-1, -1, 1, 1, 0);
    EXPECT_PIXEL(1, 1, 255, 0, 0, 255);
}

static void texels_are_seen_while_they_are_drawn_to(void **state)
{
    (void)state;
    draw_to_texture();
    clear(1, 0, 0, 1);
    const GLubyte green[4] = {0, 255, 0, 255};
    EXPECT_NO_ERROR(glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green));
    EXPECT_PIXEL(3, 2, 0, 255, 0, 255);
    EXPECT_PIXEL(2, 2, 255, 0, 0, 255);
    EXPECT_NO_ERROR(glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 3, 2, 1, 1));
    EXPECT_PIXEL(8, 8, 0, 255, 0, 255);
}

static void two_framebuffers_share_a_renderbuffer(void **state)
{
    (void)state;
    const GLuint color = renderbuffer_of(GL_RGBA8, 4, 4);
    bind_new_framebuffer();
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, color);
    clear(1, 0, 0, 1);
    const GLuint other = bind_new_framebuffer();
    attach_renderbuffer(GL_COLOR_ATTACHMENT3, color);
    EXPECT_NO_ERROR(glReadBuffer(GL_COLOR_ATTACHMENT3));
    EXPECT_PIXEL(0, 0, 255, 0, 0, 255);
    EXPECT_NO_ERROR(glDrawBuffer(GL_COLOR_ATTACHMENT3));
    clear(0, 1, 0, 1);
    EXPECT_PIXEL(3, 3, 0, 255, 0, 255);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawBuffer(GL_BACK));
    EXPECT_NO_ERROR(glDrawBuffer(GL_NONE));
    clear(0, 0, 1, 1);
    EXPECT_PIXEL(3, 3, 0, 255, 0, 255);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawBuffer(GL_COLOR_ATTACHMENT0));
    EXPECT_INTS(GL_DRAW_BUFFER, GL_FRONT);
    glBindFramebuffer(GL_FRAMEBUFFER, other);
    EXPECT_INTS(GL_DRAW_BUFFER, GL_NONE);
    EXPECT_INTS(GL_READ_BUFFER, GL_COLOR_ATTACHMENT3);
}

static void stencil_is_kept(void **state)
{
    (void)state;
    const GLuint both = renderbuffer_of(GL_DEPTH24_STENCIL8, 4, 4);
    const GLuint f = bind_new_framebuffer();
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, renderbuffer_of(GL_RGB8, 4, 4));
    EXPECT_NO_ERROR(attach_renderbuffer(GL_DEPTH_STENCIL_ATTACHMENT, both));
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    EXPECT_INTS(GL_STENCIL_BITS, 8);
    EXPECT_INTS(GL_DEPTH_BITS, 24);
    EXPECT_INTS(GL_ALPHA_BITS, 0);
    glClearStencil(5);
    glClearDepth(0.25);
    clear(0, 0, 0, 0.5f);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    GLubyte stencil;
    GLfloat depth;
    EXPECT_NO_ERROR(glReadPixels(1, 1, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil));
    EXPECT_NO_ERROR(glReadPixels(1, 1, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth));
    assert_int_equal(stencil, 5);
    assert_true(depth > 0.2499999f && depth < 0.2500001f);
    EXPECT_PIXEL(0, 0, 0, 0, 0, 255); /* without alpha */
}

static void depth_alone_can_be_drawn(void **state)
{
    (void)state;
    const GLuint texture = texture_of(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT);
    bind_new_framebuffer();
    attach_texture(GL_DEPTH_ATTACHMENT, texture);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    glViewport(0, 0, WIDTH, HEIGHT);
    glEnable(GL_DEPTH_TEST);
    EXPECT_NO_ERROR(clear(0, 0, 0, 0));
    EXPECT_NO_ERROR(rectangle(-1, -1, 1, 0, -1));
    GLfloat depth[HEIGHT][WIDTH];
    EXPECT_NO_ERROR(glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth));
    assert_true(depth[0][0] == 0 && depth[HEIGHT - 1][0] == 1);
    GLubyte pixel[4];
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel));
}

static void deleting_detaches_from_the_bound_one(void **state)
{
    (void)state;
    const GLuint texture = draw_to_texture();
    clear(1, 1, 1, 1);
    glDeleteTextures(1, &texture);
    GLint type;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    assert_int_equal(type, GL_NONE);
    const GLuint kept = texture_of(GL_RGBA8, GL_RGBA);
    const GLuint f = bind_new_framebuffer();
    attach_texture(GL_COLOR_ATTACHMENT0, kept);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteTextures(1, &kept); /* still attached there, and drawn to */
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    EXPECT_STATUS(GL_FRAMEBUFFER_COMPLETE);
    clear(0, 1, 1, 1);
    EXPECT_PIXEL(0, 0, 0, 255, 255, 255);
    EXPECT_NO_ERROR(glDeleteFramebuffers(1, &f));
    EXPECT_INTS(GL_FRAMEBUFFER_BINDING, 0);
    EXPECT_INTS(GL_DRAW_BUFFER, GL_FRONT);
}

/* ---- copies ---- */

static void blit_turns_over_and_scales(void **state)
{
    (void)state;
    draw_to_texture();
    clear(0, 0, 0, 1);
    glColor3f(1, 0, 0);
    rectangle(-1, -1, -0.5f, 0, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    clear(0, 0, 1, 1);
    EXPECT_NO_ERROR(glBlitFramebuffer(0, 0, WIDTH, HEIGHT, 2 * WIDTH, 2 * HEIGHT, 0, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    EXPECT_PIXEL(2 * WIDTH - 1, 2 * HEIGHT - 1, 255, 0, 0, 255);
    EXPECT_PIXEL(2 * WIDTH - WIDTH / 2, HEIGHT, 255, 0, 0, 255);
    EXPECT_PIXEL(2 * WIDTH - WIDTH / 2 - 1, HEIGHT, 0, 0, 0, 255);
    EXPECT_PIXEL(0, 0, 0, 0, 0, 255);
    EXPECT_PIXEL(2 * WIDTH, 0, 0, 0, 255, 255);
    EXPECT_ERROR(GL_INVALID_ENUM, glBlitFramebuffer(0, 0, 1, 1, 2, 2, 3, 3, GL_COLOR_BUFFER_BIT, GL_REPEAT));
    EXPECT_ERROR(GL_INVALID_VALUE, glBlitFramebuffer(0, 0, 1, 1, 2, 2, 3, 3, GL_ACCUM_BUFFER_BIT, GL_NEAREST));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBlitFramebuffer(0, 0, 1, 1, 2, 2, 3, 3, GL_DEPTH_BUFFER_BIT, GL_LINEAR));
}

static void mipmaps_are_made_on_demand(void **state)
{
    (void)state;
    draw_to_texture();
    clear(0.2f, 0.4f, 0.6f, 0.8f);
    EXPECT_NO_ERROR(glGenerateMipmap(GL_TEXTURE_2D));
    GLubyte texels[HEIGHT / 2][WIDTH / 2][4];
    EXPECT_NO_ERROR(glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels));
    assert_int_equal(texels[5][9][2], 153);
    EXPECT_ERROR(GL_INVALID_ENUM, glGenerateMipmap(GL_TEXTURE_CUBE_MAP_POSITIVE_X));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(names_become_objects_when_bound),  GL_TEST(reading_and_drawing_are_bound_apart),
            GL_TEST(renderbuffers_keep_their_format),  GL_TEST(attaching_checks_its_arguments),
            GL_TEST(the_window_has_attachments_of_its_own),
            GL_TEST(all_attachments_have_as_many_samples),
            GL_TEST(srgb_images_are_drawn_to),
            GL_TEST(blending_depends_on_the_format),
            GL_TEST(completeness_depends_on_attachments), GL_TEST(drawing_goes_to_the_texture),
            GL_TEST(texels_are_seen_while_they_are_drawn_to), GL_TEST(two_framebuffers_share_a_renderbuffer),
            GL_TEST(stencil_is_kept),                  GL_TEST(depth_alone_can_be_drawn),
            GL_TEST(deleting_detaches_from_the_bound_one), GL_TEST(blit_turns_over_and_scales),
            GL_TEST(mipmaps_are_made_on_demand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
