/* Shading after assembly: the vertices of a draw of filled polygons are lit, and their other attributes emitted, when it is
 * known which triangles may cover a pixel; where none does, not at all. Their positions are in the cache by then. A chunk
 * of vertices is shaded as a whole, once. */
#include "pipeline/pipeline.h"

#include <stdlib.h>
#include <string.h>

enum { SHARED_CHUNKS = 12 }; /* fewer are not worth waking another thread for */

struct shading {
    int32_t wanted;     /* number of a chunk that is to be shaded: a list in front */
    bool named, shaded; /* the chunk's own */
};

bool fgl_shade_later(struct pipeline *p, const struct vertex_job *job)
{
    struct vertex_cache *c = &p->cache;
    const int chunks = (job->n + VERTEX_CHUNK - 1) / VERTEX_CHUNK;
    if (chunks > c->chunks) {
        struct shading *bigger = realloc(c->chunk, (size_t)chunks * sizeof *bigger);
        if (!bigger)
            return false;
        c->chunk = bigger;
        c->chunks = chunks;
    }
    memset(c->chunk, 0, (size_t)chunks * sizeof *c->chunk);
    return true;
}

static void shade_chunk(void *arg, int item, int worker)
{
    struct pipeline *p = arg;
    const struct vertex_job *job = p->unshaded;
    struct vertex_batch *b = p->batch[worker];
    const int at = p->cache.chunk[item].wanted * VERTEX_CHUNK;
    fgl_fetch(b, job->source, p->plan.fetch, job->first + (uint32_t)at, fgl_min(job->n - at, VERTEX_CHUNK));
    fgl_vertex_shade(&p->plan.vertex, b, p->general);
    fgl_emit_attributes(&p->plan.emit, b, p->cache.record + (size_t)at * p->plan.emit.record_bytes);
}

/* Lists the chunks that the triangles name and that are not shaded. Returns how many. */
static int list_chunks(struct pipeline *p, int chunks)
{
    struct shading *c = p->cache.chunk;
    const struct triangle_list *t = &p->triangles;
    int n = 0;
    for (int s = 0; s < fgl_triangles_sections(t); s++)
        for (int i = 0; i < t->section[s].n; i++)
            for (int k = 0; k < 3; k++)
                c[t->seen[s * SECTION_TRIANGLES + i].vertex[k] / VERTEX_CHUNK].named = true;
    for (int i = 0; i < chunks; i++) {
        if (!c[i].named || c[i].shaded)
            continue;
        c[i].shaded = true;
        c[n++].wanted = i;
    }
    return n;
}

void fgl_shade_listed(struct pipeline *p)
{
    const int chunks = (p->unshaded->n + VERTEX_CHUNK - 1) / VERTEX_CHUNK;
    const int n = list_chunks(p, chunks);
    if (fgl_pipeline_share(p, n >= SHARED_CHUNKS) > 1) {
        fgl_workers_run(p->workers, n, shade_chunk, p);
        return;
    }
    for (int i = 0; i < n; i++)
        shade_chunk(p, i, 0);
}
