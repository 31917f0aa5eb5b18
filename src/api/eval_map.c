/* glMap and glGetMap (GL 1.5, 5.1 "Evaluators", 6.1.3 "Enumerated Queries"). */
#include "api/eval_map.h"
#include "api/command.h"
#include "api/convert.h"
#include "api/errors.h"
#include "api/list.h"

#include <stdlib.h>
#include <string.h>

/* What each map gives, and its initial control point (table 6.26). */
static const struct {
    enum fgl_attr attr;
    int size;
    float initial[BEZIER_MAX_SIZE];
} kinds[MAP_COUNT] = {
        [MAP_COLOR_4] = {ATTR_COLOR, 4, {1, 1, 1, 1}},
        [MAP_INDEX] = {ATTR_INDEX, 1, {1}},
        [MAP_NORMAL] = {ATTR_NORMAL, 3, {0, 0, 1}},
        [MAP_TEXTURE_COORD_1] = {ATTR_TEX0, 1, {0}},
        [MAP_TEXTURE_COORD_2] = {ATTR_TEX0, 2, {0, 0}},
        [MAP_TEXTURE_COORD_3] = {ATTR_TEX0, 3, {0, 0, 0}},
        [MAP_TEXTURE_COORD_4] = {ATTR_TEX0, 4, {0, 0, 0, 1}},
        [MAP_VERTEX_3] = {ATTR_POSITION, 3, {0, 0, 0}},
        [MAP_VERTEX_4] = {ATTR_POSITION, 4, {0, 0, 0, 1}},
};

int fgl_map_size(int map)
{
    return kinds[map].size;
}
enum fgl_attr fgl_map_attr(int map)
{
    return kinds[map].attr;
}

struct eval_maps *fgl_eval_maps(struct context *ctx)
{
    if (ctx->eval_maps)
        return ctx->eval_maps;
    struct eval_maps *maps = ctx->eval_maps = calloc(1, sizeof *maps);
    RETURN_VALUE_ERROR_IF(ctx, !maps, GL_OUT_OF_MEMORY, NULL);
    for (int dim = 0; dim < 2; dim++)
        for (int i = 0; i < MAP_COUNT; i++)
            maps->map[dim][i] = (struct eval_map){.net = {kinds[i].initial, {1, 1}, kinds[i].size},
                                                  .domain = {0, 1, 0, 1},
                                                  .scale = {1, 1}};
    return maps;
}

void fgl_eval_maps_destroy(struct context *ctx)
{
    for (int dim = 0; ctx->eval_maps && dim < 2; dim++)
        for (int i = 0; i < MAP_COUNT; i++)
            free(ctx->eval_maps->map[dim][i].points);
    free(ctx->eval_maps);
    ctx->eval_maps = NULL;
}

/* ---- glMap ---- */

/* A map with its control points close together: the payload of a display list's node. */
struct map_node {
    int32_t dim, map; /* dim: 0 for one dimension, 1 for two */
    int32_t order[2];
    float domain[4];
    float points[];
};

/* What glMap's callers give, of either type; without a second dimension order[1] is 1. */
struct map_call {
    GLenum target;
    float domain[4];
    GLint stride[2], order[2];
    const GLfloat *floats; /* one of these */
    const GLdouble *doubles;
};

/* The map that a target names in so many dimensions, -1 if none. */
static int map_of(GLenum target, int dim)
{
    const GLenum first = dim ? GL_MAP2_COLOR_4 : GL_MAP1_COLOR_4;
    return target >= first && target - first < MAP_COUNT ? (int)(target - first) : -1;
}

static GLenum check(const struct map_call *c, int dim)
{
    const int map = map_of(c->target, dim);
    if (map < 0)
        return GL_INVALID_ENUM;
    if (!c->floats && !c->doubles)
        return GL_INVALID_VALUE;
    for (int d = 0; d <= dim; d++)
        if (c->domain[2 * d] == c->domain[2 * d + 1] || c->stride[d] < kinds[map].size || c->order[d] < 1 ||
            c->order[d] > FGL_MAX_EVAL_ORDER)
            return GL_INVALID_VALUE;
    return GL_NO_ERROR;
}

static void fill_node(struct map_node *node, const struct map_call *c, int dim)
{
    node->dim = dim;
    node->map = map_of(c->target, dim);
    memcpy(node->order, c->order, sizeof node->order);
    memcpy(node->domain, c->domain, sizeof node->domain);
    float *to = node->points;
    for (ptrdiff_t i = 0; i < c->order[0]; i++)
        for (ptrdiff_t j = 0; j < c->order[1]; j++)
            for (ptrdiff_t k = 0; k < kinds[node->map].size; k++) {
                const ptrdiff_t at = i * c->stride[0] + j * c->stride[1] + k;
                *to++ = c->floats ? c->floats[at] : (float)c->doubles[at];
            }
}

