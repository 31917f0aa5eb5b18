/* Lines (GL 1.5, 3.4 "Line Segments"), in OSMesa's way: an aliased line is a polygon of four edges around the
 * segment, whose ends are moved so that the first and the last pixel obey the diamond-exit rule of 3.4.1.
 * Window y runs down. */
#include "raster/coverage.h"
#include "raster/setup.h"

/* One coordinate pair along the line's major axis (x if |dx| >= |dy|) and across it. */
struct line_end {
    float major, minor;   /* window coordinates */
    float fmajor, fminor; /* from the pixel's centre: -0.5 .. 0.5 */
};

static bool positive(float v)
{
    return v >= 0.0f;
}
static float fraction(float v)
{
    return v - floorf(v);
}

static struct line_end end_of(const float *v, int major)
{
    const float a = v[major], b = v[1 - major];
    return (struct line_end){a, b, fraction(a) - 0.5f, fraction(b) - 0.5f};
}

/* How far the ends must be moved along the major axis, zero where the polygon draws what the diamond rule
 * asks for as it is. */
struct shifts {
    float start, end;
};

/* x-major: d* = start - end. */
static struct shifts shifts_x_major(const struct line_end *s, const struct line_end *e, float dx, float dy,
                                    float slope)
{
    bool draw_start, draw_end;
    const float fy_end = e->fminor == -0.5f && dy < 0.0f ? 0.5f : e->fminor;
    if (fabsf(s->fmajor) + fabsf(s->fminor) < 0.5f) {
        draw_start = true;
    } else if (positive(s->fmajor) == positive(-dx)) {
        draw_start = false;
    } else if (positive(-s->fminor) != positive(dy)) {
        draw_start = true;
    } else {
        const float cross = fraction(s->minor) + s->fmajor * slope;
        draw_start = cross > 0.0f && cross < 1.0f;
    }
    if (fabsf(e->fmajor) + fabsf(fy_end) < 0.5f) {
        draw_end = false;
    } else if (positive(e->fmajor) != positive(-dx)) {
        draw_end = false;
    } else if (positive(-fy_end) == positive(dy)) {
        draw_end = true;
    } else {
        const float cross = fraction(e->minor) + e->fmajor * slope;
        draw_end = cross > 0.0f && cross < 1.0f;
    }
    const bool plain_start = positive(-s->fmajor) != positive(dx);
    const bool plain_end = positive(e->fmajor) == positive(-dx) || e->fmajor == 0.0f;
    const float half = dx < 0.0f ? -0.5f : 0.5f;
    return (struct shifts){draw_start != plain_start ? half - s->fmajor : 0.0f,
                           draw_end != plain_end ? half - e->fmajor : 0.0f};
}

static struct shifts shifts_y_major(const struct line_end *s, const struct line_end *e, float dx, float dy,
                                    float slope)
{
    bool draw_start, draw_end;
    const float fx_end = e->fminor == -0.5f && dx < 0.0f ? 0.5f : e->fminor;
    if (fabsf(s->fminor) + fabsf(s->fmajor) < 0.5f) {
        draw_start = true;
    } else if (positive(-s->fmajor) == positive(dy)) {
        draw_start = false;
    } else if (positive(s->fminor) != positive(-dx)) {
        draw_start = true;
    } else {
        const float cross = fraction(s->minor) + s->fmajor * slope;
        draw_start = cross > 0.0f && cross < 1.0f;
    }
    if (fabsf(fx_end) + fabsf(e->fmajor) < 0.5f) {
        draw_end = false;
    } else if (positive(-e->fmajor) != positive(dy)) {
        draw_end = false;
    } else if (positive(fx_end) == positive(-dx)) {
        draw_end = true;
    } else {
        const float cross = fraction(e->minor) + e->fmajor * slope;
        draw_end = cross >= 0.0f && cross < 1.0f;
    }
    const bool plain_start = positive(s->fmajor) == positive(dy);
    const bool plain_end = positive(-e->fmajor) == positive(dy) || e->fmajor == 0.0f;
    const float half = dy > 0.0f ? 0.5f : -0.5f;
    return (struct shifts){draw_start != plain_start ? half - s->fmajor : 0.0f,
                           draw_end != plain_end ? half - e->fmajor : 0.0f};
}

