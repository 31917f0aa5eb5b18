/* GL/freeglut_std.h - the name that some programs of freeglut include for GL/glut.h. */
#include <GL/glut.h>
