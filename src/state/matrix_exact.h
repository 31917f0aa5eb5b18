/* Matrices in double, beside the floats of matrix.h: the same commands, rounded once for each operation and never
 * to float (GL 1.5, 2.11.2 "Matrices"). What FIXEDGL_EXACT draws with. Layer 1. */
#ifndef FGL_STATE_MATRIX_EXACT_H
#define FGL_STATE_MATRIX_EXACT_H

#include "base/fgl.h"

/* Column major: m[4 * column + row]. m may not alias. */
void fgl_exact_load(double m[16], const float v[16]);
void fgl_exact_product(double r[16], const double a[16], const double b[16]);
void fgl_exact_multiply(double m[16], const float v[16]); /* m = m * v */
void fgl_exact_rotate(double m[16], double degrees, double x, double y, double z);
void fgl_exact_translate(double m[16], double x, double y, double z);
void fgl_exact_scale(double m[16], double x, double y, double z);
void fgl_exact_frustum(double m[16], double l, double r, double b, double t, double n, double f);
void fgl_exact_ortho(double m[16], double l, double r, double b, double t, double n, double f);

/* r[row] = row of m . v, of `count` components. */
void fgl_exact_transform(double r[4], const double m[16], const float v[4], int count);

/* The plane p of object space in eye space, p * inverse(m); 0 where m is singular. */
void fgl_exact_transform_plane(double r[4], const double m[16], const double p[4]);

/* The inverse of the upper 3x3, whatever the matrix's class: inv[row][column]. Returns false when there is none:
 * then inv is the cofactors' matrix, transposed as the inverse is: its limit up to scale. */
bool fgl_exact_inverse3(double inv[3][3], const double m[16]);

#endif
