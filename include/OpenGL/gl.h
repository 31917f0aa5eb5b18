/* OpenGL/gl.h - for programs written on macOS: the same as <GL/gl.h>. MIT License, see LICENSE. */
#include <GL/gl.h>
