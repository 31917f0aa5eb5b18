/* Where vertex arrays lie, as queries show it (GL 1.5, 2.8 "Vertex Arrays"). Drawing from them is pictures'
 * business. */
#include "api/gl_test.h"

static const char memory[256];

static ptrdiff_t offset_of(GLenum pointer_name)
{
    void *p = NULL;
    glGetPointerv(pointer_name, &p);
    return (const char *)p - memory;
}

static void pointers(void **state)
{
    (void)state;
    glVertexPointer(2, GL_SHORT, 20, memory + 1);
    glNormalPointer(GL_BYTE, 21, memory + 2);
    glColorPointer(3, GL_UNSIGNED_BYTE, 22, memory + 3);
    glIndexPointer(GL_UNSIGNED_BYTE, 23, memory + 4);
    glTexCoordPointer(1, GL_DOUBLE, 24, memory + 5);
    glEdgeFlagPointer(25, memory + 6);
    assert_int_equal(glGetError(), GL_NO_ERROR);

    EXPECT_INTS(GL_VERTEX_ARRAY_SIZE, 2);
    EXPECT_INTS(GL_VERTEX_ARRAY_TYPE, GL_SHORT);
    EXPECT_INTS(GL_VERTEX_ARRAY_STRIDE, 20);
    EXPECT_INTS(GL_NORMAL_ARRAY_TYPE, GL_BYTE);
    EXPECT_INTS(GL_NORMAL_ARRAY_STRIDE, 21);
    EXPECT_INTS(GL_COLOR_ARRAY_SIZE, 3);
    EXPECT_INTS(GL_COLOR_ARRAY_TYPE, GL_UNSIGNED_BYTE);
    EXPECT_INTS(GL_COLOR_ARRAY_STRIDE, 22);
    EXPECT_INTS(GL_INDEX_ARRAY_TYPE, GL_UNSIGNED_BYTE);
    EXPECT_INTS(GL_INDEX_ARRAY_STRIDE, 23);
    EXPECT_INTS(GL_TEXTURE_COORD_ARRAY_SIZE, 1);
    EXPECT_INTS(GL_TEXTURE_COORD_ARRAY_TYPE, GL_DOUBLE);
    EXPECT_INTS(GL_TEXTURE_COORD_ARRAY_STRIDE, 24);
    EXPECT_INTS(GL_EDGE_FLAG_ARRAY_STRIDE, 25);
    const GLenum names[] = {GL_VERTEX_ARRAY_POINTER,        GL_NORMAL_ARRAY_POINTER,
                            GL_COLOR_ARRAY_POINTER,         GL_INDEX_ARRAY_POINTER,
                            GL_TEXTURE_COORD_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_POINTER};
    for (int i = 0; i < 6; i++)
        assert_int_equal(offset_of(names[i]), i + 1);
}

static const GLenum arrays[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY,        GL_COLOR_ARRAY,
                                GL_INDEX_ARRAY,  GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY};

static void enables(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        glEnableClientState(arrays[i]);
        for (int k = 0; k < 6; k++)
            assert_int_equal(glIsEnabled(arrays[k]), i == k);
        glDisableClientState(arrays[i]);
        assert_false(glIsEnabled(arrays[i]));
        glEnable(arrays[i]); /* GL_EXT_vertex_array */
        assert_true(glIsEnabled(arrays[i]));
        glDisable(arrays[i]);
        assert_false(glIsEnabled(arrays[i]));
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Table 2.5: which types each array accepts. */
static void types(void **state)
{
    (void)state;
    const GLenum all[] = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT,
                          GL_INT,  GL_UNSIGNED_INT,  GL_FLOAT, GL_DOUBLE};
    const char *const accepted[] = {"..s.i.fd", "b.s.i.fd", "bBsSiIfd", ".Bs.i.fd", "..s.i.fd"};
    for (int t = 0; t < 8; t++) {
        for (int a = 0; a < 5; a++) {
            switch (a) {
            case 0: glVertexPointer(3, all[t], 0, memory); break;
            case 1: glNormalPointer(all[t], 0, memory); break;
            case 2: glColorPointer(4, all[t], 0, memory); break;
            case 3: glIndexPointer(all[t], 0, memory); break;
            default: glTexCoordPointer(2, all[t], 0, memory); break;
            }
            assert_int_equal(glGetError(), accepted[a][t] == '.' ? GL_INVALID_ENUM : GL_NO_ERROR);
        }
    }
}

/* Table 2.6, as text: components and byte offsets of texture coordinates, colour, normal and vertex; whole
 * stride. */
