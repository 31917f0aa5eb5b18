/* Values as the encodings of texture formats keep them, other than unsigned normalized integers (format.h). Layer 2. */
#ifndef FGL_TEXTURE_ENCODE_H
#define FGL_TEXTURE_ENCODE_H

#include "texture/format.h"

/* Channel c of n texels: what is left of each value. Not for ENCODED_UNORM. color: as for fgl_texture_store_color. ENCODED_SRGB: in come
 * values on the sRGB curve, out linear ones. */
void fgl_texture_encode(const struct texture_format *format, int c, int n, const float *const color[4], float *out);

/* The byte that a kept colour of an sRGB format comes from. */
int fgl_srgb_byte(float linear);

/* From linear to the sRGB curve: v in [0,1]. */
float fgl_srgb_from_linear(float v);

#endif
