/* Loading GLFW at run time. */
#include <dlfcn.h>
#include <stdbool.h>
#include <string.h>
#include "glfw_table.h"
#include "internal.h"

static struct glfw table;
static bool loaded;

static void *open_library(void)
{
    static const char *const names[] = {"libglfw.so.3", "libglfw.3.dylib", "libglfw.so"};
    void *library = NULL;
    for (size_t i = 0; !library && i < sizeof names / sizeof names[0]; i++)
        library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    return library;
}

/* The object pointer of dlsym to a function pointer, as POSIX lets us. */
static void find(void *library, const char *name, void *function_pointer)
{
    void *symbol = dlsym(library, name);
    if (!symbol)
        fgl_glut_fail(1, "GLFW has no %s: version 3.2 or later is needed", name);
    memcpy(function_pointer, &symbol, sizeof symbol);
}

static void print_error(int code, const char *text)
{
    fgl_glut_warn("GLFW error 0x%x: %s", code, text);
}

const struct glfw *fgl_glfw(void)
{
    if (loaded)
        return &table;
    void *library = open_library();
    if (!library)
        fgl_glut_fail(1, "a window needs GLFW, libglfw.so.3 (Debian: libglfw3); without it set "
                         "FIXEDGL_CAPTURE=out.png");
#define F(result, name, parameters) find(library, "glfw" #name, &table.name);
    FGL_GLFW_FUNCTIONS(F)
#undef F
    table.SetErrorCallback(print_error);
    if (!table.Init())
        fgl_glut_fail(1, "cannot open the display; without one set FIXEDGL_CAPTURE=out.png");
    loaded = true;
    return &table;
}