static const struct layout {
    GLenum format;
    int texcoord, color, normal, vertex;
    GLenum color_type;
    int color_at, normal_at, vertex_at, stride;
} layouts[] = {
        {GL_V2F, 0, 0, 0, 2, 0, 0, 0, 0, 8},
        {GL_V3F, 0, 0, 0, 3, 0, 0, 0, 0, 12},
        {GL_C4UB_V2F, 0, 4, 0, 2, GL_UNSIGNED_BYTE, 0, 0, 4, 12},
        {GL_C4UB_V3F, 0, 4, 0, 3, GL_UNSIGNED_BYTE, 0, 0, 4, 16},
        {GL_C3F_V3F, 0, 3, 0, 3, GL_FLOAT, 0, 0, 12, 24},
        {GL_N3F_V3F, 0, 0, 3, 3, 0, 0, 0, 12, 24},
        {GL_C4F_N3F_V3F, 0, 4, 3, 3, GL_FLOAT, 0, 16, 28, 40},
        {GL_T2F_V3F, 2, 0, 0, 3, 0, 0, 0, 8, 20},
        {GL_T4F_V4F, 4, 0, 0, 4, 0, 0, 0, 16, 32},
        {GL_T2F_C4UB_V3F, 2, 4, 0, 3, GL_UNSIGNED_BYTE, 8, 0, 12, 24},
        {GL_T2F_C3F_V3F, 2, 3, 0, 3, GL_FLOAT, 8, 0, 20, 32},
        {GL_T2F_N3F_V3F, 2, 0, 3, 3, 0, 0, 8, 20, 32},
        {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3, GL_FLOAT, 8, 24, 36, 48},
        {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4, GL_FLOAT, 16, 32, 44, 60},
};

static void counted_pointers(void **state)
{
    (void)state;
    glVertexPointerEXT(2, GL_SHORT, 20, 5, memory + 1);
    glTexCoordPointerEXT(1, GL_DOUBLE, 24, 6, memory + 5);
    glEdgeFlagPointerEXT(25, 7, (const GLboolean *)memory + 6);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    EXPECT_INTS(GL_VERTEX_ARRAY_SIZE, 2);
    EXPECT_INTS(GL_VERTEX_ARRAY_STRIDE, 20);
    assert_int_equal(offset_of(GL_VERTEX_ARRAY_POINTER_EXT), 1);
    assert_int_equal(offset_of(GL_TEXTURE_COORD_ARRAY_POINTER_EXT), 5);
    assert_int_equal(offset_of(GL_EDGE_FLAG_ARRAY_POINTER_EXT), 6);
    if (on_fixedgl()) { /* OSMesa says 0 */
        EXPECT_INTS(GL_VERTEX_ARRAY_COUNT_EXT, 5);
        EXPECT_INTS(GL_TEXTURE_COORD_ARRAY_COUNT_EXT, 6);
        EXPECT_INTS(GL_EDGE_FLAG_ARRAY_COUNT_EXT, 7);
        EXPECT_ERROR(GL_INVALID_VALUE, glNormalPointerEXT(GL_FLOAT, 0, -1, memory));
    }
}

/* An array that is enabled but was never given: OSMesa reads address 0. */
static void not_given(void **state)
{
    (void)state;
    if (!on_fixedgl())
        return;
    glClear(GL_COLOR_BUFFER_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    EXPECT_NO_ERROR(glDrawArrays(GL_TRIANGLES, 0, 3));
    EXPECT_NO_ERROR(glArrayElement(2));
    EXPECT_VALUES(GL_CURRENT_COLOR, 0, 0, 0, 0);
}

static void interleaved(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
        const struct layout *l = &layouts[i];
        for (int a = 0; a < 6; a++)
            i % 2 ? glEnableClientState(arrays[a]) : glDisableClientState(arrays[a]);
        const GLsizei stride = i % 3 ? 0 : 100;
        EXPECT_NO_ERROR(glInterleavedArrays(l->format, stride, memory));
        const int whole = stride ? stride : l->stride;

        EXPECT_INTS(GL_EDGE_FLAG_ARRAY, 0);
        EXPECT_INTS(GL_INDEX_ARRAY, 0);
        EXPECT_INTS(GL_VERTEX_ARRAY, 1);
        EXPECT_INTS(GL_VERTEX_ARRAY_SIZE, l->vertex);
        EXPECT_INTS(GL_VERTEX_ARRAY_STRIDE, whole);
        assert_int_equal(offset_of(GL_VERTEX_ARRAY_POINTER), l->vertex_at);
        EXPECT_INTS(GL_NORMAL_ARRAY, l->normal != 0);
        if (l->normal)
            assert_int_equal(offset_of(GL_NORMAL_ARRAY_POINTER), l->normal_at);
        EXPECT_INTS(GL_COLOR_ARRAY, l->color != 0);
        if (l->color) {
            EXPECT_INTS(GL_COLOR_ARRAY_SIZE, l->color);
            EXPECT_INTS(GL_COLOR_ARRAY_TYPE, (GLint)l->color_type);
            EXPECT_INTS(GL_COLOR_ARRAY_STRIDE, whole);
            assert_int_equal(offset_of(GL_COLOR_ARRAY_POINTER), l->color_at);
        }
        EXPECT_INTS(GL_TEXTURE_COORD_ARRAY, l->texcoord != 0);
        if (l->texcoord) {
            EXPECT_INTS(GL_TEXTURE_COORD_ARRAY_SIZE, l->texcoord);
            assert_int_equal(offset_of(GL_TEXTURE_COORD_ARRAY_POINTER), 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {GL_TEST(pointers), GL_TEST(enables), GL_TEST(types),
                                       GL_TEST(counted_pointers), GL_TEST(interleaved), GL_TEST(not_given)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
