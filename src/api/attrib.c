/* Attribute stacks (GL 1.5, 6.1.14 "Saving and Restoring State"): a group is a struct of the state, saved and
 * restored whole. GL_ENABLE_BIT alone cuts across the groups: it is every capability of state_table.def. */
#include "api/attrib.h"

#include "api/array_object.h"
#include "api/buffer.h"
#include "api/command.h"
#include "api/enable.h"
#include "api/framebuffer_object.h"
#include "api/material.h"
#include "api/set.h"
#include "api/texture_attrib.h"

#include <stdlib.h>
#include <string.h>

struct group {
    GLbitfield bit;
    unsigned dirty;
    size_t offset, size; /* in struct server_state */
};

#define GROUP(bit, dirty, field)                                                                             \
    {                                                                                                        \
        (bit), (dirty), offsetof(struct server_state, field), sizeof((struct server_state *)0)->field        \
    }

static const struct group groups[] = {
        GROUP(GL_CURRENT_BIT, DIRTY_CURRENT | DIRTY_MATERIAL, current),
        GROUP(GL_POINT_BIT, DIRTY_RASTER | DIRTY_POINT | DIRTY_TEXTURE, point),
        GROUP(GL_LINE_BIT, DIRTY_RASTER, line),
        GROUP(GL_POLYGON_BIT, DIRTY_RASTER, polygon),
        GROUP(GL_POLYGON_STIPPLE_BIT, DIRTY_RASTER, polygon_stipple),
        GROUP(GL_PIXEL_MODE_BIT, 0, pixel_mode),
        GROUP(GL_LIGHTING_BIT, DIRTY_LIGHT | DIRTY_MATERIAL, lighting),
        GROUP(GL_FOG_BIT, DIRTY_FOG | DIRTY_FRAGMENT, fog),
        GROUP(GL_DEPTH_BUFFER_BIT, DIRTY_FRAGMENT, depth),
        GROUP(GL_ACCUM_BUFFER_BIT, 0, accum),
        GROUP(GL_STENCIL_BUFFER_BIT, DIRTY_FRAGMENT, stencil),
        GROUP(GL_VIEWPORT_BIT, DIRTY_VIEWPORT, viewport),
        GROUP(GL_TRANSFORM_BIT, DIRTY_NORMALIZE | DIRTY_CLIP_PLANE, transform),
        GROUP(GL_COLOR_BUFFER_BIT, DIRTY_FRAGMENT | DIRTY_FRAMEBUFFER, color_buffer),
        GROUP(GL_HINT_BIT, DIRTY_RASTER, hint),
        GROUP(GL_EVAL_BIT, DIRTY_CURRENT, eval),
        GROUP(GL_LIST_BIT, 0, list),
        GROUP(GL_MULTISAMPLE_BIT, DIRTY_RASTER, multisample),
        GROUP(GL_SCISSOR_BIT, DIRTY_SCISSOR, scissor),
};

/* The first push makes the stack. */
static bool reserve(struct context *ctx, void **stack, size_t entries, size_t entry_size)
{
    if (!*stack)
        *stack = calloc(entries, entry_size);
    RETURN_VALUE_ERROR_IF(ctx, !*stack, GL_OUT_OF_MEMORY, false);
    return true;
}

void fgl_exec_PushAttrib(struct context *ctx, GLbitfield mask)
{
    RETURN_ERROR_IF(ctx, ctx->attrib_depth >= FGL_MAX_ATTRIB_DEPTH, GL_STACK_OVERFLOW);
    void *stack = ctx->attrib_stack;
    if (!reserve(ctx, &stack, FGL_MAX_ATTRIB_DEPTH, sizeof *ctx->attrib_stack))
        return;
    ctx->attrib_stack = stack;

    if (mask & (GL_CURRENT_BIT | GL_LIGHTING_BIT))
        fgl_flush_current(ctx);
    struct attrib_entry *e = &ctx->attrib_stack[ctx->attrib_depth++];
    e->mask = mask;
    e->state = ctx->s;
    if (mask & GL_TEXTURE_BIT)
        fgl_textures_save(ctx, e);
}

static void restore_group(struct context *ctx, const struct group *g, const struct server_state *saved)
{
    char *now = (char *)&ctx->s + g->offset;
    const char *then = (const char *)saved + g->offset;

    if (memcmp(now, then, g->size) == 0)
        return;
    memcpy(now, then, g->size);
    ctx->dirty |= g->dirty;
}

