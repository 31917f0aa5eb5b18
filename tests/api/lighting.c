/* Lights under matrices, materials, colour material (GL 1.5, 2.14.2 "Lighting Parameter
 * Specification", 2.14.3 "ColorMaterial"). */
#include "api/gl_test.h"

/* x' = 2x + 3y, y' = z + 5, z' = -x, w' = w + x/4: no two terms alike. */
static const GLfloat odd_matrix[16] = {2, 0, -1, 0.25f, 3, 0, 0, 0, 0, 1, 0, 0, 0, 5, 0, 1};

static void position_is_transformed_when_given(void **state)
{
    (void)state;
    const GLfloat v[4] = {1, 2, 3, 1};
    glLoadMatrixf(odd_matrix);
    glLightfv(GL_LIGHT3, GL_POSITION, v);
    glLoadIdentity();
    EXPECT_LIGHT(3, GL_POSITION, 8, 8, -1, 1.25f);
    glLightfv(GL_LIGHT3, GL_POSITION, v);
    EXPECT_LIGHT(3, GL_POSITION, 1, 2, 3, 1);
    EXPECT_LIGHT(2, GL_POSITION, 0, 0, 1, 0);
}

static void a_direction_is_not_translated(void **state)
{
    (void)state;
    const GLfloat v[4] = {1, 2, 3, 0};
    glTranslatef(10, 20, 30);
    glScalef(2, 2, 4);
    glLightfv(GL_LIGHT0, GL_POSITION, v);
    EXPECT_LIGHT(0, GL_POSITION, 2, 4, 12, 0);
}

static void spot_direction_by_the_upper_3x3(void **state)
{
    (void)state;
    const GLfloat v[3] = {1, 2, 3};
    glLoadMatrixf(odd_matrix);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, v);
    EXPECT_LIGHT(0, GL_SPOT_DIRECTION, 8, 3, -1); /* not normalised */
}

static void only_the_modelview_matrix_counts(void **state)
{
    (void)state;
    const GLfloat v[4] = {1, 2, 3, 1};
    glMatrixMode(GL_PROJECTION);
    glScalef(7, 7, 7);
    glLightfv(GL_LIGHT0, GL_POSITION, v);
    EXPECT_LIGHT(0, GL_POSITION, 1, 2, 3, 1);
}

static void inside_push_and_pop(void **state)
{
    (void)state;
    const GLfloat v[4] = {0, 0, 0, 1};
    glTranslatef(1, 0, 0);
    glPushMatrix();
    glTranslatef(0, 2, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, v);
    glPopMatrix();
    glLightfv(GL_LIGHT1, GL_POSITION, v);
    EXPECT_LIGHT(0, GL_POSITION, 1, 2, 0, 1);
    EXPECT_LIGHT(1, GL_POSITION, 1, 0, 0, 1);
}

/* When the list is called, not when it is compiled. */
static void position_in_a_list(void **state)
{
    (void)state;
    const GLfloat v[4] = {0, 0, 0, 1};
    glNewList(1, GL_COMPILE);
    glLightfv(GL_LIGHT0, GL_POSITION, v);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91);
    glEndList();
    EXPECT_LIGHT(0, GL_POSITION, 0, 0, 1, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glTranslatef(4, 5, 6);
    glCallList(1);
    EXPECT_LIGHT(0, GL_POSITION, 4, 5, 6, 1);
    assert_int_equal(glGetError(), GL_INVALID_VALUE);
    glDeleteLists(1, 1);
}

