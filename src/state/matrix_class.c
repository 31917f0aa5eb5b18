/* The classes of matrices, and their inverses by class (GL 1.5, 2.11.2 "Matrices").
 *
 * A matrix is analysed when its class or inverse is first read after a change. OSMesa rule: the class decides
 * which formula gives the inverse, and the formulas differ in the last bits. */
#include "state/matrix_class.h"

#include <math.h>
#include <string.h>

/* Which inverse: the shapes that OSMesa tells apart. */
enum shape { SHAPE_IDENTITY, SHAPE_NO_ROTATION, SHAPE_AFFINE, SHAPE_GENERAL };

/* Classification from values
 * ---------------------------------------------------------------------------------- */

static float dot3(const float *a, const float *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* |x| beyond the tolerance of classification, 1e-6: OSMesa rule. */
static bool differs(float x)
{
    return (double)(x * x) > 1e-6 * 1e-6;
}

static bool agrees(float x)
{
    return (double)(x * x) < 1e-6 * 1e-6;
}

static bool all_zero(const float m[16], unsigned elements)
{
    for (int i = 0; i < 16; i++)
        if (elements >> i & 1 && m[i] != 0.0f)
            return false;
    return true;
}

#define BIT(row, column) (1u << AT(row, column))
enum {
    LAST_ROW = BIT(3, 0) | BIT(3, 1) | BIT(3, 2),
    OFF_DIAGONAL_XY = BIT(0, 1) | BIT(1, 0),
    OFF_DIAGONAL_Z = BIT(0, 2) | BIT(1, 2) | BIT(2, 0) | BIT(2, 1),
    TRANSLATION_XYZ = BIT(0, 3) | BIT(1, 3) | BIT(2, 3)
};

/* A rotation about z, perhaps with scale or shear in the plane; z is untouched. */
static unsigned classify_plane(const float m[16])
{
    float xx = m[0] * m[0] + m[1] * m[1], yy = m[4] * m[4] + m[5] * m[5], xy = m[0] * m[4] + m[1] * m[5];

    return (differs(xx - 1.0f) || differs(yy - 1.0f) ? MAT_GENERAL_SCALE : 0) |
           (differs(xy) ? MAT_GENERAL_3D : MAT_ROTATION);
}

static unsigned classify_diagonal(const float m[16])
{
    if (agrees(m[0] - m[5]) && agrees(m[0] - m[10]))
        return differs(m[0] - 1.0f) ? MAT_UNIFORM_SCALE : 0;
    return MAT_GENERAL_SCALE;
}

static unsigned classify_affine(const float m[16])
{
    const float *x = m, *y = m + 4, *z = m + 8;
    float xx = dot3(x, x), yy = dot3(y, y), zz = dot3(z, z);
    unsigned flags = MAT_GENERAL_SCALE;

    if (agrees(xx - yy) && agrees(xx - zz))
        flags = differs(xx - 1.0f) ? MAT_UNIFORM_SCALE : 0;
    if (agrees(dot3(x, y))) {
        float d[3] = {x[1] * y[2] - x[2] * y[1] - z[0], x[2] * y[0] - x[0] * y[2] - z[1],
                      x[0] * y[1] - x[1] * y[0] - z[2]};
        if ((double)dot3(d, d) < 1e-6 * 1e-6)
            return flags | MAT_ROTATION;
    }
    return flags | MAT_GENERAL_3D;
}

static enum shape classify(struct matrix *mat)
{
    const float *m = mat->m;
    bool affine = all_zero(m, LAST_ROW) && m[15] == 1.0f;
    bool plane = affine && all_zero(m, OFF_DIAGONAL_Z | BIT(2, 3)) && m[10] == 1.0f;
    bool diagonal = affine && all_zero(m, OFF_DIAGONAL_XY | OFF_DIAGONAL_Z);

    mat->flags &= ~(unsigned)FLAGS_CLASS;
    mat->flags |= all_zero(m, TRANSLATION_XYZ) ? 0 : MAT_TRANSLATION;
    if (diagonal && all_zero(m, TRANSLATION_XYZ) && m[0] == 1.0f && m[5] == 1.0f && m[10] == 1.0f)
        return SHAPE_IDENTITY;
    if (diagonal && plane) {
        mat->flags |= m[0] == 1.0f && m[5] == 1.0f ? 0 : MAT_GENERAL_SCALE;
        return SHAPE_NO_ROTATION;
    }
    if (plane) {
        mat->flags |= classify_plane(m);
        return SHAPE_AFFINE;
    }
    if (diagonal) {
        mat->flags |= classify_diagonal(m);
        return SHAPE_NO_ROTATION;
    }
    if (affine) {
        mat->flags |= classify_affine(m);
        return SHAPE_AFFINE;
    }
    mat->flags |= MAT_GENERAL;
    return SHAPE_GENERAL;
}

static enum shape shape_of_flags(unsigned flags)
{
    flags &= FLAGS_CLASS;
    if (!flags)
        return SHAPE_IDENTITY;
    if (!(flags & ~(unsigned)(MAT_TRANSLATION | MAT_UNIFORM_SCALE | MAT_GENERAL_SCALE)))
        return SHAPE_NO_ROTATION;
    return flags & ~(unsigned)FLAGS_AFFINE ? SHAPE_GENERAL : SHAPE_AFFINE;
}

/* Inverses. Each returns false when the matrix has none.
 * ---------------------------------------------------------- */

static bool invert_no_rotation(float inv[16], const float m[16], bool translation)
{
    memcpy(inv, identity, sizeof identity);
    for (int i = 0; i < 3; i++) {
        if (m[AT(i, i)] == 0.0f)
            return false;
        inv[AT(i, i)] = 1.0f / m[AT(i, i)];
        if (translation)
            inv[AT(i, 3)] = -(m[AT(i, 3)] * inv[AT(i, i)]);
    }
    return true;
}

/* The last column of an affine inverse whose upper 3x3 is done. */
static void invert_translation(float inv[16], const float m[16])
{
    for (int row = 0; row < 3; row++)
        inv[AT(row, 3)] = -(m[AT(0, 3)] * inv[AT(row, 0)] + m[AT(1, 3)] * inv[AT(row, 1)] +
                            m[AT(2, 3)] * inv[AT(row, 2)]);
}

/* Rotation and uniform scale: the transpose over the square of the scale. */
static bool invert_angle_preserving(float inv[16], const float m[16], unsigned flags)
{
    memcpy(inv, identity, sizeof identity);
    if (!(flags & (MAT_UNIFORM_SCALE | MAT_ROTATION))) {
        for (int row = 0; row < 3; row++)
            inv[AT(row, 3)] = -m[AT(row, 3)];
        return true;
    }
    float square = m[AT(0, 0)] * m[AT(0, 0)] + m[AT(0, 1)] * m[AT(0, 1)] + m[AT(0, 2)] * m[AT(0, 2)];
    if (flags & MAT_UNIFORM_SCALE && square == 0.0f)
        return false;
    float scale = flags & MAT_UNIFORM_SCALE ? 1.0f / square : 1.0f;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            inv[AT(row, column)] = scale * m[AT(column, row)];
    if (flags & MAT_TRANSLATION)
        invert_translation(inv, m);
    return true;
}

/* The determinant of the upper 3x3: positive and negative terms are summed apart. */
static float determinant3(const float m[16])
{
    static const unsigned char term[6][3] = {{AT(0, 0), AT(1, 1), AT(2, 2)}, {AT(1, 0), AT(2, 1), AT(0, 2)},
                                             {AT(2, 0), AT(0, 1), AT(1, 2)}, {AT(2, 0), AT(1, 1), AT(0, 2)},
                                             {AT(1, 0), AT(0, 1), AT(2, 2)}, {AT(0, 0), AT(2, 1), AT(1, 2)}};
    float positive = 0.0f, negative = 0.0f;

    for (int i = 0; i < 6; i++) {
        float product = m[term[i][0]] * m[term[i][1]] * m[term[i][2]];
        float t = i < 3 ? product : -product;
        if (t >= 0.0f)
            positive += t;
        else
            negative += t;
    }
    return positive + negative;
}

static bool invert_affine(float inv[16], const float m[16], unsigned flags)
{
    if (!(flags & FLAGS_CLASS & ~(unsigned)FLAGS_ANGLE_PRESERVING))
        return invert_angle_preserving(inv, m, flags);

    float det = determinant3(m);
    if (fabsf(det) < 1e-25f)
        return false;
    float scale = 1.0f / det;
    memcpy(inv, identity, sizeof identity);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            /* The cofactor of element (column, row), by cyclic indices. */
            int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            inv[AT(row, column)] = (m[AT(r1, c1)] * m[AT(r2, c2)] - m[AT(r1, c2)] * m[AT(r2, c1)]) * scale;
        }
    invert_translation(inv, m);
    return true;
}

