/* Cube and the other Platonic solids, and the rhombic dodecahedron, centred on the origin, faces and vertices
 * in freeglut's order. A face is flat: each of its vertices carries the face's normal, and no vertex is
 * shared between faces. */
#include <math.h>
#include <GL/freeglut.h>
#include "internal.h"
#include "shapes.h"

enum { MAX_VERTICES = 60, MAX_INDICES = 108, MAX_SIDES = 5 };

struct polyhedron {
    int faces, sides;
    double normal_length[2]; /* of faces along the z axis, and of the others: 1, but where freeglut's are not
                              */
    const double (*vertex)[3];
    const unsigned char *face; /* faces * sides indices into vertex, counter-clockwise from outside */
};

/* clang-format off: tables stand in columns */
#define A (1.0 / 3.0)
#define B 0.47140452079103168293 /* sqrt(2) / 3 */
#define C 0.81649658092772603273 /* sqrt(2 / 3) */
static const double tetrahedron_vertex[4][3] = {{1, 0, 0}, {-A, 2 * B, 0}, {-A, -B, C}, {-A, -B, -C}};
static const unsigned char tetrahedron_face[] = {1, 3, 2, 0, 2, 3, 0, 3, 1, 0, 1, 2};
#undef A
#undef B
#undef C

static const double octahedron_vertex[6][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                               {0, 0, -1}, {0, -1, 0}, {-1, 0, 0}};
static const unsigned char octahedron_face[] = {0, 1, 2, 0, 3, 1, 0, 2, 4, 0, 4, 3,
                                                5, 2, 1, 5, 1, 3, 5, 4, 2, 5, 3, 4};

#define P 1.61803398874989484820 /* golden ratio */
#define Q 0.61803398874989484820 /* its reciprocal */
static const double dodecahedron_vertex[20][3] = {
        {P, Q, 0},  {P, -Q, 0},  {1, 1, 1},   {1, 1, -1},   {1, -1, 1},  {1, -1, -1}, {Q, 0, P},
        {Q, 0, -P}, {0, P, Q},   {0, P, -Q},  {0, -P, Q},   {0, -P, -Q}, {-Q, 0, P},  {-Q, 0, -P},
        {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}, {-P, Q, 0},  {-P, -Q, 0}};
static const unsigned char dodecahedron_face[] = {8,  14, 12, 6,  2, 9,  3,  7,  13, 15, 10, 4,  6,  12, 16,
                                                  11, 17, 13, 7,  5, 6,  4,  1,  0,  2,  12, 14, 18, 19, 16,
                                                  7,  3,  0,  1,  5, 13, 17, 19, 18, 15, 0,  3,  9,  8,  2,
                                                  1,  4,  10, 11, 5, 18, 14, 8,  9,  15, 19, 17, 11, 10, 16};
#undef P
#undef Q

/* Two poles on the x axis and two pentagons at x = +-1/sqrt(5), of radius 2/sqrt(5). */
#define H 0.44721359549995793928 /* 1 / sqrt(5) */
#define R 0.89442719099991587856 /* 2 / sqrt(5) */
#define S 0.27639320225002103036 /* R cos 72 */
#define T 0.72360679774997896964 /* R cos 36 */
#define U 0.85065080835203993218 /* R sin 72 */
#define V 0.52573111211913360603 /* R sin 36 */
static const double icosahedron_vertex[12][3] = {{1, 0, 0},   {H, R, 0},    {H, S, U},   {H, S, -U},
                                                 {H, -T, V},  {H, -T, -V},  {-H, T, V},  {-H, T, -V},
                                                 {-H, -S, U}, {-H, -S, -U}, {-H, -R, 0}, {-1, 0, 0}};
static const unsigned char icosahedron_face[] = {
        0, 1, 2, 0, 2, 4, 0, 4, 5,  0, 5,  3, 0, 3, 1, 1,  6, 2, 2,  8, 4, 4,  10, 5, 5,  9,  3, 3,  7, 1,
        1, 7, 6, 2, 6, 8, 4, 8, 10, 5, 10, 9, 3, 9, 7, 11, 7, 9, 11, 6, 7, 11, 8,  6, 11, 10, 8, 11, 9, 10};
#undef H
#undef R
#undef S
#undef T
#undef U
#undef V

static const double cube_vertex[8][3] = {{.5, .5, .5},  {.5, .5, -.5},  {.5, -.5, .5},  {.5, -.5, -.5},
                                         {-.5, .5, .5}, {-.5, .5, -.5}, {-.5, -.5, .5}, {-.5, -.5, -.5}};
static const unsigned char cube_face[] = {0, 4, 6, 2, 0, 2, 3, 1, 0, 1, 5, 4,
                                          4, 5, 7, 6, 7, 3, 2, 6, 3, 7, 5, 1};

/* 2 high. Its slanted faces have normals sqrt(1/2) long, as freeglut's. */
#define D 0.70710678118654752440 /* sqrt(1/2) */
static const double rhombic_vertex[14][3] = {
        {0, 0, 1},   {D, 0, .5}, {0, D, .5},  {-D, 0, .5}, {0, -D, .5},  {D, D, 0},    {-D, D, 0},
        {-D, -D, 0}, {D, -D, 0}, {D, 0, -.5}, {0, D, -.5}, {-D, 0, -.5}, {0, -D, -.5}, {0, 0, -1}};
