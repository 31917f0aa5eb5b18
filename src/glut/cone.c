/* Cone and cylinder, freeglut 3.4's to the last bit: rings of `slices` vertices from the base up. */
#include <math.h>
#include <GL/freeglut.h>
#include "internal.h"
#include "shapes.h"

/* Straight lines up the side, and the first `rings` rings around it. */
static void draw_wire(const struct shape_mesh *m, int slices, int stacks, int rings)
{
    GLuint n = (GLuint)slices;
    GLuint *side = m->index, *ring = m->index + 2 * n;
    for (GLuint j = 0; j < n; j++) {
        side[2 * j] = 1 + n + j;
        side[2 * j + 1] = 1 + n * ((GLuint)stacks + 1) + j;
    }
    for (GLuint i = 0; i < n * (GLuint)rings; i++)
        ring[i] = 1 + n + i;
    fgl_shape_begin(m->position, m->normal);
    fgl_shape_draw_elements(GL_LINES, side, 1, 2 * slices);
    fgl_shape_draw_elements(GL_LINE_LOOP, ring, rings, slices);
    fgl_shape_end();
}

/* ---- cone: base centre, base ring facing -z, then stacks + 1 rings up to the apex ---- */

static bool make_cone(struct shape_mesh *m, float base, float height, int slices, int stacks)
{
    if (slices < 1 || stacks < 1)
        return false;
    uint64_t vertices = (uint64_t)slices * ((uint64_t)stacks + 2) + 1;
    uint64_t indices = 2 * ((uint64_t)slices + 1) * ((uint64_t)stacks + 1) + 2 * (uint64_t)slices;
    if (!fgl_shape_reserve(m, vertices, indices, slices))
        return false;
    fgl_shape_circle(m->circle, slices);
    float slant = sqrtf(height * height + base * base);
    float normal_xy = height / slant, normal_z = base / slant;
    float z_step = height / (float)stacks, r_step = base / (float)stacks;
    float z = 0, r = base;
    size_t v = 0;
    fgl_shape_set(m->position[v], 0, 0, 0);
    fgl_shape_set(m->normal[v++], 0, 0, -1);
    for (int i = -1; i <= stacks; i++) {
        for (int j = 0; j < slices; j++, v++) {
            float c = m->circle[j][0], s = m->circle[j][1];
            fgl_shape_set(m->position[v], c * r, s * r, z);
            if (i < 0)
                fgl_shape_set(m->normal[v], 0, 0, -1);
            else
                fgl_shape_set(m->normal[v], c * normal_xy, s * normal_xy, normal_z);
        }
        if (i >= 0) {
            z += z_step;
            r -= r_step;
        }
    }
    return true;
}

void glutSolidCone(double base, double height, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutSolidCone");
    if (!make_cone(&m, (float)base, (float)height, slices, stacks))
        return;
    GLuint *out = fgl_shape_cap_strip(m.index, 1, 0, slices, true);
    for (int i = 1; i <= stacks; i++) {
        GLuint ring = 1 + (GLuint)i * (GLuint)slices;
        out = fgl_shape_ring_strip(out, ring, ring + (GLuint)slices, slices);
    }
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_TRIANGLE_STRIP, m.index, stacks + 1, 2 * (slices + 1));
    fgl_shape_end();
}

void glutWireCone(double base, double height, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutWireCone");
    if (make_cone(&m, (float)base, (float)height, slices, stacks))
        draw_wire(&m, slices, stacks, stacks);
}

/* ---- cylinder: base centre, base ring facing -z, stacks + 1 rings up, top ring facing +z, top centre ----
 */

static bool make_cylinder(struct shape_mesh *m, float radius, float height, int slices, int stacks)
{
    if (slices < 1 || stacks < 1)
        return false;
    uint64_t vertices = (uint64_t)slices * ((uint64_t)stacks + 3) + 2;
    uint64_t indices = 2 * ((uint64_t)slices + 1) * ((uint64_t)stacks + 2) + 2 * (uint64_t)slices;
    if (!fgl_shape_reserve(m, vertices, indices, slices))
        return false;
    fgl_shape_circle(m->circle, slices);
    float z_step = height / (float)stacks, z = 0;
    size_t v = 0;
    fgl_shape_set(m->position[v], 0, 0, 0);
    fgl_shape_set(m->normal[v++], 0, 0, -1);
    for (int i = -1; i <= stacks + 1; i++) {
        bool cap = i < 0 || i > stacks;
        for (int j = 0; j < slices; j++, v++) {
            float c = m->circle[j][0], s = m->circle[j][1];
            fgl_shape_set(m->position[v], c * radius, s * radius, z);
            fgl_shape_set(m->normal[v], cap ? 0 : c, cap ? 0 : s, i < 0 ? -1 : cap ? 1 : 0);
        }
        if (i >= 0 && i < stacks)
            z += z_step;
    }
    fgl_shape_set(m->position[v], 0, 0, height);
    fgl_shape_set(m->normal[v], 0, 0, 1);
    return true;
}

void glutSolidCylinder(double radius, double height, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutSolidCylinder");
    if (!make_cylinder(&m, (float)radius, (float)height, slices, stacks))
        return;
    GLuint n = (GLuint)slices, top = 1 + n * ((GLuint)stacks + 2);
    GLuint *out = fgl_shape_cap_strip(m.index, 1, 0, slices, true);
    for (GLuint ring = 1 + n; ring + n < top; ring += n)
        out = fgl_shape_ring_strip(out, ring, ring + n, slices);
    fgl_shape_cap_strip(out, top, top + n, slices, false);
    fgl_shape_begin(m.position, m.normal);
    fgl_shape_draw_elements(GL_TRIANGLE_STRIP, m.index, stacks + 2, 2 * (slices + 1));
    fgl_shape_end();
}

void glutWireCylinder(double radius, double height, GLint slices, GLint stacks)
{
    struct shape_mesh m;
    fgl_glut_require_init("glutWireCylinder");
    if (make_cylinder(&m, (float)radius, (float)height, slices, stacks))
        draw_wire(&m, slices, stacks, stacks + 1);
}
