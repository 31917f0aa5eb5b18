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

/* The arithmetic a context draws with: the specification's result, in double, rounded once at the pixel; the operations
 * of Mesa's OSMesa in its order, so that pictures are equal byte by byte. */
#define FIXEDGL_EXACT 1
#define FIXEDGL_COMPATIBLE 2

/* Sets the arithmetic of the current context and returns the one that was set before; 0 if there is an error or no
 * current context. A context begins with FIXEDGL_COMPATIBLE, or what the environment variable FIXEDGL_ACCURACY says:
 * exact or compatible; anything else is FIXEDGL_COMPATIBLE and a line on stderr. GL_INVALID_ENUM: mode is neither
 * FIXEDGL_EXACT nor FIXEDGL_COMPATIBLE. GL_INVALID_OPERATION: between glBegin and glEnd. */
GLAPI GLenum GLAPIENTRY fixedglAccuracy(GLenum mode);

/* The same as a hint: glHint(GL_LIGHTING_ACCURACY_HINT_FIXEDGL, mode), GL_NICEST: FIXEDGL_EXACT; GL_DONT_CARE:
 * FIXEDGL_COMPATIBLE; GL_FASTEST: FIXEDGL_COMPATIBLE, there is nothing faster. glGetIntegerv of it returns the
 * hint of the arithmetic that is set. glPopAttrib does not bring it back. */
#define GL_LIGHTING_ACCURACY_HINT_FIXEDGL 0x1F5A1

/* Why a pixel has its colour (docs/explain.md).
 *
 * fixedglExplainPixel arms the pixel x, y, in window coordinates as glReadPixels has them, in the current context: from now on each
 * draw notes what it does there; what was armed before is forgotten. Drawing becomes slower, its bytes stay the same. A negative
 * x ends it. The pixel may lie outside of the framebuffer as long as nobody asks.
 * GL_INVALID_VALUE: y is negative and x is not. GL_INVALID_OPERATION: between glBegin and glEnd.
 * GL_OUT_OF_MEMORY. */
GLAPI void GLAPIENTRY fixedglExplainPixel(GLint x, GLint y);

/* The forms of an explanation. */
#define FIXEDGL_TEXT 1 /* to read */
#define FIXEDGL_JSON 2 /* to be read by a program; its members are listed in docs/explain.md */

/* Explains the armed pixel as it is now: which primitives touched it since it was cleared; of the one that wrote its colour last, each
 * vertex with its weight and every term of the lighting equation; and the fragment's way to the framebuffer. vertex: 0, 1 or 2 for that
 * vertex of the primitive alone, -1 for all. The string is the context's, valid until the next call. NULL if there is
 * an error or no current context. GL_INVALID_ENUM: form is none. GL_INVALID_VALUE: vertex is not -1..2. GL_INVALID_OPERATION: between
 * glBegin and glEnd; no pixel is armed; it lies outside of the framebuffer. GL_OUT_OF_MEMORY. */
GLAPI const char *GLAPIENTRY fixedglExplain(GLenum form, GLint vertex);

#ifdef __cplusplus
}
#endif

#endif