void fgl_map_replay(struct context *ctx, void *payload)
{
    const struct map_node *node = payload;
    RETURN_ERROR_IF(ctx, ctx->s.texture.active_texture != 0, GL_INVALID_OPERATION);
    struct eval_maps *maps = fgl_eval_maps(ctx);
    const int size = kinds[node->map].size;
    const size_t bytes = (size_t)node->order[0] * (size_t)node->order[1] * (size_t)size * sizeof(float);
    float *points = malloc(bytes);
    RETURN_ERROR_IF(ctx, !maps || !points, GL_OUT_OF_MEMORY);
    fgl_flush_vertices(ctx, 0);
    memcpy(points, node->points, bytes);
    struct eval_map *m = &maps->map[node->dim][node->map];
    free(m->points);
    m->points = points;
    m->net = (struct bezier_net){points, {node->order[0], node->order[1]}, size};
    memcpy(m->domain, node->domain, sizeof m->domain);
    for (int d = 0; d < 2; d++)
        m->scale[d] = 1.0f / (m->domain[2 * d + 1] - m->domain[2 * d]);
}

/* Records, executes, or both. */
static void map(int dim, const struct map_call *c)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (fgl_refused_inside(ctx))
        return;
    const GLenum error = check(c, dim);
    if (error) {
        fgl_command_error(ctx, error);
        return;
    }
    const bool record = ctx->compiling;
    const size_t bytes =
            sizeof(struct map_node) + (size_t)(c->order[0] * c->order[1] * BEZIER_MAX_SIZE) * sizeof(float);
    struct map_node *node = record ? fgl_list_record(ctx, OP_MAP, bytes) : malloc(bytes);
    RETURN_ERROR_IF(ctx, !node, GL_OUT_OF_MEMORY);
    fill_node(node, c, dim);
    if (ctx->compiling != GL_COMPILE)
        fgl_map_replay(ctx, node);
    if (!record)
        free(node);
}

void GLAPIENTRY glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                        const GLfloat *points)
{
    map(0, &(struct map_call){target, {u1, u2, 0, 1}, {stride, 0}, {order, 1}, points, NULL});
}

void GLAPIENTRY glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                        const GLdouble *points)
{
    map(0, &(struct map_call){target, {(float)u1, (float)u2, 0, 1}, {stride, 0}, {order, 1}, NULL, points});
}

void GLAPIENTRY glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
                        GLfloat v2, GLint vstride, GLint vorder, const GLfloat *points)
{
    map(1, &(struct map_call){target, {u1, u2, v1, v2}, {ustride, vstride}, {uorder, vorder}, points, NULL});
}

void GLAPIENTRY glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
                        GLdouble v2, GLint vstride, GLint vorder, const GLdouble *points)
{
    const float domain[4] = {(float)u1, (float)u2, (float)v1, (float)v2};
    struct map_call c = {
            .target = target, .stride = {ustride, vstride}, .order = {uorder, vorder}, .doubles = points};
    memcpy(c.domain, domain, sizeof domain);
    map(1, &c);
}

/* ---- glGetMap ---- */

/* The values of a query, and how many; 0 after an error. */
static int get_map(struct context *ctx, GLenum target, GLenum query, float order[2], const float **values)
{
    const int dim = map_of(target, 1) >= 0;
    const int number = map_of(target, dim);
    RETURN_VALUE_ERROR_IF(ctx, number < 0, GL_INVALID_ENUM, 0);
    const struct eval_maps *maps = fgl_eval_maps(ctx);
    if (!maps)
        return 0;
    const struct eval_map *m = &maps->map[dim][number];
    switch (query) {
    case GL_COEFF: *values = m->net.points; return m->net.order[0] * m->net.order[1] * m->net.size;
    case GL_DOMAIN: *values = m->domain; return dim ? 4 : 2;
    case GL_ORDER:
        order[0] = (float)m->net.order[0];
        order[1] = (float)m->net.order[1];
        *values = order;
        return dim ? 2 : 1;
    default: fgl_error(ctx, GL_INVALID_ENUM); return 0;
    }
}

void fgl_exec_GetMapfv(struct context *ctx, GLenum target, GLenum query, GLfloat *v)
{
    float order[2];
    const float *values;
    const int n = get_map(ctx, target, query, order, &values);
    for (int i = 0; i < n; i++)
        v[i] = values[i];
}

void fgl_exec_GetMapdv(struct context *ctx, GLenum target, GLenum query, GLdouble *v)
{
    float order[2];
    const float *values;
    const int n = get_map(ctx, target, query, order, &values);
    for (int i = 0; i < n; i++)
        v[i] = (double)values[i];
}

void fgl_exec_GetMapiv(struct context *ctx, GLenum target, GLenum query, GLint *v)
{
    float order[2];
    const float *values;
    const int n = get_map(ctx, target, query, order, &values);
    for (int i = 0; i < n; i++)
        v[i] = fgl_int_round((double)values[i]);
}
