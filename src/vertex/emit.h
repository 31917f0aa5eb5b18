/* From batch arrays to raster vertices (raster/raster.h): the end of the vertex stage. Layer 3. */
#ifndef FGL_VERTEX_EMIT_H
#define FGL_VERTEX_EMIT_H

#include "base/batch.h"

/* Which batch arrays a raster vertex has. The lanes are those of fragment/fragment.h: position 0..3, colour 4..7, secondary colour 8..10,
 * fog 11; then, when two-sided, the back face's colour and secondary colour in the same order, from back_lane. */
struct emit_plan {
    int stride; /* floats, a multiple of 4 */
    int lanes;  /* lanes without the back face's */
    bool color, secondary, fog, two_sided;
    int back_lane;
};

/* Writes batch->n raster vertices of plan->stride floats. */
void fgl_emit(const struct emit_plan *plan, const struct vertex_batch *batch, float *record);

#endif
