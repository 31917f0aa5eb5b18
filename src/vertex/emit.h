/* From batch arrays to raster vertices (raster/raster.h): the end of the vertex stage. Layer 3.
 *
 * A raster vertex is an array of the mode's scalar type, float or, in FIXEDGL_EXACT, double; so is a clip vertex: clip
 * coordinates, and in FIXEDGL_EXACT eye coordinates behind them. */
#ifndef FGL_VERTEX_EMIT_H
#define FGL_VERTEX_EMIT_H

#include "base/batch.h"
#include "base/cpu.h"
#include "base/lit_fragments.h"

enum { CLIP_LANES = 4, EXACT_CLIP_LANES = 8 };
#define CLIP_VERTEX_LANES (R_EXACT ? (int)EXACT_CLIP_LANES : (int)CLIP_LANES) /* in kernels */

/* Which batch arrays a raster vertex has. The lanes are those of fragment/fragment.h: position 0..3, colour 4..7, secondary colour 8..10,
 * fog 11; then, from texture_lane on, four lanes for each texture of struct vertex_plan; then, when two-sided, the back face's colour and secondary colour in the same order, from back_lane. */
struct emit_plan {
    enum fgl_arith arith;
    size_t record_bytes, clip_bytes; /* of a raster vertex, of a clip vertex */
    int stride; /* lanes of a raster vertex, a multiple of 4 */
    int lanes;  /* lanes without the back face's */
    bool color, secondary, fog, two_sided;
    int back_lane;
    int textures, texture_lane;
    int texture_unit[FGL_MAX_TEXTURE_UNITS]; /* whose given coordinates are handed over; -1: those computed */
    int lit_lane; /* lighting per fragment: normal, eye coordinates where lit_eye, the attributes; 0: none */
    bool lit_eye;
    int lit_attributes, lit_attribute[LIT_ATTRIBUTES];
    int size_lane; /* the point's size, when it differs by vertex; 0: none */
};

/* Sets arith and stride, and the sizes that follow from them. */
void fgl_emit_layout(struct emit_plan *plan, enum fgl_arith arith, int stride);

/* Writes batch->n raster vertices and, where the batch has any outcode, clip vertices. */
void fgl_emit(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip);
/* The same in two steps: positions and clip vertices, everything else. */
void fgl_emit_positions(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip);
void fgl_emit_attributes(const struct emit_plan *plan, const struct vertex_batch *batch, void *record);

#endif
