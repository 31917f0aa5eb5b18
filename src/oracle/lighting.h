/*
 * The oracle: colors of lit vertices as the specification defines them (GL 1.5, 2.11 "Coordinate
 * Transformations", 2.14 "Colors and Coloring"), from the floats that a program gives, in 113 bits.
 * It shares nothing with src/.
 */
#ifndef ORACLE_LIGHTING_H
#define ORACLE_LIGHTING_H

#include <stdbool.h>

#include <GL/gl.h>

#include "oracle/quad.h"

enum { ORACLE_LIGHTS = 8 };

/* Components in the order of the GL; position and spot_direction as given to glLight, in object coordinates.
 */
struct oracle_light {
    float ambient[4], diffuse[4], specular[4];
    float position[4];
    float spot_direction[3], spot_exponent, spot_cutoff; /* degrees; 180: no spot */
    float attenuation[3];                                /* constant, linear, quadratic */
};

struct oracle_material {
    float ambient[4], diffuse[4], specular[4], emission[4];
    float shininess;
};

/* What the color of a vertex depends on, but for the vertex. Matrices in the order of glLoadMatrix. */
struct oracle_state {
    float modelview[16];
    float light_modelview[16]; /* modelview matrix at the time of glLight */
    bool normalize, rescale_normal;
    bool local_viewer, two_sided, separate_specular;
    float scene_ambient[4];
    struct oracle_material front, back;
    GLenum color_material_face; /* 0: GL_COLOR_MATERIAL is disabled */
    GLenum color_material_mode;
    int lights; /* the first so many are enabled */
    struct oracle_light light[ORACLE_LIGHTS];
};

struct oracle_vertex {
    float position[4], normal[3];
    float color[4];   /* the current color, for color material */
    bool back_facing; /* its primitive is */
};

struct oracle_color {
    bool drawn;        /* false: clipped (w = 0), or a position that is not finite */
    quad component[4]; /* the sum of primary and secondary color, in [0,1] */
    quad to_cone_edge; /* least |cosine of a spot - cosine of its cutoff| */
    quad to_horizon;   /* least |n.VP| of a light with specular color, where f_i jumps */
};

struct oracle_color oracle_shade(const struct oracle_state *state, const struct oracle_vertex *vertex);

#endif
