/* Scenes as programs draw them. */
#include "oracle/generators.h"

#include "oracle/ordinary.h"

void oracle_multiply(float *v, int count, float factor)
{
    for (int i = 0; i < count; i++)
        v[i] *= factor;
}

void generate_lights(struct random *r, struct oracle_scene *s, double count)
{
    oracle_ordinary(r, s, (int)count);
}

void generate_positional(struct random *r, struct oracle_scene *s, double count)
{
    oracle_ordinary(r, s, (int)count);
    for (int i = 0; i < s->state.lights; i++)
        oracle_point_light(r, &s->state.light[i]);
    oracle_aim_normals(r, s);
}

void generate_attenuated(struct random *r, struct oracle_scene *s, double count)
{
    generate_positional(r, s, count);
    for (int i = 0; i < s->state.lights; i++)
        oracle_attenuate(r, &s->state.light[i]);
}

void generate_local_viewer(struct random *r, struct oracle_scene *s, double count)
{
    oracle_ordinary(r, s, (int)count);
    s->state.local_viewer = true;
    oracle_aim_normals(r, s);
}

void generate_spots(struct random *r, struct oracle_scene *s, double count)
{
    generate_positional(r, s, count);
    for (int i = 0; i < s->state.lights; i++)
        oracle_aim_spot(s, &s->state.light[i], random_below(r, s->count), random_between(r, 20, 80),
                        random_between(r, 1, 30));
}

void generate_every_kind(struct random *r, struct oracle_scene *s, double count)
{
    oracle_ordinary(r, s, (int)count);
    s->state.local_viewer = random_below(r, 2);
    oracle_aim_normals(r, s);
    for (int i = 0; i < s->state.lights; i++) {
        struct oracle_light *light = &s->state.light[i];
        if (light->position[3] != 0 && random_below(r, 2))
            oracle_attenuate(r, light);
        if (random_below(r, 2))
            oracle_aim_spot(s, light, random_below(r, s->count), random_between(r, 20, 80),
                            random_between(r, 1, 30));
    }
}

/* The lights stand where another modelview matrix put them. */
void generate_lights_of_other_matrix(struct random *r, struct oracle_scene *s, double count)
{
    oracle_ordinary(r, s, (int)count);
    oracle_rigid(r, s->state.light_modelview);
    oracle_aim_normals(r, s);
}

/* parameter: the shininess; below 0: fractional ones */
void generate_shininess(struct random *r, struct oracle_scene *s, double value)
{
    generate_every_kind(r, s, 2);
    s->state.front.shininess = value < 0 ? random_between(r, 0.1f, 10) : (float)value;
    s->state.back.shininess = s->state.front.shininess;
}
