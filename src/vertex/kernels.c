/* The vertex kernels of one instruction set and one arithmetic, and the order in which a plan runs them.
 *
 * The build compiles this file once for each instruction set, with FGL_ISA naming it (sse2, avx2, avx512;
 * base elsewhere) and the compiler's options to match, and for each arithmetic, with FGL_ARITH naming it. A kernel is
 * written once, always inlined with constant flags, and instantiated here by one-line wrappers. */
#include "base/cpu.h"
#include "vertex/emit_kernel.h"
#include "vertex/index_kernel.h"
#include "vertex/light_kernel.h"
#include "vertex/texgen_kernel.h"

#define STRING_OF(isa) #isa
#define ISA_STRING(isa) STRING_OF(isa)

/* Normals: [to eye space][scaling] */

typedef void normal_fn(const struct vertex_plan *FGL_RESTRICT plan, struct vertex_work *FGL_RESTRICT work,
                       int n);

#define NORMAL_KERNEL(name, to_eye, scaling)                                                                 \
    static void name(const struct vertex_plan *FGL_RESTRICT plan, struct vertex_work *FGL_RESTRICT work,     \
                     int n)                                                                                  \
    {                                                                                                        \
        transform_normals(plan, work, n, to_eye, scaling);                                                   \
    }
NORMAL_KERNEL(normals_object, false, NORMAL_AS_IS)
NORMAL_KERNEL(normals_object_normalize, false, NORMAL_NORMALIZE)
NORMAL_KERNEL(normals_eye, true, NORMAL_AS_IS)
NORMAL_KERNEL(normals_eye_rescale, true, NORMAL_RESCALE)
NORMAL_KERNEL(normals_eye_normalize, true, NORMAL_NORMALIZE)
NORMAL_KERNEL(normals_general, R_EXACT || plan->normal_in_eye_space, PLAN_NUMBERS(plan)->normal_scaling)

static normal_fn *const normal_kernel[2][3] = {
        {normals_object, normals_general, normals_object_normalize},
        {normals_eye, normals_eye_rescale, normals_eye_normalize},
};

/* Lights: by key. The digits of a name are the bits of enum light_key, lowest first. Rare keys have no kernel
 * of their own. */

typedef void light_fn(const light_numbers *light, unsigned key, const struct lighting_plan *plan, int face,
                      struct vertex_work *work, int n);

#define EACH_MATERIAL(M, p, a, s, c, v, x) M(p, a, s, c, v, x, 0, 0) M(p, a, s, c, v, x, 0, 1)
#define EACH_SPECULAR(M, p, a, s)                                                                            \
    EACH_MATERIAL(M, p, a, s, 0, 0, 0)                                                                       \
    EACH_MATERIAL(M, p, a, s, 1, 0, 0)                                                                       \
    EACH_MATERIAL(M, p, a, s, 1, 1, 0)                                                                       \
    EACH_MATERIAL(M, p, a, s, 1, 0, 1)                                                                       \
    EACH_MATERIAL(M, p, a, s, 1, 1, 1)                                                                       \
    M(p, a, s, 1, 0, 0, 1, 0)                                                                                \
    M(p, a, s, 1, 0, 1, 1, 0)
#define EACH_LIGHT(M)                                                                                        \
    EACH_SPECULAR(M, 0, 0, 0)                                                                                \
    EACH_SPECULAR(M, 0, 0, 1)                                                                                \
    EACH_SPECULAR(M, 1, 0, 0)                                                                                \
    EACH_SPECULAR(M, 1, 0, 1)                                                                                \
    EACH_SPECULAR(M, 1, 1, 0)                                                                                \
    EACH_SPECULAR(M, 1, 1, 1)

