/* Viewport, depth range and user clip planes (GL 1.5, 2.11.1 "Controlling the Viewport", 2.12 "Clipping"). */
#include "api/command.h"
#include "api/plane.h"
#include "api/set.h"

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

void fgl_exec_ClipPlane(struct context *ctx, GLenum plane, const GLdouble *equation)
{
    const unsigned i = plane - GL_CLIP_PLANE0;
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_CLIP_PLANES, GL_INVALID_ENUM);

    fgl_set_plane(ctx, DIRTY_CLIP_PLANE, ctx->s.transform.clip_plane[i], ctx->s.transform.exact_clip_plane[i], equation);
}

void fgl_exec_GetClipPlane(struct context *ctx, GLenum plane, GLdouble *equation)
{
    const unsigned i = plane - GL_CLIP_PLANE0;
    RETURN_ERROR_IF(ctx, i >= FGL_MAX_CLIP_PLANES, GL_INVALID_ENUM);

    for (int c = 0; c < 4; c++)
        equation[c] = (double)ctx->s.transform.clip_plane[i][c];
}
