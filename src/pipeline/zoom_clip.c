#include "pipeline/zoom_clip.h"

#include "base/arith.h"
#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

enum { LANES = LANE_COLOR + LANE_GROUP, LANE_S = LANE_COLOR, LANE_T };

/* What the rasterizer sees as the fragment stage. */
struct zoom_sampler {
    struct fragment_plan fragment; /* first: the plan that fill is given */
    const struct zoom *zoom;
    zoomed_run_fn *take;
    void *taker;
    int *column, *row; /* by window x */
};

static float plane_value(const struct planes *p, int lane, int x, int y)
{
    return fgl_fma(p->dady[lane], (float)y, fgl_fma(p->dadx[lane], (float)x, p->a00[lane]));
}

static void sample(const struct fragment_plan *plan, const struct planes *planes, const struct runs *runs)
{
    const struct zoom_sampler *s = (const struct zoom_sampler *)plan;
    for (int i = 0; i < runs->n; i++) {
        const int y = runs->y + i;
        for (int x = runs->x0[i]; x < runs->x1[i]; x++) {
            const float w = 1.0f / plane_value(planes, LANE_OOW, x, y);
            s->column[x] = fgl_zoom_texel_column(s->zoom, plane_value(planes, LANE_S, x, y) * w);
            s->row[x] = fgl_zoom_texel_row(s->zoom, plane_value(planes, LANE_T, x, y) * w);
        }
        if (runs->x0[i] < runs->x1[i])
            s->take(s->taker, y, runs->x0[i], runs->x1[i], s->column, s->row);
    }
}

/* The viewport is the window; nothing else of the pipeline is asked for. In every mode compatible's arithmetic chooses pixels. */
static void setup_clipper(struct pipeline *p, const struct framebuffer *fb, const struct rect *bounds, const struct zoom_sampler *sampler)
{
    struct vertex_plan *v = &p->plan.vertex;
    struct raster_plan *raster = &p->plan.raster;
    const float scale[3] = {(float)fb->width * 0.5f, -((float)fb->height * 0.5f), 0.5f};
    memset(p, 0, sizeof *p);
    for (int k = 0; k < 3; k++) {
        v->viewport_scale[k] = scale[k];
        v->viewport_trans[k] = k == 1 ? -scale[k] : scale[k];
    }
    p->plan.emit.stride = LANES;
    p->plan.clip = fgl_clip_kernels(ARITH_COMPATIBLE);
    p->plan.polygon_fill = true;
    raster->kernels = fgl_raster_kernels(ARITH_COMPATIBLE);
    raster->triangle = raster->filled = raster->kernels->triangle;
    raster->bounds = *bounds;
    raster->stride = raster->lanes = LANES;
    raster->fragment = &sampler->fragment;
}

/* Corner (i, j) of the rectangle, 0: at the raster position. */
static unsigned set_corner(const struct zoom *z, const struct framebuffer *fb, int i, int j, float *record, float *clip)
{
    const float w = (float)fb->width, h = (float)fb->height;
    const float x = z->x[i] / w * 2.0f - 1.0f, y = z->y[j] / h * 2.0f - 1.0f;
    const float lanes[LANES] = {fgl_fma(x, w * 0.5f, w * 0.5f), fgl_fma(y, -(h * 0.5f), h * 0.5f), 0.5f, 1.0f,
                                (float)i, z->t_at[j], 0.0f, 1.0f};
    const float position[4] = {x, y, 0.0f, 1.0f};
    memcpy(record, lanes, sizeof lanes);
    memcpy(clip, position, sizeof position);
    return (x > 1.0f ? 1u : 0) | (x < -1.0f ? 2u : 0) | (y > 1.0f ? 4u : 0) | (y < -1.0f ? 8u : 0);
}

bool fgl_zoom_clip(const struct zoom *zoom, const struct framebuffer *fb, const struct rect *bounds, zoomed_run_fn *take, void *taker)
{
    static const int corner[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; /* raster/zoom.h: triangles 0 1 2 and 0 2 3 */
    struct zoom_sampler sampler = {.fragment = {.fill = sample, .general = sample}, .zoom = zoom, .take = take, .taker = taker};
    struct pipeline clipper;
    float record[4][LANES], clip[4][4];
    unsigned outcode[4];
    sampler.column = malloc(2 * (size_t)fb->stride * sizeof *sampler.column);
    if (!sampler.column)
        return false;
    sampler.row = sampler.column + fb->stride;
    setup_clipper(&clipper, fb, bounds, &sampler);
    for (int i = 0; i < 4; i++)
        outcode[i] = set_corner(zoom, fb, corner[i][0], corner[i][1], record[i], clip[i]);
    for (int i = 2; i < 4; i++) {
        const struct clip_vertices triangle = {{record[0], record[i - 1], record[i]}, {clip[0], clip[i - 1], clip[i]}, record[0],
                                               outcode[0] | outcode[i - 1] | outcode[i], 0};
        clipper.plan.clip->triangle(&clipper, &clipper.plan.raster, &triangle);
    }
    free(sampler.column);
    return true;
}
