/* Features: vertices and indices in buffer objects. Every vertex buffer holds ARRAY_VERTICES records of the same layout, so that an array
 * that stays enabled can always be read. */
#include "generator.h"

enum {
    VERTEX_BUFFERS = 2, FIRST_ELEMENT_BUFFER = 10, ELEMENT_BUFFERS = 2, /* names */
    RECORD = 12, COLOR_AT = 3, NORMAL_AT = 7, COORDS_AT = 10,           /* floats: position, color, normal, coordinates */
    STRIDE = 4 * RECORD, INDICES = 32
};

static double random_usage(struct generator *g)
{
    return ONE_OF(g, GL_STATIC_DRAW, GL_DYNAMIC_DRAW, GL_STREAM_DRAW, GL_STREAM_READ, GL_STATIC_COPY, GL_DYNAMIC_READ);
}

static void extend_records(struct generator *g, int count)
{
    for (int i = 0; i < count; i++) {
        double position[4], color[4], normal[3];
        random_position(g, position);
        random_color(g, color);
        random_normal(g, normal);
        const double coords[2] = {real(g, -1.0, 2.0), real(g, -1.0, 2.0)};
        script_extend(g->script, 3, position);
        script_extend(g->script, 4, color);
        script_extend(g->script, 3, normal);
        script_extend(g->script, 2, coords);
    }
}

/* Some of the records anew. */
static void emit_changes(struct generator *g)
{
    const int first = below(g, ARRAY_VERTICES), count = integer(g, 1, ARRAY_VERTICES - first);
    if (chance(g, 50))
        EMIT(g, BufferSubData, GL_ARRAY_BUFFER, first * STRIDE, GL_FLOAT);
    else
        EMIT(g, WriteMapped, GL_ARRAY_BUFFER, ONE_OF(g, GL_WRITE_ONLY, GL_READ_WRITE), first * STRIDE, GL_FLOAT);
    extend_records(g, count);
}

static void emit_reading(struct generator *g, double target, int size)
{
    const int offset = 4 * below(g, size / 8);
    switch (below(g, 4)) {
    case 0: EMIT(g, GetBufferSubData, target, offset, 4 * integer(g, 1, (size - offset) / 4)); break;
    case 1: EMIT(g, ReadMapped, target, ONE_OF(g, GL_READ_ONLY, GL_READ_WRITE), 4 * integer(g, 1, size / 4)); break;
    default:
        EMIT(g, GetBufferParameteriv, target, ONE_OF(g, GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_MAPPED, GL_BUFFER_ACCESS));
    }
}

static void emit_pointers(struct generator *g)
{
    EMIT(g, VertexPointerOffset, chance(g, 80) ? 3 : 2, GL_FLOAT, STRIDE, 0);
    EMIT(g, EnableClientState, GL_VERTEX_ARRAY);
    g->arrays_set = true;
    if (chance(g, 65)) {
        if (g->color_size == 4 && chance(g, 25)) /* the bytes of a float */
            EMIT(g, ColorPointerOffset, 4, GL_UNSIGNED_BYTE, STRIDE, 4 * (COLOR_AT + below(g, 4)));
        else
            EMIT(g, ColorPointerOffset, g->color_size, GL_FLOAT, STRIDE, 4 * COLOR_AT);
        EMIT(g, EnableClientState, GL_COLOR_ARRAY);
    }
    if (chance(g, 40)) {
        EMIT(g, NormalPointerOffset, GL_FLOAT, STRIDE, 4 * NORMAL_AT);
        EMIT(g, EnableClientState, GL_NORMAL_ARRAY);
    }
    if (chance(g, 30) && g->tex_coord_size == 2) {
        EMIT(g, TexCoordPointerOffset, 2, GL_FLOAT, STRIDE, 4 * COORDS_AT);
        EMIT(g, EnableClientState, GL_TEXTURE_COORD_ARRAY);
    }
}

static void emit_vertex_buffer(struct generator *g)
{
    EMIT(g, BindBuffer, GL_ARRAY_BUFFER, 1 + below(g, VERTEX_BUFFERS));
    if (chance(g, 20)) {
        EMIT(g, BufferSize, GL_ARRAY_BUFFER, ARRAY_VERTICES * STRIDE, 0, random_usage(g));
        EMIT(g, BufferSubData, GL_ARRAY_BUFFER, 0, GL_FLOAT);
    } else {
        EMIT(g, BufferData, GL_ARRAY_BUFFER, random_usage(g), GL_FLOAT);
    }
    extend_records(g, ARRAY_VERTICES);
    emit_pointers(g);
    if (chance(g, 30))
        emit_changes(g);
    if (chance(g, 30))
        emit_reading(g, GL_ARRAY_BUFFER, ARRAY_VERTICES * STRIDE);
    EMIT(g, BindBuffer, GL_ARRAY_BUFFER, 0);
}

static void emit_from_elements(struct generator *g)
{
    static const double types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};
    const int log_size = below(g, 3), first = below(g, 8), mode = array_mode(g), count = vertex_count(g, mode, integer(g, 1, INDICES - first - 4));
    const double type = types[log_size];
    EMIT(g, BindBuffer, GL_ELEMENT_ARRAY_BUFFER, FIRST_ELEMENT_BUFFER + below(g, ELEMENT_BUFFERS));
    EMIT(g, BufferData, GL_ELEMENT_ARRAY_BUFFER, random_usage(g), type);
    for (int i = 0; i < INDICES; i++) {
        const double index = below(g, ARRAY_VERTICES);
        script_extend(g->script, 1, &index);
    }
    if (chance(g, 20))
        emit_reading(g, GL_ELEMENT_ARRAY_BUFFER, INDICES << log_size);
    if (chance(g, 60))
        EMIT(g, DrawElementsOffset, mode, count, type, first << log_size);
    else if (chance(g, 50))
        EMIT(g, DrawRangeElementsOffset, mode, 0, ARRAY_VERTICES - 1, count, type, first << log_size);
    else
        EMIT(g, MultiDrawElementsOffset, mode, type, first << log_size, count, 0, vertex_count(g, mode, 6));
    EMIT(g, BindBuffer, GL_ELEMENT_ARRAY_BUFFER, 0);
}

void feature_buffer_object(struct generator *g)
{
    if (g->compiling)
        return;
    emit_vertex_buffer(g);
    for (int n = integer(g, 1, 2); n > 0; n--) {
        if (chance(g, 60))
            emit_from_elements(g);
        else
            emit_draw_arrays(g);
    }
    if (chance(g, 15))
        EMIT(g, DeleteBuffers, 1, FIRST_ELEMENT_BUFFER + below(g, ELEMENT_BUFFERS));
    if (chance(g, 10))
        EMIT(g, IsBuffer, 1 + below(g, 12));
    if (chance(g, 70))
        disable_arrays(g, 60);
}
