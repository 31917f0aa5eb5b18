/* Matrices (GL 1.5, 2.11.2 "Matrices"), their classes and their inverses, in OSMesa's float operations.
 *
 * A matrix is analysed when its class or inverse is first read after a change. Commands that say what they do (glRotate, glScale,
 * ...) only add their flag; after glLoadMatrix and glMultMatrix the class is found from the values. OSMesa rule: either way
 * the class decides which formula gives the inverse, and the formulas differ in the last bits. */
#include "state/matrix.h"

#include <math.h>
#include <string.h>

#define AT(row, column) ((row) + 4 * (column))

enum {
    FLAGS_ANGLE_PRESERVING = MAT_ROTATION | MAT_TRANSLATION | MAT_UNIFORM_SCALE,
    FLAGS_AFFINE = FLAGS_ANGLE_PRESERVING | MAT_GENERAL_SCALE | MAT_GENERAL_3D,
    FLAGS_CLASS = FLAGS_AFFINE | MAT_PERSPECTIVE | MAT_GENERAL | MAT_SINGULAR
};

/* Which inverse: the shapes that OSMesa tells apart. */
enum shape { SHAPE_IDENTITY, SHAPE_NO_ROTATION, SHAPE_AFFINE, SHAPE_GENERAL };

static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

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
    m->flags &= FLAGS_CLASS;
}

void fgl_matrix_load(struct matrix *m, const float v[16])
{
    if (memcmp(m->m, v, sizeof m->m) == 0)
        return;
    memcpy(m->m, v, sizeof m->m);
    m->flags = MAT_GENERAL | MAT_CLASSIFY | MAT_INVERSE_STALE;
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
    if (memcmp(v, identity, sizeof identity) != 0)
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
        m->m[AT(row, 3)] = m->m[AT(row, 0)] * x + m->m[AT(row, 1)] * y + m->m[AT(row, 2)] * z + m->m[AT(row, 3)];
    m->flags |= MAT_TRANSLATION | MAT_INVERSE_STALE;
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
}

/* Classification from values ---------------------------------------------------------------------------------- */

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

/* Inverses. Each returns false when the matrix has none. ---------------------------------------------------------- */

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
    static const unsigned char term[6][3] = {
            {AT(0, 0), AT(1, 1), AT(2, 2)}, {AT(1, 0), AT(2, 1), AT(0, 2)}, {AT(2, 0), AT(0, 1), AT(1, 2)},
            {AT(2, 0), AT(1, 1), AT(0, 2)}, {AT(1, 0), AT(0, 1), AT(2, 2)}, {AT(0, 0), AT(2, 1), AT(1, 2)}};
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

/* Gauss elimination of [m | identity] with partial pivoting: the largest element of the column rises from below by
 * exchanges of neighbours. */
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
