/* What the tests of headless programs share: each test runs a program in a child process, with FIXEDGL_* variables
 * set, and looks at its exit status, at what it wrote to stdout and stderr, and at its pictures. */
#ifndef TESTS_GLUT_HEADLESS_H
#define TESTS_GLUT_HEADLESS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmocka.h>
#include <GL/glut.h>

static char directory[] = "/tmp/fixedgl-glut-XXXXXX";
static char output[4096]; /* stdout of the last child, then its stderr */

static inline const char *path(const char *name)
{
    static char paths[4][64];
    static int next;
    char *p = paths[next++ % 4];
    snprintf(p, sizeof paths[0], "%s/%s", directory, name);
    return p;
}

static inline void read_output(const char *name)
{
    size_t used = strlen(output);
    FILE *file = fopen(path(name), "rb");
    assert_non_null(file);
    used += fread(output + used, 1, sizeof output - 1 - used, file);
    output[used] = 0;
    fclose(file);
}

static inline void set_variable(const char *assignment)
{
    char name[64];
    size_t length = strcspn(assignment, "=");
    snprintf(name, sizeof name, "%.*s", (int)length, assignment);
    setenv(name, assignment + length + 1, 1);
}

/* Runs program(); variables are "NAME=value" strings, NULL at the end. Returns its exit status. */
static inline int run(void (*program)(void), const char *const *variables)
{
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        for (; *variables; variables++)
            set_variable(*variables);
        if (chdir(directory) != 0 || !freopen("stdout", "wb", stdout) || !freopen("stderr", "wb", stderr))
            _exit(99);
        char name[] = "program", *arguments[] = {name, NULL};
        int count = 1;
        glutInit(&count, arguments);
        program();
        exit(98); /* glutMainLoop does not return */
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    output[0] = 0;
    read_output("stdout");
    read_output("stderr");
    if (!WIFEXITED(status))
        fail_msg("ended by signal %d: %s", WTERMSIG(status), output);
    return WEXITSTATUS(status);
}

#define VARIABLES(...) ((const char *const[]){__VA_ARGS__, NULL})

static inline void expect_run(void (*program)(void), const char *const *variables, int status, const char *wanted)
{
    int got = run(program, variables);
    assert_string_equal(output, wanted);
    assert_int_equal(got, status);
}

/* Pixel (x, y from the top) of a PAM file of the given size. */
static inline uint32_t pam_pixel(const char *name, int width, int height, int x, int y)
{
    unsigned char bytes[4096];
    char size[64];
    FILE *file = fopen(path(name), "rb");
    assert_non_null(file);
    size_t length = fread(bytes, 1, sizeof bytes - 1, file);
    fclose(file);
    bytes[length] = 0; /* the header is text without zeros */
    const char *header = (const char *)bytes, *end = strstr(header, "ENDHDR\n");
    snprintf(size, sizeof size, "\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\n", width, height);
    assert_int_equal(strncmp(header, "P7\n# GL_RENDERER: ", 18), 0);
    assert_non_null(strstr(header, size));
    assert_non_null(end);
    const unsigned char *pixels = bytes + (end - header) + 7;
    assert_int_equal(bytes + length - pixels, 4 * width * height);
    const unsigned char *rgba = pixels + 4 * (y * width + x);
    return (uint32_t)rgba[0] << 24 | (uint32_t)rgba[1] << 16 | (uint32_t)rgba[2] << 8 | rgba[3];
}

static inline int make_directory(void **state)
{
    (void)state;
    return mkdtemp(directory) ? 0 : -1;
}

static inline int remove_directory(void **state)
{
    static const char *const names[] = {"stdout", "stderr", "a.pam", "a.depth"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        remove(path(names[i]));
    return rmdir(directory);
}

#endif
