/* The fragment kernels: for random plans, the fused and the general kernel of every instruction set that this
 * CPU has give the bytes of a plain transcription of the rules, pixel by pixel; nothing outside of the runs
 * changes. */
#include "raster_setup.h"

#include "base/arith.h"

#include <math.h>

enum { WIDTH = 100, HEIGHT = 20 };

/* ---- the transcription ---- */

struct pixel { /* colour in units of the buffer's last place, or in floats */
    double c[4];
};

static double channel_max(const struct framebuffer *fb)
{
    return fb->color_kind == COLOR_UNORM16 ? 65535.0 : fb->color_kind == COLOR_FLOAT ? 1.0 : 255.0;
}

static struct pixel load(const struct framebuffer *fb, size_t at)
{
    struct pixel p = {{0}};
    if (fb->color_kind == COLOR_UNORM8)
        for (int c = 0; c < 4; c++)
            p.c[c] = ((const uint8_t *)fb->color)[4 * at + (size_t)c];
    if (fb->color_kind == COLOR_UNORM16)
        for (int c = 0; c < 4; c++)
            p.c[c] = ((const uint16_t *)fb->color)[4 * at + (size_t)c];
    if (fb->color_kind == COLOR_FLOAT)
        for (int c = 0; c < 4; c++)
            p.c[c] = (double)((const float *)fb->color)[4 * at + (size_t)c];
    if (fb->color_kind == COLOR_565) {
        const unsigned v = ((const uint16_t *)fb->color)[at], r = v >> 11, g = v >> 5 & 63, b = v & 31;
        p = (struct pixel){{r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2}};
    }
    if (!fb->has_alpha)
        p.c[3] = channel_max(fb);
    return p;
}

static void store(const struct framebuffer *fb, size_t at, struct pixel p)
{
    for (size_t c = 0; c < 4; c++) {
        if (fb->color_kind == COLOR_UNORM8)
            ((uint8_t *)fb->color)[4 * at + c] = (uint8_t)p.c[c];
        if (fb->color_kind == COLOR_UNORM16)
            ((uint16_t *)fb->color)[4 * at + c] = (uint16_t)p.c[c];
        if (fb->color_kind == COLOR_FLOAT)
            ((float *)fb->color)[4 * at + c] = (float)p.c[c];
    }
    if (fb->color_kind == COLOR_565)
        ((uint16_t *)fb->color)[at] =
                (uint16_t)((int)p.c[0] >> 3 << 11 | (int)p.c[1] >> 2 << 5 | (int)p.c[2] >> 3);
}

static float unit(float v)
{
    return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
}

/* Half to even of a float product. */
static double quantise(float v, double max)
{
    return nearbyint((double)(unit(v) * (float)max));
}

static float plane(const struct planes *p, int lane, int x, int y)
{
    return fmaf(p->dady[lane], (float)y, fmaf(p->dadx[lane], (float)x, p->a00[lane]));
}

static bool passes(GLenum func, double a, double b)
{
    switch (func) {
    case GL_NEVER: return false;
    case GL_LESS: return a < b;
    case GL_EQUAL: return a == b;
    case GL_LEQUAL: return a <= b;
    case GL_GREATER: return a > b;
    case GL_NOTEQUAL: return a != b;
    case GL_GEQUAL: return a >= b;
    default: return true;
    }
}

static int stencil_result(GLenum op, int v, int ref)
{
    switch (op) {
    case GL_ZERO: return 0;
    case GL_REPLACE: return ref;
    case GL_INCR: return v == 255 ? 255 : v + 1;
    case GL_DECR: return v == 0 ? 0 : v - 1;
    case GL_INCR_WRAP: return (v + 1) % 256;
    case GL_DECR_WRAP: return (v + 255) % 256;
    case GL_INVERT: return 255 - v;
    default: return v;
    }
}

