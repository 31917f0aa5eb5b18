/* Components on their way into the caller's memory: converted to the type, then stored. Shared by what packs framebuffers
 * (pixel_pack.c) and images (pixel_pack_image.c). */
#ifndef FGL_FRAMEBUFFER_PIXEL_COMPONENTS_H
#define FGL_FRAMEBUFFER_PIXEL_COMPONENTS_H

#include "framebuffer/pixel_pack.h"

/* A chunk of converted components, one plane for each in the order of the format: the bits of the integer or
 * of the float. */
struct component_row {
    uint32_t value[PIXEL_MAX_COMPONENTS][PIXEL_CHUNK];
};

/* Bits of magnitude in component c of a type. */
int fgl_type_bits(const struct pixel_type *type, int c);

/* Which channel of a row component c of a format is; luminance is red. */
static inline int fgl_component_channel(const struct pixel_format *format, int c)
{
    return format->channel[c] == CHANNEL_LUMINANCE ? 0 : (int)format->channel[c];
}

/* [0,1] to a normalized integer, half to even. */
uint32_t fgl_float_to_norm(float v, uint32_t max);

/* Fetched integers to floats. OSMesa rule: v * (1 / max). */
void fgl_fetched_to_float(struct fetched_row *row, int n);

void fgl_clamp_colors(struct color_row *color, int n); /* to [0,1] */
/* GL 1.5, 4.3.2 "Conversion to L": R + G + B. OSMesa rule: the channels are clamped before, the sum after. The sum takes the place of red. */
void fgl_add_luminance(struct color_row *color, int n);

/* n colours, depths in [0,1], or an index, to components of the type. Luminance is red. */
void fgl_convert_colors(const struct fetched_row *row, const struct pixel_format *format, const struct pixel_type *type, int n,
                        struct component_row *out);
uint32_t fgl_convert_depth(float depth, GLenum type);
uint32_t fgl_convert_index(int32_t index, const struct pixel_type *type);

/* Writes n pixels of the image's row from `column` on, and no other byte. The components may change. */
void fgl_store_components(const struct pixel_image *image, int row, int column, int n, struct component_row *components);

#endif
