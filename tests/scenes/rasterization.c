/* GL 1.5, 2.11.1 viewport, 3.5 polygons, 4.1 scissor and depth, 4.2 masks and clearing. */
#include <stddef.h>

#include "scenes/scene.h"

static void quad(float x0, float y0, float x1, float y1, float z)
{
    glBegin(GL_QUADS);
    glVertex3f(x0, y0, z);
    glVertex3f(x1, y0, z);
    glVertex3f(x1, y1, z);
    glVertex3f(x0, y1, z);
    glEnd();
}

/* Two triangles of either winding. */
static void both_windings(void)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0.4f, 0);
    glVertex2f(4, 4);
    glVertex2f(30, 8);
    glVertex2f(12, 60);
    glColor3f(0, 0.4f, 1);
    glVertex2f(34, 4);
    glVertex2f(40, 60);
    glVertex2f(60, 30);
    glEnd();
}

static void cull_back(void)
{
    scene_pixels();
    glEnable(GL_CULL_FACE);
    both_windings();
}

static void cull_front(void)
{
    scene_pixels();
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    both_windings();
}

static void front_face(void)
{
    scene_pixels();
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    both_windings();
}

/* Faces culled one by one in a sphere; also lines and points, which never are. */
static void cull_all(void)
{
    scene_perspective();
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT_AND_BACK);
    scene_sphere(8, 1);
    glBegin(GL_LINES);
    glVertex3f(-1, -1, 0);
    glVertex3f(1, 1, 0);
    glEnd();
}

/* A wall drawn twice: the second is pulled to the front on one side only. */
static void polygon_offset(void)
{
    scene_perspective();
    glRotatef(50, 1, 1, 0);
    glColor3f(0.6f, 0.6f, 0.6f);
    quad(-1.5f, -1.5f, 1.5f, 1.5f, 0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
    glColor3f(1, 0, 0);
    quad(-1.2f, -1.2f, 0, 1.2f, 0);
    glPolygonOffset(1, 2);
    glColor3f(0, 1, 0);
    quad(0, -1.2f, 1.2f, 1.2f, 0);
    glPolygonOffset(0, 1);
    glColor3f(0, 0, 1);
    quad(-1, -1.5f, 1, -1.3f, 0);
}

static void scissor(void)
{
    scene_pixels();
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 20, 33, 17);
    glClearColor(0.2f, 0.3f, 0.4f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    glScissor(15, 5, 30, 50);
    both_windings();
    glScissor(0, 0, 0, 10);
    quad(0, 0, 64, 64, 0);
}

/* Eight functions in eight columns, against a slope that crosses the depth in the buffer. */
static void depth_functions(void)
{
    scene_pixels();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glColor3f(0.3f, 0.3f, 0.3f);
    quad(0, 0, 64, 64, 0);
    for (int i = 0; i < 8; i++) {
        glDepthFunc(GL_NEVER + (GLenum)i);
        glColor3f(1, (float)i / 7, 0);
        glBegin(GL_QUADS);
        glVertex3f(8 * (float)i, 4, -0.5f);
        glVertex3f(8 * (float)i + 7, 4, -0.5f);
        glVertex3f(8 * (float)i + 7, 44, 0.5f);
        glVertex3f(8 * (float)i, 44, 0.5f);
        glEnd();
        quad(8 * (float)i, 50, 8 * (float)i + 7, 60, 0);
    }
}

static void depth_mask(void)
{
    scene_pixels();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glColor3f(1, 0, 0);
    quad(5, 5, 40, 40, 0.5f);
    glDepthMask(GL_TRUE);
    glColor3f(0, 1, 0);
    quad(20, 20, 60, 60, -0.5f);
    glDepthMask(GL_FALSE);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
}

static void depth_range(void)
{
    scene_pixels();
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 4; i++) {
        static const double range[4][2] = {{0, 1}, {0.25, 0.75}, {1, 0}, {-2, 3}};
        glDepthRange(range[i][0], range[i][1]);
        glBegin(GL_TRIANGLES);
        glColor3f(1, 0, 0);
        glVertex3f(16 * (float)i, 2, -1);
        glColor3f(0, 1, 0);
        glVertex3f(16 * (float)i + 15, 5, 0.3f);
        glColor3f(0, 0, 1);
        glVertex3f(16 * (float)i + 5, 60, 1);
        glEnd();
    }
}

