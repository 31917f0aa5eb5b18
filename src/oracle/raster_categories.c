/* Triangles and meshes, each kind a category. */
#include <math.h>
#include <stdlib.h>

#include "oracle/raster_measure.h"

static const float pixel = 2.0f / ORACLE_WINDOW; /* in device coordinates */

/* Device coordinates and w to clip coordinates. */
static void place(struct raster_vertex *v, float x, float y, float z, float w)
{
    v->clip[0] = x * w;
    v->clip[1] = y * w;
    v->clip[2] = z * w;
    v->clip[3] = w;
}

static void color_at_random(struct random *r, struct raster_triangle *t)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            t->vertex[i].color[k] = random_between(r, 0, 1);
        t->vertex[i].color[3] = 1;
    }
}

static void within(struct random *r, struct raster_triangle *t, float radius, float most_w, float most_z)
{
    const float reach = 1 - radius, x = random_between(r, -reach, reach),
                y = random_between(r, -reach, reach);
    color_at_random(r, t);
    for (int i = 0; i < 3; i++)
        place(&t->vertex[i], x + random_between(r, -radius, radius), y + random_between(r, -radius, radius),
              random_between(r, -most_z, most_z), random_magnitude(r, 1 / most_w, most_w));
}

static void ordinary(struct random *r, struct raster_triangle *t)
{
    within(r, t, 1, 1, 1);
}

static void in_perspective(struct random *r, struct raster_triangle *t)
{
    within(r, t, 1, 2, 1);
}

static void in_strong_perspective(struct random *r, struct raster_triangle *t)
{
    within(r, t, 1, 31.6f, 1); /* ratios of w from 1e-3 to 1e3 */
}

static void small(struct random *r, struct raster_triangle *t)
{
    within(r, t, 3 * pixel, 2, 1);
}

static void tiny(struct random *r, struct raster_triangle *t)
{
    within(r, t, 0.7f * pixel, 2, 1);
}

/* The third corner is near the line through the others: 1/4 to 1/512 of a pixel. */
static void sliver(struct random *r, struct raster_triangle *t)
{
    const float along = random_between(r, 0, 1), off = pixel * random_magnitude(r, 1.0f / 512, 0.25f);
    float p[2][2];
    color_at_random(r, t);
    for (int i = 0; i < 2; i++) {
        p[i][0] = random_between(r, -0.95f, 0.95f);
        p[i][1] = random_between(r, -0.95f, 0.95f);
        place(&t->vertex[i], p[i][0], p[i][1], random_between(r, -1, 1), random_magnitude(r, 0.5f, 2));
    }
    const float dx = p[1][0] - p[0][0], dy = p[1][1] - p[0][1], length = sqrtf(dx * dx + dy * dy) + 1e-6f;
    place(&t->vertex[2], p[0][0] + along * dx - off * dy / length, p[0][1] + along * dy + off * dx / length,
          random_between(r, -1, 1), 1);
}

/* Corners at multiples of half a pixel: many edges go through centers. */
static void on_centers(struct random *r, struct raster_triangle *t)
{
    color_at_random(r, t);
    for (int i = 0; i < 3; i++)
        place(&t->vertex[i], (float)(random_below(r, 2 * ORACLE_WINDOW + 1) - ORACLE_WINDOW) * pixel / 2,
              (float)(random_below(r, 2 * ORACLE_WINDOW + 1) - ORACLE_WINDOW) * pixel / 2,
              random_between(r, -1, 1), random_below(r, 2) ? 1 : 4);
}

/* Corners half way between multiples of 1/256 of a pixel, around the corners of pixels. */
static void on_ties(struct random *r, struct raster_triangle *t)
{
    color_at_random(r, t);
    for (int i = 0; i < 3; i++) {
        float p[2];
        for (int k = 0; k < 2; k++)
            p[k] = (float)(random_below(r, ORACLE_WINDOW - 2) + 1 - ORACLE_WINDOW / 2) * pixel +
                   (float)(2 * random_below(r, 8) - 7) * pixel / 512;
        place(&t->vertex[i], p[0], p[1], random_between(r, -1, 1), 1);
    }
}

static void steep(struct random *r, struct raster_triangle *t)
{
    within(r, t, 8 * pixel, 1, 1);
    for (int i = 0; i < 3; i++)
        t->vertex[i].clip[2] = i == 1 ? -1.0f : 1.0f;
}

