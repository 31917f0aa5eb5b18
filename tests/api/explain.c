/* fixedglExplain: the explained value is the byte in the framebuffer whatever the state, what was armed does
 * not change the picture, and the terms are those of the equation (GL 1.5, 2.14.1), worked out by hand. */
#include "api/gl_test.h"

#include <math.h>

/* Pixels from one that is explained to the next; with a sanitizer each takes ten times as long. */
#if defined(__SANITIZE_ADDRESS__)
enum { STEP = 7 };
#else
enum { STEP = 3 };
#endif

/* ---- as much of JSON as the test needs ---- */

static const char *find(const char *text, const char *key)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    const char *at = text ? strstr(text, quoted) : NULL;
    return at ? at + strlen(quoted) : NULL;
}

static void expect_numbers(const char *text, const char *key, const double *expected, int n, double tolerance)
{
    const char *at = find(text, key);
    if (!at)
        fail_msg("no \"%s\"", key);
    for (int i = 0; i < n; i++) {
        char *end;
        at += *at == '[' || *at == ',';
        const double v = strtod(at, &end);
        if (end == at || !(fabs(v - expected[i]) <= tolerance))
            fail_msg("%s[%d] is %.9g, expected %.9g", key, i, v, expected[i]);
        at = end;
    }
}
#define EXPECT(text, key, tolerance, ...)                                                                    \
    do {                                                                                                     \
        const double expected_[] = {__VA_ARGS__};                                                            \
        expect_numbers(text, key, expected_, sizeof expected_ / sizeof *expected_, tolerance);               \
    } while (0)

static const char *explain(void)
{
    const char *text = fixedglExplain(FIXEDGL_JSON, -1);
    assert_non_null(text);
    return text;
}

static void expect_text(const char *text, const char *part)
{
    if (!strstr(text, part))
        fail_msg("\"%s\" is not in: %s", part, text);
}

/* ---- every state: the value explained is the value drawn ---- */

static void begin(void)
{
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
}

/* Three triangles one behind the other, out of order; the corners reach behind the eye. */
static void triangles(void)
{
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        const float z = i == 0 ? -3 : i == 1 ? -5 : -2;
        glNormal3f(0.3f * (float)i, 0.2f, 0.9f);
        glColor4f(1, 0.3f * (float)i, 0.1f, 0.8f);
        glVertex3f(-2, -1, z);
        glNormal3f(-0.5f, 0.1f, 0.7f);
        glColor4f(0.2f, 1, 0.3f, 0.3f);
        glVertex3f(3, -2, z - 1);
        glColor4f(0.1f, 0.5f, 1, 0.6f);
        glVertex3f(0.3f, 3, z + 2.5f);
    }
    glEnd();
}

static void light(float w)
{
    const float position[4] = {2, 3, 1, w}, white[4] = {1, 1, 1, 1}, green[4] = {0.1f, 0.7f, 0.2f, 0.5f};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT3);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightfv(GL_LIGHT3, GL_DIFFUSE, green);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 9);
}

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

/* ---- terms ---- */

/* A quad over the whole picture, two units before the eye, normal towards it. */
static void wall(void)
{
    glBegin(GL_QUADS);
    glVertex3f(-2, -2, -2);
    glVertex3f(2, -2, -2);
    glVertex3f(2, 2, -2);
    glVertex3f(-2, 2, -2);
    glEnd();
}

static void one_spot_by_hand(void **state)
{
    const float position[4] = {0, 0, 0, 1}, ambient[4] = {0.1f, 0.2f, 0.3f, 1},
                diffuse[4] = {1, 0.5f, 0.25f, 1}, half[4] = {0.5f, 0.5f, 0.5f, 1};
    (void)state;
    fixedglExplainPixel(20, 9);
    begin();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT2);
    glLightfv(GL_LIGHT2, GL_POSITION, position);
    glLightfv(GL_LIGHT2, GL_AMBIENT, ambient);
    glLightfv(GL_LIGHT2, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT2, GL_SPECULAR, half);
    glLightf(GL_LIGHT2, GL_CONSTANT_ATTENUATION, 2);
    glLightf(GL_LIGHT2, GL_QUADRATIC_ATTENUATION, 0.5f);
    glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 80);
    glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 2);
    glMaterialfv(GL_FRONT, GL_AMBIENT, half);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, half);
    glMaterialfv(GL_FRONT, GL_SPECULAR, diffuse);
    glMaterialf(GL_FRONT, GL_SHININESS, 3);
    wall();
    glPopAttrib();
    const char *v = find(explain(), "vertices");
    const double r3 = 1 / sqrt(3), att = 1 / (2 + 0.5 * 12), spot_ = 1.0 / 3;
    const double h = (r3 + 1) / sqrt(2 * r3 * r3 + (r3 + 1) * (r3 + 1)), s = pow(h, 3) * att * spot_;
    const double sx = find(v, "object")[1] == '-' ? 1 : -1;
    EXPECT(v, "start", 1e-6, 0.1, 0.1, 0.1);
    EXPECT(v, "light", 0, 2);
    EXPECT(v, "VP", 1e-6, sx * r3);
    EXPECT(v, "distance", 1e-6, sqrt(12));
    EXPECT(v, "attenuation", 1e-6, att);
    EXPECT(v, "spot", 1e-6, spot_);
    EXPECT(v, "n_dot_VP", 1e-6, r3);
    EXPECT(v, "n_dot_h", 1e-6, h);
    EXPECT(v, "shininess", 0, 3);
    const char *l = find(v, "highlight");
    EXPECT(l, "ambient", 1e-6, 0.05 * att * spot_, 0.1 * att * spot_, 0.15 * att * spot_);
    EXPECT(l, "diffuse", 1e-6, 0.5 * r3 * att * spot_, 0.25 * r3 * att * spot_, 0.125 * r3 * att * spot_);
    EXPECT(l, "specular", 1e-5, 0.5 * s, 0.25 * s, 0.125 * s);
    EXPECT(l, "sum", 1e-5, 0.1 + (0.05 + 0.5 * r3) * att * spot_ + 0.5 * s);
}

