#include "oracle/raster.h"

enum { SUBPIXELS = 256, HALF = ORACLE_WINDOW / 2 };

static quad absolute(quad x)
{
    return x < 0 ? -x : x;
}

static quad clamp01(quad x)
{
    return !(x > 0) ? 0 : x > 1 ? 1 : x;
}

/* Half to even; |x| < 2^40. */
static int64_t round_to_integer(quad x)
{
    int64_t floor = (int64_t)x;
    floor -= (quad)floor > x;
    const quad rest = x - (quad)floor;
    if (rest == (quad)0.5)
        return floor + (floor & 1);
    return floor + (rest > (quad)0.5);
}

/* GL 1.5, 2.11.1 "Controlling the Viewport". Device coordinate to 1/256 of a pixel. */
static int64_t snap(float x, float w)
{
    return round_to_integer(((quad)x / (quad)w * HALF + HALF) * SUBPIXELS);
}

static bool is_inside_volume(const float v[4])
{
    for (int k = 0; k < 3; k++)
        if (!(v[k] >= -v[3] && v[k] <= v[3]))
            return false;
    return v[3] > 0;
}

static int64_t area_of(const struct raster_setup *s)
{
    return (s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) - (s->x[2] - s->x[0]) * (s->y[1] - s->y[0]);
}

/* Corner i of the triangle lies opposite of edge i; homogeneous, so that no division by w is needed (Olano
 * and Greer, 1997): (a, b, c) is the cross product of the other two corners' (x, y, w). */
static void set_edges(struct raster_setup *s)
{
    for (int i = 0; i < 3; i++) {
        const float *p = s->triangle->vertex[(i + 1) % 3].clip, *q = s->triangle->vertex[(i + 2) % 3].clip;
        s->edge[i][0] = (quad)p[1] * (quad)q[3] - (quad)p[3] * (quad)q[1];
        s->edge[i][1] = (quad)p[3] * (quad)q[0] - (quad)p[0] * (quad)q[3];
        s->edge[i][2] = (quad)p[0] * (quad)q[1] - (quad)p[1] * (quad)q[0];
    }
    const float *first = s->triangle->vertex[0].clip;
    const quad determinant =
            s->edge[0][0] * (quad)first[0] + s->edge[0][1] * (quad)first[1] + s->edge[0][2] * (quad)first[3];
    s->flat = determinant == 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            s->edge[i][k] = determinant < 0 ? -s->edge[i][k] : s->edge[i][k];
}

void oracle_raster_setup(const struct raster_triangle *triangle, struct raster_setup *s)
{
    *s = (struct raster_setup){.triangle = triangle};
    for (int i = 0; i < 3; i++)
        s->clipped = s->clipped || !is_inside_volume(triangle->vertex[i].clip);
    set_edges(s);
    if (s->clipped)
        return;
    for (int i = 0; i < 3; i++) {
        const float *v = triangle->vertex[i].clip;
        s->x[i] = snap(v[0], v[3]);
        s->y[i] = snap(v[1], v[3]);
    }
    if (area_of(s) < 0) {
        const int64_t x = s->x[1], y = s->y[1];
        s->x[1] = s->x[2], s->y[1] = s->y[2];
        s->x[2] = x, s->y[2] = y;
    }
}

/* Counterclockwise: the inside is left of each edge. On the edge, inside if the edge goes down or,
 * horizontal, to the right: a left or a bottom edge. */
static enum raster_coverage snapped_coverage(const struct raster_setup *s, int x, int y)
{
    const int64_t px = SUBPIXELS * (int64_t)x + SUBPIXELS / 2, py = SUBPIXELS * (int64_t)y + SUBPIXELS / 2;
    if (area_of(s) == 0)
        return RASTER_OUTSIDE;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int64_t dx = s->x[j] - s->x[i], dy = s->y[j] - s->y[i];
        const int64_t side = dx * (py - s->y[i]) - dy * (px - s->x[i]);
        if (side < 0 || (side == 0 && !(dy < 0 || (dy == 0 && dx > 0))))
            return RASTER_OUTSIDE;
    }
    return RASTER_INSIDE;
}

static quad device(int pixel)
{
    return ((quad)pixel + (quad)0.5 - HALF) / HALF;
}

static quad line_at(const quad line[3], int x, int y)
{
    return line[0] * device(x) + line[1] * device(y) + line[2];
}

/* Sum over the corners of edge times a component of the position: proportional to it, everywhere. */
static void plane_of(const struct raster_setup *s, int component, quad plane[3])
{
    for (int k = 0; k < 3; k++) {
        plane[k] = 0;
        for (int i = 0; i < 3; i++)
            plane[k] += s->edge[i][k] * (quad)s->triangle->vertex[i].clip[component];
    }
}

/* Whether the pixel's center is on the inner side of a line, if it is not too near: RASTER_INSIDE if it is.
 */
static enum raster_coverage side_of(const quad line[3], int x, int y)
{
    const quad margin = (quad)1 / 128 / HALF, at = line_at(line, x, y);
    const quad steepest = absolute(line[0]) + absolute(line[1]); /* not below the gradient's length */
    if (at > margin * steepest)
        return RASTER_INSIDE;
    return at < -margin * steepest ? RASTER_OUTSIDE : RASTER_UNDECIDED;
}

/* Inside the three edges and -w <= z <= w; the frustum's other planes are the window's borders. */
enum raster_coverage oracle_raster_loose_coverage(const struct raster_setup *s, int x, int y)
{
    quad z[3], w[3], bound[2][3];
    plane_of(s, 2, z);
    plane_of(s, 3, w);
    for (int k = 0; k < 3; k++) {
        bound[0][k] = w[k] + z[k];
        bound[1][k] = w[k] - z[k];
    }
    const quad *line[5] = {s->edge[0], s->edge[1], s->edge[2], bound[0], bound[1]};
    enum raster_coverage result = s->flat ? RASTER_OUTSIDE : RASTER_INSIDE;
    for (int i = 0; i < 5; i++) {
        const enum raster_coverage side = side_of(line[i], x, y);
        result = side < result ? side : result;
    }
    return result;
}

enum raster_coverage oracle_raster_coverage(const struct raster_setup *s, int x, int y)
{
    return s->clipped ? oracle_raster_loose_coverage(s, x, y) : snapped_coverage(s, x, y);
}

void oracle_raster_weights(const struct raster_setup *s, int x, int y, quad weight[3])
{
    for (int i = 0; i < 3; i++)
        weight[i] = line_at(s->edge[i], x, y);
}

struct raster_truth oracle_raster_truth(const struct raster_setup *s, int x, int y)
{
    struct raster_truth truth = {{0, 0, 0, 0}, 0};
    quad sum = 0, z = 0, w = 0, weight[3];
    oracle_raster_weights(s, x, y, weight);
    for (int i = 0; i < 3; i++) {
        const struct raster_vertex *v = &s->triangle->vertex[i];
        sum += weight[i];
        z += weight[i] * (quad)v->clip[2];
        w += weight[i] * (quad)v->clip[3];
        for (int k = 0; k < 4; k++)
            truth.color[k] += weight[i] * (quad)v->color[k];
    }
    for (int k = 0; k < 4; k++)
        truth.color[k] = clamp01(truth.color[k] / sum);
    truth.depth = clamp01((z / w + 1) / 2);
    return truth;
}
