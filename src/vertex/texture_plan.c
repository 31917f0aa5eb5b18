/* Derives which texture coordinates the vertex stage hands over, and how they come about (GL 1.5, 2.11.4). */
#include "texture/texture.h"
#include "vertex/vertex.h"

#include <string.h>

static bool needs_eye_space(GLenum mode)
{
    return mode != GL_OBJECT_LINEAR;
}

bool fgl_texgen_in_eye_space(const struct server_state *s)
{
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        const struct texture_unit *u = &s->texture.unit[unit];
        for (int c = 0; c < 4 && u->enabled; c++)
            if (u->gen_enabled[c] && needs_eye_space(u->gen[c].mode) && fgl_texture_current(u))
                return true;
    }
    return false;
}

/* How unit u's coordinates come about; false if they are given, unchanged. */
static bool derive(struct vertex_texture *to, struct exact_texture *exact, const struct texture_unit *u, struct matrix *matrix)
{
    bool generated = false;
    for (int c = 0; c < 4; c++) {
        const struct texgen *gen = &u->gen[c];
        to->gen[c] = u->gen_enabled[c] ? gen->mode : GL_NONE;
        generated |= u->gen_enabled[c];
        const bool object = gen->mode == GL_OBJECT_LINEAR;
        for (int i = 0; i < 4; i++) {
            to->numbers.plane[c][i] = object ? gen->object_plane[i] : gen->eye_plane[i];
            exact->plane[c][i] = object ? (double)gen->object_plane[i] : gen->exact_eye_plane[i];
        }
    }
    /* OSMesa rule: a matrix that once was more than the identity is applied. */
    to->transformed = fgl_matrix_class(matrix) != 0;
    memcpy(to->numbers.matrix, matrix->m, sizeof to->numbers.matrix);
    memcpy(exact->matrix, matrix->exact, sizeof exact->matrix);
    return generated || to->transformed;
}

/* Whether somebody asks for the unit's coordinates: a texture, or feedback for the first unit's. */
static bool is_wanted(const struct context *ctx, int unit)
{
    const struct texture_unit *u = &ctx->s.texture.unit[unit];
    return (u->enabled && fgl_texture_current(u)) || (unit == 0 && ctx->render_mode == GL_FEEDBACK);
}

void fgl_texture_plan_validate(struct vertex_plan *plan, struct context *ctx, uint32_t varying)
{
    plan->textures = 0;
    plan->texgen_eye = plan->texgen_normal = false;
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        const struct texture_unit *u = &ctx->s.texture.unit[unit];
        struct vertex_texture *to = &plan->texture[plan->textures];
        struct matrix_stack *stack = &ctx->texture_matrix[unit];
        if (!is_wanted(ctx, unit))
            continue;
        to->unit = unit;
        to->computed = derive(to, &plan->exact.texture[plan->textures], u, &stack->entry[stack->top]) || ctx->s.point.point_sprite;
        if (!to->computed && !(varying >> (ATTR_TEX0 + unit) & 1))
            continue; /* the same for the whole draw */
        plan->textures++;
        for (int c = 0; c < 4; c++) {
            const GLenum mode = to->gen[c];
            plan->texgen_eye |= mode == GL_SPHERE_MAP || mode == GL_REFLECTION_MAP;
            plan->texgen_normal |= mode == GL_SPHERE_MAP || mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP;
        }
    }
}
