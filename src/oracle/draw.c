/*
 * Every vertex gets a pixel of its own, by its own viewport of 1 x 1, whatever its position is: for points
 * the projection keeps nothing but w, so that all of them lie in the middle. Shading is flat, so the pixel is
 * the color of the vertex and no interpolation comes between.
 */
#include <stdlib.h>
#include <string.h>

#include <GL/osmesa.h>

#include "oracle/scene.h"

enum { SIZE = 8, COMPANIONS = 15 };

_Static_assert(SIZE *SIZE == ORACLE_VERTICES, "a pixel for each vertex");

static OSMesaContext context;
static float pixels[SIZE * SIZE][4];

bool oracle_open(void)
{
    context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    return context != NULL && OSMesaMakeCurrent(context, pixels, GL_FLOAT, SIZE, SIZE);
}

void oracle_close(void)
{
    OSMesaDestroyContext(context);
    context = NULL;
}

static void set_material(GLenum face, const struct oracle_material *material)
{
    glMaterialfv(face, GL_AMBIENT, material->ambient);
    glMaterialfv(face, GL_DIFFUSE, material->diffuse);
    glMaterialfv(face, GL_SPECULAR, material->specular);
    glMaterialfv(face, GL_EMISSION, material->emission);
    glMaterialf(face, GL_SHININESS, material->shininess);
}

static void set_light(GLenum name, const struct oracle_light *light)
{
    glLightfv(name, GL_AMBIENT, light->ambient);
    glLightfv(name, GL_DIFFUSE, light->diffuse);
    glLightfv(name, GL_SPECULAR, light->specular);
    glLightfv(name, GL_POSITION, light->position);
    glLightfv(name, GL_SPOT_DIRECTION, light->spot_direction);
    glLightf(name, GL_SPOT_EXPONENT, light->spot_exponent);
    glLightf(name, GL_SPOT_CUTOFF, light->spot_cutoff);
    glLightf(name, GL_CONSTANT_ATTENUATION, light->attenuation[0]);
    glLightf(name, GL_LINEAR_ATTENUATION, light->attenuation[1]);
    glLightf(name, GL_QUADRATIC_ATTENUATION, light->attenuation[2]);
    glEnable(name);
}

static void set_enabled(GLenum capability, bool enabled)
{
    if (enabled)
        glEnable(capability);
    else
        glDisable(capability);
}

void oracle_set_state(const struct oracle_state *state)
{
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(state->light_modelview);
    for (int i = 0; i < ORACLE_LIGHTS; i++)
        glDisable(GL_LIGHT0 + (GLenum)i);
    for (int i = 0; i < state->lights; i++)
        set_light(GL_LIGHT0 + (GLenum)i, &state->light[i]);
    glLoadMatrixf(state->modelview);
    glDisable(GL_COLOR_MATERIAL);
    set_material(GL_FRONT, &state->front);
    set_material(GL_BACK, &state->back);
    if (state->color_material_face != 0) {
        glColorMaterial(state->color_material_face, state->color_material_mode);
        glEnable(GL_COLOR_MATERIAL);
    }
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, state->scene_ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, state->local_viewer);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, state->two_sided);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  state->separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    set_enabled(GL_NORMALIZE, state->normalize);
    set_enabled(GL_RESCALE_NORMAL, state->rescale_normal);
    glEnable(GL_LIGHTING);
    glShadeModel(GL_FLAT);
}

void oracle_set_arrays(const struct oracle_vertex *vertices, bool colors)
{
    const GLsizei stride = (GLsizei)sizeof *vertices;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(4, GL_FLOAT, stride, vertices->position);
    glNormalPointer(GL_FLOAT, stride, vertices->normal);
    if (colors) {
        glEnableClientState(GL_COLOR_ARRAY);
        glColorPointer(4, GL_FLOAT, stride, vertices->color);
    } else {
        glDisableClientState(GL_COLOR_ARRAY);
    }
}

/* The point is the last of a few that fall on the same pixel: lit in a batch of unlike neighbours. */
static void draw_points(const struct oracle_scene *scene)
{
    oracle_set_arrays(scene->vertex, scene->state.color_material_face != 0);
    glMatrixMode(GL_PROJECTION);
    for (int i = 0; i < scene->count; i++) {
        const float w = scene->vertex[i].position[3] < 0 ? -1.0f : 1.0f;
        const float keep_w[16] = {[15] = w};
        glLoadMatrixf(keep_w);
        glViewport(i % SIZE, i / SIZE, 1, 1);
        int first = i;
        while (!scene->alone && first > 0 && i - first < COMPANIONS &&
               (scene->vertex[first - 1].position[3] < 0) == (w < 0))
            first--;
        glDrawArrays(GL_POINTS, first, i - first + 1);
    }
}

/* Object coordinates of a point given in eye coordinates, by Cramer's rule. */
static void to_object(const float m[16], const double eye[3], float object[4])
{
    double c[3][3], b[3];
    for (int i = 0; i < 3; i++) {
        b[i] = eye[i] - (double)m[12 + i];
        for (int j = 0; j < 3; j++)
            c[i][j] = (double)m[4 * i + j];
    }
    double cofactor[3][3];
    for (int i = 0; i < 3; i++) {
        const double *p = c[(i + 1) % 3], *q = c[(i + 2) % 3];
        for (int j = 0; j < 3; j++)
            cofactor[i][j] = p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
    }
    const double determinant = c[0][0] * cofactor[0][0] + c[0][1] * cofactor[0][1] + c[0][2] * cofactor[0][2];
    for (int i = 0; i < 3; i++)
        object[i] = (float)((cofactor[i][0] * b[0] + cofactor[i][1] * b[1] + cofactor[i][2] * b[2]) /
                            determinant);
    object[3] = 1;
}

/* Two more corners in eye space, below the vertex to the left and to the right, and a projection in which the
 * triangle covers the middle of the viewport. */
static void draw_triangle(const struct oracle_scene *scene, int i)
{
    const float *m = scene->state.modelview, *v = scene->vertex[i].position;
    double eye[3];
    for (int r = 0; r < 3; r++)
        eye[r] = (double)m[r] * (double)v[0] + (double)m[4 + r] * (double)v[1] +
                 (double)m[8 + r] * (double)v[2] + (double)m[12 + r];
    const float projection[16] = {
            [0] = 1, [5] = 1, [12] = (float)-eye[0], [13] = (float)(0.75 - eye[1]), [15] = 1};
    struct oracle_vertex corner[3] = {scene->vertex[i], scene->vertex[i], scene->vertex[i]};
    const double side = scene->vertex[i].back_facing ? -0.75 : 0.75;
    to_object(m, (const double[3]){eye[0] - side, eye[1] - 1.5, eye[2]}, corner[0].position);
    to_object(m, (const double[3]){eye[0] + side, eye[1] - 1.5, eye[2]}, corner[1].position);
    oracle_set_arrays(corner, scene->state.color_material_face != 0);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(projection);
    glViewport(i % SIZE, i / SIZE, 1, 1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void oracle_draw(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4])
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    oracle_set_state(&scene->state);
    if (!scene->triangles)
        draw_points(scene);
    for (int i = 0; scene->triangles && i < scene->count; i++)
        draw_triangle(scene, i);
    glFinish();
    memcpy(rgba, pixels, sizeof pixels);
}
