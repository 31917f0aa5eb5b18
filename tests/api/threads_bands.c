/* Many lines, and large pixel rectangles, are drawn in bands of rows that worker threads share (fgl_pipeline_bands): the bytes of colour, depth and stencil are those
 * that one thread draws. */
#define _XOPEN_SOURCE 700
#include "api/gl_test.h"

enum { SIZE = 300, IMAGE = 4 * SIZE * SIZE };

struct planes {
    GLubyte color[SIZE * SIZE * 4], stencil[SIZE * SIZE];
    GLfloat depth[SIZE * SIZE];
};

static GLuint image[IMAGE];

static void fill_image(void)
{
    unsigned seed = 1;
    for (int i = 0; i < IMAGE; i++) {
        seed = seed * 1664525u + 1013904223u;
        image[i] = seed & 0x3fffffffu; /* floats from 0 to 2, too */
    }
}

static void colors(void)
{
    glDrawPixels(SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDrawPixels(SIZE, SIZE - 7, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void blended(void)
{
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.2f);
    colors();
    glDrawPixels(SIZE, SIZE, GL_RGBA, GL_FLOAT, image);
}

static void zoomed(void)
{
    glPixelZoom(2.7f, 3.3f);
    glDrawPixels(SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glPixelZoom(1, -1);
    glRasterPos2f(-1, 0.9f);
    glDrawPixels(SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, image);
}

static void depths(void)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDrawPixels(SIZE, SIZE, GL_DEPTH_COMPONENT, GL_FLOAT, image);
    glDrawPixels(SIZE, SIZE, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, image);
    glDrawPixels(SIZE, SIZE, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, image);
}

static void copied(void)
{
    colors();
    glCopyPixels(20, 0, SIZE - 20, SIZE - 3, GL_COLOR);
}

static void counted(void)
{
    GLuint query, passed;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    colors();
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    assert_int_equal(passed, SIZE * SIZE + SIZE * (SIZE - 7));
}

/* A strip whose stipple goes on into the lines of the next band, some of it outside of the window, then level lines. */
static void lines(void)
{
    enum { VERTICES = 1500 };
    for (int k = 0; k < 2; k++) {
        glBegin(k ? GL_LINES : GL_LINE_STRIP);
        for (int i = 0; i < VERTICES; i++) {
            const GLuint *p = &image[4 * (k * VERTICES + i)], *first = p - (k ? 4 * (i % 2) : 0);
            glColor4ub(p[0] >> 5 & 255, p[1] >> 5 & 255, p[2] >> 5 & 255, 200);
            glVertex3f((float)(p[0] >> 8 & 1023) / 400 - 1.3f, (float)(first[1] >> 8 & 1023) / 400 - 1.3f, (float)(p[2] >> 8 & 1023) / 1023);
        }
        glEnd();
    }
}

static void plain_lines(void)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    lines();
}

static void stippled_lines(void)
{
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x4f0f);
    glLineWidth(4);
    lines();
}

static void smooth_lines(void)
{
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    stippled_lines();
    glLineWidth(1);
    plain_lines();
}

/* Draws with so many threads into *planes. */
static void draw(void (*scene)(void), const char *threads, struct planes *planes)
{
    static GLubyte buffer[SIZE * SIZE * 4];
    setenv("FIXEDGL_THREADS", threads, 1);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    assert_true(context && OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, SIZE, SIZE));
    glClearDepth(0.3);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glRasterPos2f(-1, -1);
    scene();
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, planes->color);
    glReadPixels(0, 0, SIZE, SIZE, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, planes->stencil);
    glReadPixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_FLOAT, planes->depth);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    OSMesaDestroyContext(context);
}

static void bands(void **state)
{
    static void (*const scenes[])(void) = {colors, blended, zoomed, depths, copied, counted, plain_lines, stippled_lines, smooth_lines};
    static const char *const threads[] = {"2", "5"};
    static struct planes one, some;
    (void)state;
    fill_image();
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        draw(scenes[i], "1", &one);
        for (int k = 0; k < 2; k++) {
            draw(scenes[i], threads[k], &some);
            assert_memory_equal(&one, &some, sizeof one);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bands)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
