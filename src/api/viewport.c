/* Viewport, depth range and user clip planes (GL 1.5, 2.11.1 "Controlling the Viewport", 2.12 "Clipping"). */
#include "api/command.h"
#include "api/set.h"
#include "state/matrix_exact.h"

#include <string.h>

enum { VIEWPORT_MIN = -32768, VIEWPORT_MAX = 32767 }; /* OSMesa's VIEWPORT_BOUNDS_RANGE */

void fgl_exec_Viewport(struct context *ctx, GLint x, GLint y, GLsizei width, GLsizei height)
{
    RETURN_ERROR_IF(ctx, width < 0 || height < 0, GL_INVALID_VALUE);
    const int v[4] = {
            fgl_clamp(x, VIEWPORT_MIN, VIEWPORT_MAX),
            fgl_clamp(y, VIEWPORT_MIN, VIEWPORT_MAX),
            fgl_min(width, FGL_MAX_VIEWPORT),
            fgl_min(height, FGL_MAX_VIEWPORT),
    };
    if (memcmp(ctx->s.viewport.viewport, v, sizeof v) == 0)
        return;
    fgl_flush_vertices(ctx, DIRTY_VIEWPORT);
    memcpy(ctx->s.viewport.viewport, v, sizeof v);
}

void fgl_exec_DepthRange(struct context *ctx, GLdouble near_val, GLdouble far_val)
{
    const float range[2] = {fgl_clamp01((float)near_val), fgl_clamp01((float)far_val)};

    fgl_set_floats(ctx, DIRTY_VIEWPORT, ctx->s.viewport.depth_range, range, 2);
}

/* The plane in double, after that in float: where only they differ, nothing but FIXEDGL_EXACT sees it. */
static void set_exact_plane(struct context *ctx, double field[4], const GLdouble *equation)
{
    const struct matrix *modelview = fgl_matrix_top(&ctx->modelview);
    const bool exact = fgl_context_arith(ctx) == ARITH_EXACT;
    double m[16], eye[4];

    fgl_exact_load(m, modelview->m);
    fgl_exact_transform_plane(eye, exact ? modelview->exact : m, equation);
    if (exact && memcmp(field, eye, sizeof eye) != 0)
        fgl_flush_vertices(ctx, DIRTY_CLIP_PLANE);
    memcpy(field, eye, sizeof eye);
}

/* Planes live in eye space: plane times the inverse modelview matrix of the time of the call. Floats, summed
 * left to right. */
void fgl_exec_ClipPlane(struct context *ctx, GLenum plane, const GLdouble *equation)
{
    const unsigned i = plane - GL_CLIP_PLANE0;
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_CLIP_PLANES, GL_INVALID_ENUM);

    const float *inv = fgl_matrix_inverse(fgl_matrix_top(&ctx->modelview));
    const float p[4] = {(float)equation[0], (float)equation[1], (float)equation[2], (float)equation[3]};
    float eye[4];
    for (int c = 0; c < 4; c++)
        eye[c] = p[0] * inv[4 * c] + p[1] * inv[4 * c + 1] + p[2] * inv[4 * c + 2] + p[3] * inv[4 * c + 3];
    fgl_set_floats(ctx, DIRTY_CLIP_PLANE, ctx->s.transform.clip_plane[i], eye, 4);
    set_exact_plane(ctx, ctx->s.transform.exact_clip_plane[i], equation);
}

void fgl_exec_GetClipPlane(struct context *ctx, GLenum plane, GLdouble *equation)
{
    const unsigned i = plane - GL_CLIP_PLANE0;
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_CLIP_PLANES, GL_INVALID_ENUM);

    for (int c = 0; c < 4; c++)
        equation[c] = (double)ctx->s.transform.clip_plane[i][c];
}
