/* Every command with parameters without sense, in any order and state: FixedGL neither crashes nor hangs, nor reads or writes outside of
 * what it was given (what the address sanitizer sees: make asan).
 *
 * usage: misuse [--seed N] [--contexts N] [--calls N] [--trace]
 *
 * The commands are those of the headers (calls.awk, groups.def). Pointers are to memory that has room for whatever the sizes can ask for: what is read
 * holds small numbers, so that it may be indexes, what is written is never read. Lists are not called while one is compiled: sixty-four
 * levels of calls to themselves take as long as they take. */
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    LARGEST = 64,            /* size, skip or index of commands with pointers */
    ROOM = 96 << 20,         /* an image of (size + skip)^3 pixels of 16 bytes, and convolution's border */
    FILLED = 1 << 20,
    MAX_WINDOW = 100,
    SECONDS = 30,            /* that a command may take, with a sanitizer and other programs beside it */
};

static unsigned char *given, *written;
static unsigned char picture[MAX_WINDOW * MAX_WINDOW * 16];

/* ---- random values ---- */

static uint64_t random_state;

static unsigned below(unsigned n)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(random_state >> 33) % n;
}

static const GLenum enumerants[] = {
#include "enumerants.inc"
};

/* Any, or the neighbour of the one before, as those of a target, its parameters and their values often are. */
static GLenum enumerant(void)
{
    static GLenum last;
    switch (below(8)) {
    case 0: return last = below(70000);
    case 1: case 2: return last += below(8);
    default: return last = enumerants[below(sizeof enumerants / sizeof *enumerants)];
    }
}

#define GROUP(name, ...) static const GLenum name##_group[] = {__VA_ARGS__};
#include "groups.def"
#undef GROUP

static GLenum one_of(const GLenum *group, size_t n)
{
    return below(16) ? group[below((unsigned)n)] : enumerant();
}
#define ONE_OF(name) one_of(name##_group, sizeof name##_group / sizeof *name##_group)

static int small_integer(void)
{
    static const int sizes[] = {0, 1, 2, 3, 4, 5, 7, 8, 16, 31, 32, 33, LARGEST - 1, LARGEST};
    return below(12) == 0 ? -(int)below(70) : sizes[below(sizeof sizes / sizeof *sizes)];
}

static int integer(void)
{
    static const int extremes[] = {-1, -2, INT32_MIN, INT32_MIN + 1, INT32_MAX, 65536, 16385, 8193, 1 << 20, -65537};
    return below(5) == 0 ? extremes[below(sizeof extremes / sizeof *extremes)] : small_integer();
}

static double number(void)
{
    static const double extremes[] = {1e30, -1e30, 1e38, -1e38, (double)INFINITY, -(double)INFINITY, (double)NAN, 1e-38, 1e-45, -0.0, 90, 180, 1e-6, 65536,
                                      4294967296.0, -4294967296.0, 0.999999};
    static const double usual[] = {0, 1, -1, 0.5, 2, -0.5, 0.25, 3, 10, 100};
    switch (below(12)) {
    case 0: return extremes[below(sizeof extremes / sizeof *extremes)];
    case 1: case 2: case 3: return below(1000) / 500.0 - 1.0;
    default: return usual[below(sizeof usual / sizeof *usual)];
    }
}

static GLbitfield bits(void)
{
    return below(4) == 0 ? ~0u : below(2) ? 1u << below(24) : below(1u << 24);
}

/* For a parameter that its command's pname tells the meaning of. */
static int integer_parameter(void)
{
    return below(3) ? (int)ONE_OF(value) : integer();
}

static double parameter(void)
{
    return below(3) ? ONE_OF(value) : number();
}

static int level(void)
{
    return below(8) ? (int)below(7) : integer();
}

static int border(void)
{
    return below(8) ? (int)below(2) : integer();
}

static const void *indexes(void)
{
    return given + 8 * below(64);
}

static const void *numbers(void)
{
    return given + FILLED + 8 * below(64);
}

static void *output(void)
{
    return written + 8 * below(64);
}

static void *pointers(void)
{
    static const void *all[LARGEST];
    for (int i = 0; i < LARGEST; i++)
        all[i] = indexes();
    return all;
}

