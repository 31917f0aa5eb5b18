/* The functions of GL that the scenes call. Nothing is linked: a worker looks them up in the library that it times. */
#ifndef BENCH_FUNCTIONS_H
#define BENCH_FUNCTIONS_H

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

/* clang-format off */
#define FOR_EACH_FUNCTION(F)                                                                                 \
    F(void, Accum, (GLenum, GLfloat))                                                                        \
    F(void, ActiveTexture, (GLenum))                                                                         \
    F(void, AlphaFunc, (GLenum, GLfloat))                                                                    \
    F(void, Begin, (GLenum))                                                                                 \
    F(void, BindFramebuffer, (GLenum, GLuint))                                                               \
    F(void, BindTexture, (GLenum, GLuint))                                                                   \
    F(void, Bitmap, (GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte *))                 \
    F(void, BlendFunc, (GLenum, GLenum))                                                                     \
    F(void, CallList, (GLuint))                                                                              \
    F(void, Clear, (GLbitfield))                                                                             \
    F(void, Color3fv, (const GLfloat *))                                                                     \
    F(void, Color4f, (GLfloat, GLfloat, GLfloat, GLfloat))                                                   \
    F(void, CopyPixels, (GLint, GLint, GLsizei, GLsizei, GLenum))                                            \
    F(void, CopyTexSubImage2D, (GLenum, GLint, GLint, GLint, GLint, GLint, GLsizei, GLsizei))                \
    F(void, CullFace, (GLenum))                                                                              \
    F(void, Disable, (GLenum))                                                                               \
    F(void, DrawElements, (GLenum, GLsizei, GLenum, const GLvoid *))                                         \
    F(void, DrawPixels, (GLsizei, GLsizei, GLenum, GLenum, const GLvoid *))                                  \
    F(void, Enable, (GLenum))                                                                                \
    F(void, EnableClientState, (GLenum))                                                                     \
    F(void, End, (void))                                                                                     \
    F(void, EndList, (void))                                                                                 \
    F(void, Finish, (void))                                                                                  \
    F(void, Fogf, (GLenum, GLfloat))                                                                         \
    F(void, Fogi, (GLenum, GLint))                                                                           \
    F(void, FramebufferTexture2D, (GLenum, GLenum, GLenum, GLuint, GLint))                                   \
    F(void, GenFramebuffers, (GLsizei, GLuint *))                                                            \
    F(void, GenTextures, (GLsizei, GLuint *))                                                                \
    F(GLenum, GetError, (void))                                                                              \
    F(const GLubyte *, GetString, (GLenum))                                                                  \
    F(void, Lightf, (GLenum, GLenum, GLfloat))                                                               \
    F(void, Lightfv, (GLenum, GLenum, const GLfloat *))                                                      \
    F(void, LightModeli, (GLenum, GLint))                                                                    \
    F(void, LineStipple, (GLint, GLushort))                                                                  \
    F(void, LineWidth, (GLfloat))                                                                            \
    F(void, LogicOp, (GLenum))                                                                               \
    F(void, Materialf, (GLenum, GLenum, GLfloat))                                                            \
    F(void, Materialfv, (GLenum, GLenum, const GLfloat *))                                                   \
    F(void, MatrixMode, (GLenum))                                                                            \
    F(void, MultiTexCoord2f, (GLenum, GLfloat, GLfloat))                                                     \
    F(void, NewList, (GLuint, GLenum))                                                                       \
    F(void, Normal3fv, (const GLfloat *))                                                                    \
    F(void, NormalPointer, (GLenum, GLsizei, const GLvoid *))                                                \
    F(void, Ortho, (GLdouble, GLdouble, GLdouble, GLdouble, GLdouble, GLdouble))                             \
    F(void, PixelZoom, (GLfloat, GLfloat))                                                                   \
    F(void, PointSize, (GLfloat))                                                                            \
    F(void, PolygonStipple, (const GLubyte *))                                                               \
    F(void, PopMatrix, (void))                                                                               \
    F(void, PushMatrix, (void))                                                                              \
    F(void, RasterPos2f, (GLfloat, GLfloat))                                                                 \
    F(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, GLvoid *))                          \
    F(void, StencilFunc, (GLenum, GLint, GLuint))                                                            \
    F(void, StencilOp, (GLenum, GLenum, GLenum))                                                             \
    F(void, TexEnvi, (GLenum, GLenum, GLint))                                                                \
    F(void, TexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const GLvoid *))     \
    F(void, TexParameteri, (GLenum, GLenum, GLint))                                                          \
    F(void, TexSubImage2D, (GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, const GLvoid *))  \
    F(void, Translatef, (GLfloat, GLfloat, GLfloat))                                                         \
    F(void, Vertex2f, (GLfloat, GLfloat))                                                                    \
    F(void, Vertex3f, (GLfloat, GLfloat, GLfloat))                                                           \
    F(void, Vertex3fv, (const GLfloat *))                                                                    \
    F(void, VertexPointer, (GLint, GLenum, GLsizei, const GLvoid *))                                         \
    F(void, Viewport, (GLint, GLint, GLsizei, GLsizei))
/* clang-format on */

#define DECLARE_FUNCTION(result, name, parameters) result(*name) parameters;
struct functions {
    FOR_EACH_FUNCTION(DECLARE_FUNCTION)
    OSMesaContext (*CreateContext)(GLenum, GLint, GLint, GLint, OSMesaContext);
    GLboolean (*MakeCurrent)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
    GLenum (*Accuracy)(GLenum); /* NULL but in FixedGL */
};
#undef DECLARE_FUNCTION

/* Those of the library that this process loaded. */
extern struct functions gl;

#endif
