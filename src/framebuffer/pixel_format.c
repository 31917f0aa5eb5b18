/* The tables of formats and types, and addresses in the caller's memory. */
#include "framebuffer/pixel_format.h"

#include <string.h>

#define R CHANNEL_RED
#define G CHANNEL_GREEN
#define B CHANNEL_BLUE
#define A CHANNEL_ALPHA
#define L CHANNEL_LUMINANCE

/* GL 1.5, table 3.6 "DrawPixels and ReadPixels formats"; GL_ARB_texture_rg, GL_EXT_abgr, GL_EXT_packed_depth_stencil. */
static const struct pixel_format formats[] = {
        {GL_COLOR_INDEX, 1, {CHANNEL_INDEX}},
        {GL_STENCIL_INDEX, 1, {CHANNEL_STENCIL}},
        {GL_DEPTH_COMPONENT, 1, {CHANNEL_DEPTH}},
        {GL_DEPTH_STENCIL, 2, {CHANNEL_DEPTH, CHANNEL_STENCIL}},
        {GL_RED, 1, {R}},
        {GL_GREEN, 1, {G}},
        {GL_BLUE, 1, {B}},
        {GL_ALPHA, 1, {A}},
        {GL_RG, 2, {R, G}},
        {GL_RGB, 3, {R, G, B}},
        {GL_RGBA, 4, {R, G, B, A}},
        {GL_BGR, 3, {B, G, R}},
        {GL_BGRA, 4, {B, G, R, A}},
        {GL_ABGR_EXT, 4, {A, B, G, R}},
        {GL_LUMINANCE, 1, {L}},
        {GL_LUMINANCE_ALPHA, 2, {L, A}},
};

/* GL 1.5, tables 3.5 "pixel data type parameter values" and 3.8 "Packed pixel formats". A type without REV
 * has the first component in the highest bits. */
static const struct pixel_type types[] = {
        {.type = GL_UNSIGNED_BYTE, .kind = COMPONENT_UNSIGNED, .bytes = 1},
        {.type = GL_BYTE, .kind = COMPONENT_SIGNED, .bytes = 1},
        {.type = GL_UNSIGNED_SHORT, .kind = COMPONENT_UNSIGNED, .bytes = 2},
        {.type = GL_SHORT, .kind = COMPONENT_SIGNED, .bytes = 2},
        {.type = GL_UNSIGNED_INT, .kind = COMPONENT_UNSIGNED, .bytes = 4},
        {.type = GL_INT, .kind = COMPONENT_SIGNED, .bytes = 4},
        {.type = GL_FLOAT, .kind = COMPONENT_FLOAT, .bytes = 4},
        {.type = GL_BITMAP, .kind = COMPONENT_BITMAP},
        {GL_UNSIGNED_BYTE_3_3_2, COMPONENT_PACKED, 1, 3, {3, 3, 2}, {5, 2, 0}},
        {GL_UNSIGNED_BYTE_2_3_3_REV, COMPONENT_PACKED, 1, 3, {3, 3, 2}, {0, 3, 6}},
        {GL_UNSIGNED_SHORT_5_6_5, COMPONENT_PACKED, 2, 3, {5, 6, 5}, {11, 5, 0}},
        {GL_UNSIGNED_SHORT_5_6_5_REV, COMPONENT_PACKED, 2, 3, {5, 6, 5}, {0, 5, 11}},
        {GL_UNSIGNED_SHORT_4_4_4_4, COMPONENT_PACKED, 2, 4, {4, 4, 4, 4}, {12, 8, 4, 0}},
        {GL_UNSIGNED_SHORT_4_4_4_4_REV, COMPONENT_PACKED, 2, 4, {4, 4, 4, 4}, {0, 4, 8, 12}},
        {GL_UNSIGNED_SHORT_5_5_5_1, COMPONENT_PACKED, 2, 4, {5, 5, 5, 1}, {11, 6, 1, 0}},
        {GL_UNSIGNED_SHORT_1_5_5_5_REV, COMPONENT_PACKED, 2, 4, {5, 5, 5, 1}, {0, 5, 10, 15}},
        {GL_UNSIGNED_INT_8_8_8_8, COMPONENT_PACKED, 4, 4, {8, 8, 8, 8}, {24, 16, 8, 0}},
        {GL_UNSIGNED_INT_8_8_8_8_REV, COMPONENT_PACKED, 4, 4, {8, 8, 8, 8}, {0, 8, 16, 24}},
        {GL_UNSIGNED_INT_10_10_10_2, COMPONENT_PACKED, 4, 4, {10, 10, 10, 2}, {22, 12, 2, 0}},
        {GL_UNSIGNED_INT_2_10_10_10_REV, COMPONENT_PACKED, 4, 4, {10, 10, 10, 2}, {0, 10, 20, 30}},
        {GL_UNSIGNED_INT_24_8, COMPONENT_PACKED, 4, 2, {24, 8}, {8, 0}},
};

