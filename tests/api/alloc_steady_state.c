/*
 * In steady state nothing is allocated, per vertex or per frame: after a few frames, the same frames again
 * make no call of the allocator. Its functions are counted by definitions of this program that pass on to the
 * next.
 */
#define _GNU_SOURCE /* RTLD_NEXT */
#include <dlfcn.h>
#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/gl.h>
#include <GL/osmesa.h>

/* ---- the counter ---- */

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define HAS_OWN_ALLOCATOR
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define HAS_OWN_ALLOCATOR
#endif

#ifndef HAS_OWN_ALLOCATOR
static atomic_long allocations;

/* dlsym may allocate before it has found the allocator. */
static _Alignas(64) unsigned char early[8192];
static size_t early_used;

static void *allocate_early(size_t size)
{
    void *block = early + early_used;
    early_used += (size + 63) & ~(size_t)63;
    return early_used <= sizeof early ? block : NULL;
}

static int is_early(const void *block)
{
    return (uintptr_t)block - (uintptr_t)early < sizeof early;
}

/* The next definition of the function, or NULL while dlsym is looking for one. */
static void *next(const char *name)
{
    static _Thread_local int looking;
    if (looking)
        return NULL;
    looking = 1;
    void *function = dlsym(RTLD_NEXT, name);
    looking = 0;
    return function;
}

void *malloc(size_t size)
{
    static void *(*real)(size_t);
    atomic_fetch_add(&allocations, 1);
    if (!real)
        *(void **)&real = next("malloc");
    return real ? real(size) : allocate_early(size);
}

void *calloc(size_t count, size_t size)
{
    static void *(*real)(size_t, size_t);
    atomic_fetch_add(&allocations, 1);
    if (!real)
        *(void **)&real = next("calloc");
    return real ? real(count, size) : allocate_early(count * size);
}

void *realloc(void *block, size_t size)
{
    static void *(*real)(void *, size_t);
    atomic_fetch_add(&allocations, 1);
    if (!real)
        *(void **)&real = next("realloc");
    return real(block, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    static void *(*real)(size_t, size_t);
    atomic_fetch_add(&allocations, 1);
    if (!real)
        *(void **)&real = next("aligned_alloc");
    return real(alignment, size);
}

int posix_memalign(void **block, size_t alignment, size_t size)
{
    static int (*real)(void **, size_t, size_t);
    atomic_fetch_add(&allocations, 1);
    if (!real)
        *(void **)&real = next("posix_memalign");
    return real(block, alignment, size);
}

void free(void *block)
{
    static void (*real)(void *);
    if (is_early(block))
        return;
    if (!real)
        *(void **)&real = next("free");
    real(block);
}

static long count_allocations(void)
{
    return atomic_load(&allocations);
}
#else
static long count_allocations(void)
{
    return 0;
}
#endif

/* ---- frames ---- */

enum { SIZE = 128, STACKS = 24, SLICES = 48, VERTICES = STACKS * SLICES, WARM_UP = 4, FRAMES = 10 };

static unsigned char pixels[4 * SIZE * SIZE];
static float position[VERTICES][3]; /* on the unit sphere: normals too */
static float color[VERTICES][4];
static GLushort indices[STACKS - 1][2 * SLICES];
static GLuint list;
static OSMesaContext context;

static void vertex(int i)
{
    glColor4fv(color[i]);
    glNormal3fv(position[i]);
    glVertex3fv(position[i]);
}

static void draw_immediate(void)
{
    for (int stack = 0; stack < STACKS - 1; stack++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 2 * SLICES; i++)
            vertex(indices[stack][i]);
        glEnd();
    }
}

/* More vertices in one glBegin than any batch holds, of each primitive, partly clipped. */
static void draw_long_primitives(void)
{
    glPushMatrix();
    glScalef(2, 2, 2);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; mode++) {
        glBegin(mode);
        for (int i = 0; i < VERTICES; i++)
            vertex(i);
        glEnd();
    }
    glPopMatrix();
}

static void set_arrays(void)
{
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, position);
    glNormalPointer(GL_FLOAT, 0, position);
    glColorPointer(4, GL_FLOAT, 0, color);
}

