/* The maps of evaluators (GL 1.5, 5.1 "Evaluators"). */
#ifndef FGL_API_EVAL_MAP_H
#define FGL_API_EVAL_MAP_H

#include "state/context.h"
#include "vertex/bezier.h"

/* What a map gives, in the order of GL_MAP1_COLOR_4... and of GL_MAP2_COLOR_4... */
enum {
    MAP_COLOR_4,
    MAP_INDEX,
    MAP_NORMAL,
    MAP_TEXTURE_COORD_1,
    MAP_TEXTURE_COORD_2,
    MAP_TEXTURE_COORD_3,
    MAP_TEXTURE_COORD_4,
    MAP_VERTEX_3,
    MAP_VERTEX_4,
    MAP_COUNT
};

struct eval_map {
    struct bezier_net net; /* net.points: initial values, or allocated */
    float *points;         /* the same when allocated, else NULL */
    float domain[4];       /* u1 u2 v1 v2 */
    float scale[2];        /* 1 / (u2 - u1), 1 / (v2 - v1) */
};

struct eval_maps {
    struct eval_map map[2][MAP_COUNT]; /* [one dimension, two] */
};

/* Floats of a map's value, and the vertex attribute that it becomes. */
int fgl_map_size(int map);
enum fgl_attr fgl_map_attr(int map);

/* The context's maps, made at the first call; NULL after GL_OUT_OF_MEMORY. */
struct eval_maps *fgl_eval_maps(struct context *ctx);
void fgl_eval_maps_destroy(struct context *ctx);

/* glMap from a display list. */
void fgl_map_replay(struct context *ctx, void *payload);

#endif
