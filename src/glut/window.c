/* Windows. Each has an OSMesa context and one RGBA buffer, besides one of indexes with GLUT_INDEX; a child
 * window is one drawn over its parent. */
#include <stdlib.h>
#include <string.h>
#include <GL/freeglut.h>
#include "internal.h"

struct window *fgl_window_find(int id)
{
    for (struct window *w = fgl_glut.windows; w; w = w->next)
        if (w->id == id && !w->destroyed)
            return w;
    return NULL;
}

struct window *fgl_window_root(struct window *w)
{
    while (w->parent)
        w = w->parent;
    return w;
}

void fgl_window_make_current(struct window *w)
{
    if (!OSMesaMakeCurrent(w->context, w->colormap ? w->indexes : w->pixels, GL_UNSIGNED_BYTE, w->width,
                           w->height))
        fgl_glut_fail(1, "cannot draw pictures of %d x %d", w->width, w->height);
    fgl_glut.current = w;
}

void fgl_window_finish(struct window *w)
{
    struct window *current = fgl_glut.current;
    fgl_window_make_current(w);
    glFinish();
    if (w->colormap)
        fgl_colormap_show(w);
    if (current && current != w)
        fgl_window_make_current(current);
}

void fgl_window_resize(struct window *w, int width, int height)
{
    unsigned char *pixels = calloc((size_t)width * 4, (size_t)height);
    unsigned char *indexes = w->colormap ? calloc((size_t)width, (size_t)height) : NULL;
    if (!pixels || (w->colormap && !indexes))
        fgl_glut_fail(1, "no memory for a picture of %d x %d", width, height);
    unsigned char *old = w->pixels, *old_indexes = w->indexes;
    w->pixels = pixels;
    w->indexes = indexes;
    w->width = w->wanted_width = width;
    w->height = w->wanted_height = height;
    w->reshape = w->redisplay = true;
    struct window *current = fgl_glut.current;
    fgl_window_make_current(w);
    free(old); /* only now: one was the context's buffer */
    free(old_indexes);
    if (current && current != w)
        fgl_window_make_current(current);
}

static void append(struct window *w)
{
    struct window **link = &fgl_glut.windows;
    while (*link)
        link = &(*link)->next;
    *link = w;
    w->next = NULL;
}

static void unlink_window(struct window *w)
{
    struct window **link = &fgl_glut.windows;
    while (*link != w)
        link = &(*link)->next;
    *link = w->next;
}

/* Depth and stencil are always there, as every OSMesa picture is drawn; accumulation only when asked for. */
static void create_context(struct window *w)
{
    bool indexed = w->mode & GLUT_INDEX;
    w->context = OSMesaCreateContextExt(indexed ? OSMESA_COLOR_INDEX : OSMESA_RGBA, 24, 8,
                                        w->mode & GLUT_ACCUM ? 16 : 0, NULL);
    if (!w->context)
        fgl_glut_fail(1, "cannot create a context%s", indexed ? " in color index mode" : "");
    if (indexed && !(w->colormap = calloc(1, sizeof *w->colormap)))
        fgl_glut_fail(1, "no memory for a colormap");
}

static struct window *create(struct window *parent, int x, int y, int width, int height)
{
    struct window *w = calloc(1, sizeof *w);
    if (!w)
        fgl_glut_fail(1, "no memory for a window");
    w->id = ++fgl_glut.last_window_id;
    w->parent = parent;
    w->x = x;
    w->y = y;
    w->mode = parent ? parent->mode : fgl_glut.mode;
    w->cursor = GLUT_CURSOR_INHERIT;
    w->shown = true;
    create_context(w);
    append(w);
    fgl_glut.current = w;
    fgl_window_resize(w, width, height);
    return w;
}

int glutCreateWindow(const char *title)
{
    fgl_glut_require_init("glutCreateWindow");
    bool forced = fgl_glut.forced_width > 0;
    struct window *w = create(NULL, fgl_glut.x, fgl_glut.y, forced ? fgl_glut.forced_width : fgl_glut.width,
                              forced ? fgl_glut.forced_height : fgl_glut.height);
    if (fgl_glut.headless)
        fgl_headless_window_created();
    else
        fgl_platform_open(w, title ? title : "");
    return w->id;
}

int glutCreateSubWindow(int parent, int x, int y, int width, int height)
{
    fgl_glut_require_init("glutCreateSubWindow");
    struct window *p = fgl_window_find(parent);
    if (!p || width <= 0 || height <= 0) {
        fgl_glut_warn("glutCreateSubWindow: no window %d, or a size that is not positive", parent);
        return 0;
    }
    return create(p, x, y, width, height)->id;
}

void glutDestroyWindow(int id)
{
    fgl_glut_require_init("glutDestroyWindow");
    struct window *w = fgl_window_find(id);
    if (!w) {
        fgl_glut_warn("glutDestroyWindow: no window %d", id);
        return;
    }
    for (struct window *child = fgl_glut.windows; child; child = child->next)
        if (child->parent == w && !child->destroyed)
            glutDestroyWindow(child->id);
    fgl_loop_run_close(w);
    if (fgl_glut.headless)
        fgl_headless_window_destroyed(w);
    w->destroyed = true; /* freed by the main loop: it may be running this window's callback */
    if (fgl_glut.current == w)
        fgl_glut.current = NULL;
    if (fgl_glut.grab == w)
        fgl_glut.grab = NULL;
}

