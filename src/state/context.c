/* Initial values of the state tables (GL 1.5, 6.2 "State Tables"), one function for each struct of context.h. Layer 1. */
#include "state/context.h"

#include "fixedgl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Thread_local FGL_TLS_FAST struct context *fgl_current;

static void set4(float v[4], float x, float y, float z, float w)
{
    v[0] = x;
    v[1] = y;
    v[2] = z;
    v[3] = w;
}

static void init_current(struct current_state *s)
{
    for (int a = 0; a < ATTR_MATERIAL; a++)
        set4(s->attr[a], 0, 0, 0, 1);
    set4(s->attr[ATTR_NORMAL], 0, 0, 1, 1);
    set4(s->attr[ATTR_COLOR], 1, 1, 1, 1);
    s->attr[ATTR_INDEX][0] = 1;
    s->attr[ATTR_EDGE_FLAG][0] = 1;

    set4(s->raster_position, 0, 0, 0, 1);
    set4(s->raster_color, 1, 1, 1, 1);
    set4(s->raster_secondary_color, 0, 0, 0, 1);
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        set4(s->raster_texture_coords[unit], 0, 0, 0, 1);
    s->raster_index = 1;
    s->raster_position_valid = true;
}

static void init_light(struct light *l, bool first)
{
    const float white = first ? 1.0f : 0.0f; /* light 0 shines when enabled, the others are black */

    set4(l->ambient, 0, 0, 0, 1);
    set4(l->diffuse, white, white, white, 1);
    set4(l->specular, white, white, white, 1);
    set4(l->position, 0, 0, 1, 0);
    l->spot_direction[2] = -1;
    l->exact_position[2] = 1;
    l->exact_spot_direction[2] = -1;
    l->spot_cutoff = 180;
    l->constant_attenuation = 1;
}

static void init_lighting(struct lighting_state *s)
{
    s->shade_model = GL_SMOOTH;
    s->color_material_face = GL_FRONT_AND_BACK;
    s->color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
    s->light_model_color_control = GL_SINGLE_COLOR;
    set4(s->light_model_ambient, 0.2f, 0.2f, 0.2f, 1);
    for (int face = 0; face < 2; face++) {
        set4(s->material[MAT_AMBIENT][face], 0.2f, 0.2f, 0.2f, 1);
        set4(s->material[MAT_DIFFUSE][face], 0.8f, 0.8f, 0.8f, 1);
        set4(s->material[MAT_SPECULAR][face], 0, 0, 0, 1);
        set4(s->material[MAT_EMISSION][face], 0, 0, 0, 1);
        set4(s->material[MAT_SHININESS][face], 0, 0, 0, 0);
        set4(s->material[MAT_INDEXES][face], 0, 1, 1, 0);
    }
    for (int i = 0; i < FGL_MAX_LIGHTS; i++)
        init_light(&s->light[i], i == 0);
}

static void init_rasterization(struct server_state *s)
{
    s->fog.fog_mode = GL_EXP;
    s->fog.fog_coord_src = GL_FRAGMENT_DEPTH;
    s->fog.fog_density = 1;
    s->fog.fog_end = 1;

    s->point.point_size = 1;
    s->point.point_size_max = FGL_MAX_POINT_SIZE;
    s->point.point_fade_threshold_size = 1;
    s->point.point_distance_attenuation[0] = 1;

    s->multisample.multisample = true;
    s->multisample.sample_coverage_value = 1;

    s->line.line_width = 1;
    s->line.line_stipple_repeat = 1;
    s->line.line_stipple_pattern = 0xffff;

    s->polygon.cull_face_mode = GL_BACK;
    s->polygon.front_face = GL_CCW;
    s->polygon.polygon_mode[0] = s->polygon.polygon_mode[1] = GL_FILL;
    memset(s->polygon_stipple.row, 0xff, sizeof s->polygon_stipple.row);
}

static void init_fragment(struct server_state *s)
{
    s->depth.depth_writemask = true;
    s->depth.depth_func = GL_LESS;
    s->depth.depth_clear_value = 1;

    s->stencil.stencil_func = GL_ALWAYS;
    s->stencil.stencil_fail = GL_KEEP;
    s->stencil.stencil_pass_depth_fail = GL_KEEP;
    s->stencil.stencil_pass_depth_pass = GL_KEEP;
    s->stencil.stencil_value_mask = s->stencil.stencil_writemask = 0xff; /* all ones, for 8 bits */

    struct color_buffer_state *c = &s->color_buffer;
    c->dither = true;
    c->alpha_test_func = GL_ALWAYS;
    c->blend_src_rgb = c->blend_src_alpha = GL_ONE;
    c->blend_dst_rgb = c->blend_dst_alpha = GL_ZERO;
    c->blend_equation[0] = c->blend_equation[1] = GL_FUNC_ADD;
    c->logic_op_mode = GL_COPY;
    c->draw_buffer = GL_FRONT; /* OSMesa rule: contexts are single buffered */
    c->index_writemask = ~0u;
    for (int i = 0; i < 4; i++)
        c->color_writemask[i] = true;
}

static void init_hints(struct hint_state *h)
{
    h->perspective_correction_hint = h->point_smooth_hint = h->line_smooth_hint = GL_DONT_CARE;
    h->polygon_smooth_hint = h->fog_hint = GL_DONT_CARE;
    h->generate_mipmap_hint = h->texture_compression_hint = h->phong_hint = GL_DONT_CARE;
}

static void init_scale(struct scale_bias *t)
{
    set4(t->scale, 1, 1, 1, 1);
}

