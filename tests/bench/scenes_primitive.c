/* Many lines, points and triangles, unlit: what assembly and rasterization cost. */
#include "scene.h"

enum { LINES = 20000, POINTS = 100000, TRIANGLES = 300 };

/* Vertices in the square from -1.5 to 1.5; those of a line or triangle at most `reach` from its first in each coordinate. */
struct soup {
    GLenum mode;
    int vertices;
    float reach;
    GLenum enabled; /* 0: nothing */
    float size;     /* line width or point size */
};

static int vertices_of(GLenum mode)
{
    return mode == GL_POINTS ? 1 : mode == GL_LINES ? 2 : 3;
}

static void open(const struct scene *scene, struct instance *instance)
{
    const struct soup *soup = scene->detail;
    const int group = vertices_of(soup->mode);
    unsigned seed = 1;

    instance->position = allocate((size_t)soup->vertices, sizeof *instance->position);
    instance->color = allocate((size_t)soup->vertices, sizeof *instance->color);
    for (int i = 0; i < soup->vertices; i++)
        for (int c = 0; c < 3; c++) {
            const float v = random_float(&seed);
            instance->position[i][c] =
                i % group == 0 ? 3 * v - 1.5f : instance->position[i - i % group][c] + soup->reach * (2 * v - 1);
            instance->color[i][c] = random_float(&seed);
        }
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(-1.5, 1.5, -1.5, 1.5, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    gl.Translatef(0, 0, -4);
    gl.Enable(GL_DEPTH_TEST);
    gl.LineWidth(soup->size);
    gl.PointSize(soup->size);
    gl.LineStipple(1, 0x0f0f);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (soup->enabled)
        gl.Enable(soup->enabled);
    if (soup->enabled == GL_LINE_SMOOTH)
        gl.Enable(GL_BLEND);
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    const struct soup *soup = scene->detail;

    gl.Begin(soup->mode);
    for (int i = 0; i < soup->vertices; i++) {
        gl.Color3fv(instance->color[i]);
        gl.Vertex3fv(instance->position[i]);
    }
    gl.End();
}

#define SOUP(name, size, frames, ...) {name, size, frames, open, draw, &(const struct soup){__VA_ARGS__}, false}
const struct scene primitive_scenes[] = {
    SOUP("300 smooth triangles, 1024x1024", 1024, 4, GL_TRIANGLES, 3 * TRIANGLES, 1.5f, 0, 1),
    {"300 smooth triangles, 1024x1024, exact", 1024, 4, open, draw,
     &(const struct soup){GL_TRIANGLES, 3 * TRIANGLES, 1.5f, 0, 1}, true},
    SOUP("20,000 lines", 500, 4, GL_LINES, 2 * LINES, 0.2f, 0, 1),
    SOUP("20,000 lines, 5 wide", 500, 2, GL_LINES, 2 * LINES, 0.2f, 0, 5),
    SOUP("20,000 lines, smooth", 500, 2, GL_LINES, 2 * LINES, 0.2f, GL_LINE_SMOOTH, 1),
    SOUP("20,000 lines, stippled", 500, 2, GL_LINES, 2 * LINES, 0.2f, GL_LINE_STIPPLE, 1),
    SOUP("100,000 points", 500, 4, GL_POINTS, POINTS, 0, 0, 1),
    SOUP("100,000 points, 4 wide", 500, 2, GL_POINTS, POINTS, 0, 0, 4),
    SOUP("100,000 points, smooth", 500, 2, GL_POINTS, POINTS, 0, GL_POINT_SMOOTH, 4),
    {0},
};
