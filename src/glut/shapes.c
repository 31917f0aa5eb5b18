/* Sphere and torus, and what all shapes are made with, with the tessellation of freeglut 3.4: the same
 * vertices to the last bit, in the same primitives. Every shape is a grid of vertices drawn as one triangle
 * strip per ring. */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <GL/glut.h>
#include "internal.h"
#include "shapes.h"

static struct {
    unsigned char *bytes;
    size_t size;
} scratch;

bool fgl_shape_reserve(struct shape_mesh *mesh, uint64_t vertices, uint64_t indices, int circle_points)
{
    if (vertices > INT_MAX / 64 || indices > INT_MAX / 64) {
        fgl_glut_warn("a shape of %llu vertices is too large", (unsigned long long)vertices);
        return false;
    }
    size_t size = 2 * (size_t)vertices * sizeof(float[3]) + (size_t)indices * sizeof(GLuint) +
                  (size_t)circle_points * sizeof(float[2]);
    if (size > scratch.size) {
        unsigned char *bytes = realloc(scratch.bytes, size);
        if (!bytes) {
            fgl_glut_warn("no memory for a shape of %llu vertices", (unsigned long long)vertices);
            return false;
        }
        scratch.bytes = bytes;
        scratch.size = size;
    }
    mesh->position = (float(*)[3])(void *)scratch.bytes;
    mesh->normal = mesh->position + vertices;
    mesh->index = (GLuint *)(void *)(mesh->normal + vertices);
    mesh->circle = (float(*)[2])(void *)(mesh->index + indices);
    return true;
}

void fgl_shape_begin(const float (*position)[3], const float (*normal)[3])
{
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, position);
    glNormalPointer(GL_FLOAT, 0, normal);
}

void fgl_shape_end(void)
{
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_NORMAL_ARRAY);
}

void fgl_shape_draw_elements(GLenum mode, const GLuint *index, int count, int length)
{
    for (int i = 0; i < count; i++)
        glDrawElements(mode, length, GL_UNSIGNED_INT, index + (size_t)i * (size_t)length);
}

static const float PI = 3.14159265358979323846f, TWO_PI = 6.28318530717958647692f;

void fgl_shape_set(float out[3], float x, float y, float z)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

/* Cosine and sine of step i around a circle cut in n parts; negative n runs clockwise. freeglut's roundings:
 * the step and the angle in float, the functions in double, their results to float. +0 for sin 0 either way.
 */
static void circle_point(int i, int n, float whole, float *cosine, float *sine)
{
    float angle = whole / (float)n * (float)i;
    *cosine = (float)cos((double)angle);
    *sine = i ? (float)sin((double)angle) : 0;
}

void fgl_shape_circle(float (*circle)[2], int n)
{
    for (int i = 0; i < n; i++)
        circle_point(i, -n, TWO_PI, &circle[i][0], &circle[i][1]);
}

GLuint *fgl_shape_ring_strip(GLuint *out, GLuint first, GLuint second, int n)
{
    for (int j = 0; j <= n; j++) {
        GLuint step = (GLuint)(j == n ? 0 : j);
        *out++ = first + step;
        *out++ = second + step;
    }
    return out;
}

GLuint *fgl_shape_cap_strip(GLuint *out, GLuint ring, GLuint pole, int n, bool pole_first)
{
    for (int j = 0; j <= n; j++) {
        GLuint on_ring = ring + (GLuint)(j == n ? 0 : j);
        *out++ = pole_first ? pole : on_ring;
        *out++ = pole_first ? on_ring : pole;
    }
    return out;
}

/* ---- sphere: pole, stacks - 1 rings of `slices` vertices from +z to -z, pole ---- */

static bool make_sphere(struct shape_mesh *m, float radius, int slices, int stacks)
{
    if (slices < 1 || stacks < 2)
        return false;
    uint64_t vertices = (uint64_t)slices * (uint64_t)(stacks - 1) + 2;
    uint64_t indices = 2 * ((uint64_t)slices + 1) * (uint64_t)stacks + vertices;
    if (!fgl_shape_reserve(m, vertices, indices, slices))
        return false;
    fgl_shape_circle(m->circle, slices);
    size_t v = 0;
    fgl_shape_set(m->position[v], 0, 0, radius);
    fgl_shape_set(m->normal[v++], 0, 0, 1);
    for (int i = 1; i < stacks; i++) {
        float z, r;
        circle_point(i, stacks, PI, &z, &r);
        for (int j = 0; j < slices; j++, v++) {
            float c = m->circle[j][0], s = m->circle[j][1];
            fgl_shape_set(m->normal[v], c * r, s * r, z);
            fgl_shape_set(m->position[v], c * r * radius, s * r * radius, z * radius);
        }
    }
    fgl_shape_set(m->position[v], 0, 0, -radius);
    fgl_shape_set(m->normal[v], 0, 0, -1);
    return true;
}

