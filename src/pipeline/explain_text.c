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
    fgl_explain_text_pixel(t, &e->after, fb);
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
    if (!table->d->vertex_plan.color_index) {
        ROW(table, "emission", cell3f(table, v->material[MAT_EMISSION]));
        ROW(table, "material's ambient", cell3f(table, v->material[MAT_AMBIENT]));
        label(table, "scene's ambient light");
        cell3f(table, l->model_ambient);
        fgl_text_end_line(table->t);
        ROW(table, "= start of the sum", cell3(table, f->base));
    }
    for (int i = 0; i < l->n; i++)
        light_terms(table, i);
    if (table->d->vertex_plan.color_index) { /* 2.14.5; light is an intensity */
        ROW(table, "diffuse sum d", cell1(table, f->sum[0]));
        ROW(table, "specular sum s", cell1(table, f->specular_sum[0]));
        ROW(table, "GL_COLOR_INDEXES a d s", cell3f(table, v->material[MAT_INDEXES]));
        ROW(table, "= vertex index", cell1(table, (double)v->color[0]));
        return;
    }
    ROW(table, "= sum", cell3(table, f->sum));
    ROW(table, at_pixel ? "clamped: its colour" : "clamped: vertex colour", cell3f(table, v->color));
    ROW(table, "alpha, of the diffuse", cell1(table, (double)v->color[3]));
    if (l->separate_specular)
        ROW(table, "secondary colour", cell3f(table, v->secondary));
}

/* ---- the whole ---- */

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
    else if (d->vertex_plan.color_index)
        ROW(&table, d->vertex_plan.index_is_varying ? "glIndex" : "glIndex, not by vertex", cell1(&table, (double)v->color[0]));
    else
        ROW(&table, d->vertex_plan.color_is_varying ? "glColor, clamped" : "glColor, not by vertex",
            cell3f(&table, v->color));
    fgl_explain_text_fragment(t, d, fb);
}

void fgl_explain_text(struct explain *e, const struct framebuffer *fb, int vertex)
{
    struct text *t = &e->text;
    const struct explain_event *last = fgl_explain_last(e);
    fgl_text_clear(t);
    fgl_text_add(t, "Pixel %d, %d of %d x %d, from the lower left:  ", e->x, e->y, fb->width, fb->height);
    fgl_explain_text_pixel(t, &e->value, fb);
    fgl_text_add(t, "\n");
    if (!e->agrees)
        fgl_text_add(t, "  (!) drawing gave another value than explaining: this is a defect of FixedGL\n");
    if (!last || last->outcome == OUTCOME_CLEARED) {
        const float *c = last ? last->fragment.smoothed : NULL;
        fgl_text_add(t, "Nothing was drawn here. ");
        if (c && fb->color_kind == COLOR_INDEX8)
            fgl_text_add(t, "It is glClear's index, glClearIndex(%g).\n", (double)c[0]);
        else if (c)
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
