/* The explanation for reading: from the primitive to the byte, a column for each vertex, a row for each term.
 */
#include "pipeline/explain.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *fgl_explain_mode_name(GLenum mode)
{
    static const char *const name[] = {
            "GL_POINTS",         "GL_LINES",        "GL_LINE_LOOP", "GL_LINE_STRIP", "GL_TRIANGLES",
            "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUADS",     "GL_QUAD_STRIP", "GL_POLYGON"};
    return mode <= GL_POLYGON ? name[mode] : "";
}

const char *fgl_explain_outcome_name(enum explain_outcome outcome)
{
    static const char *const name[] = {
            "drawn",  "failed alpha test", "failed stencil test", "failed depth test", "masked", "cleared",
            "changed"};
    return name[outcome];
}

/* What a primitive is made of. */
static const char *part_name(GLenum mode)
{
    static const char *const name[] = {"point",    "line",     "line", "line", "triangle",
                                       "triangle", "triangle", "quad", "quad", "polygon"};
    return mode <= GL_POLYGON ? name[mode] : "";
}

/* ---- one line each ---- */

static void pixel_color(struct text *t, const struct pixel_value *v, const struct framebuffer *fb)
{
    for (int c = 0; c < (fb->color_kind == COLOR_565 ? 3 : 4); c++) {
        fgl_text_add(t, "%s", c ? " " : "");
        fgl_text_add(t, fb->color_kind == COLOR_FLOAT ? "%.6g" : "%.0f", v->color[c]);
    }
}

static void event_line(struct text *t, const struct explain_event *e, const struct framebuffer *fb)
{
    char what[80];
    if (e->outcome == OUTCOME_CLEARED)
        snprintf(what, sizeof what, "glClear");
    else if (e->outcome == OUTCOME_OTHER)
        snprintf(what, sizeof what, "pixels, a bitmap or the like");
    else
        snprintf(what, sizeof what, "draw %d: %s %d of %s, %s %d", e->draw, e->call, e->prim + 1,
                 fgl_explain_mode_name(e->mode), part_name(e->mode), e->number);
    fgl_text_add(t, "  %-64s %-20s ", what, fgl_explain_outcome_name(e->outcome));
    pixel_color(t, &e->after, fb);
    fgl_text_add(t, "\n");
}

static void events(const struct explain *e, struct text *t, const struct framebuffer *fb)
{
    enum { SHOWN = 12 };
    const int kept = fgl_min(e->events, EXPLAIN_EVENTS);
    fgl_text_add(t, "\nWhat happened at the pixel                                          and the colour "
                    "after it\n");
    for (int i = 0; i < kept; i++) {
        if (i == SHOWN - 1 && kept > SHOWN) {
            fgl_text_add(t, "  ... %d more ...\n", e->events - SHOWN);
            i = kept - 1;
        }
        event_line(t, &e->event[i], fb);
    }
}

/* ---- the table of vertices ---- */

struct table {
    struct text *t;
    const struct explain_detail *d;
    int first, last; /* vertices shown */
    int face;
    const struct explain_vertex *vertex; /* the vertices, or the pixel where that is what is lit */
};

FGL_PRINTF(2, 3)
static void label(const struct table *table, const char *format, ...)
{
    char text[64];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fgl_text_add(table->t, "  %-26s", text);
}

static void cell1(const struct table *table, double v)
{
    fgl_text_add(table->t, "%9.4f%18s", v, "");
}

static void cell3(const struct table *table, const double v[3])
{
    fgl_text_add(table->t, "%9.4f%8.4f%8.4f  ", v[0], v[1], v[2]);
}

static void cell3f(const struct table *table, const float v[3])
{
    const double d[3] = {(double)v[0], (double)v[1], (double)v[2]};
    cell3(table, d);
}

/* A row: for each vertex shown, v is the vertex and f its face's terms. */
#define ROW(table, name, cell)                                                                               \
    do {                                                                                                     \
        label(table, "%s", name);                                                                            \
        for (int k = (table)->first; k <= (table)->last; k++) {                                              \
            const struct explain_vertex *v = &(table)->vertex[k];                                          \
            const struct face_trace *f = &v->trace.face[(table)->face];                                      \
            (void)f;                                                                                         \
            cell;                                                                                            \
        }                                                                                                    \
        fgl_text_end_line((table)->t);                                                                       \
    } while (0)

static void heading(const struct table *table)
{
    fgl_text_add(table->t, "\n%-28s", "Vertices");
    for (int k = table->first; k <= table->last; k++) {
        char title[64];
        snprintf(title, sizeof title, "vertex %d: number %d", k, table->d->vertex[k].number);
        fgl_text_add(table->t, "   %-24s", title);
    }
    fgl_text_end_line(table->t);
}

