/* Lines (GL 1.5, 3.4 "Line Segments"), in OSMesa's way: an aliased line is a polygon of four edges around the
 * segment, whose ends are moved so that the first and the last pixel obey the diamond-exit rule of 3.4.1.
 * Window y runs along the rows: down, but up in framebuffer objects. Kernels. */
#ifndef FGL_RASTER_LINE_KERNEL_H
#define FGL_RASTER_LINE_KERNEL_H

#include "raster/coverage.h"
#include "raster/setup.h"

/* One coordinate pair along the line's major axis (x if |dx| >= |dy|) and across it. */
struct line_end {
    real major, minor;   /* window coordinates */
    real fmajor, fminor; /* from the pixel's centre: -0.5 .. 0.5 */
};

static bool positive(real v)
{
    return v >= 0;
}
static real fraction(real v)
{
    return v - r_floor(v);
}

static struct line_end end_of(const real *v, int major)
{
    const real a = v[major], b = v[1 - major];
    return (struct line_end){a, b, fraction(a) - (real)0.5, fraction(b) - (real)0.5};
}

/* How far the ends must be moved along the major axis, zero where the polygon draws what the diamond rule
 * asks for as it is. */
struct shifts {
    real start, end;
};

/* x-major: d* = start - end. */
static struct shifts shifts_x_major(const struct line_end *s, const struct line_end *e, real dx, real dy,
                                    real slope)
{
    bool draw_start, draw_end;
    const real fy_end = e->fminor == (real)-0.5 && dy < 0 ? (real)0.5 : e->fminor;
    if (r_abs(s->fmajor) + r_abs(s->fminor) < (real)0.5) {
        draw_start = true;
    } else if (positive(s->fmajor) == positive(-dx)) {
        draw_start = false;
    } else if (positive(-s->fminor) != positive(dy)) {
        draw_start = true;
    } else {
        const real cross = fraction(s->minor) + s->fmajor * slope;
        draw_start = cross > 0 && cross < 1;
    }
    if (r_abs(e->fmajor) + r_abs(fy_end) < (real)0.5) {
        draw_end = false;
    } else if (positive(e->fmajor) != positive(-dx)) {
        draw_end = false;
    } else if (positive(-fy_end) == positive(dy)) {
        draw_end = true;
    } else {
        const real cross = fraction(e->minor) + e->fmajor * slope;
        draw_end = cross > 0 && cross < 1;
    }
    const bool plain_start = positive(-s->fmajor) != positive(dx);
    const bool plain_end = positive(e->fmajor) == positive(-dx) || e->fmajor == 0;
    const real half = dx < 0 ? (real)-0.5 : (real)0.5;
    return (struct shifts){draw_start != plain_start ? half - s->fmajor : 0,
                           draw_end != plain_end ? half - e->fmajor : 0};
}

static struct shifts shifts_y_major(const struct line_end *s, const struct line_end *e, real dx, real dy,
                                    real slope)
{
    bool draw_start, draw_end;
    const real fx_end = e->fminor == (real)-0.5 && dx < 0 ? (real)0.5 : e->fminor;
    if (r_abs(s->fminor) + r_abs(s->fmajor) < (real)0.5) {
        draw_start = true;
    } else if (positive(-s->fmajor) == positive(dy)) {
        draw_start = false;
    } else if (positive(s->fminor) != positive(-dx)) {
        draw_start = true;
    } else {
        const real cross = fraction(s->minor) + s->fmajor * slope;
        draw_start = cross > 0 && cross < 1;
    }
    if (r_abs(fx_end) + r_abs(e->fmajor) < (real)0.5) {
        draw_end = false;
    } else if (positive(-e->fmajor) != positive(dy)) {
        draw_end = false;
    } else if (positive(fx_end) == positive(-dx)) {
        draw_end = true;
    } else {
        const real cross = fraction(e->minor) + e->fmajor * slope;
        draw_end = cross >= 0 && cross < 1;
    }
    const bool plain_start = positive(s->fmajor) == positive(dy);
    const bool plain_end = positive(-e->fmajor) == positive(dy) || e->fmajor == 0;
    const real half = dy > 0 ? (real)0.5 : (real)-0.5;
    return (struct shifts){draw_start != plain_start ? half - s->fmajor : 0,
                           draw_end != plain_end ? half - e->fmajor : 0};
}

