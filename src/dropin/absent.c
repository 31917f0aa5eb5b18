/* The names of libGL.so.1 and libOSMesa.so.8 that FixedGL does not draw with, for programs that are already
 * compiled. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <GL/gl.h>
#include <GL/osmesa.h>

static void *refuse(const char *function, bool *told)
{
    if (!*told)
        fprintf(stderr, "fixedgl: there is no %s here (neither GLX nor OpenGL after 1.5): the call is ignored\n",
                function);
    *told = true;
    return NULL;
}

/* Called with any arguments: the caller cleans up after them, and takes a null pointer, 0 or False from the
 * same register. */
#define ABSENT(name)                                                                                         \
    GLAPI void *name(void);                                                                                  \
    void *name(void)                                                                                         \
    {                                                                                                        \
        static bool told;                                                                                    \
        return refuse(#name, &told);                                                                         \
    }
#define QUIET(name)                                                                                          \
    GLAPI void *name(void);                                                                                  \
    void *name(void)                                                                                         \
    {                                                                                                        \
        return NULL;                                                                                         \
    }
#include "absent.def"

/* GLX 1.4, 3.3.7. Libraries ask it to see whether they may call OpenGL. */
GLAPI OSMesaContext glXGetCurrentContext(void);
OSMesaContext glXGetCurrentContext(void)
{
    return OSMesaGetCurrentContext();
}

/* What GLEW looks at before it loads functions (GLX 1.4, 3.3.2, 3.3.7): version 1.4 without extensions, on a display that
 * is no connection to anything: zeros of more than the size of Xlib's. */
GLAPI void *glXGetCurrentDisplay(void);
GLAPI int glXQueryVersion(void *display, int *major, int *minor);
GLAPI const char *glXGetClientString(void *display, int name);
GLAPI const char *glXQueryServerString(void *display, int screen, int name);
GLAPI const char *glXQueryExtensionsString(void *display, int screen);

void *glXGetCurrentDisplay(void)
{
    static long long display[256];
    return OSMesaGetCurrentContext() ? display : NULL;
}

int glXQueryVersion(void *display, int *major, int *minor)
{
    (void)display;
    *major = 1;
    *minor = 4;
    return 1;
}

const char *glXGetClientString(void *display, int name)
{
    enum { VENDOR = 1, VERSION };
    (void)display;
    return name == VENDOR ? "FixedGL" : name == VERSION ? "1.4" : "";
}

const char *glXQueryServerString(void *display, int screen, int name)
{
    (void)screen;
    return glXGetClientString(display, name);
}

const char *glXQueryExtensionsString(void *display, int screen)
{
    (void)display, (void)screen;
    return "";
}

typedef void (*function)(void);
GLAPI function glXGetProcAddress(const unsigned char *name);
GLAPI function glXGetProcAddressARB(const unsigned char *name);

/* GLX 1.4, 3.3.12. NULL for what is absent, so that a program can ask before it calls. */
function glXGetProcAddress(const unsigned char *name)
{
    static const struct {
        const char *name;
        function function;
    } here[] = {{"glXGetCurrentContext", (function)glXGetCurrentContext},
                {"glXGetCurrentDisplay", (function)glXGetCurrentDisplay},
                {"glXQueryVersion", (function)glXQueryVersion},
                {"glXGetClientString", (function)glXGetClientString},
                {"glXQueryServerString", (function)glXQueryServerString},
                {"glXQueryExtensionsString", (function)glXQueryExtensionsString},
                {"glXGetProcAddress", (function)glXGetProcAddress},
                {"glXGetProcAddressARB", (function)glXGetProcAddressARB}};
    for (size_t i = 0; i < sizeof here / sizeof *here; i++)
        if (strcmp(here[i].name, (const char *)name) == 0)
            return here[i].function;
    return OSMesaGetProcAddress((const char *)name);
}

function glXGetProcAddressARB(const unsigned char *name)
{
    return glXGetProcAddress(name);
}
