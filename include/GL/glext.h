/*
 * GL/glext.h - OpenGL 1.4, OpenGL 1.5 and the extensions that FixedGL offers.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 *
 * Included by GL/gl.h unless GL_GLEXT_LEGACY is defined; the rules at its top hold here too. The functions
 * are declared if GL_GLEXT_PROTOTYPES is defined before; the types of pointers to them, PFN...PROC, for use
 * with OSMesaGetProcAddress, always are. Which extensions a context offers is said by
 * glGetString(GL_EXTENSIONS).
 *
 * This is not the whole registry, so GL_GLEXT_VERSION is left undefined: a program may include a larger
 * glext.h of its own after this one.
 */
#if !defined(FIXEDGL_GLEXT_H) && !defined(__gl_glext_h_) && !defined(__glext_h_)
#define FIXEDGL_GLEXT_H

/* clang-format off: tokens stand in columns */

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif


/* ---- OpenGL 1.2: documented in GL/gl.h ----------------------------------------------------------------- */

#ifndef GL_VERSION_1_2
#define GL_VERSION_1_2 1
#endif

typedef void (APIENTRYP PFNGLDRAWRANGEELEMENTSPROC)(GLenum mode, GLuint start, GLuint end, GLsizei count,
        GLenum type, const void *indices);
typedef void (APIENTRYP PFNGLTEXIMAGE3DPROC)(GLenum target, GLint level, GLint internalformat, GLsizei width,
        GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void *pixels);
typedef void (APIENTRYP PFNGLTEXSUBIMAGE3DPROC)(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
        const void *pixels);
typedef void (APIENTRYP PFNGLCOPYTEXSUBIMAGE3DPROC)(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);


/* ---- OpenGL 1.3: documented in GL/gl.h ----------------------------------------------------------------- */

#ifndef GL_VERSION_1_3
#define GL_VERSION_1_3 1
#endif

typedef void (APIENTRYP PFNGLACTIVETEXTUREPROC)(GLenum texture);
typedef void (APIENTRYP PFNGLSAMPLECOVERAGEPROC)(GLfloat value, GLboolean invert);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE3DPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE2DPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE1DPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLint border, GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE3DPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format,
        GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE2DPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE1DPROC)(GLenum target, GLint level, GLint xoffset,
        GLsizei width, GLenum format, GLsizei imageSize, const void *data);
typedef void (APIENTRYP PFNGLGETCOMPRESSEDTEXIMAGEPROC)(GLenum target, GLint level, void *img);
typedef void (APIENTRYP PFNGLCLIENTACTIVETEXTUREPROC)(GLenum texture);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1DPROC)(GLenum target, GLdouble s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1DVPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1FPROC)(GLenum target, GLfloat s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1FVPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1IPROC)(GLenum target, GLint s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1IVPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1SPROC)(GLenum target, GLshort s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1SVPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2DPROC)(GLenum target, GLdouble s, GLdouble t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2DVPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2FPROC)(GLenum target, GLfloat s, GLfloat t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2FVPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2IPROC)(GLenum target, GLint s, GLint t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2IVPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2SPROC)(GLenum target, GLshort s, GLshort t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2SVPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3DPROC)(GLenum target, GLdouble s, GLdouble t, GLdouble r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3DVPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3FPROC)(GLenum target, GLfloat s, GLfloat t, GLfloat r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3FVPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3IPROC)(GLenum target, GLint s, GLint t, GLint r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3IVPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3SPROC)(GLenum target, GLshort s, GLshort t, GLshort r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3SVPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4DPROC)(GLenum target, GLdouble s, GLdouble t, GLdouble r,
        GLdouble q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4DVPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4FPROC)(GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4FVPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4IPROC)(GLenum target, GLint s, GLint t, GLint r, GLint q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4IVPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4SPROC)(GLenum target, GLshort s, GLshort t, GLshort r, GLshort q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4SVPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLLOADTRANSPOSEMATRIXFPROC)(const GLfloat *m);
typedef void (APIENTRYP PFNGLLOADTRANSPOSEMATRIXDPROC)(const GLdouble *m);
typedef void (APIENTRYP PFNGLMULTTRANSPOSEMATRIXFPROC)(const GLfloat *m);
typedef void (APIENTRYP PFNGLMULTTRANSPOSEMATRIXDPROC)(const GLdouble *m);


/* ---- OpenGL 1.4 ---------------------------------------------------------------------------------------- */

#ifndef GL_VERSION_1_4
#define GL_VERSION_1_4 1

#ifdef GL_GLEXT_PROTOTYPES
/* Set the current fog coordinate, used for fog while GL_FOG_COORD_SRC is GL_FOG_COORD. Initially 0. (2.7) */
GLAPI void GLAPIENTRY glFogCoordf(GLfloat coord);
GLAPI void GLAPIENTRY glFogCoordfv(const GLfloat *coord);
GLAPI void GLAPIENTRY glFogCoordd(GLdouble coord);
GLAPI void GLAPIENTRY glFogCoorddv(const GLdouble *coord);

/* Set the current secondary color, added after texturing while GL_COLOR_SUM is enabled. Alpha is always 1.
 * Initially (0, 0, 0, 1). (2.7) */
