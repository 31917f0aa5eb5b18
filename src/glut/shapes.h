/* Geometry shared by the GLUT shapes: one mesh at a time, in scratch memory that is kept between calls, so
 * that drawing the same shapes again allocates nothing. Positions and normals are in object space. */
#ifndef FGL_GLUT_SHAPES_H
#define FGL_GLUT_SHAPES_H

#include <stdbool.h>
#include <stdint.h>
#include <GL/gl.h>

struct shape_mesh {
    float (*position)[3];
    float (*normal)[3]; /* unit length */
    GLuint *index;      /* strips or loops one after the other; each function says how many and how long */
    float (*circle)[2]; /* cosine and sine table of the rings */
};

/* Makes room for a mesh. False, with a message, when the size overflows or memory is short. */
bool fgl_shape_reserve(struct shape_mesh *mesh, uint64_t vertices, uint64_t indices, int circle_points);

/* Points the vertex and normal arrays at the mesh and enables them; end disables them again. As in freeglut
 * the array pointers and the two enables are left changed for the caller. */
void fgl_shape_begin(const float (*position)[3], const float (*normal)[3]);
void fgl_shape_end(void);

/* Draws `count` primitives of `length` indices each, one glDrawElements per primitive. */
void fgl_shape_draw_elements(GLenum mode, const GLuint *index, int count, int length);

#endif
