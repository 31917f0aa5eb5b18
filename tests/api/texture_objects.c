/* Texture objects, units, parameters, environments and texgen (GL 1.5, 3.8.4, 3.8.11, 3.8.13, 2.11.4; tables 6.14 to 6.17). Where OSMesa
 * departs from the specification the expectation is the specification's. */
#include "api/gl_test.h"

#define EXPECT_TEXTURE(pname, ...) EXPECT_FLOATS(glGetTexParameterfv(GL_TEXTURE_2D, (pname), got_), __VA_ARGS__)
#define EXPECT_ENV(pname, ...) EXPECT_FLOATS(glGetTexEnvfv(GL_TEXTURE_ENV, (pname), got_), __VA_ARGS__)
#define EXPECT_GEN(coord, pname, ...) EXPECT_FLOATS(glGetTexGenfv((coord), (pname), got_), __VA_ARGS__)

static const GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
static const GLenum bindings[] = {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
                                  GL_TEXTURE_BINDING_CUBE_MAP};

static void names_become_textures_when_bound(void **state)
{
    (void)state;
    GLuint name[3] = {0};
    EXPECT_ERROR(GL_INVALID_VALUE, glGenTextures(-1, name));
    EXPECT_NO_ERROR(glGenTextures(3, name));
    assert_true(name[0] && name[1] && name[2] && name[0] != name[1] && name[1] != name[2] && name[0] != name[2]);
    assert_false(glIsTexture(name[0]));
    assert_false(glIsTexture(0));
    EXPECT_NO_ERROR(glBindTexture(GL_TEXTURE_2D, name[0]));
    assert_true(glIsTexture(name[0]));
    EXPECT_NO_ERROR(glBindTexture(GL_TEXTURE_1D, 77)); /* any name will do */
    assert_true(glIsTexture(77));
}

static void a_texture_keeps_its_target(void **state)
{
    (void)state;
    for (GLuint i = 0; i < 4; i++) {
        EXPECT_NO_ERROR(glBindTexture(targets[i], 10 + i));
        EXPECT_INTS(bindings[i], (GLint)(10 + i));
        EXPECT_ERROR(GL_INVALID_OPERATION, glBindTexture(targets[(i + 1) % 4], 10 + i));
    }
    EXPECT_ERROR(GL_INVALID_ENUM, glBindTexture(GL_PROXY_TEXTURE_2D, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glBindTexture(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1));
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 11);
}

static void deleting_unbinds(void **state)
{
    (void)state;
    const GLuint names[3] = {5, 0, 99};
    glBindTexture(GL_TEXTURE_2D, 5);
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, 5);
    EXPECT_ERROR(GL_INVALID_VALUE, glDeleteTextures(-1, names));
    EXPECT_NO_ERROR(glDeleteTextures(3, names));
    assert_false(glIsTexture(5));
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 0);
    glActiveTexture(GL_TEXTURE0);
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 0);
}

static void all_textures_are_resident(void **state)
{
    (void)state;
    const GLuint names[2] = {5, 6};
    const GLclampf priority[2] = {0.25f, 7.0f};
    GLboolean resident[2];
    EXPECT_ERROR(GL_INVALID_VALUE, (void)glAreTexturesResident(2, names, resident));
    glBindTexture(GL_TEXTURE_2D, 5);
    glBindTexture(GL_TEXTURE_2D, 6);
    assert_true(glAreTexturesResident(2, names, resident));
    EXPECT_ERROR(GL_INVALID_VALUE, (void)glAreTexturesResident(-1, names, resident));
    EXPECT_ERROR(GL_INVALID_VALUE, glPrioritizeTextures(-1, names, priority));
    EXPECT_NO_ERROR(glPrioritizeTextures(2, names, priority));
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 1);
    glBindTexture(GL_TEXTURE_2D, 5);
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 0.25f);
    EXPECT_TEXTURE(GL_TEXTURE_RESIDENT, 1);
}

static void contexts_share_textures(void **state)
{
    static unsigned char other_picture[TEST_SIZE * TEST_SIZE * 4];
    OSMesaContext other = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, *state);
    glBindTexture(GL_TEXTURE_2D, 5);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.5f);
    assert_true(OSMesaMakeCurrent(other, other_picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE));
    assert_true(glIsTexture(5));
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 0);
    const GLuint name = 5;
    glDeleteTextures(1, &name);
    assert_true(OSMesaMakeCurrent(*state, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE));
    assert_false(glIsTexture(5));
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 0.5f); /* still bound here */
    OSMesaDestroyContext(other);
}

