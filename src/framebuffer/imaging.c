/* The stages of pixel transfer that the imaging subset adds, in their order, on whole images. */
#include "framebuffer/imaging.h"

#include <float.h>
#include <stdlib.h>

/* ---- state ---- */

struct imaging *fgl_imaging(struct context *ctx)
{
    static const struct imaging_format initial = {GL_RGBA, GL_RGBA, 0};
    if (ctx->imaging)
        return ctx->imaging;
    struct imaging *s = ctx->imaging = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    for (int i = 0; i < COLOR_TABLES; i++)
        s->table[i].format = s->proxy_table[i] = initial;
    for (int i = 0; i < FILTERS; i++)
        s->filter[i].format = initial;
    s->histogram.format = s->proxy_histogram = s->minmax.format = initial;
    s->minmax.format.width = 2;
    fgl_minmax_reset(&s->minmax);
    return s;
}

void fgl_imaging_destroy(struct context *ctx)
{
    free(ctx->imaging);
    ctx->imaging = NULL;
}

/* GL 1.5, 3.6.3 "Minmax Table Specification": the largest value as minimum, the smallest as maximum. */
void fgl_minmax_reset(struct minmax *minmax)
{
    for (int c = 0; c < 4; c++) {
        minmax->value[c][0] = FLT_MAX;
        minmax->value[c][1] = -FLT_MAX;
    }
}

/* GL 1.5, tables 3.12 to 3.14. */
int fgl_imaging_source(GLenum base_format, int channel)
{
    switch (base_format) {
    case GL_ALPHA: return channel == 3 ? 3 : -1;
    case GL_LUMINANCE: return channel == 3 ? -1 : 0;
    case GL_LUMINANCE_ALPHA: return channel == 3 ? 3 : 0;
    case GL_INTENSITY: return 0;
    case GL_RGB: return channel == 3 ? -1 : channel;
    case GL_RGBA: return channel;
    default: return -1;
    }
}

static bool changes(const struct scale_bias *t)
{
    bool active = false;
    for (int c = 0; c < 4; c++)
        active |= t->scale[c] != 1.0f || t->bias[c] != 0.0f;
    return active;
}

bool fgl_imaging_active(const struct context *ctx)
{
    const struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    bool active = s->histogram || s->minmax || changes(&s->post_color_matrix);
    for (int i = 0; i < COLOR_TABLES; i++)
        active |= s->color_table[i];
    for (int i = 0; i < FILTERS; i++)
        active |= s->convolution[i];
    return active || !fgl_matrix_is_identity(&ctx->color_matrix.entry[ctx->color_matrix.top]);
}

/* ---- stages on n pixels, four floats each ---- */

static int entry_of(float v, int width)
{
    return (int)(fgl_clamp01(v) * (float)(width - 1) + 0.5f);
}

/* 3.6.5 "Color Table Lookup", table 3.12. An empty table changes nothing. */
static void look_up(const struct color_table *table, float *color, size_t n)
{
    const int width = table->format.width;
    for (int c = 0; c < 4; c++)
        if (width && fgl_imaging_source(table->format.base_format, c) >= 0)
            for (size_t i = 0; i < n; i++)
                color[4 * i + c] = table->value[c][entry_of(color[4 * i + c], width)];
}

static void scale_and_bias(const struct scale_bias *t, float *color, size_t n)
{
    for (size_t i = 0; i < 4 * n; i++)
        color[i] = color[i] * t->scale[i % 4] + t->bias[i % 4];
}

/* 3.6.5 "Color Matrix Transformation"; m is column major. */
static void transform(const float m[16], float *color, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        float *v = color + 4 * i;
        const float r = v[0], g = v[1], b = v[2], a = v[3];
        for (int c = 0; c < 4; c++)
            v[c] = m[c] * r + m[4 + c] * g + m[8 + c] * b + m[12 + c] * a;
    }
}

