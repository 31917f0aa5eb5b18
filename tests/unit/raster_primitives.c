/* Lines, points, stipple, polygon modes and planes: the worked examples of docs/rasterization.md, through the
 * public functions of the rasterizer into a small float framebuffer. Coordinates here have y up, as GL's. */
#include "raster_setup.h"

#include <math.h>

enum { SIZE = 64 };

struct scene {
    struct server_state state;
    struct framebuffer fb;
    struct fragment_plan fragment;
    struct raster_plan raster;
};

typedef float vertex[LANE_TEX0 + 8];

static void scene_start(struct scene *s)
{
    state_defaults(&s->state);
    s->fb = framebuffer_make(SIZE, SIZE, COLOR_FLOAT, 24);
}

static void scene_validate(struct scene *s, enum color_source source)
{
    for (size_t i = 0; i < pixels(&s->fb); i++)
        s->fb.depth[i] = s->fb.depth_max;
    memset(s->fb.color, 0, pixels(&s->fb) * pixel_size(s->fb.color_kind));
    s->fragment.color_source = source;
    fgl_fragment_validate(&s->fragment, &s->state, &s->fb, false);
    fgl_raster_validate(&s->raster, &s->state, &s->fragment);
    s->raster.lanes = s->fragment.lanes;
    s->raster.flat = source == COLOR_FLAT;
    s->raster.two_sided = false;
}

static void scene_end(struct scene *s)
{
    framebuffer_check(&s->fb);
    framebuffer_destroy(&s->fb);
}

/* White, at (x, y) with y up. */
static void place(vertex v, float x, float y)
{
    memset(v, 0, sizeof(vertex));
    v[LANE_X] = x;
    v[LANE_Y] = (float)SIZE - y;
    v[LANE_Z] = 0.5f;
    v[LANE_OOW] = 1.0f;
    for (int c = 0; c < 4; c++)
        v[LANE_COLOR + c] = 1.0f;
}

static const float *pixel(const struct scene *s, int x, int y)
{
    return (const float *)s->fb.color + 4 * ((size_t)(SIZE - 1 - y) * (size_t)s->fb.stride + (size_t)x);
}

static bool drawn(const struct scene *s, int x, int y)
{
    return pixel(s, x, y)[0] != 0.0f;
}

/* Only the pixels of the rectangle, and all of them. */
static void assert_drawn_box(const struct scene *s, int x0, int y0, int x1, int y1)
{
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            assert_int_equal(drawn(s, x, y), x >= x0 && x <= x1 && y >= y0 && y <= y1);
}

static void line(struct scene *s, float x0, float y0, float x1, float y1, int *counter)
{
    vertex a, b;
    place(a, x0, y0);
    place(b, x1, y1);
    fgl_raster_line(&s->raster, a, b, b, counter);
}

static void lines_obey_the_diamond_rule(void **state)
{
    static const struct {
        float ends[4];
        int box[4];
    } cases[] = {
            {{20, 5, 20, 30}, {19, 5, 19, 29}},
            {{5, 20, 30, 20}, {5, 19, 29, 19}},
            {{5.5f, 20.5f, 30.5f, 20.5f}, {5, 20, 29, 20}},
            {{30.5f, 20.5f, 5.5f, 20.5f}, {6, 20, 30, 20}},
            {{20 + 1.0f / 512, 5, 20 + 1.0f / 512, 30}, {20, 5, 20, 29}},
    };
    static struct scene s;
    int counter = 0;
    (void)state;
    scene_start(&s);
    for (size_t i = 0; i < FGL_COUNTOF(cases); i++) {
        const float *e = cases[i].ends;
        const int *b = cases[i].box;
        scene_validate(&s, COLOR_SMOOTH);
        line(&s, e[0], e[1], e[2], e[3], &counter);
        assert_drawn_box(&s, b[0], b[1], b[2], b[3]);
    }
    scene_validate(&s, COLOR_SMOOTH);
    line(&s, 10.25f, 10.25f, 10.25f, 10.25f, &counter);
    assert_drawn_box(&s, 0, 0, -1, -1);
    scene_end(&s);
}

