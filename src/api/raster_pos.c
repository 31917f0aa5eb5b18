/* glRasterPos and glWindowPos (GL 1.5, 2.13 "Current Raster Position"): every form leads to one of two. */
#include "api/command.h"
#include "api/errors.h"
#include "pipeline/feedback.h"
#include "pipeline/raster_position.h"

/* GL 1.5, 5.2: while selecting, a valid raster position is a hit. */
static void select_position(struct context *ctx)
{
    if (ctx->render_mode == GL_SELECT && ctx->s.current.raster_position_valid)
        fgl_selection_hit(&ctx->selection, ctx->s.current.raster_position[2]);
}

void fgl_exec_RasterPos4f(struct context *ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w)
{
    const float object[4] = {x, y, z, w};
    fgl_flush_vertices(ctx, 0);
    fgl_flush_current(ctx);
    fgl_raster_position_set(ctx, object);
    select_position(ctx);
}

void fgl_exec_WindowPos3f(struct context *ctx, GLfloat x, GLfloat y, GLfloat z)
{
    fgl_flush_vertices(ctx, 0);
    fgl_flush_current(ctx);
    fgl_raster_position_set_window(ctx, x, y, z);
    select_position(ctx);
}

#define RASTER_POS(suffix, T)                                                                                \
    void GLAPIENTRY glRasterPos2##suffix(T x, T y)                                                           \
    {                                                                                                        \
        glRasterPos4f((GLfloat)x, (GLfloat)y, 0.0f, 1.0f);                                                   \
    }                                                                                                        \
    void GLAPIENTRY glRasterPos3##suffix(T x, T y, T z)                                                      \
    {                                                                                                        \
        glRasterPos4f((GLfloat)x, (GLfloat)y, (GLfloat)z, 1.0f);                                             \
    }                                                                                                        \
    RASTER_POS_VECTORS(suffix, T)
#define RASTER_POS4(suffix, T)                                                                               \
    void GLAPIENTRY glRasterPos4##suffix(T x, T y, T z, T w)                                                 \
    {                                                                                                        \
        glRasterPos4f((GLfloat)x, (GLfloat)y, (GLfloat)z, (GLfloat)w);                                       \
    }
#define RASTER_POS_VECTORS(suffix, T)                                                                        \
    void GLAPIENTRY glRasterPos2##suffix##v(const T *v)                                                      \
    {                                                                                                        \
        glRasterPos4f((GLfloat)v[0], (GLfloat)v[1], 0.0f, 1.0f);                                             \
    }                                                                                                        \
    void GLAPIENTRY glRasterPos3##suffix##v(const T *v)                                                      \
    {                                                                                                        \
        glRasterPos4f((GLfloat)v[0], (GLfloat)v[1], (GLfloat)v[2], 1.0f);                                    \
    }                                                                                                        \
    void GLAPIENTRY glRasterPos4##suffix##v(const T *v)                                                      \
    {                                                                                                        \
        glRasterPos4f((GLfloat)v[0], (GLfloat)v[1], (GLfloat)v[2], (GLfloat)v[3]);                           \
    }
RASTER_POS(d, GLdouble)
RASTER_POS(f, GLfloat)
RASTER_POS(i, GLint)
RASTER_POS(s, GLshort)
RASTER_POS4(d, GLdouble)
RASTER_POS4(i, GLint)
RASTER_POS4(s, GLshort)

#define WINDOW_POS_FORMS(T, s, ext)                                                                          \
    void GLAPIENTRY glWindowPos2##s##ext(T x, T y)                                                           \
    {                                                                                                        \
        glWindowPos3f((GLfloat)x, (GLfloat)y, 0.0f);                                                         \
    }                                                                                                        \
    void GLAPIENTRY glWindowPos2##s##v##ext(const T *v)                                                      \
    {                                                                                                        \
        glWindowPos3f((GLfloat)v[0], (GLfloat)v[1], 0.0f);                                                   \
    }                                                                                                        \
    void GLAPIENTRY glWindowPos3##s##v##ext(const T *v)                                                      \
    {                                                                                                        \
        glWindowPos3f((GLfloat)v[0], (GLfloat)v[1], (GLfloat)v[2]);                                          \
    }
#define WINDOW_POS3(T, s, ext)                                                                               \
    void GLAPIENTRY glWindowPos3##s##ext(T x, T y, T z)                                                      \
    {                                                                                                        \
        glWindowPos3f((GLfloat)x, (GLfloat)y, (GLfloat)z);                                                   \
    }
#define WINDOW_POS(T, s)                                                                                     \
    WINDOW_POS_FORMS(T, s, ) WINDOW_POS_FORMS(T, s, ARB) WINDOW_POS3(T, s, ARB)                              \
    WINDOW_POS_FORMS(T, s, MESA) WINDOW_POS3(T, s, MESA)
WINDOW_POS(GLdouble, d)
WINDOW_POS(GLfloat, f)
WINDOW_POS(GLint, i)
WINDOW_POS(GLshort, s)
WINDOW_POS3(GLdouble, d, )
WINDOW_POS3(GLint, i, )
WINDOW_POS3(GLshort, s, )
