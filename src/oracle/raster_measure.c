#include "oracle/raster_measure.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <GL/osmesa.h>

enum { SIZE = ORACLE_WINDOW, DEPTHS = (1 << 24) - 1 };

static OSMesaContext context;
static float pixels[SIZE][SIZE][4]; /* lower left first */

bool raster_open(void)
{
    context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    if (context == NULL || !OSMesaMakeCurrent(context, pixels, GL_FLOAT, SIZE, SIZE))
        return false;
    glViewport(0, 0, SIZE, SIZE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnableClientState(GL_VERTEX_ARRAY);
    return true;
}

void raster_close(void)
{
    OSMesaDestroyContext(context);
    context = NULL;
}

static void draw(const struct raster_triangle *triangles, int count)
{
    const GLsizei stride = (GLsizei)sizeof(struct raster_vertex);
    glVertexPointer(4, GL_FLOAT, stride, triangles->vertex[0].clip);
    glColorPointer(4, GL_FLOAT, stride, triangles->vertex[0].color);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3 * count);
    glFinish();
}

/* ---- summaries ---- */

struct samples {
    float *error;
    long count, room;
};

static void add(struct samples *samples, double error)
{
    if (samples->count == samples->room) {
        samples->room = 2 * samples->room + 4096;
        samples->error = realloc(samples->error, (size_t)samples->room * sizeof(float));
        if (samples->error == NULL)
            abort();
    }
    samples->error[samples->count++] = (float)error;
}

static int ascending(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Frees the samples. */
static struct error_summary summarize(struct samples *samples)
{
    struct error_summary result = {.count = samples->count};
    if (samples->count > 0) {
        qsort(samples->error, (size_t)samples->count, sizeof(float), ascending);
        result.max = (double)samples->error[samples->count - 1];
        result.p999 = (double)samples->error[(samples->count - 1) * 999 / 1000];
        for (long i = 0; i < samples->count; i++)
            result.mean += (double)samples->error[i] / (double)samples->count;
    }
    free(samples->error);
    return result;
}

/* ---- triangles ---- */

struct tally {
    struct raster_error error;
    struct samples color, depth;
};

static int to_byte(double x)
{
    return (int)floor(x * 255 + 0.5);
}

static void compare_pixel(struct tally *tally, const struct raster_truth *truth, const float drawn[4],
                          uint32_t depth)
{
    for (int k = 0; k < 3; k++) {
        if (!isfinite(drawn[k])) {
            tally->error.invalid++;
            continue;
        }
        const double value = fmin(fmax((double)drawn[k], 0), 1), exact = (double)truth->color[k];
        add(&tally->color, fabs((double)((quad)value - truth->color[k])));
        tally->error.wrong_bytes += to_byte(value) != to_byte(exact) && drawn[k] != (float)exact;
    }
    add(&tally->depth, fabs((double)((quad)depth - truth->depth * DEPTHS)));
    tally->error.pixels++;
}

static void count_wrong(struct raster_error *error, enum raster_coverage loose)
{
    if (loose == RASTER_UNDECIDED)
        error->other_corners++;
    else
        error->wrong_coverage++;
}

static void compare_triangle(struct tally *tally, const struct raster_triangle *triangle)
{
    GLint width, height, bytes;
    void *depths;
    struct raster_setup setup;
    oracle_raster_setup(triangle, &setup);
    draw(triangle, 1);
    OSMesaGetDepthBuffer(context, &width, &height, &bytes, &depths);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const bool drawn = pixels[y][x][3] != 0;
            const enum raster_coverage coverage = oracle_raster_coverage(&setup, x, y);
            if (coverage != RASTER_UNDECIDED && drawn != (coverage == RASTER_INSIDE))
                count_wrong(&tally->error, oracle_raster_loose_coverage(&setup, x, y));
            if (!drawn || coverage != RASTER_INSIDE || setup.flat)
                continue;
            const struct raster_truth truth = oracle_raster_truth(&setup, x, y);
            compare_pixel(tally, &truth, pixels[y][x], ((const uint32_t *)depths)[y * SIZE + x] & DEPTHS);
        }
}

/* ---- meshes ---- */

/* Each hit adds this. */
static const float hit = 1.0f / 64;

static void count_hits(struct tally *tally, const struct raster_triangle *triangle, int count)
{
    glDisableClientState(GL_COLOR_ARRAY);
    glColor4f(hit, hit, hit, hit);
    glEnable(GL_BLEND);
    draw(triangle, count);
    glDisable(GL_BLEND);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            tally->error.wrong_coverage += pixels[y][x][0] != hit;
    tally->error.pixels += SIZE * SIZE;
}

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static double time_triangles(const struct raster_triangle *triangle, int count)
{
    double least = DBL_MAX;
    for (int round = 0; round < 5; round++) {
        const double start = now_ns();
        draw(triangle, count);
        least = fmin(least, now_ns() - start);
    }
    return least / count;
}

struct raster_error raster_measure(int number, uint64_t seed, int triangles)
{
    const struct raster_category *category = &raster_categories[number];
    const bool mesh = category->kind == RASTER_MESH;
    const int count = triangles * category->times;
    const int most = mesh ? RASTER_MESH_MOST : count;
    struct raster_triangle *triangle = calloc((size_t)most, sizeof *triangle);
    struct tally tally = {.color = {NULL, 0, 0}};
    if (triangle == NULL)
        abort();
    glEnableClientState(GL_COLOR_ARRAY);
    int drawn = 0;
    for (int i = 0; i < (mesh ? (count + 9) / 10 : count); i++) {
        struct random random = random_stream(seed, (uint64_t)(number + 100000) << 32 | (uint64_t)i);
        if (mesh) {
            drawn = raster_mesh(category, &random, triangle);
            count_hits(&tally, triangle, drawn);
        } else {
            category->generate(&random, &triangle[i]);
            compare_triangle(&tally, &triangle[i]);
            drawn = i + 1;
        }
    }
    tally.error.ns = time_triangles(triangle, drawn);
    tally.error.color = summarize(&tally.color);
    tally.error.depth = summarize(&tally.depth);
    free(triangle);
    return tally.error;
}
