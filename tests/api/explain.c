/* fixedglExplain: the terms are those of the equation (GL 1.5, 2.14.1), worked out by hand; events, warnings, errors. */
#include "api/explain_test.h"

/* ---- terms ---- */

/* A quad over the whole picture, two units before the eye, normal towards it. */
static void wall(void)
{
    glBegin(GL_QUADS);
    glVertex3f(-2, -2, -2);
    glVertex3f(2, -2, -2);
    glVertex3f(2, 2, -2);
    glVertex3f(-2, 2, -2);
    glEnd();
}

static void one_spot_by_hand(void **state)
{
    const float position[4] = {0, 0, 0, 1}, ambient[4] = {0.1f, 0.2f, 0.3f, 1},
                diffuse[4] = {1, 0.5f, 0.25f, 1}, half[4] = {0.5f, 0.5f, 0.5f, 1};
    (void)state;
    fixedglExplainPixel(20, 9);
    begin();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT2);
    glLightfv(GL_LIGHT2, GL_POSITION, position);
    glLightfv(GL_LIGHT2, GL_AMBIENT, ambient);
    glLightfv(GL_LIGHT2, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT2, GL_SPECULAR, half);
    glLightf(GL_LIGHT2, GL_CONSTANT_ATTENUATION, 2);
    glLightf(GL_LIGHT2, GL_QUADRATIC_ATTENUATION, 0.5f);
    glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 80);
    glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 2);
    glMaterialfv(GL_FRONT, GL_AMBIENT, half);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, half);
    glMaterialfv(GL_FRONT, GL_SPECULAR, diffuse);
    glMaterialf(GL_FRONT, GL_SHININESS, 3);
    wall();
    glPopAttrib();
    const char *v = find(explain(), "vertices");
    const double r3 = 1 / sqrt(3), att = 1 / (2 + 0.5 * 12), spot_ = 1.0 / 3;
    const double h = (r3 + 1) / sqrt(2 * r3 * r3 + (r3 + 1) * (r3 + 1)), s = pow(h, 3) * att * spot_;
    const double sx = find(v, "object")[1] == '-' ? 1 : -1;
    EXPECT(v, "start", 1e-6, 0.1, 0.1, 0.1);
    EXPECT(v, "light", 0, 2);
    EXPECT(v, "VP", 1e-6, sx * r3);
    EXPECT(v, "distance", 1e-6, sqrt(12));
    EXPECT(v, "attenuation", 1e-6, att);
    EXPECT(v, "spot", 1e-6, spot_);
    EXPECT(v, "n_dot_VP", 1e-6, r3);
    EXPECT(v, "n_dot_h", 1e-6, h);
    EXPECT(v, "shininess", 0, 3);
    const char *l = find(v, "highlight");
    EXPECT(l, "ambient", 1e-6, 0.05 * att * spot_, 0.1 * att * spot_, 0.15 * att * spot_);
    EXPECT(l, "diffuse", 1e-6, 0.5 * r3 * att * spot_, 0.25 * r3 * att * spot_, 0.125 * r3 * att * spot_);
    EXPECT(l, "specular", 1e-5, 0.5 * s, 0.25 * s, 0.125 * s);
    EXPECT(l, "sum", 1e-5, 0.1 + (0.05 + 0.5 * r3) * att * spot_ + 0.5 * s);
}

/* The weights put the pixel's centre together from the vertices, whatever the perspective and where a vertex
 * lies behind the eye. */
static void weights_locate_the_pixel(void **state)
{
    (void)state;
    for (int x = 5; x < 60; x += 9) {
        fixedglExplainPixel(x, 30);
        begin();
        triangles();
        glPopAttrib();
        const char *v = find(explain(), "vertices");
        double clip[2] = {0, 0};
        while (v && (v = find(v, "weight"))) {
            const char *c = find(v, "clip");
            double component[4];
            char *end;
            const double weight = strtod(v, &end);
            for (int i = 0; i < 4; i++, c = end)
                component[i] = strtod(c + 1, &end);
            clip[0] += weight * component[0];
            clip[1] += weight * component[3];
        }
        assert_true(clip[1] > 0);
        assert_true(fabs((clip[0] / clip[1] * 0.5 + 0.5) * TEST_SIZE - (x + 0.5)) < 0.02);
    }
}

static void events_in_order(void **state)
{
    (void)state;
    fixedglExplainPixel(32, 32);
    begin();
    glColor3f(1, 0, 0);
    wall();
    glDepthFunc(GL_GREATER);
    wall();
    glDepthFunc(GL_ALWAYS);
    glColor3f(0, 1, 0);
    wall();
    glPopAttrib();
    const char *text = explain();
    const char *const outcome[] = {"cleared", "drawn", "failed depth test", "drawn"};
    const char *at = text;
    for (int i = 0; i < 4; i++) {
        at = find(at, "outcome");
        assert_non_null(at);
        if (strncmp(at + 1, outcome[i], strlen(outcome[i])) != 0)
            fail_msg("event %d is not \"%s\": %.30s", i, outcome[i], at);
    }
    assert_null(find(at, "outcome"));
    EXPECT(find(text, "made_by"), "draw", 0, 3);
    EXPECT(text, "color", 0, 0, 255, 0, 255);
}

