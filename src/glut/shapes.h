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

void fgl_shape_set(float out[3], float x, float y, float z);

/* Cosines and sines of n points around a circle, clockwise from (1, 0), with freeglut's roundings. */
void fgl_shape_circle(float (*circle)[2], int n);

/* Indices of a triangle strip between two rings of n vertices, or between a ring and a pole; closed by
 * repeating the start. The end of what was written. */
GLuint *fgl_shape_ring_strip(GLuint *out, GLuint first, GLuint second, int n);
GLuint *fgl_shape_cap_strip(GLuint *out, GLuint ring, GLuint pole, int n, bool pole_first);

/* Draws `count` primitives of `length` indices each, one glDrawElements per primitive. */
void fgl_shape_draw_elements(GLenum mode, const GLuint *index, int count, int length);

#endif
