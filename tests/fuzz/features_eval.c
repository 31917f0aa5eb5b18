/* Features: evaluators, feedback, selection. */
#include "generator.h"

#include <string.h>

/* ---- evaluators ---- */

static void add_control_points(struct generator *g, unsigned target, int count)
{
    for (int i = 0; i < count; i++) {
        double v[4];
        if (target == GL_MAP1_COLOR_4 || target == GL_MAP2_COLOR_4)
            random_color(g, v);
        else if (target == GL_MAP1_NORMAL || target == GL_MAP2_NORMAL)
            random_normal(g, v);
        else
            random_position(g, v);
        const bool four = target == GL_MAP1_COLOR_4 || target == GL_MAP2_COLOR_4 || target == GL_MAP1_VERTEX_4 || target == GL_MAP2_VERTEX_4;
        script_extend(g->script, four ? 4 : 3, v);
    }
}

static int components(unsigned target)
{
    return target == GL_MAP1_NORMAL || target == GL_MAP2_NORMAL || target == GL_MAP1_VERTEX_3 || target == GL_MAP2_VERTEX_3 ? 3 : 4;
}

static void emit_map1(struct generator *g, unsigned target)
{
    const int order = integer(g, 1, 6), stride = components(target);
    EMIT(g, Map1f, target, 0, chance(g, 70) ? 1 : 2, stride, order);
    add_control_points(g, target, order);
    EMIT(g, Enable, target);
}

/* Of order 2 or more: with GL_AUTO_NORMAL OSMesa's surfaces of order 1 are arbitrary. */
static void emit_map2(struct generator *g, unsigned target)
{
    const int uorder = integer(g, 2, 5), vorder = integer(g, 2, 5), stride = components(target);
    EMIT(g, Map2f, target, 0, 1, stride * vorder, uorder, chance(g, 70) ? 0 : -1, 1, stride, vorder);
    add_control_points(g, target, uorder * vorder);
    EMIT(g, Enable, target);
}

/* OSMesa mixes up current values that maps gave: they are set again. */
static void restore_current(struct generator *g)
{
    emit_color(g);
    emit_normal(g);
}

/* No lines with a stipple, see random_mode. */
static double mesh_mode(struct generator *g)
{
    return g->used[FEATURE_line_stipple] ? ONE_OF(g, GL_POINT, GL_FILL) : ONE_OF(g, GL_POINT, GL_LINE, GL_FILL, GL_FILL);
}

void feature_eval_mesh(struct generator *g)
{
    if (g->compiling)
        return;
    const bool surface = chance(g, 60);
    if (surface) {
        emit_map2(g, chance(g, 70) ? GL_MAP2_VERTEX_3 : GL_MAP2_VERTEX_4);
        if (chance(g, 40))
            emit_map2(g, GL_MAP2_COLOR_4);
        if (chance(g, 30))
            emit_map2(g, GL_MAP2_NORMAL);
        else
            toggle(g, GL_AUTO_NORMAL, 50);
        EMIT(g, MapGrid2f, integer(g, 1, 6), 0, 1, integer(g, 1, 6), real(g, 0.0, 0.3), real(g, 0.5, 1.0));
        EMIT(g, EvalMesh2, mesh_mode(g), 0, integer(g, 1, 6), integer(g, 0, 2), integer(g, 3, 6));
    } else {
        emit_map1(g, chance(g, 70) ? GL_MAP1_VERTEX_3 : GL_MAP1_VERTEX_4);
        if (chance(g, 40))
            emit_map1(g, GL_MAP1_COLOR_4);
        EMIT(g, MapGrid1f, integer(g, 1, 12), 0, real(g, 0.5, 1.0));
        EMIT(g, EvalMesh1, g->used[FEATURE_line_stipple] ? GL_POINT : ONE_OF(g, GL_POINT, GL_LINE), 0, integer(g, 1, 12));
    }
    restore_current(g);
}

