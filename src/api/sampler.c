/* Sampler objects: names, bindings, parameters (GL_ARB_sampler_objects). */
#include "api/sampler.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/params.h"
#include "api/texture_target.h"

#include <stdlib.h>
#include <string.h>

struct sampler_store {
    atomic_int references;
    struct idmap map; /* name -> struct sampler_object */
};

static void release(void *value)
{
    fgl_sampler_release(value);
}

struct sampler_store *fgl_sampler_store_create(void)
{
    struct sampler_store *store = calloc(1, sizeof *store);
    if (store)
        atomic_init(&store->references, 1);
    return store;
}

void fgl_sampler_store_retain(struct sampler_store *store)
{
    atomic_fetch_add(&store->references, 1);
}

void fgl_sampler_store_release(struct sampler_store *store)
{
    if (!store || atomic_fetch_sub(&store->references, 1) != 1)
        return;
    fgl_idmap_free(&store->map, release);
    free(store);
}

/* ---- names ---- */

/* A new object under a free name; its one reference is the name's. False after recording GL_OUT_OF_MEMORY. */
static bool add(struct context *ctx, GLuint name)
{
    struct sampler_object *sampler = calloc(1, sizeof *sampler);
    if (!sampler || !fgl_idmap_put(&ctx->samplers->map, name, sampler)) {
        free(sampler);
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return false;
    }
    atomic_init(&sampler->references, 1);
    sampler->name = name;
    fgl_texture_init_parameters(&sampler->parameters);
    return true;
}

/* OSMesa rule: the objects are made at once. */
void fgl_exec_GenSamplers(struct context *ctx, GLsizei count, GLuint *samplers)
{
    RETURN_ERROR_IF(ctx, count < 0, GL_INVALID_VALUE);
    const GLuint first = count ? fgl_idmap_find_free(&ctx->samplers->map, (uint32_t)count) : 0;
    for (GLuint i = 0; first && i < (GLuint)count; i++) {
        if (!add(ctx, first + i))
            return;
        samplers[i] = first + i;
    }
}

/* Units of this context draw without a deleted object, those of others with it until they bind another. */
void fgl_exec_DeleteSamplers(struct context *ctx, GLsizei count, const GLuint *samplers)
{
    RETURN_ERROR_IF(ctx, count < 0, GL_INVALID_VALUE);
    fgl_flush_vertices(ctx, DIRTY_TEXTURE);
    for (GLsizei i = 0; i < count; i++) {
        struct sampler_object *sampler = samplers[i] ? fgl_idmap_remove(&ctx->samplers->map, samplers[i]) : NULL;
        for (int unit = 0; sampler && unit < FGL_MAX_TEXTURE_UNITS; unit++)
            if (ctx->s.texture.unit[unit].sampler == sampler)
                fgl_sampler_bind(&ctx->s.texture.unit[unit].sampler, NULL);
        fgl_sampler_release(sampler);
    }
}

GLboolean fgl_exec_IsSampler(struct context *ctx, GLuint sampler)
{
    return fgl_idmap_get(&ctx->samplers->map, sampler) ? GL_TRUE : GL_FALSE;
}

void fgl_exec_BindSampler(struct context *ctx, GLuint unit, GLuint name)
{
    RETURN_ERROR_IF(ctx, unit >= FGL_MAX_TEXTURE_UNITS, GL_INVALID_VALUE);
    struct sampler_object **bound = &ctx->s.texture.unit[unit].sampler, *sampler = fgl_idmap_get(&ctx->samplers->map, name);
    RETURN_ERROR_IF(ctx, name && !sampler, GL_INVALID_OPERATION);
    if (*bound == sampler)
        return;
    fgl_flush_vertices(ctx, DIRTY_TEXTURE);
    fgl_sampler_bind(bound, sampler);
}

/* ---- parameters ---- */

/* The row of a parameter that samplers have; NULL: none. */
static const struct param *param_of(GLenum pname)
{
    switch (pname) {
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R:
    case GL_TEXTURE_MIN_FILTER:
    case GL_TEXTURE_MAG_FILTER:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_TEXTURE_MIN_LOD:
    case GL_TEXTURE_MAX_LOD:
    case GL_TEXTURE_LOD_BIAS:
    case GL_TEXTURE_COMPARE_MODE:
    case GL_TEXTURE_COMPARE_FUNC: return fgl_texture_param(pname);
    default: return NULL;
    }
}

