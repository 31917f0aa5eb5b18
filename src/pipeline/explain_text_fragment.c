/* The second half of the explanation for reading: the fragment, from its interpolated colour to the pixel. */
#include "base/color_index.h"
#include "pipeline/explain.h"

#include <stdio.h>
#include <string.h>

void fgl_explain_text_pixel(struct text *t, const struct pixel_value *v, const struct framebuffer *fb)
{
    const int n = fb->color_kind == COLOR_INDEX8 ? 1 : fb->color_kind == COLOR_565 ? 3 : 4;
    for (int c = 0; c < n; c++) {
        fgl_text_add(t, "%s", c ? " " : "");
        fgl_text_add(t, fb->color_kind == COLOR_FLOAT ? "%.6g" : "%.0f", v->color[c]);
    }
}

static void color_line(struct text *t, const char *name, const float v[4], const char *note)
{
    fgl_text_add(t, "  %-26s%9.4f%8.4f%8.4f%8.4f  %s\n", name, (double)v[0], (double)v[1], (double)v[2],
                 (double)v[3], note);
}

static const char *factor_name(GLenum f)
{
    static const char *const name[] = {"src colour",    "1 - src colour", "src alpha",
                                       "1 - src alpha", "dst alpha",      "1 - dst alpha",
                                       "dst colour",    "1 - dst colour", "min(src alpha, 1 - dst alpha)"};
    static const char *const constant[] = {"constant", "1 - constant", "constant alpha",
                                           "1 - constant alpha"};
    if (f <= GL_ONE)
        return f == GL_ONE ? "1" : "0";
    if (f >= GL_SRC_COLOR && f <= GL_SRC_ALPHA_SATURATE)
        return name[f - GL_SRC_COLOR];
    return f >= GL_CONSTANT_COLOR && f <= GL_ONE_MINUS_CONSTANT_ALPHA ? constant[f - GL_CONSTANT_COLOR] : "?";
}

