/* GL 1.5, 2.14.1 to 2.14.3: materials, two-sided lighting, color material. */
#include <stddef.h>

#include "scenes/scene.h"

static const float red[4] = {0.8f, 0.1f, 0.1f, 0.9f}, blue[4] = {0.1f, 0.2f, 0.9f, 0.6f};

/* A band that turns its front and its back to the viewer. */
static void band(void)
{
    glDisable(GL_CULL_FACE);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= 12; i++)
        for (int k = 0; k < 2; k++) {
            const float t = (float)i / 12;
            glColor3f(t, 1 - t, (float)k);
            glNormal3f(0.6f - 1.2f * t, k ? 0.3f : -0.3f, 0.8f);
            glVertex3f(-1.5f + 3 * t, (t - 0.45f) * (k ? 3.0f : -3.0f), 0.4f * t);
        }
    glEnd();
}

static void two_sided(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, blue);
    glMaterialf(GL_BACK, GL_SHININESS, 3);
    band();
    glRotatef(180, 0, 1, 0);
    glTranslatef(0, 0.8f, -1);
    band();
}

static void two_sided_flat(void)
{
    glShadeModel(GL_FLAT);
    two_sided();
}

static void one_sided(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, blue);
    band();
}

static void emission(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glMaterialfv(GL_FRONT, GL_EMISSION, blue);
    scene_sphere(12, 1);
}

static void shininess_zero(void)
{
    scene_perspective();
    scene_light(2, 1, 3, 0);
    glMaterialf(GL_FRONT, GL_SHININESS, 0);
    scene_sphere(12, 1);
}

static void shininess_most(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glMaterialf(GL_FRONT, GL_SHININESS, 128);
    scene_sphere(24, 1);
}

static void color_material(GLenum face, GLenum mode)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glColorMaterial(face, mode);
    glEnable(GL_COLOR_MATERIAL);
    band();
}

static void color_material_diffuse(void)
{
    color_material(GL_FRONT_AND_BACK, GL_DIFFUSE);
}

static void color_material_both(void)
{
    color_material(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
}

static void color_material_specular(void)
{
    color_material(GL_FRONT_AND_BACK, GL_SPECULAR);
}

static void color_material_emission(void)
{
    color_material(GL_FRONT_AND_BACK, GL_EMISSION);
}

/* The material keeps what the color was when it stops to be tracked. */
static void color_material_constant(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(0.2f, 0.6f, 0.4f);
    glTranslatef(-0.7f, 0, 0);
    scene_sphere(8, 1);
    glColor3f(0.7f, 0.6f, 0.1f);
    glTranslatef(0.7f, 0.6f, 0);
    scene_sphere(8, 1);
    glDisable(GL_COLOR_MATERIAL);
    glColor3f(0, 0, 1);
    glTranslatef(0.7f, 0, 0);
    scene_sphere(8, 1);
}

static void material_per_vertex(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 1);
    for (int part = 0; part < 4; part++) {
        glBegin(GL_TRIANGLE_FAN);
        for (int i = 0; i < 6; i++) {
            const float angle[2] = {(float)(i % 3) - 1, (float)(i / 3) * 2 - 1};
            const float color[4] = {(float)(i % 2), (float)(i % 3) / 2, (float)i / 5, (float)i / 6};
            if (part == 0)
                glMaterialfv(GL_FRONT, GL_DIFFUSE, color);
            else if (part == 1)
                glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, color);
            else if (part == 2)
                glMaterialfv(GL_FRONT, GL_SPECULAR, color);
            else
                glMaterialf(GL_FRONT, GL_SHININESS, 10 * (float)i);
            glNormal3f(0.4f * angle[0], 0.4f * angle[1], 0.8f);
            glVertex3f(0.6f * (i < 3 ? angle[0] : -angle[0]) + (part & 1 ? 0.9f : -0.9f),
                       0.6f * angle[1] + (part & 2 ? 0.9f : -0.9f), 0);
        }
        glEnd();
    }
}

static void material_between_primitives(void)
{
    scene_perspective();
    scene_light(1, 1, 3, 0);
    for (int i = 0; i < 5; i++) {
        const float color[4] = {(float)i / 4, 0.5f, 1 - (float)i / 4, 1};
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
        glMaterialf(GL_FRONT, GL_SHININESS, 4 * (float)i);
        glPushMatrix();
        glTranslatef(-1.4f + 0.7f * (float)i, 0.5f * (float)(i % 3) - 0.5f, 0);
        glScalef(0.4f, 0.4f, 0.4f);
        scene_sphere(8, 0.4f);
        glPopMatrix();
    }
}

const struct scene scenes_of_materials[] = {
        {"two-sided", two_sided},
        {"two-sided-flat", two_sided_flat},
        {"one-sided", one_sided},
        {"emission", emission},
        {"shininess-0", shininess_zero},
        {"shininess-128", shininess_most},
        {"color-material-diffuse", color_material_diffuse},
        {"color-material-ambient-diffuse", color_material_both},
        {"color-material-specular", color_material_specular},
        {"color-material-emission", color_material_emission},
        {"color-material-constant", color_material_constant},
        {"material-per-vertex", material_per_vertex},
        {"material-between-primitives", material_between_primitives},
        {NULL, NULL},
};
