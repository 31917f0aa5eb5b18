/* What a term costs, as work and not as time: the vertex kernels are compiled here with operations that are counted. Lights
 * that are disabled, terms that are black, lights at infinity (w = 0) and the infinite viewer add none of the work of what
 * they stand in for. */
#include "vertex_setup.h"

#include "base/arith.h"

enum operation { DOT, ROW, ROOT, QUOTIENT, POWER, COLOR_TERM, OPERATIONS };
static long operations[OPERATIONS];

#define COUNTED1(kind, type, name, T) \
    static inline type counted_##name(T a) { operations[kind]++; return name(a); }
#define COUNTED2(kind, type, name, T, U) \
    static inline type counted_##name(T a, U b) { operations[kind]++; return name(a, b); }
COUNTED2(DOT, real, r_dot3, struct real3, struct real3)
COUNTED2(ROW, real, r_row3, struct real3, const real *)
COUNTED2(ROW, real, r_row4, struct real4, const real *)
COUNTED1(ROOT, real, r_sqrt, real)
COUNTED1(ROOT, real, r_rsqrt, real)
COUNTED1(ROOT, struct real3, r_normalize3, struct real3)
COUNTED1(QUOTIENT, real, r_attenuation, real)
COUNTED2(POWER, real, r_pow, real, real)
COUNTED1(COLOR_TERM, real, r_term, real)

#define r_dot3 counted_r_dot3
#define r_row3 counted_r_row3
#define r_row4 counted_r_row4
#define r_sqrt counted_r_sqrt
#define r_rsqrt counted_r_rsqrt
#define r_normalize3 counted_r_normalize3
#define r_attenuation counted_r_attenuation
#define r_pow counted_r_pow
#define r_term counted_r_term

#undef FGL_ISA
#undef FGL_ARITH
#define FGL_ISA counted
#define FGL_ARITH compatible
#include "vertex/kernels.c"

static struct context *ctx;
static struct vertex_plan *plan;
static struct vertex_batch *batch;
static struct light *light0;

/* One light, directional, with a highlight; normals as they are. */
static int set_up(void **state)
{
    (void)state;
    ctx = new_context();
    plan = calloc(1, sizeof *plan);
    batch = calloc(1, sizeof *batch);
    if (!plan || !batch)
        return -1;
    light0 = &ctx->s.lighting.light[0];
    light0->enabled = true;
    for (int c = 0; c < 3; c++)
        ctx->s.lighting.material[MAT_SPECULAR][0][c] = 1;
    ctx->s.lighting.material[MAT_SHININESS][0][0] = 10;
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    free(batch);
    free(plan);
    free(ctx);
    return 0;
}

/* The operations of one vertex, as whole numbers: all vertices of a group cost the same. */
struct work {
    long of[OPERATIONS];
};

static struct work work_of_a_vertex(void)
{
    struct work work;
    memset(batch, 0, sizeof *batch);
    batch->n = VERTEX_GROUP;
    batch->varying = 1u << ATTR_POSITION | 1u << ATTR_NORMAL;
    for (int i = 0; i < VERTEX_GROUP; i++)
        batch->in[ATTR_POSITION].c[3][i] = batch->in[ATTR_NORMAL].c[2][i] = 1;
    memset(plan, 0, sizeof *plan);
    ctx->dirty = DIRTY_ALL;
    fgl_vertex_validate(plan, ctx, batch->varying, &(const struct framebuffer){.height = 10});
    memset(operations, 0, sizeof operations);
    fgl_vertex_kernels_counted_compatible.run(plan, batch, 0, VERTEX_GROUP, false);
    for (int k = 0; k < OPERATIONS; k++) {
        assert_int_equal(operations[k] % VERTEX_GROUP, 0);
        work.of[k] = operations[k] / VERTEX_GROUP;
    }
    return work;
}

static void same_work(struct work a, struct work b)
{
    for (int k = 0; k < OPERATIONS; k++)
        assert_int_equal(a.of[k], b.of[k]);
}

static void lights_cost_what_is_enabled(void **state)
{
    (void)state;
    light0->enabled = false;
    const struct work none = work_of_a_vertex();
    assert_int_equal(none.of[DOT] + none.of[ROOT] + none.of[POWER] + none.of[COLOR_TERM], 0);
    assert_int_equal(none.of[ROW], 4); /* clip coordinates */
    light0->enabled = true;
    const struct work one = work_of_a_vertex();
    assert_true(one.of[DOT] > 0 && one.of[POWER] == 1 && one.of[COLOR_TERM] == 9);
    for (int i = 1; i < FGL_MAX_LIGHTS; i++) { /* given everything, but not enabled */
        ctx->s.lighting.light[i] = *light0;
        ctx->s.lighting.light[i].position[3] = 1;
        ctx->s.lighting.light[i].spot_cutoff = 30;
        ctx->s.lighting.light[i].enabled = false;
    }
    same_work(work_of_a_vertex(), one);
    ctx->s.lighting.light[5].enabled = true;
    assert_int_equal(work_of_a_vertex().of[POWER], 3);
    ctx->s.lighting.lighting = false;
    same_work(work_of_a_vertex(), none);
}

