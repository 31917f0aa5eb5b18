/* Headless mode: frames on the virtual clock, then the event script, then the picture, then the end. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <GL/glut.h>
#include "internal.h"

static struct {
    const char *capture, *depth; /* files for the last picture, NULL for none */
    int frames;                  /* yet to be drawn before the script */
    bool drew_frame;
    struct script script;
    int next_statement;
    int window; /* id that events and captures are for, 0: the first top-level window */
    bool finished, exiting;
} state = {.frames = 1};

static const char *variable(const char *name)
{
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}

static void read_frames(const char *text)
{
    char *end;
    long frames = strtol(text, &end, 10);
    if (*end || frames < 1 || frames > INT_MAX)
        fgl_glut_fail(2, "FIXEDGL_FRAMES=%s is not a number of frames", text);
    state.frames = (int)frames;
}

static void read_script(const char *text)
{
    char error[256];
    if (!fgl_script_parse(text, &state.script, error, sizeof error))
        fgl_glut_fail(2, "FIXEDGL_EVENTS: %s", error);
}

static bool have_display(void)
{
#if defined(__APPLE__) || defined(_WIN32)
    return true;
#else
    return variable("DISPLAY") || variable("WAYLAND_DISPLAY");
#endif
}

void fgl_headless_read_environment(void)
{
    const char *frames = variable("FIXEDGL_FRAMES"), *events = variable("FIXEDGL_EVENTS");
    const char *size = variable("FIXEDGL_SIZE"), *headless = variable("FIXEDGL_HEADLESS");
    state.capture = variable("FIXEDGL_CAPTURE");
    state.depth = variable("FIXEDGL_CAPTURE_DEPTH");
    if (size && !fgl_script_parse_size(size, &fgl_glut.forced_width, &fgl_glut.forced_height))
        fgl_glut_fail(2, "FIXEDGL_SIZE=%s is not WIDTHxHEIGHT, each from 1 to 16384", size);
    if (frames)
        read_frames(frames);
    if (events)
        read_script(events);
    bool asked = state.capture || state.depth || frames || events;
    fgl_glut.headless = asked || (headless && strcmp(headless, "0") != 0) || !have_display();
    if (fgl_glut.headless && !asked)
        fgl_glut_warn("no window: drawing one frame; set FIXEDGL_CAPTURE=out.png to keep the picture%s",
                      have_display() ? "" : ", or DISPLAY to see it");
}

static struct window *target_window(void)
{
    struct window *w = state.window ? fgl_window_find(state.window) : NULL;
    for (struct window *first = fgl_glut.windows; !w && first; first = first->next)
        if (!first->parent && !first->destroyed)
            w = first;
    return w;
}

/* A picture that cannot be written is the end, even inside exit(). */
static void write_or_fail(bool written)
{
    if (written)
        return;
    if (!state.exiting)
        exit(1);
    fflush(NULL);
    _Exit(1);
}

/* Writes the last picture, once. */
static void finish(void)
{
    if (state.finished)
        return;
    state.finished = true;
    if (!state.capture && !state.depth)
        return;
    struct window *w = target_window();
    if (!w) {
        fgl_glut_warn("no window is left to capture");
        return;
    }
    if (state.capture)
        write_or_fail(fgl_picture_write(w, state.capture));
    if (state.depth)
        write_or_fail(fgl_picture_write_depth(w, state.depth));
}

/* A program that calls exit itself, from a key callback perhaps, gets its picture too. */
static void finish_at_exit(void)
{
    state.exiting = true;
    finish();
}

/* Registered once the first context exists, so that it runs before the exit handlers of the renderer. */
void fgl_headless_window_created(void)
{
    static bool registered;
    if (!registered)
        atexit(finish_at_exit);
    registered = true;
}

/* The last window of a program that destroys it before it exits. */
void fgl_headless_window_destroyed(struct window *w)
{
    int others = 0;
    for (struct window *other = fgl_glut.windows; other; other = other->next)
        others += other != w && !other->parent && !other->destroyed;
    if (!w->parent && !others && state.drew_frame)
        finish();
}

