/* Attribute stacks (GL 1.5, 6.1.14 "Saving and Restoring State"): each group brings back exactly its own
 * values. */
#include "api/spec_state.h"

#include <math.h>

static void set_colors_and_lights(void)
{
    glSecondaryColor3f(0.25f, 0.5f, 0.75f);
    glFogCoordf(3);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    const GLfloat v[4] = {0.25f, 0.5f, 0.75f, 0.5f};
    glColor4fv(v);
    glIndexf(5);
    glNormal3f(1, 0, 0.5f);
    glTexCoord4f(1, 2, 3, 4);
    glEdgeFlag(GL_FALSE);
    glShadeModel(GL_FLAT);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glColorMaterial(GL_BACK, GL_SPECULAR);
    glFogfv(GL_FOG_COLOR, v);
    glFogf(GL_FOG_INDEX, 3);
    glFogf(GL_FOG_DENSITY, 0.5f);
    glFogf(GL_FOG_START, 2);
    glFogf(GL_FOG_END, 9);
    glFogi(GL_FOG_MODE, GL_LINEAR);
}

static void set_rasterization(void)
{
    glPointSize(3);
    glPointParameterf(GL_POINT_SIZE_MIN, 2);
    glPointParameterf(GL_POINT_SIZE_MAX, 20);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (const GLfloat[]){0.5f, 0.25f, 2});
    glSampleCoverage(0.5f, GL_TRUE);
    glLineWidth(2);
    glLineStipple(7, 0x1234);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    glPolygonOffset(1.5f, 2);
    const GLenum hints[] = {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
                            GL_POLYGON_SMOOTH_HINT,         GL_FOG_HINT,          GL_GENERATE_MIPMAP_HINT,
                            GL_TEXTURE_COMPRESSION_HINT};
    for (size_t i = 0; i < sizeof hints / sizeof *hints; i++)
        glHint(hints[i], GL_NICEST);
}

static void set_fragments(void)
{
    glViewport(1, 2, 30, 40);
    glDepthRange(0.25, 0.75);
    glMatrixMode(GL_PROJECTION);
    glScissor(3, 4, 5, 6);
    glAlphaFunc(GL_GREATER, 0.5f);
    glStencilFunc(GL_LESS, 17, 0x0f);
    glStencilOp(GL_ZERO, GL_REPLACE, GL_INVERT);
    glStencilMask(0x3c);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE);
    glBlendEquationSeparateEXT(GL_MAX, GL_MIN);
    glBlendColor(0.25f, 0.5f, 0.75f, 1);
    glLogicOp(GL_XOR);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_FRONT_LEFT);
    glIndexMask(0x55);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glClearColor(0.25f, 0.5f, 0.75f, 1);
    glClearIndex(3);
    glClearDepth(0.5);
    glClearStencil(9);
    glListBase(100);
}

static void set_pixels(void)
{
    const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE},
                 biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS};
    for (int i = 0; i < 5; i++) {
        glPixelTransferf(scales[i], 2.5f + (GLfloat)i);
        glPixelTransferf(biases[i], -0.5f - (GLfloat)i);
    }
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    glPixelTransferi(GL_MAP_STENCIL, GL_TRUE);
    glPixelTransferi(GL_INDEX_SHIFT, 3);
    glPixelTransferi(GL_INDEX_OFFSET, -7);
    glPixelZoom(2, -1.5f);
    glClearAccum(-0.25f, 0.5f, 0.75f, 1);
}

/* The current raster position takes the current values along; a second one, behind the viewer, is invalid. */
static void set_raster_position(void)
{
    const GLfloat outside[4] = {3, 2, 1, -0.5f};
    glRasterPos3f(0.5f, 0.25f, -0.5f);
    glRasterPos4fv(outside);
}

