/*
 * fixedgl.h - what FixedGL adds to OpenGL and OSMesa.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 */
#ifndef FIXEDGL_H
#define FIXEDGL_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this header. */
#define FIXEDGL_VERSION_MAJOR 0
#define FIXEDGL_VERSION_MINOR 1
#define FIXEDGL_VERSION_PATCH 0
#define FIXEDGL_VERSION "0.1.0"

/* Returns the version of the library as a static string, "MAJOR.MINOR.PATCH". No context need be current. */
GLAPI const char *GLAPIENTRY fixedglVersion(void);

/* The arithmetic a context draws with: the specification's result to the last bit of a float; the operations
 * of Mesa's OSMesa in its order, so that pictures are equal byte by byte; the quickest. */
#define FIXEDGL_EXACT 1
#define FIXEDGL_COMPATIBLE 2
#define FIXEDGL_FAST 3

/* Sets the arithmetic of the current context, initially FIXEDGL_COMPATIBLE, and returns the one that was set
 * before; 0 if there is an error or no current context. GL_INVALID_ENUM: mode is not FIXEDGL_COMPATIBLE (the
 * others are not implemented yet). GL_INVALID_OPERATION: between glBegin and glEnd. */
GLAPI GLenum GLAPIENTRY fixedglAccuracy(GLenum mode);

#ifdef __cplusplus
}
#endif

#endif