static double factor(GLenum f, int c, const struct pixel *s, const struct pixel *d, const double constant[4],
                     double max)
{
    switch (f) {
    case GL_ZERO: return 0.0;
    case GL_ONE: return max;
    case GL_SRC_COLOR: return s->c[c];
    case GL_ONE_MINUS_SRC_COLOR: return max - s->c[c];
    case GL_DST_COLOR: return d->c[c];
    case GL_ONE_MINUS_DST_COLOR: return max - d->c[c];
    case GL_SRC_ALPHA: return s->c[3];
    case GL_ONE_MINUS_SRC_ALPHA: return max - s->c[3];
    case GL_DST_ALPHA: return d->c[3];
    case GL_ONE_MINUS_DST_ALPHA: return max - d->c[3];
    case GL_CONSTANT_COLOR: return constant[c];
    case GL_ONE_MINUS_CONSTANT_COLOR: return max - constant[c];
    case GL_CONSTANT_ALPHA: return constant[3];
    case GL_ONE_MINUS_CONSTANT_ALPHA: return max - constant[3];
    default: return c == 3 ? max : fmin(s->c[3], max - d->c[3]); /* GL_SRC_ALPHA_SATURATE */
    }
}

/* The product of two normalised n-bit numbers, as the integer that OSMesa makes of it. */
static double product(double a, double b, double max)
{
    const uint64_t t = (uint64_t)a * (uint64_t)b, n = max == 255.0 ? 8 : 16;
    return (double)((t + (t >> n) + (1u << (n - 1))) >> n);
}

static double blended(const struct color_buffer_state *s, int c, const struct pixel *src,
                      const struct pixel *dst, double max)
{
    double constant[4];
    const GLenum equation = s->blend_equation[c == 3];
    for (int i = 0; i < 4; i++)
        constant[i] = quantise(s->blend_color[i], max);
    if (equation == GL_MIN)
        return fmin(src->c[c], dst->c[c]);
    if (equation == GL_MAX)
        return fmax(src->c[c], dst->c[c]);
    const double a =
            product(src->c[c],
                    factor(c == 3 ? s->blend_src_alpha : s->blend_src_rgb, c, src, dst, constant, max), max);
    const double b =
            product(dst->c[c],
                    factor(c == 3 ? s->blend_dst_alpha : s->blend_dst_rgb, c, src, dst, constant, max), max);
    const double sum = equation == GL_FUNC_SUBTRACT ? a - b
                       : equation == GL_FUNC_ADD    ? a + b
                                                             : b - a;
    return fmin(fmax(sum, 0.0), max);
}

/* GL 1.5, table 4.2, by truth table: bit 2 s + d of the operation's code. */
static unsigned logic(GLenum op, unsigned s, unsigned d, unsigned max)
{
    static const unsigned char table[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                            1, 9, 5, 13, 3, 11, 7, 15}; /* GL_CLEAR .. GL_SET */
    const unsigned t = table[op - GL_CLEAR];
    return ((t & 1 ? ~s & ~d : 0) | (t & 2 ? ~s & d : 0) | (t & 4 ? s & ~d : 0) | (t & 8 ? s & d : 0)) & max;
}

static float fog_factor(const struct fragment_plan *plan, float z)
{
    if (plan->fog_mode == GL_LINEAR)
        return unit(z * plan->fog.p + plan->fog.q);
    const float t = z * plan->fog.k;
    return unit(r_exp2(plan->fog_mode == GL_EXP ? -t : -(t * t)));
}

static void shade(const struct fragment_plan *plan, const struct planes *p, int x, int y, float c[4])
{
    const float w = 1.0f / plane(p, LANE_OOW, x, y);
    for (int i = 0; i < 4; i++)
        c[i] = plan->color_source == COLOR_SMOOTH ? plane(p, LANE_COLOR + i, x, y) * w
               : plan->color_source == COLOR_FLAT ? p->a00[LANE_COLOR + i]
                                                  : plan->constant_color[i];
    for (int i = 0; i < 3 && plan->has_secondary; i++)
        c[i] += plan->secondary_source == COLOR_SMOOTH ? plane(p, LANE_SECONDARY + i, x, y) * w
                : plan->secondary_source == COLOR_FLAT ? p->a00[LANE_SECONDARY + i]
                                                       : plan->constant_secondary[i];
    if (plan->has_fog) {
        const float f = fog_factor(plan, plane(p, LANE_FOG, x, y) * w);
        for (int i = 0; i < 3; i++)
            c[i] = plan->fog_color[i] * (1.0f - f) + c[i] * f;
    }
}