/* Every value of a group gets another than its initial value. */
static void change_everything(void)
{
    set_colors_and_lights();
    set_rasterization();
    set_fragments();
    set_pixels();
    set_raster_position();
    glBindTexture(GL_TEXTURE_1D, 5);
    glBindTexture(GL_TEXTURE_2D, 6);
    glMapGrid1f(7, 2, 3);
    glMapGrid2f(5, -1, 2, 6, 3, 2);
    for (int i = 0; i < SPEC_VALUES; i++) {
        if (!(spec_state[i].groups & GL_ENABLE_BIT))
            continue;
        if (spec_state[i].initial[0] != 0)
            glDisable(spec_state[i].name);
        else
            glEnable(spec_state[i].name);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static struct state_snapshot initial, changed, restored;

static void everything_is_changed(void **state)
{
    (void)state;
    take_snapshot(&initial);
    change_everything();
    take_snapshot(&changed);
    for (int i = 0; i < SPEC_VALUES; i++) {
        if (spec_state[i].groups && same_value(&initial, &changed, i)) {
            print_error("%s did not change\n", spec_state[i].text);
            fail();
        }
    }
}

static void try_group(GLbitfield mask)
{
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    take_snapshot(&initial);
    glPushAttrib(mask);
    change_everything();
    take_snapshot(&changed);
    glPopAttrib();
    take_snapshot(&restored);
    for (int i = 0; i < SPEC_VALUES; i++) {
        if (spec_state[i].name == GL_ATTRIB_STACK_DEPTH)
            continue;
        const bool saved = spec_state[i].groups & mask;
        if (same_value(&restored, saved ? &initial : &changed, i))
            continue;
        print_error("glPushAttrib(0x%x): %s is %s\n", mask, spec_state[i].text,
                    saved ? "not restored" : "restored too");
        fail();
    }
    glPopAttrib();
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void each_group(void **state)
{
    (void)state;
    for (int bit = 0; bit < 20; bit++)
        try_group(1u << bit);
    try_group(0);
    try_group(GL_ALL_ATTRIB_BITS);
    try_group(GL_ENABLE_BIT | GL_FOG_BIT);
}

/* GL 1.5, 6.1.2 "Data Conversions", and 2.9's table for what is normalized: to the nearest integer, halves either way. */
static bool converts(const struct spec_value *s, double v, GLint n)
{
    const double real = s->normalized ? (4294967295.0 * v - 1.0) / 2.0 : v;
    return fabs((double)n - real) <= 0.5 || (s->normalized && fabs((double)n - real) <= 1.0);
}

static void every_conversion(void **state)
{
    (void)state;
    change_everything();
    for (int i = 0; i < SPEC_VALUES; i++) {
        const struct spec_value *s = &spec_state[i];
        GLdouble d[16] = {0};
        GLfloat f[16] = {0};
        GLint n[16] = {0};
        GLboolean b[16] = {0};
        glGetDoublev(s->name, d);
        glGetFloatv(s->name, f);
        glGetIntegerv(s->name, n);
        glGetBooleanv(s->name, b);
        for (int k = 0; k < s->count; k++) {
            if (f[k] == (GLfloat)d[k] && b[k] == (d[k] != 0) && converts(s, d[k], n[k]))
                continue;
            print_error("%s [%d]: double %g, float %g, integer %d, boolean %d\n", s->text, k, d[k], (double)f[k], n[k], b[k]);
            fail();
        }
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* What the tables of glGet do not show. */
static void lights_materials_planes_stipple(void **state)
{
    (void)state;
    const GLfloat v[4] = {0.25f, 0.5f, 0.75f, 1};
    const GLdouble plane[4] = {1, 2, 3, 4};
    GLubyte stipple[128] = {0x12, 0x34};
    glPushAttrib(GL_LIGHTING_BIT | GL_TRANSFORM_BIT | GL_POLYGON_STIPPLE_BIT);
    glLightfv(GL_LIGHT7, GL_POSITION, v);
    glLightf(GL_LIGHT7, GL_SPOT_CUTOFF, 45);
    glMaterialfv(GL_BACK, GL_EMISSION, v);
    glMaterialf(GL_FRONT, GL_SHININESS, 64);
    glClipPlane(GL_CLIP_PLANE0 + 7, plane);
    glPolygonStipple(stipple);
    EXPECT_MATERIAL(GL_BACK, GL_EMISSION, 0.25f, 0.5f, 0.75f, 1);
    glPopAttrib();
    EXPECT_LIGHT(7, GL_POSITION, 0, 0, 1, 0);
    EXPECT_LIGHT(7, GL_SPOT_CUTOFF, 180);
    EXPECT_MATERIAL(GL_BACK, GL_EMISSION, 0, 0, 0, 1);
    EXPECT_MATERIAL(GL_FRONT, GL_SHININESS, 0);
    GLdouble got[4];
    glGetClipPlane(GL_CLIP_PLANE0 + 7, got);
    assert_true(got[0] == 0 && got[3] == 0);
    glGetPolygonStipple(stipple);
    assert_int_equal(stipple[0], 0xff);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void matrices_are_not_attributes(void **state)
{
    (void)state;
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glTranslatef(1, 2, 3);
    glPopAttrib();
    EXPECT_VALUES(GL_MODELVIEW_MATRIX, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1);
}

static void nested(void **state)
{
    (void)state;
    for (int i = 1; i <= 16; i++) {
        glPointSize((GLfloat)i);
        glPushAttrib(i % 2 ? GL_POINT_BIT : GL_LINE_BIT);
        EXPECT_INTS(GL_ATTRIB_STACK_DEPTH, i);
    }
    EXPECT_ERROR(GL_STACK_OVERFLOW, glPushAttrib(GL_POINT_BIT));
    glPointSize(99);
    for (int i = 16; i >= 1; i--) {
        glPopAttrib();
        EXPECT_VALUES(GL_POINT_SIZE, i == 16 ? 99.0f : (GLfloat)(i % 2 ? i : i + 1));
    }
    EXPECT_ERROR(GL_STACK_UNDERFLOW, glPopAttrib());
    EXPECT_INTS(GL_ATTRIB_STACK_DEPTH, 0);
}

static const GLenum pixel_store[] = {GL_PACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES,
                                     GL_UNPACK_LSB_FIRST};

static void client_groups(void **state)
{
    (void)state;
    for (GLbitfield mask = 0; mask < 4; mask++) {
        const GLint arrays = mask & GL_CLIENT_VERTEX_ARRAY_BIT ? 0 : 1,
                    store = mask & GL_CLIENT_PIXEL_STORE_BIT ? 0 : 1;
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
        glPushClientAttrib(mask);
        EXPECT_INTS(GL_CLIENT_ATTRIB_STACK_DEPTH, 2);
        for (int i = 0; i < 4; i++)
            glPixelStorei(pixel_store[i], 1);
        glEnableClientState(GL_COLOR_ARRAY);
        glColorPointer(3, GL_UNSIGNED_BYTE, 12, pixel_store);
        glPopClientAttrib();
        for (int i = 0; i < 4; i++)
            EXPECT_INTS(pixel_store[i], store);
        void *pointer = NULL;
        glGetPointerv(GL_COLOR_ARRAY_POINTER, &pointer);
        assert_ptr_equal(pointer, arrays ? (const void *)pixel_store : NULL);
        EXPECT_INTS(GL_COLOR_ARRAY, arrays);
        EXPECT_INTS(GL_COLOR_ARRAY_SIZE, arrays ? 3 : 4);
        EXPECT_INTS(GL_COLOR_ARRAY_STRIDE, arrays ? 12 : 0);
        glPopClientAttrib();
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void client_stack_limits(void **state)
{
    (void)state;
    for (int i = 0; i < 16; i++)
        EXPECT_NO_ERROR(glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT));
    EXPECT_ERROR(GL_STACK_OVERFLOW, glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT));
    for (int i = 0; i < 16; i++)
        EXPECT_NO_ERROR(glPopClientAttrib());
    EXPECT_ERROR(GL_STACK_UNDERFLOW, glPopClientAttrib());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(everything_is_changed),
            GL_TEST(each_group),
            GL_TEST(every_conversion),
            GL_TEST(lights_materials_planes_stipple),
            GL_TEST(nested),
            GL_TEST(client_groups),
            GL_TEST(matrices_are_not_attributes),
            GL_TEST(client_stack_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
