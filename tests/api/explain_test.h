/* What the tests of fixedglExplain share. */
#ifndef TESTS_API_EXPLAIN_TEST_H
#define TESTS_API_EXPLAIN_TEST_H

#include "api/gl_test.h"

#include <math.h>

/* ---- as much of JSON as the tests need ---- */

static inline const char *find(const char *text, const char *key)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    const char *at = text ? strstr(text, quoted) : NULL;
    return at ? at + strlen(quoted) : NULL;
}

static inline void expect_numbers(const char *text, const char *key, const double *expected, int n, double tolerance)
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

static inline const char *explain(void)
{
    const char *text = fixedglExplain(FIXEDGL_JSON, -1);
    assert_non_null(text);
    return text;
}

static inline void expect_text(const char *text, const char *part)
{
    if (!strstr(text, part))
        fail_msg("\"%s\" is not in: %s", part, text);
}

/* ---- what is drawn ---- */

static inline void begin(void)
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
static inline void triangles(void)
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

static inline void light(float w)
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

#endif