/* The weights put the pixel's centre together from the vertices, whatever the perspective and where a vertex
 * lies behind the eye. */
static void weights_locate_the_pixel(void **state)
{
    (void)state;
    for (int x = 5; x < 60; x += 9) {
        fixedglExplainPixel(x, 30);
        begin();
        triangles();
        glPopAttrib();
        const char *v = find(explain(), "vertices");
        double clip[2] = {0, 0};
        while (v && (v = find(v, "weight"))) {
            const char *c = find(v, "clip");
            double component[4];
            char *end;
            const double weight = strtod(v, &end);
            for (int i = 0; i < 4; i++, c = end)
                component[i] = strtod(c + 1, &end);
            clip[0] += weight * component[0];
            clip[1] += weight * component[3];
        }
        assert_true(clip[1] > 0);
        assert_true(fabs((clip[0] / clip[1] * 0.5 + 0.5) * TEST_SIZE - (x + 0.5)) < 0.02);
    }
}

static void events_in_order(void **state)
{
    (void)state;
    fixedglExplainPixel(32, 32);
    begin();
    glColor3f(1, 0, 0);
    wall();
    glDepthFunc(GL_GREATER);
    wall();
    glDepthFunc(GL_ALWAYS);
    glColor3f(0, 1, 0);
    wall();
    glPopAttrib();
    const char *text = explain();
    const char *const outcome[] = {"cleared", "drawn", "failed depth test", "drawn"};
    const char *at = text;
    for (int i = 0; i < 4; i++) {
        at = find(at, "outcome");
        assert_non_null(at);
        if (strncmp(at + 1, outcome[i], strlen(outcome[i])) != 0)
            fail_msg("event %d is not \"%s\": %.30s", i, outcome[i], at);
    }
    assert_null(find(at, "outcome"));
    EXPECT(find(text, "made_by"), "draw", 0, 3);
    EXPECT(text, "color", 0, 0, 255, 0, 255);
}

static void changes_that_are_no_draws(void **state)
{
    (void)state;
    const GLubyte pixel[4] = {1, 2, 3, 4};
    GLfloat feedback[64];
    fixedglExplainPixel(4, 4);
    begin();
    glPopAttrib();
    expect_text(fixedglExplain(FIXEDGL_TEXT, -1), "glClearColor(0.1, 0.2, 0.3, 0.4)");
    assert_null(find(explain(), "made_by"));

    glFeedbackBuffer(64, GL_3D, feedback);
    glRenderMode(GL_FEEDBACK);
    wall();
    assert_true(glRenderMode(GL_RENDER) > 0);
    assert_null(find(find(explain(), "outcome"), "outcome")); /* only the clear */

    wall();
    assert_non_null(find(explain(), "made_by"));
    glWindowPos2i(4, 4);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    expect_text(explain(), "\"changed\"");
    EXPECT(explain(), "color", 0, 1, 2, 3, 4);
    assert_null(find(explain(), "made_by"));
    expect_text(fixedglExplain(FIXEDGL_TEXT, -1), "glDrawPixels");
}

/* ---- warnings ---- */

struct mistake {
    void (*make)(void);
    const char *said;
};