/* OSMesa rule: a line's or point's vertex goes to the nearest 1/256 pixel, half away from zero. */
static int64_t snap_line(real v)
{
    const real s = (v - (real)0.5) * 256;
    return (int64_t)(s >= 0 ? s + (real)0.5 : s - (real)0.5);
}

/* Planes along the line: no gradient across it. */
static void line_planes(const struct raster_plan *plan, struct planes *p, const real *v0, const real *v1,
                        const real *provoking, real dx_ooa, real dy_ooa, real ooa)
{
    for (int lane = LANE_Z; lane < plan->lanes; lane++) {
        const real a0 = lane < LANE_COLOR ? v0[lane] : v0[lane] * v0[LANE_OOW];
        const real a1 = lane < LANE_COLOR ? v1[lane] : v1[lane] * v1[LANE_OOW];
        const real d = a0 - a1;
        const real dadx = d * dx_ooa * ooa, dady = d * dy_ooa * ooa;
        PLANES(p)->dadx[lane] = dadx;
        PLANES(p)->dady[lane] = dady;
        PLANES(p)->a00[lane] = a0 - (dadx * (v0[LANE_X] - (real)0.5) + dady * (v0[LANE_Y] - (real)0.5));
    }
    if (plan->flat)
        flat_planes(p, provoking + LANE_COLOR, plan->secondary);
    PLANES(p)->z_offset = 0;
    p->smoothing = SMOOTH_NONE;
    p->stipple = NULL;
}

static void aliased_line(const struct raster_plan *plan, const real *v0, const real *v1,
                         const real *provoking)
{
    const real dx = v0[LANE_X] - v1[LANE_X], dy = v0[LANE_Y] - v1[LANE_Y], length2 = dx * dx + dy * dy;
    if (!within_limit(v0) || !within_limit(v1) || !(length2 > 0))
        return;
    const bool x_major = r_abs(dx) >= r_abs(dy);
    const int major = x_major ? LANE_X : LANE_Y;
    const real slope = x_major ? dy / dx : dx / dy;
    const struct line_end s = end_of(v0, major), e = end_of(v1, major);
    const struct shifts shift =
            x_major ? shifts_x_major(&s, &e, dx, dy, slope) : shifts_y_major(&s, &e, dx, dy, slope);

    const int64_t half_width = 128 * (int)(plan->line_width + 0.5f);
    const int64_t start_major = snap_line(s.major + shift.start),
                  start_minor = snap_line(s.minor + shift.start * slope);
    const int64_t end_major = snap_line(e.major + shift.end),
                  end_minor = snap_line(e.minor + shift.end * slope);
    const bool forward = x_major ? dx < 0 : dy < 0; /* towards larger coordinates */
    const int64_t lo = forward ? start_major : end_major, lo_minor = forward ? start_minor : end_minor;
    const int64_t hi = forward ? end_major : start_major, hi_minor = forward ? end_minor : start_minor;
    const struct polygon along_x = {
            {hi, lo, lo, hi},
            {hi_minor - half_width, lo_minor - half_width, lo_minor + half_width, hi_minor + half_width}};
    const struct polygon along_y = {
            {lo_minor - half_width, hi_minor - half_width, hi_minor + half_width, lo_minor + half_width},
            {lo, hi, hi, lo}};

    struct planes planes;
    const real stretched = 1 + slope * slope;
    line_planes(plan, &planes, v0, v1, provoking, x_major ? dx * stretched : 0,
                x_major ? 0 : dy * stretched, 1 / length2);
    quad(plan, x_major ? &along_x : &along_y, &planes);
}

/* A rectangle of two triangles, half a pixel longer at each end and wider at each side; coverage is made for
 * each pixel by the fragment stage. */
