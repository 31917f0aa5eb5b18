/* The vertex kernels: every instruction set that this CPU has, specialised and general, gives the bits of a
 * plain scalar transcription of the rules; nothing is written behind the spare elements. */
#include "fixedgl.h"
#include "vertex_setup.h"

#include "base/arith.h"
#include "base/cpu.h"

/* The transcription: one vertex, straight from docs/lighting.md, no kernels. */

struct lit {
    float color[4], secondary[3];
};

static void row4(float out[4], const float m[16], const struct vertex_batch *b, int i, int rows)
{
    for (int r = 0; r < rows; r++) {
        float t = b->in[ATTR_POSITION].c[0][i] * m[r];
        t = b->in[ATTR_POSITION].c[1][i] * m[4 + r] + t;
        t = b->in[ATTR_POSITION].c[2][i] * m[8 + r] + t;
        out[r] = b->in[ATTR_POSITION].c[3][i] * m[12 + r] + t;
    }
}

static float dot(const float a[3], const float b[3])
{
    return (a[2] * b[2] + a[1] * b[1]) + a[0] * b[0];
}

static void normalize(float v[3])
{
    const float s = 1.0f / sqrtf(dot(v, v));

    for (int c = 0; c < 3; c++)
        v[c] *= s;
}

static void reference_normal(const struct vertex_plan *plan, const struct vertex_batch *b, int i, float n[3])
{
    float given[3];

    for (int c = 0; c < 3; c++)
        n[c] = given[c] = plan->varying >> ATTR_NORMAL & 1 ? b->in[ATTR_NORMAL].c[c][i]
                                                           : plan->constant[ATTR_NORMAL][c];
    if (plan->normal_in_eye_space)
        for (int r = 0; r < 3; r++)
            n[r] = dot(given, plan->normal_matrix[r]);
    if (plan->normal_scaling == NORMAL_NORMALIZE)
        normalize(n);
    if (plan->normal_scaling == NORMAL_RESCALE)
        for (int c = 0; c < 3; c++)
            n[c] *= plan->rescale_factor;
}

static float material(const struct lighting_plan *plan, const struct vertex_batch *b, int i, int parameter,
                      int face, int c)
{
    const int source = plan->source[parameter][face];
    return source < 0 ? plan->material[parameter][face][c] : b->in[source].c[c][i];
}

static void reference_light(const struct light_derived *L, const struct vertex_plan *vertex,
                            const struct vertex_batch *b, int i, int face, const float n[3], struct lit *out)
{
    const struct lighting_plan *plan = &vertex->light;
    const bool attenuated = L->key & LIGHT_ATTENUATED, spot = L->key & LIGHT_SPOT;
    float eye[4], VP[3], h[3], att = 1, f_spec = 0;

    memcpy(VP, L->direction, sizeof VP);
    memcpy(h, L->half, sizeof h);
    row4(eye, vertex->modelview, b, i, 3);
    if (L->key & LIGHT_POSITIONAL) {
        for (int c = 0; c < 3; c++)
            VP[c] = L->position[c] - eye[c];
        const float d2 = dot(VP, VP), d = sqrtf(d2), r = 1.0f / d;
        normalize(VP);
        if (attenuated)
            att = 1.0f / ((L->k2 * d2 + L->k1 * d) + L->k0 * (r * d));
    }
    if (spot) {
        const float t = -dot(VP, L->spot_direction),
                    s = L->cos_cutoff < t ? r_pow(t, L->spot_exponent) : 0.0f;
        att = attenuated ? att * s : s;
    }
    if (plan->local_viewer) {
        normalize(eye);
        for (int c = 0; c < 3; c++)
            h[c] = VP[c] - eye[c];
        normalize(h);
    } else if (L->key & LIGHT_POSITIONAL) {
        for (int c = 0; c < 3; c++)
            h[c] = VP[c] + plan->view_direction[c];
        normalize(h);
    }

    const float n_dot_VP = face ? -dot(n, VP) : dot(n, VP), n_dot_h = face ? -dot(n, h) : dot(n, h);
    const float shininess = fmaxf(fminf(material(plan, b, i, MAT_SHININESS, face, 0), 128), -128);
    float diffuse = n_dot_VP > 0 ? n_dot_VP : 0;
    if (n_dot_VP > 0)
        f_spec = plan->shininess_all_zero ? 1 : r_pow(n_dot_h, shininess);
    if (attenuated || spot) {
        diffuse *= att;
        f_spec *= att;
    }
    for (int c = 0; c < 3; c++) {
        const float A = L->color[0][c] * material(plan, b, i, MAT_AMBIENT, face, c);
        const float D = L->color[1][c] * material(plan, b, i, MAT_DIFFUSE, face, c);
        const float S = L->color[2][c] * material(plan, b, i, MAT_SPECULAR, face, c);
        out->color[c] = (attenuated || spot ? att * A : A) + out->color[c];
        out->color[c] = diffuse * D + out->color[c];
        if (L->key & LIGHT_SPECULAR)
            *(plan->separate_specular ? &out->secondary[c] : &out->color[c]) += f_spec * S;
    }
}

