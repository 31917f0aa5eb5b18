/* Convolution filters (GL 1.5, 3.6.3 "Convolution Filter Specification"; queries 6.1.8 "Convolution Query"). */
#include "api/command.h"
#include "api/convert.h"
#include "api/imaging.h"
#include "api/set.h"

#include <stdlib.h>
#include <string.h>

static bool find_filter(GLenum target, int *filter)
{
    *filter = (int)target - GL_CONVOLUTION_1D;
    return *filter >= 0 && *filter < FILTERS;
}

/* ---- specification ---- */

/* The weights of one image. Components that the format does not have are left as they are: 1 at the pixel itself, the filter's
 * middle. */
static void set_weights(float *value, size_t channel_step, GLenum base_format, const struct color_image *image)
{
    const int n = image->width * image->height, middle = image->height / 2 * image->width + image->width / 2;
    for (int c = 0; c < 4; c++) {
        const int source = fgl_imaging_source(base_format, c);
        float *const to = value + (size_t)c * channel_step;
        for (int i = 0; i < n; i++)
            to[i] = source >= 0 ? image->color[4 * i + source] : i == middle ? 1.0f : 0.0f;
    }
}

static GLenum filter_error(struct context *ctx, const struct imaging_call *call, int index, struct imaging_format *format)
{
    if (!find_filter(call->target, &(int){0}) || (int)call->target - GL_CONVOLUTION_1D != index)
        return GL_INVALID_ENUM;
    if (!fgl_imaging_format(call->internal_format, call->width, format))
        return GL_INVALID_ENUM;
    const GLenum error = fgl_imaging_source_error(ctx, call);
    if (error)
        return error;
    const bool fits = call->width >= 0 && call->width <= FGL_MAX_CONVOLUTION && call->height >= 0 && call->height <= FGL_MAX_CONVOLUTION;
    return fits ? GL_NO_ERROR : GL_INVALID_VALUE;
}

void fgl_filter_execute(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels)
{
    const int index = (int)call->image - IMAGE_FILTER_1D;
    const bool separable = index == FILTER_SEPARABLE;
    const struct scale_bias *transform = &ctx->s.pixel_mode.imaging.filter_transform[index];
    struct convolution_filter *filter = &ctx->imaging->filter[index];
    struct imaging_format format;
    struct color_image image, column = {0};
    const GLenum error = filter_error(ctx, call, index, &format);
    RETURN_ERROR_IF(ctx, error, error);
    if (!fgl_imaging_colors(ctx, call, pixels, 0, call->width, separable ? 1 : call->height, transform, &image))
        return;
    if (!separable || fgl_imaging_colors(ctx, call, pixels, 1, call->height, 1, transform, &column)) {
        filter->format = format;
        filter->height = call->height;
        set_weights(filter->value[0], FGL_COUNTOF(filter->value[0]), format.base_format, &image);
        if (separable)
            set_weights(filter->column[0], FGL_COUNTOF(filter->column[0]), format.base_format, &column);
    }
    free(image.color);
    free(column.color);
}

void GLAPIENTRY glConvolutionFilter1D(GLenum target, GLenum internalformat, GLsizei width, GLenum format, GLenum type,
                                      const GLvoid *image)
{
    const struct imaging_call call = {.image = IMAGE_FILTER_1D, .target = target, .internal_format = internalformat,
                                      .format = format, .type = type, .width = width, .height = 1};
    fgl_imaging_command(&call, image, NULL);
}

void GLAPIENTRY glConvolutionFilter2D(GLenum target, GLenum internalformat, GLsizei width, GLsizei height, GLenum format,
                                      GLenum type, const GLvoid *image)
{
    const struct imaging_call call = {.image = IMAGE_FILTER_2D, .target = target, .internal_format = internalformat,
                                      .format = format, .type = type, .width = width, .height = height};
    fgl_imaging_command(&call, image, NULL);
}

void GLAPIENTRY glSeparableFilter2D(GLenum target, GLenum internalformat, GLsizei width, GLsizei height, GLenum format,
                                    GLenum type, const GLvoid *row, const GLvoid *column)
{
    const struct imaging_call call = {.image = IMAGE_FILTER_SEPARABLE, .target = target, .internal_format = internalformat,
                                      .format = format, .type = type, .width = width, .height = height};
    fgl_imaging_command(&call, row, column);
}

void GLAPIENTRY glCopyConvolutionFilter1D(GLenum target, GLenum internalformat, GLint x, GLint y, GLsizei width)
{
    const struct imaging_call call = {.image = IMAGE_FILTER_1D, .target = target, .internal_format = internalformat,
                                      .width = width, .height = 1, .copy = true, .x = x, .y = y};
    fgl_imaging_command(&call, NULL, NULL);
}

void GLAPIENTRY glCopyConvolutionFilter2D(GLenum target, GLenum internalformat, GLint x, GLint y, GLsizei width, GLsizei height)
{
    const struct imaging_call call = {.image = IMAGE_FILTER_2D, .target = target, .internal_format = internalformat,
                                      .width = width, .height = height, .copy = true, .x = x, .y = y};
    fgl_imaging_command(&call, NULL, NULL);
}

/* ---- parameters ---- */

int fgl_count_convolution(GLenum pname)
{
    switch (pname) {
    case GL_CONVOLUTION_BORDER_MODE: return 1;
    case GL_CONVOLUTION_BORDER_COLOR:
    case GL_CONVOLUTION_FILTER_SCALE:
    case GL_CONVOLUTION_FILTER_BIAS: return 4;
    default: return 0;
    }
}