/* 3.6.5 "Histogram". Counters stay at their greatest value. */
static void count(struct histogram *histogram, const float *color, size_t n)
{
    const int width = histogram->format.width;
    for (int c = 0; c < 4; c++)
        if (width && fgl_imaging_has(histogram->format.base_format, c))
            for (size_t i = 0; i < n; i++) {
                uint32_t *counter = &histogram->count[c][entry_of(color[4 * i + c], width)];
                *counter += *counter != UINT32_MAX;
            }
}

/* 3.6.5 "Minmax". */
static void measure(struct minmax *minmax, const float *color, size_t n)
{
    for (int c = 0; c < 4; c++) {
        float *const limit = minmax->value[c];
        if (fgl_imaging_has(minmax->format.base_format, c))
            for (size_t i = 0; i < n; i++) {
                const float v = color[4 * i + c];
                limit[0] = v < limit[0] ? v : limit[0];
                limit[1] = v > limit[1] ? v : limit[1];
            }
    }
}

/* ---- all of them ---- */

static bool convolve(const struct context *ctx, int dimensions, struct color_image *image)
{
    const struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    const int i = fgl_convolution_filter(s, dimensions);
    if (i < 0)
        return true;
    if (!fgl_convolve(image, &ctx->imaging->filter[i], i == FILTER_SEPARABLE, s->border_mode[i], s->border_color[i]))
        return false;
    scale_and_bias(&s->post_convolution, image->color, (size_t)image->width * (size_t)image->height);
    return true;
}

static void discard(struct color_image *image)
{
    image->width = image->height = 0;
}

/* 3.6.5 from "Color Table Lookup" to "Minmax". */
static bool run_stages(struct context *ctx, int dimensions, struct color_image *image)
{
    const struct imaging_state *s = &ctx->s.pixel_mode.imaging;
    struct imaging *imaging = fgl_imaging(ctx);
    if (!imaging)
        return false;
    if (s->color_table[COLOR_TABLE_FIRST])
        look_up(&imaging->table[COLOR_TABLE_FIRST], image->color, (size_t)image->width * (size_t)image->height);
    if (!convolve(ctx, dimensions, image))
        return false;
    const size_t n = (size_t)image->width * (size_t)image->height;
    if (s->color_table[COLOR_TABLE_POST_CONVOLUTION])
        look_up(&imaging->table[COLOR_TABLE_POST_CONVOLUTION], image->color, n);
    transform(fgl_matrix_top(&ctx->color_matrix)->m, image->color, n);
    scale_and_bias(&s->post_color_matrix, image->color, n);
    if (s->color_table[COLOR_TABLE_POST_COLOR_MATRIX])
        look_up(&imaging->table[COLOR_TABLE_POST_COLOR_MATRIX], image->color, n);
    if (s->histogram)
        count(&imaging->histogram, image->color, n);
    const bool counted_only = s->histogram && imaging->histogram.sink;
    if (s->minmax && !counted_only)
        measure(&imaging->minmax, image->color, n);
    if (counted_only || (s->minmax && imaging->minmax.sink))
        discard(image);
    return true;
}

static bool finish(struct context *ctx, int dimensions, struct color_image *image)
{
    if (run_stages(ctx, dimensions, image))
        return true;
    free(image->color);
    image->color = NULL;
    return false;
}

bool fgl_imaging_unpack(struct context *ctx, const struct pixel_unpack *unpack, int width, int height, int dimensions,
                        struct color_image *out)
{
    return fgl_colors_unpack(unpack, width, height, out) && finish(ctx, dimensions, out);
}

bool fgl_imaging_fetch(struct context *ctx, int x, int y, int width, int height, int dimensions, struct color_image *out)
{
    return fgl_colors_fetch(ctx->read_framebuffer, &ctx->s.pixel_mode, ctx->pixel_map, x, y, width, height, out) &&
           finish(ctx, dimensions, out);
}
