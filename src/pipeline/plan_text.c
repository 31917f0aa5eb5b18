/* The plan in words: the stages that a draw runs, and those that it leaves out because the scene does not
 * require them. */
#include "pipeline/plan_report.h"

#include "fixedgl.h"

#include <stdio.h>

static const char *const comparison[] = {"GL_NEVER",   "GL_LESS",     "GL_EQUAL",  "GL_LEQUAL",
                                         "GL_GREATER", "GL_NOTEQUAL", "GL_GEQUAL", "GL_ALWAYS"};

/* ---- what is done ---- */

static void describe_attributes(struct text *t, uint32_t varying, uint32_t fetched)
{
    static const char *const name[ATTR_MATERIAL] = {
            "position", "normal", "colour", "secondary colour", "fog coordinate", "index", "edge flag"};
    const char *separator = "";
    fgl_text_add(t, "  fetch       ");
    for (int a = 0; a < ATTR_COUNT; a++)
        if (varying >> a & fetched >> a & 1) {
            fgl_text_add(t, "%s%s", separator,
                         a >= ATTR_MATERIAL ? "material"
                         : name[a]          ? name[a]
                                            : "texture coordinates");
            separator = ", ";
        }
    fgl_text_add(t, "\n");
}

static void describe_lighting(struct text *t, const struct lighting_plan *l)
{
    fgl_text_add(t, "  lighting    %d light%s, %s space, %s viewer%s%s%s\n", l->n, l->n == 1 ? "" : "s",
                 l->object_space ? "object" : "eye", l->local_viewer ? "local" : "infinite",
                 l->two_sided ? ", two-sided" : "", l->separate_specular ? ", separate specular colour" : "",
                 l->varying ? ", material by vertex" : "");
    for (int i = 0; i < l->n; i++) {
        const unsigned k = l->light[i].key;
        fgl_text_add(t, "    GL_LIGHT%d %s%s%s%s%s\n", l->light[i].number,
                     k & LIGHT_POSITIONAL ? "positional" : "directional",
                     k & LIGHT_ATTENUATED ? ", attenuated" : "", k & LIGHT_SPOT ? ", spot" : "",
                     k & LIGHT_REFLECTION ? ", highlight by reflection vector" : k & LIGHT_SPECULAR ? ", highlight" : "",
                     k & LIGHT_LOCAL_VIEWER ? " for a local viewer" : "");
    }
}

static void describe_fragments(struct text *t, const struct fragment_plan *f)
{
    static const char *const color[COLOR_SOURCES] = {"constant", "flat", "interpolated", "of an image", "lit at each fragment"};
    fgl_text_add(t, "  fragments   colour %s%s%s%s%s", color[f->color_source],
                 f->has_secondary ? ", colour sum" : "", f->has_fog ? ", fog" : "",
                 f->alpha_test ? ", alpha test" : "", f->stencil_test ? ", stencil test" : "");
    if (f->depth_test)
        fgl_text_add(t, ", depth test %s%s", comparison[f->depth_func & 7],
                     f->depth_write ? "" : " without write");
    fgl_text_add(t, "%s%s: %s kernel\n", f->blend ? ", blending" : "",
                 f->logic_op ? ", logical operation" : "", f->fill == f->general ? "the general" : "a fused");
}

void fgl_plan_describe(struct text *t, const struct plan *plan)
{
    static const char *const scaling[] = {"as they are", "rescaled", "normalized"};
    const struct vertex_plan *v = &plan->vertex;
    if (v->arith == ARITH_EXACT)
        fgl_text_add(t, "  accuracy    exact: in double, rounded once\n");
    describe_attributes(t, plan->varying, plan->fetch);
    fgl_text_add(t, "  transform   to clip and window coordinates%s%s%s\n",
                 v->need_eye ? ", to eye coordinates" : "", v->need_fog_z ? ", fog's distance" : "",
                 v->user_planes ? ", against clip planes" : "");
    if (v->lighting && v->need_normal)
        fgl_text_add(t, "  normals     %s, %s\n", v->normal_in_eye_space ? "to eye space" : "in object space",
                     scaling[v->normal_scaling]);
    if (v->lighting)
        describe_lighting(t, &v->light);
    fgl_text_add(t, "  raster      %d floats a vertex%s%s%s%s\n", plan->emit.stride,
                 plan->polygon_fill ? "" : ", polygon mode",
                 plan->raster.cull_ccw || plan->raster.cull_cw ? ", culling" : "",
                 plan->raster.offset_fill ? ", polygon offset" : "",
                 plan->raster.polygon_stipple ? ", stipple" : "");
    describe_fragments(t, &plan->fragment);
}

/* ---- what is left out ---- */

static void left(struct text *t, const char *what, const char *why)
{
    fgl_text_add(t, "    %-24s %s\n", what, why);
}

