/* Errors of the commands that draw, read, record, evaluate, select and save: every one that their sections name, in the order of the
 * specification. Where OSMesa differs is said. GL_INVALID_OPERATION between glBegin and glEnd is begin_end_errors.c. */
#include "api/refused.h"

static GLubyte bytes[4096];

/* GL 1.5, 2.6 to 2.10 */
static void primitives(void **state)
{
    (void)state;
    if (on_fixedgl()) /* OSMesa knows lines with adjacency, as GL 3.2 does */
        REFUSED(GL_INVALID_ENUM, glBegin(GL_POLYGON + 1));
    REFUSED(GL_INVALID_OPERATION, glEnd());
    REFUSED(GL_INVALID_ENUM, glDrawArrays(GL_POLYGON + 6, 0, 1));
    REFUSED(GL_INVALID_VALUE, glDrawArrays(GL_POINTS, 0, -1));
    REFUSED(GL_INVALID_ENUM, glDrawElements(GL_POLYGON + 6, 1, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_VALUE, glDrawElements(GL_POINTS, -1, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_ENUM, glDrawElements(GL_POINTS, 1, GL_BYTE, bytes));
    REFUSED(GL_INVALID_ENUM, glDrawElements(GL_POINTS, 1, GL_FLOAT, bytes));
}

/* GL 1.5, 2.11.2 */
static void matrix_stacks(void **state)
{
    (void)state;
    static const struct {
        GLenum mode;
        int depth;
    } stacks[] = {{GL_MODELVIEW, 32}, {GL_PROJECTION, 32}, {GL_TEXTURE, 10}};
    for (int i = 0; i < 3; i++) {
        glMatrixMode(stacks[i].mode);
        REFUSED(GL_STACK_UNDERFLOW, glPopMatrix());
        for (int k = 1; k < stacks[i].depth; k++)
            EXPECT_NO_ERROR(glPushMatrix());
        REFUSED(GL_STACK_OVERFLOW, glPushMatrix());
    }
}

/* GL 1.5, 3.6.1, 3.6.3 */
static void pixel_state(void **state)
{
    (void)state;
    const GLfloat f[4] = {0};
    const GLuint u[4] = {0};
    const GLushort s[4] = {0};
    GLfloat got[4];
    REFUSED(GL_INVALID_ENUM, glPixelTransferf(GL_ZOOM_X, 1));
    REFUSED(GL_INVALID_ENUM, glPixelTransferi(GL_PACK_ALIGNMENT, 1));
    for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; map++) {
        REFUSED(GL_INVALID_VALUE, glPixelMapfv(map, 0, f));
        REFUSED(GL_INVALID_VALUE, glPixelMapuiv(map, -1, u));
        REFUSED(GL_INVALID_VALUE, glPixelMapusv(map, 257, s));
        if (map > GL_PIXEL_MAP_I_TO_A)
            EXPECT_NO_ERROR(glPixelMapfv(map, 3, f));
        else if (on_fixedgl() || map > GL_PIXEL_MAP_I_TO_I) /* OSMesa does not ask it of this one */
            REFUSED(GL_INVALID_VALUE, glPixelMapfv(map, 3, f));
    }
    REFUSED(GL_INVALID_ENUM, glPixelMapfv(GL_PIXEL_MAP_I_TO_I - 1, 1, f));
    REFUSED(GL_INVALID_ENUM, glPixelMapfv(GL_PIXEL_MAP_A_TO_A + 1, 1, f));
    REFUSED(GL_INVALID_ENUM, glGetPixelMapfv(GL_PIXEL_MAP_I_TO_I_SIZE, got));
}

/* GL 1.5, 3.6.4: the format and the type of an image. */
struct image_error {
    GLenum format, type, error;
};
static const struct image_error image_errors[] = {
        {GL_RGBA + 0x1000, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_RGBA, GL_DOUBLE, GL_INVALID_ENUM},
        {GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
        {GL_DEPTH_COMPONENT, GL_BITMAP, GL_INVALID_ENUM},
        {GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
        {GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, GL_INVALID_OPERATION},
        {GL_RGB, GL_UNSIGNED_INT_8_8_8_8, GL_INVALID_OPERATION},
        {GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, GL_INVALID_OPERATION},
        {GL_LUMINANCE, GL_UNSIGNED_INT_2_10_10_10_REV, GL_INVALID_OPERATION},
        {GL_ABGR_EXT, GL_UNSIGNED_INT_2_10_10_10_REV, GL_INVALID_OPERATION}, /* an OSMesa rule: not fields of several sizes */
        {GL_ABGR_EXT, GL_UNSIGNED_SHORT_5_5_5_1, GL_INVALID_OPERATION},
        {GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE_2_3_3_REV, GL_INVALID_OPERATION},
};

static void images(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof image_errors / sizeof *image_errors; i++) {
        const struct image_error *e = &image_errors[i];
        REFUSED(e->error, glDrawPixels(1, 1, e->format, e->type, bytes));
        REFUSED(e->error, glReadPixels(0, 0, 1, 1, e->format, e->type, bytes));
    }
    REFUSED(GL_INVALID_VALUE, glDrawPixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_VALUE, glDrawPixels(1, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_VALUE, glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_VALUE, glReadPixels(0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes));
    REFUSED(GL_INVALID_VALUE, glCopyPixels(0, 0, -1, 1, GL_COLOR));
    if (on_fixedgl()) { /* OSMesa crashes */
        EXPECT_ERROR(GL_OUT_OF_MEMORY, glCopyPixels(0, 0, INT32_MAX, 1, GL_COLOR));
        EXPECT_ERROR(GL_OUT_OF_MEMORY, glCopyPixels(0, 0, INT32_MAX, INT32_MAX, GL_COLOR));
    }
    REFUSED(GL_INVALID_VALUE, glCopyPixels(0, 0, 1, -1, GL_DEPTH));
    REFUSED(GL_INVALID_ENUM, glCopyPixels(0, 0, 1, 1, GL_RGBA));
    REFUSED(GL_INVALID_VALUE, glBitmap(-1, 1, 0, 0, 0, 0, bytes));
    REFUSED(GL_INVALID_VALUE, glBitmap(1, -1, 0, 0, 0, 0, bytes));
    REFUSED(GL_INVALID_ENUM, glAccum(GL_REPLACE, 1));
}

/* Buffers that the framebuffer does not have (3.6.4, 4.2.4, 4.3.2). */
static void missing_buffers(void **state)
{
    (void)state;
    OSMesaContext bare = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    static GLubyte pixels[4 * 4 * 4];
    assert_true(bare && OSMesaMakeCurrent(bare, pixels, GL_UNSIGNED_BYTE, 4, 4));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, bytes));
    EXPECT_ERROR(GL_INVALID_OPERATION, glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes));
    EXPECT_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyPixels(0, 0, 1, 1, GL_DEPTH));
    EXPECT_ERROR(GL_INVALID_OPERATION, glCopyPixels(0, 0, 1, 1, GL_STENCIL));
    EXPECT_ERROR(GL_INVALID_OPERATION, glAccum(GL_LOAD, 1));
    OSMesaDestroyContext(bare);
}