static void normal_quarter(void)
{
    light(0);
    glScalef(4, 4, 4);
    glTranslatef(0, 0, 1.5f);
    glNormal3f(0, 0, 1);
}
static void normal_backwards(void)
{
    light(1);
    glNormal3f(0, 0, -1);
}
static void lighting_off(void)
{
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
}
static void no_light(void)
{
    glEnable(GL_LIGHTING);
}
static void light_black(void)
{
    light(0);
    glEnable(GL_LIGHT5);
}
static void before_look_at(void)
{
    light(1);
    glTranslatef(0, 0, -0.5f);
}
static void too_bright(void)
{
    const float e[4] = {3, 0, 0, 1};
    light(0);
    glMaterialfv(GL_FRONT, GL_EMISSION, e);
}
static void material_black(void)
{
    const float e[4] = {0, 0, 0, 1};
    light(0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, e);
    glMaterialfv(GL_FRONT, GL_SPECULAR, e);
}
static void outside_cone(void)
{
    const float up[3] = {0, 1, 0};
    light(1);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, up);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 5);
}
static void no_shininess(void)
{
    light(0);
    glMaterialf(GL_FRONT, GL_SHININESS, 0);
}
static void far_light(void)
{
    light(1);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 500);
}
static void back_face(void)
{
    light(0);
    glFrontFace(GL_CW);
}
static void between(void)
{
    const float p[4] = {0, 0, -1, 1};
    light(1);
    glLightfv(GL_LIGHT0, GL_POSITION, p);
    glMaterialf(GL_FRONT, GL_SHININESS, 100);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
}
static void nothing_wrong(void)
{
    const float p[4] = {0, 0, 1, 0};
    light(0);
    glDisable(GL_LIGHT3);
    glLightfv(GL_LIGHT0, GL_POSITION, p);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);
    const float s[4] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, s);
}

static void what_a_teacher_says(void **state)
{
    static const struct mistake mistake[] = {
            {normal_quarter, "A normal of length 0.25 with GL_NORMALIZE off"},
            {normal_backwards, "The normals face away from the viewer"},
            {normal_backwards, "GL_LIGHT0 is behind the surface"},
            {lighting_off, "2 lights are enabled, but GL_LIGHTING is not"},
            {no_light, "no light is: only emission"},
            {light_black, "GL_LIGHT5 is enabled but black"},
            {before_look_at, "GL_LIGHT0's position was set before gluLookAt"},
            {too_bright, "Value clamped: the sum of red at vertex 0 is 3."},
            {material_black, "The material is black"},
            {outside_cone, "GL_LIGHT0: the polygon is outside of the spot's cone"},
            {no_shininess, "GL_SHININESS 0"},
            {far_light, "GL_LIGHT0 is attenuated to less than 1/255"},
            {back_face, "GL_LIGHT_MODEL_TWO_SIDE is not set"},
            {between, "The highlight falls between the vertices"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof mistake / sizeof *mistake; i++) {
        fixedglExplainPixel(31, 32);
        begin();
        glNormal3f(0, 0, 1);
        mistake[i].make();
        wall();
        glPopAttrib();
        expect_text(find(explain(), "warnings"), mistake[i].said);
        expect_text(fixedglExplain(FIXEDGL_TEXT, 1), mistake[i].said);
    }
    begin();
    nothing_wrong();
    wall();
    glPopAttrib();
    expect_text(explain(), "\"warnings\":[]");
}

/* ---- the interface ---- */

static void errors(void **state)
{
    (void)state;
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1))); /* not armed */
    EXPECT_ERROR(GL_INVALID_VALUE, fixedglExplainPixel(3, -1));
    EXPECT_NO_ERROR(fixedglExplainPixel(TEST_SIZE, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1))); /* outside */
    EXPECT_NO_ERROR(fixedglExplainPixel(0, 0));
    EXPECT_ERROR(GL_INVALID_ENUM, assert_null(fixedglExplain(17, -1)));
    EXPECT_ERROR(GL_INVALID_VALUE, assert_null(fixedglExplain(FIXEDGL_JSON, 3)));
    glBegin(GL_POINTS);
    fixedglExplainPixel(0, 0);
    assert_null(fixedglExplain(FIXEDGL_TEXT, -1));
    glEnd();
    EXPECT_ERROR(GL_INVALID_OPERATION, (void)0);
    EXPECT_NO_ERROR(assert_non_null(fixedglExplain(FIXEDGL_TEXT, 2)));
    EXPECT_NO_ERROR(fixedglExplainPixel(-1, 0));
    EXPECT_ERROR(GL_INVALID_OPERATION, assert_null(fixedglExplain(FIXEDGL_TEXT, -1)));
}

static void one_vertex_alone(void **state)
{
    (void)state;
    fixedglExplainPixel(30, 30);
    begin();
    triangles();
    glPopAttrib();
    const char *v = find(fixedglExplain(FIXEDGL_JSON, 1), "vertices");
    const char *first = find(v, "weight");
    assert_non_null(first);
    assert_null(find(first, "weight"));
    EXPECT(v, "number", 0, 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            GL_TEST(parts_are_numbered),
            GL_TEST(explained_is_drawn),
            GL_TEST(explained_is_drawn_in_exact_mode),
            GL_TEST(one_spot_by_hand),
            GL_TEST(weights_locate_the_pixel),
            GL_TEST(events_in_order),
            GL_TEST(changes_that_are_no_draws),
            GL_TEST(what_a_teacher_says),
            GL_TEST(errors),
            GL_TEST(one_vertex_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
