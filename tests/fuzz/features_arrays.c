/* Features: vertex arrays. Every array has ARRAY_VERTICES elements, so that one that stays enabled can always be read. */
#include "generator.h"

#include <math.h>
#include <stdlib.h>

static const double integer_types[] = {GL_SHORT, GL_INT};
static const double color_types[] = {GL_FLOAT, GL_DOUBLE, GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT};
static const double color_largest[] = {0.0, 0.0, 255.0, 127.0, 65535.0, 32767.0, 4294967295.0, 2147483647.0};

/* Tight, or with a gap of some bytes. */
static double stride(struct generator *g, int size)
{
    return chance(g, 60) ? 0.0 : size + 4 * below(g, 4);
}

static int size_of(double type)
{
    return type == GL_DOUBLE ? 8 : type == GL_FLOAT || type == GL_INT || type == GL_UNSIGNED_INT ? 4
           : type == GL_SHORT || type == GL_UNSIGNED_SHORT ? 2 : 1;
}

static void emit_vertex_array(struct generator *g)
{
    const int size = chance(g, 60) ? 3 : integer(g, 2, 4);
    double type = chance(g, 80) ? GL_FLOAT : GL_DOUBLE;
    if (g->space != CLIP_SPACE && chance(g, 15))
        type = one_of(g, 2, integer_types);
    EMIT(g, VertexPointer, size, type, stride(g, size * size_of(type)));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        double v[4];
        random_position(g, v);
        for (int k = 0; k < 3 && size_of(type) <= 4 && type != GL_FLOAT; k++)
            v[k] = round(v[k]);
        script_extend(g->script, size, v);
    }
    EMIT(g, EnableClientState, GL_VERTEX_ARRAY);
}

static void emit_color_array(struct generator *g)
{
    const int form = chance(g, 40) ? 2 : chance(g, 50) ? 0 : below(g, 8), size = g->color_size;
    EMIT(g, ColorPointer, size, color_types[form], stride(g, size * size_of(color_types[form]) + (form == 2 ? 4 - size : 0)));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        double c[4];
        random_color(g, c);
        for (int k = 0; k < 4 && color_largest[form] > 0.0; k++)
            c[k] = floor(fmin(fmax(c[k], 0.0), 1.0) * color_largest[form]);
        script_extend(g->script, size, c);
    }
    EMIT(g, EnableClientState, GL_COLOR_ARRAY);
}

static void emit_normal_array(struct generator *g)
{
    static const double types[] = {GL_FLOAT, GL_DOUBLE, GL_INT, GL_SHORT, GL_BYTE};
    static const double most[] = {0.0, 0.0, 2147483647.0, 32767.0, 127.0};
    const int form = chance(g, 60) ? 0 : below(g, 5);
    EMIT(g, NormalPointer, types[form], stride(g, 3 * size_of(types[form]) + (form == 4 ? 1 : form == 3 ? 2 : 0)));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        double n[3];
        random_normal(g, n);
        for (int k = 0; k < 3 && form >= 2; k++)
            n[k] = floor(n[k] * most[form]);
        script_extend(g->script, 3, n);
    }
    EMIT(g, EnableClientState, GL_NORMAL_ARRAY);
}

/* Ones: primitives of all modes are drawn from the arrays (see feature_edge_flag). */
static void emit_edge_flag_array(struct generator *g)
{
    EMIT(g, EdgeFlagPointer, below(g, 5));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        const double flag = 1.0;
        script_extend(g->script, 1, &flag);
    }
    EMIT(g, EnableClientState, GL_EDGE_FLAG_ARRAY);
}

void disable_arrays(struct generator *g, int percent)
{
    static const double arrays[] = {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_EDGE_FLAG_ARRAY, GL_TEXTURE_COORD_ARRAY};
    for (int i = 0; i < 5; i++) {
        if (chance(g, percent))
            EMIT(g, DisableClientState, arrays[i]);
    }
}

void emit_arrays(struct generator *g)
{
    emit_vertex_array(g);
    g->arrays_set = true;
    if (chance(g, 65))
        emit_color_array(g);
    if (chance(g, 40))
        emit_normal_array(g);
    if (chance(g, 10) && g->enabled[FEATURE_edge_flag])
        emit_edge_flag_array(g);
}

int array_mode(struct generator *g)
{
    const int mode = random_mode(g);
    const bool contained = g->contained;
    g->contained = false;
    return contained ? GL_LINES : mode;
}

void emit_draw_arrays(struct generator *g)
{
    const int first = below(g, 8);
    if (chance(g, 40))
        emit_color(g);
    const int mode = array_mode(g), count = vertex_count(g, mode, integer(g, 1, ARRAY_VERTICES - first - 2));
    EMIT(g, DrawArrays, mode, first + count > ARRAY_VERTICES ? ARRAY_VERTICES - count : first, count);
}