static void parameters_start_as_table_6_15_says(void **state)
{
    (void)state;
    EXPECT_TEXTURE(GL_TEXTURE_MIN_FILTER, (float)GL_NEAREST_MIPMAP_LINEAR);
    EXPECT_TEXTURE(GL_TEXTURE_MAG_FILTER, (float)GL_LINEAR);
    EXPECT_TEXTURE(GL_TEXTURE_WRAP_S, (float)GL_REPEAT);
    EXPECT_TEXTURE(GL_TEXTURE_WRAP_T, (float)GL_REPEAT);
    EXPECT_TEXTURE(GL_TEXTURE_WRAP_R, (float)GL_REPEAT);
    EXPECT_TEXTURE(GL_TEXTURE_BORDER_COLOR, 0, 0, 0, 0);
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 1);
    EXPECT_TEXTURE(GL_TEXTURE_MIN_LOD, -1000);
    EXPECT_TEXTURE(GL_TEXTURE_MAX_LOD, 1000);
    EXPECT_TEXTURE(GL_TEXTURE_BASE_LEVEL, 0);
    EXPECT_TEXTURE(GL_TEXTURE_MAX_LEVEL, 1000);
    EXPECT_TEXTURE(GL_DEPTH_TEXTURE_MODE, (float)GL_LUMINANCE);
    EXPECT_TEXTURE(GL_TEXTURE_COMPARE_MODE, (float)GL_NONE);
    EXPECT_TEXTURE(GL_TEXTURE_COMPARE_FUNC, (float)GL_LEQUAL);
    EXPECT_TEXTURE(GL_GENERATE_MIPMAP, 0);
}

static void parameters_take_only_their_values(void **state)
{
    (void)state;
    static const GLenum enums[] = {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER,  GL_TEXTURE_WRAP_S,
                                   GL_TEXTURE_WRAP_T,     GL_TEXTURE_WRAP_R,      GL_DEPTH_TEXTURE_MODE,
                                   GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC};
    for (size_t i = 0; i < sizeof enums / sizeof *enums; i++)
        EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, enums[i], GL_LIGHT0));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_LIGHT0, GL_CLAMP));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, -1));
    parameters_start_as_table_6_15_says(state);
}

static void parameters_convert(void **state)
{
    (void)state;
    const GLfloat color[4] = {-1, 2, 0.5f, 0.25f};
    const GLint integers[4] = {0x7fffffff, 0x40000000, 0, -0x7fffffff - 1};
    GLint got[4];
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color);
    EXPECT_TEXTURE(GL_TEXTURE_BORDER_COLOR, 0, 1, 0.5f, 0.25f);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, got);
    assert_int_equal(got[1], 0x7fffffff);
    assert_int_equal(got[2], 0x3fffffff);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, integers);
    EXPECT_TEXTURE(GL_TEXTURE_BORDER_COLOR, 1, 0.5f, 1.0f / 4294967294.0f, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0x40000000);
    if (on_fixedgl()) /* GL 1.5, 3.8.4: converted as table 2.9 says; OSMesa does not */
        EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 0.5f);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 2.7f);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, got);
    assert_int_equal(got[0], 3);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 5);
    EXPECT_TEXTURE(GL_GENERATE_MIPMAP, 1);
}

static GLint coord_replace(void)
{
    GLint got = -1;
    glGetTexEnviv(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, &got);
    return got;
}

/* GL_ARB_point_sprite: GL_COORD_REPLACE_ARB, of each unit, is saved with the points, not with the textures. */
static void coordinate_replacement_belongs_to_points(void **state)
{
    (void)state;
    assert_int_equal(coord_replace(), 0);
    glActiveTexture(GL_TEXTURE1);
    glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
    glActiveTexture(GL_TEXTURE0);
    assert_int_equal(coord_replace(), 0);
    glActiveTexture(GL_TEXTURE1);
    glPushAttrib(GL_TEXTURE_BIT);
    glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_FALSE);
    glPopAttrib();
    assert_int_equal(coord_replace(), 0);
    glPushAttrib(GL_POINT_BIT);
    glTexEnvf(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 1);
    glEnable(GL_POINT_SPRITE_ARB);
    assert_int_equal(coord_replace(), 1);
    glPopAttrib();
    assert_int_equal(coord_replace(), 0);
    assert_false(glIsEnabled(GL_POINT_SPRITE_ARB));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_POINT_SPRITE_ARB, GL_TEXTURE_ENV_MODE, GL_ADD));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COORD_REPLACE_ARB, GL_TRUE));
}

static void environments_belong_to_units(void **state)
{
    (void)state;
    EXPECT_ENV(GL_TEXTURE_ENV_MODE, (float)GL_MODULATE);
    EXPECT_ENV(GL_COMBINE_RGB, (float)GL_MODULATE);
    EXPECT_ENV(GL_SOURCE1_ALPHA, (float)GL_PREVIOUS);
    EXPECT_ENV(GL_OPERAND2_RGB, (float)GL_SRC_ALPHA);
    EXPECT_ENV(GL_RGB_SCALE, 1);
    EXPECT_ENV(GL_TEXTURE_ENV_COLOR, 0, 0, 0, 0);
    glActiveTexture(GL_TEXTURE1);
    EXPECT_INTS(GL_ACTIVE_TEXTURE, GL_TEXTURE1);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 100);
    EXPECT_FLOATS(glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, got_), 100);
    EXPECT_ENV(GL_TEXTURE_ENV_MODE, (float)GL_ADD);
    glActiveTexture(GL_TEXTURE0);
    EXPECT_ENV(GL_TEXTURE_ENV_MODE, (float)GL_MODULATE);
    EXPECT_FLOATS(glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, got_), 0);
    EXPECT_ERROR(GL_INVALID_ENUM, glClientActiveTexture(GL_TEXTURE0 + 8));
    if (on_fixedgl()) /* OSMesa counts units of shaders, too */
        EXPECT_ERROR(GL_INVALID_ENUM, glActiveTexture(GL_TEXTURE0 + 8));
}

