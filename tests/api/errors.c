/* Errors of the commands that set and query state, and that a command which raises one changes nothing
 * (GL 1.5, 2.5 "GL Errors"). GL_INVALID_OPERATION between glBegin and glEnd is begin_end_errors.c; what draws is errors_drawing.c. */
#include "api/refused.h"

#include <math.h>

static void matrices(void **state)
{
    (void)state;
    REFUSED(GL_INVALID_ENUM, glMatrixMode(BAD));
    REFUSED(GL_INVALID_ENUM, glMatrixMode(GL_MODELVIEW_MATRIX));
    REFUSED(GL_INVALID_VALUE, glFrustum(1, 1, 0, 1, 1, 2));
    REFUSED(GL_INVALID_VALUE, glFrustum(0, 1, 1, 1, 1, 2));
    REFUSED(GL_INVALID_VALUE, glFrustum(0, 1, 0, 1, 0, 2));
    REFUSED(GL_INVALID_VALUE, glFrustum(0, 1, 0, 1, 1, -2));
    REFUSED(GL_INVALID_VALUE, glFrustum(0, 1, 0, 1, 2, 2));
    REFUSED(GL_INVALID_VALUE, glOrtho(1, 1, 0, 1, 1, 2));
    REFUSED(GL_INVALID_VALUE, glOrtho(0, 1, 1, 1, 1, 2));
    REFUSED(GL_INVALID_VALUE, glOrtho(0, 1, 0, 1, 2, 2));
    REFUSED(GL_STACK_UNDERFLOW, glPopMatrix());
    REFUSED(GL_INVALID_VALUE, glViewport(0, 0, -1, 1));
    REFUSED(GL_INVALID_VALUE, glViewport(0, 0, 1, -1));
    const GLdouble plane[4] = {1, 2, 3, 4};
    REFUSED(GL_INVALID_ENUM, glClipPlane(GL_CLIP_PLANE0 + 8, plane));
    REFUSED(GL_INVALID_ENUM, glClipPlane(GL_CLIP_PLANE0 - 1, plane));
    GLdouble got[4];
    REFUSED(GL_INVALID_ENUM, glGetClipPlane(GL_CLIP_PLANE0 + 8, got));
}

static void lights(void **state)
{
    (void)state;
    const GLfloat v[4] = {1, 2, 3, 4};
    GLfloat got[4];
    GLint n[4] = {0};
    REFUSED(GL_INVALID_ENUM, glLightfv(GL_LIGHT0 + 8, GL_AMBIENT, v));
    REFUSED(GL_INVALID_ENUM, glLightfv(GL_LIGHT0, BAD, v));
    REFUSED(GL_INVALID_ENUM, glLightiv(GL_LIGHT0, BAD, n));
    REFUSED(GL_INVALID_ENUM, glLightf(GL_LIGHT0, BAD, 1));
    REFUSED(GL_INVALID_ENUM, glLighti(GL_LIGHT0 - 1, GL_SPOT_CUTOFF, 1));
    const GLfloat bad_cutoff[] = {-1, 90.5f, 179, 181};
    for (int i = 0; i < 4; i++)
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, bad_cutoff[i]));
    REFUSED(GL_INVALID_VALUE, glLighti(GL_LIGHT0, GL_SPOT_CUTOFF, 91));
    REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -0.5f));
    REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5f));
    for (GLenum p = GL_CONSTANT_ATTENUATION; p <= GL_QUADRATIC_ATTENUATION; p++)
        REFUSED(GL_INVALID_VALUE, glLightf(GL_LIGHT0, p, -1));
    EXPECT_LIGHT(0, GL_SPOT_CUTOFF, 180);
    EXPECT_LIGHT(0, GL_SPOT_EXPONENT, 0);
    EXPECT_LIGHT(0, GL_CONSTANT_ATTENUATION, 1);
    REFUSED(GL_INVALID_ENUM, glGetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, got));
    REFUSED(GL_INVALID_ENUM, glGetLightfv(GL_LIGHT0, BAD, got));
    REFUSED(GL_INVALID_ENUM, glGetLightiv(GL_LIGHT0, BAD, n));
    REFUSED(GL_INVALID_ENUM, glGetLightiv(GL_LIGHT0 + 8, GL_AMBIENT, n));

    REFUSED(GL_INVALID_ENUM, glLightModelfv(BAD, v));
    REFUSED(GL_INVALID_ENUM, glLightModeliv(BAD, n));
    REFUSED(GL_INVALID_ENUM, glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, BAD));
    REFUSED(GL_INVALID_ENUM, glShadeModel(GL_FILL));

    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90));
    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 0));
    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180));
    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128));
}