GLAPI void GLAPIENTRY glSecondaryColor3b(GLbyte red, GLbyte green, GLbyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3bv(const GLbyte *v);
GLAPI void GLAPIENTRY glSecondaryColor3d(GLdouble red, GLdouble green, GLdouble blue);
GLAPI void GLAPIENTRY glSecondaryColor3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glSecondaryColor3f(GLfloat red, GLfloat green, GLfloat blue);
GLAPI void GLAPIENTRY glSecondaryColor3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glSecondaryColor3i(GLint red, GLint green, GLint blue);
GLAPI void GLAPIENTRY glSecondaryColor3iv(const GLint *v);
GLAPI void GLAPIENTRY glSecondaryColor3s(GLshort red, GLshort green, GLshort blue);
GLAPI void GLAPIENTRY glSecondaryColor3sv(const GLshort *v);
GLAPI void GLAPIENTRY glSecondaryColor3ub(GLubyte red, GLubyte green, GLubyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3ubv(const GLubyte *v);
GLAPI void GLAPIENTRY glSecondaryColor3ui(GLuint red, GLuint green, GLuint blue);
GLAPI void GLAPIENTRY glSecondaryColor3uiv(const GLuint *v);
GLAPI void GLAPIENTRY glSecondaryColor3us(GLushort red, GLushort green, GLushort blue);
GLAPI void GLAPIENTRY glSecondaryColor3usv(const GLushort *v);

/* Arrays of fog coordinates, GL_FLOAT or GL_DOUBLE, and of secondary colors, size 3, any type that
 * glColorPointer takes. GL_INVALID_VALUE: another size, negative stride. (2.8) */
GLAPI void GLAPIENTRY glFogCoordPointer(GLenum type, GLsizei stride, const void *pointer);
GLAPI void GLAPIENTRY glSecondaryColorPointer(GLint size, GLenum type, GLsizei stride, const void *pointer);

/* As drawcount calls of glDrawArrays or glDrawElements with the i-th values of the arrays; those with count 0
 * draw nothing. GL_INVALID_VALUE: negative drawcount. (2.8) */
GLAPI void GLAPIENTRY glMultiDrawArrays(GLenum mode, const GLint *first, const GLsizei *count,
                                        GLsizei drawcount);
GLAPI void GLAPIENTRY glMultiDrawElements(GLenum mode, const GLsizei *count, GLenum type,
                                          const void *const *indices, GLsizei drawcount);

/* Set the raster position in window coordinates and make it valid. z is clamped to [0,1] and mapped to the
 * depth range, missing z is 0; color and texture coordinates are the current ones, without lighting.
 * (2.13) */
GLAPI void GLAPIENTRY glWindowPos2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glWindowPos2dv(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glWindowPos2fv(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glWindowPos2iv(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glWindowPos2sv(const GLshort *v);
GLAPI void GLAPIENTRY glWindowPos3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glWindowPos3dv(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glWindowPos3fv(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glWindowPos3iv(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glWindowPos3sv(const GLshort *v);

/* Set a parameter of points: GL_POINT_SIZE_MIN and GL_POINT_SIZE_MAX, the limits of the size in pixels;
 * GL_POINT_FADE_THRESHOLD_SIZE, for multisampling. v forms also GL_POINT_DISTANCE_ATTENUATION (a, b, c): the
 * size is divided by sqrt(a + b d + c d^2), d being the distance to the eye; initially (1, 0, 0).
 * GL_INVALID_VALUE: a negative size. (3.3) */
GLAPI void GLAPIENTRY glPointParameterf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPointParameterfv(GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glPointParameteri(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glPointParameteriv(GLenum pname, const GLint *params);

/* As glBlendFunc, with factors of their own for alpha. (4.1.8) */
GLAPI void GLAPIENTRY glBlendFuncSeparate(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha,
                                          GLenum dfactorAlpha);
#endif

typedef void (APIENTRYP PFNGLBLENDFUNCSEPARATEPROC)(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha,
        GLenum dfactorAlpha);
typedef void (APIENTRYP PFNGLMULTIDRAWARRAYSPROC)(GLenum mode, const GLint *first, const GLsizei *count,
        GLsizei drawcount);
typedef void (APIENTRYP PFNGLMULTIDRAWELEMENTSPROC)(GLenum mode, const GLsizei *count, GLenum type,
        const void *const *indices, GLsizei drawcount);
typedef void (APIENTRYP PFNGLPOINTPARAMETERFPROC)(GLenum pname, GLfloat param);
typedef void (APIENTRYP PFNGLPOINTPARAMETERFVPROC)(GLenum pname, const GLfloat *params);
typedef void (APIENTRYP PFNGLPOINTPARAMETERIPROC)(GLenum pname, GLint param);
typedef void (APIENTRYP PFNGLPOINTPARAMETERIVPROC)(GLenum pname, const GLint *params);
typedef void (APIENTRYP PFNGLFOGCOORDFPROC)(GLfloat coord);
typedef void (APIENTRYP PFNGLFOGCOORDFVPROC)(const GLfloat *coord);
typedef void (APIENTRYP PFNGLFOGCOORDDPROC)(GLdouble coord);
typedef void (APIENTRYP PFNGLFOGCOORDDVPROC)(const GLdouble *coord);
typedef void (APIENTRYP PFNGLFOGCOORDPOINTERPROC)(GLenum type, GLsizei stride, const void *pointer);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3BPROC)(GLbyte red, GLbyte green, GLbyte blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3BVPROC)(const GLbyte *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3DPROC)(GLdouble red, GLdouble green, GLdouble blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3DVPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3FPROC)(GLfloat red, GLfloat green, GLfloat blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3FVPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3IPROC)(GLint red, GLint green, GLint blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3IVPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3SPROC)(GLshort red, GLshort green, GLshort blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3SVPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UBPROC)(GLubyte red, GLubyte green, GLubyte blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UBVPROC)(const GLubyte *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UIPROC)(GLuint red, GLuint green, GLuint blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UIVPROC)(const GLuint *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3USPROC)(GLushort red, GLushort green, GLushort blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3USVPROC)(const GLushort *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLORPOINTERPROC)(GLint size, GLenum type, GLsizei stride,
        const void *pointer);
typedef void (APIENTRYP PFNGLWINDOWPOS2DPROC)(GLdouble x, GLdouble y);
typedef void (APIENTRYP PFNGLWINDOWPOS2DVPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2FPROC)(GLfloat x, GLfloat y);
typedef void (APIENTRYP PFNGLWINDOWPOS2FVPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2IPROC)(GLint x, GLint y);
typedef void (APIENTRYP PFNGLWINDOWPOS2IVPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2SPROC)(GLshort x, GLshort y);
typedef void (APIENTRYP PFNGLWINDOWPOS2SVPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3DPROC)(GLdouble x, GLdouble y, GLdouble z);
typedef void (APIENTRYP PFNGLWINDOWPOS3DVPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3FPROC)(GLfloat x, GLfloat y, GLfloat z);
typedef void (APIENTRYP PFNGLWINDOWPOS3FVPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3IPROC)(GLint x, GLint y, GLint z);
typedef void (APIENTRYP PFNGLWINDOWPOS3IVPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3SPROC)(GLshort x, GLshort y, GLshort z);
typedef void (APIENTRYP PFNGLWINDOWPOS3SVPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLBLENDCOLORPROC)(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
typedef void (APIENTRYP PFNGLBLENDEQUATIONPROC)(GLenum mode);
#endif


/* ---- OpenGL 1.5 ---------------------------------------------------------------------------------------- */

#ifndef GL_VERSION_1_5
#define GL_VERSION_1_5 1

#ifdef GL_GLEXT_PROTOTYPES
/* Binds buffer to target, GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER; a new name becomes an empty buffer, 0
 * means client memory. (2.9 Buffer objects, here and down to glUnmapBuffer) */
GLAPI void GLAPIENTRY glBindBuffer(GLenum target, GLuint buffer);

/* Write n unused names; delete n buffers, where one is bound 0 takes its place, 0 and unused names are
 * skipped; return whether a name is that of a buffer. */
GLAPI void GLAPIENTRY glGenBuffers(GLsizei n, GLuint *buffers);
GLAPI void GLAPIENTRY glDeleteBuffers(GLsizei n, const GLuint *buffers);
GLAPI GLboolean GLAPIENTRY glIsBuffer(GLuint buffer);

/* Gives the bound buffer size bytes, from data or, if data is NULL, undefined; usage is one of the nine
 * GL_..._DRAW, _READ and _COPY, a hint. GL_INVALID_VALUE: negative size. GL_INVALID_OPERATION: buffer 0 is
 * bound. */
GLAPI void GLAPIENTRY glBufferData(GLenum target, GLsizeiptr size, const void *data, GLenum usage);

/* Replace, or read, size bytes of the bound buffer from offset on. GL_INVALID_VALUE: beyond its end, or
 * negative. GL_INVALID_OPERATION: buffer 0 is bound, or the buffer is mapped. */
GLAPI void GLAPIENTRY glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void *data);
GLAPI void GLAPIENTRY glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void *data);

/* Returns the address of the bound buffer's bytes for access GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE;
 * drawing with it is an error until glUnmapBuffer. GL_INVALID_OPERATION: buffer 0 is bound, or the buffer is
 * mapped. */
GLAPI void *GLAPIENTRY glMapBuffer(GLenum target, GLenum access);

/* Ends that; returns GL_FALSE if the contents were lost. GL_INVALID_OPERATION: the buffer is not mapped. */
GLAPI GLboolean GLAPIENTRY glUnmapBuffer(GLenum target);

/* Write a property of the bound buffer: GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS or
 * GL_BUFFER_MAPPED; the address for GL_BUFFER_MAP_POINTER, NULL if it is not mapped. GL_INVALID_OPERATION:
 * buffer 0 is bound. (6.1.13) */
GLAPI void GLAPIENTRY glGetBufferParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetBufferPointerv(GLenum target, GLenum pname, void **params);

/* Write n unused names; delete n queries; return whether a name is that of a query. (4.1.7 Occlusion
 * queries) */
GLAPI void GLAPIENTRY glGenQueries(GLsizei n, GLuint *ids);
GLAPI void GLAPIENTRY glDeleteQueries(GLsizei n, const GLuint *ids);
GLAPI GLboolean GLAPIENTRY glIsQuery(GLuint id);

/* Counts into query id, between these two, the samples that pass the depth test; target is GL_SAMPLES_PASSED.
 * GL_INVALID_OPERATION: id is 0 or in use, a query is running; none is running. (4.1.7) */
GLAPI void GLAPIENTRY glBeginQuery(GLenum target, GLuint id);
GLAPI void GLAPIENTRY glEndQuery(GLenum target);

/* Write GL_CURRENT_QUERY, 0 if none is running, or GL_QUERY_COUNTER_BITS. (6.1.12) */
GLAPI void GLAPIENTRY glGetQueryiv(GLenum target, GLenum pname, GLint *params);

/* Write GL_QUERY_RESULT or GL_QUERY_RESULT_AVAILABLE of query id. GL_INVALID_OPERATION: id is no query, or is
 * running. (6.1.12) */
GLAPI void GLAPIENTRY glGetQueryObjectiv(GLuint id, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetQueryObjectuiv(GLuint id, GLenum pname, GLuint *params);
#endif

typedef void (APIENTRYP PFNGLGENQUERIESPROC)(GLsizei n, GLuint *ids);
typedef void (APIENTRYP PFNGLDELETEQUERIESPROC)(GLsizei n, const GLuint *ids);
typedef GLboolean (APIENTRYP PFNGLISQUERYPROC)(GLuint id);
typedef void (APIENTRYP PFNGLBEGINQUERYPROC)(GLenum target, GLuint id);
typedef void (APIENTRYP PFNGLENDQUERYPROC)(GLenum target);
typedef void (APIENTRYP PFNGLGETQUERYIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETQUERYOBJECTIVPROC)(GLuint id, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETQUERYOBJECTUIVPROC)(GLuint id, GLenum pname, GLuint *params);
typedef void (APIENTRYP PFNGLBINDBUFFERPROC)(GLenum target, GLuint buffer);
typedef void (APIENTRYP PFNGLDELETEBUFFERSPROC)(GLsizei n, const GLuint *buffers);
typedef void (APIENTRYP PFNGLGENBUFFERSPROC)(GLsizei n, GLuint *buffers);
typedef GLboolean (APIENTRYP PFNGLISBUFFERPROC)(GLuint buffer);
typedef void (APIENTRYP PFNGLBUFFERDATAPROC)(GLenum target, GLsizeiptr size, const void *data, GLenum usage);
typedef void (APIENTRYP PFNGLBUFFERSUBDATAPROC)(GLenum target, GLintptr offset, GLsizeiptr size,
        const void *data);
typedef void (APIENTRYP PFNGLGETBUFFERSUBDATAPROC)(GLenum target, GLintptr offset, GLsizeiptr size,
        void *data);
typedef void *(APIENTRYP PFNGLMAPBUFFERPROC)(GLenum target, GLenum access);
typedef GLboolean (APIENTRYP PFNGLUNMAPBUFFERPROC)(GLenum target);
typedef void (APIENTRYP PFNGLGETBUFFERPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETBUFFERPOINTERVPROC)(GLenum target, GLenum pname, void **params);
#endif


/* ---- Extensions that later versions took up: the same commands and tokens under older names ------------ */

#ifndef GL_ARB_imaging
#define GL_ARB_imaging 1
#endif

typedef void (APIENTRYP PFNGLCOLORTABLEPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLenum format, GLenum type, const void *table);
typedef void (APIENTRYP PFNGLCOLORTABLEPARAMETERFVPROC)(GLenum target, GLenum pname, const GLfloat *params);
typedef void (APIENTRYP PFNGLCOLORTABLEPARAMETERIVPROC)(GLenum target, GLenum pname, const GLint *params);
typedef void (APIENTRYP PFNGLCOPYCOLORTABLEPROC)(GLenum target, GLenum internalformat, GLint x, GLint y,
        GLsizei width);
typedef void (APIENTRYP PFNGLGETCOLORTABLEPROC)(GLenum target, GLenum format, GLenum type, void *table);
typedef void (APIENTRYP PFNGLGETCOLORTABLEPARAMETERFVPROC)(GLenum target, GLenum pname, GLfloat *params);
typedef void (APIENTRYP PFNGLGETCOLORTABLEPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLCOLORSUBTABLEPROC)(GLenum target, GLsizei start, GLsizei count, GLenum format,
        GLenum type, const void *data);
typedef void (APIENTRYP PFNGLCOPYCOLORSUBTABLEPROC)(GLenum target, GLsizei start, GLint x, GLint y,
        GLsizei width);
typedef void (APIENTRYP PFNGLCONVOLUTIONFILTER1DPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLenum format, GLenum type, const void *image);
typedef void (APIENTRYP PFNGLCONVOLUTIONFILTER2DPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLsizei height, GLenum format, GLenum type, const void *image);
typedef void (APIENTRYP PFNGLCONVOLUTIONPARAMETERFPROC)(GLenum target, GLenum pname, GLfloat params);
typedef void (APIENTRYP PFNGLCONVOLUTIONPARAMETERFVPROC)(GLenum target, GLenum pname, const GLfloat *params);
typedef void (APIENTRYP PFNGLCONVOLUTIONPARAMETERIPROC)(GLenum target, GLenum pname, GLint params);
typedef void (APIENTRYP PFNGLCONVOLUTIONPARAMETERIVPROC)(GLenum target, GLenum pname, const GLint *params);
typedef void (APIENTRYP PFNGLCOPYCONVOLUTIONFILTER1DPROC)(GLenum target, GLenum internalformat, GLint x,
        GLint y, GLsizei width);
typedef void (APIENTRYP PFNGLCOPYCONVOLUTIONFILTER2DPROC)(GLenum target, GLenum internalformat, GLint x,
        GLint y, GLsizei width, GLsizei height);
typedef void (APIENTRYP PFNGLGETCONVOLUTIONFILTERPROC)(GLenum target, GLenum format, GLenum type,
        void *image);
typedef void (APIENTRYP PFNGLGETCONVOLUTIONPARAMETERFVPROC)(GLenum target, GLenum pname, GLfloat *params);
typedef void (APIENTRYP PFNGLGETCONVOLUTIONPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETSEPARABLEFILTERPROC)(GLenum target, GLenum format, GLenum type, void *row,
        void *column, void *span);
typedef void (APIENTRYP PFNGLSEPARABLEFILTER2DPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLsizei height, GLenum format, GLenum type, const void *row, const void *column);
typedef void (APIENTRYP PFNGLGETHISTOGRAMPROC)(GLenum target, GLboolean reset, GLenum format, GLenum type,
        void *values);
typedef void (APIENTRYP PFNGLGETHISTOGRAMPARAMETERFVPROC)(GLenum target, GLenum pname, GLfloat *params);
typedef void (APIENTRYP PFNGLGETHISTOGRAMPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETMINMAXPROC)(GLenum target, GLboolean reset, GLenum format, GLenum type,
        void *values);
typedef void (APIENTRYP PFNGLGETMINMAXPARAMETERFVPROC)(GLenum target, GLenum pname, GLfloat *params);
typedef void (APIENTRYP PFNGLGETMINMAXPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLHISTOGRAMPROC)(GLenum target, GLsizei width, GLenum internalformat,
        GLboolean sink);
typedef void (APIENTRYP PFNGLMINMAXPROC)(GLenum target, GLenum internalformat, GLboolean sink);
typedef void (APIENTRYP PFNGLRESETHISTOGRAMPROC)(GLenum target);
typedef void (APIENTRYP PFNGLRESETMINMAXPROC)(GLenum target);

/* Units of texture coordinates and images, as in OpenGL 1.3; functions and tokens are in GL/gl.h. */
#ifndef GL_ARB_multitexture
#define GL_ARB_multitexture 1
typedef void (APIENTRYP PFNGLACTIVETEXTUREARBPROC)(GLenum texture);
typedef void (APIENTRYP PFNGLCLIENTACTIVETEXTUREARBPROC)(GLenum texture);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1DARBPROC)(GLenum target, GLdouble s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1DVARBPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1FARBPROC)(GLenum target, GLfloat s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1FVARBPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1IARBPROC)(GLenum target, GLint s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1IVARBPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1SARBPROC)(GLenum target, GLshort s);
typedef void (APIENTRYP PFNGLMULTITEXCOORD1SVARBPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2DARBPROC)(GLenum target, GLdouble s, GLdouble t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2DVARBPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2FARBPROC)(GLenum target, GLfloat s, GLfloat t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2FVARBPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2IARBPROC)(GLenum target, GLint s, GLint t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2IVARBPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2SARBPROC)(GLenum target, GLshort s, GLshort t);
typedef void (APIENTRYP PFNGLMULTITEXCOORD2SVARBPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3DARBPROC)(GLenum target, GLdouble s, GLdouble t, GLdouble r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3DVARBPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3FARBPROC)(GLenum target, GLfloat s, GLfloat t, GLfloat r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3FVARBPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3IARBPROC)(GLenum target, GLint s, GLint t, GLint r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3IVARBPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3SARBPROC)(GLenum target, GLshort s, GLshort t, GLshort r);
typedef void (APIENTRYP PFNGLMULTITEXCOORD3SVARBPROC)(GLenum target, const GLshort *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4DARBPROC)(GLenum target, GLdouble s, GLdouble t, GLdouble r,
        GLdouble q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4DVARBPROC)(GLenum target, const GLdouble *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4FARBPROC)(GLenum target, GLfloat s, GLfloat t, GLfloat r,
        GLfloat q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4FVARBPROC)(GLenum target, const GLfloat *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4IARBPROC)(GLenum target, GLint s, GLint t, GLint r, GLint q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4IVARBPROC)(GLenum target, const GLint *v);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4SARBPROC)(GLenum target, GLshort s, GLshort t, GLshort r,
        GLshort q);
typedef void (APIENTRYP PFNGLMULTITEXCOORD4SVARBPROC)(GLenum target, const GLshort *v);
#endif

/* The raster position in window coordinates, as in OpenGL 1.4. */
#ifndef GL_ARB_window_pos
#define GL_ARB_window_pos 1
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glWindowPos2dARB(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glWindowPos2dvARB(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos2fARB(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glWindowPos2fvARB(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos2iARB(GLint x, GLint y);
GLAPI void GLAPIENTRY glWindowPos2ivARB(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos2sARB(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glWindowPos2svARB(const GLshort *v);
GLAPI void GLAPIENTRY glWindowPos3dARB(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glWindowPos3dvARB(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos3fARB(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glWindowPos3fvARB(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos3iARB(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glWindowPos3ivARB(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos3sARB(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glWindowPos3svARB(const GLshort *v);
#endif
typedef void (APIENTRYP PFNGLWINDOWPOS2DARBPROC)(GLdouble x, GLdouble y);
typedef void (APIENTRYP PFNGLWINDOWPOS2DVARBPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2FARBPROC)(GLfloat x, GLfloat y);
typedef void (APIENTRYP PFNGLWINDOWPOS2FVARBPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2IARBPROC)(GLint x, GLint y);
typedef void (APIENTRYP PFNGLWINDOWPOS2IVARBPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2SARBPROC)(GLshort x, GLshort y);
typedef void (APIENTRYP PFNGLWINDOWPOS2SVARBPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3DARBPROC)(GLdouble x, GLdouble y, GLdouble z);
typedef void (APIENTRYP PFNGLWINDOWPOS3DVARBPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3FARBPROC)(GLfloat x, GLfloat y, GLfloat z);
typedef void (APIENTRYP PFNGLWINDOWPOS3FVARBPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3IARBPROC)(GLint x, GLint y, GLint z);
typedef void (APIENTRYP PFNGLWINDOWPOS3IVARBPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3SARBPROC)(GLshort x, GLshort y, GLshort z);
typedef void (APIENTRYP PFNGLWINDOWPOS3SVARBPROC)(const GLshort *v);
#endif

/* The same under its first name; without the forms of four coordinates. */
#ifndef GL_MESA_window_pos
#define GL_MESA_window_pos 1
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glWindowPos2dMESA(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glWindowPos2dvMESA(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos2fMESA(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glWindowPos2fvMESA(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos2iMESA(GLint x, GLint y);
GLAPI void GLAPIENTRY glWindowPos2ivMESA(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos2sMESA(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glWindowPos2svMESA(const GLshort *v);
GLAPI void GLAPIENTRY glWindowPos3dMESA(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glWindowPos3dvMESA(const GLdouble *v);
GLAPI void GLAPIENTRY glWindowPos3fMESA(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glWindowPos3fvMESA(const GLfloat *v);
GLAPI void GLAPIENTRY glWindowPos3iMESA(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glWindowPos3ivMESA(const GLint *v);
GLAPI void GLAPIENTRY glWindowPos3sMESA(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glWindowPos3svMESA(const GLshort *v);
#endif
typedef void (APIENTRYP PFNGLWINDOWPOS2DMESAPROC)(GLdouble x, GLdouble y);
typedef void (APIENTRYP PFNGLWINDOWPOS2DVMESAPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2FMESAPROC)(GLfloat x, GLfloat y);
typedef void (APIENTRYP PFNGLWINDOWPOS2FVMESAPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2IMESAPROC)(GLint x, GLint y);
typedef void (APIENTRYP PFNGLWINDOWPOS2IVMESAPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS2SMESAPROC)(GLshort x, GLshort y);
typedef void (APIENTRYP PFNGLWINDOWPOS2SVMESAPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3DMESAPROC)(GLdouble x, GLdouble y, GLdouble z);
typedef void (APIENTRYP PFNGLWINDOWPOS3DVMESAPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3FMESAPROC)(GLfloat x, GLfloat y, GLfloat z);
typedef void (APIENTRYP PFNGLWINDOWPOS3FVMESAPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3IMESAPROC)(GLint x, GLint y, GLint z);
typedef void (APIENTRYP PFNGLWINDOWPOS3IVMESAPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLWINDOWPOS3SMESAPROC)(GLshort x, GLshort y, GLshort z);
typedef void (APIENTRYP PFNGLWINDOWPOS3SVMESAPROC)(const GLshort *v);
#endif

/* Pixels with blue first, as in OpenGL 1.2. */
#ifndef GL_EXT_bgra
#define GL_EXT_bgra 1
#define GL_BGR_EXT                                 0x80E0
#define GL_BGRA_EXT                                0x80E1
#endif

/* Packed pixels, as in OpenGL 1.2 without the REV types. */
#ifndef GL_EXT_packed_pixels
#define GL_EXT_packed_pixels 1
#define GL_UNSIGNED_BYTE_3_3_2_EXT                 0x8032
#define GL_UNSIGNED_SHORT_4_4_4_4_EXT              0x8033
#define GL_UNSIGNED_SHORT_5_5_5_1_EXT              0x8034
#define GL_UNSIGNED_INT_8_8_8_8_EXT                0x8035
#define GL_UNSIGNED_INT_10_10_10_2_EXT             0x8036
#endif

/* Lighting per fragment: glShadeModel(GL_PHONG_WIN) interpolates normals and eye coordinates instead of colors and
 * evaluates the lighting equation of 2.14.1 at every fragment, with the normal scaled to unit length there. Without
 * GL_LIGHTING, in color index mode, and for what feedback and the raster position take, it is GL_SMOOTH.
 * GL_PHONG_HINT_WIN is a target of glHint; it is kept and has no effect. */
#ifndef GL_WIN_phong_shading
#define GL_WIN_phong_shading 1
#define GL_PHONG_WIN                               0x80EA
#define GL_PHONG_HINT_WIN                          0x80EB
#endif

/* Phong's own highlight: with glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, GL_TRUE) n.h in the lighting equation
 * is replaced by r.p, the unit vector to the light reflected at the normal, r = 2(n.l)n - l, times that to the viewer
 * ((0, 0, 1) without GL_LIGHT_MODEL_LOCAL_VIEWER). Initially GL_FALSE. */
#ifndef GL_APPLE_specular_vector
#define GL_APPLE_specular_vector 1
#define GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE       0x85B0
#endif

/* The largest GL_SHININESS of glMaterial and GL_SPOT_EXPONENT of glLight: limits for glGet. */
#ifndef GL_NV_light_max_exponent
#define GL_NV_light_max_exponent 1
#define GL_MAX_SHININESS_NV                        0x8504
#define GL_MAX_SPOT_EXPONENT_NV                    0x8505
#endif

/* Normals rescaled by a uniform modelview scale, as in OpenGL 1.2. */
#ifndef GL_EXT_rescale_normal
#define GL_EXT_rescale_normal 1
#define GL_RESCALE_NORMAL_EXT                      0x803A
#endif

/* Highlights added after texturing, as in OpenGL 1.2. */
#ifndef GL_EXT_separate_specular_color
#define GL_EXT_separate_specular_color 1
#define GL_LIGHT_MODEL_COLOR_CONTROL_EXT           0x81F8
#define GL_SINGLE_COLOR_EXT                        0x81F9
#define GL_SEPARATE_SPECULAR_COLOR_EXT             0x81FA
#endif

/* Texture objects, as in OpenGL 1.1. */
#ifndef GL_EXT_texture_object
#define GL_EXT_texture_object 1
#define GL_TEXTURE_PRIORITY_EXT                    0x8066
#define GL_TEXTURE_RESIDENT_EXT                    0x8067
#define GL_TEXTURE_1D_BINDING_EXT                  0x8068
#define GL_TEXTURE_2D_BINDING_EXT                  0x8069
#define GL_TEXTURE_3D_BINDING_EXT                  0x806A
#ifdef GL_GLEXT_PROTOTYPES
GLAPI GLboolean GLAPIENTRY glAreTexturesResidentEXT(GLsizei n, const GLuint *textures, GLboolean *residences);
GLAPI void GLAPIENTRY glBindTextureEXT(GLenum target, GLuint texture);
GLAPI void GLAPIENTRY glDeleteTexturesEXT(GLsizei n, const GLuint *textures);
GLAPI void GLAPIENTRY glGenTexturesEXT(GLsizei n, GLuint *textures);
GLAPI GLboolean GLAPIENTRY glIsTextureEXT(GLuint texture);
GLAPI void GLAPIENTRY glPrioritizeTexturesEXT(GLsizei n, const GLuint *textures, const GLclampf *priorities);
#endif
typedef GLboolean (APIENTRYP PFNGLARETEXTURESRESIDENTEXTPROC)(GLsizei n, const GLuint *textures,
        GLboolean *residences);
typedef void (APIENTRYP PFNGLBINDTEXTUREEXTPROC)(GLenum target, GLuint texture);
typedef void (APIENTRYP PFNGLDELETETEXTURESEXTPROC)(GLsizei n, const GLuint *textures);
typedef void (APIENTRYP PFNGLGENTEXTURESEXTPROC)(GLsizei n, GLuint *textures);
typedef GLboolean (APIENTRYP PFNGLISTEXTUREEXTPROC)(GLuint texture);
typedef void (APIENTRYP PFNGLPRIORITIZETEXTURESEXTPROC)(GLsizei n, const GLuint *textures,
        const GLclampf *priorities);
#endif

/* Vertex arrays, as in OpenGL 1.1; count says how many elements an array has, arrays are switched by
 * glEnable. */
#ifndef GL_EXT_vertex_array
#define GL_EXT_vertex_array 1
#define GL_VERTEX_ARRAY_EXT                        0x8074
#define GL_NORMAL_ARRAY_EXT                        0x8075
#define GL_COLOR_ARRAY_EXT                         0x8076
#define GL_INDEX_ARRAY_EXT                         0x8077
#define GL_TEXTURE_COORD_ARRAY_EXT                 0x8078
#define GL_EDGE_FLAG_ARRAY_EXT                     0x8079
#define GL_VERTEX_ARRAY_SIZE_EXT                   0x807A
#define GL_VERTEX_ARRAY_TYPE_EXT                   0x807B
#define GL_VERTEX_ARRAY_STRIDE_EXT                 0x807C
#define GL_VERTEX_ARRAY_COUNT_EXT                  0x807D
#define GL_NORMAL_ARRAY_TYPE_EXT                   0x807E
#define GL_NORMAL_ARRAY_STRIDE_EXT                 0x807F
#define GL_NORMAL_ARRAY_COUNT_EXT                  0x8080
#define GL_COLOR_ARRAY_SIZE_EXT                    0x8081
#define GL_COLOR_ARRAY_TYPE_EXT                    0x8082
#define GL_COLOR_ARRAY_STRIDE_EXT                  0x8083
#define GL_COLOR_ARRAY_COUNT_EXT                   0x8084
#define GL_INDEX_ARRAY_TYPE_EXT                    0x8085
#define GL_INDEX_ARRAY_STRIDE_EXT                  0x8086
#define GL_INDEX_ARRAY_COUNT_EXT                   0x8087
#define GL_TEXTURE_COORD_ARRAY_SIZE_EXT            0x8088
#define GL_TEXTURE_COORD_ARRAY_TYPE_EXT            0x8089
#define GL_TEXTURE_COORD_ARRAY_STRIDE_EXT          0x808A
#define GL_TEXTURE_COORD_ARRAY_COUNT_EXT           0x808B
#define GL_EDGE_FLAG_ARRAY_STRIDE_EXT              0x808C
#define GL_EDGE_FLAG_ARRAY_COUNT_EXT               0x808D
#define GL_VERTEX_ARRAY_POINTER_EXT                0x808E
#define GL_NORMAL_ARRAY_POINTER_EXT                0x808F
#define GL_COLOR_ARRAY_POINTER_EXT                 0x8090
#define GL_INDEX_ARRAY_POINTER_EXT                 0x8091
#define GL_TEXTURE_COORD_ARRAY_POINTER_EXT         0x8092
#define GL_EDGE_FLAG_ARRAY_POINTER_EXT             0x8093
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glArrayElementEXT(GLint i);
GLAPI void GLAPIENTRY glColorPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count,
                                        const void *pointer);
GLAPI void GLAPIENTRY glDrawArraysEXT(GLenum mode, GLint first, GLsizei count);
GLAPI void GLAPIENTRY glEdgeFlagPointerEXT(GLsizei stride, GLsizei count, const GLboolean *pointer);
GLAPI void GLAPIENTRY glGetPointervEXT(GLenum pname, void **params);
GLAPI void GLAPIENTRY glIndexPointerEXT(GLenum type, GLsizei stride, GLsizei count, const void *pointer);
GLAPI void GLAPIENTRY glNormalPointerEXT(GLenum type, GLsizei stride, GLsizei count, const void *pointer);
GLAPI void GLAPIENTRY glTexCoordPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count,
                                           const void *pointer);
GLAPI void GLAPIENTRY glVertexPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei count,
                                         const void *pointer);
#endif
typedef void (APIENTRYP PFNGLARRAYELEMENTEXTPROC)(GLint i);
typedef void (APIENTRYP PFNGLCOLORPOINTEREXTPROC)(GLint size, GLenum type, GLsizei stride, GLsizei count,
        const void *pointer);
typedef void (APIENTRYP PFNGLDRAWARRAYSEXTPROC)(GLenum mode, GLint first, GLsizei count);
typedef void (APIENTRYP PFNGLEDGEFLAGPOINTEREXTPROC)(GLsizei stride, GLsizei count, const GLboolean *pointer);
typedef void (APIENTRYP PFNGLGETPOINTERVEXTPROC)(GLenum pname, void **params);
typedef void (APIENTRYP PFNGLINDEXPOINTEREXTPROC)(GLenum type, GLsizei stride, GLsizei count,
        const void *pointer);
typedef void (APIENTRYP PFNGLNORMALPOINTEREXTPROC)(GLenum type, GLsizei stride, GLsizei count,
        const void *pointer);
typedef void (APIENTRYP PFNGLTEXCOORDPOINTEREXTPROC)(GLint size, GLenum type, GLsizei stride, GLsizei count,
        const void *pointer);
typedef void (APIENTRYP PFNGLVERTEXPOINTEREXTPROC)(GLint size, GLenum type, GLsizei stride, GLsizei count,
        const void *pointer);
#endif


/* Samples per pixel, as in OpenGL 1.3: there is one. */
#ifndef GL_ARB_multisample
#define GL_ARB_multisample 1
#define GL_MULTISAMPLE_ARB                        0x809D
#define GL_SAMPLE_ALPHA_TO_COVERAGE_ARB           0x809E
#define GL_SAMPLE_ALPHA_TO_ONE_ARB                0x809F
#define GL_SAMPLE_COVERAGE_ARB                    0x80A0
#define GL_SAMPLE_BUFFERS_ARB                     0x80A8
#define GL_SAMPLES_ARB                            0x80A9
#define GL_SAMPLE_COVERAGE_VALUE_ARB              0x80AA
#define GL_SAMPLE_COVERAGE_INVERT_ARB             0x80AB
#define GL_MULTISAMPLE_BIT_ARB                    0x20000000
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glSampleCoverageARB(GLfloat value, GLboolean invert);
#endif
typedef void (APIENTRYP PFNGLSAMPLECOVERAGEARBPROC)(GLfloat value, GLboolean invert);
#endif

/* Matrices given by rows, as in OpenGL 1.3. */
#ifndef GL_ARB_transpose_matrix
#define GL_ARB_transpose_matrix 1
#define GL_TRANSPOSE_MODELVIEW_MATRIX_ARB         0x84E3
#define GL_TRANSPOSE_PROJECTION_MATRIX_ARB        0x84E4
#define GL_TRANSPOSE_TEXTURE_MATRIX_ARB           0x84E5
#define GL_TRANSPOSE_COLOR_MATRIX_ARB             0x84E6
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glLoadTransposeMatrixfARB(const GLfloat *m);
GLAPI void GLAPIENTRY glLoadTransposeMatrixdARB(const GLdouble *m);
GLAPI void GLAPIENTRY glMultTransposeMatrixfARB(const GLfloat *m);
GLAPI void GLAPIENTRY glMultTransposeMatrixdARB(const GLdouble *m);
#endif
typedef void (APIENTRYP PFNGLLOADTRANSPOSEMATRIXFARBPROC)(const GLfloat *m);
typedef void (APIENTRYP PFNGLLOADTRANSPOSEMATRIXDARBPROC)(const GLdouble *m);
typedef void (APIENTRYP PFNGLMULTTRANSPOSEMATRIXFARBPROC)(const GLfloat *m);
typedef void (APIENTRYP PFNGLMULTTRANSPOSEMATRIXDARBPROC)(const GLdouble *m);
#endif

/* Points whose size depends on their distance, as in OpenGL 1.4. */
#ifndef GL_ARB_point_parameters
#define GL_ARB_point_parameters 1
#define GL_POINT_SIZE_MIN_ARB                     0x8126
#define GL_POINT_SIZE_MAX_ARB                     0x8127
#define GL_POINT_FADE_THRESHOLD_SIZE_ARB          0x8128
#define GL_POINT_DISTANCE_ATTENUATION_ARB         0x8129
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glPointParameterfARB(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPointParameterfvARB(GLenum pname, const GLfloat *params);
#endif
typedef void (APIENTRYP PFNGLPOINTPARAMETERFARBPROC)(GLenum pname, GLfloat param);
typedef void (APIENTRYP PFNGLPOINTPARAMETERFVARBPROC)(GLenum pname, const GLfloat *params);
#endif

#ifndef GL_EXT_point_parameters
#define GL_EXT_point_parameters 1
#define GL_POINT_SIZE_MIN_EXT                     0x8126
#define GL_POINT_SIZE_MAX_EXT                     0x8127
#define GL_POINT_FADE_THRESHOLD_SIZE_EXT          0x8128
#define GL_DISTANCE_ATTENUATION_EXT               0x8129
#ifdef GL_GLEXT_PROTOTYPES
/* As glPointParameterf. */
GLAPI void GLAPIENTRY glPointParameterfEXT(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPointParameterfvEXT(GLenum pname, const GLfloat *params);
#endif
typedef void (APIENTRYP PFNGLPOINTPARAMETERFEXTPROC)(GLenum pname, GLfloat param);
typedef void (APIENTRYP PFNGLPOINTPARAMETERFVEXTPROC)(GLenum pname, const GLfloat *params);
#endif

/* Buffer objects, as in OpenGL 1.5. */
#ifndef GL_ARB_vertex_buffer_object
#define GL_ARB_vertex_buffer_object 1
#define GL_BUFFER_SIZE_ARB                        0x8764
#define GL_BUFFER_USAGE_ARB                       0x8765
#define GL_ARRAY_BUFFER_ARB                       0x8892
#define GL_ELEMENT_ARRAY_BUFFER_ARB               0x8893
#define GL_ARRAY_BUFFER_BINDING_ARB               0x8894
#define GL_ELEMENT_ARRAY_BUFFER_BINDING_ARB       0x8895
#define GL_VERTEX_ARRAY_BUFFER_BINDING_ARB        0x8896
#define GL_NORMAL_ARRAY_BUFFER_BINDING_ARB        0x8897
#define GL_COLOR_ARRAY_BUFFER_BINDING_ARB         0x8898
#define GL_INDEX_ARRAY_BUFFER_BINDING_ARB         0x8899
#define GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING_ARB 0x889A
#define GL_EDGE_FLAG_ARRAY_BUFFER_BINDING_ARB     0x889B
#define GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING_ARB 0x889C
#define GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING_ARB 0x889D
#define GL_WEIGHT_ARRAY_BUFFER_BINDING_ARB        0x889E
#define GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING_ARB 0x889F
#define GL_READ_ONLY_ARB                          0x88B8
#define GL_WRITE_ONLY_ARB                         0x88B9
#define GL_READ_WRITE_ARB                         0x88BA
#define GL_BUFFER_ACCESS_ARB                      0x88BB
#define GL_BUFFER_MAPPED_ARB                      0x88BC
#define GL_BUFFER_MAP_POINTER_ARB                 0x88BD
#define GL_STREAM_DRAW_ARB                        0x88E0
#define GL_STREAM_READ_ARB                        0x88E1
#define GL_STREAM_COPY_ARB                        0x88E2
#define GL_STATIC_DRAW_ARB                        0x88E4
#define GL_STATIC_READ_ARB                        0x88E5
#define GL_STATIC_COPY_ARB                        0x88E6
#define GL_DYNAMIC_DRAW_ARB                       0x88E8
#define GL_DYNAMIC_READ_ARB                       0x88E9
#define GL_DYNAMIC_COPY_ARB                       0x88EA
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBindBufferARB(GLenum target, GLuint buffer);
GLAPI void GLAPIENTRY glDeleteBuffersARB(GLsizei n, const GLuint *buffers);
GLAPI void GLAPIENTRY glGenBuffersARB(GLsizei n, GLuint *buffers);
GLAPI GLboolean GLAPIENTRY glIsBufferARB(GLuint buffer);
GLAPI void GLAPIENTRY glBufferDataARB(GLenum target, GLsizeiptr size, const void *data, GLenum usage);
GLAPI void GLAPIENTRY glBufferSubDataARB(GLenum target, GLintptr offset, GLsizeiptr size, const void *data);
GLAPI void GLAPIENTRY glGetBufferSubDataARB(GLenum target, GLintptr offset, GLsizeiptr size, void *data);
GLAPI void *GLAPIENTRY glMapBufferARB(GLenum target, GLenum access);
GLAPI GLboolean GLAPIENTRY glUnmapBufferARB(GLenum target);
GLAPI void GLAPIENTRY glGetBufferParameterivARB(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetBufferPointervARB(GLenum target, GLenum pname, void **params);
#endif
typedef void (APIENTRYP PFNGLBINDBUFFERARBPROC)(GLenum target, GLuint buffer);
typedef void (APIENTRYP PFNGLDELETEBUFFERSARBPROC)(GLsizei n, const GLuint *buffers);
typedef void (APIENTRYP PFNGLGENBUFFERSARBPROC)(GLsizei n, GLuint *buffers);
typedef GLboolean (APIENTRYP PFNGLISBUFFERARBPROC)(GLuint buffer);
typedef void (APIENTRYP PFNGLBUFFERDATAARBPROC)(GLenum target, GLsizeiptr size, const void *data,
        GLenum usage);
typedef void (APIENTRYP PFNGLBUFFERSUBDATAARBPROC)(GLenum target, GLintptr offset, GLsizeiptr size,
        const void *data);
typedef void (APIENTRYP PFNGLGETBUFFERSUBDATAARBPROC)(GLenum target, GLintptr offset, GLsizeiptr size,
        void *data);
typedef void *(APIENTRYP PFNGLMAPBUFFERARBPROC)(GLenum target, GLenum access);
typedef GLboolean (APIENTRYP PFNGLUNMAPBUFFERARBPROC)(GLenum target);
typedef void (APIENTRYP PFNGLGETBUFFERPARAMETERIVARBPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETBUFFERPOINTERVARBPROC)(GLenum target, GLenum pname, void **params);
#endif

/* Counts of samples that pass the depth test, as in OpenGL 1.5. */
#ifndef GL_ARB_occlusion_query
#define GL_ARB_occlusion_query 1
#define GL_QUERY_COUNTER_BITS_ARB                 0x8864
#define GL_CURRENT_QUERY_ARB                      0x8865
#define GL_QUERY_RESULT_ARB                       0x8866
#define GL_QUERY_RESULT_AVAILABLE_ARB             0x8867
#define GL_SAMPLES_PASSED_ARB                     0x8914
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glGenQueriesARB(GLsizei n, GLuint *ids);
GLAPI void GLAPIENTRY glDeleteQueriesARB(GLsizei n, const GLuint *ids);
GLAPI GLboolean GLAPIENTRY glIsQueryARB(GLuint id);
GLAPI void GLAPIENTRY glBeginQueryARB(GLenum target, GLuint id);
GLAPI void GLAPIENTRY glEndQueryARB(GLenum target);
GLAPI void GLAPIENTRY glGetQueryivARB(GLenum target, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetQueryObjectivARB(GLuint id, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetQueryObjectuivARB(GLuint id, GLenum pname, GLuint *params);
#endif
typedef void (APIENTRYP PFNGLGENQUERIESARBPROC)(GLsizei n, GLuint *ids);
typedef void (APIENTRYP PFNGLDELETEQUERIESARBPROC)(GLsizei n, const GLuint *ids);
typedef GLboolean (APIENTRYP PFNGLISQUERYARBPROC)(GLuint id);
typedef void (APIENTRYP PFNGLBEGINQUERYARBPROC)(GLenum target, GLuint id);
typedef void (APIENTRYP PFNGLENDQUERYARBPROC)(GLenum target);
typedef void (APIENTRYP PFNGLGETQUERYIVARBPROC)(GLenum target, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETQUERYOBJECTIVARBPROC)(GLuint id, GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGETQUERYOBJECTUIVARBPROC)(GLuint id, GLenum pname, GLuint *params);
#endif

/* Pixels with alpha first. */
#ifndef GL_EXT_abgr
#define GL_EXT_abgr 1
#define GL_ABGR_EXT                               0x8000
#endif

/* A constant color for blending, as in OpenGL 1.4. */
#ifndef GL_EXT_blend_color
#define GL_EXT_blend_color 1
#define GL_CONSTANT_COLOR_EXT                     0x8001
#define GL_ONE_MINUS_CONSTANT_COLOR_EXT           0x8002
#define GL_CONSTANT_ALPHA_EXT                     0x8003
#define GL_ONE_MINUS_CONSTANT_ALPHA_EXT           0x8004
#define GL_BLEND_COLOR_EXT                        0x8005
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBlendColorEXT(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
#endif
typedef void (APIENTRYP PFNGLBLENDCOLOREXTPROC)(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
#endif

/* Other blend equations than the sum, as in OpenGL 1.4. */
#ifndef GL_EXT_blend_minmax
#define GL_EXT_blend_minmax 1
#define GL_MIN_EXT                                0x8007
#define GL_MAX_EXT                                0x8008
#define GL_FUNC_ADD_EXT                           0x8006
#define GL_BLEND_EQUATION_EXT                     0x8009
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBlendEquationEXT(GLenum mode);
#endif
typedef void (APIENTRYP PFNGLBLENDEQUATIONEXTPROC)(GLenum mode);
#endif

#ifndef GL_EXT_blend_subtract
#define GL_EXT_blend_subtract 1
#define GL_FUNC_SUBTRACT_EXT                      0x800A
#define GL_FUNC_REVERSE_SUBTRACT_EXT              0x800B
#endif

/* Blend factors of their own for alpha, as in OpenGL 1.4. */
#ifndef GL_EXT_blend_func_separate
#define GL_EXT_blend_func_separate 1
#define GL_BLEND_DST_RGB_EXT                      0x80C8
#define GL_BLEND_SRC_RGB_EXT                      0x80C9
#define GL_BLEND_DST_ALPHA_EXT                    0x80CA
#define GL_BLEND_SRC_ALPHA_EXT                    0x80CB
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBlendFuncSeparateEXT(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha,
        GLenum dfactorAlpha);
#endif
typedef void (APIENTRYP PFNGLBLENDFUNCSEPARATEEXTPROC)(GLenum sfactorRGB, GLenum dfactorRGB,
        GLenum sfactorAlpha, GLenum dfactorAlpha);
#endif

/* A promise not to change arrays while they are locked. GL_INVALID_VALUE: first < 0 or count <= 0.
 * GL_INVALID_OPERATION: locked already, or not locked. */
#ifndef GL_EXT_compiled_vertex_array
#define GL_EXT_compiled_vertex_array 1
#define GL_ARRAY_ELEMENT_LOCK_FIRST_EXT           0x81A8
#define GL_ARRAY_ELEMENT_LOCK_COUNT_EXT           0x81A9
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glLockArraysEXT(GLint first, GLsizei count);
GLAPI void GLAPIENTRY glUnlockArraysEXT(void);
#endif
typedef void (APIENTRYP PFNGLLOCKARRAYSEXTPROC)(GLint first, GLsizei count);
typedef void (APIENTRYP PFNGLUNLOCKARRAYSEXTPROC)(void);
#endif

/* Elements in a known range, as in OpenGL 1.2. */
#ifndef GL_EXT_draw_range_elements
#define GL_EXT_draw_range_elements 1
#define GL_MAX_ELEMENTS_VERTICES_EXT              0x80E8
#define GL_MAX_ELEMENTS_INDICES_EXT               0x80E9
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glDrawRangeElementsEXT(GLenum mode, GLuint start, GLuint end, GLsizei count,
        GLenum type, const void *indices);
#endif
typedef void (APIENTRYP PFNGLDRAWRANGEELEMENTSEXTPROC)(GLenum mode, GLuint start, GLuint end, GLsizei count,
        GLenum type, const void *indices);
#endif

/* Fog coordinates of vertices, as in OpenGL 1.4. */
#ifndef GL_EXT_fog_coord
#define GL_EXT_fog_coord 1
#define GL_FOG_COORDINATE_SOURCE_EXT              0x8450
#define GL_FOG_COORDINATE_EXT                     0x8451
#define GL_FRAGMENT_DEPTH_EXT                     0x8452
#define GL_CURRENT_FOG_COORDINATE_EXT             0x8453
#define GL_FOG_COORDINATE_ARRAY_TYPE_EXT          0x8454
#define GL_FOG_COORDINATE_ARRAY_STRIDE_EXT        0x8455
#define GL_FOG_COORDINATE_ARRAY_POINTER_EXT       0x8456
#define GL_FOG_COORDINATE_ARRAY_EXT               0x8457
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glFogCoordfEXT(GLfloat coord);
GLAPI void GLAPIENTRY glFogCoordfvEXT(const GLfloat *coord);
GLAPI void GLAPIENTRY glFogCoorddEXT(GLdouble coord);
GLAPI void GLAPIENTRY glFogCoorddvEXT(const GLdouble *coord);
GLAPI void GLAPIENTRY glFogCoordPointerEXT(GLenum type, GLsizei stride, const void *pointer);
#endif
typedef void (APIENTRYP PFNGLFOGCOORDFEXTPROC)(GLfloat coord);
typedef void (APIENTRYP PFNGLFOGCOORDFVEXTPROC)(const GLfloat *coord);
typedef void (APIENTRYP PFNGLFOGCOORDDEXTPROC)(GLdouble coord);
typedef void (APIENTRYP PFNGLFOGCOORDDVEXTPROC)(const GLdouble *coord);
typedef void (APIENTRYP PFNGLFOGCOORDPOINTEREXTPROC)(GLenum type, GLsizei stride, const void *pointer);
#endif

/* Several draws in one call, as in OpenGL 1.4. */
#ifndef GL_EXT_multi_draw_arrays
#define GL_EXT_multi_draw_arrays 1
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glMultiDrawArraysEXT(GLenum mode, const GLint *first, const GLsizei *count,
        GLsizei primcount);
GLAPI void GLAPIENTRY glMultiDrawElementsEXT(GLenum mode, const GLsizei *count, GLenum type,
        const void *const *indices, GLsizei primcount);
#endif
typedef void (APIENTRYP PFNGLMULTIDRAWARRAYSEXTPROC)(GLenum mode, const GLint *first, const GLsizei *count,
        GLsizei primcount);
typedef void (APIENTRYP PFNGLMULTIDRAWELEMENTSEXTPROC)(GLenum mode, const GLsizei *count, GLenum type,
        const void *const *indices, GLsizei primcount);
#endif

/* A color added after texturing, as in OpenGL 1.4. */
#ifndef GL_EXT_secondary_color
#define GL_EXT_secondary_color 1
#define GL_COLOR_SUM_EXT                          0x8458
#define GL_CURRENT_SECONDARY_COLOR_EXT            0x8459
#define GL_SECONDARY_COLOR_ARRAY_SIZE_EXT         0x845A
#define GL_SECONDARY_COLOR_ARRAY_TYPE_EXT         0x845B
#define GL_SECONDARY_COLOR_ARRAY_STRIDE_EXT       0x845C
#define GL_SECONDARY_COLOR_ARRAY_POINTER_EXT      0x845D
#define GL_SECONDARY_COLOR_ARRAY_EXT              0x845E
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glSecondaryColor3bEXT(GLbyte red, GLbyte green, GLbyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3bvEXT(const GLbyte *v);
GLAPI void GLAPIENTRY glSecondaryColor3dEXT(GLdouble red, GLdouble green, GLdouble blue);
GLAPI void GLAPIENTRY glSecondaryColor3dvEXT(const GLdouble *v);
GLAPI void GLAPIENTRY glSecondaryColor3fEXT(GLfloat red, GLfloat green, GLfloat blue);
GLAPI void GLAPIENTRY glSecondaryColor3fvEXT(const GLfloat *v);
GLAPI void GLAPIENTRY glSecondaryColor3iEXT(GLint red, GLint green, GLint blue);
GLAPI void GLAPIENTRY glSecondaryColor3ivEXT(const GLint *v);
GLAPI void GLAPIENTRY glSecondaryColor3sEXT(GLshort red, GLshort green, GLshort blue);
GLAPI void GLAPIENTRY glSecondaryColor3svEXT(const GLshort *v);
GLAPI void GLAPIENTRY glSecondaryColor3ubEXT(GLubyte red, GLubyte green, GLubyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3ubvEXT(const GLubyte *v);
GLAPI void GLAPIENTRY glSecondaryColor3uiEXT(GLuint red, GLuint green, GLuint blue);
GLAPI void GLAPIENTRY glSecondaryColor3uivEXT(const GLuint *v);
GLAPI void GLAPIENTRY glSecondaryColor3usEXT(GLushort red, GLushort green, GLushort blue);
GLAPI void GLAPIENTRY glSecondaryColor3usvEXT(const GLushort *v);
GLAPI void GLAPIENTRY glSecondaryColorPointerEXT(GLint size, GLenum type, GLsizei stride,
        const void *pointer);
#endif
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3BEXTPROC)(GLbyte red, GLbyte green, GLbyte blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3BVEXTPROC)(const GLbyte *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3DEXTPROC)(GLdouble red, GLdouble green, GLdouble blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3DVEXTPROC)(const GLdouble *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3FEXTPROC)(GLfloat red, GLfloat green, GLfloat blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3FVEXTPROC)(const GLfloat *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3IEXTPROC)(GLint red, GLint green, GLint blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3IVEXTPROC)(const GLint *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3SEXTPROC)(GLshort red, GLshort green, GLshort blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3SVEXTPROC)(const GLshort *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UBEXTPROC)(GLubyte red, GLubyte green, GLubyte blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UBVEXTPROC)(const GLubyte *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UIEXTPROC)(GLuint red, GLuint green, GLuint blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3UIVEXTPROC)(const GLuint *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3USEXTPROC)(GLushort red, GLushort green, GLushort blue);
typedef void (APIENTRYP PFNGLSECONDARYCOLOR3USVEXTPROC)(const GLushort *v);
typedef void (APIENTRYP PFNGLSECONDARYCOLORPOINTEREXTPROC)(GLint size, GLenum type, GLsizei stride,
        const void *pointer);
#endif

/* Stencil operations that wrap around, as in OpenGL 1.4. */
#ifndef GL_EXT_stencil_wrap
#define GL_EXT_stencil_wrap 1
#define GL_INCR_WRAP_EXT                          0x8507
#define GL_DECR_WRAP_EXT                          0x8508
#endif

/* Colors as factors of themselves, as in OpenGL 1.4. */
#ifndef GL_NV_blend_square
#define GL_NV_blend_square 1
#endif


/* ---- Extensions beyond OpenGL 1.5 ---------------------------------------------------------------------- */

/* Points drawn as textured squares: an enable, and a texture environment of its own (target
 * GL_POINT_SPRITE_ARB) with GL_COORD_REPLACE_ARB, per unit: texture coordinates run over the point from 0 to
 * 1. */
#ifndef GL_ARB_point_sprite
#define GL_ARB_point_sprite 1
#define GL_POINT_SPRITE_ARB                        0x8861
#define GL_COORD_REPLACE_ARB                       0x8862
#endif

/* A blend equation of its own for alpha. GL_INVALID_ENUM: no blend equation. */
#ifndef GL_EXT_blend_equation_separate
#define GL_EXT_blend_equation_separate 1
#define GL_BLEND_EQUATION_RGB_EXT                 0x8009
#define GL_BLEND_EQUATION_ALPHA_EXT               0x883D
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBlendEquationSeparateEXT(GLenum modeRGB, GLenum modeAlpha);
#endif
typedef void (APIENTRYP PFNGLBLENDEQUATIONSEPARATEEXTPROC)(GLenum modeRGB, GLenum modeAlpha);
#endif

/* Depth and stencil of one pixel in one 32-bit word: depth in the upper 24 bits, stencil in the lower 8. */
#ifndef GL_EXT_packed_depth_stencil
#define GL_EXT_packed_depth_stencil 1
#define GL_DEPTH_STENCIL_EXT                       0x84F9
#define GL_UNSIGNED_INT_24_8_EXT                   0x84FA
#define GL_DEPTH24_STENCIL8_EXT                    0x88F0
#define GL_TEXTURE_STENCIL_SIZE_EXT                0x88F1
#endif

/* Lighting computed per fragment: GL_PHONG_WIN for glShadeModel, and a hint. */
#ifndef GL_WIN_phong_shading
#define GL_WIN_phong_shading 1
#define GL_PHONG_WIN                               0x80EA
#define GL_PHONG_HINT_WIN                          0x80EB
#endif

/* Highlights from the reflected light vector instead of the half vector: a boolean for glLightModel. */
#ifndef GL_APPLE_specular_vector
#define GL_APPLE_specular_vector 1
#define GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE       0x85B0
#endif

/* Limits of GL_SHININESS and GL_SPOT_EXPONENT that may be above 128, for glGet. */
#ifndef GL_NV_light_max_exponent
#define GL_NV_light_max_exponent 1
#define GL_MAX_SHININESS_NV                        0x8504
#define GL_MAX_SPOT_EXPONENT_NV                    0x8505
#endif

/* Framebuffers made of renderbuffers and textures, to draw into instead of the caller's buffer. */
#ifndef GL_EXT_framebuffer_object
#define GL_EXT_framebuffer_object 1

/* Targets, attachment points, bindings and limits. */
#define GL_FRAMEBUFFER_EXT                         0x8D40
#define GL_RENDERBUFFER_EXT                        0x8D41
#define GL_COLOR_ATTACHMENT0_EXT                   0x8CE0
#define GL_COLOR_ATTACHMENT1_EXT                   0x8CE1
#define GL_COLOR_ATTACHMENT2_EXT                   0x8CE2
#define GL_COLOR_ATTACHMENT3_EXT                   0x8CE3
#define GL_COLOR_ATTACHMENT4_EXT                   0x8CE4
#define GL_COLOR_ATTACHMENT5_EXT                   0x8CE5
#define GL_COLOR_ATTACHMENT6_EXT                   0x8CE6
#define GL_COLOR_ATTACHMENT7_EXT                   0x8CE7
#define GL_COLOR_ATTACHMENT8_EXT                   0x8CE8
#define GL_COLOR_ATTACHMENT9_EXT                   0x8CE9
#define GL_COLOR_ATTACHMENT10_EXT                  0x8CEA
#define GL_COLOR_ATTACHMENT11_EXT                  0x8CEB
#define GL_COLOR_ATTACHMENT12_EXT                  0x8CEC
#define GL_COLOR_ATTACHMENT13_EXT                  0x8CED
#define GL_COLOR_ATTACHMENT14_EXT                  0x8CEE
#define GL_COLOR_ATTACHMENT15_EXT                  0x8CEF
#define GL_DEPTH_ATTACHMENT_EXT                    0x8D00
#define GL_STENCIL_ATTACHMENT_EXT                  0x8D20
#define GL_FRAMEBUFFER_BINDING_EXT                 0x8CA6
#define GL_RENDERBUFFER_BINDING_EXT                0x8CA7
#define GL_MAX_COLOR_ATTACHMENTS_EXT               0x8CDF
#define GL_MAX_RENDERBUFFER_SIZE_EXT               0x84E8

/* Properties of an attachment and of a renderbuffer, and stencil formats. */
#define GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE_EXT  0x8CD0
#define GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_EXT  0x8CD1
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL_EXT 0x8CD2
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE_EXT 0x8CD3
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_3D_ZOFFSET_EXT 0x8CD4
#define GL_RENDERBUFFER_WIDTH_EXT                  0x8D42
#define GL_RENDERBUFFER_HEIGHT_EXT                 0x8D43
#define GL_RENDERBUFFER_INTERNAL_FORMAT_EXT        0x8D44
#define GL_RENDERBUFFER_RED_SIZE_EXT               0x8D50
#define GL_RENDERBUFFER_GREEN_SIZE_EXT             0x8D51
#define GL_RENDERBUFFER_BLUE_SIZE_EXT              0x8D52
#define GL_RENDERBUFFER_ALPHA_SIZE_EXT             0x8D53
#define GL_RENDERBUFFER_DEPTH_SIZE_EXT             0x8D54
#define GL_RENDERBUFFER_STENCIL_SIZE_EXT           0x8D55
#define GL_STENCIL_INDEX1_EXT                      0x8D46
#define GL_STENCIL_INDEX4_EXT                      0x8D47
#define GL_STENCIL_INDEX8_EXT                      0x8D48
#define GL_STENCIL_INDEX16_EXT                     0x8D49

/* Answers of glCheckFramebufferStatusEXT, and the error of drawing or reading when it is not complete. */
#define GL_FRAMEBUFFER_COMPLETE_EXT                0x8CD5
#define GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT_EXT   0x8CD6
#define GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT_EXT 0x8CD7
#define GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS_EXT   0x8CD9
#define GL_FRAMEBUFFER_INCOMPLETE_FORMATS_EXT      0x8CDA
#define GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER_EXT  0x8CDB
#define GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER_EXT  0x8CDC
#define GL_FRAMEBUFFER_UNSUPPORTED_EXT             0x8CDD
#define GL_INVALID_FRAMEBUFFER_OPERATION_EXT       0x0506

#ifdef GL_GLEXT_PROTOTYPES
/* Bind (a new name makes an object, 0 is none), delete, make names, and ask whether a name is that of an
 * object. */
GLAPI void GLAPIENTRY glBindRenderbufferEXT(GLenum target, GLuint renderbuffer);
GLAPI void GLAPIENTRY glDeleteRenderbuffersEXT(GLsizei n, const GLuint *renderbuffers);
GLAPI void GLAPIENTRY glGenRenderbuffersEXT(GLsizei n, GLuint *renderbuffers);
GLAPI GLboolean GLAPIENTRY glIsRenderbufferEXT(GLuint renderbuffer);

/* Gives the bound renderbuffer width x height pixels of a color, depth or stencil format. GL_INVALID_VALUE:
 * larger than GL_MAX_RENDERBUFFER_SIZE_EXT. GL_INVALID_OPERATION: none is bound. */
GLAPI void GLAPIENTRY glRenderbufferStorageEXT(GLenum target, GLenum internalformat, GLsizei width,
                                               GLsizei height);

/* Writes a property of the bound renderbuffer. GL_INVALID_OPERATION: none is bound. */
GLAPI void GLAPIENTRY glGetRenderbufferParameterivEXT(GLenum target, GLenum pname, GLint *params);

/* The same for framebuffers; framebuffer 0 is the caller's buffer. */
GLAPI void GLAPIENTRY glBindFramebufferEXT(GLenum target, GLuint framebuffer);
GLAPI void GLAPIENTRY glDeleteFramebuffersEXT(GLsizei n, const GLuint *framebuffers);
GLAPI void GLAPIENTRY glGenFramebuffersEXT(GLsizei n, GLuint *framebuffers);
GLAPI GLboolean GLAPIENTRY glIsFramebufferEXT(GLuint framebuffer);

/* Returns whether the bound framebuffer can be drawn to, or what is wrong with it. */
GLAPI GLenum GLAPIENTRY glCheckFramebufferStatusEXT(GLenum target);

/* Attach an image of a texture (level; layer zoffset of a 3D one), or a renderbuffer, to the bound
 * framebuffer; name 0 detaches. GL_INVALID_OPERATION: framebuffer 0 is bound, the name is none, the texture
 * has another target. GL_INVALID_VALUE: level or zoffset out of range. */
GLAPI void GLAPIENTRY glFramebufferTexture1DEXT(GLenum target, GLenum attachment, GLenum textarget,
                                                GLuint texture, GLint level);
GLAPI void GLAPIENTRY glFramebufferTexture2DEXT(GLenum target, GLenum attachment, GLenum textarget,
                                                GLuint texture, GLint level);
GLAPI void GLAPIENTRY glFramebufferTexture3DEXT(GLenum target, GLenum attachment, GLenum textarget,
                                                GLuint texture, GLint level, GLint zoffset);
GLAPI void GLAPIENTRY glFramebufferRenderbufferEXT(GLenum target, GLenum attachment,
                                                   GLenum renderbuffertarget, GLuint renderbuffer);

/* Writes a property of an attachment. GL_INVALID_OPERATION: framebuffer 0 is bound. */
GLAPI void GLAPIENTRY glGetFramebufferAttachmentParameterivEXT(GLenum target, GLenum attachment, GLenum pname,
                                                               GLint *params);

/* Makes all smaller levels of the texture bound to target from its base level. */
GLAPI void GLAPIENTRY glGenerateMipmapEXT(GLenum target);
#endif
typedef GLboolean (APIENTRYP PFNGLISRENDERBUFFEREXTPROC)(GLuint renderbuffer);
typedef void (APIENTRYP PFNGLBINDRENDERBUFFEREXTPROC)(GLenum target, GLuint renderbuffer);
typedef void (APIENTRYP PFNGLDELETERENDERBUFFERSEXTPROC)(GLsizei n, const GLuint *renderbuffers);
typedef void (APIENTRYP PFNGLGENRENDERBUFFERSEXTPROC)(GLsizei n, GLuint *renderbuffers);
typedef void (APIENTRYP PFNGLRENDERBUFFERSTORAGEEXTPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLsizei height);
typedef void (APIENTRYP PFNGLGETRENDERBUFFERPARAMETERIVEXTPROC)(GLenum target, GLenum pname, GLint *params);
typedef GLboolean (APIENTRYP PFNGLISFRAMEBUFFEREXTPROC)(GLuint framebuffer);
typedef void (APIENTRYP PFNGLBINDFRAMEBUFFEREXTPROC)(GLenum target, GLuint framebuffer);
typedef void (APIENTRYP PFNGLDELETEFRAMEBUFFERSEXTPROC)(GLsizei n, const GLuint *framebuffers);
typedef void (APIENTRYP PFNGLGENFRAMEBUFFERSEXTPROC)(GLsizei n, GLuint *framebuffers);
typedef GLenum (APIENTRYP PFNGLCHECKFRAMEBUFFERSTATUSEXTPROC)(GLenum target);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE1DEXTPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE2DEXTPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE3DEXTPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level, GLint zoffset);
typedef void (APIENTRYP PFNGLFRAMEBUFFERRENDERBUFFEREXTPROC)(GLenum target, GLenum attachment,
        GLenum renderbuffertarget, GLuint renderbuffer);
typedef void (APIENTRYP PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVEXTPROC)(GLenum target, GLenum attachment,
        GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGENERATEMIPMAPEXTPROC)(GLenum target);
#endif

/* Depth images, as in OpenGL 1.4. */
#ifndef GL_ARB_depth_texture
#define GL_ARB_depth_texture 1
#define GL_DEPTH_COMPONENT16_ARB                   0x81A5
#define GL_DEPTH_COMPONENT24_ARB                   0x81A6
#define GL_DEPTH_COMPONENT32_ARB                   0x81A7
#define GL_TEXTURE_DEPTH_SIZE_ARB                  0x884A
#define GL_DEPTH_TEXTURE_MODE_ARB                  0x884B
#endif

/* Depth textures compared with r, as in OpenGL 1.4. */
#ifndef GL_ARB_shadow
#define GL_ARB_shadow 1
#define GL_TEXTURE_COMPARE_MODE_ARB                0x884C
#define GL_TEXTURE_COMPARE_FUNC_ARB                0x884D
#define GL_COMPARE_R_TO_TEXTURE_ARB                0x884E
#endif

/* Coordinates clamped to the border, as in OpenGL 1.3. */
#ifndef GL_ARB_texture_border_clamp
#define GL_ARB_texture_border_clamp 1
#define GL_CLAMP_TO_BORDER_ARB                     0x812D
#endif

/* Compressed images, as in OpenGL 1.3: no specific format. */
#ifndef GL_ARB_texture_compression
#define GL_ARB_texture_compression 1
#define GL_COMPRESSED_ALPHA_ARB                    0x84E9
#define GL_COMPRESSED_LUMINANCE_ARB                0x84EA
#define GL_COMPRESSED_LUMINANCE_ALPHA_ARB          0x84EB
#define GL_COMPRESSED_INTENSITY_ARB                0x84EC
#define GL_COMPRESSED_RGB_ARB                      0x84ED
#define GL_COMPRESSED_RGBA_ARB                     0x84EE
#define GL_TEXTURE_COMPRESSION_HINT_ARB            0x84EF
#define GL_TEXTURE_COMPRESSED_IMAGE_SIZE_ARB       0x86A0
#define GL_TEXTURE_COMPRESSED_ARB                  0x86A1
#define GL_NUM_COMPRESSED_TEXTURE_FORMATS_ARB      0x86A2
#define GL_COMPRESSED_TEXTURE_FORMATS_ARB          0x86A3
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glCompressedTexImage3DARB(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const GLvoid *data);
GLAPI void GLAPIENTRY glCompressedTexImage2DARB(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const GLvoid *data);
GLAPI void GLAPIENTRY glCompressedTexImage1DARB(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLint border, GLsizei imageSize, const GLvoid *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage3DARB(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize,
        const GLvoid *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage2DARB(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const GLvoid *data);
GLAPI void GLAPIENTRY glCompressedTexSubImage1DARB(GLenum target, GLint level, GLint xoffset, GLsizei width,
        GLenum format, GLsizei imageSize, const GLvoid *data);
GLAPI void GLAPIENTRY glGetCompressedTexImageARB(GLenum target, GLint level, void *img);
#endif
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE3DARBPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE2DARBPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXIMAGE1DARBPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLint border, GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE3DARBPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format,
        GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE2DARBPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLCOMPRESSEDTEXSUBIMAGE1DARBPROC)(GLenum target, GLint level, GLint xoffset,
        GLsizei width, GLenum format, GLsizei imageSize, const GLvoid *data);
typedef void (APIENTRYP PFNGLGETCOMPRESSEDTEXIMAGEARBPROC)(GLenum target, GLint level, void *img);
#endif

/* Cube maps, as in OpenGL 1.3. */
#ifndef GL_ARB_texture_cube_map
#define GL_ARB_texture_cube_map 1
#define GL_NORMAL_MAP_ARB                          0x8511
#define GL_REFLECTION_MAP_ARB                      0x8512
#define GL_TEXTURE_CUBE_MAP_ARB                    0x8513
#define GL_TEXTURE_BINDING_CUBE_MAP_ARB            0x8514
#define GL_TEXTURE_CUBE_MAP_POSITIVE_X_ARB         0x8515
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_X_ARB         0x8516
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Y_ARB         0x8517
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_ARB         0x8518
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Z_ARB         0x8519
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_ARB         0x851A
#define GL_PROXY_TEXTURE_CUBE_MAP_ARB              0x851B
#define GL_MAX_CUBE_MAP_TEXTURE_SIZE_ARB           0x851C
#endif

/* GL_ADD as an environment, as in OpenGL 1.3. */
#ifndef GL_ARB_texture_env_add
#define GL_ARB_texture_env_add 1
#endif

/* The environment GL_COMBINE, as in OpenGL 1.3. */
#ifndef GL_ARB_texture_env_combine
#define GL_ARB_texture_env_combine 1
#define GL_COMBINE_ARB                             0x8570
#define GL_COMBINE_RGB_ARB                         0x8571
#define GL_COMBINE_ALPHA_ARB                       0x8572
#define GL_SOURCE0_RGB_ARB                         0x8580
#define GL_SOURCE1_RGB_ARB                         0x8581
#define GL_SOURCE2_RGB_ARB                         0x8582
#define GL_SOURCE0_ALPHA_ARB                       0x8588
#define GL_SOURCE1_ALPHA_ARB                       0x8589
#define GL_SOURCE2_ALPHA_ARB                       0x858A
#define GL_OPERAND0_RGB_ARB                        0x8590
#define GL_OPERAND1_RGB_ARB                        0x8591
#define GL_OPERAND2_RGB_ARB                        0x8592
#define GL_OPERAND0_ALPHA_ARB                      0x8598
#define GL_OPERAND1_ALPHA_ARB                      0x8599
#define GL_OPERAND2_ALPHA_ARB                      0x859A
#define GL_RGB_SCALE_ARB                           0x8573
#define GL_ADD_SIGNED_ARB                          0x8574
#define GL_INTERPOLATE_ARB                         0x8575
#define GL_SUBTRACT_ARB                            0x84E7
#define GL_CONSTANT_ARB                            0x8576
#define GL_PRIMARY_COLOR_ARB                       0x8577
#define GL_PREVIOUS_ARB                            0x8578
#endif

/* Other units as sources of GL_COMBINE, as in OpenGL 1.4. */
#ifndef GL_ARB_texture_env_crossbar
#define GL_ARB_texture_env_crossbar 1
#endif

/* Dot products in GL_COMBINE, as in OpenGL 1.3. */
#ifndef GL_ARB_texture_env_dot3
#define GL_ARB_texture_env_dot3 1
#define GL_DOT3_RGB_ARB                            0x86AE
#define GL_DOT3_RGBA_ARB                           0x86AF
#endif

#ifndef GL_EXT_pixel_buffer_object
#define GL_EXT_pixel_buffer_object 1
#define GL_PIXEL_PACK_BUFFER_EXT                   0x88EB
#define GL_PIXEL_UNPACK_BUFFER_EXT                 0x88EC
#define GL_PIXEL_PACK_BUFFER_BINDING_EXT           0x88ED
#define GL_PIXEL_UNPACK_BUFFER_BINDING_EXT         0x88EF
#endif

/* The same names in OpenGL 2.1. */
#ifndef GL_PIXEL_PACK_BUFFER
#define GL_PIXEL_PACK_BUFFER                       0x88EB
#define GL_PIXEL_UNPACK_BUFFER                     0x88EC
#define GL_PIXEL_PACK_BUFFER_BINDING               0x88ED
#define GL_PIXEL_UNPACK_BUFFER_BINDING             0x88EF
#endif

/* Textures of GL_TEXTURE_RECTANGLE_ARB have one level and no border, and are addressed by texels: s from 0 to the width, t to the height. Their
 * wrap modes clamp and their filters do not mipmap; GL_INVALID_ENUM otherwise. */
#ifndef GL_ARB_texture_rectangle
#define GL_ARB_texture_rectangle 1
#define GL_EXT_texture_rectangle 1
#define GL_TEXTURE_RECTANGLE_ARB                   0x84F5
#define GL_TEXTURE_BINDING_RECTANGLE_ARB           0x84F6
#define GL_PROXY_TEXTURE_RECTANGLE_ARB             0x84F7
#define GL_MAX_RECTANGLE_TEXTURE_SIZE_ARB          0x84F8
#endif
#ifndef GL_NV_texture_rectangle
#define GL_NV_texture_rectangle 1
#define GL_TEXTURE_RECTANGLE_NV                    0x84F5
#define GL_TEXTURE_BINDING_RECTANGLE_NV            0x84F6
#define GL_PROXY_TEXTURE_RECTANGLE_NV              0x84F7
#define GL_MAX_RECTANGLE_TEXTURE_SIZE_NV           0x84F8
#endif

/* What red, green, blue and alpha of a texel are made of, border and depth textures included: glTexParameter with GL_RED, GL_GREEN, GL_BLUE,
 * GL_ALPHA, GL_ZERO or GL_ONE; all four of GL_TEXTURE_SWIZZLE_RGBA. GL_INVALID_ENUM otherwise. */
#ifndef GL_EXT_texture_swizzle
#define GL_EXT_texture_swizzle 1
#define GL_TEXTURE_SWIZZLE_R_EXT                   0x8E42
#define GL_TEXTURE_SWIZZLE_G_EXT                   0x8E43
#define GL_TEXTURE_SWIZZLE_B_EXT                   0x8E44
#define GL_TEXTURE_SWIZZLE_A_EXT                   0x8E45
#define GL_TEXTURE_SWIZZLE_RGBA_EXT                0x8E46
#endif
#ifndef GL_ARB_texture_swizzle
#define GL_ARB_texture_swizzle 1
#define GL_TEXTURE_SWIZZLE_R                       0x8E42
#define GL_TEXTURE_SWIZZLE_G                       0x8E43
#define GL_TEXTURE_SWIZZLE_B                       0x8E44
#define GL_TEXTURE_SWIZZLE_A                       0x8E45
#define GL_TEXTURE_SWIZZLE_RGBA                    0x8E46
#endif

/* All levels of a texture at once, whose sizes and formats never change after: the glTexImage and glCopyTexImage commands then raise
 * GL_INVALID_OPERATION. internalformat: sized formats; glGetTexParameter has GL_TEXTURE_IMMUTABLE_FORMAT.
 * Errors: GL_INVALID_ENUM for other targets and formats; GL_INVALID_VALUE for sizes or levels below 1 and sizes that are too large;
 * GL_INVALID_OPERATION for more levels than the size has, the default texture, and a texture that has storage. */
#ifndef GL_ARB_texture_storage
#define GL_ARB_texture_storage 1
#define GL_TEXTURE_IMMUTABLE_FORMAT                0x912F
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glTexStorage1D(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width);
GLAPI void GLAPIENTRY glTexStorage2D(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
        GLsizei height);
GLAPI void GLAPIENTRY glTexStorage3D(GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
        GLsizei height, GLsizei depth);
#endif
typedef void(GLAPIENTRYP PFNGLTEXSTORAGE1DPROC)(GLenum target, GLsizei levels, GLenum internalformat,
        GLsizei width);
typedef void(GLAPIENTRYP PFNGLTEXSTORAGE2DPROC)(GLenum target, GLsizei levels, GLenum internalformat,
        GLsizei width, GLsizei height);
typedef void(GLAPIENTRYP PFNGLTEXSTORAGE3DPROC)(GLenum target, GLsizei levels, GLenum internalformat,
        GLsizei width, GLsizei height, GLsizei depth);
#endif

/* A sampler object bound to a unit, from 0, samples in place of the parameters of its textures: wrap modes, filters, border colour, levels of
 * detail, comparison. Pnames and values are those of glTexParameter for these; the I forms take border colours as integers.
 * Errors: GL_INVALID_VALUE for negative counts and units that there are not; GL_INVALID_OPERATION for names that glGenSamplers did not give;
 * GL_INVALID_ENUM for other pnames and values. */
#ifndef GL_ARB_sampler_objects
#define GL_ARB_sampler_objects 1
#define GL_SAMPLER_BINDING                         0x8919
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glGenSamplers(GLsizei count, GLuint *samplers);
GLAPI void GLAPIENTRY glDeleteSamplers(GLsizei count, const GLuint *samplers);
GLAPI GLboolean GLAPIENTRY glIsSampler(GLuint sampler);
GLAPI void GLAPIENTRY glBindSampler(GLuint unit, GLuint sampler);
GLAPI void GLAPIENTRY glSamplerParameteri(GLuint sampler, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glSamplerParameterf(GLuint sampler, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glSamplerParameteriv(GLuint sampler, GLenum pname, const GLint *params);
GLAPI void GLAPIENTRY glSamplerParameterfv(GLuint sampler, GLenum pname, const GLfloat *params);
GLAPI void GLAPIENTRY glSamplerParameterIiv(GLuint sampler, GLenum pname, const GLint *params);
GLAPI void GLAPIENTRY glSamplerParameterIuiv(GLuint sampler, GLenum pname, const GLuint *params);
GLAPI void GLAPIENTRY glGetSamplerParameteriv(GLuint sampler, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetSamplerParameterfv(GLuint sampler, GLenum pname, GLfloat *params);
GLAPI void GLAPIENTRY glGetSamplerParameterIiv(GLuint sampler, GLenum pname, GLint *params);
GLAPI void GLAPIENTRY glGetSamplerParameterIuiv(GLuint sampler, GLenum pname, GLuint *params);
#endif
typedef void(GLAPIENTRYP PFNGLGENSAMPLERSPROC)(GLsizei count, GLuint *samplers);
typedef void(GLAPIENTRYP PFNGLDELETESAMPLERSPROC)(GLsizei count, const GLuint *samplers);
typedef GLboolean(GLAPIENTRYP PFNGLISSAMPLERPROC)(GLuint sampler);
typedef void(GLAPIENTRYP PFNGLBINDSAMPLERPROC)(GLuint unit, GLuint sampler);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERIPROC)(GLuint sampler, GLenum pname, GLint param);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERFPROC)(GLuint sampler, GLenum pname, GLfloat param);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERIVPROC)(GLuint sampler, GLenum pname, const GLint *params);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERFVPROC)(GLuint sampler, GLenum pname, const GLfloat *params);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERIIVPROC)(GLuint sampler, GLenum pname, const GLint *params);
typedef void(GLAPIENTRYP PFNGLSAMPLERPARAMETERIUIVPROC)(GLuint sampler, GLenum pname, const GLuint *params);
typedef void(GLAPIENTRYP PFNGLGETSAMPLERPARAMETERIVPROC)(GLuint sampler, GLenum pname, GLint *params);
typedef void(GLAPIENTRYP PFNGLGETSAMPLERPARAMETERFVPROC)(GLuint sampler, GLenum pname, GLfloat *params);
typedef void(GLAPIENTRYP PFNGLGETSAMPLERPARAMETERIIVPROC)(GLuint sampler, GLenum pname, GLint *params);
typedef void(GLAPIENTRYP PFNGLGETSAMPLERPARAMETERIUIVPROC)(GLuint sampler, GLenum pname, GLuint *params);
#endif

/* glMapBufferRange maps a part of a buffer object, for reading, writing or both: GL_MAP_READ_BIT, GL_MAP_WRITE_BIT. The other bits are hints,
 * but GL_MAP_FLUSH_EXPLICIT_BIT, which allows glFlushMappedBufferRange.
 * Errors: GL_INVALID_VALUE outside of the buffer or for other bits; GL_INVALID_OPERATION for no length, no access, one that contradicts
 * itself, and a buffer that is mapped or none. */
#ifndef GL_ARB_map_buffer_range
#define GL_ARB_map_buffer_range 1
#define GL_MAP_READ_BIT                            0x0001
#define GL_MAP_WRITE_BIT                           0x0002
#define GL_MAP_INVALIDATE_RANGE_BIT                0x0004
#define GL_MAP_INVALIDATE_BUFFER_BIT               0x0008
#define GL_MAP_FLUSH_EXPLICIT_BIT                  0x0010
#define GL_MAP_UNSYNCHRONIZED_BIT                  0x0020
#define GL_BUFFER_ACCESS_FLAGS                     0x911F
#define GL_BUFFER_MAP_LENGTH                       0x9120
#define GL_BUFFER_MAP_OFFSET                       0x9121
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void *GLAPIENTRY glMapBufferRange(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access);
GLAPI void GLAPIENTRY glFlushMappedBufferRange(GLenum target, GLintptr offset, GLsizeiptr length);
#endif
typedef void *(GLAPIENTRYP PFNGLMAPBUFFERRANGEPROC)(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access);
typedef void(GLAPIENTRYP PFNGLFLUSHMAPPEDBUFFERRANGEPROC)(GLenum target, GLintptr offset, GLsizeiptr length);
#endif

/* Mirrored images, as in OpenGL 1.4. */
#ifndef GL_ARB_texture_mirrored_repeat
#define GL_ARB_texture_mirrored_repeat 1
#define GL_MIRRORED_REPEAT_ARB                     0x8370
#endif

/* Images of any size. */
#ifndef GL_ARB_texture_non_power_of_two
#define GL_ARB_texture_non_power_of_two 1
#endif

/* Images from the framebuffer, as in OpenGL 1.1. */
#ifndef GL_EXT_copy_texture
#define GL_EXT_copy_texture 1
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glCopyTexImage1DEXT(GLenum target, GLint level, GLenum internalformat, GLint x,
        GLint y, GLsizei width, GLint border);
GLAPI void GLAPIENTRY glCopyTexImage2DEXT(GLenum target, GLint level, GLenum internalformat, GLint x,
        GLint y, GLsizei width, GLsizei height, GLint border);
GLAPI void GLAPIENTRY glCopyTexSubImage1DEXT(GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
        GLsizei width);
GLAPI void GLAPIENTRY glCopyTexSubImage2DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint x, GLint y, GLsizei width, GLsizei height);
GLAPI void GLAPIENTRY glCopyTexSubImage3DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);
#endif
typedef void (APIENTRYP PFNGLCOPYTEXIMAGE1DEXTPROC)(GLenum target, GLint level, GLenum internalformat,
        GLint x, GLint y, GLsizei width, GLint border);
typedef void (APIENTRYP PFNGLCOPYTEXIMAGE2DEXTPROC)(GLenum target, GLint level, GLenum internalformat,
        GLint x, GLint y, GLsizei width, GLsizei height, GLint border);
typedef void (APIENTRYP PFNGLCOPYTEXSUBIMAGE1DEXTPROC)(GLenum target, GLint level, GLint xoffset, GLint x,
        GLint y, GLsizei width);
typedef void (APIENTRYP PFNGLCOPYTEXSUBIMAGE2DEXTPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height);
typedef void (APIENTRYP PFNGLCOPYTEXSUBIMAGE3DEXTPROC)(GLenum target, GLint level, GLint xoffset,
        GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);
#endif

/* All comparisons of depth textures, as in OpenGL 1.5. */
#ifndef GL_EXT_shadow_funcs
#define GL_EXT_shadow_funcs 1
#endif

/* Parts of images, as in OpenGL 1.1. */
#ifndef GL_EXT_subtexture
#define GL_EXT_subtexture 1
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glTexSubImage1DEXT(GLenum target, GLint level, GLint xoffset, GLsizei width,
        GLenum format, GLenum type, const GLvoid *pixels);
GLAPI void GLAPIENTRY glTexSubImage2DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid *pixels);
#endif
typedef void (APIENTRYP PFNGLTEXSUBIMAGE1DEXTPROC)(GLenum target, GLint level, GLint xoffset, GLsizei width,
        GLenum format, GLenum type, const GLvoid *pixels);
typedef void (APIENTRYP PFNGLTEXSUBIMAGE2DEXTPROC)(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid *pixels);
#endif

/* Sized internal formats and proxies, as in OpenGL 1.1. */
#ifndef GL_EXT_texture
#define GL_EXT_texture 1
#define GL_ALPHA4_EXT                              0x803B
#define GL_ALPHA8_EXT                              0x803C
#define GL_ALPHA12_EXT                             0x803D
#define GL_ALPHA16_EXT                             0x803E
#define GL_LUMINANCE4_EXT                          0x803F
#define GL_LUMINANCE8_EXT                          0x8040
#define GL_LUMINANCE12_EXT                         0x8041
#define GL_LUMINANCE16_EXT                         0x8042
#define GL_LUMINANCE4_ALPHA4_EXT                   0x8043
#define GL_LUMINANCE6_ALPHA2_EXT                   0x8044
#define GL_LUMINANCE8_ALPHA8_EXT                   0x8045
#define GL_LUMINANCE12_ALPHA4_EXT                  0x8046
#define GL_LUMINANCE12_ALPHA12_EXT                 0x8047
#define GL_LUMINANCE16_ALPHA16_EXT                 0x8048
#define GL_INTENSITY_EXT                           0x8049
#define GL_INTENSITY4_EXT                          0x804A
#define GL_INTENSITY8_EXT                          0x804B
#define GL_INTENSITY12_EXT                         0x804C
#define GL_INTENSITY16_EXT                         0x804D
#define GL_RGB2_EXT                                0x804E
#define GL_RGB4_EXT                                0x804F
#define GL_RGB5_EXT                                0x8050
#define GL_RGB8_EXT                                0x8051
#define GL_RGB10_EXT                               0x8052
#define GL_RGB12_EXT                               0x8053
#define GL_RGB16_EXT                               0x8054
#define GL_RGBA2_EXT                               0x8055
#define GL_RGBA4_EXT                               0x8056
#define GL_RGB5_A1_EXT                             0x8057
#define GL_RGBA8_EXT                               0x8058
#define GL_RGB10_A2_EXT                            0x8059
#define GL_RGBA12_EXT                              0x805A
#define GL_RGBA16_EXT                              0x805B
#define GL_TEXTURE_RED_SIZE_EXT                    0x805C
#define GL_TEXTURE_GREEN_SIZE_EXT                  0x805D
#define GL_TEXTURE_BLUE_SIZE_EXT                   0x805E
#define GL_TEXTURE_ALPHA_SIZE_EXT                  0x805F
#define GL_TEXTURE_LUMINANCE_SIZE_EXT              0x8060
#define GL_TEXTURE_INTENSITY_SIZE_EXT              0x8061
#define GL_REPLACE_EXT                             0x8062
#define GL_PROXY_TEXTURE_1D_EXT                    0x8063
#define GL_PROXY_TEXTURE_2D_EXT                    0x8064
#define GL_TEXTURE_TOO_LARGE_EXT                   0x8065
#endif

/* Three-dimensional images, as in OpenGL 1.2. */
#ifndef GL_EXT_texture3D
#define GL_EXT_texture3D 1
#define GL_PACK_SKIP_IMAGES_EXT                    0x806B
#define GL_PACK_IMAGE_HEIGHT_EXT                   0x806C
#define GL_UNPACK_SKIP_IMAGES_EXT                  0x806D
#define GL_UNPACK_IMAGE_HEIGHT_EXT                 0x806E
#define GL_TEXTURE_3D_EXT                          0x806F
#define GL_PROXY_TEXTURE_3D_EXT                    0x8070
#define GL_TEXTURE_DEPTH_EXT                       0x8071
#define GL_TEXTURE_WRAP_R_EXT                      0x8072
#define GL_MAX_3D_TEXTURE_SIZE_EXT                 0x8073
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glTexImage3DEXT(GLenum target, GLint level, GLenum internalformat, GLsizei width,
        GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const GLvoid *pixels);
GLAPI void GLAPIENTRY glTexSubImage3DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
        const GLvoid *pixels);
#endif
typedef void (APIENTRYP PFNGLTEXIMAGE3DEXTPROC)(GLenum target, GLint level, GLenum internalformat,
        GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
        const GLvoid *pixels);
typedef void (APIENTRYP PFNGLTEXSUBIMAGE3DEXTPROC)(GLenum target, GLint level, GLint xoffset, GLint yoffset,
        GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
        const GLvoid *pixels);
#endif

/* Cube maps, as in OpenGL 1.3. */
#ifndef GL_EXT_texture_cube_map
#define GL_EXT_texture_cube_map 1
#define GL_NORMAL_MAP_EXT                          0x8511
#define GL_REFLECTION_MAP_EXT                      0x8512
#define GL_TEXTURE_CUBE_MAP_EXT                    0x8513
#define GL_TEXTURE_BINDING_CUBE_MAP_EXT            0x8514
#define GL_TEXTURE_CUBE_MAP_POSITIVE_X_EXT         0x8515
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_X_EXT         0x8516
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Y_EXT         0x8517
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Y_EXT         0x8518
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Z_EXT         0x8519
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Z_EXT         0x851A
#define GL_PROXY_TEXTURE_CUBE_MAP_EXT              0x851B
#define GL_MAX_CUBE_MAP_TEXTURE_SIZE_EXT           0x851C
#endif

/* GL_ADD as an environment, as in OpenGL 1.3. */
#ifndef GL_EXT_texture_env_add
#define GL_EXT_texture_env_add 1
#endif

/* The environment GL_COMBINE, as in OpenGL 1.3. */
#ifndef GL_EXT_texture_env_combine
#define GL_EXT_texture_env_combine 1
#define GL_COMBINE_EXT                             0x8570
#define GL_COMBINE_RGB_EXT                         0x8571
#define GL_COMBINE_ALPHA_EXT                       0x8572
#define GL_RGB_SCALE_EXT                           0x8573
#define GL_ADD_SIGNED_EXT                          0x8574
#define GL_INTERPOLATE_EXT                         0x8575
#define GL_CONSTANT_EXT                            0x8576
#define GL_PRIMARY_COLOR_EXT                       0x8577
#define GL_PREVIOUS_EXT                            0x8578
#define GL_SOURCE0_RGB_EXT                         0x8580
#define GL_SOURCE1_RGB_EXT                         0x8581
#define GL_SOURCE2_RGB_EXT                         0x8582
#define GL_SOURCE0_ALPHA_EXT                       0x8588
#define GL_SOURCE1_ALPHA_EXT                       0x8589
#define GL_SOURCE2_ALPHA_EXT                       0x858A
#define GL_OPERAND0_RGB_EXT                        0x8590
#define GL_OPERAND1_RGB_EXT                        0x8591
#define GL_OPERAND2_RGB_EXT                        0x8592
#define GL_OPERAND0_ALPHA_EXT                      0x8598
#define GL_OPERAND1_ALPHA_EXT                      0x8599
#define GL_OPERAND2_ALPHA_EXT                      0x859A
#endif

/* Dot products in GL_COMBINE, without scale. */
#ifndef GL_EXT_texture_env_dot3
#define GL_EXT_texture_env_dot3 1
#define GL_DOT3_RGB_EXT                            0x8740
#define GL_DOT3_RGBA_EXT                           0x8741
#endif

/* A bias of the level of detail for each unit, as in OpenGL 1.4. */
#ifndef GL_EXT_texture_lod_bias
#define GL_EXT_texture_lod_bias 1
#define GL_MAX_TEXTURE_LOD_BIAS_EXT                0x84FD
#define GL_TEXTURE_FILTER_CONTROL_EXT              0x8500
#define GL_TEXTURE_LOD_BIAS_EXT                    0x8501
#endif

/* Textures of floats of 16 or 32 bits: texels are neither clamped nor, with 32 bits, rounded. GL_TEXTURE_*_TYPE_ARB, of
 * glGetTexLevelParameter: what the bits of a channel mean. */
#ifndef GL_ARB_texture_float
#define GL_ARB_texture_float 1
#define GL_TEXTURE_RED_TYPE_ARB                    0x8C10
#define GL_TEXTURE_GREEN_TYPE_ARB                  0x8C11
#define GL_TEXTURE_BLUE_TYPE_ARB                   0x8C12
#define GL_TEXTURE_ALPHA_TYPE_ARB                  0x8C13
#define GL_TEXTURE_LUMINANCE_TYPE_ARB              0x8C14
#define GL_TEXTURE_INTENSITY_TYPE_ARB              0x8C15
#define GL_TEXTURE_DEPTH_TYPE_ARB                  0x8C16
#define GL_UNSIGNED_NORMALIZED_ARB                 0x8C17
#define GL_RGBA32F_ARB                             0x8814
#define GL_RGB32F_ARB                              0x8815
#define GL_ALPHA32F_ARB                            0x8816
#define GL_INTENSITY32F_ARB                        0x8817
#define GL_LUMINANCE32F_ARB                        0x8818
#define GL_LUMINANCE_ALPHA32F_ARB                  0x8819
#define GL_RGBA16F_ARB                             0x881A
#define GL_RGB16F_ARB                              0x881B
#define GL_ALPHA16F_ARB                            0x881C
#define GL_INTENSITY16F_ARB                        0x881D
#define GL_LUMINANCE16F_ARB                        0x881E
#define GL_LUMINANCE_ALPHA16F_ARB                  0x881F
#endif

/* Textures of red, or red and green, alone: drawn as (R, 0, 0, 1), (R, G, 0, 1). The integer formats are not accepted. */
#ifndef GL_ARB_texture_rg
#define GL_ARB_texture_rg 1
#define GL_RG                                      0x8227
#define GL_RG_INTEGER                              0x8228
#define GL_R8                                      0x8229
#define GL_R16                                     0x822A
#define GL_RG8                                     0x822B
#define GL_RG16                                    0x822C
#define GL_R16F                                    0x822D
#define GL_R32F                                    0x822E
#define GL_RG16F                                   0x822F
#define GL_RG32F                                   0x8230
#define GL_R8I                                     0x8231
#define GL_R8UI                                    0x8232
#define GL_R16I                                    0x8233
#define GL_R16UI                                   0x8234
#define GL_R32I                                    0x8235
#define GL_R32UI                                   0x8236
#define GL_RG8I                                    0x8237
#define GL_RG8UI                                   0x8238
#define GL_RG16I                                   0x8239
#define GL_RG16UI                                  0x823A
#define GL_RG32I                                   0x823B
#define GL_RG32UI                                  0x823C
#define GL_COMPRESSED_RED                          0x8225
#define GL_COMPRESSED_RG                           0x8226
#endif

/* Textures of signed integers that stand for -1 to 1. */
#ifndef GL_EXT_texture_snorm
#define GL_EXT_texture_snorm 1
#define GL_ALPHA_SNORM                             0x9010
#define GL_LUMINANCE_SNORM                         0x9011
#define GL_LUMINANCE_ALPHA_SNORM                   0x9012
#define GL_INTENSITY_SNORM                         0x9013
#define GL_ALPHA8_SNORM                            0x9014
#define GL_LUMINANCE8_SNORM                        0x9015
#define GL_LUMINANCE8_ALPHA8_SNORM                 0x9016
#define GL_INTENSITY8_SNORM                        0x9017
#define GL_ALPHA16_SNORM                           0x9018
#define GL_LUMINANCE16_SNORM                       0x9019
#define GL_LUMINANCE16_ALPHA16_SNORM               0x901A
#define GL_INTENSITY16_SNORM                       0x901B
#define GL_RED_SNORM                               0x8F90
#define GL_RG_SNORM                                0x8F91
#define GL_RGB_SNORM                               0x8F92
#define GL_RGBA_SNORM                              0x8F93
#define GL_R8_SNORM                                0x8F94
#define GL_RG8_SNORM                               0x8F95
#define GL_RGB8_SNORM                              0x8F96
#define GL_RGBA8_SNORM                             0x8F97
#define GL_R16_SNORM                               0x8F98
#define GL_RG16_SNORM                              0x8F99
#define GL_RGB16_SNORM                             0x8F9A
#define GL_RGBA16_SNORM                            0x8F9B
#define GL_SIGNED_NORMALIZED                       0x8F9C
#endif

/* Textures of 8 bits whose colours, but not alpha, are stored by the sRGB curve, and drawn with as linear ones. */
#ifndef GL_EXT_texture_sRGB
#define GL_EXT_texture_sRGB 1
#define GL_SRGB_EXT                                0x8C40
#define GL_SRGB8_EXT                               0x8C41
#define GL_SRGB_ALPHA_EXT                          0x8C42
#define GL_SRGB8_ALPHA8_EXT                        0x8C43
#define GL_SLUMINANCE_ALPHA_EXT                    0x8C44
#define GL_SLUMINANCE8_ALPHA8_EXT                  0x8C45
#define GL_SLUMINANCE_EXT                          0x8C46
#define GL_SLUMINANCE8_EXT                         0x8C47
#define GL_COMPRESSED_SRGB_EXT                     0x8C48
#define GL_COMPRESSED_SRGB_ALPHA_EXT               0x8C49
#define GL_COMPRESSED_SLUMINANCE_EXT               0x8C4A
#define GL_COMPRESSED_SLUMINANCE_ALPHA_EXT         0x8C4B
#define GL_COMPRESSED_SRGB_S3TC_DXT1_EXT           0x8C4C /* these four go with a compression that is not offered */
#define GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT     0x8C4D
#define GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT     0x8C4E
#define GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT     0x8C4F
#endif

/* Textures and pixels of three floats without sign in 32 bits: 11, 11 and 10 of them. */
#ifndef GL_EXT_packed_float
#define GL_EXT_packed_float 1
#define GL_R11F_G11F_B10F_EXT                      0x8C3A
#define GL_UNSIGNED_INT_10F_11F_11F_REV_EXT        0x8C3B
#define GL_RGBA_SIGNED_COMPONENTS_EXT              0x8C3C
#endif

/* Textures and pixels of three mantissas of 9 bits with one exponent. */
#ifndef GL_EXT_texture_shared_exponent
#define GL_EXT_texture_shared_exponent 1
#define GL_RGB9_E5_EXT                             0x8C3D
#define GL_UNSIGNED_INT_5_9_9_9_REV_EXT            0x8C3E
#define GL_TEXTURE_SHARED_SIZE_EXT                 0x8C3F
#endif

/* Buffer objects that pixels are read from (unpack) and written to (pack): while one is bound, the pointers to pixels of commands are offsets
 * into it. GL_INVALID_OPERATION: the pixels do not fit in it, or it is mapped. */
#ifndef GL_ARB_pixel_buffer_object
#define GL_ARB_pixel_buffer_object 1
#define GL_PIXEL_PACK_BUFFER_ARB                   0x88EB
#define GL_PIXEL_UNPACK_BUFFER_ARB                 0x88EC
#define GL_PIXEL_PACK_BUFFER_BINDING_ARB           0x88ED
#define GL_PIXEL_UNPACK_BUFFER_BINDING_ARB         0x88EF
#endif

/* Mirrored images, as in OpenGL 1.4. */
#ifndef GL_IBM_texture_mirrored_repeat
#define GL_IBM_texture_mirrored_repeat 1
#define GL_MIRRORED_REPEAT_IBM                     0x8370
#endif

/* Coordinates from normals and reflections, as in OpenGL 1.3. */
#ifndef GL_NV_texgen_reflection
#define GL_NV_texgen_reflection 1
#define GL_NORMAL_MAP_NV                           0x8511
#define GL_REFLECTION_MAP_NV                       0x8512
#endif

/* Mipmaps made by the library, as in OpenGL 1.4. */
#ifndef GL_SGIS_generate_mipmap
#define GL_SGIS_generate_mipmap 1
#define GL_GENERATE_MIPMAP_SGIS                    0x8191
#define GL_GENERATE_MIPMAP_HINT_SGIS               0x8192
#endif

/* Coordinates clamped to the border, as in OpenGL 1.3. */
#ifndef GL_SGIS_texture_border_clamp
#define GL_SGIS_texture_border_clamp 1
#define GL_CLAMP_TO_BORDER_SGIS                    0x812D
#endif

/* Coordinates clamped to the edge, as in OpenGL 1.2. */
#ifndef GL_SGIS_texture_edge_clamp
#define GL_SGIS_texture_edge_clamp 1
#define GL_CLAMP_TO_EDGE_SGIS                      0x812F
#endif

/* Limits of the level of detail, as in OpenGL 1.2. */
#ifndef GL_SGIS_texture_lod
#define GL_SGIS_texture_lod 1
#define GL_TEXTURE_MIN_LOD_SGIS                    0x813A
#define GL_TEXTURE_MAX_LOD_SGIS                    0x813B
#define GL_TEXTURE_BASE_LEVEL_SGIS                 0x813C
#define GL_TEXTURE_MAX_LEVEL_SGIS                  0x813D
#endif

/* The same under the names of OpenGL 3.0, with framebuffers of their own for drawing and reading, and copies between them. Attachments may
 * differ in size: what all of them have is drawn to. GL_MAX_SAMPLES is 1: a renderbuffer
 * that is multisampled has one sample a pixel. */
#ifndef GL_ARB_framebuffer_object
#define GL_ARB_framebuffer_object 1

/* Targets, attachment points, bindings and limits. */
#define GL_DEPTH_STENCIL_ATTACHMENT                        0x821A
#define GL_MAX_RENDERBUFFER_SIZE                           0x84E8
#define GL_FRAMEBUFFER_BINDING                             0x8CA6
#define GL_DRAW_FRAMEBUFFER_BINDING                        0x8CA6
#define GL_RENDERBUFFER_BINDING                            0x8CA7
#define GL_READ_FRAMEBUFFER                                0x8CA8
#define GL_DRAW_FRAMEBUFFER                                0x8CA9
#define GL_READ_FRAMEBUFFER_BINDING                        0x8CAA
#define GL_MAX_COLOR_ATTACHMENTS                           0x8CDF
#define GL_COLOR_ATTACHMENT0                               0x8CE0
#define GL_COLOR_ATTACHMENT1                               0x8CE1
#define GL_COLOR_ATTACHMENT2                               0x8CE2
#define GL_COLOR_ATTACHMENT3                               0x8CE3
#define GL_COLOR_ATTACHMENT4                               0x8CE4
#define GL_COLOR_ATTACHMENT5                               0x8CE5
#define GL_COLOR_ATTACHMENT6                               0x8CE6
#define GL_COLOR_ATTACHMENT7                               0x8CE7
#define GL_COLOR_ATTACHMENT8                               0x8CE8
#define GL_COLOR_ATTACHMENT9                               0x8CE9
#define GL_COLOR_ATTACHMENT10                              0x8CEA
#define GL_COLOR_ATTACHMENT11                              0x8CEB
#define GL_COLOR_ATTACHMENT12                              0x8CEC
#define GL_COLOR_ATTACHMENT13                              0x8CED
#define GL_COLOR_ATTACHMENT14                              0x8CEE
#define GL_COLOR_ATTACHMENT15                              0x8CEF
#define GL_DEPTH_ATTACHMENT                                0x8D00
#define GL_STENCIL_ATTACHMENT                              0x8D20
#define GL_FRAMEBUFFER                                     0x8D40
#define GL_RENDERBUFFER                                    0x8D41
#define GL_MAX_SAMPLES                                     0x8D57

/* Properties of attachments and renderbuffers. */
#define GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING           0x8210
#define GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE           0x8211
#define GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE                 0x8212
#define GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE               0x8213
#define GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE                0x8214
#define GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE               0x8215
#define GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE               0x8216
#define GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE             0x8217
#define GL_FRAMEBUFFER_DEFAULT                             0x8218
#define GL_RENDERBUFFER_SAMPLES                            0x8CAB
#define GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE              0x8CD0
#define GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME              0x8CD1
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL            0x8CD2
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE    0x8CD3
#define GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER            0x8CD4
#define GL_RENDERBUFFER_WIDTH                              0x8D42
#define GL_RENDERBUFFER_HEIGHT                             0x8D43
#define GL_RENDERBUFFER_INTERNAL_FORMAT                    0x8D44
#define GL_RENDERBUFFER_RED_SIZE                           0x8D50
#define GL_RENDERBUFFER_GREEN_SIZE                         0x8D51
#define GL_RENDERBUFFER_BLUE_SIZE                          0x8D52
#define GL_RENDERBUFFER_ALPHA_SIZE                         0x8D53
#define GL_RENDERBUFFER_DEPTH_SIZE                         0x8D54
#define GL_RENDERBUFFER_STENCIL_SIZE                       0x8D55
#define GL_UNSIGNED_NORMALIZED                             0x8C17

/* Formats. */
#define GL_INDEX                                           0x8222
#define GL_DEPTH_STENCIL                                   0x84F9
#define GL_UNSIGNED_INT_24_8                               0x84FA
#define GL_DEPTH24_STENCIL8                                0x88F0
#define GL_TEXTURE_STENCIL_SIZE                            0x88F1
#define GL_STENCIL_INDEX1                                  0x8D46
#define GL_STENCIL_INDEX4                                  0x8D47
#define GL_STENCIL_INDEX8                                  0x8D48
#define GL_STENCIL_INDEX16                                 0x8D49

/* Answers of glCheckFramebufferStatus, and the error of drawing or reading when it is not complete. */
#define GL_INVALID_FRAMEBUFFER_OPERATION                   0x0506
#define GL_FRAMEBUFFER_UNDEFINED                           0x8219
#define GL_FRAMEBUFFER_COMPLETE                            0x8CD5
#define GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT               0x8CD6
#define GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT       0x8CD7
#define GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER              0x8CDB
#define GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER              0x8CDC
#define GL_FRAMEBUFFER_UNSUPPORTED                         0x8CDD
#define GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE              0x8D56

#ifdef GL_GLEXT_PROTOTYPES
/* As in GL_EXT_framebuffer_object. */
GLAPI GLboolean GLAPIENTRY glIsRenderbuffer(GLuint renderbuffer);
GLAPI void GLAPIENTRY glBindRenderbuffer(GLenum target, GLuint renderbuffer);
GLAPI void GLAPIENTRY glDeleteRenderbuffers(GLsizei n, const GLuint *renderbuffers);
GLAPI void GLAPIENTRY glGenRenderbuffers(GLsizei n, GLuint *renderbuffers);
GLAPI void GLAPIENTRY glRenderbufferStorage(GLenum target, GLenum internalformat, GLsizei width,
                                            GLsizei height);
/* The same with `samples` samples a pixel. GL_INVALID_VALUE: more than GL_MAX_SAMPLES, or fewer than 0. */
GLAPI void GLAPIENTRY glRenderbufferStorageMultisample(GLenum target, GLsizei samples,
                                                       GLenum internalformat, GLsizei width, GLsizei height);
GLAPI void GLAPIENTRY glGetRenderbufferParameteriv(GLenum target, GLenum pname, GLint *params);
GLAPI GLboolean GLAPIENTRY glIsFramebuffer(GLuint framebuffer);
/* target: GL_FRAMEBUFFER (both), GL_DRAW_FRAMEBUFFER or GL_READ_FRAMEBUFFER; of the other commands, GL_FRAMEBUFFER is GL_DRAW_FRAMEBUFFER. */
GLAPI void GLAPIENTRY glBindFramebuffer(GLenum target, GLuint framebuffer);
GLAPI void GLAPIENTRY glDeleteFramebuffers(GLsizei n, const GLuint *framebuffers);
GLAPI void GLAPIENTRY glGenFramebuffers(GLsizei n, GLuint *framebuffers);
GLAPI GLenum GLAPIENTRY glCheckFramebufferStatus(GLenum target);
GLAPI void GLAPIENTRY glFramebufferTexture1D(GLenum target, GLenum attachment, GLenum textarget,
                                             GLuint texture, GLint level);
GLAPI void GLAPIENTRY glFramebufferTexture2D(GLenum target, GLenum attachment, GLenum textarget,
                                             GLuint texture, GLint level);
GLAPI void GLAPIENTRY glFramebufferTexture3D(GLenum target, GLenum attachment, GLenum textarget,
                                             GLuint texture, GLint level, GLint zoffset);
/* One layer of a 3D texture. GL_INVALID_OPERATION: another texture. */
GLAPI void GLAPIENTRY glFramebufferTextureLayer(GLenum target, GLenum attachment, GLuint texture,
                                                GLint level, GLint layer);
GLAPI void GLAPIENTRY glFramebufferRenderbuffer(GLenum target, GLenum attachment,
                                                GLenum renderbuffertarget, GLuint renderbuffer);
GLAPI void GLAPIENTRY glGetFramebufferAttachmentParameteriv(GLenum target, GLenum attachment, GLenum pname,
                                                            GLint *params);
GLAPI void GLAPIENTRY glGenerateMipmap(GLenum target);
/* Copies the buffers in mask from a rectangle of the read framebuffer to one of the draw framebuffer, scaled and turned over as the corners
 * say; the scissor test applies. filter: GL_NEAREST, or GL_LINEAR for colors. GL_INVALID_VALUE: other bits in mask. GL_INVALID_OPERATION:
 * GL_LINEAR with depth or stencil; depth or stencil formats that differ. GL_INVALID_FRAMEBUFFER_OPERATION: one is not complete. */
GLAPI void GLAPIENTRY glBlitFramebuffer(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0,
                                        GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask,
                                        GLenum filter);
#endif
typedef GLboolean (APIENTRYP PFNGLISRENDERBUFFERPROC)(GLuint renderbuffer);
typedef void (APIENTRYP PFNGLBINDRENDERBUFFERPROC)(GLenum target, GLuint renderbuffer);
typedef void (APIENTRYP PFNGLDELETERENDERBUFFERSPROC)(GLsizei n, const GLuint *renderbuffers);
typedef void (APIENTRYP PFNGLGENRENDERBUFFERSPROC)(GLsizei n, GLuint *renderbuffers);
typedef void (APIENTRYP PFNGLRENDERBUFFERSTORAGEPROC)(GLenum target, GLenum internalformat, GLsizei width,
        GLsizei height);
typedef void (APIENTRYP PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC)(GLenum target, GLsizei samples,
        GLenum internalformat, GLsizei width, GLsizei height);
typedef void (APIENTRYP PFNGLGETRENDERBUFFERPARAMETERIVPROC)(GLenum target, GLenum pname, GLint *params);
typedef GLboolean (APIENTRYP PFNGLISFRAMEBUFFERPROC)(GLuint framebuffer);
typedef void (APIENTRYP PFNGLBINDFRAMEBUFFERPROC)(GLenum target, GLuint framebuffer);
typedef void (APIENTRYP PFNGLDELETEFRAMEBUFFERSPROC)(GLsizei n, const GLuint *framebuffers);
typedef void (APIENTRYP PFNGLGENFRAMEBUFFERSPROC)(GLsizei n, GLuint *framebuffers);
typedef GLenum (APIENTRYP PFNGLCHECKFRAMEBUFFERSTATUSPROC)(GLenum target);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE1DPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE2DPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURE3DPROC)(GLenum target, GLenum attachment, GLenum textarget,
        GLuint texture, GLint level, GLint zoffset);
typedef void (APIENTRYP PFNGLFRAMEBUFFERTEXTURELAYERPROC)(GLenum target, GLenum attachment, GLuint texture,
        GLint level, GLint layer);
typedef void (APIENTRYP PFNGLFRAMEBUFFERRENDERBUFFERPROC)(GLenum target, GLenum attachment,
        GLenum renderbuffertarget, GLuint renderbuffer);
typedef void (APIENTRYP PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC)(GLenum target, GLenum attachment,
        GLenum pname, GLint *params);
typedef void (APIENTRYP PFNGLGENERATEMIPMAPPROC)(GLenum target);
typedef void (APIENTRYP PFNGLBLITFRAMEBUFFERPROC)(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1,
        GLint dstX0, GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter);
#endif

/* Objects that keep the arrays of a model: pointers, sizes, types, which are enabled, and the buffer of element indexes. Only what
 * lies in buffer objects can be kept: placing an array in client memory while an object is bound is GL_INVALID_OPERATION. */
#ifndef GL_ARB_vertex_array_object
#define GL_ARB_vertex_array_object 1

/* The bound object, 0 for none. glGetIntegerv. */
#define GL_VERTEX_ARRAY_BINDING                    0x85B5

#ifdef GL_GLEXT_PROTOTYPES
/* 0 for the context's own arrays. GL_INVALID_OPERATION: a name that glGenVertexArrays has not given, or deleted. */
GLAPI void GLAPIENTRY glBindVertexArray(GLuint array);
/* Where a bound object is deleted, 0 is bound. GL_INVALID_VALUE: n is negative. */
GLAPI void GLAPIENTRY glDeleteVertexArrays(GLsizei n, const GLuint *arrays);
/* GL_INVALID_VALUE: n is negative. */
GLAPI void GLAPIENTRY glGenVertexArrays(GLsizei n, GLuint *arrays);
/* GL_TRUE for a name that has been bound. */
GLAPI GLboolean GLAPIENTRY glIsVertexArray(GLuint array);
#endif
typedef void (APIENTRYP PFNGLBINDVERTEXARRAYPROC)(GLuint array);
typedef void (APIENTRYP PFNGLDELETEVERTEXARRAYSPROC)(GLsizei n, const GLuint *arrays);
typedef void (APIENTRYP PFNGLGENVERTEXARRAYSPROC)(GLsizei n, GLuint *arrays);
typedef GLboolean (APIENTRYP PFNGLISVERTEXARRAYPROC)(GLuint array);
#endif

/* glBlitFramebuffer before it came to OpenGL 3.0. */
#ifndef GL_EXT_framebuffer_blit
#define GL_EXT_framebuffer_blit 1
#define GL_READ_FRAMEBUFFER_EXT                    0x8CA8
#define GL_DRAW_FRAMEBUFFER_EXT                    0x8CA9
#define GL_DRAW_FRAMEBUFFER_BINDING_EXT            0x8CA6
#define GL_READ_FRAMEBUFFER_BINDING_EXT            0x8CAA
#ifdef GL_GLEXT_PROTOTYPES
GLAPI void GLAPIENTRY glBlitFramebufferEXT(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0,
                                           GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask,
                                           GLenum filter);
#endif
typedef void (APIENTRYP PFNGLBLITFRAMEBUFFEREXTPROC)(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1,
        GLint dstX0, GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter);
#endif


/* ---- Of later versions and other extensions -------------------------------------------------------------
 * Names of what FixedGL does not have, for programs that ask at run time and for those that set it in passing: commands answer
 * GL_INVALID_ENUM to them and do nothing. The macros that announce their versions and extensions are not defined. */

#define GL_SHADING_LANGUAGE_VERSION                0x8B8C
#define GL_MAJOR_VERSION                           0x821B
#define GL_MINOR_VERSION                           0x821C
#define GL_NUM_EXTENSIONS                          0x821D
#define GL_CONTEXT_FLAGS                           0x821E
#define GL_CURRENT_PROGRAM                         0x8B8D
#define GL_MAX_VERTEX_ATTRIBS                      0x8869
#define GL_MAX_TEXTURE_COORDS                      0x8871
#define GL_MAX_TEXTURE_IMAGE_UNITS                 0x8872
#define GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS        0x8B4D
#define GL_MAX_DRAW_BUFFERS                        0x8824
#define GL_VERTEX_SHADER                           0x8B31
#define GL_FRAGMENT_SHADER                         0x8B30
#define GL_VERTEX_PROGRAM_ARB                      0x8620
#define GL_FRAGMENT_PROGRAM_ARB                    0x8804
#define GL_VERTEX_PROGRAM_POINT_SIZE               0x8642
#define GL_PROGRAM_POINT_SIZE                      0x8642
#define GL_COLOR_INDEX8_EXT                        0x80E5
#define GL_CLIP_VOLUME_CLIPPING_HINT_EXT           0x80F0
#define GL_TEXTURE_MAX_ANISOTROPY_EXT              0x84FE
#define GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT          0x84FF
#define GL_COMPRESSED_RGB_S3TC_DXT1_EXT            0x83F0
#define GL_COMPRESSED_RGBA_S3TC_DXT1_EXT           0x83F1
#define GL_COMPRESSED_RGBA_S3TC_DXT3_EXT           0x83F2
#define GL_COMPRESSED_RGBA_S3TC_DXT5_EXT           0x83F3
#define GL_DEPTH_STENCIL_TEXTURE_MODE              0x90EA
#define GL_DEPTH_CLAMP                             0x864F
#define GL_FRAMEBUFFER_SRGB                        0x8DB9
#define GL_MULTISAMPLE_FILTER_HINT_NV              0x8534
#define GL_PRIMITIVE_RESTART                       0x8F9D
#define GL_TEXTURE_CUBE_MAP_SEAMLESS               0x884F

/* Before OpenGL 1.1, another name. */
#define GL_POLYGON_OFFSET_EXT                      0x8037 /* GL_POLYGON_OFFSET_FILL */

#ifdef __cplusplus
}
#endif

#endif
