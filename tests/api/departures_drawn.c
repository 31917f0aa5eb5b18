/* Where the picture that FixedGL draws is the specification's and OSMesa's is not (docs/departures.md). On
 * OSMesa this test shows that it still differs; tests/api/departures_on_osmesa.sh runs it there. */
#include "api/gl_test.h"

static int drawn_pixels(void)
{
    int count = 0;
    glFinish();
    for (int i = 0; i < TEST_SIZE * TEST_SIZE; i++)
        count += picture[4 * i] != 0 || picture[4 * i + 1] != 0 || picture[4 * i + 2] != 0;
    return count;
}

static const unsigned char *pixel(int x, int y)
{
    glFinish();
    return picture + 4 * (y * TEST_SIZE + x);
}

/* nine-vertices. GL 1.5, 2.6.1: a triangle without area does not take the others with it. */
static void nine_vertices_are_three_triangles(void **state)
{
    static const float corners[9][2] = {{-1, -1}, {0, -1},      {-1, 0},      {0, 0},      {1, 0},
                                        {0, 1},   {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}};
    (void)state;
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 9; i++) {
        glColor3f(1, 1, (float)i / 8); /* smooth */
        glVertex2fv(corners[i]);
    }
    glEnd();
    if (on_fixedgl())
        assert_int_equal(drawn_pixels(),
                         2 * (32 * 31 / 2)); /* the centers on the long edges are not theirs */
    else
        assert_int_equal(drawn_pixels(), 0);
}

static void two_strips(void)
{
    for (int strip = 0; strip < 2; strip++) {
        const float x = strip == 0 ? -0.9f : 0.4f;
        glBegin(GL_TRIANGLE_STRIP);
        glVertex2f(x, -0.9f);
        glVertex2f(x + 0.4f, -0.9f);
        glVertex2f(x, 0.9f);
        glVertex2f(x + 0.4f, 0.9f);
        glEnd();
    }
}

/* incomplete-in-lists. GL 1.5, 2.6.1: vertices that are not enough for a primitive are ignored, in a list too. */
static void incomplete_primitives_draw_nothing(void **state)
{
    static const float corner[5][2] = {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0.5f, 0}, {-0.5f, 0.9f}, {0.9f, 0.9f}};
    static const struct {
        GLenum mode;
        int count, complete; /* vertices, those that make whole primitives */
    } rows[] = {{GL_QUADS, 3, 0}, {GL_QUAD_STRIP, 3, 0}, {GL_TRIANGLES, 4, 3}, {GL_QUADS, 5, 4}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        int pixels[2];
        for (int whole = 0; whole < 2; whole++) {
            glNewList(1, GL_COMPILE);
            for (int twice = 0; twice < 2; twice++) {
                glBegin(rows[i].mode);
                for (int v = 0; v < (whole ? rows[i].complete : rows[i].count); v++)
                    glVertex2fv(corner[v]);
                glEnd();
            }
            glEndList();
            glClear(GL_COLOR_BUFFER_BIT);
            glCallList(1);
            pixels[whole] = drawn_pixels();
        }
        assert_int_equal(pixels[0] == pixels[1], on_fixedgl());
    }
}

/* strips-in-lists. GL 1.5, 5.4: calling a list is the same as the commands in it. */
static void strips_of_a_list_are_apart(void **state)
{
    (void)state;
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glNewList(1, GL_COMPILE);
    two_strips();
    glEndList();
    two_strips();
    const int commands = drawn_pixels();
    glClear(GL_COLOR_BUFFER_BIT);
    glCallList(1);
    if (on_fixedgl())
        assert_int_equal(drawn_pixels(), commands);
    else
        assert_true(drawn_pixels() > commands);
}

/* empty-stipple. GL 1.5, 3.5.2: no bit of the pattern, no fragment. */
static void an_empty_stipple_draws_nothing(void **state)
{
    static const GLubyte pattern[128] = {0};
    (void)state;
    glEnable(GL_POLYGON_STIPPLE);
    glPolygonStipple(pattern);
    glRectf(-1, -1, 1, 1);
    assert_int_equal(drawn_pixels(), on_fixedgl() ? 0 : TEST_SIZE * TEST_SIZE);
}

