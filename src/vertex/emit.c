#include "vertex/emit.h"

/* Four arrays to four neighbouring lanes of each record: a transposition. */
static void emit4(float *FGL_RESTRICT to, int stride, const struct lanes4 *from, int n)
{
    const float *x = from->c[0], *y = from->c[1], *z = from->c[2], *w = from->c[3];
    for (int i = 0; i < n; i++, to += stride) {
        to[0] = x[i];
        to[1] = y[i];
        to[2] = z[i];
        to[3] = w[i];
    }
}

/* Positions and one colour, the commonest record. */
static void emit8(float *FGL_RESTRICT to, const struct lanes4 *FGL_RESTRICT win, const struct lanes4 *FGL_RESTRICT color, int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++) {
            to[8 * i + c] = win->c[c][i];
            to[8 * i + 4 + c] = color->c[c][i];
        }
}

void fgl_emit(const struct emit_plan *plan, const struct vertex_batch *b, float *record)
{
    const int stride = plan->stride, n = b->n;
    if (stride == 8 && plan->color) {
        emit8(record, &b->win, &b->color[0], n);
        return;
    }
    emit4(record, stride, &b->win, n);
    if (plan->color)
        emit4(record + 4, stride, &b->color[0], n);
    if (plan->secondary)
        emit4(record + 8, stride, &b->secondary[0], n);
    if (plan->fog)
        for (int i = 0; i < n; i++)
            record[i * stride + 11] = b->fog_z[i];
    if (plan->two_sided)
        emit4(record + plan->back_lane, stride, &b->color[1], n);
    if (plan->two_sided && plan->secondary)
        emit4(record + plan->back_lane + 4, stride, &b->secondary[1], n);
}
