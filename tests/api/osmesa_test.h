/* What the tests of the OSMesa interface share. They hold on Mesa's OSMesa too (LD_PRELOAD=libOSMesa.so.8)
 * but where on_mesa says otherwise. */
#ifndef TESTS_API_OSMESA_TEST_H
#define TESTS_API_OSMESA_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <GL/gl.h>
#include <GL/osmesa.h>

enum { WIDTH = 5, HEIGHT = 3, LARGEST = 16 };

union buffer {
    unsigned char byte[LARGEST * WIDTH * HEIGHT];
    uint16_t word[LARGEST * WIDTH * HEIGHT / 2];
    float real[LARGEST * WIDTH * HEIGHT / 4];
};

static inline OSMesaContext create(GLenum format)
{
    OSMesaContext context = OSMesaCreateContextExt(format, 24, 8, 0, NULL);
    assert_non_null(context);
    return context;
}

static inline OSMesaContext open_rgba(void *buffer)
{
    OSMesaContext context = create(OSMESA_RGBA);
    assert_true(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    return context;
}

static bool on_mesa;

static inline int find_out_whose(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext context = open_rgba(&buffer);
    on_mesa = strstr((const char *)glGetString(GL_VERSION), "Mesa") != NULL;
    OSMesaDestroyContext(context);
    return 0;
}

static inline void clear_to(float red, float green, float blue, float alpha)
{
    glClearColor(red, green, blue, alpha);
    glClear(GL_COLOR_BUFFER_BIT);
}

#endif
