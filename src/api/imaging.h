/* Commands that specify color tables and convolution filters from images (GL 1.5, 3.6.3), as one call; also what a display list keeps
 * of them. */
#ifndef FGL_API_IMAGING_H
#define FGL_API_IMAGING_H

#include "framebuffer/imaging.h"

struct imaging_call {
    enum imaging_image { IMAGE_COLOR_TABLE, IMAGE_COLOR_SUB_TABLE, IMAGE_FILTER_1D, IMAGE_FILTER_2D, IMAGE_FILTER_SEPARABLE } image;
    GLenum target, internal_format, format, type;
    int start, width, height;
    bool copy; /* from the framebuffer, at (x, y) */
    int x, y;
};

/* Where the images of a call lie: given, or in a display list. Two for a separable filter: row and column. */
struct imaging_pixels {
    const struct pixel_store *store;
    const void *image[2];
};

/* A command: checked, recorded, executed. The proxies' are never recorded (GL 1.5, 5.4). */
void fgl_imaging_command(const struct imaging_call *call, const void *image, const void *column);
void fgl_list_replay_imaging(struct context *ctx, const void *payload);
void fgl_list_replay_histogram(struct context *ctx, const void *payload);

/* The two executions: color_table.c, convolution.c. pixels: NULL for copies. */
void fgl_color_table_execute(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels);
void fgl_filter_execute(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels);

/* The format of a table, filter, histogram or minmax; false for others (GL 1.5, 3.6.3: tables 3.15 and 3.16 without depths). */
bool fgl_imaging_format(GLenum internal_format, int width, struct imaging_format *out);

/* Whether a table or histogram may have so many entries: none or a power of two. */
static inline bool fgl_imaging_width(int width)
{
    return width >= 0 && (width & (width - 1)) == 0;
}

/* The error of formats and types of images that are given or returned: colours only. */
GLenum fgl_imaging_pixels_error(GLenum format, GLenum type);
/* The same for a call, which may read from the framebuffer. */
GLenum fgl_imaging_source_error(struct context *ctx, const struct imaging_call *call);

/* An image of a call, each component scaled and biased; a NULL pointer is an image of zeros. False after recording
 * GL_OUT_OF_MEMORY. out->color is to be freed. */
bool fgl_imaging_colors(struct context *ctx, const struct imaging_call *call, const struct imaging_pixels *pixels, int which, int width,
                        int height, const struct scale_bias *transform, struct color_image *out);

/* Writes a table or filter to the caller's memory; components that its format does not have are 0. False after recording an error. */
bool fgl_imaging_return(struct context *ctx, GLenum base_format, GLenum format, GLenum type, const float *const value[4], int width,
                        int height, void *pixels);

/* The place of a component's size among ..._RED_SIZE, GREEN, BLUE, ALPHA, LUMINANCE, INTENSITY_SIZE, as its bits. */
int fgl_imaging_size(const struct imaging_format *format, unsigned component);

#endif
