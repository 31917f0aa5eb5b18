/* Simple queries (GL 1.5, 6.1.1 "Simple Queries", 6.1.2 "Data Conversions"): any row of state_table.def as
 * any type. */
#include "api/command.h"
#include "api/convert.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/state_table.h"

/* Every state value is exact in a double. */
static double read_field(const struct state_row *row, const char *field, int i)
{
    switch (row->kind) {
    case STATE_BOOL:
    case STATE_ARRAY: return ((const bool *)(const void *)field)[i];
    case STATE_MASK: return ((const unsigned *)(const void *)field)[i];
    case STATE_USHORT: return ((const uint16_t *)(const void *)field)[i];
    case STATE_FLOAT:
    case STATE_UNIT: return (double)((const float *)(const void *)field)[i];
    case STATE_CLAMPED: return (double)fgl_clamp01(((const float *)(const void *)field)[i]);
    case STATE_UNIT_DOUBLE: return ((const double *)(const void *)field)[i];
    default: return ((const int *)(const void *)field)[i];
    }
}

static bool is_current_value(const struct state_row *row)
{
    const size_t first = offsetof(struct context, s.current);
    return row->offset >= first && row->offset < first + sizeof(struct current_state);
}

/* The row of `name` with its values; NULL after recording an error. */
static const struct state_row *query(struct context *ctx, GLenum name, double v[STATE_MAX_VALUES])
{
    const struct state_row *row = fgl_state_row(name);
    RETURN_VALUE_ERROR_IF(ctx, !row, GL_INVALID_ENUM, NULL);

    if (row->read) {
        fgl_framebuffer_update(ctx);
        row->read(ctx, v);
        return row;
    }
    if (row->dirty) { /* a capability */
        v[0] = fgl_state_get_flag(row, ctx);
        return row;
    }
    if (is_current_value(row))
        fgl_flush_current(ctx);
    const bool constant = row->kind == STATE_LIMIT || row->kind == STATE_FLOAT_LIMIT;
    const char *field = fgl_state_field(row, ctx);
    for (int i = 0; i < row->count; i++)
        v[i] = constant ? (double)row->limit[i] : read_field(row, field, i);
    return row;
}

static GLint to_int(enum state_kind kind, double v)
{
    switch (kind) {
    case STATE_UNIT:
    case STATE_CLAMPED:
    case STATE_UNIT_DOUBLE: return fgl_int_from_normalized(v);
    default: return fgl_int_round(v);
    }
}

void fgl_exec_GetBooleanv(struct context *ctx, GLenum pname, GLboolean *data)
{
    double v[STATE_MAX_VALUES];
    const struct state_row *row = query(ctx, pname, v);

    for (int i = 0; row && i < row->count; i++)
        data[i] = v[i] != 0 ? GL_TRUE : GL_FALSE;
}

void fgl_exec_GetIntegerv(struct context *ctx, GLenum pname, GLint *data)
{
    double v[STATE_MAX_VALUES];
    const struct state_row *row = query(ctx, pname, v);

    for (int i = 0; row && i < row->count; i++)
        data[i] = to_int(row->kind, v[i]);
}

void fgl_exec_GetFloatv(struct context *ctx, GLenum pname, GLfloat *data)
{
    double v[STATE_MAX_VALUES];
    const struct state_row *row = query(ctx, pname, v);

    for (int i = 0; row && i < row->count; i++)
        data[i] = (float)v[i];
}

void fgl_exec_GetDoublev(struct context *ctx, GLenum pname, GLdouble *data)
{
    double v[STATE_MAX_VALUES];
    const struct state_row *row = query(ctx, pname, v);

    for (int i = 0; row && i < row->count; i++)
        data[i] = v[i];
}