static void materials(void **state)
{
    (void)state;
    const GLfloat v[4] = {1, 2, 3, 4};
    GLfloat got[4];
    GLint n[4] = {0};
    REFUSED(GL_INVALID_ENUM, glMaterialfv(BAD, GL_AMBIENT, v));
    REFUSED(GL_INVALID_ENUM, glMaterialfv(GL_FRONT, BAD, v));
    REFUSED(GL_INVALID_ENUM, glMaterialiv(GL_FRONT, GL_POSITION, n));
    REFUSED(GL_INVALID_VALUE, glMaterialf(GL_FRONT, GL_SHININESS, -1));
    REFUSED(GL_INVALID_VALUE, glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 128.5f));
    REFUSED(GL_INVALID_VALUE, glMateriali(GL_BACK, GL_SHININESS, 129));
    EXPECT_NO_ERROR(glMateriali(GL_FRONT_AND_BACK, GL_SHININESS, 128));
    REFUSED(GL_INVALID_ENUM, glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, got));
    REFUSED(GL_INVALID_ENUM, glGetMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, got));
    REFUSED(GL_INVALID_ENUM, glGetMaterialiv(GL_FRONT, GL_POSITION, n));
    REFUSED(GL_INVALID_ENUM, glColorMaterial(BAD, GL_AMBIENT));
    REFUSED(GL_INVALID_ENUM, glColorMaterial(GL_FRONT, GL_SHININESS));

    glBegin(GL_POINTS);
    glMaterialf(GL_FRONT, GL_SHININESS, 200);
    glEnd();
    assert_int_equal(glGetError(), GL_INVALID_VALUE);
    EXPECT_MATERIAL(GL_FRONT, GL_SHININESS, 128);
}

/* The scalar forms take single-valued parameters only; OSMesa sets the other components to 0. */
static void scalar_forms(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    REFUSED(GL_INVALID_ENUM, glLightf(GL_LIGHT0, GL_AMBIENT, 1));
    REFUSED(GL_INVALID_ENUM, glLighti(GL_LIGHT0, GL_POSITION, 1));
    REFUSED(GL_INVALID_ENUM, glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1));
    REFUSED(GL_INVALID_ENUM, glLightModeli(GL_LIGHT_MODEL_AMBIENT, 1));
    REFUSED(GL_INVALID_ENUM, glMaterialf(GL_FRONT, GL_DIFFUSE, 1));
    REFUSED(GL_INVALID_ENUM, glMateriali(GL_FRONT, GL_DIFFUSE, 1));
    REFUSED(GL_INVALID_ENUM, glFogf(GL_FOG_COLOR, 1));
    REFUSED(GL_INVALID_ENUM, glFogi(GL_FOG_COLOR, 1));
    EXPECT_LIGHT(0, GL_AMBIENT, 0, 0, 0, 1);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0.8f, 0.8f, 0.8f, 1);
}

static void rasterization(void **state)
{
    (void)state;
    const GLfloat v[4] = {0};
    REFUSED(GL_INVALID_VALUE, glPointSize(0));
    REFUSED(GL_INVALID_VALUE, glPointSize(-1));
    REFUSED(GL_INVALID_VALUE, glLineWidth(0));
    REFUSED(GL_INVALID_ENUM, glCullFace(BAD));
    REFUSED(GL_INVALID_ENUM, glFrontFace(GL_FRONT));
    REFUSED(GL_INVALID_ENUM, glPolygonMode(BAD, GL_FILL));
    REFUSED(GL_INVALID_ENUM, glPolygonMode(GL_FRONT, BAD));
    REFUSED(GL_INVALID_ENUM, glHint(BAD, GL_NICEST));
    REFUSED(GL_INVALID_ENUM, glHint(GL_FOG_HINT, BAD));
    REFUSED(GL_INVALID_ENUM, glFogfv(BAD, v));
    REFUSED(GL_INVALID_ENUM, glFogi(GL_FOG_MODE, GL_NEAREST));
    REFUSED(GL_INVALID_ENUM, glFogf(GL_FOG_MODE, -1));
    REFUSED(GL_INVALID_VALUE, glFogf(GL_FOG_DENSITY, -1));
    REFUSED(GL_INVALID_ENUM, glPixelStorei(BAD, 1));
    REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_PACK_ALIGNMENT, 3));
    REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_UNPACK_ALIGNMENT, 0));
    REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_UNPACK_ALIGNMENT, 16));
    REFUSED(GL_INVALID_VALUE, glPixelStorei(GL_PACK_ROW_LENGTH, -1));
    REFUSED(GL_INVALID_VALUE, glPixelStoref(GL_UNPACK_SKIP_ROWS, -1));
}