static void smooth_line(const struct raster_plan *plan, const real *v0, const real *v1,
                        const real *provoking)
{
    const real dx = v1[LANE_X] - v0[LANE_X], dy = v1[LANE_Y] - v0[LANE_Y], length = r_sqrt(dx * dx + dy * dy);
    if (!within_limit(v0) || !within_limit(v1))
        return;
    const real half_width = (real)(plan->line_width * 0.5f + 0.5f);
    const real half_length = length < 1 ? length : length * (real)0.5 + (real)0.5;
    const float angle = atan2f((float)dy, (float)dx);
    const real c = (real)cosf(angle), s = (real)sinf(angle);
    real corner[4][LANE_MAX];
    for (int i = 0; i < 4; i++) {
        const real along = i < 2 ? (real)-0.5 : (real)0.5, across = i & 1 ? -half_width : half_width;
        memcpy(corner[i], i < 2 ? v0 : v1, (size_t)plan->lanes * sizeof(real));
        corner[i][LANE_X] += along * c - across * s;
        corner[i][LANE_Y] += along * s + across * c;
        corner[i][LANE_SMOOTH + 0] = i & 1 ? half_width : -half_width;
        corner[i][LANE_SMOOTH + 1] = half_width;
        corner[i][LANE_SMOOTH + 2] = i < 2 ? -half_length : half_length;
        corner[i][LANE_SMOOTH + 3] = half_length;
    }
    smooth_triangle(plan, corner[2], corner[1], corner[0], provoking, SMOOTH_LINE);
    smooth_triangle(plan, corner[3], corner[1], corner[2], provoking, SMOOTH_LINE);
}

/* Whether all of a line is above or below the bounds, which may be those of a band: asked before anything else is done for it. */
static bool misses_rows(const struct raster_plan *plan, const real *v0, const real *v1)
{
    const real reach = (real)plan->line_width + 4, y0 = (real)plan->bounds.y0 - reach, y1 = (real)plan->bounds.y1 + reach;
    return (v0[LANE_Y] < y0 && v1[LANE_Y] < y0) || (v0[LANE_Y] > y1 && v1[LANE_Y] > y1);
}

static void unstippled_line(const struct raster_plan *plan, const real *v0, const real *v1,
                            const real *provoking)
{
    if (plan->line_smooth)
        smooth_line(plan, v0, v1, provoking);
    else
        aliased_line(plan, v0, v1, provoking);
}

/* The vertex at t, 0..1: everything is linear in window space here, 1/w too. */
static void between(const struct raster_plan *plan, const real *v0, const real *v1, real t, real *v)
{
    for (int i = 0; i < plan->lanes; i++)
        v[i] = v0[i] + t * (v1[i] - v0[i]);
}

/* Line stipple (GL 1.5, 3.4.2): a line for each stretch of pixels that the pattern admits. */
static void stippled_line(const struct raster_plan *plan, const real *v0, const real *v1,
                          const real *provoking, int *counter)
{
    const real dx = r_abs(v1[LANE_X] - v0[LANE_X]), dy = r_abs(v1[LANE_Y] - v0[LANE_Y]);
    const real length = plan->line_smooth ? r_sqrt(dx * dx + dy * dy) : r_max(dx, dy);
    if (!within_limit(v0) || !within_limit(v1))
        return;
    const int n = (int)r_ceil(length);
    const bool missed = misses_rows(plan, v0, v1);
    int start = -1; /* of the stretch, or -1 outside */
    real a[LANE_MAX], b[LANE_MAX];
    for (int i = 0; i <= n && !missed; i++) {
        const bool on =
                i < n && plan->line_stipple_pattern >> ((*counter + i) / plan->line_stipple_factor & 15) & 1;
        if (on && start < 0)
            start = i;
        if (on || start < 0)
            continue;
        between(plan, v0, v1, (real)start / length, a);
        between(plan, v0, v1, (real)i / length, b);
        unstippled_line(plan, start == 0 ? v0 : a, i == n ? v1 : b, provoking);
        start = -1;
    }
    *counter += n;
}

static void draw_line(const struct raster_plan *plan, const void *v0, const void *v1, const void *provoking,
                      int *stipple_counter)
{
    if (plan->line_stipple)
        stippled_line(plan, v0, v1, provoking, stipple_counter);
    else if (!misses_rows(plan, v0, v1))
        unstippled_line(plan, v0, v1, provoking);
}

#endif