static float *find_vector(struct imaging_state *s, int filter, GLenum pname)
{
    switch (pname) {
    case GL_CONVOLUTION_BORDER_COLOR: return s->border_color[filter];
    case GL_CONVOLUTION_FILTER_SCALE: return s->filter_transform[filter].scale;
    case GL_CONVOLUTION_FILTER_BIAS: return s->filter_transform[filter].bias;
    default: return NULL;
    }
}

void fgl_exec_ConvolutionParameterfv(struct context *ctx, GLenum target, GLenum pname, const GLfloat *params)
{
    int filter;
    RETURN_ERROR_IF(ctx, !find_filter(target, &filter) || !fgl_count_convolution(pname), GL_INVALID_ENUM);
    struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    float *vector = find_vector(s, filter, pname);
    if (vector) {
        fgl_set_floats(ctx, 0, vector, params, 4);
        return;
    }
    const GLenum mode = fgl_enum_from_float(params[0]);
    RETURN_ERROR_IF(ctx, mode != GL_REDUCE && mode != GL_CONSTANT_BORDER && mode != GL_REPLICATE_BORDER, GL_INVALID_ENUM);
    SET(ctx, 0, s->border_mode[filter], mode);
}

void GLAPIENTRY glConvolutionParameteriv(GLenum target, GLenum pname, const GLint *params)
{
    GLfloat v[4] = {0};
    for (int i = 0; i < fgl_count_convolution(pname); i++)
        v[i] = pname == GL_CONVOLUTION_BORDER_COLOR ? fgl_float_from_int_color(params[i]) : (GLfloat)params[i];
    glConvolutionParameterfv(target, pname, v);
}

/* The forms of one value know no vectors. */
static GLenum scalar(GLenum pname)
{
    return fgl_count_convolution(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glConvolutionParameterf(GLenum target, GLenum pname, GLfloat params)
{
    glConvolutionParameterfv(target, scalar(pname), &params);
}

void GLAPIENTRY glConvolutionParameteri(GLenum target, GLenum pname, GLint params)
{
    glConvolutionParameteriv(target, scalar(pname), &params);
}

/* ---- queries ---- */

void fgl_exec_GetConvolutionFilter(struct context *ctx, GLenum target, GLenum format, GLenum type, GLvoid *image)
{
    int index;
    RETURN_ERROR_IF(ctx, !find_filter(target, &index) || index == FILTER_SEPARABLE, GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_pixels_error(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    const struct convolution_filter *f = &ctx->imaging->filter[index];
    const float *const value[4] = {f->value[0], f->value[1], f->value[2], f->value[3]};
    fgl_imaging_return(ctx, f->format.base_format, format, type, value, f->format.width, f->height, image);
}

/* `span` is not used. */
void fgl_exec_GetSeparableFilter(struct context *ctx, GLenum target, GLenum format, GLenum type, GLvoid *row, GLvoid *column,
                                 GLvoid *span)
{
    (void)span;
    RETURN_ERROR_IF(ctx, target != GL_SEPARABLE_2D, GL_INVALID_ENUM);
    const GLenum error = fgl_imaging_pixels_error(format, type);
    RETURN_ERROR_IF(ctx, error, error);
    RETURN_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY);
    const struct convolution_filter *f = &ctx->imaging->filter[FILTER_SEPARABLE];
    const float *const rows[4] = {f->value[0], f->value[1], f->value[2], f->value[3]};
    const float *const columns[4] = {f->column[0], f->column[1], f->column[2], f->column[3]};
    if (fgl_imaging_return(ctx, f->format.base_format, format, type, rows, f->format.width, 1, row))
        fgl_imaging_return(ctx, f->format.base_format, format, type, columns, f->height, 1, column);
}

/* The number of values; 0 after recording an error. */
static int get(struct context *ctx, GLenum target, GLenum pname, float v[4])
{
    int index;
    struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    RETURN_VALUE_ERROR_IF(ctx, !find_filter(target, &index), GL_INVALID_ENUM, 0);
    RETURN_VALUE_ERROR_IF(ctx, !fgl_imaging(ctx), GL_OUT_OF_MEMORY, 0);
    const struct convolution_filter *f = &ctx->imaging->filter[index];
    switch (pname) {
    case GL_CONVOLUTION_BORDER_MODE: v[0] = (float)s->border_mode[index]; return 1;
    case GL_CONVOLUTION_FORMAT: v[0] = (float)f->format.internal_format; return 1;
    case GL_CONVOLUTION_WIDTH: v[0] = (float)f->format.width; return 1;
    case GL_CONVOLUTION_HEIGHT: v[0] = (float)f->height; return 1;
    case GL_MAX_CONVOLUTION_WIDTH: v[0] = FGL_MAX_CONVOLUTION; return 1;
    case GL_MAX_CONVOLUTION_HEIGHT: v[0] = index == FILTER_1D ? 1 : FGL_MAX_CONVOLUTION; return 1;
    default: break;
    }
    const float *vector = find_vector(s, index, pname);
    RETURN_VALUE_ERROR_IF(ctx, !vector, GL_INVALID_ENUM, 0);
    memcpy(v, vector, 4 * sizeof *v);
    return 4;
}

void fgl_exec_GetConvolutionParameterfv(struct context *ctx, GLenum target, GLenum pname, GLfloat *params)
{
    float v[4];
    const int n = get(ctx, target, pname, v);
    memcpy(params, v, (size_t)n * sizeof *v);
}

void fgl_exec_GetConvolutionParameteriv(struct context *ctx, GLenum target, GLenum pname, GLint *params)
{
    float v[4];
    const int n = get(ctx, target, pname, v);
    for (int i = 0; i < n; i++)
        params[i] = pname == GL_CONVOLUTION_BORDER_COLOR ? fgl_int_from_normalized((double)v[i]) : fgl_int_round((double)v[i]);
}