static void beyond_sides(struct random *r, struct raster_triangle *t)
{
    ordinary(r, t);
    for (int i = 0; i < 3; i++)
        place(&t->vertex[i], random_between(r, -4, 4), random_between(r, -4, 4), random_between(r, -1, 1),
              random_magnitude(r, 0.5f, 2));
}

static void beyond_near_and_far(struct random *r, struct raster_triangle *t)
{
    within(r, t, 1, 2, 3);
}

static void huge(struct random *r, struct raster_triangle *t)
{
    ordinary(r, t);
    for (int i = 0; i < 3; i++) {
        const float size = random_magnitude(r, 10, 1e6f);
        place(&t->vertex[i], random_between(r, -size, size), random_between(r, -size, size),
              random_between(r, -1, 1), 1);
    }
}

static void behind_viewer(struct random *r, struct raster_triangle *t)
{
    within(r, t, 1, 2, 1);
    t->vertex[random_below(r, 3)].clip[3] = -random_magnitude(r, 0.5f, 2);
}

/* ---- meshes ---- */

static int ascending(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Device coordinates of the lines between columns; in meshes of many they are very near to one another, so
 * they stay straight: rounding must not fold the mesh. */
static void divide(struct random *r, float *at, int parts, bool thin)
{
    for (int i = 0; i <= parts; i++)
        at[i] = thin ? random_between(r, -1, 1) : -1 + 2 * (float)i / (float)parts;
    at[0] = -1, at[parts] = 1;
    qsort(at, (size_t)parts + 1, sizeof at[0], ascending);
}

int raster_mesh(const struct raster_category *category, struct random *r, struct raster_triangle *triangle)
{
    enum { MOST = 128, ROWS = 12 };
    static struct raster_vertex point[MOST + 1][ROWS + 1];
    float x[MOST + 1], y[ROWS + 1];
    const int columns = category->columns;
    const bool thin = columns > 20;
    int count = 0;
    divide(r, x, columns, thin);
    divide(r, y, ROWS, false);
    for (int i = 0; i <= columns; i++)
        for (int j = 0; j <= ROWS; j++) {
            const float dx =
                    thin || i == 0 || i == columns ? 0 : random_between(r, -0.4f, 0.4f) / (float)columns;
            const float dy = j == 0 || j == ROWS ? 0 : random_between(r, -0.4f, 0.4f) / ROWS;
            place(&point[i][j], x[i] + dx, y[j] + dy, 0,
                  category->perspective ? random_magnitude(r, 0.1f, 10) : 1);
        }
    for (int i = 0; i < columns; i++)
        for (int j = 0; j < ROWS; j++) {
            const struct raster_vertex *a = &point[i][j], *b = &point[i + 1][j], *c = &point[i + 1][j + 1],
                                       *d = &point[i][j + 1];
            const bool other = random_below(r, 2);
            triangle[count++] = (struct raster_triangle){{*a, *b, other ? *d : *c}};
            triangle[count++] = (struct raster_triangle){{other ? *b : *a, *c, *d}};
        }
    return count;
}

const struct raster_category raster_categories[] = {
        {"triangles", RASTER_TRIANGLES, ordinary, 1, 0, false},
        {"triangles in perspective", RASTER_TRIANGLES, in_perspective, 1, 0, false},
        {"ratios of w to 1e3", RASTER_TRIANGLES, in_strong_perspective, 1, 0, false},
        {"triangles of some pixels", RASTER_TRIANGLES, small, 20, 0, false},
        {"triangles below a pixel", RASTER_TRIANGLES, tiny, 20, 0, false},
        {"slivers", RASTER_TRIANGLES, sliver, 20, 0, false},
        {"corners on pixel centers", RASTER_TRIANGLES, on_centers, 1, 0, false},
        {"corners half way between 1/256 pixels", RASTER_TRIANGLES, on_ties, 1, 0, false},
        {"steep in depth", RASTER_TRIANGLES, steep, 20, 0, false},
        {"clipped at the sides", RASTER_TRIANGLES, beyond_sides, 1, 0, false},
        {"clipped at near and far plane", RASTER_TRIANGLES, beyond_near_and_far, 1, 0, false},
        {"clipped and huge", RASTER_TRIANGLES, huge, 1, 0, false},
        {"a corner behind the viewer", RASTER_TRIANGLES, behind_viewer, 1, 0, false},
        {"shared edges", RASTER_MESH, NULL, 1, 12, false},
        {"shared edges in perspective", RASTER_MESH, NULL, 1, 12, true},
        {"shared edges of slivers", RASTER_MESH, NULL, 1, 128, false},
};

const int raster_category_count = (int)(sizeof raster_categories / sizeof raster_categories[0]);
