/* Pixel transfer modes and pixel maps (GL 1.5, 3.6.3 "Pixel Transfer Modes"; queries 6.1.3 "Enumerated
 * Queries"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/set.h"

#include <string.h>

/* ---- glPixelTransfer ---- */

static float *find_float(struct pixel_mode_state *m, GLenum pname)
{
    switch (pname) {
    case GL_RED_SCALE: return &m->scale[0];
    case GL_GREEN_SCALE: return &m->scale[1];
    case GL_BLUE_SCALE: return &m->scale[2];
    case GL_ALPHA_SCALE: return &m->scale[3];
    case GL_RED_BIAS: return &m->bias[0];
    case GL_GREEN_BIAS: return &m->bias[1];
    case GL_BLUE_BIAS: return &m->bias[2];
    case GL_ALPHA_BIAS: return &m->bias[3];
    case GL_DEPTH_SCALE: return &m->depth_scale;
    case GL_DEPTH_BIAS: return &m->depth_bias;
    case GL_POST_CONVOLUTION_RED_SCALE: return &m->imaging.post_convolution.scale[0];
    case GL_POST_CONVOLUTION_GREEN_SCALE: return &m->imaging.post_convolution.scale[1];
    case GL_POST_CONVOLUTION_BLUE_SCALE: return &m->imaging.post_convolution.scale[2];
    case GL_POST_CONVOLUTION_ALPHA_SCALE: return &m->imaging.post_convolution.scale[3];
    case GL_POST_CONVOLUTION_RED_BIAS: return &m->imaging.post_convolution.bias[0];
    case GL_POST_CONVOLUTION_GREEN_BIAS: return &m->imaging.post_convolution.bias[1];
    case GL_POST_CONVOLUTION_BLUE_BIAS: return &m->imaging.post_convolution.bias[2];
    case GL_POST_CONVOLUTION_ALPHA_BIAS: return &m->imaging.post_convolution.bias[3];
    case GL_POST_COLOR_MATRIX_RED_SCALE: return &m->imaging.post_color_matrix.scale[0];
    case GL_POST_COLOR_MATRIX_GREEN_SCALE: return &m->imaging.post_color_matrix.scale[1];
    case GL_POST_COLOR_MATRIX_BLUE_SCALE: return &m->imaging.post_color_matrix.scale[2];
    case GL_POST_COLOR_MATRIX_ALPHA_SCALE: return &m->imaging.post_color_matrix.scale[3];
    case GL_POST_COLOR_MATRIX_RED_BIAS: return &m->imaging.post_color_matrix.bias[0];
    case GL_POST_COLOR_MATRIX_GREEN_BIAS: return &m->imaging.post_color_matrix.bias[1];
    case GL_POST_COLOR_MATRIX_BLUE_BIAS: return &m->imaging.post_color_matrix.bias[2];
    case GL_POST_COLOR_MATRIX_ALPHA_BIAS: return &m->imaging.post_color_matrix.bias[3];
    default: return NULL;
    }
}