#define LIGHT_KEY(p, a, s, c, v, x, z, m) (p | a << 1 | s << 2 | c << 3 | v << 4 | x << 5 | z << 6 | m << 7)
#define LIGHT_KERNEL(p, a, s, c, v, x, z, m)                                                                 \
    static void light_##p##a##s##c##v##x##z##m(const light_numbers *FGL_RESTRICT light, unsigned key,         \
                                               const struct lighting_plan *FGL_RESTRICT plan, int face,      \
                                               struct vertex_work *FGL_RESTRICT work, int n)                 \
    {                                                                                                        \
        (void)key;                                                                                           \
        add_light(light, plan, face, work, n, LIGHT_KEY(p, a, s, c, v, x, z, m), NULL);                      \
    }
EACH_LIGHT(LIGHT_KERNEL)

#define LIGHT_ENTRY(p, a, s, c, v, x, z, m)                                                                  \
    [LIGHT_KEY(p, a, s, c, v, x, z, m)] = light_##p##a##s##c##v##x##z##m,
static light_fn *const light_kernel[LIGHT_KEY_COUNT] = {EACH_LIGHT(LIGHT_ENTRY)};

static void light_general(const light_numbers *FGL_RESTRICT light, unsigned key,
                          const struct lighting_plan *FGL_RESTRICT plan, int face,
                          struct vertex_work *FGL_RESTRICT work, int n)
{
    add_light(light, plan, face, work, n, key, NULL);
}

/* The general kernel, noting the terms of the first vertex. */
static FGL_NOINLINE void light_noted(const light_numbers *light, unsigned key,
                                     const struct lighting_plan *plan, int face, struct vertex_work *work, int n, struct face_trace *trace,
                                     int index)
{
    struct light_terms *terms = &trace->light[index];
    *terms = (struct light_terms){.attenuation = 1, .spot = 1};
    add_light(light, plan, face, work, n, key, terms);
}

static void note3(double to[3], real from[3][VERTEX_CHUNK])
{
    for (int c = 0; c < 3; c++)
        to[c] = (double)from[c][0];
}

/* The stages of a chunk, in the specification's order */

static void run_positions(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n)
{
    transform_positions(plan, b, first, n);
#if R_EXACT
    real_lanes4 *position = &b->exact.eye;
    if (plan->user_planes)
        keep_eye(plan, b, first, n);
#else
    real_lanes4 *position = &b->clip;
#endif
    for (int i = 0; i < FGL_MAX_CLIP_PLANES; i++)
        if (plan->user_planes >> i & 1)
            test_user_plane(PLAN_NUMBERS(plan)->user_plane[i], position, (uint32_t)CLIP_USER0 << i, b, first, n);
}

static void run_normals(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n,
                        struct vertex_work *work, bool general)
{
    normal_fn *kernel =
            general ? normals_general
                    : normal_kernel[R_EXACT || plan->normal_in_eye_space][PLAN_NUMBERS(plan)->normal_scaling];

    load_normals(plan, b, first, n, work);
    kernel(plan, work, n);
}

/* Adds the plan's lights to sums that were started. trace: NULL, or where the terms of the first vertex go. */
static void add_lights(const struct vertex_plan *vertex, int n, int face, struct vertex_work *work, bool general,
                       struct face_trace *trace)
{
    const struct lighting_plan *plan = &vertex->light;
    const light_numbers *lights = PLAN_LIGHTS(vertex);

    if (trace)
        note3(trace->base, work->color);
    for (int i = 0; i < plan->n; i++) {
        const light_numbers *light = &lights[i];
        const unsigned key = plan->light[i].key;
        light_fn *kernel = general ? NULL : light_kernel[key];
        if (trace)
            light_noted(light, key, plan, face, work, n, trace, i);
        else
            (kernel ? kernel : light_general)(light, key, plan, face, work, n);
    }
    if (!R_EXACT && plan->varying)
        mark_not_numbers(work, n);
    if (trace) {
        note3(trace->sum, work->color);
        note3(trace->specular_sum, work->specular);
    }
}

/* Lights one face into color[face] and secondary[face]. trace: NULL but for fgl_vertex_trace. */
static void run_face(const struct vertex_plan *vertex, struct vertex_batch *b, int first, int n, int face,
                     struct vertex_work *work, bool general, struct face_trace *trace)
{
    const struct lighting_plan *plan = &vertex->light;
    const int alpha = plan->source[MAT_DIFFUSE][face];
    real_lanes4 *color = &RESULTS(b)->color[face];

