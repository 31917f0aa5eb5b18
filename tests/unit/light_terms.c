/* The lighting equation term by term (GL 1.5, 2.14.1 "Lighting"): one vertex, one light, everything black but
 * the term under test; the expected value is the specification's formula in double. */
#include "vertex_setup.h"

static struct context *ctx;
static struct light *light;

static float position[4], normal[3];

static int set_up(void **state)
{
    (void)state;
    ctx = new_context();
    light = &ctx->s.lighting.light[0];
    light->enabled = true;
    memset(light->ambient, 0, sizeof light->ambient);
    memset(light->diffuse, 0, sizeof light->diffuse);
    memset(light->specular, 0, sizeof light->specular);
    memset(ctx->s.lighting.light_model_ambient, 0, 4 * sizeof(float));
    memset(ctx->s.lighting.material, 0, sizeof ctx->s.lighting.material);
    memcpy(light->position, (float[4]){0, 3, 4, 0}, sizeof light->position);
    memcpy(position, (float[4]){1, 2, -3, 1}, sizeof position);
    memcpy(normal, (float[3]){0, 0, 1}, sizeof normal);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    free(ctx);
    return 0;
}

/* The red of light and material for one kind of colour. */
static void give(float *of_light, enum fgl_material parameter, float l, float m)
{
    of_light[0] = l;
    ctx->s.lighting.material[parameter][0][0] = ctx->s.lighting.material[parameter][1][0] = m;
}

static struct vertex_batch *run(void)
{
    struct vertex_plan *plan = calloc(1, sizeof *plan);
    static struct vertex_batch batch;

    memcpy(ctx->s.current.attr[ATTR_NORMAL], normal, sizeof normal);
    batch.n = 1;
    for (int c = 0; c < 4; c++)
        batch.in[ATTR_POSITION].c[c][0] = position[c];
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION, &(const struct framebuffer){.height = 10});
    fgl_vertex_run(plan, &batch, false);
    free(plan);
    return &batch;
}

static void expect_red(double expected)
{
    const double red = (double)run()->color[0].c[0][0];

    if (fabs(red - expected) > 2e-6)
        fail_msg("%.9g, expected %.9g", red, expected);
}

static void emission(void **state)
{
    (void)state;
    ctx->s.lighting.material[MAT_EMISSION][0][0] = 0.3f;
    expect_red(0.3);
}

static void scene_ambient(void **state)
{
    (void)state;
    give(ctx->s.lighting.light_model_ambient, MAT_AMBIENT, 0.5f, 0.3f);
    expect_red(0.15);
}

static void ambient(void **state)
{
    (void)state;
    give(light->ambient, MAT_AMBIENT, 0.5f, 0.3f);
    memcpy(normal, (float[3]){0, 0, -1}, sizeof normal); /* the direction does not matter */
    expect_red(0.15);
}

static void diffuse_of_a_directional_light(void **state)
{
    (void)state;
    give(light->diffuse, MAT_DIFFUSE, 0.5f, 0.9f);
    expect_red(0.45 * 4 / 5);
    memcpy(normal, (float[3]){0, 0, -1}, sizeof normal);
    expect_red(0);
}

static void diffuse_of_a_positional_light(void **state)
{
    (void)state;
    give(light->diffuse, MAT_DIFFUSE, 0.5f, 0.9f);
    memcpy(light->position, (float[4]){2, 4, -2, 2}, sizeof light->position); /* at (1, 2, -1): 2 in front */
    memcpy(normal, (float[3]){0, 0.6f, 0.8f}, sizeof normal);
    expect_red(0.45 * 0.8);
}

static void attenuation(void **state)
{
    (void)state;
    give(light->ambient, MAT_AMBIENT, 1, 1);
    memcpy(light->position, (float[4]){1, 2, -1, 1}, sizeof light->position); /* at distance 2 */
    light->constant_attenuation = 2;
    expect_red(1.0 / 2);
    light->linear_attenuation = 0.5f;
    expect_red(1.0 / 3);
    light->quadratic_attenuation = 0.25f;
    expect_red(1.0 / 4);
    light->position[3] = 0; /* not of directional lights */
    expect_red(1);
}

static void spot(void **state)
{
    (void)state;
    give(light->ambient, MAT_AMBIENT, 1, 1);
    memcpy(light->position, (float[4]){1, 2, -1, 1}, sizeof light->position);
    memcpy(light->spot_direction, (float[3]){0, 3, -4},
           sizeof light->spot_direction); /* cosine 0.8 to the vertex */
    light->spot_cutoff = 40;
    expect_red(1);
    light->spot_exponent = 10;
    expect_red(pow(0.8, 10));
    light->spot_cutoff = 36;
    expect_red(0);
    light->spot_cutoff = 180; /* not a spot: no fall-off either */
    expect_red(1);
}

