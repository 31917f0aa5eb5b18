/* From state to the fragment plan: the stages that the state requires, and a fused kernel where there is one
 * for just these. */
#include "base/color_index.h"
#include "fragment/fragment.h"

/* Lanes that the stages read but those of textures and of lighting, in whole groups. */
static int lanes_of(const struct fragment_plan *plan)
{
    const bool lit = plan->color_source == COLOR_LIT;
    if ((plan->has_secondary && plan->secondary_source != COLOR_CONSTANT && !lit) || plan->has_fog)
        return LANE_TEX0;
    return (plan->color_source == COLOR_CONSTANT && !plan->primary_interpolated) || lit ? LANE_COLOR : LANE_SECONDARY;
}

/* OSMesa rule: coefficients in double, rounded to float once. */
static void validate_fog(struct fragment_plan *plan, const struct fog_state *fog)
{
    plan->has_fog = fog->fog;
    plan->fog_mode = fog->fog_mode;
    plan->fog.p = fog->fog_end == fog->fog_start ? 1.0f : -1.0f / (fog->fog_end - fog->fog_start);
    plan->fog.q = fog->fog_end * -plan->fog.p;

    struct exact_fog_numbers *exact = &plan->exact_fog;
    const double start = (double)fog->fog_start, end = (double)fog->fog_end;
    exact->p = end == start ? 1 : -1 / (end - start);
    exact->q = end * -exact->p;
    exact->k = (double)fog->fog_density * (fog->fog_mode == GL_EXP2 ? 1.2011224087864498 : 1.4426950408889634);
    plan->fog.k = (float)exact->k;
    for (int i = 0; i < 4; i++)
        plan->fog_color[i] = fgl_clamp01(fog->fog_color[i]); /* queries clamp too */
    plan->fog_index = fog->fog_index;
}

/* The kernels that do just what the plan asks for, if there are such. */
static void choose_fused(struct fragment_plan *plan)
{
    const struct fragment_kernels *kernels = fgl_fragment_kernels(plan->arith);
    const bool *write = plan->channel_write;
    const enum depth_kind depth = !plan->depth_test ? DEPTH_OFF : plan->depth_func == GL_LESS ? DEPTH_LESS : DEPTH_LEQUAL;
    const bool staged = plan->has_secondary || plan->has_fog || plan->textures || !kernels->fused[depth][plan->color_source];
    if (plan->fb->color_kind != COLOR_UNORM8 || plan->alpha_test || plan->stencil_test || plan->blend || plan->logic_op ||
        plan->samples_passed || !(write[0] && write[1] && write[2] && write[3]))
        return;
    if (plan->depth_test && (!plan->depth_write || (plan->depth_func != GL_LESS && plan->depth_func != GL_LEQUAL)))
        return;
    plan->fill = staged ? kernels->staged[depth] : kernels->fused[depth][plan->color_source];
    plan->scatter = staged ? NULL : kernels->scatter[depth][plan->color_source];
}

/* Whether the second factor is 1 minus the first, or the other way round. */
static bool are_complements(GLenum a, GLenum b)
{
    const GLenum low = a < b ? a : b, high = a < b ? b : a;
    const bool pair = (low >= GL_SRC_COLOR && low <= GL_DST_COLOR && low % 2 == 0) || low == GL_CONSTANT_COLOR || low == GL_CONSTANT_ALPHA;
    return pair && high == low + 1;
}

static bool blends_by_lerp(const struct color_buffer_state *s)
{
    return s->blend_equation[0] == GL_FUNC_ADD && s->blend_equation[1] == GL_FUNC_ADD && are_complements(s->blend_src_rgb, s->blend_dst_rgb) &&
           are_complements(s->blend_src_alpha, s->blend_dst_alpha);
}

/* Colour index mode: neither colour sum nor alpha test nor blending (GL 1.5, 3.9, 4.1.4, 4.1.8), a logical
 * operation and a write mask of its own (4.1.10, 4.2.2). */
static void validate_index(struct fragment_plan *plan, const struct color_buffer_state *color)
{
    plan->has_secondary = plan->alpha_test = plan->blend = false;
    plan->textures = 0;
    plan->logic_op = color->index_logic_op;
    plan->color_write = color->index_writemask & FGL_INDEX_MAX && color->draw_buffer != GL_NONE;
    plan->lanes = lanes_of(plan);
    plan->fill = plan->general = fgl_fragment_kernels(plan->arith)->index;
    plan->scatter = NULL;
}

/* OSMesa rule: a colour that textures replace is as if it were constant, which decides how quads are split. */
static void validate_textures(struct fragment_plan *plan, const struct server_state *s, bool general)
{
    plan->textures = fgl_texture_stages(plan->texture, s, plan->texture_varying);
    plan->texture_products = !general && fgl_texture_products(plan->texture, plan->textures);
    if (!plan->keeps_color && !plan->has_secondary && !fgl_texture_reads_primary(plan->texture, plan->textures))
        plan->color_source = COLOR_CONSTANT;
    plan->primary_interpolated = plan->primary_interpolated && fgl_texture_names_primary(plan->texture, plan->textures);
    plan->lanes = lanes_of(plan);
    for (int i = 0; i < plan->textures; i++)
        if (plan->texture[i].source == COORDINATES_PLANES) {
            plan->texture[i].lane += lanes_of(plan);
            plan->lanes += LANE_GROUP;
        }
}

void fgl_fragment_validate(struct fragment_plan *plan, const struct server_state *s, struct framebuffer *fb,
                           bool general)
{
    const struct color_buffer_state *color = &s->color_buffer;
    plan->fb = fb;
    plan->color_buffer = *color;
    plan->stencil = s->stencil;
    plan->depth_func = s->depth.depth_func;
    validate_fog(plan, &s->fog);

    plan->alpha_test = color->alpha_test && color->alpha_test_func != GL_ALWAYS;
    plan->depth_test = s->depth.depth_test && fb->depth;
    plan->depth_write = plan->depth_test && s->depth.depth_writemask;
    plan->stencil_test = s->stencil.stencil_test && fgl_framebuffer_need_stencil(fb) && fb->stencil;
    plan->logic_op = color->color_logic_op;
    plan->blend = color->blend && !plan->logic_op; /* GL 1.5, 4.1.10: a logical operation replaces blending */
    plan->blend_lerp = plan->blend && fb->one_component && blends_by_lerp(color);
    plan->write_bits = 0;
    for (int i = 0; i < 4; i++) {
        plan->channel_write[i] = color->color_writemask[i] && color->draw_buffer != GL_NONE;
        plan->write_bits |= plan->channel_write[i] ? 255u << (8 * i) : 0;
    }
    plan->color_write = plan->write_bits != 0;
    if (fb->color_kind == COLOR_INDEX8) {
        validate_index(plan, color);
        return;
    }
    validate_textures(plan, s, general);

    plan->fill = plan->general = fgl_fragment_kernels(plan->arith)->general;
    plan->scatter = NULL;
    if (!general)
        choose_fused(plan);
}