    if (plan->varying) {
        load_materials(plan, b, first, n, face, work);
        start_varying(plan, n, work);
    } else {
        start_constant(PLAN_BASE(vertex, face), n, work);
    }
    add_lights(vertex, n, face, work, general, trace);

    if (vertex->color_index) {
        light_indexes(plan, b, first, n, face, work);
        return;
    }
    clamp_sums(work->color, color, first, n);
    if (alpha < 0)
        fill_lane((real)fgl_clamp01(plan->base[face][3]), color->c[3] + first, n);
    else
        clamp_lane(b->in[alpha].c[3] + first, color->c[3] + first, n);
    if (plan->separate_specular)
        clamp_sums(work->specular, &RESULTS(b)->secondary[face], first, n);
}

/* Texture coordinates that are computed. They always use eye space: OSMesa rule. */
static void run_textures(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, bool general)
{
    struct vertex_work work;
    if (plan->texgen_eye)
        transform_eye(plan, b, first, n, &work);
    if (plan->texgen_normal)
        run_normals(plan, b, first, n, &work, general);
    for (int k = 0; k < plan->textures; k++)
        if (plan->texture[k].computed)
            run_texture(plan, b, k, &work, first, n);
}

static void run_colors(struct vertex_batch *b, int first, int n)
{
    for (int c = 0; c < 4; c++)
        clamp_lane(b->in[ATTR_COLOR].c[c] + first, RESULTS(b)->color[0].c[c] + first, n);
}

static void spread_color(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n)
{
    for (int c = 0; c < 4; c++)
        for (int i = first; i < first + n; i++)
            RESULTS(b)->color[0].c[c][i] = (real)fgl_clamp01(plan->constant[ATTR_COLOR][c]);
}

/* Returns whether a vertex is extreme. */
static bool gather_extremes(struct vertex_work *work, struct vertex_batch *b, int first, int n)
{
    uint32_t any = 0;

    for (int i = 0; i < n; i++)
        any |= b->extreme[first + i] = work->extreme[i];
    return any != 0;
}

/* Lighting per fragment: what it reads. */
static void hand_over(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, struct vertex_work *work)
{
    real_lanes4 *normal = &RESULTS(b)->lit_normal, *eye = &RESULTS(b)->lit_eye;

    for (int c = 0; c < 3 && plan->need_normal; c++)
        memcpy(normal->c[c] + first, work->normal[c], (size_t)n * sizeof(real));
    for (int c = 0; c < 3 && plan->need_eye; c++)
        memcpy(eye->c[c] + first, work->eye[c], (size_t)n * sizeof(real));
}

/* Fragments are lit as vertices with their normals scaled to unit length. */
static bool light_fragments(const struct vertex_plan *vertex, struct lit_fragments *f, struct face_trace *trace,
                            uint32_t extreme[LIT_GROUP])
{
    const struct lighting_plan *plan = &vertex->light;
    const int n = LIT_GROUP, face = plan->two_sided && f->back;
    struct vertex_work work;
    uint32_t any = 0;

    load_fragments(vertex, f, &work);
    if (plan->varying) {
        load_fragment_materials(plan, f, face, &work);
        start_varying(plan, n, &work);
    } else {
        start_constant(PLAN_BASE(vertex, face), n, &work);
    }
    add_lights(vertex, n, face, &work, false, trace);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < n; i++)
            f->color[c][i] = (double)r_clamp01(work.color[c][i]);
    for (int c = 0; c < 3 && plan->separate_specular; c++)
        for (int i = 0; i < n; i++)
            f->secondary[c][i] = (double)r_clamp01(work.specular[c][i]);
    load_fragment_parameter(plan, f, MAT_DIFFUSE, face, 3, work.color[0]);
    for (int i = 0; i < n; i++)
        f->color[3][i] = (double)r_clamp01(work.color[0][i]);
    for (int i = 0; i < n; i++)
        any |= extreme[i] = R_EXACT ? 0u : work.extreme[i];
    return any != 0;
}

