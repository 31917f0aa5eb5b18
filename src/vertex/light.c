/* Derives the lighting part of the plan from state (GL 1.5, 2.14.1 "Lighting"): each enabled light once, as
 * what it is, with every product that does not differ by vertex. All in float, left to right: OSMesa rule. */
#include "vertex/vertex.h"

#include <math.h>
#include <string.h>

/* v scaled to unit length; the zero vector stays. */
static void normalize(float v[3])
{
    float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

    if (square > 0.0f) {
        float scale = 1.0f / sqrtf(square);
        for (int c = 0; c < 3; c++)
            v[c] *= scale;
    }
}

static bool is_zero(const float v[3])
{
    return v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f;
}

static bool is_spot(const struct light *light)
{
    return light->spot_cutoff != 180.0f;
}

static bool is_attenuated(const struct light *light)
{
    return light->constant_attenuation != 1.0f || light->linear_attenuation != 0.0f ||
           light->quadratic_attenuation != 0.0f;
}

/* Whether lighting may be done in object space: OSMesa rule. Only directions are needed, and lengths are
 * kept. */
static bool in_object_space(const struct server_state *s, unsigned modelview_class, bool light_fragments)
{
    const struct lighting_state *state = &s->lighting;
    const float *attenuation = s->point.point_distance_attenuation;

    if (light_fragments || state->light_model_local_viewer || state->light_model_color_control == GL_SEPARATE_SPECULAR_COLOR)
        return false;
    if (attenuation[0] != 1.0f || attenuation[1] != 0.0f || attenuation[2] != 0.0f || fgl_texgen_in_eye_space(s))
        return false;
    for (int i = 0; i < FGL_MAX_LIGHTS; i++)
        if (state->light[i].enabled && (state->light[i].position[3] != 0.0f || is_spot(&state->light[i])))
            return false;
    return !(modelview_class & ~(unsigned)(MAT_ROTATION | MAT_TRANSLATION));
}

/* Materials
 * --------------------------------------------------------------------------------------------------- */

/* GL 1.5, 2.14.3 "ColorMaterial": whether the parameter follows the current colour. */
static bool follows_color(const struct lighting_state *state, enum fgl_material parameter, int face)
{
    GLenum mode = state->color_material_parameter;

    if (!state->color_material || state->color_material_face == (face ? GL_FRONT : GL_BACK))
        return false;
    switch (parameter) {
    case MAT_AMBIENT: return mode == GL_AMBIENT || mode == GL_AMBIENT_AND_DIFFUSE;
    case MAT_DIFFUSE: return mode == GL_DIFFUSE || mode == GL_AMBIENT_AND_DIFFUSE;
    case MAT_SPECULAR: return mode == GL_SPECULAR;
    case MAT_EMISSION: return mode == GL_EMISSION;
    default: return false;
    }
}

static void list_attribute(struct lighting_plan *light, int attribute)
{
    for (int k = 0; k < light->attributes; k++)
        if (light->attribute[k] == attribute)
            return;
    light->attribute[light->attributes++] = attribute;
}

/* Where each parameter comes from: the vertices' colours, the vertices' materials, or a constant. */
static void derive_materials(struct vertex_plan *plan, const struct lighting_state *state)
{
    struct lighting_plan *light = &plan->light;
    const int faces = light->two_sided ? 2 : 1;

    light->varying = false;
    light->attributes = 0;
    memcpy(light->material, state->material, sizeof light->material);
    for (int p = 0; p < MAT_COUNT; p++)
        for (int face = 0; face < 2; face++) {
            const int own = fgl_material_attr((enum fgl_material)p, face);
            const bool follows = follows_color(state, (enum fgl_material)p, face);
            int *source = &light->source[p][face];

            *source = -1;
            if (plan->color_index && p < MAT_SHININESS)
                continue; /* RGBA materials play no part */
            if (follows && plan->varying >> ATTR_COLOR & 1)
                *source = ATTR_COLOR;
            else if (!follows && (plan->varying >> own & 1))
                *source = own;
            if (*source < 0 || face >= faces || p == MAT_INDEXES)
                continue;
            light->varying = true;
            list_attribute(light, *source);
        }
}

static void derive_constants(struct lighting_plan *plan)
{
    plan->shininess_all_zero = true;
    for (int face = 0; face <= plan->two_sided; face++) {
        const float *shininess = plan->material[MAT_SHININESS][face];
        const float *ambient = plan->material[MAT_AMBIENT][face],
                    *emission = plan->material[MAT_EMISSION][face];

        for (int c = 0; c < 3; c++)
            plan->base[face][c] = plan->model_ambient[c] * ambient[c] + emission[c];
        plan->base[face][3] = plan->material[MAT_DIFFUSE][face][3];
        plan->shininess[face] = fmaxf(fminf(shininess[0], FGL_MAX_SHININESS), -FGL_MAX_SHININESS);
        if (shininess[0] != 0.0f || plan->source[MAT_SHININESS][face] >= 0)
            plan->shininess_all_zero = false;
    }
}