static void reference_color(const struct vertex_plan *plan, const struct vertex_batch *b, int i, int face,
                            struct lit *out)
{
    const struct lighting_plan *light = &plan->light;
    float n[3];

    reference_normal(plan, b, i, n);
    memset(out, 0, sizeof *out);
    for (int c = 0; c < 3; c++)
        out->color[c] = light->model_ambient[c] * material(light, b, i, MAT_AMBIENT, face, c) +
                        material(light, b, i, MAT_EMISSION, face, c);
    out->color[3] = material(light, b, i, MAT_DIFFUSE, face, 3);
    for (int k = 0; k < light->n; k++)
        reference_light(&light->light[k], plan, b, i, face, n, out);
    for (int c = 0; c < 4; c++)
        out->color[c] = fgl_clamp01(out->color[c]);
    for (int c = 0; c < 3; c++)
        out->secondary[c] = fgl_clamp01(out->secondary[c]);
}

static uint32_t reference_outcode(const struct vertex_plan *plan, const float clip[4])
{
    const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
    uint32_t code = (x > w ? 1u : 0) | (x + w < 0 ? 2u : 0) | (y > w ? 4u : 0) | (y + w < 0 ? 8u : 0) |
                    (z + w < 0 ? 16u : 0) | (z > w ? 32u : 0);

    for (int p = 0; p < FGL_MAX_CLIP_PLANES; p++) {
        const float *plane = plan->user_plane[p];
        if (plan->user_planes >> p & 1 &&
            fmaf(plane[3], w, fmaf(plane[2], z, fmaf(plane[1], y, plane[0] * x))) < 0)
            code |= 64u << p;
    }
    return code;
}

/* Comparison
 * ------------------------------------------------------------------------------------------------- */

static int set, vertex; /* of the check under way */
static const char *kernels_name;

static void expect(const char *what, float expected, float found)
{
    if (!same_float(expected, found))
        fail_msg("set %d, %s, vertex %d, %s: %a, expected %a", set, kernels_name, vertex, what, (double)found,
                 (double)expected);
}

static void check_vertex(const struct vertex_plan *plan, const struct vertex_batch *b, int i)
{
    float clip[4];

    vertex = i;
    row4(clip, plan->mvp, b, i, 4);
    for (int c = 0; c < 4; c++)
        expect("clip", clip[c], b->clip.c[c][i]);
    const float oow = 1.0f / clip[3];
    expect("1/w", oow, b->win.c[3][i]);
    for (int c = 0; c < 3; c++)
        expect("window", fmaf(clip[c] * oow, plan->viewport_scale[c], plan->viewport_trans[c]),
               b->win.c[c][i]);
    assert_int_equal(b->outcode[i], reference_outcode(plan, clip));
    for (int face = 0; face <= plan->light.two_sided; face++) {
        struct lit lit;
        reference_color(plan, b, i, face, &lit);
        for (int c = 0; c < 4; c++)
            expect(face ? "back color" : "color", lit.color[c], b->color[face].c[c][i]);
        for (int c = 0; c < 3 && plan->light.separate_specular; c++)
            expect("secondary", lit.secondary[c], b->secondary[face].c[c][i]);
    }
}

/* Guards behind the spare elements of every lane that is written: the next lane begins there, so a guard is
 * the next lane's first element; and of a lane of a batch that is not full, all behind the spare ones. */
static void check_untouched(const struct vertex_batch *b, int n)
{
    const struct lanes4 *out[] = {&b->clip,     &b->win,          &b->color[0],
                                  &b->color[1], &b->secondary[0], &b->secondary[1]};
    const int end = n + FGL_BATCH_PAD;

    for (size_t k = 0; k < sizeof out / sizeof *out; k++)
        for (int c = 0; c < 4; c++)
            for (int i = end; i < FGL_BATCH_CAPACITY; i++)
                assert_true(out[k]->c[c][i] == -77.0f);
    for (int i = end; i < FGL_BATCH_CAPACITY; i++)
        assert_true(b->fog_z[i] == -77.0f && b->point_size[i] == -77.0f && b->outcode[i] == 7777);
}

static void fill_outputs(struct vertex_batch *b)
{
    struct lanes4 *out[] = {&b->clip,     &b->win,          &b->color[0],
                            &b->color[1], &b->secondary[0], &b->secondary[1]};

    for (int i = 0; i < FGL_BATCH_CAPACITY; i++) {
        for (size_t k = 0; k < sizeof out / sizeof *out; k++)
            for (int c = 0; c < 4; c++)
                out[k]->c[c][i] = -77.0f;
        b->fog_z[i] = b->point_size[i] = -77.0f;
        b->outcode[i] = 7777;
    }
}

