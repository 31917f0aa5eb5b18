/* fixedglExplain in colour index mode: the index explained is the one in the buffer, and where nothing else is done to it the last
 * stage's. */
#include "api/gl_test.h"

enum { STEP = 3 };

static unsigned char indexes[TEST_SIZE][TEST_SIZE];

static int make_index_context(void **state)
{
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_COLOR_INDEX, 24, 8, 0, NULL);
    *state = context;
    return context && OSMesaMakeCurrent(context, indexes, GL_UNSIGNED_BYTE, TEST_SIZE, TEST_SIZE) ? 0 : -1;
}

static void plain(void)
{
}

static void flat(void)
{
    glShadeModel(GL_FLAT);
}

static void foggy(void)
{
    glEnable(GL_FOG);
    glFogf(GL_FOG_DENSITY, 0.8f);
    glFogf(GL_FOG_INDEX, 40);
}

static void lit(void)
{
    static const GLfloat white[4] = {1, 1, 1, 1};
    static const GLint material[3] = {10, 100, 200};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_SPECULAR, white);
    glMaterialiv(GL_FRONT_AND_BACK, GL_COLOR_INDEXES, material);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 5);
    glNormal3f(0.1f, 0.2f, 0.97f);
}

static void smooth_lines(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_LINE_SMOOTH);
    glLineWidth(5);
}

static void combined(void)
{
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
}

static void masked(void)
{
    glIndexMask(0x5a);
}

static void (*const setting[])(void) = {plain, flat, foggy, lit, smooth_lines, combined, masked};
enum { PLAIN_SETTINGS = 5 }; /* the rest combine with what was there */

static void draw(void)
{
    glClearIndex(7);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        const float z = i == 1 ? 0.5f : -0.5f * (float)i;
        glIndexi(20 + 60 * i);
        glVertex3f(-0.9f, -0.8f, z);
        glIndexi(250);
        glVertex3f(0.9f, -0.5f + 0.2f * (float)i, -z);
        glIndexf(30.5f);
        glVertex3f(0.1f * (float)i, 0.9f, z);
    }
    glEnd();
    glFinish();
}

static double first_number(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    assert_non_null(at);
    return strtod(at + strlen(key), NULL);
}

static void check_pixel(int x, int y, bool plainly, int *drawn)
{
    fixedglExplainPixel(x, y);
    draw();
    const char *text = fixedglExplain(FIXEDGL_JSON, -1);
    assert_non_null(text);
    assert_non_null(strstr(text, "\"agrees\":true"));
    assert_int_equal((int)first_number(text, "\"color\":["), indexes[y][x]);
    const char *made = strstr(text, "\"made_by\":");
    if (made == NULL) {
        assert_non_null(strstr(text, "\"events\":[{\"outcome\":\"cleared\""));
        return;
    }
    ++*drawn;
    const char *fragment = strstr(made, "\"fragment\":");
    if (plainly)
        assert_int_equal((int)first_number(fragment, "\"color\":["), indexes[y][x]);
    assert_non_null(strstr(fixedglExplain(FIXEDGL_TEXT, -1), "= the pixel"));
}

static void explained_indexes_are_drawn(void **state)
{
    static unsigned char unwatched[TEST_SIZE][TEST_SIZE];
    (void)state;
    for (size_t i = 0; i < sizeof setting / sizeof *setting; i++) {
        int drawn = 0;
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        setting[i]();
        fixedglExplainPixel(-1, 0);
        draw();
        memcpy(unwatched, indexes, sizeof unwatched);
        for (int y = (int)i % STEP; y < TEST_SIZE; y += STEP)
            for (int x = ((int)i + y) % STEP; x < TEST_SIZE; x += STEP)
                check_pixel(x, y, i < PLAIN_SETTINGS, &drawn);
        assert_memory_equal(unwatched, indexes, sizeof unwatched);
        assert_true(drawn > 50);
        glPopAttrib();
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void a_lit_index_by_hand(void **state)
{
    static const GLfloat towards[4] = {0, 0, 1, 0};
    (void)state;
    lit();
    glLightfv(GL_LIGHT0, GL_POSITION, towards);
    glLightfv(GL_LIGHT0, GL_SPECULAR, (const GLfloat[4]){0, 0, 0, 1});
    glNormal3f(0, 0, 1);
    fixedglExplainPixel(32, 20);
    draw();
    const char *text = fixedglExplain(FIXEDGL_TEXT, 0);
    assert_non_null(strstr(text, "diffuse sum d                1.0000"));
    assert_non_null(strstr(text, "= vertex index             100.0000")); /* 2.14.5 with d = 1, s = 0 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test_setup_teardown(explained_indexes_are_drawn, make_index_context, destroy_context),
            cmocka_unit_test_setup_teardown(a_lit_index_by_hand, make_index_context, destroy_context),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
