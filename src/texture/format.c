/* The table of internal formats. */
#include "texture/format.h"

#define U TEXELS_UNORM8, ENCODED_UNORM
#define W TEXELS_FLOAT, ENCODED_UNORM
#define D TEXELS_DEPTH, ENCODED_UNORM
#define F TEXELS_FLOAT, ENCODED_FLOAT
#define S TEXELS_FLOAT, ENCODED_SNORM
#define C TEXELS_FLOAT, ENCODED_SRGB

/* OSMesa rules: formats without bits of their own have 8 a channel; 4-bit channels alone become 8, 2-bit ones 4; 12 bits
 * become 16. The generic compressed formats are not compressed. */
static const struct texture_format formats[] = {
        {GL_ALPHA, GL_ALPHA, U, {0, 0, 0, 8}},
        {GL_ALPHA4, GL_ALPHA, U, {0, 0, 0, 8}},
        {GL_ALPHA8, GL_ALPHA, U, {0, 0, 0, 8}},
        {GL_ALPHA12, GL_ALPHA, W, {0, 0, 0, 16}},
        {GL_ALPHA16, GL_ALPHA, W, {0, 0, 0, 16}},
        {1, GL_LUMINANCE, U, {8}},
        {GL_LUMINANCE, GL_LUMINANCE, U, {8}},
        {GL_LUMINANCE4, GL_LUMINANCE, U, {8}},
        {GL_LUMINANCE8, GL_LUMINANCE, U, {8}},
        {GL_LUMINANCE12, GL_LUMINANCE, W, {16}},
        {GL_LUMINANCE16, GL_LUMINANCE, W, {16}},
        {2, GL_LUMINANCE_ALPHA, U, {8, 0, 0, 8}},
        {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, U, {8, 0, 0, 8}},
        {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, U, {4, 0, 0, 4}},
        {GL_LUMINANCE6_ALPHA2, GL_LUMINANCE_ALPHA, U, {8, 0, 0, 8}},
        {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, U, {8, 0, 0, 8}},
        {GL_LUMINANCE12_ALPHA4, GL_LUMINANCE_ALPHA, W, {16, 0, 0, 16}},
        {GL_LUMINANCE12_ALPHA12, GL_LUMINANCE_ALPHA, W, {16, 0, 0, 16}},
        {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA, W, {16, 0, 0, 16}},
        {GL_INTENSITY, GL_INTENSITY, U, {8}},
        {GL_INTENSITY4, GL_INTENSITY, U, {8}},
        {GL_INTENSITY8, GL_INTENSITY, U, {8}},
        {GL_INTENSITY12, GL_INTENSITY, W, {16}},
        {GL_INTENSITY16, GL_INTENSITY, W, {16}},
        {3, GL_RGB, U, {8, 8, 8}},
        {GL_RGB, GL_RGB, U, {8, 8, 8}},
        {GL_R3_G3_B2, GL_RGB, U, {3, 3, 2}},
        {GL_RGB4, GL_RGB, U, {4, 4, 4}},
        {GL_RGB5, GL_RGB, U, {5, 5, 5}},
        {GL_RGB8, GL_RGB, U, {8, 8, 8}},
        {GL_RGB10, GL_RGB, W, {10, 10, 10}},
        {GL_RGB12, GL_RGB, W, {16, 16, 16}},
        {GL_RGB16, GL_RGB, W, {16, 16, 16}},
        {4, GL_RGBA, U, {8, 8, 8, 8}},
        {GL_RGBA, GL_RGBA, U, {8, 8, 8, 8}},
        {GL_RGBA2, GL_RGBA, U, {4, 4, 4, 4}},
        {GL_RGBA4, GL_RGBA, U, {4, 4, 4, 4}},
        {GL_RGB5_A1, GL_RGBA, U, {5, 5, 5, 1}},
        {GL_RGBA8, GL_RGBA, U, {8, 8, 8, 8}},
        {GL_RGB10_A2, GL_RGBA, W, {10, 10, 10, 2}},
        {GL_RGBA12, GL_RGBA, W, {16, 16, 16, 16}},
        {GL_RGBA16, GL_RGBA, W, {16, 16, 16, 16}},
        {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, D, {24}},
        {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, D, {16}},
        {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, D, {24}},
        {GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, D, {32}},
        {GL_DEPTH_STENCIL, GL_DEPTH_STENCIL, D, {24}},
        {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, D, {24}},
        {GL_COMPRESSED_ALPHA, GL_ALPHA, U, {0, 0, 0, 8}},
        {GL_COMPRESSED_LUMINANCE, GL_LUMINANCE, U, {8}},
        {GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, U, {8, 0, 0, 8}},
        {GL_COMPRESSED_INTENSITY, GL_INTENSITY, U, {8}},
        {GL_COMPRESSED_RGB, GL_RGB, U, {8, 8, 8}},
        {GL_COMPRESSED_RGBA, GL_RGBA, U, {8, 8, 8, 8}},
        {GL_RED, GL_RED, U, {8}},
        {GL_R8, GL_RED, U, {8}},
        {GL_R16, GL_RED, W, {16}},
        {GL_RG, GL_RG, U, {8, 8}},
        {GL_RG8, GL_RG, U, {8, 8}},
        {GL_RG16, GL_RG, W, {16, 16}},
        {GL_COMPRESSED_RED, GL_RED, U, {8}},
        {GL_COMPRESSED_RG, GL_RG, U, {8, 8}},
        {GL_R16F, GL_RED, F, {16}},
        {GL_RG16F, GL_RG, F, {16, 16}},
        {GL_RGB16F_ARB, GL_RGB, F, {16, 16, 16}},
        {GL_RGBA16F_ARB, GL_RGBA, F, {16, 16, 16, 16}},
        {GL_ALPHA16F_ARB, GL_ALPHA, F, {0, 0, 0, 16}},
        {GL_LUMINANCE16F_ARB, GL_LUMINANCE, F, {16}},
        {GL_LUMINANCE_ALPHA16F_ARB, GL_LUMINANCE_ALPHA, F, {16, 0, 0, 16}},
        {GL_INTENSITY16F_ARB, GL_INTENSITY, F, {16}},
        {GL_R32F, GL_RED, F, {32}},
        {GL_RG32F, GL_RG, F, {32, 32}},
        {GL_RGB32F_ARB, GL_RGB, F, {32, 32, 32}},
        {GL_RGBA32F_ARB, GL_RGBA, F, {32, 32, 32, 32}},
        {GL_ALPHA32F_ARB, GL_ALPHA, F, {0, 0, 0, 32}},
        {GL_LUMINANCE32F_ARB, GL_LUMINANCE, F, {32}},
        {GL_LUMINANCE_ALPHA32F_ARB, GL_LUMINANCE_ALPHA, F, {32, 0, 0, 32}},
        {GL_INTENSITY32F_ARB, GL_INTENSITY, F, {32}},
        {GL_RED_SNORM, GL_RED, S, {8}},
        {GL_R8_SNORM, GL_RED, S, {8}},
        {GL_R16_SNORM, GL_RED, S, {16}},
        {GL_RG_SNORM, GL_RG, S, {8, 8}},
        {GL_RG8_SNORM, GL_RG, S, {8, 8}},
        {GL_RG16_SNORM, GL_RG, S, {16, 16}},
        {GL_RGB_SNORM, GL_RGB, S, {8, 8, 8}},
        {GL_RGB8_SNORM, GL_RGB, S, {8, 8, 8}},
        {GL_RGB16_SNORM, GL_RGB, S, {16, 16, 16}},
        {GL_RGBA_SNORM, GL_RGBA, S, {8, 8, 8, 8}},
        {GL_RGBA8_SNORM, GL_RGBA, S, {8, 8, 8, 8}},
        {GL_RGBA16_SNORM, GL_RGBA, S, {16, 16, 16, 16}},
        {GL_ALPHA_SNORM, GL_ALPHA, S, {0, 0, 0, 8}},
        {GL_ALPHA8_SNORM, GL_ALPHA, S, {0, 0, 0, 8}},
        {GL_ALPHA16_SNORM, GL_ALPHA, S, {0, 0, 0, 16}},
        {GL_LUMINANCE_SNORM, GL_LUMINANCE, S, {8}},
        {GL_LUMINANCE8_SNORM, GL_LUMINANCE, S, {8}},
        {GL_LUMINANCE16_SNORM, GL_LUMINANCE, S, {16}},
        {GL_LUMINANCE_ALPHA_SNORM, GL_LUMINANCE_ALPHA, S, {8, 0, 0, 8}},
        {GL_LUMINANCE8_ALPHA8_SNORM, GL_LUMINANCE_ALPHA, S, {8, 0, 0, 8}},
        {GL_LUMINANCE16_ALPHA16_SNORM, GL_LUMINANCE_ALPHA, S, {16, 0, 0, 16}},
        {GL_INTENSITY_SNORM, GL_INTENSITY, S, {8}},
        {GL_INTENSITY8_SNORM, GL_INTENSITY, S, {8}},
        {GL_INTENSITY16_SNORM, GL_INTENSITY, S, {16}},
        {GL_SRGB_EXT, GL_RGB, C, {8, 8, 8}},
        {GL_SRGB8_EXT, GL_RGB, C, {8, 8, 8}},
        {GL_SRGB_ALPHA_EXT, GL_RGBA, C, {8, 8, 8, 8}},
        {GL_SRGB8_ALPHA8_EXT, GL_RGBA, C, {8, 8, 8, 8}},
        {GL_SLUMINANCE_EXT, GL_LUMINANCE, C, {8}},
        {GL_SLUMINANCE8_EXT, GL_LUMINANCE, C, {8}},
        {GL_SLUMINANCE_ALPHA_EXT, GL_LUMINANCE_ALPHA, C, {8, 0, 0, 8}},
        {GL_SLUMINANCE8_ALPHA8_EXT, GL_LUMINANCE_ALPHA, C, {8, 0, 0, 8}},
        {GL_COMPRESSED_SRGB_EXT, GL_RGB, C, {8, 8, 8}},
        {GL_COMPRESSED_SRGB_ALPHA_EXT, GL_RGBA, C, {8, 8, 8, 8}},
        {GL_COMPRESSED_SLUMINANCE_EXT, GL_LUMINANCE, C, {8}},
        {GL_COMPRESSED_SLUMINANCE_ALPHA_EXT, GL_LUMINANCE_ALPHA, C, {8, 0, 0, 8}},
        {GL_R11F_G11F_B10F_EXT, GL_RGB, TEXELS_FLOAT, ENCODED_PACKED_FLOAT, {11, 11, 10}},
        {GL_RGB9_E5_EXT, GL_RGB, TEXELS_FLOAT, ENCODED_SHARED_EXPONENT, {9, 9, 9}},
};

