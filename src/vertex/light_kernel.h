/* The lighting equation (GL 1.5, 2.14.1 "Lighting"), one light at a time. Kernels.
 *
 *   c = e_cm + a_cm * a_cs + sum over the lights of att * spot * (a + (n . VP) d + f (n . h)^s_rm s)
 *
 * With GL_APPLE_specular_vector r . V takes the place of n . h: r is VP reflected at n, V points to the viewer.
 * a, d, s: products of the light's colours and the material's. f is 1 where n . VP > 0, else 0; dots are not
 * negative. Colours are sums here; clamping is 2.14.6 "Clamping or Masking". The order of operations inside
 * is OSMesa's: docs/lighting.md. */
#ifndef FGL_VERTEX_LIGHT_KERNEL_H
#define FGL_VERTEX_LIGHT_KERNEL_H

#include "vertex/work.h"

/* The product of a light's colour and the material, constant or by vertex. */
static FGL_ALWAYS_INLINE struct real3 light_product(const light_numbers *FGL_RESTRICT L,
                                                    struct vertex_work *FGL_RESTRICT work, int face, int i,
                                                    int color, const bool varying)
{
    const real *constant = L->product[face][color], *own = L->color[color];

    if (varying)
        return r_vec3(own[0] * work->material[color][0][i], own[1] * work->material[color][1][i],
                      own[2] * work->material[color][2][i]);
    return r_vec3(constant[0], constant[1], constant[2]);
}

static FGL_ALWAYS_INLINE struct real3 vec3_of(const real v[3])
{
    return r_vec3(v[0], v[1], v[2]);
}

static FGL_ALWAYS_INLINE struct real3 view_direction(const struct lighting_plan *FGL_RESTRICT plan)
{
    const float *v = plan->view_direction;

    return R_EXACT ? r_vec3(0, 0, 1) : r_vec3((real)v[0], (real)v[1], (real)v[2]);
}

#if R_EXACT
/* Which vertices are within the light's cone or on its edge, without a root: the cosine along / |v| by its square. Those
 * that are nearer to the edge than the rounding of this are decided in higher precision. */
static FGL_NOINLINE void find_cone(const struct exact_light *L, struct vertex_work *work, int n, bool positional)
{
    const struct real3 position = vec3_of(L->position), axis = vec3_of(L->spot_direction);
    const real cos_square = L->cos_square.hi, rounding = (real)0x1p-46;
    const double origin[3] = {0, 0, 0};
    uint32_t near = 0;

    if (!positional) {
        const real inside = fgl_cone_contains(L->position, origin, L->axis, L->cos_square);
        for (int i = 0, end = whole_groups(n); i < end; i++)
            work->in_cone[i] = inside;
        return;
    }
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real3 v = r_sub3(load3(work->eye, i), position);
        real along = r_dot3(v, axis), square = r_dot3(v, v), difference = along * along - cos_square * square;
        work->in_cone[i] = r_select((along >= 0) & (difference >= 0), 1, 0);
        near |= (uint32_t)(r_abs(difference) <= rounding * square);
    }
    for (int i = 0; near && i < n; i++) {
        const double to[3] = {work->eye[0][i], work->eye[1][i], work->eye[2][i]};
        work->in_cone[i] = fgl_cone_contains(L->position, to, L->axis, L->cos_square);
    }
}
#endif

/* Whether vertex i, at this cosine, is inside the cone. OSMesa rule: the edge is outside. */
static FGL_ALWAYS_INLINE bool in_cone(const light_numbers *FGL_RESTRICT L, struct vertex_work *FGL_RESTRICT work, int i,
                                      real cosine)
{
#if R_EXACT
    (void)L, (void)cosine;
    return work->in_cone[i] != 0;
#else
    (void)work, (void)i;
    return L->cos_cutoff < cosine;
#endif
}

static FGL_ALWAYS_INLINE struct real3 term3(struct real3 v)
{
    return r_vec3(r_term(v.x), r_term(v.y), r_term(v.z));
}

/* The half vector: the unit vector of a + b, a and b unit vectors. It is normal to a - b: where a + b is small, that
 * removes what the rounding of their lengths left. OSMesa rule: not done. */
