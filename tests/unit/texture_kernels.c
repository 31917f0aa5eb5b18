/* Textured fragments: for random textures, filters and environments the specialised kernels of every instruction set that this CPU has give the
 * bytes of the general path of the first. */
#include "raster_setup.h"

#include "texture/image.h"

#include <math.h>

enum { WIDTH = 100, HEIGHT = 12, UNITS = 2, LARGEST = 48, CASES = 1500 };

static GLenum pick(const GLenum *of, int n)
{
    return of[one_of(n)];
}

/* ---- random textures ---- */

static void define(struct texture_image *image, enum texture_target target, GLenum internal_format, int width, int height, int depth)
{
    const struct image_shape shape = {internal_format, fgl_texture_format(internal_format), width, height, depth, 0};
    assert_true(fgl_texture_image_define(image, target, &shape, false));
    const size_t texels = (size_t)image->width * (size_t)image->height * (size_t)image->depth;
    for (size_t i = 0; i < texels * fgl_texel_bytes(image->kind); i++)
        ((uint8_t *)image->texels)[i] = (uint8_t)random_bits();
    if (image->kind == TEXELS_FLOAT)
        for (size_t i = 0; i < 4 * texels; i++)
            ((float *)image->texels)[i] = between(0.0f, 1.0f);
}

