/* The Khronos registry's list of OpenGL 1.0 to 1.5 with the imaging subset and of each extension offered (gl.xml of Debian's khronos-api) against the library: every command is
 * exported and answers, every token is declared with its value, every state variable can be queried. What is still missing
 * stands in registry_missing.txt, which may only shrink: an entry that is there after all fails the test.
 *
 * gl.xml is read as text: each element that matters here stands on lines of its own. */
#include "api/gl_test.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

static const char registry_path[] = "/usr/share/khronos-api/gl.xml";
static const char missing_path[] = "tests/api/registry_missing.txt";

static char *registry, *headers, *missing;
static int failures;

static char *read_text(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (!f) {
        print_error("cannot read %s\n", path);
        exit(1);
    }
    fseek(f, 0, SEEK_END);
    const long size = ftell(f);
    rewind(f);
    char *text = calloc(1, (size_t)size + 2);
    assert_int_equal(fread(text + 1, 1, (size_t)size, f), size);
    text[0] = '\n';
    fclose(f);
    return text;
}

/* Whether `name` is a line of registry_missing.txt. */
static bool is_expected_missing(const char *name)
{
    char line[128];
    snprintf(line, sizeof line, "\n%s\n", name);
    return strstr(missing, line) != NULL;
}

/* One fact about a name: it holds, or the name is expected to be missing, and not both. */
static void expect(bool holds, const char *name, const char *what)
{
    if (holds != is_expected_missing(name))
        return;
    print_error(holds ? "%s is there: take it off %s\n" : "%s %s\n", name, holds ? missing_path : what);
    failures++;
}

/* The value of an attribute of the element at `tag`; false if it has none. */
static bool attribute(const char *tag, const char *name, char *value, size_t size)
{
    char key[32];
    snprintf(key, sizeof key, " %s=\"", name);
    const char *end = strchr(tag, '>'), *at = strstr(tag, key);
    if (!at || at > end)
        return false;
    at += strlen(key);
    const size_t n = strcspn(at, "\"");
    snprintf(value, size, "%.*s", (int)n, at);
    return true;
}

/* Calls f with the name of each `element` between the tag that starts with `begin` and the tag `end`. */
static void each_name_between(const char *begin, const char *end, const char *element, void (*f)(const char *name))
{
    char open[32], name[128];
    snprintf(open, sizeof open, "<%s ", element);
    const char *at = strstr(registry, begin);
    assert_non_null(at);
    const char *last = strstr(at, end);
    for (at = strstr(at, open); at && at < last; at = strstr(at + 1, open))
        if (attribute(at, "name", name, sizeof name))
            f(name);
}

/* The same with all that OpenGL 1.0 to 1.5 and its imaging subset are made of. */
static void each_name(const char *element, void (*f)(const char *name))
{
    for (int minor = 0; minor <= 5; minor++) {
        char feature[64];
        snprintf(feature, sizeof feature, "<feature api=\"gl\" name=\"GL_VERSION_1_%d\"", minor);
        each_name_between(feature, "</feature>", element, f);
    }
    each_name_between("<extension name=\"GL_ARB_imaging\"", "</extension>", element, f);
}

/* The same with what the extensions are made of that this library names. */
static void each_name_of_extensions(const char *element, void (*f)(const char *name))
{
    const char *at = (const char *)glGetString(GL_EXTENSIONS);
    for (size_t n; (n = strcspn(at, " ")) > 0; at += n + strspn(at + n, " ")) {
        char begin[128];
        snprintf(begin, sizeof begin, "<extension name=\"%.*s\"", (int)n, at);
        const char *tag = strstr(registry, begin);
        if (tag && strchr(tag, '>')[-1] != '/') /* else it has nothing of its own */
            each_name_between(begin, "</extension>", element, f);
    }
}

/* ---- commands ---- */

/* Integers and pointers, then floating point values, whatever their order: as the calling conventions of x86-64 and
 * AArch64 put them. */
typedef intptr_t any_command(intptr_t, intptr_t, intptr_t, intptr_t, intptr_t, intptr_t, double, double, double, double,
                             double, double, double, double, intptr_t, intptr_t, intptr_t, intptr_t, intptr_t, intptr_t);

/* A command's integers are 0 and its pointers point here. */
static union {
    double align;
    char bytes[1 << 16];
} memory;