/* The first frame is drawn at time 0; before each later one 16 ms pass and the idle callback runs. */
static void draw_frame(void)
{
    if (state.drew_frame) {
        fgl_clock_advance(FRAME_MS);
        if (fgl_glut.idle)
            fgl_glut.idle();
    }
    state.drew_frame = true;
    fgl_loop_update();
}

static void pass_time(int ms)
{
    for (; ms > 0 && !fgl_glut.leave; ms -= FRAME_MS) {
        fgl_clock_advance(ms < FRAME_MS ? ms : FRAME_MS);
        if (fgl_glut.idle)
            fgl_glut.idle();
        fgl_loop_update();
    }
}

static void press(struct window *w, int button, bool down, int x, int y)
{
    if (!w->destroyed)
        fgl_event_button(w, button, down, x, y);
}

static void click(struct window *w, const struct statement *s)
{
    for (int i = 0; i < s->number[2]; i++) {
        press(w, s->value, true, s->number[0], s->number[1]);
        press(w, s->value, false, s->number[0], s->number[1]);
    }
}

static void drag(struct window *w, const struct statement *s)
{
    press(w, s->value, true, s->number[0], s->number[1]);
    if (!w->destroyed)
        fgl_event_motion(w, s->number[2], s->number[3]);
    press(w, s->value, false, s->number[2], s->number[3]);
}

static void run_statement(const struct statement *s)
{
    struct window *w = target_window(), *root = fgl_window_root(w);
    const int *n = s->number;
    switch (s->kind) {
    case STATEMENT_KEY:
        fgl_event_key(root, s->value, true);
        if (!root->destroyed)
            fgl_event_key(root, s->value, false);
        break;
    case STATEMENT_SPECIAL:
        fgl_event_special(root, s->value, true);
        if (!root->destroyed)
            fgl_event_special(root, s->value, false);
        break;
    case STATEMENT_PRESS: press(root, s->value, true, n[0], n[1]); break;
    case STATEMENT_RELEASE: press(root, s->value, false, n[0], n[1]); break;
    case STATEMENT_CLICK: click(root, s); break;
    case STATEMENT_DRAG: drag(root, s); break;
    case STATEMENT_MOVE: fgl_event_motion(root, n[0], n[1]); break;
    case STATEMENT_WHEEL: fgl_event_wheel(root, s->value, n[0], n[1]); break;
    case STATEMENT_MODIFIERS: fgl_glut.modifiers = s->value; break;
    case STATEMENT_RESIZE: fgl_window_resize(w, n[0], n[1]); break;
    case STATEMENT_MENU:
        if (!fgl_menu_pick(w, n, s->value))
            fgl_glut_fail(2, "FIXEDGL_EVENTS: statement %d: no such menu item", state.next_statement);
        break;
    case STATEMENT_WAIT:
        for (int i = 0; i < n[0] && !fgl_glut.leave; i++)
            draw_frame();
        break;
    case STATEMENT_TIME: pass_time(n[0]); break;
    case STATEMENT_WINDOW:
        if (!fgl_window_find(n[0]))
            fgl_glut_fail(2, "FIXEDGL_EVENTS: statement %d: no window %d", state.next_statement, n[0]);
        state.window = n[0];
        break;
    case STATEMENT_CAPTURE: write_or_fail(fgl_picture_write(w, s->text)); break;
    case STATEMENT_DEPTH: write_or_fail(fgl_picture_write_depth(w, s->text)); break;
    case STATEMENT_QUIT: state.next_statement = state.script.count; break;
    }
}

bool fgl_headless_step(void)
{
    if (fgl_window_collect()) {
        if (state.frames > 0) {
            state.frames--;
            draw_frame();
            return true;
        }
        if (state.next_statement < state.script.count) {
            run_statement(&state.script.statements[state.next_statement++]);
            fgl_loop_update();
            return true;
        }
    }
    finish();
    fgl_script_free(&state.script);
    return false;
}
