/* Real windows, through GLFW. The picture is drawn by FixedGL into memory; GLFW's own context, with the
 * system's GL found through glfwGetProcAddress, only copies it to the screen. No gl* function is called by
 * name here. */
#include <stdlib.h>
#include <string.h>
#include <GL/glut.h>
#include "glfw_table.h"
#include "internal.h"
#include "keys.h"

/* The system GL's functions, found once its first context is current. */
static struct {
    void (*Viewport)(GLint, GLint, GLsizei, GLsizei);
    void (*RasterPos2f)(GLfloat, GLfloat);
    void (*DrawPixels)(GLsizei, GLsizei, GLenum, GLenum, const GLvoid *);
} screen_gl;

static struct window *window_of(GLFWwindow *handle)
{
    return fgl_glfw()->GetWindowUserPointer(handle);
}

/* GLFW's cursor is in screen coordinates, GLUT's in pixels; they differ on high-density screens. */
static void to_pixels(GLFWwindow *handle, double x, double y, int *pixel_x, int *pixel_y)
{
    int width = 1, height = 1;
    const struct window *w = window_of(handle);
    fgl_glfw()->GetWindowSize(handle, &width, &height);
    *pixel_x = (int)(x * w->width / (width ? width : 1));
    *pixel_y = (int)(y * w->height / (height ? height : 1));
}

static void cursor_pixels(GLFWwindow *handle, int *x, int *y)
{
    double cursor_x, cursor_y;
    fgl_glfw()->GetCursorPos(handle, &cursor_x, &cursor_y);
    to_pixels(handle, cursor_x, cursor_y, x, y);
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int mods)
{
    (void)scancode;
    struct window *w = window_of(handle);
    bool down = action != GLFW_RELEASE;
    if (action == GLFW_REPEAT && (fgl_glut.ignore_key_repeat || fgl_glut.key_repeat == GLUT_KEY_REPEAT_OFF))
        return;
    fgl_glut.modifiers = fgl_keys_modifiers(mods);
    int special = fgl_keys_special(key), character = fgl_keys_character(key, mods, down);
    if (special)
        fgl_event_special(w, special, down);
    else if (character)
        fgl_event_key(w, character, down);
}

/* Printable characters come from here, since only the window system knows the keyboard's layout. */
static void on_character(GLFWwindow *handle, unsigned int character)
{
    if (character < 256)
        fgl_event_key(window_of(handle), (int)character, true);
}

static void on_button(GLFWwindow *handle, int button, int action, int mods)
{
    static const int buttons[] = {GLUT_LEFT_BUTTON, GLUT_RIGHT_BUTTON, GLUT_MIDDLE_BUTTON};
    int x, y;
    if (button > GLFW_MOUSE_BUTTON_MIDDLE)
        return;
    fgl_glut.modifiers = fgl_keys_modifiers(mods);
    cursor_pixels(handle, &x, &y);
    fgl_event_button(window_of(handle), buttons[button], action == GLFW_PRESS, x, y);
}

static void on_motion(GLFWwindow *handle, double cursor_x, double cursor_y)
{
    int x, y;
    to_pixels(handle, cursor_x, cursor_y, &x, &y);
    fgl_event_motion(window_of(handle), x, y);
}

static void on_entry(GLFWwindow *handle, int entered)
{
    fgl_event_entry(window_of(handle), entered != 0);
}

static void on_scroll(GLFWwindow *handle, double dx, double dy)
{
    int x, y;
    (void)dx;
    cursor_pixels(handle, &x, &y);
    if (dy > 0 || dy < 0)
        fgl_event_wheel(window_of(handle), dy > 0 ? 1 : -1, x, y);
}

static void on_size(GLFWwindow *handle, int width, int height)
{
    struct window *w = window_of(handle);
    if (width <= 0 || height <= 0) /* iconified */
        return;
    w->wanted_width = width;
    w->wanted_height = height;
}

static void on_position(GLFWwindow *handle, int x, int y)
{
    struct window *w = window_of(handle);
    w->x = x;
    w->y = y;
}

static void on_refresh(GLFWwindow *handle)
{
    window_of(handle)->redisplay = true;
}

static void on_close(GLFWwindow *handle)
{
    window_of(handle)->close_asked = true;
}

static void on_iconify(GLFWwindow *handle, int iconified)
{
    struct window *w = window_of(handle);
    w->shown = !iconified;
    w->redisplay = w->redisplay || !iconified;
}

static void set_callbacks(const struct glfw *glfw, GLFWwindow *handle)
{
    glfw->SetKeyCallback(handle, on_key);
    glfw->SetCharCallback(handle, on_character);
    glfw->SetMouseButtonCallback(handle, on_button);
    glfw->SetCursorPosCallback(handle, on_motion);
    glfw->SetCursorEnterCallback(handle, on_entry);
    glfw->SetScrollCallback(handle, on_scroll);
    glfw->SetFramebufferSizeCallback(handle, on_size);
    glfw->SetWindowPosCallback(handle, on_position);
    glfw->SetWindowRefreshCallback(handle, on_refresh);
    glfw->SetWindowCloseCallback(handle, on_close);
    glfw->SetWindowIconifyCallback(handle, on_iconify);
}

static void load_screen_gl(const struct glfw *glfw)
{
    screen_gl.Viewport = (void (*)(GLint, GLint, GLsizei, GLsizei))glfw->GetProcAddress("glViewport");
    screen_gl.RasterPos2f = (void (*)(GLfloat, GLfloat))glfw->GetProcAddress("glRasterPos2f");
    screen_gl.DrawPixels =
            (void (*)(GLsizei, GLsizei, GLenum, GLenum, const GLvoid *))glfw->GetProcAddress("glDrawPixels");
    if (!screen_gl.Viewport || !screen_gl.RasterPos2f || !screen_gl.DrawPixels)
        fgl_glut_fail(1, "the system's GL has no glDrawPixels");
}

