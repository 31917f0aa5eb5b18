/* GL 1.5, 2.8 "Vertex Arrays": types, strides, index types. */
#include <stddef.h>

#include "scenes/scene.h"

/* Six corners of a fan about the middle of the picture, in pixels. */
static const GLshort corner[6][2] = {{32, 32}, {60, 30}, {50, 58}, {14, 57}, {4, 28}, {22, 4}};

static void vertices_short(void)
{
    static const GLubyte color[6][3] = {{255, 255, 255}, {255, 0, 0},   {200, 255, 0},
                                        {0, 255, 10},    {0, 128, 255}, {77, 0, 255}};
    scene_pixels();
    glVertexPointer(2, GL_SHORT, 0, corner);
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
}

static void vertices_int(void)
{
    GLint vertex[6][3];
    GLushort color[6][4];
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 4; k++) {
            if (k < 3)
                vertex[i][k] = k < 2 ? corner[i][k] : 0;
            color[i][k] = (GLushort)(9999 * (i + k));
        }
    scene_pixels();
    glVertexPointer(3, GL_INT, 0, vertex);
    glColorPointer(4, GL_UNSIGNED_SHORT, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
}

static void vertices_double(void)
{
    double vertex[6][4];
    double color[6][3];
    for (int i = 0; i < 6; i++) {
        const double w = 1 + 0.3 * i;
        vertex[i][0] = corner[i][0] * w;
        vertex[i][1] = corner[i][1] * w;
        vertex[i][2] = 0.2 * w;
        vertex[i][3] = w;
        for (int k = 0; k < 3; k++)
            color[i][k] = (i + k) % 5 / 4.0;
    }
    scene_pixels();
    glVertexPointer(4, GL_DOUBLE, 0, vertex);
    glColorPointer(3, GL_DOUBLE, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
}

/* Fields of a struct; signed colors and normals. */
static void strides(void)
{
    struct vertex {
        GLbyte normal[4];
        GLfloat position[2];
        GLbyte color[4];
    } v[6];
    for (int i = 0; i < 6; i++)
        v[i] = (struct vertex){{(GLbyte)(20 * i), (GLbyte)(40 - 20 * i), 100, 0},
                               {corner[i][0] + 0.25f, corner[i][1] - 0.25f},
                               {(GLbyte)(25 * i), (GLbyte)(127 - 20 * i), 90, 127}};
    scene_pixels();
    scene_light(0.3f, 0.4f, 1, 0);
    glEnable(GL_COLOR_MATERIAL);
    glVertexPointer(2, GL_FLOAT, sizeof v[0], v[0].position);
    glNormalPointer(GL_BYTE, sizeof v[0], v[0].normal);
    glColorPointer(4, GL_BYTE, sizeof v[0], v[0].color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_POLYGON, 0, 6);
}

static void normals(void)
{
    GLshort shorts[6][3];
    GLint ints[6][3];
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++) {
            shorts[i][k] = (GLshort)(k == 2 ? 30000 : 5000 * (i - 3 * k));
            ints[i][k] = 65000 * shorts[i][k];
        }
    scene_pixels();
    scene_light(0.3f, 0.4f, 1, 0);
    glScalef(0.5f, 1, 1);
    glVertexPointer(2, GL_SHORT, 0, corner);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_SHORT, 0, shorts);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
    glTranslatef(64, 0, 0);
    glNormalPointer(GL_INT, 0, ints);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
}

/* The same with indices of each type, and one by one. */
static void elements(void)
{
    static const GLubyte bytes[] = {0, 1, 2, 0, 3, 4};
    static const GLushort shorts[] = {0, 1, 2, 5, 3, 4, 1, 0};
    static const GLuint ints[] = {5, 4, 3, 2};
    static const GLfloat color[6][4] = {{1, 1, 1, 1}, {1, 0, 0, 0.5f}, {0.7f, 1, 0, 1},
                                        {0, 1, 0, 1}, {0, 0.4f, 1, 1}, {0.3f, 0, 1, 0}};
    scene_pixels();
    glScalef(0.5f, 0.5f, 1);
    glVertexPointer(2, GL_SHORT, 0, corner);
    glColorPointer(4, GL_FLOAT, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, bytes);
    glTranslatef(64, 0, 0);
    glDrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, shorts);
    glTranslatef(0, 64, 0);
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_INT, ints);
    glTranslatef(-64, 0, 0);
    glBegin(GL_LINE_LOOP);
    for (int i = 5; i >= 0; i--)
        glArrayElement(i);
    glEnd();
}

static void interleaved(void)
{
    struct {
        GLubyte color[4];
        GLfloat position[3];
    } c4ub_v3f[6];
    GLfloat c4f_n3f_v3f[6][10];
    for (int i = 0; i < 6; i++) {
        const float x = corner[i][0], y = corner[i][1];
        const GLfloat row[10] = {0.1f * (float)i, 0.5f, 0.9f, 1, 0.1f * (float)i, 0.3f, 0.8f, x, y, 0};
        for (int k = 0; k < 10; k++)
            c4f_n3f_v3f[i][k] = row[k];
        for (int k = 0; k < 4; k++)
            c4ub_v3f[i].color[k] = (GLubyte)(40 * i + 12 * k);
        c4ub_v3f[i].position[0] = x;
        c4ub_v3f[i].position[1] = y;
        c4ub_v3f[i].position[2] = 0;
    }
    scene_pixels();
    glScalef(0.5f, 1, 1);
    glInterleavedArrays(GL_C4UB_V3F, 0, c4ub_v3f);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
    glTranslatef(64, 0, 0);
    scene_light(0, 0, 1, 0);
    glEnable(GL_COLOR_MATERIAL);
    glInterleavedArrays(GL_C4F_N3F_V3F, 0, c4f_n3f_v3f);
    glDrawArrays(GL_TRIANGLE_FAN, 0, 6);
}

const struct scene scenes_of_arrays[] = {
        {"arrays-short", vertices_short},    {"arrays-int", vertices_int},
        {"arrays-double", vertices_double},  {"arrays-strides", strides},
        {"arrays-normals", normals},         {"arrays-elements", elements},
        {"arrays-interleaved", interleaved}, {NULL, NULL},
};
