/* Martin Newell's teapot (University of Utah, 1975): ten bicubic Bezier patches, copied by symmetry to 32 and
 * evaluated on a regular grid, with the operations of freeglut 3.4 in its order, so that every float is
 * equal. The data is z up; GLUT draws it y up, centred in height, at half its size. */
#include <math.h>
#include <string.h>
#include <GL/glut.h>
#include "internal.h"
#include "shapes.h"

enum { PATCHES = 10, COPIES = 32, SOLID_GRID = 8, WIRE_GRID = 10 };

struct patch {
    int copies; /* 4: turned about the vertical axis by 90 degrees each time; 2: mirrored in y */
    float point[16][3];
};

/* clang-format off: tables stand in columns */
/* A ring of the body: radius r at height z; Newell's quarter circle has its inner points at 0.56 r. */
#define RING(r, k, z)                                                                                        \
    {r, 0, z}, {r, -(k), z}, {k, -(r), z},                                                                   \
    {                                                                                                        \
        0, -(r), z                                                                                           \
    }
#define BASE_RING(r, k, z)                                                                                   \
    {0, -(r), z}, {k, -(r), z}, {r, -(k), z},                                                                \
    {                                                                                                        \
        r, 0, z                                                                                              \
    }
/* A row across the handle or the spout: out along y and back. */
#define ROW(x0, z0, x1, z1, y)                                                                               \
    {x0, 0, z0}, {x0, -(y), z0}, {x1, -(y), z1},                                                             \
    {                                                                                                        \
        x1, 0, z1                                                                                            \
    }

static const struct patch patches[PATCHES] = {
        /* rim */
        {4,
         {RING(1.4f, 0.784f, 2.4f), RING(1.3375f, 0.749f, 2.53125f), RING(1.4375f, 0.805f, 2.53125f),
          RING(1.5f, 0.84f, 2.4f)}},
        /* body, upper and lower */
        {4,
         {RING(1.5f, 0.84f, 2.4f), RING(1.75f, 0.98f, 1.875f), RING(2.0f, 1.12f, 1.35f),
          RING(2.0f, 1.12f, 0.9f)}},
        {4,
         {RING(2.0f, 1.12f, 0.9f), RING(2.0f, 1.12f, 0.45f), RING(1.5f, 0.84f, 0.225f),
          RING(1.5f, 0.84f, 0.15f)}},
        /* knob and lid; two points of the top are 0.002 off the axis in Newell's data */
        {4,
         {{0, 0, 3.15f},
          {0, -0.002f, 3.15f},
          {0.002f, 0, 3.15f},
          {0, 0, 3.15f},
          RING(0.8f, 0.45f, 3.15f),
          RING(0, 0, 2.85f),
          RING(0.2f, 0.112f, 2.7f)}},
        {4,
         {RING(0.2f, 0.112f, 2.7f), RING(0.4f, 0.224f, 2.55f), RING(1.3f, 0.728f, 2.55f),
          RING(1.3f, 0.728f, 2.4f)}},
        /* bottom, seen from below */
        {4,
         {BASE_RING(0, 0, 0), BASE_RING(1.425f, 0.798f, 0), BASE_RING(1.5f, 0.84f, 0.075f),
          BASE_RING(1.5f, 0.84f, 0.15f)}},
        /* handle, upper and lower */
        {2,
         {ROW(-1.6f, 2.025f, -1.5f, 2.25f, 0.3f), ROW(-2.3f, 2.025f, -2.5f, 2.25f, 0.3f),
          ROW(-2.7f, 2.025f, -3.0f, 2.25f, 0.3f), ROW(-2.7f, 1.8f, -3.0f, 1.8f, 0.3f)}},
        {2,
         {ROW(-2.7f, 1.8f, -3.0f, 1.8f, 0.3f), ROW(-2.7f, 1.575f, -3.0f, 1.35f, 0.3f),
          ROW(-2.5f, 1.125f, -2.65f, 0.9375f, 0.3f), ROW(-2.0f, 0.9f, -1.9f, 0.6f, 0.3f)}},
        /* spout and its lip */
        {2,
         {ROW(1.7f, 1.425f, 1.7f, 0.6f, 0.66f), ROW(2.6f, 1.425f, 3.1f, 0.825f, 0.66f),
          ROW(2.3f, 2.1f, 2.4f, 2.025f, 0.25f), ROW(2.7f, 2.4f, 3.3f, 2.4f, 0.25f)}},
        {2,
         {ROW(2.7f, 2.4f, 3.3f, 2.4f, 0.25f), ROW(2.8f, 2.475f, 3.525f, 2.49375f, 0.25f),
          ROW(2.9f, 2.475f, 3.45f, 2.5125f, 0.15f), ROW(2.8f, 2.4f, 3.2f, 2.4f, 0.15f)}},
};
/* clang-format on */
enum { KNOB_PATCH = 3, BOTTOM_PATCH = 5 };

