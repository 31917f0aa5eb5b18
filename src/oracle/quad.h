/*
 * Arithmetic of 113 significant bits for the oracle: what it computes is the truth that renderers are
 * measured against, so it takes nothing from the library, and from a math library only frexp, ldexp and the
 * square root that a Newton iteration starts from.
 */
#ifndef ORACLE_QUAD_H
#define ORACLE_QUAD_H

#include <float.h>

#if LDBL_MANT_DIG == 113
typedef long double quad;
#else
__extension__ typedef __float128 quad;
#endif

/* Relative error of each result below: under 2^-105; tests/oracle/quad.c holds them to it. */

/* x >= 0. NaN and infinity come back as they are. */
quad quad_sqrt(quad x);

/* x > 0 and finite. */
quad quad_log2(quad x);

/* 0 below 2^-16000, infinity above 2^16000. */
quad quad_exp2(quad x);

/* x >= 0 to the power y >= 0; 1 for y = 0, whatever x is; NaN and infinity otherwise remain. */
quad quad_pow(quad x, quad y);

/* Cosine of an angle in degrees, [0, 180]. */
quad quad_cos_degrees(quad angle);

#endif
