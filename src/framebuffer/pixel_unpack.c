/* Unpacking a row: load elements, convert each component, pixel transfer. */
#include "framebuffer/pixel_unpack.h"

#include "base/arith_fma.h"
#include "base/unorm.h"

#include "base/color_index.h"

#include <string.h>

const struct pixel_store fgl_packed_store = {.alignment = 1};

/* ---- loading ---- */

/* The first element of pixel `column`, and the elements from a pixel to the next. */
static const uint8_t *element_at(const struct pixel_image *image, int row, int column)
{
    return fgl_pixel_row(image, row) + (size_t)column * image->pixel_bytes;
}

/* n elements, `step` bytes apart. */
static FGL_ALWAYS_INLINE void load_elements(const uint8_t *p, size_t step, int n, const int bytes, const bool swap,
                                            uint32_t *FGL_RESTRICT out)
{
    for (int i = 0; i < n; i++, p += step) {
        uint16_t v2;
        uint32_t v = *p;
        if (bytes == 2) {
            memcpy(&v2, p, sizeof v2);
            v = swap ? (uint32_t)(v2 >> 8 | (v2 & 255) << 8) : v2;
        } else if (bytes == 4) {
            memcpy(&v, p, sizeof v);
            v = swap ? v >> 24 | (v >> 8 & 0xff00) | (v & 0xff00) << 8 | v << 24 : v;
        }
        out[i] = v;
    }
}

/* Component c of n pixels, as the bits of its element or the field of its pixel. */
static void load_component(const struct pixel_image *image, int row, int column, int n, int c, uint32_t *out)
{
    const struct pixel_type *type = image->type;
    const uint8_t *p = element_at(image, row, column) + (type->fields ? 0 : c * type->bytes);
    const size_t step = image->pixel_bytes;
    switch (image->swap_bytes ? -type->bytes : type->bytes) {
    case 2: load_elements(p, step, n, 2, false, out); break;
    case 4: step == 4 ? (void)memcpy(out, p, (size_t)n * 4) : load_elements(p, step, n, 4, false, out); break;
    case -2: load_elements(p, step, n, 2, true, out); break;
    case -4: load_elements(p, step, n, 4, true, out); break;
    default: load_elements(p, step, n, 1, false, out); break;
    }
    for (int i = 0; type->fields && i < n; i++)
        out[i] = out[i] >> type->shift[c] & (0xffffffffu >> (32 - type->bits[c]));
}

/* The element's value as a signed integer of its type. */
static int32_t signed_of(uint32_t v, int bytes)
{
    return bytes == 1 ? (int8_t)v : bytes == 2 ? (int16_t)v : (int32_t)v;
}

/* ---- colour ---- */

/* OSMesa rules: v * (1 / max) in float. 32-bit integers are first reduced to 16 bits, unsigned ones rounded,
 * signed ones shifted; packed fields of less than 8 bits are first extended to 8 by repeating their bits. */
static void convert_unsigned(const uint32_t *v, int n, int bits, float *out)
{
    if (bits == 32) {
        for (int i = 0; i < n; i++)
            out[i] = (float)(((uint64_t)v[i] * 65535 + 0x7fffffff) / 0xffffffff) * (1.0f / 65535.0f);
    } else if (bits < 8) {
        for (int i = 0; i < n; i++) {
            uint32_t repeated = v[i] << (8 - bits);
            for (int have = bits; have < 8; have *= 2)
                repeated |= repeated >> have;
            out[i] = (float)repeated * (1.0f / 255.0f);
        }
    } else {
        const float step = 1.0f / (float)(0xffffffffu >> (32 - bits));
        for (int i = 0; i < n; i++)
            out[i] = (float)v[i] * step;
    }
}

static void convert_signed(const uint32_t *v, int n, int bytes, float *out)
{
    const float step = bytes == 1 ? 1.0f / 127.0f : 1.0f / 32767.0f;
    for (int i = 0; i < n; i++) {
        const int32_t value = signed_of(v[i], bytes);
        const float f = (float)(bytes == 4 ? (int32_t)(int16_t)(v[i] >> 16) : value) * step;
        out[i] = f < -1.0f ? -1.0f : f;
    }
}