/* Lights
 * ------------------------------------------------------------------------------------------------------ */

/* position, direction and half vector in the lighting space. */
static void derive_geometry(struct light_derived *out, const struct light *light,
                            const struct lighting_plan *plan, const float inverse[16])
{
    const double radians_per_degree = 3.14159265358979323846 / 180.0;
    const float *p = light->position;

    for (int r = 0; r < 3; r++)
        out->position[r] = plan->object_space ? inverse[r] * p[0] + inverse[4 + r] * p[1] +
                                                        inverse[8 + r] * p[2] + inverse[12 + r] * p[3]
                                              : p[r];
    memcpy(out->direction, out->position, sizeof out->direction);
    normalize(out->direction);
    for (int c = 0; c < 3; c++)
        out->half[c] = out->direction[c] + plan->view_direction[c];
    normalize(out->half);
    if (p[3] != 0.0f) {
        const float inverse_w = 1.0f / p[3];
        for (int c = 0; c < 3; c++)
            out->position[c] *= inverse_w;
    }

    memcpy(out->spot_direction, light->spot_direction, sizeof out->spot_direction);
    normalize(out->spot_direction);
    normalize(out->spot_direction); /* OSMesa rule: twice, which can move the last bit */
    out->spot_exponent = light->spot_exponent;
    out->cos_cutoff = fmaxf(cosf((float)((double)light->spot_cutoff * radians_per_degree)), 0.0f);
    out->k0 = light->constant_attenuation;
    out->k1 = light->linear_attenuation;
    out->k2 = light->quadratic_attenuation;
}

/* Colours and their products with the material. */
static void derive_products(struct light_derived *out, const struct light *light,
                            const struct lighting_plan *plan)
{
    const float *const own[COLOR_COUNT] = {light->ambient, light->diffuse, light->specular};

    for (int color = 0; color < COLOR_COUNT; color++)
        for (int c = 0; c < 3; c++) {
            out->color[color][c] = own[color][c];
            for (int face = 0; face < 2; face++)
                out->product[face][color][c] = own[color][c] * plan->material[MAT_AMBIENT + color][face][c];
        }
}

/* Whether a product can be other than zero on a face in use. */
static bool contributes(const struct light_derived *light, const struct lighting_plan *plan, int color)
{
    for (int face = 0; face <= plan->two_sided; face++) {
        const bool varying = plan->source[MAT_AMBIENT + color][face] >= 0;
        if (!is_zero(varying ? light->color[color] : light->product[face][color]))
            return true;
    }
    return false;
}

static unsigned light_key(const struct light_derived *out, const struct light *light,
                          const struct lighting_plan *plan)
{
    unsigned key = 0;

    if (light->position[3] != 0.0f)
        key |= LIGHT_POSITIONAL | (is_attenuated(light) ? LIGHT_ATTENUATED : 0);
    if (is_spot(light))
        key |= LIGHT_SPOT;
    if (plan->varying)
        key |= LIGHT_VARYING;
    if (contributes(out, plan, COLOR_SPECULAR)) {
        key |= LIGHT_SPECULAR | (plan->separate_specular ? LIGHT_SEPARATE : 0);
        key |= plan->specular_vector ? LIGHT_REFLECTION : 0;
        key |= plan->shininess_all_zero ? LIGHT_ZERO_SHININESS : plan->local_viewer ? LIGHT_LOCAL_VIEWER : 0;
    }
    return key;
}

static void derive_lights(struct vertex_plan *vertex, const struct lighting_state *state,
                          const float inverse[16])
{
    struct lighting_plan *plan = &vertex->light;

    plan->n = 0;
    vertex->need_eye = vertex->need_view = vertex->need_normal = false;
    for (int i = 0; i < FGL_MAX_LIGHTS; i++) {
        const struct light *light = &state->light[i];
        struct light_derived *out = &plan->light[plan->n];

        if (!light->enabled)
            continue;
        out->number = i;
        derive_geometry(out, light, plan, inverse);
        derive_products(out, light, plan);
        out->key = light_key(out, light, plan);
        if (!contributes(out, plan, COLOR_AMBIENT) && !contributes(out, plan, COLOR_DIFFUSE) &&
            !(out->key & LIGHT_SPECULAR))
            continue;
        plan->n++;
        vertex->need_normal = true;
        vertex->need_eye |= (out->key & (LIGHT_POSITIONAL | LIGHT_LOCAL_VIEWER)) != 0;
        vertex->need_view |= (out->key & LIGHT_LOCAL_VIEWER) != 0;
    }
}