/* moving-by-no-bitmap. GL 1.5, 3.7: the raster position moves, also in a list. */
static void no_bitmap_moves_the_raster_position(void **state)
{
    (void)state;
    glRasterPos2f(-1, -1);
    glNewList(1, GL_COMPILE);
    glBitmap(0, 0, 0, 0, 5, 7, NULL);
    glEndList();
    glCallList(1);
    if (on_fixedgl())
        EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 5, 7, 0.5f, 1);
    else
        EXPECT_VALUES(GL_CURRENT_RASTER_POSITION, 0, 0, 0.5f, 1);
}

/* copied-depths. GL 1.5, 4.3.3, 3.6.5: scale and bias apply to depths that are copied. */
static void copied_depths_are_scaled(void **state)
{
    float depth = 0;
    (void)state;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    glPixelTransferf(GL_DEPTH_SCALE, 0.5f);
    glRasterPos2f(0, 0);
    glCopyPixels(0, 0, 8, 8, GL_DEPTH);
    glPixelTransferf(GL_DEPTH_SCALE, 1);
    glReadPixels(36, 36, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    assert_true(depth > (on_fixedgl() ? 0.2499f : 0.4999f) && depth < (on_fixedgl() ? 0.2501f : 0.5001f));
}

/* pixel-transfer. GL 1.5, 3.6.3: GL_MAP_COLOR maps each component. */
static void blue_is_mapped(void **state)
{
    static const GLubyte black[4] = {0, 0, 0, 255};
    const GLfloat one = 1;
    (void)state;
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 1, &one);
    glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 1, &one);
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    glRasterPos2f(-1, -1);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, black);
    assert_int_equal(pixel(0, 0)[0], 255);
    assert_int_equal(pixel(0, 0)[2], on_fixedgl() ? 255 : 0);
}

/* flat-surfaces. GL 1.5, 5.1: a map of order 1 is a point. */
static void a_surface_of_order_1_is_where_its_point_is(void **state)
{
    static const GLfloat point[3] = {-0.5f, 0.5f, 0};
    (void)state;
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 1, point);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_AUTO_NORMAL);
    glPointSize(3);
    glBegin(GL_POINTS);
    glEvalCoord2f(0.5f, 0.5f);
    glEnd();
    if (on_fixedgl()) {
        assert_int_equal(drawn_pixels(), 9);
        assert_int_equal(pixel(16, 48)[0], 255);
    } else {
        assert_int_equal(pixel(16, 48)[0], 0);
    }
}

/* accumulation-at-first. OSMesa's first values are those of the memory that it got, so nothing is said of
 * them. */
static void the_accumulation_buffer_begins_as_zero(void **state)
{
    (void)state;
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glAccum(GL_RETURN, 1);
    if (on_fixedgl())
        assert_int_equal(drawn_pixels(), 0);
}

/* returned-pictures. GL 1.5, 5.5: what has been drawn is complete after glFinish. */
static void a_returned_picture_is_shown(void **state)
{
    (void)state;
    glClearAccum(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    glFinish();
    glAccum(GL_RETURN, 1);
    assert_int_equal(drawn_pixels(), on_fixedgl() ? TEST_SIZE * TEST_SIZE : 0);
}

/* attenuated-points. GL 1.5, 3.3: the size of a point is not bounded by the viewport. */
static void attenuated_points_reach_out_of_the_viewport(void **state)
{
    (void)state;
    glViewport(16, 16, 32, 32);
    glPointSize(16);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (const GLfloat[]){4, 0, 0}); /* size 8 */
    glBegin(GL_POINTS);
    glVertex2f(-1, -1);
    glEnd();
    assert_int_equal(drawn_pixels(), on_fixedgl() ? 64 : 16);
}

/* A triangle, green at its second corner, whose first corner is `x` far out. */
static void draw_triangle(float x)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(x, -1);
    glColor3f(0, 1, 0);
    glVertex2f(-1, 1);
    glColor3f(0, 0, 1);
    glVertex2f(-1, -1);
    glEnd();
}

/* smooth-with-fill. GL 1.5, 2.14.7: the shade model is that of the primitives after it. */
static void the_shade_model_is_new(void **state)
{
    (void)state;
    glEnable(GL_POINT_SMOOTH);
    draw_triangle(3); /* clipped */
    glShadeModel(GL_FLAT);
    draw_triangle(1);
    assert_int_equal(pixel(2, TEST_SIZE / 2)[1], on_fixedgl() ? 0 : 129);
}