void glutSolidSphere(double radius, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutSolidSphere");
    if (!make_sphere(&m, (float)radius, slices, stacks))
        return;
    GLuint last = (GLuint)slices * (GLuint)(stacks - 1) + 1;
    GLuint *out = fgl_shape_cap_strip(m.index, 1, 0, slices, false);
    for (int i = 1; i < stacks - 1; i++) {
        GLuint ring = 1 + (GLuint)(i - 1) * (GLuint)slices;
        out = fgl_shape_ring_strip(out, ring + (GLuint)slices, ring, slices);
    }
    fgl_shape_cap_strip(out, last - (GLuint)slices, last, slices, true);
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_TRIANGLE_STRIP, m.index, stacks, 2 * (slices + 1));
    fgl_shape_end();
}

void glutWireSphere(double radius, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutWireSphere");
    if (!make_sphere(&m, (float)radius, slices, stacks))
        return;
    GLuint *meridian = m.index, *parallel = m.index + (uint64_t)slices * ((uint64_t)stacks + 1);
    GLuint last = (GLuint)slices * (GLuint)(stacks - 1) + 1;
    GLuint *out = meridian;
    for (int j = 0; j < slices; j++) {
        *out++ = 0;
        for (int i = 1; i < stacks; i++)
            *out++ = 1 + (GLuint)(i - 1) * (GLuint)slices + (GLuint)j;
        *out++ = last;
    }
    for (GLuint i = 1; i < last; i++)
        *out++ = i;
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_LINE_STRIP, meridian, slices, stacks + 1);
    fgl_shape_draw_elements(GL_LINE_LOOP, parallel, stacks - 1, slices);
    fgl_shape_end();
}

/* ---- torus: `rings` circles of `sides` vertices, around the z axis ---- */

static bool make_torus(struct shape_mesh *m, float inner, float outer, int sides, int rings)
{
    if (sides < 2 || rings < 2)
        return false;
    uint64_t vertices = (uint64_t)sides * (uint64_t)rings;
    if (!fgl_shape_reserve(m, vertices, 2 * ((uint64_t)rings + 1) * (uint64_t)sides, sides))
        return false;
    fgl_shape_circle(m->circle, sides);
    size_t v = 0;
    for (int j = 0; j < rings; j++) {
        float c_ring, s_ring;
        circle_point(j, rings, TWO_PI, &c_ring, &s_ring);
        for (int i = 0; i < sides; i++, v++) {
            float c = m->circle[i][0], s = m->circle[i][1];
            float r = outer + c * inner;
            fgl_shape_set(m->position[v], c_ring * r, s_ring * r, s * inner);
            fgl_shape_set(m->normal[v], c_ring * c, s_ring * c, s);
        }
    }
    return true;
}

void glutSolidTorus(double inner, double outer, GLint sides, GLint rings)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutSolidTorus");
    if (!make_torus(&m, (float)inner, (float)outer, sides, rings))
        return;
    GLuint *out = m.index;
    for (int i = 0; i < sides; i++)
        for (int j = 0; j <= rings; j++) {
            GLuint ring = (GLuint)(j % rings) * (GLuint)sides;
            *out++ = ring + (GLuint)i;
            *out++ = ring + (GLuint)((i + 1) % sides);
        }
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_TRIANGLE_STRIP, m.index, sides, 2 * (rings + 1));
    fgl_shape_end();
}

void glutWireTorus(double inner, double outer, GLint sides, GLint rings)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutWireTorus");
    if (!make_torus(&m, (float)inner, (float)outer, sides, rings))
        return;
    GLuint n = (GLuint)sides * (GLuint)rings, *out = m.index;
    for (GLuint i = 0; i < n; i++)
        *out++ = i;
    for (int i = 0; i < sides; i++)
        for (int j = 0; j < rings; j++)
            *out++ = (GLuint)j * (GLuint)sides + (GLuint)i;
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_LINE_LOOP, m.index, rings, sides);
    fgl_shape_draw_elements(GL_LINE_LOOP, m.index + n, sides, rings);
    fgl_shape_end();
}
