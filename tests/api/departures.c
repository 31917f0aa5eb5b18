/* Where the state that FixedGL keeps is the specification's and OSMesa's is not (docs/departures.md). On
 * OSMesa this test shows that it still differs. */
#include "api/gl_test.h"

#include <math.h>

static void draw_something(void)
{
    glBegin(GL_POINTS);
    glVertex2i(0, 0);
    glEnd();
    glFinish();
}

/* GL 1.5, 6.1.14: what glPushAttrib saved comes back. OSMesa does not notice a colour that was set outside
 * glBegin and glEnd and that nothing has drawn or asked for since, and leaves it. */
static void pop_restores_an_unused_color(void **state)
{
    (void)state;
    glColor3f(1, 0, 0);
    draw_something();
    glPushAttrib(GL_CURRENT_BIT);
    glColor3f(0, 1, 0);
    glPopAttrib();
    draw_something();
    if (on_fixedgl())
        EXPECT_VALUES(GL_CURRENT_COLOR, 1, 0, 0, 1);
    else
        EXPECT_VALUES(GL_CURRENT_COLOR, 0, 1, 0, 1);
}

static void pop_restores_an_unused_material(void **state)
{
    (void)state;
    const GLfloat grey[4] = {0.5f, 0.5f, 0.5f, 1};
    draw_something();
    glPushAttrib(GL_LIGHTING_BIT);
    glMaterialfv(GL_FRONT, GL_EMISSION, grey);
    glPopAttrib();
    draw_something();
    if (on_fixedgl())
        EXPECT_MATERIAL(GL_FRONT, GL_EMISSION, 0, 0, 0, 1);
    else
        EXPECT_MATERIAL(GL_FRONT, GL_EMISSION, 0.5f, 0.5f, 0.5f, 1);
}

/* Each level of the stack is its own. OSMesa forgets, at the inner glPopAttrib, what had changed since the
 * outer push. */
static void pop_restores_what_changed_inside_an_inner_push(void **state)
{
    (void)state;
    glPushAttrib(GL_ENABLE_BIT);
    glPushAttrib(GL_CURRENT_BIT);
    glEnable(GL_LIGHTING);
    glPopAttrib();
    glPopAttrib();
    assert_int_equal(glIsEnabled(GL_LIGHTING), on_fixedgl() ? GL_FALSE : GL_TRUE);
}

/* popped-state. GL 1.5, tables 6.8 and 6.10: GL_COLOR_SUM belongs to fog and enable, lights' switches to lighting and enable. */
static void pop_restores_what_was_enabled(void **state)
{
    static const GLenum caps[][2] = {{GL_FOG_BIT, GL_COLOR_SUM}, {GL_ENABLE_BIT, GL_COLOR_SUM}, {GL_ENABLE_BIT, GL_LIGHT5}};
    (void)state;
    for (int i = 0; i < 3; i++) {
        glPushAttrib(caps[i][0]);
        glEnable(caps[i][1]);
        glPopAttrib();
        assert_int_equal(glIsEnabled(caps[i][1]), on_fixedgl() ? GL_FALSE : GL_TRUE);
        glDisable(caps[i][1]);
    }
}

/* popped-state. GL 1.5, tables 6.8 and 6.28. */
static void pop_restores_the_source_of_fog_coordinates_and_hints(void **state)
{
    (void)state;
    glPushAttrib(GL_FOG_BIT | GL_HINT_BIT);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    glHint(GL_GENERATE_MIPMAP_HINT, GL_NICEST);
    glPopAttrib();
    EXPECT_VALUES(GL_FOG_COORD_SRC, on_fixedgl() ? GL_FRAGMENT_DEPTH : GL_FOG_COORD);
    EXPECT_VALUES(GL_GENERATE_MIPMAP_HINT, on_fixedgl() ? GL_DONT_CARE : GL_NICEST);
}

/* GL 1.5, 2.14.3: tracked material parameters have the current colour, wherever it comes from. */
static void tracked_materials_follow_a_restored_color(void **state)
{
    (void)state;
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(1, 0, 0);
    draw_something();
    glPushAttrib(GL_CURRENT_BIT);
    glColor3f(0, 1, 0);
    draw_something();
    glPopAttrib();
    EXPECT_VALUES(GL_CURRENT_COLOR, 1, 0, 0, 1);
    if (on_fixedgl())
        EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 0, 0, 1);
    else
        EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0, 1, 0, 1);
}