static void fragments(void **state)
{
    (void)state;
    REFUSED(GL_INVALID_VALUE, glScissor(0, 0, -1, 1));
    REFUSED(GL_INVALID_VALUE, glScissor(0, 0, 1, -1));
    REFUSED(GL_INVALID_ENUM, glAlphaFunc(GL_NEVER - 1, 0.5f));
    REFUSED(GL_INVALID_ENUM, glAlphaFunc(GL_ALWAYS + 1, 0.5f));
    REFUSED(GL_INVALID_ENUM, glStencilFunc(BAD, 1, 1));
    REFUSED(GL_INVALID_ENUM, glStencilOp(BAD, GL_ZERO, GL_ZERO));
    REFUSED(GL_INVALID_ENUM, glStencilOp(GL_ZERO, BAD, GL_ZERO));
    REFUSED(GL_INVALID_ENUM, glStencilOp(GL_ZERO, GL_ZERO, BAD));
    REFUSED(GL_INVALID_ENUM, glDepthFunc(BAD));
    REFUSED(GL_INVALID_ENUM, glBlendFunc(BAD, GL_ONE));
    REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ZERO, BAD));
    if (on_fixedgl()) /* GL 1.5, table 4.2; OSMesa allows it, as GL 3.3 does */
        REFUSED(GL_INVALID_ENUM, glBlendFunc(GL_ZERO, GL_SRC_ALPHA_SATURATE));
    REFUSED(GL_INVALID_ENUM, glLogicOp(GL_CLEAR - 1));
    REFUSED(GL_INVALID_ENUM, glLogicOp(GL_SET + 1));
    REFUSED(GL_INVALID_ENUM, glDrawBuffer(BAD));
    REFUSED(GL_INVALID_ENUM, glReadBuffer(BAD));
    REFUSED(GL_INVALID_OPERATION, glDrawBuffer(GL_FRONT_RIGHT));
    REFUSED(GL_INVALID_OPERATION, glDrawBuffer(GL_AUX0));
    REFUSED(GL_INVALID_OPERATION, glReadBuffer(GL_RIGHT));
    REFUSED(GL_INVALID_OPERATION, glReadBuffer(GL_AUX0));
    REFUSED(GL_INVALID_VALUE, glClear(0x80000000u));
}

static void capabilities_and_queries(void **state)
{
    (void)state;
    GLint n[16] = {7};
    GLfloat f[16] = {7};
    GLdouble d[16] = {7};
    GLboolean b[16] = {7};
    void *p = n;
    REFUSED(GL_INVALID_ENUM, glEnable(BAD));
    REFUSED(GL_INVALID_ENUM, glEnable(GL_POINT_SIZE)); /* a value, but not a capability */
    REFUSED(GL_INVALID_ENUM, glDisable(BAD));
    REFUSED(GL_INVALID_ENUM, assert_false(glIsEnabled(BAD)));
    REFUSED(GL_INVALID_ENUM, glGetIntegerv(BAD, n));
    REFUSED(GL_INVALID_ENUM, glGetFloatv(BAD, f));
    REFUSED(GL_INVALID_ENUM, glGetDoublev(BAD, d));
    REFUSED(GL_INVALID_ENUM, glGetBooleanv(BAD, b));
    assert_true(n[0] == 7 && f[0] == 7 && d[0] == 7 && b[0] == 7);
    REFUSED(GL_INVALID_ENUM, glGetPointerv(BAD, &p));
    assert_ptr_equal(p, n);
    REFUSED(GL_INVALID_ENUM, assert_null(glGetString(BAD)));
    if (on_fixedgl()) {
        REFUSED(GL_INVALID_ENUM, fixedglAccuracy(3));
        REFUSED(GL_INVALID_ENUM, fixedglAccuracy(0));
        REFUSED(GL_INVALID_ENUM, glHint(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_TRUE));
    }
}

/* OSMesa raises the error, but stores the size first. */
#define NEGATIVE_STRIDE(call)                                                                                \
    do {                                                                                                     \
        if (on_fixedgl())                                                                                    \
            REFUSED(GL_INVALID_VALUE, call);                                                                 \
        else                                                                                                 \
            EXPECT_ERROR(GL_INVALID_VALUE, call);                                                            \
    } while (0)

