/* Facts about GL libraries: printed by the process that loads one, read by the others. */
#define _GNU_SOURCE /* dladdr */
#include "library.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <GL/osmesa.h>

#include "child.h"

#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif

static const double query_timeout = 60;

/* The functions asked for, with the types of the public headers. */
struct entry_points {
    OSMesaContext(GLAPIENTRY *create)(GLenum, GLint, GLint, GLint, OSMesaContext);
    GLboolean(GLAPIENTRY *make_current)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
    void(GLAPIENTRY *destroy)(OSMesaContext);
    const GLubyte *(GLAPIENTRY *get_string)(GLenum);
    const char *(GLAPIENTRY *fixedgl_version)(void);
};

/* ISO C has no cast from an object pointer to a function pointer; POSIX says that both have the same bits. */
static void find(void *handle, const char *name, void *function)
{
    void *symbol = dlsym(handle, name);
    memcpy(function, &symbol, sizeof symbol);
}

static void print_path(const char *library, const void *symbol)
{
    Dl_info where;
    char path[PATH_MAX];
    if (dladdr(symbol, &where) != 0 && realpath(where.dli_fname, path) != NULL)
        library = path;
    printf("library: %s\n", library);
}

static void print_string(const char *name, const GLubyte *value)
{
    printf("%s: %s\n", name, value != NULL ? (const char *)value : "(none)");
}

static void print_extensions(const char *names)
{
    for (; names != NULL && *(names += strspn(names, " ")) != '\0'; names += strcspn(names, " "))
        printf("extension: %.*s\n", (int)strcspn(names, " "), names);
}

static bool print_facts(const struct entry_points *gl, struct problem *problem)
{
    static GLubyte pixels[16 * 16 * 4];
    OSMesaContext context = gl->create(OSMESA_RGBA, 24, 8, 0, NULL);
    if (context == NULL || !gl->make_current(context, pixels, GL_UNSIGNED_BYTE, 16, 16))
        return fgl_problem_set(problem, "it makes no context");
    if (gl->fixedgl_version != NULL)
        printf("fixedglVersion: %s\n", gl->fixedgl_version());
    print_string("GL_VENDOR", gl->get_string(GL_VENDOR));
    print_string("GL_RENDERER", gl->get_string(GL_RENDERER));
    print_string("GL_VERSION", gl->get_string(GL_VERSION));
    print_extensions((const char *)gl->get_string(GL_EXTENSIONS));
    gl->destroy(context);
    return true;
}

bool fgl_library_print(const char *library, struct problem *problem)
{
    void *handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (handle == NULL)
        return fgl_problem_set(problem, "%s", dlerror());
    struct entry_points gl;
    find(handle, "OSMesaCreateContextExt", &gl.create);
    find(handle, "OSMesaMakeCurrent", &gl.make_current);
    find(handle, "OSMesaDestroyContext", &gl.destroy);
    find(handle, "glGetString", &gl.get_string);
    find(handle, "fixedglVersion", &gl.fixedgl_version);
    if (gl.create == NULL || gl.make_current == NULL || gl.destroy == NULL || gl.get_string == NULL)
        return fgl_problem_set(problem, "%s has no OSMesa functions", library);
    print_path(library, dlsym(handle, "OSMesaMakeCurrent"));
    return print_facts(&gl, problem);
}

static bool take_fact(char *line, void *context, struct problem *problem)
{
    struct library_facts *facts = context;
    char extension[128];
    (void)problem;
    fgl_take_value(line, "library", facts->path, sizeof facts->path);
    fgl_take_value(line, "GL_VENDOR", facts->vendor, sizeof facts->vendor);
    fgl_take_value(line, "GL_RENDERER", facts->renderer, sizeof facts->renderer);
    fgl_take_value(line, "GL_VERSION", facts->version, sizeof facts->version);
    facts->extensions += fgl_take_value(line, "extension", extension, sizeof extension);
    return true;
}

static bool take_first_line(char *line, void *context, struct problem *problem)
{
    struct problem *first = context;
    (void)problem;
    if (first->text[0] == '\0')
        snprintf(first->text, sizeof first->text, "%s", line);
    return true;
}

