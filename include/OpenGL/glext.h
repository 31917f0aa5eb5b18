/* OpenGL/glext.h - for programs written on macOS: the same as <GL/glext.h>. MIT License, see LICENSE. */
#include <GL/glext.h>
