/* Evaluators (GL 1.5, 5.1): glEvalCoord, grids and meshes. A vertex made here goes through immediate mode as
 * if the program had given it; its other attributes are for it alone, and the current values stay. */
#include "api/eval.h"
#include "api/command.h"
#include "api/errors.h"
#include "api/eval_map.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "api/set.h"

#include <math.h>
#include <string.h>

/* ---- one vertex ---- */

/* Attributes that the enabled maps gave one vertex. */
struct evaluated {
    int n;
    struct {
        enum fgl_attr attr;
        int size;
        float value[4], before[4];
    } attribute[MAP_COUNT];
    int position_size; /* 0: no map gives a position */
    float position[4];
};

/* GL 1.5, 5.1: of several maps for the same attribute the one with most components counts. */
static unsigned without_overridden(unsigned maps)
{
    for (int i = MAP_TEXTURE_COORD_4; i > MAP_TEXTURE_COORD_1; i--)
        if (maps >> i & 1)
            maps &= ~((1u << i) - (1u << MAP_TEXTURE_COORD_1));
    if (maps >> MAP_VERTEX_4 & 1)
        maps &= ~(1u << MAP_VERTEX_3);
    return maps;
}

static void parameters(const struct eval_map *m, const float coord[2], float t[2])
{
    for (int d = 0; d < 2; d++)
        t[d] = (coord[d] - m->domain[2 * d]) * m->scale[d];
}

static void add_attribute(struct evaluated *e, enum fgl_attr attr, int size, const float *value)
{
    int i = 0;
    while (i < e->n && e->attribute[i].attr != attr)
        i++;
    if (i == e->n)
        e->n++;
    e->attribute[i].attr = attr;
    e->attribute[i].size = size;
    memcpy(e->attribute[i].value, value, (size_t)size * sizeof(float));
}

/* GL_AUTO_NORMAL: the cross product of the partial derivatives, of x/w, y/w, z/w for GL_MAP2_VERTEX_4. */
static void auto_normal(struct evaluated *e, const struct eval_map *m, const float t[2])
{
    float d[2][4], *p = e->position;
    fgl_bezier_tangents(&m->net, t[0], t[1], p, d[0], d[1]);
    for (int i = 0; m->net.size == 4 && i < 2; i++)
        for (int k = 0; k < 3; k++)
            d[i][k] = d[i][k] * p[3] - d[i][3] * p[k];
    float normal[3];
    for (int k = 0; k < 3; k++)
        normal[k] = d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
    const float length2 = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const float scale = length2 != 0.0f ? 1.0f / sqrtf(length2) : 1.0f;
    for (int k = 0; k < 3; k++)
        normal[k] *= scale;
    add_attribute(e, ATTR_NORMAL, 3, normal);
}

/* Evaluates the enabled maps of `dim` (0: one dimension, 1: two) at a coordinate. */
static void evaluate(struct context *ctx, int dim, const float coord[2], struct evaluated *e)
{
    const unsigned maps = without_overridden(dim ? ctx->s.eval.map2_enabled : ctx->s.eval.map1_enabled);
    const struct eval_maps *all = fgl_eval_maps(ctx);
    e->n = e->position_size = 0;
    for (int i = 0; all && i < MAP_COUNT; i++) {
        const struct eval_map *m = &all->map[dim][i];
        float t[2], value[4];
        if (!(maps >> i & 1))
            continue;
        const bool position = fgl_map_attr(i) == ATTR_POSITION;
        parameters(m, coord, t);
        e->position_size = position ? fgl_map_size(i) : 0;
        if (position && dim && ctx->s.eval.auto_normal) {
            auto_normal(e, m, t);
            continue;
        }
        if (dim)
            fgl_bezier_surface(&m->net, t[0], t[1], position ? e->position : value);
        else
            fgl_bezier_curve(&m->net, t[0], position ? e->position : value);
        if (!position)
            add_attribute(e, fgl_map_attr(i), fgl_map_size(i), value);
    }
}

/* The value of an attribute that the next vertex would have, and how many of its components matter. */
static int next_value(struct context *ctx, enum fgl_attr attr, float v[4])
{
    static const float unset[4] = {0, 0, 0, 1};
    const struct immediate *im = ctx->vertices;
    const int in_format = im->format.size[attr];
    memcpy(v, unset, sizeof unset);
    if (in_format) {
        memcpy(v, im->vertex + im->format.offset[attr], (size_t)in_format * sizeof(float));
        return in_format;
    }
    memcpy(v, fgl_current_attr(ctx, attr), 4 * sizeof(float));
    int size = 4;
    while (size > 1 && v[size - 1] == unset[size - 1])
        size--;
    return size;
}

