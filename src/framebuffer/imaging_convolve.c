/* Convolution (GL 1.5, 3.6.5 "Convolution"). A border mode that keeps the size is a larger image, of which convolution then leaves as
 * much as there was. */
#include "framebuffer/imaging.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

int fgl_convolution_filter(const struct imaging_state *s, int dimensions)
{
    if (dimensions == 1)
        return s->convolution[FILTER_1D] ? FILTER_1D : -1;
    if (dimensions == 2)
        return s->convolution[FILTER_2D] ? FILTER_2D : s->convolution[FILTER_SEPARABLE] ? FILTER_SEPARABLE : -1;
    return -1;
}

static int reduced(int size, int filter_size)
{
    return size <= 0 ? size : fgl_max(0, size - fgl_max(filter_size, 1) + 1);
}

void fgl_convolved_size(struct context *ctx, int dimensions, int *width, int *height)
{
    const struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    const int i = fgl_convolution_filter(s, dimensions);
    const struct imaging *imaging = i < 0 || s->border_mode[i] != GL_REDUCE ? NULL : fgl_imaging(ctx);
    if (!imaging)
        return;
    *width = reduced(*width, imaging->filter[i].format.width);
    *height = reduced(*height, imaging->filter[i].height);
}

/* The weights of one pass: width x height of each channel. */
struct weights {
    int width, height;
    const float *of[4];
};

/* The image gets `with` in place of its pixels, or is left alone when that is NULL. */
static bool replace(struct color_image *image, int width, int height, float *with)
{
    if (!with)
        return false;
    free(image->color);
    *image = (struct color_image){width, height, with};
    return true;
}

static float *new_pixels(int width, int height)
{
    const size_t n = (size_t)width * (size_t)height;
    return calloc(n ? n : 1, 4 * sizeof(float));
}

/* The image with floor(size / 2) pixels of border before it, and behind it as many as make size - 1 of both. */
static bool extend(struct color_image *image, int filter_width, int filter_height, GLenum border_mode, const float border_color[4])
{
    if (image->width > INT_MAX - filter_width || image->height > INT_MAX - filter_height)
        return false;
    const int width = image->width + filter_width - 1, height = image->height + filter_height - 1;
    float *out = new_pixels(width, height);
    for (int y = 0; out && y < height; y++)
        for (int x = 0; x < width; x++) {
            const int u = x - filter_width / 2, v = y - filter_height / 2;
            const bool inside = u >= 0 && u < image->width && v >= 0 && v < image->height;
            const size_t nearest = (size_t)fgl_clamp(v, 0, image->height - 1) * (size_t)image->width +
                                   (size_t)fgl_clamp(u, 0, image->width - 1);
            memcpy(out + 4 * ((size_t)y * (size_t)width + (size_t)x),
                   inside || border_mode == GL_REPLICATE_BORDER ? image->color + 4 * nearest : border_color, 4 * sizeof(float));
        }
    return replace(image, width, height, out);
}

/* C[i, j] = sum over n, m of Cs[i + n, j + m] Cf[n, m] for one row of pixels. */
static void convolve_row(const struct color_image *image, const struct weights *w, int y, int width, float *FGL_RESTRICT out)
{
    for (int m = 0; m < w->height; m++)
        for (int n = 0; n < w->width; n++) {
            const float *from = image->color + 4 * ((size_t)(y + m) * (size_t)image->width + (size_t)n);
            const int at = m * w->width + n;
            const float f[4] = {w->of[0][at], w->of[1][at], w->of[2][at], w->of[3][at]};
            for (size_t i = 0; i < 4 * (size_t)width; i += 4)
                for (size_t c = 0; c < 4; c++)
                    out[i + c] += from[i + c] * f[c];
        }
}

static bool pass(struct color_image *image, const struct weights *w)
{
    const int width = reduced(image->width, w->width), height = reduced(image->height, w->height);
    float *out = new_pixels(width, height);
    for (int y = 0; out && y < height; y++)
        convolve_row(image, w, y, width, out + 4 * (size_t)y * (size_t)width);
    return replace(image, width, height, out);
}

static struct weights weights_of(const float *value, size_t channel_step, int width, int height)
{
    return (struct weights){width, height, {value, value + channel_step, value + 2 * channel_step, value + 3 * channel_step}};
}

/* A filter of no size makes everything 0. */
bool fgl_convolve(struct color_image *image, const struct convolution_filter *filter, bool separable, GLenum border_mode,
                  const float border_color[4])
{
    const int width = filter->format.width, height = filter->height;
    const size_t step = FGL_COUNTOF(filter->value[0]), column_step = FGL_COUNTOF(filter->column[0]);
    if (width == 0 || height == 0) {
        memset(image->color, 0, (size_t)image->width * (size_t)image->height * 4 * sizeof(float));
        return true;
    }
    if (image->width == 0 || image->height == 0)
        return true;
    if (border_mode != GL_REDUCE && !extend(image, width, height, border_mode, border_color))
        return false;
    if (!separable) {
        const struct weights whole = weights_of(filter->value[0], step, width, height);
        return pass(image, &whole);
    }
    const struct weights row = weights_of(filter->value[0], step, width, 1),
                         column = weights_of(filter->column[0], column_step, 1, height);
    return pass(image, &row) && pass(image, &column);
}
