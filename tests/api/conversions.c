/* Conversions between the types of parameters, of the state and of queries (GL 1.5, table 2.9, 6.1.2 "Data
 * Conversions"). */
#include "api/gl_test.h"

#include <limits.h>

enum { LARGEST = INT_MAX, SMALLEST = INT_MIN };

static void rgba(GLfloat v[4], float red)
{
    v[0] = red;
    v[1] = 0;
    v[2] = 0.5f;
    v[3] = 1;
}

/* Colours, normals and depths: 1 is the largest integer. OSMesa's -1 is one more than the smallest. */
static void normalized_values_fill_the_integers(void **state)
{
    (void)state;
    const GLint minus_one = on_fixedgl() ? SMALLEST : -LARGEST, half = LARGEST / 2;
    GLfloat v[4];
    rgba(v, -1);
    glColor4fv(v);
    EXPECT_INTS(GL_CURRENT_COLOR, minus_one, 0, half, LARGEST);
    glNormal3fv(v);
    EXPECT_INTS(GL_CURRENT_NORMAL, minus_one, 0, half);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
    EXPECT_INTS(GL_LIGHT_MODEL_AMBIENT, minus_one, 0, half, LARGEST);
    glDepthRange(1, 0.5);
    EXPECT_INTS(GL_DEPTH_RANGE, LARGEST, half);
    glClearDepth(0.5);
    EXPECT_INTS(GL_DEPTH_CLEAR_VALUE, half);
    glAlphaFunc(GL_LESS, 0.5f);
    EXPECT_INTS(GL_ALPHA_TEST_REF, half);

    GLint n[4];
    glLightfv(GL_LIGHT1, GL_DIFFUSE, v);
    glGetLightiv(GL_LIGHT1, GL_DIFFUSE, n);
    check_ints(n, (GLint[]){minus_one, 0, half, LARGEST}, 4, "light", __FILE__, __LINE__);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, v);
    glGetMaterialiv(GL_FRONT, GL_DIFFUSE, n);
    check_ints(n, (GLint[]){minus_one, 0, half, LARGEST}, 4, "material", __FILE__, __LINE__);
}

static void clamped_when_read(void **state)
{
    (void)state;
    glClearColor(2, -1, 0.5f, 1);
    EXPECT_INTS(GL_COLOR_CLEAR_VALUE, LARGEST, 0, LARGEST / 2, LARGEST);
    EXPECT_VALUES(GL_COLOR_CLEAR_VALUE, 1, 0, 0.5f, 1);
    const GLfloat v[4] = {2, -1, 0.5f, 1};
    glFogfv(GL_FOG_COLOR, v);
    EXPECT_VALUES(GL_FOG_COLOR, 1, 0, 0.5f, 1);
    glAlphaFunc(GL_LESS, 3);
    EXPECT_VALUES(GL_ALPHA_TEST_REF, 1);
    glClearDepth(7);
    EXPECT_VALUES(GL_DEPTH_CLEAR_VALUE, 1);
    glDepthRange(-1, 2);
    EXPECT_VALUES(GL_DEPTH_RANGE, 0, 1);
    glStencilFunc(GL_LESS, 300, 1);
    EXPECT_INTS(GL_STENCIL_REF, 255);
    glStencilFunc(GL_LESS, -1, 1);
    EXPECT_INTS(GL_STENCIL_REF, 0);
    glLineStipple(0, 1);
    EXPECT_INTS(GL_LINE_STIPPLE_REPEAT, 1);
    glLineStipple(1000, 1);
    EXPECT_INTS(GL_LINE_STIPPLE_REPEAT, 256);
    glViewport(-100000, 100000, 1000000, 1000000);
    EXPECT_INTS(GL_VIEWPORT, -32768, 32767, 16384, 16384);
}

/* Not clamped: colours of lights, materials and vertices. */
static void not_clamped(void **state)
{
    (void)state;
    const GLfloat v[4] = {3, -2, 0.5f, 7};
    glColor4fv(v);
    EXPECT_VALUES(GL_CURRENT_COLOR, 3, -2, 0.5f, 7);
    glLightfv(GL_LIGHT0, GL_SPECULAR, v);
    EXPECT_LIGHT(0, GL_SPECULAR, 3, -2, 0.5f, 7);
    glMaterialfv(GL_BACK, GL_AMBIENT, v);
    EXPECT_MATERIAL(GL_BACK, GL_AMBIENT, 3, -2, 0.5f, 7);
    glPointSize(1000);
    EXPECT_VALUES(GL_POINT_SIZE, 1000);
}