/* OSMesa rules for texels: integers become those of 8 or 16 bits, when negative 0; or floats of all their bits. */
static void convert_texels(const struct pixel_type *type, int c, enum unpack_steps steps, const uint32_t *v, int n,
                           float *out)
{
    const bool is_signed = type->kind == COMPONENT_SIGNED;
    const int bits = type->fields ? type->bits[c] : 8 * type->bytes - (is_signed ? 1 : 0);
    const int to = steps == UNPACK_UNORM8 ? 8 : steps == UNPACK_UNORM16 && !type->fields ? 16 : 0;
    const float step = 1.0f / (float)fgl_unorm_max(to ? to : bits);
    for (int i = 0; i < n; i++) {
        const int32_t value = is_signed ? signed_of(v[i], type->bytes) : 0;
        if (to)
            out[i] = (float)(value < 0 ? 0 : fgl_unorm_resize(is_signed ? (uint32_t)value : v[i], bits, to)) * step;
        else if (is_signed)
            out[i] = value < -(int32_t)fgl_unorm_max(bits) ? -1.0f : (float)value * step;
        else
            out[i] = (float)v[i] * step;
    }
}

static void convert_component(const struct pixel_type *type, int c, enum unpack_steps steps, const uint32_t *v, int n,
                              float *out)
{
    if (steps != UNPACK_DRAWN && type->kind != COMPONENT_FLOAT)
        convert_texels(type, c, steps, v, n, out);
    else if (type->kind == COMPONENT_FLOAT)
        for (int i = 0; i < n; i++)
            out[i] = fgl_bits_float(v[i]);
    else if (type->kind == COMPONENT_SIGNED)
        convert_signed(v, n, type->bytes, out);
    else
        convert_unsigned(v, n, type->fields ? type->bits[c] : 8 * type->bytes, out);
}

/* GL 1.5, 3.6.4 "Final Expansion to RGBA": missing colours are 0, missing alpha is 1; luminance is all three
 * colours. */
static void expand(const struct pixel_format *format, struct color_row *row, int n)
{
    bool given[4] = {false, false, false, false};
    for (int c = 0; c < format->components; c++)
        if (format->channel[c] != CHANNEL_LUMINANCE)
            given[format->channel[c]] = true;
    if (format->channel[0] == CHANNEL_LUMINANCE) {
        given[0] = given[1] = given[2] = true;
        memcpy(row->channel[1], row->channel[0], (size_t)n * sizeof(float));
        memcpy(row->channel[2], row->channel[0], (size_t)n * sizeof(float));
    }
    for (int c = 0; c < 4; c++)
        for (int i = 0; !given[c] && i < n; i++)
            row->channel[c][i] = c == 3 ? 1.0f : 0.0f;
}

/* ---- indexes ---- */

static void unpack_index(const struct pixel_unpack *unpack, int row, int column, int n, bool stencil,
                         int32_t *out)
{
    const struct pixel_type *type = unpack->image.type;
    uint32_t v[PIXEL_CHUNK];
    if (type->kind == COMPONENT_BITMAP) {
        uint32_t bits = 0;
        for (int i = 0; i < n; i++) {
            bits = i % BITMAP_CHUNK ? bits >> 1 : fgl_unpack_bits(&unpack->image, row, column + i, fgl_min(BITMAP_CHUNK, n - i));
            out[i] = bits & 1;
        }
    } else {
        load_component(&unpack->image, row, column, n, unpack->image.format->components - 1, v); /* of GL_DEPTH_STENCIL the second */
        for (int i = 0; i < n; i++)
            out[i] = type->kind == COMPONENT_FLOAT    ? fgl_index_of(fgl_bits_float(v[i]))
                     : type->kind == COMPONENT_SIGNED ? signed_of(v[i], type->bytes)
                                                      : (int32_t)v[i];
    }
    fgl_transfer_index(unpack->mode, unpack->maps, stencil, out, n);
}

