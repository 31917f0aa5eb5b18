/* From texture state to the stages that fragments go through (GL 1.5, 3.8). */
#include "fragment/fragment.h"
#include "texture/format.h"

#include <math.h>

/* ---- samplers ---- */

static enum texture_filter image_filter(GLenum filter)
{
    return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST || filter == GL_LINEAR_MIPMAP_LINEAR
                   ? FILTER_LINEAR
                   : FILTER_NEAREST;
}

static enum mip_filter mip_filter(GLenum filter)
{
    switch (filter) {
    case GL_NEAREST_MIPMAP_NEAREST:
    case GL_LINEAR_MIPMAP_NEAREST: return MIP_NEAREST;
    case GL_NEAREST_MIPMAP_LINEAR:
    case GL_LINEAR_MIPMAP_LINEAR: return MIP_LINEAR;
    default: return MIP_NONE;
    }
}

static bool needs_border(GLenum wrap)
{
    return wrap != GL_REPEAT && wrap != GL_CLAMP_TO_EDGE;
}

/* OSMesa rules: an image alone, at level 0, is no mipmap; cube maps are clamped to their edges, and mixed filters with mipmaps need
 * floats there. */
static void derive_filters(struct sampler *to, const struct texture_parameters *p, bool level_zero_only)
{
    static const int dimensions[TEXTURE_TARGETS] = {1, 2, 2, 3, 2};
    to->min = image_filter(p->min_filter);
    to->mag = image_filter(p->mag_filter);
    to->mip = level_zero_only ? MIP_NONE : mip_filter(p->min_filter);
    to->dimensions = dimensions[to->target];
    const bool cube = to->target == TEXTURE_CUBE_MAP;
    to->fixed_point = to->kind == TEXELS_UNORM8 && (!cube || to->mip == MIP_NONE || to->min == to->mag);
    for (int i = 0; i < 3; i++) {
        to->wrap[i] = cube ? GL_CLAMP_TO_EDGE : p->wrap[i];
        to->fixed_point &= i >= to->dimensions || !needs_border(to->wrap[i]);
    }
    to->compare_func = to->kind == TEXELS_DEPTH && p->compare_mode == GL_COMPARE_R_TO_TEXTURE ? p->compare_func : 0;
}

/* OSMesa rules: the bias is a multiple of 1/256; limits that say nothing are left out. */
static void derive_lod(struct sampler *to, const struct texture_parameters *p, float unit_bias)
{
    to->needs_lod = to->mip != MIP_NONE || to->min != to->mag;
    to->lod_bias = roundf(fmaxf(-16.0f, fminf(16.0f, p->lod_bias + unit_bias)) * 256.0f) / 256.0f;
    to->min_lod = fmaxf(p->min_lod, 0.0f);
    to->max_lod = p->max_lod;
    to->adjusts_lod = to->lod_bias != 0.0f || to->min_lod > 0.0f || to->max_lod < FGL_MAX_TEXTURE_LEVELS;
    to->magnify_below = to->mag == FILTER_LINEAR && to->min == FILTER_NEAREST && mip_filter(p->min_filter) != MIP_NONE ? 0.5f : 0.0f;
}

/* What the base format leaves of a texture (GL 1.5, tables 3.22 and 3.23): a format without RGB, or without alpha, keeps the fragment's. */
static bool has_rgb(GLenum base)
{
    return base != GL_ALPHA;
}
static bool has_alpha(GLenum base)
{
    return base == GL_ALPHA || base == GL_LUMINANCE_ALPHA || base == GL_INTENSITY || base == GL_RGBA;
}

/* GL 1.5, table 3.20: what a border texel has, as if it came from an image of the format. */
static void derive_border(struct sampler *to, const float color[4], const struct texture_format *format)
{
    const GLenum base_format = format->base_format;
    float c[4];
    for (int i = 0; i < 4; i++)
        c[i] = fgl_texture_format_leaves_unit(format) ? color[i] : fgl_clamp01(color[i]);
    const bool luminance = base_format == GL_LUMINANCE || base_format == GL_LUMINANCE_ALPHA ||
                           base_format == GL_INTENSITY || format->kind == TEXELS_DEPTH;
    for (int i = 0; i < 4; i++) {
        const bool missing = (base_format == GL_RED && i > 0) || (base_format == GL_RG && i > 1) || base_format == GL_ALPHA;
        to->border[i] = i < 3 && missing ? 0.0f : i < 3 && luminance ? c[0] : c[i];
    }
    if (!has_alpha(base_format))
        to->border[3] = 1.0f;
    if (base_format == GL_INTENSITY)
        to->border[3] = c[0];
}

