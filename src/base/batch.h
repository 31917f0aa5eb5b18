/* The vertex batch: what flows from the API's arrays through the vertex stage to primitive assembly. Layer 0.
 *
 * A batch holds at most FGL_BATCH_SIZE vertices as a structure of arrays, one array for each component, so that a
 * stage is one loop over vertices that the compiler can vectorise. Every array has FGL_BATCH_PAD spare elements behind its
 * last vertex, which a kernel may read and write but nobody may rely on.
 *
 * Filled by pipeline/draw.c: `in` (object space, as the program gave it; only attributes in `varying` are arrays, every
 * other attribute is the context's current value and is a constant of the plan).
 * Filled by the vertex stage: everything below "out". */
#ifndef FGL_BASE_BATCH_H
#define FGL_BASE_BATCH_H

#include "base/fgl.h"
#include "base/limits.h"

enum { FGL_BATCH_SIZE = 1024, FGL_BATCH_PAD = 16, FGL_BATCH_CAPACITY = FGL_BATCH_SIZE + FGL_BATCH_PAD };

/* The attributes of a vertex (GL 1.5, 2.7 "Vertex Specification", 2.8 "Vertex Arrays"); material parameters may change
 * between Begin and End (2.14.2) and are then attributes too. */
enum fgl_attr {
    ATTR_POSITION,
    ATTR_NORMAL,
    ATTR_COLOR,
    ATTR_SECONDARY_COLOR,
    ATTR_FOG_COORD,
    ATTR_INDEX,
    ATTR_EDGE_FLAG,
    ATTR_TEX0,
    ATTR_MATERIAL = ATTR_TEX0 + FGL_MAX_TEXTURE_UNITS, /* + enum fgl_material * 2 + (0 front, 1 back) */
    ATTR_COUNT = ATTR_MATERIAL + 12
};

enum fgl_material { MAT_AMBIENT, MAT_DIFFUSE, MAT_SPECULAR, MAT_EMISSION, MAT_SHININESS, MAT_INDEXES, MAT_COUNT };

static inline int fgl_material_attr(enum fgl_material m, int back) { return ATTR_MATERIAL + (int)m * 2 + back; }

/* Up to four components, an array each. */
struct lanes4 {
    float c[4][FGL_BATCH_CAPACITY];
};

/* What the vertex stage of FIXEDGL_EXACT hands over in place of the floats of the same names. */
struct lanes4_exact {
    double c[4][FGL_BATCH_CAPACITY];
};
struct exact_batch {
    struct lanes4_exact clip, win, color[2], secondary[2];
    struct lanes4_exact lit_normal, lit_eye;
    struct lanes4_exact eye; /* x y z w, not divided; where there are user clip planes */
    struct lanes4_exact texture[FGL_MAX_TEXTURE_UNITS];
    double fog_z[FGL_BATCH_CAPACITY];
};

struct vertex_batch {
    int n; /* vertices, 0..FGL_BATCH_SIZE */

    uint32_t varying;         /* bit a: attribute a differs by vertex and is in in[a] */
    struct lanes4 in[ATTR_COUNT]; /* position: w is 1 and z is 0 where the program gave fewer components */

    /* out: written only where the plan says so */
    struct lanes4 clip;       /* clip space x y z w */
    struct lanes4 win;        /* window space x, y (along the framebuffer's rows), z in [0,1]; c[3] = 1/w_clip */
    struct lanes4 color[2];   /* lit or given colour, clamped to [0,1]; [1]: the back face's, when two-sided */
    struct lanes4 secondary[2]; /* separate specular colour, clamped */
    struct lanes4 texture[FGL_MAX_TEXTURE_UNITS]; /* coordinates that are computed, as struct vertex_plan lists them */
    struct lanes4 lit_normal, lit_eye; /* for lighting per fragment: normal, and eye space position divided by w; c[3] = 0 */
    float fog_z[FGL_BATCH_CAPACITY]; /* |z_eye|, for fog */
    float point_size[FGL_BATCH_CAPACITY];
    uint32_t outcode[FGL_BATCH_CAPACITY]; /* CLIP_* bits: the planes that the vertex lies outside of */
    struct exact_batch exact;
    uint32_t extreme[FGL_BATCH_CAPACITY]; /* lit in float: not 0 where float is not safe (vertex/work.h) */
    uint32_t outcode_any;     /* OR over the batch */
    uint32_t outcode_all;     /* AND over the batch */
};

/* Outcode bits, in the order in which planes are clipped against (GL 1.5, 2.12 "Clipping"). */
enum {
    CLIP_RIGHT = 1 << 0, /* x > w */
    CLIP_LEFT = 1 << 1,  /* x + w < 0 */
    CLIP_TOP = 1 << 2,   /* y > w */
    CLIP_BOTTOM = 1 << 3, /* y + w < 0 */
    CLIP_NEAR = 1 << 4,  /* z + w < 0 */
    CLIP_FAR = 1 << 5,   /* z > w */
    CLIP_USER0 = 1 << 6  /* user plane i: bit 6 + i */
};

#endif
