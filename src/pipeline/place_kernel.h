/* Where a raster position comes to lie (GL 1.5, 2.13 "Current Raster Position"): as a vertex, alone. OSMesa rule: it is
 * transformed by modelview and projection one after the other, each sum left to right. Kernels. */
#ifndef FGL_PIPELINE_PLACE_KERNEL_H
#define FGL_PIPELINE_PLACE_KERNEL_H

#include "pipeline/pipeline.h"
#include "vertex/work.h"

#if R_EXACT
#define MATRIX_NUMBERS(matrix) ((matrix)->exact)
#define CLIP_PLANE(transform, i) ((transform)->exact_clip_plane[i])
#else
#define MATRIX_NUMBERS(matrix) ((matrix)->m)
#define CLIP_PLANE(transform, i) ((transform)->clip_plane[i])
#endif

static void place_transform(real out[4], const real m[16], const real v[4])
{
    for (int r = 0; r < 4; r++)
        out[r] = m[r] * v[0] + m[4 + r] * v[1] + m[8 + r] * v[2] + m[12 + r] * v[3];
}

static bool place_inside(const struct transform_state *t, const real eye[4], const real clip[4])
{
    for (int c = 0; c < 3; c++)
        if (!(clip[c] <= clip[3] && -clip[c] <= clip[3]))
            return false;
    for (int i = 0; i < FGL_MAX_CLIP_PLANES; i++) {
        const real *p = CLIP_PLANE(t, i);
        if ((t->clip_plane_enabled >> i & 1) &&
            p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2] + p[3] * eye[3] < 0)
            return false;
    }
    return true;
}

static void place_window(const struct viewport_state *s, const real clip[4], float window[4])
{
    const real inverse_w = clip[3] == 0 ? 1 : 1 / clip[3];
    const real half_width = (real)s->viewport[2] * (real)0.5, half_height = (real)s->viewport[3] * (real)0.5;
    const double near = (double)s->depth_range[0], far = (double)s->depth_range[1];
    const real scale[3] = {half_width, half_height, (real)(0.5 * (far - near))};
    const real trans[3] = {half_width + (real)s->viewport[0], half_height + (real)s->viewport[1],
                           (real)(0.5 * (near + far))};
    for (int c = 0; c < 3; c++)
        window[c] = (float)(clip[c] * inverse_w * scale[c] + trans[c]);
    window[3] = (float)clip[3];
}

static bool place(struct context *ctx, const float object[4])
{
    struct current_state *current = &ctx->s.current;
    const real position[4] = {(real)object[0], (real)object[1], (real)object[2], (real)object[3]};
    real eye[4], clip[4], texture[4];

    place_transform(eye, MATRIX_NUMBERS(fgl_matrix_top(&ctx->modelview)), position);
    place_transform(clip, MATRIX_NUMBERS(fgl_matrix_top(&ctx->projection)), eye);
    if (!place_inside(&ctx->s.transform, eye, clip))
        return false;
    place_window(&ctx->s.viewport, clip, current->raster_position);
    current->raster_distance = (float)r_sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        const float *s = current->attr[ATTR_TEX0 + unit];
        const real given[4] = {(real)s[0], (real)s[1], (real)s[2], (real)s[3]};
        place_transform(texture, MATRIX_NUMBERS(fgl_matrix_top(&ctx->texture_matrix[unit])), given);
        for (int c = 0; c < 4; c++)
            current->raster_texture_coords[unit][c] = (float)texture[c];
    }
    return true;
}

#endif