static void derive_swizzle(struct sampler *to, const GLenum swizzle[4])
{
    to->swizzled = false;
    for (int c = 0; c < 4; c++) {
        to->swizzle[c] = swizzle[c] == GL_ZERO ? SWIZZLE_ZERO : swizzle[c] == GL_ONE ? SWIZZLE_ONE : (uint8_t)(swizzle[c] - GL_RED);
        to->swizzled |= to->swizzle[c] != c;
    }
}

static void derive_levels(struct sampler *to, const struct texture_object *object)
{
    const int base = fgl_texture_base_level(object);
    to->last_level = to->mip == MIP_NONE ? 0 : fgl_texture_last_level(object) - base;
    for (int i = 0; i <= to->last_level; i++) {
        const struct texture_image *image = &object->image[0][base + i];
        to->level[i].size[0] = image->width;
        to->level[i].size[1] = image->height;
        to->level[i].size[2] = image->depth;
        for (int c = 0; c < 3; c++)
            to->level[i].scale[c] = object->target == TEXTURE_RECTANGLE ? 1.0f : (float)to->level[i].size[c];
        for (int face = 0; face < fgl_texture_faces(object->target); face++)
            to->level[i].texels[face] = object->image[face][base + i].texels;
    }
}

static void derive_sampler(struct sampler *to, const struct texture_object *object, const struct texture_unit *unit)
{
    const struct texture_parameters *p = fgl_texture_sampling(unit, object);
    const struct texture_image *image = &object->image[0][fgl_texture_base_level(object)];
    to->target = object->target;
    to->kind = image->kind;
    to->depth_bits = image->kind == TEXELS_DEPTH ? image->format->bits[0] : 0;
    const bool rgba = image->format->base_format == GL_RGBA || image->format->base_format == GL_RGB;
    for (int c = 0; c < 4; c++)
        to->shift[c] = to->kind == TEXELS_UNORM8 && rgba && image->format->bits[c] ? 8 - image->format->bits[c] : 0;
    derive_filters(to, p, fgl_texture_last_level(object) == 0);
    derive_lod(to, p, unit->env.lod_bias);
    derive_border(to, p->border_color, image->format);
    to->depth_mode = object->parameters.depth_mode;
    derive_swizzle(to, object->parameters.swizzle);
    derive_levels(to, object);
}

/* ---- environments ---- */

static void set_combine(struct combine *to, GLenum function, GLenum source0, GLenum source1, GLenum operand)
{
    *to = (struct combine){
            .function = function, .source = {source0, source1, GL_CONSTANT}, .operand = {operand, operand, operand}, .scale = 1.0f};
}

static void derive_decal(struct texture_environment *to, GLenum base)
{
    set_combine(&to->alpha, GL_REPLACE, GL_PREVIOUS, GL_PREVIOUS, GL_SRC_ALPHA);
    if (base == GL_RGB || base == GL_RED || base == GL_RG) {
        set_combine(&to->rgb, GL_REPLACE, GL_TEXTURE, GL_PREVIOUS, GL_SRC_COLOR);
    } else if (base == GL_RGBA) {
        set_combine(&to->rgb, GL_INTERPOLATE, GL_TEXTURE, GL_PREVIOUS, GL_SRC_COLOR);
        to->rgb.source[2] = GL_TEXTURE;
        to->rgb.operand[2] = GL_SRC_ALPHA;
    } else { /* undefined; OSMesa keeps the fragment */
        set_combine(&to->rgb, GL_REPLACE, GL_PREVIOUS, GL_PREVIOUS, GL_SRC_COLOR);
    }
}

static void derive_blend(struct texture_environment *to, GLenum base)
{
    set_combine(&to->rgb, GL_INTERPOLATE, GL_CONSTANT, GL_PREVIOUS, GL_SRC_COLOR);
    to->rgb.source[2] = GL_TEXTURE;
    set_combine(&to->alpha, GL_MODULATE, GL_PREVIOUS, GL_TEXTURE, GL_SRC_ALPHA);
    if (base == GL_INTENSITY) {
        set_combine(&to->alpha, GL_INTERPOLATE, GL_CONSTANT, GL_PREVIOUS, GL_SRC_ALPHA);
        to->alpha.source[2] = GL_TEXTURE;
    }
}

