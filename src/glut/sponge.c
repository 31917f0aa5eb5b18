/* Sierpinski's sponge: a tetrahedron of four smaller ones, each made of four. */
#include <GL/freeglut.h>
#include "internal.h"
#include "shapes.h"

enum { FACES = 4, SIDES = 3, MAX_LEVEL = 10 }; /* 4^10 tetrahedra are 300 MB */

static const float corner[4][3] = {{1, 0, 0},
                                   {-0.33333333333f, 0.94280904158f, 0},
                                   {-0.33333333333f, -0.47140452079f, 0.81649658093f},
                                   {-0.33333333333f, -0.47140452079f, -0.81649658093f}};
static const unsigned char face[FACES][SIDES] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

/* One tetrahedron, its faces' normals opposite of the corner that they lack. */
static void put_tetrahedron(struct shape_mesh *m, size_t *vertices, const double offset[3], float scale)
{
    for (int f = 0; f < FACES; f++)
        for (int i = 0; i < SIDES; i++, ++*vertices)
            for (int axis = 0; axis < 3; axis++) {
                m->position[*vertices][axis] = (float)offset[axis] + corner[face[f][i]][axis] * scale;
                m->normal[*vertices][axis] = 0 - corner[f][axis]; /* no -0 */
            }
}

/* freeglut's roundings: offsets in double, to which products in float are added. */
static void put_sponge(struct shape_mesh *m, size_t *vertices, int level, const double offset[3], float scale)
{
    if (level == 0) {
        put_tetrahedron(m, vertices, offset, scale);
        return;
    }
    for (int i = 0; i < 4; i++) {
        double at[3];
        for (int axis = 0; axis < 3; axis++)
            at[axis] = offset[axis] + (double)(corner[i][axis] * (scale / 2));
        put_sponge(m, vertices, level - 1, at, scale / 2);
    }
}

static size_t make_sponge(struct shape_mesh *m, int level, const double offset[3], double scale)
{
    size_t vertices = 0;
    if (level < 0)
        return 0;
    if (level > MAX_LEVEL) {
        fgl_glut_warn("a sponge of %d levels is too large", level);
        return 0;
    }
    if (fgl_shape_reserve(m, (uint64_t)FACES * SIDES << 2 * level, 0, 0))
        put_sponge(m, &vertices, level, offset, (float)scale);
    return vertices;
}

void glutSolidSierpinskiSponge(int levels, double offset[3], double scale)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutSolidSierpinskiSponge");
    size_t vertices = make_sponge(&m, levels, offset, scale);
    if (vertices == 0)
        return;
    fgl_shape_begin(m.position, m.normal);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)vertices);
    fgl_shape_end();
}

void glutWireSierpinskiSponge(int levels, double offset[3], double scale)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutWireSierpinskiSponge");
    size_t vertices = make_sponge(&m, levels, offset, scale);
    if (vertices == 0)
        return;
    fgl_shape_begin(m.position, m.normal);
    for (size_t first = 0; first < vertices; first += SIDES)
        glDrawArrays(GL_LINE_LOOP, (GLint)first, SIDES);
    fgl_shape_end();
}