static void wide_lines_widen_across(void **state)
{
    static struct scene s;
    int counter = 0;
    (void)state;
    scene_start(&s);
    s.state.line.line_width = 4.4f;
    scene_validate(&s, COLOR_SMOOTH);
    line(&s, 5.5f, 20.5f, 30.5f, 20.5f, &counter);
    int rows = 0;
    for (int y = 0; y < SIZE; y++)
        rows += drawn(&s, 15, y);
    assert_int_equal(rows, 4);
    scene_end(&s);
}

static void stipple_counts_along_a_strip(void **state)
{
    static struct scene s;
    int counter = 0;
    (void)state;
    scene_start(&s);
    s.state.line.line_stipple = true;
    s.state.line.line_stipple_pattern = 0x0f0f;
    scene_validate(&s, COLOR_SMOOTH);
    line(&s, 2.5f, 20.5f, 20.5f, 20.5f, &counter);
    line(&s, 20.5f, 20.5f, 40.5f, 20.5f, &counter);
    assert_int_equal(counter, 38);
    for (int x = 0; x < SIZE; x++)
        assert_int_equal(drawn(&s, x, 20), x >= 2 && x < 40 && ((x - 2) & 7) < 4);
    scene_end(&s);
}

static void points_are_squares(void **state)
{
    static const struct {
        float x, y, size;
        int box[4];
    } cases[] = {
            {20, 20, 1, {20, 20, 20, 20}},          {20.5f, 20.5f, 1, {20, 20, 20, 20}},
            {20.5f, 20.5f, 2, {20, 20, 21, 21}},    {20.5f, 20.5f, 3, {19, 19, 21, 21}},
            {20.5f, 20.5f, 2.5f, {20, 20, 21, 21}}, {1, 1, 9, {0, 0, 5, 5}},
    };
    static struct scene s;
    (void)state;
    scene_start(&s);
    for (size_t i = 0; i < FGL_COUNTOF(cases); i++) {
        vertex v;
        place(v, cases[i].x, cases[i].y);
        scene_validate(&s, COLOR_SMOOTH);
        fgl_raster_point(&s.raster, v, cases[i].size);
        assert_drawn_box(&s, cases[i].box[0], cases[i].box[1], cases[i].box[2], cases[i].box[3]);
    }
    scene_end(&s);
}

/* OSMesa rule: a disc without a soft edge, whose alpha rises towards the centre. */
static void smooth_points_are_discs(void **state)
{
    static const double row[] = {1,     1,     1.714, 2.143,
                                 2.286, 2.143, 1.714, 1}; /* (1 - d^2) / (1 - (3/4)^2) inside, d in radii */
    static struct scene s;
    vertex v;
    (void)state;
    scene_start(&s);
    s.state.point.point_smooth = true;
    scene_validate(&s, COLOR_SMOOTH);
    place(v, 20.5f, 20.5f);
    fgl_raster_point(&s.raster, v, 8.0f);
    for (int i = 0; i < 8; i++)
        assert_true(fabs((double)pixel(&s, 16 + i, 20)[3] - row[i]) < 0.001);
    assert_false(drawn(&s, 17, 17)); /* within the square, outside of the disc */
    scene_end(&s);
}

static void rectangle(struct scene *s, float x0, float y0, float x1, float y1, bool as_mode)
{
    int counter = 0;
    vertex v[4];
    place(v[0], x0, y0);
    place(v[1], x1, y0);
    place(v[2], x1, y1);
    place(v[3], x0, y1);
    if (as_mode) {
        fgl_raster_polygon_mode(&s->raster, v[0], v[1], v[2], v[2], 3, &counter);
        fgl_raster_polygon_mode(&s->raster, v[0], v[2], v[3], v[3], 6, &counter);
    } else {
        fgl_raster_triangle(&s->raster, v[0], v[1], v[2], v[2]);
        fgl_raster_triangle(&s->raster, v[0], v[2], v[3], v[3]);
    }
}

