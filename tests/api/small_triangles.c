/* Triangles of a few pixels are drawn many at once (pipeline/sieve_kernel.h, raster/small_kernel.h): the bytes are those of the general path, which
 * takes one after the other. */
#define _XOPEN_SOURCE 700
#include "api/gl_test.h"

#include <math.h>

enum { SIZE = 96, TRIANGLES = 3000 };

struct setting {
    const char *name;
    GLenum shade_model, depth_func, cull_face; /* 0: disabled */
    bool lit, scissor, offset, exact, constant;
    float side; /* pixels, of the largest triangles */
};

static unsigned seed;

static float random_float(float least, float greatest)
{
    seed = seed * 1664525u + 1013904223u;
    return least + (greatest - least) * (float)(seed >> 8) / (float)(1 << 24);
}

static void set_up(const struct setting *s)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 4);
    glShadeModel(s->shade_model);
    if (s->depth_func) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(s->depth_func);
    }
    if (s->cull_face) {
        glEnable(GL_CULL_FACE);
        glCullFace(s->cull_face);
    }
    if (s->lit) {
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
        glMaterialfv(GL_BACK, GL_DIFFUSE, (float[]){1, 0.3f, 0, 1});
    }
    if (s->scissor) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(13, 21, 50, 37);
    }
    if (s->offset) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.5f, 4);
    }
}

/* On half pixels: edges go through pixels' centres. */
static float place(float window, bool half_pixels)
{
    return half_pixels ? floorf(window * SIZE) / SIZE : window;
}

/* Most are small; one in fifty is large, so that the order between the two shows; some cross the frustum. */
static void draw(const struct setting *s)
{
    seed = 1;
    glColor3f(0.3f, 0.9f, 0.6f);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < TRIANGLES; i++) {
        const float side = (i % 50 ? s->side : 40) * 2 / SIZE, x = random_float(-1.05f, 1.05f), y = random_float(-1.05f, 1.05f);
        for (int k = 0; k < 3; k++) {
            const float z = random_float(1.2f, 3.5f);
            if (!s->constant)
                glColor3f(random_float(0, 1), random_float(0, 1), random_float(0, 1));
            glNormal3f(random_float(-1, 1), random_float(-1, 1), random_float(0, 1));
            const float at[2] = {x + random_float(-side, side), y + random_float(-side, side)};
            glVertex3f(place(at[0], i % 3 == 0) * z, place(at[1], i % 3 == 0) * z, -z);
        }
    }
    glEnd();
    glFinish();
}

struct result {
    uint32_t color[SIZE * SIZE], depth[SIZE * SIZE];
};

static void draw_by(const struct setting *s, const char *path, struct result *result)
{
    setenv("FIXEDGL_PATH", path, 1);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, NULL);
    assert_true(OSMesaMakeCurrent(context, result->color, GL_UNSIGNED_BYTE, SIZE, SIZE));
    unsetenv("FIXEDGL_PATH");
    if (on_fixedgl() && s->exact)
        fixedglAccuracy(FIXEDGL_EXACT);
    set_up(s);
    draw(s);
    glReadPixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, result->depth);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    OSMesaDestroyContext(context);
}

static void same_as_the_general_path(void **state)
{
    static const struct setting settings[] = {
        {"smooth, less", GL_SMOOTH, GL_LESS, 0, .side = 1.5f},
        {"smooth, lequal", GL_SMOOTH, GL_LEQUAL, 0, .side = 3},
        {"smooth, no depth test", GL_SMOOTH, 0, GL_BACK, .side = 1},
        {"flat, less", GL_FLAT, GL_LESS, GL_FRONT, .side = 2},
        {"flat, no depth test", GL_FLAT, 0, 0, .side = 2},
        {"constant, lequal", GL_SMOOTH, GL_LEQUAL, 0, .constant = true, .side = 2},
        {"two-sided", GL_SMOOTH, GL_LESS, 0, .lit = true, .side = 2},
        {"two-sided, flat", GL_FLAT, GL_LESS, 0, .lit = true, .side = 2},
        {"scissor", GL_SMOOTH, GL_LESS, 0, .scissor = true, .side = 2},
        {"offset", GL_SMOOTH, GL_LESS, 0, .offset = true, .side = 2},
        {"not equal, which is not fused", GL_SMOOTH, GL_NOTEQUAL, 0, .side = 2},
    };
    static struct result fast, general;
    (void)state;
    for (size_t i = 0; i < 2 * (sizeof settings / sizeof settings[0]); i++) {
        struct setting s = settings[i / 2];
        s.exact = i % 2;
        draw_by(&s, "", &fast);
        draw_by(&s, "general", &general);
        int drawn = 0;
        for (int k = 0; k < SIZE * SIZE; k++)
            drawn += fast.color[k] != 0;
        assert_true(drawn > SIZE * SIZE / 10);
        if (memcmp(fast.color, general.color, sizeof fast.color) != 0 || memcmp(fast.depth, general.depth, sizeof fast.depth) != 0)
            fail_msg("%s%s: not the general path's bytes", s.name, s.exact ? ", exact" : "");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_as_the_general_path)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
