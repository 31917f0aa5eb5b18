/*
 * GL/gl.h - OpenGL 1.5, the fixed-function pipeline.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 *
 * Types, every token of OpenGL 1.0 to 1.5 and of its imaging subset, and the functions of OpenGL 1.0 to 1.3,
 * the imaging subset and ARB_multitexture: what the usual <GL/gl.h> declares. GL/glext.h, included at the
 * end, has the functions of 1.4 and 1.5 and the extensions. Tokens and functions stand in the order of the
 * chapters of "The OpenGL Graphics System: A Specification (Version 1.5)"; the numbers in the headings are
 * its sections.
 *
 * Rules that hold everywhere and are not repeated below:
 *
 * - Suffixes name the argument type: b GLbyte, s GLshort, i GLint, f GLfloat, d GLdouble, ub us ui the
 *   unsigned ones; a final v means that the values are read from an array. A digit is the number of values.
 * - An integer given for a color or a normal component is mapped to [0,1] (unsigned: c / (2^b - 1)) or to
 *   [-1,1] (signed: (2c + 1) / (2^b - 1)), b being the bits of its type; for anything else its value is taken
 *   as it is.
 * - Errors (2.5): a token that is not one of those listed is GL_INVALID_ENUM. A negative GLsizei is
 *   GL_INVALID_VALUE. Memory exhausted is GL_OUT_OF_MEMORY. A command that raises an error is ignored and
 *   returns 0. Only further errors are named below.
 * - Between glBegin and glEnd only glVertex, glColor, glSecondaryColor, glFogCoord, glIndex, glNormal,
 *   glTexCoord, glMultiTexCoord, glEdgeFlag, glMaterial, glArrayElement, glEvalCoord, glEvalPoint, glCallList
 *   and glCallLists are allowed (2.6.3); any other command is GL_INVALID_OPERATION, but for those of vertex
 *   arrays and pixel storage, of which the specification leaves it open.
 * - Object coordinates are those given to glVertex; the modelview matrix takes them to eye coordinates, the
 *   projection matrix to clip coordinates, division by w to normalized device coordinates in [-1,1], and
 *   viewport and depth range to window coordinates, in pixels from the lower left corner, with depth in
 *   [0,1].
 * - Every command acts on the context that is current in the calling thread (see GL/osmesa.h); without one it
 *   does nothing.
 */
#ifndef __gl_h_
#define __gl_h_

/* clang-format off: tokens stand in columns */

#include <stddef.h>

/* GLAPI marks an exported function, GLAPIENTRY and APIENTRY its calling convention, the P forms a pointer to
 * one. */
#ifndef GLAPI
#if defined(__GNUC__) && __GNUC__ >= 4
#define GLAPI __attribute__((visibility("default")))
#else
#define GLAPI extern
#endif
#endif

#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#ifndef GLAPIENTRYP
#define GLAPIENTRYP GLAPIENTRY *
#endif
#ifndef APIENTRY
#define APIENTRY GLAPIENTRY
#endif
#ifndef APIENTRYP
#define APIENTRYP APIENTRY *
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define GL_VERSION_1_1 1
#define GL_VERSION_1_2 1
#define GL_VERSION_1_3 1
#define GL_ARB_imaging 1


/* ---- 2.3 Command syntax: the types (table 2.2) --------------------------------------------------------- */

typedef void GLvoid;
typedef unsigned char GLboolean;
typedef signed char GLbyte;     /* 8 bits, two's complement */
typedef unsigned char GLubyte;
typedef short GLshort;          /* 16 bits */
typedef unsigned short GLushort;
typedef int GLint;              /* 32 bits */
typedef unsigned int GLuint;
typedef int GLsizei;            /* a size or count, never negative */
typedef unsigned int GLenum;    /* one of the tokens below */
typedef unsigned int GLbitfield;
typedef float GLfloat;          /* IEEE single */
typedef float GLclampf;         /* clamped to [0,1] when it is stored */
typedef double GLdouble;
typedef double GLclampd;        /* clamped to [0,1] when it is stored */
typedef ptrdiff_t GLintptr;     /* a byte offset into a buffer object (1.5) */
typedef ptrdiff_t GLsizeiptr;   /* a size in bytes of a buffer object (1.5) */
typedef GLintptr GLintptrARB;
typedef GLsizeiptr GLsizeiptrARB;

#define GL_FALSE                                   0
#define GL_TRUE                                    1

/* Types of array elements and pixels. GL_2_BYTES to GL_4_BYTES: list names for glCallLists, most significant
 * first. */
#define GL_BYTE                                    0x1400
#define GL_UNSIGNED_BYTE                           0x1401
#define GL_SHORT                                   0x1402
#define GL_UNSIGNED_SHORT                          0x1403
#define GL_INT                                     0x1404
#define GL_UNSIGNED_INT                            0x1405
#define GL_FLOAT                                   0x1406
#define GL_2_BYTES                                 0x1407
#define GL_3_BYTES                                 0x1408
#define GL_4_BYTES                                 0x1409
#define GL_DOUBLE                                  0x140A

/* Tokens that several sections share: faces, comparisons, coordinates. */
#define GL_NONE                                    0
#define GL_FRONT                                   0x0404
#define GL_BACK                                    0x0405
#define GL_FRONT_AND_BACK                          0x0408
#define GL_NEVER                                   0x0200
#define GL_LESS                                    0x0201
#define GL_EQUAL                                   0x0202
#define GL_LEQUAL                                  0x0203
#define GL_GREATER                                 0x0204
#define GL_NOTEQUAL                                0x0205
#define GL_GEQUAL                                  0x0206
#define GL_ALWAYS                                  0x0207
#define GL_S                                       0x2000
#define GL_T                                       0x2001
#define GL_R                                       0x2002
#define GL_Q                                       0x2003


/* ---- 2.5 GL errors ------------------------------------------------------------------------------------- */

#define GL_NO_ERROR                                0
#define GL_INVALID_ENUM                            0x0500
#define GL_INVALID_VALUE                           0x0501
#define GL_INVALID_OPERATION                       0x0502
#define GL_STACK_OVERFLOW                          0x0503
#define GL_STACK_UNDERFLOW                         0x0504
#define GL_OUT_OF_MEMORY                           0x0505
#define GL_TABLE_TOO_LARGE                         0x8031

/* Returns the first error since the last call and clears it; GL_NO_ERROR if there was none. Between glBegin
 * and glEnd it returns 0 and raises GL_INVALID_OPERATION. */
GLAPI GLenum GLAPIENTRY glGetError(void);


/* ---- 2.6 Begin/End paradigm ---------------------------------------------------------------------------- */

#define GL_POINTS                                  0x0000
#define GL_LINES                                   0x0001
#define GL_LINE_LOOP                               0x0002
#define GL_LINE_STRIP                              0x0003
#define GL_TRIANGLES                               0x0004
#define GL_TRIANGLE_STRIP                          0x0005
#define GL_TRIANGLE_FAN                            0x0006
#define GL_QUADS                                   0x0007
#define GL_QUAD_STRIP                              0x0008
#define GL_POLYGON                                 0x0009

/* Starts a group of vertices that are assembled into primitives of the kind mode, one of the ten above. A
 * primitive left incomplete at glEnd is dropped. GL_INVALID_OPERATION between glBegin and glEnd. (2.6.1) */
GLAPI void GLAPIENTRY glBegin(GLenum mode);

/* Ends the group. GL_INVALID_OPERATION without a glBegin. (2.6.1) */
GLAPI void GLAPIENTRY glEnd(void);

#define GL_EDGE_FLAG                               0x0B43

/* Sets the edge flag of the vertices that follow: GL_FALSE marks the edge that starts at the vertex as
 * interior, so that GL_POINT and GL_LINE polygons leave it out. Read for separate triangles, quads and
 * polygons only. Initially GL_TRUE. (2.6.2 Polygon edges) */
GLAPI void GLAPIENTRY glEdgeFlag(GLboolean flag);
GLAPI void GLAPIENTRY glEdgeFlagv(const GLboolean *flag);


/* ---- 2.7 Vertex specification -------------------------------------------------------------------------- */

/* Gives one vertex in object coordinates and all current data (color, normal, texture coordinates, edge flag,
 * ...) with it. Missing z is 0, missing w is 1. Outside glBegin and glEnd it does nothing. */
GLAPI void GLAPIENTRY glVertex2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glVertex2dv(const GLdouble *v);
GLAPI void GLAPIENTRY glVertex2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glVertex2fv(const GLfloat *v);
GLAPI void GLAPIENTRY glVertex2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glVertex2iv(const GLint *v);
GLAPI void GLAPIENTRY glVertex2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glVertex2sv(const GLshort *v);
GLAPI void GLAPIENTRY glVertex3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glVertex3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glVertex3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glVertex3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glVertex3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glVertex3iv(const GLint *v);
GLAPI void GLAPIENTRY glVertex3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glVertex3sv(const GLshort *v);
GLAPI void GLAPIENTRY glVertex4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w);
GLAPI void GLAPIENTRY glVertex4dv(const GLdouble *v);
GLAPI void GLAPIENTRY glVertex4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w);
GLAPI void GLAPIENTRY glVertex4fv(const GLfloat *v);
GLAPI void GLAPIENTRY glVertex4i(GLint x, GLint y, GLint z, GLint w);
GLAPI void GLAPIENTRY glVertex4iv(const GLint *v);
GLAPI void GLAPIENTRY glVertex4s(GLshort x, GLshort y, GLshort z, GLshort w);
GLAPI void GLAPIENTRY glVertex4sv(const GLshort *v);

/* Set the current texture coordinates (s, t, r, q) of unit 0. Missing t and r are 0, missing q is 1. */
GLAPI void GLAPIENTRY glTexCoord1d(GLdouble s);
GLAPI void GLAPIENTRY glTexCoord1dv(const GLdouble *v);
GLAPI void GLAPIENTRY glTexCoord1f(GLfloat s);
GLAPI void GLAPIENTRY glTexCoord1fv(const GLfloat *v);
GLAPI void GLAPIENTRY glTexCoord1i(GLint s);
GLAPI void GLAPIENTRY glTexCoord1iv(const GLint *v);
GLAPI void GLAPIENTRY glTexCoord1s(GLshort s);
GLAPI void GLAPIENTRY glTexCoord1sv(const GLshort *v);
GLAPI void GLAPIENTRY glTexCoord2d(GLdouble s, GLdouble t);
GLAPI void GLAPIENTRY glTexCoord2dv(const GLdouble *v);
GLAPI void GLAPIENTRY glTexCoord2f(GLfloat s, GLfloat t);
GLAPI void GLAPIENTRY glTexCoord2fv(const GLfloat *v);
GLAPI void GLAPIENTRY glTexCoord2i(GLint s, GLint t);
GLAPI void GLAPIENTRY glTexCoord2iv(const GLint *v);
GLAPI void GLAPIENTRY glTexCoord2s(GLshort s, GLshort t);
GLAPI void GLAPIENTRY glTexCoord2sv(const GLshort *v);
GLAPI void GLAPIENTRY glTexCoord3d(GLdouble s, GLdouble t, GLdouble r);
GLAPI void GLAPIENTRY glTexCoord3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glTexCoord3f(GLfloat s, GLfloat t, GLfloat r);
GLAPI void GLAPIENTRY glTexCoord3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glTexCoord3i(GLint s, GLint t, GLint r);
GLAPI void GLAPIENTRY glTexCoord3iv(const GLint *v);
GLAPI void GLAPIENTRY glTexCoord3s(GLshort s, GLshort t, GLshort r);
GLAPI void GLAPIENTRY glTexCoord3sv(const GLshort *v);
GLAPI void GLAPIENTRY glTexCoord4d(GLdouble s, GLdouble t, GLdouble r, GLdouble q);
GLAPI void GLAPIENTRY glTexCoord4dv(const GLdouble *v);
GLAPI void GLAPIENTRY glTexCoord4f(GLfloat s, GLfloat t, GLfloat r, GLfloat q);
GLAPI void GLAPIENTRY glTexCoord4fv(const GLfloat *v);
GLAPI void GLAPIENTRY glTexCoord4i(GLint s, GLint t, GLint r, GLint q);
GLAPI void GLAPIENTRY glTexCoord4iv(const GLint *v);
GLAPI void GLAPIENTRY glTexCoord4s(GLshort s, GLshort t, GLshort r, GLshort q);
GLAPI void GLAPIENTRY glTexCoord4sv(const GLshort *v);

#define GL_TEXTURE0                                0x84C0
#define GL_TEXTURE1                                0x84C1
#define GL_TEXTURE2                                0x84C2
#define GL_TEXTURE3                                0x84C3
#define GL_TEXTURE4                                0x84C4
#define GL_TEXTURE5                                0x84C5
#define GL_TEXTURE6                                0x84C6
#define GL_TEXTURE7                                0x84C7
#define GL_TEXTURE8                                0x84C8
#define GL_TEXTURE9                                0x84C9
#define GL_TEXTURE10                               0x84CA
#define GL_TEXTURE11                               0x84CB
#define GL_TEXTURE12                               0x84CC
#define GL_TEXTURE13                               0x84CD
#define GL_TEXTURE14                               0x84CE
#define GL_TEXTURE15                               0x84CF
#define GL_TEXTURE16                               0x84D0
#define GL_TEXTURE17                               0x84D1
#define GL_TEXTURE18                               0x84D2
#define GL_TEXTURE19                               0x84D3
#define GL_TEXTURE20                               0x84D4
#define GL_TEXTURE21                               0x84D5
#define GL_TEXTURE22                               0x84D6
#define GL_TEXTURE23                               0x84D7
#define GL_TEXTURE24                               0x84D8
#define GL_TEXTURE25                               0x84D9
#define GL_TEXTURE26                               0x84DA
#define GL_TEXTURE27                               0x84DB
#define GL_TEXTURE28                               0x84DC
#define GL_TEXTURE29                               0x84DD
#define GL_TEXTURE30                               0x84DE
#define GL_TEXTURE31                               0x84DF

#define GL_TEXTURE0_ARB                            0x84C0
#define GL_TEXTURE1_ARB                            0x84C1
#define GL_TEXTURE2_ARB                            0x84C2
#define GL_TEXTURE3_ARB                            0x84C3
#define GL_TEXTURE4_ARB                            0x84C4
#define GL_TEXTURE5_ARB                            0x84C5
#define GL_TEXTURE6_ARB                            0x84C6
#define GL_TEXTURE7_ARB                            0x84C7
#define GL_TEXTURE8_ARB                            0x84C8
#define GL_TEXTURE9_ARB                            0x84C9
#define GL_TEXTURE10_ARB                           0x84CA
#define GL_TEXTURE11_ARB                           0x84CB
#define GL_TEXTURE12_ARB                           0x84CC
#define GL_TEXTURE13_ARB                           0x84CD
#define GL_TEXTURE14_ARB                           0x84CE
#define GL_TEXTURE15_ARB                           0x84CF
#define GL_TEXTURE16_ARB                           0x84D0
#define GL_TEXTURE17_ARB                           0x84D1
#define GL_TEXTURE18_ARB                           0x84D2
#define GL_TEXTURE19_ARB                           0x84D3
#define GL_TEXTURE20_ARB                           0x84D4
#define GL_TEXTURE21_ARB                           0x84D5
#define GL_TEXTURE22_ARB                           0x84D6
#define GL_TEXTURE23_ARB                           0x84D7
#define GL_TEXTURE24_ARB                           0x84D8
#define GL_TEXTURE25_ARB                           0x84D9
#define GL_TEXTURE26_ARB                           0x84DA
#define GL_TEXTURE27_ARB                           0x84DB
#define GL_TEXTURE28_ARB                           0x84DC
#define GL_TEXTURE29_ARB                           0x84DD
#define GL_TEXTURE30_ARB                           0x84DE
#define GL_TEXTURE31_ARB                           0x84DF
#define GL_ACTIVE_TEXTURE_ARB                      0x84E0
#define GL_CLIENT_ACTIVE_TEXTURE_ARB               0x84E1
#define GL_MAX_TEXTURE_UNITS_ARB                   0x84E2