static void arrays(void **state)
{
    (void)state;
    REFUSED(GL_INVALID_VALUE, glVertexPointer(1, GL_FLOAT, 0, NULL));
    REFUSED(GL_INVALID_VALUE, glVertexPointer(5, GL_FLOAT, 0, NULL));
    REFUSED(GL_INVALID_ENUM, glVertexPointer(3, GL_BYTE, 0, NULL));
    NEGATIVE_STRIDE(glVertexPointer(3, GL_FLOAT, -1, NULL));
    REFUSED(GL_INVALID_ENUM, glNormalPointer(GL_UNSIGNED_SHORT, 0, NULL));
    NEGATIVE_STRIDE(glNormalPointer(GL_FLOAT, -1, NULL));
    REFUSED(GL_INVALID_VALUE, glColorPointer(2, GL_FLOAT, 0, NULL));
    REFUSED(GL_INVALID_ENUM, glColorPointer(3, BAD, 0, NULL));
    NEGATIVE_STRIDE(glColorPointer(3, GL_FLOAT, -1, NULL));
    REFUSED(GL_INVALID_ENUM, glIndexPointer(GL_UNSIGNED_SHORT, 0, NULL));
    NEGATIVE_STRIDE(glIndexPointer(GL_FLOAT, -1, NULL));
    REFUSED(GL_INVALID_VALUE, glTexCoordPointer(0, GL_FLOAT, 0, NULL));
    REFUSED(GL_INVALID_VALUE, glTexCoordPointer(5, GL_FLOAT, 0, NULL));
    REFUSED(GL_INVALID_ENUM, glTexCoordPointer(2, GL_UNSIGNED_BYTE, 0, NULL));
    NEGATIVE_STRIDE(glTexCoordPointer(2, GL_FLOAT, -1, NULL));
    NEGATIVE_STRIDE(glEdgeFlagPointer(-1, NULL));
    REFUSED(GL_INVALID_ENUM, glInterleavedArrays(GL_V2F - 1, 0, NULL));
    REFUSED(GL_INVALID_ENUM, glInterleavedArrays(GL_T4F_C4F_N3F_V4F + 1, 0, NULL));
    NEGATIVE_STRIDE(glInterleavedArrays(GL_V2F, -1, NULL));
    REFUSED(GL_INVALID_ENUM, glEnableClientState(BAD));
    REFUSED(GL_INVALID_ENUM, glDisableClientState(GL_LIGHTING));
}

/* Not a number has no range; none of these may crash, or turn into another value's error. */
static void not_a_number(void **state)
{
    (void)state;
    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, NAN));
    EXPECT_NO_ERROR(glFogf(GL_FOG_DENSITY, NAN));
    EXPECT_ERROR(GL_INVALID_ENUM, glFogf(GL_FOG_MODE, NAN));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, NAN));
    EXPECT_NO_ERROR(glClearColor(NAN, NAN, NAN, NAN));
    EXPECT_VALUES(GL_COLOR_CLEAR_VALUE, 0, 0, 0, 0);
    EXPECT_NO_ERROR(glDepthRange((double)NAN, (double)NAN));
    EXPECT_VALUES(GL_DEPTH_RANGE, 0, 0);
    EXPECT_NO_ERROR(glClearDepth((double)NAN));
    EXPECT_VALUES(GL_DEPTH_CLEAR_VALUE, 0);
    EXPECT_NO_ERROR(glRotatef(NAN, 0, 0, 1));
    EXPECT_NO_ERROR(glPixelStoref(GL_PACK_SKIP_ROWS, 1));
}

static void the_first_error_is_kept(void **state)
{
    (void)state;
    glCullFace(BAD);
    glPointSize(-1);
    glPopMatrix();
    assert_int_equal(glGetError(), GL_INVALID_ENUM);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Without a current context commands do nothing and queries return 0. */
static void without_a_context(void **state)
{
    (void)state;
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    glEnable(BAD);
    glMaterialf(GL_FRONT, GL_SHININESS, 1);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 1);
    glBegin(GL_POINTS);
    glVertex2i(0, 0);
    glEnd();
    glFlush();
    if (OSMesaGetCurrentContext() == NULL) {
        assert_int_equal(glGetError(), GL_NO_ERROR);
        assert_int_equal(glIsEnabled(GL_DITHER), GL_FALSE);
        assert_null(glGetString(GL_VENDOR));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(matrices),
            GL_TEST(lights),
            GL_TEST(materials),
            GL_TEST(scalar_forms),
            GL_TEST(fragments),
            GL_TEST(rasterization),
            GL_TEST(arrays),
            GL_TEST(not_a_number),
            GL_TEST(capabilities_and_queries),
            GL_TEST(the_first_error_is_kept),
            GL_TEST(without_a_context),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