void fgl_unpack_color_index(const struct pixel_unpack *unpack, int row, int column, int n, float *out)
{
    int32_t index[PIXEL_CHUNK];
    unpack_index(unpack, row, column, n, false, index);
    fgl_transfer_color_index(unpack->mode, unpack->maps, index, n);
    for (int i = 0; i < n; i++)
        out[i] = (float)(index[i] & FGL_INDEX_MAX);
}

void fgl_unpack_color(const struct pixel_unpack *unpack, int row, int column, int n, struct color_row *out)
{
    const struct pixel_image *image = &unpack->image;
    const struct pixel_format *format = image->format;
    if (format->channel[0] == CHANNEL_INDEX) {
        int32_t index[PIXEL_CHUNK];
        unpack_index(unpack, row, column, n, false, index);
        fgl_transfer_index_to_color(unpack->maps, index, out, n);
        return;
    }
    const bool transfer = fgl_transfer_color_active(unpack->mode);
    const enum unpack_steps steps = transfer && unpack->steps != UNPACK_DRAWN ? UNPACK_FLOAT : unpack->steps;
    uint32_t v[PIXEL_CHUNK];
    for (int c = 0; c < format->components; c++) {
        const int channel = format->channel[c] == CHANNEL_LUMINANCE ? 0 : (int)format->channel[c];
        load_component(image, row, column, n, c, v);
        convert_component(image->type, c, steps, v, n, out->channel[channel]);
    }
    expand(format, out, n);
    if (transfer)
        fgl_transfer_color(unpack->mode, unpack->maps, out, n);
}

/* ---- depth and stencil ---- */

/* OSMesa rule: depths pass through an integer of 32, 16 or 24 bits, by type, which floats are cut to; and 32
 * bits are read as their first 23. */
struct depth_steps {
    int bits;
    float step;
    int shift;
};

static struct depth_steps depth_steps_of(GLenum type)
{
    if (type == GL_UNSIGNED_INT)
        return (struct depth_steps){32, 1.0f / 8388607.0f, 9};
    if (type == GL_UNSIGNED_SHORT)
        return (struct depth_steps){16, 1.0f / 65535.0f, 0};
    return (struct depth_steps){24, 1.0f / 16777215.0f, 0};
}

/* Depths in [0,1]. OSMesa rules: signed integers as GL 1.5, table 2.9 says, (2c + 1) / (2^b - 1), but with 2^b - 2 of 32 bits; and 0 of 8
 * and 16 bits is 0. */
static float depth_of(const struct pixel_type *type, uint32_t v)
{
    const int32_t value = signed_of(v, type->bytes);
    switch (type->type) {
    case GL_UNSIGNED_BYTE: return (float)v / 255.0f;
    case GL_BYTE: return value ? (2.0f * (float)value + 1.0f) * (1.0f / 255.0f) : 0.0f;
    case GL_UNSIGNED_SHORT: return (float)v * (1.0f / 65535.0f);
    case GL_SHORT: return value ? (2.0f * (float)value + 1.0f) * (1.0f / 65535.0f) : 0.0f;
    case GL_UNSIGNED_INT: return (float)((double)v * (1.0 / 4294967295.0));
    case GL_INT: return (2.0f * (float)value + 1.0f) * (1.0f / 4294967294.0f);
    case GL_UNSIGNED_INT_24_8: return (float)((double)v / 16777215.0);
    default: return fgl_bits_float(v);
    }
}

/* To an integer of so many bits, cut off. */
static uint32_t cut_depth(float depth, int bits)
{
    const float max = (float)fgl_unorm_max(bits);
    return bits <= 24 ? (uint32_t)(depth * max) : (uint32_t)((double)depth * (double)fgl_unorm_max(bits));
}