static void restore_enables(struct context *ctx, const struct server_state *saved)
{
    const int active = ctx->s.texture.active_texture;
    const struct state_row *row;

    for (int i = 0; (row = fgl_state_row_at(i)) != NULL; i++) {
        for (int unit = 0; row->dirty && unit < (row->unit == UNIT_SERVER ? FGL_MAX_TEXTURE_UNITS : 1); unit++) {
            ctx->s.texture.active_texture = unit;
            fgl_enable_set(ctx, row, fgl_state_saved_flag(row, saved, ctx));
        }
    }
    ctx->s.texture.active_texture = active;
}

/* OSMesa rule: stored vertices are drawn, whatever is restored.
 * DEPARTURE: colours and materials set since the push are restored also where OSMesa has not noticed that they were set
 * (nothing was drawn or asked since), and tracked materials follow the colour that comes back. tests/api/departures.c */
void fgl_exec_PopAttrib(struct context *ctx)
{
    RETURN_ERROR_IF(ctx, ctx->attrib_depth == 0, GL_STACK_UNDERFLOW);
    const struct attrib_entry *e = &ctx->attrib_stack[--ctx->attrib_depth];

    const bool attributes = e->mask & (GL_CURRENT_BIT | GL_LIGHTING_BIT);
    fgl_flush_vertices(ctx, 0);
    if (attributes)
        fgl_flush_all(ctx);
    const GLenum draw_buffer = ctx->s.color_buffer.draw_buffer, read_buffer = ctx->s.pixel_mode.read_buffer;
    for (size_t i = 0; i < FGL_COUNTOF(groups); i++) {
        if (e->mask & groups[i].bit)
            restore_group(ctx, &groups[i], &e->state);
    }
    fgl_framebuffer_keep_buffers(ctx, draw_buffer, read_buffer);
    if (e->mask & GL_TEXTURE_BIT)
        fgl_textures_restore(ctx, e);
    if (e->mask & GL_ENABLE_BIT)
        restore_enables(ctx, &e->state);
    if (attributes)
        fgl_material_track_color(ctx);
}

void fgl_exec_PushClientAttrib(struct context *ctx, GLbitfield mask)
{
    RETURN_ERROR_IF(ctx, ctx->client_attrib_depth >= FGL_MAX_CLIENT_ATTRIB_DEPTH, GL_STACK_OVERFLOW);
    void *stack = ctx->client_attrib_stack;
    if (!reserve(ctx, &stack, FGL_MAX_CLIENT_ATTRIB_DEPTH, sizeof *ctx->client_attrib_stack))
        return;
    ctx->client_attrib_stack = stack;

    struct client_attrib_entry *e = &ctx->client_attrib_stack[ctx->client_attrib_depth++];
    e->mask = mask;
    e->state = ctx->client;
    if (mask & GL_CLIENT_VERTEX_ARRAY_BIT)
        fgl_buffer_retain_arrays(&e->state.arrays);
    if (mask & GL_CLIENT_PIXEL_STORE_BIT)
        fgl_buffer_retain_pixels(&e->state);
}

void fgl_exec_PopClientAttrib(struct context *ctx)
{
    RETURN_ERROR_IF(ctx, ctx->client_attrib_depth == 0, GL_STACK_UNDERFLOW);
    struct client_attrib_entry *e = &ctx->client_attrib_stack[--ctx->client_attrib_depth];

    if (e->mask & GL_CLIENT_PIXEL_STORE_BIT) {
        fgl_buffer_release_pixels(&ctx->client);
        ctx->client.pack = e->state.pack;
        ctx->client.unpack = e->state.unpack;
    }
    if (e->mask & GL_CLIENT_VERTEX_ARRAY_BIT)
        fgl_array_object_restore(ctx, &e->state.arrays);
}

void fgl_client_attrib_destroy(struct context *ctx)
{
    for (int i = 0; i < ctx->client_attrib_depth; i++) {
        struct client_attrib_entry *e = &ctx->client_attrib_stack[i];
        if (e->mask & GL_CLIENT_VERTEX_ARRAY_BIT)
            fgl_buffer_release_arrays(&e->state.arrays);
        if (e->mask & GL_CLIENT_PIXEL_STORE_BIT)
            fgl_buffer_release_pixels(&e->state);
    }
    fgl_buffer_release_arrays(&ctx->client.arrays);
    fgl_buffer_release_pixels(&ctx->client);
    free(ctx->client_attrib_stack);
}