static void coordinates(const struct table *table)
{
    heading(table);
    ROW(table, "weight at the pixel", cell1(table, v->weight));
    ROW(table, "object coordinates", cell3f(table, v->object));
    ROW(table, "eye coordinates", cell3(table, v->trace.eye));
    ROW(table, "clip coordinates x y z", cell3f(table, v->clip));
    ROW(table, "                 w", cell1(table, (double)v->clip[3]));
    ROW(table, "window coordinates",
        fgl_text_add(table->t, "%9.2f%8.2f%8.4f  ", (double)v->window[0], (double)v->window[1],
                     (double)v->window[2]));
    if (table->d->vertex_plan.need_normal) {
        ROW(table, "normal as given", cell3f(table, v->normal));
        ROW(table,
            table->d->vertex_plan.normal_in_eye_space ? "normal n, eye space" : "normal n, object space",
            cell3(table, v->trace.normal));
    }
}

static void light_heading(const struct table *table, const struct light_derived *l)
{
    const unsigned k = l->key;
    struct text *t = table->t;
    fgl_text_add(t, "  GL_LIGHT%d, %s%s%s%s\n", l->number,
                 k & LIGHT_POSITIONAL ? "positional" : "directional",
                 k & LIGHT_ATTENUATED ? ", attenuated" : "", k & LIGHT_SPOT ? ", spot" : "",
                 k & LIGHT_SPECULAR ? k & LIGHT_LOCAL_VIEWER ? ", local viewer" : ""
                                    : ", no highlight: light or material has no specular colour");
    if (!(k & LIGHT_VARYING)) {
        static const char *const name[COLOR_COUNT] = {"ambient", "diffuse", "specular"};
        fgl_text_add(t, "    light x material:");
        for (int color = 0; color < COLOR_COUNT; color++) {
            const float *p = l->product[table->face][color];
            fgl_text_add(t, "  %s %.4g %.4g %.4g", name[color], (double)p[0], (double)p[1], (double)p[2]);
        }
        fgl_text_add(t, "\n");
    }
    if (k & LIGHT_ATTENUATED)
        fgl_text_add(t, "    attenuation = 1 / (%.4g + %.4g d + %.4g d^2)\n", (double)l->k0, (double)l->k1,
                     (double)l->k2);
    if (k & LIGHT_SPOT)
        fgl_text_add(t, "    spot = c^%.4g where c, the cosine from the spot's axis, is above %.4f; else 0\n",
                     (double)l->spot_exponent, (double)l->cos_cutoff);
}

static void light_terms(const struct table *table, int i)
{
    const struct light_derived *l = &table->d->vertex_plan.light.light[i];
    light_heading(table, l);
    ROW(table, "  VP, towards the light", cell3(table, f->light[i].VP));
    if (l->key & LIGHT_POSITIONAL)
        ROW(table, "  d, its distance", cell1(table, f->light[i].distance));
    if (l->key & LIGHT_ATTENUATED)
        ROW(table, "  attenuation", cell1(table, f->light[i].attenuation));
    if (l->key & LIGHT_SPOT) {
        ROW(table, "  c, cosine from the axis", cell1(table, f->light[i].spot_cosine));
        ROW(table, "  spot", cell1(table, f->light[i].spot));
    }
    ROW(table, "  n.VP", cell1(table, f->light[i].n_dot_VP));
    if (l->key & LIGHT_SPECULAR) {
        const bool r = l->key & LIGHT_REFLECTION;
        ROW(table, r ? "  r, VP reflected at n" : "  h, half vector", cell3(table, f->light[i].half));
        ROW(table, r ? "  r.v, v to the viewer" : "  n.h", cell1(table, f->light[i].n_dot_h));
        ROW(table, "  s, shininess", cell1(table, f->light[i].shininess));
        ROW(table, r ? "  (r.v)^s, 0 if n.VP <= 0" : "  (n.h)^s, 0 if n.VP <= 0", cell1(table, f->light[i].highlight));
    }
    ROW(table, "  + ambient", cell3(table, f->light[i].ambient));
    ROW(table, "  + diffuse", cell3(table, f->light[i].diffuse));
    if (l->key & LIGHT_SPECULAR)
        ROW(table, l->key & LIGHT_SEPARATE ? "  specular, kept apart" : "  + specular",
            cell3(table, f->light[i].specular));
}

