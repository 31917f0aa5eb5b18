/* Features: several primitives at once, ranges of elements, arrays of the later attributes. */
#include "generator.h"

enum { MOST_DRAWS = 4 };

static void extend_indices(struct generator *g, int count, int first, int last)
{
    for (int i = 0; i < count; i++) {
        const double index = integer(g, first, last);
        script_extend(g->script, 1, &index);
    }
}

static void emit_multi_draw_arrays(struct generator *g)
{
    double draws[2 * MOST_DRAWS];
    const int n = integer(g, 1, MOST_DRAWS), mode = array_mode(g);
    for (int i = 0; i < n; i++) {
        const int first = below(g, 8);
        draws[2 * i] = first;
        draws[2 * i + 1] = vertex_count(g, mode, integer(g, 1, ARRAY_VERTICES - first - 2));
    }
    EMIT(g, MultiDrawArrays, mode);
    script_extend(g->script, 2 * n, draws);
}

static double random_index_type(struct generator *g)
{
    return ONE_OF(g, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT);
}

static void emit_multi_draw_elements(struct generator *g)
{
    const int mode = array_mode(g);
    EMIT(g, MultiDrawElements, mode, random_index_type(g));
    for (int n = integer(g, 1, MOST_DRAWS); n > 0; n--) {
        const double count = vertex_count(g, mode, integer(g, 1, 14));
        script_extend(g->script, 1, &count);
        extend_indices(g, (int)count, 0, ARRAY_VERTICES - 1);
    }
}

static void emit_draw_range(struct generator *g)
{
    const int mode = array_mode(g), count = vertex_count(g, mode, integer(g, 1, 20)), first = below(g, 8),
              last = integer(g, first, ARRAY_VERTICES - 1);
    EMIT(g, DrawRangeElements, mode, first, last, count, random_index_type(g));
    extend_indices(g, count, first, last);
}

void feature_multi_draw(struct generator *g)
{
    if (g->compiling)
        return;
    emit_arrays(g);
    switch (below(g, 3)) {
    case 0: emit_multi_draw_arrays(g); break;
    case 1: emit_multi_draw_elements(g); break;
    default: emit_draw_range(g);
    }
    if (chance(g, 70))
        disable_arrays(g, 60);
}

/* ---- secondary colors, fog coordinates, coordinates of several units ---- */

static void emit_secondary_colors(struct generator *g)
{
    EMIT(g, SecondaryColorPointer, 3, GL_FLOAT, ONE_OF(g, 0, 16));
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        double c[4];
        random_color(g, c);
        script_extend(g->script, 3, c);
    }
    EMIT(g, EnableClientState, GL_SECONDARY_COLOR_ARRAY);
}

static void emit_fog_coordinates(struct generator *g)
{
    EMIT(g, FogCoordPointer, ONE_OF(g, GL_FLOAT, GL_DOUBLE), 0);
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        const double coord = real(g, 0.0, g->space == EYE_SPACE ? 10.0 : 1.5);
        script_extend(g->script, 1, &coord);
    }
    EMIT(g, EnableClientState, GL_FOG_COORD_ARRAY);
}

static void emit_coordinates(struct generator *g, int unit)
{
    const int size = unit == 0 ? g->tex_coord_size : 4;
    EMIT(g, ClientActiveTexture, GL_TEXTURE0 + unit);
    EMIT(g, TexCoordPointer, size, GL_FLOAT, 0);
    for (int i = 0; i < ARRAY_VERTICES; i++) {
        const double coords[4] = {real(g, -1.0, 2.0), real(g, -1.0, 2.0), real(g, -1.0, 2.0), real(g, 0.5, 2.0)};
        script_extend(g->script, size, coords);
    }
    EMIT(g, EnableClientState, GL_TEXTURE_COORD_ARRAY);
    EMIT(g, ClientActiveTexture, GL_TEXTURE0);
}

void feature_attribute_arrays(struct generator *g)
{
    if (g->compiling)
        return;
    emit_arrays(g);
    if (chance(g, 40))
        emit_secondary_colors(g);
    if (chance(g, 40))
        emit_fog_coordinates(g);
    for (int unit = 0; unit < 2; unit++) {
        if (chance(g, 50))
            emit_coordinates(g, unit);
    }
    emit_draw_arrays(g);
    EMIT(g, DisableClientState, GL_SECONDARY_COLOR_ARRAY);
    EMIT(g, DisableClientState, GL_FOG_COORD_ARRAY);
    EMIT(g, ClientActiveTexture, GL_TEXTURE1);
    EMIT(g, DisableClientState, GL_TEXTURE_COORD_ARRAY);
    EMIT(g, ClientActiveTexture, GL_TEXTURE0);
    disable_arrays(g, 100);
}
