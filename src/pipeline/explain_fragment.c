/* A fragment's stages, found by running the general fragment kernel on a scratch row: with no stage but
 * interpolation first, then with one more each time. A float buffer keeps colours as they are, neither
 * rounded nor clamped. */
#include "pipeline/explain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SCRATCH_PIXEL = 16 /* bytes: four floats */ };

/* ---- pixels of any framebuffer ---- */

static ptrdiff_t pixel_at(const struct framebuffer *fb, int row, int x)
{
    return (ptrdiff_t)row * fb->stride + x;
}

struct pixel_value fgl_explain_pixel(const struct framebuffer *fb, int row, int x)
{
    const ptrdiff_t at = pixel_at(fb, row, x);
    struct pixel_value v = {
            {0, 0, 0, 0}, fb->depth ? fb->depth[at] : 0, fb->stencil ? fb->stencil[at] : (uint8_t)0};
    const uint16_t half = ((const uint16_t *)fb->color)[fb->color_kind == COLOR_565 ? at : 0];
    for (int c = 0; c < 4; c++)
        switch (fb->color_kind) {
        case COLOR_UNORM8: v.color[c] = ((const uint32_t *)fb->color)[at] >> (8 * c) & 255; break;
        case COLOR_UNORM16: v.color[c] = ((const uint16_t *)fb->color)[4 * at + c]; break;
        case COLOR_FLOAT: v.color[c] = (double)((const float *)fb->color)[4 * at + c]; break;
        case COLOR_565:
            v.color[c] = c == 0 ? half >> 11 : c == 1 ? half >> 5 & 63 : c == 2 ? half & 31 : 0;
            break;
        case COLOR_INDEX8: v.color[c] = c == 0 ? ((const uint8_t *)fb->color)[at] : 0; break;
        }
    return v;
}

void fgl_explain_put_pixel(const struct framebuffer *fb, int row, int x, const struct pixel_value *v)
{
    const ptrdiff_t at = pixel_at(fb, row, x);
    const double *color = v->color;
    switch (fb->color_kind) {
    case COLOR_UNORM8:
        ((uint32_t *)fb->color)[at] = (uint32_t)color[0] | (uint32_t)color[1] << 8 |
                                      (uint32_t)color[2] << 16 | (uint32_t)color[3] << 24;
        break;
    case COLOR_INDEX8: ((uint8_t *)fb->color)[at] = (uint8_t)color[0]; break;
    case COLOR_UNORM16:
        for (int c = 0; c < 4; c++)
            ((uint16_t *)fb->color)[4 * at + c] = (uint16_t)color[c];
        break;
    case COLOR_FLOAT:
        for (int c = 0; c < 4; c++)
            ((float *)fb->color)[4 * at + c] = (float)color[c];
        break;
    case COLOR_565:
        ((uint16_t *)fb->color)[at] =
                (uint16_t)((unsigned)color[0] << 11 | (unsigned)color[1] << 5 | (unsigned)color[2]);
        break;
    }
    if (fb->depth)
        fb->depth[at] = v->depth;
    if (fb->stencil)
        fb->stencil[at] = v->stencil;
}

bool fgl_explain_same(const struct pixel_value *a, const struct pixel_value *b)
{
    return memcmp(a->color, b->color, sizeof a->color) == 0 && a->depth == b->depth &&
           a->stencil == b->stencil;
}

/* ---- the scratch row ---- */

bool fgl_explain_scratch(struct scratch *s, const struct framebuffer *fb)
{
    if (s->room < fb->stride) {
        const size_t n = (size_t)fb->stride;
        void *color = realloc(s->fb.color, n * SCRATCH_PIXEL);
        s->fb.color = color ? color : s->fb.color;
        uint32_t *depth = realloc(s->fb.depth, n * sizeof *depth);
        s->fb.depth = depth ? depth : s->fb.depth;
        uint8_t *stencil = realloc(s->fb.stencil, n);
        s->fb.stencil = stencil ? stencil : s->fb.stencil;
        if (!color || !depth || !stencil)
            return false;
        memset(color, 0, n * SCRATCH_PIXEL);
        memset(depth, 0, n * sizeof *depth);
        memset(stencil, 0, n);
        s->room = fb->stride;
    }
    s->indexed = fb->color_kind == COLOR_INDEX8;
    s->fb.width = fb->width;
    s->fb.height = fb->height;
    s->fb.y_up = fb->y_up;
    s->fb.stride = 0; /* every row is this one */
    s->fb.has_alpha = true;
    s->fb.depth_bits = fb->depth_bits ? fb->depth_bits : 24;
    s->fb.depth_max = fb->depth_bits ? fb->depth_max : 0xffffff;
    return true;
}

