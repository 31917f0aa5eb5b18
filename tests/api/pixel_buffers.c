/* Pixels in buffer objects (GL_ARB_pixel_buffer_object), and parts of them mapped (GL_ARB_map_buffer_range). */
#include "api/gl_test.h"

enum { SIZE = 256 };

/* A buffer of SIZE bytes 0, 1, 2, ... bound to the target. */
static GLuint buffer_for(GLenum target)
{
    GLubyte bytes[SIZE];
    GLuint name;
    for (int i = 0; i < SIZE; i++)
        bytes[i] = (GLubyte)i;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, SIZE, bytes, GL_STREAM_DRAW);
    return name;
}

static const GLubyte *bytes_of(GLenum target)
{
    static GLubyte bytes[SIZE];
    glGetBufferSubData(target, 0, SIZE, bytes);
    return bytes;
}

#define OFFSET(n) ((GLvoid *)(uintptr_t)(n))

static void pixels_are_drawn_from_a_buffer(void **state)
{
    (void)state;
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    glWindowPos2i(0, 0);
    glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glWindowPos2i(0, 1);
    glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(8));
    glFinish();
    assert_int_equal(picture[5], 5);
    assert_int_equal(picture[4 * TEST_SIZE + 5], 13);
}

static void pixels_are_read_into_a_buffer(void **state)
{
    (void)state;
    buffer_for(GL_PIXEL_PACK_BUFFER);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(100));
    const GLubyte *got = bytes_of(GL_PIXEL_PACK_BUFFER);
    assert_int_equal(got[99], 99);
    assert_int_equal(got[100], 255);
    assert_int_equal(got[105], 0);
    assert_int_equal(got[108], 108);
}

static void images_are_unpacked_and_packed(void **state)
{
    GLubyte texels[16];
    (void)state;
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL); /* offset 0 */
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(200));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    assert_int_equal(texels[7], 7);
    assert_int_equal(texels[12], 200);
    buffer_for(GL_PIXEL_PACK_BUFFER);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(32));
    assert_int_equal(bytes_of(GL_PIXEL_PACK_BUFFER)[32 + 12], 200);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    EXPECT_NO_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL)); /* no pixels */
}

static void maps_and_stipples_too(void **state)
{
    GLfloat map[4] = {0};
    GLubyte stipple[128];
    (void)state;
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    const GLuint values[4] = {0, 0xffffffff, 0, 0xffffffff};
    glBufferSubData(GL_PIXEL_UNPACK_BUFFER, 16, sizeof values, values);
    glPixelMapuiv(GL_PIXEL_MAP_R_TO_R, 4, OFFSET(16));
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, map);
    assert_true(map[1] == 1.0f && map[2] == 0.0f);
    glPolygonStipple(OFFSET(64));
    glGetPolygonStipple(stipple);
    assert_int_equal(stipple[5], 69);
    buffer_for(GL_PIXEL_PACK_BUFFER);
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, OFFSET(4));
    glGetPolygonStipple(OFFSET(128));
    const GLubyte *got = bytes_of(GL_PIXEL_PACK_BUFFER);
    memcpy(map, got + 4, sizeof map);
    assert_true(map[3] == 1.0f);
    assert_int_equal(got[128 + 5], 69);
}

/* They are compiled with what the buffer holds then. */
static void lists_keep_what_was_in_the_buffer(void **state)
{
    (void)state;
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    glNewList(1, GL_COMPILE);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(40));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(80));
    glBitmap(8, 1, 0, 0, 0, 0, OFFSET(255));
    glEndList();
    glBufferData(GL_PIXEL_UNPACK_BUFFER, 4, NULL, GL_STREAM_DRAW);
    glWindowPos2i(0, 0);
    EXPECT_NO_ERROR(glCallList(1));
    glFinish();
    GLubyte texel[4];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    assert_int_equal(texel[1], 81);
    assert_int_equal(picture[4], 255);
}

static void pixels_outside_of_the_buffer_are_refused(void **state)
{
    (void)state;
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    glWindowPos2i(0, 0);
    EXPECT_NO_ERROR(glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(1)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(8, 9, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(-4)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_SHORT, OFFSET(1)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glBitmap(16, 65, 0, 0, 0, 0, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_NO_ERROR(glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(253)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 64, OFFSET(4)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glPolygonStipple(OFFSET(129)));
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 8);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(8, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0x7fffffff);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0x7fffffff);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(2, 2, GL_RGBA, GL_FLOAT, NULL));
}

static void reading_past_the_buffer_is_refused(void **state)
{
    (void)state;
    buffer_for(GL_PIXEL_PACK_BUFFER);
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 9, 8, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(254)));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    EXPECT_NO_ERROR(glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, OFFSET(4)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, OFFSET(256)));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGetPolygonStipple(OFFSET(200)));
    assert_int_equal(bytes_of(GL_PIXEL_PACK_BUFFER)[255], 0); /* of the image, the rest is as it was */
}

