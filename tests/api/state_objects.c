/* The rows of the state tables that glGet does not return (GL 1.5, tables 6.7, 6.9, 6.10, 6.14 to 6.17, 6.25, 6.26): lights, materials,
 * clip planes, textures, pixel maps, evaluator maps. Their initial values, and the groups of glPushAttrib that bring them back. Written
 * from the specification. (OSMesa does not bring back materials that it has not noticed: docs/departures.md, popped-attributes.) */
#include "api/gl_test.h"

typedef void get_fn(GLenum target, GLenum pname, GLfloat *v);
typedef void set_fn(GLenum target, GLenum pname, const GLfloat *v);

struct row {
    const char *text;
    get_fn *get;
    set_fn *set;
    GLenum target, pname;
    GLbitfield group;
    int count;
    GLfloat initial[4], other[4];
};

static void get_plane(GLenum target, GLenum pname, GLfloat *v)
{
    GLdouble d[4];
    (void)pname;
    glGetClipPlane(target, d);
    for (int i = 0; i < 4; i++)
        v[i] = (GLfloat)d[i];
}

static void set_plane(GLenum target, GLenum pname, const GLfloat *v)
{
    const GLdouble d[4] = {(GLdouble)v[0], (GLdouble)v[1], (GLdouble)v[2], (GLdouble)v[3]};
    (void)pname;
    glClipPlane(target, d);
}

static void get_pixel_map(GLenum target, GLenum pname, GLfloat *v)
{
    (void)pname;
    glGetPixelMapfv(target, v);
}

static void set_pixel_map(GLenum target, GLenum pname, const GLfloat *v)
{
    (void)pname;
    glPixelMapfv(target, 1, v);
}

static void get_map(GLenum target, GLenum pname, GLfloat *v)
{
    glGetMapfv(target, pname, v);
}

static void set_domain(GLenum target, GLenum pname, const GLfloat *v)
{
    static const GLfloat points[4] = {0, 0, 0, 1};
    (void)pname;
    glMap1f(target, v[0], v[1], 4, 1, points);
}

#define LIGHT(i, pname, ...) {"light " #i " " #pname, glGetLightfv, glLightfv, GL_LIGHT0 + i, pname, GL_LIGHTING_BIT, __VA_ARGS__}
#define LIGHT_ROWS(i, r, g, b)                                                                                                     \
    LIGHT(i, GL_AMBIENT, 4, {0, 0, 0, 1}, {.25f, .5f, .75f, .5f}), LIGHT(i, GL_DIFFUSE, 4, {r, g, b, 1}, {.25f, .5f, .75f, .5f}),  \
            LIGHT(i, GL_SPECULAR, 4, {r, g, b, 1}, {.5f, .25f, .75f, .5f}), LIGHT(i, GL_POSITION, 4, {0, 0, 1, 0}, {1, 2, 3, 1}),  \
            LIGHT(i, GL_CONSTANT_ATTENUATION, 1, {1}, {2}), LIGHT(i, GL_LINEAR_ATTENUATION, 1, {0}, {2}),                          \
            LIGHT(i, GL_QUADRATIC_ATTENUATION, 1, {0}, {2}), LIGHT(i, GL_SPOT_DIRECTION, 3, {0, 0, -1}, {1, 0, 0}),                \
            LIGHT(i, GL_SPOT_EXPONENT, 1, {0}, {7}), LIGHT(i, GL_SPOT_CUTOFF, 1, {180}, {30})
#define MATERIAL(face, pname, ...) {#face " " #pname, glGetMaterialfv, glMaterialfv, face, pname, GL_LIGHTING_BIT, __VA_ARGS__}
#define MATERIAL_ROWS(face)                                                                                                        \
    MATERIAL(face, GL_AMBIENT, 4, {.2f, .2f, .2f, 1}, {.25f, .5f, .75f, .5f}),                                                     \
            MATERIAL(face, GL_DIFFUSE, 4, {.8f, .8f, .8f, 1}, {.25f, .5f, .75f, .5f}),                                             \
            MATERIAL(face, GL_SPECULAR, 4, {0, 0, 0, 1}, {.25f, .5f, .75f, .5f}),                                                  \
            MATERIAL(face, GL_EMISSION, 4, {0, 0, 0, 1}, {.25f, .5f, .75f, .5f}),                                                  \
            MATERIAL(face, GL_SHININESS, 1, {0}, {64}), MATERIAL(face, GL_COLOR_INDEXES, 3, {0, 1, 1}, {2, 3, 4})
#define PLANE(i) {"clip plane " #i, get_plane, set_plane, GL_CLIP_PLANE0 + i, 0, GL_TRANSFORM_BIT, 4, {0, 0, 0, 0}, {1, 2, 3, 4}}
#define ENV(pname, ...) {#pname, glGetTexEnvfv, glTexEnvfv, GL_TEXTURE_ENV, pname, GL_TEXTURE_BIT, __VA_ARGS__}
#define GEN(c, pname, ...) {#c " " #pname, glGetTexGenfv, glTexGenfv, c, pname, GL_TEXTURE_BIT, __VA_ARGS__}
#define GEN_ROWS(c, x, y)                                                                                                          \
    GEN(c, GL_TEXTURE_GEN_MODE, 1, {GL_EYE_LINEAR}, {GL_OBJECT_LINEAR}), GEN(c, GL_OBJECT_PLANE, 4, {x, y, 0, 0}, {1, 2, 3, 4}),   \
            GEN(c, GL_EYE_PLANE, 4, {x, y, 0, 0}, {1, 2, 3, 4})
