/* FixedGL: what FixedGL adds to OpenGL. Copyright (c) 2026 The FixedGL authors. MIT License. */
#ifndef FIXEDGL_H
#define FIXEDGL_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FIXEDGL_VERSION_MAJOR 0
#define FIXEDGL_VERSION_MINOR 1
#define FIXEDGL_VERSION_PATCH 0
#define FIXEDGL_VERSION "0.1.0"

#define FIXEDGL_EXACT 1
#define FIXEDGL_COMPATIBLE 2
#define FIXEDGL_FAST 3

GLAPI const char *GLAPIENTRY fixedglVersion(void);
GLAPI GLenum GLAPIENTRY fixedglAccuracy(GLenum mode);

#ifdef __cplusplus
}
#endif

#endif
