/* GL 1.5, 5.4 "Display Lists", 6.1.14 attribute stacks. */
#include <stddef.h>

#include "scenes/scene.h"

static void fan(float x, float y, float radius)
{
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i < 7; i++)
        scene_ring_vertex(i, 7, x, y, radius);
    glEnd();
}

static void list(void)
{
    const GLuint name = glGenLists(1);
    glNewList(name, GL_COMPILE);
    fan(16, 16, 14);
    glTranslatef(30, 5, 0);
    glEndList();
    scene_pixels();
    glCallList(name);
    glCallList(name);
    glLoadIdentity();
    glTranslatef(0, 30, 0);
    glShadeModel(GL_FLAT);
    glCallList(name);
    glDeleteLists(name, 1);
    glCallList(name);
}

static void compile_and_execute(void)
{
    scene_pixels();
    const GLuint name = glGenLists(1);
    glNewList(name, GL_COMPILE_AND_EXECUTE);
    fan(20, 20, 18);
    glColor3f(0.3f, 0.9f, 0.2f);
    glTranslatef(22, 22, 0);
    glEndList();
    glRecti(0, 0, 6, 6);
    glCallList(name);
    glRecti(0, 0, 6, 6);
}

/* Lists within lists, changed after they were compiled in. */
static void nested(void)
{
    const GLuint name = glGenLists(3);
    glNewList(name, GL_COMPILE);
    fan(0, 0, 9);
    glEndList();
    glNewList(name + 1, GL_COMPILE);
    glPushMatrix();
    glTranslatef(12, 12, 0);
    glCallList(name);
    glPopMatrix();
    glTranslatef(19, 3, 0);
    glEndList();
    glNewList(name + 2, GL_COMPILE);
    for (int i = 0; i < 3; i++)
        glCallList(name + 1);
    glEndList();
    scene_pixels();
    glCallList(name + 2);
    glNewList(name, GL_COMPILE);
    glRecti(-6, -6, 5, 7);
    glEndList();
    glLoadIdentity();
    glTranslatef(0, 30, 0);
    glCallList(name + 2);
}

static void call_lists(void)
{
    static const GLubyte bytes[] = {2, 0, 1, 2, 0};
    static const GLshort shorts[] = {1, 0, 2};
    const GLuint name = glGenLists(3);
    for (GLuint i = 0; i < 3; i++) {
        glNewList(name + i, GL_COMPILE);
        glColor3f((float)i / 2, 1 - (float)i / 2, 0.5f);
        glRecti(1, 1, 9, 8 + 8 * (int)i);
        glTranslatef(12, (float)i, 0);
        glEndList();
    }
    scene_pixels();
    glListBase(name);
    glCallLists(5, GL_UNSIGNED_BYTE, bytes);
    glLoadIdentity();
    glTranslatef(0, 32, 0);
    glCallLists(3, GL_SHORT, shorts);
}

/* Vertices in a list, glBegin and glEnd around it; lights and materials in a list. */
static void parts(void)
{
    static const float green[4] = {0.1f, 0.7f, 0.2f, 1}, position[4] = {1, 1, 2, 0};
    const GLuint name = glGenLists(2);
    glNewList(name, GL_COMPILE);
    for (int i = 0; i < 5; i++) {
        glNormal3f(0.2f * (float)(i - 2), 0.3f, 0.9f);
        scene_ring_vertex(i, 5, 0, 0, 1.2f);
    }
    glEndList();
    glNewList(name + 1, GL_COMPILE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, green);
    glEndList();
    scene_perspective();
    glBegin(GL_LINE_LOOP);
    glCallList(name);
    glEnd();
    glRotatef(30, 1, 0, 0);
    glCallList(name + 1);
    glTranslatef(0.5f, -0.6f, 0);
    glBegin(GL_POLYGON);
    glCallList(name);
    glEnd();
}

/* Arrays are read when a list is compiled. */
static void arrays(void)
{
    float vertex[4][2] = {{4, 4}, {40, 8}, {30, 60}, {8, 30}};
    const GLuint name = glGenLists(1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertex);
    glNewList(name, GL_COMPILE);
    glDrawArrays(GL_QUADS, 0, 4);
    glEndList();
    for (int i = 0; i < 4; i++)
        vertex[i][0] = 0;
    scene_pixels();
    glColor3f(0.9f, 0.3f, 0.5f);
    glCallList(name);
}

static void attributes(void)
{
    scene_pixels();
    glColor3f(1, 0.8f, 0.1f);
    glPushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT | GL_ENABLE_BIT);
    glColor3f(0, 0.5f, 1);
    glShadeModel(GL_FLAT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 20, 20);
    glRecti(2, 2, 30, 30);
    glPushAttrib(GL_VIEWPORT_BIT | GL_TRANSFORM_BIT | GL_SCISSOR_BIT | GL_POLYGON_BIT);
    glViewport(32, 32, 32, 32);
    glDisable(GL_SCISSOR_TEST);
    glCullFace(GL_FRONT);
    glEnable(GL_CULL_FACE);
    fan(32, 32, 30);
    glFrontFace(GL_CW);
    fan(32, 32, 20);
    glPopAttrib();
    fan(16, 16, 8);
    glPopAttrib();
    fan(16, 48, 14);
    glRecti(40, 4, 60, 24);
}

const struct scene scenes_of_lists[] = {
        {"list", list},
        {"list-compile-and-execute", compile_and_execute},
        {"list-nested", nested},
        {"call-lists", call_lists},
        {"list-parts", parts},
        {"list-arrays", arrays},
        {"attribute-stack", attributes},
        {NULL, NULL},
};
