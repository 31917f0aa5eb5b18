/*
 * The sphere has radius 1 and stands 4 in front of the viewer; one positional light, a glossy material. Each
 * extreme changes numbers of the scene in a way that leaves the picture as it was, or that the specification
 * has an answer for. The vertices are lit as everywhere in the oracle, 64 at a time; the picture is made
 * here.
 */
#include "oracle/spheres.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/generators.h"
#include "oracle/ordinary.h"

enum { SIZE = ORACLE_SPHERE_SIZE };

static const float away = 4;

/* ---- the extremes ---- */

static void as_it_is(struct oracle_scene *s, double unused)
{
    (void)s, (void)unused;
}

/* The eye space of the scene becomes its object space. */
static void bake_modelview(struct oracle_scene *s)
{
    for (int i = 0; i < s->count; i++)
        s->vertex[i].position[2] -= away;
    oracle_identity(s->state.modelview);
}

static void resize(struct oracle_scene *s, double size)
{
    bake_modelview(s);
    oracle_multiply(s->state.light[0].position, 3, (float)size);
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].position, 3, (float)size);
}

static void set_direction_length(struct oracle_scene *s, double length)
{
    s->state.light[0].position[3] = 0;
    oracle_multiply(s->state.light[0].position, 3, (float)length);
}

static void set_normal_length(struct oracle_scene *s, double length)
{
    s->state.normalize = true;
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].normal, 3, (float)length);
}

static void scale(struct oracle_scene *s, double by)
{
    for (int c = 0; c < 3; c++)
        oracle_multiply(s->state.modelview + 4 * c, 3, (float)by);
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].position, 3, (float)(1 / by));
    s->state.rescale_normal = by > 1;
    s->state.normalize = by < 1;
}

/* The axes of object space are nearly parallel, so that small differences of large numbers place a point. */
static void shear(struct oracle_scene *s, double angle)
{
    float *m = s->state.modelview;
    s->state.normalize = true;
    m[4] = 1;
    m[5] = (float)angle;
    for (int i = 0; i < s->count; i++) {
        struct oracle_vertex *v = &s->vertex[i];
        v->position[1] /= m[5];
        v->position[0] -= v->position[1];
        v->normal[1] = v->normal[0] + m[5] * v->normal[1];
    }
}

/* Turns a vector about the z axis, there or back. */
static void turn(float *v, double way)
{
    const double c = cos(0.5), s = way * sin(0.5), x = (double)v[0], y = (double)v[1];
    v[0] = (float)(c * x - s * y);
    v[1] = (float)(s * x + c * y);
}

/* The world is turned, and moved far from its origin; the matrix brings it back. */
static void move_world(struct oracle_scene *s, double offset)
{
    float *m = s->state.modelview;
    m[12] = -(float)offset;
    turn(m, 1), turn(m + 4, 1), turn(m + 12, 1);
    for (int i = 0; i < s->count; i++) {
        turn(s->vertex[i].position, -1), turn(s->vertex[i].normal, -1);
        s->vertex[i].position[0] += (float)offset;
    }
}

static void set_vertex_w(struct oracle_scene *s, double w)
{
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].position, 4, (float)w);
}

static void set_shininess_0(struct oracle_scene *s, double linear_attenuation)
{
    s->state.front.shininess = 0;
    s->state.light[0].attenuation[1] = (float)linear_attenuation;
}

static void set_no_attenuation(struct oracle_scene *s, double unused)
{
    (void)unused;
    s->state.light[0].attenuation[0] = 0;
}

static void set_spot_without_direction(struct oracle_scene *s, double cutoff)
{
    memset(s->state.light[0].spot_direction, 0, sizeof s->state.light[0].spot_direction);
    s->state.light[0].spot_cutoff = (float)cutoff;
}

static void collapse(struct oracle_scene *s, double unused)
{
    (void)unused;
    s->state.normalize = true;
    s->state.modelview[10] = 0;
}

