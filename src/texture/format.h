/* Internal formats of textures (GL 1.5, tables 3.15 and 3.16): what each stores, as OSMesa does. Layer 2. */
#ifndef FGL_TEXTURE_FORMAT_H
#define FGL_TEXTURE_FORMAT_H

#include "texture/texture.h"

/* bits: what is stored of red, green, blue and alpha; luminance and intensity are in bits[0]. */
struct texture_format {
    GLenum internal_format, base_format;
    enum texel_kind kind;
    int bits[4]; /* depth: bits[0] */
};

/* The generic compressed formats. OSMesa rule: kept as, and reported to be, their base formats. */
static inline bool fgl_texture_format_compressed(const struct texture_format *format)
{
    return format->internal_format >= GL_COMPRESSED_ALPHA && format->internal_format <= GL_COMPRESSED_RGBA;
}

/* NULL for an enum that is no internal format. */
const struct texture_format *fgl_texture_format(GLenum internal_format);

/* The same for an image of pixels of this format and type. OSMesa rule: unsized formats have the precision of some packed types, and of
 * words. */
const struct texture_format *fgl_texture_format_for(GLenum internal_format, GLenum format, GLenum type);

#endif