/* The renderer's context is made current again afterwards: under Mesa both share what "current" means. */
static void release_screen(const struct glfw *glfw)
{
    glfw->MakeContextCurrent(NULL);
    if (fgl_glut.current)
        fgl_window_make_current(fgl_glut.current);
}

void fgl_platform_open(struct window *w, const char *title)
{
    const struct glfw *glfw = fgl_glfw();
    glfw->WindowHint(GLFW_VISIBLE, GLFW_TRUE);
    GLFWwindow *handle = glfw->CreateWindow(w->width, w->height, title, NULL, NULL);
    if (!handle)
        fgl_glut_fail(1, "cannot open a window of %d x %d", w->width, w->height);
    w->platform = handle;
    glfw->SetWindowUserPointer(handle, w);
    if (w->x >= 0 && w->y >= 0)
        glfw->SetWindowPos(handle, w->x, w->y);
    glfw->GetFramebufferSize(handle, &w->wanted_width, &w->wanted_height);
    set_callbacks(glfw, handle);
    glfw->MakeContextCurrent(handle);
    load_screen_gl(glfw);
    glfw->SwapInterval(1);
    release_screen(glfw);
}

void fgl_platform_close(struct window *w)
{
    fgl_glfw()->DestroyWindow(w->platform);
    w->platform = NULL;
}

void fgl_platform_present(struct window *w)
{
    const struct glfw *glfw = fgl_glfw();
    unsigned char *picture = fgl_picture_compose(w);
    glfw->MakeContextCurrent(w->platform);
    screen_gl.Viewport(0, 0, w->width, w->height);
    screen_gl.RasterPos2f(-1, -1);
    screen_gl.DrawPixels(w->width, w->height, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    glfw->SwapBuffers(w->platform);
    release_screen(glfw);
    if (picture != w->pixels)
        free(picture);
}

void fgl_platform_wait(int ms)
{
    const struct glfw *glfw = fgl_glfw();
    if (ms < 0)
        glfw->WaitEvents();
    else if (ms > 0)
        glfw->WaitEventsTimeout(ms / 1000.0);
    else
        glfw->PollEvents();
}

void fgl_platform_set_title(struct window *w, const char *title)
{
    fgl_glfw()->SetWindowTitle(w->platform, title);
}

void fgl_platform_set_size(struct window *w, int width, int height)
{
    fgl_glfw()->SetWindowSize(w->platform, width, height);
}

void fgl_platform_set_position(struct window *w, int x, int y)
{
    fgl_glfw()->SetWindowPos(w->platform, x, y);
}

void fgl_platform_show(struct window *w, bool shown)
{
    (shown ? fgl_glfw()->ShowWindow : fgl_glfw()->HideWindow)(w->platform);
}

void fgl_platform_iconify(struct window *w)
{
    fgl_glfw()->IconifyWindow(w->platform);
}

void fgl_platform_full_screen(struct window *w)
{
    const struct glfw *glfw = fgl_glfw();
    GLFWmonitor *monitor = glfw->GetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfw->GetVideoMode(monitor) : NULL;
    if (!mode || fgl_platform_is_full_screen(w))
        return;
    const int place[4] = {w->x, w->y, w->width, w->height};
    memcpy(w->before_full_screen, place, sizeof place);
    glfw->SetWindowMonitor(w->platform, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool fgl_platform_is_full_screen(const struct window *w)
{
    return fgl_glfw()->GetWindowMonitor(w->platform) != NULL;
}

void fgl_platform_leave_full_screen(struct window *w)
{
    const int *place = w->before_full_screen;
    if (fgl_platform_is_full_screen(w))
        fgl_glfw()->SetWindowMonitor(w->platform, NULL, place[0], place[1], place[2], place[3], 0);
}

void fgl_platform_set_cursor(struct window *w, int cursor)
{
    static GLFWcursor *shapes[4];
    static const int names[4] = {GLFW_IBEAM_CURSOR, GLFW_CROSSHAIR_CURSOR, GLFW_VRESIZE_CURSOR,
                                 GLFW_HRESIZE_CURSOR};
    const struct glfw *glfw = fgl_glfw();
    int shape = cursor == GLUT_CURSOR_FULL_CROSSHAIR ? GLUT_CURSOR_CROSSHAIR : cursor;
    bool hidden = cursor == GLUT_CURSOR_NONE;
    glfw->SetInputMode(w->platform, GLFW_CURSOR, hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    int i = shape - GLUT_CURSOR_TEXT;
    if (i >= 0 && i < 4 && !shapes[i])
        shapes[i] = glfw->CreateStandardCursor(names[i]);
    glfw->SetCursor(w->platform, i >= 0 && i < 4 ? shapes[i] : NULL);
}

void fgl_platform_warp_pointer(struct window *w, int x, int y)
{
    fgl_glfw()->SetCursorPos(w->platform, x, y);
}

/* Headless, the screen is taken to be 1920 x 1080. */
void fgl_platform_screen_size(int *width, int *height)
{
    *width = 1920;
    *height = 1080;
    if (fgl_glut.headless)
        return;
    GLFWmonitor *monitor = fgl_glfw()->GetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? fgl_glfw()->GetVideoMode(monitor) : NULL;
    if (mode) {
        *width = mode->width;
        *height = mode->height;
    }
}
