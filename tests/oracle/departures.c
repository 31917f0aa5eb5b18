/*
 * The named departures of lighting (docs/departures.md): for each category of scenes the truth and what is
 * drawn at the worst vertex. FixedGL is within the bound of compatible mode. With LD_PRELOAD=libOSMesa.so.8
 * the test shows that OSMesa is off by more than a byte's step; tests/api/departures_on_osmesa.sh runs it
 * there.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "oracle/measure.h"

enum { SCENES = 16 };

static const struct departure {
    const char *name, *category;
} departures[] = {
        {"back-color-material", "color material"},
        {"cone-edges", "exactly on the edge of a cone of 0"},
        {"cone-edges", "exactly on the edge of a cone of 45"},
        {"cone-edges", "exactly on the edge of a cone of 90"},
        {"cone-edges", "spot cutoff 0"},
        {"cone-edges", "spot direction 0, cutoff 90"},
        {"homogeneous-vertices", "vertex w not 1"},
        {"lights-out-of-range", "light at the vertex"},
        {"lights-out-of-range", "distance 0"},
        {"lights-out-of-range", "distance 1e-30"},
        {"lights-out-of-range", "distance 3e19"},
        {"lights-out-of-range", "light w 1e-30"},
        {"lights-out-of-range", "vertex w negative"},
        {"lights-out-of-range", "directional light of length 1e-30"},
        {"lights-out-of-range", "directional light of length 1e30"},
        {"lights-out-of-range", "GL_NORMALIZE, normals of 1e-30"},
        {"lights-out-of-range", "GL_NORMALIZE, normals of 1e30"},
        {"lights-out-of-range", "GL_RESCALE_NORMAL, scale 1e10"},
        {"lights-out-of-range", "modelview scaled to 1e-9"},
        {"lights-out-of-range", "modelview singular, one axis 0"},
        {"lights-out-of-range", "world 1e6 away"},
        {"lights-out-of-range", "viewer at 1e-25"},
        {"lights-out-of-range", "vertex at the eye"},
        {"not-a-number", "diffuse light not finite"},
        {"not-a-number", "attenuation not finite"},
        {"shininess-0", "shininess 0"},
};

enum { DEPARTURES = sizeof departures / sizeof departures[0] };

static int find_category(const char *name)
{
    for (int i = 0; i < oracle_category_count; i++)
        if (strcmp(oracle_categories[i].name, name) == 0)
            return i;
    fail_msg("no category %s", name);
    return 0;
}

static void test_departure(void **state)
{
    const struct departure *departure = *state;
    const int category = find_category(departure->category);
    const struct oracle_measurement m = oracle_measurement_of(category, 20260101, SCENES);
    const struct oracle_error error = oracle_measure(&m, oracle_draw);
    printf("%-20s %-36s truth %.9g, drawn %.9g; wrong bytes: %ld of %ld\n", departure->name,
           departure->category, error.worst.truth, error.worst.drawn, error.wrong_bytes, error.components);
    if (strcmp((const char *)glGetString(GL_VENDOR), "FixedGL") == 0)
        assert_true(error.max <= oracle_categories[category].bounds.compatible);
    else
        assert_true(error.max > 1.0 / 255);
}

int main(void)
{
    static struct departure table[DEPARTURES];
    static struct CMUnitTest tests[DEPARTURES];
    unsetenv("FIXEDGL_ACCURACY");
    if (!oracle_open())
        return 1;
    for (int i = 0; i < DEPARTURES; i++) {
        table[i] = departures[i];
        tests[i] = (struct CMUnitTest){table[i].category, test_departure, NULL, NULL, &table[i]};
    }
    const int result = _cmocka_run_group_tests("departures", tests, DEPARTURES, NULL, NULL);
    oracle_close();
    return result;
}