static void pixel_centres_belong_to_left_and_bottom(void **state)
{
    static struct scene s;
    (void)state;
    scene_start(&s);
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f, 10.5f, 20.5f, 20.5f, false);
    assert_drawn_box(&s, 10, 10, 19, 19);
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f + 1.0f / 512, 10.5f, 20.5f + 1.0f / 512, 20.5f, false); /* ties to even */
    assert_drawn_box(&s, 10, 10, 19, 19);
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f + 3.0f / 512, 10.5f, 20.5f + 3.0f / 512, 20.5f, false);
    assert_drawn_box(&s, 11, 10, 20, 19);
    scene_end(&s);
}

static int count_drawn(const struct scene *s)
{
    int n = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            n += drawn(s, x, y);
    return n;
}

static void polygon_modes_draw_edges_and_corners(void **state)
{
    static struct scene s;
    (void)state;
    scene_start(&s);
    s.state.polygon.polygon_mode[0] = GL_LINE;
    s.state.polygon.polygon_mode[1] = GL_POINT;
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f, 10.5f, 20.5f, 20.5f, true);
    assert_int_equal(count_drawn(&s), 40); /* no diagonal */
    assert_false(drawn(&s, 15, 15));
    s.state.polygon.front_face = GL_CW;
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f, 10.5f, 20.5f, 20.5f, true);
    assert_int_equal(count_drawn(&s), 4);
    s.state.polygon.cull_face = true;
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 10.5f, 10.5f, 20.5f, 20.5f, true);
    assert_int_equal(count_drawn(&s), 0);
    scene_end(&s);
}

static void polygon_stipple_starts_at_the_lower_left(void **state)
{
    static struct scene s;
    (void)state;
    scene_start(&s);
    s.state.polygon.polygon_stipple = true;
    random_seed(3);
    for (int i = 0; i < 32; i++)
        s.state.polygon_stipple.row[i] = random_bits();
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 0, 0, SIZE, SIZE, false);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            assert_int_equal(drawn(&s, x, y), s.state.polygon_stipple.row[y % 32] >> (31 - x % 32) & 1);
    scene_end(&s);
}

/* The planes at a pixel, transcribed: set-up on unsnapped coordinates, counter-clockwise order, attributes
 * over w. */
static float attribute_at(const vertex v[3], int lane, bool perspective, int x, int y)
{
    const float area = (v[0][0] - v[1][0]) * (v[2][1] - v[0][1]) - (v[2][0] - v[0][0]) * (v[0][1] - v[1][1]);
    const float *const a = v[area > 0.0f ? 0 : 1], *const b = v[area > 0.0f ? 1 : 0], *const c = v[2];
    const float x01 = a[0] - b[0], y01 = a[1] - b[1], x20 = c[0] - a[0], y20 = c[1] - a[1];
    const float ooa = 1.0f / (x01 * y20 - y01 * x20);
    const float a0 = a[lane] * (perspective ? a[LANE_OOW] : 1.0f),
                a1 = b[lane] * (perspective ? b[LANE_OOW] : 1.0f),
                a2 = c[lane] * (perspective ? c[LANE_OOW] : 1.0f);
    const float d01 = a0 - a1, d20 = a2 - a0;
    const float dx = d01 * (y20 * ooa) - d20 * (y01 * ooa), dy = d20 * (x01 * ooa) - d01 * (x20 * ooa);
    const float origin = a0 - (dx * (a[0] - 0.5f) + dy * (a[1] - 0.5f));
    return fmaf(dy, (float)y, fmaf(dx, (float)x, origin));
}

