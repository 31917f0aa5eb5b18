/* From state to the rasterizer's plan (GL 1.5, chapter 3; 4.1.2 "Scissor Test"). */
#include "raster/raster.h"

/* GL 1.5, 4.1.2: the scissor rectangle, y up, turned over and cut to the framebuffer. */
static struct rect bounds_of(const struct scissor_state *scissor, const struct framebuffer *fb)
{
    if (!scissor->scissor_test)
        return (struct rect){0, 0, fb->width, fb->height};
    const int64_t x = scissor->scissor_box[0], y = scissor->scissor_box[1];
    const int64_t x1 = x + scissor->scissor_box[2], y1 = y + scissor->scissor_box[3];
    const int64_t w = fb->width, h = fb->height;
    const struct rect r = {(int)(x < 0 ? 0 : x < w ? x : w), (int)(y1 > h ? 0 : y1 > 0 ? h - y1 : h),
                           (int)(x1 < 0 ? 0 : x1 < w ? x1 : w), (int)(y > h ? 0 : y > 0 ? h - y : h)};
    return r;
}

void fgl_raster_validate(struct raster_plan *plan, const struct server_state *s, const struct fragment_plan *fragment)
{
    const struct polygon_state *polygon = &s->polygon;
    const bool both = polygon->cull_face_mode == GL_FRONT_AND_BACK, front = polygon->cull_face_mode == GL_FRONT;
    plan->kernels = fgl_raster_kernels();
    plan->bounds = bounds_of(&s->scissor, fragment->fb);
    plan->framebuffer_height = fragment->fb->height;
    plan->fragment = fragment;

    plan->front_is_ccw = polygon->front_face == GL_CCW;
    plan->cull_ccw = polygon->cull_face && (both || front == plan->front_is_ccw);
    plan->cull_cw = polygon->cull_face && (both || front != plan->front_is_ccw);
    plan->polygon_mode[0] = polygon->polygon_mode[0];
    plan->polygon_mode[1] = polygon->polygon_mode[1];
    plan->offset_point = polygon->polygon_offset_point;
    plan->offset_line = polygon->polygon_offset_line;
    plan->offset_fill = polygon->polygon_offset_fill;
    plan->offset_factor = polygon->polygon_offset_factor;
    plan->offset_units = polygon->polygon_offset_units;
    plan->offset_unit = 2.0f / (float)fragment->fb->depth_max; /* OSMesa rule: two steps of the depth buffer */
    plan->polygon_stipple = polygon->polygon_stipple;
    plan->stipple = &s->polygon_stipple;

    plan->line_width = s->line.line_width;
    plan->line_smooth = s->line.line_smooth;
    plan->line_stipple = s->line.line_stipple;
    plan->line_stipple_factor = s->line.line_stipple_repeat;
    plan->line_stipple_pattern = s->line.line_stipple_pattern;
    plan->point_size = s->point.point_size;
    plan->point_smooth = s->point.point_smooth;
}