static void a_mapped_buffer_is_refused(void **state)
{
    (void)state;
    glWindowPos2i(0, 0);
    buffer_for(GL_PIXEL_UNPACK_BUFFER);
    glMapBuffer(GL_PIXEL_UNPACK_BUFFER, GL_READ_ONLY);
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER);
    EXPECT_NO_ERROR(glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
    buffer_for(GL_PIXEL_PACK_BUFFER);
    glMapBuffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL));
}

static void bindings_belong_to_the_pixel_store(void **state)
{
    (void)state;
    const GLuint unpack = buffer_for(GL_PIXEL_UNPACK_BUFFER), pack = buffer_for(GL_PIXEL_PACK_BUFFER);
    EXPECT_INTS(GL_PIXEL_UNPACK_BUFFER_BINDING, (GLint)unpack);
    EXPECT_INTS(GL_PIXEL_PACK_BUFFER_BINDING, (GLint)pack);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, unpack);
    glPopClientAttrib();
    EXPECT_INTS(GL_PIXEL_UNPACK_BUFFER_BINDING, (GLint)unpack);
    EXPECT_INTS(GL_PIXEL_PACK_BUFFER_BINDING, (GLint)pack);
    glDeleteBuffers(1, &pack);
    EXPECT_INTS(GL_PIXEL_PACK_BUFFER_BINDING, 0);
}

static GLint buffer_value(GLenum pname)
{
    GLint v = -1;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, pname, &v);
    return v;
}

static void a_part_is_mapped(void **state)
{
    GLvoid *pointer = NULL;
    (void)state;
    buffer_for(GL_ARRAY_BUFFER);
    GLubyte *bytes = glMapBufferRange(GL_ARRAY_BUFFER, 16, 32, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
    assert_non_null(bytes);
    bytes[1] = 99;
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    assert_ptr_equal(pointer, bytes);
    assert_int_equal(buffer_value(GL_BUFFER_MAP_OFFSET), 16);
    assert_int_equal(buffer_value(GL_BUFFER_MAP_LENGTH), 32);
    assert_int_equal(buffer_value(GL_BUFFER_ACCESS_FLAGS), GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
    assert_int_equal(buffer_value(GL_BUFFER_ACCESS), GL_WRITE_ONLY);
    EXPECT_NO_ERROR(glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 32));
    EXPECT_ERROR(GL_INVALID_VALUE, glFlushMappedBufferRange(GL_ARRAY_BUFFER, 1, 32));
    EXPECT_ERROR(GL_INVALID_VALUE, glFlushMappedBufferRange(GL_ARRAY_BUFFER, -1, 1));
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 1, GL_MAP_READ_BIT));
    assert_true(glUnmapBuffer(GL_ARRAY_BUFFER));
    assert_int_equal(bytes_of(GL_ARRAY_BUFFER)[17], 99);
    EXPECT_ERROR(GL_INVALID_OPERATION, glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 1));
}

static void parts_that_cannot_be_mapped(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 1, GL_MAP_READ_BIT));
    EXPECT_ERROR(GL_INVALID_ENUM, glMapBufferRange(GL_TEXTURE_2D, 0, 1, GL_MAP_READ_BIT));
    buffer_for(GL_ARRAY_BUFFER);
    EXPECT_ERROR(GL_INVALID_VALUE, glMapBufferRange(GL_ARRAY_BUFFER, -1, 1, GL_MAP_READ_BIT));
    EXPECT_ERROR(GL_INVALID_VALUE, glMapBufferRange(GL_ARRAY_BUFFER, 0, -1, GL_MAP_READ_BIT));
    EXPECT_ERROR(GL_INVALID_VALUE, glMapBufferRange(GL_ARRAY_BUFFER, 250, 10, GL_MAP_READ_BIT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 0, GL_MAP_READ_BIT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 1, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 1, GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT));
    EXPECT_ERROR(GL_INVALID_OPERATION, glMapBufferRange(GL_ARRAY_BUFFER, 0, 1, GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(pixels_are_drawn_from_a_buffer),
            GL_TEST(pixels_are_read_into_a_buffer),
            GL_TEST(images_are_unpacked_and_packed),
            GL_TEST(maps_and_stipples_too),
            GL_TEST(lists_keep_what_was_in_the_buffer),
            GL_TEST(pixels_outside_of_the_buffer_are_refused),
            GL_TEST(reading_past_the_buffer_is_refused),
            GL_TEST(a_mapped_buffer_is_refused),
            GL_TEST(bindings_belong_to_the_pixel_store),
            GL_TEST(a_part_is_mapped),
            GL_TEST(parts_that_cannot_be_mapped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
