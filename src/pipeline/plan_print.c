/* The plan in words, for FIXEDGL_DEBUG=plan. */
#include "pipeline/pipeline.h"

#include <stdio.h>

static void print_lighting(const struct lighting_plan *l)
{
    fprintf(stderr, "  lighting: %d light%s, %s space, %s viewer%s%s\n", l->n, l->n == 1 ? "" : "s",
            l->object_space ? "object" : "eye", l->local_viewer ? "local" : "infinite", l->two_sided ? ", two-sided" : "",
            l->separate_specular ? ", separate specular" : "");
    for (int i = 0; i < l->n; i++) {
        const unsigned k = l->light[i].key;
        fprintf(stderr, "    GL_LIGHT%d: %s%s%s%s%s%s\n", l->light[i].number, k & LIGHT_POSITIONAL ? "positional" : "directional",
                k & LIGHT_ATTENUATED ? ", attenuated" : "", k & LIGHT_SPOT ? ", spot" : "", k & LIGHT_SPECULAR ? ", specular" : "",
                k & LIGHT_LOCAL_VIEWER ? ", local viewer" : "", k & LIGHT_VARYING ? ", material by vertex" : "");
    }
}

void fgl_plan_print(const struct plan *plan)
{
    static const char *const normal[] = {"as is", "rescaled", "normalized"};
    static const char *const color[] = {"constant", "flat", "smooth"};
    const struct vertex_plan *v = &plan->vertex;
    const struct fragment_plan *f = &plan->fragment;
    fprintf(stderr, "plan: attributes varying 0x%x, fetched 0x%x\n", plan->varying, plan->varying & plan->fetch);
    fprintf(stderr, "  vertex: transform%s%s%s\n", v->need_eye ? ", eye position" : "", v->need_fog_z ? ", fog depth" : "",
            v->user_planes ? ", user clip planes" : "");
    if (v->need_normal)
        fprintf(stderr, "  normal: %s\n", normal[v->normal_scaling]);
    if (v->lighting)
        print_lighting(&v->light);
    fprintf(stderr, "  raster: %d lanes%s%s%s\n", plan->emit.lanes, plan->polygon_fill ? "" : ", polygon mode",
            plan->raster.cull_ccw || plan->raster.cull_cw ? ", culling" : "", plan->raster.offset_fill ? ", polygon offset" : "");
    fprintf(stderr, "  fragment: colour %s%s%s%s%s%s%s%s\n", color[f->color_source], f->has_secondary ? ", colour sum" : "",
            f->has_fog ? ", fog" : "", f->alpha_test ? ", alpha test" : "", f->stencil_test ? ", stencil test" : "",
            f->depth_test ? ", depth test" : "", f->logic_op ? ", logic op" : "", f->blend ? ", blend" : "");
}
