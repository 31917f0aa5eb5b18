/* Pixel transfer modes and pixel maps (GL 1.5, 3.6.3 "Pixel Transfer Modes"; queries 6.1.3 "Enumerated
 * Queries"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "api/pixel_image.h"
#include "api/set.h"
#include "state/share.h"

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

/* Maps to indexes keep the nearest integers, maps to colours values in [0,1]. */
static void set_map(struct context *ctx, GLenum map, GLsizei mapsize, const GLfloat *values)
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

struct map_node {
    GLenum map;
    GLsizei size;
    GLfloat value[FGL_MAX_PIXEL_MAP];
};

void fgl_list_replay_pixel_map(struct context *ctx, const void *payload)
{
    const struct map_node *n = payload;
    set_map(ctx, n->map, n->size, n->value);
}

/* n: the values that there are, none when mapsize is an error. */
static void map_command(struct context *ctx, GLenum map, GLsizei mapsize, const GLfloat *values, int n)
{
    if (ctx->compiling) {
        struct map_node *node = fgl_list_record(ctx, OP_PIXEL_MAP, sizeof *node);
        if (node) {
            node->map = map;
            node->size = mapsize;
            memcpy(node->value, values, (size_t)n * sizeof *values);
        }
    }
    if (ctx->compiling != GL_COMPILE)
        set_map(ctx, map, mapsize, values);
}

/* Integers to indexes are themselves, to colours fractions of the greatest. */
#define PIXEL_MAP(suffix, T, max)                                                                            \
    static void map_##suffix(struct context *ctx, GLenum map, GLsizei mapsize, const void *values)           \
    {                                                                                                        \
        GLfloat v[FGL_MAX_PIXEL_MAP];                                                                        \
        const int n = mapsize >= 1 && mapsize <= FGL_MAX_PIXEL_MAP ? mapsize : 0;                            \
        const bool indexes = holds_indexes(map - GL_PIXEL_MAP_I_TO_I);                                       \
        if (n && !fgl_buffer_elements(ctx, &ctx->client.unpack, n, sizeof(T), &values))                      \
            return;                                                                                          \
        const T *from = values;                                                                              \
        for (int i = 0; i < n; i++)                                                                          \
            v[i] = indexes ? (GLfloat)from[i] : (GLfloat)((double)from[i] / (max));                          \
        map_command(ctx, map, mapsize, v, n);                                                                \
    }                                                                                                        \
    void GLAPIENTRY glPixelMap##suffix(GLenum map, GLsizei mapsize, const T *values)                         \
    {                                                                                                        \
        struct context *ctx = fgl_current;                                                                   \
        if (ctx && !fgl_refused_inside(ctx))                                                                 \
            FGL_SHARED(ctx, map_##suffix(ctx, map, mapsize, values));                                        \
    }
PIXEL_MAP(fv, GLfloat, 1.0)
PIXEL_MAP(uiv, GLuint, 4294967295.0)
PIXEL_MAP(usv, GLushort, 65535.0)

static const struct pixel_map *find_map(struct context *ctx, GLenum map)
{
    const unsigned number = map - GL_PIXEL_MAP_I_TO_I;
    if (number < PIXEL_MAP_COUNT)
        return &ctx->pixel_map[number];
    fgl_error(ctx, GL_INVALID_ENUM);
    return NULL;
}

#define GET_PIXEL_MAP(suffix, T, max)                                                                    \
    void fgl_exec_GetPixelMap##suffix(struct context *ctx, GLenum map, T *values)                            \
    {                                                                                                        \
        const struct pixel_map *m = find_map(ctx, map);                                                      \
        const bool indexes = holds_indexes(map - GL_PIXEL_MAP_I_TO_I);                                       \
        const void *to = values;                                                                             \
        if (!m || !fgl_buffer_elements(ctx, &ctx->client.pack, m->size, sizeof(T), &to))                     \
            return;                                                                                          \
        for (int i = 0; i < m->size; i++) {                                                                  \
            const double v = (double)m->value[i] * (indexes ? 1.0 : (max));                                  \
            ((T *)to)[i] = (T)(v < 0.0 ? 0.0 : v > (max) ? (max) : v);                               \
        }                                                                                                    \
    }
GET_PIXEL_MAP(uiv, GLuint, 4294967295.0)
GET_PIXEL_MAP(usv, GLushort, 65535.0)

/* As they are kept. */
void fgl_exec_GetPixelMapfv(struct context *ctx, GLenum map, GLfloat *values)
{
    const struct pixel_map *m = find_map(ctx, map);
    const void *to = values;
    if (m && fgl_buffer_elements(ctx, &ctx->client.pack, m->size, sizeof *values, &to))
        memcpy((void *)to, m->value, (size_t)m->size * sizeof *values);
}
