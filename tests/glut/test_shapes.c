/* The shapes against what freeglut 3.4.0 draws. The glDraw* functions here take the place of the library's:
 * they hash every primitive's mode and count and every vertex's floats (position, normal, texture
 * coordinates). The expected values were recorded the same way from freeglut on x86-64. */
#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <GL/freeglut.h>

static struct {
    const float *position, *normal, *texcoord;
    bool texture;
    int draws, vertices;
    uint64_t hash; /* FNV-1a */
    double worst_normal, wanted_length;
} record;

static void hash_word(uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        record.hash = (record.hash ^ (word >> shift & 255)) * UINT64_C(0x100000001b3);
}

static void hash_floats(const float *values, int count)
{
    for (int i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        hash_word(bits);
    }
}

static void record_draw(GLenum mode, GLsizei count)
{
    record.draws++;
    record.vertices += count;
    hash_word(mode);
    hash_word((uint32_t)count);
}

static void record_vertex(unsigned int i)
{
    const float *n = record.normal + 3 * i;
    double length =
            sqrt((double)n[0] * (double)n[0] + (double)n[1] * (double)n[1] + (double)n[2] * (double)n[2]);
    double error = fabs(length - record.wanted_length);
    if (!(error <= record.worst_normal)) /* also if it is not a number */
        record.worst_normal = error;
    hash_floats(record.position + 3 * i, 3);
    hash_floats(n, 3);
    if (record.texture)
        hash_floats(record.texcoord + 2 * i, 2);
}

void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    record_draw(mode, count);
    for (int i = 0; i < count; i++)
        record_vertex((unsigned int)(first + i));
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const GLvoid *indices)
{
    assert_int_equal(type, GL_UNSIGNED_INT);
    record_draw(mode, count);
    for (int i = 0; i < count; i++)
        record_vertex(((const GLuint *)indices)[i]);
}

static void take_pointer(const float **to, GLint size, GLint wanted, GLenum type, GLsizei stride,
                         const void *from)
{
    assert_int_equal(size, wanted);
    assert_int_equal(type, GL_FLOAT);
    assert_int_equal(stride, 0);
    *to = from;
}

void glVertexPointer(GLint size, GLenum type, GLsizei stride, const GLvoid *pointer)
{
    take_pointer(&record.position, size, 3, type, stride, pointer);
}

void glNormalPointer(GLenum type, GLsizei stride, const GLvoid *pointer)
{
    take_pointer(&record.normal, 3, 3, type, stride, pointer);
}

void glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const GLvoid *pointer)
{
    take_pointer(&record.texcoord, size, 2, type, stride, pointer);
}

void glEnableClientState(GLenum array)
{
    record.texture = record.texture || array == GL_TEXTURE_COORD_ARRAY;
}
void glDisableClientState(GLenum array)
{
    record.texture = record.texture && array != GL_TEXTURE_COORD_ARRAY;
}

static void start(double normal_length)
{
    memset(&record, 0, sizeof record);
    record.hash = UINT64_C(0xcbf29ce484222325);
    record.wanted_length = normal_length;
}

static void check(const char *name, int draws, int vertices, uint64_t hash, double normal_tolerance)
{
    if (record.draws != draws || record.vertices != vertices || record.hash != hash)
        fail_msg("%s: %d draws, %d vertices, 0x%016llx", name, record.draws, record.vertices,
                 (unsigned long long)record.hash);
    if (record.worst_normal > normal_tolerance)
        fail_msg("%s: a normal is off its length by %g", name, record.worst_normal);
    assert_false(record.texture);
}