static void every_light_parameter(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        const GLfloat v[4] = {(GLfloat)i, 2, 3, 4};
        for (GLenum p = GL_AMBIENT; p <= GL_SPOT_DIRECTION; p++)
            glLightfv(GL_LIGHT0 + i, p, v);
        for (GLenum p = GL_SPOT_EXPONENT; p <= GL_QUADRATIC_ATTENUATION; p++)
            glLightf(GL_LIGHT0 + i, p, (GLfloat)(p - GL_SPOT_EXPONENT + i));
    }
    for (int i = 0; i < 8; i++) {
        for (GLenum p = GL_AMBIENT; p <= GL_POSITION; p++)
            EXPECT_LIGHT(i, p, (GLfloat)i, 2, 3, 4);
        EXPECT_LIGHT(i, GL_SPOT_DIRECTION, (GLfloat)i, 2, 3);
        for (GLenum p = GL_SPOT_EXPONENT; p <= GL_QUADRATIC_ATTENUATION; p++)
            EXPECT_LIGHT(i, p, (GLfloat)(p - GL_SPOT_EXPONENT + i));
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void every_material_parameter(void **state)
{
    (void)state;
    const GLenum params[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    for (int i = 0; i < 4; i++) {
        glMaterialfv(GL_FRONT, params[i], (GLfloat[]){(GLfloat)i, 1, 2, 3});
        glMaterialfv(GL_BACK, params[i], (GLfloat[]){(GLfloat)i, 5, 6, 7});
    }
    glMaterialf(GL_FRONT, GL_SHININESS, 10);
    glMaterialf(GL_BACK, GL_SHININESS, 20);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (GLfloat[]){1, 2, 3});
    glMaterialfv(GL_BACK, GL_COLOR_INDEXES, (GLfloat[]){4, 5, 6});
    for (int i = 0; i < 4; i++) {
        EXPECT_MATERIAL(GL_FRONT, params[i], (GLfloat)i, 1, 2, 3);
        EXPECT_MATERIAL(GL_BACK, params[i], (GLfloat)i, 5, 6, 7);
    }
    EXPECT_MATERIAL(GL_FRONT, GL_SHININESS, 10);
    EXPECT_MATERIAL(GL_BACK, GL_SHININESS, 20);
    EXPECT_MATERIAL(GL_FRONT, GL_COLOR_INDEXES, 1, 2, 3);
    EXPECT_MATERIAL(GL_BACK, GL_COLOR_INDEXES, 4, 5, 6);

    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){9, 8, 7, 6});
    for (int i = 0; i < 2; i++) {
        EXPECT_MATERIAL(GL_FRONT, params[i], 9, 8, 7, 6);
        EXPECT_MATERIAL(GL_BACK, params[i], 9, 8, 7, 6);
    }
    EXPECT_MATERIAL(GL_BACK, GL_SPECULAR, 2, 5, 6, 7);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void material_between_begin_and_end(void **state)
{
    (void)state;
    glBegin(GL_POINTS);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 2, 3, 4});
    glVertex2i(0, 0);
    glMaterialf(GL_FRONT, GL_SHININESS, 33);
    glEnd();
    EXPECT_MATERIAL(GL_FRONT, GL_SPECULAR, 1, 2, 3, 4);
    EXPECT_MATERIAL(GL_FRONT, GL_SHININESS, 33);
    EXPECT_MATERIAL(GL_BACK, GL_SHININESS, 0);
}

static void material_in_a_list(void **state)
{
    (void)state;
    glNewList(1, GL_COMPILE);
    glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){1, 2, 3, 4});
    glMaterialf(GL_FRONT, GL_SHININESS, 129);
    glEndList();
    assert_int_equal(glGetError(), GL_NO_ERROR);
    EXPECT_MATERIAL(GL_FRONT, GL_EMISSION, 0, 0, 0, 1);
    glCallList(1);
    EXPECT_MATERIAL(GL_FRONT, GL_EMISSION, 1, 2, 3, 4);
    assert_int_equal(glGetError(), GL_INVALID_VALUE);
    glDeleteLists(1, 1);
}

static void color_material_follows_the_color(void **state)
{
    (void)state;
    glColor4f(1, 0.5f, 0.25f, 0.75f);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0.8f, 0.8f, 0.8f, 1);
    glEnable(GL_COLOR_MATERIAL); /* at once */
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 0.5f, 0.25f, 0.75f);
    EXPECT_MATERIAL(GL_BACK, GL_AMBIENT, 1, 0.5f, 0.25f, 0.75f);
    EXPECT_MATERIAL(GL_FRONT, GL_SPECULAR, 0, 0, 0, 1);
    glColor3f(0, 1, 0);
    EXPECT_MATERIAL(GL_BACK, GL_DIFFUSE, 0, 1, 0, 1);
    glBegin(GL_POINTS);
    glColor3f(0, 0, 1);
    glVertex2i(0, 0);
    glEnd();
    EXPECT_MATERIAL(GL_FRONT, GL_AMBIENT, 0, 0, 1, 1);
    glDisable(GL_COLOR_MATERIAL); /* the last colour stays */
    glColor3f(1, 1, 1);
    EXPECT_MATERIAL(GL_FRONT, GL_AMBIENT, 0, 0, 1, 1);
}

