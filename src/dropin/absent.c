/* The names of libGL.so.1 and libOSMesa.so.8 that FixedGL does not draw with, for programs that are already
 * compiled. */
#include <stdbool.h>
#include <stdio.h>
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

typedef void (*function)(void);
GLAPI function glXGetProcAddress(const unsigned char *name);
GLAPI function glXGetProcAddressARB(const unsigned char *name);

/* GLX 1.4, 3.3.12. NULL for what is absent, so that a program can ask before it calls. */
function glXGetProcAddress(const unsigned char *name)
{
    return OSMesaGetProcAddress((const char *)name);
}

function glXGetProcAddressARB(const unsigned char *name)
{
    return OSMesaGetProcAddress((const char *)name);
}
