/* Coverage: the runs of triangles and lines against the edge rule evaluated at each pixel in 64-bit integers,
 * for every instruction set; shared edges; bounds; coordinates that are no numbers. A recorder stands where
 * fragments would be drawn. */
#include "raster_setup.h"

#include <math.h>

enum { WIDTH = 150, HEIGHT = 130 };

static unsigned char hits[HEIGHT][WIDTH];
static struct rect allowed;

static void record_runs(const struct fragment_plan *plan, const struct planes *planes,
                        const struct runs *runs)
{
    (void)plan;
    (void)planes;
    assert_in_range(runs->n, 1, RUNS_MAX);
    for (int i = 0; i < runs->n; i++)
        for (int x = runs->x0[i]; x < runs->x1[i]; x++) {
            const int y = runs->y + i;
            assert_true(x >= allowed.x0 && x < allowed.x1 && y >= allowed.y0 && y < allowed.y1);
            hits[y][x]++;
        }
}

struct bench {
    struct server_state state;
    struct framebuffer fb;
    struct fragment_plan fragment;
    struct raster_plan raster;
};

static void setup(struct bench *b, enum fgl_isa isa)
{
    state_defaults(&b->state);
    b->fb = (struct framebuffer){.width = WIDTH, .height = HEIGHT, .depth_max = 0xffffff};
    b->fragment = (struct fragment_plan){
            .fill = record_runs, .general = record_runs, .fb = &b->fb, .lanes = LANE_COLOR};
    fgl_raster_validate(&b->raster, &b->state, &b->fragment);
    b->raster.kernels = fgl_raster_kernels_of(isa, ARITH_COMPATIBLE);
    b->raster.triangle = b->raster.kernels->triangle;
    b->raster.lanes = LANE_COLOR;
    b->raster.flat = b->raster.two_sided = false;
    allowed = b->raster.bounds;
    memset(hits, 0, sizeof hits);
}

typedef float vertex[LANE_COLOR];

static void random_vertex(vertex v, float cx, float cy, float size, int grid)
{
    v[LANE_X] = cx + between(-size, size);
    v[LANE_Y] = cy + between(-size, size);
    if (grid) { /* centres and corners of pixels, halves of units: where ties are */
        v[LANE_X] = floorf(v[LANE_X] * (float)grid) / (float)grid;
        v[LANE_Y] = floorf(v[LANE_Y] * (float)grid) / (float)grid;
    }
    v[LANE_Z] = between(0.0f, 1.0f);
    v[LANE_OOW] = 1.0f;
}

/* The rule, as docs/rasterization.md has it. */
static int64_t snapped(float v)
{
    return (int64_t)nearbyint((double)((v - 0.5f) * 256.0f));
}

static bool rule_covers(const vertex tri[3], int column, int row)
{
    int64_t x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = snapped(tri[i][LANE_X]);
        y[i] = snapped(tri[i][LANE_Y]);
    }
    const int64_t area = (x[0] - x[1]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[0] - y[1]);
    for (int i = 0; i < 3; i++) {
        const int p = area > 0 ? i : (i + 1) % 3, q = area > 0 ? (i + 1) % 3 : i;
        const int64_t a = y[p] - y[q], b = x[p] - x[q];
        const int64_t e = a * (x[p] - 256 * (int64_t)column) - b * (y[p] - 256 * (int64_t)row);
        const bool owns = a < 0 || (a == 0 && b < 0);
        if (area == 0 || e + owns <= 0)
            return false;
    }
    return true;
}

static void triangles_follow_the_rule(void **state)
{
    (void)state;
    for (int isa = 0; isa < FGL_ISA_COUNT; isa++) {
        if (!fgl_cpu_has((enum fgl_isa)isa))
            continue;
        random_seed(1);
        for (int round = 0; round < 3000; round++) {
            static struct bench b;
            setup(&b, (enum fgl_isa)isa);
            const float size = round % 4 == 0   ? 3.0f
                               : round % 4 == 1 ? 30.0f
                               : round % 4 == 2 ? 400.0f
                                                : 60000.0f;
            const float cx = between(0, WIDTH), cy = between(0, HEIGHT);
            vertex v[3];
            for (int i = 0; i < 3; i++)
                random_vertex(v[i], cx, cy, size, one_of(3) ? 0 : 1 << one_of(10));
            if (one_of(10) == 0)
                v[2][LANE_Y] = v[1][LANE_Y];
            if (one_of(10) == 0)
                v[2][LANE_X] = v[0][LANE_X];
            if (one_of(8) == 0) {
                allowed = (struct rect){one_of(80), one_of(80), 80 + one_of(WIDTH - 80),
                                        80 + one_of(HEIGHT - 80)};
                b.raster.bounds = allowed;
            }
            fgl_raster_triangle(&b.raster, v[0], v[1], v[2], v[2]);
            for (int y = allowed.y0; y < allowed.y1; y++)
                for (int x = allowed.x0; x < allowed.x1; x++)
                    assert_int_equal(hits[y][x], rule_covers((const vertex *)v, x, y));
        }
    }
}

