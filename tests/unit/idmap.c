/* The map of object names: what was put is there, what was removed is not, and neither an enormous range nor names that come and go for
 * ever cost more than what is there. */
#include "base/idmap.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static int destroyed;

static void count_destroyed(void *value)
{
    (void)value;
    destroyed++;
}

static void put(struct idmap *map, uint32_t name)
{
    static int something;
    assert_true(fgl_idmap_put(map, name, &something));
}

static void names(void **state)
{
    struct idmap map = {0};
    (void)state;
    assert_null(fgl_idmap_get(&map, 1));
    for (uint32_t name = 1; name <= 1000; name++)
        put(&map, name * 7);
    for (uint32_t name = 1; name <= 7000; name++)
        assert_true((fgl_idmap_get(&map, name) != NULL) == (name % 7 == 0));
    assert_non_null(fgl_idmap_remove(&map, 70));
    assert_null(fgl_idmap_remove(&map, 70));
    assert_null(fgl_idmap_get(&map, 70));
    assert_int_equal(fgl_idmap_find_free(&map, 5), 7001);
    put(&map, UINT32_MAX);
    assert_int_equal(fgl_idmap_find_free(&map, 7), 64); /* where 70 was */
    destroyed = 0;
    fgl_idmap_free(&map, count_destroyed);
    assert_int_equal(destroyed, 1000);
}

static void ranges(void **state)
{
    struct idmap map = {0};
    (void)state;
    for (uint32_t name = 1; name <= 100; name++)
        put(&map, name);
    put(&map, UINT32_MAX);
    destroyed = 0;
    fgl_idmap_remove_range(&map, 11, 10, count_destroyed); /* name by name */
    assert_int_equal(destroyed, 10);
    assert_non_null(fgl_idmap_get(&map, 10));
    assert_null(fgl_idmap_get(&map, 11));
    assert_null(fgl_idmap_get(&map, 20));
    assert_non_null(fgl_idmap_get(&map, 21));
    fgl_idmap_remove_range(&map, 51, INT32_MAX, count_destroyed); /* all that is there looked at */
    assert_int_equal(destroyed, 60);
    assert_non_null(fgl_idmap_get(&map, 50));
    assert_null(fgl_idmap_get(&map, 51));
    assert_non_null(fgl_idmap_get(&map, UINT32_MAX));
    fgl_idmap_remove_range(&map, UINT32_MAX, 2, count_destroyed); /* names end */
    assert_int_equal(destroyed, 61);
    assert_non_null(fgl_idmap_get(&map, 1));
    fgl_idmap_free(&map, count_destroyed);
}

static void come_and_go(void **state)
{
    struct idmap map = {0};
    (void)state;
    for (uint32_t name = 1; name <= 100000; name++) {
        put(&map, name);
        if (name > 10)
            assert_non_null(fgl_idmap_remove(&map, name - 10));
    }
    assert_in_range(map.capacity, 16, 64);
    fgl_idmap_free(&map, count_destroyed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(names), cmocka_unit_test(ranges), cmocka_unit_test(come_and_go)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
