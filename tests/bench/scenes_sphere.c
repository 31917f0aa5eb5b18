/* Spheres of strips, lit: what the vertex stage costs. */
#define _XOPEN_SOURCE 700
#include <math.h>

#include "scene.h"

enum lighting { SHINY, DIRECTIONAL, POSITIONAL, EIGHT };
enum way { IMMEDIATE, ARRAYS, LIST };

struct sphere {
    enum lighting lighting;
    enum way way;
    bool culled; /* both faces */
    int slices, stacks;
};

static void build(const struct sphere *sphere, struct instance *instance)
{
    const int row = sphere->slices + 1;
    int n = 0;

    instance->position = allocate((size_t)row * (size_t)(sphere->stacks + 1), sizeof *instance->position);
    instance->index = allocate(2 * (size_t)row * (size_t)sphere->stacks, sizeof *instance->index);
    for (int i = 0; i <= sphere->stacks; i++)
        for (int j = 0; j < row; j++) {
            const double latitude = M_PI * i / sphere->stacks, longitude = 2 * M_PI * j / sphere->slices;
            float *p = instance->position[i * row + j];
            p[0] = (float)(sin(latitude) * cos(longitude));
            p[1] = (float)cos(latitude);
            p[2] = (float)(-sin(latitude) * sin(longitude));
        }
    for (int i = 0; i < sphere->stacks; i++)
        for (int j = 0; j < row; j++) {
            instance->index[n++] = (GLuint)(i * row + j);
            instance->index[n++] = (GLuint)((i + 1) * row + j);
        }
}

static void set_lighting(enum lighting lighting)
{
    const int count = lighting == EIGHT ? 8 : 1;

    gl.Enable(GL_LIGHTING);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting == EIGHT);
    if (lighting == SHINY || lighting == EIGHT) {
        gl.Materialfv(GL_FRONT, GL_SPECULAR, (float[]){1, 1, 1, 1});
        gl.Materialf(GL_FRONT, GL_SHININESS, 50);
    }
    for (int i = 0; i < count; i++) {
        const GLenum light = GL_LIGHT0 + (GLenum)i;
        const float w = lighting == POSITIONAL || lighting == EIGHT ? 1 : 0;
        gl.Enable(light);
        gl.Lightfv(light, GL_POSITION, (float[]){1.5f - 0.4f * (float)i, 1, w == 0 ? 1 : -1.5f, w});
        if (lighting != EIGHT)
            continue;
        gl.Lightfv(light, GL_DIFFUSE, (float[]){0.2f, 0.1f + 0.02f * (float)i, 0.15f, 1});
        gl.Lightfv(light, GL_SPECULAR, (float[]){0.3f, 0.3f, 0.3f, 1});
        gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.1f);
        gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.05f);
    }
}

static void draw_strips(const struct sphere *sphere, const struct instance *instance)
{
    const int length = 2 * (sphere->slices + 1);

    for (int i = 0; i < sphere->stacks; i++) {
        const GLuint *strip = instance->index + i * length;
        if (sphere->way == ARRAYS) {
            gl.DrawElements(GL_TRIANGLE_STRIP, length, GL_UNSIGNED_INT, strip);
            continue;
        }
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int j = 0; j < length; j++) {
            gl.Normal3fv(instance->position[strip[j]]);
            gl.Vertex3fv(instance->position[strip[j]]);
        }
        gl.End();
    }
}

static void open(const struct scene *scene, struct instance *instance)
{
    const struct sphere *sphere = scene->detail;

    build(sphere, instance);
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(-1.5, 1.5, -1.5, 1.5, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    set_lighting(sphere->lighting); /* in eye space */
    gl.Translatef(0, 0, -4);
    gl.Enable(GL_DEPTH_TEST);
    gl.CullFace(GL_FRONT_AND_BACK);
    if (sphere->culled)
        gl.Enable(GL_CULL_FACE);
    if (sphere->way == ARRAYS) {
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.EnableClientState(GL_NORMAL_ARRAY);
        gl.VertexPointer(3, GL_FLOAT, 0, instance->position);
        gl.NormalPointer(GL_FLOAT, 0, instance->position);
    } else if (sphere->way == LIST) {
        gl.NewList(1, GL_COMPILE);
        draw_strips(sphere, instance);
        gl.EndList();
    }
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    const struct sphere *sphere = scene->detail;

    if (sphere->way == LIST)
        gl.CallList(1);
    else
        draw_strips(sphere, instance);
}

#define SMALL(name, ...) {name, 500, 50, open, draw, &(const struct sphere){__VA_ARGS__, 20, 16}, false}
#define LARGE(name, ...) {name, 500, 4, open, draw, &(const struct sphere){__VA_ARGS__, 500, 250}, false}
#define LIT(name, lighting, exact)                                                                    \
    {name, 500, 4, open, draw, &(const struct sphere){lighting, ARRAYS, false, 500, 250}, exact}
const struct scene sphere_scenes[] = {
    SMALL("light: sphere 20x16, 500x500", SHINY, ARRAYS, false),
    LARGE("sphere 500x250, 1 directional, immediate", DIRECTIONAL, IMMEDIATE, false),
    LARGE("sphere 500x250, 1 directional, arrays", DIRECTIONAL, ARRAYS, false),
    LARGE("sphere 500x250, 1 directional, list", DIRECTIONAL, LIST, false),
    LARGE("sphere 500x250, 1 positional, immediate", POSITIONAL, IMMEDIATE, false),
    LARGE("sphere 500x250, 1 positional, arrays", POSITIONAL, ARRAYS, false),
    LARGE("sphere 500x250, 8 positional, immediate", EIGHT, IMMEDIATE, false),
    LARGE("sphere 500x250, 8 positional, arrays", EIGHT, ARRAYS, false),
    LARGE("all culled: 1 directional, immediate", DIRECTIONAL, IMMEDIATE, true),
    LARGE("all culled: 1 directional, arrays", DIRECTIONAL, ARRAYS, true),
    LARGE("all culled: 1 directional, list", DIRECTIONAL, LIST, true),
    LARGE("all culled: 1 positional, immediate", POSITIONAL, IMMEDIATE, true),
    LARGE("all culled: 1 positional, arrays", POSITIONAL, ARRAYS, true),
    LARGE("all culled: 8 positional, immediate", EIGHT, IMMEDIATE, true),
    LARGE("all culled: 8 positional, arrays", EIGHT, ARRAYS, true),
    LIT("lit vertices, 1 light, compatible", SHINY, false),
    LIT("lit vertices, 1 light, exact", SHINY, true),
    LIT("lit vertices, 8 lights, compatible", EIGHT, false),
    LIT("lit vertices, 8 lights, exact", EIGHT, true),
    {0},
};