/* clang-format off */
const struct oracle_sphere oracle_spheres[] = {
        {"nothing extreme", as_it_is, 0},
        {"all of size 1e-22", resize, 1e-22},
        {"all of size 1e20", resize, 1e20},
        {"directional light of length 1e-30", set_direction_length, 1e-30},
        {"directional light of length 1e25", set_direction_length, 1e25},
        {"normals of 1e-25, GL_NORMALIZE", set_normal_length, 1e-25},
        {"modelview scaled to 1e-15, GL_NORMALIZE", scale, 1e-15},
        {"modelview scaled to 1e8, GL_RESCALE_NORMAL", scale, 1e8},
        {"modelview of condition 1e7, GL_NORMALIZE", shear, 1e-7},
        {"modelview of rank 2, GL_NORMALIZE", collapse, 0},
        {"world 1e7 away", move_world, 1e7},
        {"w of vertices 5", set_vertex_w, 5},
        {"w of vertices -1", set_vertex_w, -1},
        {"shininess 0, light attenuated", set_shininess_0, 0.2},
        {"attenuation 0", set_no_attenuation, 0},
        {"spot direction 0, cutoff 90", set_spot_without_direction, 90},
};
/* clang-format on */

const int oracle_sphere_count = (int)(sizeof oracle_spheres / sizeof oracle_spheres[0]);

/* ---- the picture ---- */

static void make_state(struct oracle_state *state)
{
    static const struct oracle_material clay = {
            {0.8f, 0.35f, 0.2f, 1}, {0.8f, 0.35f, 0.2f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0, 0, 0, 1}, 20};
    *state = (struct oracle_state){.lights = 1, .front = clay, .back = clay, .local_viewer = true};
    oracle_identity(state->modelview);
    oracle_identity(state->light_modelview);
    state->modelview[14] = -away;
    for (int i = 0; i < 4; i++)
        state->scene_ambient[i] = i < 3 ? 0.2f : 1;
    state->light[0] = (struct oracle_light){.diffuse = {1, 1, 1, 1},
                                            .specular = {1, 1, 1, 1},
                                            .position = {-1.5f, 1.5f, -1, 1},
                                            .spot_direction = {0, 0, -1},
                                            .spot_cutoff = 180,
                                            .attenuation = {1, 0, 0}};
}

/* A point of the sphere for each pixel of its disk: no mesh, so the picture shows lighting alone. */
static bool point_of(int pixel, float point[3])
{
    const double x = (pixel % SIZE + 0.5) / SIZE * 2.2 - 1.1, y = 1.1 - (pixel / SIZE + 0.5) / SIZE * 2.2;
    if (x * x + y * y >= 1)
        return false;
    const double z = sqrt(1 - x * x - y * y);
    point[0] = (float)x, point[1] = (float)y, point[2] = (float)z;
    return true;
}

static void store(const float rgba[4], unsigned char byte[4])
{
    const bool numbers = rgba[0] == rgba[0] && rgba[1] == rgba[1] && rgba[2] == rgba[2];
    const float magenta[3] = {1, 0, 1};
    for (int k = 0; k < 3; k++)
        byte[k] = (unsigned char)(255 * fminf(fmaxf(numbers ? rgba[k] : magenta[k], 0), 1) + 0.5f);
    byte[3] = 255;
}

/* Lights the points of the pixels listed in `pixel`, at most 64. */
static void light_pixels(const struct oracle_sphere *sphere, oracle_renderer *render, const int *pixel,
                         int count, unsigned char (*picture)[4])
{
    struct oracle_scene scene = {.count = count};
    float rgba[ORACLE_VERTICES][4];
    make_state(&scene.state);
    for (int i = 0; i < count; i++) {
        struct oracle_vertex *vertex = &scene.vertex[i];
        point_of(pixel[i], vertex->normal);
        memcpy(vertex->position, vertex->normal, sizeof vertex->normal);
        vertex->position[3] = 1;
    }
    sphere->change(&scene, sphere->parameter);
    render(&scene, rgba);
    for (int i = 0; i < count; i++)
        store(rgba[i], picture[pixel[i]]);
}

static bool write_pam(const char *path, unsigned char (*picture)[4])
{
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        return false;
    fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", SIZE, SIZE);
    const bool written = fwrite(picture, 4, SIZE * SIZE, file) == SIZE * SIZE;
    return fclose(file) == 0 && written;
}

bool oracle_sphere_write(const struct oracle_sphere *sphere, oracle_renderer *render, const char *path)
{
    static unsigned char picture[SIZE * SIZE][4];
    const unsigned char ground[4] = {30, 32, 38, 255};
    int pixel[ORACLE_VERTICES], count = 0;
    float point[3];
    for (int i = 0; i < SIZE * SIZE; i++) {
        memcpy(picture[i], ground, sizeof ground);
        if (point_of(i, point))
            pixel[count++] = i;
        if (count == ORACLE_VERTICES || (i == SIZE * SIZE - 1 && count > 0)) {
            light_pixels(sphere, render, pixel, count, picture);
            count = 0;
        }
    }
    return write_pam(path, picture);
}
