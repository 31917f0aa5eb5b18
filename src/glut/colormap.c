/* Colour index windows: their colormaps, and their indexes as colours (GLUT 3, section 8 "Color Index Colormap
 * Management"). Each window has its own colormap, which is looked up whenever its picture is shown or written. */
#include <string.h>
#include <GL/glut.h>
#include "internal.h"

static bool is_cell(int cell)
{
    return cell >= 0 && cell < COLORMAP_SIZE;
}

static float clamp(float v)
{
    return v > 0 ? (v < 1 ? v : 1) : 0;
}

void glutSetColor(int cell, GLfloat red, GLfloat green, GLfloat blue)
{
    struct window *w = fgl_glut_require_window("glutSetColor");
    if (!w->colormap) {
        fgl_glut_warn("glutSetColor: the window has no colormap, as it was created without GLUT_INDEX");
    } else if (!is_cell(cell)) {
        fgl_glut_warn("glutSetColor: no color %d in a colormap of %d", cell, COLORMAP_SIZE);
    } else {
        float *color = w->colormap->color[cell];
        color[0] = clamp(red);
        color[1] = clamp(green);
        color[2] = clamp(blue);
    }
}

GLfloat glutGetColor(int cell, int component)
{
    const struct window *w = fgl_glut_require_window("glutGetColor");
    if (!w->colormap || !is_cell(cell) || component < GLUT_RED || component > GLUT_BLUE)
        return -1;
    return w->colormap->color[cell][component - GLUT_RED];
}

void glutCopyColormap(int id)
{
    struct window *w = fgl_glut_require_window("glutCopyColormap");
    const struct window *from = fgl_window_find(id);
    if (!from || !from->colormap || !w->colormap)
        fgl_glut_warn("glutCopyColormap: window %d or the current one has no colormap", id);
    else
        *w->colormap = *from->colormap;
}

void fgl_colormap_show(struct window *w)
{
    unsigned char rgba[COLORMAP_SIZE][4];
    const size_t n = (size_t)w->width * (size_t)w->height;
    for (int cell = 0; cell < COLORMAP_SIZE; cell++) {
        for (int c = 0; c < 3; c++)
            rgba[cell][c] = (unsigned char)(w->colormap->color[cell][c] * 255 + 0.5f);
        rgba[cell][3] = 255;
    }
    for (size_t i = 0; i < n; i++)
        memcpy(w->pixels + 4 * i, rgba[w->indexes[i]], 4);
}