/* GL 1.5, 2.6.2: edge flags are part of the vertices of a list. OSMesa draws no edges after the list was drawn filled. */
static void edges_show_after_filling(void **state)
{
    (void)state;
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glEdgeFlag(GL_TRUE);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(-1, 1);
    glEnd();
    glEndList();
    glCallList(1);
    glFinish();
    glClear(GL_COLOR_BUFFER_BIT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glCallList(1);
    glFinish();
    bool drawn = false;
    for (int i = 0; i < TEST_SIZE * TEST_SIZE; i++)
        drawn = drawn || picture[4 * i];
    assert_int_equal(drawn, on_fixedgl());
}

static void vertex_of(bool primary, bool secondary)
{
    if (primary)
        glColor3f(0, 0, 1);
    if (secondary)
        glSecondaryColor3f(1, 0, 0);
    glVertex2i(0, 0);
}

/* draws-after-feedback. GL 1.5, 2.7: the current secondary color is that of all vertices that follow. */
static void secondary_colors_stay_after_feedback(void **state)
{
    float fed[16];
    (void)state;
    glEnable(GL_COLOR_SUM);
    glFeedbackBuffer(16, GL_3D_COLOR, fed);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_POINTS);
    vertex_of(true, true);
    glEnd();
    glRenderMode(GL_RENDER);
    glBegin(GL_POINTS);
    vertex_of(true, false);
    glEnd();
    glFinish();
    assert_int_equal(picture[4 * (TEST_SIZE / 2 * TEST_SIZE + TEST_SIZE / 2)], on_fixedgl() ? 255 : 0);
}

/* One light at `position`, white, with nothing else that shines; the vertex's normal is (0, 0, 1). */
static void light_from(float x, float y, float z)
{
    const GLfloat position[4] = {x, y, z, 1}, black[4] = {0, 0, 0, 1};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glMaterialfv(GL_FRONT, GL_AMBIENT, black);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, black);
    glNormal3f(0, 0, 1);
}

/* Red in the middle of the picture, within one step. */
static void expect_red(int ours, int osmesas)
{
    glFinish();
    const int red = picture[4 * (TEST_SIZE / 2 * TEST_SIZE + TEST_SIZE / 2)], expected = on_fixedgl() ? ours : osmesas;
    if (red < expected - 1 || red > expected + 1)
        fail_msg("red is %d, expected %d", red, expected);
}

/* GL 1.5, 2.14.1: vectors between points given by homogeneous coordinates. (0, 0, -1, 2) is the point (0, 0, -0.5), and the
 * light at (1, 0, 0.5) stands 45 degrees above it: 0.7071. OSMesa does not divide by w and has 1.5 / (1 + 1.5^2)^(1/2). */
static void eye_coordinates_are_divided_by_w(void **state)
{
    (void)state;
    const GLfloat white[4] = {1, 1, 1, 1};
    light_from(1, 0, 0.5f);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, white);
    glBegin(GL_POINTS);
    glVertex4f(0, 0, -1, 2);
    glEnd();
    expect_red(180, 212);
}

/* GL 1.5, 2.14.1: (n . h)^0 is 1, attenuated here to 0.8. OSMesa multiplies by (n . VP)^(n . VP) too, 0.5^0.5. */
static void shininess_0_is_no_falloff(void **state)
{
    (void)state;
    const GLfloat white[4] = {1, 1, 1, 1};
    light_from(1.7320508f, 0, 1);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1.25f);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glBegin(GL_POINTS);
    glVertex2i(0, 0);
    glEnd();
    expect_red(204, 144);
}

/* A term that is no number counts as 0 also where materials differ by vertex; OSMesa clamps the sum to white. */
static void a_vertex_material_that_is_no_number(void **state)
{
    (void)state;
    const GLfloat grey[4] = {0.4f, 0.4f, 0.4f, 1}, none[4] = {NAN, NAN, NAN, 1};
    light_from(0, 0, 1);
    glMaterialfv(GL_FRONT, GL_EMISSION, grey);
    glBegin(GL_POINTS);
    glVertex2f(0.5f, 0.5f);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, none);
    glVertex2i(0, 0);
    glEnd();
    expect_red(102, 255);
}

/* GL 1.5, 3.9: without lighting, colours are summed while GL_COLOR_SUM is enabled. */
static void unlit_secondary_colors_are_not_summed(void **state)
{
    (void)state;
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glColor3f(0, 1, 0);
    glSecondaryColor3f(1, 0, 0);
    glRectf(-1, -1, 1, 1);
    glFinish();
    assert_int_equal(picture[0], 0); /* on OSMesa too */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(pop_restores_an_unused_color),
            GL_TEST(pop_restores_an_unused_material),
            GL_TEST(pop_restores_what_changed_inside_an_inner_push),
            GL_TEST(pop_restores_what_was_enabled),
            GL_TEST(pop_restores_the_source_of_fog_coordinates_and_hints),
            GL_TEST(tracked_materials_follow_a_restored_color),
            GL_TEST(edges_show_after_filling),
            GL_TEST(unlit_secondary_colors_are_not_summed),
            GL_TEST(secondary_colors_stay_after_feedback),
            GL_TEST(eye_coordinates_are_divided_by_w),
            GL_TEST(shininess_0_is_no_falloff),
            GL_TEST(a_vertex_material_that_is_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
