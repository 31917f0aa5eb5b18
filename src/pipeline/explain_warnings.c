/* What a teacher would say about the primitive that made a pixel: the mistakes that lighting programs make,
 * recognised from the plan and the numbers. Each warning is one sentence of what is, and what to do. */
#include "pipeline/explain.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

FGL_PRINTF(2, 3)
static void warn(struct explain_detail *d, const char *format, ...)
{
    va_list arguments;
    if (d->warnings == EXPLAIN_WARNINGS)
        return;
    va_start(arguments, format);
    vsnprintf(d->warning[d->warnings++], EXPLAIN_WARNING_LENGTH, format, arguments);
    va_end(arguments);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool is_black(const float v[4])
{
    return v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f;
}

static int face_of(const struct explain_detail *d)
{
    return d->two_sided && !d->front ? 1 : 0;
}

/* ---- switches ---- */

static void check_switches(struct context *ctx, struct explain_detail *d)
{
    const struct lighting_state *l = &ctx->s.lighting;
    const bool moved = !fgl_matrix_is_identity(fgl_matrix_top(&ctx->modelview));
    int enabled = 0;
    for (int i = 0; i < FGL_MAX_LIGHTS; i++)
        enabled += l->light[i].enabled;
    if (!l->lighting) {
        if (enabled)
            warn(d, "%d light%s enabled, but GL_LIGHTING is not: the colour is glColor's.", enabled,
                 enabled == 1 ? " is" : "s are");
        return;
    }
    if (!enabled)
        warn(d, "GL_LIGHTING is enabled, but no light is: only emission and the scene's ambient light are "
                "left.");
    if (!l->color_material && d->vertex_plan.varying >> ATTR_COLOR & 1)
        warn(d, "glColor is given but has no effect: under GL_LIGHTING it counts only with GL_COLOR_MATERIAL "
                "enabled.");
    for (int i = 0; i < FGL_MAX_LIGHTS; i++) {
        const struct light *light = &l->light[i];
        if (light->enabled && is_black(light->ambient) && is_black(light->diffuse) &&
            is_black(light->specular))
            warn(d, "GL_LIGHT%d is enabled but black%s.", i,
                 i > 0 ? ": only GL_LIGHT0 begins white, the others need glLight" : "");
        if (light->enabled && light->position[3] != 0.0f && light->placed_under_identity && moved)
            warn(d,
                 "GL_LIGHT%d's position was set before gluLookAt or any other modelview command: it is fixed "
                 "to the viewer. "
                 "For a place in the scene, set it after them.",
                 i);
    }
}

static void check_material(const struct server_state *s, struct explain_detail *d)
{
    const struct explain_vertex *v = &d->vertex[d->n - 1];
    if (is_black(v->material[MAT_AMBIENT]) && is_black(v->material[MAT_DIFFUSE]) &&
        is_black(v->material[MAT_SPECULAR]) && is_black(v->material[MAT_EMISSION]))
        warn(d, "The material is black.");
    if (!is_black(v->material[MAT_SPECULAR]) && v->material[MAT_SHININESS][0] == 0.0f)
        warn(d, "The material has a specular colour but GL_SHININESS 0, its initial value: the highlight is "
                "everywhere that light falls.");
    if (!d->front && !d->two_sided)
        warn(d, "This is the back of the polygon, lit as its front: GL_LIGHT_MODEL_TWO_SIDE is not set%s.",
             s->polygon.cull_face ? "" : ", nor GL_CULL_FACE enabled");
}

/* ---- numbers ---- */

static void check_normals(const struct server_state *s, struct explain_detail *d)
{
    const struct explain_vertex *v = &d->vertex[d->n - 1];
    const double length = sqrt(dot(v->trace.normal, v->trace.normal));
    const double given =
            sqrt((double)v->normal[0] * (double)v->normal[0] + (double)v->normal[1] * (double)v->normal[1] +
                 (double)v->normal[2] * (double)v->normal[2]);
    if (!d->vertex_plan.need_normal)
        return;
    if (given == 0.0)
        warn(d, "The normal is zero: no light with a direction can light it.");
    else if (fabs(length - 1.0) > 0.01 && !d->lit)
        warn(d, "A normal of length %.3g with GL_NORMALIZE %s: diffuse light is multiplied by it%s.", length,
             s->transform.normalize ? "on" : "off",
             fabs(given - 1.0) <= 0.01 ? ". It was given with length 1; the modelview matrix scales: enable "
                                         "GL_NORMALIZE or GL_RESCALE_NORMAL"
                                       : "");
    int away = 0;
    for (int i = 0; i < d->n; i++) /* in eye space the viewer is at the origin */
        away += !d->vertex_plan.light.object_space &&
                dot(d->vertex[i].trace.normal, d->vertex[i].trace.eye) > 0;
    if (d->n == 3 && d->front && away == 3)
        warn(d, "The normals face away from the viewer though the polygon's front is seen: are they "
                "reversed, or the vertices' order?");
}

/* What was lit, n of them: the vertices, or the pixel itself. */
static const struct explain_vertex *lit_points(const struct explain_detail *d, int *n)
{
    *n = d->lit ? 1 : d->n;
    return d->lit ? &d->at : d->vertex;
}

static void check_light(struct explain_detail *d, int i)
{
    const struct light_derived *light = &d->vertex_plan.light.light[i];
    int n, behind = 0, outside = 0, faint = 0;
    const struct explain_vertex *v = lit_points(d, &n);
    for (int k = 0; k < n; k++) {
        const struct light_terms *t = &v[k].trace.face[face_of(d)].light[i];
        behind += t->n_dot_VP <= 0;
        outside += t->spot == 0;
        faint += t->attenuation < 1.0 / 255.0;
    }
    if (outside == n)
        warn(d, "GL_LIGHT%d: %s is outside of the spot's cone.", light->number, d->lit ? "the pixel" : "the polygon");
    else if (behind == n)
        warn(d,
             "GL_LIGHT%d is behind the surface (n.VP <= 0 at %s): the normals face away from it, and only "
             "its ambient term is left.",
             light->number, d->lit ? "the pixel" : n == 1 ? "the vertex" : "every vertex");
    if (faint == n)
        warn(d, "GL_LIGHT%d is attenuated to less than 1/255 by its distance.", light->number);
}

static void check_clamping(struct explain_detail *d)
{
    static const char *const channel[] = {"red", "green", "blue"};
    int n;
    const struct explain_vertex *v = lit_points(d, &n);
    for (int k = 0; k < n; k++)
        for (int c = 0; c < 3; c++) {
            const double sum = v[k].trace.face[face_of(d)].sum[c];
            if (sum > 1.0) {
                char where[32] = "the pixel";
                if (!d->lit)
                    snprintf(where, sizeof where, "vertex %d", k);
                warn(d,
                     "Value clamped: the sum of %s at %s is %.3g, more than 1; details in brighter "
                     "parts are lost.",
                     channel[c], where, sum);
                return;
            }
        }
}

/* All lights' specular terms of a face, the brightest channel. */
static double highlight(const struct explain_detail *d, const struct vertex_trace *trace)
{
    double most = 0;
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < d->vertex_plan.light.n; i++)
            sum += trace->face[face_of(d)].light[i].specular[c];
        most = fmax(most, sum);
    }
    return most;
}