static double half_of(const double l[3], const double v[3], const double n[3])
{
    const double h[3] = {l[0] + v[0], l[1] + v[1], l[2] + v[2]};
    const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    return (h[0] * n[0] + h[1] * n[1] + h[2] * n[2]) / length;
}

static void specular_with_the_viewer_at_infinity(void **state)
{
    const double l[3] = {0, 0.6, 0.8}, v[3] = {0, 0, 1}, n[3] = {0, 0, 1};
    (void)state;

    give(light->specular, MAT_SPECULAR, 0.5f, 0.8f);
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 20;
    expect_red(0.4 * pow(half_of(l, v, n), 20));
    memcpy(normal, (float[3]){0, 0, -1}, sizeof normal); /* facing away: f is 0 */
    expect_red(0);
}

static void specular_with_a_local_viewer(void **state)
{
    const double d = sqrt(14), l[3] = {0, 0.6, 0.8}, v[3] = {-1 / d, -2 / d, 3 / d}, n[3] = {0, 0, 1};
    (void)state;

    give(light->specular, MAT_SPECULAR, 0.5f, 0.8f);
    ctx->s.lighting.light_model_local_viewer = true;
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 20;
    expect_red(0.4 * pow(half_of(l, v, n), 20));
}

static void shininess_is_limited(void **state)
{
    const double l[3] = {0, 0.6, 0.8}, v[3] = {0, 0, 1}, n[3] = {0, 0, 1};
    (void)state;

    give(light->specular, MAT_SPECULAR, 1, 1);
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 1000;
    expect_red(pow(half_of(l, v, n), 128));
}

static void separate_specular_is_a_color_of_its_own(void **state)
{
    const struct vertex_batch *b;
    (void)state;

    give(light->specular, MAT_SPECULAR, 0.5f, 0.8f);
    give(light->diffuse, MAT_DIFFUSE, 0.5f, 0.9f);
    ctx->s.lighting.light_model_color_control = GL_SEPARATE_SPECULAR_COLOR;
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 1;
    b = run();
    assert_true(fabs((double)b->color[0].c[0][0] - 0.36) < 1e-6);
    assert_true(fabs((double)b->secondary[0].c[0][0] - 0.4 * sqrt(0.9)) < 1e-6);
}

static void the_back_face_has_the_negated_normal(void **state)
{
    const struct vertex_batch *b;
    (void)state;

    give(light->diffuse, MAT_DIFFUSE, 0.5f, 0.9f);
    ctx->s.lighting.light_model_two_side = true;
    ctx->s.lighting.material[MAT_DIFFUSE][1][0] = 0.4f;
    memcpy(normal, (float[3]){0, 0, -1}, sizeof normal);
    b = run();
    assert_true(b->color[0].c[0][0] == 0);
    assert_true(fabs((double)b->color[1].c[0][0] - 0.2 * 0.8) < 1e-6);
}

static void lights_add_up_and_are_clamped(void **state)
{
    (void)state;
    give(light->ambient, MAT_AMBIENT, 0.5f, 1);
    ctx->s.lighting.light[5] = *light;
    ctx->s.lighting.light[5].ambient[0] = 0.25f;
    expect_red(0.75);
    ctx->s.lighting.light[5].ambient[0] = 2;
    expect_red(1);
}

static void normals_are_transformed_by_the_inverse(void **state)
{
    (void)state;
    give(light->diffuse, MAT_DIFFUSE, 1, 1);
    fgl_matrix_scale(&ctx->modelview.entry[0], 1, 4, 2);
    memcpy(normal, (float[3]){0, 0.6f, 0.8f}, sizeof normal);
    expect_red(0.15 * 0.6 + 0.4 * 0.8);
    ctx->s.transform.normalize = true;
    expect_red((0.15 * 0.6 + 0.4 * 0.8) / sqrt(0.15 * 0.15 + 0.4 * 0.4));
}

static void rescaled_normals(void **state)
{
    (void)state;
    give(light->diffuse, MAT_DIFFUSE, 1, 1);
    fgl_matrix_scale(&ctx->modelview.entry[0], 4, 4, 4);
    expect_red(0.8 / 4);
    ctx->s.transform.rescale_normal = true;
    expect_red(0.8);
}

#define TERM(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
            TERM(emission),
            TERM(scene_ambient),
            TERM(ambient),
            TERM(diffuse_of_a_directional_light),
            TERM(diffuse_of_a_positional_light),
            TERM(attenuation),
            TERM(spot),
            TERM(specular_with_the_viewer_at_infinity),
            TERM(specular_with_a_local_viewer),
            TERM(shininess_is_limited),
            TERM(separate_specular_is_a_color_of_its_own),
            TERM(the_back_face_has_the_negated_normal),
            TERM(lights_add_up_and_are_clamped),
            TERM(normals_are_transformed_by_the_inverse),
            TERM(rescaled_normals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
