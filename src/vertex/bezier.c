/* Bezier curves and surfaces. See bezier.h. */
#include "vertex/bezier.h"

#include <string.h>

/* Horner's scheme for  sum of B_i(t) p_i,  B_i the Bernstein polynomials of degree n - 1: the power of 1 - t
 * is multiplied in step by step, that of t and the binomial coefficient run along. Control point i stands at
 * p + i * stride. */
static void curve(const float *p, int stride, int n, int size, float t, float *point)
{
    memcpy(point, p, (size_t)size * sizeof *point);
    if (n < 2)
        return;
    const float s = 1.0f - t;
    float binomial = (float)(n - 1), power = t;
    for (int i = 1;; i++) {
        p += stride;
        for (int k = 0; k < size; k++)
            point[k] = s * point[k] + binomial * power * p[k];
        if (i + 1 == n)
            return;
        power *= t;
        binomial *= (float)(n - i - 1);
        binomial *= 1.0f / (float)(i + 1);
    }
}

void fgl_bezier_curve(const struct bezier_net *net, float t, float *point)
{
    curve(net->points, net->size, net->order[0], net->size, t, point);
}

/* OSMesa rule: first along the direction of lower order, the first one only if it is strictly lower; then
 * along the curve that this gives. */
void fgl_bezier_surface(const struct bezier_net *net, float u, float v, float *point)
{
    const int nu = net->order[0], nv = net->order[1], size = net->size, row = nv * size;
    float across[FGL_MAX_EVAL_ORDER][BEZIER_MAX_SIZE];
    if (nu < nv) {
        for (int j = 0; j < nv; j++)
            curve(net->points + j * size, row, nu, size, u, across[j]);
        curve(across[0], BEZIER_MAX_SIZE, nv, size, v, point);
    } else {
        for (int i = 0; i < nu; i++)
            curve(net->points + i * row, size, nv, size, v, across[i]);
        curve(across[0], BEZIER_MAX_SIZE, nu, size, u, point);
    }
}

/* ---- de Casteljau's scheme, one component at a time ---- */

/* A component of the net while it shrinks: c[i][j] for i < n[0], j < n[1]. */
struct scheme {
    float c[FGL_MAX_EVAL_ORDER][FGL_MAX_EVAL_ORDER];
    int n[2];
};

static float mix(float a, float b, float t)
{
    return (1.0f - t) * a + t * b;
}

/* One order less in both directions. */
static void step_both(struct scheme *s, float u, float v)
{
    s->n[0]--;
    s->n[1]--;
    for (int i = 0; i < s->n[0]; i++) {
        float left = mix(s->c[i][0], s->c[i + 1][0], u);
        for (int j = 0; j < s->n[1]; j++) {
            const float right = mix(s->c[i][j + 1], s->c[i + 1][j + 1], u);
            s->c[i][j] = mix(left, right, v);
            left = right;
        }
    }
}

/* One order less for n values. */
static void step(float *c, int n, float t)
{
    for (int i = 0; i + 1 < n; i++)
        c[i] = mix(c[i], c[i + 1], t);
}

/* What is left of a component in the end: its value, and the differences along both directions. */
struct ending {
    float value, d[2];
};

static struct ending end_square(const struct scheme *s, float u, float v)
{
    const float a = s->c[0][0], b = s->c[0][1], c = s->c[1][0], d = s->c[1][1];
    return (struct ending){mix(mix(a, b, v), mix(c, d, v), u), {mix(c - a, d - b, v), mix(b - a, d - c, u)}};
}

/* Two values are left in direction `thin`, more in the other: `t` and `along` are the parameters of these. */
static struct ending end_strip(const struct scheme *s, int thin, float t, float along)
{
    float value[FGL_MAX_EVAL_ORDER], difference[FGL_MAX_EVAL_ORDER];
    int n = s->n[1 - thin];
    for (int i = 0; i < n; i++) {
        const float a = thin ? s->c[i][0] : s->c[0][i], b = thin ? s->c[i][1] : s->c[1][i];
        value[i] = mix(a, b, t);
        difference[i] = b - a;
    }
    for (; n > 2; n--) {
        step(value, n, along);
        step(difference, n, along);
    }
    struct ending e = {mix(value[0], value[1], along), {0, 0}};
    e.d[thin] = mix(difference[0], difference[1], along);
    e.d[1 - thin] = value[1] - value[0];
    return e;
}

/* Component k of the net. Order 1, a constant, is taken as order 2 with twice the same point. */
static void load(struct scheme *s, const struct bezier_net *net, int k)
{
    for (int d = 0; d < 2; d++)
        s->n[d] = fgl_max(net->order[d], 2);
    for (int i = 0; i < s->n[0]; i++)
        for (int j = 0; j < s->n[1]; j++) {
            const int row = fgl_min(i, net->order[0] - 1), column = fgl_min(j, net->order[1] - 1);
            s->c[i][j] = net->points[(row * net->order[1] + column) * net->size + k];
        }
}

void fgl_bezier_tangents(const struct bezier_net *net, float u, float v, float *point, float *du, float *dv)
{
    struct scheme s;
    for (int k = 0; k < net->size; k++) {
        load(&s, net, k);
        while (s.n[0] > 2 && s.n[1] > 2)
            step_both(&s, u, v);
        const struct ending e = s.n[0] == s.n[1]  ? end_square(&s, u, v)
                                : s.n[0] < s.n[1] ? end_strip(&s, 0, u, v)
                                                  : end_strip(&s, 1, v, u);
        point[k] = e.value;
        du[k] = e.d[0];
        dv[k] = e.d[1];
    }
}