static void send(struct context *ctx, struct evaluated *e)
{
    for (int i = 0; i < e->n; i++) {
        const int before = next_value(ctx, e->attribute[i].attr, e->attribute[i].before);
        float v[4] = {0, 0, 0, 1};
        memcpy(v, e->attribute[i].value, (size_t)e->attribute[i].size * sizeof(float));
        e->attribute[i].size =
                fgl_max(e->attribute[i].size, before); /* room for what comes back afterwards */
        fgl_attr_set(ctx, e->attribute[i].attr, e->attribute[i].size, v);
    }
    fgl_vertex(ctx, e->position_size, e->position);
    for (int i = 0; i < e->n; i++)
        fgl_attr_set(ctx, e->attribute[i].attr, e->attribute[i].size, e->attribute[i].before);
}

/* Without a map for positions there is no vertex, and outside Begin/End nobody asked for one. */
static void eval_coord(struct context *ctx, int dim, float u, float v)
{
    struct evaluated e;
    if (ctx->begin_mode == OUTSIDE_BEGIN_END)
        return;
    evaluate(ctx, dim, (float[2]){u, v}, &e);
    if (e.position_size)
        send(ctx, &e);
}

/* ---- grids ---- */

/* The distance of grid points: direction 0 is u, 1 is v. */
static float step(const struct context *ctx, int dim, int direction)
{
    const struct eval_state *s = &ctx->s.eval;
    const float *domain = (dim ? s->map2_grid_domain : s->map1_grid_domain) + 2 * direction;
    const int segments = dim ? s->map2_grid_segments[direction] : s->map1_grid_segments;
    return (domain[1] - domain[0]) / (float)segments;
}

static float grid_point(const struct context *ctx, int dim, int direction, int i)
{
    const struct eval_state *s = &ctx->s.eval;
    return (float)i * step(ctx, dim, direction) +
           (dim ? s->map2_grid_domain : s->map1_grid_domain)[2 * direction];
}

void fgl_exec_MapGrid1f(struct context *ctx, GLint un, GLfloat u1, GLfloat u2)
{
    struct eval_state *s = &ctx->s.eval;
    RETURN_ERROR_IF(ctx, un < 1, GL_INVALID_VALUE);
    fgl_set_floats(ctx, 0, s->map1_grid_domain, (float[]){u1, u2}, 2);
    SET(ctx, 0, s->map1_grid_segments, un);
}

void fgl_exec_MapGrid2f(struct context *ctx, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1,
                        GLfloat v2)
{
    struct eval_state *s = &ctx->s.eval;
    RETURN_ERROR_IF(ctx, un < 1 || vn < 1, GL_INVALID_VALUE);
    fgl_set_floats(ctx, 0, s->map2_grid_domain, (float[]){u1, u2, v1, v2}, 4);
    SET(ctx, 0, s->map2_grid_segments[0], un);
    SET(ctx, 0, s->map2_grid_segments[1], vn);
}

void GLAPIENTRY glMapGrid1d(GLint un, GLdouble u1, GLdouble u2)
{
    glMapGrid1f(un, (GLfloat)u1, (GLfloat)u2);
}

void GLAPIENTRY glMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2)
{
    glMapGrid2f(un, (GLfloat)u1, (GLfloat)u2, vn, (GLfloat)v1, (GLfloat)v2);
}

/* ---- glEvalCoord, glEvalPoint: allowed between Begin and End ---- */

struct eval_node {
    int32_t dim; /* 0: one dimension, 1: two */
    bool on_grid;
    float coord[2];   /* of glEvalCoord */
    int32_t point[2]; /* of glEvalPoint */
};

void fgl_eval_replay(struct context *ctx, void *payload)
{
    const struct eval_node *n = payload;
    if (n->on_grid)
        eval_coord(ctx, n->dim, grid_point(ctx, n->dim, 0, n->point[0]),
                   n->dim ? grid_point(ctx, 1, 1, n->point[1]) : 0);
    else
        eval_coord(ctx, n->dim, n->coord[0], n->coord[1]);
}

/* Records, executes, or both. */
static void eval(struct eval_node node)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (ctx->compiling) {
        struct eval_node *recorded = fgl_list_record(ctx, OP_EVAL, sizeof node);
        if (recorded)
            *recorded = node;
        if (ctx->compiling == GL_COMPILE)
            return;
    }
    const struct list_pause pause = fgl_list_pause(ctx);
    fgl_eval_replay(ctx, &node);
    fgl_list_resume(ctx, pause);
}

#define EVAL_COORD(T, s)                                                                                     \
    void GLAPIENTRY glEvalCoord1##s(T u)                                                                     \
    {                                                                                                        \
        eval((struct eval_node){.dim = 0, .coord = {(float)u}});                                             \
    }                                                                                                        \
    void GLAPIENTRY glEvalCoord2##s(T u, T v)                                                                \
    {                                                                                                        \
        eval((struct eval_node){.dim = 1, .coord = {(float)u, (float)v}});                                   \
    }                                                                                                        \
    void GLAPIENTRY glEvalCoord1##s##v(const T *u)                                                           \
    {                                                                                                        \
        glEvalCoord1##s(u[0]);                                                                               \
    }                                                                                                        \
    void GLAPIENTRY glEvalCoord2##s##v(const T *u)                                                           \
    {                                                                                                        \
        glEvalCoord2##s(u[0], u[1]);                                                                         \
    }
