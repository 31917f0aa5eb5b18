/* Color tables (GL 1.5, 3.6.3 "Color Table Specification"; queries 6.1.7 "Color Table Query"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/imaging.h"
#include "api/set.h"

#include <stdlib.h>
#include <string.h>

static bool find_table(GLenum target, int *table)
{
    *table = (int)target - GL_COLOR_TABLE;
    return *table >= 0 && *table < COLOR_TABLES;
}

static bool find_proxy(GLenum target, int *table)
{
    *table = (int)target - GL_PROXY_COLOR_TABLE;
    return *table >= 0 && *table < COLOR_TABLES;
}

/* ---- specification ---- */

/* Entries from `start` on: clamped to [0,1], each component from where the format has it. */
static void set_entries(struct color_table *table, int start, const struct color_image *image)
{
    for (int c = 0; c < 4; c++) {
        const int source = fgl_imaging_source(table->format.base_format, c);
        for (int i = 0; source >= 0 && i < image->width; i++)
            table->value[c][start + i] = fgl_clamp01(image->color[4 * i + source]);
    }
}

static void set_proxy(struct imaging_format *proxy, const struct imaging_format *format)
{
    *proxy = format->width <= FGL_MAX_COLOR_TABLE ? *format : (struct imaging_format){0};
}

static void define(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels)
{
    int index;
    struct imaging_format format;
    struct color_image image;
    const bool proxy = !call->copy && find_proxy(call->target, &index);
    RETURN_ERROR_IF(ctx, !proxy && !find_table(call->target, &index), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_imaging_format(call->internal_format, call->width, &format), GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_source_error(ctx, call);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging_width(call->width), GL_INVALID_VALUE);
    if (proxy) {
        set_proxy(&ctx->imaging->proxy_table[index], &format);
        return;
    }
    RETURN_ERROR_IF(ctx, call->width > FGL_MAX_COLOR_TABLE, GL_TABLE_TOO_LARGE);
    struct color_table *table = &ctx->imaging->table[index];
    if (!fgl_imaging_colors(ctx, call, pixels, 0, call->width, 1, &ctx->s.pixel_mode.imaging.color_table_transform[index], &image))
        return;
    table->format = format;
    set_entries(table, 0, &image);
    free(image.color);
}