/* GL 1.5, 5.1 */
static void evaluators(void **state)
{
    (void)state;
    static const GLfloat f[1024];
    static const GLdouble d[1024];
    GLfloat got[64];
    GLint order[2];
    static const struct {
        GLenum target;
        int components;
    } maps[] = {{GL_MAP1_COLOR_4, 4}, {GL_MAP1_INDEX, 1}, {GL_MAP1_NORMAL, 3}, {GL_MAP1_TEXTURE_COORD_2, 2}, {GL_MAP1_VERTEX_3, 3},
                {GL_MAP1_VERTEX_4, 4}};
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        const GLenum one = maps[i].target, two = one - GL_MAP1_COLOR_4 + GL_MAP2_COLOR_4;
        const int k = maps[i].components;
        REFUSED(GL_INVALID_VALUE, glMap1f(one, 1, 1, k, 2, f));
        REFUSED(GL_INVALID_VALUE, glMap1d(one, 0, 1, k - 1, 2, d));
        REFUSED(GL_INVALID_VALUE, glMap1f(one, 0, 1, k, 0, f));
        REFUSED(GL_INVALID_VALUE, glMap1f(one, 0, 1, k, 31, f));
        REFUSED(GL_INVALID_VALUE, glMap2f(two, 1, 1, k, 2, 0, 1, k, 2, f));
        REFUSED(GL_INVALID_VALUE, glMap2f(two, 0, 1, k, 2, 3, 3, k, 2, f));
        REFUSED(GL_INVALID_VALUE, glMap2f(two, 0, 1, k - 1, 2, 0, 1, k, 2, f));
        REFUSED(GL_INVALID_VALUE, glMap2d(two, 0, 1, k, 2, 0, 1, k - 1, 2, d));
        REFUSED(GL_INVALID_VALUE, glMap2f(two, 0, 1, k, 0, 0, 1, k, 2, f));
        REFUSED(GL_INVALID_VALUE, glMap2f(two, 0, 1, k, 2, 0, 1, k, 31, f));
        REFUSED(GL_INVALID_ENUM, glMap1f(two, 0, 1, k, 2, f));
        REFUSED(GL_INVALID_ENUM, glMap2f(one, 0, 1, k, 2, 0, 1, k, 2, f));
        REFUSED(GL_INVALID_ENUM, glGetMapfv(one, GL_COEFF + 7, got));
    }
    REFUSED(GL_INVALID_ENUM, glGetMapiv(GL_MAP1_GRID_DOMAIN, GL_ORDER, order));
    REFUSED(GL_INVALID_VALUE, glMapGrid1f(0, 0, 1));
    REFUSED(GL_INVALID_VALUE, glMapGrid2d(0, 0, 1, 1, 0, 1));
    REFUSED(GL_INVALID_VALUE, glMapGrid2f(1, 0, 1, 0, 0, 1));
    REFUSED(GL_INVALID_ENUM, glEvalMesh1(GL_FILL, 0, 1));
    REFUSED(GL_INVALID_ENUM, glEvalMesh2(GL_FILL + 1, 0, 1, 0, 1));
}