EVAL_COORD(GLfloat, f)
EVAL_COORD(GLdouble, d)

void GLAPIENTRY glEvalPoint1(GLint i)
{
    eval((struct eval_node){.dim = 0, .on_grid = true, .point = {i}});
}
void GLAPIENTRY glEvalPoint2(GLint i, GLint j)
{
    eval((struct eval_node){.dim = 1, .on_grid = true, .point = {i, j}});
}

/* ---- glEvalMesh: OSMesa rule: grid lines lie a step from each other, not each at its multiple of the step
 * ---- */

/* The part of a grid that a mesh covers. */
struct mesh {
    struct context *ctx;
    float first[2], step[2];
    int count[2]; /* points */
};

static struct mesh mesh_of(struct context *ctx, int dim, const GLint first[2], const GLint last[2])
{
    struct mesh m = {.ctx = ctx};
    for (int d = 0; d <= dim; d++) {
        m.first[d] = grid_point(ctx, dim, d, first[d]);
        m.step[d] = step(ctx, dim, d);
        const int64_t count = (int64_t)last[d] - first[d] + 1;
        m.count[d] = count < 0 ? 0 : count < INT32_MAX ? (int)count : INT32_MAX;
    }
    return m;
}

static bool has_position(unsigned maps)
{
    return maps >> MAP_VERTEX_3 & 3;
}

void fgl_exec_EvalMesh1(struct context *ctx, GLenum mode, GLint i1, GLint i2)
{
    RETURN_ERROR_IF(ctx, mode != GL_POINT && mode != GL_LINE, GL_INVALID_ENUM);
    if (!has_position(ctx->s.eval.map1_enabled) || !fgl_draw_ready(ctx))
        return;
    const struct list_pause pause = fgl_list_pause(ctx);
    const struct mesh m = mesh_of(ctx, 0, (GLint[2]){i1}, (GLint[2]){i2});
    float u = m.first[0];
    fgl_begin(ctx, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for (int i = 0; i < m.count[0]; i++, u += m.step[0])
        eval_coord(ctx, 0, u, 0);
    fgl_end(ctx);
    fgl_list_resume(ctx, pause);
}

/* A row of points: along u at v, or along v at u. */
static void mesh_row(const struct mesh *m, int along, float at)
{
    float t = m->first[along];
    for (int i = 0; i < m->count[along]; i++, t += m->step[along])
        eval_coord(m->ctx, 1, along ? at : t, along ? t : at);
}

static void mesh_points(const struct mesh *m)
{
    float v = m->first[1];
    fgl_begin(m->ctx, GL_POINTS);
    for (int j = 0; j < m->count[1]; j++, v += m->step[1])
        mesh_row(m, 0, v);
    fgl_end(m->ctx);
}

static void mesh_lines(const struct mesh *m)
{
    for (int along = 0; along < 2; along++) {
        float at = m->first[1 - along];
        for (int j = 0; j < m->count[1 - along]; j++, at += m->step[1 - along]) {
            fgl_begin(m->ctx, GL_LINE_STRIP);
            mesh_row(m, along, at);
            fgl_end(m->ctx);
        }
    }
}

static void mesh_strips(const struct mesh *m)
{
    float v = m->first[1];
    for (int j = 0; j + 1 < m->count[1]; j++, v += m->step[1]) {
        float u = m->first[0];
        fgl_begin(m->ctx, GL_TRIANGLE_STRIP);
        for (int i = 0; i < m->count[0]; i++, u += m->step[0]) {
            eval_coord(m->ctx, 1, u, v);
            eval_coord(m->ctx, 1, u, v + m->step[1]);
        }
        fgl_end(m->ctx);
    }
}

void fgl_exec_EvalMesh2(struct context *ctx, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2)
{
    RETURN_ERROR_IF(ctx, mode != GL_POINT && mode != GL_LINE && mode != GL_FILL, GL_INVALID_ENUM);
    if (!has_position(ctx->s.eval.map2_enabled) || !fgl_draw_ready(ctx))
        return;
    const struct list_pause pause = fgl_list_pause(ctx);
    const struct mesh m = mesh_of(ctx, 1, (GLint[2]){i1, j1}, (GLint[2]){i2, j2});
    switch (mode) {
    case GL_POINT: mesh_points(&m); break;
    case GL_LINE: mesh_lines(&m); break;
    default: mesh_strips(&m); break;
    }
    fgl_list_resume(ctx, pause);
}