/* Cubic Bernstein polynomials and their derivatives at x. */
struct bernstein {
    float value[4], slope[4];
};

static struct bernstein bernstein_at(float x)
{
    float y = 1 - x, xx = x * x, yy = y * y;
    return (struct bernstein){
            {yy * y, 3 * x * yy, 3 * xx * y, xx * x},
            {-3 * yy, 3 * yy - 6 * x * y, 6 * x * y - 3 * xx, 3 * xx},
    };
}

/* Control points in GLUT's frame: y up, the middle of the height at 0, times scale / 2. */
static void place_points(const struct patch *patch, float half_scale, float out[16][3])
{
    for (int i = 0; i < 16; i++) {
        out[i][0] = patch->point[i][0] * half_scale;
        out[i][1] = (patch->point[i][2] - 1.575f) * half_scale;
        out[i][2] = -patch->point[i][1] * half_scale;
    }
}

/* sum over a, b of u[a] * v[b] * point[4a + b] */
static void blend(const float u[4], const float v[4], const float point[16][3], float out[3])
{
    for (int axis = 0; axis < 3; axis++) {
        float sum = 0;
        for (int a = 0; a < 4; a++) {
            float row = 0;
            for (int b = 0; b < 4; b++)
                row += v[b] * point[4 * a + b][axis];
            sum += u[a] * row;
        }
        out[axis] = sum;
    }
}

static void unit_cross(const float a[3], const float b[3], float out[3])
{
    float x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    float length = sqrtf(x * x + y * y + z * z);
    out[0] = x / length;
    out[1] = y / length;
    out[2] = z / length;
}

/* The grid of one patch, row by row of u. normal may be NULL. */
static void evaluate(int patch, float half_scale, int grid, float (*position)[3], float (*normal)[3])
{
    float point[16][3], along_u[3], along_v[3];
    place_points(&patches[patch], half_scale, point);
    for (int k = 0; k < grid * grid; k++) {
        struct bernstein u = bernstein_at((float)(k / grid) / ((float)grid - 1));
        struct bernstein v = bernstein_at((float)(k % grid) / ((float)grid - 1));
        blend(u.value, v.value, (const float(*)[3])point, position[k]);
        if (!normal)
            continue;
        blend(u.slope, v.value, (const float(*)[3])point, along_u);
        blend(u.value, v.slope, (const float(*)[3])point, along_v);
        unit_cross(along_v, along_u, normal[k]);
        if ((patch == KNOB_PATCH || patch == BOTTOM_PATCH) && k < grid) { /* degenerate at the pole */
            normal[k][0] = normal[k][2] = 0;
            normal[k][1] = patch == KNOB_PATCH ? 1 : -1;
        }
    }
}

/* Writes copy number `copy` of the grid `in`: turned, or mirrored with its rows in reverse order. */
static void copy_grid(int copies, int copy, int grid, const float (*in)[3], float (*out)[3])
{
    for (int k = 0; k < grid * grid; k++) {
        const float *p = in[copies == 2 ? (grid - 1 - k / grid) * grid + k % grid : k];
        float turned[4][3] = {
                {p[0], p[1], p[2]}, {p[2], p[1], -p[0]}, {-p[0], p[1], -p[2]}, {-p[2], p[1], p[0]}};
        float mirrored[3] = {p[0], p[1], -p[2]};
        memcpy(out[k], copies == 2 ? mirrored : turned[copy], sizeof(float[3]));
    }
}

