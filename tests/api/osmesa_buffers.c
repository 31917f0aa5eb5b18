/* The buffers of an OSMesa context: formats, types, pixel store, depth, and when the caller's one changes. */
#include "osmesa_test.h"

/* ---- formats ---- */

/* A pixel of the color (.2, .4, .6, .8) in the caller's memory. */
struct pixel {
    GLenum format, type;
    int size; /* bytes; 0: the two do not go together */
    unsigned char byte[4];
    uint16_t word[4];
};

static const struct pixel pixels[] = {
        {OSMESA_RGBA, GL_UNSIGNED_BYTE, 4, {0x33, 0x66, 0x99, 0xcc}, {0}},
        {OSMESA_BGRA, GL_UNSIGNED_BYTE, 4, {0x99, 0x66, 0x33, 0xcc}, {0}},
        {OSMESA_ARGB, GL_UNSIGNED_BYTE, 4, {0xcc, 0x33, 0x66, 0x99}, {0}},
        {OSMESA_RGB, GL_UNSIGNED_BYTE, 3, {0x33, 0x66, 0x99}, {0}},
        {OSMESA_BGR, GL_UNSIGNED_BYTE, 3, {0x99, 0x66, 0x33}, {0}},
        {OSMESA_RGB_565, GL_UNSIGNED_BYTE, 0, {0}, {0}},
        {OSMESA_RGBA, GL_UNSIGNED_SHORT, 8, {0}, {0x3333, 0x6666, 0x9999, 0xcccc}},
        {OSMESA_BGRA, GL_UNSIGNED_SHORT, 8, {0}, {0x3333, 0x6666, 0x9999, 0xcccc}},
        {OSMESA_ARGB, GL_UNSIGNED_SHORT, 8, {0}, {0x3333, 0x6666, 0x9999, 0xcccc}},
        {OSMESA_BGR, GL_UNSIGNED_SHORT, 0, {0}, {0}},
        {OSMESA_RGB_565, GL_UNSIGNED_SHORT, 0, {0}, {0}},
        {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, 2, {0}, {6 << 11 | 25 << 5 | 19}},
        {OSMESA_RGB, GL_UNSIGNED_SHORT_5_6_5, 0, {0}, {0}},
        {OSMESA_RGBA, GL_UNSIGNED_SHORT_5_6_5, 0, {0}, {0}},
        {OSMESA_RGBA, GL_FLOAT, 16, {0}, {0}},
        {OSMESA_BGRA, GL_FLOAT, 16, {0}, {0}},
        {OSMESA_ARGB, GL_FLOAT, 16, {0}, {0}},
        {OSMESA_BGR, GL_FLOAT, 0, {0}, {0}},
        {OSMESA_RGB_565, GL_FLOAT, 0, {0}, {0}},
        {OSMESA_RGBA, GL_INT, 0, {0}, {0}},
        {OSMESA_RGBA, GL_DOUBLE, 0, {0}, {0}},
};

static void check_pixel(const struct pixel *expected, const union buffer *buffer, int i)
{
    static const float color[4] = {.2f, .4f, .6f, .8f};
    if (expected->type == GL_UNSIGNED_BYTE)
        assert_memory_equal(buffer->byte + i * expected->size, expected->byte, expected->size);
    else if (expected->type == GL_FLOAT)
        assert_memory_equal(buffer->real + 4 * i, color, sizeof color);
    else
        assert_memory_equal(buffer->word + i * expected->size / 2, expected->word, expected->size);
}

static void check_format(const struct pixel *expected)
{
    union buffer buffer;
    memset(&buffer, 0x5a, sizeof buffer);
    OSMesaContext context = create(expected->format);
    const bool bound = OSMesaMakeCurrent(context, &buffer, expected->type, WIDTH, HEIGHT);
    const bool refused = on_mesa && expected->format == OSMESA_BGR;
    assert_int_equal(bound, expected->size > 0 && !refused);
    if (bound) {
        clear_to(.2f, .4f, .6f, .8f);
        glFinish();
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            check_pixel(expected, &buffer, i);
        for (size_t i = (size_t)expected->size * WIDTH * HEIGHT; i < sizeof buffer; i++)
            assert_int_equal(buffer.byte[i], 0x5a);
    }
    OSMesaDestroyContext(context);
}