/* A bent grid: each pixel of its inside once, whatever the windings. */
static void shared_edges_have_no_cracks(void **state)
{
    enum { CELLS = 40 };
    static vertex v[CELLS + 1][CELLS + 1];
    static struct bench b;
    (void)state;
    random_seed(2);
    for (int round = 0; round < 20; round++) {
        setup(&b, fgl_cpu_isa());
        for (int j = 0; j <= CELLS; j++)
            for (int i = 0; i <= CELLS; i++) {
                const bool rim = i == 0 || j == 0 || i == CELLS || j == CELLS;
                random_vertex(v[j][i], 3.6f * (float)i, 3.1f * (float)j, rim ? 0.0f : 1.0f,
                              round % 2 ? 2 : 0);
            }
        for (int j = 0; j < CELLS; j++)
            for (int i = 0; i < CELLS; i++) {
                const bool swap = one_of(2);
                fgl_raster_triangle(&b.raster, v[j][i], v[j][i + 1], v[j + 1][swap ? i : i + 1], v[j][i]);
                fgl_raster_triangle(&b.raster, v[j + 1][i + 1], v[j + 1][i], v[j][swap ? i + 1 : i], v[j][i]);
            }
        for (int y = 0; y < 124; y++)
            for (int x = 0; x < 144; x++)
                assert_int_equal(hits[y][x], 1);
    }
}

static int total_hits(void)
{
    int n = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            n += hits[y][x];
    return n;
}

static void culling_goes_by_orientation(void **state)
{
    static struct bench b;
    (void)state;
    setup(&b, fgl_cpu_isa());
    const vertex v[3] = {
            {10, 10, 0, 1}, {10, 50, 0, 1}, {50, 10, 0, 1}}; /* y down: counter-clockwise as GL sees it */
    for (int culls = 0; culls < 8; culls++) {
        const bool ccw = culls & 1, cull_ccw = culls >> 1 & 1, cull_cw = culls >> 2 & 1;
        b.raster.cull_ccw = cull_ccw;
        b.raster.cull_cw = cull_cw;
        memset(hits, 0, sizeof hits);
        fgl_raster_triangle(&b.raster, v[0], v[ccw ? 1 : 2], v[ccw ? 2 : 1], v[0]);
        assert_int_equal(total_hits() > 0, !(ccw ? cull_ccw : cull_cw));
    }
}

static void no_numbers_draw_nothing(void **state)
{
    static const float odd[] = {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, 3e5f, -3e5f, 3.4e38f};
    static struct bench b;
    int counter = 0;
    (void)state;
    for (int smooth = 0; smooth < 4; smooth++)
        for (size_t k = 0; k < 6 * FGL_COUNTOF(odd); k++) {
            setup(&b, fgl_cpu_isa());
            b.raster.line_smooth = b.raster.point_smooth = smooth & 1;
            b.raster.line_stipple = smooth & 2;
            vertex v[3] = {{10, 10, 0, 1}, {10, 50, 0, 1}, {50, 10, 0, 1}};
            v[k % 6 / 2][k % 2] = odd[k / 6];
            fgl_raster_triangle(&b.raster, v[0], v[1], v[2], v[2]);
            if (k % 6 < 4)
                fgl_raster_line(&b.raster, v[0], v[1], v[1], &counter);
            fgl_raster_point(&b.raster, v[k % 6 / 2], 5.0f);
            assert_int_equal(total_hits(), 0);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(triangles_follow_the_rule),
            cmocka_unit_test(shared_edges_have_no_cracks),
            cmocka_unit_test(culling_goes_by_orientation),
            cmocka_unit_test(no_numbers_draw_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
