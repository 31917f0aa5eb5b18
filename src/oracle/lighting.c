/*
 * The equation of GL 1.5, 2.14.1 "Lighting", term by term, and our answers where it has none:
 *
 *   light at the vertex                  VP = 0: only its ambient term; the spot's cosine is 0
 *   attenuation with denominator 0       the largest finite float
 *   vertex at the eye, local viewer      VPe = 0: h = VP
 *   h = 0, normal 0, spot direction 0    the dot product is 0
 *   0 to the power 0                     1
 *   singular modelview matrix            with GL_NORMALIZE its cofactors stand for the inverse, else normals
 * are 0 a term that is NaN                   counts as 0 colors outside [0,1]                 clamped at the
 * end only: primary, secondary, then their sum
 */
#include "oracle/lighting.h"

struct vec3 {
    quad x, y, z;
};

struct vec4 {
    quad x, y, z, w;
};

static struct vec3 add(struct vec3 a, struct vec3 b)
{
    return (struct vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static struct vec3 scale(quad s, struct vec3 v)
{
    return (struct vec3){s * v.x, s * v.y, s * v.z};
}

static struct vec3 negate(struct vec3 v)
{
    return (struct vec3){-v.x, -v.y, -v.z};
}

static quad absolute(quad x)
{
    return x < 0 ? -x : x;
}

/* A sum that cancels down to the rounding of its terms is 0: on the horizon, singular. */
static quad sum3(quad a, quad b, quad c)
{
    const quad s = a + b + c;
    return absolute(s) < (quad)0x1p-105 * (absolute(a) + absolute(b) + absolute(c)) ? 0 : s;
}

static quad dot(struct vec3 a, struct vec3 b)
{
    return sum3(a.x * b.x, a.y * b.y, a.z * b.z);
}

static struct vec3 cross(struct vec3 a, struct vec3 b)
{
    return (struct vec3){sum3(a.y * b.z, -a.z * b.y, 0), sum3(a.z * b.x, -a.x * b.z, 0),
                         sum3(a.x * b.y, -a.y * b.x, 0)};
}

static quad length(struct vec3 v)
{
    return quad_sqrt(dot(v, v));
}

static struct vec3 unit_or_zero(struct vec3 v)
{
    const quad l = length(v);
    return l == 0 ? v : scale(1 / l, v);
}

static bool is_finite(quad x)
{
    return x - x == 0;
}

static quad least(quad a, quad b)
{
    return b < a ? b : a;
}

static quad clamp01(quad x)
{
    return !(x > 0) ? 0 : x > 1 ? 1 : x;
}

/* ---- transformation ---- */

/* GL 1.5, 2.11: matrices are column-major, m[4 * column + row]. */
static struct vec4 transform(const float m[16], const float v[4])
{
    quad r[4];
    for (int row = 0; row < 4; row++)
        r[row] = (quad)m[row] * (quad)v[0] + (quad)m[4 + row] * (quad)v[1] + (quad)m[8 + row] * (quad)v[2] +
                 (quad)m[12 + row] * (quad)v[3];
    return (struct vec4){r[0], r[1], r[2], r[3]};
}

static struct vec3 column(const float m[16], int c)
{
    return (struct vec3){(quad)m[4 * c], (quad)m[4 * c + 1], (quad)m[4 * c + 2]};
}

static struct vec3 transform_direction(const float m[16], const float v[3])
{
    return add(add(scale((quad)v[0], column(m, 0)), scale((quad)v[1], column(m, 1))),
               scale((quad)v[2], column(m, 2)));
}

/* 2.14.1: the vector from P1 to P2, either of which may be a direction (w = 0). */
static struct vec3 from_to(struct vec4 p1, struct vec4 p2)
{
    const struct vec3 a = {p1.x, p1.y, p1.z}, b = {p2.x, p2.y, p2.z};
    if (p1.w != 0 && p2.w != 0)
        return add(scale(1 / p2.w, b), negate(scale(1 / p1.w, a)));
    if (p1.w != 0)
        return b;
    if (p2.w != 0)
        return negate(a);
    return add(b, negate(a));
}

/* 2.11.3 "Normal Transformation": n times the inverse of the upper 3x3 of the modelview matrix, rescaled by
 * the length of the third row of the inverse, then normalized. Row i of the inverse of a matrix is the cross
 * product of the two columns other than i, divided by the determinant. */
static struct vec3 transform_normal(const struct oracle_state *state, const float normal[3])
{
    const struct vec3 c0 = column(state->modelview, 0), c1 = column(state->modelview, 1),
                      c2 = column(state->modelview, 2);
    const struct vec3 row[3] = {cross(c1, c2), cross(c2, c0), cross(c0, c1)};
    const quad determinant = dot(c0, row[0]);
    struct vec3 n = add(add(scale((quad)normal[0], row[0]), scale((quad)normal[1], row[1])),
                        scale((quad)normal[2], row[2]));
    if (state->normalize)
        return unit_or_zero(determinant < 0 ? negate(n) : n);
    if (determinant == 0)
        return (struct vec3){0, 0, 0};
    n = scale(1 / determinant, n);
    return state->rescale_normal ? scale(absolute(determinant) / length(row[2]), n) : n;
}

/* ---- materials ---- */

static bool applies(GLenum which_face, bool back)
{
    return which_face == GL_FRONT_AND_BACK || which_face == (GLenum)(back ? GL_BACK : GL_FRONT);
}

static void copy(float to[4], const float from[4])
{
    for (int i = 0; i < 4; i++)
        to[i] = from[i];
}

/* 2.14.3 "ColorMaterial": the current color replaces the values that the mode names. */
static struct oracle_material material_of(const struct oracle_state *state,
                                          const struct oracle_vertex *vertex, bool back)
{
    struct oracle_material m = back ? state->back : state->front;
    const GLenum mode = state->color_material_mode;
    if (state->color_material_face == 0 || !applies(state->color_material_face, back))
        return m;
    if (mode == GL_AMBIENT || mode == GL_AMBIENT_AND_DIFFUSE)
        copy(m.ambient, vertex->color);
    if (mode == GL_DIFFUSE || mode == GL_AMBIENT_AND_DIFFUSE)
        copy(m.diffuse, vertex->color);
    if (mode == GL_SPECULAR)
        copy(m.specular, vertex->color);
    if (mode == GL_EMISSION)
        copy(m.emission, vertex->color);
    return m;
}

/* ---- one light ---- */

struct sums {
    quad primary[3], secondary[3];
};

static void add_term(quad sum[3], quad factor, const float light[4], const float material[4])
{
    for (int i = 0; i < 3; i++) {
        const quad term = factor * ((quad)light[i] * (quad)material[i]);
        if (term == term)
            sum[i] += term;
    }
}

/* att_i */
static quad attenuation(const struct oracle_light *light, quad w, quad distance)
{
    if (w == 0)
        return 1;
    const quad denominator = (quad)light->attenuation[0] + (quad)light->attenuation[1] * distance +
                             (quad)light->attenuation[2] * distance * distance;
    return denominator == 0 ? (quad)FLT_MAX : 1 / denominator;
}

/* spot_i. Closer than 2^-100 to the edge no vertex comes that is not on it: it is lit. */
static quad spot(const struct oracle_light *light, struct vec3 direction, struct vec3 VP, quad *to_edge)
{
    if (light->spot_cutoff == 180)
        return 1;
    const quad cosine = dot(negate(VP), direction);
    const quad edge = quad_cos_degrees((quad)light->spot_cutoff);
    *to_edge = least(*to_edge, absolute(cosine - edge));
    if (cosine < edge - (quad)0x1p-100)
        return 0;
    return quad_pow(cosine < 0 ? 0 : cosine, (quad)light->spot_exponent);
}

static bool has_color(const float light[4], const float material[4])
{
    return light[0] * material[0] != 0 || light[1] * material[1] != 0 || light[2] * material[2] != 0;
}

/* eye is a point: (0, 0, 0, 1). */
static void add_light(const struct oracle_state *state, const struct oracle_light *light,
                      const struct oracle_material *material, struct vec4 V, struct vec3 n, struct sums *sums,
                      struct oracle_color *color)
{
    const struct vec4 P = transform(state->light_modelview, light->position), eye = {0, 0, 0, 1};
    const struct vec3 to_light = from_to(V, P), VP = unit_or_zero(to_light);
    const struct vec3 direction =
            unit_or_zero(transform_direction(state->light_modelview, light->spot_direction));
    const quad factor =
            attenuation(light, P.w, length(to_light)) * spot(light, direction, VP, &color->to_cone_edge);
    const quad n_dot_VP = dot(n, VP);
    const struct vec3 to_viewer =
            state->local_viewer ? unit_or_zero(from_to(V, eye)) : (struct vec3){0, 0, 1};
    const quad n_dot_h = dot(n, unit_or_zero(add(VP, to_viewer)));

    add_term(sums->primary, factor, light->ambient, material->ambient);
    if (n_dot_VP > 0) /* this is f_i */ {
        add_term(sums->primary, factor * n_dot_VP, light->diffuse, material->diffuse);
        add_term(state->separate_specular ? sums->secondary : sums->primary,
                 factor * quad_pow(n_dot_h < 0 ? 0 : n_dot_h, (quad)material->shininess), light->specular,
                 material->specular);
    }
    if (has_color(light->specular, material->specular))
        color->to_horizon = least(color->to_horizon, absolute(n_dot_VP));
}

/* ---- the sum ---- */

struct oracle_color oracle_shade(const struct oracle_state *state, const struct oracle_vertex *vertex)
{
    struct oracle_color color = {.to_cone_edge = 1, .to_horizon = 1};
    const struct vec4 V = transform(state->modelview, vertex->position);
    color.drawn = V.w != 0 && is_finite(V.x) && is_finite(V.y) && is_finite(V.z) && is_finite(V.w);
    const bool back = state->two_sided && vertex->back_facing;
    const struct oracle_material material = material_of(state, vertex, back);
    const struct vec3 front_normal = transform_normal(state, vertex->normal);
    const struct vec3 n = back ? negate(front_normal) : front_normal;

    static const float one[4] = {1, 1, 1, 1};
    struct sums sums = {{0, 0, 0}, {0, 0, 0}};
    add_term(sums.primary, 1, one, material.emission);
    add_term(sums.primary, 1, state->scene_ambient, material.ambient);
    for (int i = 0; i < state->lights; i++)
        add_light(state, &state->light[i], &material, V, n, &sums, &color);
    for (int i = 0; i < 3; i++)
        color.component[i] = clamp01(clamp01(sums.primary[i]) + clamp01(sums.secondary[i]));
    color.component[3] = clamp01((quad)material.diffuse[3]);
    return color;
}