static void reference_pixel(const struct fragment_plan *plan, const struct planes *p, int x, int y)
{
    const struct framebuffer *fb = plan->fb;
    const struct color_buffer_state *s = &plan->color_buffer;
    const size_t at = (size_t)y * (size_t)fb->stride + (size_t)x;
    const double max = channel_max(fb);
    float c[4];
    shade(plan, p, x, y, c);
    if (plan->alpha_test && fb->color_kind == COLOR_UNORM8 &&
        !passes(s->alpha_test_func, quantise(c[3], 255.0), quantise(s->alpha_test_ref, 255.0)))
        return;
    if (plan->alpha_test && fb->color_kind != COLOR_UNORM8 &&
        !passes(s->alpha_test_func, (double)c[3], (double)s->alpha_test_ref))
        return;

    const double z = quantise(plane(p, LANE_Z, x, y) + p->z_offset, (double)fb->depth_max);
    const bool depth_ok = !plan->depth_test || passes(plan->depth_func, z, fb->depth[at]);
    if (plan->stencil_test) {
        const struct stencil_state *t = &plan->stencil;
        const int ref = fgl_clamp(t->stencil_ref, 0, 255), v = fb->stencil[at],
                  mask = (int)(t->stencil_writemask & 255);
        const bool ok =
                passes(t->stencil_func, ref & (int)t->stencil_value_mask, v & (int)t->stencil_value_mask);
        const GLenum op = !ok        ? t->stencil_fail
                          : depth_ok ? t->stencil_pass_depth_pass
                                     : t->stencil_pass_depth_fail;
        fb->stencil[at] = (uint8_t)((v & ~mask) | (stencil_result(op, v, ref) & mask));
        if (!ok)
            return;
    }
    if (!depth_ok)
        return;
    if (plan->depth_write)
        fb->depth[at] = (uint32_t)z;

    const struct pixel dst = load(fb, at);
    struct pixel src, out;
    for (int i = 0; i < 4; i++)
        src.c[i] = fb->color_kind == COLOR_FLOAT ? (double)c[i] : quantise(c[i], max);
    for (int i = 0; i < 4; i++) {
        out.c[i] = src.c[i];
        if (plan->blend)
            out.c[i] = blended(s, i, &src, &dst, max);
        if (plan->logic_op && fb->color_kind != COLOR_FLOAT)
            out.c[i] = logic(s->logic_op_mode, (unsigned)src.c[i], (unsigned)dst.c[i], (unsigned)max);
        if (!plan->channel_write[i])
            out.c[i] = dst.c[i];
    }
    store(fb, at, out);
}

static void reference_fill(const struct fragment_plan *plan, const struct planes *planes,
                           const struct runs *runs)
{
    for (int i = 0; i < runs->n; i++)
        for (int x = runs->x0[i]; x < runs->x1[i]; x++)
            reference_pixel(plan, planes, x, runs->y + i);
}

/* ---- random cases ---- */

static GLenum pick(const GLenum *of, int n)
{
    return of[one_of(n)];
}

static const GLenum factors[] = {GL_ZERO,
                                 GL_ONE,
                                 GL_SRC_COLOR,
                                 GL_ONE_MINUS_SRC_COLOR,
                                 GL_DST_COLOR,
                                 GL_ONE_MINUS_DST_COLOR,
                                 GL_SRC_ALPHA,
                                 GL_ONE_MINUS_SRC_ALPHA,
                                 GL_DST_ALPHA,
                                 GL_ONE_MINUS_DST_ALPHA,
                                 GL_CONSTANT_COLOR,
                                 GL_ONE_MINUS_CONSTANT_COLOR,
                                 GL_CONSTANT_ALPHA,
                                 GL_ONE_MINUS_CONSTANT_ALPHA,
                                 GL_SRC_ALPHA_SATURATE};
static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
static const GLenum operations[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                    GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
static const GLenum fog_modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};

static GLenum any_func(void)
{
    return (GLenum)(GL_NEVER + one_of(8));
}

static void random_color_state(struct color_buffer_state *s, bool can_blend)
{
    s->alpha_test = one_of(3) == 0;
    s->alpha_test_func = any_func();
    s->alpha_test_ref = (float)one_of(256) / 255.0f;
    s->blend = can_blend && one_of(2);
    s->color_logic_op = one_of(4) == 0;
    s->logic_op_mode = (GLenum)(GL_CLEAR + one_of(16));
    s->blend_src_rgb = pick(factors, 15);
    s->blend_dst_rgb = pick(factors, 14);
    s->blend_src_alpha = pick(factors, 15);
    s->blend_dst_alpha = pick(factors, 14);
    s->blend_equation[0] = pick(equations, 5);
    s->blend_equation[1] = pick(equations, 5);
    for (int c = 0; c < 4; c++) {
        s->blend_color[c] = between(0.0f, 1.0f);
        s->color_writemask[c] = one_of(5) != 0;
    }
}

