/* GL 1.5, 3.8 texturing: filters, wrap modes, level of detail, targets, environments, units. */
#include <stddef.h>

#include "scenes/scene.h"

enum { MOST = 32 };

/* Texels that differ in every channel; number tells images from one another. */
static void make_image(GLenum target, int level, int number, int width, int height)
{
    static GLubyte image[MOST * MOST][4];
    for (int i = 0; i < width * height; i++) {
        image[i][0] = (GLubyte)(i * 37 + number * 61);
        image[i][1] = (GLubyte)(i * 11 + number * 17 + 90);
        image[i][2] = (GLubyte)(255 - i * 23);
        image[i][3] = (GLubyte)(i * 53 + 128);
    }
    glTexImage2D(target, level, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
}

static void make_texture(int width, int height, GLenum min_filter, GLenum mag_filter, GLenum wrap)
{
    for (int level = 0, w = width, h = height;; level++, w = w > 1 ? w / 2 : 1, h = h > 1 ? h / 2 : 1) {
        make_image(GL_TEXTURE_2D, level, level, w, h);
        if (w == 1 && h == 1)
            break;
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (int)min_filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (int)mag_filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (int)wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (int)wrap);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (float[]){0.9f, 0.5f, 0.1f, 0.7f});
    glEnable(GL_TEXTURE_2D);
}

/* A leaning wall with coordinates from -repeat to repeat and another color at each corner. */
static void wall(float repeat)
{
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    scene_perspective();
    glRotatef(55, 1, 0.4f, 0);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        glColor4f(0.4f + 0.2f * (float)i, 1 - 0.2f * (float)i, 0.8f, 0.5f);
        glTexCoord2f(repeat * corner[i][0], repeat * corner[i][1]);
        glMultiTexCoord2f(GL_TEXTURE1, repeat * corner[i][1], corner[i][0]);
        glVertex3f(1.8f * corner[i][0], 1.8f * corner[i][1], 0);
    }
    glEnd();
}

static void nearest(void)
{
    make_texture(16, 8, GL_NEAREST, GL_NEAREST, GL_REPEAT);
    wall(1.5f);
}

static void linear(void)
{
    make_texture(16, 8, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    wall(1.5f);
}

static void odd_size(void)
{
    make_texture(13, 7, GL_LINEAR, GL_LINEAR, GL_REPEAT);
    wall(1.5f);
}

static void border(void)
{
    make_texture(5, 8, GL_LINEAR, GL_LINEAR, GL_CLAMP);
    wall(1.5f);
}

static void mirrored(void)
{
    make_texture(8, 8, GL_LINEAR, GL_NEAREST, GL_MIRRORED_REPEAT);
    wall(3);
}

static void mipmap_nearest(void)
{
    make_texture(32, 16, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT);
    wall(3);
}

static void trilinear(void)
{
    make_texture(32, 16, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
    wall(3);
}

static void mixed_at_the_border(void)
{
    make_texture(32, 32, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_BORDER);
    wall(1.2f);
}

static void limited_levels(void)
{
    make_texture(32, 32, GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST, GL_REPEAT);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 0.75f);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 2.5f);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 0.3f);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
    wall(4);
}

static void cube_map(void)
{
    for (GLenum face = 0; face < 6; face++)
        for (int level = 0; level < 5; level++)
            make_image(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, (int)face + 6 * level, 16 >> level, 16 >> level);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    for (GLenum i = 0; i < 3; i++) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    glEnable(GL_TEXTURE_CUBE_MAP);
    scene_perspective();
    scene_sphere(12, 1);
}

static void sphere_map(void)
{
    make_texture(16, 16, GL_LINEAR, GL_LINEAR, GL_REPEAT);
    for (GLenum i = 0; i < 2; i++) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    scene_perspective();
    scene_light(1, 2, 3, 0);
    scene_sphere(12, 1);
}

static void two_units(void)
{
    make_texture(16, 8, GL_LINEAR, GL_LINEAR, GL_REPEAT);
    glActiveTexture(GL_TEXTURE1);
    make_texture(4, 4, GL_NEAREST, GL_NEAREST, GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glActiveTexture(GL_TEXTURE0);
    wall(1);
}

static void combined(void)
{
    make_texture(16, 8, GL_LINEAR, GL_LINEAR, GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD_SIGNED);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_INTERPOLATE);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
    wall(1);
}

/* The color is replaced, which makes the quad as if it were smooth: its diagonal is the first. */
static void replaced_flat(void)
{
    make_texture(8, 8, GL_LINEAR, GL_LINEAR, GL_REPEAT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glShadeModel(GL_FLAT);
    scene_pixels();
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        glColor3f(1, 0, 0);
        glTexCoord2f((float)i, (float)(i % 2));
        glVertex2f(i == 0 ? 4 : i == 1 ? 60 : i == 2 ? 30 : 20, i == 0 ? 4 : i == 1 ? 10 : i == 2 ? 20 : 60);
    }
    glEnd();
}

static void incomplete(void)
{
    make_image(GL_TEXTURE_2D, 0, 0, 8, 8); /* no mipmaps, and the filter asks for them */
    glEnable(GL_TEXTURE_2D);
    wall(1);
}

const struct scene scenes_of_textures[] = {
        {"texture-nearest", nearest},
        {"texture-linear", linear},
        {"texture-odd-size", odd_size},
        {"texture-border", border},
        {"texture-mirrored", mirrored},
        {"texture-mipmap-nearest", mipmap_nearest},
        {"texture-trilinear", trilinear},
        {"texture-mixed-at-the-border", mixed_at_the_border},
        {"texture-limited-levels", limited_levels},
        {"texture-cube-map", cube_map},
        {"texture-sphere-map", sphere_map},
        {"texture-two-units", two_units},
        {"texture-combined", combined},
        {"texture-replaced-flat", replaced_flat},
        {"texture-incomplete", incomplete},
        {NULL, NULL},
};
