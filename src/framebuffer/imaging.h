/* The imaging subset (GL 1.5, 3.6.3 and 3.6.5): color tables, convolution, the color matrix, histogram and minimum/maximum.
 * Layer 2. They are stages of pixel transfer behind scale, bias and maps (pixel_transfer.h), and they need images whole:
 * convolution reads neighbours and changes sizes, histograms count every pixel once. Programs that use none of them never come
 * here: fgl_imaging_active says so, and rows are transferred one by one. */
#ifndef FGL_FRAMEBUFFER_IMAGING_H
#define FGL_FRAMEBUFFER_IMAGING_H

#include "framebuffer/framebuffer.h"
#include "framebuffer/pixel_unpack.h"

/* What tables, filters and histograms have in common. Their values are floats (counters 32-bit integers) in any format. */
struct imaging_format {
    GLenum internal_format, base_format; /* 0: what a proxy did not fit */
    int width;
};

struct color_table {
    struct imaging_format format;
    float value[4][FGL_MAX_COLOR_TABLE]; /* what replaces red, green, blue and alpha */
};

/* Weights of red, green, blue and alpha, the bottom row first. Components that the format does not have keep the pixels' values: their
 * weights are 1 at the pixel itself. */
struct convolution_filter {
    struct imaging_format format;
    int height;
    float value[4][FGL_MAX_CONVOLUTION * FGL_MAX_CONVOLUTION]; /* of FILTER_SEPARABLE: the row */
    float column[4][FGL_MAX_CONVOLUTION];                      /* of FILTER_SEPARABLE */
};

struct histogram {
    struct imaging_format format;
    bool sink;
    uint32_t count[4][FGL_MAX_HISTOGRAM];
};

struct minmax {
    struct imaging_format format; /* of width 2 */
    bool sink;
    float value[4][2]; /* of each channel: minimum, maximum */
};

struct imaging {
    struct color_table table[COLOR_TABLES];
    struct convolution_filter filter[FILTERS];
    struct histogram histogram;
    struct minmax minmax;
    struct imaging_format proxy_table[COLOR_TABLES], proxy_histogram;
};

/* The context's; made when first asked for; NULL when memory is short. */
struct imaging *fgl_imaging(struct context *ctx);
void fgl_imaging_destroy(struct context *ctx);
void fgl_minmax_reset(struct minmax *minmax);

/* Which of red, green, blue and alpha a format takes the values of a channel from; -1: the format does not have the channel. */
int fgl_imaging_source(GLenum base_format, int channel);
/* Whether the format has this component itself: what is counted and what is returned (luminance and intensity as red). */
static inline bool fgl_imaging_has(GLenum base_format, int channel)
{
    return fgl_imaging_source(base_format, channel) == channel;
}

/* Whether any stage may change, count or discard colours. */
bool fgl_imaging_active(const struct context *ctx);

/* RGBA floats, the bottom row first. */
struct color_image {
    int width, height;
    float *color; /* malloc */
};

/* The filter that is applied to images of commands for so many dimensions (1 or 2; 0: to none); -1: none. */
int fgl_convolution_filter(const struct imaging_state *s, int dimensions);
/* The size that an image has behind it; a size that is not positive stays as it is. */
void fgl_convolved_size(struct context *ctx, int dimensions, int *width, int *height);
/* Applies it; false when memory is short. */
bool fgl_convolve(struct color_image *image, const struct convolution_filter *filter, bool separable, GLenum border_mode,
                  const float border_color[4]);

/* The image as `unpack` describes it, after all of pixel transfer: with no pixels if a sink took them. out->color is the caller's to
 * free. False when memory is short. */
bool fgl_imaging_unpack(struct context *ctx, const struct pixel_unpack *unpack, int width, int height, int dimensions,
                        struct color_image *out);
/* The same from a rectangle of the framebuffer (window coordinates, y up); what lies outside is 0. */
bool fgl_imaging_fetch(struct context *ctx, int x, int y, int width, int height, int dimensions, struct color_image *out);

/* The same without pixel transfer: for tables and filters. */
bool fgl_colors_unpack(const struct pixel_unpack *unpack, int width, int height, struct color_image *out);
bool fgl_colors_fetch(const struct framebuffer *fb, const struct pixel_mode_state *mode, const struct pixel_map *maps, int x, int y,
                      int width, int height, struct color_image *out);

/* The image as one of memory, on which pixel transfer has nothing left to do. */
struct pixel_unpack fgl_color_image_unpack(const struct color_image *image, const struct pixel_unpack *like);

#endif