void fgl_exec_PixelTransferf(struct context *ctx, GLenum pname, GLfloat param)
{
    struct pixel_mode_state *m = &ctx->s.pixel_mode;
    float *value = find_float(m, pname);
    if (value) {
        SET(ctx, 0, *value, param);
        return;
    }
    switch (pname) {
    case GL_MAP_COLOR: SET(ctx, 0, m->map_color, param != 0.0f); break;
    case GL_MAP_STENCIL: SET(ctx, 0, m->map_stencil, param != 0.0f); break;
    case GL_INDEX_SHIFT: SET(ctx, 0, m->index_shift, fgl_int_saturate((double)param)); break;
    case GL_INDEX_OFFSET: SET(ctx, 0, m->index_offset, fgl_int_saturate((double)param)); break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}

void GLAPIENTRY glPixelTransferi(GLenum pname, GLint param)
{
    glPixelTransferf(pname, (GLfloat)param);
}

/* ---- glPixelMap ---- */

static bool is_index_map(unsigned map)
{
    return map < PIXEL_MAP_R_TO_R;
}

static bool holds_indexes(unsigned map)
{
    return map == PIXEL_MAP_I_TO_I || map == PIXEL_MAP_S_TO_S;
}

int fgl_count_pixel_map(GLsizei mapsize)
{
    return mapsize >= 1 && mapsize <= FGL_MAX_PIXEL_MAP ? mapsize : 0;
}

/* Maps to indexes keep the nearest integers, maps to colours values in [0,1]. */
void fgl_exec_PixelMapfv(struct context *ctx, GLenum map, GLsizei mapsize, const GLfloat *values)
{
    const unsigned number = map - GL_PIXEL_MAP_I_TO_I;
    RETURN_ERROR_IF(ctx, mapsize < 1 || mapsize > FGL_MAX_PIXEL_MAP, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, number < PIXEL_MAP_COUNT && is_index_map(number) && (mapsize & (mapsize - 1)),
                    GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, number >= PIXEL_MAP_COUNT, GL_INVALID_ENUM);
    fgl_flush_vertices(ctx, 0);
    struct pixel_map *m = &ctx->pixel_map[number];
    m->size = mapsize;
    for (int i = 0; i < mapsize; i++)
        m->value[i] = number == PIXEL_MAP_S_TO_S   ? (float)fgl_int_round((double)values[i])
                      : number == PIXEL_MAP_I_TO_I ? values[i]
                                                   : fgl_clamp01(values[i]);
}

#define PIXEL_MAP_FROM(suffix, T, max)                                                                       \
    void GLAPIENTRY glPixelMap##suffix(GLenum map, GLsizei mapsize, const T *values)                         \
    {                                                                                                        \
        GLfloat v[FGL_MAX_PIXEL_MAP];                                                                        \
        const int n = fgl_count_pixel_map(mapsize);                                                          \
        const bool indexes = holds_indexes(map - GL_PIXEL_MAP_I_TO_I);                                       \
        for (int i = 0; i < n; i++)                                                                          \
            v[i] = indexes ? (GLfloat)values[i] : (GLfloat)((double)values[i] / (max));                      \
        glPixelMapfv(map, mapsize, v);                                                                       \
    }
PIXEL_MAP_FROM(uiv, GLuint, 4294967295.0)
PIXEL_MAP_FROM(usv, GLushort, 65535.0)

static const struct pixel_map *find_map(struct context *ctx, GLenum map)
{
    const unsigned number = map - GL_PIXEL_MAP_I_TO_I;
    if (number < PIXEL_MAP_COUNT)
        return &ctx->pixel_map[number];
    fgl_error(ctx, GL_INVALID_ENUM);
    return NULL;
}

void fgl_exec_GetPixelMapfv(struct context *ctx, GLenum map, GLfloat *values)
{
    const struct pixel_map *m = find_map(ctx, map);
    if (m)
        memcpy(values, m->value, (size_t)m->size * sizeof *values);
}

#define GET_PIXEL_MAP(suffix, T, max)                                                                        \
    void fgl_exec_GetPixelMap##suffix(struct context *ctx, GLenum map, T *values)                            \
    {                                                                                                        \
        const struct pixel_map *m = find_map(ctx, map);                                                      \
        const bool indexes = holds_indexes(map - GL_PIXEL_MAP_I_TO_I);                                       \
        for (int i = 0; m && i < m->size; i++) {                                                             \
            const double v = (double)m->value[i] * (indexes ? 1.0 : (max));                                  \
            values[i] = (T)(v < 0.0 ? 0.0 : v > (max) ? (max) : v);                                          \
        }                                                                                                    \
    }
GET_PIXEL_MAP(uiv, GLuint, 4294967295.0)
GET_PIXEL_MAP(usv, GLushort, 65535.0)