#define CHECK(call, length, draws, vertices, hash)                                                           \
    do {                                                                                                     \
        start(length);                                                                                       \
        call;                                                                                                \
        check(#call, draws, vertices, UINT64_C(hash), 3e-7);                                                 \
    } while (0)

static void test_round_shapes(void **state)
{
    (void)state;
    CHECK(glutSolidSphere(1, 16, 16), 1, 16, 544, 0xbc32c7ec4c81ced5);
    CHECK(glutWireSphere(0.75, 20, 16), 1, 35, 640, 0x1f88bc47ee2bad4f);
    CHECK(glutSolidSphere(2.5, 13, 29), 1, 29, 812, 0xcb02d8d37b5ed980);
    CHECK(glutSolidCone(1, 1, 8, 8), 1, 9, 162, 0x42c424d8f5c5fd87);
    CHECK(glutWireCone(0.75, 2, 31, 17), 1, 18, 589, 0x99b1cb8d23731d33);
    CHECK(glutSolidTorus(1, 0.275, 10, 7), 1, 10, 160, 0x569bb6e4eb4a7941);
    CHECK(glutWireTorus(0.75, 2, 16, 16), 1, 32, 512, 0xfcb4a46be589c491);
}

static void test_polyhedra(void **state)
{
    (void)state;
    const double icosahedron_normal = 0.957454138327394; /* freeglut's are not unit */
    CHECK(glutSolidCube(1), 1, 1, 36, 0x30c92f59e22ab225);
    CHECK(glutWireCube(1.3), 1, 6, 24, 0xf1eac0a759b8f025);
    CHECK(glutSolidTetrahedron(), 1, 1, 12, 0x68e83a1830da8bc1);
    CHECK(glutWireTetrahedron(), 1, 4, 12, 0xcd8bd1d97214ef89);
    CHECK(glutSolidOctahedron(), 1, 1, 24, 0x469578aa72a184c9);
    CHECK(glutWireOctahedron(), 1, 8, 24, 0x7692ec66db3aad25);
    CHECK(glutSolidDodecahedron(), 1, 1, 108, 0x0e44b038354cb04d);
    CHECK(glutWireDodecahedron(), 1, 12, 60, 0x3c419fe5aede2925);
    CHECK(glutSolidIcosahedron(), icosahedron_normal, 1, 60, 0x0a81aac77c9501e5);
    CHECK(glutWireIcosahedron(), icosahedron_normal, 20, 60, 0x4789a2ca4da7e8fd);
}

static void test_freeglut_shapes(void **state)
{
    (void)state;
    double offset[3] = {0.1, -0.3, 0.2};
    CHECK(glutSolidCylinder(0.75, 2, 13, 5), 1, 7, 196, 0x592367c1911f2170);
    CHECK(glutWireCylinder(2.5, 0.3, 8, 8), 1, 10, 88, 0x6959b32394ac671a);
    CHECK(glutSolidSierpinskiSponge(3, offset, 0.7), 1, 1, 768, 0x96c6512ec4c46e4e);
    CHECK(glutWireSierpinskiSponge(2, offset, 1.5), 1, 64, 192, 0xdb336f36eceffce7);
    CHECK(glutSolidSierpinskiSponge(0, offset, 1), 1, 1, 12, 0xbbfb8e9cc92f2e79);
    CHECK(glutSolidSierpinskiSponge(-1, offset, 1), 1, 0, 0, 0xcbf29ce484222325);
    /* 8 of its 12 normals are sqrt(1/2) long */
    start(0.70710678);
    glutSolidRhombicDodecahedron();
    check("solid rhombic dodecahedron", 1, 72, UINT64_C(0xbc949f30a108ffb9), 0.2929);
    start(0.70710678);
    glutWireRhombicDodecahedron();
    check("wire rhombic dodecahedron", 12, 48, UINT64_C(0x26ce54d095cbdea5), 0.2929);
}

/* The first size decides the normals' last bits, as in freeglut; the recording began with 1. */
static void test_teapot(void **state)
{
    (void)state;
    CHECK(glutSolidTeapot(1), 1, 1, 9408, 0x9c4e4b9ee84273f8);
    CHECK(glutWireTeapot(1), 1, 640, 6400, 0xb705934faa5ba061);
    CHECK(glutSolidTeapot(100), 1, 1, 9408, 0x25a6582f44739d5f);
    CHECK(glutSolidTeapot(1), 1, 1, 9408, 0x9c4e4b9ee84273f8);
}

/* Counts that make no surface draw nothing; so do sizes beyond memory. */
static void test_degenerate(void **state)
{
    (void)state;
    start(1);
    glutSolidSphere(1, 0, 5);
    glutSolidSphere(1, 5, 1);
    glutWireSphere(1, -3, 4);
    glutSolidCone(1, 1, 0, 1);
    glutWireCone(1, 1, 5, 0);
    glutSolidTorus(1, 2, 1, 5);
    glutWireTorus(1, 2, 5, -1);
    glutSolidCylinder(1, 1, 0, 3);
    glutWireCylinder(1, 1, 3, 0);
    glutSolidSphere(1, 0x7fffffff, 0x7fffffff);
    glutSolidSierpinskiSponge(11, (double[3]){0}, 1);
    glutSolidTorus(1, 2, 0x40000000, 8);
    assert_int_equal(record.draws, 0);
}

/* More vertices than 16 bits can index: freeglut's indices wrap around, ours do not. */
static void test_many_vertices(void **state)
{
    (void)state;
    start(1);
    glutSolidSphere(1, 400, 200);
    assert_int_equal(record.draws, 200);
    assert_int_equal(record.vertices, 200 * 802);
    assert_true(record.worst_normal < 3e-7);
}

int main(void)
{
    char name[] = "test_shapes", *arguments[] = {name, NULL};
    int count = 1;
    setenv("FIXEDGL_FRAMES", "1", 1); /* headless */
    glutInit(&count, arguments);
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_round_shapes),  cmocka_unit_test(test_polyhedra),
            cmocka_unit_test(test_teapot),        cmocka_unit_test(test_degenerate),
            cmocka_unit_test(test_many_vertices), cmocka_unit_test(test_freeglut_shapes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