const struct pixel_format *fgl_pixel_format(GLenum format)
{
    for (size_t i = 0; i < FGL_COUNTOF(formats); i++)
        if (formats[i].format == format)
            return &formats[i];
    return NULL;
}

const struct pixel_type *fgl_pixel_type(GLenum type)
{
    for (size_t i = 0; i < FGL_COUNTOF(types); i++)
        if (types[i].type == type)
            return &types[i];
    return NULL;
}

/* Whether a packed type may hold the format: table 3.8; three fields are for GL_RGB alone, two for GL_DEPTH_STENCIL. OSMesa rule:
 * GL_ABGR_EXT, which the table has not, goes with fields of one size. */
static bool fields_fit(const struct pixel_type *t, const struct pixel_format *f)
{
    switch (t->fields) {
    case 2: return f->format == GL_DEPTH_STENCIL;
    case 3: return f->format == GL_RGB;
    default: return f->components == 4 && (f->format != GL_ABGR_EXT || t->bits[0] == t->bits[3]);
    }
}

GLenum fgl_pixel_check(GLenum format, GLenum type)
{
    const struct pixel_format *f = fgl_pixel_format(format);
    const struct pixel_type *t = fgl_pixel_type(type);
    if (!f || !t)
        return GL_INVALID_ENUM;
    if (t->kind == COMPONENT_BITMAP && format != GL_COLOR_INDEX && format != GL_STENCIL_INDEX)
        return GL_INVALID_ENUM;
    if (format == GL_DEPTH_STENCIL && type != GL_UNSIGNED_INT_24_8)
        return GL_INVALID_ENUM;
    if (t->kind == COMPONENT_PACKED && !fields_fit(t, f))
        return GL_INVALID_OPERATION;
    return GL_NO_ERROR;
}

/* Bytes of `pixels` pixels in a row, without alignment. */
static size_t unaligned_bytes(const struct pixel_image *image, size_t pixels)
{
    return image->type->kind == COMPONENT_BITMAP ? (pixels + 7) / 8 : pixels * image->pixel_bytes;
}

struct pixel_image fgl_pixel_image(const struct pixel_store *store, GLenum format, GLenum type, int width,
                                   const void *pixels)
{
    struct pixel_image image = {.format = fgl_pixel_format(format), .type = fgl_pixel_type(type)};
    const bool bitmap = image.type->kind == COMPONENT_BITMAP;
    const size_t skip = (size_t)store->skip_pixels, alignment = (size_t)store->alignment;
    image.pixel_bytes =
            (size_t)image.type->bytes * (size_t)(image.type->fields ? 1 : image.format->components);
    const size_t row = unaligned_bytes(&image, (size_t)(store->row_length > 0 ? store->row_length : width));
    image.row_bytes = (row + alignment - 1) / alignment * alignment;
    image.first = (uintptr_t)pixels + (size_t)store->skip_rows * image.row_bytes +
                  (bitmap ? skip / 8 : skip * image.pixel_bytes);
    image.first_bit = bitmap ? (int)(skip % 8) : 0;
    image.swap_bytes = store->swap_bytes && image.type->bytes > 1;
    image.lsb_first = store->lsb_first;
    return image;
}

size_t fgl_pixel_image_bytes(const struct pixel_store *store, GLenum format, GLenum type, int width,
                             int height)
{
    if (width <= 0 || height <= 0)
        return 0;
    const struct pixel_image image = fgl_pixel_image(store, format, type, width, NULL);
    if ((double)height * (double)image.row_bytes > (double)(SIZE_MAX / 4))
        return SIZE_MAX / 2; /* more than there can be */
    return image.first + (size_t)(height - 1) * image.row_bytes +
           unaligned_bytes(&image, (size_t)width + (size_t)image.first_bit);
}

void fgl_swap_bytes(void *elements, size_t n, int bytes)
{
    uint8_t *p = elements;
    for (size_t i = 0; i < n; i++, p += bytes)
        for (int low = 0, high = bytes - 1; low < high; low++, high--) {
            const uint8_t byte = p[low];
            p[low] = p[high];
            p[high] = byte;
        }
}
