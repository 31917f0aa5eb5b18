#include "state/matrix_exact.h"

#include "base/pair.h"
#include "state/matrix_class.h"

#include <math.h>
#include <string.h>

void fgl_exact_load(double m[16], const float v[16])
{
    for (int i = 0; i < 16; i++)
        m[i] = (double)v[i];
}

void fgl_exact_product(double r[16], const double a[16], const double b[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++)
            r[AT(row, column)] = a[AT(row, 0)] * b[AT(0, column)] + a[AT(row, 1)] * b[AT(1, column)] +
                                 a[AT(row, 2)] * b[AT(2, column)] + a[AT(row, 3)] * b[AT(3, column)];
}

static void multiply(double m[16], const double v[16])
{
    double r[16];

    fgl_exact_product(r, m, v);
    memcpy(m, r, sizeof r);
}

void fgl_exact_multiply(double m[16], const float v[16])
{
    double d[16];

    fgl_exact_load(d, v);
    multiply(m, d);
}

/* GL 1.5, 2.11.2: the rotation about the vector (x, y, z), whatever its length but 0. */
void fgl_exact_rotate(double m[16], double degrees, double x, double y, double z)
{
    const double angle = degrees * (3.14159265358979323846 / 180.0), s = sin(angle), c = cos(angle);
    const double length = sqrt(x * x + y * y + z * z);

    if (!(length > 0))
        return;
    x /= length;
    y /= length;
    z /= length;
    const double k = 1 - c;
    const double r[16] = {k * x * x + c,     k * x * y + z * s, k * z * x - y * s, 0,
                          k * x * y - z * s, k * y * y + c,     k * y * z + x * s, 0,
                          k * z * x + y * s, k * y * z - x * s, k * z * z + c,     0,
                          0,                 0,                 0,                 1};
    multiply(m, r);
}

void fgl_exact_translate(double m[16], double x, double y, double z)
{
    for (int row = 0; row < 4; row++)
        m[AT(row, 3)] += m[AT(row, 0)] * x + m[AT(row, 1)] * y + m[AT(row, 2)] * z;
}

void fgl_exact_scale(double m[16], double x, double y, double z)
{
    for (int row = 0; row < 4; row++) {
        m[AT(row, 0)] *= x;
        m[AT(row, 1)] *= y;
        m[AT(row, 2)] *= z;
    }
}

void fgl_exact_frustum(double m[16], double l, double r, double b, double t, double n, double f)
{
    const double v[16] = {[AT(0, 0)] = 2 * n / (r - l),
                          [AT(1, 1)] = 2 * n / (t - b),
                          [AT(0, 2)] = (r + l) / (r - l),
                          [AT(1, 2)] = (t + b) / (t - b),
                          [AT(2, 2)] = -(f + n) / (f - n),
                          [AT(3, 2)] = -1,
                          [AT(2, 3)] = -(2 * f * n) / (f - n)};
    multiply(m, v);
}

void fgl_exact_ortho(double m[16], double l, double r, double b, double t, double n, double f)
{
    const double v[16] = {[AT(0, 0)] = 2 / (r - l),          [AT(1, 1)] = 2 / (t - b),
                          [AT(2, 2)] = -2 / (f - n),         [AT(0, 3)] = -(r + l) / (r - l),
                          [AT(1, 3)] = -(t + b) / (t - b),   [AT(2, 3)] = -(f + n) / (f - n),
                          [AT(3, 3)] = 1};
    multiply(m, v);
}

void fgl_exact_transform(double r[4], const double m[16], const float v[4], int count)
{
    for (int row = 0; row < 4; row++) {
        r[row] = 0;
        for (int k = 0; k < count; k++)
            r[row] += m[AT(row, k)] * (double)v[k];
    }
}

/* Solves r * m = p by elimination with column pivots. */
void fgl_exact_transform_plane(double r[4], const double m[16], const double p[4])
{
    double row[4][5]; /* equation c: the sum of r[k] * m[k, c] is p[c] */

    for (int c = 0; c < 4; c++) {
        memcpy(row[c], m + 4 * c, 4 * sizeof(double));
        row[c][4] = p[c];
    }
    for (int k = 0; k < 4; k++) {
        int pivot = k;
        for (int i = k + 1; i < 4; i++)
            pivot = fabs(row[i][k]) > fabs(row[pivot][k]) ? i : pivot;
        for (int c = 0; c < 5; c++) {
            const double swapped = row[k][c];
            row[k][c] = row[pivot][c];
            row[pivot][c] = swapped;
        }
        for (int i = 0; i < 4; i++) {
            const double factor = row[i][k] / row[k][k];
            for (int c = k; i != k && c < 5; c++)
                row[i][c] -= factor * row[k][c];
        }
    }
    bool regular = true;
    for (int k = 0; k < 4; k++) {
        r[k] = row[k][4] / row[k][k];
        regular = regular && isfinite(r[k]);
    }
    for (int k = 0; k < 4 && !regular; k++)
        r[k] = 0;
}

/* The inverse. Sums of products cancel where a matrix is nearly singular, so they are formed in pairs of doubles. */

bool fgl_exact_inverse3(double inv[3][3], const double m[16])
{
    struct pair determinant = {0, 0};
    double magnitude = 0;

    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            /* The cofactor of element (column, row), by cyclic indices. */
            const int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            const double a = m[AT(r1, c1)], b = m[AT(r2, c2)], c = m[AT(r1, c2)], d = m[AT(r2, c1)];
            const struct pair cofactor = pair_sum(pair_product(a, b), pair_product(-c, d));
            inv[row][column] = cofactor.hi;
            if (row)
                continue;
            const double element = m[AT(column, 0)];
            struct pair term = pair_product(element, cofactor.hi);
            term.lo += element * cofactor.lo;
            determinant = pair_sum(determinant, term);
            magnitude += fabs(element) * (fabs(a * b) + fabs(c * d));
        }
    /* What is left of a sum that cancels down to the rounding of its terms is 0. */
    if (!(fabs(determinant.hi) > 0x1p-96 * magnitude))
        return false;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            inv[row][column] /= determinant.hi;
    return true;
}