static void run_one_set(int n)
{
    struct context *ctx = new_context();
    struct vertex_plan *plan = calloc(1, sizeof *plan);
    struct vertex_batch *batch = calloc(1, sizeof *batch);

    assert_true(plan && batch);
    random_seed(set);
    random_state_of(ctx);
    random_batch(batch, random_varying(), n);
    fgl_vertex_validate(plan, ctx, batch->varying, &(const struct framebuffer){.height = 75});
    for (int isa = 0; isa < FGL_ISA_COUNT; isa++)
        for (int general = 0; general < 2 && fgl_vertex_kernels_of((enum fgl_isa)isa, ARITH_COMPATIBLE); general++) {
            const struct vertex_kernels *kernels = fgl_vertex_kernels_of((enum fgl_isa)isa, ARITH_COMPATIBLE);
            kernels_name = general ? "general" : kernels->isa;
            fill_outputs(batch);
            for (int first = 0; first < n; first += VERTEX_CHUNK)
                kernels->run(plan, batch, first, fgl_min(n - first, VERTEX_CHUNK), general);
            for (int i = 0; i<n; i += n> 64 ? 7 : 1)
                check_vertex(plan, batch, i);
            check_untouched(batch, n);
        }
    free(batch);
    free(plan);
    free(ctx);
}

/* The same bits, or both no number. */
static void same_lanes(const struct lanes4_exact *a, const struct lanes4_exact *b, int n)
{
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            if (!isnan(a->c[c][i]) || !isnan(b->c[c][i]))
                assert_memory_equal(&a->c[c][i], &b->c[c][i], sizeof(double));
}

/* Colours and positions of every set and path are those of the first. */
static void exact_sets_agree(int n)
{
    static struct vertex_batch first;
    struct context *ctx = new_context();
    struct vertex_plan *plan = calloc(1, sizeof *plan);
    struct vertex_batch *batch = calloc(1, sizeof *batch);

    assert_true(plan && batch);
    random_seed(set);
    random_state_of(ctx);
    random_batch(batch, random_varying(), n);
    ctx->accuracy = FIXEDGL_EXACT;
    fgl_vertex_validate(plan, ctx, batch->varying, &(const struct framebuffer){.height = 75});
    memset(&first, 0, sizeof first);
    for (int isa = 0; isa < FGL_ISA_COUNT; isa++)
        for (int general = 0; general < 2 && fgl_vertex_kernels_of((enum fgl_isa)isa, ARITH_EXACT); general++) {
            memset(&batch->clip, 0, sizeof *batch - offsetof(struct vertex_batch, clip));
            for (int i = 0; i < n; i += VERTEX_CHUNK)
                fgl_vertex_kernels_of((enum fgl_isa)isa, ARITH_EXACT)->run(plan, batch, i, fgl_min(n - i, VERTEX_CHUNK), general);
            if (isa == 0 && !general)
                memcpy(&first, batch, sizeof first);
            same_lanes(&batch->exact.win, &first.exact.win, n);
            same_lanes(&batch->exact.eye, &first.exact.eye, n);
            same_lanes(&batch->exact.color[0], &first.exact.color[0], n);
            same_lanes(&batch->exact.color[1], &first.exact.color[1], n);
            same_lanes(&batch->exact.secondary[0], &first.exact.secondary[0], n);
        }
    free(batch);
    free(plan);
    free(ctx);
}

static void exact_kernels_agree(void **state)
{
    (void)state;
    for (set = 0; set < 400; set++)
        exact_sets_agree(set % 3 ? 40 : 300);
}

static void kernels_agree_with_the_transcription(void **state)
{
    static const int counts[] = {40, 1, 15, 16, 17, 40, 255, 256, 257, 40, FGL_BATCH_SIZE, 0};
    (void)state;

    for (set = 0; set < 600; set++)
        run_one_set(counts[set % 12]);
}

static void a_batch_has_its_outcodes_summed_up(void **state)
{
    struct context *ctx = new_context();
    struct vertex_plan *plan = calloc(1, sizeof *plan);
    struct vertex_batch *b = calloc(1, sizeof *b);
    (void)state;

    ctx->s.lighting.lighting = false;
    fgl_vertex_validate(plan, ctx, 1u << ATTR_POSITION, &(const struct framebuffer){.height = 10});
    fgl_vertex_run(plan, b, false);
    assert_int_equal(b->outcode_any, 0);
    assert_int_equal(b->outcode_all, 0);
    b->n = 2;
    for (int i = 0; i < 2; i++) {
        b->in[ATTR_POSITION].c[0][i] = 5;
        b->in[ATTR_POSITION].c[1][i] = i ? 5 : 0;
        b->in[ATTR_POSITION].c[3][i] = 1;
    }
    b->in[ATTR_POSITION].c[2][2] = 99; /* behind the last vertex: counts for nothing */
    fgl_vertex_run(plan, b, false);
    assert_int_equal(b->outcode_any, CLIP_RIGHT | CLIP_TOP);
    assert_int_equal(b->outcode_all, CLIP_RIGHT);
    free(b);
    free(plan);
    free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(kernels_agree_with_the_transcription),
                                       cmocka_unit_test(exact_kernels_agree),
                                       cmocka_unit_test(a_batch_has_its_outcodes_summed_up)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
