/* Immediate mode: Begin and End (GL 1.5, 2.6.1), and what setters and queries do with the vertices that wait. See immediate.h. */
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/immediate.h"
#include "api/list.h"

#include <string.h>

/* Makes the attributes current values and forgets which they were. */
static void empty_format(struct context *ctx, struct immediate *im)
{
    fgl_format_to_current(ctx, &im->format, im->vertex);
    fgl_immediate_reset_format(im);
    im->pending = im->stored = false;
}

void fgl_begin(struct context *ctx, GLenum mode)
{
    struct immediate *im = ctx->vertices;
    if (im->mode == CONTINUED_PRIMITIVE) { /* a Begin inside the caller's primitive: an error when executed, which does not end that */
        struct immediate_prim *continued = &im->prim[im->prim_count - 1];
        continued->count = im->count - continued->first;
    }
    if (im->format.floats && !im->format.size[ATTR_POSITION] && !im->compiling)
        empty_format(ctx, im);
    if (im->prim_count == IMMEDIATE_MAX_PRIMS)
        fgl_immediate_flush(ctx, im);
    im->prim[im->prim_count++] = (struct immediate_prim){mode, im->count, 0, mode != CONTINUED_PRIMITIVE, false};
    im->mode = mode;
    im->of_arrays = false;
    im->pending = true; /* attributes between Begin and End are set without a word (vertex_commands.c) */
    if (!im->compiling)
        ctx->begin_mode = mode;
}

void fgl_end(struct context *ctx)
{
    struct immediate *im = ctx->vertices;
    if (im->prim_count) {
        struct immediate_prim *p = &im->prim[im->prim_count - 1];
        p->end = true;
        if (p->mode == GL_LINE_LOOP && !p->begin) { /* close with the loop's first vertex, kept at the start of the store */
            memcpy(im->next, im->store + (size_t)p->first * (size_t)im->format.floats,
                   (size_t)im->format.floats * sizeof(float));
            im->next += im->format.floats;
            im->count++;
        }
        p->count = im->count - p->first;
    }
    im->mode = OUTSIDE_BEGIN_END;
    if (!im->compiling) {
        ctx->begin_mode = OUTSIDE_BEGIN_END;
        im->stored = im->stored || (im->prim_count && im->prim[im->prim_count - 1].count > 0);
    }
    const bool executed_open = im->compiling && ctx->begin_mode != OUTSIDE_BEGIN_END; /* the first part of this primitive */
    if (im->count >= im->max_count || executed_open)
        fgl_immediate_flush(ctx, im);
}

void GLAPIENTRY glBegin(GLenum mode)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (ctx->vertices->mode <= GL_POLYGON)
        fgl_command_error(ctx, GL_INVALID_OPERATION);
    else if (mode > GL_POLYGON)
        fgl_command_error(ctx, GL_INVALID_ENUM);
    else if (ctx->vertices->compiling || fgl_draw_ready(ctx))
        fgl_begin(ctx, mode);
}

void GLAPIENTRY glEnd(void)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (ctx->vertices->compiling && ctx->vertices->mode == OUTSIDE_BEGIN_END) {
        fgl_begin(ctx, CONTINUED_PRIMITIVE); /* ends a primitive that the caller of the list began */
        fgl_end(ctx);
        return;
    }
    RETURN_ERROR_IF(ctx, ctx->vertices->mode == OUTSIDE_BEGIN_END, GL_INVALID_OPERATION);
    fgl_end(ctx);
}

/* ---- what setters and queries call ---- */

/* OSMesa rule: what a query makes current values stays in the vertex format, too. */
void fgl_flush_current(struct context *ctx)
{
    struct immediate *im = ctx->immediate;
    if (ctx->begin_mode != OUTSIDE_BEGIN_END || !im->pending)
        return;
    fgl_format_to_current(ctx, &im->format, im->vertex);
    im->pending = false;
    im->stored = true;
}

void fgl_flush_all(struct context *ctx)
{
    struct immediate *im = ctx->immediate;
    if (ctx->begin_mode != OUTSIDE_BEGIN_END)
        return;
    if (im->count)
        fgl_immediate_flush(ctx, im);
    empty_format(ctx, im);
}

void fgl_flush_vertices(struct context *ctx, unsigned dirty)
{
    if (ctx->immediate->stored)
        fgl_flush_all(ctx);
    ctx->dirty |= dirty;
}

void fgl_flush_for_arrays(struct context *ctx)
{
    if (ctx->immediate->stored)
        fgl_flush_all(ctx);
    else
        fgl_flush_current(ctx);
}
