/* Conversions between the types of parameters and queries and the types of the state
 * (GL 1.5, 2.14 table 2.9 "Component conversions" and 6.1.2 "Data Conversions"). */
#ifndef FGL_API_CONVERT_H
#define FGL_API_CONVERT_H

#include "state/context.h"

#include <limits.h>
#include <math.h>

/* An integer colour component, (2c + 1) / (2^32 - 1). Float products, as OSMesa's: the last bit is theirs. */
static inline float fgl_float_from_int_color(GLint c)
{
    return (2.0f * (float)c + 1.0f) * (1.0f / 4294967294.0f);
}

/* Colours and normals of vertex commands: signed c to (2c + 1) / (2^b - 1), unsigned c to c / (2^b - 1). */
static inline float fgl_norm_b(GLbyte c) { return (2.0f * (float)c + 1.0f) * (1.0f / 255.0f); }
static inline float fgl_norm_s(GLshort c) { return (2.0f * (float)c + 1.0f) * (1.0f / 65535.0f); }
static inline float fgl_norm_i(GLint c) { return fgl_float_from_int_color(c); }
static inline float fgl_norm_ub(GLubyte c) { return (float)c / 255.0f; }
static inline float fgl_norm_us(GLushort c) { return (float)c * (1.0f / 65535.0f); }
static inline float fgl_norm_ui(GLuint c) { return (float)((double)c * (1.0 / 4294967295.0)); }

static inline GLint fgl_int_saturate(double v)
{
    if (!(v > INT_MIN))
        return INT_MIN; /* and NaN */
    return v < INT_MAX ? (GLint)v : INT_MAX;
}

/* To the nearest integer, halves away from zero. */
static inline GLint fgl_int_round(double v)
{
    return fgl_int_saturate(v < 0 ? ceil(v - 0.5) : floor(v + 0.5));
}

/* A colour, normal or depth value: 1 is the largest integer, -1 the smallest; ((2^32 - 1) f - 1) / 2 rounded.
 */
static inline GLint fgl_int_from_normalized(double f)
{
    return fgl_int_saturate(floor(2147483647.5 * f));
}

/* An enumerant that came as a float; 0 for what cannot be one. */
static inline GLenum fgl_enum_from_float(float v)
{
    return v >= 0.0f && v < 65536.0f ? (GLenum)v : 0;
}

#endif
