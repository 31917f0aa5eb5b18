/* Capabilities: glEnable, glDisable, glIsEnabled. Which there are: the CAP rows of state_table.def, and vertex arrays, which were capabilities in
 * GL_EXT_vertex_array. */
#include "api/enable.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/material.h"

void fgl_enable_set(struct context *ctx, const struct state_row *row, bool on)
{
    if (fgl_state_get_flag(row, ctx) == on)
        return;
    fgl_flush_vertices(ctx, row->dirty);
    if (row->offset != offsetof(struct context, s.lighting.color_material)) {
        fgl_state_put_flag(row, ctx, on);
        return;
    }
    fgl_flush_current(ctx);
    ctx->s.lighting.color_material = on;
    fgl_material_track_color(ctx);
}

static void set(struct context *ctx, GLenum cap, bool on)
{
    const struct state_row *row = fgl_state_row(cap);
    RETURN_ERROR_IF(ctx, !row || !row->dirty, GL_INVALID_ENUM);
    fgl_enable_set(ctx, row, on);
}

static bool is_array(GLenum cap)
{
    const struct state_row *row = fgl_state_row(cap);
    return row && row->kind == STATE_ARRAY;
}

void fgl_exec_Enable(struct context *ctx, GLenum cap)
{
    if (is_array(cap))
        fgl_exec_EnableClientState(ctx, cap);
    else
        set(ctx, cap, true);
}
void fgl_exec_Disable(struct context *ctx, GLenum cap)
{
    if (is_array(cap))
        fgl_exec_DisableClientState(ctx, cap);
    else
        set(ctx, cap, false);
}

GLboolean fgl_exec_IsEnabled(struct context *ctx, GLenum cap)
{
    const struct state_row *row = fgl_state_row(cap);
    RETURN_VALUE_ERROR_IF(ctx, !row || (!row->dirty && row->kind != STATE_ARRAY), GL_INVALID_ENUM, GL_FALSE);
    return fgl_state_get_flag(row, ctx) ? GL_TRUE : GL_FALSE;
}
