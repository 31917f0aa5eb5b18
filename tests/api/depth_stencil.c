/* Depth and stencil in one pixel (GL_EXT_packed_depth_stencil). */
#include "api/gl_test.h"

enum { N = 4 };
static const GLuint given[N] = {0x89abcd11, 0x1234567f, 0xffffff00, 0x000001fe};

#define EXPECT_PIXELS(...)                                                                                   \
    do {                                                                                                     \
        const GLuint expected_[N] = {__VA_ARGS__};                                                           \
        GLuint got_[N] = {0};                                                                                \
        glReadPixels(0, 0, N, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, got_);                              \
        assert_memory_equal(got_, expected_, sizeof got_);                                                   \
    } while (0)

static void clear_and_draw(void)
{
    glPushAttrib(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glStencilMask(0xff);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClearStencil(3);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glPopAttrib();
    glWindowPos2i(0, 0);
    glDrawPixels(N, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given);
}

/* Neither tests nor colour: the masks and the scissor alone. */
static void only_masks_and_scissor_apply(void **state)
{
    (void)state;
    clear_and_draw();
    EXPECT_PIXELS(0x89abcd11, 0x1234567f, 0xffffff00, 0x000001fe);
    glFinish();
    assert_int_equal(picture[0], 0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 255);
    clear_and_draw();
    EXPECT_PIXELS(0x89abcd11, 0x1234567f, 0xffffff00, 0x000001fe);
    glStencilMask(0x0f);
    clear_and_draw();
    EXPECT_PIXELS(0x89abcd01, 0x1234560f, 0xffffff00, 0x0000010e);
    glStencilMask(0xff);
    glDepthMask(GL_FALSE);
    clear_and_draw();
    EXPECT_PIXELS(0xffffff11, 0xffffff7f, 0xffffff00, 0xfffffffe);
}

static void pixels_are_copied(void **state)
{
    (void)state;
    clear_and_draw();
    glWindowPos2i(1, 0);
    glCopyPixels(0, 0, 2, 1, GL_DEPTH_STENCIL);
    EXPECT_PIXELS(0x89abcd11, 0x89abcd11, 0x1234567f, 0x000001fe);
    EXPECT_ERROR(GL_INVALID_ENUM, glCopyPixels(0, 0, 1, 1, GL_DEPTH_STENCIL_ATTACHMENT));
}

static void reading_transfers(void **state)
{
    GLuint got[N];
    (void)state;
    clear_and_draw();
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    glPixelTransferf(GL_DEPTH_SCALE, 0);
    glReadPixels(0, 0, N, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, got);
    assert_int_equal(got[0], 0x13);
    assert_int_equal(got[3], 0x00);
}

static GLint level_value(GLenum pname)
{
    GLint v = -1;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, pname, &v);
    return v;
}

static void textures_keep_both(void **state)
{
    GLuint got[N] = {0};
    GLfloat depth[N];
    (void)state;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, N, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given);
    assert_int_equal(level_value(GL_TEXTURE_DEPTH_SIZE), 24);
    assert_int_equal(level_value(GL_TEXTURE_STENCIL_SIZE), 8);
    assert_int_equal(level_value(GL_TEXTURE_INTERNAL_FORMAT), GL_DEPTH24_STENCIL8);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, got);
    assert_memory_equal(got, given, sizeof got);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    assert_true(depth[2] == 1.0f);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given);
    clear_and_draw();
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 0, 1, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, got);
    assert_int_equal(got[0], 0xffffff00);
    assert_int_equal(got[1], 0x89abcd11);
}

static void a_texture_is_both_attachments(void **state)
{
    GLuint texture, framebuffer;
    GLint v = 0;
    (void)state;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, N, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    EXPECT_PIXELS(0x89abcd11, 0x1234567f, 0xffffff00, 0x000001fe);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &v);
    assert_int_equal(v, texture);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &v);
    assert_int_equal(v, 8);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &v);
    assert_int_equal(v, 24);
    glClearStencil(7);
    glClear(GL_STENCIL_BUFFER_BIT);
    EXPECT_PIXELS(0x89abcd07, 0x12345607, 0xffffff07, 0x00000107);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    GLuint got[N];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, got);
    assert_int_equal(got[1], 0x12345607);
}

static void lists_keep_pixels(void **state)
{
    GLuint pixels[N];
    (void)state;
    memcpy(pixels, given, sizeof pixels);
    glNewList(1, GL_COMPILE);
    glDrawPixels(N, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pixels);
    glEndList();
    memset(pixels, 0, sizeof pixels);
    glWindowPos2i(0, 0);
    glCallList(1);
    EXPECT_PIXELS(0x89abcd11, 0x1234567f, 0xffffff00, 0x000001fe);
}

static void formats_and_types_must_go_together(void **state)
{
    static GLuint out[16];
    (void)state;
    EXPECT_ERROR(GL_INVALID_ENUM, glDrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT, given));
    EXPECT_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT, out));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_INT_24_8, given));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT_24_8, out));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 1, 1, 0, GL_RGBA, GL_FLOAT, given));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH24_STENCIL8, 1, 1, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given));
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, out));
}

static void both_buffers_are_needed(void **state)
{
    static GLuint out[4];
    (void)state;
    OSMesaContext before = OSMesaGetCurrentContext(), depth_only = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_non_null(depth_only);
    OSMesaMakeCurrent(depth_only, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, given));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, out));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyPixels(0, 0, 1, 1, GL_DEPTH_STENCIL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 0, 0, 1, 1, 0));
    OSMesaDestroyContext(depth_only);
    OSMesaMakeCurrent(before, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(only_masks_and_scissor_apply),  GL_TEST(pixels_are_copied), GL_TEST(reading_transfers),
            GL_TEST(textures_keep_both),            GL_TEST(a_texture_is_both_attachments),
            GL_TEST(lists_keep_pixels),             GL_TEST(formats_and_types_must_go_together),
            GL_TEST(both_buffers_are_needed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
