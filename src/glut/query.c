/* glutGet and its kin: what the library, its windows and its devices are. */
#include <string.h>
#include <GL/freeglut.h>
#include "internal.h"

enum { SCREEN_DPI_TENTHS = 254 }; /* 1 mm is 1/25.4 inch; screens are taken to have 96 dots per inch */

static int gl_integer(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

static int child_count(const struct window *w)
{
    int count = 0;
    for (const struct window *child = fgl_glut.windows; child; child = child->next)
        count += child->parent == w && !child->destroyed;
    return count;
}

static int screen(bool vertical, bool millimetres)
{
    int width, height;
    fgl_platform_screen_size(&width, &height);
    int pixels = vertical ? height : width;
    return millimetres ? pixels * SCREEN_DPI_TENTHS / 960 : pixels;
}

/* Queries about the current window; 0 where there is none, as in GLUT. */
static int get_window(GLenum query, const struct window *w)
{
    if (!w)
        return 0;
    switch (query) {
    case GLUT_WINDOW_X: return w->x;
    case GLUT_WINDOW_Y: return w->y;
    case GLUT_WINDOW_WIDTH: return w->width;
    case GLUT_WINDOW_HEIGHT: return w->height;
    case GLUT_WINDOW_BUFFER_SIZE: return w->colormap ? 8 : 32;
    case GLUT_WINDOW_STENCIL_SIZE: return gl_integer(GL_STENCIL_BITS);
    case GLUT_WINDOW_DEPTH_SIZE: return gl_integer(GL_DEPTH_BITS);
    case GLUT_WINDOW_RED_SIZE: return gl_integer(GL_RED_BITS);
    case GLUT_WINDOW_GREEN_SIZE: return gl_integer(GL_GREEN_BITS);
    case GLUT_WINDOW_BLUE_SIZE: return gl_integer(GL_BLUE_BITS);
    case GLUT_WINDOW_ALPHA_SIZE: return gl_integer(GL_ALPHA_BITS);
    case GLUT_WINDOW_ACCUM_RED_SIZE: return gl_integer(GL_ACCUM_RED_BITS);
    case GLUT_WINDOW_ACCUM_GREEN_SIZE: return gl_integer(GL_ACCUM_GREEN_BITS);
    case GLUT_WINDOW_ACCUM_BLUE_SIZE: return gl_integer(GL_ACCUM_BLUE_BITS);
    case GLUT_WINDOW_ACCUM_ALPHA_SIZE: return gl_integer(GL_ACCUM_ALPHA_BITS);
    case GLUT_WINDOW_DOUBLEBUFFER: return (w->mode & GLUT_DOUBLE) != 0;
    case GLUT_WINDOW_RGBA: return !w->colormap;
    case GLUT_WINDOW_COLORMAP_SIZE: return w->colormap ? COLORMAP_SIZE : 0;
    case GLUT_WINDOW_PARENT: return w->parent ? w->parent->id : 0;
    case GLUT_WINDOW_NUM_CHILDREN: return child_count(w);
    case GLUT_WINDOW_CURSOR: return w->cursor;
    default: return 0; /* samples, stereo, format id */
    }
}

int glutGet(GLenum query)
{
    if (query == GLUT_INIT_STATE) /* the one that may be asked before glutInit */
        return fgl_glut.initialized;
    fgl_glut_require_init("glutGet");
    if (query >= GLUT_WINDOW_X && query <= GLUT_WINDOW_FORMAT_ID)
        return get_window(query, fgl_glut.current);
    switch (query) {
    case GLUT_SCREEN_WIDTH: return screen(false, false);
    case GLUT_SCREEN_HEIGHT: return screen(true, false);
    case GLUT_SCREEN_WIDTH_MM: return screen(false, true);
    case GLUT_SCREEN_HEIGHT_MM: return screen(true, true);
    case GLUT_MENU_NUM_ITEMS: return fgl_menu_item_count();
    case GLUT_DISPLAY_MODE_POSSIBLE: return 1;
    case GLUT_INIT_WINDOW_X: return fgl_glut.x;
    case GLUT_INIT_WINDOW_Y: return fgl_glut.y;
    case GLUT_INIT_WINDOW_WIDTH: return fgl_glut.width;
    case GLUT_INIT_WINDOW_HEIGHT: return fgl_glut.height;
    case GLUT_INIT_DISPLAY_MODE: return (int)fgl_glut.mode;
    case GLUT_ELAPSED_TIME: return fgl_clock_now();
    case GLUT_VERSION: return 30400; /* whose shapes and additions these are */
    case GLUT_ACTION_ON_WINDOW_CLOSE: return fgl_glut.on_close;
    case GLUT_INIT_MAJOR_VERSION: return fgl_glut.context_version[0];
    case GLUT_INIT_MINOR_VERSION: return fgl_glut.context_version[1];
    case GLUT_INIT_FLAGS: return fgl_glut.context_flags;
    case GLUT_INIT_PROFILE: return fgl_glut.context_profile;
    case GLUT_FULL_SCREEN:
        return fgl_glut.current && fgl_glut.current->platform &&
               fgl_platform_is_full_screen(fgl_glut.current);
    case GLUT_DIRECT_RENDERING: return GLUT_TRY_DIRECT_CONTEXT;
    case GLUT_WINDOW_BORDER_WIDTH:
    case GLUT_WINDOW_BORDER_HEIGHT:
    case GLUT_WINDOW_SRGB:
    case GLUT_AUX:
    case GLUT_RENDERING_CONTEXT:
    case GLUT_SKIP_STALE_MOTION_EVENTS:
    case GLUT_GEOMETRY_VISUALIZE_NORMALS:
    case GLUT_STROKE_FONT_DRAW_JOIN_DOTS:
    case GLUT_ALLOW_NEGATIVE_WINDOW_POSITION: return 0;
    default: fgl_glut_warn("glutGet: no query 0x%x", query); return -1;
    }
}

int *glutGetModeValues(GLenum mode, int *size)
{
    static int samples = 1;
    fgl_glut_require_init("glutGetModeValues");
    *size = mode == GLUT_MULTISAMPLE;
    return *size ? &samples : NULL;
}

int glutDeviceGet(GLenum query)
{
    fgl_glut_require_init("glutDeviceGet");
    switch (query) {
    case GLUT_HAS_KEYBOARD:
    case GLUT_HAS_MOUSE: return 1;
    case GLUT_NUM_MOUSE_BUTTONS: return BUTTONS;
    case GLUT_DEVICE_IGNORE_KEY_REPEAT: return fgl_glut.ignore_key_repeat;
    case GLUT_DEVICE_KEY_REPEAT: return fgl_glut.key_repeat;
    case GLUT_HAS_SPACEBALL:
    case GLUT_HAS_DIAL_AND_BUTTON_BOX:
    case GLUT_HAS_TABLET:
    case GLUT_NUM_SPACEBALL_BUTTONS:
    case GLUT_NUM_BUTTON_BOX_BUTTONS:
    case GLUT_NUM_DIALS:
    case GLUT_NUM_TABLET_BUTTONS:
    case GLUT_HAS_JOYSTICK:
    case GLUT_OWNS_JOYSTICK:
    case GLUT_JOYSTICK_BUTTONS:
    case GLUT_JOYSTICK_AXES:
    case GLUT_JOYSTICK_POLL_RATE: return 0;
    default: fgl_glut_warn("glutDeviceGet: no query 0x%x", query); return -1;
    }
}

int glutLayerGet(GLenum query)
{
    fgl_glut_require_init("glutLayerGet");
    switch (query) {
    case GLUT_OVERLAY_POSSIBLE:
    case GLUT_HAS_OVERLAY:
    case GLUT_NORMAL_DAMAGED: return 0;
    case GLUT_LAYER_IN_USE: return GLUT_NORMAL;
    case GLUT_TRANSPARENT_INDEX:
    case GLUT_OVERLAY_DAMAGED: return -1;
    default: fgl_glut_warn("glutLayerGet: no query 0x%x", query); return -1;
    }
}

int glutGetModifiers(void)
{
    fgl_glut_require_init("glutGetModifiers");
    return fgl_glut.modifiers;
}

int glutExtensionSupported(const char *extension)
{
    fgl_glut_require_window("glutExtensionSupported");
    const char *list = (const char *)glGetString(GL_EXTENSIONS);
    size_t length = strlen(extension);
    if (length == 0 || strchr(extension, ' '))
        return 0;
    while (list && *list) {
        size_t word = strcspn(list, " ");
        if (word == length && strncmp(list, extension, word) == 0)
            return 1;
        list += word + strspn(list + word, " ");
    }
    return 0;
}

static const char *error_name(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "an unknown error";
    }
}

void glutReportErrors(void)
{
    GLenum error;
    fgl_glut_require_window("glutReportErrors");
    while ((error = glGetError()) != GL_NO_ERROR)
        fgl_glut_warn("GL error 0x%04x, %s", error, error_name(error));
}