/* Not for programs to ask for. */
enum { RGB565 = GL_NONE };
static const struct texture_format rgb565 = {GL_RGB, GL_RGB, U, {5, 6, 5}};

const struct texture_format *fgl_texture_format(GLenum internal_format)
{
    for (size_t i = 0; i < FGL_COUNTOF(formats); i++)
        if (formats[i].internal_format == internal_format)
            return &formats[i];
    return NULL;
}

/* The unsized formats, and what is kept for pixels of a certain format and type; GL_RGBA as the pixels' format: or GL_BGRA. */
static const struct {
    GLenum internal_format, format, type, kept;
} suited[] = {
        {GL_ALPHA, GL_ALPHA, GL_UNSIGNED_SHORT, GL_ALPHA16},
        {GL_LUMINANCE, GL_LUMINANCE, GL_UNSIGNED_SHORT, GL_LUMINANCE16},
        {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT, GL_LUMINANCE16_ALPHA16},
        {GL_RGB, GL_RGB, GL_UNSIGNED_BYTE_3_3_2, GL_R3_G3_B2},
        {GL_RGB, GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, GL_R3_G3_B2},
        {GL_RGB, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, RGB565},
        {GL_RGB, GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, RGB565},
        {GL_RGB, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, GL_RGB5},
        {GL_RGB, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGB10},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA4},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_RGBA4},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, GL_RGB5_A1},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_RGB5_A1},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, GL_RGB10_A2},
        {GL_RGBA, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGB10_A2},
        {GL_RGBA, GL_ABGR_EXT, GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA4},
        {GL_RGBA, GL_ABGR_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_RGBA4},
        {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, GL_DEPTH_COMPONENT16},
        {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_DEPTH_COMPONENT32},
};

const struct texture_format *fgl_texture_format_for(GLenum internal_format, GLenum format, GLenum type, bool swap_bytes)
{
    if (swap_bytes && type != GL_UNSIGNED_SHORT_5_5_5_1 && type != GL_UNSIGNED_INT_2_10_10_10_REV)
        return fgl_texture_format(internal_format);
    if (internal_format == GL_RGBA && format == GL_RGBA && type == GL_UNSIGNED_SHORT)
        return fgl_texture_format(GL_RGBA16);
    if (format == GL_BGRA)
        format = GL_RGBA;
    for (size_t i = 0; i < FGL_COUNTOF(suited); i++)
        if (suited[i].internal_format == internal_format && suited[i].format == format && suited[i].type == type)
            return suited[i].kept == RGB565 ? &rgb565 : fgl_texture_format(suited[i].kept);
    return fgl_texture_format(internal_format);
}
