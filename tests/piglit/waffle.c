/* A libwaffle-1.so.0 for piglit's compiled tests: every window is memory, every context an OSMesa context of the
 * library that PIGLIT_OSMESA names. Only what piglit calls. */
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WAFFLE_API_VERSION 0x0106
#include <waffle.h>

#define API __attribute__((visibility("default")))

struct waffle_display {
    char unused;
};
struct waffle_config {
    bool possible; /* such a context can be made; piglit wants the config itself in any case */
};
struct waffle_context {
    void *osmesa;
};
struct waffle_window {
    int width, height;
    void *pixels;
};

enum { RGBA = 0x1908, UNSIGNED_BYTE = 0x1401, DEPTH_BITS = 24, STENCIL_BITS = 8, ACCUM_BITS = 16 };

/* The OSMesa entry points of the library under test. */
static struct {
    void *library;
    void *(*create)(unsigned format, int depth, int stencil, int accum, void *share);
    void (*destroy)(void *context);
    unsigned char (*make_current)(void *context, void *pixels, unsigned type, int width, int height);
    void *(*get_proc_address)(const char *name);
} osmesa;

static struct waffle_error_info last_error = {WAFFLE_NO_ERROR, "", 0};

static void *failed(enum waffle_error code, const char *message)
{
    last_error = (struct waffle_error_info){code, message, strlen(message)};
    return NULL;
}

/* dlsym without converting an object pointer to a function pointer. */
static void find(void *function, const char *name)
{
    void *address = dlsym(osmesa.library, name);
    memcpy(function, &address, sizeof address);
}

API bool waffle_init(const int32_t *attributes)
{
    (void)attributes;
    const char *path = getenv("PIGLIT_OSMESA");
    osmesa.library = dlopen(path ? path : "libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!osmesa.library) {
        fprintf(stderr, "waffle: %s\n", dlerror());
        failed(WAFFLE_ERROR_FATAL, "the OSMesa library cannot be loaded");
        return false;
    }
    find(&osmesa.create, "OSMesaCreateContextExt");
    find(&osmesa.destroy, "OSMesaDestroyContext");
    find(&osmesa.make_current, "OSMesaMakeCurrent");
    find(&osmesa.get_proc_address, "OSMesaGetProcAddress");
    return osmesa.create && osmesa.destroy && osmesa.make_current && osmesa.get_proc_address;
}

API bool waffle_teardown(void)
{
    return true;
}
API enum waffle_error waffle_error_get_code(void)
{
    return last_error.code;
}
API const struct waffle_error_info *waffle_error_get_info(void)
{
    return &last_error;
}
API const char *waffle_error_to_string(enum waffle_error e)
{
    return e == WAFFLE_NO_ERROR ? "WAFFLE_NO_ERROR" : "WAFFLE_ERROR";
}
API const char *waffle_enum_to_string(int32_t e)
{
    (void)e;
    return "WAFFLE_ENUM";
}
API int32_t waffle_attrib_list_length(const int32_t *list)
{
    int32_t n = 0;
    while (list && list[2 * n])
        n++;
    return n;
}

API struct waffle_display *waffle_display_connect(const char *name)
{
    (void)name;
    return calloc(1, sizeof(struct waffle_display));
}
API bool waffle_display_disconnect(struct waffle_display *display)
{
    free(display);
    return true;
}
API bool waffle_display_supports_context_api(struct waffle_display *display, int32_t api)
{
    (void)display;
    return api == WAFFLE_CONTEXT_OPENGL;
}
API union waffle_native_display *waffle_display_get_native(struct waffle_display *display)
{
    (void)display;
    return NULL;
}

/* Whether OpenGL 1.x can give the attribute its value. */
static bool attribute_possible(int32_t name, int32_t value)
{
    switch (name) {
    case WAFFLE_CONTEXT_API: return value == WAFFLE_CONTEXT_OPENGL;
    case WAFFLE_CONTEXT_MAJOR_VERSION: return value < 3;
    case WAFFLE_CONTEXT_PROFILE: return value != WAFFLE_CONTEXT_CORE_PROFILE;
    case WAFFLE_SAMPLES: return value <= 0;
    default: return true;
    }
}

