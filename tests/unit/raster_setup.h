/* What the tests of rasterization and of fragments share: a framebuffer with guard bytes around it, and plans
 * made from default state. */
#ifndef TESTS_UNIT_RASTER_SETUP_H
#define TESTS_UNIT_RASTER_SETUP_H

#include "unit.h"

#include "raster/raster.h"

enum { GUARD = 4096 /* bytes */, GUARD_BYTE = 0xa5 };

/* Memory of n bytes on 64, with GUARD bytes of GUARD_BYTE before and behind. */
static inline void *guarded(size_t n)
{
    unsigned char *p = aligned_alloc(64, (n + 2 * GUARD + 63) / 64 * 64);
    assert_non_null(p);
    memset(p, GUARD_BYTE, n + 2 * GUARD);
    memset(p + GUARD, 0, n);
    return p + GUARD;
}

static inline void guarded_check(const void *memory, size_t n)
{
    const unsigned char *p = memory;
    for (int i = 1; i <= GUARD; i++)
        assert_true(p[-i] == GUARD_BYTE && p[n - 1 + (size_t)i] == GUARD_BYTE);
}

static inline void guarded_free(void *p)
{
    free((unsigned char *)p - GUARD);
}

static inline size_t pixel_size(enum color_kind kind)
{
    static const size_t size[] = {
            [COLOR_UNORM8] = 4, [COLOR_UNORM16] = 8, [COLOR_FLOAT] = 16, [COLOR_565] = 2};
    return size[kind];
}

static inline size_t pixels(const struct framebuffer *fb)
{
    return (size_t)fb->stride * (size_t)fb->height;
}

static inline struct framebuffer framebuffer_make(int width, int height, enum color_kind kind, int depth_bits)
{
    struct framebuffer fb = {.width = width,
                             .height = height,
                             .color_kind = kind,
                             .has_alpha = kind != COLOR_565,
                             .depth_bits = depth_bits};
    fb.stride = (width + FB_ALIGN - 1) / FB_ALIGN * FB_ALIGN;
    fb.depth_max = (1u << depth_bits) - 1;
    fb.color = guarded(pixels(&fb) * pixel_size(kind));
    fb.depth = guarded(pixels(&fb) * sizeof *fb.depth);
    fb.stencil = guarded(pixels(&fb));
    fb.stencil_bits = 8;
    return fb;
}

static inline void framebuffer_check(const struct framebuffer *fb)
{
    guarded_check(fb->color, pixels(fb) * pixel_size(fb->color_kind));
    guarded_check(fb->depth, pixels(fb) * sizeof *fb->depth);
    guarded_check(fb->stencil, pixels(fb));
}

static inline void framebuffer_destroy(struct framebuffer *fb)
{
    guarded_free(fb->color);
    guarded_free(fb->depth);
    guarded_free(fb->stencil);
}

/* The state that rasterization and fragments read, at its initial values. */
static inline void state_defaults(struct server_state *s)
{
    memset(s, 0, sizeof *s);
    s->polygon.cull_face_mode = GL_BACK;
    s->polygon.front_face = GL_CCW;
    s->polygon.polygon_mode[0] = s->polygon.polygon_mode[1] = GL_FILL;
    s->line.line_width = 1.0f;
    s->line.line_stipple_repeat = 1;
    s->line.line_stipple_pattern = 0xffff;
    s->point.point_size = 1.0f;
    s->depth.depth_writemask = true;
    s->depth.depth_func = GL_LESS;
    s->stencil.stencil_func = s->color_buffer.alpha_test_func = GL_ALWAYS;
    s->stencil.stencil_fail = s->stencil.stencil_pass_depth_fail = s->stencil.stencil_pass_depth_pass =
            GL_KEEP;
    s->stencil.stencil_value_mask = s->stencil.stencil_writemask = 255;
    s->color_buffer.blend_src_rgb = s->color_buffer.blend_src_alpha = GL_ONE;
    s->color_buffer.blend_equation[0] = s->color_buffer.blend_equation[1] = GL_FUNC_ADD;
    s->color_buffer.logic_op_mode = GL_COPY;
    s->color_buffer.draw_buffer = GL_FRONT;
    for (int c = 0; c < 4; c++)
        s->color_buffer.color_writemask[c] = true;
    s->fog.fog_mode = GL_EXP;
    s->fog.fog_density = s->fog.fog_end = 1.0f;
}

#endif
