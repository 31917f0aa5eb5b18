/* The explanation for programs: JSON, documented in docs/explain.md. Numbers have the digits that bring the
 * same float back. */
#include "pipeline/explain.h"

#include <math.h>

static void number(struct text *t, double v)
{
    if (v - v == 0.0)
        fgl_text_add(t, "%.9g", v);
    else
        fgl_text_add(t, "null"); /* JSON has no NaN and no infinity */
}

static void name(struct text *t, const char *key)
{
    const char last = t->length ? t->data[t->length - 1] : '{';
    fgl_text_add(t, "%s\"%s\":", last == '{' || last == '[' ? "" : ",", key);
}

static void numbers(struct text *t, const char *key, const double *v, int n)
{
    name(t, key);
    for (int i = 0; i < n; i++) {
        fgl_text_add(t, i ? "," : "[");
        number(t, v[i]);
    }
    fgl_text_add(t, "]");
}

static void floats(struct text *t, const char *key, const float *v, int n)
{
    double d[4];
    for (int i = 0; i < n; i++)
        d[i] = (double)v[i];
    numbers(t, key, d, n);
}

static void one(struct text *t, const char *key, double v)
{
    name(t, key);
    number(t, v);
}

static void truth(struct text *t, const char *key, bool v)
{
    name(t, key);
    fgl_text_add(t, v ? "true" : "false");
}

/* s has no character that JSON would want escaped: all texts are the library's own. */
static void string(struct text *t, const char *key, const char *s)
{
    name(t, key);
    fgl_text_add(t, "\"%s\"", s);
}

static void open(struct text *t, const char *key, char bracket)
{
    if (key)
        name(t, key);
    else if (t->length && t->data[t->length - 1] == '}')
        fgl_text_add(t, ",");
    fgl_text_add(t, "%c", bracket);
}

static void close(struct text *t, char bracket)
{
    fgl_text_add(t, "%c", bracket);
}

static void doubles3(struct text *t, const char *key, const double v[3])
{
    const float values[3] = {(float)v[0], (float)v[1], (float)v[2]};
    floats(t, key, values, 3);
}

/* In the order in which the units are applied. */
static void textures(struct text *t, const struct fragment_stages *s)
{
    open(t, "textures", '[');
    for (int i = 0; i < s->textures; i++) {
        const struct texture_trace *trace = &s->texture[i].trace;
        const float texel[4] = {(float)trace->texel[0], (float)trace->texel[1], (float)trace->texel[2], (float)trace->texel[3]};
        open(t, NULL, '{');
        doubles3(t, "coordinate", trace->coordinate);
        one(t, "magnified", trace->magnified);
        one(t, "level", trace->level);
        one(t, "fraction", trace->fraction);
        floats(t, "texel", texel, 4);
        floats(t, "result", s->texture[i].result, 4);
        close(t, '}');
    }
    close(t, ']');
}

static void fragment(struct text *t, const struct fragment_stages *s)
{
    open(t, "fragment", '{');
    floats(t, "interpolated", s->interpolated, 4);
    if (s->textures > 0)
        textures(t, s);
    floats(t, "color_sum", s->summed, 4);
    one(t, "fog_factor", (double)s->fog_factor);
    floats(t, "fogged", s->fogged, 4);
    floats(t, "color", s->smoothed, 4);
    one(t, "depth", s->depth);
    close(t, '}');
}

static void event(struct text *t, const struct explain_event *e)
{
    open(t, NULL, '{');
    string(t, "outcome", fgl_explain_outcome_name(e->outcome));
    numbers(t, "before", e->before.color, 4);
    numbers(t, "after", e->after.color, 4);
    if (e->outcome != OUTCOME_CLEARED && e->outcome != OUTCOME_OTHER) {
        one(t, "draw", e->draw);
        string(t, "call", e->call);
        string(t, "mode", fgl_explain_mode_name(e->mode));
        one(t, "primitive", e->prim);
        one(t, "number", e->number);
        fragment(t, &e->fragment);
    }
    close(t, '}');
}

static void light(struct text *t, const struct light_derived *l, const struct light_terms *terms)
{
    open(t, NULL, '{');
    one(t, "light", l->number);
    numbers(t, "VP", terms->VP, 3);
    if (l->key & LIGHT_POSITIONAL)
        one(t, "distance", terms->distance);
    one(t, "attenuation", terms->attenuation);
    one(t, "spot", terms->spot);
    one(t, "n_dot_VP", terms->n_dot_VP);
    if (l->key & LIGHT_SPECULAR) {
        const bool reflection = l->key & LIGHT_REFLECTION;
        numbers(t, reflection ? "reflection" : "half", terms->half, 3);
        one(t, reflection ? "r_dot_v" : "n_dot_h", terms->n_dot_h);
        one(t, "shininess", terms->shininess);
        one(t, "highlight", terms->highlight);
    }
    numbers(t, "ambient", terms->ambient, 3);
    numbers(t, "diffuse", terms->diffuse, 3);
    numbers(t, "specular", terms->specular, 3);
    close(t, '}');
}

