/* The state of libfixedglut and what its files offer each other. GLUT is one program's toolkit, used from one
 * thread; so all state is one struct. Built on the public OSMesa and GL interfaces only. */
#ifndef FGL_GLUT_INTERNAL_H
#define FGL_GLUT_INTERNAL_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <GL/osmesa.h>
#include "script.h"

#if defined(__GNUC__)
#define FGL_PRINTF(text, first) __attribute__((format(printf, text, first)))
#define FGL_NORETURN __attribute__((noreturn))
#else
#define FGL_PRINTF(text, first)
#define FGL_NORETURN
#endif

enum { COLORMAP_SIZE = 256 };
struct colormap {
    float color[COLORMAP_SIZE][3]; /* red, green, blue in [0,1]; black until glutSetColor */
};

enum { FRAME_MS = 16, BUTTONS = 3 }; /* virtual milliseconds per headless frame; buttons a menu can have */

struct callbacks {
    void (*display)(void);
    void (*reshape)(int, int);
    void (*keyboard)(unsigned char, int, int);
    void (*keyboard_up)(unsigned char, int, int);
    void (*special)(int, int, int);
    void (*special_up)(int, int, int);
    void (*mouse)(int, int, int, int);
    void (*motion)(int, int);
    void (*passive_motion)(int, int);
    void (*wheel)(int, int, int, int);
    void (*entry)(int);
    void (*visibility)(int);
    void (*window_status)(int);
    void (*close)(void);
};

struct window {
    int id;
    struct window *next;   /* in order of creation and stacking, lowest first */
    struct window *parent; /* NULL for a top-level window */
    int x, y;              /* of the top left corner, in the parent or on the screen */
    int width, height;     /* pixels */
    unsigned int mode;     /* GLUT_* display mode bits */
    OSMesaContext context;
    unsigned char *pixels;  /* width * height RGBA, lowest row first */
    unsigned char *indexes; /* GLUT_INDEX: what the context draws to, of which fgl_window_finish makes pixels;
                               else NULL */
    struct colormap *colormap; /* GLUT_INDEX: its own; else NULL */
    int wanted_width, wanted_height;
    bool reshape, redisplay; /* callbacks due */
    bool shown, told_shown, destroyed, close_asked;
    int cursor;
    int menu[BUTTONS]; /* ids, 0 for none */
    int pointer_x, pointer_y;
    bool entered;
    struct callbacks call;
    int before_full_screen[4]; /* x, y, width, height */
    void *data;                /* the program's */
    void *platform;            /* top-level windows in windowed mode: the GLFW window */
};

struct glut {
    bool initialized, headless;
    unsigned int mode;
    int x, y, width, height;         /* of new windows */
    int forced_width, forced_height; /* FIXEDGL_SIZE, 0 if not set */
    struct window *windows, *current;
    struct window *grab; /* gets the motion while a button is down */
    int last_window_id, buttons_down, modifiers;
    int on_close; /* GLUT_ACTION_* */
    bool leave;
    void (*idle)(void);
    void (*menu_status)(int, int, int);
    void (*menu_state)(int);
    int context_version[2], context_flags, context_profile; /* asked for; of no effect */
    void (*error)(const char *, va_list),
            (*warning)(const char *, va_list); /* the program's, or NULL: print */
    int key_repeat;
    bool ignore_key_repeat;
};
extern struct glut fgl_glut;

/* init.c */
void fgl_glut_warn(const char *format, ...) FGL_PRINTF(1, 2);
/* Prints one line and exits with the status: 1 misuse or failure, 2 unreadable FIXEDGL_* variable. */
FGL_NORETURN void fgl_glut_fail(int status, const char *format, ...) FGL_PRINTF(2, 3);
void fgl_glut_require_init(const char *function);
/* The current window; exits if there is none. */
struct window *fgl_glut_require_window(const char *function);

/* window.c */
struct window *fgl_window_find(int id);
struct window *fgl_window_root(struct window *w);
void fgl_window_make_current(struct window *w);
/* glFinish in it, and pixels are up to date; the current window stays. */
void fgl_window_finish(struct window *w);
/* Gives the window buffers of that size and marks it for reshape and redisplay. */
void fgl_window_resize(struct window *w, int width, int height);
/* Frees the windows that glutDestroyWindow has marked. True while any window remains. */
bool fgl_window_collect(void);
/* The topmost descendant of w under a point; changes the point to its coordinates. */
struct window *fgl_window_at(struct window *w, int *x, int *y);

/* colormap.c: the colours of a GLUT_INDEX window's indexes into its pixels. */
void fgl_colormap_show(struct window *w);

/* clock.c */
int fgl_clock_now(void); /* milliseconds since glutInit, real or virtual */
void fgl_clock_start(void);
/* Runs the timers due; on the virtual clock, each at its own time while the clock moves on by `ms`. */
void fgl_clock_run_timers(void);
void fgl_clock_advance(int ms);
int fgl_clock_next_timer(void); /* milliseconds until the next timer, -1 if there is none */

/* loop.c */
void fgl_loop_update(void); /* reshape, visibility and display callbacks due, of all windows */
void fgl_loop_run_close(struct window *w);

/* headless.c */
void fgl_headless_read_environment(void); /* decides glut.headless */
void fgl_headless_window_created(void);
void fgl_headless_window_destroyed(struct window *w);
/* One frame or one script statement; after the last, writes the final picture and returns false. */
bool fgl_headless_step(void);

/* event.c: input for a top-level window, in its coordinates */
void fgl_event_key(struct window *w, int key, bool down);
void fgl_event_special(struct window *w, int key, bool down);
void fgl_event_button(struct window *w, int button, bool down, int x, int y);
void fgl_event_motion(struct window *w, int x, int y);
void fgl_event_wheel(struct window *w, int direction, int x, int y);
void fgl_event_entry(struct window *w, bool entered);

/* picture.c: w with its children over it. On failure a line on stderr and false. */
bool fgl_picture_write(struct window *w, const char *file);       /* .png, else PAM */
bool fgl_picture_write_depth(struct window *w, const char *file); /* FGLDEPTH, see docs/glut.md */
/* The composed RGBA rows, lowest first; w->pixels itself if there are no children, else memory to free. */
unsigned char *fgl_picture_compose(struct window *w);

/* menu.c */
bool fgl_menu_opens(struct window *w, int button);
/* Picks an item by positions from 1, one per level. False if there is no such item. */
bool fgl_menu_pick(struct window *w, const int *path, int levels);
int fgl_menu_item_count(void); /* of the current menu */

/* platform.c: GLFW. Windowed mode only. */
void fgl_platform_open(struct window *w, const char *title);
void fgl_platform_close(struct window *w);
void fgl_platform_present(struct window *w);
void fgl_platform_wait(int ms); /* handles events, waiting up to ms for one; -1: as long as it takes */
void fgl_platform_set_title(struct window *w, const char *title);
void fgl_platform_set_size(struct window *w, int width, int height);
void fgl_platform_set_position(struct window *w, int x, int y);
void fgl_platform_show(struct window *w, bool shown);
void fgl_platform_iconify(struct window *w);
void fgl_platform_full_screen(struct window *w);
bool fgl_platform_is_full_screen(const struct window *w);
void fgl_platform_leave_full_screen(struct window *w);
void fgl_platform_set_cursor(struct window *w, int cursor);
void fgl_platform_warp_pointer(struct window *w, int x, int y);
void fgl_platform_screen_size(int *width, int *height);

#endif
