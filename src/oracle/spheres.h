/* What an extreme does to the look of things: a lit sphere. */
#ifndef ORACLE_SPHERES_H
#define ORACLE_SPHERES_H

#include <stdbool.h>

#include "oracle/scene.h"

enum { ORACLE_SPHERE_SIZE = 120 }; /* of its picture, pixels */

struct oracle_sphere {
    const char *name;
    void (*change)(struct oracle_scene *scene, double parameter);
    double parameter;
};

extern const struct oracle_sphere oracle_spheres[];
extern const int oracle_sphere_count;

/* Writes the picture as PAM: each pixel is a vertex lit by the renderer. Colors that are no numbers are shown
 * in magenta. False if the file cannot be written. */
bool oracle_sphere_write(const struct oracle_sphere *sphere, oracle_renderer *render, const char *path);

#endif
