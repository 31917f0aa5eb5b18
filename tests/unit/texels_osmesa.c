/* Storage of textures against Mesa's OSMesa: random images of every format and type to every internal format, without and with pixel transfer,
 * read back as floats: the same bits. */
#include "both.h"

enum { SIDE = 16 };

struct texture_gl {
    void (*TexImage2D)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *);
    void (*GetTexImage)(GLenum, GLint, GLenum, GLenum, void *);
    void (*PixelTransferf)(GLenum, GLfloat);
    GLenum (*GetError)(void);
};

static const GLint internal_formats[] = {
        1, 2, 3, 4, GL_ALPHA, GL_ALPHA4, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16, GL_LUMINANCE, GL_LUMINANCE4, GL_LUMINANCE8, GL_LUMINANCE12,
        GL_LUMINANCE16, GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_LUMINANCE6_ALPHA2, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE12_ALPHA4,
        GL_LUMINANCE12_ALPHA12, GL_LUMINANCE16_ALPHA16, GL_INTENSITY, GL_INTENSITY4, GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16,
        GL_RGB, GL_R3_G3_B2, GL_RGB4, GL_RGB5, GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16, GL_RGBA, GL_RGBA2, GL_RGBA4, GL_RGB5_A1, GL_RGBA8,
        GL_RGB10_A2, GL_RGBA12, GL_RGBA16, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32};
static const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                 GL_COLOR_INDEX, GL_DEPTH_COMPONENT};
static const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT, GL_BITMAP,
                               GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5,
                               GL_UNSIGNED_SHORT_5_6_5_REV, GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_4_4_4_4_REV,
                               GL_UNSIGNED_SHORT_5_5_5_1, GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_UNSIGNED_INT_8_8_8_8,
                               GL_UNSIGNED_INT_8_8_8_8_REV, GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV};

static struct texture_gl texture_fixedgl, texture_osmesa;
static uint32_t seed = 1;
static union {
    uint32_t word[SIDE * SIDE * 4];
    float real[SIDE * SIDE * 4];
} image;

static void fill_texture_table(struct texture_gl *gl, get_proc_fn *get_proc)
{
    gl->TexImage2D = (void (*)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *))get_proc("glTexImage2D");
    gl->GetTexImage = (void (*)(GLenum, GLint, GLenum, GLenum, void *))get_proc("glGetTexImage");
    gl->PixelTransferf = (void (*)(GLenum, GLfloat))get_proc("glPixelTransferf");
    gl->GetError = (GLenum(*)(void))get_proc("glGetError");
}

static void fill_image(GLenum type)
{
    for (int i = 0; i < SIDE * SIDE * 4; i++) {
        seed = seed * 1664525u + 1013904223u;
        image.word[i] = seed ^ seed >> 15;
        if (type == GL_FLOAT)
            image.real[i] = (float)(seed >> 20) / 4095.0f * 1.2f - 0.1f;
    }
}

/* Uploads and reads back; false when the combination raises an error. */
static bool store(const struct texture_gl *gl, GLint internal_format, GLenum format, GLenum type, bool transfer, float *out)
{
    const bool depth = format == GL_DEPTH_COMPONENT;
    gl->PixelTransferf(GL_RED_SCALE, transfer ? 0.7f : 1.0f);
    gl->PixelTransferf(GL_GREEN_BIAS, transfer ? 0.2f : 0.0f);
    gl->PixelTransferf(GL_DEPTH_SCALE, transfer ? 0.5f : 1.0f);
    gl->TexImage2D(GL_TEXTURE_2D, 0, internal_format, SIDE, SIDE, 0, format, type, &image);
    gl->PixelTransferf(GL_DEPTH_SCALE, 1.0f);
    if (gl->GetError() != GL_NO_ERROR)
        return false;
    gl->GetTexImage(GL_TEXTURE_2D, 0, depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, out);
    return true;
}

static void compare(GLint internal_format, GLenum format, GLenum type, bool transfer)
{
    static float ours[SIDE * SIDE * 4], theirs[SIDE * SIDE * 4];
    fill_image(type);
    fixedgl.make_current(fixedgl.context, fixedgl.pixels, GL_FLOAT, BOTH_SIZE, BOTH_SIZE);
    const bool stored = store(&texture_fixedgl, internal_format, format, type, transfer, ours);
    if (!have_osmesa)
        return;
    osmesa.make_current(osmesa.context, osmesa.pixels, GL_FLOAT, BOTH_SIZE, BOTH_SIZE);
    assert_int_equal(store(&texture_osmesa, internal_format, format, type, transfer, theirs), stored);
    if (stored && memcmp(ours, theirs, sizeof ours) != 0)
        fail_msg("internal format 0x%x, format 0x%x, type 0x%x, transfer %d", internal_format, format, type, transfer);
}

static void images_are_stored_alike(void **state)
{
    (void)state;
    fill_texture_table(&texture_fixedgl, OSMesaGetProcAddress);
    begin_context(&fixedgl);
    if (have_osmesa) {
        void *library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
        fill_texture_table(&texture_osmesa, (get_proc_fn *)dlsym(library, "OSMesaGetProcAddress"));
        begin_context(&osmesa);
    }
    for (size_t i = 0; i < sizeof internal_formats / sizeof *internal_formats; i++)
        for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
            for (size_t t = 0; t < sizeof types / sizeof *types; t++)
                for (int transfer = 0; transfer < 2; transfer++)
                    compare(internal_formats[i], formats[f], types[t], transfer);
    end_context(&fixedgl);
    if (have_osmesa)
        end_context(&osmesa);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(images_are_stored_alike)};
    return cmocka_run_group_tests(tests, load_both, NULL);
}