/* The integer and pointer arguments of a command, from its element in the registry. */
static bool read_arguments(const char *name, intptr_t argument[12])
{
    char proto[128];
    snprintf(proto, sizeof proto, "<name>%s</name></proto>", name);
    const char *at = strstr(registry, proto);
    if (!at)
        return false;
    const char *end = strstr(at, "</command>");
    int n = 0;
    for (at = strstr(at, "<param"); at && at < end && n < 12; at = strstr(at + 1, "<param")) {
        const char *close = strstr(at, "</param>"), *star = strchr(at, '*');
        const char *type = strstr(at, "<ptype>GL");
        const bool pointer = star && star < close;
        const bool real = type && type < close && (strncmp(type + 9, "float", 5) == 0 || strncmp(type + 9, "double", 6) == 0);
        if (pointer || !real)
            argument[n++] = pointer ? (intptr_t)&memory : 0;
    }
    return true;
}

static void call(const char *name, any_command *f)
{
#if defined(__x86_64__) || defined(__aarch64__)
    intptr_t a[12] = {0};
    if (!read_arguments(name, a)) {
        print_error("%s has no prototype in the registry\n", name);
        failures++;
        return;
    }
    f(a[0], a[1], a[2], a[3], a[4], a[5], 0, 0, 0, 0, 0, 0, 0, 0, a[6], a[7], a[8], a[9], a[10], a[11]);
    glEnd();
    while (glGetError() != GL_NO_ERROR)
        continue;
#else
    (void)name, (void)f;
#endif
}

static void check_command(const char *name)
{
    any_command *f = (any_command *)OSMesaGetProcAddress(name);
    expect(f && dlsym(RTLD_DEFAULT, name), name, "is not exported");
    if (f)
        call(name, f);
}

static void every_command(void **state)
{
    (void)state;
    failures = 0;
    each_name("command", check_command);
    each_name_of_extensions("command", check_command);
    assert_int_equal(failures, 0);
}

/* ---- tokens ---- */

/* The element that gives a token its value, for desktop OpenGL; NULL if there is none. */
static const char *find_token(const char *name)
{
    char key[128], api[16];
    snprintf(key, sizeof key, "name=\"%s\"", name);
    for (const char *at = strstr(registry, key); at; at = strstr(at + 1, key)) {
        const char *tag = at;
        while (*tag != '<')
            tag--;
        if (strncmp(tag, "<enum value=", 12) == 0 && (!attribute(tag, "api", api, sizeof api) || strcmp(api, "gl") == 0))
            return tag;
    }
    return NULL;
}

static void check_token(const char *name)
{
    char value[32] = "", define[128];
    const char *tag = find_token(name);
    snprintf(define, sizeof define, "\n#define %s ", name);
    const char *declared = strstr(headers, define);
    const bool equal = tag && attribute(tag, "value", value, sizeof value) && declared &&
                       strtoul(declared + strlen(define), NULL, 0) == strtoul(value, NULL, 0);
    expect(equal, name, "is not declared with the registry's value");
}

static void every_token(void **state)
{
    (void)state;
    failures = 0;
    each_name("enum", check_token);
    each_name_of_extensions("enum", check_token);
    assert_int_equal(failures, 0);
}

/* ---- state ---- */

static void check_state(const char *name)
{
    char group[512], value[32];
    GLdouble v[16];
    const char *tag = find_token(name);
    if (!tag || !attribute(tag, "group", group, sizeof group) || !strstr(group, "GetPName") ||
        !attribute(tag, "value", value, sizeof value))
        return;
    glGetDoublev((GLenum)strtoul(value, NULL, 0), v);
    char entry[160];
    snprintf(entry, sizeof entry, "glGet %s", name);
    expect(glGetError() == GL_NO_ERROR, entry, "is GL_INVALID_ENUM");
}

static void every_state_variable(void **state)
{
    (void)state;
    failures = 0;
    each_name("enum", check_state);
    assert_int_equal(failures, 0);
}

int main(void)
{
    registry = read_text(registry_path);
    missing = read_text(missing_path);
    char *gl = read_text("include/GL/gl.h"), *glext = read_text("include/GL/glext.h");
    headers = calloc(1, strlen(gl) + strlen(glext) + 1);
    strcat(strcpy(headers, gl), glext);
    const struct CMUnitTest tests[] = {
            GL_TEST(every_command),
            GL_TEST(every_token),
            GL_TEST(every_state_variable),
    };
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    free(registry);
    free(missing);
    free(gl);
    free(glext);
    free(headers);
    return result;
}
