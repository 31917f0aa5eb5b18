/* Internal formats of textures (GL 1.5, tables 3.15 and 3.16): what each stores, as OSMesa does. Layer 2. */
#ifndef FGL_TEXTURE_FORMAT_H
#define FGL_TEXTURE_FORMAT_H

#include "texture/texture.h"

/* What the bits of a channel mean. */
enum texel_encoding {
    ENCODED_UNORM,
    ENCODED_SNORM,           /* GL_EXT_texture_snorm: [-1,1] */
    ENCODED_SRGB,            /* GL_EXT_texture_sRGB: 8 bits, colours by the sRGB curve; kept decoded */
    ENCODED_FLOAT,           /* GL_ARB_texture_float: 16 or 32 bits */
    ENCODED_PACKED_FLOAT,    /* GL_EXT_packed_float: 11, 11 and 10 bits without sign */
    ENCODED_SHARED_EXPONENT  /* GL_EXT_texture_shared_exponent: 9 bits each and an exponent of 5 bits for the three */
};

/* bits: what is stored of red, green, blue and alpha; luminance and intensity are in bits[0]. */
struct texture_format {
    GLenum internal_format, base_format;
    enum texel_kind kind;
    enum texel_encoding encoding;
    int bits[4]; /* depth: bits[0]; GL_DEPTH_STENCIL has 8 bits of stencil besides */
};

/* Whether texels may be less than 0 or greater than 1. */
static inline bool fgl_texture_format_leaves_unit(const struct texture_format *format)
{
    return format->encoding != ENCODED_UNORM && format->encoding != ENCODED_SRGB;
}

/* Whether bytes of colours are kept as they are. */
static inline bool fgl_texture_format_keeps_bytes(const struct texture_format *format)
{
    bool all = format->kind == TEXELS_UNORM8;
    for (int c = 0; c < 4; c++)
        all = all && (format->bits[c] == 0 || format->bits[c] == 8);
    return all;
}

/* The generic compressed formats. OSMesa rule: kept as, and reported to be, their base formats. */
static inline bool fgl_texture_format_compressed(const struct texture_format *format)
{
    const GLenum f = format->internal_format;
    return (f >= GL_COMPRESSED_ALPHA && f <= GL_COMPRESSED_RGBA) || f == GL_COMPRESSED_RED || f == GL_COMPRESSED_RG ||
           (f >= GL_COMPRESSED_SRGB_EXT && f <= GL_COMPRESSED_SLUMINANCE_ALPHA_EXT);
}

/* Whether images of the format can be drawn to. */
static inline bool fgl_texture_format_drawable(const struct texture_format *format)
{
    const bool srgb = format->encoding == ENCODED_SRGB && (format->base_format == GL_RGB || format->base_format == GL_RGBA);
    return format->kind != TEXELS_DEPTH && (format->encoding == ENCODED_UNORM || srgb) && !fgl_texture_format_compressed(format);
}

/* NULL for an enum that is no internal format. */
const struct texture_format *fgl_texture_format(GLenum internal_format);

/* The same for an image of pixels of this format and type. OSMesa rule: unsized formats have the precision of some packed types, and of
 * words; swapped bytes undo that, but for two types. */
const struct texture_format *fgl_texture_format_for(GLenum internal_format, GLenum format, GLenum type, bool swap_bytes);

#endif