static void random_state_of(struct server_state *s, bool plain, bool can_blend)
{
    state_defaults(s);
    s->depth.depth_test = one_of(3) != 0;
    s->depth.depth_func = one_of(2) ? GL_LESS : GL_LEQUAL;
    if (plain)
        return;
    random_color_state(&s->color_buffer, can_blend);
    s->depth.depth_func = any_func();
    s->depth.depth_writemask = one_of(3) != 0;
    s->stencil.stencil_test = one_of(2);
    s->stencil.stencil_func = any_func();
    s->stencil.stencil_ref = one_of(400) - 50;
    s->stencil.stencil_value_mask = random_bits() | (one_of(2) ? 255 : 0);
    s->stencil.stencil_writemask = random_bits() | (one_of(2) ? 255 : 0);
    s->stencil.stencil_fail = pick(operations, 8);
    s->stencil.stencil_pass_depth_fail = pick(operations, 8);
    s->stencil.stencil_pass_depth_pass = pick(operations, 8);
    s->fog.fog = one_of(3) == 0;
    s->fog.fog_mode = pick(fog_modes, 3);
    s->fog.fog_density = between(0.0f, 2.0f);
    s->fog.fog_start = between(0.0f, 1.0f);
    s->fog.fog_end = one_of(6) ? between(0.0f, 2.0f) : s->fog.fog_start;
    for (int c = 0; c < 4; c++)
        s->fog.fog_color[c] = between(0.0f, 1.0f);
}

/* Values from a little below 0 to a little above 1 over the buffer; now and then no numbers at all. */
static void random_planes(struct planes *p, bool flat)
{
    memset(p, 0, sizeof *p);
    for (int lane = 0; lane < LANE_TEX0; lane++) {
        const bool constant = flat && lane >= LANE_COLOR && lane < LANE_FOG;
        p->a00[lane] = between(-0.1f, 1.1f);
        p->dadx[lane] = constant ? 0.0f : between(-0.01f, 0.01f);
        p->dady[lane] = constant ? 0.0f : between(-0.01f, 0.01f);
    }
    p->a00[LANE_OOW] = one_of(20) ? between(1.0f, 4.0f) : 0.0f;
    p->z_offset = one_of(3) ? 0.0f : between(-0.2f, 0.2f);
    if (one_of(30) == 0)
        p->dadx[one_of(LANE_TEX0)] = INFINITY;
}

static void random_runs(struct runs *r)
{
    r->n = 1 + one_of(HEIGHT);
    r->y = one_of(HEIGHT - r->n + 1);
    for (int i = 0; i < r->n; i++) {
        r->x0[i] = one_of(WIDTH);
        r->x1[i] = one_of(4) ? fgl_min(WIDTH, r->x0[i] + one_of(40)) : one_of(WIDTH + 1);
    }
}

/* Some depths are what the primitive will have: equality must occur. */
static void random_pixels(const struct framebuffer *fb, const struct planes *p)
{
    for (size_t i = 0; i < pixels(fb) * pixel_size(fb->color_kind) / 4; i++)
        if (fb->color_kind == COLOR_FLOAT)
            ((float *)fb->color)[i] = between(-0.5f, 1.5f);
        else
            ((uint32_t *)fb->color)[i] = random_bits();
    for (size_t i = 0; i < pixels(fb); i++) {
        const int x = (int)(i % (size_t)fb->stride), y = (int)(i / (size_t)fb->stride);
        const double z = quantise(plane(p, LANE_Z, x, y) + p->z_offset, (double)fb->depth_max);
        fb->depth[i] = one_of(3) ? (uint32_t)z : random_bits() & fb->depth_max;
        fb->stencil[i] = (uint8_t)random_bits();
    }
}

static void copy_pixels(const struct framebuffer *to, const struct framebuffer *from)
{
    memcpy(to->color, from->color, pixels(from) * pixel_size(from->color_kind));
    memcpy(to->depth, from->depth, pixels(from) * sizeof *from->depth);
    memcpy(to->stencil, from->stencil, pixels(from));
}