static struct texture_object *random_texture(enum texture_target target)
{
    static const GLenum formats[] = {GL_RGBA8, GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8, GL_INTENSITY8, GL_RGBA4, GL_RGBA16};
    static const GLenum swizzles[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_ZERO, GL_ONE};
    static const GLenum filters[] = {GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
    static const GLenum wraps[] = {GL_REPEAT, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP, GL_MIRRORED_REPEAT};
    struct texture_object *t = calloc(1, sizeof *t);
    const GLenum format = pick(formats, FGL_COUNTOF(formats));
    const bool power = one_of(2), cube = target == TEXTURE_CUBE_MAP;
    const int w = power ? 1 << one_of(6) : 1 + one_of(LARGEST);
    const int h = target == TEXTURE_1D ? 1 : cube ? w : power ? 1 << one_of(6) : 1 + one_of(LARGEST);
    const int d = target == TEXTURE_3D ? 1 << one_of(3) : 1;
    t->target = target;
    t->parameters = (struct texture_parameters){.min_filter = pick(filters, 6), .mag_filter = pick(filters, 2), .max_level = 1000,
                                                .min_lod = -1000, .max_lod = 1000, .depth_mode = GL_LUMINANCE};
    for (int c = 0; c < 4; c++)
        t->parameters.swizzle[c] = one_of(12) ? (GLenum)(GL_RED + c) : pick(swizzles, 6);
    if (one_of(3) == 0)
        t->parameters.lod_bias = between(-2.0f, 2.0f);
    for (int i = 0; i < 3; i++)
        t->parameters.wrap[i] = pick(wraps, one_of(3) ? 3 : 5);
    for (int face = 0; face < fgl_texture_faces(target); face++)
        for (int level = 0; level == 0 || fgl_max(fgl_max(w, h), d) >> level; level++)
            define(&t->image[face][level], target, format, fgl_max(w >> level, 1), fgl_max(h >> level, 1), fgl_max(d >> level, 1));
    assert_true(fgl_texture_complete(t, true));
    return t;
}

static void free_texture(struct texture_object *t)
{
    for (int face = 0; face < TEXTURE_MAX_FACES; face++)
        for (int level = 0; level < FGL_MAX_TEXTURE_LEVELS; level++)
            fgl_texture_image_clear(&t->image[face][level]);
    free(t);
}

/* ---- random draws ---- */

static void random_environment(struct texture_env *e)
{
    static const GLenum modes[] = {GL_MODULATE, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_ADD, GL_BLEND, GL_COMBINE};
    static const GLenum functions[] = {GL_MODULATE, GL_REPLACE, GL_ADD, GL_INTERPOLATE};
    static const GLenum sources[] = {GL_TEXTURE, GL_PREVIOUS, GL_PRIMARY_COLOR, GL_CONSTANT};
    static const GLenum operands[] = {GL_SRC_COLOR, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
    *e = (struct texture_env){.mode = pick(modes, FGL_COUNTOF(modes)), .rgb_scale = one_of(4) ? 1.0f : 2.0f, .alpha_scale = 1.0f};
    e->combine_rgb = pick(functions, 4);
    e->combine_alpha = pick(functions, 4);
    for (int i = 0; i < 3; i++) {
        e->source_rgb[i] = pick(sources, one_of(2) ? 2 : 4);
        e->source_alpha[i] = pick(sources, one_of(2) ? 2 : 4);
        e->operand_rgb[i] = pick(operands, one_of(2) ? 2 : 5);
        e->operand_alpha[i] = one_of(3) ? GL_SRC_ALPHA : GL_ONE_MINUS_SRC_ALPHA;
    }
    for (int c = 0; c < 4; c++)
        e->color[c] = between(0.0f, 1.0f);
}

static void random_state_of(struct server_state *s, struct texture_object *texture[UNITS])
{
    state_defaults(s);
    s->depth.depth_test = one_of(2);
    s->depth.depth_func = one_of(3) ? GL_LESS : GL_GEQUAL;
    s->color_buffer.blend = one_of(4) == 0;
    s->color_buffer.blend_src_rgb = s->color_buffer.blend_src_alpha = GL_SRC_ALPHA;
    s->color_buffer.blend_dst_rgb = s->color_buffer.blend_dst_alpha = GL_ONE_MINUS_SRC_ALPHA;
    for (int unit = 0; unit < UNITS; unit++) {
        const enum texture_target target = one_of(4) ? TEXTURE_2D : (enum texture_target)one_of(TEXTURE_TARGETS);
        texture[unit] = random_texture(target);
        s->texture.unit[unit].bound[target] = texture[unit];
        s->texture.unit[unit].enabled = unit == 0 || one_of(2) ? 1u << target : 0;
        random_environment(&s->texture.unit[unit].env);
        for (int c = 0; c < 4; c++)
            s->current.attr[ATTR_TEX0 + unit][c] = between(0.5f, 2.0f);
    }
}

/* Textures are seen from eight times too large to eight times too small. */
static void random_planes(struct planes *p, const struct fragment_plan *plan)
{
    const float slope = (float)(1 << one_of(7)) / 512.0f;
    memset(p, 0, sizeof *p);
    for (int lane = 0; lane < LANE_MAX; lane++) {
        p->a00[lane] = between(-0.1f, 1.1f);
        p->dadx[lane] = between(-0.005f, 0.005f);
        p->dady[lane] = between(-0.005f, 0.005f);
    }
    p->a00[LANE_OOW] = between(1.0f, 4.0f);
    for (int i = 0; i < plan->textures; i++)
        for (int c = 0; c < 4; c++) {
            const int lane = plan->texture[i].lane + c;
            p->a00[lane] = c == 3 ? between(1.0f, 2.0f) : between(-2.0f, 2.0f);
            p->dadx[lane] = c == 3 ? 0.001f : between(-slope, slope);
            p->dady[lane] = c == 3 ? 0.002f : between(-slope, slope);
        }
    if (one_of(30) == 0)
        p->dadx[LANE_COLOR + one_of(12)] = INFINITY;
}

static void random_pixels(const struct framebuffer *a, const struct framebuffer *b)
{
    for (size_t i = 0; i < pixels(a); i++) {
        ((uint32_t *)a->color)[i] = ((uint32_t *)b->color)[i] = random_bits();
        a->depth[i] = b->depth[i] = random_bits() & a->depth_max;
    }
}

static const struct fragment_kernels *first_kernels(void)
{
    int isa = 0;
    while (!fgl_cpu_has((enum fgl_isa)isa))
        isa++;
    return fgl_fragment_kernels_of((enum fgl_isa)isa, ARITH_COMPATIBLE);
}

/* What the plan chose, but of another instruction set. */
static fragment_fill_fn *chosen(const struct fragment_plan *plan, enum fgl_isa isa)
{
    const struct fragment_kernels *k = fgl_fragment_kernels_of(isa, ARITH_COMPATIBLE);
    return plan->fill == plan->general ? k->general : k->staged[plan->depth_test ? DEPTH_LESS : DEPTH_OFF];
}

/* One random draw into two buffers; returns whether it was of products. */
static bool compare_paths(void)
{
    static struct server_state s;
    struct texture_object *texture[UNITS];
    struct framebuffer want = framebuffer_make(WIDTH, HEIGHT, COLOR_UNORM8, 24), got = framebuffer_make(WIDTH, HEIGHT, COLOR_UNORM8, 24);
    struct fragment_plan general = {.color_source = (enum color_source)one_of(3), .texture_varying = (uint32_t)one_of(8)}, special;
    struct planes planes;
    struct runs runs = {.n = HEIGHT};
    for (int c = 0; c < 4; c++)
        general.constant_color[c] = between(0.0f, 1.0f);
    for (int i = 0; i < HEIGHT; i++) {
        runs.x0[i] = one_of(WIDTH);
        runs.x1[i] = one_of(3) ? fgl_min(runs.x0[i] + one_of(60), WIDTH) : WIDTH;
    }
    random_state_of(&s, texture);
    special = general;
    fgl_fragment_validate(&general, &s, &want, true);
    fgl_fragment_validate(&special, &s, &got, false);
    assert_true(general.textures > 0 && !general.texture_products);
    random_planes(&planes, &general);

    for (int isa = 0; isa < FGL_ISA_COUNT; isa++) {
        if (!fgl_cpu_has((enum fgl_isa)isa))
            continue;
        random_pixels(&want, &got);
        first_kernels()->general(&general, &planes, &runs);
        chosen(&special, (enum fgl_isa)isa)(&special, &planes, &runs);
        assert_memory_equal(want.color, got.color, pixels(&want) * sizeof(uint32_t));
        assert_memory_equal(want.depth, got.depth, pixels(&want) * sizeof *want.depth);
        framebuffer_check(&got);
    }
    framebuffer_destroy(&want);
    framebuffer_destroy(&got);
    for (int unit = 0; unit < UNITS; unit++)
        free_texture(texture[unit]);
    return special.texture_products;
}

static void all_paths_agree(void **state)
{
    int products = 0;
    (void)state;
    random_seed(21);
    for (int i = 0; i < CASES; i++)
        products += compare_paths();
    assert_true(products > CASES / 8 && products < CASES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_paths_agree)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