/* n: whole groups; count: those that are vertices. */
static bool run_lighting(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, int count,
                         bool general, struct vertex_trace *trace)
{
    struct vertex_work work;

    if (!R_EXACT)
        memset(work.extreme, 0, sizeof work.extreme);
    if (plan->need_eye || trace)
        transform_eye(plan, b, first, n, &work);
    if (trace)
        note3(trace->eye, work.eye);
    if (plan->need_eye && !R_EXACT)
        check_eye(plan, b, first, n, &work);
    if (plan->need_eye && plan->need_view)
        normalize_view(&work, n);
    if (plan->need_normal)
        run_normals(plan, b, first, n, &work, general);
    if (trace && plan->need_normal)
        note3(trace->normal, work.normal);
    if (plan->light_fragments && !trace)
        hand_over(plan, b, first, n, &work);
    for (int face = 0; face <= plan->light.two_sided && (trace || !plan->light_fragments); face++)
        run_face(plan, b, first, n, face, &work, general, trace ? &trace->face[face] : NULL);
    return !R_EXACT && gather_extremes(&work, b, first, count);
}

static void trace_eye(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n,
                      struct vertex_trace *trace)
{
    struct vertex_work work;

    transform_eye(plan, b, first, n, &work);
    note3(trace->eye, work.eye);
}

/* All but positions. */
static bool shade_chunk(const struct vertex_plan *plan, struct vertex_batch *b, int first, int count, bool general,
                        struct vertex_trace *trace)
{
    const int n = whole_groups(count + VERTEX_GROUP - 1);

    if (plan->need_fog_z)
        eye_distance(plan, b, first, n, RESULTS(b)->fog_z);
    if (plan->need_fog_coord)
        given_fog_coord(plan, b, first, n, RESULTS(b)->fog_z);
    if (plan->need_point_size)
        point_sizes(plan, b, first, n);
    if (plan->color_is_varying)
        run_colors(b, first, n);
    else if (plan->color_is_spread)
        spread_color(plan, b, first, n);
    for (int c = 0; c < 3 && plan->secondary_is_varying; c++)
        clamp_lane(b->in[ATTR_SECONDARY_COLOR].c[c] + first, RESULTS(b)->secondary[0].c[c] + first, n);
    if (plan->index_is_varying)
        mask_lane(b->in[ATTR_INDEX].c[0] + first, RESULTS(b)->color[0].c[0] + first, n);
    if (plan->textures)
        run_textures(plan, b, first, n, general);
    if (plan->lighting)
        return run_lighting(plan, b, first, n, count, general, trace);
    if (trace)
        trace_eye(plan, b, first, n, trace);
    return false;
}

static void positions(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n)
{
    run_positions(plan, b, first, whole_groups(n + VERTEX_GROUP - 1));
}

static bool shade(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, bool general)
{
    return shade_chunk(plan, b, first, n, general, NULL);
}

static bool run(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, bool general)
{
    positions(plan, b, first, n);
    return shade_chunk(plan, b, first, n, general, NULL);
}

static void light(const struct vertex_plan *plan, struct vertex_batch *b, int first, int n, bool general)
{
    (void)run_lighting(plan, b, first, whole_groups(n + VERTEX_GROUP - 1), n, general, NULL);
}

static bool trace_vertex(const struct vertex_plan *plan, struct vertex_batch *b, struct vertex_trace *trace)
{
    positions(plan, b, 0, 1);
    return shade_chunk(plan, b, 0, 1, true, trace);
}

extern const struct vertex_kernels FGL_KERNELS(vertex);
const struct vertex_kernels FGL_KERNELS(vertex) = {
        .isa = ISA_STRING(FGL_ISA),
        .run = run,
        .positions = positions,
        .shade = shade,
        .light = light,
        .light_fragments = light_fragments,
        .trace = trace_vertex,
        .emit = emit,
        .emit_positions = emit_positions,
        .emit_attributes = emit_attributes,
};
