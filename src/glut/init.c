/* Initialization and messages. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <GL/freeglut.h>
#include "internal.h"

struct glut fgl_glut = {
        .mode = GLUT_RGBA | GLUT_SINGLE | GLUT_DEPTH,
        .x = -1,
        .y = -1,
        .width = 300,
        .height = 300,
        .context_version = {1, 0},
        .key_repeat = GLUT_KEY_REPEAT_DEFAULT,
};

typedef void report_function(const char *, va_list);

static void report(report_function *func, const char *format, va_list arguments)
{
    if (func) {
        func(format, arguments);
        return;
    }
    fputs("fixedglut: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
}

void fgl_glut_warn(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report(fgl_glut.warning, format, arguments);
    va_end(arguments);
}

void fgl_glut_fail(int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report(fgl_glut.error, format, arguments);
    va_end(arguments);
    exit(status);
}

void fgl_glut_require_init(const char *function)
{
    if (!fgl_glut.initialized)
        fgl_glut_fail(1, "%s called before glutInit", function);
}

struct window *fgl_glut_require_window(const char *function)
{
    fgl_glut_require_init(function);
    if (!fgl_glut.current)
        fgl_glut_fail(1, "%s called with no current window", function);
    return fgl_glut.current;
}

/* "640x480+10+20", any part of which may be missing, as XParseGeometry reads it. */
static void read_geometry(const char *text)
{
    int width, height, x, y, used = 0;
    if (sscanf(text, "%5dx%5d%n", &width, &height, &used) == 2) {
        glutInitWindowSize(width, height);
        text += used;
    }
    if (sscanf(text, "%6d%6d", &x, &y) == 2)
        glutInitWindowPosition(x, y);
}

/* Removes GLUT's own options from the command line. */
static void read_arguments(int *argcp, char **argv)
{
    static const char *const flags[] = {"-iconic", "-indirect", "-direct", "-sync", "-gldebug"};
    int kept = 1;
    for (int i = 1; i < *argcp; i++) {
        bool known = false;
        for (size_t f = 0; f < sizeof flags / sizeof flags[0]; f++)
            known = known || strcmp(argv[i], flags[f]) == 0;
        if (strcmp(argv[i], "-display") == 0 || strcmp(argv[i], "-geometry") == 0) {
            if (i + 1 == *argcp)
                fgl_glut_fail(1, "%s needs an argument", argv[i]);
            if (strcmp(argv[i++], "-geometry") == 0)
                read_geometry(argv[i]);
        } else if (!known) {
            argv[kept++] = argv[i];
        }
    }
    if (*argcp > kept) {
        *argcp = kept;
        argv[kept] = NULL;
    }
}

void glutInit(int *argcp, char **argv)
{
    if (fgl_glut.initialized)
        fgl_glut_fail(1, "glutInit called a second time");
    fgl_glut.initialized = true;
    if (argcp && argv)
        read_arguments(argcp, argv);
    fgl_headless_read_environment();
    fgl_clock_start();
}

void glutInitWindowPosition(int x, int y)
{
    fgl_glut.x = x;
    fgl_glut.y = y;
}

void glutInitWindowSize(int width, int height)
{
    if (width <= 0 || height <= 0) {
        fgl_glut_warn("glutInitWindowSize(%d, %d) is not a size", width, height);
        return;
    }
    fgl_glut.width = width;
    fgl_glut.height = height;
}

void glutInitDisplayMode(unsigned int mode)
{
    if (mode & GLUT_STEREO)
        fgl_glut_warn("GLUT_STEREO is not available");
    if (mode & GLUT_MULTISAMPLE)
        fgl_glut_warn("GLUT_MULTISAMPLE is not available");
    fgl_glut.mode = mode & ~(unsigned int)(GLUT_STEREO | GLUT_MULTISAMPLE);
}

void glutInitDisplayString(const char *words)
{
    static const struct {
        const char *word;
        unsigned int bit;
    } modes[] = {{"double", GLUT_DOUBLE}, {"depth", GLUT_DEPTH},   {"stencil", GLUT_STENCIL},
                 {"acc", GLUT_ACCUM},     {"acca", GLUT_ACCUM},    {"alpha", GLUT_ALPHA},
                 {"index", GLUT_INDEX},   {"stereo", GLUT_STEREO}, {"samples", GLUT_MULTISAMPLE}};
    unsigned int mode = GLUT_RGBA;
    while (*(words += strspn(words, " \t\n"))) {
        size_t length = strcspn(words, " \t\n"), name = strcspn(words, " \t\n<>=!~");
        for (size_t i = 0; i < sizeof modes / sizeof modes[0]; i++)
            if (strlen(modes[i].word) == name && strncmp(words, modes[i].word, name) == 0)
                mode |= modes[i].bit;
        words += length;
    }
    glutInitDisplayMode(mode);
}

void glutInitErrorFunc(void (*func)(const char *, va_list))
{
    fgl_glut.error = func;
}

void glutInitWarningFunc(void (*func)(const char *, va_list))
{
    fgl_glut.warning = func;
}

void glutInitContextVersion(int major, int minor)
{
    if (major > 1 || (major == 1 && minor > 5))
        fgl_glut_warn("OpenGL %d.%d is not available: contexts are of OpenGL 1.5", major, minor);
    fgl_glut.context_version[0] = major;
    fgl_glut.context_version[1] = minor;
}

void glutInitContextFlags(int flags)
{
    fgl_glut.context_flags = flags;
}

void glutInitContextProfile(int profile)
{
    fgl_glut.context_profile = profile;
}

GLUTproc glutGetProcAddress(const char *name)
{
    return OSMesaGetProcAddress(name);
}