static void black_terms_cost_nothing(void **state)
{
    (void)state;
    light0->position[3] = 1;
    ctx->s.lighting.light_model_local_viewer = true;
    const struct work shiny = work_of_a_vertex();
    for (int c = 0; c < 3; c++)
        ctx->s.lighting.material[MAT_SPECULAR][0][c] = 0;
    const struct work dull = work_of_a_vertex();
    assert_int_equal(dull.of[POWER], 0);
    assert_int_equal(dull.of[ROOT], 1); /* the vector to the light; of 3 with half vector and viewer */
    assert_int_equal(shiny.of[ROOT], 3);
    assert_int_equal(dull.of[COLOR_TERM], shiny.of[COLOR_TERM] - 3);
    assert_true(dull.of[DOT] < shiny.of[DOT]);
    for (int c = 0; c < 3; c++) /* a black light, though enabled */
        light0->ambient[c] = light0->diffuse[c] = light0->specular[c] = 0;
    const struct work black = work_of_a_vertex();
    light0->enabled = false;
    same_work(work_of_a_vertex(), black);
}

static void directional_lights_have_no_distance(void **state)
{
    (void)state;
    light0->linear_attenuation = 1;
    const struct work directional = work_of_a_vertex();
    assert_int_equal(directional.of[ROOT], 0);
    assert_int_equal(directional.of[QUOTIENT], 0);
    assert_int_equal(directional.of[ROW], 4);  /* clip coordinates; normals stay in object space */
    assert_int_equal(directional.of[POWER], 1); /* the highlight */
    light0->position[3] = 1;
    const struct work positional = work_of_a_vertex();
    assert_int_equal(positional.of[QUOTIENT], 1);
    assert_int_equal(positional.of[ROOT], 3); /* to the light, distance, half vector */
    light0->linear_attenuation = 0;
    assert_int_equal(work_of_a_vertex().of[QUOTIENT], 0);
    assert_int_equal(work_of_a_vertex().of[ROOT], 2);
}

static void the_infinite_viewer_needs_no_eye_coordinates(void **state)
{
    (void)state;
    const struct work infinite = work_of_a_vertex();
    ctx->s.lighting.light_model_local_viewer = true;
    const struct work local = work_of_a_vertex();
    assert_int_equal(infinite.of[ROOT], 0);
    assert_int_equal(local.of[ROOT], 2); /* viewer and half vector */
    assert_true(local.of[ROW] > infinite.of[ROW]);
    ctx->s.lighting.light[1] = *light0;
    assert_int_equal(work_of_a_vertex().of[ROOT], 3); /* the viewer once */
}

static void no_cone_no_power(void **state)
{
    (void)state;
    light0->spot_exponent = 20;
    const struct work open = work_of_a_vertex();
    assert_int_equal(open.of[POWER], 1);
    light0->spot_cutoff = 40;
    const struct work cone = work_of_a_vertex();
    assert_int_equal(cone.of[POWER], 2);
    assert_true(cone.of[DOT] > open.of[DOT]);
}

static void faces_and_normals(void **state)
{
    (void)state;
    const struct work one = work_of_a_vertex();
    ctx->s.transform.normalize = true;
    assert_int_equal(work_of_a_vertex().of[ROOT], 1);
    ctx->s.transform.normalize = false;
    ctx->s.lighting.light_model_two_side = true;
    memcpy(ctx->s.lighting.material[MAT_SPECULAR][1], ctx->s.lighting.material[MAT_SPECULAR][0], 4 * sizeof(float));
    assert_int_equal(work_of_a_vertex().of[COLOR_TERM], 2 * one.of[COLOR_TERM]);
}

#define WORK_TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {WORK_TEST(lights_cost_what_is_enabled),
                                       WORK_TEST(black_terms_cost_nothing),
                                       WORK_TEST(directional_lights_have_no_distance),
                                       WORK_TEST(the_infinite_viewer_needs_no_eye_coordinates),
                                       WORK_TEST(no_cone_no_power),
                                       WORK_TEST(faces_and_normals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
