/* Histogram and minimum/maximum (GL 1.5, 3.6.3 "Histogram Table Specification", "Minmax Table Specification"; queries 6.1.9, 6.1.10). */
#include "api/command.h"
#include "api/convert.h"
#include "api/imaging.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "api/set.h"
#include "framebuffer/pixel_pack.h"

#include <string.h>

/* Intensity cannot be counted. */
static bool find_format(GLenum internal_format, int width, struct imaging_format *format)
{
    return fgl_imaging_format(internal_format, width, format) && format->base_format != GL_INTENSITY;
}

/* ---- specification ---- */

static void specify_histogram(struct context *ctx, GLenum target, GLsizei width, GLenum internal_format, bool sink)
{
    struct imaging_format format;
    const bool proxy = target == GL_PROXY_HISTOGRAM;
    RETURN_ERROR_IF(ctx, target != GL_HISTOGRAM && !proxy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_imaging_width(width), GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, !find_format(internal_format, width, &format), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !proxy && width > FGL_MAX_HISTOGRAM, GL_TABLE_TOO_LARGE);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    struct histogram *histogram = &ctx->imaging->histogram;
    if (proxy) {
        ctx->imaging->proxy_histogram = width <= FGL_MAX_HISTOGRAM ? format : (struct imaging_format){0};
        return;
    }
    histogram->format = format;
    histogram->sink = sink;
    memset(histogram->count, 0, sizeof histogram->count);
}

struct histogram_node {
    GLenum target, internal_format;
    GLsizei width;
    GLboolean sink;
};

void fgl_list_replay_histogram(struct context *ctx, const void *payload)
{
    const struct histogram_node *n = payload;
    specify_histogram(ctx, n->target, n->width, n->internal_format, n->sink);
}

/* A proxy's is never compiled (GL 1.5, 5.4). */
void GLAPIENTRY glHistogram(GLenum target, GLsizei width, GLenum internalformat, GLboolean sink)
{
    struct context *ctx = fgl_current;
    if (!ctx || fgl_refused_inside(ctx))
        return;
    const bool compiled = ctx->compiling && target != GL_PROXY_HISTOGRAM;
    struct histogram_node *node = compiled ? fgl_list_record(ctx, OP_HISTOGRAM, sizeof *node) : NULL;
    if (node)
        *node = (struct histogram_node){target, internalformat, width, sink};
    if (!compiled || ctx->compiling == GL_COMPILE_AND_EXECUTE)
        specify_histogram(ctx, target, width, internalformat, sink);
}