static FGL_ALWAYS_INLINE struct real3 half_vector(struct real3 a, struct real3 b, uint32_t *extreme)
{
    struct real3 sum = r_add3(a, b);

    if (R_EXACT) {
        struct real3 d = r_scale3(r_sub3(a, b), (real)0.5);
        sum = r_sub3(sum, r_scale3(d, r_dot3(sum, d)));
    } else {
        *extreme |= outside(r_dot3(sum, sum), SAFE_HALF_SQUARE, SAFE_SQUARE_GREATEST);
    }
    return r_normalize3(sum);
}

/* GL_APPLE_specular_vector: the direction in which light from the unit vector VP leaves a surface. */
static FGL_ALWAYS_INLINE struct real3 reflection_vector(struct real3 normal, struct real3 VP)
{
    return r_sub3(r_scale3(normal, 2 * r_dot3(normal, VP)), VP);
}

/* Notes a term of vertex 0 where terms are asked for. In kernels that draw, `terms` is the constant NULL and
 * this is nothing. */
#define NOTE(field, value)                                                                                   \
    do {                                                                                                     \
        if (terms && i == 0)                                                                                 \
            terms->field = (double)(value);                                                                  \
    } while (0)
#define NOTE3(field, v)                                                                                      \
    do {                                                                                                     \
        struct real3 noted = (v);                                                                            \
        NOTE(field[0], noted.x);                                                                             \
        NOTE(field[1], noted.y);                                                                             \
        NOTE(field[2], noted.z);                                                                             \
    } while (0)

/* Adds one light to the sums of n vertices, for one face: the back face's normal is the negated one. terms:
 * NULL, or where the factors of vertex 0 go. */
static FGL_ALWAYS_INLINE void add_light(const light_numbers *FGL_RESTRICT L,
                                        const struct lighting_plan *FGL_RESTRICT plan, int face,
                                        struct vertex_work *FGL_RESTRICT work, int n, const unsigned key,
                                        struct light_terms *terms)
{
    const bool positional = key & LIGHT_POSITIONAL, attenuated = key & LIGHT_ATTENUATED,
               spotted = key & LIGHT_SPOT;
    const bool specular = key & LIGHT_SPECULAR, local_viewer = key & LIGHT_LOCAL_VIEWER;
    const bool reflection = key & LIGHT_REFLECTION;
    const bool separate = key & LIGHT_SEPARATE, varying = key & LIGHT_VARYING,
               zero = key & LIGHT_ZERO_SHININESS;
    const struct real3 position = vec3_of(L->position), direction = vec3_of(L->direction);
    const struct real3 axis = vec3_of(L->spot_direction), toward_eye = view_direction(plan);
    const real side = face ? -1 : 1;

#if R_EXACT
    if (spotted)
        find_cone(L, work, n, positional);
#endif
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        struct real3 normal = load3(work->normal, i);
        struct real3 VP = direction;
        real att = 1, f_spec = 0;
        uint32_t extreme = 0;

        if (positional) {
            struct real3 to_light = r_sub3(position, load3(work->eye, i));
            real square = r_dot3(to_light, to_light), inverse = r_rsqrt(square);
            VP = r_scale3(to_light, inverse);
            extreme |= outside(square, work->least[i], SAFE_SQUARE_GREATEST);
            NOTE(distance, r_sqrt(square));
            if (attenuated) {
                real d = r_sqrt(square);
                real constant = R_EXACT ? L->k0 : L->k0 * (inverse * d);
                att = r_attenuation((L->k2 * square + L->k1 * d) + constant);
                NOTE(attenuation, att);
            }
        }
        if (spotted) {
            real cosine = -r_dot3(VP, axis);
            real spot = r_select(in_cone(L, work, i, cosine), r_pow(cosine, L->spot_exponent), 0);
            att = attenuated ? att * spot : spot;
#if !R_EXACT
            extreme |= (uint32_t)(r_abs(cosine - L->cos_cutoff) < CONE_EDGE);
#endif
            NOTE(spot_cosine, cosine);
            NOTE(spot, spot);
        }
        real n_dot_VP = side * r_dot3(normal, VP);
        real diffuse = r_max(n_dot_VP, 0);
        NOTE3(VP, VP);
        NOTE(n_dot_VP, n_dot_VP);

