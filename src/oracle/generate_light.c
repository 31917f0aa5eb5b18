/* Scenes in which a light is out of the ordinary. */
#include "oracle/generators.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "oracle/ordinary.h"

/* ---- spots ---- */

void generate_spot_exponent(struct random *r, struct oracle_scene *s, double exponent)
{
    generate_positional(r, s, 2);
    for (int i = 0; i < 2; i++)
        oracle_aim_spot(s, &s->state.light[i], i, 60, (float)exponent);
}

/* A narrow cone; the vertices stand close to its axis, or on it: integers, so that they do exactly. */
void generate_spot_cutoff(struct random *r, struct oracle_scene *s, double cutoff)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    for (int k = 0; k < 3; k++) {
        light->position[k] = (float)(random_below(r, 9) - 4);
        light->spot_direction[k] = (float)(random_below(r, 3) + 1);
    }
    light->position[3] = 1;
    light->spot_cutoff = (float)cutoff;
    light->spot_exponent = random_between(r, 0, 8);
    const float spread = 3 * tanf((float)fmin(cutoff, 80) * 3.14159265f / 180);
    for (int i = 0; i < s->count; i++) {
        const float along = (float)(random_below(r, 4) + 1);
        for (int k = 0; k < 3; k++)
            s->vertex[i].position[k] = light->position[k] + along * light->spot_direction[k] +
                                       (i % 4 == 0 ? 0 : random_between(r, -spread, spread));
    }
    oracle_aim_normals(r, s);
}

/* Vertices exactly on the edge of the cone, from small integers: about an axis for 45 and 90 degrees, about a
 * diagonal for 60, on the axis itself for 0. */
void generate_cone_edge(struct random *r, struct oracle_scene *s, double cutoff)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    const int axis = random_below(r, 3), second = (axis + 1) % 3, third = (axis + 2) % 3;
    memset(light->spot_direction, 0, sizeof light->spot_direction);
    light->spot_direction[axis] = 1;
    if (cutoff == 60)
        light->spot_direction[second] = 1;
    light->spot_cutoff = (float)cutoff;
    light->spot_exponent = random_below(r, 2) ? 0 : 2;
    for (int k = 0; k < 3; k++)
        light->position[k] = (float)(random_below(r, 9) - 4);
    light->position[3] = 1;
    for (int i = 0; i < s->count; i++) {
        const float h = (float)(random_below(r, 5) + 1), sign = random_below(r, 2) ? 1.0f : -1.0f;
        float offset[3] = {0};
        offset[axis] = cutoff == 90 ? 0 : h;
        if (cutoff == 45 || cutoff == 90)
            offset[random_below(r, 2) ? second : third] = sign * h;
        if (cutoff == 60)
            offset[third] = sign * h;
        for (int k = 0; k < 3; k++)
            s->vertex[i].position[k] = light->position[k] + offset[k];
    }
    oracle_aim_normals(r, s);
}

/* parameter: how far the vertices are from the edge of the cone, inside or outside; as near as floats allow
 */
void generate_near_cone_edge(struct random *r, struct oracle_scene *s, double degrees)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    const float cutoff = random_between(r, 15, 75), place[4] = {0, 0, 0, 1}, down[3] = {0, 0, -1};
    memcpy(light->position, place, sizeof place);
    memcpy(light->spot_direction, down, sizeof down);
    light->spot_cutoff = cutoff;
    light->spot_exponent = random_between(r, 0, 4);
    for (int i = 0; i < s->count; i++) {
        const double side = random_below(r, 2) ? degrees : -degrees;
        const double angle = ((double)cutoff + side) * 3.14159265358979324 / 180;
        const double around = (double)random_between(r, 0, 6.28f), far = (double)random_between(r, 1, 6);
        s->vertex[i].position[0] = (float)(far * sin(angle) * cos(around));
        s->vertex[i].position[1] = (float)(far * sin(angle) * sin(around));
        s->vertex[i].position[2] = (float)(-far * cos(angle));
    }
    oracle_aim_normals(r, s);
}