static void color_material_of_each_face_and_parameter(void **state)
{
    (void)state;
    const GLenum params[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT, GL_AMBIENT);
    for (int p = 0; p < 4; p++) {
        for (GLenum face = GL_FRONT; face <= GL_BACK; face++) {
            const float c = (float)(p * 2) + (face == GL_BACK ? 1.0f : 0.0f) + 1;
            glColorMaterial(face, params[p]);
            glColor4f(c, c, c, c);
            EXPECT_MATERIAL(face, params[p], c, c, c, c);
        }
    }
    glColorMaterial(GL_FRONT, GL_EMISSION); /* gets the colour at once */
    for (int p = 0; p < 4; p++) {
        const float front = p == 3 ? 8 : (float)(2 * p + 1), back = (float)(2 * p + 2);
        EXPECT_MATERIAL(GL_FRONT, params[p], front, front, front, front);
        EXPECT_MATERIAL(GL_BACK, params[p], back, back, back, back);
    }
}

/* A tracked parameter does not listen to glMaterial. */
static void material_while_tracking(void **state)
{
    (void)state;
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(1, 0, 0);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 0, 0, 1);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){0, 0, 1, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, (GLfloat[]){0, 0, 1, 1});
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 0, 0, 1);
    EXPECT_MATERIAL(GL_FRONT, GL_EMISSION, 0, 0, 1, 1);
}

/* OSMesa rule: glMaterial and glColor outside glBegin and glEnd wait for the next vertices, unless a state
 * change or a query comes after vertices. A material that waits while tracking begins is the last word. */
static void material_waiting_when_tracking_begins(void **state)
{
    (void)state;
    const GLfloat blue[4] = {0, 0, 1, 1};
    glMaterialfv(GL_FRONT, GL_DIFFUSE, blue);
    glEnable(GL_COLOR_MATERIAL);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0, 0, 1, 1);
    EXPECT_MATERIAL(GL_BACK, GL_DIFFUSE, 1, 1, 1, 1);
    glDisable(GL_COLOR_MATERIAL);

    glMaterialfv(GL_FRONT, GL_DIFFUSE, blue);
    EXPECT_VALUES(GL_CURRENT_COLOR, 1, 1, 1, 1); /* now it waits no more */
    glEnable(GL_COLOR_MATERIAL);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 1, 1, 1);
}

static void tracking_through_the_attribute_stack(void **state)
{
    (void)state;
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(1, 0, 0);
    glPushAttrib(GL_ENABLE_BIT);
    glDisable(GL_COLOR_MATERIAL);
    glColor3f(0, 1, 0);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 1, 0, 0, 1);
    glPopAttrib();
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0, 1, 0, 1);

    glPushAttrib(GL_CURRENT_BIT);
    glColor3f(0, 0, 1);
    EXPECT_MATERIAL(GL_FRONT, GL_DIFFUSE, 0, 0, 1, 1);
    glPopAttrib();
    EXPECT_VALUES(GL_CURRENT_COLOR, 0, 1, 0, 1);
}

/* fixedgl.h: by function and by hint, in a list too, and what a query says. */
static void accuracy(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    EXPECT_VALUES(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_DONT_CARE);
    assert_int_equal(fixedglAccuracy(FIXEDGL_EXACT), FIXEDGL_COMPATIBLE);
    EXPECT_VALUES(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_NICEST);
    glHint(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_DONT_CARE);
    assert_int_equal(fixedglAccuracy(FIXEDGL_COMPATIBLE), FIXEDGL_COMPATIBLE);
    glNewList(1, GL_COMPILE);
    glHint(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_NICEST);
    glEndList();
    EXPECT_VALUES(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_DONT_CARE);
    glHint(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_FASTEST);
    EXPECT_VALUES(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, GL_DONT_CARE);
    glCallList(1);
    assert_int_equal(fixedglAccuracy(FIXEDGL_COMPATIBLE), FIXEDGL_EXACT);
    glBegin(GL_POINTS);
    assert_int_equal(fixedglAccuracy(FIXEDGL_EXACT), 0);
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    assert_int_equal(fixedglAccuracy(FIXEDGL_COMPATIBLE), FIXEDGL_COMPATIBLE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(position_is_transformed_when_given),
            GL_TEST(a_direction_is_not_translated),
            GL_TEST(spot_direction_by_the_upper_3x3),
            GL_TEST(only_the_modelview_matrix_counts),
            GL_TEST(inside_push_and_pop),
            GL_TEST(position_in_a_list),
            GL_TEST(every_light_parameter),
            GL_TEST(every_material_parameter),
            GL_TEST(material_between_begin_and_end),
            GL_TEST(material_in_a_list),
            GL_TEST(color_material_follows_the_color),
            GL_TEST(color_material_of_each_face_and_parameter),
            GL_TEST(material_while_tracking),
            GL_TEST(tracking_through_the_attribute_stack),
            GL_TEST(material_waiting_when_tracking_begins),
            GL_TEST(accuracy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