static void draw_arrays(void)
{
    set_arrays();
    for (int stack = 0; stack < STACKS - 1; stack++)
        glDrawElements(GL_TRIANGLE_STRIP, 2 * SLICES, GL_UNSIGNED_SHORT, indices[stack]);
    glDrawElements(GL_LINE_STRIP, 2 * SLICES, GL_UNSIGNED_SHORT, indices[0]);
    glDrawArrays(GL_POINTS, 0, VERTICES);
    glBegin(GL_LINES);
    for (int i = 0; i < VERTICES; i++)
        glArrayElement(i);
    glEnd();
}

static void draw_list(void)
{
    for (int i = 0; i < 5; i++) {
        glRotatef(20, 1, 1, 0);
        glCallList(list);
    }
}

static void change_state(void)
{
    static float turn;
    turn += 0.1f;
    for (int i = 0; i < 8; i++) {
        const GLenum light = GL_LIGHT0 + (GLenum)i;
        const float place[4] = {cosf(turn + (float)i), sinf(turn), 2, (float)(i & 1)};
        const float half[4] = {0.5f, 0.5f, 0.5f, 1};
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushMatrix();
        glRotatef(10 * turn, 0, 1, 0);
        glEnable(light);
        glLightfv(light, GL_POSITION, place);
        glLightf(light, GL_SPOT_CUTOFF, i & 2 ? 45.0f : 180.0f);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, i & 1);
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, half);
        glShadeModel(i & 1 ? GL_FLAT : GL_SMOOTH);
        glScissor(i, i, SIZE - i, SIZE - i);
        glEnable(GL_SCISSOR_TEST);
        glPolygonMode(GL_FRONT_AND_BACK, i & 4 ? GL_LINE : GL_FILL);
        draw_immediate();
        glPopMatrix();
        glPopAttrib();
    }
}

static void read_back(void)
{
    static unsigned char read[4 * SIZE * SIZE];
    static float depth[SIZE * SIZE];
    void *buffer;
    GLint w, h, bytes;
    draw_immediate();
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, read);
    glReadPixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    OSMesaGetDepthBuffer(context, &w, &h, &bytes, &buffer);
}

static void draw_frame(void (*draw)(void))
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    draw();
    glFinish();
}

static void compile_list(void)
{
    glNewList(list, GL_COMPILE);
    draw_immediate();
    glEndList();
}

static long allocations_of(void (*draw)(void))
{
    for (int i = 0; i < WARM_UP; i++)
        draw_frame(draw);
    const long before = count_allocations();
    for (int i = 0; i < FRAMES; i++)
        draw_frame(draw);
    return count_allocations() - before;
}

/* ---- tests ---- */

static int set_up(void **state)
{
    (void)state;
    for (int i = 0; i < VERTICES; i++) {
        const float theta = 3.14159265f * (float)(i / SLICES) / (STACKS - 1);
        const float phi = 6.2831853f * (float)(i % SLICES) / (SLICES - 1);
        position[i][0] = sinf(theta) * cosf(phi);
        position[i][1] = cosf(theta);
        position[i][2] = sinf(theta) * sinf(phi);
        for (int k = 0; k < 3; k++)
            color[i][k] = 0.5f + 0.5f * position[i][k];
        color[i][3] = 1;
    }
    for (int stack = 0; stack < STACKS - 1; stack++)
        for (int i = 0; i < 2 * SLICES; i++)
            indices[stack][i] = (GLushort)((stack + (i & 1)) * SLICES + i / 2);
    context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE))
        return -1;
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    list = glGenLists(1);
    compile_list();
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    OSMesaDestroyContext(context);
    return 0;
}

/* Allocations must be seen where there are some. */
static void test_counter(void **state)
{
    (void)state;
#ifdef HAS_OWN_ALLOCATOR
    skip();
#endif
    assert_true(allocations_of(compile_list) >= FRAMES);
}

static void test_immediate(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(draw_immediate), 0);
}

static void test_long_primitives(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(draw_long_primitives), 0);
}

static void test_arrays(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(draw_arrays), 0);
}

static void test_lists(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(draw_list), 0);
}

static void test_state_changes(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(change_state), 0);
}

static void test_reading(void **state)
{
    (void)state;
    assert_int_equal(allocations_of(read_back), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_counter),         cmocka_unit_test(test_immediate),
            cmocka_unit_test(test_long_primitives), cmocka_unit_test(test_arrays),
            cmocka_unit_test(test_lists),           cmocka_unit_test(test_state_changes),
            cmocka_unit_test(test_reading),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