/* Gauss elimination of [m | identity] with partial pivoting: the largest element of the column rises from
 * below by exchanges of neighbours. */
static bool eliminate(float a[4][8])
{
    for (int k = 0; k < 4; k++) {
        for (int row = 3; row > k; row--)
            if (fabsf(a[row][k]) > fabsf(a[row - 1][k]))
                for (int j = 0; j < 8; j++) {
                    float t = a[row][j];
                    a[row][j] = a[row - 1][j];
                    a[row - 1][j] = t;
                }
        if (a[k][k] == 0.0f)
            return false;
        for (int row = k + 1; row < 4; row++) {
            float factor = a[row][k] / a[k][k];
            for (int j = k + 1; j < 8; j++)
                a[row][j] -= factor * a[k][j];
        }
    }
    return true;
}

static bool invert_general(float inv[16], const float m[16])
{
    float a[4][8];

    for (int row = 0; row < 4; row++)
        for (int j = 0; j < 8; j++)
            a[row][j] = j < 4 ? m[AT(row, j)] : identity[AT(row, j - 4)];
    if (!eliminate(a))
        return false;
    for (int k = 3; k >= 0; k--) {
        float scale = 1.0f / a[k][k];
        for (int j = 4; j < 8; j++) {
            a[k][j] *= scale;
            for (int row = 0; row < k; row++)
                a[row][j] -= a[k][j] * a[row][k];
        }
    }
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            inv[AT(row, column)] = a[row][4 + column];
    return true;
}

