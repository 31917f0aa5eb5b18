/* GL 1.5, 2.11.2 "Matrices". */
#include <stddef.h>

#include "scenes/scene.h"

/* Four triangles: of three, the last seen edge on, OSMesa draws none. */
static void axes(void)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 1, 1);
    glVertex3f(0, 0.2f, 0.1f);
    glVertex3f(0.1f, 0, 0.2f);
    glVertex3f(0.2f, 0.1f, 0);
    for (int k = 0; k < 3; k++) {
        const float x = (float)(k == 0), y = (float)(k == 1), z = (float)(k == 2);
        glColor3f(x, y, z);
        glVertex3f(0.2f * z, 0.2f * x, 0.2f * y);
        glVertex3f(x, y, z);
        glVertex3f(-0.2f * z, -0.2f * x, -0.2f * y);
    }
    glEnd();
}

static void rotations(void)
{
    scene_perspective();
    for (int i = 0; i < 16; i++) {
        glPushMatrix();
        glTranslatef(-1.5f + (float)(i % 4), -1.5f + (float)(i / 4), 0);
        glScalef(0.6f, 0.6f, 0.6f);
        if (i < 4)
            glRotatef(40 * (float)i + 10, 1, 0, 0);
        else if (i < 8)
            glRotatef(40 * (float)i, 0, 2, 0);
        else if (i < 12)
            glRotated(-33 * i, 0, 0, -1);
        else
            glRotatef(25 * (float)i, 1, (float)i, -3);
        axes();
        glPopMatrix();
    }
}

static void stacks(void)
{
    scene_perspective();
    glPushMatrix();
    for (int i = 0; i < 8; i++) {
        glRotatef(30, 0, 0, 1);
        glTranslatef(0.4f, 0.1f, 0.1f);
        glPushMatrix();
        glScalef(0.5f, 0.7f, 0.9f);
        axes();
    }
    for (int i = 0; i < 8; i++) {
        glPopMatrix();
        glRotatef(-10, 0, 1, 0);
        axes();
    }
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glOrtho(-3, 3, -3, 3, -10, 10);
    axes();
    glPopMatrix();
    axes();
}

static void load_and_multiply(void)
{
    static const float shear[16] = {1, 0.3f, 0, 0, -0.4f, 1, 0.2f, 0, 0, 0, 1, 0, 0.1f, -0.2f, 0, 1};
    static const double projective[16] = {1, 0, 0, 0.2, 0, 1, 0, -0.1, 0, 0, 0.5, 0.1, 0, 0, 0, 1.4};
    glLoadMatrixf(shear);
    axes();
    glScaled(0.5, -0.5, 0.5);
    glMultMatrixd(projective);
    axes();
    glLoadIdentity();
    glTranslated(-0.5, 0.5, 0);
    glMultMatrixf(shear);
    axes();
}

/* Four coordinates; integers; two. */
static void coordinates(void)
{
    static const double d[4] = {0.5, 1, 0, 2};
    static const short s[2] = {1, 0};
    glBegin(GL_TRIANGLE_FAN);
    glVertex2i(0, 0);
    glColor3f(1, 0, 0);
    glVertex2sv(s);
    glColor3f(0, 1, 0);
    glVertex4dv(d);
    glColor3f(0, 0, 1);
    glVertex4f(-0.3f, 0.5f, 0.1f, 0.7f);
    glColor3d(1, 1, 0);
    glVertex3i(-1, -1, 0);
    glColor3us(65535, 300, 20000);
    glVertex4s(1, -2, 0, 3);
    glEnd();
}

const struct scene scenes_of_matrices[] = {
        {"rotations", rotations},
        {"matrix-stacks", stacks},
        {"load-and-multiply", load_and_multiply},
        {"coordinates", coordinates},
        {NULL, NULL},
};