static const unsigned char rhombic_face[] = {0, 1,  5,  2,  0, 2,  6,  3,  0, 3,  7,  4,  0, 4,  8,  1,
                                             5, 10, 6,  2,  6, 11, 7,  3,  7, 12, 8,  4,  8, 9,  5,  1,
                                             5, 9,  13, 10, 6, 10, 13, 11, 7, 11, 13, 12, 8, 12, 13, 9};
/* clang-format on */

static const struct polyhedron tetrahedron = {4, 3, {1, 1}, tetrahedron_vertex, tetrahedron_face};
static const struct polyhedron octahedron = {8, 3, {1, 1}, octahedron_vertex, octahedron_face};
static const struct polyhedron dodecahedron = {12, 5, {1, 1}, dodecahedron_vertex, dodecahedron_face};
/* freeglut's icosahedron normals are the cross product of two edges, 0.957 long: sqrt(3)/2 * (2 - 2/sqrt(5)).
 * Kept, since a program without GL_NORMALIZE shows it. */
#define ICOSAHEDRON_NORMAL 0.957454138327394
static const struct polyhedron icosahedron = {
        20, 3, {ICOSAHEDRON_NORMAL, ICOSAHEDRON_NORMAL}, icosahedron_vertex, icosahedron_face};
static const struct polyhedron rhombic_dodecahedron = {12, 4, {1, D}, rhombic_vertex, rhombic_face};
#undef D
static const struct polyhedron cube = {6, 4, {1, 1}, cube_vertex, cube_face};

/* A regular face's normal points along the sum of its vertices. */
static void face_normal(const struct polyhedron *p, int face, float normal[3])
{
    double sum[3] = {0, 0, 0};
    for (int i = 0; i < p->sides; i++)
        for (int axis = 0; axis < 3; axis++)
            sum[axis] += p->vertex[p->face[face * p->sides + i]][axis];
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int axis = 0; axis < 3; axis++)
        normal[axis] = (float)(sum[axis] * p->normal_length[sum[2] != 0] / length);
}

static void begin_polyhedron(const struct polyhedron *p, float size)
{
    static float position[MAX_VERTICES][3], normal[MAX_VERTICES][3];
    for (int i = 0; i < p->faces * p->sides; i++) {
        for (int axis = 0; axis < 3; axis++)
            position[i][axis] = (float)p->vertex[p->face[i]][axis] * size;
        face_normal(p, i / p->sides, normal[i]);
    }
    fgl_shape_begin((const float(*)[3])position, (const float(*)[3])normal);
}

static void draw_wire(const char *name, const struct polyhedron *p, float size)
{
    fgl_glut_require_init(name);
    begin_polyhedron(p, size);
    for (int face = 0; face < p->faces; face++)
        glDrawArrays(GL_LINE_LOOP, face * p->sides, p->sides);
    fgl_shape_end();
}

/* Triangles as they are; squares and pentagons cut as freeglut cuts them, through glDrawElements. */
static void draw_solid(const char *name, const struct polyhedron *p, float size)
{
    static const GLuint cut[] = {0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 4, 4, 2, 3};
    const GLuint *corner = p->sides == 5 ? cut + 6 : cut;
    int corners = 3 * (p->sides - 2);
    GLuint index[MAX_INDICES];

    fgl_glut_require_init(name);
    begin_polyhedron(p, size);
    if (p->sides == 3) {
        glDrawArrays(GL_TRIANGLES, 0, 3 * p->faces);
    } else {
        for (int i = 0; i < p->faces * corners; i++)
            index[i] = (GLuint)(i / corners * p->sides) + corner[i % corners];
        fgl_shape_draw_elements(GL_TRIANGLES, index, 1, p->faces * corners);
    }
    fgl_shape_end();
}

void glutSolidCube(double size)
{
    draw_solid("glutSolidCube", &cube, (float)size);
}

void glutWireCube(double size)
{
    draw_wire("glutWireCube", &cube, (float)size);
}

void glutSolidTetrahedron(void)
{
    draw_solid("glutSolidTetrahedron", &tetrahedron, 1);
}

void glutWireTetrahedron(void)
{
    draw_wire("glutWireTetrahedron", &tetrahedron, 1);
}

void glutSolidOctahedron(void)
{
    draw_solid("glutSolidOctahedron", &octahedron, 1);
}

void glutWireOctahedron(void)
{
    draw_wire("glutWireOctahedron", &octahedron, 1);
}

void glutSolidDodecahedron(void)
{
    draw_solid("glutSolidDodecahedron", &dodecahedron, 1);
}

void glutWireDodecahedron(void)
{
    draw_wire("glutWireDodecahedron", &dodecahedron, 1);
}

void glutSolidIcosahedron(void)
{
    draw_solid("glutSolidIcosahedron", &icosahedron, 1);
}

void glutWireIcosahedron(void)
{
    draw_wire("glutWireIcosahedron", &icosahedron, 1);
}

void glutSolidRhombicDodecahedron(void)
{
    draw_solid("glutSolidRhombicDodecahedron", &rhombic_dodecahedron, 1);
}

void glutWireRhombicDodecahedron(void)
{
    draw_wire("glutWireRhombicDodecahedron", &rhombic_dodecahedron, 1);
}