static void test_formats(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof pixels / sizeof pixels[0]; i++)
        check_format(&pixels[i]);
}

static void test_unknown_formats(void **state)
{
    (void)state;
    assert_null(OSMesaCreateContext(0, NULL));
    assert_null(OSMesaCreateContext(GL_LUMINANCE, NULL));
}

/* ---- pixel store and queries ---- */

static void test_defaults(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext context = open_rgba(&buffer);
    static const GLint expected[][2] = {
            {OSMESA_WIDTH, WIDTH},           {OSMESA_HEIGHT, HEIGHT},    {OSMESA_FORMAT, OSMESA_RGBA},
            {OSMESA_TYPE, GL_UNSIGNED_BYTE}, {OSMESA_ROW_LENGTH, 0},     {OSMESA_Y_UP, 1},
            {OSMESA_MAX_WIDTH, 16384},       {OSMESA_MAX_HEIGHT, 16384},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        GLint value = -1;
        OSMesaGetIntegerv(expected[i][0], &value);
        assert_int_equal(value, expected[i][1]);
    }
    GLint viewport[4], scissor[4];
    const GLint whole[4] = {0, 0, WIDTH, HEIGHT};
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    assert_memory_equal(viewport, whole, sizeof whole);
    assert_memory_equal(scissor, whole, sizeof whole);
    OSMesaDestroyContext(context);
}

/* Lowest row red, the others blue. */
static void draw_rows(void)
{
    clear_to(0, 0, 1, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, WIDTH, 1);
    clear_to(1, 0, 0, 1);
    glDisable(GL_SCISSOR_TEST);
    glFinish();
}

static void test_y_up(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext context = open_rgba(&buffer);
    const int last = 4 * WIDTH * (HEIGHT - 1);
    draw_rows();
    assert_int_equal(buffer.byte[0], 255);
    assert_int_equal(buffer.byte[last], 0);
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    draw_rows();
    assert_int_equal(buffer.byte[0], 0);
    assert_int_equal(buffer.byte[last], 255);
    GLint value;
    OSMesaGetIntegerv(OSMESA_Y_UP, &value);
    assert_int_equal(value, 0);
    unsigned char read[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read); /* the GL's rows remain */
    assert_int_equal(read[0], 255);
    OSMesaDestroyContext(context);
}

static void test_row_length(void **state)
{
    (void)state;
    enum { LENGTH = WIDTH + 2 };
    unsigned char rows[4 * LENGTH * HEIGHT];
    memset(rows, 0x5a, sizeof rows);
    OSMesaContext context = open_rgba(rows);
    OSMesaPixelStore(OSMESA_ROW_LENGTH, LENGTH);
    clear_to(1, 1, 1, 1);
    glFinish();
    for (int i = 0; i < 4 * LENGTH * HEIGHT; i++)
        assert_int_equal(rows[i], i / 4 % LENGTH < WIDTH ? 255 : 0x5a);
    GLint value;
    OSMesaGetIntegerv(OSMESA_ROW_LENGTH, &value);
    assert_int_equal(value, LENGTH);
    OSMesaDestroyContext(context);
}

static void test_color_buffer(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext context = open_rgba(&buffer);
    GLint width, height, format;
    void *address;
    assert_true(OSMesaGetColorBuffer(context, &width, &height, &format, &address));
    assert_int_equal(width, WIDTH);
    assert_int_equal(height, HEIGHT);
    assert_int_equal(format, OSMESA_RGBA);
    assert_ptr_equal(address, &buffer);
    OSMesaDestroyContext(context);
}

/* ---- depth ---- */

struct depth {
    int asked, stencil, bits, bytes;
};