/* GL 1.5, tables 3.22 and 3.23: the five simple modes. */
static void derive_simple(struct texture_environment *to, GLenum mode, GLenum base)
{
    switch (mode) {
    case GL_DECAL: derive_decal(to, base); return;
    case GL_BLEND: derive_blend(to, base); break;
    case GL_REPLACE:
        set_combine(&to->rgb, GL_REPLACE, GL_TEXTURE, GL_PREVIOUS, GL_SRC_COLOR);
        set_combine(&to->alpha, GL_REPLACE, GL_TEXTURE, GL_PREVIOUS, GL_SRC_ALPHA);
        break;
    case GL_ADD:
        set_combine(&to->rgb, GL_ADD, GL_PREVIOUS, GL_TEXTURE, GL_SRC_COLOR);
        set_combine(&to->alpha, base == GL_INTENSITY ? GL_ADD : GL_MODULATE, GL_PREVIOUS, GL_TEXTURE, GL_SRC_ALPHA);
        break;
    default:
        set_combine(&to->rgb, GL_MODULATE, GL_PREVIOUS, GL_TEXTURE, GL_SRC_COLOR);
        set_combine(&to->alpha, GL_MODULATE, GL_PREVIOUS, GL_TEXTURE, GL_SRC_ALPHA);
        break;
    }
    if (!has_rgb(base))
        set_combine(&to->rgb, GL_REPLACE, GL_PREVIOUS, GL_PREVIOUS, GL_SRC_COLOR);
    if (!has_alpha(base))
        set_combine(&to->alpha, GL_REPLACE, GL_PREVIOUS, GL_PREVIOUS, GL_SRC_ALPHA);
}

/* The dot products of GL_EXT_texture_env_dot3: those of OpenGL 1.3 but without scales. */
static void derive_dot3_ext(struct texture_environment *to)
{
    if (to->rgb.function != GL_DOT3_RGB_EXT && to->rgb.function != GL_DOT3_RGBA_EXT)
        return;
    const bool rgba = to->rgb.function == GL_DOT3_RGBA_EXT;
    to->rgb.function = rgba ? GL_DOT3_RGBA : GL_DOT3_RGB;
    to->rgb.scale = 1.0f;
    if (rgba)
        to->alpha.scale = 1.0f;
}

static void derive_combine(struct texture_environment *to, const struct texture_env *e)
{
    to->rgb = (struct combine){.function = e->combine_rgb, .scale = e->rgb_scale};
    to->alpha = (struct combine){.function = e->combine_alpha, .scale = e->alpha_scale};
    for (int i = 0; i < 3; i++) {
        to->rgb.source[i] = e->source_rgb[i];
        to->rgb.operand[i] = e->operand_rgb[i];
        to->alpha.source[i] = e->source_alpha[i];
        to->alpha.operand[i] = e->operand_alpha[i];
    }
    derive_dot3_ext(to);
}

static GLenum environment_format(const struct sampler *sampler, GLenum base)
{
    return sampler->kind == TEXELS_DEPTH ? sampler->depth_mode : base;
}

/* Whether the function may take values of [0,1] out of it. */
static bool leaves_range(const struct combine *combine)
{
    const GLenum f = combine->function;
    return combine->scale != 1.0f || !(f == GL_REPLACE || f == GL_MODULATE || f == GL_INTERPOLATE);
}

/* Whether an argument is the texel, or what was before, as it is; where says for which component: 0 RGB, 1 alpha. */
static bool is_plain(const struct combine *combine, int k, int where, GLenum source)
{
    const GLenum operand = combine->operand[k];
    return combine->source[k] == source && operand == (where ? GL_SRC_ALPHA : GL_SRC_COLOR);
}

static bool derive_product(const struct combine *combine, int where, bool *by_texel, bool *by_previous)
{
    const bool texel0 = is_plain(combine, 0, where, GL_TEXTURE), previous0 = is_plain(combine, 0, where, GL_PREVIOUS);
    const bool texel1 = is_plain(combine, 1, where, GL_TEXTURE), previous1 = is_plain(combine, 1, where, GL_PREVIOUS);
    const bool both = combine->function == GL_MODULATE && ((texel0 && previous1) || (previous0 && texel1));
    const bool one = combine->function == GL_REPLACE && (texel0 || previous0);
    *by_texel = both || texel0;
    *by_previous = both || previous0;
    return both || one;
}