static void lighting(const struct table *table)
{
    const struct lighting_plan *l = &table->d->vertex_plan.light;
    const bool at_pixel = table->vertex == &table->d->at;
    fgl_text_add(table->t, "\nLighting (GL 1.5, 2.14.1)%s, %s face, %s viewer, in %s space\n",
                 at_pixel ? " of the pixel itself" : "", table->face ? "back" : "front", l->local_viewer ? "local" : "infinite",
                 l->object_space ? "object" : "eye");
    fgl_text_add(table->t, "  emission + scene x ambient + sum over the lights of\n"
                           "      attenuation spot (ambient + max(n.VP, 0) diffuse + (%s)^s specular)\n",
                 l->specular_vector ? "r.v" : "n.h");
    if (at_pixel) {
        ROW(table, "n, interpolated, length 1", cell3(table, v->trace.normal));
        if (table->d->vertex_plan.need_eye)
            ROW(table, "eye coordinates", cell3(table, v->trace.eye));
    }
    ROW(table, "emission", cell3f(table, v->material[MAT_EMISSION]));
    ROW(table, "material's ambient", cell3f(table, v->material[MAT_AMBIENT]));
    label(table, "scene's ambient light");
    cell3f(table, l->model_ambient);
    fgl_text_end_line(table->t);
    ROW(table, "= start of the sum", cell3(table, f->base));
    for (int i = 0; i < l->n; i++)
        light_terms(table, i);
    ROW(table, "= sum", cell3(table, f->sum));
    ROW(table, at_pixel ? "clamped: its colour" : "clamped: vertex colour", cell3f(table, v->color));
    ROW(table, "alpha, of the diffuse", cell1(table, (double)v->color[3]));
    if (l->separate_specular)
        ROW(table, "secondary colour", cell3f(table, v->secondary));
}

/* ---- the pixel ---- */

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
        pixel_color(t, &d->event.before, fb);
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
    pixel_color(t, &d->event.after, fb);
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
    static const char *const targets[TEXTURE_TARGETS] = {"1D", "2D", "3D", "cube map"};
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

static void fragment(struct text *t, const struct explain_detail *d, const struct framebuffer *fb)
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
    if (fb->depth)
        fgl_text_add(t, "  %-26s%9.6f            %u of %u, was %u%s\n", "depth",
                     (double)s->depth / (double)fb->depth_max, s->depth, fb->depth_max, d->event.before.depth,
                     f->depth_test ? "" : "; GL_DEPTH_TEST is off");
    writing(t, d, fb);
}

static void detail(const struct explain *e, struct text *t, const struct framebuffer *fb, int vertex)
{
    const struct explain_detail *d = &e->detail;
    struct table table = {t, d, 0, d->n - 1, d->two_sided && !d->front ? 1 : 0, d->vertex};
    const struct table pixel = {t, d, 0, 0, table.face, &d->at};
    const struct explain_event *last = &d->event;
    if (vertex >= 0)
        table.first = table.last = fgl_min(vertex, d->n - 1);
    fgl_text_add(t, "\nMade by draw %d, %s %d of %s: %s %d%s%s%s\n", last->draw, last->call, last->prim + 1,
                 fgl_explain_mode_name(last->mode), part_name(last->mode), last->number,
                 d->n == 3 ? last->mode >= GL_QUADS ? ", the triangle below" : "" : "",
                 d->n == 3 ? d->front ? ", front" : ", back" : "", d->is_clipped ? ", clipped" : "");
    for (int i = 0; i < d->warnings; i++)
        fgl_text_add(t, "%s  ! %s\n", i ? "" : "\nNote\n", d->warning[i]);
    coordinates(&table);
    if (d->vertex_plan.lighting)
        lighting(d->lit ? &pixel : &table);
    else
        ROW(&table, d->vertex_plan.color_is_varying ? "glColor, clamped" : "glColor, not by vertex",
            cell3f(&table, v->color));
    fragment(t, d, fb);
}

void fgl_explain_text(struct explain *e, const struct framebuffer *fb, int vertex)
{
    struct text *t = &e->text;
    const struct explain_event *last = fgl_explain_last(e);
    fgl_text_clear(t);
    fgl_text_add(t, "Pixel %d, %d of %d x %d, from the lower left:  ", e->x, e->y, fb->width, fb->height);
    pixel_color(t, &e->value, fb);
    fgl_text_add(t, "\n");
    if (!e->agrees)
        fgl_text_add(t, "  (!) drawing gave another value than explaining: this is a defect of FixedGL\n");
    if (!last || last->outcome == OUTCOME_CLEARED) {
        const float *c = last ? last->fragment.smoothed : NULL;
        fgl_text_add(t, "Nothing was drawn here. ");
        if (c)
            fgl_text_add(t, "It is glClear's colour, glClearColor(%g, %g, %g, %g).\n", (double)c[0],
                         (double)c[1], (double)c[2], (double)c[3]);
        else
            fgl_text_add(t, "Nor was it cleared.\n");
    } else if (last->outcome == OUTCOME_OTHER) {
        fgl_text_add(t, "It was changed by a command that draws no primitive: glDrawPixels, glCopyPixels, "
                        "glBitmap or glAccum.\n");
    }
    if (e->events)
        events(e, t, fb);
    if (e->has_detail)
        detail(e, t, fb, vertex);
}