        if (specular) {
            const struct real3 to_viewer = local_viewer ? r_scale3(load3(work->view, i), -1) : toward_eye;
            struct real3 h = vec3_of(L->half);
            if (reflection)
                h = reflection_vector(normal, VP);
            else if (local_viewer)
                h = half_vector(VP, to_viewer, &extreme);
            else if (positional)
                h = half_vector(VP, toward_eye, &extreme);
            real n_dot_h = reflection ? r_dot3(h, to_viewer) : side * r_dot3(normal, h);
            real shininess = varying ? work->shininess[i] : (real)plan->shininess[face];
            f_spec = zero ? 1 : r_pow(n_dot_h, shininess);
            f_spec = r_select(n_dot_VP > 0, f_spec, 0);
            NOTE3(half, h);
            NOTE(n_dot_h, n_dot_h);
            NOTE(shininess, shininess);
            NOTE(highlight, f_spec);
        }

        struct real3 c = load3(work->color, i),
                     ambient = light_product(L, work, face, i, COLOR_AMBIENT, varying);
        if (attenuated || spotted) {
            diffuse = diffuse * att;
            f_spec = f_spec * att;
            ambient = r_scale3(ambient, att);
        }
        struct real3 d = r_scale3(light_product(L, work, face, i, COLOR_DIFFUSE, varying), diffuse);
        c = r_add3(term3(ambient), c);
        c = r_add3(term3(d), c);
        NOTE3(ambient, ambient);
        NOTE3(diffuse, d);
        if (specular) {
            struct real3 s = term3(r_scale3(light_product(L, work, face, i, COLOR_SPECULAR, varying), f_spec));
            NOTE3(specular, s);
            if (separate)
                store3(work->specular, i, r_add3(s, load3(work->specular, i)));
            else
                c = r_add3(s, c);
        }
        store3(work->color, i, c);
        if (!R_EXACT && (positional || spotted || local_viewer))
            work->extreme[i] |= extreme;
    }
}
#undef NOTE
#undef NOTE3

/* One lane of a material parameter: the vertices' own, or the constant. */
static FGL_ALWAYS_INLINE void load_parameter(const struct lighting_plan *FGL_RESTRICT plan,
                                             struct vertex_batch *FGL_RESTRICT b, int first, int n,
                                             enum fgl_material parameter, int face, int component,
                                             real *FGL_RESTRICT out)
{
    const int source = plan->source[parameter][face];
    const real constant = (real)plan->material[parameter][face][component];

    if (source < 0) {
        for (int i = 0, end = whole_groups(n); i < end; i++)
            out[i] = constant;
    } else {
        for (int i = 0, end = whole_groups(n); i < end; i++)
            out[i] = (real)b->in[source].c[component][first + i];
    }
}

/* Materials that differ by vertex (GL 1.5, 2.14.2 "Lighting Parameter Specification", 2.14.3
 * "ColorMaterial"): the work space's material of one face, its emission in the sums. */
static FGL_ALWAYS_INLINE void load_materials(const struct lighting_plan *FGL_RESTRICT plan,
                                            struct vertex_batch *FGL_RESTRICT b, int first, int n, int face,
                                            struct vertex_work *FGL_RESTRICT work)
{
    for (int color = 0; color < COLOR_COUNT; color++)
        for (int c = 0; c < 3; c++)
            load_parameter(plan, b, first, n, (enum fgl_material)(MAT_AMBIENT + color), face, c,
                           work->material[color][c]);
    load_parameter(plan, b, first, n, MAT_SHININESS, face, 0, work->shininess);
    for (int c = 0; c < 3; c++)
        load_parameter(plan, b, first, n, MAT_EMISSION, face, c, work->color[c]);
}

/* The same of fragments. */
static FGL_NOINLINE void load_fragment_parameter(const struct lighting_plan *plan, const struct lit_fragments *f,
                                                 enum fgl_material parameter, int face, int component, real *out)
{
    const int source = plan->source[parameter][face];
    int k = 0;

    while (source >= 0 && plan->attribute[k] != source)
        k++;
    for (int i = 0; i < LIT_GROUP; i++)
        out[i] = source < 0 ? (real)plan->material[parameter][face][component] : (real)f->attribute[k][component][i];
}