static void run(struct scratch *s, struct fragment_plan *plan, enum color_kind kind,
                const struct planes *planes, int row, int x)
{
    struct runs runs = {.y = row, .n = 1};
    runs.x0[0] = x;
    runs.x1[0] = x + 1;
    s->fb.color_kind = kind;
    plan->fb = &s->fb;
    plan->general(plan, planes, &runs);
}

/* The plan with nothing but interpolation. */
static struct fragment_plan bare_plan(const struct fragment_plan *plan)
{
    struct fragment_plan f = *plan;
    f.textures = 0;
    f.has_secondary = f.has_fog = f.alpha_test = f.depth_test = f.depth_write = f.stencil_test = f.blend =
            f.logic_op = false;
    f.color_write = true;
    for (int c = 0; c < 4; c++)
        f.channel_write[c] = true;
    f.color_buffer.index_writemask = ~0u;
    return f;
}

/* The index of a fragment as it would be written. Whether it is left out is seen by what was there before. */
static bool index_of(struct scratch *s, struct fragment_plan *f, const struct planes *planes, int row, int x,
                     float color[4])
{
    uint8_t *pixel = (uint8_t *)s->fb.color + x, after[2];
    for (int before = 0; before < 2; before++) {
        *pixel = (uint8_t)before;
        run(s, f, COLOR_INDEX8, planes, row, x);
        after[before] = *pixel;
    }
    color[0] = (float)after[0];
    color[1] = color[2] = color[3] = 0;
    return after[0] == after[1];
}

/* The colour of the fragment; false when it is left out. */
static bool color_of(struct scratch *s, struct fragment_plan *f, const struct planes *planes, int row, int x,
                     float color[4])
{
    float *pixel = (float *)s->fb.color + 4 * x;
    if (f->general == fgl_fragment_kernels(f->arith)->index)
        return index_of(s, f, planes, row, x, color);
    pixel[0] = pixel[1] = pixel[2] = pixel[3] = -1e30f; /* no stage makes such a colour */
    run(s, f, COLOR_FLOAT, planes, row, x);
    if (pixel[0] == -1e30f && pixel[3] == -1e30f)
        return false;
    memcpy(color, pixel, 4 * sizeof *color);
    return true;
}

void fgl_explain_color(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes,
                       int row, int x, float color[4])
{
    struct fragment_plan f = bare_plan(plan);
    f.color_source = COLOR_SMOOTH;
    f.general = fgl_fragment_kernels(f.arith)->general; /* whatever the mode */
    color_of(s, &f, planes, row, x, color);
}

/* A light_fragments_fn between the fragment kernel and the plan's lights, which notes. */
struct noting {
    const struct vertex_plan *plan;
    struct vertex_trace *trace;
};

static void note_lights(const void *lights, struct lit_fragments *f)
{
    const struct noting *noting = lights;
    struct vertex_trace *to = noting->trace;
    double square = 0;
    for (int c = 0; c < 3; c++) {
        to->eye[c] = noting->plan->need_eye ? f->eye[c][0] : 0;
        square += f->normal[c][0] * f->normal[c][0];
    }
    for (int c = 0; c < 3; c++)
        to->normal[c] = square > 0 ? f->normal[c][0] / sqrt(square) : 0;
    fgl_vertex_trace_fragment(noting->plan, f, &to->face[noting->plan->light.two_sided && f->back]);
}

void fgl_explain_lit(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes, int row, int x,
                     struct vertex_trace *trace)
{
    const struct noting noting = {plan->lit.lights, trace};
    struct fragment_plan f = bare_plan(plan);
    float color[4];
    memset(trace, 0, sizeof *trace);
    f.lit.light = note_lights;
    f.lit.lights = &noting;
    color_of(s, &f, planes, row, x, color);
}

/* Fog alone: what a white fragment keeps of itself in black fog. */
static float fog_factor(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes,
                        int row, int x)
{
    struct fragment_plan f = *plan;
    float color[4] = {1, 1, 1, 1};
    f.color_source = COLOR_CONSTANT;
    f.general = fgl_fragment_kernels(f.arith)->general;
    f.has_secondary = false;
    f.textures = 0;
    for (int c = 0; c < 4; c++) {
        f.constant_color[c] = 1.0f;
        f.fog_color[c] = 0.0f;
    }
    color_of(s, &f, planes, row, x, color);
    return color[0];
}

