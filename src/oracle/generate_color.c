/* Scenes about materials and colors, and with parameters that are not numbers. */
#include "oracle/generators.h"

#include <math.h>

#include "oracle/ordinary.h"

/* ---- material ---- */

void generate_two_sided(struct random *r, struct oracle_scene *s, double count)
{
    generate_every_kind(r, s, count);
    s->state.two_sided = true;
    s->triangles = true;
    for (int i = 0; i < s->count; i++)
        s->vertex[i].back_facing = random_below(r, 2);
}

void generate_color_material(struct random *r, struct oracle_scene *s, double unused)
{
    static const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    static const GLenum modes[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
    (void)unused;
    if (random_below(r, 2))
        generate_two_sided(r, s, 2);
    else
        generate_every_kind(r, s, 2);
    s->state.color_material_face = faces[random_below(r, 3)];
    s->state.color_material_mode = modes[random_below(r, 5)];
}

void generate_separate_specular(struct random *r, struct oracle_scene *s, double count)
{
    generate_every_kind(r, s, count);
    s->state.separate_specular = true;
}

static void any_color(struct random *r, float color[4])
{
    for (int k = 0; k < 4; k++)
        color[k] = random_between(r, -3, 4);
}

void generate_colors_out_of_range(struct random *r, struct oracle_scene *s, double count)
{
    generate_every_kind(r, s, count);
    s->state.separate_specular = random_below(r, 2);
    any_color(r, s->state.scene_ambient);
    any_color(r, s->state.front.ambient);
    any_color(r, s->state.front.diffuse);
    any_color(r, s->state.front.specular);
    any_color(r, s->state.front.emission);
    for (int i = 0; i < s->state.lights; i++) {
        any_color(r, s->state.light[i].ambient);
        any_color(r, s->state.light[i].diffuse);
        any_color(r, s->state.light[i].specular);
    }
}

/* ---- not numbers ---- */

static float not_finite(struct random *r)
{
    const float values[3] = {NAN, INFINITY, -INFINITY};
    return values[random_below(r, 3)];
}

/* parameter: which of the parameters below */
void generate_not_finite_light(struct random *r, struct oracle_scene *s, double which)
{
    generate_every_kind(r, s, 2);
    struct oracle_light *light = &s->state.light[random_below(r, 2)];
    float *const value[] = {&light->position[random_below(r, 4)], &light->spot_direction[random_below(r, 3)],
                            &light->ambient[random_below(r, 3)], &light->diffuse[random_below(r, 3)],
                            &light->specular[random_below(r, 3)]};
    *value[(int)which] = not_finite(r);
}

void generate_not_finite_attenuation(struct random *r, struct oracle_scene *s, double unused)
{
    (void)unused;
    generate_positional(r, s, 2);
    s->state.light[random_below(r, 2)].attenuation[random_below(r, 3)] = random_below(r, 2) ? NAN : INFINITY;
}

void generate_not_finite_material(struct random *r, struct oracle_scene *s, double unused)
{
    (void)unused;
    generate_every_kind(r, s, 2);
    struct oracle_material *m = &s->state.front;
    float *const value[] = {m->ambient, m->diffuse, m->specular, m->emission, s->state.scene_ambient};
    value[random_below(r, 5)][random_below(r, 3)] = not_finite(r);
}

void generate_not_finite_normal(struct random *r, struct oracle_scene *s, double unused)
{
    (void)unused;
    generate_every_kind(r, s, 2);
    s->state.normalize = random_below(r, 2);
    for (int i = 0; i < s->count; i += 2)
        s->vertex[i].normal[random_below(r, 3)] = not_finite(r);
}

void generate_not_finite_position(struct random *r, struct oracle_scene *s, double unused)
{
    (void)unused;
    generate_every_kind(r, s, 2);
    s->alone = true;
    for (int i = 0; i < s->count; i += 2)
        s->vertex[i].position[random_below(r, 4)] = not_finite(r);
}
