/* From batch arrays to raster vertices (raster/raster.h) and clip vertices: the end of the vertex stage. Kernels. */
#ifndef FGL_VERTEX_EMIT_KERNEL_H
#define FGL_VERTEX_EMIT_KERNEL_H

#include "vertex/work.h"

/* Four arrays to four neighbouring lanes of each record: a transposition. */
static void emit4(real *FGL_RESTRICT to, int stride, const real_lanes4 *from, int n)
{
    const real *x = from->c[0], *y = from->c[1], *z = from->c[2], *w = from->c[3];
    for (int i = 0; i < n; i++, to += stride) {
        to[0] = x[i];
        to[1] = y[i];
        to[2] = z[i];
        to[3] = w[i];
    }
}

/* Positions and one colour, the commonest record. */
static void emit8(real *FGL_RESTRICT to, const real_lanes4 *FGL_RESTRICT win, const real_lanes4 *FGL_RESTRICT color, int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++) {
            to[8 * i + c] = win->c[c][i];
            to[8 * i + 4 + c] = color->c[c][i];
        }
}

/* Coordinates as they were given. */
static void emit_given(real *FGL_RESTRICT to, int stride, const struct lanes4 *from, int n)
{
    for (int i = 0; i < n; i++, to += stride)
        for (int c = 0; c < 4; c++)
            to[c] = (real)from->c[c][i];
}

static void emit_textures(const struct emit_plan *plan, const struct vertex_batch *batch, real *record)
{
    for (int k = 0; k < plan->textures; k++) {
        const int unit = plan->texture_unit[k];
        real *to = record + plan->texture_lane + 4 * k;
        if (unit < 0)
            emit4(to, plan->stride, &RESULTS(batch)->texture[k], batch->n);
        else
            emit_given(to, plan->stride, &batch->in[ATTR_TEX0 + unit], batch->n);
    }
}

static FGL_NOINLINE void emit_lit(const struct emit_plan *plan, const struct vertex_batch *batch, real *to)
{
    emit4(to, plan->stride, &RESULTS(batch)->lit_normal, batch->n);
    to += 4;
    if (plan->lit_eye) {
        emit4(to, plan->stride, &RESULTS(batch)->lit_eye, batch->n);
        to += 4;
    }
    for (int k = 0; k < plan->lit_attributes; k++, to += 4)
        emit_given(to, plan->stride, &batch->in[plan->lit_attribute[k]], batch->n);
}

/* All of a record but its position. */
static void emit_attributes(const struct emit_plan *plan, const struct vertex_batch *batch, void *records)
{
    real *record = records;
    const int stride = plan->stride, n = batch->n;
    if (plan->color)
        emit4(record + 4, stride, &RESULTS(batch)->color[0], n);
    if (plan->secondary)
        emit4(record + 8, stride, &RESULTS(batch)->secondary[0], n);
    if (plan->fog)
        for (int i = 0; i < n; i++)
            record[i * stride + 11] = RESULTS(batch)->fog_z[i];
    emit_textures(plan, batch, record);
    if (plan->lit_lane)
        emit_lit(plan, batch, record + plan->lit_lane);
    for (int i = 0; i < n && plan->size_lane; i++)
        record[i * stride + plan->size_lane] = (real)batch->point_size[i];
    if (plan->two_sided)
        emit4(record + plan->back_lane, stride, &RESULTS(batch)->color[1], n);
    if (plan->two_sided && plan->secondary)
        emit4(record + plan->back_lane + 4, stride, &RESULTS(batch)->secondary[1], n);
}

static void emit_clip(const struct vertex_batch *batch, void *clip)
{
    if (!batch->outcode_any)
        return;
    emit4(clip, CLIP_VERTEX_LANES, &RESULTS(batch)->clip, batch->n);
#if R_EXACT
    emit4((real *)clip + 4, CLIP_VERTEX_LANES, &batch->exact.eye, batch->n);
#endif
}

/* Positions alone. clip: written only where the batch has any outcode. */
static void emit_positions(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip)
{
    emit4(record, plan->stride, &RESULTS(batch)->win, batch->n);
    emit_clip(batch, clip);
}

static void emit(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip)
{
    if (plan->stride == 8 && plan->color && !plan->textures) {
        emit8(record, &RESULTS(batch)->win, &RESULTS(batch)->color[0], batch->n);
    } else {
        emit4(record, plan->stride, &RESULTS(batch)->win, batch->n);
        emit_attributes(plan, batch, record);
    }
    emit_clip(batch, clip);
}

#endif