bool fgl_window_collect(void)
{
    struct window *w = fgl_glut.windows;
    while (w) {
        struct window *next = w->next;
        if (w->destroyed) {
            unlink_window(w);
            if (w->platform)
                fgl_platform_close(w);
            OSMesaDestroyContext(w->context);
            free(w->pixels);
            free(w->indexes);
            free(w->colormap);
            free(w);
        }
        w = next;
    }
    return fgl_glut.windows != NULL;
}

struct window *fgl_window_at(struct window *w, int *x, int *y)
{
    struct window *found = NULL;
    for (struct window *child = fgl_glut.windows; child; child = child->next)
        if (child->parent == w && child->shown && !child->destroyed && *x >= child->x && *y >= child->y &&
            *x < child->x + child->width && *y < child->y + child->height)
            found = child;
    if (!found)
        return w;
    *x -= found->x;
    *y -= found->y;
    return fgl_window_at(found, x, y);
}

void glutSetWindow(int id)
{
    fgl_glut_require_init("glutSetWindow");
    struct window *w = fgl_window_find(id);
    if (!w)
        fgl_glut_warn("glutSetWindow: no window %d", id);
    else if (w != fgl_glut.current)
        fgl_window_make_current(w);
}

int glutGetWindow(void)
{
    fgl_glut_require_init("glutGetWindow");
    return fgl_glut.current ? fgl_glut.current->id : 0;
}

void glutSetWindowTitle(const char *title)
{
    struct window *w = fgl_glut_require_window("glutSetWindowTitle");
    if (w->platform)
        fgl_platform_set_title(w, title);
}

void glutSetIconTitle(const char *title)
{
    (void)title; /* today's window managers have no icon titles */
    fgl_glut_require_window("glutSetIconTitle");
}

void glutReshapeWindow(int width, int height)
{
    struct window *w = fgl_glut_require_window("glutReshapeWindow");
    if (width <= 0 || height <= 0) {
        fgl_glut_warn("glutReshapeWindow(%d, %d) is not a size", width, height);
    } else if (w->platform) {
        fgl_platform_set_size(w, width, height);
    } else {
        w->wanted_width = width;
        w->wanted_height = height;
    }
}

void glutPositionWindow(int x, int y)
{
    struct window *w = fgl_glut_require_window("glutPositionWindow");
    w->x = x;
    w->y = y;
    if (w->platform)
        fgl_platform_set_position(w, x, y);
    else if (w->parent)
        fgl_window_root(w)->redisplay = true;
}

void glutFullScreen(void)
{
    struct window *w = fgl_glut_require_window("glutFullScreen");
    if (w->platform)
        fgl_platform_full_screen(w);
}

void glutLeaveFullScreen(void)
{
    struct window *w = fgl_glut_require_window("glutLeaveFullScreen");
    if (w->platform)
        fgl_platform_leave_full_screen(w);
}

void glutFullScreenToggle(void)
{
    struct window *w = fgl_glut_require_window("glutFullScreenToggle");
    if (w->platform && fgl_platform_is_full_screen(w))
        fgl_platform_leave_full_screen(w);
    else if (w->platform)
        fgl_platform_full_screen(w);
}

void *glutGetWindowData(void)
{
    return fgl_glut_require_window("glutGetWindowData")->data;
}

void glutSetWindowData(void *data)
{
    fgl_glut_require_window("glutSetWindowData")->data = data;
}

static void show(const char *function, bool shown)
{
    struct window *w = fgl_glut_require_window(function);
    w->redisplay = w->redisplay || (shown && !w->shown);
    w->shown = shown;
    if (w->platform)
        fgl_platform_show(w, shown);
}

void glutShowWindow(void)
{
    show("glutShowWindow", true);
}

void glutHideWindow(void)
{
    show("glutHideWindow", false);
}

void glutIconifyWindow(void)
{
    struct window *w = fgl_glut_require_window("glutIconifyWindow");
    if (w->platform)
        fgl_platform_iconify(w);
    else
        w->shown = false;
}

void glutPopWindow(void)
{
    struct window *w = fgl_glut_require_window("glutPopWindow");
    unlink_window(w);
    append(w);
}

void glutPushWindow(void)
{
    struct window *w = fgl_glut_require_window("glutPushWindow");
    unlink_window(w);
    w->next = fgl_glut.windows;
    fgl_glut.windows = w;
}

void glutPostRedisplay(void)
{
    fgl_glut_require_window("glutPostRedisplay")->redisplay = true;
}

void glutPostWindowRedisplay(int id)
{
    fgl_glut_require_init("glutPostWindowRedisplay");
    struct window *w = fgl_window_find(id);
    if (w)
        w->redisplay = true;
    else
        fgl_glut_warn("glutPostWindowRedisplay: no window %d", id);
}

void glutSwapBuffers(void)
{
    struct window *w = fgl_glut_require_window("glutSwapBuffers");
    glFinish();
    if (!fgl_glut.headless)
        fgl_platform_present(fgl_window_root(w));
}

void glutSetCursor(int cursor)
{
    struct window *w = fgl_glut_require_window("glutSetCursor");
    w->cursor = cursor;
    if (w->platform)
        fgl_platform_set_cursor(w, cursor);
}

void glutWarpPointer(int x, int y)
{
    struct window *w = fgl_window_root(fgl_glut_require_window("glutWarpPointer"));
    if (w->platform)
        fgl_platform_warp_pointer(w, x, y);
    w->pointer_x = x;
    w->pointer_y = y;
}