static void color_mask(void)
{
    scene_pixels();
    for (int i = 0; i < 16; i++) {
        glColorMask(i & 1, i >> 1 & 1, i >> 2 & 1, i >> 3 & 1);
        glColor4f(0.9f, 0.8f, 0.7f, 0.6f);
        quad(16 * (float)(i % 4), 16 * (float)(i / 4), 16 * (float)(i % 4) + 13, 16 * (float)(i / 4) + 13, 0);
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 30, 64, 4);
    glColorMask(1, 0, 1, 0);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void viewport(void)
{
    glViewport(7, 11, 40, 30);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex3f(-1, -1, 0);
    glColor3f(0, 1, 0);
    glVertex3f(1, -0.6f, 0.5f);
    glColor3f(0, 0, 1);
    glVertex3f(0.1f, 1, -0.5f);
    glEnd();
    glViewport(-20, 40, 100, 15);
    glBegin(GL_LINE_LOOP);
    glVertex2f(-0.9f, -0.9f);
    glVertex2f(0.9f, -0.9f);
    glVertex2f(0.2f, 0.9f);
    glEnd();
    glPointSize(9);
    glBegin(GL_POINTS); /* reaches out of the viewport */
    glVertex2f(0.1f, 0.95f);
    glEnd();
}

/* Random triangles that share corners: no pixel is missed or hit twice; z and color of each. */
static void mesh(void)
{
    unsigned random = 12345;
    float corner[9][9][2];
    scene_pixels();
    for (int j = 0; j < 9; j++)
        for (int i = 0; i < 9; i++)
            for (int k = 0; k < 2; k++) {
                random = random * 1664525u + 1013904223u;
                corner[j][i][k] = 8 * (float)(k ? j : i) + (float)(random >> 8) * (3.0f / 16777216);
            }
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_DEPTH_TEST);
    for (int j = 0; j < 8; j++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 9; i++)
            for (int k = 0; k < 2; k++) {
                glColor3f((float)((i + j) % 2), (float)i / 8, (float)(j + k) / 8);
                glVertex3f(corner[j + k][i][0], corner[j + k][i][1], 0.1f * (float)(i - j));
            }
        glEnd();
    }
}

static void slivers(void)
{
    scene_pixels();
    glEnable(GL_DEPTH_TEST);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 20; i++) {
        const float y = 1.3f + 3.1f * (float)i;
        glColor3f(1, 0, (float)i / 19);
        glVertex3f(1.1f, y, -0.9f);
        glColor3f(0, 1, 0);
        glVertex3f(62.3f, y + 0.05f * (float)i, 0.9f);
        glColor3f(0, 0, 1);
        glVertex3f(40.7f, y + 0.4f + 0.05f * (float)i, 0.1f);
    }
    glEnd();
}

static void perspective_colors(void)
{
    scene_perspective();
    glRotatef(70, 1, 0.2f, 0);
    glBegin(GL_TRIANGLE_STRIP);
    glColor4f(1, 0, 0, 1);
    glVertex3f(-2, -3, 0);
    glColor4f(0, 1, 0, 0.5f);
    glVertex3f(2, -3, 0);
    glColor4f(0, 0, 1, 0.25f);
    glVertex3f(-2, 6, 0);
    glColor4f(1, 1, 1, 0);
    glVertex3f(2, 6, 0);
    glEnd();
}

static void clear_values(void)
{
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 64; i++) {
        const float v = (float)i / 63;
        glScissor(i, 0, 1, SCENE_SIZE);
        glClearColor(v, v * v, 1.5f - 2 * v, 1 - v);
        glClearDepth((double)v);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
}

const struct scene scenes_of_rasterization[] = {
        {"cull-back", cull_back},
        {"cull-front", cull_front},
        {"front-face", front_face},
        {"cull-all", cull_all},
        {"polygon-offset", polygon_offset},
        {"scissor", scissor},
        {"depth-functions", depth_functions},
        {"depth-mask", depth_mask},
        {"depth-range", depth_range},
        {"color-mask", color_mask},
        {"viewport", viewport},
        {"mesh", mesh},
        {"slivers", slivers},
        {"perspective-colors", perspective_colors},
        {"clear-values", clear_values},
        {NULL, NULL},
};