static void other_floats_are_rounded(void **state)
{
    (void)state;
    const struct {
        float value;
        GLint rounded;
    } cases[] = {{0.49f, 0},  {0.5f, 1},   {1.5f, 2},   {2.5f, 3},
                 {-0.5f, -1}, {-1.5f, -2}, {-1.4f, -1}, {100000, 100000}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        glFogf(GL_FOG_START, cases[i].value);
        EXPECT_INTS(GL_FOG_START, cases[i].rounded);
    }
    glFogf(GL_FOG_START, 0.01f);
    GLboolean b = GL_FALSE;
    glGetBooleanv(GL_FOG_START, &b);
    assert_int_equal(b, GL_TRUE);
    if (!on_fixedgl())
        return; /* undefined by the specification, but not left to chance */
    glFogf(GL_FOG_START, 3e9f);
    EXPECT_INTS(GL_FOG_START, LARGEST);
    glFogf(GL_FOG_START, -3e9f);
    EXPECT_INTS(GL_FOG_START, SMALLEST);
}

/* OSMesa drops the fraction of what glGetLight returns. */
static void light_queries_are_rounded(void **state)
{
    (void)state;
    const GLfloat v[4] = {1.5f, -2.5f, 3.25f, 1};
    GLint n[4];
    glLightfv(GL_LIGHT0, GL_POSITION, v);
    glGetLightiv(GL_LIGHT0, GL_POSITION, n);
    if (on_fixedgl())
        check_ints(n, (GLint[]){2, -3, 3, 1}, 4, "position", __FILE__, __LINE__);
    else
        check_ints(n, (GLint[]){1, -2, 3, 1}, 4, "position", __FILE__, __LINE__);
    glMaterialf(GL_FRONT, GL_SHININESS, 1.5f);
    glGetMaterialiv(GL_FRONT, GL_SHININESS, n);
    assert_int_equal(n[0], 2);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){0.5f, 1.25f, 7.5f});
    glGetMaterialiv(GL_FRONT, GL_COLOR_INDEXES, n);
    check_ints(n, (GLint[]){1, 1, 8}, 3, "indexes", __FILE__, __LINE__);
}

static float color_of(GLint c)
{
    return (float)((2.0 * c + 1) / 4294967295.0);
}

/* Table 2.9: (2c + 1) / (2^32 - 1). */
static void integer_colors_are_scaled(void **state)
{
    (void)state;
    const GLint c[4] = {LARGEST, SMALLEST, 1000000000, 0};
    const GLfloat f[4] = {1, -1, color_of(1000000000), color_of(0)};
    const GLenum colors[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    for (int i = 0; i < 4; i++) {
        glMaterialiv(GL_FRONT, colors[i], c);
        EXPECT_MATERIAL(GL_FRONT, colors[i], f[0], f[1], f[2], f[3]);
        if (colors[i] == GL_EMISSION)
            continue; /* not of lights */
        glLightiv(GL_LIGHT2, colors[i], c);
        EXPECT_LIGHT(2, colors[i], f[0], f[1], f[2], f[3]);
    }
    glLightModeliv(GL_LIGHT_MODEL_AMBIENT, c);
    EXPECT_VALUES(GL_LIGHT_MODEL_AMBIENT, f[0], f[1], f[2], f[3]);
    glMaterialiv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, c);
    EXPECT_MATERIAL(GL_FRONT, GL_AMBIENT, f[0], f[1], f[2], f[3]);
    EXPECT_MATERIAL(GL_BACK, GL_DIFFUSE, f[0], f[1], f[2], f[3]);
    glFogiv(GL_FOG_COLOR, c);
    EXPECT_VALUES(GL_FOG_COLOR, f[0], 0, f[2], f[3]);
}