/* All 32 patches. Like freeglut, normals are made by the first call and kept: their last bits are those of
 * the first scale that the program draws. A zero first scale uses 1. */
static void tessellate(float scale, int grid, float (*position)[3], float (*normal)[3])
{
    int size = grid * grid;
    for (int patch = 0; patch < PATCHES; patch++) {
        int copies = patches[patch].copies;
        evaluate(patch, scale / 2, grid, position, normal);
        for (int copy = 1; copy < copies; copy++) {
            copy_grid(copies, copy, grid, (const float(*)[3])position, position + copy * size);
            if (normal)
                copy_grid(copies, copy, grid, (const float(*)[3])normal, normal + copy * size);
        }
        position += copies * size;
        normal = normal ? normal + copies * size : NULL;
    }
}

struct teapot {
    bool made;
    float scale;
    float position[COPIES * WIRE_GRID * WIRE_GRID][3];
    float normal[COPIES * WIRE_GRID * WIRE_GRID][3];
    float texcoord[COPIES * WIRE_GRID * WIRE_GRID][2];
};

static void prepare(struct teapot *t, float scale, int grid)
{
    if (!t->made) {
        tessellate(scale == 0 ? 1 : scale, grid, t->position, t->normal);
        for (int i = 0; i < COPIES * grid * grid; i++) {
            int k = i % (grid * grid);
            t->texcoord[i][0] = (float)(k / grid) / ((float)grid - 1);
            t->texcoord[i][1] = (float)(k % grid) / ((float)grid - 1);
        }
    }
    if (!t->made || t->scale != scale)
        tessellate(scale, grid, t->position, NULL);
    t->made = true;
    t->scale = scale;
}

void glutSolidTeapot(double size)
{
    enum { CELLS = SOLID_GRID - 1, CORNERS = COPIES * CELLS * CELLS * 6 };
    static struct teapot teapot;
    static GLuint index[CORNERS];
    static const GLuint corner[6] = {0, SOLID_GRID, SOLID_GRID + 1, 0, SOLID_GRID + 1, 1};

    fgl_glut_require_init("glutSolidTeapot");
    prepare(&teapot, (float)size, SOLID_GRID);
    for (int i = 0; i < CORNERS; i++) {
        int cell = i / 6, patch = cell / (CELLS * CELLS), row = cell / CELLS % CELLS, column = cell % CELLS;
        index[i] = (GLuint)(patch * SOLID_GRID * SOLID_GRID + row * SOLID_GRID + column) + corner[i % 6];
    }
    fgl_shape_begin((const float(*)[3])teapot.position, (const float(*)[3])teapot.normal);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, 0, teapot.texcoord);
    fgl_shape_draw_elements(GL_TRIANGLES, index, 1, CORNERS);
    fgl_shape_end();
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

/* The lines along u of all patches, then all those along v. */
void glutWireTeapot(double size)
{
    enum { SIZE = WIRE_GRID * WIRE_GRID };
    static struct teapot teapot;
    static GLuint index[COPIES * 2 * SIZE];

    fgl_glut_require_init("glutWireTeapot");
    prepare(&teapot, (float)size, WIRE_GRID);
    for (int i = 0; i < COPIES * SIZE; i++) {
        int patch = i / SIZE, line = i % SIZE / WIRE_GRID, step = i % WIRE_GRID;
        index[i] = (GLuint)(patch * SIZE + step * WIRE_GRID + line);
        index[i + COPIES * SIZE] = (GLuint)(patch * SIZE + line * WIRE_GRID + step);
    }
    fgl_shape_begin((const float(*)[3])teapot.position, (const float(*)[3])teapot.normal);
    fgl_shape_draw_elements(GL_LINE_STRIP, index, COPIES * 2 * WIRE_GRID, WIRE_GRID);
    fgl_shape_end();
}
