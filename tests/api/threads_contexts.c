/*
 * Several contexts at once, each current in a thread of its own, draw the same pictures as one after the
 * other.
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/gl.h>
#include <GL/osmesa.h>

enum { THREADS = 6, SIZE = 96, FRAMES = 12, RINGS = 16, SEGMENTS = 24, BYTES = 4 * SIZE * SIZE };

struct painter {
    int number;
    OSMesaContext share;
    GLuint shared_list;
    unsigned char picture[BYTES];
    GLenum error;
    int failed;
};

/* A bumpy sheet; a different one for each number. */
static void draw_sheet(int number)
{
    for (int ring = 0; ring < RINGS; ring++) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= SEGMENTS; i++)
            for (int k = 0; k < 2; k++) {
                const float x = (float)i / SEGMENTS * 2 - 1, y = (float)(ring + k) / RINGS * 2 - 1;
                glColor3f(0.5f + 0.5f * x, 0.5f + 0.5f * y, (float)number / THREADS);
                glNormal3f(x, y, 1);
                glVertex3f(x, y, 0.3f * x * y + 0.05f * (float)((i * number) % 3));
            }
        glEnd();
    }
}

static void draw_frame(const struct painter *painter, int frame)
{
    const int number = painter->number;
    const float light[4] = {(float)number - 2, 1, 2, (float)(number & 1)};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glRotatef((float)(10 * frame + 30 * number), 0.3f, 1, 0.2f);
    if (painter->shared_list && number & 2)
        glCallList(painter->shared_list);
    draw_sheet(number);
    glFinish();
}

static void set_up(int number)
{
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_COLOR_MATERIAL);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glShadeModel(number & 4 ? GL_FLAT : GL_SMOOTH);
    glClearColor((float)number / 8, 0.25f, 0.5f, 1);
}

static void *paint(void *argument)
{
    struct painter *painter = argument;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, painter->share);
    if (!context || !OSMesaMakeCurrent(context, painter->picture, GL_UNSIGNED_BYTE, SIZE, SIZE)) {
        painter->failed = 1;
        return NULL;
    }
    set_up(painter->number);
    for (int frame = 0; frame < FRAMES; frame++) {
        draw_frame(painter, frame);
        painter->failed |= OSMesaGetCurrentContext() != context;
    }
    painter->error = glGetError();
    OSMesaDestroyContext(context);
    return NULL;
}

static void check(const struct painter *painter)
{
    assert_int_equal(painter->failed, 0);
    assert_int_equal(painter->error, GL_NO_ERROR);
}

/* Draws one after the other, then all at once, and compares. */
static void compare(OSMesaContext share, GLuint list)
{
    static struct painter alone[THREADS], together[THREADS];
    pthread_t thread[THREADS];
    for (int i = 0; i < THREADS; i++) {
        alone[i] = together[i] = (struct painter){.number = i, .share = share, .shared_list = list};
        paint(&alone[i]);
        check(&alone[i]);
    }
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, paint, &together[i]), 0);
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    for (int i = 0; i < THREADS; i++) {
        check(&together[i]);
        assert_memory_equal(alone[i].picture, together[i].picture, BYTES);
        assert_memory_not_equal(alone[i].picture, alone[(i + 1) % THREADS].picture, BYTES);
    }
}

static void test_own(void **state)
{
    (void)state;
    compare(NULL, 0);
}

static void test_shared_lists(void **state)
{
    (void)state;
    unsigned char picture[4];
    OSMesaContext owner = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_true(OSMesaMakeCurrent(owner, picture, GL_UNSIGNED_BYTE, 1, 1));
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glScalef(0.7f, 0.7f, 0.7f);
    draw_sheet(5);
    glEndList();
    compare(owner, list);
    OSMesaDestroyContext(owner);
}

/* A context may move to another thread, once it is no longer current in the first. */
static void *finish_elsewhere(void *argument)
{
    struct painter *painter = argument;
    painter->failed = !OSMesaMakeCurrent(painter->share, painter->picture, GL_UNSIGNED_BYTE, SIZE, SIZE);
    draw_frame(painter, 3);
    painter->error = glGetError();
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    return NULL;
}

static void test_moving(void **state)
{
    (void)state;
    static struct painter here, there;
    here = there = (struct painter){.number = 1};
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_true(OSMesaMakeCurrent(context, here.picture, GL_UNSIGNED_BYTE, SIZE, SIZE));
    set_up(1);
    draw_frame(&here, 3);
    assert_true(OSMesaMakeCurrent(NULL, NULL, 0, 0, 0));
    there.share = context;
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, finish_elsewhere, &there), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    check(&there);
    assert_memory_equal(here.picture, there.picture, BYTES);
    OSMesaDestroyContext(context);
}

