/* Features: display lists, attribute stacks. */
#include "generator.h"

/* Some state and drawing within a list or a pair of Push and Pop. */
static void emit_body(struct generator *g)
{
    g->depth++;
    for (int n = integer(g, 1, 4); n > 0; n--) {
        if (chance(g, 40))
            random_state(g);
        else
            random_draw(g);
    }
    g->depth--;
}

/* A list of vertices without Begin and End, to be called between them. */
static void emit_vertex_list(struct generator *g)
{
    const bool lists_inside = g->enabled[FEATURE_list_inside];
    g->enabled[FEATURE_list_inside] = false;
    EMIT(g, NewList, 1 + g->vertex_lists++, GL_COMPILE);
    g->steady = true;
    emit_vertices(g, integer(g, 1, 5));
    g->steady = false;
    EMIT0(g, EndList);
    g->enabled[FEATURE_list_inside] = lists_inside;
}

static unsigned new_list(struct generator *g, bool with_execute)
{
    const unsigned list = FIRST_LIST + g->lists;
    EMIT(g, NewList, list, with_execute ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    const enum space space = g->space;
    const double grid = g->grid;
    g->compiling = true;
    g->executing = with_execute;
    emit_body(g);
    g->compiling = g->executing = false;
    if (!with_execute) {
        g->space = space; /* a view in the list was not set now */
        g->grid = grid;
    }
    EMIT0(g, EndList);
    g->lists++;
    return list;
}

/* Before a list is called: OSMesa must notice the current color, which else comes back after the list. */
static void notice_color(struct generator *g)
{
    if (!g->compiling)
        EMIT(g, GetFloatv, GL_CURRENT_COLOR);
}

static void call_some_list(struct generator *g)
{
    notice_color(g);
    if (g->lists)
        EMIT(g, CallList, FIRST_LIST + below(g, (int)g->lists));
}

void feature_list(struct generator *g)
{
    if (g->compiling || g->depth >= MAX_DEPTH) {
        call_some_list(g); /* nested lists; those that exist already, so that there are no circles */
        return;
    }
    if (chance(g, 30) && g->vertex_lists < 8)
        emit_vertex_list(g);
    const bool execute = chance(g, 30);
    const unsigned list = new_list(g, execute);
    for (int n = integer(g, execute ? 0 : 1, 2); n > 0; n--) {
        if (chance(g, 50))
            random_state(g);
        notice_color(g);
        EMIT(g, CallList, list);
    }
    if (chance(g, 20)) {
        EMIT(g, DeleteLists, list, 1);
        EMIT(g, CallList, list);
    }
}

void feature_call_lists(struct generator *g)
{
    static const double types[] = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT,
                                   GL_2_BYTES, GL_3_BYTES, GL_4_BYTES};
    while (g->lists < 2 && !g->compiling && g->depth < MAX_DEPTH)
        new_list(g, false);
    if (g->lists == 0 || g->compiling)
        return; /* whether the base may change while several lists are called is left open */
    const int base = chance(g, 50) ? 0 : FIRST_LIST - below(g, 20), count = integer(g, 1, 4);
    EMIT(g, ListBase, base);
    notice_color(g);
    EMIT(g, CallLists, count, one_of(g, 10, types));
    for (int i = 0; i < count; i++) {
        const double list = FIRST_LIST - base + below(g, (int)g->lists);
        script_extend(g->script, 1, &list);
    }
    EMIT(g, ListBase, 0);
}

void feature_list_inside(struct generator *g)
{
    if (g->vertex_lists)
        EMIT(g, CallList, 1 + below(g, (int)g->vertex_lists));
}

void feature_attrib_stack(struct generator *g)
{
    if (g->depth >= MAX_DEPTH || g->compiling || g->pushed)
        return; /* not within each other: OSMesa forgets at the inner PopAttrib what the outer one has to restore */
    static const double masks[] = {GL_CURRENT_BIT, GL_POINT_BIT, GL_LINE_BIT, GL_POLYGON_BIT, GL_POLYGON_STIPPLE_BIT, GL_LIGHTING_BIT,
                                   GL_FOG_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_VIEWPORT_BIT, GL_TRANSFORM_BIT, GL_ENABLE_BIT,
                                   GL_COLOR_BUFFER_BIT, GL_HINT_BIT, GL_LIST_BIT, GL_SCISSOR_BIT};
    const double bits = chance(g, 40) ? (double)GL_ALL_ATTRIB_BITS : chance(g, 50) ? one_of(g, 16, masks) : below(g, 0x100000);
    unsigned mask = (unsigned)bits;
    if (g->enabled[FEATURE_clip_plane]) /* OSMesa does not bring clip planes back rightly */
        mask &= ~(unsigned)GL_TRANSFORM_BIT;
    if (g->enabled[FEATURE_lighting] && (mask & GL_ENABLE_BIT)) /* which brings no lights back (departure popped-state) */
        mask |= GL_LIGHTING_BIT;
    if (g->levels_set) /* base levels may come back to images that it has lost (departure lost-levels) */
        mask &= ~(unsigned)GL_TEXTURE_BIT;
    EMIT(g, PushAttrib, (double)mask);
    g->pushed = true;
    emit_body(g);
    g->pushed = false;
    /* OSMesa must draw to notice what has been set, and materials must be told of the color. */
    EMIT(g, Begin, GL_POINTS);
    emit_vertex(g);
    EMIT0(g, End);
    EMIT0(g, PopAttrib);
    emit_color(g);
    /* Two that OSMesa does not bring back (departure popped-state). */
    if (g->enabled[FEATURE_color_sum])
        toggle(g, GL_COLOR_SUM, 80);
    if (g->enabled[FEATURE_fog_coordinate])
        EMIT(g, Fogi, GL_FOG_COORD_SRC, ONE_OF(g, GL_FOG_COORD, GL_FRAGMENT_DEPTH));
    settle_shade_model(g);
    random_draw(g);
}
