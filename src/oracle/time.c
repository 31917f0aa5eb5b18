/* What a vertex costs. */
#include "oracle/scene.h"

#include <float.h>
#include <math.h>
#include <string.h>
#include <time.h>

enum { COPIES = 64, ROUNDS = 40 };

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* As a strip of lines. Nothing of the position is kept but w: they have no length, and cost next to nothing after
 * the vertex stage. */
double oracle_time_strip(const struct oracle_scene *scene)
{
    static struct oracle_vertex vertices[COPIES * ORACLE_VERTICES];
    for (int i = 0; i < COPIES; i++)
        memcpy(vertices + i * scene->count, scene->vertex, (size_t)scene->count * sizeof vertices[0]);
    const float keep_w[16] = {[15] = scene->vertex[0].position[3] < 0 ? -1.0f : 1.0f};
    oracle_set_state(&scene->state);
    oracle_set_arrays(vertices, scene->state.color_material_face != 0);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(keep_w);
    glViewport(0, 0, 1, 1);
    double least = DBL_MAX;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now_ns();
        glDrawArrays(GL_LINE_STRIP, 0, COPIES * scene->count);
        glFinish();
        least = fmin(least, now_ns() - start);
    }
    return least / (COPIES * scene->count);
}

double oracle_time_renderer(const struct oracle_scene *scene, oracle_renderer *render)
{
    float rgba[ORACLE_VERTICES][4];
    double least = DBL_MAX;
    for (int round = 0; round < ROUNDS / 8; round++) {
        const double start = now_ns();
        for (int i = 0; i < COPIES; i++)
            render(scene, rgba);
        least = fmin(least, now_ns() - start);
    }
    return least / (COPIES * scene->count);
}
