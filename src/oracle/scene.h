/* Scenes for the oracle: one lighting state and the vertices lit by it, and how they are drawn. */
#ifndef ORACLE_SCENE_H
#define ORACLE_SCENE_H

#include "oracle/lighting.h"

enum { ORACLE_VERTICES = 64 };

struct oracle_scene {
    struct oracle_state state;
    bool triangles; /* each vertex is the last of a flat triangle, else a point; needs a modelview matrix with
                       a tame inverse and w = 1 */
    bool alone;     /* each vertex in a draw call of its own, for those that draw nothing */
    int count;
    struct oracle_vertex vertex[ORACLE_VERTICES];
};

/* Makes a context with a buffer of floats current, in which every color comes back as it was computed: false
 * if that fails. */
bool oracle_open(void);
void oracle_close(void);

/* Sets the lighting state of the scene, and the vertices as arrays. */
void oracle_set_state(const struct oracle_state *state);
void oracle_set_arrays(const struct oracle_vertex *vertices, bool colors);

/* Draws the scene with the functions of GL/gl.h, of whichever library the program runs on. rgba[i] is the
 * color of vertex i; 0, 0, 0, 0 if it drew nothing. */
void oracle_draw(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4]);

/* Nanoseconds per vertex, the quickest of some draws of some thousand: by the GL, as a strip of lines
 * that have no length; or by a function that takes oracle_draw's place. */
typedef void oracle_renderer(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4]);
double oracle_time_strip(const struct oracle_scene *scene);
double oracle_time_renderer(const struct oracle_scene *scene, oracle_renderer *render);

#endif
