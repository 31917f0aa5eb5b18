/* OSMesa contexts: making, making current, sharing, and the addresses of functions. */
#include "osmesa_test.h"

/* ---- contexts ---- */

static void test_attribs(void **state)
{
    (void)state;
    union buffer buffer;
    static const int good[] = {OSMESA_FORMAT,
                               OSMESA_BGRA,
                               OSMESA_DEPTH_BITS,
                               24,
                               OSMESA_STENCIL_BITS,
                               8,
                               OSMESA_ACCUM_BITS,
                               16,
                               OSMESA_PROFILE,
                               OSMESA_COMPAT_PROFILE,
                               0};
    static const int unknown[] = {0x7777, 1, 0};
    static const int negative[] = {OSMESA_DEPTH_BITS, -1, 0};
    OSMesaContext context = OSMesaCreateContextAttribs(good, NULL);
    assert_non_null(context);
    assert_true(OSMesaMakeCurrent(context, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    GLint value;
    OSMesaGetIntegerv(OSMESA_FORMAT, &value);
    assert_int_equal(value, OSMESA_BGRA);
    glGetIntegerv(GL_ACCUM_RED_BITS, &value);
    assert_int_equal(value, 16);
    OSMesaDestroyContext(context);
    assert_null(OSMesaCreateContextAttribs(unknown, NULL));
    assert_null(OSMesaCreateContextAttribs(negative, NULL));
}

static void test_make_current(void **state)
{
    (void)state;
    union buffer buffer;
    assert_null(OSMesaGetCurrentContext());
    OSMesaContext a = open_rgba(&buffer), b = create(OSMESA_RGBA);
    assert_ptr_equal(OSMesaGetCurrentContext(), a);
    assert_false(OSMesaMakeCurrent(b, NULL, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_false(OSMesaMakeCurrent(NULL, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_false(OSMesaMakeCurrent(b, &buffer, GL_UNSIGNED_BYTE, 0, HEIGHT));
    assert_false(OSMesaMakeCurrent(b, &buffer, GL_UNSIGNED_BYTE, WIDTH, -1));
    if (!on_mesa) /* which has a maximum and does not look at it */
        assert_false(OSMesaMakeCurrent(b, &buffer, GL_UNSIGNED_BYTE, 16385, HEIGHT));
    assert_false(OSMesaMakeCurrent(b, &buffer, GL_BYTE, WIDTH, HEIGHT));
    assert_ptr_equal(OSMesaGetCurrentContext(), a);
    assert_true(OSMesaMakeCurrent(b, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_ptr_equal(OSMesaGetCurrentContext(), b);
    assert_true(OSMesaMakeCurrent(NULL, NULL, 0, 0, 0));
    assert_null(OSMesaGetCurrentContext());
    OSMesaDestroyContext(a);
    OSMesaDestroyContext(b);
}

static void test_destroy_current(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaDestroyContext(open_rgba(&buffer));
    assert_null(OSMesaGetCurrentContext());
    OSMesaDestroyContext(NULL);
}

/* Each context has state and picture of its own. */
static void test_two_contexts(void **state)
{
    (void)state;
    union buffer first, second;
    OSMesaContext a = open_rgba(&first);
    glEnable(GL_LIGHTING);
    clear_to(1, 0, 0, 1);
    glFinish();
    OSMesaContext b = open_rgba(&second);
    assert_false(glIsEnabled(GL_LIGHTING));
    clear_to(0, 1, 0, 1);
    glFinish();
    assert_int_equal(first.byte[0], 255);
    assert_int_equal(second.byte[1], 255);
    assert_true(OSMesaMakeCurrent(a, &first, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_true(glIsEnabled(GL_LIGHTING));
    OSMesaDestroyContext(b);
    OSMesaDestroyContext(a);
}

static void test_shared_lists(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext a = open_rgba(&buffer);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    clear_to(0, 1, 0, 1);
    glEndList();
    OSMesaContext sharing = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, a);
    OSMesaContext alone = create(OSMESA_RGBA);
    assert_true(OSMesaMakeCurrent(alone, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_false(glIsList(list));
    OSMesaDestroyContext(alone);
    OSMesaDestroyContext(a);
    assert_true(OSMesaMakeCurrent(sharing, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_true(glIsList(list));
    glCallList(list);
    glFinish();
    assert_int_equal(buffer.byte[0], 0);
    assert_int_equal(buffer.byte[1], 255);
    OSMesaDestroyContext(sharing);
}

/* ---- addresses ---- */

static void check_address(const char *name)
{
    if (OSMesaGetProcAddress(name) == NULL)
        fail_msg("no address of %s", name);
}

static void test_proc_address(void **state)
{
    (void)state;
#define CMD_LIST(Name, ...) check_address("gl" #Name);
#define CMD_LISTV(Name, ...) check_address("gl" #Name);
#define CMD_LIST0(Name) check_address("gl" #Name);
#define CMD_NOW(Name, ...) check_address("gl" #Name);
#define CMD_NOW0(Name) check_address("gl" #Name);
#define CMD_GET(type, Name, ...) check_address("gl" #Name);
#define CMD_GET0(type, Name) check_address("gl" #Name);
#define CMD_HAND(Name) check_address("gl" #Name);
#define CMD_ALIAS(Name, ...) check_address("gl" #Name);
#define CMD_ALIAS0(Name, ...) check_address("gl" #Name);
#define CMD_ALIAS_GET(type, Name, ...) check_address("gl" #Name);
#include "api/command.def"
    check_address("OSMesaMakeCurrent");
    check_address("OSMesaGetProcAddress");
    if (on_mesa) /* which invents an address for any name, and has others than it exports */
        return;
    assert_null(OSMesaGetProcAddress("glNoSuchFunction"));
    assert_true(OSMesaGetProcAddress("glClear") == (OSMESAproc)glClear);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_attribs),         cmocka_unit_test(test_make_current),
            cmocka_unit_test(test_destroy_current), cmocka_unit_test(test_two_contexts),
            cmocka_unit_test(test_shared_lists),    cmocka_unit_test(test_proc_address),
    };
    return cmocka_run_group_tests(tests, find_out_whose, NULL);
}
