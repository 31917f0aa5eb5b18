/* Matrices (GL 1.5, 2.11.2 "Matrices"): the commands, in OSMesa's float operations. A command that says what
 * it does (glRotate, glScale,
 * ...) adds its flag; after glLoadMatrix and glMultMatrix the class is found from the values
 * (matrix_class.c). */
#include "state/matrix_class.h"
#include "state/matrix_exact.h"

#include <math.h>
#include <string.h>

bool fgl_matrix_is_identity(const struct matrix *m)
{
    for (int i = 0; i < 16; i++)
        if (m->m[i] != identity[i])
            return false;
    return true;
}

void fgl_matrix_set_identity(struct matrix *m)
{
    fgl_matrix_load_identity(m);
    m->flags = 0;
}

/* The class flags stay: OSMesa rule. */
void fgl_matrix_load_identity(struct matrix *m)
{
    memcpy(m->m, identity, sizeof m->m);
    memcpy(m->inv, identity, sizeof m->inv);
    fgl_exact_load(m->exact, identity);
    m->flags &= FLAGS_CLASS;
}

void fgl_matrix_load(struct matrix *m, const float v[16])
{
    fgl_exact_load(m->exact, v);
    if (memcmp(m->m, v, sizeof m->m) == 0)
        return;
    memcpy(m->m, v, sizeof m->m);
    m->flags = MAT_GENERAL | MAT_CLASSIFY | MAT_INVERSE_STALE;
}

bool fgl_matrix_exactly_equal(const struct matrix *a, const struct matrix *b)
{
    return memcmp(a->m, b->m, sizeof a->m) == 0 && memcmp(a->exact, b->exact, sizeof a->exact) == 0;
}

void fgl_matrix_product(float r[16], const float a[16], const float b[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++)
            r[AT(row, column)] = a[AT(row, 0)] * b[AT(0, column)] + a[AT(row, 1)] * b[AT(1, column)] +
                                 a[AT(row, 2)] * b[AT(2, column)] + a[AT(row, 3)] * b[AT(3, column)];
}

/* The product of matrices whose last row is 0 0 0 1; zero terms are left out. */
static void product_affine(float r[16], const float a[16], const float b[16])
{
    memcpy(r, identity, 16 * sizeof *r);
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 3; row++) {
            float sum = a[AT(row, 0)] * b[AT(0, column)] + a[AT(row, 1)] * b[AT(1, column)] +
                        a[AT(row, 2)] * b[AT(2, column)];
            r[AT(row, column)] = column == 3 ? sum + a[AT(row, 3)] : sum;
        }
}

/* m = m * v, v of the class `flags`. */
static void multiply(struct matrix *m, const float v[16], unsigned flags)
{
    float r[16];

    m->flags |= flags | MAT_INVERSE_STALE;
    if (m->flags & FLAGS_CLASS & ~(unsigned)FLAGS_AFFINE)
        fgl_matrix_product(r, m->m, v);
    else
        product_affine(r, m->m, v);
    memcpy(m->m, r, sizeof m->m);
}

void fgl_matrix_multiply(struct matrix *m, const float v[16])
{
    if (memcmp(v, identity, sizeof identity) == 0)
        return;
    fgl_exact_multiply(m->exact, v);
    multiply(m, v, MAT_GENERAL | MAT_CLASSIFY);
}

/* The rotation about coordinate axis `axis` (0 x, 1 y, 2 z). */
static void axis_rotation(float r[16], int axis, float s, float c)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;

    r[AT(u, u)] = r[AT(v, v)] = c;
    r[AT(u, v)] = -s;
    r[AT(v, u)] = s;
}

/* GL 1.5, 2.11.2 "Matrices": the rotation about the unit vector (x, y, z). */
static void general_rotation(float r[16], float x, float y, float z, float s, float c)
{
    float k = 1.0f - c;
    float xx = x * x, yy = y * y, zz = z * z, xy = x * y, yz = y * z, zx = z * x;
    float xs = x * s, ys = y * s, zs = z * s;

    r[AT(0, 0)] = k * xx + c;
    r[AT(0, 1)] = k * xy - zs;
    r[AT(0, 2)] = k * zx + ys;
    r[AT(1, 0)] = k * xy + zs;
    r[AT(1, 1)] = k * yy + c;
    r[AT(1, 2)] = k * yz - xs;
    r[AT(2, 0)] = k * zx - ys;
    r[AT(2, 1)] = k * yz + xs;
    r[AT(2, 2)] = k * zz + c;
}