void feature_eval_coord(struct generator *g)
{
    if (g->compiling)
        return;
    const bool surface = chance(g, 40);
    if (surface)
        emit_map2(g, GL_MAP2_VERTEX_3);
    else
        emit_map1(g, GL_MAP1_VERTEX_3);
    if (surface)
        EMIT(g, MapGrid2f, 8, 0, 1, 8, 0, 1);
    else
        EMIT(g, MapGrid1f, 8, 0, 1);
    const int mode = (int)ONE_OF(g, GL_POINTS, GL_LINES, GL_TRIANGLES, GL_TRIANGLE_FAN, GL_POLYGON);
    EMIT(g, Begin, mode);
    emit_color(g);
    emit_normal(g);
    for (int n = vertex_count(g, mode, integer(g, 3, 9)); n > 0; n--) {
        if (chance(g, 40))
            emit_color(g);
        if (surface && chance(g, 70))
            EMIT(g, EvalCoord2f, real(g, 0.0, 1.0), real(g, 0.0, 1.0));
        else if (surface)
            EMIT(g, EvalPoint2, below(g, 9), below(g, 9));
        else if (chance(g, 70))
            EMIT(g, EvalCoord1f, real(g, 0.0, 1.0));
        else
            EMIT(g, EvalPoint1, below(g, 9));
    }
    EMIT0(g, End);
    restore_current(g);
}

/* ---- feedback and selection ---- */

/* Points and filled, smooth polygons: OSMesa loses line resets, edge flags and provoking vertices. */
static void emit_fed_back(struct generator *g)
{
    static const int modes[] = {GL_POINTS, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_POLYGON};
    const int mode = modes[below(g, 5)], count = vertex_count(g, mode, integer(g, 3, 6));
    EMIT(g, Begin, mode);
    emit_vertices(g, count);
    EMIT0(g, End);
}

/* Its units get lost in OSMesa. */
static void disable_offset(struct generator *g)
{
    EMIT(g, Disable, GL_POLYGON_OFFSET_FILL);
    EMIT(g, Disable, GL_POLYGON_OFFSET_LINE);
    EMIT(g, Disable, GL_POLYGON_OFFSET_POINT);
}

void feature_feedback(struct generator *g)
{
    if (g->compiling || g->pushed)
        return;
    EMIT(g, ShadeModel, GL_SMOOTH);
    settle_shade_model(g);
    EMIT(g, PolygonMode, GL_FRONT_AND_BACK, GL_FILL);
    disable_offset(g);
    EMIT(g, FeedbackBuffer, chance(g, 90) ? 2000 : integer(g, 1, 60), ONE_OF(g, GL_2D, GL_3D, GL_3D_COLOR, GL_4D_COLOR_TEXTURE));
    EMIT(g, RenderMode, GL_FEEDBACK);
    for (int n = integer(g, 1, 3); n > 0; n--) {
        if (chance(g, 30))
            EMIT(g, PassThrough, real(g, -5.0, 5.0));
        emit_fed_back(g);
    }
    EMIT(g, RenderMode, GL_RENDER);
    emit_unseen_point(g); /* departure draws-after-feedback */
}

/* OSMesa gives the depth 1.0 as 0. */
void feature_selection(struct generator *g)
{
    if (g->compiling || g->pushed)
        return;
    disable_offset(g);
    EMIT(g, DepthRange, real(g, 0.0, 0.4), real(g, 0.5, 0.9));
    EMIT(g, SelectBuffer, chance(g, 90) ? 500 : integer(g, 1, 12));
    EMIT(g, RenderMode, GL_SELECT);
    EMIT0(g, InitNames);
    EMIT(g, PushName, below(g, 100));
    for (int n = integer(g, 1, 5); n > 0; n--) {
        switch (below(g, 4)) {
        case 0: EMIT(g, PushName, below(g, 100)); break;
        case 1: EMIT0(g, PopName); break;
        default: EMIT(g, LoadName, below(g, 100));
        }
        emit_fed_back(g);
    }
    EMIT(g, RenderMode, GL_RENDER);
}