void generate_directional_spot(struct random *r, struct oracle_scene *s, double unused)
{
    (void)unused;
    oracle_ordinary(r, s, 2);
    for (int i = 0; i < 2; i++) {
        struct oracle_light *light = &s->state.light[i];
        oracle_directional_light(r, light);
        oracle_aim_spot(s, light, 0, 60, random_between(r, 1, 10));
        for (int k = 0; k < 3; k++)
            light->spot_direction[k] += random_between(r, -0.5f, 0.5f);
    }
    oracle_aim_normals(r, s);
}

void generate_zero_spot_direction(struct random *r, struct oracle_scene *s, double cutoff)
{
    generate_positional(r, s, 1);
    memset(s->state.light[0].spot_direction, 0, sizeof s->state.light[0].spot_direction);
    s->state.light[0].spot_cutoff = (float)cutoff;
    s->state.light[0].spot_exponent = random_below(r, 2) ? 0 : 2;
}

/* ---- attenuation and distance ---- */

/* parameter: the magnitude of the coefficients, 0 included */
void generate_attenuation(struct random *r, struct oracle_scene *s, double magnitude)
{
    generate_positional(r, s, 1);
    for (int k = 0; k < 3; k++)
        s->state.light[0].attenuation[k] = random_between(r, 0.1f, 1) * (float)magnitude;
    s->state.light[0].attenuation[random_below(r, 3)] = 0;
}

/* parameter: the distance from vertices to light, roughly; the whole scene is that small or large */
void generate_distance(struct random *r, struct oracle_scene *s, double d)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    oracle_point_light(r, light);
    oracle_aim_normals(r, s);
    oracle_multiply(light->position, 3, (float)(d / 4));
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].position, 3, (float)(d / 4));
    const double per_distance = d == 0 ? 1 : 1 / d;
    if (random_below(r, 2))
        light->attenuation[1] = (float)fmin(per_distance, (double)FLT_MAX);
    if (random_below(r, 2))
        light->attenuation[2] = (float)fmin(per_distance * per_distance, (double)FLT_MAX);
}

/* parameter: the constant coefficient */
void generate_light_at_vertex(struct random *r, struct oracle_scene *s, double constant)
{
    generate_positional(r, s, 2);
    struct oracle_light *light = &s->state.light[0];
    light->attenuation[0] = (float)constant;
    light->attenuation[1] = 0.5f;
    if (random_below(r, 2))
        oracle_aim_spot(s, light, 1, random_below(r, 2) ? 60 : 90, (float)random_below(r, 2));
    for (int i = 0; i < s->count; i += 2)
        memcpy(s->vertex[i].position, light->position, sizeof light->position);
}

/* ---- homogeneous coordinates ---- */

/* parameter: w of the light; x, y, z are of the order of 1, or of w */
void generate_light_w(struct random *r, struct oracle_scene *s, double w)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    oracle_point_light(r, light);
    if (random_below(r, 2))
        oracle_multiply(light->position, 3, (float)w);
    light->position[3] = (float)w;
    oracle_aim_normals(r, s);
}

/* parameter: the sign of the vertices' w; 0: that of every other vertex is 0 */
void generate_vertex_w(struct random *r, struct oracle_scene *s, double sign)
{
    generate_every_kind(r, s, 2);
    s->alone = sign == 0;
    for (int i = 0; i < s->count; i++) {
        oracle_multiply(s->vertex[i].position, 4, (sign < 0 ? -1.0f : 1.0f) * random_magnitude(r, 0.1f, 10));
        if (sign == 0 && i % 2)
            s->vertex[i].position[3] = 0;
    }
}

/* parameter: the length of the directional light's vector */
void generate_direction_length(struct random *r, struct oracle_scene *s, double length)
{
    oracle_ordinary(r, s, 2);
    for (int i = 0; i < 2; i++) {
        oracle_directional_light(r, &s->state.light[i]);
        oracle_multiply(s->state.light[i].position, 3, (float)length);
    }
    oracle_aim_normals(r, s);
}
