/* GL/freeglut_ext.h - the name that some programs of freeglut include for GL/freeglut.h. */
#include <GL/freeglut.h>
