/* Random states and batches for tests of the vertex stage. */
#ifndef TESTS_UNIT_VERTEX_SETUP_H
#define TESTS_UNIT_VERTEX_SETUP_H

#include "unit.h"

#include "framebuffer/framebuffer.h"
#include "vertex/vertex.h"

#include <math.h>

static inline struct context *new_context(void)
{
    struct context *ctx = calloc(1, sizeof *ctx);

    assert_non_null(ctx);
    fgl_state_init(ctx);
    ctx->s.lighting.lighting = true;
    return ctx;
}

static inline struct matrix *modelview(struct context *ctx)
{
    return &ctx->modelview.entry[ctx->modelview.top];
}

static inline void random_color(float c[4])
{
    for (int i = 0; i < 4; i++)
        c[i] = one_of(5) ? between(0, 0.7f) : (float)one_of(2);
}

static inline void random_light(struct light *light)
{
    const float w[4] = {0, 1, between(0.2f, 3), -0.5f};

    light->enabled = one_of(4) != 0;
    random_color(light->ambient);
    random_color(light->diffuse);
    random_color(light->specular);
    if (!one_of(4))
        memset(light->specular, 0, sizeof light->specular);
    for (int i = 0; i < 3; i++) {
        light->position[i] = between(-4, 4);
        light->spot_direction[i] = between(-1, 1);
    }
    light->position[3] = w[one_of(4)];
    for (int i = 0; i < 4; i++) {
        light->exact_position[i] = (double)light->position[i];
        light->exact_spot_direction[i] = i < 3 ? (double)light->spot_direction[i] : 0;
    }
    light->spot_cutoff = one_of(2) ? 180 : between(20, 90);
    light->spot_exponent = one_of(2) ? 0 : between(0, 128);
    light->constant_attenuation = one_of(2) ? 1 : between(0.2f, 1);
    light->linear_attenuation = one_of(2) ? 0 : between(0, 1);
    light->quadratic_attenuation = one_of(2) ? 0 : between(0, 1);
}

static inline void random_lighting(struct lighting_state *state)
{
    static const GLenum parameter[5] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                        GL_AMBIENT_AND_DIFFUSE};
    const int lights = one_of(9);
    const bool dull = !one_of(4);

    for (int i = 0; i < lights; i++)
        random_light(&state->light[i]);
    state->light_model_two_side = one_of(2);
    state->light_model_local_viewer = one_of(2);
    state->light_model_color_control = one_of(2) ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR;
    state->color_material = one_of(2);
    state->color_material_face = one_of(2) ? GL_FRONT_AND_BACK : one_of(2) ? GL_FRONT : GL_BACK;
    state->color_material_parameter = parameter[one_of(5)];
    random_color(state->light_model_ambient);
    for (int face = 0; face < 2; face++) {
        for (int p = MAT_AMBIENT; p <= MAT_EMISSION; p++)
            random_color(state->material[p][face]);
        state->material[MAT_SHININESS][face][0] = dull ? 0 : between(0, 140);
    }
}

static inline void random_state_of(struct context *ctx)
{
    struct matrix *projection = &ctx->projection.entry[ctx->projection.top];

    random_lighting(&ctx->s.lighting);
    if (one_of(4))
        fgl_matrix_rotate(modelview(ctx), between(-180, 180), between(-1, 1), between(-1, 1),
                          between(0.1f, 1));
    if (!one_of(3))
        fgl_matrix_scale(modelview(ctx), between(0.5f, 2), between(0.5f, 2), between(0.5f, 2));
    if (!one_of(3))
        fgl_matrix_scale(modelview(ctx), 0.5f, 0.5f, 0.5f);
    fgl_matrix_translate(modelview(ctx), between(-1, 1), between(-1, 1), between(-1, 1));
    if (one_of(2))
        fgl_matrix_frustum(projection, -1, 1, -1, 1, 1, 10);
    ctx->s.transform.normalize = !one_of(3);
    ctx->s.transform.rescale_normal = !one_of(3);
    ctx->s.transform.clip_plane_enabled = one_of(2) ? 0 : (unsigned)one_of(256);
    for (int i = 0; i < FGL_MAX_CLIP_PLANES; i++)
        random_color(ctx->s.transform.clip_plane[i]);
    ctx->s.viewport.viewport[2] = 100;
    ctx->s.viewport.viewport[3] = 75;
    ctx->s.fog.fog = one_of(2);
    if (!one_of(4))
        ctx->s.point.point_distance_attenuation[1] = 0.5f;
}

/* Which attributes differ by vertex: some selection. */
static inline uint32_t random_varying(void)
{
    uint32_t varying = 1u << ATTR_POSITION;

    varying |= one_of(5) ? 1u << ATTR_NORMAL : 0;
    varying |= one_of(2) ? 1u << ATTR_COLOR : 0;
    return varying | (one_of(4) ? 0 : random_bits() << ATTR_MATERIAL & ((1u << ATTR_COUNT) - 1));
}

/* Ordinary values, with some of the kinds that need care: zeros, w = 0, NaN, infinities, denormals. */
static inline void random_batch(struct vertex_batch *b, uint32_t varying, int n)
{
    static const float special[] = {0, -0.0f, 1, 1e-40f, 1e30f, -1e30f, 1e-30f, INFINITY, NAN};
    const bool edges = !one_of(3);

    b->n = n;
    b->varying = varying;
    for (int attr = 0; attr < ATTR_COUNT; attr++)
        for (int c = 0; c < 4; c++)
            for (int i = 0; i < FGL_BATCH_CAPACITY; i++)
                b->in[attr].c[c][i] = edges && !one_of(12) ? special[one_of(9)] : between(-1, 1);
    for (int i = 0; i < FGL_BATCH_CAPACITY; i++) {
        b->in[ATTR_POSITION].c[3][i] = edges && !one_of(8) ? 0 : one_of(2) ? 1 : between(0.2f, 3);
        if (edges && !one_of(6))
            for (int c = 0; c < 3; c++)
                b->in[ATTR_NORMAL].c[c][i] = 0;
    }
}

#endif