static void planes_follow_the_rule(void **state)
{
    static struct scene s;
    (void)state;
    random_seed(4);
    scene_start(&s);
    for (int round = 0; round < 200; round++) {
        vertex v[3];
        s.state.depth.depth_test = true;
        scene_validate(&s, round % 2 ? COLOR_FLAT : COLOR_SMOOTH);
        s.raster.two_sided = round % 3 == 0;
        s.raster.back_lane = LANE_TEX0;
        for (int i = 0; i < 3; i++) {
            place(v[i], between(0, SIZE), between(0, SIZE));
            v[i][LANE_Z] = between(0.1f, 0.9f);
            v[i][LANE_OOW] = between(0.1f, 3.0f);
            for (int c = 0; c < 4; c++) {
                v[i][LANE_COLOR + c] = between(0.1f, 0.9f);
                v[i][LANE_TEX0 + c] = between(0.1f, 0.9f);
            }
        }
        const float area =
                (v[0][0] - v[1][0]) * (v[2][1] - v[0][1]) - (v[2][0] - v[0][0]) * (v[0][1] - v[1][1]);
        const int lane = s.raster.two_sided && area < 0.0f ? LANE_TEX0 : LANE_COLOR;
        fgl_raster_triangle(&s.raster, v[0], v[1], v[2], v[1]);
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++) {
                const float *p = (const float *)s.fb.color + 4 * (y * s.fb.stride + x);
                if (p[0] == 0.0f)
                    continue;
                const float w = 1.0f / attribute_at((const vertex *)v, LANE_OOW, false, x, y);
                for (int c = 0; c < 4; c++)
                    assert_true(same_float(
                            p[c], round % 2 ? v[1][lane + c]
                                            : attribute_at((const vertex *)v, lane + c, true, x, y) * w));
                const float z = attribute_at((const vertex *)v, LANE_Z, false, x, y);
                assert_int_equal(s.fb.depth[y * s.fb.stride + x], (uint32_t)nearbyintf(z * 16777215.0f));
            }
    }
    scene_end(&s);
}

/* One unit of polygon offset is two steps of the depth buffer; the factor multiplies the steeper slope. */
static void polygon_offset_moves_depth(void **state)
{
    static struct scene s;
    (void)state;
    scene_start(&s);
    s.state.depth.depth_test = true;
    s.state.polygon.polygon_offset_fill = true;
    s.state.polygon.polygon_offset_units = -3.0f;
    s.state.polygon.polygon_offset_factor = 5.0f; /* level: no effect */
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 0, 0, SIZE, SIZE, false);
    assert_in_range(s.fb.depth[5 * s.fb.stride + 5], 8388608 - 7, 8388608 - 5);
    scene_end(&s);
}

/* Departure from OSMesa, which offsets filled polygons while any of the three is enabled. */
static void polygon_offset_is_enabled_for_each_mode(void **state)
{
    static struct scene s;
    (void)state;
    scene_start(&s);
    s.state.depth.depth_test = true;
    s.state.polygon.polygon_offset_line = s.state.polygon.polygon_offset_point = true;
    s.state.polygon.polygon_offset_units = -100.0f;
    scene_validate(&s, COLOR_SMOOTH);
    rectangle(&s, 0, 0, SIZE, SIZE, false);
    assert_in_range(s.fb.depth[5 * s.fb.stride + 5], 8388607, 8388608);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(lines_obey_the_diamond_rule),
            cmocka_unit_test(wide_lines_widen_across),
            cmocka_unit_test(stipple_counts_along_a_strip),
            cmocka_unit_test(points_are_squares),
            cmocka_unit_test(smooth_points_are_discs),
            cmocka_unit_test(pixel_centres_belong_to_left_and_bottom),
            cmocka_unit_test(polygon_modes_draw_edges_and_corners),
            cmocka_unit_test(polygon_stipple_starts_at_the_lower_left),
            cmocka_unit_test(planes_follow_the_rule),
            cmocka_unit_test(polygon_offset_moves_depth),
            cmocka_unit_test(polygon_offset_is_enabled_for_each_mode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
