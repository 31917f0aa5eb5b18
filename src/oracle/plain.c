/* GL 1.5, 2.14.1 "Lighting", as one writes it down from the book. */
#include "oracle/plain.h"

#include <math.h>

struct vector {
    float x, y, z;
};

static struct vector sum(struct vector a, struct vector b)
{
    return (struct vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static struct vector times(float s, struct vector v)
{
    return (struct vector){s * v.x, s * v.y, s * v.z};
}

static float dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector cross(struct vector a, struct vector b)
{
    return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static struct vector unit(struct vector v)
{
    return times(1 / sqrtf(dot(v, v)), v);
}

static struct vector column(const float m[16], int c)
{
    return (struct vector){m[4 * c], m[4 * c + 1], m[4 * c + 2]};
}

/* The first three components of a product of matrix and vector. */
static struct vector transform(const float m[16], const float v[3], float w)
{
    return sum(sum(times(v[0], column(m, 0)), times(v[1], column(m, 1))),
               sum(times(v[2], column(m, 2)), times(w, column(m, 3))));
}

static struct vector transform_normal(const struct oracle_state *state, const float n[3])
{
    const struct vector a = column(state->modelview, 0), b = column(state->modelview, 1),
                        c = column(state->modelview, 2);
    const float inverse = 1 / dot(a, cross(b, c));
    const struct vector third = times(inverse, cross(a, b));
    const struct vector normal = sum(times(n[0] * inverse, cross(b, c)),
                                     sum(times(n[1] * inverse, cross(c, a)), times(n[2], third)));
    if (state->normalize)
        return unit(normal);
    return state->rescale_normal ? times(1 / sqrtf(dot(third, third)), normal) : normal;
}

static const struct oracle_material *material_of(const struct oracle_state *state,
                                                 const struct oracle_vertex *vertex, bool back,
                                                 struct oracle_material *own)
{
    *own = back ? state->back : state->front;
    const GLenum face = state->color_material_face, mode = state->color_material_mode;
    if (face != GL_FRONT_AND_BACK && face != (GLenum)(back ? GL_BACK : GL_FRONT))
        return own;
    for (int k = 0; k < 4; k++) {
        if (mode == GL_AMBIENT || mode == GL_AMBIENT_AND_DIFFUSE)
            own->ambient[k] = vertex->color[k];
        if (mode == GL_DIFFUSE || mode == GL_AMBIENT_AND_DIFFUSE)
            own->diffuse[k] = vertex->color[k];
        if (mode == GL_SPECULAR)
            own->specular[k] = vertex->color[k];
        if (mode == GL_EMISSION)
            own->emission[k] = vertex->color[k];
    }
    return own;
}

static float clamp(float x)
{
    return x < 0 ? 0 : x > 1 ? 1 : x;
}

static void add_light(const struct oracle_state *state, const struct oracle_light *light,
                      const struct oracle_material *m, struct vector position, struct vector n,
                      float primary[3], float secondary[3])
{
    const float w = light->position[3], pi = 3.14159265f;
    struct vector L = transform(state->light_modelview, light->position, w);
    float factor = 1;
    if (w != 0) {
        L = sum(times(1 / w, L), times(-1, position));
        const float d = sqrtf(dot(L, L));
        factor = 1 / (light->attenuation[0] + light->attenuation[1] * d + light->attenuation[2] * d * d);
    }
    L = unit(L);
    if (light->spot_cutoff != 180) {
        const struct vector axis = unit(transform(state->light_modelview, light->spot_direction, 0));
        const float cosine = dot(times(-1, L), axis);
        factor *= cosine < cosf(light->spot_cutoff * pi / 180) ? 0 : powf(cosine, light->spot_exponent);
    }
    const struct vector viewer = state->local_viewer ? unit(times(-1, position)) : (struct vector){0, 0, 1};
    const float diffuse = fmaxf(dot(n, L), 0);
    const float specular = dot(n, L) > 0 ? powf(fmaxf(dot(n, unit(sum(L, viewer))), 0), m->shininess) : 0;
    for (int k = 0; k < 3; k++) {
        primary[k] +=
                factor * (light->ambient[k] * m->ambient[k] + diffuse * light->diffuse[k] * m->diffuse[k]);
        secondary[k] += factor * specular * light->specular[k] * m->specular[k];
    }
}

static void shade(const struct oracle_state *state, const struct oracle_vertex *vertex, float rgba[4])
{
    const bool back = state->two_sided && vertex->back_facing;
    struct oracle_material own;
    const struct oracle_material *m = material_of(state, vertex, back, &own);
    const float w = vertex->position[3];
    const struct vector position = times(1 / w, transform(state->modelview, vertex->position, w));
    const struct vector n = times(back ? -1.0f : 1.0f, transform_normal(state, vertex->normal));
    float primary[3], secondary[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        primary[k] = m->emission[k] + m->ambient[k] * state->scene_ambient[k];
    for (int i = 0; i < state->lights; i++)
        add_light(state, &state->light[i], m, position, n, primary, secondary);
    for (int k = 0; k < 3; k++)
        rgba[k] = state->separate_specular ? clamp(clamp(primary[k]) + clamp(secondary[k]))
                                           : clamp(primary[k] + secondary[k]);
    rgba[3] = clamp(m->diffuse[3]);
}

void oracle_plain(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4])
{
    for (int i = 0; i < scene->count; i++)
        shade(&scene->state, &scene->vertex[i], rgba[i]);
}