static void other_integers_are_not_scaled(void **state)
{
    (void)state;
    const GLint n[4] = {1, -2, 3, 4};
    glLightiv(GL_LIGHT2, GL_POSITION, n);
    EXPECT_LIGHT(2, GL_POSITION, 1, -2, 3, 4);
    glLightiv(GL_LIGHT2, GL_SPOT_DIRECTION, n);
    EXPECT_LIGHT(2, GL_SPOT_DIRECTION, 1, -2, 3);
    glLighti(GL_LIGHT2, GL_SPOT_CUTOFF, 60);
    EXPECT_LIGHT(2, GL_SPOT_CUTOFF, 60);
    glMateriali(GL_FRONT, GL_SHININESS, 50);
    EXPECT_MATERIAL(GL_FRONT, GL_SHININESS, 50);
    glMaterialiv(GL_FRONT, GL_COLOR_INDEXES, n);
    EXPECT_MATERIAL(GL_FRONT, GL_COLOR_INDEXES, 1, -2, 3);
    glFogi(GL_FOG_DENSITY, 3);
    EXPECT_VALUES(GL_FOG_DENSITY, 3);
    glFogf(GL_FOG_MODE, (float)GL_LINEAR);
    EXPECT_INTS(GL_FOG_MODE, GL_LINEAR);
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 0.25f);
    EXPECT_INTS(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glLightModelf(GL_LIGHT_MODEL_COLOR_CONTROL, (float)GL_SEPARATE_SPECULAR_COLOR);
    EXPECT_INTS(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
}

static void masks(void **state)
{
    (void)state;
    glStencilMask(~0u);
    EXPECT_INTS(GL_STENCIL_WRITEMASK, LARGEST);
    EXPECT_VALUES(GL_STENCIL_WRITEMASK, 4294967296.0f);
    glStencilFunc(GL_LESS, 0, 0x80000000u);
    EXPECT_INTS(GL_STENCIL_VALUE_MASK, LARGEST);
    glStencilMask(0x1234);
    EXPECT_INTS(GL_STENCIL_WRITEMASK, 0x1234);
    glColorMask(2, 0, 255, 0); /* any value but 0 is GL_TRUE */
    EXPECT_INTS(GL_COLOR_WRITEMASK, 1, 0, 1, 0);
    glDepthMask(77);
    if (on_fixedgl()) /* OSMesa: 77 */
        EXPECT_INTS(GL_DEPTH_WRITEMASK, 1);
}

static void pixel_store_numbers(void **state)
{
    (void)state;
    glPixelStoref(GL_PACK_SKIP_ROWS, 2.5f);
    EXPECT_INTS(GL_PACK_SKIP_ROWS, 3);
    glPixelStoref(GL_UNPACK_ALIGNMENT, 7.75f);
    EXPECT_INTS(GL_UNPACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, -5);
    EXPECT_INTS(GL_UNPACK_SWAP_BYTES, 1);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void stipple_by_pixel_store(void **state)
{
    (void)state;
    GLubyte in[8 * 40], out[8 * 40];
    for (int i = 0; i < 8 * 40; i++)
        in[i] = (GLubyte)(13 * i + 5);
    glPolygonStipple(in);
    glGetPolygonStipple(out);
    assert_memory_equal(in, out, 128);

    glPixelStorei(GL_PACK_LSB_FIRST, 1);
    glGetPolygonStipple(out);
    for (int i = 0; i < 128; i++) {
        for (int bit = 0; bit < 8; bit++)
            assert_int_equal(in[i] >> bit & 1, out[i] >> (7 - bit) & 1);
    }

    glPixelStorei(GL_PACK_LSB_FIRST, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 40); /* 5 bytes, with alignment 8 */
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    glPolygonStipple(in);
    glGetPolygonStipple(out);
    for (int y = 0; y < 32; y++) {
        for (int x = 0; x < 32; x++) {
            const int bit = 8 * 8 * (y + 2) + x + 3;
            assert_int_equal(out[4 * y + x / 8] >> (7 - x % 8) & 1, in[bit / 8] >> (7 - bit % 8) & 1);
        }
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(normalized_values_fill_the_integers),
            GL_TEST(clamped_when_read),
            GL_TEST(not_clamped),
            GL_TEST(other_floats_are_rounded),
            GL_TEST(light_queries_are_rounded),
            GL_TEST(integer_colors_are_scaled),
            GL_TEST(other_integers_are_not_scaled),
            GL_TEST(masks),
            GL_TEST(pixel_store_numbers),
            GL_TEST(stipple_by_pixel_store),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
