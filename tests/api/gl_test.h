/* What the API tests share: a context for each test, and checks of errors and queries.
 * The tests use the public API alone, so that the same program also runs on Mesa's OSMesa
 * (LD_PRELOAD=libOSMesa.so.8), which shows that what they expect is right. Where FixedGL differs on purpose
 * the expectation says so: on_fixedgl(). */
#ifndef TESTS_API_GL_TEST_H
#define TESTS_API_GL_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/osmesa.h>
#include <fixedgl.h>

enum { TEST_SIZE = 64 };

static unsigned char picture[TEST_SIZE * TEST_SIZE * 4]; /* RGBA, bottom row first */

static inline int make_context(void **state)
{
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, NULL);
    *state = context;
    if (!context || !OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE))
        return -1;
    return glGetError() == GL_NO_ERROR ? 0 : -1;
}

static inline int destroy_context(void **state)
{
    OSMesaDestroyContext(*state);
    return 0;
}

#define GL_TEST(function) cmocka_unit_test_setup_teardown(function, make_context, destroy_context)

static inline bool on_fixedgl(void)
{
    return strcmp((const char *)glGetString(GL_VENDOR), "FixedGL") == 0;
}

/* Fails unless the call raises exactly this error. */
#define EXPECT_ERROR(error, call)                                                                            \
    do {                                                                                                     \
        call;                                                                                                \
        check_error((error), #call, __FILE__, __LINE__);                                                     \
    } while (0)
#define EXPECT_NO_ERROR(call) EXPECT_ERROR(GL_NO_ERROR, call)

static inline void check_error(GLenum expected, const char *call, const char *file, int line)
{
    const GLenum error = glGetError();
    if (error == expected)
        return;
    print_error("%s:%d: %s: error 0x%04x, expected 0x%04x\n", file, line, call, error, expected);
    _fail(file, line);
}

/* Fails unless n values are equal, bit by bit for floats. */
#define EXPECT_INTS(name, ...)                                                                               \
    do {                                                                                                     \
        const GLint expected_[] = {__VA_ARGS__};                                                             \
        GLint got_[16] = {0};                                                                                \
        glGetIntegerv((name), got_);                                                                         \
        check_ints(got_, expected_, sizeof expected_ / sizeof *expected_, #name, __FILE__, __LINE__);        \
    } while (0)
#define EXPECT_FLOATS(get, ...)                                                                              \
    do {                                                                                                     \
        const GLfloat expected_[] = {__VA_ARGS__};                                                           \
        GLfloat got_[16] = {0};                                                                              \
        get;                                                                                                 \
        check_floats(got_, expected_, sizeof expected_ / sizeof *expected_, #get, __FILE__, __LINE__);       \
    } while (0)
#define EXPECT_VALUES(name, ...) EXPECT_FLOATS(glGetFloatv((name), got_), __VA_ARGS__)
#define EXPECT_LIGHT(i, pname, ...) EXPECT_FLOATS(glGetLightfv(GL_LIGHT0 + (i), (pname), got_), __VA_ARGS__)
#define EXPECT_MATERIAL(face, pname, ...) EXPECT_FLOATS(glGetMaterialfv((face), (pname), got_), __VA_ARGS__)

static inline void check_ints(const GLint *got, const GLint *expected, size_t n, const char *what,
                              const char *file, int line)
{
    for (size_t i = 0; i < n; i++) {
        if (got[i] == expected[i])
            continue;
        print_error("%s:%d: %s [%zu]: %d, expected %d\n", file, line, what, i, got[i], expected[i]);
        _fail(file, line);
    }
}

static inline void check_floats(const GLfloat *got, const GLfloat *expected, size_t n, const char *what,
                                const char *file, int line)
{
    for (size_t i = 0; i < n; i++) {
        if (got[i] == expected[i])
            continue;
        print_error("%s:%d: %s [%zu]: %.9g, expected %.9g\n", file, line, what, i, (double)got[i],
                    (double)expected[i]);
        _fail(file, line);
    }
}

#endif