int fgl_count_sampler(GLenum pname)
{
    const struct param *p = param_of(pname);
    return p ? p->count : 0;
}

void fgl_exec_SamplerParameterfv(struct context *ctx, GLuint name, GLenum pname, const GLfloat *params)
{
    struct sampler_object *sampler = fgl_idmap_get(&ctx->samplers->map, name);
    const struct param *p = param_of(pname);
    RETURN_ERROR_IF(ctx, !sampler, GL_INVALID_OPERATION);
    RETURN_ERROR_IF(ctx, !p || !fgl_texture_enums_allowed(p, params), GL_INVALID_ENUM);
    fgl_param_set(ctx, DIRTY_TEXTURE, p, &sampler->parameters, params);
}

void fgl_exec_SamplerParameteriv(struct context *ctx, GLuint name, GLenum pname, const GLint *params)
{
    float v[4] = {0};
    fgl_param_from_ints(param_of(pname), params, v);
    fgl_exec_SamplerParameterfv(ctx, name, pname, v);
}

/* The pname if a scalar form takes it. */
static GLenum scalar(GLenum pname)
{
    return fgl_param_scalar(param_of(pname));
}

void fgl_exec_SamplerParameterf(struct context *ctx, GLuint name, GLenum pname, GLfloat param)
{
    fgl_exec_SamplerParameterfv(ctx, name, scalar(pname), &param);
}

void fgl_exec_SamplerParameteri(struct context *ctx, GLuint name, GLenum pname, GLint param)
{
    fgl_exec_SamplerParameteriv(ctx, name, scalar(pname), &param);
}

/* A border colour is kept as the integers that were given, which only glGetSamplerParameterI understands. */
void fgl_exec_SamplerParameterIiv(struct context *ctx, GLuint name, GLenum pname, const GLint *params)
{
    float bits[4];
    if (pname != GL_TEXTURE_BORDER_COLOR) {
        fgl_exec_SamplerParameteriv(ctx, name, pname, params);
        return;
    }
    memcpy(bits, params, sizeof bits);
    fgl_exec_SamplerParameterfv(ctx, name, pname, bits);
}

void fgl_exec_SamplerParameterIuiv(struct context *ctx, GLuint name, GLenum pname, const GLuint *params)
{
    fgl_exec_SamplerParameterIiv(ctx, name, pname, (const GLint *)params);
}

/* ---- queries ---- */

/* Reads a parameter; NULL after recording an error. */
static const struct param *get(struct context *ctx, GLuint name, GLenum pname, float v[4])
{
    const struct sampler_object *sampler = fgl_idmap_get(&ctx->samplers->map, name);
    const struct param *p = param_of(pname);
    RETURN_VALUE_ERROR_IF(ctx, !sampler, GL_INVALID_OPERATION, NULL);
    RETURN_VALUE_ERROR_IF(ctx, !p, GL_INVALID_ENUM, NULL);
    fgl_param_get(p, &sampler->parameters, v);
    return p;
}

void fgl_exec_GetSamplerParameterfv(struct context *ctx, GLuint name, GLenum pname, GLfloat *params)
{
    float v[4];
    const struct param *p = get(ctx, name, pname, v);
    if (p)
        memcpy(params, v, (size_t)p->count * sizeof *v);
}

void fgl_exec_GetSamplerParameteriv(struct context *ctx, GLuint name, GLenum pname, GLint *params)
{
    float v[4];
    const struct param *p = get(ctx, name, pname, v);
    if (p)
        fgl_param_to_ints(p, v, params);
}

void fgl_exec_GetSamplerParameterIiv(struct context *ctx, GLuint name, GLenum pname, GLint *params)
{
    float v[4];
    const struct param *p = get(ctx, name, pname, v);
    if (p && pname == GL_TEXTURE_BORDER_COLOR)
        memcpy(params, v, sizeof v);
    else if (p)
        fgl_param_to_ints(p, v, params);
}

void fgl_exec_GetSamplerParameterIuiv(struct context *ctx, GLuint name, GLenum pname, GLuint *params)
{
    fgl_exec_GetSamplerParameterIiv(ctx, name, pname, (GLint *)params);
}
