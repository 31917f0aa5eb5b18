/* GLUT/glut.h - for programs written on macOS: the same as <GL/glut.h>. MIT License, see LICENSE. */
#include <GL/glut.h>
