/* Matrices: their flags (sticky, found anew), and that every formula of the inverse gives an inverse. */
#include "unit.h"

#include "state/matrix.h"

#include <math.h>

static void flags_stick(void **state)
{
    struct matrix m;
    const float shear[16] = {1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    (void)state;

    fgl_matrix_set_identity(&m);
    assert_int_equal(fgl_matrix_class(&m), 0);
    fgl_matrix_rotate(&m, 30, 0, 0, 1);
    fgl_matrix_load_identity(&m);
    assert_int_equal(fgl_matrix_class(&m), MAT_ROTATION);
    fgl_matrix_scale(&m, 2, 2, 2);
    fgl_matrix_translate(&m, 1, 2, 3);
    assert_int_equal(fgl_matrix_class(&m), MAT_ROTATION | MAT_UNIFORM_SCALE | MAT_TRANSLATION);
    fgl_matrix_scale(&m, 1, 2, 1);
    assert_int_equal(fgl_matrix_class(&m),
                     MAT_ROTATION | MAT_UNIFORM_SCALE | MAT_TRANSLATION | MAT_GENERAL_SCALE);
    fgl_matrix_load(&m, shear); /* forgets them all */
    assert_int_equal(fgl_matrix_class(&m), MAT_GENERAL_3D | MAT_GENERAL_SCALE);
    fgl_matrix_frustum(&m, -1, 1, -1, 1, 1, 9);
    assert_true(fgl_matrix_class(&m) & MAT_PERSPECTIVE);
}

static void nothing_done_leaves_no_flag(void **state)
{
    struct matrix m;
    const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    (void)state;

    fgl_matrix_set_identity(&m);
    fgl_matrix_rotate(&m, 0, 1, 0, 0);
    fgl_matrix_rotate(&m, 45, 1e-5f, 0, 1e-5f); /* no direction */
    fgl_matrix_load(&m, identity);
    fgl_matrix_multiply(&m, identity);
    assert_int_equal(fgl_matrix_class(&m), 0);
}

static void classes_by_value(void **state)
{
    static const struct {
        float m[16];
        unsigned flags;
    } row[] = {
            {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 0, 0, 1}, MAT_TRANSLATION},
            {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}, MAT_UNIFORM_SCALE},
            {{2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}, MAT_GENERAL_SCALE},
            {{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, MAT_ROTATION},
            {{0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 2, 1}, MAT_ROTATION | MAT_TRANSLATION},
            {{0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 0, 1}, MAT_UNIFORM_SCALE | MAT_GENERAL_3D},
            {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0}, MAT_TRANSLATION | MAT_GENERAL},
    };
    struct matrix m;
    (void)state;

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        fgl_matrix_set_identity(&m);
        fgl_matrix_load(&m, row[i].m);
        assert_int_equal(fgl_matrix_class(&m), row[i].flags);
    }
}

static void random_matrix(struct matrix *m, int kind)
{
    float v[16];

    fgl_matrix_set_identity(m);
    if (kind & 1)
        fgl_matrix_rotate(m, between(-180, 180), between(-1, 1), between(-1, 1), between(0.1f, 1));
    if (kind & 2)
        fgl_matrix_translate(m, between(-3, 3), between(-3, 3), between(-3, 3));
    if (kind & 4)
        fgl_matrix_scale(m, 1.75f, 1.75f, 1.75f);
    if (kind & 8)
        fgl_matrix_scale(m, between(0.5f, 2), between(0.5f, 2), between(0.5f, 2));
    if (kind & 16) {
        for (int i = 0; i < 16; i++)
            v[i] = (i % 5 == 0 ? 2 : 0) + between(-0.5f, 0.5f);
        fgl_matrix_multiply(m, v);
    }
}

static void inverse_times_matrix_is_identity(void **state)
{
    struct matrix m;
    float product[16];
    (void)state;

    random_seed(0);
    for (int i = 0; i < 20000; i++) {
        random_matrix(&m, i % 32);
        fgl_matrix_product(product, m.m, fgl_matrix_inverse(&m));
        for (int e = 0; e < 16; e++)
            assert_true(fabsf(product[e] - (e % 5 == 0 ? 1.0f : 0.0f)) < 2e-5f);
    }
}

static void singular_matrices_have_the_identity(void **state)
{
    struct matrix m;
    (void)state;

    fgl_matrix_set_identity(&m);
    fgl_matrix_rotate(&m, 30, 1, 2, 3);
    fgl_matrix_scale(&m, 1, 0, 1);
    for (int e = 0; e < 16; e++)
        assert_true(fgl_matrix_inverse(&m)[e] == (e % 5 == 0 ? 1.0f : 0.0f));
    assert_true(fgl_matrix_class(&m) & MAT_SINGULAR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(flags_stick),
            cmocka_unit_test(nothing_done_leaves_no_flag),
            cmocka_unit_test(classes_by_value),
            cmocka_unit_test(inverse_times_matrix_is_identity),
            cmocka_unit_test(singular_matrices_have_the_identity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