void fgl_matrix_rotate(struct matrix *m, float angle_deg, float x, float y, float z)
{
    const double radians_per_degree = 3.14159265358979323846 / 180.0;
    float angle = (float)((double)angle_deg * radians_per_degree);
    float s = sinf(angle), c = cosf(angle), length;
    float r[16];

    if (angle_deg == 0.0f)
        return;
    fgl_exact_rotate(m->exact, (double)angle_deg, (double)x, (double)y, (double)z);
    memcpy(r, identity, sizeof r);
    if (x == 0.0f && y == 0.0f && z != 0.0f) {
        axis_rotation(r, 2, z < 0.0f ? -s : s, c);
    } else if (x == 0.0f && y != 0.0f && z == 0.0f) {
        axis_rotation(r, 1, y < 0.0f ? -s : s, c);
    } else if (x != 0.0f && y == 0.0f && z == 0.0f) {
        axis_rotation(r, 0, x < 0.0f ? -s : s, c);
    } else {
        length = sqrtf(x * x + y * y + z * z);
        if (length <= 1e-4f)
            return; /* no direction: OSMesa rule */
        general_rotation(r, x / length, y / length, z / length, s, c);
    }
    multiply(m, r, MAT_ROTATION);
}

void fgl_matrix_translate(struct matrix *m, float x, float y, float z)
{
    for (int row = 0; row < 4; row++)
        m->m[AT(row, 3)] =
                m->m[AT(row, 0)] * x + m->m[AT(row, 1)] * y + m->m[AT(row, 2)] * z + m->m[AT(row, 3)];
    m->flags |= MAT_TRANSLATION | MAT_INVERSE_STALE;
    fgl_exact_translate(m->exact, (double)x, (double)y, (double)z);
}

void fgl_matrix_scale(struct matrix *m, float x, float y, float z)
{
    bool uniform = fabsf(x - y) < 1e-8f && fabsf(x - z) < 1e-8f;

    for (int row = 0; row < 4; row++) {
        m->m[AT(row, 0)] *= x;
        m->m[AT(row, 1)] *= y;
        m->m[AT(row, 2)] *= z;
    }
    m->flags |= (uniform ? MAT_UNIFORM_SCALE : MAT_GENERAL_SCALE) | MAT_INVERSE_STALE;
    fgl_exact_scale(m->exact, (double)x, (double)y, (double)z);
}

void fgl_matrix_frustum(struct matrix *m, double l_, double r_, double b_, double t_, double n_, double f_)
{
    float l = (float)l_, r = (float)r_, b = (float)b_, t = (float)t_, n = (float)n_, f = (float)f_;
    float v[16] = {0};

    v[AT(0, 0)] = (2.0f * n) / (r - l);
    v[AT(1, 1)] = (2.0f * n) / (t - b);
    v[AT(0, 2)] = (r + l) / (r - l);
    v[AT(1, 2)] = (t + b) / (t - b);
    v[AT(2, 2)] = -(f + n) / (f - n);
    v[AT(3, 2)] = -1.0f;
    v[AT(2, 3)] = -(2.0f * f * n) / (f - n);
    multiply(m, v, MAT_PERSPECTIVE);
    fgl_exact_frustum(m->exact, l_, r_, b_, t_, n_, f_);
}

void fgl_matrix_ortho(struct matrix *m, double l_, double r_, double b_, double t_, double n_, double f_)
{
    float l = (float)l_, r = (float)r_, b = (float)b_, t = (float)t_, n = (float)n_, f = (float)f_;
    float v[16];

    memcpy(v, identity, sizeof v);
    v[AT(0, 0)] = 2.0f / (r - l);
    v[AT(1, 1)] = 2.0f / (t - b);
    v[AT(2, 2)] = -2.0f / (f - n);
    v[AT(0, 3)] = -(r + l) / (r - l);
    v[AT(1, 3)] = -(t + b) / (t - b);
    v[AT(2, 3)] = -(f + n) / (f - n);
    multiply(m, v, MAT_GENERAL_SCALE | MAT_TRANSLATION);
    fgl_exact_ortho(m->exact, l_, r_, b_, t_, n_, f_);
}
