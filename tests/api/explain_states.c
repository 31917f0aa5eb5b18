/* fixedglExplain: whatever the state, the explained value is the byte in the framebuffer, and what was armed does not change the picture. */
#include "api/explain_test.h"

/* Pixels from one that is explained to the next; with a sanitizer each takes ten times as long. */
#if defined(__SANITIZE_ADDRESS__)
enum { STEP = 7 };
#else
enum { STEP = 3 };
#endif

static void smooth(void)
{
    triangles();
}
static void flat(void)
{
    glShadeModel(GL_FLAT);
    triangles();
}
static void directional(void)
{
    light(0);
    triangles();
}
static void local(void)
{
    light(1);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2f);
    triangles();
}
static void spot(void)
{
    light(1);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
    glEnable(GL_NORMALIZE);
    triangles();
}
static void separate(void)
{
    light(0);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    triangles();
}
static void colored(void)
{
    light(0);
    glEnable(GL_COLOR_MATERIAL);
    triangles();
}

static void two_sided(void)
{
    const float blue[4] = {0, 0, 1, 1};
    light(0);
    glFrontFace(GL_CW);
    glMaterialfv(GL_BACK, GL_EMISSION, blue);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    triangles();
}

static void phong(void)
{
    glShadeModel(GL_PHONG_WIN);
    glEnable(GL_COLOR_MATERIAL);
    local();
}
static void phong_two_sided(void)
{
    glShadeModel(GL_PHONG_WIN);
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, 1);
    two_sided();
}
static void textured(void)
{
    const unsigned char texels[2][2][4] = {{{255, 90, 20, 255}, {40, 200, 90, 128}}, {{10, 60, 250, 255}, {180, 180, 180, 0}}};
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    separate();
}
static void textured_phong(void)
{
    glShadeModel(GL_PHONG_WIN);
    textured();
}

static void fog(void)
{
    glEnable(GL_FOG);
    glFogf(GL_FOG_DENSITY, 0.3f);
    triangles();
}
static void blend(void)
{
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    triangles();
}
static void blend_over(void)
{
    glDisable(GL_DEPTH_TEST);
    blend();
} /* each draw changes the pixel again */
static void alpha(void)
{
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    triangles();
}
static void logic(void)
{
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    triangles();
}
static void masked(void)
{
    glColorMask(1, 0, 1, 0);
    triangles();
}
static void scissored(void)
{
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 20, 30, 15);
    triangles();
}
static void no_depth(void)
{
    glDisable(GL_DEPTH_TEST);
    triangles();
}
static void user_plane(void)
{
    const GLdouble p[4] = {1, 0.3, 0, 0.1};
    glClipPlane(GL_CLIP_PLANE0, p);
    glEnable(GL_CLIP_PLANE0);
    triangles();
}
static void as_lines(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(4);
    triangles();
}
static void as_points(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(15);
    triangles();
}
static void offset(void)
{
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 3);
    triangles();
    triangles();
}

static void stencil(void)
{
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_GREATER, 2, 255);
    glStencilOp(GL_KEEP, GL_INCR, GL_INCR);
    triangles();
    triangles();
}

static void stippled(void)
{
    GLubyte pattern[128];
    for (int i = 0; i < 128; i++)
        pattern[i] = i / 8 & 1 ? 0xf0 : 0x3c;
    glPolygonStipple(pattern);
    glEnable(GL_POLYGON_STIPPLE);
    triangles();
}

static void star(GLenum mode)
{
    glBegin(mode);
    for (int i = 0; i < 9; i++) {
        glColor4f((float)i / 8, 1 - (float)i / 8, 0.5f, 0.7f);
        glVertex3f(2.2f * cosf((float)i * 2.8f), 2.2f * sinf((float)i * 2.8f), -2 - 0.2f * (float)i);
    }
    glEnd();
}

static void lines(void)
{
    glLineWidth(3);
    star(GL_LINES);
    star(GL_LINE_LOOP);
}
static void smooth_lines(void)
{
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glLineWidth(5);
    star(GL_LINE_STRIP);
}
static void stippled_lines(void)
{
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x5a5a);
    glLineWidth(3);
    star(GL_LINE_STRIP);
}
static void points(void)
{
    glPointSize(9);
    star(GL_POINTS);
}
static void smooth_points(void)
{
    glEnable(GL_POINT_SMOOTH);
    glPointSize(12);
    star(GL_POINTS);
}
static void polygons(void)
{
    star(GL_POLYGON);
    star(GL_TRIANGLE_FAN);
    star(GL_TRIANGLE_STRIP);
    star(GL_QUADS);
    star(GL_QUAD_STRIP);
}
static void stippled_edges(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x3a5c);
    glLineWidth(3);
    star(GL_QUADS);
    star(GL_POLYGON);
    triangles();
}

static void edges(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_LINE_SMOOTH);
    star(GL_POLYGON);
    star(GL_QUADS);
}

