/* From state to the rasterizer's plan (GL 1.5, chapter 3; 4.1.2 "Scissor Test"). */
#include "raster/raster.h"

#include <math.h>

static int clamp_to(int64_t v, int size)
{
    return v < 0 ? 0 : v < size ? (int)v : size;
}

/* GL 1.5, 4.1.2: the scissor rectangle, cut to the framebuffer. */
struct rect fgl_raster_bounds(const struct scissor_state *scissor, const struct framebuffer *fb)
{
    if (!scissor->scissor_test)
        return (struct rect){0, 0, fb->width, fb->height};
    const int64_t x = scissor->scissor_box[0], y = scissor->scissor_box[1];
    const int64_t x1 = x + scissor->scissor_box[2], y1 = y + scissor->scissor_box[3];
    const struct rect window = {clamp_to(x, fb->width), clamp_to(y, fb->height), clamp_to(x1, fb->width), clamp_to(y1, fb->height)};
    return fgl_turned(fb, window);
}

/* OSMesa rule: these states send all triangles the longer road (polygon_kernel.h). */
static bool takes_longer_road(const struct raster_plan *plan)
{
    return plan->polygon_mode[0] != GL_FILL || plan->polygon_mode[1] != GL_FILL || plan->polygon_stipple ||
           plan->line_stipple || plan->line_smooth || plan->point_smooth;
}

static void filled_triangle(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                            const void *provoking)
{
    fgl_raster_polygon_mode(plan, v0, v1, v2, provoking, EDGES_ALL, NULL);
}

void fgl_raster_validate(struct raster_plan *plan, const struct server_state *s,
                         const struct fragment_plan *fragment)
{
    const struct polygon_state *polygon = &s->polygon;
    plan->kernels = fgl_raster_kernels(fragment->arith);
    plan->filled = plan->kernels->triangle;
    plan->line = plan->kernels->line;
    plan->point = plan->kernels->point;
    plan->bounds = fgl_raster_bounds(&s->scissor, fragment->fb);
    plan->fragment = fragment;

    plan->front_is_ccw = (polygon->front_face == GL_CCW) != fragment->fb->y_up;
    plan->first_row_owned = fragment->fb->y_up; /* GL's lower edge, in either case */
    plan->cull_front = polygon->cull_face && polygon->cull_face_mode != GL_BACK;
    plan->cull_back = polygon->cull_face && polygon->cull_face_mode != GL_FRONT;
    plan->cull_ccw = plan->front_is_ccw ? plan->cull_front : plan->cull_back;
    plan->cull_cw = plan->front_is_ccw ? plan->cull_back : plan->cull_front;
    /* A face that is culled takes the other's mode: it shows in triangles without area. */
    plan->polygon_mode[0] = polygon->polygon_mode[plan->cull_front ? 1 : 0];
    plan->polygon_mode[1] = plan->cull_back ? plan->polygon_mode[0] : polygon->polygon_mode[1];
    plan->offset_point = polygon->polygon_offset_point;
    plan->offset_line = polygon->polygon_offset_line;
    plan->offset_fill = polygon->polygon_offset_fill;
    plan->offset_factor = polygon->polygon_offset_factor;
    /* OSMesa rule: one unit is two steps of the depth buffer. */
    plan->offset_units =
            (float)((double)polygon->polygon_offset_units * (2.0 / (double)fragment->fb->depth_max));
    plan->polygon_smoothing = /* OSMesa rule: polygons are not antialiased, but an index says so in its low bits */
            polygon->polygon_smooth && fragment->fb->color_kind == COLOR_INDEX8 ? SMOOTH_WHOLE : SMOOTH_NONE;
    plan->polygon_stipple = polygon->polygon_stipple;
    plan->stipple = &s->polygon_stipple;

    plan->line_width = fminf(fmaxf(s->line.line_width, 1), FGL_MAX_LINE_WIDTH); /* GL 1.5, 3.4 */
    plan->line_smooth = s->line.line_smooth;
    plan->line_stipple = s->line.line_stipple &&
                         s->line.line_stipple_pattern != 0xffff; /* OSMesa rule: else as if disabled */
    plan->line_stipple_factor = s->line.line_stipple_repeat;
    plan->line_stipple_pattern = s->line.line_stipple_pattern;
    /* OSMesa rule: also a size that distance does not attenuate is clamped. */
    plan->point_size = fminf(fmaxf(s->point.point_size, s->point.point_size_min), s->point.point_size_max);
    plan->point_smooth = s->point.point_smooth;
    plan->point_sprite = s->point.point_sprite;
    plan->longer_road = takes_longer_road(plan);
    plan->scatters = fragment->scatter && !plan->longer_road && !plan->offset_fill;
    plan->triangle = plan->longer_road ? filled_triangle : plan->kernels->triangle;
}
