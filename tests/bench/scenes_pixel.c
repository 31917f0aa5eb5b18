/* Clears, pixel rectangles, bitmaps and the accumulation buffer. */
#include "scene.h"

enum { SIZE = 512, REPEATS = 10, TEXT_ROWS = 60, TEXT_COLUMNS = 80, GLYPH_WIDTH = 8, GLYPH_HEIGHT = 8 };

enum action { CLEAR, READ, DRAW, COPY, TEXT, ACCUMULATE };

struct rectangle {
    enum action action;
    GLenum format, type; /* of the image; of what is copied: format alone */
    float zoom;
    GLenum enabled; /* 0: nothing */
};

/* An image of bytes that are no NaN as floats. */
static void open(const struct scene *scene, struct instance *instance)
{
    const struct rectangle *rectangle = scene->detail;
    const size_t pixels = (size_t)scene->size * (size_t)scene->size;
    unsigned seed = 1;

    instance->image = allocate(pixels, 16);
    for (size_t i = 0; i < 4 * pixels; i++)
        if (rectangle->type == GL_FLOAT)
            ((float *)instance->image)[i] = random_float(&seed);
        else
            ((GLuint *)instance->image)[i] = (GLuint)((double)random_float(&seed) * 4294967295.0);
    gl.PixelZoom(rectangle->zoom, rectangle->zoom);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (rectangle->enabled)
        gl.Enable(rectangle->enabled);
}

static void draw_text(void)
{
    static const GLubyte glyph[GLYPH_HEIGHT] = {0x00, 0x82, 0x82, 0xfe, 0x44, 0x28, 0x10, 0x10}; /* A, bottom row first */

    gl.Color4f(1, 1, 0, 1);
    for (int row = 0; row < TEXT_ROWS; row++) {
        gl.RasterPos2f(-1, -0.99f + 2.0f * (float)row / TEXT_ROWS);
        for (int i = 0; i < TEXT_COLUMNS; i++)
            gl.Bitmap(GLYPH_WIDTH, GLYPH_HEIGHT, 0, 0, 6, 0, glyph);
    }
}

static void accumulate(void)
{
    gl.Accum(GL_LOAD, 0.5f);
    gl.Accum(GL_ACCUM, 0.4f);
    gl.Accum(GL_ADD, 0.1f);
    gl.Accum(GL_MULT, 0.9f);
    gl.Accum(GL_RETURN, 1);
}

/* A point follows each clear: clears of what nobody saw could be left out. */
static void clear(GLbitfield buffers)
{
    gl.Clear(buffers);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(0, 0);
    gl.End();
}

static void act(const struct scene *scene, const struct rectangle *r, void *image)
{
    const int size = scene->size, part = (int)((float)size / r->zoom);

    switch (r->action) {
    case CLEAR: clear(r->format); break;
    case READ: gl.ReadPixels(0, 0, size, size, r->format, r->type, image); break;
    case DRAW: gl.DrawPixels(part, part, r->format, r->type, image); break;
    case COPY: gl.CopyPixels(0, 0, part, part, r->format); break;
    case TEXT: draw_text(); break;
    case ACCUMULATE: accumulate(); break;
    }
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    const struct rectangle *rectangle = scene->detail;

    gl.RasterPos2f(-1, -1);
    for (int i = 0; i < REPEATS; i++)
        act(scene, rectangle, instance->image);
}

#define PIXELS(name, ...) {name, SIZE, 2, open, draw, &(const struct rectangle){__VA_ARGS__}, false}
const struct scene pixel_scenes[] = {
    PIXELS("10 clears of colour and depth", CLEAR, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, 0, 1, 0),
    PIXELS("10 clears of all four buffers", CLEAR,
           GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT, 0, 1, 0),
    PIXELS("glReadPixels RGBA bytes", READ, GL_RGBA, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glReadPixels RGB bytes", READ, GL_RGB, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glReadPixels RGBA floats", READ, GL_RGBA, GL_FLOAT, 1, 0),
    PIXELS("glReadPixels luminance bytes", READ, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glReadPixels depth floats", READ, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 0),
    PIXELS("glReadPixels depth unsigned ints", READ, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1, 0),
    PIXELS("glReadPixels stencil bytes", READ, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glDrawPixels RGBA bytes", DRAW, GL_RGBA, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glDrawPixels RGB bytes", DRAW, GL_RGB, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glDrawPixels luminance bytes", DRAW, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glDrawPixels RGBA floats", DRAW, GL_RGBA, GL_FLOAT, 1, 0),
    PIXELS("glDrawPixels RGBA bytes, zoom 3", DRAW, GL_RGBA, GL_UNSIGNED_BYTE, 3, 0),
    PIXELS("glDrawPixels RGBA bytes, blend", DRAW, GL_RGBA, GL_UNSIGNED_BYTE, 1, GL_BLEND),
    PIXELS("glDrawPixels depth floats", DRAW, GL_DEPTH_COMPONENT, GL_FLOAT, 1, GL_DEPTH_TEST),
    PIXELS("glDrawPixels stencil bytes", DRAW, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, 0),
    PIXELS("glCopyPixels colour", COPY, GL_COLOR, 0, 1, 0),
    PIXELS("glCopyPixels colour, zoom 3", COPY, GL_COLOR, 0, 3, 0),
    PIXELS("glCopyPixels depth", COPY, GL_DEPTH, 0, 1, GL_DEPTH_TEST),
    PIXELS("bitmap text, 48,000 glyphs", TEXT, 0, 0, 1, 0),
    PIXELS("glAccum, 10 times all five operations", ACCUMULATE, 0, 0, 1, 0),
    {0},
};