/* Whether the tests of the plan other than that of depth let the fragment live: then it writes its depth,
 * which *depth receives. */
static bool lives(struct scratch *s, struct fragment_plan f, enum color_kind kind,
                  const struct planes *planes, int row, int x, uint32_t *depth)
{
    const uint32_t none = 0xffffffff;
    f.depth_test = f.depth_write = true;
    f.depth_func = GL_ALWAYS;
    s->fb.depth[x] = none;
    run(s, &f, kind, planes, row, x);
    if (s->fb.depth[x] == none)
        return false;
    *depth = s->fb.depth[x];
    return true;
}

static enum explain_outcome outcome_of(struct scratch *s, const struct fragment_plan *plan,
                                       const struct planes *planes, int row, int x, struct fragment_plan f,
                                       uint32_t *depth)
{
    const struct framebuffer *fb = plan->fb;
    float color[4];
    lives(s, f, COLOR_FLOAT, planes, row, x, depth);
    f.alpha_test = plan->alpha_test;
    if (!lives(s, f, fb->color_kind, planes, row, x, depth))
        return OUTCOME_ALPHA;
    f.stencil_test = plan->stencil_test;
    if (fb->stencil)
        s->fb.stencil[x] = fb->stencil[pixel_at(fb, row, x)];
    if (!lives(s, f, fb->color_kind, planes, row, x, depth))
        return OUTCOME_STENCIL;
    f.alpha_test = f.stencil_test = false;
    f.depth_test = plan->depth_test;
    if (plan->depth_test)
        s->fb.depth[x] = fb->depth[pixel_at(fb, row, x)];
    if (!color_of(s, &f, planes, row, x, color))
        return OUTCOME_DEPTH;
    return plan->color_write ? OUTCOME_DRAWN : OUTCOME_MASKED;
}

/* Color index mode: the index before it is rounded, and which index is written. */
static void index_stages(struct scratch *s, struct fragment_plan *f, const struct fragment_plan *plan,
                         const struct planes *unsmoothed, const struct planes *planes, int row, int x, struct fragment_stages *to)
{
    struct fragment_plan exact = *f;
    exact.general = fgl_fragment_kernels(f->arith)->general;
    color_of(s, &exact, unsmoothed, row, x, to->interpolated);
    to->interpolated[1] = to->interpolated[2] = to->interpolated[3] = 0;
    memcpy(to->summed, to->interpolated, sizeof to->summed);
    memcpy(to->fogged, to->interpolated, sizeof to->fogged);
    f->has_fog = plan->has_fog;
    to->covered = color_of(s, f, unsmoothed, row, x, f->has_fog ? to->fogged : to->smoothed);
    to->fog_factor = f->has_fog ? fog_factor(s, f, unsmoothed, row, x) : 1.0f;
    to->covered = color_of(s, f, planes, row, x, to->smoothed) && to->covered;
}

static void color_stages(struct scratch *s, struct fragment_plan *f, const struct fragment_plan *plan,
                         const struct planes *unsmoothed, const struct planes *planes, int row, int x, struct fragment_stages *to)
{
    to->covered = color_of(s, f, unsmoothed, row, x, to->interpolated);
    to->textures = plan->textures;
    for (f->textures = 0; f->textures < plan->textures;) {
        struct explained_texture *texture = &to->texture[f->textures];
        fgl_fragment_kernels(plan->arith)->trace_texture(plan, unsmoothed, f->textures++, row, x, &texture->trace);
        color_of(s, f, unsmoothed, row, x, texture->result);
    }
    f->has_secondary = plan->has_secondary;
    color_of(s, f, unsmoothed, row, x, to->summed);
    f->has_fog = plan->has_fog;
    color_of(s, f, unsmoothed, row, x, to->fogged);
    to->fog_factor = plan->has_fog ? fog_factor(s, f, unsmoothed, row, x) : 1.0f;
    to->covered = color_of(s, f, planes, row, x, to->smoothed) && to->covered;
}

void fgl_explain_stages(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes,
                        int row, int x, struct fragment_stages *to)
{
    struct fragment_plan f = bare_plan(plan);
    struct planes unsmoothed = *planes;
    memset(to, 0, sizeof *to);
    unsmoothed.smoothing = SMOOTH_NONE;
    (s->indexed ? index_stages : color_stages)(s, &f, plan, &unsmoothed, planes, row, x, to);
    if (to->covered)
        to->outcome = outcome_of(s, plan, planes, row, x, f, &to->depth);
}
