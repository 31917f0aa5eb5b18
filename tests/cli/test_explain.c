/* What `fixedgl explain` says is what was drawn: every picture of the list, at many pixels. The explained
 * value must be the byte of the captured picture; the vertices' colours, weighted, must make the interpolated
 * colour; that, taken through the stages, must round to the byte. The pixels are chosen by a seed:
 * FIXEDGL_SEED=n, printed when a test fails. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "cli/child.h"
#include "cli/departures.h"
#include "cli/image.h"
#include "cli/pictures.h"

/* Pixels of each picture, each a run of its program. With a sanitizer each takes ten times as long: one of every third. */
#if defined(__SANITIZE_ADDRESS__)
enum { PIXELS = 1, EVERY = 3 };
#else
enum { PIXELS = 4, EVERY = 1 };
#endif

static char folder[] = "/tmp/fixedgl-test-XXXXXX";
static unsigned seed = 1;
static int explained, by_primitive, lit; /* pixels */

static unsigned next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed >> 8;
}

/* ---- as much of JSON as the test needs ---- */

/* The text after "key": from `text` on, or NULL. */
static const char *find(const char *text, const char *key)
{
    char quoted[64];
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    const char *at = text ? strstr(text, quoted) : NULL;
    return at ? at + strlen(quoted) : NULL;
}

static bool numbers_at(const char *at, double *v, int n)
{
    for (int i = 0; at && i < n; i++) {
        char *end;
        at += *at == '[' || *at == ',';
        v[i] = strtod(at, &end);
        if (end == at)
            return false;
        at = end;
    }
    return at;
}

static bool numbers(const char *text, const char *key, double *v, int n)
{
    return numbers_at(find(text, key), v, n);
}