static void replace(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels)
{
    int index;
    struct color_image image;
    RETURN_ERROR_IF(ctx, !find_table(call->target, &index), GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_source_error(ctx, call);
    RETURN_ERROR_IF(ctx, error, error);
    struct color_table *table = &ctx->imaging->table[index];
    RETURN_ERROR_IF(ctx, call->start < 0 || call->width < 0 || (int64_t)call->start + call->width > table->format.width,
                    GL_INVALID_VALUE);
    if (!fgl_imaging_colors(ctx, call, pixels, 0, call->width, 1, &ctx->s.pixel_mode.imaging.color_table_transform[index], &image))
        return;
    set_entries(table, call->start, &image);
    free(image.color);
}

void fgl_color_table_execute(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels)
{
    if (call->image == IMAGE_COLOR_TABLE)
        define(ctx, call, pixels);
    else
        replace(ctx, call, pixels);
}

void GLAPIENTRY glColorTable(GLenum target, GLenum internalformat, GLsizei width, GLenum format, GLenum type, const GLvoid *table)
{
    const struct imaging_call call = {.image = IMAGE_COLOR_TABLE, .target = target, .internal_format = internalformat,
                                      .format = format, .type = type, .width = width, .height = 1};
    fgl_imaging_command(&call, table, NULL);
}

void GLAPIENTRY glColorSubTable(GLenum target, GLsizei start, GLsizei count, GLenum format, GLenum type, const GLvoid *data)
{
    const struct imaging_call call = {.image = IMAGE_COLOR_SUB_TABLE, .target = target, .format = format, .type = type,
                                      .start = start, .width = count, .height = 1};
    fgl_imaging_command(&call, data, NULL);
}

void GLAPIENTRY glCopyColorTable(GLenum target, GLenum internalformat, GLint x, GLint y, GLsizei width)
{
    const struct imaging_call call = {.image = IMAGE_COLOR_TABLE, .target = target, .internal_format = internalformat,
                                      .width = width, .height = 1, .copy = true, .x = x, .y = y};
    fgl_imaging_command(&call, NULL, NULL);
}

void GLAPIENTRY glCopyColorSubTable(GLenum target, GLsizei start, GLint x, GLint y, GLsizei width)
{
    const struct imaging_call call = {.image = IMAGE_COLOR_SUB_TABLE, .target = target, .start = start, .width = width,
                                      .height = 1, .copy = true, .x = x, .y = y};
    fgl_imaging_command(&call, NULL, NULL);
}

/* ---- parameters ---- */

int fgl_count_color_table(GLenum pname)
{
    return pname == GL_COLOR_TABLE_SCALE || pname == GL_COLOR_TABLE_BIAS ? 4 : 0;
}

/* NULL after recording an error. */
static float *find_parameter(struct context *ctx, GLenum target, GLenum pname)
{
    int index;
    RETURN_VALUE_ERROR_IF(ctx, !find_table(target, &index) || !fgl_count_color_table(pname), GL_INVALID_ENUM, NULL);
    struct scale_bias *t = &ctx->s.pixel_mode.imaging.color_table_transform[index];
    return pname == GL_COLOR_TABLE_SCALE ? t->scale : t->bias;
}

void fgl_exec_ColorTableParameterfv(struct context *ctx, GLenum target, GLenum pname, const GLfloat *params)
{
    float *parameter = find_parameter(ctx, target, pname);
    if (parameter)
        fgl_set_floats(ctx, 0, parameter, params, 4);
}

void GLAPIENTRY glColorTableParameteriv(GLenum target, GLenum pname, const GLint *params)
{
    GLfloat v[4] = {0};
    for (int i = 0; i < fgl_count_color_table(pname); i++)
        v[i] = (GLfloat)params[i];
    glColorTableParameterfv(target, pname, v);
}

/* ---- queries ---- */

void fgl_exec_GetColorTable(struct context *ctx, GLenum target, GLenum format, GLenum type, GLvoid *table)
{
    int index;
    RETURN_ERROR_IF(ctx, !find_table(target, &index), GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_pixels_error(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    const struct color_table *t = &ctx->imaging->table[index];
    const float *const value[4] = {t->value[0], t->value[1], t->value[2], t->value[3]};
    fgl_imaging_return(ctx, t->format.base_format, format, type, value, t->format.width, 1, table);
}

/* The number of values; 0 after recording an error. */
static int get(struct context *ctx, GLenum target, GLenum pname, float v[4])
{
    int index;
    const bool proxy = find_proxy(target, &index);
    if (!proxy && fgl_count_color_table(pname)) {
        const float *parameter = find_parameter(ctx, target, pname);
        if (parameter)
            memcpy(v, parameter, 4 * sizeof *v);
        return parameter ? 4 : 0;
    }
    RETURN_VALUE_ERROR_IF(ctx, !proxy && !find_table(target, &index), GL_INVALID_ENUM, 0);
    RETURN_VALUE_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY, 0);
    const struct imaging_format *f = proxy ? &ctx->imaging->proxy_table[index] : &ctx->imaging->table[index].format;
    switch (pname) {
    case GL_COLOR_TABLE_FORMAT: v[0] = (float)f->internal_format; return 1;
    case GL_COLOR_TABLE_WIDTH: v[0] = (float)f->width; return 1;
    case GL_COLOR_TABLE_RED_SIZE:
    case GL_COLOR_TABLE_GREEN_SIZE:
    case GL_COLOR_TABLE_BLUE_SIZE:
    case GL_COLOR_TABLE_ALPHA_SIZE:
    case GL_COLOR_TABLE_LUMINANCE_SIZE:
    case GL_COLOR_TABLE_INTENSITY_SIZE: v[0] = (float)fgl_imaging_size(f, pname - GL_COLOR_TABLE_RED_SIZE); return 1;
    default: fgl_error(ctx, GL_INVALID_ENUM); return 0;
    }
}

void fgl_exec_GetColorTableParameterfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    float v[4];
    const int n = get(ctx, target, pname, v);
    memcpy(params, v, (size_t)n * sizeof *v);
}

void fgl_exec_GetColorTableParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    float v[4];
    const int n = get(ctx, target, pname, v);
    for (int i = 0; i < n; i++)
        params[i] = fgl_int_round((double)v[i]);
}