static void environments_take_only_their_values(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_ADD));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, 1));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LIGHT0));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE0 + 8));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3));
    EXPECT_ERROR(GL_INVALID_VALUE, glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 2));
    if (on_fixedgl()) /* OSMesa reads four values where one is given */
        EXPECT_ERROR(GL_INVALID_ENUM, glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1));
    EXPECT_NO_ERROR(glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE7));
    EXPECT_NO_ERROR(glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 4));
}

static void eye_planes_are_transformed(void **state)
{
    (void)state;
    const GLfloat plane[4] = {1, 2, 3, 4};
    EXPECT_GEN(GL_S, GL_TEXTURE_GEN_MODE, (float)GL_EYE_LINEAR);
    EXPECT_GEN(GL_T, GL_EYE_PLANE, 0, 1, 0, 0);
    EXPECT_GEN(GL_Q, GL_OBJECT_PLANE, 0, 0, 0, 0);
    glScalef(2, 2, 2);
    glTranslatef(1, 0, 0);
    glTexGenfv(GL_S, GL_EYE_PLANE, plane);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
    EXPECT_GEN(GL_S, GL_EYE_PLANE, 0.5f, 1, 1.5f, 3);
    EXPECT_GEN(GL_S, GL_OBJECT_PLANE, 1, 2, 3, 4);
    EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_LINEAR));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_TEXTURE_2D, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR));
    EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_S, GL_LIGHT0, GL_EYE_LINEAR));
    if (on_fixedgl())
        EXPECT_ERROR(GL_INVALID_ENUM, glTexGeni(GL_S, GL_OBJECT_PLANE, 1));
}

static void the_texture_group_is_pushed(void **state)
{
    (void)state;
    glBindTexture(GL_TEXTURE_2D, 5);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.25f);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_3D);
    glPushAttrib(GL_TEXTURE_BIT);
    glDisable(GL_TEXTURE_3D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glActiveTexture(GL_TEXTURE0);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.75f);
    glBindTexture(GL_TEXTURE_2D, 6);
    glPopAttrib();
    EXPECT_INTS(GL_ACTIVE_TEXTURE, GL_TEXTURE1);
    assert_true(glIsEnabled(GL_TEXTURE_3D));
    EXPECT_ENV(GL_TEXTURE_ENV_MODE, (float)GL_MODULATE);
    glActiveTexture(GL_TEXTURE0);
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 5);
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 0.25f);
}

static void enables_of_all_units_are_pushed(void **state)
{
    (void)state;
    glActiveTexture(GL_TEXTURE4);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_GEN_R);
    glActiveTexture(GL_TEXTURE2);
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_TEXTURE_CUBE_MAP);
    glActiveTexture(GL_TEXTURE4);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_TEXTURE_GEN_R);
    glPopAttrib();
    EXPECT_INTS(GL_ACTIVE_TEXTURE, GL_TEXTURE4);
    assert_true(glIsEnabled(GL_TEXTURE_2D) && glIsEnabled(GL_TEXTURE_GEN_R));
    glActiveTexture(GL_TEXTURE2);
    assert_false(glIsEnabled(GL_TEXTURE_CUBE_MAP));
}

static void lists_hold_texture_commands(void **state)
{
    (void)state;
    const GLuint name = 9;
    const GLclampf priority = 0.5f;
    glNewList(1, GL_COMPILE);
    glBindTexture(GL_TEXTURE_2D, 9);
    glPrioritizeTextures(1, &name, &priority);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glEndList();
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 0);
    EXPECT_NO_ERROR(glCallList(1));
    EXPECT_INTS(GL_TEXTURE_BINDING_2D, 9);
    EXPECT_TEXTURE(GL_TEXTURE_WRAP_S, (float)GL_CLAMP);
    EXPECT_TEXTURE(GL_TEXTURE_PRIORITY, 0.5f);
    EXPECT_ENV(GL_TEXTURE_ENV_MODE, (float)GL_DECAL);
    EXPECT_GEN(GL_S, GL_TEXTURE_GEN_MODE, (float)GL_SPHERE_MAP);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(names_become_textures_when_bound),
            GL_TEST(a_texture_keeps_its_target),
            GL_TEST(deleting_unbinds),
            GL_TEST(all_textures_are_resident),
            GL_TEST(contexts_share_textures),
            GL_TEST(parameters_start_as_table_6_15_says),
            GL_TEST(parameters_take_only_their_values),
            GL_TEST(parameters_convert),
            GL_TEST(environments_belong_to_units),
            GL_TEST(coordinate_replacement_belongs_to_points),
            GL_TEST(environments_take_only_their_values),
            GL_TEST(eye_planes_are_transformed),
            GL_TEST(the_texture_group_is_pushed),
            GL_TEST(enables_of_all_units_are_pushed),
            GL_TEST(lists_hold_texture_commands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
