/* The errors of a renderer in triangles of one kind. */
#ifndef ORACLE_RASTER_MEASURE_H
#define ORACLE_RASTER_MEASURE_H

#include "oracle/raster.h"
#include "oracle/random.h"

/* Errors over values in [0,1], of which renderers compute many. */
struct error_summary {
    long count;
    double max, mean, p999;
};

struct raster_error {
    long pixels;         /* colored and compared */
    long wrong_coverage; /* colored and should not be, or the reverse; of meshes: not colored exactly once */
    long other_corners;  /* the same, nearer to an edge than 1/128 of a pixel: a corner was rounded otherwise
                          */
    struct error_summary color; /* after clamping to [0,1] */
    struct error_summary depth; /* in units of 2^-24 */
    long wrong_bytes;           /* colors that differ from the truth when both are rounded to 8 bits */
    long invalid;               /* NaN or infinite */
    double ns;                  /* per triangle */
};

enum raster_kind { RASTER_TRIANGLES, RASTER_MESH };

struct raster_category {
    const char *name;
    enum raster_kind kind;
    void (*generate)(struct random *random, struct raster_triangle *triangle); /* NULL for meshes */
    int times;        /* so many times as many triangles, where each has few pixels */
    int columns;      /* of a mesh; thin ones if there are more than 20 */
    bool perspective; /* of a mesh */
};

extern const struct raster_category raster_categories[];
extern const int raster_category_count;

enum { RASTER_MESH_MOST = 4096 }; /* triangles */

/* A mesh that covers the whole window: every pixel lies in one triangle. Returns the number of triangles. */
int raster_mesh(const struct raster_category *category, struct random *random,
                struct raster_triangle *triangle);

/* Makes a context for raster_measure current: false if that fails. */
bool raster_open(void);
void raster_close(void);

/* Draws so many triangles, or a tenth as many meshes, and compares. Triangle number i of a category is the
 * same for the same seed. */
struct raster_error raster_measure(int category, uint64_t seed, int count);

#endif