/* Normals
 * ----------------------------------------------------------------------------------------------------- */

static void derive_normals(struct vertex_plan *plan, const struct transform_state *transform,
                           const float inverse[16], unsigned modelview_class)
{
    const bool keeps_lengths = !(modelview_class & ~(unsigned)(MAT_ROTATION | MAT_TRANSLATION));

    plan->normal_in_eye_space = !plan->light.object_space;
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++)
            plan->normal_matrix[r][k] = inverse[4 * r + k];

    /* GL 1.5, 2.11.3 "Normal Transformation": the factor from the third row of the inverse. */
    float square = inverse[2] * inverse[2] + inverse[6] * inverse[6] + inverse[10] * inverse[10];
    plan->rescale_factor = keeps_lengths || square < 1e-12f ? 1.0f : 1.0f / sqrtf(square);
    plan->normal_scaling = NORMAL_AS_IS;
    if (transform->normalize)
        plan->normal_scaling = NORMAL_NORMALIZE;
    else if (transform->rescale_normal && plan->normal_in_eye_space && plan->rescale_factor != 1.0f)
        plan->normal_scaling = NORMAL_RESCALE;
}

/* Color index lighting in the terms of RGBA lighting (GL 1.5, 2.14.5 "Color Index Lighting"): lights have
 * intensities, .30 R + .59 G + .11 B, instead of colours and no ambient part, and the material reflects all of
 * them; the diffuse sum and the specular one are wanted apart. */
static void take_intensities(struct lighting_state *to, const struct lighting_state *from)
{
    *to = *from;
    to->color_material = false;
    to->light_model_color_control = GL_SEPARATE_SPECULAR_COLOR;
    memset(to->light_model_ambient, 0, sizeof to->light_model_ambient);
    for (int face = 0; face < 2; face++)
        for (int c = 0; c < 4; c++) {
            to->material[MAT_AMBIENT][face][c] = to->material[MAT_EMISSION][face][c] = 0.0f;
            to->material[MAT_DIFFUSE][face][c] = to->material[MAT_SPECULAR][face][c] = 1.0f;
        }
    for (int i = 0; i < FGL_MAX_LIGHTS; i++) {
        const float *d = from->light[i].diffuse, *s = from->light[i].specular;
        for (int c = 0; c < 3; c++) {
            to->light[i].ambient[c] = 0.0f;
            to->light[i].diffuse[c] = 0.30f * d[0] + 0.59f * d[1] + 0.11f * d[2];
            to->light[i].specular[c] = 0.30f * s[0] + 0.59f * s[1] + 0.11f * s[2];
        }
    }
}

void fgl_normals_validate(struct vertex_plan *plan, struct context *ctx)
{
    struct matrix *modelview = &ctx->modelview.entry[ctx->modelview.top];
    const unsigned modelview_class = fgl_matrix_class(modelview);

    plan->light.object_space = false;
    derive_normals(plan, &ctx->s.transform, fgl_matrix_inverse(modelview), modelview_class);
}

void fgl_light_validate(struct vertex_plan *plan, struct context *ctx)
{
    struct lighting_state intensities;
    const struct lighting_state *state = &ctx->s.lighting;
    if (plan->color_index) {
        take_intensities(&intensities, state);
        state = &intensities;
    }
    struct matrix *modelview = &ctx->modelview.entry[ctx->modelview.top];
    const unsigned modelview_class = fgl_matrix_class(modelview);
    const float *inverse = fgl_matrix_inverse(modelview);
    struct lighting_plan *light = &plan->light;

    light->two_sided = state->light_model_two_side;
    light->local_viewer = state->light_model_local_viewer;
    light->separate_specular = state->light_model_color_control == GL_SEPARATE_SPECULAR_COLOR;
    light->specular_vector = state->light_model_specular_vector;
    light->object_space = in_object_space(&ctx->s, modelview_class, plan->light_fragments);
    memcpy(light->model_ambient, state->light_model_ambient, sizeof light->model_ambient);
    for (int c = 0; c < 3; c++)
        light->view_direction[c] = light->object_space ? modelview->m[4 * c + 2] : c == 2 ? 1.0f : 0.0f;

    derive_materials(plan, state);
    derive_constants(light);
    derive_lights(plan, state, inverse);
    derive_normals(plan, &ctx->s.transform, inverse, modelview_class);
}