static void lighting(struct text *t, const struct explain_detail *d, const struct explain_vertex *v)
{
    static const char *const parameter[MAT_COUNT] = {"ambient",  "diffuse",   "specular",
                                                     "emission", "shininess", NULL};
    const struct face_trace *f = &v->trace.face[d->two_sided && !d->front ? 1 : 0];
    floats(t, "normal", v->normal, 3);
    numbers(t, "lit_normal", v->trace.normal, 3);
    open(t, "material", '{');
    for (int m = 0; parameter[m]; m++)
        floats(t, parameter[m], v->material[m], m == MAT_SHININESS ? 1 : 4);
    close(t, '}');
    numbers(t, "start", f->base, 3);
    open(t, "lights", '[');
    for (int i = 0; i < d->vertex_plan.light.n; i++)
        light(t, &d->vertex_plan.light.light[i], &f->light[i]);
    close(t, ']');
    numbers(t, "sum", f->sum, 3);
    if (d->vertex_plan.light.separate_specular)
        numbers(t, "specular_sum", f->specular_sum, 3);
}

static void vertex_object(struct text *t, const struct explain_detail *d, const struct explain_vertex *v)
{
    open(t, NULL, '{');
    one(t, "number", v->number);
    one(t, "index", v->index);
    one(t, "weight", v->weight);
    floats(t, "object", v->object, 4);
    numbers(t, "eye", v->trace.eye, 3);
    floats(t, "clip", v->clip, 4);
    floats(t, "window", v->window, 3);
    if (d->vertex_plan.lighting)
        lighting(t, d, v);
    floats(t, "color", v->color, 4);
    if (d->fragment_plan.has_secondary)
        floats(t, "secondary", v->secondary, 3);
    close(t, '}');
}

static void primitive(struct text *t, const struct explain_detail *d, int vertex)
{
    static const char *const source[COLOR_SOURCES] = {
            [COLOR_CONSTANT] = "constant", [COLOR_FLAT] = "flat", [COLOR_SMOOTH] = "smooth", [COLOR_LIT] = "phong"};
    open(t, "made_by", '{');
    one(t, "draw", d->event.draw);
    string(t, "call", d->event.call);
    string(t, "mode", fgl_explain_mode_name(d->event.mode));
    one(t, "primitive", d->event.prim);
    one(t, "number", d->event.number);
    string(t, "face", d->front ? "front" : "back");
    truth(t, "clipped", d->is_clipped);
    string(t, "shading", source[d->fragment_plan.color_source]);
    truth(t, "blended", d->fragment_plan.blend);
    open(t, "vertices", '[');
    for (int i = 0; i < d->n; i++)
        if (vertex < 0 || i == fgl_min(vertex, d->n - 1))
            vertex_object(t, d, &d->vertex[i]);
    close(t, ']');
    if (d->lit) {
        open(t, "lit", '{');
        numbers(t, "eye", d->at.trace.eye, 3);
        lighting(t, d, &d->at);
        close(t, '}');
    }
    fragment(t, &d->event.fragment);
    open(t, "warnings", '[');
    for (int i = 0; i < d->warnings; i++)
        fgl_text_add(t, "%s\"%s\"", i ? "," : "", d->warning[i]);
    close(t, ']');
    close(t, '}');
}

void fgl_explain_json(struct explain *e, const struct framebuffer *fb, int vertex)
{
    struct text *t = &e->text;
    const int kept = fgl_min(e->events, EXPLAIN_EVENTS);
    const double pixel[2] = {e->x, e->y}, size[2] = {fb->width, fb->height};
    fgl_text_clear(t);
    open(t, NULL, '{');
    numbers(t, "pixel", pixel, 2);
    numbers(t, "size", size, 2);
    numbers(t, "color", e->value.color, fb->color_kind == COLOR_INDEX8 ? 1 : fb->color_kind == COLOR_565 ? 3 : 4);
    one(t, "depth", e->value.depth);
    truth(t, "agrees", e->agrees);
    open(t, "events", '[');
    for (int i = 0; i < kept; i++)
        event(t, &e->event[i]);
    close(t, ']');
    if (e->has_detail)
        primitive(t, &e->detail, vertex);
    close(t, '}');
    fgl_text_add(t, "\n");
}
