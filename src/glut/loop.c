/* The main loop: callbacks that are due, and in windowed mode waiting for events. */
#include <stdlib.h>
#include <GL/freeglut.h>
#include "internal.h"

static void run_reshape(struct window *w)
{
    w->reshape = false;
    fgl_window_make_current(w);
    if (w->call.reshape)
        w->call.reshape(w->width, w->height);
    else
        glViewport(0, 0, w->width, w->height);
}

static void run_visibility(struct window *w)
{
    w->told_shown = w->shown;
    fgl_window_make_current(w);
    if (w->call.window_status)
        w->call.window_status(w->shown ? GLUT_FULLY_RETAINED : GLUT_HIDDEN);
    if (w->call.visibility)
        w->call.visibility(w->shown ? GLUT_VISIBLE : GLUT_NOT_VISIBLE);
}

static void run_display(struct window *w)
{
    if (!w->call.display)
        fgl_glut_fail(1, "window %d has no display callback", w->id);
    w->redisplay = false;
    fgl_window_make_current(w);
    w->call.display();
}

void fgl_loop_update(void)
{
    for (struct window *w = fgl_glut.windows; w; w = w->next) {
        if (!w->destroyed && (w->wanted_width != w->width || w->wanted_height != w->height))
            fgl_window_resize(w, w->wanted_width, w->wanted_height);
        if (w->reshape && !w->destroyed)
            run_reshape(w);
        if (w->shown != w->told_shown && !w->destroyed)
            run_visibility(w);
        if (w->redisplay && w->shown && !w->destroyed)
            run_display(w);
    }
}

void fgl_loop_run_close(struct window *w)
{
    void (*close)(void) = w->call.close;
    if (!close)
        return;
    w->call.close = NULL; /* once */
    struct window *current = fgl_glut.current;
    fgl_window_make_current(w);
    close();
    if (current && !current->destroyed)
        fgl_window_make_current(current);
}

/* The user closed a window. */
static void close_asked_windows(void)
{
    for (struct window *w = fgl_glut.windows; w; w = w->next) {
        if (!w->close_asked || w->destroyed)
            continue;
        glutDestroyWindow(w->id);
        if (fgl_glut.on_close == GLUT_ACTION_EXIT)
            exit(0);
        if (fgl_glut.on_close == GLUT_ACTION_GLUTMAINLOOP_RETURNS)
            fgl_glut.leave = true;
    }
}

static void present_single_buffered(void)
{
    for (struct window *w = fgl_glut.windows; w; w = w->next)
        if (w->platform && w->shown && !w->destroyed && !(w->mode & GLUT_DOUBLE))
            fgl_platform_present(w);
}

/* One turn in windowed mode. A single-buffered program may draw at any time, in a timer or an event, so its
 * picture is shown after every turn; a double-buffered one shows its own in glutSwapBuffers. */
static void run_turn(void)
{
    int wait = fgl_glut.idle ? 0 : fgl_clock_next_timer();
    for (struct window *w = fgl_glut.windows; w; w = w->next)
        if (w->redisplay && w->shown)
            wait = 0;
    fgl_platform_wait(wait);
    close_asked_windows();
    fgl_clock_run_timers();
    fgl_loop_update();
    present_single_buffered();
    if (fgl_glut.idle && !fgl_glut.leave)
        fgl_glut.idle();
}

/* One turn in either mode; false when the loop is over. */
static bool turn(void)
{
    if (fgl_glut.headless)
        return fgl_headless_step() && !fgl_glut.leave;
    if (!fgl_window_collect())
        return false;
    run_turn();
    return !fgl_glut.leave;
}

void glutMainLoop(void)
{
    fgl_glut_require_init("glutMainLoop");
    if (!fgl_glut.windows)
        fgl_glut_fail(1, "glutMainLoop called with no window");
    while (turn()) {
    }
    if (!fgl_glut.leave)
        exit(0);
    fgl_glut.leave = false;
}

void glutMainLoopEvent(void)
{
    fgl_glut_require_init("glutMainLoopEvent");
    if (!turn() && fgl_glut.headless && !fgl_glut.leave)
        exit(0);
}

void glutLeaveMainLoop(void)
{
    fgl_glut_require_init("glutLeaveMainLoop");
    fgl_glut.leave = true;
}

void glutSetOption(GLenum option, int value)
{
    fgl_glut_require_init("glutSetOption");
    if (option == GLUT_ACTION_ON_WINDOW_CLOSE && value >= GLUT_ACTION_EXIT &&
        value <= GLUT_ACTION_CONTINUE_EXECUTION)
        fgl_glut.on_close = value;
    else if (option == GLUT_RENDERING_CONTEXT && value == GLUT_USE_CURRENT_CONTEXT)
        fgl_glut_warn("glutSetOption: windows cannot share a context");
    else if (option != GLUT_RENDERING_CONTEXT && option != GLUT_DIRECT_RENDERING &&
             option != GLUT_MULTISAMPLE &&
             (option < GLUT_SKIP_STALE_MOTION_EVENTS || option > GLUT_ALLOW_NEGATIVE_WINDOW_POSITION))
        fgl_glut_warn("glutSetOption: option 0x%x, value %d not known", option, value);
}

void glutExit(void)
{
    if (!fgl_glut.initialized) /* as from an error function, which glutInit need not have gone before */
        return;
    for (struct window *w = fgl_glut.windows; w; w = w->next)
        if (!w->destroyed)
            glutDestroyWindow(w->id);
    fgl_window_collect();
    fgl_glut.initialized = false;
}
