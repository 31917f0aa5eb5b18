/* Features: matrices, viewport, clip planes, matrix stacks. */
#include "generator.h"

#include <math.h>

/* A whole new view, so that object coordinates are those of a space. */
void feature_view(struct generator *g)
{
    static const double grids[] = {0.0, 0.0, 1.0, 0.5, 0.0625, 1.0 / 256, 1.0 / 512};
    EMIT(g, MatrixMode, GL_PROJECTION);
    EMIT0(g, LoadIdentity);
    g->space = (enum space)below(g, 3);
    g->grid = 0.0;
    if (g->space == PIXEL_SPACE) {
        g->grid = one_of(g, 7, grids);
        EMIT(g, Ortho, 0, g->script->width, 0, g->script->height, -1, 1);
    } else if (g->space == EYE_SPACE) {
        const double right = real(g, 0.4, 1.0), top = real(g, 0.4, 1.0), left = chance(g, 70) ? -right : real(g, -1.0, -0.3);
        EMIT(g, Frustum, left, right, -top, top, real(g, 0.5, 1.5), real(g, 6.0, 30.0));
    } else if (chance(g, 30)) {
        EMIT(g, Ortho, -1, 1, -1, 1, real(g, -3.0, -1.0), real(g, 1.0, 4.0));
    }
    EMIT(g, MatrixMode, GL_MODELVIEW);
    EMIT0(g, LoadIdentity);
}

static void emit_axis_rotation(struct generator *g)
{
    const double angle = chance(g, 30) ? 90.0 * integer(g, -3, 4) : real(g, -180.0, 180.0);
    double axis[3] = {0.0, 0.0, 0.0};
    if (g->space == PIXEL_SPACE)
        axis[2] = 1.0;
    else if (chance(g, 50))
        axis[below(g, 3)] = chance(g, 80) ? 1.0 : -2.0;
    else
        random_normal(g, axis);
    if (chance(g, 15))
        EMIT(g, Rotated, angle, axis[0], axis[1], axis[2]);
    else
        EMIT(g, Rotatef, angle, axis[0], axis[1], axis[2]);
}

static void emit_translation(struct generator *g)
{
    const double size = g->space == PIXEL_SPACE ? 10.0 : g->space == EYE_SPACE ? 1.5 : 0.4;
    double v[3] = {real(g, -size, size), real(g, -size, size), g->space == PIXEL_SPACE ? real(g, -0.2, 0.2) : real(g, -size, size)};
    if (chance(g, 15))
        EMIT(g, Translated, v[0], v[1], v[2]);
    else
        EMIT(g, Translatef, v[0], v[1], v[2]);
}

static void emit_scale(struct generator *g)
{
    double v[3] = {real(g, 0.4, 1.6), real(g, 0.4, 1.6), real(g, 0.4, 1.6)};
    if (chance(g, 40))
        v[1] = v[2] = v[0];
    if (chance(g, 20))
        v[below(g, 3)] *= -1.0;
    if (chance(g, 15))
        EMIT(g, Scaled, v[0], v[1], v[2]);
    else
        EMIT(g, Scalef, v[0], v[1], v[2]);
}

/* Near the identity, so that it can be inverted; seldom with a perspective row. */
static void emit_matrix(struct generator *g)
{
    double m[16];
    const double size = g->space == PIXEL_SPACE ? 0.1 : 0.4;
    for (int i = 0; i < 16; i++)
        m[i] = i % 4 == 3 ? 0.0 : real(g, -size, size);
    for (int i = 0; i < 16; i += 5)
        m[i] += 1.0;
    if (chance(g, 15) && !g->enabled[FEATURE_lighting])
        m[4 * below(g, 3) + 3] = real(g, -0.05, 0.05);
    for (int i = 0; i < 16; i++)
        m[i] = (double)(float)m[i];
    const enum command command = chance(g, 50) ? CMD_MultMatrixf : chance(g, 50) ? CMD_MultMatrixd
                                 : chance(g, 50) ? CMD_LoadMatrixf : CMD_LoadMatrixd;
    script_add(g->script, command, 16, m);
}

void feature_matrix(struct generator *g)
{
    const int other = below(g, 100);
    if (other < 5 && use(g, FEATURE_texture_matrix))
        EMIT(g, MatrixMode, GL_TEXTURE);
    else if (other >= 5 && other < 12)
        EMIT(g, MatrixMode, GL_PROJECTION);
    if (chance(g, 30))
        EMIT0(g, LoadIdentity);
    for (int n = other < 12 ? 1 : integer(g, 1, 3); n > 0; n--) {
        switch (below(g, 8)) {
        case 0: case 1: case 2: emit_axis_rotation(g); break;
        case 3: case 4: emit_translation(g); break;
        case 5: case 6: emit_scale(g); break;
        default: emit_matrix(g);
        }
    }
    if (other < 12)
        EMIT(g, MatrixMode, GL_MODELVIEW);
}

void feature_matrix_stack(struct generator *g)
{
    EMIT0(g, PushMatrix);
    feature_matrix(g);
    if (g->depth < MAX_DEPTH) {
        g->depth++;
        random_draw(g);
        g->depth--;
    }
    EMIT0(g, PopMatrix);
    random_draw(g);
}

void feature_viewport(struct generator *g)
{
    const int width = g->script->width, height = g->script->height;
    if (chance(g, 30))
        EMIT(g, Viewport, 0, 0, width, height);
    else
        EMIT(g, Viewport, integer(g, -10, width / 2), integer(g, -10, height / 2), integer(g, 1, width + 10),
             integer(g, 1, height + 10));
}

void feature_depth_range(struct generator *g)
{
    if (chance(g, 30))
        EMIT(g, DepthRange, 0, 1);
    else
        EMIT(g, DepthRange, real(g, -0.1, 1.0), real(g, 0.0, 1.1));
}

void feature_clip_plane(struct generator *g)
{
    const unsigned plane = GL_CLIP_PLANE0 + (unsigned)below(g, 6);
    double normal[3];
    random_normal(g, normal);
    double size = g->space == PIXEL_SPACE ? 20.0 : g->space == EYE_SPACE ? 1.0 : 0.5;
    double offset = real(g, -size, size);
    if (g->space == PIXEL_SPACE)
        offset -= normal[0] * g->script->width / 2 + normal[1] * g->script->height / 2;
    else if (g->space == EYE_SPACE)
        offset += normal[2] * 4.0;
    EMIT(g, ClipPlane, plane, normal[0], normal[1], normal[2], (double)(float)offset);
    toggle(g, plane, 75);
}

void feature_normalize(struct generator *g)
{
    toggle(g, chance(g, 70) ? GL_NORMALIZE : GL_RESCALE_NORMAL, 75);
}