void fgl_unpack_depth(const struct pixel_unpack *unpack, int row, int column, int n, float *out)
{
    const struct pixel_type *type = unpack->image.type;
    const struct depth_steps s = depth_steps_of(type->type);
    const bool exact = type->kind == COMPONENT_UNSIGNED && !fgl_transfer_depth_active(unpack->mode);
    uint32_t v[PIXEL_CHUNK];
    load_component(&unpack->image, row, column, n, 0, v);
    if (type->kind == COMPONENT_FLOAT)
        memcpy(out, v, (size_t)n * sizeof *out);
    for (int i = 0; i < n && type->kind != COMPONENT_FLOAT; i++)
        out[i] = depth_of(type, v[i]);
    fgl_transfer_depth(unpack->mode, out, n);
    for (int i = 0; i < n && type->kind != COMPONENT_FLOAT; i++) {
        const uint32_t whole = exact ? (type->bytes == 1 ? v[i] * 65793 : v[i]) : cut_depth(out[i], s.bits);
        out[i] = (float)(whole >> s.shift) * s.step;
    }
}

void fgl_unpack_depth_texels(const struct pixel_unpack *unpack, int row, int column, int n, int bits, uint32_t *out)
{
    const struct pixel_type *type = unpack->image.type;
    const bool packed = type->kind == COMPONENT_PACKED; /* GL_UNSIGNED_INT_24_8 */
    const int have = packed ? 24 : 8 * type->bytes;
    const bool transfer = fgl_transfer_depth_active(unpack->mode);
    /* OSMesa rule: these are integers all the way. */
    const bool whole = !transfer && (packed || (type->kind == COMPONENT_UNSIGNED && have >= 16 && bits != 24));
    float depth[PIXEL_CHUNK];
    load_component(&unpack->image, row, column, n, 0, out);
    for (int i = 0; i < n; i++)
        depth[i] = depth_of(type, out[i]);
    if (transfer)
        fgl_transfer_depth(unpack->mode, depth, n);
    for (int i = 0; i < n; i++)
        out[i] = !whole        ? cut_depth(fgl_clamp01(depth[i]), bits)
                 : have > bits ? out[i] >> (have - bits)
                               : fgl_unorm_resize(out[i], have, bits);
}

void fgl_unpack_stencil(const struct pixel_unpack *unpack, int row, int column, int n, int32_t *out)
{
    unpack_index(unpack, row, column, n, true, out);
}

/* In each byte. */
static uint64_t reverse_bits(uint64_t v)
{
    v = (v >> 1 & 0x5555555555555555) | (v & 0x5555555555555555) << 1;
    v = (v >> 2 & 0x3333333333333333) | (v & 0x3333333333333333) << 2;
    return (v >> 4 & 0x0f0f0f0f0f0f0f0f) | (v & 0x0f0f0f0f0f0f0f0f) << 4;
}

uint32_t fgl_unpack_bits(const struct pixel_image *image, int row, int column, int n)
{
    const int first = image->first_bit + column, bytes = (first + n - 1) / 8 - first / 8 + 1;
    const uint8_t *from = fgl_pixel_row(image, row) + first / 8;
    uint64_t bits = 0;
    for (int i = 0; i < bytes; i++)
        bits |= (uint64_t)from[i] << (8 * i);
    if (!image->lsb_first)
        bits = reverse_bits(bits);
    return (uint32_t)(bits >> first % 8) & 0xffffffff >> (BITMAP_CHUNK - n);
}

/* ---- copies for display lists ---- */

static void copy_bits(const struct pixel_image *image, int row, int width, uint8_t *out)
{
    for (int x = 0; x < width; x += 8)
        out[x / 8] = (uint8_t)reverse_bits(fgl_unpack_bits(image, row, x, fgl_min(8, width - x)));
}

void fgl_pixel_copy(const struct pixel_store *store, GLenum format, GLenum type, int width, int height,
                    const void *pixels, void *out)
{
    const struct pixel_image from = fgl_pixel_image(store, format, type, width, pixels);
    const struct pixel_image to = fgl_pixel_image(&fgl_packed_store, format, type, width, out);
    for (int y = 0; y < height; y++) {
        uint8_t *row = fgl_pixel_row(&to, y);
        if (from.type->kind == COMPONENT_BITMAP) {
            copy_bits(&from, y, width, row);
            continue;
        }
        memcpy(row, fgl_pixel_row(&from, y), to.row_bytes);
        if (from.swap_bytes)
            fgl_swap_bytes(row, to.row_bytes / (size_t)from.type->bytes, from.type->bytes);
    }
}