/* A new empty file's name; NULL when there can be none. */
static char *make_file(void)
{
    char *name = fgl_temporary_name();
    const int file = mkstemp(name);
    if (file >= 0) {
        close(file);
        return name;
    }
    free(name);
    return NULL;
}

static void remove_file(char *name)
{
    if (name)
        remove(name);
    free(name);
}

/* Runs a short program and hands each line of its output to `use`; of its errors, if it fails, to `problem`.
 */
static bool read_output(char *const *argv, bool (*use)(char *, void *, struct problem *), void *context,
                        struct problem *problem)
{
    /* OSMesa keeps a little memory to the end, which is no fault of a sanitized build of this tool. */
    static const char *const set[] = {"MESA_SHADER_CACHE_DISABLE=true", "LC_ALL=C",
                                      "ASAN_OPTIONS=detect_leaks=0", NULL};
    char *output = make_file(), *errors = make_file();
    const struct child child = {argv, set, output, errors, query_timeout};
    struct problem said = {""}, ignored;
    bool good = output && errors ? fgl_child_run(&child, problem) : fgl_problem_set(problem, "cannot make a temporary file");
    if (good)
        good = fgl_read_lines(output, use, context, problem);
    else if (errors && fgl_read_lines(errors, take_first_line, &said, &ignored) && said.text[0] != '\0')
        *problem = said;
    fgl_take_value(said.text, "fixedgl", problem->text, sizeof problem->text);
    remove_file(output);
    remove_file(errors);
    return good;
}

/* Asks dpkg which package the library came from. */
static void query_package(struct library_facts *facts)
{
    struct problem owner = {""}, package = {""}, ignored;
    char *search[] = {"dpkg-query", "-S", facts->path, NULL};
    if (!read_output(search, take_first_line, &owner, &ignored))
        return;
    owner.text[strcspn(owner.text, ":, ")] = '\0';
    char *show[] = {"dpkg-query", "-W", "-f", "${Package} ${Version}\n", owner.text, NULL};
    if (read_output(show, take_first_line, &package, &ignored))
        snprintf(facts->package, sizeof facts->package, "%.120s", package.text);
}

static bool own_path(char path[PATH_MAX])
{
    const ssize_t length = readlink("/proc/self/exe", path, PATH_MAX - 1);
    if (length > 0)
        path[length] = '\0';
    return length > 0;
}

bool fgl_library_query(const char *library, struct library_facts *facts, struct problem *problem)
{
    *facts = (struct library_facts){0};
    char self[PATH_MAX];
    if (!own_path(self))
        return fgl_problem_set(problem, "cannot find the fixedgl program itself");
    char *argv[] = {self, "info", (char *)library, NULL};
    if (!read_output(argv, take_fact, facts, problem))
        return false;
    query_package(facts);
    return true;
}

char *fgl_library_beside(const char *file)
{
    char self[PATH_MAX];
    if (own_path(self)) {
        *strrchr(self, '/') = '\0';
        char *path = fgl_format("%s/%s", self, file);
        if (access(path, R_OK) == 0)
            return path;
        free(path);
    }
    const char *name = strrchr(file, '/');
    return fgl_format("%s", name != NULL ? name + 1 : file);
}

char *fgl_library_own(void)
{
    return fgl_library_beside("../lib/libfixedgl.so");
}

#if defined(__x86_64__) || defined(__i386__)
static bool has_fma_flag(char *line, void *context, struct problem *problem)
{
    (void)problem;
    if (strncmp(line, "flags", 5) == 0 && strstr(line, " fma ") != NULL)
        *(bool *)context = true;
    return true;
}
#endif

bool fgl_cpu_has_fma(void)
{
#if defined(__x86_64__) || defined(__i386__)
    bool found = false;
    struct problem ignored;
    return fgl_read_lines("/proc/cpuinfo", has_fma_flag, &found, &ignored) && found;
#elif defined(__aarch64__)
    return true; /* part of the base instruction set */
#else
    return false;
#endif
}
