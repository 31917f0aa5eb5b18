/* The lighting plan: what a scene does not require is not in it. */
#include "vertex_setup.h"

static struct context *ctx;
static struct vertex_plan *plan;

static int set_up(void **state)
{
    (void)state;
    ctx = new_context();
    plan = calloc(1, sizeof *plan);
    ctx->s.lighting.light[0].enabled = true;
    return plan ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    free(plan);
    free(ctx);
    return 0;
}

static unsigned key_of_light0(void)
{
    ctx->dirty = DIRTY_ALL;
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION | 1u << ATTR_NORMAL, &(const struct framebuffer){.height = 10});
    assert_int_equal(plan->light.n, 1);
    return plan->light.light[0].key;
}

static void set_specular_material(float red)
{
    ctx->s.lighting.material[MAT_SPECULAR][0][0] = red;
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 10;
}

static void the_default_light_is_plain(void **state)
{
    (void)state;
    assert_int_equal(key_of_light0(), 0); /* directional, no specular material */
    assert_true(plan->need_normal && !plan->need_eye && plan->light.object_space);
    assert_int_equal(plan->normal_scaling, NORMAL_AS_IS);
}

static void lights_are_what_they_are(void **state)
{
    struct light *light = &ctx->s.lighting.light[0];
    (void)state;

    light->position[3] = 1;
    assert_int_equal(key_of_light0(), LIGHT_POSITIONAL);
    assert_true(plan->need_eye && !plan->light.object_space);
    light->linear_attenuation = 1;
    assert_int_equal(key_of_light0(), LIGHT_POSITIONAL | LIGHT_ATTENUATED);
    light->spot_cutoff = 45;
    assert_int_equal(key_of_light0(), LIGHT_POSITIONAL | LIGHT_ATTENUATED | LIGHT_SPOT);
    light->position[3] = 0; /* a directional light is not attenuated */
    assert_int_equal(key_of_light0(), LIGHT_SPOT);
}

static void highlights_need_a_material(void **state)
{
    (void)state;
    ctx->s.lighting.light_model_local_viewer = true;
    ctx->s.lighting.light_model_color_control = GL_SEPARATE_SPECULAR_COLOR;
    assert_int_equal(key_of_light0(), 0);
    assert_false(plan->need_eye);
    set_specular_material(0.5f);
    assert_int_equal(key_of_light0(), LIGHT_SPECULAR | LIGHT_LOCAL_VIEWER | LIGHT_SEPARATE);
    assert_true(plan->need_eye);
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 0;
    assert_true(key_of_light0() & LIGHT_ZERO_SHININESS);
}

static void black_lights_are_left_out(void **state)
{
    struct light *black = &ctx->s.lighting.light[1];
    (void)state;

    black->enabled = true;
    black->position[3] = 1;
    memset(black->ambient, 0, sizeof black->ambient);
    memset(black->diffuse, 0, sizeof black->diffuse);
    memset(black->specular, 0, sizeof black->specular);
    assert_int_equal(key_of_light0(), 0);
    assert_false(plan->need_eye);
}

static void colors_follow_glColorMaterial(void **state)
{
    (void)state;
    ctx->s.lighting.color_material = true;
    ctx->s.lighting.color_material_face = GL_FRONT;
    ctx->s.lighting.color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
    assert_int_equal(key_of_light0(), 0); /* the colour is constant here */
    ctx->dirty = 0;                       /* a change of what varies is enough */
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION | 1u << ATTR_COLOR, &(const struct framebuffer){.height = 10});
    assert_int_equal(plan->light.light[0].key, LIGHT_VARYING);
    assert_int_equal(plan->light.source[MAT_DIFFUSE][0], ATTR_COLOR);
    assert_int_equal(plan->light.source[MAT_DIFFUSE][1], -1);
    assert_int_equal(plan->light.source[MAT_SPECULAR][0], -1);
}

static void normals_are_scaled_when_they_need_it(void **state)
{
    (void)state;
    ctx->s.transform.rescale_normal = true;
    (void)key_of_light0();
    assert_int_equal(plan->normal_scaling, NORMAL_AS_IS);
    fgl_matrix_scale(modelview(ctx), 2, 2, 2);
    (void)key_of_light0();
    assert_int_equal(plan->normal_scaling, NORMAL_RESCALE);
    assert_true(plan->rescale_factor == 2 && plan->normal_in_eye_space);
    ctx->s.transform.normalize = true;
    (void)key_of_light0();
    assert_int_equal(plan->normal_scaling, NORMAL_NORMALIZE);
}

static void unlit_draws_have_no_lighting(void **state)
{
    (void)state;
    ctx->s.lighting.lighting = false;
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION, &(const struct framebuffer){.height = 10});
    assert_false(plan->lighting || plan->color_is_varying || plan->need_fog_z || plan->need_point_size);
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION | 1u << ATTR_COLOR, &(const struct framebuffer){.height = 10});
    assert_true(plan->color_is_varying);
}

#define PLAN(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
            PLAN(the_default_light_is_plain),    PLAN(lights_are_what_they_are),
            PLAN(highlights_need_a_material),    PLAN(black_lights_are_left_out),
            PLAN(colors_follow_glColorMaterial), PLAN(normals_are_scaled_when_they_need_it),
            PLAN(unlit_draws_have_no_lighting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