static void writing(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
{
    const struct color_buffer_state *c = &d->fragment_plan.color_buffer;
    const bool *write = d->fragment_plan.channel_write;
    const double max = fb->color_kind == COLOR_UNORM8 ? 255 : fb->color_kind == COLOR_UNORM16 ? 65535 : 0;
    const float *color = d->event.fragment.smoothed;
    if (max > 0)
        fgl_text_add(t, "  x %-24.0f%9.2f%8.2f%8.2f%8.2f  clamped to 0..1 before, then rounded\n", max,
                     max * (double)fgl_clamp01(color[0]), max * (double)fgl_clamp01(color[1]),
                     max * (double)fgl_clamp01(color[2]), max * (double)fgl_clamp01(color[3]));
    if (d->fragment_plan.blend || d->fragment_plan.logic_op ||
        !(write[0] && write[1] && write[2] && write[3])) {
        fgl_text_add(t, "  %-26s ", "was in the framebuffer");
        fgl_explain_text_pixel(t, &d->event.before, fb);
        fgl_text_add(t, "\n");
    }
    if (d->fragment_plan.blend)
        fgl_text_add(
                t, "  blended                    src x (%s) + dst x (%s); alpha: src x (%s) + dst x (%s)%s\n",
                factor_name(c->blend_src_rgb), factor_name(c->blend_dst_rgb), factor_name(c->blend_src_alpha),
                factor_name(c->blend_dst_alpha),
                c->blend_equation[0] == GL_FUNC_ADD ? "" : ", by another blend equation than addition");
    if (d->fragment_plan.logic_op)
        fgl_text_add(t, "  logical operation          0x%04x\n", c->logic_op_mode);
    if (!(write[0] && write[1] && write[2] && write[3]))
        fgl_text_add(t, "  written channels           %s%s%s%s\n", write[0] ? "red " : "",
                     write[1] ? "green " : "", write[2] ? "blue " : "", write[3] ? "alpha" : "");
    fgl_text_add(t, "  = the pixel                ");
    fgl_explain_text_pixel(t, &d->event.after, fb);
    fgl_text_add(t, "\n");
}

static const char *environment_name(const struct texture_environment *e)
{
    static const struct {
        GLenum mode;
        const char *name;
    } names[] = {{GL_MODULATE, "modulated"}, {GL_REPLACE, "replaced"}, {GL_DECAL, "decal"}, {GL_BLEND, "blended"},
                 {GL_ADD, "added"}};
    for (size_t i = 0; i < FGL_COUNTOF(names); i++)
        if (e->mode == names[i].mode)
            return names[i].name;
    return "combined";
}

/* Two lines for each unit: the texel, where and in which images it was found, and what the environment made of it. */
static void texture_lines(struct text *t, const struct fragment_stages *s, const struct fragment_plan *f)
{
    static const char *const targets[TEXTURE_TARGETS] = {"1D", "2D", "rectangle", "3D", "cube map"};
    for (int i = 0; i < s->textures; i++) {
        const struct texture_trace *trace = &s->texture[i].trace;
        const float texel[4] = {(float)trace->texel[0], (float)trace->texel[1], (float)trace->texel[2], (float)trace->texel[3]};
        char note[160], level[64] = "magnified";
        if (!f->texture[i].sampler.needs_lod)
            snprintf(level, sizeof level, "one filter");
        else if (!trace->magnified)
            snprintf(level, sizeof level, "level %d%s%.3f", trace->level, trace->fraction > 0 ? " and " : " + ", trace->fraction);
        snprintf(note, sizeof note, "unit %d, %s (3.8): s t r = %.5g %.5g %.5g, %s", f->texture[i].unit,
                 targets[f->texture[i].sampler.target], trace->coordinate[0], trace->coordinate[1], trace->coordinate[2], level);
        color_line(t, "texel", texel, note);
        color_line(t, environment_name(&f->texture[i].environment), s->texture[i].result, "texture environment (3.8.13)");
    }
}

static void depth_line(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
{
    const uint32_t depth = d->event.fragment.depth;
    if (fb->depth)
        fgl_text_add(t, "  %-26s%9.6f            %u of %u, was %u%s\n", "depth", (double)depth / (double)fb->depth_max, depth,
                     fb->depth_max, d->event.before.depth, d->fragment_plan.depth_test ? "" : "; GL_DEPTH_TEST is off");
}

static void color_fragment(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
{
    const struct fragment_stages *s = &d->event.fragment;
    const struct fragment_plan *f = &d->fragment_plan;
    static const char *const source[COLOR_SOURCES] = {
            [COLOR_CONSTANT] = "the current colour, one for the whole draw",
            [COLOR_FLAT] = "flat: the colour of the last vertex",
            [COLOR_SMOOTH] = "the sum of weight x vertex colour",
            [COLOR_LIT] = "GL_PHONG_WIN: lit here, as above"};
    char note[96];
    fgl_text_add(t, "\n%-28s%9s%8s%8s%8s\n", "Fragment", "red", "green", "blue", "alpha");
    color_line(t, "colour", s->interpolated, source[f->color_source]);
    texture_lines(t, s, f);
    if (f->has_secondary)
        color_line(t, "+ secondary colour", s->summed, "colour sum (3.9)");
    if (f->has_fog) {
        snprintf(note, sizeof note, "fog (3.10): factor f = %.4f, fog colour %.3g %.3g %.3g",
                 (double)s->fog_factor, (double)f->fog_color[0], (double)f->fog_color[1],
                 (double)f->fog_color[2]);
        color_line(t, "f x colour + (1-f) x fog", s->fogged, note);
    }
    if (memcmp(s->smoothed, s->fogged, sizeof s->smoothed) != 0)
        color_line(t, "x coverage", s->smoothed, "antialiasing (3.3, 3.4)");
    depth_line(t, d, fb);
    writing(t, d, fb);
}

static void index_line(struct text *t, const char *name, float index, const char *note)
{
    fgl_text_add(t, "  %-26s%9.4f  %s\n", name, (double)index, note);
}

static void index_fragment(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
{
    const struct fragment_stages *s = &d->event.fragment;
    const struct fragment_plan *f = &d->fragment_plan;
    const unsigned mask = f->color_buffer.index_writemask & FGL_INDEX_MAX;
    static const char *const source[COLOR_SOURCES] = {[COLOR_CONSTANT] = "the current index, one for the whole draw",
                                                      [COLOR_FLAT] = "flat: the index of the last vertex",
                                                      [COLOR_SMOOTH] = "the sum of weight x vertex index"};
    char note[96];
    fgl_text_add(t, "\n%-28s%9s\n", "Fragment", "index");
    index_line(t, "index", s->interpolated[0], source[f->color_source]);
    if (f->has_fog) {
        snprintf(note, sizeof note, "fog (3.10): factor f = %.4f, fog index %.4g", (double)s->fog_factor, (double)f->fog_index);
        index_line(t, "index + (1-f) x fog index", s->fogged[0], note);
    }
    index_line(t, "rounded", s->smoothed[0], "its low four bits are the coverage where it is smoothed (3.2)");
    depth_line(t, d, fb);
    if (f->logic_op)
        fgl_text_add(t, "  logical operation          0x%04x, was %.0f\n", f->color_buffer.logic_op_mode, d->event.before.color[0]);
    if (mask != FGL_INDEX_MAX)
        fgl_text_add(t, "  written bits               0x%02x, was %.0f\n", mask, d->event.before.color[0]);
    fgl_text_add(t, "  = the pixel                ");
    fgl_explain_text_pixel(t, &d->event.after, fb);
    fgl_text_add(t, "\n");
}

void fgl_explain_text_fragment(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
{
    (d->vertex_plan.color_index ? index_fragment : color_fragment)(t, d, fb);
}
