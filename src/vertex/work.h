/* The work space of the vertex kernels: what passes between stages of one chunk of vertices, in the scalar
 * type of the arithmetic (base/arith.h). Kernels only. */
#ifndef FGL_VERTEX_WORK_H
#define FGL_VERTEX_WORK_H

#include "base/batch_results.h"
#include "vertex/vertex.h"

/* Kernels work on whole groups of this many vertices; what they compute behind the last one is never read. */
enum { VERTEX_GROUP = 16 };

/* n, which is whole groups already, told to the compiler: it needs no code for what is left over. */
static FGL_ALWAYS_INLINE int whole_groups(int n)
{
    return n & ~(VERTEX_GROUP - 1);
}

/* The numbers of the plan in the arithmetic's type. */
#if R_EXACT
typedef struct exact_light light_numbers;
#define PLAN_NUMBERS(plan) (&(plan)->exact)
#define PLAN_LIGHTS(plan) ((plan)->exact.light)
#define PLAN_BASE(plan, face) ((plan)->exact.base[face])
#else
typedef struct light_derived light_numbers;
#define PLAN_NUMBERS(plan) (plan)
#define PLAN_LIGHTS(plan) ((plan)->light.light)
#define PLAN_BASE(plan, face) ((plan)->light.base[face])
#endif

struct vertex_work {
    real eye[3][VERTEX_CHUNK];      /* eye space position; divided by w if R_EXACT */
    real view[3][VERTEX_CHUNK];     /* unit vector from the eye to the vertex; local viewer only */
    real normal[3][VERTEX_CHUNK];   /* in the lighting space */
    real color[3][VERTEX_CHUNK];    /* sums of the lighting equation, not clamped */
    real specular[3][VERTEX_CHUNK]; /* the specular sums, when separate */
    real material[COLOR_COUNT][3]
                 [VERTEX_CHUNK]; /* of the face being lit, when the material differs by vertex */
    real shininess[VERTEX_CHUNK];
    real texture[4][VERTEX_CHUNK];  /* coordinates being generated and transformed */
    real in_cone[VERTEX_CHUNK];     /* 1: within the cone of the light being added, else 0. Only if R_EXACT */
    real least[VERTEX_CHUNK];       /* distances whose squares are below it are lost in the rounding of eye */
    uint32_t extreme[VERTEX_CHUNK]; /* not 0: the vertex left the range where float is safe. Not if R_EXACT */
};

/* The range of squares of lengths in which float neither overflows nor loses bits. */
#define SAFE_SQUARE_LEAST ((real)1e-30)
#define SAFE_SQUARE_GREATEST ((real)1e30)
/* Half vectors shorter than the root of this have lost their direction in float. */
#define SAFE_HALF_SQUARE ((real)1e-4)
/* Cosines this near to a cone's edge may be on either side of it in float. */
#define CONE_EDGE ((real)5e-7)

/* NaN is outside. */
static FGL_ALWAYS_INLINE uint32_t outside(real x, real least, real greatest)
{
    return (uint32_t)!(x >= least) | (uint32_t)!(x <= greatest);
}

/* Read through pointers without const: GCC 12 does not vectorise over arrays of arrays of const. */
static FGL_ALWAYS_INLINE struct real3 load3(real a[3][VERTEX_CHUNK], int i)
{
    return r_vec3(a[0][i], a[1][i], a[2][i]);
}

static FGL_ALWAYS_INLINE void store3(real a[3][VERTEX_CHUNK], int i, struct real3 v)
{
    a[0][i] = v.x;
    a[1][i] = v.y;
    a[2][i] = v.z;
}

static FGL_ALWAYS_INLINE struct real4 load_position(struct vertex_batch *b, int i)
{
    struct lanes4 *in = &b->in[ATTR_POSITION];
    return (struct real4){(real)in->c[0][i], (real)in->c[1][i], (real)in->c[2][i], (real)in->c[3][i]};
}

#endif