static void init_imaging(struct imaging_state *s)
{
    for (int i = 0; i < COLOR_TABLES; i++)
        init_scale(&s->color_table_transform[i]);
    for (int i = 0; i < FILTERS; i++) {
        init_scale(&s->filter_transform[i]);
        s->border_mode[i] = GL_REDUCE;
    }
    init_scale(&s->post_convolution);
    init_scale(&s->post_color_matrix);
}

static void init_pixel_mode(struct pixel_mode_state *p)
{
    init_imaging(&p->imaging);
    for (int i = 0; i < 4; i++)
        p->scale[i] = 1;
    p->depth_scale = p->zoom_x = p->zoom_y = 1;
    p->read_buffer = GL_FRONT;
}

static void init_pixel_maps(struct pixel_map *maps)
{
    memset(maps, 0, PIXEL_MAP_COUNT * sizeof *maps);
    for (int i = 0; i < PIXEL_MAP_COUNT; i++)
        maps[i].size = 1;
}

static void init_texgen(struct texture_unit *u)
{
    for (int coord = 0; coord < 4; coord++) { /* s and t along x and y, r and q nothing */
        struct texgen *g = &u->gen[coord];
        g->mode = GL_EYE_LINEAR;
        if (coord < 2)
            g->object_plane[coord] = g->eye_plane[coord] = 1;
        if (coord < 2)
            g->exact_eye_plane[coord] = 1;
    }
}

static void init_texture_env(struct texture_env *e)
{
    static const GLenum source[3] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
    e->mode = e->combine_rgb = e->combine_alpha = GL_MODULATE;
    for (int i = 0; i < 3; i++) {
        e->source_rgb[i] = e->source_alpha[i] = source[i];
        e->operand_rgb[i] = i < 2 ? GL_SRC_COLOR : GL_SRC_ALPHA;
        e->operand_alpha[i] = GL_SRC_ALPHA;
    }
    e->rgb_scale = e->alpha_scale = 1;
}

static void init_texture(struct texture_state *t)
{
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        init_texgen(&t->unit[unit]);
        init_texture_env(&t->unit[unit].env);
    }
}

static void init_eval(struct eval_state *e)
{
    e->map1_grid_domain[1] = e->map2_grid_domain[1] = e->map2_grid_domain[3] = 1;
    e->map1_grid_segments = e->map2_grid_segments[0] = e->map2_grid_segments[1] = 1;
}

void fgl_state_init_arrays(struct vertex_array array[ATTR_MATERIAL])
{
    for (int i = 0; i < ATTR_MATERIAL; i++)
        array[i] = (struct vertex_array){.type = GL_FLOAT, .size = 4};
    array[ATTR_NORMAL].size = array[ATTR_SECONDARY_COLOR].size = 3;
    array[ATTR_FOG_COORD].size = array[ATTR_INDEX].size = array[ATTR_EDGE_FLAG].size = 1;
    array[ATTR_EDGE_FLAG].type = GL_UNSIGNED_BYTE;
}

static void init_stack(struct matrix_stack *stack, int limit, unsigned dirty)
{
    stack->top = 0;
    stack->limit = limit;
    stack->dirty = dirty;
    stack->changed = false;
    fgl_matrix_set_identity(&stack->entry[0]);
}

static GLenum accuracy_from_environment(void)
{
    const char *name = getenv("FIXEDGL_ACCURACY");

    if (name && strcmp(name, "exact") == 0)
        return FIXEDGL_EXACT;
    if (name && strcmp(name, "compatible") != 0)
        fprintf(stderr, "FixedGL: FIXEDGL_ACCURACY is %s: only exact and compatible are known\n", name);
    return FIXEDGL_COMPATIBLE;
}

enum fgl_arith fgl_context_arith(const struct context *ctx)
{
    return ctx->accuracy == FIXEDGL_EXACT ? ARITH_EXACT : ARITH_COMPATIBLE;
}

void fgl_state_init(struct context *ctx)
{
    memset(&ctx->s, 0, sizeof ctx->s); /* every value that the functions above leave out starts as 0, false or GL_NONE */
    memset(&ctx->client, 0, sizeof ctx->client);
    ctx->dirty = DIRTY_ALL;
    ctx->error = GL_NO_ERROR;
    ctx->begin_mode = OUTSIDE_BEGIN_END;
    ctx->accuracy = accuracy_from_environment();

    init_current(&ctx->s.current);
    init_lighting(&ctx->s.lighting);
    ctx->s.transform.matrix_mode = GL_MODELVIEW;
    ctx->s.viewport.depth_range[1] = 1;
    init_rasterization(&ctx->s);
    init_fragment(&ctx->s);
    init_hints(&ctx->s.hint);
    init_pixel_mode(&ctx->s.pixel_mode);
    init_pixel_maps(ctx->pixel_map);
    init_texture(&ctx->s.texture);
    init_eval(&ctx->s.eval);
    ctx->render_mode = GL_RENDER;
    ctx->feedback.type = GL_2D;

    fgl_state_init_arrays(ctx->client.arrays.array);
    ctx->client.pack.alignment = ctx->client.unpack.alignment = 4;

    init_stack(&ctx->modelview, FGL_MAX_MODELVIEW_DEPTH, DIRTY_MODELVIEW);
    init_stack(&ctx->projection, FGL_MAX_PROJECTION_DEPTH, DIRTY_PROJECTION);
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        init_stack(&ctx->texture_matrix[unit], FGL_MAX_TEXTURE_DEPTH, DIRTY_TEXTURE_MATRIX);
    init_stack(&ctx->color_matrix, FGL_MAX_COLOR_MATRIX_DEPTH, DIRTY_PIXEL);
}
