/* The extensions for teaching: GL_WIN_phong_shading, GL_APPLE_specular_vector, GL_NV_light_max_exponent. State and errors, and
 * what lighting per fragment leaves as it is. What it computes: tests/oracle/phong.c. */
#include "api/gl_test.h"

static void names(void **state)
{
    (void)state;
    const char *list = (const char *)glGetString(GL_EXTENSIONS);
    assert_non_null(strstr(list, "GL_WIN_phong_shading"));
    assert_non_null(strstr(list, "GL_APPLE_specular_vector"));
    assert_non_null(strstr(list, "GL_NV_light_max_exponent"));
}

static void shade_model(void **state)
{
    (void)state;
    EXPECT_INTS(GL_SHADE_MODEL, GL_SMOOTH);
    EXPECT_NO_ERROR(glShadeModel(GL_PHONG_WIN));
    EXPECT_INTS(GL_SHADE_MODEL, GL_PHONG_WIN);
    EXPECT_ERROR(GL_INVALID_ENUM, glShadeModel(GL_PHONG_HINT_WIN));
    EXPECT_INTS(GL_SHADE_MODEL, GL_PHONG_WIN);
    glPushAttrib(GL_LIGHTING_BIT);
    glShadeModel(GL_FLAT);
    glPopAttrib();
    EXPECT_INTS(GL_SHADE_MODEL, GL_PHONG_WIN);
    glNewList(1, GL_COMPILE);
    glShadeModel(GL_PHONG_WIN);
    glEndList();
    glShadeModel(GL_SMOOTH);
    glCallList(1);
    EXPECT_INTS(GL_SHADE_MODEL, GL_PHONG_WIN);
}

static void hint(void **state)
{
    (void)state;
    EXPECT_INTS(GL_PHONG_HINT_WIN, GL_DONT_CARE);
    EXPECT_NO_ERROR(glHint(GL_PHONG_HINT_WIN, GL_NICEST));
    EXPECT_INTS(GL_PHONG_HINT_WIN, GL_NICEST);
    EXPECT_ERROR(GL_INVALID_ENUM, glHint(GL_PHONG_HINT_WIN, GL_PHONG_WIN));
    EXPECT_ERROR(GL_INVALID_ENUM, glHint(GL_PHONG_WIN, GL_NICEST));
    EXPECT_INTS(GL_PHONG_HINT_WIN, GL_NICEST);
}

static void specular_vector(void **state)
{
    (void)state;
    const GLfloat on = 1;
    EXPECT_INTS(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_FALSE);
    EXPECT_NO_ERROR(glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, 7));
    EXPECT_INTS(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_TRUE);
    glPushAttrib(GL_LIGHTING_BIT);
    EXPECT_NO_ERROR(glLightModelf(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, 0));
    EXPECT_INTS(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_FALSE);
    glPopAttrib();
    EXPECT_INTS(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_TRUE);
    EXPECT_ERROR(GL_INVALID_ENUM, glLightfv(GL_LIGHT0, GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, &on));
}

/* The limits are those that are enforced. */
static void exponents(void **state)
{
    (void)state;
    GLfloat shininess, exponent;
    glGetFloatv(GL_MAX_SHININESS_NV, &shininess);
    glGetFloatv(GL_MAX_SPOT_EXPONENT_NV, &exponent);
    assert_true(shininess >= 128 && exponent >= 128);
    EXPECT_NO_ERROR(glMaterialf(GL_FRONT, GL_SHININESS, shininess));
    EXPECT_ERROR(GL_INVALID_VALUE, glMaterialf(GL_FRONT, GL_SHININESS, shininess + 0.5f));
    EXPECT_NO_ERROR(glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent));
    EXPECT_ERROR(GL_INVALID_VALUE, glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent + 0.5f));
}

/* ---- what lighting per fragment leaves as it is ---- */

static void light(void)
{
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0.2f, 0.3f, 1, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

static void triangle(void)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glNormal3f(-0.5f, -0.5f, 0.7f);
    glVertex2f(-0.9f, -0.9f);
    glColor3f(0, 1, 0);
    glNormal3f(0.5f, -0.5f, 0.7f);
    glVertex2f(0.9f, -0.8f);
    glColor3f(0, 0, 1);
    glNormal3f(0, 0.5f, 0.8f);
    glVertex2f(0, 0.9f);
    glEnd();
}

static void take_picture(unsigned char to[sizeof picture])
{
    glClear(GL_COLOR_BUFFER_BIT);
    triangle();
    glFinish();
    memcpy(to, picture, sizeof picture);
}

/* Without lights there is nothing to compute at a fragment: colours are interpolated. */
static void unlit(void **state)
{
    (void)state;
    static unsigned char smooth[sizeof picture], phong[sizeof picture];
    take_picture(smooth);
    glShadeModel(GL_PHONG_WIN);
    take_picture(phong);
    assert_memory_equal(smooth, phong, sizeof picture);
    light();
    take_picture(phong);
    glShadeModel(GL_SMOOTH);
    take_picture(smooth);
    assert_memory_not_equal(smooth, phong, sizeof picture); /* and with lights there is */
}

