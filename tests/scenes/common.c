/* What several scenes use. */
#include <math.h>

#include "scenes/scene.h"

void scene_pixels(void)
{
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, SCENE_SIZE, 0, SCENE_SIZE, -1, 1);
    glMatrixMode(GL_MODELVIEW);
}

void scene_perspective(void)
{
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.6, 0.6, -0.6, 0.6, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    glEnable(GL_DEPTH_TEST);
}

static void sphere_vertex(float theta, float phi, float normal_length)
{
    const float x = sinf(theta) * cosf(phi), y = cosf(theta), z = sinf(theta) * sinf(phi);
    glNormal3f(normal_length * x, normal_length * y, normal_length * z);
    glVertex3f(1.2f * x, 1.2f * y, 1.2f * z);
}

void scene_sphere(int slices, float normal_length)
{
    const int stacks = slices / 2;
    for (int stack = 0; stack < stacks; stack++) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= slices; i++)
            for (int k = 0; k < 2; k++)
                sphere_vertex(3.14159265f * (float)(stack + k) / (float)stacks,
                              -6.2831853f * (float)i / (float)slices, normal_length);
        glEnd();
    }
}

void scene_light(float x, float y, float z, float w)
{
    const float position[4] = {x, y, z, w};
    static const float diffuse[4] = {0.7f, 0.5f, 0.3f, 1}, specular[4] = {0.8f, 0.8f, 0.9f, 1};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

void scene_ring_vertex(int i, int count, float x, float y, float radius)
{
    const float angle = 6.2831853f * (float)i / (float)count + 0.2f;
    glColor3f(0.5f + 0.5f * cosf(angle), 0.5f + 0.5f * sinf(angle), (float)(i % 3) / 2);
    glVertex2f(x + radius * cosf(angle), y + radius * sinf(angle));
}
