/* Matrices with the class flags that OSMesa keeps beside them, and matrix stacks (GL 1.5, 2.11.2 "Matrices"). Layer 1.
 *
 * The flags matter to pixels: they choose the formula of the inverse (OSMesa's inverses differ in the last bits by class),
 * whether lighting is done in object space, and whether normals are rescaled. They are sticky: glLoadIdentity resets the
 * matrix but not the flags; glPushMatrix copies them; glLoadMatrix and glMultMatrix ask for a new classification from the
 * values, done at the next use. */
#ifndef FGL_STATE_MATRIX_H
#define FGL_STATE_MATRIX_H

#include "base/fgl.h"
#include "base/limits.h"

enum {
    MAT_ROTATION = 1 << 0,
    MAT_TRANSLATION = 1 << 1,
    MAT_UNIFORM_SCALE = 1 << 2,
    MAT_GENERAL_SCALE = 1 << 3,
    MAT_PERSPECTIVE = 1 << 4,
    MAT_GENERAL = 1 << 5,
    MAT_GENERAL_3D = 1 << 6, /* affine with shear */
    MAT_SINGULAR = 1 << 7,
    MAT_CLASSIFY = 1 << 8,   /* flags must be found anew from the values */
    MAT_INVERSE_STALE = 1 << 9
};

struct matrix {
    float m[16];   /* column major: m[4 * column + row] */
    float inv[16]; /* valid when !(flags & MAT_INVERSE_STALE); see fgl_matrix_inverse */
    double exact[16]; /* the same matrix in double (matrix_exact.h); follows m, never read for compatible bits */
    unsigned flags;
};

struct matrix_stack {
    struct matrix entry[FGL_MAX_MODELVIEW_DEPTH];
    int top;   /* index of the current matrix; depth as GL counts it is top + 1 */
    int limit; /* entries that may be used */
    unsigned dirty; /* DIRTY_* bit of this stack */
    bool changed;   /* since the last push: popping an unchanged matrix changes nothing */
};

static inline struct matrix *fgl_matrix_top(struct matrix_stack *stack) { return &stack->entry[stack->top]; }

/* Whether its values are those of the identity. */
bool fgl_matrix_is_identity(const struct matrix *m);
void fgl_matrix_set_identity(struct matrix *m); /* a new context's matrix: flags cleared too */
void fgl_matrix_load_identity(struct matrix *m);
void fgl_matrix_load(struct matrix *m, const float v[16]);
/* Whether the two matrices have the same values in double too. */
bool fgl_matrix_exactly_equal(const struct matrix *a, const struct matrix *b);
void fgl_matrix_multiply(struct matrix *m, const float v[16]); /* m = m * v, glMultMatrix */
void fgl_matrix_rotate(struct matrix *m, float angle_deg, float x, float y, float z);
void fgl_matrix_translate(struct matrix *m, float x, float y, float z);
void fgl_matrix_scale(struct matrix *m, float x, float y, float z);
void fgl_matrix_frustum(struct matrix *m, double l, double r, double b, double t, double n, double f);
void fgl_matrix_ortho(struct matrix *m, double l, double r, double b, double t, double n, double f);

/* The inverse, by the formula of the matrix's class; computed when stale. */
const float *fgl_matrix_inverse(struct matrix *m);
/* The flags without bookkeeping bits, classified anew if asked for. */
unsigned fgl_matrix_class(struct matrix *m);
/* r = a * b, floats, left to right, not fused. r may not alias. */
void fgl_matrix_product(float r[16], const float a[16], const float b[16]);

#endif
