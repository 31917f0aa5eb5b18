/* Initial values (GL 1.5, 6.2 "State Tables"), and that each can be asked for as every type. */
#include "api/spec_state.h"

static void every_initial_value(void **state)
{
    (void)state;
    int wrong = 0;
    for (int i = 0; i < SPEC_VALUES; i++) {
        const struct spec_value *s = &spec_state[i];
        double v[16] = {0};
        glGetDoublev(s->name, v);
        const GLenum error = glGetError();
        for (int k = 0; k < 16; k++) {
            if (v[k] == s->initial[k] && !error)
                continue;
            print_error("%s [%d]: %.17g, expected %.17g (error 0x%x)\n", s->text, k, v[k], s->initial[k],
                        error);
            wrong++;
            break;
        }
    }
    assert_int_equal(wrong, 0);
}

static void all_types_agree(void **state)
{
    (void)state;
    for (int i = 0; i < SPEC_VALUES; i++) {
        GLfloat f[16] = {0};
        GLboolean b[16] = {0};
        GLint n[16] = {0};
        glGetFloatv(spec_state[i].name, f);
        glGetBooleanv(spec_state[i].name, b);
        glGetIntegerv(spec_state[i].name, n);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        for (int k = 0; k < spec_state[i].count; k++) {
            assert_true(f[k] == (float)spec_state[i].initial[k]);
            assert_int_equal(b[k], spec_state[i].initial[k] != 0);
            if (spec_state[i].initial[k] == 0)
                assert_int_equal(n[k], 0);
        }
    }
}

static void capabilities(void **state)
{
    (void)state;
    for (int i = 0; i < SPEC_VALUES; i++) {
        const struct spec_value *s = &spec_state[i];
        if (!(s->groups & GL_ENABLE_BIT))
            continue;
        const GLboolean initial = s->initial[0] != 0;
        assert_int_equal(glIsEnabled(s->name), initial);
        glEnable(s->name);
        assert_int_equal(glIsEnabled(s->name), GL_TRUE);
        EXPECT_INTS(s->name, 1);
        glDisable(s->name);
        assert_int_equal(glIsEnabled(s->name), GL_FALSE);
        EXPECT_INTS(s->name, 0);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
}

/* Each bit of a field that holds several is its own. */
static void clip_planes_and_lights_are_separate(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        glEnable(GL_CLIP_PLANE0 + i);
        glEnable(GL_LIGHT0 + i);
        for (int k = 0; k < 8; k++) {
            assert_int_equal(glIsEnabled(GL_CLIP_PLANE0 + k), k == i);
            assert_int_equal(glIsEnabled(GL_LIGHT0 + k), k == i);
        }
        glDisable(GL_CLIP_PLANE0 + i);
        glDisable(GL_LIGHT0 + i);
    }
    for (GLenum i = GL_MAP1_COLOR_4; i <= GL_MAP1_VERTEX_4; i++) {
        glEnable(i);
        assert_false(glIsEnabled(i - GL_MAP1_COLOR_4 + GL_MAP2_COLOR_4));
        for (GLenum k = GL_MAP1_COLOR_4; k <= GL_MAP1_VERTEX_4; k++)
            assert_int_equal(glIsEnabled(k), k == i);
        glDisable(i);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void lights(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        const float white = i == 0 ? 1.0f : 0.0f;
        EXPECT_LIGHT(i, GL_AMBIENT, 0, 0, 0, 1);
        EXPECT_LIGHT(i, GL_DIFFUSE, white, white, white, 1);
        EXPECT_LIGHT(i, GL_SPECULAR, white, white, white, 1);
        EXPECT_LIGHT(i, GL_POSITION, 0, 0, 1, 0);
        EXPECT_LIGHT(i, GL_SPOT_DIRECTION, 0, 0, -1);
        EXPECT_LIGHT(i, GL_SPOT_EXPONENT, 0);
        EXPECT_LIGHT(i, GL_SPOT_CUTOFF, 180);
        EXPECT_LIGHT(i, GL_CONSTANT_ATTENUATION, 1);
        EXPECT_LIGHT(i, GL_LINEAR_ATTENUATION, 0);
        EXPECT_LIGHT(i, GL_QUADRATIC_ATTENUATION, 0);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void materials(void **state)
{
    (void)state;
    for (GLenum face = GL_FRONT; face <= GL_BACK; face++) {
        EXPECT_MATERIAL(face, GL_AMBIENT, 0.2f, 0.2f, 0.2f, 1);
        EXPECT_MATERIAL(face, GL_DIFFUSE, 0.8f, 0.8f, 0.8f, 1);
        EXPECT_MATERIAL(face, GL_SPECULAR, 0, 0, 0, 1);
        EXPECT_MATERIAL(face, GL_EMISSION, 0, 0, 0, 1);
        EXPECT_MATERIAL(face, GL_SHININESS, 0);
        EXPECT_MATERIAL(face, GL_COLOR_INDEXES, 0, 1, 1);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void clip_planes_stipple_pointers(void **state)
{
    (void)state;
    GLdouble plane[4] = {9, 9, 9, 9};
    glGetClipPlane(GL_CLIP_PLANE0 + 7, plane);
    for (int i = 0; i < 4; i++)
        assert_true(plane[i] == 0);

    GLubyte stipple[128] = {0};
    glGetPolygonStipple(stipple);
    for (int i = 0; i < 128; i++)
        assert_int_equal(stipple[i], 0xff);

    static const GLenum pointers[] = {GL_VERTEX_ARRAY_POINTER,        GL_NORMAL_ARRAY_POINTER,
                                      GL_COLOR_ARRAY_POINTER,         GL_INDEX_ARRAY_POINTER,
                                      GL_TEXTURE_COORD_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_POINTER,
                                      GL_SELECTION_BUFFER_POINTER,    GL_FEEDBACK_BUFFER_POINTER};
    for (size_t i = 0; i < sizeof pointers / sizeof *pointers; i++) {
        void *p = plane;
        glGetPointerv(pointers[i], &p);
        assert_null(p);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void strings(void **state)
{
    (void)state;
    assert_non_null(glGetString(GL_VENDOR));
    assert_non_null(glGetString(GL_RENDERER));
    assert_non_null(glGetString(GL_EXTENSIONS));
    assert_non_null(strstr((const char *)glGetString(GL_EXTENSIONS), "GL_EXT_rescale_normal"));
    assert_string_equal(fixedglVersion(), FIXEDGL_VERSION);
    if (!on_fixedgl())
        return;
    assert_string_equal((const char *)glGetString(GL_VERSION), "1.5 FixedGL " FIXEDGL_VERSION);
    assert_int_equal(strncmp((const char *)glGetString(GL_RENDERER), "FixedGL software", 16), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(every_initial_value),
            GL_TEST(all_types_agree),
            GL_TEST(capabilities),
            GL_TEST(clip_planes_and_lights_are_separate),
            GL_TEST(lights),
            GL_TEST(materials),
            GL_TEST(strings),
            GL_TEST(clip_planes_stipple_pointers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