static void load_fragment_materials(const struct lighting_plan *plan, const struct lit_fragments *f, int face,
                                    struct vertex_work *work)
{
    for (int c = 0; c < 3; c++) {
        for (int color = 0; color < COLOR_COUNT; color++)
            load_fragment_parameter(plan, f, (enum fgl_material)(MAT_AMBIENT + color), face, c, work->material[color][c]);
        load_fragment_parameter(plan, f, MAT_EMISSION, face, c, work->color[c]);
    }
    load_fragment_parameter(plan, f, MAT_SHININESS, face, 0, work->shininess);
}

/* Starts the sums where materials differ by vertex. */
static FGL_ALWAYS_INLINE void start_varying(const struct lighting_plan *FGL_RESTRICT plan, int n,
                                            struct vertex_work *FGL_RESTRICT work)
{
    for (int i = 0, end = whole_groups(n); i < end; i++)
        work->shininess[i] = r_max(r_min(work->shininess[i], FGL_MAX_SHININESS), -FGL_MAX_SHININESS);

    for (int c = 0; c < 3; c++) {
        for (int i = 0, end = whole_groups(n); i < end; i++) {
            work->color[c][i] =
                    r_term((real)plan->model_ambient[c] * work->material[COLOR_AMBIENT][c][i]) +
                    r_term(work->color[c][i]);
            work->specular[c][i] = 0;
        }
    }
}

/* Starts the sums with emission and the scene's ambient light. */
static FGL_ALWAYS_INLINE void start_constant(const real base[3], int n, struct vertex_work *FGL_RESTRICT work)
{
    for (int c = 0; c < 3; c++)
        for (int i = 0, end = whole_groups(n); i < end; i++) {
            work->color[c][i] = base[c];
            work->specular[c][i] = 0;
        }
}

/* Marks vertices whose own material made a term, and so the sums, no number. */
static FGL_ALWAYS_INLINE void mark_not_numbers(struct vertex_work *FGL_RESTRICT work, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++) {
        real total = (work->color[0][i] + work->specular[0][i]) + (work->color[1][i] + work->specular[1][i]) +
                     (work->color[2][i] + work->specular[2][i]);
        work->extreme[i] |= (uint32_t)(total != total);
    }
}

/* The work space of a group of fragments: normals scaled to unit length, positions, views. */
static FGL_NOINLINE void load_fragments(const struct vertex_plan *plan, const struct lit_fragments *f,
                                        struct vertex_work *work)
{
    const bool local_viewer = plan->light.local_viewer;

    for (int i = 0; i < LIT_GROUP; i++) {
        struct real3 normal = r_vec3((real)f->normal[0][i], (real)f->normal[1][i], (real)f->normal[2][i]);
        store3(work->normal, i, r_normalize3(normal));
        work->extreme[i] = outside(r_dot3(normal, normal), SAFE_SQUARE_LEAST, SAFE_SQUARE_GREATEST);
        work->least[i] = SAFE_SQUARE_LEAST;
    }
    for (int i = 0; i < LIT_GROUP && plan->need_eye; i++) {
        struct real3 eye = r_vec3((real)f->eye[0][i], (real)f->eye[1][i], (real)f->eye[2][i]);
        store3(work->eye, i, eye);
        store3(work->view, i, r_normalize3(eye));
        work->extreme[i] |= local_viewer ? outside(r_dot3(eye, eye), SAFE_SQUARE_LEAST, SAFE_SQUARE_GREATEST) : 0u;
    }
}

/* Clamps finished sums (GL 1.5, 2.14.6 "Clamping or Masking"). */
static FGL_ALWAYS_INLINE void clamp_sums(real sum[3][VERTEX_CHUNK], real_lanes4 *FGL_RESTRICT out,
                                         int first, int n)
{
    for (int c = 0; c < 3; c++)
        for (int i = 0, end = whole_groups(n); i < end; i++)
            out->c[c][first + i] = r_clamp01(sum[c][i]);
}

static FGL_ALWAYS_INLINE void clamp_lane(const float *FGL_RESTRICT in, real *FGL_RESTRICT out, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++)
        out[i] = (real)fgl_clamp01(in[i]);
}

static FGL_ALWAYS_INLINE void fill_lane(real value, real *out, int n)
{
    for (int i = 0, end = whole_groups(n); i < end; i++)
        out[i] = value;
}

#endif
