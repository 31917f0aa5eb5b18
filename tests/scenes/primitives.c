/* GL 1.5, 2.6.1 "Begin and End", 3.3 to 3.5: each primitive, its provoking vertex, points, lines, polygon
 * modes. */
#include <stddef.h>

#include "scenes/scene.h"

/* Alternating about a zigzag, as strips need it. */
static void zigzag_vertex(int i, float x, float y)
{
    glColor3f((float)(i % 4) / 3, (float)(i % 3) / 2, (float)(i % 2));
    glVertex2f(x + 6.3f * (float)i, y + (i & 1 ? 14.6f : 0));
}

static void strip(GLenum mode, int count, float y)
{
    glBegin(mode);
    for (int i = 0; i < count; i++)
        zigzag_vertex(i, 3.2f, y);
    glEnd();
}

static void ring(GLenum mode, int count, float x, float y, float radius)
{
    glBegin(mode);
    for (int i = 0; i < count; i++)
        scene_ring_vertex(i, count, x, y, radius);
    glEnd();
}

static void points(void)
{
    scene_pixels();
    ring(GL_POINTS, 17, 32, 32, 28.3f);
    strip(GL_POINTS, 9, 20);
}

static void lines(void)
{
    scene_pixels();
    ring(GL_LINES, 20, 32, 32, 30.3f);
    strip(GL_LINES, 9, 24);
}

static void line_strip(void)
{
    scene_pixels();
    strip(GL_LINE_STRIP, 9, 10);
    ring(GL_LINE_STRIP, 7, 32, 40, 20.7f);
}

static void line_loop(void)
{
    scene_pixels();
    ring(GL_LINE_LOOP, 9, 30.5f, 31.2f, 28);
    ring(GL_LINE_LOOP, 2, 30.5f, 31.2f, 12);
}

static void triangles(void)
{
    scene_pixels();
    ring(GL_TRIANGLES, 12, 32, 32, 30);
}

static void triangle_strip(void)
{
    scene_pixels();
    strip(GL_TRIANGLE_STRIP, 9, 5);
    strip(GL_TRIANGLE_STRIP, 8, 35);
}

static void triangle_fan(void)
{
    scene_pixels();
    ring(GL_TRIANGLE_FAN, 7, 32, 32, 30);
}

static void quads(void)
{
    scene_pixels();
    ring(GL_QUADS, 8, 32, 32, 30);
}

static void quad_strip(void)
{
    scene_pixels();
    strip(GL_QUAD_STRIP, 9, 5);
    strip(GL_QUAD_STRIP, 8, 35);
}

static void polygon(void)
{
    scene_pixels();
    ring(GL_POLYGON, 7, 32, 32, 30);
}

/* All ten, flat: the color is that of the provoking vertex. */
static void flat(void)
{
    scene_pixels();
    glShadeModel(GL_FLAT);
    glPushMatrix();
    glScalef(0.5f, 0.25f, 1);
    for (int mode = GL_POINTS; mode <= GL_POLYGON; mode++) {
        glPushMatrix();
        glTranslatef(mode & 1 ? 64.0f : 0.0f, (float)(mode / 2) * 50, 0);
        if (mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP)
            strip((GLenum)mode, 9, 10);
        else
            ring((GLenum)mode, 8, 32, 24, 22);
        glPopMatrix();
    }
    glPopMatrix();
}

/* Vertices too few for one more primitive are ignored. */
static void incomplete(void)
{
    static const int counts[] = {0, 1, 1, 1, 5, 2, 2, 7, 5, 2};
    scene_pixels();
    for (int mode = GL_POINTS; mode <= GL_POLYGON; mode++)
        ring((GLenum)mode, counts[mode], 8 + 12 * (float)(mode % 5), mode < 5 ? 18.0f : 46.0f, 9);
}

static void point_sizes(void)
{
    scene_pixels();
    for (int i = 0; i < 16; i++) {
        glPointSize(0.5f + 0.6f * (float)i);
        glBegin(GL_POINTS);
        glColor3f((float)i / 15, 1, 1 - (float)i / 15);
        glVertex2f(8.1f + 16 * (float)(i % 4), 8.3f + 16.03f * (float)(i / 4));
        glEnd();
    }
}

static void line_widths(void)
{
    scene_pixels();
    for (int i = 0; i < 8; i++) {
        glLineWidth(0.5f + 0.7f * (float)i);
        glBegin(GL_LINES);
        glColor3f(1, (float)i / 7, 0);
        glVertex2f(3, 4 + 7.3f * (float)i);
        glColor3f(0, (float)i / 7, 1);
        glVertex2f(30, 7.7f + 7.3f * (float)i);
        glVertex2f(36 + 3.4f * (float)i, 4);
        glVertex2f(33 + 3.8f * (float)i, 60);
        glEnd();
    }
}

static void polygon_modes(void)
{
    scene_pixels();
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    ring(GL_QUADS, 4, 16, 16, 14);
    ring(GL_POLYGON, 6, 48, 16, 14);
    ring(GL_TRIANGLE_FAN, 6, 16, 48, 14);
    glFrontFace(GL_CW);
    ring(GL_POLYGON, 6, 48, 48, 14);
}

static void edge_flags(void)
{
    scene_pixels();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(GL_POLYGON);
    for (int i = 0; i < 7; i++) {
        glEdgeFlag(i % 3 != 1);
        scene_ring_vertex(i, 7, 20, 32, 18);
    }
    glEnd();
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 6; i++) {
        glEdgeFlag(i & 1);
        scene_ring_vertex(i, 6, 48, 32, 14);
    }
    glEnd();
}

static void rectangles(void)
{
    scene_pixels();
    glColor3f(1, 0.5f, 0);
    glRectf(3.5f, 4.5f, 20.25f, 30.75f);
    glColor3f(0, 0.5f, 1);
    glRecti(60, 60, 30, 40);
    glColor3ub(10, 200, 30);
    glRects(30, 5, 50, 30);
}

const struct scene scenes_of_primitives[] = {
        {"points", points},
        {"lines", lines},
        {"line-strip", line_strip},
        {"line-loop", line_loop},
        {"triangles", triangles},
        {"triangle-strip", triangle_strip},
        {"triangle-fan", triangle_fan},
        {"quads", quads},
        {"quad-strip", quad_strip},
        {"polygon", polygon},
        {"flat-provoking-vertex", flat},
        {"incomplete-primitives", incomplete},
        {"point-sizes", point_sizes},
        {"line-widths", line_widths},
        {"polygon-modes", polygon_modes},
        {"edge-flags", edge_flags},
        {"rectangles", rectangles},
        {NULL, NULL},
};
