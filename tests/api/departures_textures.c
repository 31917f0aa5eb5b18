/* Where textures, point sprites, occlusion queries and framebuffer objects are the specification's and OSMesa's are not (docs/departures.md). On OSMesa this
 * test shows that it still differs. */
#include "api/gl_test.h"

static const unsigned char *pixel(int x, int y)
{
    glFinish();
    return picture + 4 * (y * TEST_SIZE + x);
}

static GLuint samples_of(void (*draw)(void))
{
    GLuint samples = 0;
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    draw();
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(1, GL_QUERY_RESULT, &samples);
    return samples;
}

/* Four texels in a row, nearest: black, red, green, blue. */
static void four_texels(GLenum target)
{
    static const GLubyte texels[4][4] = {{0, 0, 0, 255}, {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(target, 0, GL_RGBA, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glEnable(target);
}

/* ---- point sprites ---- */

/* replaced-coordinates. GL_ARB_point_sprite: coordinates are replaced for points alone. */
static void triangles_keep_their_coordinates(void **state)
{
    (void)state;
    four_texels(GL_TEXTURE_2D);
    glEnable(GL_POINT_SPRITE_ARB);
    glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
    glTexCoord2f(0.6f, 0.5f);
    glRectf(-1, -1, 1, 1);
    assert_int_equal(pixel(30, 30)[1], on_fixedgl() ? 255 : 0);
}

static void sprite_in_the_middle(void)
{
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
}

/* sprites-below. GL 1.5, 4.1.2: nothing is drawn outside of the scissor box. */
static void sprites_stay_in_the_scissor_box(void **state)
{
    (void)state;
    glEnable(GL_POINT_SPRITE_ARB);
    glPointSize(8);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 32, TEST_SIZE, TEST_SIZE);
    assert_int_equal(samples_of(sprite_in_the_middle), on_fixedgl() ? 32 : 40);
    assert_int_equal(pixel(32, 32)[0], 255);
    assert_int_equal(pixel(32, 31)[0], on_fixedgl() ? 0 : 255);
    assert_int_equal(pixel(32, 30)[0], 0);
}

/* ---- occlusion queries ---- */

static void draw_stencils(void)
{
    static const GLubyte stencils[16];
    glDrawPixels(4, 4, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils);
}

static void copy_stencils(void)
{
    glCopyPixels(0, 0, 5, 5, GL_STENCIL);
}

/* counted-stencils. GL 1.5, 3.6.4, 4.1.7: stencil indexes become no fragments, and queries count those. */
static void stencils_are_no_samples(void **state)
{
    (void)state;
    assert_int_equal(samples_of(draw_stencils), on_fixedgl() ? 0 : 16);
    assert_int_equal(samples_of(copy_stencils), on_fixedgl() ? 0 : 25);
}

/* ---- images ---- */

/* lost-levels. GL 1.5, 6.1.4: what was given as a level is what is asked for, whatever another level has become. */
static void a_level_stays_when_another_is_given(void **state)
{
    static const GLubyte texels[4 * 2 * 4] = {1, 2, 3, 4, 5, 6, 7, 8};
    GLubyte again[sizeof texels] = {0};
    (void)state;
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, again);
    assert_int_equal(memcmp(texels, again, sizeof again) == 0, on_fixedgl());
}

/* skipped-texels. GL 1.5, 3.6.4: the first texel is that after the skipped ones. */
static void texels_are_skipped_with_pixel_transfer(void **state)
{
    static const GLubyte texels[2][4] = {{10, 20, 30, 40}, {50, 60, 70, 80}};
    GLubyte again[4];
    (void)state;
    glPixelTransferf(GL_RED_SCALE, 2);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glPixelTransferf(GL_RED_SCALE, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, again);
    assert_int_equal(again[0], on_fixedgl() ? 100 : 20);
}

/* mipmaps-of-nothing. GL_EXT_framebuffer_object, 3.8.8: without a base level there is nothing to do; a cube map must be complete. */
static void no_mipmaps_come_from_no_image(void **state)
{
    (void)state;
    EXPECT_ERROR(on_fixedgl() ? GL_NO_ERROR : GL_INVALID_OPERATION, glGenerateMipmap(GL_TEXTURE_2D));
    EXPECT_ERROR(GL_INVALID_OPERATION, glGenerateMipmap(GL_TEXTURE_CUBE_MAP));
}

/* shadows-of-one-dimension. GL 1.5, 3.8.14: depths are compared with r. */
static void lines_of_depths_are_compared_with_r(void **state)
{
    static const GLubyte depths[2] = {128, 128};
    (void)state;
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT, 2, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, depths);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glEnable(GL_TEXTURE_1D);
    glTexCoord3f(0, 0.9f, 0.1f);
    glRectf(-1, -1, 1, 1);
    assert_int_equal(pixel(5, 5)[0], on_fixedgl() ? 255 : 0);
}

/* ---- framebuffer objects ---- */

/* As large as the window. */
static void bind_framebuffer(void)
{
    glBindFramebufferEXT(GL_FRAMEBUFFER, 1);
    glBindRenderbufferEXT(GL_RENDERBUFFER, 1);
    glRenderbufferStorageEXT(GL_RENDERBUFFER, GL_RGBA8, TEST_SIZE, TEST_SIZE);
    glFramebufferRenderbufferEXT(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
}

/* turned-stipples. GL 1.5, 3.5.2: the bit of a fragment is that of its window coordinates modulo 32. */
static void stipples_lie_in_window_coordinates(void **state)
{
    GLubyte stipple[128] = {255, 255, 255, 255}; /* row 0 */
    (void)state;
    glEnable(GL_POLYGON_STIPPLE);
    bind_framebuffer();
    glPolygonStipple(stipple);
    glRectf(-1, -1, 1, 1);
    glBindFramebufferEXT(GL_FRAMEBUFFER, 0);
    glRectf(-1, -1, 1, 1);
    assert_int_equal(pixel(9, 32)[0], on_fixedgl() ? 255 : 0);
}

static void smooth_line_through_centers(void)
{
    glEnable(GL_LINE_SMOOTH);
    glBegin(GL_LINES);
    glVertex2f(-0.5f, 1.0f / TEST_SIZE);
    glVertex2f(0.5f, 1.0f / TEST_SIZE);
    glEnd();
}

/* smooth-in-framebuffers: the same picture before and after. */
static void smooth_lines_stay_where_they_are(void **state)
{
    static unsigned char before[sizeof picture];
    (void)state;
    smooth_line_through_centers();
    glFinish();
    memcpy(before, picture, sizeof picture);
    bind_framebuffer();
    glClear(GL_COLOR_BUFFER_BIT);
    smooth_line_through_centers();
    glReadPixels(0, 0, TEST_SIZE, TEST_SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    assert_int_equal(memcmp(before, picture, sizeof picture) == 0, on_fixedgl());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(triangles_keep_their_coordinates),
            GL_TEST(sprites_stay_in_the_scissor_box),
            GL_TEST(stencils_are_no_samples),
            GL_TEST(a_level_stays_when_another_is_given),
            GL_TEST(texels_are_skipped_with_pixel_transfer),
            GL_TEST(no_mipmaps_come_from_no_image),
            GL_TEST(lines_of_depths_are_compared_with_r),
            GL_TEST(stipples_lie_in_window_coordinates),
            GL_TEST(smooth_lines_stay_where_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
