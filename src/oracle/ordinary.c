#include "oracle/ordinary.h"

#include <math.h>
#include <string.h>

static void random_color(struct random *random, float color[4], float most)
{
    for (int i = 0; i < 3; i++)
        color[i] = random_between(random, 0, most);
    color[3] = random_between(random, 0.25f, 1);
}

static void random_material(struct random *random, struct oracle_material *material)
{
    random_color(random, material->ambient, 1);
    random_color(random, material->diffuse, 1);
    random_color(random, material->specular, 1);
    random_color(random, material->emission, 0.1f);
    material->shininess = random_magnitude(random, 1, 128);
}

void oracle_identity(float matrix[16])
{
    for (int i = 0; i < 16; i++)
        matrix[i] = i % 5 == 0 ? 1 : 0;
}

/* Columns from two random directions by Gram and Schmidt; then a translation. */
void oracle_rigid(struct random *random, float matrix[16])
{
    float a[3], b[3];
    double c[3][3], dot = 0, square = 0;
    random_unit(random, a);
    random_unit(random, b);
    for (int i = 0; i < 3; i++)
        dot += (double)a[i] * (double)b[i];
    for (int i = 0; i < 3; i++) {
        c[0][i] = (double)a[i];
        c[1][i] = (double)b[i] - dot * (double)a[i];
        square += c[1][i] * c[1][i];
    }
    for (int i = 0; i < 3; i++)
        c[1][i] /= sqrt(square);
    for (int i = 0; i < 3; i++)
        c[2][i] = c[0][(i + 1) % 3] * c[1][(i + 2) % 3] - c[0][(i + 2) % 3] * c[1][(i + 1) % 3];
    oracle_identity(matrix);
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            matrix[4 * column + row] = (float)c[column][row];
    matrix[12] = random_between(random, -1, 1);
    matrix[13] = random_between(random, -1, 1);
    matrix[14] = random_between(random, -10, -5);
}

void oracle_point_light(struct random *random, struct oracle_light *light)
{
    float direction[3];
    random_unit(random, direction);
    const float distance = random_between(random, 3, 6);
    for (int i = 0; i < 3; i++)
        light->position[i] = distance * direction[i];
    light->position[3] = 1;
}

void oracle_directional_light(struct random *random, struct oracle_light *light)
{
    random_unit(random, light->position);
    light->position[3] = 0;
}

void oracle_attenuate(struct random *random, struct oracle_light *light)
{
    light->attenuation[0] = random_between(random, 0.5f, 1);
    light->attenuation[1] = random_between(random, 0, 0.1f);
    light->attenuation[2] = random_between(random, 0, 0.02f);
}

static void random_light(struct random *random, struct oracle_light *light, float most)
{
    random_color(random, light->ambient, 0.3f * most);
    random_color(random, light->diffuse, most);
    random_color(random, light->specular, most);
    if (random_below(random, 2))
        oracle_point_light(random, light);
    else
        oracle_directional_light(random, light);
    light->spot_direction[2] = -1;
    light->spot_cutoff = 180;
    light->attenuation[0] = 1;
}

static void random_vertex(struct random *random, struct oracle_vertex *vertex)
{
    for (int i = 0; i < 3; i++)
        vertex->position[i] = random_between(random, -2, 2);
    vertex->position[3] = 1;
    random_unit(random, vertex->normal);
    random_color(random, vertex->color, 1);
}

/* ---- aiming: approximate, in double ---- */

static void transform(const float m[16], const float v[4], double result[3])
{
    for (int r = 0; r < 3; r++)
        result[r] = (double)m[r] * (double)v[0] + (double)m[4 + r] * (double)v[1] +
                    (double)m[8 + r] * (double)v[2] + (double)m[12 + r] * (double)v[3];
}

static void normalize(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* From the vertex to the light, in eye space. */
static void to_light(const struct oracle_scene *scene, const struct oracle_light *light,
                     const struct oracle_vertex *vertex, double direction[3])
{
    double eye[3];
    transform(scene->state.modelview, vertex->position, eye);
    transform(scene->state.light_modelview, light->position, direction);
    for (int i = 0; light->position[3] != 0 && i < 3; i++)
        direction[i] -= eye[i];
    normalize(direction);
}

static void turn_back(const float rigid[16], const double eye[3], float object[3])
{
    for (int i = 0; i < 3; i++)
        object[i] = (float)((double)rigid[4 * i] * eye[0] + (double)rigid[4 * i + 1] * eye[1] +
                            (double)rigid[4 * i + 2] * eye[2]);
}

void oracle_aim_spot(struct oracle_scene *scene, struct oracle_light *light, int vertex, float cutoff,
                     float exponent)
{
    double direction[3];
    to_light(scene, light, &scene->vertex[vertex], direction);
    for (int i = 0; i < 3; i++)
        direction[i] = -direction[i];
    turn_back(scene->state.light_modelview, direction, light->spot_direction);
    light->spot_cutoff = cutoff;
    light->spot_exponent = exponent;
}

static void aim_normal(struct random *random, struct oracle_scene *scene, struct oracle_vertex *vertex)
{
    const struct oracle_light *light = &scene->state.light[random_below(random, scene->state.lights)];
    double half[3], viewer[3];
    to_light(scene, light, vertex, half);
    transform(scene->state.modelview, vertex->position, viewer);
    normalize(viewer);
    for (int i = 0; i < 3; i++)
        half[i] += scene->state.local_viewer ? -viewer[i] : i == 2;
    normalize(half);
    for (int i = 0; i < 3; i++)
        half[i] += (double)random_between(random, -0.2f, 0.2f);
    normalize(half);
    turn_back(scene->state.modelview, half, vertex->normal);
}

void oracle_aim_normals(struct random *random, struct oracle_scene *scene)
{
    for (int i = 0; i < scene->count; i += 2)
        aim_normal(random, scene, &scene->vertex[i]);
}

/* ---- */

static void fill(struct random *random, struct oracle_scene *scene, int lights)
{
    struct oracle_state *state = &scene->state;
    random_color(random, state->scene_ambient, 0.2f);
    random_material(random, &state->front);
    random_material(random, &state->back);
    state->lights = lights;
    for (int i = 0; i < lights; i++)
        random_light(random, &state->light[i], 1 / sqrtf((float)lights));
    scene->count = ORACLE_VERTICES;
    for (int i = 0; i < scene->count; i++)
        random_vertex(random, &scene->vertex[i]);
    oracle_aim_normals(random, scene);
}

void oracle_ordinary(struct random *random, struct oracle_scene *scene, int lights)
{
    memset(scene, 0, sizeof *scene);
    oracle_rigid(random, scene->state.modelview);
    memcpy(scene->state.light_modelview, scene->state.modelview, sizeof scene->state.modelview);
    fill(random, scene, lights);
}

void oracle_ordinary_in_eye_space(struct random *random, struct oracle_scene *scene, int lights)
{
    memset(scene, 0, sizeof *scene);
    oracle_identity(scene->state.modelview);
    oracle_identity(scene->state.light_modelview);
    fill(random, scene, lights);
}
