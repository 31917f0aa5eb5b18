/* The parser of FIXEDGL_EVENTS and FIXEDGL_SIZE. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>
#include <GL/glut.h>
#include "glut/script.h"

static char error[256];

static void parse(const char *text, struct script *script, int count)
{
    if (!fgl_script_parse(text, script, error, sizeof error))
        fail_msg("\"%s\": %s", text, error);
    assert_int_equal(script->count, count);
}

/* One statement, its value and its numbers. */
static void expect(const char *text, enum statement_kind kind, int value, int n0, int n1, int n2, int n3)
{
    struct script script;
    const int numbers[STATEMENT_NUMBERS] = {n0, n1, n2, n3};
    parse(text, &script, 1);
    assert_int_equal(script.statements[0].kind, kind);
    assert_int_equal(script.statements[0].value, value);
    assert_memory_equal(script.statements[0].number, numbers, sizeof numbers);
    fgl_script_free(&script);
}

static void test_every_statement(void **state)
{
    (void)state;
    expect("key a", STATEMENT_KEY, 'a', 0, 0, 0, 0);
    expect("key escape", STATEMENT_KEY, 27, 0, 0, 0, 0);
    expect("key space", STATEMENT_KEY, ' ', 0, 0, 0, 0);
    expect("key enter", STATEMENT_KEY, 13, 0, 0, 0, 0);
    expect("key 0x1b", STATEMENT_KEY, 27, 0, 0, 0, 0);
    expect("key 0", STATEMENT_KEY, '0', 0, 0, 0, 0);
    expect("special left", STATEMENT_SPECIAL, GLUT_KEY_LEFT, 0, 0, 0, 0);
    expect("special pagedown", STATEMENT_SPECIAL, GLUT_KEY_PAGE_DOWN, 0, 0, 0, 0);
    expect("special f12", STATEMENT_SPECIAL, GLUT_KEY_F12, 0, 0, 0, 0);
    expect("press left 10 20", STATEMENT_PRESS, GLUT_LEFT_BUTTON, 10, 20, 0, 0);
    expect("release right -1 2", STATEMENT_RELEASE, GLUT_RIGHT_BUTTON, -1, 2, 0, 0);
    expect("click middle 3 4", STATEMENT_CLICK, GLUT_MIDDLE_BUTTON, 3, 4, 1, 0);
    expect("click left 3 4 7", STATEMENT_CLICK, GLUT_LEFT_BUTTON, 3, 4, 7, 0);
    expect("drag left 1 2 3 4", STATEMENT_DRAG, GLUT_LEFT_BUTTON, 1, 2, 3, 4);
    expect("move 5 6", STATEMENT_MOVE, 0, 5, 6, 0, 0);
    expect("wheel up 5 6", STATEMENT_WHEEL, 1, 5, 6, 0, 0);
    expect("wheel down 5 6", STATEMENT_WHEEL, -1, 5, 6, 0, 0);
    expect("modifiers shift alt", STATEMENT_MODIFIERS, GLUT_ACTIVE_SHIFT | GLUT_ACTIVE_ALT, 0, 0, 0, 0);
    expect("modifiers none", STATEMENT_MODIFIERS, 0, 0, 0, 0, 0);
    expect("resize 640 480", STATEMENT_RESIZE, 0, 640, 480, 0, 0);
    expect("menu 2", STATEMENT_MENU, 1, 2, 0, 0, 0);
    expect("menu 2 1 3", STATEMENT_MENU, 3, 2, 1, 3, 0);
    expect("wait 0", STATEMENT_WAIT, 0, 0, 0, 0, 0);
    expect("time 100", STATEMENT_TIME, 0, 100, 0, 0, 0);
    expect("window 2", STATEMENT_WINDOW, 0, 2, 0, 0, 0);
    expect("quit", STATEMENT_QUIT, 0, 0, 0, 0, 0);
}

static void test_list(void **state)
{
    struct script script;
    (void)state;
    parse(" key a ;; wait 2;\tcapture out/b.png ;depth d.depth;\n", &script, 4);
    assert_int_equal(script.statements[1].kind, STATEMENT_WAIT);
    assert_int_equal(script.statements[2].kind, STATEMENT_CAPTURE);
    assert_string_equal(script.statements[2].text, "out/b.png");
    assert_string_equal(script.statements[3].text, "d.depth");
    fgl_script_free(&script);
    parse("", &script, 0);
    fgl_script_free(&script);
}

static void test_faults(void **state)
{
    static const char *const faults[] = {
            "jump",
            "key",
            "key ab",
            "key 0x100",
            "key 0x0",
            "key a b",
            "special f13",
            "press left 1",
            "press 1 2",
            "press left 1 2 3",
            "click left 1",
            "click left 1 2 0",
            "click left 1 2 x",
            "drag left 1 2 3",
            "move 1",
            "move 1 2x",
            "wheel left 1 2",
            "modifiers",
            "modifiers hyper",
            "resize 0 5",
            "resize 5 99999",
            "menu",
            "menu 0",
            "menu 1 2 3 4 5",
            "wait",
            "wait -1",
            "time x",
            "time 99999999999",
            "capture",
            "depth a b",
            "quit now",
            "key a; wait",
            "KEY a",
    };
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        struct script script;
        if (fgl_script_parse(faults[i], &script, error, sizeof error))
            fail_msg("\"%s\" was accepted", faults[i]);
        assert_null(script.statements);
        assert_null(strchr(error, '\n'));
    }
    struct script script;
    assert_false(fgl_script_parse("key a; jump 3 ;quit", &script, error, sizeof error));
    assert_string_equal(error, "statement 2, \" jump 3 \", is not a statement");
}

static void test_size(void **state)
{
    int width, height;
    (void)state;
    assert_true(fgl_script_parse_size("640x480", &width, &height));
    assert_int_equal(width, 640);
    assert_int_equal(height, 480);
    assert_true(fgl_script_parse_size("1x16384", &width, &height));
    static const char *const faults[] = {"",        "640",  "x",    "640x",     "640x480x3",
                                         "0x5",     "5x0",  "-5x5", "5x-5",     "16385x5",
                                         "5x16385", " 5x5", "5X5",  "999999x5", "5x5 "};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++)
        if (fgl_script_parse_size(faults[i], &width, &height))
            fail_msg("\"%s\" was accepted", faults[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_every_statement),
            cmocka_unit_test(test_list),
            cmocka_unit_test(test_faults),
            cmocka_unit_test(test_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
