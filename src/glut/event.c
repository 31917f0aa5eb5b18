/* Input, from GLFW or from a script, to callbacks. Each goes to the child window under the pointer, or to the
 * one that a button was pressed in until all buttons are up. */
#include <GL/glut.h>
#include "internal.h"

enum { WHEEL_UP_BUTTON = 3, WHEEL_DOWN_BUTTON = 4 };

/* The window that gets an event at (*x, *y), made current; changes the point to its coordinates. */
static struct window *target(struct window *root, int *x, int *y)
{
    struct window *w = fgl_glut.grab;
    if (w && fgl_window_root(w) == root) {
        for (struct window *p = w; p->parent; p = p->parent) {
            *x -= p->x;
            *y -= p->y;
        }
    } else {
        w = fgl_window_at(root, x, y);
    }
    fgl_window_make_current(w);
    return w;
}

static struct window *pointer_target(struct window *root, int x, int y, int *local_x, int *local_y)
{
    root->pointer_x = *local_x = x;
    root->pointer_y = *local_y = y;
    if (!root->entered)
        fgl_event_entry(root, true);
    return target(root, local_x, local_y);
}

void fgl_event_entry(struct window *root, bool entered)
{
    if (root->entered == entered)
        return;
    root->entered = entered;
    fgl_window_make_current(root);
    if (root->call.entry)
        root->call.entry(entered ? GLUT_ENTERED : GLUT_LEFT);
}

void fgl_event_key(struct window *root, int key, bool down)
{
    int x = root->pointer_x, y = root->pointer_y;
    struct window *w = target(root, &x, &y);
    void (*func)(unsigned char, int, int) = down ? w->call.keyboard : w->call.keyboard_up;
    if (func)
        func((unsigned char)key, x, y);
}

void fgl_event_special(struct window *root, int key, bool down)
{
    int x = root->pointer_x, y = root->pointer_y;
    struct window *w = target(root, &x, &y);
    void (*func)(int, int, int) = down ? w->call.special : w->call.special_up;
    if (func)
        func(key, x, y);
}

void fgl_event_button(struct window *root, int button, bool down, int x, int y)
{
    int local_x, local_y, bit = 1 << button;
    struct window *w = pointer_target(root, x, y, &local_x, &local_y);
    if (down && fgl_menu_opens(w, button))
        return; /* the menu takes the press, and its release is not one of ours */
    if (!down && !(fgl_glut.buttons_down & bit))
        return;
    fgl_glut.buttons_down = down ? fgl_glut.buttons_down | bit : fgl_glut.buttons_down & ~bit;
    fgl_glut.grab = fgl_glut.buttons_down ? w : NULL;
    if (w->call.mouse)
        w->call.mouse(button, down ? GLUT_DOWN : GLUT_UP, local_x, local_y);
}

void fgl_event_motion(struct window *root, int x, int y)
{
    int local_x, local_y;
    struct window *w = pointer_target(root, x, y, &local_x, &local_y);
    void (*func)(int, int) = fgl_glut.buttons_down ? w->call.motion : w->call.passive_motion;
    if (func)
        func(local_x, local_y);
}

void fgl_event_wheel(struct window *root, int direction, int x, int y)
{
    int local_x, local_y, button = direction > 0 ? WHEEL_UP_BUTTON : WHEEL_DOWN_BUTTON;
    struct window *w = pointer_target(root, x, y, &local_x, &local_y);
    if (w->call.wheel) {
        w->call.wheel(0, direction, local_x, local_y);
    } else if (w->call.mouse) {
        w->call.mouse(button, GLUT_DOWN, local_x, local_y);
        if (w->call.mouse)
            w->call.mouse(button, GLUT_UP, local_x, local_y);
    }
}