/* NaN has no one bit pattern; in a float buffer any will do. */
static bool same_color(const struct framebuffer *a, const struct framebuffer *b)
{
    const size_t n = pixels(a) * pixel_size(a->color_kind);
    if (a->color_kind != COLOR_FLOAT)
        return memcmp(a->color, b->color, n) == 0;
    for (size_t i = 0; i < n / sizeof(float); i++)
        if (!same_float(((const float *)a->color)[i], ((const float *)b->color)[i]))
            return false;
    return true;
}

static void assert_same_pixels(const struct framebuffer *a, const struct framebuffer *b)
{
    assert_true(same_color(a, b));
    assert_memory_equal(a->depth, b->depth, pixels(a) * sizeof *a->depth);
    assert_memory_equal(a->stencil, b->stencil, pixels(a));
}

/* One random plan, run by the transcription and by a kernel of each instruction set. */
static void compare_kernels(enum color_kind kind, int depth_bits, bool plain)
{
    static struct server_state s;
    struct framebuffer start = framebuffer_make(WIDTH, HEIGHT, kind, depth_bits),
                       want = framebuffer_make(WIDTH, HEIGHT, kind, depth_bits),
                       got = framebuffer_make(WIDTH, HEIGHT, kind, depth_bits);
    struct fragment_plan plan = {.color_source = (enum color_source)one_of(3),
                                 .has_secondary = !plain && one_of(3) == 0,
                                 .secondary_source = (enum color_source)one_of(3)};
    struct planes planes;
    struct runs runs;
    random_state_of(&s, plain, kind != COLOR_FLOAT);
    random_planes(&planes, plan.color_source == COLOR_FLAT);
    random_runs(&runs);
    random_pixels(&start, &planes);
    for (int c = 0; c < 4; c++)
        plan.constant_color[c] = between(-0.1f, 1.1f);
    for (int c = 0; c < 3; c++)
        plan.constant_secondary[c] = between(0.0f, 1.0f);

    fgl_fragment_validate(&plan, &s, &want, false);
    assert_true(!plain || kind != COLOR_UNORM8 || plan.fill != plan.general);
    copy_pixels(&want, &start);
    reference_fill(&plan, &planes, &runs);
    plan.fb = &got;
    for (int isa = 0; isa < FGL_ISA_COUNT; isa++) {
        if (!fgl_cpu_has((enum fgl_isa)isa))
            continue;
        const struct fragment_kernels *k = fgl_fragment_kernels_of((enum fgl_isa)isa, ARITH_COMPATIBLE);
        copy_pixels(&got, &start);
        k->general(&plan, &planes, &runs);
        assert_same_pixels(&want, &got);
        const enum depth_kind depth = !plan.depth_test             ? DEPTH_OFF
                                      : plan.depth_func == GL_LESS ? DEPTH_LESS
                                                                   : DEPTH_LEQUAL;
        if (plain && kind == COLOR_UNORM8) {
            copy_pixels(&got, &start);
            k->fused[depth][plan.color_source](&plan, &planes, &runs);
            assert_same_pixels(&want, &got);
        }
        if (plan.fill != plan.general) {
            copy_pixels(&got, &start);
            k->staged[depth](&plan, &planes, &runs);
            assert_same_pixels(&want, &got);
        }
        framebuffer_check(&got);
    }
    framebuffer_destroy(&start);
    framebuffer_destroy(&want);
    framebuffer_destroy(&got);
}

static void fused_kernels(void **state)
{
    (void)state;
    random_seed(11);
    for (int i = 0; i < 600; i++)
        compare_kernels(COLOR_UNORM8, i % 3 ? 24 : 16, true);
}

static void general_kernel(void **state)
{
    (void)state;
    random_seed(12);
    for (int i = 0; i < 1200; i++)
        compare_kernels((enum color_kind)(i % 4), i % 5 ? 24 : 16, false);
}

static void general_is_asked_for(void **state)
{
    static struct server_state s;
    struct framebuffer fb = framebuffer_make(WIDTH, HEIGHT, COLOR_UNORM8, 24);
    struct fragment_plan plan = {.color_source = COLOR_SMOOTH};
    (void)state;
    state_defaults(&s);
    fgl_fragment_validate(&plan, &s, &fb, true);
    assert_true(plan.fill == plan.general);
    framebuffer_destroy(&fb);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(fused_kernels),
            cmocka_unit_test(general_kernel),
            cmocka_unit_test(general_is_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