/* ---- objects that one thread changes while others draw with them ---- */

enum { CHANGES = 900, LARGE = 128 };

struct shared {
    GLuint texture, buffer, renderbuffer, list;
    GLint size; /* of the texture, at first */
};
static struct shared shared;
static OSMesaContext owner;

/* All of one colour: red of this size, green of another. */
static void define_texture(int size)
{
    static _Thread_local GLubyte texels[LARGE * LARGE][4];
    for (int i = 0; i < size * size; i++)
        memcpy(texels[i], size == shared.size ? "\xff\x00\x00\xff" : "\x00\xff\x00\xff", 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

static void make_shared(void)
{
    shared.size = 4;
    glGenTextures(1, &shared.texture);
    glBindTexture(GL_TEXTURE_2D, shared.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    define_texture(4);
    glGenBuffers(1, &shared.buffer);
    glBindBuffer(GL_ARRAY_BUFFER, shared.buffer);
    glBufferData(GL_ARRAY_BUFFER, 64, NULL, GL_STATIC_DRAW);
    glGenRenderbuffers(1, &shared.renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, shared.renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
    shared.list = glGenLists(1);
}

static void *change(void *argument)
{
    struct painter *painter = argument;
    static const float square[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, owner);
    painter->failed = !OSMesaMakeCurrent(context, painter->picture, GL_UNSIGNED_BYTE, 1, 1);
    glBindTexture(GL_TEXTURE_2D, shared.texture);
    glBindBuffer(GL_ARRAY_BUFFER, shared.buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, shared.renderbuffer);
    for (int i = 0; i < CHANGES; i++) {
        GLuint name;
        define_texture(i % 3 ? 4 : LARGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, i & 1 ? GL_LINEAR : GL_NEAREST);
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(sizeof square) * (1 + i % 5), NULL, GL_STATIC_DRAW);
        glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof square, square);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4 + i % 40, 4 + i % 40);
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_3D, name);
        glDeleteTextures(1, &name);
        glNewList(shared.list, GL_COMPILE);
        glColor3f(1, 1, 1);
        glEndList();
    }
    painter->error = glGetError();
    OSMesaDestroyContext(context);
    return NULL;
}

static void draw_shared(void)
{
    static const GLfloat corner[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glTexCoordPointer(2, GL_FLOAT, 0, NULL);
    glCallList(shared.list);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glTexCoordPointer(2, GL_FLOAT, 0, corner);
    glBindBuffer(GL_ARRAY_BUFFER, shared.buffer);
    glDrawArrays(GL_QUADS, 0, 4);
}

/* A frame is of one colour: that of the texture before a change or after it. */
static bool is_uniform(const unsigned char *picture)
{
    for (int i = 4; i < BYTES; i++)
        if (picture[i] != picture[i - 4])
            return false;
    return true;
}

static void *draw_with_shared(void *argument)
{
    struct painter *painter = argument;
    GLuint framebuffer;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, owner);
    painter->failed = !OSMesaMakeCurrent(context, painter->picture, GL_UNSIGNED_BYTE, SIZE, SIZE);
    glBindTexture(GL_TEXTURE_2D, shared.texture);
    glBindBuffer(GL_ARRAY_BUFFER, shared.buffer);
    glEnable(GL_TEXTURE_2D);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glGenFramebuffers(1, &framebuffer);
    for (int i = 0; i < CHANGES / 3; i++) {
        draw_shared();
        glFinish();
        painter->failed |= !is_uniform(painter->picture);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, shared.renderbuffer);
        draw_shared();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    painter->error = glGetError();
    OSMesaDestroyContext(context);
    return NULL;
}

static void test_changing_shared_objects(void **state)
{
    (void)state;
    static struct painter painter[THREADS];
    unsigned char picture[4];
    pthread_t thread[THREADS];
    owner = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_true(OSMesaMakeCurrent(owner, picture, GL_UNSIGNED_BYTE, 1, 1));
    make_shared();
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, i ? draw_with_shared : change, &painter[i]), 0);
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    for (int i = 0; i < THREADS; i++)
        check(&painter[i]);
    OSMesaDestroyContext(owner);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_own),
            cmocka_unit_test(test_shared_lists),
            cmocka_unit_test(test_moving),
            cmocka_unit_test(test_changing_shared_objects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
