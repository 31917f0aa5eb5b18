/* Small pictures, one idea each, that must be byte for byte those of OSMesa. */
#ifndef TESTS_SCENES_SCENE_H
#define TESTS_SCENES_SCENE_H

#include <GL/gl.h>

enum { SCENE_SIZE = 64 };

/* Draws into a cleared context of SCENE_SIZE x SCENE_SIZE pixels in which all state has its initial value. */
struct scene {
    const char *name;
    void (*draw)(void);
};

/* Each ended by a NULL name; a file each. */
extern const struct scene scenes_of_primitives[];
extern const struct scene scenes_of_clipping[];
extern const struct scene scenes_of_rasterization[];
extern const struct scene scenes_of_matrices[];
extern const struct scene scenes_of_lights[];
extern const struct scene scenes_of_materials[];
extern const struct scene scenes_of_arrays[];
extern const struct scene scenes_of_lists[];
extern const struct scene scenes_of_textures[];

/* ---- what several of them use (common.c) ---- */

/* One unit is one pixel, the origin the lower left corner; z from -1 to 1. */
void scene_pixels(void);

/* A frustum with the eye at the origin of a world that begins 4 in front of it, with depth test. */
void scene_perspective(void);

/* A lit sphere of radius 1.2 with so many slices; normals are unit vectors times normal_length. */
void scene_sphere(int slices, float normal_length);

/* Lighting with light 0, white, at this position, and a material with a highlight. */
void scene_light(float x, float y, float z, float w);

/* A color and position that differ from vertex to vertex, in pixels: number i of a ring about (x, y). */
void scene_ring_vertex(int i, int count, float x, float y, float radius);

#endif
