/* Draws with elements: the probe sees the vertices one for each element. */
#include "pipeline/explain.h"

#include <stdlib.h>
#include <string.h>

bool fgl_explain_gather(const struct pipeline *p, struct vertex_cache *to, const uint32_t *elements, int n, uint32_t base)
{
    const struct vertex_cache *from = &p->cache;
    const size_t record = p->plan.emit.record_bytes, clip = p->plan.emit.clip_bytes, count = (size_t)n;
    *to = (struct vertex_cache){.capacity = n, .record_bytes = record, .clip_bytes = clip};
    to->record = malloc(count * record);
    to->clip = malloc(count * clip);
    to->outcode = malloc(count * sizeof *to->outcode);
    to->edge_flag = malloc(count * sizeof *to->edge_flag);
    to->snapped = malloc(count * sizeof *to->snapped);
    if (!to->record || !to->clip || !to->outcode || !to->edge_flag || !to->snapped)
        return false;
    for (int i = 0; i < n; i++) {
        const size_t v = elements[i] - base;
        memcpy(to->record + (size_t)i * record, from->record + v * record, record);
        memcpy(to->clip + (size_t)i * clip, from->clip + v * clip, clip);
        to->outcode[i] = from->outcode[v];
        to->edge_flag[i] = from->edge_flag[v];
        to->snapped[i] = from->snapped[v];
    }
    return true;
}

void fgl_explain_free_gathered(struct vertex_cache *c)
{
    free(c->record);
    free(c->clip);
    free(c->outcode);
    free(c->edge_flag);
    free(c->snapped);
}
