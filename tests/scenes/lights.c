/* GL 1.5, 2.14.1 "Lighting": lights. */
#include <math.h>
#include <stddef.h>

#include "scenes/scene.h"

static void directional(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 0);
    scene_sphere(16, 1);
}

static void positional(void)
{
    scene_perspective();
    scene_light(1.5f, 1, 1.5f, 1);
    scene_sphere(16, 1);
}

static void attenuated(void)
{
    scene_perspective();
    scene_light(2, 1, 1.5f, 1);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5f);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2f);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1f);
    scene_sphere(16, 1);
}

static void spot(void)
{
    static const float direction[3] = {-0.6f, -0.4f, -1};
    scene_perspective();
    scene_light(1.5f, 1, 2.5f, 1);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 8);
    scene_sphere(24, 1);
}

static void directional_spot(void)
{
    static const float direction[3] = {-0.3f, -0.2f, -1};
    scene_perspective();
    scene_light(0.5f, 0.5f, 2, 0);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 20);
    scene_sphere(16, 1);
}

static void local_viewer(void)
{
    scene_perspective();
    scene_light(2, 1, 0.5f, 0);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    scene_sphere(16, 1);
}

static void local_viewer_positional(void)
{
    scene_perspective();
    scene_light(2, 1, 1, 1);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    scene_sphere(16, 1);
}

/* Of each kind two, around the sphere. */
static void eight(void)
{
    scene_perspective();
    scene_light(0, 0, 1, 0);
    for (int i = 0; i < 8; i++) {
        const GLenum light = GL_LIGHT0 + (GLenum)i;
        const float angle = 0.78f * (float)i;
        const float position[4] = {2 * cosf(angle), 2 * sinf(angle), 1.5f, (float)(i & 1)};
        const float color[4] = {(float)(i % 3) / 4, (float)(i % 4) / 6, (float)(i % 5) / 8, 1};
        const float inwards[3] = {-position[0], -position[1], -1.5f};
        glLightfv(light, GL_POSITION, position);
        glLightfv(light, GL_DIFFUSE, color);
        glLightfv(light, GL_SPECULAR, color);
        glLightfv(light, GL_SPOT_DIRECTION, inwards);
        glLightf(light, GL_SPOT_CUTOFF, i & 2 ? 40.0f : 180.0f);
        glLightf(light, GL_QUADRATIC_ATTENUATION, i & 4 ? 0.1f : 0.0f);
        glEnable(light);
    }
    scene_sphere(16, 1);
}

/* Position and direction are those of the modelview matrix at the time of the call. */
static void moved(void)
{
    static const float position[4] = {0, 0, 2, 1}, direction[3] = {0, 0, -1};
    scene_perspective();
    scene_light(0, 0, 1, 0);
    glPushMatrix();
    glRotatef(40, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);
    glPopMatrix();
    glRotatef(70, 1, 0, 0);
    scene_sphere(16, 1);
}

static void scene_ambient(void)
{
    static const float ambient[4] = {0.1f, 0.5f, 0.3f, 1}, material[4] = {0.9f, 0.8f, 0.4f, 0.7f};
    scene_perspective();
    scene_light(-1, 0.5f, 0, 0);
    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_AMBIENT, material);
    scene_sphere(12, 1);
}

static void separate_specular(void)
{
    scene_perspective();
    scene_light(1, 1, 2, 1);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    scene_sphere(16, 1);
}

static void normalize(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 0);
    glEnable(GL_NORMALIZE);
    glScalef(1, 0.5f, 1.2f);
    scene_sphere(16, 3);
}

static void not_normalized(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 0);
    glScalef(1, 0.5f, 1.2f);
    scene_sphere(16, 0.7f);
}

static void rescale_normal(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 1);
    glEnable(GL_RESCALE_NORMAL);
    glRotatef(20, 1, 0, 1);
    glScalef(0.6f, 0.6f, 0.6f);
    scene_sphere(16, 1);
}

static void flat(void)
{
    scene_perspective();
    scene_light(1, 2, 3, 0);
    glShadeModel(GL_FLAT);
    scene_sphere(12, 1);
}

const struct scene scenes_of_lights[] = {
        {"light-directional", directional},
        {"light-positional", positional},
        {"light-attenuated", attenuated},
        {"light-spot", spot},
        {"light-directional-spot", directional_spot},
        {"light-local-viewer", local_viewer},
        {"light-local-viewer-positional", local_viewer_positional},
        {"light-eight", eight},
        {"light-moved", moved},
        {"light-ambient", scene_ambient},
        {"light-separate-specular", separate_specular},
        {"normalize", normalize},
        {"normals-not-unit", not_normalized},
        {"rescale-normal", rescale_normal},
        {"light-flat", flat},
        {NULL, NULL},
};