/* GL 1.5, 5.2, 5.3 */
static void selection_and_feedback(void **state)
{
    (void)state;
    static GLuint hits[64];
    static GLfloat values[64];
    REFUSED(GL_INVALID_ENUM, glRenderMode(GL_RENDER + 3));
    REFUSED(GL_INVALID_VALUE, glSelectBuffer(-1, hits));
    REFUSED(GL_INVALID_VALUE, glFeedbackBuffer(-1, GL_2D, values));
    REFUSED(GL_INVALID_ENUM, glFeedbackBuffer(64, GL_4D_COLOR_TEXTURE + 1, values));
    EXPECT_NO_ERROR(glPopName()); /* ignored in this mode, as are the others */
    glSelectBuffer(64, hits);
    glFeedbackBuffer(64, GL_2D, values);
    glRenderMode(GL_SELECT);
    REFUSED(GL_INVALID_OPERATION, glSelectBuffer(64, hits));
    REFUSED(GL_INVALID_OPERATION, glLoadName(1));
    REFUSED(GL_STACK_UNDERFLOW, glPopName());
    for (int i = 0; i < 64; i++)
        EXPECT_NO_ERROR(glPushName(7));
    REFUSED(GL_STACK_OVERFLOW, glPushName(7));
    glRenderMode(GL_FEEDBACK);
    REFUSED(GL_INVALID_OPERATION, glFeedbackBuffer(64, GL_2D, values));
    glRenderMode(GL_RENDER);
}

/* GL 1.5, 5.4 */
static void lists(void **state)
{
    (void)state;
    REFUSED(GL_INVALID_VALUE, glNewList(0, GL_COMPILE));
    REFUSED(GL_INVALID_ENUM, glNewList(1, GL_COMPILE_AND_EXECUTE + 1));
    REFUSED(GL_INVALID_OPERATION, glEndList());
    REFUSED(GL_INVALID_VALUE, assert_int_equal(glGenLists(-1), 0));
    REFUSED(GL_INVALID_VALUE, glDeleteLists(1, -1));
    REFUSED(GL_INVALID_VALUE, glCallLists(-1, GL_BYTE, bytes));
    REFUSED(GL_INVALID_ENUM, glCallLists(1, GL_4_BYTES + 1, bytes));
    glNewList(1, GL_COMPILE);
    EXPECT_ERROR(GL_INVALID_OPERATION, glNewList(2, GL_COMPILE));
    glEndList();
    if (on_fixedgl()) /* OSMesa: GL_INVALID_VALUE, as GL 4 has it */
        EXPECT_NO_ERROR(glCallList(0));
    EXPECT_NO_ERROR(glCallList(999));
}

/* GL 1.5, 6.1.14 */
static void attribute_stacks(void **state)
{
    (void)state;
    REFUSED(GL_STACK_UNDERFLOW, glPopAttrib());
    REFUSED(GL_STACK_UNDERFLOW, glPopClientAttrib());
    for (int i = 0; i < 16; i++) {
        EXPECT_NO_ERROR(glPushAttrib(GL_ALL_ATTRIB_BITS));
        EXPECT_NO_ERROR(glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS));
    }
    REFUSED(GL_STACK_OVERFLOW, glPushAttrib(GL_CURRENT_BIT));
    REFUSED(GL_STACK_OVERFLOW, glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(primitives),      GL_TEST(matrix_stacks), GL_TEST(pixel_state),
            GL_TEST(images),          GL_TEST(missing_buffers), GL_TEST(evaluators),
            GL_TEST(selection_and_feedback), GL_TEST(lists),  GL_TEST(attribute_stacks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