#define TEX(target, pname, ...) {#target " " #pname, glGetTexParameterfv, glTexParameterfv, target, pname, GL_TEXTURE_BIT, __VA_ARGS__}
#define TEX_ROWS(target)                                                                                                           \
    TEX(target, GL_TEXTURE_BORDER_COLOR, 4, {0, 0, 0, 0}, {.25f, .5f, .75f, 1}),                                                   \
            TEX(target, GL_TEXTURE_MIN_FILTER, 1, {GL_NEAREST_MIPMAP_LINEAR}, {GL_NEAREST}),                                       \
            TEX(target, GL_TEXTURE_MAG_FILTER, 1, {GL_LINEAR}, {GL_NEAREST}),                                                      \
            TEX(target, GL_TEXTURE_WRAP_S, 1, {GL_REPEAT}, {GL_CLAMP}), TEX(target, GL_TEXTURE_WRAP_T, 1, {GL_REPEAT}, {GL_CLAMP}), \
            TEX(target, GL_TEXTURE_PRIORITY, 1, {1}, {.5f})
#define PIXEL_MAP(map, other) {#map, get_pixel_map, set_pixel_map, map, 0, 0, 1, {0}, {other}}

static const struct row rows[] = {
        PLANE(0), PLANE(1), PLANE(2), PLANE(3), PLANE(4), PLANE(5),
        LIGHT_ROWS(0, 1, 1, 1), LIGHT_ROWS(1, 0, 0, 0), LIGHT_ROWS(2, 0, 0, 0), LIGHT_ROWS(3, 0, 0, 0),
        LIGHT_ROWS(4, 0, 0, 0), LIGHT_ROWS(5, 0, 0, 0), LIGHT_ROWS(6, 0, 0, 0), LIGHT_ROWS(7, 0, 0, 0),
        MATERIAL_ROWS(GL_FRONT), MATERIAL_ROWS(GL_BACK),
        TEX_ROWS(GL_TEXTURE_1D), TEX_ROWS(GL_TEXTURE_2D),
        ENV(GL_TEXTURE_ENV_MODE, 1, {GL_MODULATE}, {GL_DECAL}), ENV(GL_TEXTURE_ENV_COLOR, 4, {0, 0, 0, 0}, {.25f, .5f, .75f, 1}),
        GEN_ROWS(GL_S, 1, 0), GEN_ROWS(GL_T, 0, 1), GEN_ROWS(GL_R, 0, 0), GEN_ROWS(GL_Q, 0, 0),
        PIXEL_MAP(GL_PIXEL_MAP_I_TO_I, 3), PIXEL_MAP(GL_PIXEL_MAP_S_TO_S, 3), PIXEL_MAP(GL_PIXEL_MAP_I_TO_R, .5f),
        PIXEL_MAP(GL_PIXEL_MAP_I_TO_G, .5f), PIXEL_MAP(GL_PIXEL_MAP_I_TO_B, .5f), PIXEL_MAP(GL_PIXEL_MAP_I_TO_A, .5f),
        PIXEL_MAP(GL_PIXEL_MAP_R_TO_R, .5f), PIXEL_MAP(GL_PIXEL_MAP_G_TO_G, .5f), PIXEL_MAP(GL_PIXEL_MAP_B_TO_B, .5f),
        PIXEL_MAP(GL_PIXEL_MAP_A_TO_A, .5f),
        {"domain of a map", get_map, set_domain, GL_MAP1_VERTEX_4, GL_DOMAIN, 0, 2, {0, 1}, {2, 3}},
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Fails unless the row has these values. */
static void expect(const struct row *row, const GLfloat *expected, const char *when)
{
    GLfloat got[16] = {0};
    row->get(row->target, row->pname, got);
    for (int i = 0; i < row->count; i++) {
        if (got[i] == expected[i])
            continue;
        print_error("%s, %s [%d]: %.9g, expected %.9g\n", when, row->text, i, (double)got[i], (double)expected[i]);
        fail();
    }
}

static void initial_values(void **state)
{
    (void)state;
    for (int i = 0; i < ROWS; i++)
        expect(&rows[i], rows[i].initial, "at first");
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void groups(void **state)
{
    (void)state;
    for (int bit = 0; bit < 20; bit++) {
        char when[40];
        snprintf(when, sizeof when, "after glPushAttrib(0x%x)", 1u << bit);
        glPushAttrib(1u << bit);
        for (int i = 0; i < ROWS; i++)
            rows[i].set(rows[i].target, rows[i].pname, rows[i].other);
        glPopAttrib();
        for (int i = 0; i < ROWS; i++)
            expect(&rows[i], rows[i].group & (1u << bit) ? rows[i].initial : rows[i].other, when);
        for (int i = 0; i < ROWS; i++)
            rows[i].set(rows[i].target, rows[i].pname, rows[i].initial);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(initial_values), GL_TEST(groups)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
