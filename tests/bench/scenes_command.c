/* Thousands of tiny draws: what a command costs. */
#include "scene.h"

enum { DRAWS = 5000 };

enum change { NOTHING, COLOR, MATRIX, ENABLES, MATERIAL };

static void open(const struct scene *scene, struct instance *instance)
{
    const enum change *change = scene->detail;

    (void)instance;
    if (*change == MATERIAL) {
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
    }
}

static void change_state(enum change change, int i)
{
    const float v = (float)(i % 64) / 64;

    switch (change) {
    case NOTHING: break;
    case COLOR: gl.Color4f(v, 1 - v, 0.5f, 1); break;
    case MATRIX:
        gl.PushMatrix();
        gl.Translatef(v - 0.5f, 0.5f - v, 0);
        break;
    case ENABLES:
        (i & 1 ? gl.Enable : gl.Disable)(GL_DEPTH_TEST);
        (i & 2 ? gl.Enable : gl.Disable)(GL_BLEND);
        break;
    case MATERIAL: gl.Materialfv(GL_FRONT, GL_DIFFUSE, (float[]){v, 1 - v, 0.5f, 1}); break;
    }
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    const enum change *change = scene->detail;

    (void)instance;
    for (int i = 0; i < DRAWS; i++) {
        const float x = -0.9f + 0.02f * (float)(i % 90), y = -0.9f + 0.02f * (float)(i / 90);
        change_state(*change, i);
        gl.Begin(GL_TRIANGLES);
        gl.Vertex2f(x, y);
        gl.Vertex2f(x + 0.02f, y);
        gl.Vertex2f(x, y + 0.02f);
        gl.End();
        if (*change == MATRIX)
            gl.PopMatrix();
    }
}

#define TINY(name, what) {name, 500, 4, open, draw, &(const enum change){what}, false}
const struct scene command_scenes[] = {
    TINY("5,000 triangles, a glBegin each", NOTHING),
    TINY("5,000 triangles, a glColor each", COLOR),
    TINY("5,000 triangles, a matrix each", MATRIX),
    TINY("5,000 triangles, enables before each", ENABLES),
    TINY("5,000 triangles, a material each", MATERIAL),
    {0},
};
