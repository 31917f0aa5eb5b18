/* Quads over the whole window, with one fragment operation each: what a pixel costs. */
#include "scene.h"

enum { QUADS = 20 };

struct operation {
    GLenum enabled; /* 0: nothing */
    bool smooth;    /* a colour for each corner */
};

static void open(const struct scene *scene, struct instance *instance)
{
    static const GLubyte checks[128] = {0xaa, 0xaa, 0xaa, 0xaa, 0x55, 0x55, 0x55, 0x55, 0xf0, 0xf0, 0xf0, 0xf0};
    const struct operation *operation = scene->detail;

    (void)instance;
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.AlphaFunc(GL_GREATER, 0.5f);
    gl.Fogi(GL_FOG_MODE, GL_EXP2);
    gl.StencilFunc(GL_ALWAYS, 1, ~0u);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    gl.PolygonStipple(checks);
    gl.LogicOp(GL_XOR);
    if (operation->enabled)
        gl.Enable(operation->enabled);
}

static void draw_quad(bool smooth, float z)
{
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

    for (int i = 0; i < 4; i++) {
        if (smooth || i == 0)
            gl.Color4f(0.3f + 0.2f * (float)i, 0.5f, z, 0.2f + 0.2f * (float)i);
        gl.Vertex3f(corner[i][0], corner[i][1], z);
    }
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    const struct operation *operation = scene->detail;

    (void)instance;
    gl.Begin(GL_QUADS);
    for (int i = 0; i < QUADS; i++)
        draw_quad(operation->smooth, 0.9f - 0.09f * (float)i);
    gl.End();
}

#define QUAD(name, enabled, smooth) {name, 500, 4, open, draw, &(const struct operation){enabled, smooth}, false}
const struct scene fragment_scenes[] = {
    QUAD("20 quads, constant colour", 0, false),
    QUAD("20 quads, smooth colour", 0, true),
    QUAD("20 quads, depth test, constant colour", GL_DEPTH_TEST, false),
    QUAD("20 quads, depth test", GL_DEPTH_TEST, true),
    QUAD("20 quads, blend", GL_BLEND, true),
    QUAD("20 quads, fog", GL_FOG, true),
    QUAD("20 quads, alpha test", GL_ALPHA_TEST, true),
    QUAD("20 quads, stencil", GL_STENCIL_TEST, false),
    QUAD("20 quads, polygon stipple", GL_POLYGON_STIPPLE, true),
    QUAD("20 quads, logic op", GL_COLOR_LOGIC_OP, false),
    {0},
};
