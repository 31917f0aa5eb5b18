/* Clipping against the view volume and the user's planes (GL 1.5, 2.12 "Clipping"), in clip space, in OSMesa's order: right, left, top, bottom, near,
 * far, then user planes 0..7, and only those that some vertex lies outside of. New vertices take all attributes, unfused, at one t. Kernels. */
#ifndef FGL_PIPELINE_CLIP_KERNEL_H
#define FGL_PIPELINE_CLIP_KERNEL_H

#include "pipeline/pipeline.h"
#include "vertex/work.h"

enum {
    CLIP_MAX_VERTICES = 3 + 6 + FGL_MAX_CLIP_PLANES, /* each plane adds one at most */
    CLIP_MAX_NEW = 2 * (6 + FGL_MAX_CLIP_PLANES),
    RECORD_MAX = LANE_MAX + 12
};

struct clip_vertex {
    const real *record, *clip;
    bool edge; /* boundary edge to the next vertex */
};

/* New vertices of one primitive. */
struct clip_pool {
    real record[CLIP_MAX_NEW][RECORD_MAX], clip[CLIP_MAX_NEW][CLIP_VERTEX_LANES];
    int n;
};

static const real frustum_plane[6][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, -1, 1}};

static const real *plane(const struct pipeline *p, int i)
{
    return i < 6 ? frustum_plane[i] : PLAN_NUMBERS(&p->plan.vertex)->user_plane[i - 6];
}

/* The distance of a clip vertex from plane i. User planes: in clip space, OSMesa rule; exact: in eye space. */
static real distance(const struct pipeline *p, const real *clip, int i)
{
    const real *at = plane(p, i), *v = R_EXACT && i >= 6 ? clip + CLIP_LANES : clip;
    return v[0] * at[0] + v[1] * at[1] + v[2] * at[2] + v[3] * at[3];
}

/* The vertex at `from + t (to - from)`. Its window position: OSMesa does not fuse the viewport here. */
static struct clip_vertex between(const struct pipeline *p, struct clip_pool *pool, const struct clip_vertex *from,
                                  const struct clip_vertex *to, real t)
{
    real *clip = pool->clip[pool->n], *record = pool->record[pool->n];
    pool->n++;
    for (int k = 0; k < CLIP_VERTEX_LANES; k++)
        clip[k] = from->clip[k] + t * (to->clip[k] - from->clip[k]);
    for (int k = 4; k < p->plan.emit.stride; k++)
        record[k] = from->record[k] + t * (to->record[k] - from->record[k]);
    const real *scale = PLAN_NUMBERS(&p->plan.vertex)->viewport_scale, *trans = PLAN_NUMBERS(&p->plan.vertex)->viewport_trans;
    const real oow = 1 / clip[3];
    for (int k = 0; k < 3; k++)
        record[k] = clip[k] * oow * scale[k] + trans[k];
    record[3] = oow;
    return (struct clip_vertex){record, clip, false};
}

/* The new vertex where the edge from prev to cur crosses a plane at distances dp, d. The nearer end is the base. */
static struct clip_vertex crossing(struct pipeline *p, struct clip_pool *pool, const struct clip_vertex *prev, real dp,
                                   const struct clip_vertex *cur, real d)
{
    const real ad = d < 0 ? -d : d, adp = dp < 0 ? -dp : dp;
    const bool leaving = d < 0;
    const bool base_is_cur = leaving ? ad < adp : ad <= adp;
    if (base_is_cur)
        return between(p, pool, cur, prev, d / (d - dp));
    return between(p, pool, prev, cur, -dp / (d - dp));
}

/* One plane of Sutherland and Hodgman's algorithm. Returns the number of vertices left, 0 also for NaN. */
static int clip_by_plane(struct pipeline *p, struct clip_pool *pool, int plane_number, const struct clip_vertex *in, int n,
                         struct clip_vertex *out)
{
    const bool user = plane_number >= 6;
    const struct clip_vertex *prev = &in[0];
    real dp = distance(p, prev->clip, plane_number);
    int m = 0;
    for (int i = 1; i <= n; i++) {
        const struct clip_vertex *cur = &in[i == n ? 0 : i];
        const real d = distance(p, cur->clip, plane_number);
        if (!(d - d == 0 && dp - dp == 0) || pool->n == CLIP_MAX_NEW || m + 2 > CLIP_MAX_VERTICES)
            return 0;
        if (dp >= 0)
            out[m++] = *prev;
        if ((dp >= 0) != (d >= 0)) {
            out[m] = crossing(p, pool, prev, dp, cur, d);
            out[m++].edge = dp >= 0 ? user : prev->edge; /* edges along a user's plane are boundaries */
        }
        prev = cur;
        dp = d;
    }
    return m;
}

static void emit_polygon(struct pipeline *p, const struct raster_plan *raster, const struct clip_vertex *v, int n, const real *provoking)
{
    for (int i = 2; i < n; i++) {
        const real *a = v[i - 1].record, *b = v[i].record, *c = v[0].record;
        if (p->plan.polygon_fill) {
            fgl_raster_triangle(raster, a, b, c, provoking);
            continue;
        }
        const unsigned edges = (v[i - 1].edge ? 1u : 0) | (i == n - 1 && v[i].edge ? 2u : 0) | (i == 2 && v[0].edge ? 4u : 0) |
                               (i > 2 ? (unsigned)EDGES_GO_ON : 0);
        fgl_raster_polygon_mode(&p->plan.raster, a, b, c, provoking, edges, &p->stipple_counter);
    }
}

static void clip_triangle(struct pipeline *p, const struct raster_plan *raster, const struct clip_vertices *in)
{
    struct clip_pool pool;
    struct clip_vertex list[2][CLIP_MAX_VERTICES + 2];
    pool.n = 0;
    int n = 3, now = 0;
    for (int i = 0; i < 3; i++)
        list[0][i] = (struct clip_vertex){in->record[i], in->clip[i], in->edges >> i & 1};
    for (int k = 0; k < 6 + FGL_MAX_CLIP_PLANES && n >= 3; k++) {
        if (!(in->outcode & (1u << k)))
            continue;
        n = clip_by_plane(p, &pool, k, list[now], n, list[!now]);
        now = !now;
    }
    emit_polygon(p, raster, list[now], n, in->provoking);
}

static void clip_line(const struct pipeline *p, const struct raster_plan *raster, const struct clip_vertices *in, int *stipple_counter)
{
    const struct clip_vertex a = {in->record[0], in->clip[0], false}, b = {in->record[1], in->clip[1], false};
    real t0 = 0, t1 = 0; /* how far each end moves towards the other */
    for (int k = 0; k < 6 + FGL_MAX_CLIP_PLANES; k++) {
        if (!(in->outcode & (1u << k)))
            continue;
        const real d0 = distance(p, a.clip, k), d1 = distance(p, b.clip, k);
        if (d1 < 0 && d1 / (d1 - d0) > t1)
            t1 = d1 / (d1 - d0);
        if (d0 < 0 && d0 / (d0 - d1) > t0)
            t0 = d0 / (d0 - d1);
        if (!(t0 + t1 < 1))
            return;
    }
    struct clip_pool pool;
    pool.n = 0;
    const struct clip_vertex from = t0 > 0 ? between(p, &pool, &a, &b, t0) : a;
    const struct clip_vertex to = t1 > 0 ? between(p, &pool, &b, &a, t1) : b;
    fgl_raster_line(raster, from.record, to.record, in->provoking, stipple_counter);
}

#endif