/* OSMesa rule: a line's or point's vertex goes to the nearest 1/256 pixel, half away from zero. */
static int64_t snap_line(float v)
{
    const float s = (v - 0.5f) * 256.0f;
    return (int64_t)(s >= 0.0f ? s + 0.5f : s - 0.5f);
}

/* Planes along the line: no gradient across it. */
static void line_planes(const struct raster_plan *plan, struct planes *p, const float *v0, const float *v1,
                        const float *provoking, float dx_ooa, float dy_ooa, float ooa)
{
    for (int lane = LANE_Z; lane < plan->lanes; lane++) {
        const float a0 = lane < LANE_COLOR ? v0[lane] : v0[lane] * v0[LANE_OOW];
        const float a1 = lane < LANE_COLOR ? v1[lane] : v1[lane] * v1[LANE_OOW];
        const float d = a0 - a1;
        p->dadx[lane] = d * dx_ooa * ooa;
        p->dady[lane] = d * dy_ooa * ooa;
        p->a00[lane] = a0 - (p->dadx[lane] * (v0[LANE_X] - 0.5f) + p->dady[lane] * (v0[LANE_Y] - 0.5f));
    }
    if (plan->flat)
        flat_planes(p, provoking + LANE_COLOR, plan->fragment->has_secondary);
    p->z_offset = 0.0f;
    p->smoothing = SMOOTH_NONE;
    p->stipple = NULL;
}

static void aliased_line(const struct raster_plan *plan, const float *v0, const float *v1,
                         const float *provoking)
{
    const float dx = v0[LANE_X] - v1[LANE_X], dy = v0[LANE_Y] - v1[LANE_Y], length2 = dx * dx + dy * dy;
    if (!within_limit(v0) || !within_limit(v1) || !(length2 > 0.0f))
        return;
    const bool x_major = fabsf(dx) >= fabsf(dy);
    const int major = x_major ? LANE_X : LANE_Y;
    const float slope = x_major ? dy / dx : dx / dy;
    const struct line_end s = end_of(v0, major), e = end_of(v1, major);
    const struct shifts shift =
            x_major ? shifts_x_major(&s, &e, dx, dy, slope) : shifts_y_major(&s, &e, dx, dy, slope);

    const int64_t half_width = 128 * (int)(fmaxf(1.0f, plan->line_width) + 0.5f);
    const int64_t start_major = snap_line(s.major + shift.start),
                  start_minor = snap_line(s.minor + shift.start * slope);
    const int64_t end_major = snap_line(e.major + shift.end),
                  end_minor = snap_line(e.minor + shift.end * slope);
    const bool forward = x_major ? dx < 0.0f : dy < 0.0f; /* towards larger coordinates */
    const int64_t lo = forward ? start_major : end_major, lo_minor = forward ? start_minor : end_minor;
    const int64_t hi = forward ? end_major : start_major, hi_minor = forward ? end_minor : start_minor;
    const struct polygon along_x = {
            {hi, lo, lo, hi},
            {hi_minor - half_width, lo_minor - half_width, lo_minor + half_width, hi_minor + half_width}};
    const struct polygon along_y = {
            {lo_minor - half_width, hi_minor - half_width, hi_minor + half_width, lo_minor + half_width},
            {lo, hi, hi, lo}};

    struct planes planes;
    const float stretched = 1.0f + slope * slope;
    line_planes(plan, &planes, v0, v1, provoking, x_major ? dx * stretched : 0.0f,
                x_major ? 0.0f : dy * stretched, 1.0f / length2);
    plan->kernels->quad(plan, x_major ? &along_x : &along_y, &planes);
}