static void elements(void)
{
    static const float position[5][3] = {{-2, -2, -3}, {2, -2, -2.5f}, {2, 2, -3}, {-2, 2, -6}, {0, 0, 1}};
    static const GLubyte color[5][4] = {
            {255, 0, 0, 255}, {0, 255, 0, 9}, {0, 0, 255, 80}, {9, 99, 200, 255}, {255, 255, 255, 255}};
    static const GLushort index[] = {4, 2, 3, 2, 1, 4, 0, 3, 4, 1, 2, 0};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, position);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
    glDrawElements(GL_TRIANGLES, 12, GL_UNSIGNED_SHORT, index);
    glDrawArrays(GL_QUADS, 0, 4);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
}

static void list(void)
{
    glNewList(7, GL_COMPILE);
    triangles();
    star(GL_QUADS);
    glEndList();
    glCallList(7);
}

static void cleared_in_between(void)
{
    triangles();
    glScissor(0, 0, 64, 32);
    glEnable(GL_SCISSOR_TEST);
    glColorMask(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    star(GL_POLYGON);
}

static void (*const scene[])(void) = {smooth,         flat,       directional,
                                      local,          spot,       separate,
                                      colored,        two_sided,  fog,
                                      phong,          textured,   textured_phong,
                                      phong_two_sided,
                                      blend,          blend_over, alpha,
                                      logic,          masked,     scissored,
                                      no_depth,       user_plane, as_lines,
                                      as_points,      offset,     stencil,
                                      stippled,       lines,      smooth_lines,
                                      stippled_lines, points,     smooth_points,
                                      polygons,       edges,      stippled_edges,
                                      elements,       list,       cleared_in_between};

static void draw(int i)
{
    begin();
    scene[i]();
    glPopAttrib();
    glFinish();
}

/* The last event that changed the pixel left it as it is. */
static void expect_last_event(const char *text, const unsigned char *p)
{
    const char *last = NULL, *at = find(text, "events"), *end = find(text, "made_by");
    while ((at = find(at, "outcome")) && (!end || at < end))
        if (strncmp(at, "\"failed", 7) != 0)
            last = at;
    if (last)
        EXPECT(last, "after", 0, p[0], p[1], p[2], p[3]);
}

static void explained_is_drawn(void **state)
{
    static unsigned char alone[sizeof picture];
    int pixels = 0, made = 0;
    (void)state;
    for (int i = 0; i < (int)(sizeof scene / sizeof *scene); i++) {
        draw(i);
        memcpy(alone, picture, sizeof alone);
        for (int y = i % STEP; y < TEST_SIZE; y += STEP)
            for (int x = (i + y) % STEP; x < TEST_SIZE; x += STEP) {
                const unsigned char *p = picture + 4 * (y * TEST_SIZE + x);
                fixedglExplainPixel(x, y);
                draw(i);
                const char *text = explain();
                if (memcmp(alone, picture, sizeof alone) != 0 || !strstr(text, "\"agrees\":true"))
                    fail_msg("scene %d, pixel %d,%d: drawn otherwise when explained", i, x, y);
                EXPECT(text, "color", 0, p[0], p[1], p[2], p[3]);
                expect_last_event(text, p);
                pixels++;
                made += find(text, "made_by") != NULL;
            }
        fixedglExplainPixel(-1, -1);
    }
    print_message("%d pixels, %d made by a primitive\n", pixels, made);
    assert_true(made > pixels / 4);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Which part of glBegin .. glEnd made a pixel: the second triangle, line, quad, ... of each mode. */
static void parts_are_numbered(void **state)
{
    static const struct {
        GLenum mode;
        int vertices, x, y; /* a pixel of the last part */
        int number;
    } rows[] = {{GL_POINTS, 2, 48, 16, 1},        {GL_LINES, 4, 32, 48, 1},         {GL_LINE_STRIP, 3, 32, 32, 1},
                {GL_LINE_LOOP, 3, 16, 32, 2},     {GL_TRIANGLES, 6, 40, 40, 1},     {GL_TRIANGLE_STRIP, 4, 40, 40, 1},
                {GL_TRIANGLE_FAN, 4, 36, 40, 1}};
    static const float triangle_strip[4][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}};
    static const float triangles[6][2] = {{-0.9f, -0.9f}, {-0.5f, -0.9f}, {-0.9f, -0.5f}, {0, 0}, {0.9f, 0}, {0, 0.9f}};
    static const float fan[4][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const float(*corner)[2] = rows[i].mode == GL_TRIANGLES ? triangles : rows[i].mode == GL_TRIANGLE_FAN ? fan : triangle_strip;
        fixedglExplainPixel(rows[i].x, rows[i].y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glPointSize(3);
        glLineWidth(3);
        glBegin(rows[i].mode);
        for (int v = 0; v < rows[i].vertices; v++)
            glVertex2fv(corner[v]);
        glEnd();
        glFinish();
        const char *made = find(explain(), "made_by");
        assert_non_null(made);
        EXPECT(made, "number", 0, rows[i].number);
    }
}

static void explained_is_drawn_in_exact_mode(void **state)
{
    fixedglAccuracy(FIXEDGL_EXACT);
    explained_is_drawn(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(parts_are_numbered),
            GL_TEST(explained_is_drawn),
            GL_TEST(explained_is_drawn_in_exact_mode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