static void check_highlight(struct vertex_batch *b, const struct vertex_source *source,
                            struct explain_detail *d)
{
    struct vertex_trace middle;
    double of_vertices = 0;
    if (d->n < 2 || d->flat || d->lit)
        return;
    for (int i = 0; i < d->n; i++)
        of_vertices += d->vertex[i].weight * highlight(d, &d->vertex[i].trace);
    fgl_explain_middle(b, source, d, &middle);
    const double here = fmin(highlight(d, &middle), 1.0);
    if (here - of_vertices > 0.1)
        warn(d,
             "The highlight falls between the vertices: computed here, at the pixel, its specular term would "
             "be %.2g; "
             "interpolated from the vertices it is %.2g. Use more, smaller polygons.",
             here, of_vertices);
}

void fgl_explain_warn(struct context *ctx, const struct vertex_source *source, struct explain_detail *d)
{
    const struct server_state *s = &ctx->s;
    check_switches(ctx, d);
    if (s->lighting.lighting)
        check_normals(s, d);
    if (s->lighting.lighting && !ctx->color_index) {
        check_material(s, d);
        for (int i = 0; i < d->vertex_plan.light.n; i++)
            check_light(d, i);
        check_clamping(d);
        check_highlight(ctx->pipeline->batch[0], source, d);
    }
    if (!d->fragment_plan.depth_test && ctx->framebuffer->depth && ctx->pipeline->explain->draws > 1)
        warn(d, "GL_DEPTH_TEST is off: what is drawn last is seen, even if it is farther away.");
}
