/* The same GL calls to FixedGL and to Mesa's OSMesa, in one process: a table of functions for each. Tests
 * issue calls through a table, twice with the same random numbers, and compare what comes back. The program
 * holds FixedGL statically, so its names do not reach the shared library that is loaded beside it.
 *
 * Where libOSMesa.so.8 is not installed, and under AddressSanitizer (which would report Mesa's own leaks),
 * only FixedGL draws and nothing is compared. FIXEDGL_SETS=n draws n sets instead of the default,
 * FIXEDGL_SEED=s others. */
#ifndef TESTS_UNIT_BOTH_H
#define TESTS_UNIT_BOTH_H

#include "unit.h"

#include <dlfcn.h>

#include <GL/osmesa.h>

#if defined(__SANITIZE_ADDRESS__)
#define WITH_OSMESA 0
#else
#define WITH_OSMESA 1
#endif

/* name, parameters */
#define EACH_FUNCTION(F)                                                                                     \
    F(Enable, (GLenum))                                                                                      \
    F(Disable, (GLenum))                                                                                     \
    F(MatrixMode, (GLenum))                                                                                  \
    F(LoadIdentity, (void))                                                                                  \
    F(LoadMatrixf, (const GLfloat *))                                                                        \
    F(MultMatrixf, (const GLfloat *))                                                                        \
    F(Rotatef, (GLfloat, GLfloat, GLfloat, GLfloat))                                                         \
    F(Translatef, (GLfloat, GLfloat, GLfloat))                                                               \
    F(Scalef, (GLfloat, GLfloat, GLfloat))                                                                   \
    F(Frustum, (GLdouble, GLdouble, GLdouble, GLdouble, GLdouble, GLdouble))                                 \
    F(Ortho, (GLdouble, GLdouble, GLdouble, GLdouble, GLdouble, GLdouble))                                   \
    F(PushMatrix, (void))                                                                                    \
    F(PopMatrix, (void))                                                                                     \
    F(Lightf, (GLenum, GLenum, GLfloat))                                                                     \
    F(Lightfv, (GLenum, GLenum, const GLfloat *))                                                            \
    F(LightModelfv, (GLenum, const GLfloat *))                                                               \
    F(LightModeli, (GLenum, GLint))                                                                          \
    F(Materialf, (GLenum, GLenum, GLfloat))                                                                  \
    F(Materialfv, (GLenum, GLenum, const GLfloat *))                                                         \
    F(ColorMaterial, (GLenum, GLenum))                                                                       \
    F(ShadeModel, (GLenum))                                                                                  \
    F(Begin, (GLenum))                                                                                       \
    F(End, (void))                                                                                           \
    F(Vertex4fv, (const GLfloat *))                                                                          \
    F(Normal3fv, (const GLfloat *))                                                                          \
    F(Color4fv, (const GLfloat *))                                                                           \
    F(ClearColor, (GLclampf, GLclampf, GLclampf, GLclampf))                                                  \
    F(Clear, (GLbitfield))                                                                                   \
    F(Finish, (void))                                                                                        \
    F(GetFloatv, (GLenum, GLfloat *))                                                                        \
    F(GetLightfv, (GLenum, GLenum, GLfloat *))

enum { BOTH_SIZE = 48 };

struct gl {
#define MEMBER(name, parameters) void(*name) parameters;
    EACH_FUNCTION(MEMBER)
#undef MEMBER
    OSMesaContext (*create)(GLenum, GLint, GLint, GLint, OSMesaContext);
    GLboolean (*make_current)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
    void (*destroy)(OSMesaContext);
    OSMesaContext context;
    float pixels[BOTH_SIZE * BOTH_SIZE * 4];
};

static struct gl fixedgl, osmesa;
static bool have_osmesa;

typedef OSMESAproc get_proc_fn(const char *);

static inline void fill_table(struct gl *gl, get_proc_fn *get_proc)
{
#define ENTRY(name, parameters) gl->name = (void(*) parameters)get_proc("gl" #name);
    EACH_FUNCTION(ENTRY)
#undef ENTRY
    gl->create =
            (OSMesaContext(*)(GLenum, GLint, GLint, GLint, OSMesaContext))get_proc("OSMesaCreateContextExt");
    gl->make_current =
            (GLboolean(*)(OSMesaContext, void *, GLenum, GLsizei, GLsizei))get_proc("OSMesaMakeCurrent");
    gl->destroy = (void (*)(OSMesaContext))get_proc("OSMesaDestroyContext");
}

static inline int load_both(void **state)
{
    void *library;
    (void)state;

    fill_table(&fixedgl, OSMesaGetProcAddress);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("LP_NUM_THREADS", "1", 0);
    library = WITH_OSMESA ? dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL) : NULL;
    if (!library) {
        printf("not compared: %s\n", WITH_OSMESA ? dlerror() : "under AddressSanitizer");
        return 0;
    }
    fill_table(&osmesa, (get_proc_fn *)dlsym(library, "OSMesaGetProcAddress"));
    have_osmesa = osmesa.create && osmesa.make_current;
    return have_osmesa ? 0 : -1;
}

/* A context with a float buffer, which shows colours before they are rounded. */
static inline void begin_context(struct gl *gl)
{
    gl->context = gl->create(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_non_null(gl->context);
    assert_true(gl->make_current(gl->context, gl->pixels, GL_FLOAT, BOTH_SIZE, BOTH_SIZE));
}

static inline void end_context(struct gl *gl)
{
    gl->make_current(NULL, NULL, 0, 0, 0);
    gl->destroy(gl->context);
}

static inline int sets(int standard)
{
    const char *given = getenv("FIXEDGL_SETS");
    return given ? atoi(given) : standard;
}

#endif