/* ---- the commands ---- */

static const char *const names[] = {
#define CALL(name, arguments) #name,
#include "calls.inc"
#undef CALL
};
enum { COMMANDS = sizeof names / sizeof *names };

static void call(int command)
{
    enum {
#define CALL(name, arguments) CALL_##name,
#include "calls.inc"
#undef CALL
    };
    switch (command) {
#define CALL(name, arguments) case CALL_##name: name arguments; break;
#include "calls.inc"
#undef CALL
    }
}

static bool is_list_call(int command)
{
    return strncmp(names[command], "glCallList", 10) == 0;
}

static struct {
    int seed, contexts, calls;
    bool trace;
} options = {1, 500, 800, false};

/* What is called, for those who look for the reason of a crash. */
static int seed, count, current;

static void hung(int signal_number)
{
    (void)signal_number;
    fprintf(stderr, "misuse: %s takes more than %d s, seed %d, call %d\n", names[current], SECONDS, seed, count);
    abort();
}

static void call_one(void)
{
    GLint compiled = 0;
    current = (int)below(COMMANDS);
    if (is_list_call(current)) {
        glGetIntegerv(GL_LIST_INDEX, &compiled);
        if (compiled)
            return;
    }
    if (options.trace)
        fprintf(stderr, "%d %s\n", count, names[current]);
    alarm(SECONDS);
    glBindBuffer(GL_PIXEL_PACK_BUFFER_ARB, 0); /* buffer objects are read, maybe as indexes */
    call(current);
    if (below(12) == 0)
        glEnd();
    if (below(60) == 0)
        glEndList();
    if (below(40) == 0)
        glBindBuffer(below(2) ? GL_ARRAY_BUFFER : GL_ELEMENT_ARRAY_BUFFER, 0);
    if (below(60) == 0)
        glUnmapBuffer(GL_ARRAY_BUFFER);
}

static void run_context(void)
{
    static const GLenum formats[] = {OSMESA_RGBA, OSMESA_RGBA, OSMESA_BGRA, OSMESA_RGB, OSMESA_COLOR_INDEX};
    const OSMesaContext context = OSMesaCreateContextExt(formats[below(5)], below(4) ? 24 : 16, below(4) ? 8 : 0, below(2) ? 16 : 0, NULL);
    if (OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, 1 + (int)below(MAX_WINDOW), 1 + (int)below(MAX_WINDOW))) {
        for (count = 0; count < options.calls; count++)
            call_one();
        glEnd();
        glEndList();
        glFinish();
    }
    OSMesaDestroyContext(context);
}

static void read_options(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--trace") == 0)
            options.trace = true;
        else if (i + 1 < argc && strcmp(argv[i], "--seed") == 0)
            options.seed = atoi(argv[++i]);
        else if (i + 1 < argc && strcmp(argv[i], "--contexts") == 0)
            options.contexts = atoi(argv[++i]);
        else if (i + 1 < argc && strcmp(argv[i], "--calls") == 0)
            options.calls = atoi(argv[++i]);
        else {
            fprintf(stderr, "misuse: what is %s?\n", argv[i]);
            exit(2);
        }
    }
}

int main(int argc, char **argv)
{
    read_options(argc, argv);
    given = calloc(1, ROOM);
    written = calloc(1, ROOM);
    if (!given || !written)
        return 1;
    for (int i = 0; i < FILLED; i += 4)
        given[i] = (unsigned char)(i * 7 % (LARGEST - 3));
    for (int i = 0; i < FILLED; i += (int)sizeof(float)) {
        const float f = (float)number();
        memcpy(given + FILLED + i, &f, sizeof f);
    }
    signal(SIGALRM, hung);
    for (seed = options.seed; seed < options.seed + options.contexts; seed++) {
        random_state = (uint64_t)seed * 0x9e3779b97f4a7c15u + 1;
        run_context();
        if (seed % 500 == 0)
            fprintf(stderr, "misuse: seed %d\n", seed);
    }
    alarm(0);
    free(given);
    free(written);
    printf("%d contexts, %d calls each, of %d commands\n", options.contexts, options.calls, COMMANDS);
    return 0;
}
