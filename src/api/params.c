/* Parameters by name: look-up, ranges, conversions. See params.h. */
#include "api/params.h"

#include "api/command.h"
#include "api/convert.h"
#include "api/set.h"

#include <math.h>
#include <string.h>

#define ANY -INFINITY, INFINITY
#define BETWEEN(lo, hi) (float)(lo), (float)(hi)
#define NOT_NEGATIVE 0.0f, INFINITY

#define NO_ROW(...)

static const struct param light_params[] = {
#define LIGHT(pname, count, kind, range, field)                                                              \
    {pname, PARAM_##kind, count, range, offsetof(struct light, field)},
#define LIGHT_MODEL NO_ROW
#define MATERIAL NO_ROW
#define FOG NO_ROW
#define POINT NO_ROW
#define TEXTURE NO_ROW
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param light_model_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL(pname, count, kind, range, field)                                                        \
    {pname, PARAM_##kind, count, range, offsetof(struct lighting_state, field)},
#define MATERIAL NO_ROW
#define FOG NO_ROW
#define POINT NO_ROW
#define TEXTURE NO_ROW
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param material_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL NO_ROW
#define MATERIAL(pname, count, kind, range) {pname, PARAM_##kind, count, range, 0},
#define FOG NO_ROW
#define POINT NO_ROW
#define TEXTURE NO_ROW
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param fog_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL NO_ROW
#define MATERIAL NO_ROW
#define FOG(pname, count, kind, range, field)                                                                \
    {pname, PARAM_##kind, count, range, offsetof(struct fog_state, field)},
#define POINT NO_ROW
#define TEXTURE NO_ROW
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param point_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL NO_ROW
#define MATERIAL NO_ROW
#define FOG NO_ROW
#define POINT(pname, count, kind, range, field)                                                              \
    {pname, PARAM_##kind, count, range, offsetof(struct point_state, field)},
#define TEXTURE NO_ROW
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param texture_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL NO_ROW
#define MATERIAL NO_ROW
#define FOG NO_ROW
#define POINT NO_ROW
#define TEXTURE(pname, count, kind, range, field)                                                            \
    {pname, PARAM_##kind, count, range, offsetof(struct texture_parameters, field)},
#define TEXTURE_ENV NO_ROW
#include "api/param_table.def"
};

static const struct param texture_env_params[] = {
#define LIGHT NO_ROW
#define LIGHT_MODEL NO_ROW
#define MATERIAL NO_ROW
#define FOG NO_ROW
#define POINT NO_ROW
#define TEXTURE NO_ROW
#define TEXTURE_ENV(pname, count, kind, range, field)                                                        \
    {pname, PARAM_##kind, count, range, offsetof(struct texture_env, field)},
#include "api/param_table.def"
    {GL_COORD_REPLACE_ARB, PARAM_BOOL, 1, BETWEEN(0, 1), 0}, /* target GL_POINT_SPRITE_ARB: in struct point_state */
};

static const struct param *find(const struct param *rows, size_t n, GLenum pname)
{
    for (size_t i = 0; i < n; i++) {
        if (rows[i].pname == pname)
            return &rows[i];
    }
    return NULL;
}

#define FIND(rows, pname) find((rows), FGL_COUNTOF(rows), (pname))

const struct param *fgl_light_param(GLenum pname)
{
    return FIND(light_params, pname);
}
const struct param *fgl_light_model_param(GLenum pname)
{
    return FIND(light_model_params, pname);
}
const struct param *fgl_material_param(GLenum pname)
{
    return FIND(material_params, pname);
}
const struct param *fgl_fog_param(GLenum pname)
{
    return FIND(fog_params, pname);
}
const struct param *fgl_point_param(GLenum pname)
{
    return FIND(point_params, pname);
}

const struct param *fgl_texture_param(GLenum pname)
{
    return FIND(texture_params, pname);
}
const struct param *fgl_texture_env_param(GLenum pname)
{
    return FIND(texture_env_params, pname);
}

static int count_of(const struct param *p)
{
    return p ? p->count : 0;
}

int fgl_count_light(GLenum pname)
{
    return count_of(fgl_light_param(pname));
}
int fgl_count_light_model(GLenum pname)
{
    return count_of(fgl_light_model_param(pname));
}
int fgl_count_fog(GLenum pname)
{
    return count_of(fgl_fog_param(pname));
}
int fgl_count_point(GLenum pname)
{
    return count_of(fgl_point_param(pname));
}

int fgl_count_texture(GLenum pname)
{
    return count_of(fgl_texture_param(pname));
}
int fgl_count_texture_env(GLenum pname)
{
    return count_of(fgl_texture_env_param(pname));
}

bool fgl_param_allows(const struct param *p, const float *v)
{
    if (p->kind == PARAM_INT)
        return v[0] >= p->min && v[0] <= p->max;
    return !(v[0] < p->min) && !(v[0] > p->max); /* OSMesa rule: NaN is let through, where it is no integer */
}

void fgl_param_set(struct context *ctx, unsigned dirty, const struct param *p, void *object, const float *v)
{
    void *field = (char *)object + p->offset;

    switch (p->kind) {
    case PARAM_FLOAT:
    case PARAM_COLOR: fgl_set_floats(ctx, dirty, field, v, p->count); break;
    case PARAM_BOOL: SET(ctx, dirty, *(bool *)field, v[0] != 0.0f); break;
    case PARAM_INT: SET(ctx, dirty, *(int *)field, fgl_int_round((double)v[0])); break;
    case PARAM_ENUM:
        for (int i = 0; i < p->count; i++)
            SET(ctx, dirty, ((GLenum *)field)[i], fgl_enum_from_float(v[i]));
        break;
    }
}

void fgl_param_set_clamped(struct context *ctx, unsigned dirty, const struct param *p, void *object, const float *v)
{
    float clamped[4];

    for (int i = 0; i < p->count; i++)
        clamped[i] = p->kind == PARAM_COLOR ? fgl_clamp01(v[i]) : v[i];
    fgl_param_set(ctx, dirty, p, object, clamped);
}

GLenum fgl_param_scalar(const struct param *p)
{
    return count_of(p) == 1 ? p->pname : GL_NONE;
}

void fgl_param_get(const struct param *p, const void *object, float *v)
{
    const void *field = (const char *)object + p->offset;

    switch (p->kind) {
    case PARAM_FLOAT:
    case PARAM_COLOR: memcpy(v, field, (size_t)p->count * sizeof *v); break;
    case PARAM_BOOL: v[0] = *(const bool *)field; break;
    case PARAM_INT: v[0] = (float)*(const int *)field; break;
    case PARAM_ENUM:
        for (int i = 0; i < p->count; i++)
            v[i] = (float)((const GLenum *)field)[i];
        break;
    }
}

void fgl_param_from_ints(const struct param *p, const GLint *in, float out[4])
{
    for (int i = 0; i < count_of(p); i++)
        out[i] = p->kind == PARAM_COLOR ? fgl_float_from_int_color(in[i]) : (float)in[i];
}

void fgl_param_to_ints(const struct param *p, const float *in, GLint *out)
{
    for (int i = 0; i < p->count; i++) {
        const double v = (double)in[i];
        out[i] = p->kind == PARAM_COLOR ? fgl_int_from_normalized(v) : fgl_int_round(v);
    }
}
