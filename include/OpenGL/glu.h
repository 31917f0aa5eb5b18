/* OpenGL/glu.h - for programs written on macOS: the same as <GL/glu.h>. MIT License, see LICENSE. */
#include <GL/glu.h>