/* leaves_unit: whether texels do. */
static void derive_environment(struct texture_environment *to, const struct texture_env *e, GLenum base, bool leaves_unit)
{
    if (e->mode == GL_COMBINE)
        derive_combine(to, e);
    else
        derive_simple(to, e->mode, base);
    to->mode = e->mode;
    to->clamped = leaves_unit || leaves_range(&to->rgb) || leaves_range(&to->alpha);
    const bool rgb = derive_product(&to->rgb, 0, &to->by_texel[0], &to->by_previous[0]);
    const bool alpha = derive_product(&to->alpha, 1, &to->by_texel[1], &to->by_previous[1]);
    to->product = rgb && alpha && !to->clamped;
    for (int i = 0; i < 4; i++)
        to->color[i] = fgl_clamp01(e->color[i]);
}

/* ---- stages ---- */

/* Whether a combiner reads RGB, alpha, of the fragment's colour as it is before the stage, which for the first stage is the primary colour. */
static void note_reads(const struct combine *combine, bool for_alpha, bool previous[2], bool primary[2])
{
    const int arguments = combine->function == GL_REPLACE ? 1 : combine->function == GL_INTERPOLATE ? 3 : 2;
    for (int k = 0; k < arguments; k++) {
        const GLenum operand = combine->operand[k];
        const bool alpha = for_alpha || operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
        previous[alpha] |= combine->source[k] == GL_PREVIOUS;
        primary[alpha] |= combine->source[k] == GL_PRIMARY_COLOR;
    }
}

bool fgl_texture_reads_primary(const struct texture_stage *stage, int n)
{
    bool needed[2] = {true, true}, primary[2] = {false, false}; /* RGB, alpha */
    for (int i = n - 1; i >= 0; i--) {
        const struct texture_environment *e = &stage[i].environment;
        const bool rgba = e->rgb.function == GL_DOT3_RGBA;
        bool previous[2] = {false, false};
        if (needed[0] || (needed[1] && rgba))
            note_reads(&e->rgb, false, previous, primary);
        if (needed[1] && !rgba)
            note_reads(&e->alpha, true, previous, primary);
        needed[0] = previous[0];
        needed[1] = previous[1];
    }
    return needed[0] || needed[1] || primary[0] || primary[1];
}

bool fgl_texture_names_primary(const struct texture_stage *stage, int n)
{
    bool previous[2] = {false, false}, primary[2] = {false, false};
    for (int i = 0; i < n; i++) {
        note_reads(&stage[i].environment.rgb, false, previous, primary);
        note_reads(&stage[i].environment.alpha, true, previous, primary);
    }
    return primary[0] || primary[1];
}

bool fgl_texture_products(const struct texture_stage *stage, int n)
{
    for (int i = 0; i < n; i++)
        if (!stage[i].environment.product || !stage[i].sampler.fixed_point || stage[i].sampler.swizzled)
            return false;
    return true;
}

int fgl_texture_stages(struct texture_stage stage[FGL_MAX_TEXTURE_UNITS], const struct server_state *s, uint32_t varying)
{
    int n = 0, lane = 0;
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++) {
        const struct texture_unit *u = &s->texture.unit[unit];
        const struct texture_object *object = u->enabled ? fgl_texture_current(u) : NULL;
        if (!object)
            continue;
        struct texture_stage *to = &stage[n++];
        to->unit = unit;
        to->source = varying >> unit & 1 ? COORDINATES_PLANES : COORDINATES_CONSTANT;
        to->lane = lane;
        if (to->source == COORDINATES_PLANES)
            lane += 4;
        to->across_sprite = s->point.point_sprite && s->point.coord_replace[unit];
        for (int c = 0; c < 4; c++)
            to->constant[c] = s->current.attr[ATTR_TEX0 + unit][c];
        derive_sampler(&to->sampler, object, u);
        const struct texture_format *format = object->image[0][fgl_texture_base_level(object)].format;
        derive_environment(&to->environment, &u->env, environment_format(&to->sampler, format->base_format),
                           fgl_texture_format_leaves_unit(format));
    }
    fgl_texture_arrange(stage, n);
    return n;
}