/* As glTexCoord for the unit target, GL_TEXTURE0 + i with i < GL_MAX_TEXTURE_UNITS; another target is
 * undefined. Since 1.3; the ARB names are the same commands. */
GLAPI void GLAPIENTRY glMultiTexCoord1d(GLenum target, GLdouble s);
GLAPI void GLAPIENTRY glMultiTexCoord1dv(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord1f(GLenum target, GLfloat s);
GLAPI void GLAPIENTRY glMultiTexCoord1fv(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord1i(GLenum target, GLint s);
GLAPI void GLAPIENTRY glMultiTexCoord1iv(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord1s(GLenum target, GLshort s);
GLAPI void GLAPIENTRY glMultiTexCoord1sv(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord2d(GLenum target, GLdouble s, GLdouble t);
GLAPI void GLAPIENTRY glMultiTexCoord2dv(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord2f(GLenum target, GLfloat s, GLfloat t);
GLAPI void GLAPIENTRY glMultiTexCoord2fv(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord2i(GLenum target, GLint s, GLint t);
GLAPI void GLAPIENTRY glMultiTexCoord2iv(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord2s(GLenum target, GLshort s, GLshort t);
GLAPI void GLAPIENTRY glMultiTexCoord2sv(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord3d(GLenum target, GLdouble s, GLdouble t, GLdouble r);
GLAPI void GLAPIENTRY glMultiTexCoord3dv(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord3f(GLenum target, GLfloat s, GLfloat t, GLfloat r);
GLAPI void GLAPIENTRY glMultiTexCoord3fv(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord3i(GLenum target, GLint s, GLint t, GLint r);
GLAPI void GLAPIENTRY glMultiTexCoord3iv(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord3s(GLenum target, GLshort s, GLshort t, GLshort r);
GLAPI void GLAPIENTRY glMultiTexCoord3sv(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord4d(GLenum target, GLdouble s, GLdouble t, GLdouble r, GLdouble q);
GLAPI void GLAPIENTRY glMultiTexCoord4dv(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord4f(GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q);
GLAPI void GLAPIENTRY glMultiTexCoord4fv(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord4i(GLenum target, GLint s, GLint t, GLint r, GLint q);
GLAPI void GLAPIENTRY glMultiTexCoord4iv(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord4s(GLenum target, GLshort s, GLshort t, GLshort r, GLshort q);
GLAPI void GLAPIENTRY glMultiTexCoord4sv(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord1dARB(GLenum target, GLdouble s);
GLAPI void GLAPIENTRY glMultiTexCoord1dvARB(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord1fARB(GLenum target, GLfloat s);
GLAPI void GLAPIENTRY glMultiTexCoord1fvARB(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord1iARB(GLenum target, GLint s);
GLAPI void GLAPIENTRY glMultiTexCoord1ivARB(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord1sARB(GLenum target, GLshort s);
GLAPI void GLAPIENTRY glMultiTexCoord1svARB(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord2dARB(GLenum target, GLdouble s, GLdouble t);
GLAPI void GLAPIENTRY glMultiTexCoord2dvARB(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord2fARB(GLenum target, GLfloat s, GLfloat t);
GLAPI void GLAPIENTRY glMultiTexCoord2fvARB(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord2iARB(GLenum target, GLint s, GLint t);
GLAPI void GLAPIENTRY glMultiTexCoord2ivARB(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord2sARB(GLenum target, GLshort s, GLshort t);
GLAPI void GLAPIENTRY glMultiTexCoord2svARB(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord3dARB(GLenum target, GLdouble s, GLdouble t, GLdouble r);
GLAPI void GLAPIENTRY glMultiTexCoord3dvARB(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord3fARB(GLenum target, GLfloat s, GLfloat t, GLfloat r);
GLAPI void GLAPIENTRY glMultiTexCoord3fvARB(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord3iARB(GLenum target, GLint s, GLint t, GLint r);
GLAPI void GLAPIENTRY glMultiTexCoord3ivARB(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord3sARB(GLenum target, GLshort s, GLshort t, GLshort r);
GLAPI void GLAPIENTRY glMultiTexCoord3svARB(GLenum target, const GLshort *v);
GLAPI void GLAPIENTRY glMultiTexCoord4dARB(GLenum target, GLdouble s, GLdouble t, GLdouble r, GLdouble q);
GLAPI void GLAPIENTRY glMultiTexCoord4dvARB(GLenum target, const GLdouble *v);
GLAPI void GLAPIENTRY glMultiTexCoord4fARB(GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q);
GLAPI void GLAPIENTRY glMultiTexCoord4fvARB(GLenum target, const GLfloat *v);
GLAPI void GLAPIENTRY glMultiTexCoord4iARB(GLenum target, GLint s, GLint t, GLint r, GLint q);
GLAPI void GLAPIENTRY glMultiTexCoord4ivARB(GLenum target, const GLint *v);
GLAPI void GLAPIENTRY glMultiTexCoord4sARB(GLenum target, GLshort s, GLshort t, GLshort r, GLshort q);
GLAPI void GLAPIENTRY glMultiTexCoord4svARB(GLenum target, const GLshort *v);

/* Set the current normal in object coordinates, initially (0, 0, 1); integers are mapped to [-1,1]. It need
 * not have length 1 if GL_NORMALIZE is on. */
GLAPI void GLAPIENTRY glNormal3b(GLbyte nx, GLbyte ny, GLbyte nz);
GLAPI void GLAPIENTRY glNormal3bv(const GLbyte *v);
GLAPI void GLAPIENTRY glNormal3d(GLdouble nx, GLdouble ny, GLdouble nz);
GLAPI void GLAPIENTRY glNormal3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glNormal3f(GLfloat nx, GLfloat ny, GLfloat nz);
GLAPI void GLAPIENTRY glNormal3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glNormal3i(GLint nx, GLint ny, GLint nz);
GLAPI void GLAPIENTRY glNormal3iv(const GLint *v);
GLAPI void GLAPIENTRY glNormal3s(GLshort nx, GLshort ny, GLshort nz);
GLAPI void GLAPIENTRY glNormal3sv(const GLshort *v);

/* Set the current color; missing alpha is 1. Floats are not clamped here (but see 2.14.6). Initially (1, 1,
 * 1, 1). */
GLAPI void GLAPIENTRY glColor3b(GLbyte red, GLbyte green, GLbyte blue);
GLAPI void GLAPIENTRY glColor3bv(const GLbyte *v);
GLAPI void GLAPIENTRY glColor3d(GLdouble red, GLdouble green, GLdouble blue);
GLAPI void GLAPIENTRY glColor3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glColor3f(GLfloat red, GLfloat green, GLfloat blue);
GLAPI void GLAPIENTRY glColor3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glColor3i(GLint red, GLint green, GLint blue);
GLAPI void GLAPIENTRY glColor3iv(const GLint *v);
GLAPI void GLAPIENTRY glColor3s(GLshort red, GLshort green, GLshort blue);
GLAPI void GLAPIENTRY glColor3sv(const GLshort *v);
GLAPI void GLAPIENTRY glColor3ub(GLubyte red, GLubyte green, GLubyte blue);
GLAPI void GLAPIENTRY glColor3ubv(const GLubyte *v);
GLAPI void GLAPIENTRY glColor3ui(GLuint red, GLuint green, GLuint blue);
GLAPI void GLAPIENTRY glColor3uiv(const GLuint *v);
GLAPI void GLAPIENTRY glColor3us(GLushort red, GLushort green, GLushort blue);
GLAPI void GLAPIENTRY glColor3usv(const GLushort *v);
GLAPI void GLAPIENTRY glColor4b(GLbyte red, GLbyte green, GLbyte blue, GLbyte alpha);
GLAPI void GLAPIENTRY glColor4bv(const GLbyte *v);
GLAPI void GLAPIENTRY glColor4d(GLdouble red, GLdouble green, GLdouble blue, GLdouble alpha);
GLAPI void GLAPIENTRY glColor4dv(const GLdouble *v);
GLAPI void GLAPIENTRY glColor4f(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
GLAPI void GLAPIENTRY glColor4fv(const GLfloat *v);
GLAPI void GLAPIENTRY glColor4i(GLint red, GLint green, GLint blue, GLint alpha);
GLAPI void GLAPIENTRY glColor4iv(const GLint *v);
GLAPI void GLAPIENTRY glColor4s(GLshort red, GLshort green, GLshort blue, GLshort alpha);
GLAPI void GLAPIENTRY glColor4sv(const GLshort *v);
GLAPI void GLAPIENTRY glColor4ub(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha);
GLAPI void GLAPIENTRY glColor4ubv(const GLubyte *v);
GLAPI void GLAPIENTRY glColor4ui(GLuint red, GLuint green, GLuint blue, GLuint alpha);
GLAPI void GLAPIENTRY glColor4uiv(const GLuint *v);
GLAPI void GLAPIENTRY glColor4us(GLushort red, GLushort green, GLushort blue, GLushort alpha);
GLAPI void GLAPIENTRY glColor4usv(const GLushort *v);

/* Set the current color index, initially 1; integers are taken as they are. Without effect on an RGBA buffer
 * but for glGet. */
GLAPI void GLAPIENTRY glIndexd(GLdouble c);
GLAPI void GLAPIENTRY glIndexdv(const GLdouble *c);
GLAPI void GLAPIENTRY glIndexf(GLfloat c);
GLAPI void GLAPIENTRY glIndexfv(const GLfloat *c);
GLAPI void GLAPIENTRY glIndexi(GLint c);
GLAPI void GLAPIENTRY glIndexiv(const GLint *c);
GLAPI void GLAPIENTRY glIndexs(GLshort c);
GLAPI void GLAPIENTRY glIndexsv(const GLshort *c);
GLAPI void GLAPIENTRY glIndexub(GLubyte c);
GLAPI void GLAPIENTRY glIndexubv(const GLubyte *c);

/* Current values, for glGet (table 6.5). Fog coordinate and secondary color are set by glFogCoord and
 * glSecondaryColor of GL/glext.h (1.4). */
#define GL_CURRENT_COLOR                           0x0B00
#define GL_CURRENT_INDEX                           0x0B01
#define GL_CURRENT_NORMAL                          0x0B02
#define GL_CURRENT_TEXTURE_COORDS                  0x0B03
#define GL_CURRENT_SECONDARY_COLOR                 0x8459
#define GL_CURRENT_FOG_COORDINATE                  0x8453
#define GL_CURRENT_FOG_COORD                       0x8453


/* ---- 2.8 Vertex arrays --------------------------------------------------------------------------------- */

/* Arrays for glEnableClientState; GL_TEXTURE_COORD_ARRAY is that of the client's active unit. */
#define GL_VERTEX_ARRAY                            0x8074
#define GL_NORMAL_ARRAY                            0x8075
#define GL_COLOR_ARRAY                             0x8076
#define GL_INDEX_ARRAY                             0x8077
#define GL_TEXTURE_COORD_ARRAY                     0x8078
#define GL_EDGE_FLAG_ARRAY                         0x8079
#define GL_FOG_COORDINATE_ARRAY                    0x8457
#define GL_FOG_COORD_ARRAY                         0x8457
#define GL_SECONDARY_COLOR_ARRAY                   0x845E

/* Their state, for glGet (tables 6.6, 6.7). */
#define GL_VERTEX_ARRAY_SIZE                       0x807A
#define GL_VERTEX_ARRAY_TYPE                       0x807B
#define GL_VERTEX_ARRAY_STRIDE                     0x807C
#define GL_NORMAL_ARRAY_TYPE                       0x807E
#define GL_NORMAL_ARRAY_STRIDE                     0x807F
#define GL_COLOR_ARRAY_SIZE                        0x8081
#define GL_COLOR_ARRAY_TYPE                        0x8082
#define GL_COLOR_ARRAY_STRIDE                      0x8083
#define GL_INDEX_ARRAY_TYPE                        0x8085
#define GL_INDEX_ARRAY_STRIDE                      0x8086
#define GL_TEXTURE_COORD_ARRAY_SIZE                0x8088
#define GL_TEXTURE_COORD_ARRAY_TYPE                0x8089
#define GL_TEXTURE_COORD_ARRAY_STRIDE              0x808A
#define GL_EDGE_FLAG_ARRAY_STRIDE                  0x808C
#define GL_FOG_COORDINATE_ARRAY_TYPE               0x8454
#define GL_FOG_COORD_ARRAY_TYPE                    0x8454
#define GL_FOG_COORDINATE_ARRAY_STRIDE             0x8455
#define GL_FOG_COORD_ARRAY_STRIDE                  0x8455
#define GL_SECONDARY_COLOR_ARRAY_SIZE              0x845A
#define GL_SECONDARY_COLOR_ARRAY_TYPE              0x845B
#define GL_SECONDARY_COLOR_ARRAY_STRIDE            0x845C
#define GL_CLIENT_ACTIVE_TEXTURE                   0x84E1
#define GL_MAX_ELEMENTS_VERTICES                   0x80E8
#define GL_MAX_ELEMENTS_INDICES                    0x80E9

/* Their addresses, for glGetPointerv. */
#define GL_VERTEX_ARRAY_POINTER                    0x808E
#define GL_NORMAL_ARRAY_POINTER                    0x808F
#define GL_COLOR_ARRAY_POINTER                     0x8090
#define GL_INDEX_ARRAY_POINTER                     0x8091
#define GL_TEXTURE_COORD_ARRAY_POINTER             0x8092
#define GL_EDGE_FLAG_ARRAY_POINTER                 0x8093
#define GL_FOG_COORDINATE_ARRAY_POINTER            0x8456
#define GL_FOG_COORD_ARRAY_POINTER                 0x8456
#define GL_SECONDARY_COLOR_ARRAY_POINTER           0x845D

/* Describe where the coordinates of vertex i are: size values (2, 3 or 4) of type GL_SHORT, GL_INT, GL_FLOAT
 * or GL_DOUBLE at pointer + i * stride bytes; stride 0 means tightly packed. With a buffer object bound to
 * GL_ARRAY_BUFFER the pointer is an offset into it. GL_INVALID_VALUE: another size, negative stride. */
GLAPI void GLAPIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void *pointer);

/* The same for normals: three values of GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT or GL_DOUBLE. GL_INVALID_VALUE:
 * negative stride. */
GLAPI void GLAPIENTRY glNormalPointer(GLenum type, GLsizei stride, const void *pointer);

/* The same for colors: size 3 or 4; any signed or unsigned integer type, GL_FLOAT or GL_DOUBLE.
 * GL_INVALID_VALUE: another size, negative stride. */
GLAPI void GLAPIENTRY glColorPointer(GLint size, GLenum type, GLsizei stride, const void *pointer);

/* The same for color indices: GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT or GL_DOUBLE. GL_INVALID_VALUE:
 * negative stride. */
GLAPI void GLAPIENTRY glIndexPointer(GLenum type, GLsizei stride, const void *pointer);

/* The same for texture coordinates of the client's active unit: size 1 to 4; GL_SHORT, GL_INT, GL_FLOAT or
 * GL_DOUBLE. GL_INVALID_VALUE: another size, negative stride. */
GLAPI void GLAPIENTRY glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void *pointer);

/* The same for edge flags: one GLboolean each. GL_INVALID_VALUE: negative stride. */
GLAPI void GLAPIENTRY glEdgeFlagPointer(GLsizei stride, const void *pointer);

/* Switch an array on or off. Initially all are off. */
GLAPI void GLAPIENTRY glEnableClientState(GLenum array);
GLAPI void GLAPIENTRY glDisableClientState(GLenum array);

/* Selects the unit that glTexCoordPointer, glEnableClientState and the array queries speak of: GL_TEXTURE0 +
 * i, i < GL_MAX_TEXTURE_UNITS. Since 1.3; the ARB name is the same command. */
GLAPI void GLAPIENTRY glClientActiveTexture(GLenum texture);
GLAPI void GLAPIENTRY glClientActiveTextureARB(GLenum texture);

/* Sends element i of every enabled array as the matching command would, the vertex last. */
GLAPI void GLAPIENTRY glArrayElement(GLint i);

/* Draws the primitives that mode makes of the count elements from first on. Current values of enabled arrays
 * are indeterminate afterwards. */
GLAPI void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count);

/* The same with the elements chosen by count indices of type GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or
 * GL_UNSIGNED_INT, read from indices or, with a buffer bound to GL_ELEMENT_ARRAY_BUFFER, from that offset in
 * it. */
GLAPI void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices);

/* As glDrawElements; the caller promises that every index is in [start, end]. GL_INVALID_VALUE: end < start.
 * Since 1.2. */
GLAPI void GLAPIENTRY glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                          const void *indices);

/* Layouts of interleaved vertex data: T texture coordinates, C color (4UB: four GLubyte), N normal, V vertex,
 * each with the number of values. */
#define GL_V2F                                     0x2A20
#define GL_V3F                                     0x2A21
#define GL_C4UB_V2F                                0x2A22
#define GL_C4UB_V3F                                0x2A23
#define GL_C3F_V3F                                 0x2A24
#define GL_N3F_V3F                                 0x2A25
#define GL_C4F_N3F_V3F                             0x2A26
#define GL_T2F_V3F                                 0x2A27
#define GL_T4F_V4F                                 0x2A28
#define GL_T2F_C4UB_V3F                            0x2A29
#define GL_T2F_C3F_V3F                             0x2A2A
#define GL_T2F_N3F_V3F                             0x2A2B
#define GL_T2F_C4F_N3F_V3F                         0x2A2C
#define GL_T4F_C4F_N3F_V4F                         0x2A2D

/* Sets and enables the arrays of one of these layouts at pointer and disables the other arrays. stride as in
 * glVertexPointer. GL_INVALID_VALUE: negative stride. */
GLAPI void GLAPIENTRY glInterleavedArrays(GLenum format, GLsizei stride, const void *pointer);


/* ---- 2.9 Buffer objects (since 1.5; the functions are in GL/glext.h) ----------------------------------- */

/* Targets and their bindings; the binding each array had when its pointer was set (table 6.7). */
#define GL_ARRAY_BUFFER                            0x8892
#define GL_ELEMENT_ARRAY_BUFFER                    0x8893
#define GL_ARRAY_BUFFER_BINDING                    0x8894
#define GL_ELEMENT_ARRAY_BUFFER_BINDING            0x8895
#define GL_VERTEX_ARRAY_BUFFER_BINDING             0x8896
#define GL_NORMAL_ARRAY_BUFFER_BINDING             0x8897
#define GL_COLOR_ARRAY_BUFFER_BINDING              0x8898
#define GL_INDEX_ARRAY_BUFFER_BINDING              0x8899
#define GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING      0x889A
#define GL_EDGE_FLAG_ARRAY_BUFFER_BINDING          0x889B
#define GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING    0x889C
#define GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING     0x889D
#define GL_FOG_COORD_ARRAY_BUFFER_BINDING          0x889D
#define GL_WEIGHT_ARRAY_BUFFER_BINDING             0x889E
#define GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING      0x889F

/* State of a buffer object (table 6.8), access to a mapped one, and how it is to be used. */
#define GL_BUFFER_SIZE                             0x8764
#define GL_BUFFER_USAGE                            0x8765
#define GL_BUFFER_ACCESS                           0x88BB
#define GL_BUFFER_MAPPED                           0x88BC
#define GL_BUFFER_MAP_POINTER                      0x88BD
#define GL_READ_ONLY                               0x88B8
#define GL_WRITE_ONLY                              0x88B9
#define GL_READ_WRITE                              0x88BA
#define GL_STREAM_DRAW                             0x88E0
#define GL_STREAM_READ                             0x88E1
#define GL_STREAM_COPY                             0x88E2
#define GL_STATIC_DRAW                             0x88E4
#define GL_STATIC_READ                             0x88E5
#define GL_STATIC_COPY                             0x88E6
#define GL_DYNAMIC_DRAW                            0x88E8
#define GL_DYNAMIC_READ                            0x88E9
#define GL_DYNAMIC_COPY                            0x88EA


/* ---- 2.10 Rectangles ----------------------------------------------------------------------------------- */

/* Draw the polygon (x1,y1) (x2,y1) (x2,y2) (x1,y2) in the plane z = 0 of object coordinates; the v forms read
 * the two corners from two arrays. */
GLAPI void GLAPIENTRY glRectd(GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2);
GLAPI void GLAPIENTRY glRectdv(const GLdouble *v1, const GLdouble *v2);
GLAPI void GLAPIENTRY glRectf(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2);
GLAPI void GLAPIENTRY glRectfv(const GLfloat *v1, const GLfloat *v2);
GLAPI void GLAPIENTRY glRecti(GLint x1, GLint y1, GLint x2, GLint y2);
GLAPI void GLAPIENTRY glRectiv(const GLint *v1, const GLint *v2);
GLAPI void GLAPIENTRY glRects(GLshort x1, GLshort y1, GLshort x2, GLshort y2);
GLAPI void GLAPIENTRY glRectsv(const GLshort *v1, const GLshort *v2);


/* ---- 2.11 Coordinate transformations ------------------------------------------------------------------- */

#define GL_DEPTH_RANGE                             0x0B70
#define GL_VIEWPORT                                0x0BA2
#define GL_MAX_VIEWPORT_DIMS                       0x0D3A

/* Maps normalized depth -1 to n and 1 to f, each clamped to [0,1]; n > f is allowed. Initially 0 and 1.
 * (2.11.1) */
GLAPI void GLAPIENTRY glDepthRange(GLdouble n, GLdouble f);

/* Maps normalized x and y from [-1,1] to the window rectangle with lower left corner (x, y), in pixels. width
 * and height are clamped to GL_MAX_VIEWPORT_DIMS. The viewport does not cut off wide lines or points.
 * (2.11.1) */
GLAPI void GLAPIENTRY glViewport(GLint x, GLint y, GLsizei width, GLsizei height);

#define GL_MATRIX_MODE                             0x0BA0
#define GL_MODELVIEW                               0x1700
#define GL_PROJECTION                              0x1701
#define GL_TEXTURE                                 0x1702
#define GL_COLOR                                   0x1800
#define GL_MODELVIEW_MATRIX                        0x0BA6
#define GL_PROJECTION_MATRIX                       0x0BA7
#define GL_TEXTURE_MATRIX                          0x0BA8
#define GL_COLOR_MATRIX                            0x80B1
#define GL_TRANSPOSE_MODELVIEW_MATRIX              0x84E3
#define GL_TRANSPOSE_PROJECTION_MATRIX             0x84E4
#define GL_TRANSPOSE_TEXTURE_MATRIX                0x84E5
#define GL_TRANSPOSE_COLOR_MATRIX                  0x84E6
#define GL_MODELVIEW_STACK_DEPTH                   0x0BA3
#define GL_PROJECTION_STACK_DEPTH                  0x0BA4
#define GL_TEXTURE_STACK_DEPTH                     0x0BA5
#define GL_COLOR_MATRIX_STACK_DEPTH                0x80B2
#define GL_MAX_MODELVIEW_STACK_DEPTH               0x0D36
#define GL_MAX_PROJECTION_STACK_DEPTH              0x0D38
#define GL_MAX_TEXTURE_STACK_DEPTH                 0x0D39
#define GL_MAX_COLOR_MATRIX_STACK_DEPTH            0x80B3

/* Selects the matrix that the following commands change: GL_MODELVIEW (initially), GL_PROJECTION, GL_TEXTURE
 * (of the active unit) or GL_COLOR (imaging subset). (2.11.2 Matrices, here and down to glPopMatrix) */
GLAPI void GLAPIENTRY glMatrixMode(GLenum mode);

/* Replace the current matrix by m: 16 values, column after column, so that m[12], m[13], m[14] are a
 * translation. */
GLAPI void GLAPIENTRY glLoadMatrixf(const GLfloat *m);
GLAPI void GLAPIENTRY glLoadMatrixd(const GLdouble *m);

/* Replace the current matrix M by M * m: m applies to coordinates before M does. m as in glLoadMatrix. */
GLAPI void GLAPIENTRY glMultMatrixf(const GLfloat *m);
GLAPI void GLAPIENTRY glMultMatrixd(const GLdouble *m);

/* The same two with m given row after row. Since 1.3. */
GLAPI void GLAPIENTRY glLoadTransposeMatrixf(const GLfloat *m);
GLAPI void GLAPIENTRY glLoadTransposeMatrixd(const GLdouble *m);
GLAPI void GLAPIENTRY glMultTransposeMatrixf(const GLfloat *m);
GLAPI void GLAPIENTRY glMultTransposeMatrixd(const GLdouble *m);

/* Replaces the current matrix by the identity. */
GLAPI void GLAPIENTRY glLoadIdentity(void);

/* Multiply by a rotation of angle degrees, counter-clockwise about the axis (x, y, z) seen from its tip; the
 * axis may have any length but 0. */
GLAPI void GLAPIENTRY glRotated(GLdouble angle, GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z);

/* Multiply by a translation. */
GLAPI void GLAPIENTRY glTranslated(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glTranslatef(GLfloat x, GLfloat y, GLfloat z);

/* Multiply by a scaling along the axes. */
GLAPI void GLAPIENTRY glScaled(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glScalef(GLfloat x, GLfloat y, GLfloat z);

/* Multiplies by the perspective projection with the eye at the origin, looking along -z, that shows the
 * rectangle left..right, bottom..top of the plane z = -zNear, up to the plane z = -zFar. GL_INVALID_VALUE:
 * zNear or zFar not positive, left = right, bottom = top, zNear = zFar. */
GLAPI void GLAPIENTRY glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
                                GLdouble zFar);

/* The same for a parallel projection; zNear and zFar are distances along -z and may be negative.
 * GL_INVALID_VALUE: left = right, bottom = top, zNear = zFar. */
GLAPI void GLAPIENTRY glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
                              GLdouble zFar);

/* Selects the texture unit that the texture commands, GL_TEXTURE matrices and texture enables speak of:
 * GL_TEXTURE0 + i, i < GL_MAX_TEXTURE_UNITS. Since 1.3; the ARB name is the same command. */
GLAPI void GLAPIENTRY glActiveTexture(GLenum texture);
GLAPI void GLAPIENTRY glActiveTextureARB(GLenum texture);

/* glPushMatrix keeps a copy of the current matrix on its stack, glPopMatrix brings it back.
 * GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW: the stack is full, or holds one matrix only. */
GLAPI void GLAPIENTRY glPushMatrix(void);
GLAPI void GLAPIENTRY glPopMatrix(void);

/* Enables of 2.11.3 Normal transformation: make normals length 1, or divide out a uniform scale (1.2). */
#define GL_NORMALIZE                               0x0BA1
#define GL_RESCALE_NORMAL                          0x803A

/* Switch a capability on or off, and ask for its state. A capability is any token that a section of this file
 * calls an enable. Initially all are off but GL_DITHER and GL_MULTISAMPLE. */
GLAPI void GLAPIENTRY glEnable(GLenum cap);
GLAPI void GLAPIENTRY glDisable(GLenum cap);
GLAPI GLboolean GLAPIENTRY glIsEnabled(GLenum cap);

/* Enables and parameters of 2.11.4 Generating texture coordinates. */
#define GL_TEXTURE_GEN_S                           0x0C60
#define GL_TEXTURE_GEN_T                           0x0C61
#define GL_TEXTURE_GEN_R                           0x0C62
#define GL_TEXTURE_GEN_Q                           0x0C63
#define GL_TEXTURE_GEN_MODE                        0x2500
#define GL_OBJECT_PLANE                            0x2501
#define GL_EYE_PLANE                               0x2502
#define GL_EYE_LINEAR                              0x2400
#define GL_OBJECT_LINEAR                           0x2401
#define GL_SPHERE_MAP                              0x2402
#define GL_NORMAL_MAP                              0x8511
#define GL_REFLECTION_MAP                          0x8512

/* Say how coordinate coord (GL_S, GL_T, GL_R, GL_Q) of the active unit is made when its GL_TEXTURE_GEN_x is
 * enabled. GL_TEXTURE_GEN_MODE: GL_OBJECT_LINEAR, GL_EYE_LINEAR (initially), GL_SPHERE_MAP (S and T only),
 * GL_NORMAL_MAP or GL_REFLECTION_MAP (S, T and R only; 1.3). v forms also GL_OBJECT_PLANE and GL_EYE_PLANE:
 * four plane coefficients, those of GL_EYE_PLANE multiplied by the inverse of the present modelview
 * matrix. */
GLAPI void GLAPIENTRY glTexGend(GLenum coord, GLenum pname, GLdouble param);
GLAPI void GLAPIENTRY glTexGendv(GLenum coord, GLenum pname, const GLdouble *params);
GLAPI void GLAPIENTRY glTexGenf(GLenum coord, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexGenfv(GLenum coord, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glTexGeni(GLenum coord, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexGeniv(GLenum coord, GLenum pname, const GLint *params);


/* ---- 2.12 Clipping ------------------------------------------------------------------------------------- */

/* Enables, also the first argument of glClipPlane. GL_CLIP_PLANEi = GL_CLIP_PLANE0 + i. */
#define GL_CLIP_PLANE0                             0x3000
#define GL_CLIP_PLANE1                             0x3001
#define GL_CLIP_PLANE2                             0x3002
#define GL_CLIP_PLANE3                             0x3003
#define GL_CLIP_PLANE4                             0x3004
#define GL_CLIP_PLANE5                             0x3005
#define GL_MAX_CLIP_PLANES                         0x0D32

/* Sets user clip plane plane (GL_CLIP_PLANE0 + i, i < GL_MAX_CLIP_PLANES): points with a x + b y + c z + d w
 * >= 0 are kept, (a, b, c, d) = equation in object coordinates, taken to eye coordinates by the inverse of
 * the present modelview matrix. */
GLAPI void GLAPIENTRY glClipPlane(GLenum plane, const GLdouble *equation);


/* ---- 2.13 Current raster position ---------------------------------------------------------------------- */

#define GL_CURRENT_RASTER_POSITION                 0x0B07
#define GL_CURRENT_RASTER_DISTANCE                 0x0B09
#define GL_CURRENT_RASTER_COLOR                    0x0B04
#define GL_CURRENT_RASTER_INDEX                    0x0B05
#define GL_CURRENT_RASTER_TEXTURE_COORDS           0x0B06
#define GL_CURRENT_RASTER_POSITION_VALID           0x0B08

/* Set the raster position, where glDrawPixels, glCopyPixels and glBitmap draw. The coordinates go the way of
 * a vertex, lighting and texture coordinates too; if the point is clipped the position becomes invalid and
 * those commands do nothing. Missing z is 0, missing w is 1. glWindowPos (GL/glext.h) sets it in window
 * coordinates. */
GLAPI void GLAPIENTRY glRasterPos2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glRasterPos2dv(const GLdouble *v);
GLAPI void GLAPIENTRY glRasterPos2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glRasterPos2fv(const GLfloat *v);
GLAPI void GLAPIENTRY glRasterPos2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glRasterPos2iv(const GLint *v);
GLAPI void GLAPIENTRY glRasterPos2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glRasterPos2sv(const GLshort *v);
GLAPI void GLAPIENTRY glRasterPos3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glRasterPos3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glRasterPos3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glRasterPos3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glRasterPos3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glRasterPos3iv(const GLint *v);
GLAPI void GLAPIENTRY glRasterPos3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glRasterPos3sv(const GLshort *v);
GLAPI void GLAPIENTRY glRasterPos4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w);
GLAPI void GLAPIENTRY glRasterPos4dv(const GLdouble *v);
GLAPI void GLAPIENTRY glRasterPos4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w);
GLAPI void GLAPIENTRY glRasterPos4fv(const GLfloat *v);
GLAPI void GLAPIENTRY glRasterPos4i(GLint x, GLint y, GLint z, GLint w);
GLAPI void GLAPIENTRY glRasterPos4iv(const GLint *v);
GLAPI void GLAPIENTRY glRasterPos4s(GLshort x, GLshort y, GLshort z, GLshort w);
GLAPI void GLAPIENTRY glRasterPos4sv(const GLshort *v);


/* ---- 2.14 Colors and coloring -------------------------------------------------------------------------- */

/* Enables: lighting as a whole and each light. GL_LIGHTi = GL_LIGHT0 + i. */
#define GL_LIGHTING                                0x0B50
#define GL_LIGHT0                                  0x4000
#define GL_LIGHT1                                  0x4001
#define GL_LIGHT2                                  0x4002
#define GL_LIGHT3                                  0x4003
#define GL_LIGHT4                                  0x4004
#define GL_LIGHT5                                  0x4005
#define GL_LIGHT6                                  0x4006
#define GL_LIGHT7                                  0x4007
#define GL_MAX_LIGHTS                              0x0D31

/* Parameters of a light, of the light model and of a material (2.14.1 Lighting, tables 2.10 and 2.11). */
#define GL_AMBIENT                                 0x1200
#define GL_DIFFUSE                                 0x1201
#define GL_SPECULAR                                0x1202
#define GL_POSITION                                0x1203
#define GL_SPOT_DIRECTION                          0x1204
#define GL_SPOT_EXPONENT                           0x1205
#define GL_SPOT_CUTOFF                             0x1206
#define GL_CONSTANT_ATTENUATION                    0x1207
#define GL_LINEAR_ATTENUATION                      0x1208
#define GL_QUADRATIC_ATTENUATION                   0x1209
#define GL_LIGHT_MODEL_AMBIENT                     0x0B53
#define GL_LIGHT_MODEL_LOCAL_VIEWER                0x0B51
#define GL_LIGHT_MODEL_TWO_SIDE                    0x0B52
#define GL_LIGHT_MODEL_COLOR_CONTROL               0x81F8
#define GL_SINGLE_COLOR                            0x81F9
#define GL_SEPARATE_SPECULAR_COLOR                 0x81FA
#define GL_EMISSION                                0x1600
#define GL_SHININESS                               0x1601
#define GL_AMBIENT_AND_DIFFUSE                     0x1602
#define GL_COLOR_INDEXES                           0x1603

/* Set a parameter of light (GL_LIGHT0 + i, i < GL_MAX_LIGHTS). (2.14.2 Lighting parameter specification) All
 * forms: GL_SPOT_EXPONENT in [0,128]; GL_SPOT_CUTOFF in degrees in [0,90], or 180 for no cone; the three
 * attenuations, not negative. v forms also: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, RGBA, not clamped;
 * GL_POSITION, (x, y, z, w) in object coordinates, w = 0 for a direction, and GL_SPOT_DIRECTION (x, y, z),
 * both taken to eye coordinates by the present modelview matrix. GL_INVALID_VALUE: a value out of its
 * range. */
GLAPI void GLAPIENTRY glLightf(GLenum light, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glLightfv(GLenum light, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glLighti(GLenum light, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glLightiv(GLenum light, GLenum pname, const GLint *params);

/* Set a parameter of the light model: GL_LIGHT_MODEL_LOCAL_VIEWER, the viewer is at the eye and not
 * infinitely far; GL_LIGHT_MODEL_TWO_SIDE, back faces are lit with the back material and the opposite normal;
 * GL_LIGHT_MODEL_COLOR_CONTROL (1.2), GL_SINGLE_COLOR or, to add highlights after texturing,
 * GL_SEPARATE_SPECULAR_COLOR. v forms also: GL_LIGHT_MODEL_AMBIENT, RGBA, initially (.2, .2, .2, 1).
 * (2.14.2) */
GLAPI void GLAPIENTRY glLightModelf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glLightModelfv(GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glLightModeli(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glLightModeliv(GLenum pname, const GLint *params);

/* Set a parameter of the material of face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK. All forms: GL_SHININESS in
 * [0,128]. v forms also: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE, RGBA, not
 * clamped; GL_COLOR_INDEXES, three values. A property that tracks the current color (see below) keeps it.
 * GL_INVALID_VALUE: shininess out of range. (2.14.2) */
GLAPI void GLAPIENTRY glMaterialf(GLenum face, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glMaterialfv(GLenum face, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glMateriali(GLenum face, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glMaterialiv(GLenum face, GLenum pname, const GLint *params);

/* An enable, and the state of glColorMaterial. */
#define GL_COLOR_MATERIAL                          0x0B57
#define GL_COLOR_MATERIAL_FACE                     0x0B55
#define GL_COLOR_MATERIAL_PARAMETER                0x0B56

/* Names the property, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION or GL_AMBIENT_AND_DIFFUSE (initially),
 * of face that follows the current color while GL_COLOR_MATERIAL is enabled. (2.14.3 ColorMaterial) */
GLAPI void GLAPIENTRY glColorMaterial(GLenum face, GLenum mode);

#define GL_SHADE_MODEL                             0x0B54
#define GL_FLAT                                    0x1D00
#define GL_SMOOTH                                  0x1D01

/* GL_SMOOTH (initially): colors are interpolated. GL_FLAT: a primitive has the color of its last vertex, a
 * polygon that of its first. (2.14.7 Flatshading) */
GLAPI void GLAPIENTRY glShadeModel(GLenum mode);


/* ---- 3.3 Points ---------------------------------------------------------------------------------------- */

/* GL_POINT_SMOOTH is an enable; the GL_POINT_x below are for glPointParameter (GL/glext.h, 1.4). */
#define GL_POINT_SMOOTH                            0x0B10
#define GL_POINT_SIZE                              0x0B11
#define GL_POINT_SIZE_RANGE                        0x0B12
#define GL_POINT_SIZE_GRANULARITY                  0x0B13
#define GL_SMOOTH_POINT_SIZE_RANGE                 0x0B12
#define GL_SMOOTH_POINT_SIZE_GRANULARITY           0x0B13
#define GL_ALIASED_POINT_SIZE_RANGE                0x846D
#define GL_POINT_SIZE_MIN                          0x8126
#define GL_POINT_SIZE_MAX                          0x8127
#define GL_POINT_FADE_THRESHOLD_SIZE               0x8128
#define GL_POINT_DISTANCE_ATTENUATION              0x8129

/* Sets the diameter of points in pixels, initially 1. GL_INVALID_VALUE: size <= 0. */
GLAPI void GLAPIENTRY glPointSize(GLfloat size);


/* ---- 3.4 Line segments --------------------------------------------------------------------------------- */

/* GL_LINE_SMOOTH and GL_LINE_STIPPLE are enables. */
#define GL_LINE_SMOOTH                             0x0B20
#define GL_LINE_STIPPLE                            0x0B24
#define GL_LINE_STIPPLE_PATTERN                    0x0B25
#define GL_LINE_STIPPLE_REPEAT                     0x0B26
#define GL_LINE_WIDTH                              0x0B21
#define GL_LINE_WIDTH_RANGE                        0x0B22
#define GL_LINE_WIDTH_GRANULARITY                  0x0B23
#define GL_SMOOTH_LINE_WIDTH_RANGE                 0x0B22
#define GL_SMOOTH_LINE_WIDTH_GRANULARITY           0x0B23
#define GL_ALIASED_LINE_WIDTH_RANGE                0x846E

/* Sets the width of lines in pixels, initially 1. GL_INVALID_VALUE: width <= 0. */
GLAPI void GLAPIENTRY glLineWidth(GLfloat width);

/* Sets the dashes used while GL_LINE_STIPPLE is enabled: 16 bits, the lowest first, each standing for factor
 * fragments; factor is clamped to [1,256]. (3.4.2) */
GLAPI void GLAPIENTRY glLineStipple(GLint factor, GLushort pattern);


/* ---- 3.5 Polygons -------------------------------------------------------------------------------------- */

/* GL_CULL_FACE, GL_POLYGON_SMOOTH, GL_POLYGON_STIPPLE and GL_POLYGON_OFFSET_POINT, _LINE and _FILL are
 * enables. */
#define GL_CULL_FACE                               0x0B44
#define GL_CULL_FACE_MODE                          0x0B45
#define GL_FRONT_FACE                              0x0B46
#define GL_CW                                      0x0900
#define GL_CCW                                     0x0901
#define GL_POLYGON_SMOOTH                          0x0B41
#define GL_POLYGON_STIPPLE                         0x0B42
#define GL_POLYGON_MODE                            0x0B40
#define GL_POINT                                   0x1B00
#define GL_LINE                                    0x1B01
#define GL_FILL                                    0x1B02
#define GL_POLYGON_OFFSET_FACTOR                   0x8038
#define GL_POLYGON_OFFSET_UNITS                    0x2A00
#define GL_POLYGON_OFFSET_POINT                    0x2A01
#define GL_POLYGON_OFFSET_LINE                     0x2A02
#define GL_POLYGON_OFFSET_FILL                     0x8037

/* Polygons facing mode, GL_FRONT, GL_BACK (initially) or GL_FRONT_AND_BACK, are dropped while GL_CULL_FACE is
 * enabled. (3.5.1) */
GLAPI void GLAPIENTRY glCullFace(GLenum mode);

/* Front faces are those whose vertices run counter-clockwise in the window, GL_CCW (initially), or clockwise,
 * GL_CW. (3.5.1) */
GLAPI void GLAPIENTRY glFrontFace(GLenum mode);

/* Sets the 32 x 32 mask used while GL_POLYGON_STIPPLE is enabled: 32 rows of 4 bytes, the lowest row first,
 * unpacked as a bitmap (glPixelStore). The pattern is fixed to the window. (3.5.2) */
GLAPI void GLAPIENTRY glPolygonStipple(const GLubyte *mask);

/* Polygons facing face, GL_FRONT, GL_BACK or GL_FRONT_AND_BACK, are drawn as mode: GL_FILL (initially), their
 * edges as GL_LINE, or their vertices as GL_POINT. (3.5.4) */
GLAPI void GLAPIENTRY glPolygonMode(GLenum face, GLenum mode);

/* While the enable of the polygon's mode is on, depth is moved by factor * m + units * r, m being the
 * polygon's largest depth slope in the window and r the smallest step that the depth buffer is sure to tell
 * apart. (3.5.5) */
GLAPI void GLAPIENTRY glPolygonOffset(GLfloat factor, GLfloat units);


/* ---- 3.6 Pixel rectangles ------------------------------------------------------------------------------ */

/* Formats of pixels in client memory (tables 3.6, 4.5). */
#define GL_COLOR_INDEX                             0x1900
#define GL_STENCIL_INDEX                           0x1901
#define GL_DEPTH_COMPONENT                         0x1902
#define GL_RED                                     0x1903
#define GL_GREEN                                   0x1904
#define GL_BLUE                                    0x1905
#define GL_ALPHA                                   0x1906
#define GL_RGB                                     0x1907
#define GL_RGBA                                    0x1908
#define GL_LUMINANCE                               0x1909
#define GL_LUMINANCE_ALPHA                         0x190A
#define GL_BGR                                     0x80E0
#define GL_BGRA                                    0x80E1

/* Types of pixels besides those of 2.3: one bit each, and all components packed into one integer, the first
 * in the highest bits or, for REV, in the lowest (1.2). A packed type with a format of another number of
 * components is GL_INVALID_OPERATION in every command that takes both. */
#define GL_BITMAP                                  0x1A00
#define GL_UNSIGNED_BYTE_3_3_2                     0x8032
#define GL_UNSIGNED_BYTE_2_3_3_REV                 0x8362
#define GL_UNSIGNED_SHORT_5_6_5                    0x8363
#define GL_UNSIGNED_SHORT_5_6_5_REV                0x8364
#define GL_UNSIGNED_SHORT_4_4_4_4                  0x8033
#define GL_UNSIGNED_SHORT_4_4_4_4_REV              0x8365
#define GL_UNSIGNED_SHORT_5_5_5_1                  0x8034
#define GL_UNSIGNED_SHORT_1_5_5_5_REV              0x8366
#define GL_UNSIGNED_INT_8_8_8_8                    0x8035
#define GL_UNSIGNED_INT_8_8_8_8_REV                0x8367
#define GL_UNSIGNED_INT_10_10_10_2                 0x8036
#define GL_UNSIGNED_INT_2_10_10_10_REV             0x8368

/* How pixels lie in client memory when read (UNPACK) and when written (PACK). */
#define GL_UNPACK_SWAP_BYTES                       0x0CF0
#define GL_UNPACK_LSB_FIRST                        0x0CF1
#define GL_UNPACK_ROW_LENGTH                       0x0CF2
#define GL_UNPACK_SKIP_ROWS                        0x0CF3
#define GL_UNPACK_SKIP_PIXELS                      0x0CF4
#define GL_UNPACK_ALIGNMENT                        0x0CF5
#define GL_UNPACK_SKIP_IMAGES                      0x806D
#define GL_UNPACK_IMAGE_HEIGHT                     0x806E
#define GL_PACK_SWAP_BYTES                         0x0D00
#define GL_PACK_LSB_FIRST                          0x0D01
#define GL_PACK_ROW_LENGTH                         0x0D02
#define GL_PACK_SKIP_ROWS                          0x0D03
#define GL_PACK_SKIP_PIXELS                        0x0D04
#define GL_PACK_ALIGNMENT                          0x0D05
#define GL_PACK_SKIP_IMAGES                        0x806B
#define GL_PACK_IMAGE_HEIGHT                       0x806C

/* Set one of these: swap bytes, bitmaps with the lowest bit first; row length and image height in pixels (0:
 * as wide and high as the image); images, rows and pixels to skip; row alignment 1, 2, 4 (initially) or 8
 * bytes. GL_INVALID_VALUE: negative, or another alignment. (3.6.1 Pixel storage modes) */
GLAPI void GLAPIENTRY glPixelStoref(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPixelStorei(GLenum pname, GLint param);

#define GL_MAP_COLOR                               0x0D10
#define GL_MAP_STENCIL                             0x0D11
#define GL_INDEX_SHIFT                             0x0D12
#define GL_INDEX_OFFSET                            0x0D13
#define GL_RED_SCALE                               0x0D14
#define GL_RED_BIAS                                0x0D15
#define GL_GREEN_SCALE                             0x0D18
#define GL_GREEN_BIAS                              0x0D19
#define GL_BLUE_SCALE                              0x0D1A
#define GL_BLUE_BIAS                               0x0D1B
#define GL_ALPHA_SCALE                             0x0D1C
#define GL_ALPHA_BIAS                              0x0D1D
#define GL_DEPTH_SCALE                             0x0D1E
#define GL_DEPTH_BIAS                              0x0D1F
#define GL_POST_CONVOLUTION_RED_SCALE              0x801C
#define GL_POST_CONVOLUTION_GREEN_SCALE            0x801D
#define GL_POST_CONVOLUTION_BLUE_SCALE             0x801E
#define GL_POST_CONVOLUTION_ALPHA_SCALE            0x801F
#define GL_POST_CONVOLUTION_RED_BIAS               0x8020
#define GL_POST_CONVOLUTION_GREEN_BIAS             0x8021
#define GL_POST_CONVOLUTION_BLUE_BIAS              0x8022
#define GL_POST_CONVOLUTION_ALPHA_BIAS             0x8023
#define GL_POST_COLOR_MATRIX_RED_SCALE             0x80B4
#define GL_POST_COLOR_MATRIX_GREEN_SCALE           0x80B5
#define GL_POST_COLOR_MATRIX_BLUE_SCALE            0x80B6
#define GL_POST_COLOR_MATRIX_ALPHA_SCALE           0x80B7
#define GL_POST_COLOR_MATRIX_RED_BIAS              0x80B8
#define GL_POST_COLOR_MATRIX_GREEN_BIAS            0x80B9
#define GL_POST_COLOR_MATRIX_BLUE_BIAS             0x80BA
#define GL_POST_COLOR_MATRIX_ALPHA_BIAS            0x80BB

/* Set one of these: what happens to pixels that are drawn, copied, read or made into a texture. Scales are
 * initially 1, biases 0, maps off. (3.6.3 Pixel transfer modes) */
GLAPI void GLAPIENTRY glPixelTransferf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPixelTransferi(GLenum pname, GLint param);

#define GL_PIXEL_MAP_I_TO_I                        0x0C70
#define GL_PIXEL_MAP_S_TO_S                        0x0C71
#define GL_PIXEL_MAP_I_TO_R                        0x0C72
#define GL_PIXEL_MAP_I_TO_G                        0x0C73
#define GL_PIXEL_MAP_I_TO_B                        0x0C74
#define GL_PIXEL_MAP_I_TO_A                        0x0C75
#define GL_PIXEL_MAP_R_TO_R                        0x0C76
#define GL_PIXEL_MAP_G_TO_G                        0x0C77
#define GL_PIXEL_MAP_B_TO_B                        0x0C78
#define GL_PIXEL_MAP_A_TO_A                        0x0C79
#define GL_PIXEL_MAP_I_TO_I_SIZE                   0x0CB0
#define GL_PIXEL_MAP_S_TO_S_SIZE                   0x0CB1
#define GL_PIXEL_MAP_I_TO_R_SIZE                   0x0CB2
#define GL_PIXEL_MAP_I_TO_G_SIZE                   0x0CB3
#define GL_PIXEL_MAP_I_TO_B_SIZE                   0x0CB4
#define GL_PIXEL_MAP_I_TO_A_SIZE                   0x0CB5
#define GL_PIXEL_MAP_R_TO_R_SIZE                   0x0CB6
#define GL_PIXEL_MAP_G_TO_G_SIZE                   0x0CB7
#define GL_PIXEL_MAP_B_TO_B_SIZE                   0x0CB8
#define GL_PIXEL_MAP_A_TO_A_SIZE                   0x0CB9
#define GL_MAX_PIXEL_MAP_TABLE                     0x0D34

/* Set the look-up table map to mapsize values, colors in [0,1] (integers are mapped to that) or indices.
 * GL_INVALID_VALUE: mapsize < 1 or > GL_MAX_PIXEL_MAP_TABLE, or not a power of two for a map from indices.
 * (3.6.3) */
GLAPI void GLAPIENTRY glPixelMapfv(GLenum map, GLsizei mapsize, const GLfloat *values);
GLAPI void GLAPIENTRY glPixelMapuiv(GLenum map, GLsizei mapsize, const GLuint *values);
GLAPI void GLAPIENTRY glPixelMapusv(GLenum map, GLsizei mapsize, const GLushort *values);

/* Draws width x height pixels of format and type, lowest row first, at the raster position, each as a
 * fragment (or straight into the stencil buffer for GL_STENCIL_INDEX). GL_BITMAP is for GL_COLOR_INDEX and
 * GL_STENCIL_INDEX only (GL_INVALID_ENUM). GL_INVALID_OPERATION: the depth or stencil buffer it needs does
 * not exist. (3.6.4 Rasterization of pixel rectangles) */
GLAPI void GLAPIENTRY glDrawPixels(GLsizei width, GLsizei height, GLenum format, GLenum type,
                                   const void *pixels);

#define GL_ZOOM_X                                  0x0D16
#define GL_ZOOM_Y                                  0x0D17

/* Each pixel drawn by glDrawPixels or glCopyPixels covers xfactor by yfactor pixels; a negative factor
 * mirrors. (3.6.4) */
GLAPI void GLAPIENTRY glPixelZoom(GLfloat xfactor, GLfloat yfactor);


/* ---- 3.6.2, 3.6.3 The imaging subset (ARB_imaging) ----------------------------------------------------- */

/* Enables, targets and properties of color tables. The proxies only test whether a table would fit. */
#define GL_COLOR_TABLE                             0x80D0
#define GL_POST_CONVOLUTION_COLOR_TABLE            0x80D1
#define GL_POST_COLOR_MATRIX_COLOR_TABLE           0x80D2
#define GL_PROXY_COLOR_TABLE                       0x80D3
#define GL_PROXY_POST_CONVOLUTION_COLOR_TABLE      0x80D4
#define GL_PROXY_POST_COLOR_MATRIX_COLOR_TABLE     0x80D5
#define GL_COLOR_TABLE_SCALE                       0x80D6
#define GL_COLOR_TABLE_BIAS                        0x80D7
#define GL_COLOR_TABLE_FORMAT                      0x80D8
#define GL_COLOR_TABLE_WIDTH                       0x80D9
#define GL_COLOR_TABLE_RED_SIZE                    0x80DA
#define GL_COLOR_TABLE_GREEN_SIZE                  0x80DB
#define GL_COLOR_TABLE_BLUE_SIZE                   0x80DC
#define GL_COLOR_TABLE_ALPHA_SIZE                  0x80DD
#define GL_COLOR_TABLE_LUMINANCE_SIZE              0x80DE
#define GL_COLOR_TABLE_INTENSITY_SIZE              0x80DF

/* Sets a table from width pixels. GL_INVALID_VALUE: width is not 0 or a power of two. GL_TABLE_TOO_LARGE. */
GLAPI void GLAPIENTRY glColorTable(GLenum target, GLenum internalformat, GLsizei width, GLenum format,
                                   GLenum type, const void *table);

/* Replaces count entries from start on. GL_INVALID_VALUE: beyond the end of the table. */
GLAPI void GLAPIENTRY glColorSubTable(GLenum target, GLsizei start, GLsizei count, GLenum format, GLenum type,
                                      const void *data);

/* Set GL_COLOR_TABLE_SCALE or GL_COLOR_TABLE_BIAS: four values, applied to the entries when a table is
 * set. */
GLAPI void GLAPIENTRY glColorTableParameterfv(GLenum target, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glColorTableParameteriv(GLenum target, GLenum pname, const GLint *params);

/* The same as the first two with pixels of the read buffer from window position (x, y) on. */
GLAPI void GLAPIENTRY glCopyColorTable(GLenum target, GLenum internalformat, GLint x, GLint y, GLsizei width);
GLAPI void GLAPIENTRY glCopyColorSubTable(GLenum target, GLsizei start, GLint x, GLint y, GLsizei width);

/* Enables, targets and properties of convolution filters. */
#define GL_CONVOLUTION_1D                          0x8010
#define GL_CONVOLUTION_2D                          0x8011
#define GL_SEPARABLE_2D                            0x8012
#define GL_CONVOLUTION_BORDER_MODE                 0x8013
#define GL_CONVOLUTION_FILTER_SCALE                0x8014
#define GL_CONVOLUTION_FILTER_BIAS                 0x8015
#define GL_CONVOLUTION_FORMAT                      0x8017
#define GL_CONVOLUTION_WIDTH                       0x8018
#define GL_CONVOLUTION_HEIGHT                      0x8019
#define GL_CONVOLUTION_BORDER_COLOR                0x8154
#define GL_MAX_CONVOLUTION_WIDTH                   0x801A
#define GL_MAX_CONVOLUTION_HEIGHT                  0x801B
#define GL_REDUCE                                  0x8016
#define GL_CONSTANT_BORDER                         0x8151
#define GL_REPLICATE_BORDER                        0x8153

/* Set a filter from an image; the separable one from a row and a column. GL_INVALID_VALUE: larger than
 * GL_MAX_CONVOLUTION_WIDTH x GL_MAX_CONVOLUTION_HEIGHT. */
GLAPI void GLAPIENTRY glConvolutionFilter1D(GLenum target, GLenum internalformat, GLsizei width,
                                            GLenum format, GLenum type, const void *image);
GLAPI void GLAPIENTRY glConvolutionFilter2D(GLenum target, GLenum internalformat, GLsizei width,
                                            GLsizei height, GLenum format, GLenum type, const void *image);
GLAPI void GLAPIENTRY glSeparableFilter2D(GLenum target, GLenum internalformat, GLsizei width, GLsizei height,
                                          GLenum format, GLenum type, const void *row, const void *column);

/* Set GL_CONVOLUTION_BORDER_MODE of a target: GL_REDUCE (initially), GL_CONSTANT_BORDER or
 * GL_REPLICATE_BORDER. v forms also: GL_CONVOLUTION_BORDER_COLOR, GL_CONVOLUTION_FILTER_SCALE,
 * GL_CONVOLUTION_FILTER_BIAS, four values. */
GLAPI void GLAPIENTRY glConvolutionParameterf(GLenum target, GLenum pname, GLfloat params);
GLAPI void GLAPIENTRY glConvolutionParameterfv(GLenum target, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glConvolutionParameteri(GLenum target, GLenum pname, GLint params);
GLAPI void GLAPIENTRY glConvolutionParameteriv(GLenum target, GLenum pname, const GLint *params);

/* Set a filter from pixels of the read buffer at window position (x, y). */
GLAPI void GLAPIENTRY glCopyConvolutionFilter1D(GLenum target, GLenum internalformat, GLint x, GLint y,
                                                GLsizei width);
GLAPI void GLAPIENTRY glCopyConvolutionFilter2D(GLenum target, GLenum internalformat, GLint x, GLint y,
                                                GLsizei width, GLsizei height);

/* Enables, targets and properties of histogram and minimum/maximum. */
#define GL_HISTOGRAM                               0x8024
#define GL_PROXY_HISTOGRAM                         0x8025
#define GL_HISTOGRAM_WIDTH                         0x8026
#define GL_HISTOGRAM_FORMAT                        0x8027
#define GL_HISTOGRAM_RED_SIZE                      0x8028
#define GL_HISTOGRAM_GREEN_SIZE                    0x8029
#define GL_HISTOGRAM_BLUE_SIZE                     0x802A
#define GL_HISTOGRAM_ALPHA_SIZE                    0x802B
#define GL_HISTOGRAM_LUMINANCE_SIZE                0x802C
#define GL_HISTOGRAM_SINK                          0x802D
#define GL_MINMAX                                  0x802E
#define GL_MINMAX_FORMAT                           0x802F
#define GL_MINMAX_SINK                             0x8030

/* Sets the histogram to width zeroed bins of internalformat; with sink the counted pixels go no further.
 * GL_INVALID_VALUE: width is not 0 or a power of two. GL_TABLE_TOO_LARGE. */
GLAPI void GLAPIENTRY glHistogram(GLenum target, GLsizei width, GLenum internalformat, GLboolean sink);

/* Sets the minimum/maximum table to internalformat and resets it; sink as above. */
GLAPI void GLAPIENTRY glMinmax(GLenum target, GLenum internalformat, GLboolean sink);

/* Set all counts to 0; make the minima the largest and the maxima the smallest values. */
GLAPI void GLAPIENTRY glResetHistogram(GLenum target);
GLAPI void GLAPIENTRY glResetMinmax(GLenum target);

/* Read a table, filter, histogram (set to 0 afterwards if reset) or minimum/maximum (likewise) as pixels of
 * format and type, and their properties. (6.1.7 to 6.1.10) */
GLAPI void GLAPIENTRY glGetColorTable(GLenum target, GLenum format, GLenum type, void *table);
GLAPI void GLAPIENTRY glGetColorTableParameterfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetColorTableParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetConvolutionFilter(GLenum target, GLenum format, GLenum type, void *image);
GLAPI void GLAPIENTRY glGetSeparableFilter(GLenum target, GLenum format, GLenum type, void *row, void *column,
                                           void *span);
GLAPI void GLAPIENTRY glGetConvolutionParameterfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetConvolutionParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetHistogram(GLenum target, GLboolean reset, GLenum format, GLenum type,
                                     void *values);
GLAPI void GLAPIENTRY glGetHistogramParameterfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetHistogramParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetMinmax(GLenum target, GLboolean reset, GLenum format, GLenum type, void *values);
GLAPI void GLAPIENTRY glGetMinmaxParameterfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetMinmaxParameteriv(GLenum target, GLenum pname, GLint *params);


/* ---- 3.7 Bitmaps --------------------------------------------------------------------------------------- */

/* Draws a fragment of the current raster color for every bit set in width x height bits, lowest row first,
 * each row padded to GL_UNPACK_ALIGNMENT. (xorig, yorig) is the point of the bitmap that lies at the raster
 * position; (xmove, ymove), in pixels, is added to the position afterwards. */
GLAPI void GLAPIENTRY glBitmap(GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove,
                               GLfloat ymove, const GLubyte *bitmap);


/* ---- 3.8 Texturing ------------------------------------------------------------------------------------- */

/* Texture targets, most of them enables too, and limits. */
#define GL_TEXTURE_1D                              0x0DE0
#define GL_TEXTURE_2D                              0x0DE1
#define GL_TEXTURE_3D                              0x806F
#define GL_TEXTURE_CUBE_MAP                        0x8513
#define GL_TEXTURE_CUBE_MAP_POSITIVE_X             0x8515
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Y             0x8517
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Z             0x8519
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_X             0x8516
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Y             0x8518
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Z             0x851A
#define GL_PROXY_TEXTURE_1D                        0x8063
#define GL_PROXY_TEXTURE_2D                        0x8064
#define GL_PROXY_TEXTURE_3D                        0x8070
#define GL_PROXY_TEXTURE_CUBE_MAP                  0x851B
#define GL_TEXTURE_BINDING_1D                      0x8068
#define GL_TEXTURE_BINDING_2D                      0x8069
#define GL_TEXTURE_BINDING_3D                      0x806A
#define GL_TEXTURE_BINDING_CUBE_MAP                0x8514
#define GL_MAX_TEXTURE_SIZE                        0x0D33
#define GL_MAX_3D_TEXTURE_SIZE                     0x8073
#define GL_MAX_CUBE_MAP_TEXTURE_SIZE               0x851C
#define GL_MAX_TEXTURE_UNITS                       0x84E2
#define GL_MAX_TEXTURE_LOD_BIAS                    0x84FD
#define GL_ACTIVE_TEXTURE                          0x84E0

/* Sized internal formats (tables 3.15 to 3.17); the base ones are among the pixel formats above. */
#define GL_ALPHA4                                  0x803B
#define GL_ALPHA8                                  0x803C
#define GL_ALPHA12                                 0x803D
#define GL_ALPHA16                                 0x803E
#define GL_LUMINANCE4                              0x803F
#define GL_LUMINANCE8                              0x8040
#define GL_LUMINANCE12                             0x8041
#define GL_LUMINANCE16                             0x8042
#define GL_LUMINANCE4_ALPHA4                       0x8043
#define GL_LUMINANCE6_ALPHA2                       0x8044
#define GL_LUMINANCE8_ALPHA8                       0x8045
#define GL_LUMINANCE12_ALPHA4                      0x8046
#define GL_LUMINANCE12_ALPHA12                     0x8047
#define GL_LUMINANCE16_ALPHA16                     0x8048
#define GL_INTENSITY                               0x8049
#define GL_INTENSITY4                              0x804A
#define GL_INTENSITY8                              0x804B
#define GL_INTENSITY12                             0x804C
#define GL_INTENSITY16                             0x804D
#define GL_R3_G3_B2                                0x2A10
#define GL_RGB4                                    0x804F
#define GL_RGB5                                    0x8050
#define GL_RGB8                                    0x8051
#define GL_RGB10                                   0x8052
#define GL_RGB12                                   0x8053
#define GL_RGB16                                   0x8054
#define GL_RGBA2                                   0x8055
#define GL_RGBA4                                   0x8056
#define GL_RGB5_A1                                 0x8057
#define GL_RGBA8                                   0x8058
#define GL_RGB10_A2                                0x8059
#define GL_RGBA12                                  0x805A
#define GL_RGBA16                                  0x805B
#define GL_DEPTH_COMPONENT16                       0x81A5
#define GL_DEPTH_COMPONENT24                       0x81A6
#define GL_DEPTH_COMPONENT32                       0x81A7
#define GL_COMPRESSED_ALPHA                        0x84E9
#define GL_COMPRESSED_LUMINANCE                    0x84EA
#define GL_COMPRESSED_LUMINANCE_ALPHA              0x84EB
#define GL_COMPRESSED_INTENSITY                    0x84EC
#define GL_COMPRESSED_RGB                          0x84ED
#define GL_COMPRESSED_RGBA                         0x84EE
#define GL_TEXTURE_COMPRESSION_HINT                0x84EF
#define GL_NUM_COMPRESSED_TEXTURE_FORMATS          0x86A2
#define GL_COMPRESSED_TEXTURE_FORMATS              0x86A3

/* Set image level of the texture bound to target (or test whether it would fit, for a GL_PROXY_ target) from
 * pixels of format and type, lowest row first; pixels may be NULL: the contents are undefined. Sizes are 2^k
 * + 2 * border texels, border 0 or 1. GL_INVALID_VALUE: another size or border, a level out of range, an
 * internalformat that is none. GL_INVALID_OPERATION: internalformat and format disagree about depth. (3.8.1
 * Texture image specification; the 3D one since 1.2) */
GLAPI void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint internalformat, GLsizei width,
                                   GLint border, GLenum format, GLenum type, const void *pixels);
GLAPI void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width,
                                   GLsizei height, GLint border, GLenum format, GLenum type,
                                   const void *pixels);
GLAPI void GLAPIENTRY glTexImage3D(GLenum target, GLint level, GLint internalformat, GLsizei width,
                                   GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                                   const void *pixels);

/* The same, one- and two-dimensional, with pixels of the read buffer at window position (x, y). (3.8.2
 * Alternate texture image specification commands, here and the next two) */
GLAPI void GLAPIENTRY glCopyTexImage1D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                                       GLsizei width, GLint border);
GLAPI void GLAPIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                                       GLsizei width, GLsizei height, GLint border);

/* Replace the part of an image that begins at the given offsets. GL_INVALID_VALUE: beyond the image.
 * GL_INVALID_OPERATION: there is no such image. */
GLAPI void GLAPIENTRY glTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                                      GLenum type, const void *pixels);
GLAPI void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                                      GLsizei height, GLenum format, GLenum type, const void *pixels);
GLAPI void GLAPIENTRY glTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                                      GLsizei width, GLsizei height, GLsizei depth, GLenum format,
                                      GLenum type, const void *pixels);

/* The same with pixels of the read buffer at window position (x, y). */
GLAPI void GLAPIENTRY glCopyTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                                          GLsizei width);
GLAPI void GLAPIENTRY glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                                          GLint y, GLsizei width, GLsizei height);
GLAPI void GLAPIENTRY glCopyTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                          GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);

/* Set an image, or a part of one, from data in a compressed internalformat, imageSize bytes.
 * GL_INVALID_VALUE: imageSize does not fit the format and size. (3.8.3 Compressed texture images;
 * since 1.3) */
GLAPI void GLAPIENTRY glCompressedTexImage3D(GLenum target, GLint level, GLenum internalformat, GLsizei width,
                                             GLsizei height, GLsizei depth, GLint border, GLsizei imageSize,
                                             const void *data);
GLAPI void GLAPIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat, GLsizei width,
                                             GLsizei height, GLint border, GLsizei imageSize,
                                             const void *data);
GLAPI void GLAPIENTRY glCompressedTexImage1D(GLenum target, GLint level, GLenum internalformat, GLsizei width,
                                             GLint border, GLsizei imageSize, const void *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                                GLint zoffset, GLsizei width, GLsizei height, GLsizei depth,
                                                GLenum format, GLsizei imageSize, const void *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset,
                                                GLsizei width, GLsizei height, GLenum format,
                                                GLsizei imageSize, const void *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width,
                                                GLenum format, GLsizei imageSize, const void *data);

/* Parameters of a texture and their values (table 3.19). */
#define GL_TEXTURE_WRAP_S                          0x2802
#define GL_TEXTURE_WRAP_T                          0x2803
#define GL_TEXTURE_WRAP_R                          0x8072
#define GL_CLAMP                                   0x2900
#define GL_REPEAT                                  0x2901
#define GL_CLAMP_TO_EDGE                           0x812F
#define GL_CLAMP_TO_BORDER                         0x812D
#define GL_MIRRORED_REPEAT                         0x8370
#define GL_TEXTURE_MIN_FILTER                      0x2801
#define GL_TEXTURE_MAG_FILTER                      0x2800
#define GL_NEAREST                                 0x2600
#define GL_LINEAR                                  0x2601
#define GL_NEAREST_MIPMAP_NEAREST                  0x2700
#define GL_LINEAR_MIPMAP_NEAREST                   0x2701
#define GL_NEAREST_MIPMAP_LINEAR                   0x2702
#define GL_LINEAR_MIPMAP_LINEAR                    0x2703
#define GL_TEXTURE_BORDER_COLOR                    0x1004
#define GL_TEXTURE_PRIORITY                        0x8066
#define GL_TEXTURE_MIN_LOD                         0x813A
#define GL_TEXTURE_MAX_LOD                         0x813B
#define GL_TEXTURE_BASE_LEVEL                      0x813C
#define GL_TEXTURE_MAX_LEVEL                       0x813D
#define GL_GENERATE_MIPMAP                         0x8191
#define GL_DEPTH_TEXTURE_MODE                      0x884B
#define GL_TEXTURE_COMPARE_MODE                    0x884C
#define GL_TEXTURE_COMPARE_FUNC                    0x884D
#define GL_COMPARE_R_TO_TEXTURE                    0x884E

/* Set a parameter of the texture bound to target: the wrap modes, the two filters, the priority in [0,1], the
 * levels and limits of 1.2, automatic mipmaps, depth mode and comparison of 1.4; v forms also
 * GL_TEXTURE_BORDER_COLOR, RGBA. GL_INVALID_VALUE: a negative level. (3.8.4 Texture parameters) */
GLAPI void GLAPIENTRY glTexParameterf(GLenum target, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexParameterfv(GLenum target, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glTexParameteri(GLenum target, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexParameteriv(GLenum target, GLenum pname, const GLint *params);

/* Properties of one image, for glGetTexLevelParameter (3.8.11), and of the texture. */
#define GL_TEXTURE_WIDTH                           0x1000
#define GL_TEXTURE_HEIGHT                          0x1001
#define GL_TEXTURE_DEPTH                           0x8071
#define GL_TEXTURE_BORDER                          0x1005
#define GL_TEXTURE_INTERNAL_FORMAT                 0x1003
#define GL_TEXTURE_COMPONENTS                      0x1003
#define GL_TEXTURE_RED_SIZE                        0x805C
#define GL_TEXTURE_GREEN_SIZE                      0x805D
#define GL_TEXTURE_BLUE_SIZE                       0x805E
#define GL_TEXTURE_ALPHA_SIZE                      0x805F
#define GL_TEXTURE_LUMINANCE_SIZE                  0x8060
#define GL_TEXTURE_INTENSITY_SIZE                  0x8061
#define GL_TEXTURE_DEPTH_SIZE                      0x884A
#define GL_TEXTURE_COMPRESSED_IMAGE_SIZE           0x86A0
#define GL_TEXTURE_COMPRESSED                      0x86A1
#define GL_TEXTURE_RESIDENT                        0x8067

/* Makes texture the one that target and the active unit use; a new name becomes a texture of that target, 0
 * is the default texture. GL_INVALID_OPERATION: the texture has another target. (3.8.12 Texture objects, here
 * and the next four) */
GLAPI void GLAPIENTRY glBindTexture(GLenum target, GLuint texture);

/* Deletes n textures; where one is bound, 0 takes its place. 0 and unused names are skipped. */
GLAPI void GLAPIENTRY glDeleteTextures(GLsizei n, const GLuint *textures);

/* Writes n unused names to textures and reserves them. */
GLAPI void GLAPIENTRY glGenTextures(GLsizei n, GLuint *textures);

/* Returns GL_TRUE if all n textures are resident; otherwise GL_FALSE with the answers in residences.
 * GL_INVALID_VALUE: a name is 0 or not that of a texture. */
GLAPI GLboolean GLAPIENTRY glAreTexturesResident(GLsizei n, const GLuint *textures, GLboolean *residences);

/* Sets the priorities, clamped to [0,1], of n textures. 0 and unused names are skipped. */
GLAPI void GLAPIENTRY glPrioritizeTextures(GLsizei n, const GLuint *textures, const GLfloat *priorities);

/* Returns whether texture is the name of a texture: generated and bound at least once. (6.1.4) */
GLAPI GLboolean GLAPIENTRY glIsTexture(GLuint texture);

/* Parameters and values of texture environments (tables 3.21 to 3.25). SRCn is 1.5's name for SOURCEn. */
#define GL_TEXTURE_ENV                             0x2300
#define GL_TEXTURE_ENV_MODE                        0x2200
#define GL_TEXTURE_ENV_COLOR                       0x2201
#define GL_MODULATE                                0x2100
#define GL_DECAL                                   0x2101
#define GL_REPLACE                                 0x1E01
#define GL_ADD                                     0x0104
#define GL_COMBINE                                 0x8570
#define GL_TEXTURE_FILTER_CONTROL                  0x8500
#define GL_TEXTURE_LOD_BIAS                        0x8501
#define GL_COMBINE_RGB                             0x8571
#define GL_COMBINE_ALPHA                           0x8572
#define GL_ADD_SIGNED                              0x8574
#define GL_INTERPOLATE                             0x8575
#define GL_SUBTRACT                                0x84E7
#define GL_DOT3_RGB                                0x86AE
#define GL_DOT3_RGBA                               0x86AF
#define GL_RGB_SCALE                               0x8573
#define GL_SOURCE0_RGB                             0x8580
#define GL_SOURCE1_RGB                             0x8581
#define GL_SOURCE2_RGB                             0x8582
#define GL_SOURCE0_ALPHA                           0x8588
#define GL_SOURCE1_ALPHA                           0x8589
#define GL_SOURCE2_ALPHA                           0x858A
#define GL_SRC0_RGB                                0x8580
#define GL_SRC1_RGB                                0x8581
#define GL_SRC2_RGB                                0x8582
#define GL_SRC0_ALPHA                              0x8588
#define GL_SRC1_ALPHA                              0x8589
#define GL_SRC2_ALPHA                              0x858A
#define GL_OPERAND0_RGB                            0x8590
#define GL_OPERAND1_RGB                            0x8591
#define GL_OPERAND2_RGB                            0x8592
#define GL_OPERAND0_ALPHA                          0x8598
#define GL_OPERAND1_ALPHA                          0x8599
#define GL_OPERAND2_ALPHA                          0x859A
#define GL_CONSTANT                                0x8576
#define GL_PRIMARY_COLOR                           0x8577
#define GL_PREVIOUS                                0x8578

/* Set, for the active unit, how texture color meets fragment color. target GL_TEXTURE_ENV:
 * GL_TEXTURE_ENV_MODE is GL_MODULATE (initially), GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD or GL_COMBINE, with
 * the GL_COMBINE parameters of 1.3; v forms also GL_TEXTURE_ENV_COLOR, RGBA. target
 * GL_TEXTURE_FILTER_CONTROL: GL_TEXTURE_LOD_BIAS (1.4). GL_INVALID_VALUE: GL_RGB_SCALE or GL_ALPHA_SCALE is
 * not 1, 2 or 4. (3.8.13 Texture environments and texture functions) */
GLAPI void GLAPIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexEnvfv(GLenum target, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint *params);


/* ---- 3.9 Color sum ------------------------------------------------------------------------------------- */

/* An enable: add the secondary color after texturing, without lighting too (1.4). */
#define GL_COLOR_SUM                               0x8458


/* ---- 3.10 Fog ------------------------------------------------------------------------------------------ */

/* GL_FOG is an enable. */
#define GL_FOG                                     0x0B60
#define GL_FOG_MODE                                0x0B65
#define GL_FOG_DENSITY                             0x0B62
#define GL_FOG_START                               0x0B63
#define GL_FOG_END                                 0x0B64
#define GL_FOG_COLOR                               0x0B66
#define GL_FOG_INDEX                               0x0B61
#define GL_EXP                                     0x0800
#define GL_EXP2                                    0x0801
#define GL_FOG_COORDINATE_SOURCE                   0x8450
#define GL_FOG_COORD_SRC                           0x8450
#define GL_FOG_COORDINATE                          0x8451
#define GL_FOG_COORD                               0x8451
#define GL_FRAGMENT_DEPTH                          0x8452

/* Set a parameter of fog: GL_FOG_MODE GL_EXP (initially), GL_EXP2 or GL_LINEAR; GL_FOG_DENSITY for the
 * exponential modes; GL_FOG_START and GL_FOG_END, eye distances, for GL_LINEAR; GL_FOG_INDEX;
 * GL_FOG_COORD_SRC GL_FRAGMENT_DEPTH or GL_FOG_COORD (1.4). v forms also GL_FOG_COLOR, RGBA.
 * GL_INVALID_VALUE: negative density. */
GLAPI void GLAPIENTRY glFogf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glFogfv(GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glFogi(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glFogiv(GLenum pname, const GLint *params);


/* ---- 4.1 Per-fragment operations ----------------------------------------------------------------------- */

/* GL_SCISSOR_TEST is an enable. */
#define GL_SCISSOR_TEST                            0x0C11
#define GL_SCISSOR_BOX                             0x0C10

/* Only pixels of the rectangle with lower left corner (x, y), in the window, are written while
 * GL_SCISSOR_TEST is enabled. (4.1.2) */
GLAPI void GLAPIENTRY glScissor(GLint x, GLint y, GLsizei width, GLsizei height);

/* The first four are enables. */
#define GL_MULTISAMPLE                             0x809D
#define GL_SAMPLE_ALPHA_TO_COVERAGE                0x809E
#define GL_SAMPLE_ALPHA_TO_ONE                     0x809F
#define GL_SAMPLE_COVERAGE                         0x80A0
#define GL_SAMPLE_COVERAGE_VALUE                   0x80AA
#define GL_SAMPLE_COVERAGE_INVERT                  0x80AB
#define GL_SAMPLE_BUFFERS                          0x80A8
#define GL_SAMPLES                                 0x80A9

/* Sets the share of samples, clamped to [0,1], that GL_SAMPLE_COVERAGE keeps; invert keeps the others.
 * Without effect on a buffer without samples. (4.1.3; since 1.3) */
GLAPI void GLAPIENTRY glSampleCoverage(GLfloat value, GLboolean invert);

/* GL_ALPHA_TEST is an enable. */
#define GL_ALPHA_TEST                              0x0BC0
#define GL_ALPHA_TEST_FUNC                         0x0BC1
#define GL_ALPHA_TEST_REF                          0x0BC2

/* A fragment passes if its alpha compares so with ref, clamped to [0,1]. Initially GL_ALWAYS, 0. (4.1.4) */
GLAPI void GLAPIENTRY glAlphaFunc(GLenum func, GLfloat ref);

/* GL_STENCIL_TEST is an enable. */
#define GL_STENCIL_TEST                            0x0B90
#define GL_STENCIL_FUNC                            0x0B92
#define GL_STENCIL_VALUE_MASK                      0x0B93
#define GL_STENCIL_REF                             0x0B97
#define GL_STENCIL_FAIL                            0x0B94
#define GL_STENCIL_PASS_DEPTH_FAIL                 0x0B95
#define GL_STENCIL_PASS_DEPTH_PASS                 0x0B96
#define GL_KEEP                                    0x1E00
#define GL_INCR                                    0x1E02
#define GL_DECR                                    0x1E03
#define GL_INCR_WRAP                               0x8507
#define GL_DECR_WRAP                               0x8508

/* A fragment passes if (ref & mask) compares so with (stencil & mask); ref is clamped to [0, 2^bits - 1].
 * Initially GL_ALWAYS, 0, all ones. (4.1.5) */
GLAPI void GLAPIENTRY glStencilFunc(GLenum func, GLint ref, GLuint mask);

/* Say what becomes of the stencil value when the stencil test fails, when the depth test fails, and when both
 * pass: GL_KEEP (initially), GL_ZERO, GL_REPLACE by ref, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP or
 * GL_DECR_WRAP (1.4). (4.1.5) */
GLAPI void GLAPIENTRY glStencilOp(GLenum fail, GLenum zfail, GLenum zpass);

/* GL_DEPTH_TEST is an enable. */
#define GL_DEPTH_TEST                              0x0B71
#define GL_DEPTH_FUNC                              0x0B74

/* A fragment passes if its depth compares so with the stored one. Initially GL_LESS. (4.1.6) */
GLAPI void GLAPIENTRY glDepthFunc(GLenum func);

/* Occlusion queries (4.1.7; since 1.5, the functions are in GL/glext.h). */
#define GL_SAMPLES_PASSED                          0x8914
#define GL_QUERY_COUNTER_BITS                      0x8864
#define GL_CURRENT_QUERY                           0x8865
#define GL_QUERY_RESULT                            0x8866
#define GL_QUERY_RESULT_AVAILABLE                  0x8867

/* GL_BLEND is an enable (and a texture environment mode). */
#define GL_BLEND                                   0x0BE2
#define GL_BLEND_SRC                               0x0BE1
#define GL_BLEND_DST                               0x0BE0
#define GL_BLEND_SRC_RGB                           0x80C9
#define GL_BLEND_DST_RGB                           0x80C8
#define GL_BLEND_SRC_ALPHA                         0x80CB
#define GL_BLEND_DST_ALPHA                         0x80CA
#define GL_BLEND_COLOR                             0x8005
#define GL_BLEND_EQUATION                          0x8009
#define GL_ZERO                                    0
#define GL_ONE                                     1
#define GL_SRC_COLOR                               0x0300
#define GL_ONE_MINUS_SRC_COLOR                     0x0301
#define GL_SRC_ALPHA                               0x0302
#define GL_ONE_MINUS_SRC_ALPHA                     0x0303
#define GL_DST_ALPHA                               0x0304
#define GL_ONE_MINUS_DST_ALPHA                     0x0305
#define GL_DST_COLOR                               0x0306
#define GL_ONE_MINUS_DST_COLOR                     0x0307
#define GL_SRC_ALPHA_SATURATE                      0x0308
#define GL_CONSTANT_COLOR                          0x8001
#define GL_ONE_MINUS_CONSTANT_COLOR                0x8002
#define GL_CONSTANT_ALPHA                          0x8003
#define GL_ONE_MINUS_CONSTANT_ALPHA                0x8004
#define GL_FUNC_ADD                                0x8006
#define GL_MIN                                     0x8007
#define GL_MAX                                     0x8008
#define GL_FUNC_SUBTRACT                           0x800A
#define GL_FUNC_REVERSE_SUBTRACT                   0x800B

/* Set the factors of the fragment's and of the stored color; GL_SRC_ALPHA_SATURATE is for the fragment's
 * only. Initially GL_ONE, GL_ZERO. (4.1.8 Blending) */
GLAPI void GLAPIENTRY glBlendFunc(GLenum sfactor, GLenum dfactor);

/* Sets how the two products are joined; GL_MIN and GL_MAX use the colors without factors. Initially
 * GL_FUNC_ADD. (4.1.8; in the imaging subset, since 1.4 for all) */
GLAPI void GLAPIENTRY glBlendEquation(GLenum mode);

/* Sets the color, clamped to [0,1], of the GL_CONSTANT_ factors. (4.1.8; as glBlendEquation) */
GLAPI void GLAPIENTRY glBlendColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);

/* An enable, initially on (4.1.9). */
#define GL_DITHER                                  0x0BD0

/* GL_COLOR_LOGIC_OP and GL_INDEX_LOGIC_OP, of which GL_LOGIC_OP is the older name, are enables. */
#define GL_LOGIC_OP                                0x0BF1
#define GL_INDEX_LOGIC_OP                          0x0BF1
#define GL_COLOR_LOGIC_OP                          0x0BF2
#define GL_LOGIC_OP_MODE                           0x0BF0
#define GL_CLEAR                                   0x1500
#define GL_AND                                     0x1501
#define GL_AND_REVERSE                             0x1502
#define GL_COPY                                    0x1503
#define GL_AND_INVERTED                            0x1504
#define GL_NOOP                                    0x1505
#define GL_XOR                                     0x1506
#define GL_OR                                      0x1507
#define GL_NOR                                     0x1508
#define GL_EQUIV                                   0x1509
#define GL_INVERT                                  0x150A
#define GL_OR_REVERSE                              0x150B
#define GL_COPY_INVERTED                           0x150C
#define GL_OR_INVERTED                             0x150D
#define GL_NAND                                    0x150E
#define GL_SET                                     0x150F

/* Sets the bitwise operation of fragment and stored values, one of the sixteen above; while it is enabled for
 * color there is no blending. Initially GL_COPY. (4.1.10 Logical operation) */
GLAPI void GLAPIENTRY glLogicOp(GLenum opcode);


/* ---- 4.2 Whole framebuffer operations ------------------------------------------------------------------ */

#define GL_FRONT_LEFT                              0x0400
#define GL_FRONT_RIGHT                             0x0401
#define GL_BACK_LEFT                               0x0402
#define GL_BACK_RIGHT                              0x0403
#define GL_LEFT                                    0x0406
#define GL_RIGHT                                   0x0407
#define GL_AUX0                                    0x0409
#define GL_AUX1                                    0x040A
#define GL_AUX2                                    0x040B
#define GL_AUX3                                    0x040C
#define GL_DRAW_BUFFER                             0x0C01
#define GL_READ_BUFFER                             0x0C02
#define GL_INDEX_WRITEMASK                         0x0C21
#define GL_COLOR_WRITEMASK                         0x0C23
#define GL_DEPTH_WRITEMASK                         0x0B72
#define GL_STENCIL_WRITEMASK                       0x0B98
#define GL_COLOR_CLEAR_VALUE                       0x0C22
#define GL_INDEX_CLEAR_VALUE                       0x0C20
#define GL_DEPTH_CLEAR_VALUE                       0x0B73
#define GL_STENCIL_CLEAR_VALUE                     0x0B91
#define GL_ACCUM_CLEAR_VALUE                       0x0B80

/* Selects the color buffers that are written. GL_INVALID_OPERATION: none of them exists. (4.2.1) */
GLAPI void GLAPIENTRY glDrawBuffer(GLenum buf);

/* Set which bits of a color index, which color components, whether depth, and which bits of the stencil value
 * may be written, by clearing too. Initially all. (4.2.2 Fine control of buffer updates) */
GLAPI void GLAPIENTRY glIndexMask(GLuint mask);
GLAPI void GLAPIENTRY glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
GLAPI void GLAPIENTRY glDepthMask(GLboolean flag);
GLAPI void GLAPIENTRY glStencilMask(GLuint mask);

/* Clears the buffers of the bits in mask (GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT and
 * GL_ACCUM_BUFFER_BIT, 6.1.14) within the scissor rectangle. GL_INVALID_VALUE: any other bit. (4.2.3 Clearing
 * the buffers) */
GLAPI void GLAPIENTRY glClear(GLbitfield mask);

/* Set the values to clear to: a color clamped to [0,1]; a color index; a depth clamped to [0,1], initially 1;
 * a stencil value, of which the low bits count; an accumulation color clamped to [-1,1]. (4.2.3) */
GLAPI void GLAPIENTRY glClearColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
GLAPI void GLAPIENTRY glClearIndex(GLfloat c);
GLAPI void GLAPIENTRY glClearDepth(GLdouble depth);
GLAPI void GLAPIENTRY glClearStencil(GLint s);
GLAPI void GLAPIENTRY glClearAccum(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);

#define GL_ACCUM                                   0x0100
#define GL_LOAD                                    0x0101
#define GL_RETURN                                  0x0102
#define GL_MULT                                    0x0103

/* GL_ACCUM adds value times the read buffer to the accumulation buffer, GL_LOAD stores it there, GL_ADD adds
 * value, GL_MULT multiplies by it, and GL_RETURN writes value times the accumulation buffer, clamped to
 * [0,1], to the color buffer. GL_INVALID_OPERATION: there is no accumulation buffer. (4.2.4) */
GLAPI void GLAPIENTRY glAccum(GLenum op, GLfloat value);


/* ---- 4.3 Drawing, reading and copying pixels ----------------------------------------------------------- */

/* Selects the color buffer that is read. GL_INVALID_OPERATION: it does not exist. (4.3.2) */
GLAPI void GLAPIENTRY glReadBuffer(GLenum src);

/* Writes width x height pixels from window position (x, y) on to pixels as format and type, lowest row first,
 * laid out by the GL_PACK_ modes. GL_INVALID_OPERATION: the depth or stencil buffer asked for does not exist.
 * (4.3.2) */
GLAPI void GLAPIENTRY glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                   GLenum type, void *pixels);

#define GL_DEPTH                                   0x1801
#define GL_STENCIL                                 0x1802

/* Draws what glReadPixels would read at (x, y), GL_COLOR, GL_DEPTH or GL_STENCIL by type, at the raster
 * position. GL_INVALID_OPERATION: the buffer does not exist. (4.3.3) */
GLAPI void GLAPIENTRY glCopyPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);


/* ---- 5.1 Evaluators ------------------------------------------------------------------------------------ */

/* Enables, and targets of glMap. */
#define GL_AUTO_NORMAL                             0x0D80
#define GL_MAP1_COLOR_4                            0x0D90
#define GL_MAP1_INDEX                              0x0D91
#define GL_MAP1_NORMAL                             0x0D92
#define GL_MAP1_TEXTURE_COORD_1                    0x0D93
#define GL_MAP1_TEXTURE_COORD_2                    0x0D94
#define GL_MAP1_TEXTURE_COORD_3                    0x0D95
#define GL_MAP1_TEXTURE_COORD_4                    0x0D96
#define GL_MAP1_VERTEX_3                           0x0D97
#define GL_MAP1_VERTEX_4                           0x0D98
#define GL_MAP2_COLOR_4                            0x0DB0
#define GL_MAP2_INDEX                              0x0DB1
#define GL_MAP2_NORMAL                             0x0DB2
#define GL_MAP2_TEXTURE_COORD_1                    0x0DB3
#define GL_MAP2_TEXTURE_COORD_2                    0x0DB4
#define GL_MAP2_TEXTURE_COORD_3                    0x0DB5
#define GL_MAP2_TEXTURE_COORD_4                    0x0DB6
#define GL_MAP2_VERTEX_3                           0x0DB7
#define GL_MAP2_VERTEX_4                           0x0DB8

/* State, for glGet and glGetMap. */
#define GL_MAP1_GRID_DOMAIN                        0x0DD0
#define GL_MAP1_GRID_SEGMENTS                      0x0DD1
#define GL_MAP2_GRID_DOMAIN                        0x0DD2
#define GL_MAP2_GRID_SEGMENTS                      0x0DD3
#define GL_COEFF                                   0x0A00
#define GL_ORDER                                   0x0A01
#define GL_DOMAIN                                  0x0A02
#define GL_MAX_EVAL_ORDER                          0x0D30

/* Set a Bezier curve or surface of order (degree + 1) control points over [u1,u2] (and [v1,v2]); a stride is
 * the distance of neighboring points in values. GL_INVALID_VALUE: an empty domain, an order not in [1,
 * GL_MAX_EVAL_ORDER], a stride below the size of a point. GL_INVALID_OPERATION: the active unit is not
 * GL_TEXTURE0. */
GLAPI void GLAPIENTRY glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                              const GLdouble *points);
GLAPI void GLAPIENTRY glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                              const GLfloat *points);
GLAPI void GLAPIENTRY glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                              GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble *points);
GLAPI void GLAPIENTRY glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
                              GLfloat v2, GLint vstride, GLint vorder, const GLfloat *points);

/* Send the vertex, color, normal and texture coordinates of the enabled maps at u or (u, v); the current
 * values stay as they are. */
GLAPI void GLAPIENTRY glEvalCoord1d(GLdouble u);
GLAPI void GLAPIENTRY glEvalCoord1dv(const GLdouble *u);
GLAPI void GLAPIENTRY glEvalCoord1f(GLfloat u);
GLAPI void GLAPIENTRY glEvalCoord1fv(const GLfloat *u);
GLAPI void GLAPIENTRY glEvalCoord2d(GLdouble u, GLdouble v);
GLAPI void GLAPIENTRY glEvalCoord2dv(const GLdouble *u);
GLAPI void GLAPIENTRY glEvalCoord2f(GLfloat u, GLfloat v);
GLAPI void GLAPIENTRY glEvalCoord2fv(const GLfloat *u);

/* Set the grid: un (and vn) equal steps from u1 to u2 (v1 to v2). GL_INVALID_VALUE: a number of steps
 * <= 0. */
GLAPI void GLAPIENTRY glMapGrid1d(GLint un, GLdouble u1, GLdouble u2);
GLAPI void GLAPIENTRY glMapGrid1f(GLint un, GLfloat u1, GLfloat u2);
GLAPI void GLAPIENTRY glMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2);
GLAPI void GLAPIENTRY glMapGrid2f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2);

/* Evaluate the grid points i1..i2 (by j1..j2) and draw them as mode: GL_POINT, GL_LINE or, in two dimensions,
 * GL_FILL. */
GLAPI void GLAPIENTRY glEvalMesh1(GLenum mode, GLint i1, GLint i2);
GLAPI void GLAPIENTRY glEvalMesh2(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);

/* Evaluate one grid point. */
GLAPI void GLAPIENTRY glEvalPoint1(GLint i);
GLAPI void GLAPIENTRY glEvalPoint2(GLint i, GLint j);


/* ---- 5.2 Selection ------------------------------------------------------------------------------------- */

#define GL_RENDER_MODE                             0x0C40
#define GL_RENDER                                  0x1C00
#define GL_FEEDBACK                                0x1C01
#define GL_SELECT                                  0x1C02
#define GL_SELECTION_BUFFER_POINTER                0x0DF3
#define GL_SELECTION_BUFFER_SIZE                   0x0DF4
#define GL_NAME_STACK_DEPTH                        0x0D70
#define GL_MAX_NAME_STACK_DEPTH                    0x0D37

/* Empties the name stack. This and the next three do nothing outside GL_SELECT mode. */
GLAPI void GLAPIENTRY glInitNames(void);

/* Take the top name off, or put name on, the stack. GL_STACK_UNDERFLOW, GL_STACK_OVERFLOW. */
GLAPI void GLAPIENTRY glPopName(void);
GLAPI void GLAPIENTRY glPushName(GLuint name);

/* Replaces the top name. GL_INVALID_OPERATION: the stack is empty. */
GLAPI void GLAPIENTRY glLoadName(GLuint name);

/* Switches between drawing (GL_RENDER, initially), selection and feedback. Returns the number of hits or of
 * feedback values of the mode that ends, -1 if its buffer overflowed, 0 for GL_RENDER. GL_INVALID_OPERATION:
 * the buffer of the new mode was never set. */
GLAPI GLint GLAPIENTRY glRenderMode(GLenum mode);

/* Sets the array of size values that gets the hit records: number of names, least and greatest depth times
 * 2^32 - 1, the names from the bottom up. GL_INVALID_OPERATION: in GL_SELECT mode. */
GLAPI void GLAPIENTRY glSelectBuffer(GLsizei size, GLuint *buffer);


/* ---- 5.3 Feedback -------------------------------------------------------------------------------------- */

/* What is written per vertex, and the tokens before each primitive (table 5.2). */
#define GL_2D                                      0x0600
#define GL_3D                                      0x0601
#define GL_3D_COLOR                                0x0602
#define GL_3D_COLOR_TEXTURE                        0x0603
#define GL_4D_COLOR_TEXTURE                        0x0604
#define GL_PASS_THROUGH_TOKEN                      0x0700
#define GL_POINT_TOKEN                             0x0701
#define GL_LINE_TOKEN                              0x0702
#define GL_POLYGON_TOKEN                           0x0703
#define GL_BITMAP_TOKEN                            0x0704
#define GL_DRAW_PIXEL_TOKEN                        0x0705
#define GL_COPY_PIXEL_TOKEN                        0x0706
#define GL_LINE_RESET_TOKEN                        0x0707
#define GL_FEEDBACK_BUFFER_POINTER                 0x0DF0
#define GL_FEEDBACK_BUFFER_SIZE                    0x0DF1
#define GL_FEEDBACK_BUFFER_TYPE                    0x0DF2

/* Sets the array of size values that gets the primitives in window coordinates, and what of each vertex.
 * GL_INVALID_OPERATION: in GL_FEEDBACK mode. */
GLAPI void GLAPIENTRY glFeedbackBuffer(GLsizei size, GLenum type, GLfloat *buffer);

/* Writes GL_PASS_THROUGH_TOKEN and token in GL_FEEDBACK mode; otherwise nothing. */
GLAPI void GLAPIENTRY glPassThrough(GLfloat token);


/* ---- 5.4 Display lists --------------------------------------------------------------------------------- */

#define GL_COMPILE                                 0x1300
#define GL_COMPILE_AND_EXECUTE                     0x1301
#define GL_LIST_MODE                               0x0B30
#define GL_LIST_BASE                               0x0B32
#define GL_LIST_INDEX                              0x0B33
#define GL_MAX_LIST_NESTING                        0x0B31

/* Starts list; commands are put into it, and executed too with GL_COMPILE_AND_EXECUTE. The older list of that
 * name stays until glEndList. GL_INVALID_VALUE: list is 0. GL_INVALID_OPERATION: a list is being made. */
GLAPI void GLAPIENTRY glNewList(GLuint list, GLenum mode);

/* Ends it. GL_INVALID_OPERATION: no list is being made. */
GLAPI void GLAPIENTRY glEndList(void);

/* Executes list; an unused name, or nesting beyond GL_MAX_LIST_NESTING, does nothing. */
GLAPI void GLAPIENTRY glCallList(GLuint list);

/* Executes the n lists whose names, each added to the list base, are in lists as type: any integer type,
 * GL_FLOAT, GL_2_BYTES, GL_3_BYTES or GL_4_BYTES. */
GLAPI void GLAPIENTRY glCallLists(GLsizei n, GLenum type, const void *lists);

/* Sets the list base, initially 0. */
GLAPI void GLAPIENTRY glListBase(GLuint base);

/* Makes range empty lists with consecutive names and returns the first; 0 if there is no such gap. */
GLAPI GLuint GLAPIENTRY glGenLists(GLsizei range);

/* Returns whether list is the name of a list. */
GLAPI GLboolean GLAPIENTRY glIsList(GLuint list);

/* Deletes range lists from list on; unused names are skipped. */
GLAPI void GLAPIENTRY glDeleteLists(GLuint list, GLsizei range);


/* ---- 5.5 Flush and finish ------------------------------------------------------------------------------ */

/* glFinish returns when everything commanded before is in the framebuffer, glFlush when it is sure to get
 * there soon. Both bring the picture to the caller's buffer (GL/osmesa.h). */
GLAPI void GLAPIENTRY glFlush(void);
GLAPI void GLAPIENTRY glFinish(void);


/* ---- 5.6 Hints ----------------------------------------------------------------------------------------- */

#define GL_PERSPECTIVE_CORRECTION_HINT             0x0C50
#define GL_POINT_SMOOTH_HINT                       0x0C51
#define GL_LINE_SMOOTH_HINT                        0x0C52
#define GL_POLYGON_SMOOTH_HINT                     0x0C53
#define GL_FOG_HINT                                0x0C54
#define GL_GENERATE_MIPMAP_HINT                    0x8192
#define GL_FASTEST                                 0x1101
#define GL_NICEST                                  0x1102
#define GL_DONT_CARE                               0x1100

/* Sets what is wished for target, one of the hints above or GL_TEXTURE_COMPRESSION_HINT. Initially
 * GL_DONT_CARE. */
GLAPI void GLAPIENTRY glHint(GLenum target, GLenum mode);


/* ---- 6.1 Querying GL state ----------------------------------------------------------------------------- */

/* Properties of the framebuffer and limits that belong to no other section. */
#define GL_AUX_BUFFERS                             0x0C00
#define GL_INDEX_MODE                              0x0C30
#define GL_RGBA_MODE                               0x0C31
#define GL_DOUBLEBUFFER                            0x0C32
#define GL_STEREO                                  0x0C33
#define GL_SUBPIXEL_BITS                           0x0D50
#define GL_INDEX_BITS                              0x0D51
#define GL_RED_BITS                                0x0D52
#define GL_GREEN_BITS                              0x0D53
#define GL_BLUE_BITS                               0x0D54
#define GL_ALPHA_BITS                              0x0D55
#define GL_DEPTH_BITS                              0x0D56
#define GL_STENCIL_BITS                            0x0D57
#define GL_ACCUM_RED_BITS                          0x0D58
#define GL_ACCUM_GREEN_BITS                        0x0D59
#define GL_ACCUM_BLUE_BITS                         0x0D5A
#define GL_ACCUM_ALPHA_BITS                        0x0D5B

/* Write the value or values of pname to params, converted: non-zero is GL_TRUE; floats become the nearest
 * integer, but colors, normals and depths are scaled so that 1 is the largest integer. (6.1.1 Simple queries,
 * 6.1.2 Data conversions) */
GLAPI void GLAPIENTRY glGetBooleanv(GLenum pname, GLboolean *data);
GLAPI void GLAPIENTRY glGetIntegerv(GLenum pname, GLint *data);
GLAPI void GLAPIENTRY glGetFloatv(GLenum pname, GLfloat *data);
GLAPI void GLAPIENTRY glGetDoublev(GLenum pname, GLdouble *data);

/* Writes the four coefficients of a user clip plane, in eye coordinates. (6.1.3 Enumerated queries, here and
 * down to glGetMap) */
GLAPI void GLAPIENTRY glGetClipPlane(GLenum plane, GLdouble *equation);

/* Write parameters as the commands of the same names set them: of a light (positions and directions in eye
 * coordinates), a material (face GL_FRONT or GL_BACK), a texture environment, a generated coordinate
 * (GL_EYE_PLANE in eye coordinates), a texture, an image of a texture (GL_INVALID_VALUE: level out of range),
 * a pixel map, an evaluator. */
GLAPI void GLAPIENTRY glGetLightfv(GLenum light, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetLightiv(GLenum light, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetMaterialfv(GLenum face, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetMaterialiv(GLenum face, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetTexEnvfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetTexEnviv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetTexGendv(GLenum coord, GLenum pname, GLdouble *params);
GLAPI void GLAPIENTRY glGetTexGenfv(GLenum coord, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetTexGeniv(GLenum coord, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetTexParameterfv(GLenum target, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetTexParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetTexLevelParameterfv(GLenum target, GLint level, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetTexLevelParameteriv(GLenum target, GLint level, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetPixelMapfv(GLenum map, GLfloat *values);
GLAPI void GLAPIENTRY glGetPixelMapuiv(GLenum map, GLuint *values);
GLAPI void GLAPIENTRY glGetPixelMapusv(GLenum map, GLushort *values);
GLAPI void GLAPIENTRY glGetMapdv(GLenum target, GLenum query, GLdouble *v);
GLAPI void GLAPIENTRY glGetMapfv(GLenum target, GLenum query, GLfloat *v);
GLAPI void GLAPIENTRY glGetMapiv(GLenum target, GLenum query, GLint *v);

/* Writes image level of the texture bound to target as pixels of format and type, laid out by the GL_PACK_
 * modes. GL_INVALID_VALUE: level out of range. (6.1.4 Texture queries) */
GLAPI void GLAPIENTRY glGetTexImage(GLenum target, GLint level, GLenum format, GLenum type, void *pixels);

/* Writes a compressed image as it is stored. GL_INVALID_OPERATION: it is not compressed. (6.1.4; since
 * 1.3) */
GLAPI void GLAPIENTRY glGetCompressedTexImage(GLenum target, GLint level, void *img);

/* Writes the polygon stipple as glPolygonStipple reads it. (6.1.5) */
GLAPI void GLAPIENTRY glGetPolygonStipple(GLubyte *mask);

/* Writes the address of pname, one of the GL_..._POINTER tokens, to params. (6.1.11 Pointer and string
 * queries) */
GLAPI void GLAPIENTRY glGetPointerv(GLenum pname, void **params);

#define GL_VENDOR                                  0x1F00
#define GL_RENDERER                                0x1F01
#define GL_VERSION                                 0x1F02
#define GL_EXTENSIONS                              0x1F03

/* Returns a static string: who made the GL, what draws, its version, its extensions with blanks between.
 * (6.1.11) */
GLAPI const GLubyte *GLAPIENTRY glGetString(GLenum name);

/* Groups of state (table 6.3), some of them also bits of glClear. */
#define GL_CURRENT_BIT                             0x00000001
#define GL_POINT_BIT                               0x00000002
#define GL_LINE_BIT                                0x00000004
#define GL_POLYGON_BIT                             0x00000008
#define GL_POLYGON_STIPPLE_BIT                     0x00000010
#define GL_PIXEL_MODE_BIT                          0x00000020
#define GL_LIGHTING_BIT                            0x00000040
#define GL_FOG_BIT                                 0x00000080
#define GL_DEPTH_BUFFER_BIT                        0x00000100
#define GL_ACCUM_BUFFER_BIT                        0x00000200
#define GL_STENCIL_BUFFER_BIT                      0x00000400
#define GL_VIEWPORT_BIT                            0x00000800
#define GL_TRANSFORM_BIT                           0x00001000
#define GL_ENABLE_BIT                              0x00002000
#define GL_COLOR_BUFFER_BIT                        0x00004000
#define GL_HINT_BIT                                0x00008000
#define GL_EVAL_BIT                                0x00010000
#define GL_LIST_BIT                                0x00020000
#define GL_TEXTURE_BIT                             0x00040000
#define GL_SCISSOR_BIT                             0x00080000
#define GL_MULTISAMPLE_BIT                         0x20000000
#define GL_ALL_ATTRIB_BITS                         0xFFFFFFFF
#define GL_ATTRIB_STACK_DEPTH                      0x0BB0
#define GL_MAX_ATTRIB_STACK_DEPTH                  0x0D35
#define GL_CLIENT_PIXEL_STORE_BIT                  0x00000001
#define GL_CLIENT_VERTEX_ARRAY_BIT                 0x00000002
#define GL_CLIENT_ALL_ATTRIB_BITS                  0xFFFFFFFF
#define GL_ALL_CLIENT_ATTRIB_BITS GL_CLIENT_ALL_ATTRIB_BITS
#define GL_CLIENT_ATTRIB_STACK_DEPTH               0x0BB1
#define GL_MAX_CLIENT_ATTRIB_STACK_DEPTH           0x0D3B

/* Keep the groups of mask on a stack and bring back those kept last. GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW.
 * (6.1.14 Saving and restoring state) */
GLAPI void GLAPIENTRY glPushAttrib(GLbitfield mask);
GLAPI void GLAPIENTRY glPopAttrib(void);

/* The same for the client's state: pixel storage modes and vertex arrays. */
GLAPI void GLAPIENTRY glPushClientAttrib(GLbitfield mask);
GLAPI void GLAPIENTRY glPopClientAttrib(void);

#ifdef __cplusplus
}
#endif

#ifndef GL_GLEXT_LEGACY
#include <GL/glext.h>
#endif

#endif
