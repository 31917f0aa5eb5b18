/* What the oracle tests of single triangles share: a window of floats, vertices at random, what is drawn of them. */
#ifndef TESTS_ORACLE_DRAWING_H
#define TESTS_ORACLE_DRAWING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include "fixedgl.h"
#include "oracle/random.h"
#include "oracle/raster.h"

enum { WINDOW = ORACLE_WINDOW };

static OSMesaContext window_context;
static float window[WINDOW][WINDOW][4]; /* lower left first */

static int open_window(void **state)
{
    (void)state;
    unsetenv("FIXEDGL_ACCURACY"); /* the tests choose */
    window_context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    if (window_context == NULL || !OSMesaMakeCurrent(window_context, window, GL_FLOAT, WINDOW, WINDOW))
        return -1;
    glClearColor(0, 0, 0, 0.5f); /* no triangle has this alpha */
    return 0;
}

static int close_window(void **state)
{
    (void)state;
    OSMesaDestroyContext(window_context);
    return 0;
}

/* FIXEDGL_SEED and FIXEDGL_TRIANGLES, or what is given. */
static uint64_t seed_of(uint64_t otherwise)
{
    const char *given = getenv("FIXEDGL_SEED");
    return given != NULL ? strtoull(given, NULL, 0) : otherwise;
}

static int triangles_of(int otherwise)
{
    const char *given = getenv("FIXEDGL_TRIANGLES");
    return given != NULL && atoi(given) > 0 ? atoi(given) : otherwise;
}

/* A triangle anywhere in the view volume, w of its vertices from 1 / most_w to most_w. */
static void random_triangle(struct random *r, struct raster_triangle *t, float most_w)
{
    memset(t, 0, sizeof *t);
    for (int i = 0; i < 3; i++) {
        float *clip = t->vertex[i].clip;
        clip[3] = random_magnitude(r, 1 / most_w, most_w);
        for (int k = 0; k < 3; k++)
            clip[k] = random_between(r, -1, 1) * clip[3];
    }
}

/* Whether the pixel was drawn and is the triangle's beyond doubt. */
static bool is_drawn(const struct raster_setup *setup, int x, int y)
{
    return window[y][x][3] != 0.5f && !setup->flat && oracle_raster_coverage(setup, x, y) == RASTER_INSIDE;
}

/* GL 1.5, 3.5.1, equation 3.6, of a value of each vertex. */
static quad interpolate(const quad weight[3], const quad value[3])
{
    return (weight[0] * value[0] + weight[1] * value[1] + weight[2] * value[2]) / (weight[0] + weight[1] + weight[2]);
}

#endif