static void emit_draw_elements(struct generator *g)
{
    const int mode = array_mode(g), count = vertex_count(g, mode, integer(g, 1, 24));
    EMIT(g, DrawElements, mode, count, ONE_OF(g, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT));
    for (int i = 0; i < count; i++) {
        const double index = below(g, ARRAY_VERTICES);
        script_extend(g->script, 1, &index);
    }
}

void feature_draw_arrays(struct generator *g)
{
    if (g->compiling)
        return;
    emit_arrays(g);
    for (int n = integer(g, 1, 3); n > 0; n--)
        emit_draw_arrays(g);
    if (chance(g, 70))
        disable_arrays(g, 60);
}

void feature_draw_elements(struct generator *g)
{
    if (g->compiling)
        return;
    emit_arrays(g);
    for (int n = integer(g, 1, 3); n > 0; n--)
        emit_draw_elements(g);
    if (chance(g, 70))
        disable_arrays(g, 60);
}

void feature_interleaved_arrays(struct generator *g)
{
    /* texture coordinates, colors, normals, vertices of each format; negative: bytes */
    static const signed char counts[14][4] = {
            {0, 0, 0, 2}, {0, 0, 0, 3}, {0, -4, 0, 2}, {0, -4, 0, 3}, {0, 3, 0, 3}, {0, 0, 3, 3}, {0, 4, 3, 3},
            {2, 0, 0, 3}, {4, 0, 0, 4}, {2, -4, 0, 3}, {2, 3, 0, 3}, {2, 0, 3, 3}, {2, 4, 3, 3}, {4, 4, 3, 4}};
    if (g->compiling)
        return;
    int format;
    do
        format = below(g, 14);
    while (counts[format][1] && abs(counts[format][1]) != g->color_size);
    const int colors = counts[format][1];
    EMIT(g, InterleavedArrays, GL_V2F + format, chance(g, 70) ? 0 : 64 + 4 * below(g, 5));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        double coords[4] = {real(g, -1.0, 1.0), real(g, -1.0, 1.0), 0.0, 1.0}, color[4], normal[3], position[4];
        random_color(g, color);
        random_normal(g, normal);
        random_position(g, position);
        for (int k = 0; k < 4 && colors < 0; k++)
            color[k] = floor(fmin(fmax(color[k], 0.0), 1.0) * 255.0);
        script_extend(g->script, counts[format][0], coords);
        script_extend(g->script, colors < 0 ? -colors : colors, color);
        script_extend(g->script, counts[format][2], normal);
        script_extend(g->script, counts[format][3], position);
    }
    g->arrays_set = true;
    for (int n = integer(g, 1, 2); n > 0; n--) {
        if (chance(g, 50))
            emit_draw_arrays(g);
        else
            emit_draw_elements(g);
    }
    disable_arrays(g, 60);
}

/* In lists only here: after a draw from arrays in a list OSMesa's current colors, which GL leaves undefined, are not those that
 * the list has set. So they are set again after it. */
void feature_list_of_arrays(struct generator *g)
{
    if (g->compiling)
        return;
    emit_arrays(g);
    EMIT(g, NewList, LIST_OF_ARRAYS, GL_COMPILE);
    g->compiling = true;
    if (chance(g, 50))
        emit_draw_arrays(g);
    else
        emit_draw_elements(g);
    g->compiling = false;
    EMIT0(g, EndList);
    if (chance(g, 50))
        disable_arrays(g, 100);
    EMIT(g, GetFloatv, GL_CURRENT_COLOR);
    EMIT(g, CallList, LIST_OF_ARRAYS);
    emit_color(g);
    emit_normal(g);
}

void feature_array_element(struct generator *g)
{
    if (g->arrays_set)
        EMIT(g, ArrayElement, below(g, ARRAY_VERTICES));
}

void feature_client_attrib_stack(struct generator *g)
{
    if (g->compiling)
        return;
    const bool had_arrays = g->arrays_set;
    const double mask = ONE_OF(g, GL_CLIENT_VERTEX_ARRAY_BIT, GL_CLIENT_PIXEL_STORE_BIT, GL_CLIENT_ALL_ATTRIB_BITS);
    EMIT(g, PushClientAttrib, mask);
    emit_arrays(g);
    emit_draw_arrays(g);
    EMIT0(g, PopClientAttrib);
    g->arrays_set = had_arrays || mask == GL_CLIENT_PIXEL_STORE_BIT;
    if (had_arrays) {
        EMIT(g, EnableClientState, GL_VERTEX_ARRAY);
        emit_draw_arrays(g);
    }
}
