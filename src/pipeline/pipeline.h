/* The plan and the work space of a context's pipeline. Layer 4.
 * validate.c is the only reader of raw state that chooses functions; draw.c only runs what was chosen. */
#ifndef FGL_PIPELINE_PIPELINE_H
#define FGL_PIPELINE_PIPELINE_H

#include "fragment/fragment.h"
#include "base/workers.h"
#include "pipeline/draw.h"
#include "pipeline/feedback.h"
#include "pipeline/triangles.h"
#include "raster/raster.h"
#include "vertex/emit.h"
#include "vertex/vertex.h"

/* Everything that a draw needs to know, made from the state once for each change of it. */
struct plan {
    struct vertex_plan vertex;
    struct emit_plan emit;
    struct raster_plan raster;
    struct fragment_plan fragment;
    struct feedback_plan feedback;
    const struct clip_kernels *clip;
    uint32_t fetch;       /* attributes that some stage reads */
    uint32_t varying;     /* attributes that were arrays when the plan was made */
    bool polygon_fill;    /* both faces filled: no edge flags, no lines or points from triangles */
    bool decomposed;      /* OSMesa's longer road splits quads, even where nothing is clipped */
    bool seen_first;      /* colours wait until it is known which triangles are seen (shade.c) */
    bool rasterize;       /* false: nothing can reach the framebuffer */
};

/* Vertices after the vertex stage, for primitive assembly. */
struct vertex_cache {
    int capacity;     /* vertices */
    int used;         /* vertices of this draw */
    bool range_unknown; /* of elements: see struct vertex_source */
    size_t record_bytes, clip_bytes; /* that there is room for in each of them */
    unsigned char *record; /* raster vertices, plan.emit.record_bytes each */
    unsigned char *clip;   /* clip vertices, plan.emit.clip_bytes each; written where a batch has any outcode */
    uint32_t *outcode;
    struct snapped *snapped; /* written when polygons are filled */
    float *edge_flag; /* written when polygons are not filled */
    struct shading *chunk; /* shade.c: of each VERTEX_CHUNK vertices; written when shading waits */
    int chunks;            /* for which there is room */
};

/* Vertex v of the cache. */
static inline const void *fgl_cache_record(const struct vertex_cache *c, const struct emit_plan *emit, uint32_t v)
{
    return c->record + v * emit->record_bytes;
}
static inline const void *fgl_cache_clip(const struct vertex_cache *c, const struct emit_plan *emit, uint32_t v)
{
    return c->clip + v * emit->clip_bytes;
}

/* A point, line or triangle: its vertices' numbers in the cache, the provoking one last. */
struct primitive {
    int n;
    uint32_t vertex[3];
};

struct explain;
struct plan_report;

/* The vertices of a draw: first .. first+n of the source, to the cache's 0..n. */
struct vertex_job {
    struct pipeline *p;
    const struct vertex_source *source;
    uint32_t first;
    int n;
};

struct pipeline {
    struct plan plan;
    bool general;    /* FIXEDGL_PATH=general */
    bool print_plan; /* FIXEDGL_DEBUG=plan */
    struct vertex_cache cache;
    struct triangle_list triangles;
    const struct vertex_job *unshaded; /* the draw whose vertices have positions alone; else NULL */
    struct plan_report *report; /* plan_report.h; NULL: none is wanted */
    struct explain *explain;    /* explain.h; NULL: no pixel is being explained */
    struct primitive primitive; /* what is being assembled, for explain */
    bool one_by_one;            /* each is noted there before it is drawn */
    struct workers *workers; /* started by the first large draw */
    struct vertex_batch *batch[FGL_MAX_WORKERS]; /* each worker's, allocated when first used */
    int stipple_counter; /* of line stipple: of the line or polygon that was drawn last */
    uint32_t *elements; /* work space of glDrawElements */
    int elements_capacity;
};

/* NULL when memory is short. */
struct pipeline *fgl_pipeline_create(void);
void fgl_pipeline_destroy(struct pipeline *p);

/* The workers, started now if they were not; NULL when memory is short. */
struct workers *fgl_pipeline_workers(struct pipeline *p);

/* The bands of rows that a job is split into, 1 where it is not worth waking other threads; more of them are run by p->workers. */
int fgl_pipeline_bands(struct pipeline *p, int rows, bool worth);
enum { SHARED_AREA = 1 << 16 }; /* pixels; fewer are not worth it */

/* How many workers a job on batches is given: all of them when it is worth their waking, which costs microseconds, else one; 0 when
 * memory is short. */
int fgl_pipeline_share(struct pipeline *p, bool worth);

/* Brings the plan up to date with the state, for draws whose attributes in `varying` are arrays. */
void fgl_pipeline_validate(struct context *ctx, uint32_t varying);

/* Prints the plan on stderr (FIXEDGL_DEBUG=plan). */
void fgl_plan_print(const struct plan *plan);

/* fetch.c: vertices first .. first+n of the source into the batch; n <= FGL_BATCH_SIZE. Only the given attributes. */
void fgl_fetch(struct vertex_batch *batch, const struct vertex_source *source, uint32_t attributes, uint32_t first, int n);

/* shade.c. fgl_shade_later: before the draw's vertices are run; false when memory is short. fgl_shade_listed: shades those of the
 * listed triangles' vertices that are not shaded yet. */
bool fgl_shade_later(struct pipeline *p, const struct vertex_job *job);
void fgl_shade_listed(struct pipeline *p);

/* One attribute of vertex i. */
void fgl_fetch_one(const struct attr_source *a, int attr, uint32_t i, float v[4]);

/* Assembles and draws all primitives of a draw. */
void fgl_assemble_all(struct pipeline *p, const struct draw_prim *prims, int n, const uint32_t *elements, uint32_t base, bool compiled);

/* assemble.c: the primitive's lines, points and triangles to the rasterizer. Vertex i is the cache's number i, or elements[i] - base. */
void fgl_assemble(struct pipeline *p, const struct draw_prim *prim, const uint32_t *elements, uint32_t base, bool compiled);

/* Clips against the frustum and the user planes, hands what is left to the rasterizer. */
struct clip_vertices {
    const void *record[3], *clip[3];
    const void *provoking;
    uint32_t outcode; /* OR over the vertices */
    unsigned edges;   /* boundary edges: bit i from vertex i to the next */
};

/* The kernels of one instruction set and one arithmetic (kernels.c). raster: the pipeline's plan, or one with narrower
 * bounds. */
struct clip_kernels {
    void (*triangle)(struct pipeline *p, const struct raster_plan *raster, const struct clip_vertices *in);
    void (*line)(const struct pipeline *p, const struct raster_plan *raster, const struct clip_vertices *in, int *stipple_counter);
    /* Window position, distance and texture coordinates of a raster position; false: it is clipped, nothing is set. */
    bool (*place)(struct context *ctx, const float object[4]);
    /* Writes those of n triangles that may be seen to `seen`, which has room for n. vertex: the triangles' vertices, readable in whole
     * groups of SIEVE_GROUP. */
    struct triangle_section (*sieve)(const struct pipeline *p, const uint32_t (*vertex)[3], int n, struct seen_triangle *seen);
    /* n vertices of `size` floats, `stride` bytes apart, to the first lanes of `to`. */
    void (*fetch_floats)(struct lanes4 *to, const char *from, ptrdiff_t stride, int n, int size);
};
const struct clip_kernels *fgl_clip_kernels(enum fgl_arith arith);

#endif