static void light_left_out(struct text *t, const struct lighting_plan *plan, int i)
{
    const struct light_derived *light = NULL;
    for (int k = 0; k < plan->n; k++)
        if (plan->light[k].number == i)
            light = &plan->light[k];
    fgl_text_add(t, "    GL_LIGHT%d%15s ", i, "");
    if (!light) {
        fgl_text_add(t, "all: every product of its colours and the material's is black\n");
        return;
    }
    const unsigned k = light->key;
    if (!(k & LIGHT_POSITIONAL))
        fgl_text_add(t, "vector to it (directional); ");
    if (!(k & LIGHT_ATTENUATED))
        fgl_text_add(t, "attenuation (%s); ", k & LIGHT_POSITIONAL ? "factors 1, 0, 0" : "directional");
    if (!(k & LIGHT_SPOT))
        fgl_text_add(t, "spot (cutoff 180); ");
    if (!(k & LIGHT_SPECULAR))
        fgl_text_add(t, "highlight (its specular colour or the material's is black); ");
    else if (!(k & (LIGHT_POSITIONAL | LIGHT_LOCAL_VIEWER)))
        fgl_text_add(t, "half vector by vertex (directional, infinite viewer: computed once); ");
    if (t->data && t->data[t->length - 2] == ';')
        t->length -= 2; /* the last separator */
    else
        fgl_text_add(t, "nothing");
    fgl_text_end_line(t);
}

static void lighting_left_out(struct text *t, const struct server_state *s, const struct vertex_plan *v)
{
    int disabled = 0;
    char what[32];
    for (int i = 0; i < FGL_MAX_LIGHTS; i++)
        if (s->lighting.light[i].enabled)
            light_left_out(t, &v->light, i);
        else
            disabled++;
    snprintf(what, sizeof what, "%d lights", disabled);
    if (disabled)
        left(t, what, "disabled");
    if (!v->need_eye)
        left(t, "eye coordinates", "no positional light and no local viewer");
    if (!v->need_normal)
        left(t, "normals", "no light is left that needs them");
    else if (!v->normal_in_eye_space)
        left(t, "normals to eye space",
             "light is computed in object space: all lights are directional, the matrix keeps lengths");
    if (v->need_normal && v->normal_scaling == NORMAL_AS_IS)
        left(t, "normalization",
             s->transform.rescale_normal ? "the modelview matrix keeps lengths"
                                         : "GL_NORMALIZE and GL_RESCALE_NORMAL are off");
    if (!v->light.two_sided)
        left(t, "back faces' colours", "GL_LIGHT_MODEL_TWO_SIDE is off");
    if (!v->light.varying)
        left(t, "material by vertex", "it is constant: products with the lights' colours computed once");
}

void fgl_plan_left_out(struct text *t, const struct context *ctx, const struct plan *plan)
{
    const struct server_state *s = &ctx->s;
    const struct fragment_plan *f = &plan->fragment;
    const uint32_t unread = plan->varying & ~plan->fetch;
    if (plan->vertex.lighting)
        lighting_left_out(t, s, &plan->vertex);
    else
        left(t, "lighting", "GL_LIGHTING is off");
    if (unread >> ATTR_NORMAL & 1)
        left(t, "the vertices' normals", "nothing reads them");
    if (unread >> ATTR_COLOR & 1)
        left(t, "the vertices' colours", "under GL_LIGHTING they count only with GL_COLOR_MATERIAL");
    if (f->color_source == COLOR_CONSTANT)
        left(t, "colour interpolation", "one colour for the whole draw");
    else if (f->color_source == COLOR_FLAT)
        left(t, "colour interpolation", "GL_FLAT");
    if (!f->has_secondary)
        left(t, "colour sum", "no separate specular colour");
    if (!f->has_fog)
        left(t, "fog", "GL_FOG is off");
    if (!f->alpha_test)
        left(t, "alpha test", s->color_buffer.alpha_test ? "GL_ALWAYS" : "GL_ALPHA_TEST is off");
    if (!f->stencil_test)
        left(t, "stencil test",
             s->stencil.stencil_test ? "there is no stencil buffer" : "GL_STENCIL_TEST is off");
    if (!f->depth_test)
        left(t, "depth test", s->depth.depth_test ? "there is no depth buffer" : "GL_DEPTH_TEST is off");
    if (!f->blend)
        left(t, "blending", "GL_BLEND is off: the framebuffer's colour is not read");
    if (!plan->raster.cull_ccw && !plan->raster.cull_cw)
        left(t, "culling", "GL_CULL_FACE is off: back faces are drawn");
}

void fgl_plan_print(const struct plan *plan)
{
    struct text t = {0};
    fgl_text_add(&t, "plan\n");
    fgl_plan_describe(&t, plan);
    fputs(t.data ? t.data : "", stderr);
    fgl_text_free(&t);
}