enum { ROOM = 64 };

static int feed_back(GLfloat buffer[ROOM])
{
    glFeedbackBuffer(ROOM, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    triangle();
    return glRenderMode(GL_RENDER);
}

static void feedback_and_raster_position(void **state)
{
    (void)state;
    GLfloat smooth[ROOM] = {0}, phong[ROOM] = {0}, smooth_color[4], phong_color[4];
    light();
    glNormal3f(0.1f, 0.2f, 0.9f);
    glRasterPos2f(0.5f, 0.5f);
    glGetFloatv(GL_CURRENT_RASTER_COLOR, smooth_color);
    assert_int_equal(feed_back(smooth), 2 + 3 * 7);
    glShadeModel(GL_PHONG_WIN);
    glNormal3f(0.1f, 0.2f, 0.9f);
    glRasterPos2f(0.5f, 0.5f);
    glGetFloatv(GL_CURRENT_RASTER_COLOR, phong_color);
    assert_int_equal(feed_back(phong), 2 + 3 * 7);
    assert_memory_equal(smooth, phong, sizeof smooth);
    check_floats(phong_color, smooth_color, 4, "raster colour", __FILE__, __LINE__);
    assert_true(phong_color[0] > 0.2f);
}

/* ---- faces ---- */

/* Every pixel drawn has exactly this colour. */
static void expect_only(unsigned char r, unsigned char g, unsigned char b, const char *what)
{
    int drawn = 0;
    glFinish();
    for (int i = 0; i < TEST_SIZE * TEST_SIZE; i++) {
        const unsigned char *p = picture + 4 * i;
        if (!(p[0] | p[1] | p[2]))
            continue;
        drawn++;
        if (p[0] != r || p[1] != g || p[2] != b)
            fail_msg("%s: pixel %d is %d %d %d, not %d %d %d", what, i, p[0], p[1], p[2], r, g, b);
    }
    assert_true(drawn >= 3);
}

/* The front emits red, the back green; nothing is reflected. Front, back and each polygon mode, with and without what takes
 * polygons along the longer road. */
static void two_sides(void **state)
{
    (void)state;
    static const GLenum modes[] = {GL_FILL, GL_LINE, GL_POINT};
    const GLfloat black[4] = {0, 0, 0, 1};
    light();
    glShadeModel(GL_PHONG_WIN);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, black);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, black);
    glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){1, 0, 0, 1});
    glMaterialfv(GL_BACK, GL_EMISSION, (GLfloat[]){0, 1, 0, 1});
    glPolygonOffset(1, 1);
    for (int i = 0; i < 24; i++) {
        const GLenum mode = modes[i % 3];
        const bool back = i & 4, offset = i & 8, exact = i & 16;
        char what[64];
        snprintf(what, sizeof what, "mode 0x%x, %s, %s, %s", mode, back ? "back" : "front", offset ? "offset" : "no offset",
                 exact ? "exact" : "compatible");
        fixedglAccuracy(exact ? FIXEDGL_EXACT : FIXEDGL_COMPATIBLE);
        glPolygonMode(GL_FRONT_AND_BACK, mode);
        glFrontFace(back ? GL_CW : GL_CCW);
        (offset ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
        (offset ? glEnable : glDisable)(GL_POLYGON_OFFSET_LINE);
        glClear(GL_COLOR_BUFFER_BIT);
        triangle();
        expect_only(back ? 0 : 255, back ? 255 : 0, 0, what);
    }
}

/* ---- explain ---- */

static void explained(void **state)
{
    (void)state;
    light();
    glShadeModel(GL_PHONG_WIN);
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_TRUE);
    for (int i = 0; i < 12; i++) {
        fixedglAccuracy(i & 1 ? FIXEDGL_EXACT : FIXEDGL_COMPATIBLE);
        (i & 2 ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, i & 4 ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
        EXPECT_NO_ERROR(fixedglExplainPixel(20 + 2 * i, 24));
        glClear(GL_COLOR_BUFFER_BIT);
        triangle();
        const char *text = fixedglExplain(FIXEDGL_JSON, -1);
        assert_non_null(text);
        if (!strstr(text, "\"agrees\":true") || !strstr(text, "\"shading\":\"phong\"") || !strstr(text, "\"r_dot_v\":"))
            fail_msg("explained: %s", text);
        text = fixedglExplain(FIXEDGL_TEXT, -1);
        assert_non_null(strstr(text, "of the pixel itself"));
        assert_non_null(strstr(text, "r.v, v to the viewer"));
    }
    fixedglExplainPixel(-1, -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(names),      GL_TEST(shade_model), GL_TEST(hint),
            GL_TEST(specular_vector), GL_TEST(exponents),   GL_TEST(unlit),
            GL_TEST(feedback_and_raster_position), GL_TEST(two_sides),   GL_TEST(explained),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