static void changes_that_are_no_draws(void **state)
{
    (void)state;
    const GLubyte pixel[4] = {1, 2, 3, 4};
    GLfloat feedback[64];
    fixedglExplainPixel(4, 4);
    begin();
    glPopAttrib();
    expect_text(fixedglExplain(FIXEDGL_TEXT, -1), "glClearColor(0.1, 0.2, 0.3, 0.4)");
    assert_null(find(explain(), "made_by"));

    glFeedbackBuffer(64, GL_3D, feedback);
    glRenderMode(GL_FEEDBACK);
    wall();
    assert_true(glRenderMode(GL_RENDER) > 0);
    assert_null(find(find(explain(), "outcome"), "outcome")); /* only the clear */

    wall();
    assert_non_null(find(explain(), "made_by"));
    glWindowPos2i(4, 4);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    expect_text(explain(), "\"changed\"");
    EXPECT(explain(), "color", 0, 1, 2, 3, 4);
    assert_null(find(explain(), "made_by"));
    expect_text(fixedglExplain(FIXEDGL_TEXT, -1), "glDrawPixels");
}

/* ---- warnings ---- */

struct mistake {
    void (*make)(void);
    const char *said;
};

static void normal_quarter(void)
{
    light(0);
    glScalef(4, 4, 4);
    glTranslatef(0, 0, 1.5f);
    glNormal3f(0, 0, 1);
}
static void normal_backwards(void)
{
    light(1);
    glNormal3f(0, 0, -1);
}
static void lighting_off(void)
{
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
}
static void no_light(void)
{
    glEnable(GL_LIGHTING);
}
static void light_black(void)
{
    light(0);
    glEnable(GL_LIGHT5);
}
static void before_look_at(void)
{
    light(1);
    glTranslatef(0, 0, -0.5f);
}
static void too_bright(void)
{
    const float e[4] = {3, 0, 0, 1};
    light(0);
    glMaterialfv(GL_FRONT, GL_EMISSION, e);
}
static void material_black(void)
{
    const float e[4] = {0, 0, 0, 1};
    light(0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, e);
    glMaterialfv(GL_FRONT, GL_SPECULAR, e);
}
static void outside_cone(void)
{
    const float up[3] = {0, 1, 0};
    light(1);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, up);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 5);
}
static void no_shininess(void)
{
    light(0);
    glMaterialf(GL_FRONT, GL_SHININESS, 0);
}
static void far_light(void)
{
    light(1);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 500);
}
static void back_face(void)
{
    light(0);
    glFrontFace(GL_CW);
}
static void between(void)
{
    const float p[4] = {0, 0, -1, 1};
    light(1);
    glLightfv(GL_LIGHT0, GL_POSITION, p);
    glMaterialf(GL_FRONT, GL_SHININESS, 100);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
}
static void nothing_wrong(void)
{
    const float p[4] = {0, 0, 1, 0};
    light(0);
    glDisable(GL_LIGHT3);
    glLightfv(GL_LIGHT0, GL_POSITION, p);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);
    const float s[4] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, s);
}

static void what_a_teacher_says(void **state)
{
    static const struct mistake mistake[] = {
            {normal_quarter, "A normal of length 0.25 with GL_NORMALIZE off"},
            {normal_backwards, "The normals face away from the viewer"},
            {normal_backwards, "GL_LIGHT0 is behind the surface"},
            {lighting_off, "2 lights are enabled, but GL_LIGHTING is not"},
            {no_light, "no light is: only emission"},
            {light_black, "GL_LIGHT5 is enabled but black"},
            {before_look_at, "GL_LIGHT0's position was set before gluLookAt"},
            {too_bright, "Value clamped: the sum of red at vertex 0 is 3."},
            {material_black, "The material is black"},
            {outside_cone, "GL_LIGHT0: the polygon is outside of the spot's cone"},
            {no_shininess, "GL_SHININESS 0"},
            {far_light, "GL_LIGHT0 is attenuated to less than 1/255"},
            {back_face, "GL_LIGHT_MODEL_TWO_SIDE is not set"},
            {between, "The highlight falls between the vertices"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof mistake / sizeof *mistake; i++) {
        fixedglExplainPixel(31, 32);
        begin();
        glNormal3f(0, 0, 1);
        mistake[i].make();
        wall();
        glPopAttrib();
        expect_text(find(explain(), "warnings"), mistake[i].said);
        expect_text(fixedglExplain(FIXEDGL_TEXT, 1), mistake[i].said);
    }
    begin();
    nothing_wrong();
    wall();
    glPopAttrib();
    expect_text(explain(), "\"warnings\":[]");
}

/* ---- the interface ---- */

static void errors(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1))); /* not armed */
    EXPECT_ERROR(GL_INVALID_VALUE, fixedglExplainPixel(3, -1));
    EXPECT_NO_ERROR(fixedglExplainPixel(TEST_SIZE, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1))); /* outside */
    EXPECT_NO_ERROR(fixedglExplainPixel(0, 0));
    EXPECT_ERROR(GL_INVALID_ENUM, assert_null(fixedglExplain(17, -1)));
    EXPECT_ERROR(GL_INVALID_VALUE, assert_null(fixedglExplain(FIXEDGL_JSON, 3)));
    glBegin(GL_POINTS);
    fixedglExplainPixel(0, 0);
    assert_null(fixedglExplain(FIXEDGL_TEXT, -1));
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    EXPECT_NO_ERROR(assert_non_null(fixedglExplain(FIXEDGL_TEXT, 2)));
    EXPECT_NO_ERROR(fixedglExplainPixel(-1, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1)));
}

static void one_vertex_alone(void **state)
{
    (void)state;
    fixedglExplainPixel(30, 30);
    begin();
    triangles();
    glPopAttrib();
    const char *v = find(fixedglExplain(FIXEDGL_JSON, 1), "vertices");
    const char *first = find(v, "weight");
    assert_non_null(first);
    assert_null(find(first, "weight"));
    EXPECT(v, "number", 0, 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(one_spot_by_hand),
            GL_TEST(weights_locate_the_pixel),
            GL_TEST(events_in_order),
            GL_TEST(changes_that_are_no_draws),
            GL_TEST(what_a_teacher_says),
            GL_TEST(errors),
            GL_TEST(one_vertex_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
