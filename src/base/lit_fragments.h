/* A group of fragments that is lit as vertices are (GL_WIN_phong_shading): what passes between the fragment stage, which
 * interpolates, and the vertex stage, which has the lighting equation. Neither knows of the other. Layer 0.
 * In double, which holds the numbers of every arithmetic as they are. */
#ifndef FGL_BASE_LIT_FRAGMENTS_H
#define FGL_BASE_LIT_FRAGMENTS_H

#include <stdbool.h>

enum {
    LIT_GROUP = 16,
    LIT_ATTRIBUTES = 10 /* that may differ by fragment: a front and a back material, less the colour indexes */
};

struct lit_fragments {
    bool back; /* of a back face */
    double normal[3][LIT_GROUP]; /* interpolated, of any length */
    double eye[3][LIT_GROUP];    /* divided by w; only where it is read */
    double attribute[LIT_ATTRIBUTES][4][LIT_GROUP];
    /* out: clamped to [0,1] */
    double color[4][LIT_GROUP];
    double secondary[3][LIT_GROUP]; /* with GL_SEPARATE_SPECULAR_COLOR; else not written */
};

/* Lights a group. lights: the vertex stage's. */
typedef void light_fragments_fn(const void *lights, struct lit_fragments *f);

#endif