static char *read_text(const char *path)
{
    static char text[1 << 20];
    FILE *file = fopen(path, "r");
    if (!file)
        return NULL;
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

/* ---- runs ---- */

static bool run(const struct picture *picture, const char *pam, const char *json, int x, int y)
{
    const char *build = getenv("BUILD");
    char *program = fgl_format("%s/examples/%s", build ? build : "build", picture->program);
    char *set[] = {fgl_format("FIXEDGL_CAPTURE=%s", pam),
                   fgl_format("FIXEDGL_SIZE=%dx%d", picture->width, picture->height),
                   fgl_format("FIXEDGL_EVENTS=%s", picture->events),
                   json ? fgl_format("FIXEDGL_EXPLAIN=%d,%d", x, y) : NULL,
                   json ? fgl_format("FIXEDGL_EXPLAIN_OUT=%s", json) : NULL,
                   NULL};
    char *argv[] = {program, NULL};
    char *log = fgl_format("%s/log", folder);
    const struct child child = {argv, (const char *const *)set, log, log, 60};
    struct problem problem;
    const bool good = fgl_child_run(&child, &problem);
    if (!good)
        print_error("%s: %s\n", picture->name, problem.text);
    for (int i = 0; set[i]; i++)
        free(set[i]);
    remove(log);
    free(log);
    free(program);
    return good;
}

static void read_image(const char *pam, struct image *image)
{
    struct problem problem;
    if (!fgl_image_read_pam(pam, image, &problem))
        fail_msg("%s", problem.text);
}

/* ---- what must hold ---- */

/* The interpolated colour is the weighted sum of the vertices'. Weights and colours come from different runs
 * of the interpolation, which rounds. */
static void check_weights(const char *made, const char *fragment)
{
    double sum[4] = {0}, total = 0, interpolated[4], weight, color[4];
    for (const char *v = find(made, "vertices"); (v = find(v, "weight")) && v < fragment;) {
        assert_true(numbers_at(v, &weight, 1) && numbers(v, "color", color, 4));
        total += weight;
        for (int c = 0; c < 4; c++)
            sum[c] += weight * color[c];
    }
    assert_true(numbers(fragment, "interpolated", interpolated, 4));
    if (fabs(total - 1) >= 1e-3)
        fail_msg("weights sum to %g: %s", total, made);
    for (int c = 0; c < 4; c++)
        if (fabs(sum[c] - interpolated[c]) >= 2e-3)
            fail_msg("weighted colors sum to %g, not %g: %s", sum[c], interpolated[c], made);
}

/* The colour after the last stage rounds to the byte, where nothing is blended. */
static void check_rounding(const char *fragment, const double byte[4])
{
    double color[4];
    assert_true(numbers(fragment, "color", color, 4));
    for (int c = 0; c < 4; c++)
        if (!(byte[c] == nearbyint((color[c] < 0   ? 0
                                    : color[c] > 1 ? 1
                                                   : color[c]) *
                                   255) ||
              fabs(fabs(color[c] * 255 - floor(color[c] * 255)) - 0.5) <
                      1e-4)) /* the tie is decided in floats */
            fail_msg("component %d is drawn as %g: %s", c, byte[c], fragment);
}

/* The sum of every vertex is its start and what each light adds. */
static void check_terms(const char *made, const char *fragment)
{
    for (const char *v = find(made, "vertices"); (v = find(v, "start")) && v < fragment;) {
        double sum[3], total[3];
        const char *end = find(v, "sum");
        assert_true(numbers_at(v, total, 3) && numbers(v, "sum", sum, 3));
        const bool separate = strncmp(strchr(end, ']') + 1, ",\"specular_sum\"", 15) == 0;
        for (const char *l = v; (l = find(l, "VP")) && l < end;) {
            double term[3];
            const char *const name[] = {"ambient", "diffuse", "specular"};
            for (int k = 0; k < (separate ? 2 : 3); k++) {
                assert_true(numbers(l, name[k], term, 3));
                for (int c = 0; c < 3; c++)
                    total[c] += term[c];
            }
        }
        for (int c = 0; c < 3; c++)
            assert_true(fabs(total[c] - sum[c]) <= 1e-6 * (1 + fabs(sum[c])));
        lit++;
    }
}

static void check_pixel(const struct picture *picture, const struct image *expected, int x, int y)
{
    char *pam = fgl_format("%s/b.pam", folder), *json = fgl_format("%s/b.json", folder);
    struct image image = {0};
    double value[4];
    assert_true(run(picture, pam, json, x, y));
    const char *text = read_text(json);
    assert_non_null(text);
    read_image(pam, &image);
    assert_int_equal(image.width, expected->width);
    assert_memory_equal(image.rgba, expected->rgba,
                        4 * (size_t)image.width * (size_t)image.height); /* watching changes nothing */
    assert_true(numbers(text, "color", value, 4));
    const unsigned char *byte =
            image.rgba + 4 * ((size_t)(image.height - 1 - y) * (size_t)image.width + (size_t)x);
    for (int c = 0; c < 4; c++)
        if (value[c] != byte[c])
            fail_msg("%s, pixel %d,%d: explained %g, drawn %d", picture->name, x, y, value[c], byte[c]);
    assert_non_null(strstr(text, "\"agrees\":true"));
    explained++;
    const char *made = find(text, "made_by"), *fragment = made ? find(made, "fragment") : NULL;
    if (made) {
        by_primitive++;
        check_terms(made, fragment);
        if (strstr(made, "\"shading\":\"smooth\""))
            check_weights(made, fragment);
        if (strstr(made, "\"blended\":false"))
            check_rounding(fragment, value);
    }
    fgl_image_free(&image);
    remove(pam);
    remove(json);
    free(pam);
    free(json);
}

/* A pixel that is not the corner's colour, most of the time. */
static void choose(const struct image *image, int *x, int *y)
{
    for (int tries = 0; tries < 40; tries++) {
        *x = (int)(next_random() % (unsigned)image->width);
        *y = (int)(next_random() % (unsigned)image->height);
        if (memcmp(image->rgba + 4 * ((size_t)(image->height - 1 - *y) * (size_t)image->width + (size_t)*x),
                   image->rgba, 4) != 0)
            return;
    }
}

/* Programs that draw their scene sixty times over are slow. */
static int pixels_of(const struct picture *picture, int number)
{
    if (number % EVERY != 0)
        return 0;
    const bool slow = strcmp(picture->program, "softshadow") == 0 || strcmp(picture->program, "dof") == 0;
    return slow ? 1 : PIXELS;
}

static void every_picture(void **state)
{
    (void)state;
    struct picture_list list;
    struct departure_list departures;
    struct problem problem;
    struct image image = {0};
    if (!fgl_pictures_read("examples/pictures.txt", &list, &problem) ||
        !fgl_departures_read("tests/departures.txt", &list, &departures, &problem))
        fail_msg("%s", problem.text);
    char *pam = fgl_format("%s/a.pam", folder);
    for (int i = 0; i < list.count; i++) {
        if (fgl_departures_undrawn(&departures, list.items[i].name) != NULL)
            continue; /* in colour index mode, which is not explained */
        assert_true(run(&list.items[i], pam, NULL, 0, 0));
        read_image(pam, &image);
        for (int k = 0, x, y; k < pixels_of(&list.items[i], i); k++) {
            choose(&image, &x, &y);
            check_pixel(&list.items[i], &image, x, y);
        }
        fgl_image_free(&image);
    }
    remove(pam);
    free(pam);
    fgl_departures_free(&departures);
    fgl_pictures_free(&list);
    print_message("%d pixels explained, %d made by a primitive, %d lit vertices\n", explained, by_primitive,
                  lit);
    assert_true(by_primitive > explained / 2 && lit > explained / 2);
}

int main(void)
{
    const char *text = getenv("FIXEDGL_SEED");
    const unsigned start = seed = text ? (unsigned)strtoul(text, NULL, 10) : 1;
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_picture)};
    if (!mkdtemp(folder))
        return 1;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    if (failed)
        print_error("FIXEDGL_SEED=%u\n", start);
    rmdir(folder);
    return failed;
}
