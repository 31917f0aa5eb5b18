/* Rasterization (GL 1.5, chapter 3): from window-space vertices to runs of covered pixels. Layer 3. Has never
 * heard of a light.
 *
 * A raster vertex is an array of floats, of doubles in FIXEDGL_EXACT (enum LANE_* in fragment/fragment.h): window x, y (along the framebuffer's rows), z in
 * [0,1], 1/w_clip; then attributes, raw: set-up multiplies smooth ones by 1/w. The record is
 * raster_plan.stride lanes long; when two_sided, the back face's colour (4 lanes) and secondary colour (3
 * more, when the fragment plan has one) stand at back_lane. */
#ifndef FGL_RASTER_RASTER_H
#define FGL_RASTER_RASTER_H

#include "base/batch.h"
#include "fragment/fragment.h"

/* Corners in units of 1/256 pixel; pixel centres are multiples of 256. */
enum { POLYGON_EDGES = 4 };
struct polygon {
    int64_t x[POLYGON_EDGES], y[POLYGON_EDGES];
};

/* A vertex's window position in 1/256 pixel, as the rasterizer rounds it: facing and extent of a triangle are read off
 * three of these. SNAP_SPECIAL in x: outside of the view volume, or too far away for the rasterizer. */
struct snapped {
    int32_t x, y;
};
#define SNAP_SPECIAL INT32_MIN

/* Pixels of small triangles, gathered to be drawn together. */
enum { SMALL_PIXELS = 16 };
struct small_pixels {
    int n;
    int32_t x[SMALL_PIXELS], y[SMALL_PIXELS];
    const void *vertex[3][SMALL_PIXELS]; /* raster vertices of the pixel's triangle, counter-clockwise, provoking last */
    int color[SMALL_PIXELS];             /* the lane where its face's colour begins */
};

/* The kernels of one instruction set and one arithmetic (kernels.c). Every set gives the same bytes. Vertices and
 * provoking vertices are raster vertices. */
struct raster_plan;
typedef void raster_triangle_fn(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                                const void *provoking);
typedef void raster_line_fn(const struct raster_plan *plan, const void *v0, const void *v1, const void *provoking,
                            int *stipple_counter);
typedef void raster_point_fn(const struct raster_plan *plan, const void *v, float size);
struct raster_kernels {
    raster_triangle_fn *triangle;
    void (*polygon_mode)(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                         const void *provoking, unsigned edges, int *stipple_counter);
    raster_line_fn *line;
    raster_point_fn *point;
    /* the window positions of a batch */
    void (*snap)(const struct vertex_batch *batch, struct snapped *out);
    /* Draws the pixels, in their order, and empties the group. */
    void (*small_pixels)(const struct raster_plan *plan, struct small_pixels *pixels);
};

struct raster_plan {
    const struct raster_kernels *kernels;
    raster_triangle_fn *triangle; /* the kernel, or the longer road of polygon_kernel.h */
    bool longer_road;
    bool scatters; /* pixels of small triangles may be drawn by kernels->small_pixels */
    /* What becomes of primitives at the end of the longer road, of lines and of points: they are drawn, or
     * taken by feedback or selection (pipeline/feedback.h), whose context `taker` is. */
    raster_triangle_fn *filled;
    raster_line_fn *line;
    raster_point_fn *point;
    struct context *taker;
    struct rect bounds; /* framebuffer and scissor: the only rectangle that bounds pixels (the viewport does
                           not) */
    int stride;         /* lanes from a raster vertex to the next */
    int lanes;          /* lanes to set up planes for, 4..LANE_MAX */
    bool flat;          /* colour lanes come from the provoking vertex, raw */
    bool two_sided;
    int back_lane;
    int face_lane; /* lane that is above 0 for back faces, lit as such at each fragment; 0: none */
    bool cull_front, cull_back;
    bool cull_ccw, cull_cw; /* the same by orientation: the sign of the snapped area, counter-clockwise where row 0
                               is above the others (else a framebuffer object shows its mirror image) */
    bool front_is_ccw;
    int first_row_owned; /* pixel centres on a level edge belong to the polygon whose first row they are: 1, last row: 0 */
    GLenum polygon_mode[2]; /* 0 front, 1 back */
    bool offset_point, offset_line, offset_fill;
    float offset_factor, offset_units; /* units in window z */
    enum smoothing polygon_smoothing; /* of filled polygons: SMOOTH_NONE or SMOOTH_WHOLE */
    bool polygon_stipple;
    const struct polygon_stipple_state *stipple;
    bool secondary; /* vertices have a secondary colour */
    int size_lane;  /* of the vertices' point size; 0: point_size is that of all */
    float line_width, point_size;
    bool line_smooth, point_smooth, point_sprite, line_stipple;
    int line_stipple_factor;
    uint16_t line_stipple_pattern;
    const struct fragment_plan *fragment;
};

/* The kernels of the processor's best instruction set, and of any that fgl_cpu_has. */
const struct raster_kernels *fgl_raster_kernels(enum fgl_arith arith);
const struct raster_kernels *fgl_raster_kernels_of(enum fgl_isa isa, enum fgl_arith arith);

/* The pixels that may be drawn: the framebuffer's, within the scissor rectangle when that test is
 * enabled. */
struct rect fgl_raster_bounds(const struct scissor_state *scissor, const struct framebuffer *fb);

/* Fills all but stride, lanes, flat, two_sided, back_lane, face_lane, secondary, size_lane (the vertex stage's layout). */
void fgl_raster_validate(struct raster_plan *plan, const struct server_state *s,
                         const struct fragment_plan *fragment);

/* The same for one of `bands` bands of rows. */
static inline struct raster_plan fgl_raster_band(const struct raster_plan *plan, int band, int bands)
{
    struct raster_plan narrowed = *plan;
    const int top = plan->bounds.y0, height = plan->bounds.y1 - top;
    narrowed.bounds.y0 = top + height * band / bands;
    narrowed.bounds.y1 = top + height * (band + 1) / bands;
    return narrowed;
}

/* A filled triangle in the order that set-up must see; `provoking` is the vertex flat colours come from.
 * Culls by snapped area. Draws nothing when a coordinate is NaN or infinite. */
static inline void fgl_raster_triangle(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                                       const void *provoking)
{
    plan->triangle(plan, v0, v1, v2, provoking);
}

/* The same through glPolygonMode: edges and points as the modes of its face say; `edges` bit i: the edge from
 * v_i to v_(i+1)%3 is a boundary. The line stipple starts anew unless the triangle goes on with the polygon
 * of the one before. OSMesa rule: it does so too after a part of a polygon that is not drawn as lines. */
enum { EDGES_ALL = 7, EDGES_GO_ON = 8 };
static inline void fgl_raster_polygon_mode(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                                           const void *provoking, unsigned edges, int *stipple_counter)
{
    plan->kernels->polygon_mode(plan, v0, v1, v2, provoking, edges, stipple_counter);
}

/* stipple_counter runs along a strip or loop; reset to 0 by the caller where GL says. */
static inline void fgl_raster_line(const struct raster_plan *plan, const void *v0, const void *v1, const void *provoking,
                                   int *stipple_counter)
{
    plan->line(plan, v0, v1, provoking, stipple_counter);
}

static inline void fgl_raster_point(const struct raster_plan *plan, const void *v, float size)
{
    plan->point(plan, v, size);
}

#endif
