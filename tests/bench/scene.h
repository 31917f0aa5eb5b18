/* The scenes that are timed. One is a set-up, done once in a context of its own, and a frame: clear, draw, glFinish; `draw` is what
 * comes between. */
#ifndef BENCH_SCENE_H
#define BENCH_SCENE_H

#include <stdbool.h>

#include "functions.h"

/* What a worker keeps of a scene between rounds. */
struct instance {
    OSMesaContext context;
    void *pixels;         /* the window's */
    void *image;          /* pixel scenes: as large as the window, 16 bytes a pixel */
    float (*position)[3]; /* of the sphere also its normals, since it is a unit sphere */
    float (*color)[3];
    GLuint *index; /* sphere: per stack one strip of 2 (slices + 1) */
};

struct scene {
    const char *name;
    int size;   /* of the square window */
    int frames; /* in a round */
    void (*open)(const struct scene *scene, struct instance *instance);
    void (*draw)(const struct scene *scene, const struct instance *instance);
    const void *detail; /* what the scene's file makes of it */
    bool exact;         /* FixedGL in exact mode */
};

/* The whole list, in the order of the report. */
const struct scene *scene_at(int index);
int scene_count(void);

/* The files' lists, each ended by a scene without name. */
extern const struct scene sphere_scenes[], primitive_scenes[], fragment_scenes[], texture_scenes[],
        pixel_scenes[], command_scenes[];

/* A message on stderr, and the end. detail may be NULL. */
void fail(const char *what, const char *detail);
/* Zeroed; never NULL. */
void *allocate(size_t count, size_t size);
/* In [0,1); the same sequence in every process that starts with the same seed. */
float random_float(unsigned *seed);

#endif
