/* Ordinary scenes, from which the generators of categories.c start. */
#ifndef ORACLE_ORDINARY_H
#define ORACLE_ORDINARY_H

#include "oracle/random.h"
#include "oracle/scene.h"

/* A rigid modelview matrix, so many lights (directional or positional), one material, vertices within 2 of
 * the origin of object space with unit normals. Half of the normals are near a half vector, to have
 * highlights. Sums of colors seldom reach 1. */
void oracle_ordinary(struct random *random, struct oracle_scene *scene, int lights);

/* The same with identity matrices: eye coordinates are object coordinates. */
void oracle_ordinary_in_eye_space(struct random *random, struct oracle_scene *scene, int lights);

void oracle_identity(float matrix[16]);
void oracle_rigid(struct random *random, float matrix[16]);

void oracle_point_light(struct random *random, struct oracle_light *light);       /* 3 to 6 from the origin */
void oracle_directional_light(struct random *random, struct oracle_light *light); /* of length 1 */

/* Attenuation that leaves between a third and all of the light at the distances above. */
void oracle_attenuate(struct random *random, struct oracle_light *light);

/* A spot of this cutoff and exponent whose cone is about a vertex. */
void oracle_aim_spot(struct oracle_scene *scene, struct oracle_light *light, int vertex, float cutoff,
                     float exponent);

/* Turns half of the normals to half vectors of the lights, roughly. Matrices must be rigid. */
void oracle_aim_normals(struct random *random, struct oracle_scene *scene);

#endif