static bool invert(struct matrix *m, enum shape shape)
{
    switch (shape) {
    case SHAPE_NO_ROTATION: return invert_no_rotation(m->inv, m->m, m->flags & MAT_TRANSLATION);
    case SHAPE_AFFINE: return invert_affine(m->inv, m->m, m->flags);
    case SHAPE_GENERAL: return invert_general(m->inv, m->m);
    default: memcpy(m->inv, identity, sizeof identity); return true;
    }
}

static void analyse(struct matrix *m)
{
    if (!(m->flags & (MAT_CLASSIFY | MAT_INVERSE_STALE)))
        return;
    enum shape shape = m->flags & MAT_CLASSIFY ? classify(m) : shape_of_flags(m->flags);
    if (invert(m, shape)) {
        m->flags &= ~(unsigned)MAT_SINGULAR;
    } else {
        memcpy(m->inv, identity, sizeof identity);
        m->flags |= MAT_SINGULAR;
    }
    m->flags &= ~(unsigned)(MAT_CLASSIFY | MAT_INVERSE_STALE);
}

const float *fgl_matrix_inverse(struct matrix *m)
{
    analyse(m);
    return m->inv;
}

unsigned fgl_matrix_class(struct matrix *m)
{
    analyse(m);
    return m->flags & FLAGS_CLASS;
}
