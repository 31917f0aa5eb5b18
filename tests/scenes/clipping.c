/* GL 1.5, 2.12 "Clipping": at each plane of the view volume and at the user's. */
#include <math.h>
#include <stddef.h>

#include "scenes/scene.h"

/* A smooth triangle; everything outside the cube from -1 to 1 is clipped. */
static void triangle(float ax, float ay, float az, float bx, float by, float bz, float cx, float cy, float cz)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex3f(ax, ay, az);
    glColor3f(0, 1, 0);
    glVertex3f(bx, by, bz);
    glColor3f(0, 0, 1);
    glVertex3f(cx, cy, cz);
    glEnd();
}

static void left(void)
{
    triangle(-1.9f, 0.1f, 0.2f, 0.7f, -0.8f, -0.3f, 0.6f, 0.9f, 0.4f);
}

static void right(void)
{
    triangle(1.9f, 0.1f, 0.2f, -0.7f, 0.8f, -0.3f, -0.6f, -0.9f, 0.4f);
}

static void bottom(void)
{
    triangle(0.1f, -1.8f, 0.2f, 0.8f, 0.7f, -0.3f, -0.9f, 0.6f, 0.4f);
}

static void top(void)
{
    triangle(0.1f, 1.8f, 0.2f, -0.8f, -0.7f, -0.3f, 0.9f, -0.6f, 0.4f);
}

static void near(void)
{
    triangle(0.1f, 0.8f, -1.7f, -0.8f, -0.7f, 0.3f, 0.9f, -0.6f, 0.4f);
}

static void far(void)
{
    triangle(0.1f, 0.8f, 1.7f, -0.8f, -0.7f, 0.3f, 0.9f, -0.6f, -0.4f);
}

static void every_plane(void)
{
    triangle(-3.1f, -1.2f, 1.6f, 2.8f, -2.1f, -1.7f, 0.4f, 3.3f, 0.3f);
}

static void flat(void)
{
    glShadeModel(GL_FLAT);
    triangle(-1.9f, 0.1f, 0.2f, 0.7f, -0.8f, -0.3f, 0.6f, 1.9f, 0.4f);
}

/* Behind the eye, w below 0. */
static void perspective(void)
{
    scene_perspective();
    triangle(-1.5f, -1.4f, 6, 1.9f, -1.2f, -2, 0.2f, 0.8f, -9);
    triangle(-1.5f, 0.6f, 1, 1.2f, 1.8f, 4.5f, 0.1f, -0.5f, -30);
}

/* One of a row of quads is clipped. */
static void quads(void)
{
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            const float x = (float)(k == 1 || k == 2), y = (float)(k > 1);
            glColor3f(x, y, (float)k / 3);
            glVertex3f(-1.1f + 0.55f * (float)i + 0.5f * x, -0.7f + 1.4f * y, 0.3f * x);
        }
    glEnd();
}

/* Primitives that cover themselves, each with one vertex outside: what is on top shows the order of their
 * parts. */
static void overlapping(void)
{
    for (int mode = GL_TRIANGLES; mode <= GL_POLYGON; mode++) {
        unsigned random = 77 + (unsigned)mode;
        glViewport(21 * (mode % 3), mode < GL_QUADS ? 0 : 32, 21, 32);
        glBegin((GLenum)mode);
        for (int i = 0; i < 12; i++) {
            float value[5];
            for (int k = 0; k < 5; k++) {
                random = random * 1664525u + 1013904223u;
                value[k] = (float)(random >> 8) * (1.0f / 16777216);
            }
            glColor3f(value[0], value[1], value[2]);
            glVertex2f(i == 5 ? 1.5f : 1.8f * value[3] - 0.9f, 1.8f * value[4] - 0.9f);
        }
        glEnd();
    }
}

static void overlapping_lines(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    overlapping();
}

static void lines(void)
{
    glBegin(GL_LINES);
    for (int i = 0; i < 24; i++) {
        const float angle = 0.2617994f * (float)i, c = cosf(angle), s = sinf(angle);
        glColor3f(1, (float)i / 23, 0);
        glVertex3f(0.2f * c, 0.2f * s, 0);
        glColor3f(0, (float)i / 23, 1);
        glVertex3f(1.6f * c, 1.6f * s, i % 3 ? 0.9f : 1.8f);
    }
    glEnd();
}

static void points(void)
{
    glPointSize(7);
    glBegin(GL_POINTS);
    for (int i = 0; i < 9; i++) {
        glColor3f((float)i / 8, 1, 0);
        glVertex3f(0.94f + 0.02f * (float)i, -1 + 0.25f * (float)i, 0);
        glVertex3f(-0.8f + 0.2f * (float)i, 0, -0.8f - 0.05f * (float)i);
    }
    glEnd();
}

static void user_plane(void)
{
    static const double plane[4] = {0.7, -0.4, 0.3, 0.15};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    triangle(-0.9f, -0.8f, 0.2f, 0.9f, -0.7f, -0.3f, 0.1f, 0.9f, 0.4f);
}

static void user_planes(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 0);
    glRotatef(25, 1, 1, 0);
    for (int i = 0; i < 6; i++) {
        const double angle = 1.0471975511965976 * i;
        const double plane[4] = {cos(angle), sin(angle), 0.2, 0.9};
        glClipPlane(GL_CLIP_PLANE0 + (GLenum)i, plane);
        glEnable(GL_CLIP_PLANE0 + (GLenum)i);
    }
    scene_sphere(16, 1);
}

/* The plane stands in the eye space of its time. */
static void user_plane_moves(void)
{
    static const double plane[4] = {1, 0, 0, 0};
    scene_perspective();
    glPushMatrix();
    glRotatef(35, 0, 0, 1);
    glScalef(2, 1, 1);
    glClipPlane(GL_CLIP_PLANE1, plane);
    glPopMatrix();
    glEnable(GL_CLIP_PLANE1);
    scene_light(0, 0, 1, 0);
    scene_sphere(12, 1);
    glDisable(GL_LIGHTING);
    glBegin(GL_LINES);
    glVertex3f(-2, 1.4f, 0);
    glVertex3f(2, 1.2f, 0);
    glEnd();
}

static void polygon_lines(void)
{
    static const double plane[4] = {0, -1, 0, 0.3};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    triangle(-1.9f, 0.1f, 0.2f, 0.7f, -0.8f, -0.3f, 0.6f, 0.9f, 0.4f);
}

const struct scene scenes_of_clipping[] = {
        {"clip-left", left},
        {"clip-right", right},
        {"clip-bottom", bottom},
        {"clip-top", top},
        {"clip-near", near},
        {"clip-far", far},
        {"clip-every-plane", every_plane},
        {"clip-flat", flat},
        {"clip-perspective", perspective},
        {"clip-quads", quads},
        {"clip-overlapping", overlapping},
        {"clip-overlapping-lines", overlapping_lines},
        {"clip-lines", lines},
        {"clip-points", points},
        {"user-plane", user_plane},
        {"user-planes", user_planes},
        {"user-plane-moves", user_plane_moves},
        {"clip-polygon-lines", polygon_lines},
        {NULL, NULL},
};
