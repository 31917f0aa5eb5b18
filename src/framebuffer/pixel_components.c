/* Components. See pixel_components.h. */
#include "framebuffer/pixel_components.h"

#include "base/arith_fma.h"
#include "base/unorm.h"

#include <string.h>

/* ---- conversion of a component ---- */

/* A float to a normalized integer with the given maximum. OSMesa rule: the product is a float; it is rounded
 * half to even, half up in packed pixels; unsigned components are clamped to [0,1], signed ones to [-1,1]. */
static uint32_t float_to_norm(float v, uint32_t max, bool is_signed, bool half_up)
{
    const float lowest = is_signed ? -1.0f : 0.0f;
    if (v >= 1.0f)
        return max;
    if (!(v > lowest))
        return is_signed && v <= lowest ? 0u - max : 0;
    if (half_up)
        return (uint32_t)((double)(v * (float)max) + 0.5);
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: adding it rounds to an integer, half to even */
    return (uint32_t)(int64_t)(((double)(v * (float)max) + magic) - magic);
}

int fgl_type_bits(const struct pixel_type *type, int c)
{
    if (type->kind == COMPONENT_PACKED)
        return type->bits[c];
    return 8 * type->bytes - (type->kind == COMPONENT_SIGNED ? 1 : 0);
}

uint32_t fgl_float_to_norm(float v, uint32_t max)
{
    return float_to_norm(v, max, false, false);
}

/* ---- colours ---- */

void fgl_fetched_to_float(struct fetched_row *row, int n)
{
    const float step = row->bits ? 1.0f / (float)fgl_unorm_max(row->bits) : 0.0f;
    for (int c = 0; row->bits && c < 4; c++)
        for (int i = 0; i < n; i++)
            row->color.channel[c][i] = (float)row->integer[c][i] * step;
    row->bits = 0;
}

void fgl_clamp_colors(struct color_row *color, int n)
{
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            color->channel[c][i] = fgl_clamp01(color->channel[c][i]);
}

void fgl_add_luminance(struct color_row *color, int n)
{
    fgl_clamp_colors(color, n);
    for (int i = 0; i < n; i++)
        color->channel[0][i] =
                fgl_clamp01(color->channel[0][i] + color->channel[1][i] + color->channel[2][i]);
}

static void convert_color(const struct fetched_row *row, int channel, const struct pixel_type *type, int c,
                          int n, uint32_t *out)
{
    const int bits = fgl_type_bits(type, c);
    const bool half_up = type->kind == COMPONENT_PACKED && bits != 8,
               is_signed = type->kind == COMPONENT_SIGNED;
    if (type->kind == COMPONENT_FLOAT)
        for (int i = 0; i < n; i++)
            out[i] = fgl_float_bits(row->color.channel[channel][i]);
    else if (row->bits == 0)
        for (int i = 0; i < n; i++)
            out[i] = float_to_norm(row->color.channel[channel][i], fgl_unorm_max(bits), is_signed, half_up);
    else
        for (int i = 0; i < n; i++)
            out[i] = fgl_unorm_resize(row->integer[channel][i], row->bits, bits);
}

void fgl_convert_colors(const struct fetched_row *row, const struct pixel_format *format, const struct pixel_type *type, int n,
                           struct component_row *out)
{
    for (int c = 0; c < format->components; c++)
        convert_color(row, fgl_component_channel(format, c), type, c, n, out->value[c]);
}

/* ---- depths and indexes ---- */

/* OSMesa rules: GL_UNSIGNED_INT repeats the bits when nothing is to be done but that; signed types as GL 1.5,
 * table 4.7 says, c = ((2^b - 1) f - 1) / 2, each step towards zero, but GL_INT; unsigned ones are cut off,
 * but GL_UNSIGNED_SHORT is rounded. */
uint32_t fgl_convert_depth(float d, GLenum type)
{
    switch (type) {
    case GL_UNSIGNED_BYTE: return (uint32_t)(d * 255.0f);
    case GL_BYTE: return (uint32_t)((int32_t)(d * 255.0f - 1.0f) / 2);
    case GL_UNSIGNED_SHORT: return float_to_norm(d, 65535, false, false);
    case GL_SHORT: return (uint32_t)((int32_t)(d * 65535.0f - 1.0f) / 2);
    case GL_UNSIGNED_INT: return (uint32_t)((double)d * 4294967295.0);
    case GL_INT: return (uint32_t)((double)d * 2147483647.0);
    case GL_UNSIGNED_INT_24_8: return (uint32_t)(d * 16777215.0f);
    default: return fgl_float_bits(d);
    }
}

/* GL 1.5, table 4.8: an index is masked with the type's largest value. */
uint32_t fgl_convert_index(int32_t index, const struct pixel_type *type)
{
    if (type->kind == COMPONENT_FLOAT)
        return fgl_float_bits((float)index);
    return type->kind == COMPONENT_BITMAP ? (uint32_t)index & 1
                                          : (uint32_t)index & fgl_unorm_max(fgl_type_bits(type, 0));
}

/* ---- storing ---- */

static void store_bits(const struct pixel_image *image, uint8_t *row, int column, int n,
                       const uint32_t *value)
{
    for (int i = 0; i < n; i++) {
        const int bit = image->first_bit + column + i;
        const int mask = 1 << (image->lsb_first ? bit % 8 : 7 - bit % 8);
        row[bit / 8] = (uint8_t)(value[i] ? row[bit / 8] | mask : row[bit / 8] & ~mask);
    }
}

/* n elements, `step` bytes apart. */
static void store_elements(uint8_t *out, size_t step, int bytes, int n, const uint32_t *value)
{
    for (int i = 0; i < n; i++, out += step) {
        if (bytes == 1) {
            *out = (uint8_t)value[i];
        } else if (bytes == 2) {
            const uint16_t v = (uint16_t)value[i];
            memcpy(out, &v, sizeof v);
        } else {
            memcpy(out, &value[i], sizeof value[i]);
        }
    }
}

/* The fields of packed pixels together in value[0]. */
static void join_fields(const struct pixel_type *type, struct component_row *row, int n)
{
    for (int i = 0; i < n; i++) {
        uint32_t element = 0;
        for (int c = 0; c < type->fields; c++)
            element |= row->value[c][i] << type->shift[c];
        row->value[0][i] = element;
    }
}

void fgl_store_components(const struct pixel_image *image, int row, int column, int n,
                      struct component_row *components)
{
    const struct pixel_type *type = image->type;
    uint8_t *start = fgl_pixel_row(image, row);
    if (type->kind == COMPONENT_BITMAP) {
        store_bits(image, start, column, n, components->value[0]);
        return;
    }
    start += (size_t)column * image->pixel_bytes;
    if (type->kind == COMPONENT_PACKED)
        join_fields(type, components, n);
    const int elements = type->fields ? 1 : image->format->components;
    for (int c = 0; c < elements; c++)
        store_elements(start + c * type->bytes, image->pixel_bytes, type->bytes, n, components->value[c]);
    if (image->swap_bytes)
        fgl_swap_bytes(start, (size_t)n * (size_t)elements, type->bytes);
}