static void check_depth(const struct depth *d)
{
    union buffer buffer;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, d->asked, d->stencil, 0, NULL);
    assert_non_null(context);
    assert_true(OSMesaMakeCurrent(context, &buffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    GLint bits, stencil, width, height, bytes;
    void *values;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    glGetIntegerv(GL_STENCIL_BITS, &stencil);
    assert_int_equal(bits, d->bits);
    assert_int_equal(stencil, d->stencil > 0 ? 8 : 0);
    glClearDepth(0.5);
    glClearStencil(0xab);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glFinish();
    assert_int_equal(OSMesaGetDepthBuffer(context, &width, &height, &bytes, &values), d->bits > 0);
    if (d->bits > 0) {
        assert_int_equal(width, WIDTH);
        assert_int_equal(height, HEIGHT);
        assert_int_equal(bytes, d->bytes);
    }
    for (int i = 0; d->bits > 0 && i < WIDTH * HEIGHT; i++) {
        if (d->bytes == 2)
            assert_int_equal(((uint16_t *)values)[i], 0x8000);
        else
            assert_int_equal(((uint32_t *)values)[i], (d->stencil > 0 ? 0xab000000u : 0) | 0x800000);
    }
    OSMesaDestroyContext(context);
}

static void test_depth_bits(void **state)
{
    (void)state;
    static const struct depth cases[] = {{0, 0, 0, 0},   {16, 0, 16, 2}, {24, 0, 24, 4}, {32, 0, 24, 4},
                                         {16, 8, 24, 4}, {24, 8, 24, 4}, {32, 8, 24, 4}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        check_depth(&cases[i]);
}

/* The lowest row comes first. */
static void test_depth_rows(void **state)
{
    (void)state;
    union buffer buffer;
    OSMesaContext context = open_rgba(&buffer);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, WIDTH, 1);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glFinish();
    GLint width, height, bytes;
    void *values;
    assert_true(OSMesaGetDepthBuffer(context, &width, &height, &bytes, &values));
    assert_int_equal(((uint32_t *)values)[0] & 0xffffff, 0);
    assert_int_equal(((uint32_t *)values)[WIDTH] & 0xffffff, 0xffffff);
    OSMesaDestroyContext(context);
}

static void test_no_buffer_yet(void **state)
{
    (void)state;
    if (on_mesa)
        skip(); /* crashes */
    OSMesaContext context = create(OSMESA_RGBA);
    GLint width = 1, height = 1, other = 1;
    void *address = &width;
    assert_false(OSMesaGetDepthBuffer(context, &width, &height, &other, &address));
    assert_int_equal(width, 0);
    assert_null(address);
    OSMesaDestroyContext(context);
}

/* ---- when the buffer changes ---- */

static void test_flush(void **state)
{
    (void)state;
    union buffer buffer;
    memset(&buffer, 0x5a, sizeof buffer);
    OSMesaContext context = open_rgba(&buffer);
    unsigned char read[4];
    clear_to(1, 1, 1, 1);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
    assert_int_equal(read[0], 255);
    assert_int_equal(buffer.byte[0], 0x5a);
    glFlush();
    assert_int_equal(buffer.byte[0], 255);
    clear_to(0, 1, 0, 1);
    assert_int_equal(buffer.byte[0], 255);
    glFinish();
    assert_int_equal(buffer.byte[0], 0);
    OSMesaDestroyContext(context);
}

/* The first picture starts from zeros, not from what the caller's buffer held; a new buffer of the same size
 * receives the whole picture. */
static void test_other_buffer(void **state)
{
    (void)state;
    union buffer first, second;
    memset(&first, 0x5a, sizeof first);
    memset(&second, 0x5a, sizeof second);
    OSMesaContext context = open_rgba(&first);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    clear_to(1, 1, 1, 1);
    glFinish();
    assert_int_equal(first.byte[0], 255);
    assert_int_equal(first.byte[4], 0);
    assert_true(OSMesaMakeCurrent(context, &second, GL_UNSIGNED_BYTE, WIDTH, HEIGHT));
    assert_int_equal(second.byte[0], 0x5a);
    glScissor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    assert_int_equal(second.byte[0], 255);
    assert_int_equal(second.byte[4], 255);
    assert_int_equal(second.byte[8], 0);
    OSMesaDestroyContext(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(test_formats),       cmocka_unit_test(test_unknown_formats),
            cmocka_unit_test(test_defaults),      cmocka_unit_test(test_y_up),
            cmocka_unit_test(test_row_length),    cmocka_unit_test(test_color_buffer),
            cmocka_unit_test(test_depth_bits),    cmocka_unit_test(test_depth_rows),
            cmocka_unit_test(test_no_buffer_yet), cmocka_unit_test(test_flush),
            cmocka_unit_test(test_other_buffer),
    };
    return cmocka_run_group_tests(tests, find_out_whose, NULL);
}