API struct waffle_config *waffle_config_choose(struct waffle_display *display, const int32_t attributes[])
{
    (void)display;
    bool possible = true;
    for (int i = 0; attributes && attributes[i]; i += 2)
        if (!attribute_possible(attributes[i], attributes[i + 1]))
            possible = false;
    struct waffle_config *config = calloc(1, sizeof *config);
    if (!config)
        return failed(WAFFLE_ERROR_BAD_ALLOC, "out of memory");
    config->possible = possible;
    return config;
}
API bool waffle_config_destroy(struct waffle_config *config)
{
    free(config);
    return true;
}

API struct waffle_context *waffle_context_create(struct waffle_config *config, struct waffle_context *share)
{
    if (!config->possible)
        return failed(WAFFLE_ERROR_UNSUPPORTED_ON_PLATFORM, "no such context");
    struct waffle_context *context = calloc(1, sizeof *context);
    if (!context)
        return failed(WAFFLE_ERROR_BAD_ALLOC, "out of memory");
    context->osmesa = osmesa.create(RGBA, DEPTH_BITS, STENCIL_BITS, ACCUM_BITS, share ? share->osmesa : NULL);
    return context;
}
API bool waffle_context_destroy(struct waffle_context *context)
{
    if (context)
        osmesa.destroy(context->osmesa);
    free(context);
    return true;
}

API struct waffle_window *waffle_window_create(struct waffle_config *config, int32_t width, int32_t height)
{
    (void)config;
    struct waffle_window *window = calloc(1, sizeof *window);
    if (!window)
        return failed(WAFFLE_ERROR_BAD_ALLOC, "out of memory");
    *window = (struct waffle_window){width, height, calloc((size_t)width * (size_t)height, 4)};
    return window;
}
API struct waffle_window *waffle_window_create2(struct waffle_config *config, const intptr_t attributes[])
{
    int32_t width = 256, height = 256;
    for (int i = 0; attributes && attributes[i]; i += 2) {
        if (attributes[i] == WAFFLE_WINDOW_WIDTH)
            width = (int32_t)attributes[i + 1];
        if (attributes[i] == WAFFLE_WINDOW_HEIGHT)
            height = (int32_t)attributes[i + 1];
    }
    return waffle_window_create(config, width, height);
}
API bool waffle_window_destroy(struct waffle_window *window)
{
    if (window)
        free(window->pixels);
    free(window);
    return true;
}
API bool waffle_window_show(struct waffle_window *window)
{
    (void)window;
    return true;
}
API bool waffle_window_swap_buffers(struct waffle_window *window)
{
    (void)window;
    return true;
}
API union waffle_native_window *waffle_window_get_native(struct waffle_window *window)
{
    (void)window;
    return NULL;
}

API bool waffle_make_current(struct waffle_display *display, struct waffle_window *window,
                             struct waffle_context *context)
{
    static uint32_t pixel; /* for a context without a window */
    (void)display;
    if (!context)
        return osmesa.make_current(NULL, NULL, 0, 0, 0) || true;
    if (!window)
        return osmesa.make_current(context->osmesa, &pixel, UNSIGNED_BYTE, 1, 1);
    return osmesa.make_current(context->osmesa, window->pixels, UNSIGNED_BYTE, window->width, window->height);
}
API void *waffle_get_proc_address(const char *name)
{
    void *address = osmesa.get_proc_address(name);
    return address ? address : dlsym(osmesa.library, name);
}
API bool waffle_dl_can_open(int32_t library)
{
    return library == WAFFLE_DL_OPENGL;
}
API void *waffle_dl_sym(int32_t library, const char *name)
{
    return library == WAFFLE_DL_OPENGL ? waffle_get_proc_address(name) : NULL;
}
API bool waffle_is_extension_in_string(const char *extensions, const char *name)
{
    const size_t n = strlen(name);
    for (const char *p = extensions; p && (p = strstr(p, name)); p += n)
        if ((p == extensions || p[-1] == ' ') && (p[n] == ' ' || p[n] == '\0'))
            return true;
    return false;
}