/* A rectangle of two triangles, half a pixel longer at each end and wider at each side; coverage is made for
 * each pixel by the fragment stage. */
static void smooth_line(const struct raster_plan *plan, const float *v0, const float *v1,
                        const float *provoking)
{
    const float dx = v1[LANE_X] - v0[LANE_X], dy = v1[LANE_Y] - v0[LANE_Y], length = sqrtf(dx * dx + dy * dy);
    if (!within_limit(v0) || !within_limit(v1))
        return;
    const float half_width = plan->line_width <= 1.0f ? 1.0f : plan->line_width * 0.5f + 0.5f;
    const float half_length = length < 1.0f ? length : length * 0.5f + 0.5f;
    const float angle = atan2f(dy, dx), c = cosf(angle), s = sinf(angle);
    float corner[4][LANE_MAX];
    for (int i = 0; i < 4; i++) {
        const float along = i < 2 ? -0.5f : 0.5f, across = i & 1 ? -half_width : half_width;
        memcpy(corner[i], i < 2 ? v0 : v1, (size_t)plan->lanes * sizeof(float));
        corner[i][LANE_X] += along * c - across * s;
        corner[i][LANE_Y] += along * s + across * c;
        corner[i][LANE_SMOOTH + 0] = i & 1 ? half_width : -half_width;
        corner[i][LANE_SMOOTH + 1] = half_width;
        corner[i][LANE_SMOOTH + 2] = i < 2 ? -half_length : half_length;
        corner[i][LANE_SMOOTH + 3] = half_length;
    }
    plan->kernels->smooth_triangle(plan, corner[2], corner[1], corner[0], provoking, SMOOTH_LINE);
    plan->kernels->smooth_triangle(plan, corner[3], corner[1], corner[2], provoking, SMOOTH_LINE);
}

static void unstippled_line(const struct raster_plan *plan, const float *v0, const float *v1,
                            const float *provoking)
{
    if (plan->line_smooth)
        smooth_line(plan, v0, v1, provoking);
    else
        aliased_line(plan, v0, v1, provoking);
}

/* The vertex at t, 0..1: everything is linear in window space here, 1/w too. */
static void between(const struct raster_plan *plan, const float *v0, const float *v1, float t, float *v)
{
    for (int i = 0; i < plan->lanes; i++)
        v[i] = v0[i] + t * (v1[i] - v0[i]);
}

/* Line stipple (GL 1.5, 3.4.2): a line for each stretch of pixels that the pattern admits. */
static void stippled_line(const struct raster_plan *plan, const float *v0, const float *v1,
                          const float *provoking, int *counter)
{
    const float dx = fabsf(v1[LANE_X] - v0[LANE_X]), dy = fabsf(v1[LANE_Y] - v0[LANE_Y]);
    const float length = plan->line_smooth ? sqrtf(dx * dx + dy * dy) : fmaxf(dx, dy);
    if (!within_limit(v0) || !within_limit(v1))
        return;
    const int n = (int)ceilf(length);
    int start = -1; /* of the stretch, or -1 outside */
    float a[LANE_MAX], b[LANE_MAX];
    for (int i = 0; i <= n; i++) {
        const bool on =
                i < n && plan->line_stipple_pattern >> ((*counter + i) / plan->line_stipple_factor & 15) & 1;
        if (on && start < 0)
            start = i;
        if (on || start < 0)
            continue;
        between(plan, v0, v1, (float)start / length, a);
        between(plan, v0, v1, (float)i / length, b);
        unstippled_line(plan, start == 0 ? v0 : a, i == n ? v1 : b, provoking);
        start = -1;
    }
    *counter += n;
}

void fgl_raster_draw_line(const struct raster_plan *plan, const float *v0, const float *v1,
                          const float *provoking, int *stipple_counter)
{
    if (plan->line_stipple)
        stippled_line(plan, v0, v1, provoking, stipple_counter);
    else
        unstippled_line(plan, v0, v1, provoking);
}