/* back-color-material. GL 1.5, 2.14.2: the material of back faces is what was last set for these. */
static void back_faces_have_their_own_material(void **state)
{
    static const GLfloat red[] = {1, 0, 0, 1}, green[] = {0, 1, 0, 1};
    (void)state;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (const GLfloat[]){0, 0, 0, 1});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glFrontFace(GL_CW);
    glNormal3f(0, 0, -1);
    glBegin(GL_TRIANGLES);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, red);
    glVertex2f(-1, -1);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, green);
    glVertex2f(3, -1);
    glVertex2f(-1, 3);
    glEnd();
    const unsigned char *middle = pixel(TEST_SIZE / 2, TEST_SIZE / 2);
    assert_int_equal(middle[0], 255);
    if (on_fixedgl())
        assert_int_equal(middle[1], 0);
    else
        assert_true(middle[1] > 0);
}

/* A context of another format for one test; its buffer has a pixel of the middle. */
static const void *draw_in(GLenum format, GLenum type, void (*draw)(void), void *buffer)
{
    OSMesaContext before = OSMesaGetCurrentContext(),
                  context = OSMesaCreateContextExt(format, 24, 8, 0, NULL);
    assert_non_null(context);
    assert_true(OSMesaMakeCurrent(context, buffer, type, 16, 16));
    draw();
    glFinish();
    OSMesaMakeCurrent(before, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE);
    OSMesaDestroyContext(context);
    return buffer;
}

static void draw_denormal(void)
{
    glBegin(GL_QUADS);
    glColor4f(1e-40f, 0, 0, 1);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
}

/* denormals. GL 1.5, 2.1.1: nothing is said of them; they are numbers as others. */
static void denormals_are_kept(void **state)
{
    static float buffer[16 * 16][4];
    (void)state;
    draw_in(OSMESA_RGBA, GL_FLOAT, draw_denormal, buffer);
    if (on_fixedgl())
        assert_true(buffer[136][0] > 0.9e-40f && buffer[136][0] < 1.1e-40f);
    else
        assert_true(buffer[136][0] == 0);
}

static void draw_ramp(void)
{
    GLubyte ramp[16][3];
    for (int i = 0; i < 16; i++)
        ramp[i][0] = ramp[i][1] = ramp[i][2] = (GLubyte)(10 * i + 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2f(-1, -1);
    glDrawPixels(16, 1, GL_RGB, GL_UNSIGNED_BYTE, ramp);
}

/* three-byte-pixels: the picture is the same in every format of the buffer. */
static void pixels_of_three_bytes_are_in_their_places(void **state)
{
    static unsigned char buffer[16 * 16][3];
    bool same = true;
    (void)state;
    draw_in(OSMESA_RGB, GL_UNSIGNED_BYTE, draw_ramp, buffer);
    for (int i = 0; i < 16; i++)
        same = same && buffer[i][0] == 10 * i + 1 && buffer[i][2] == 10 * i + 1;
    assert_int_equal(same, on_fixedgl());
}

/* pixel-transfer. GL_EXT_packed_depth_stencil: both components are transferred. */
static void drawn_depths_and_stencils_are_transferred(void **state)
{
    const GLuint pixel24_8 = 0x40000011;
    GLuint got = 0;
    (void)state;
    glPixelTransferf(GL_DEPTH_SCALE, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    glWindowPos2i(0, 0);
    glDrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &pixel24_8);
    glPixelTransferf(GL_DEPTH_SCALE, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &got);
    assert_int_equal(got, on_fixedgl() ? 0x12 : 0x11);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(nine_vertices_are_three_triangles),
            GL_TEST(incomplete_primitives_draw_nothing),
            GL_TEST(strips_of_a_list_are_apart),
            GL_TEST(an_empty_stipple_draws_nothing),
            GL_TEST(no_bitmap_moves_the_raster_position),
            GL_TEST(copied_depths_are_scaled),
            GL_TEST(blue_is_mapped),
            GL_TEST(a_surface_of_order_1_is_where_its_point_is),
            GL_TEST(the_accumulation_buffer_begins_as_zero),
            GL_TEST(a_returned_picture_is_shown),
            GL_TEST(attenuated_points_reach_out_of_the_viewport),
            GL_TEST(the_shade_model_is_new),
            GL_TEST(back_faces_have_their_own_material),
            GL_TEST(denormals_are_kept),
            GL_TEST(pixels_of_three_bytes_are_in_their_places),
            GL_TEST(drawn_depths_and_stencils_are_transferred),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