void fgl_exec_Minmax(struct context *ctx, GLenum target, GLenum internalformat, GLboolean sink)
{
    struct imaging_format format;
    RETURN_ERROR_IF(ctx, target != GL_MINMAX, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !find_format(internalformat, 2, &format), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    ctx->imaging->minmax.format = format;
    ctx->imaging->minmax.sink = sink;
    fgl_minmax_reset(&ctx->imaging->minmax);
}

void fgl_exec_ResetHistogram(struct context *ctx, GLenum target)
{
    RETURN_ERROR_IF(ctx, target != GL_HISTOGRAM, GL_INVALID_ENUM);
    if (ctx->imaging)
        memset(ctx->imaging->histogram.count, 0, sizeof ctx->imaging->histogram.count);
}

void fgl_exec_ResetMinmax(struct context *ctx, GLenum target)
{
    RETURN_ERROR_IF(ctx, target != GL_MINMAX, GL_INVALID_ENUM);
    if (ctx->imaging)
        fgl_minmax_reset(&ctx->imaging->minmax);
}

/* ---- queries ---- */

static bool return_counts(struct context *ctx, const struct histogram *histogram, GLenum format, GLenum type, void *values)
{
    static const uint32_t zeros[PIXEL_CHUNK];
    const int width = histogram->format.width;
    const void *to = values;
    if (!fgl_buffer_image(ctx, &ctx->client.pack, format, type, width, 1, &to))
        return false;
    const struct pixel_pack pack = {.image = fgl_pixel_image(&ctx->client.pack, format, type, width, to)};
    for (int x = 0; x < width; x += PIXEL_CHUNK) {
        const uint32_t *count[4];
        for (int c = 0; c < 4; c++)
            count[c] = fgl_imaging_has(histogram->format.base_format, c) ? histogram->count[c] + x : zeros;
        fgl_pack_counts(&pack, count, fgl_min(PIXEL_CHUNK, width - x), 0, x);
    }
    return true;
}

void fgl_exec_GetHistogram(struct context *ctx, GLenum target, GLboolean reset, GLenum format, GLenum type, GLvoid *values)
{
    RETURN_ERROR_IF(ctx, target != GL_HISTOGRAM, GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_pixels_error(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    if (return_counts(ctx, &ctx->imaging->histogram, format, type, values) && reset)
        fgl_exec_ResetHistogram(ctx, target);
}

void fgl_exec_GetMinmax(struct context *ctx, GLenum target, GLboolean reset, GLenum format, GLenum type, GLvoid *values)
{
    RETURN_ERROR_IF(ctx, target != GL_MINMAX, GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_pixels_error(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    const struct minmax *m = &ctx->imaging->minmax;
    const float *const value[4] = {m->value[0], m->value[1], m->value[2], m->value[3]};
    if (fgl_imaging_return(ctx, m->format.base_format, format, type, value, 2, 1, values) && reset)
        fgl_exec_ResetMinmax(ctx, target);
}

/* False after recording an error. */
static bool get_histogram(struct context *ctx, GLenum target, GLenum pname, int *v)
{
    const bool proxy = target == GL_PROXY_HISTOGRAM;
    RETURN_VALUE_ERROR_IF(ctx, target != GL_HISTOGRAM && !proxy, GL_INVALID_ENUM, false);
    RETURN_VALUE_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY, false);
    const struct imaging_format *f = proxy ? &ctx->imaging->proxy_histogram : &ctx->imaging->histogram.format;
    switch (pname) {
    case GL_HISTOGRAM_WIDTH: *v = f->width; return true;
    case GL_HISTOGRAM_FORMAT: *v = (int)f->internal_format; return true;
    case GL_HISTOGRAM_RED_SIZE:
    case GL_HISTOGRAM_GREEN_SIZE:
    case GL_HISTOGRAM_BLUE_SIZE:
    case GL_HISTOGRAM_ALPHA_SIZE:
    case GL_HISTOGRAM_LUMINANCE_SIZE: *v = fgl_imaging_size(f, pname - GL_HISTOGRAM_RED_SIZE); return true;
    case GL_HISTOGRAM_SINK:
        *v = ctx->imaging->histogram.sink;
        RETURN_VALUE_ERROR_IF(ctx, proxy, GL_INVALID_ENUM, false);
        return true;
    default: fgl_error(ctx, GL_INVALID_ENUM); return false;
    }
}

void fgl_exec_GetHistogramParameterfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    int v;
    if (get_histogram(ctx, target, pname, &v))
        *params = (GLfloat)v;
}

void fgl_exec_GetHistogramParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    int v;
    if (get_histogram(ctx, target, pname, &v))
        *params = v;
}

static bool get_minmax(struct context *ctx, GLenum target, GLenum pname, int *v)
{
    RETURN_VALUE_ERROR_IF(ctx, target != GL_MINMAX || (pname != GL_MINMAX_FORMAT && pname != GL_MINMAX_SINK), GL_INVALID_ENUM, false);
    RETURN_VALUE_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY, false);
    *v = pname == GL_MINMAX_FORMAT ? (int)ctx->imaging->minmax.format.internal_format : ctx->imaging->minmax.sink;
    return true;
}

void fgl_exec_GetMinmaxParameterfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    int v;
    if (get_minmax(ctx, target, pname, &v))
        *params = (GLfloat)v;
}

void fgl_exec_GetMinmaxParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    int v;
    if (get_minmax(ctx, target, pname, &v))
        *params = v;
}
