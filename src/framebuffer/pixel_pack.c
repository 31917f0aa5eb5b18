/* Packing a row: fetch from the framebuffer, pixel transfer, convert each component to the type, store. */
#include "framebuffer/pixel_pack.h"

#include "base/unorm.h"

#include "framebuffer/rows.h"

#include <string.h>

/* A chunk of converted components, one plane for each in the order of the format: the bits of the integer or
 * of the float. */
struct component_row {
    uint32_t value[PIXEL_MAX_COMPONENTS][PIXEL_CHUNK];
};

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

static uint32_t float_bits(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    return bits;
}

/* Bits of magnitude in component c of a type. */
static int type_bits(const struct pixel_type *type, int c)
{
    if (type->kind == COMPONENT_PACKED)
        return type->bits[c];
    return 8 * type->bytes - (type->kind == COMPONENT_SIGNED ? 1 : 0);
}

/* ---- colour ---- */

static void fetch_unorm8(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row)
{
    const uint32_t *pixel = (const uint32_t *)fb->color + at;
    const uint32_t alpha = fb->has_alpha ? 0 : 255;
    row->bits = 8;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            row->integer[c][i] = (pixel[i] >> (8 * c) & 255) | (c == 3 ? alpha : 0);
}

static void fetch_unorm16(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row)
{
    const uint16_t *pixel = (const uint16_t *)fb->color + 4 * at;
    row->bits = 16;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            row->integer[c][i] = c == 3 && !fb->has_alpha ? 65535 : pixel[4 * i + c];
}

/* OSMesa rule: reading clamps, from float buffers too. */
static void fetch_float(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row)
{
    const float *pixel = (const float *)fb->color + 4 * at;
    row->bits = 0;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            row->color.channel[c][i] = c == 3 && !fb->has_alpha ? 1.0f : fgl_clamp01(pixel[4 * i + c]);
}

static void fetch_565(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row, bool bytes)
{
    static const int shift[3] = {11, 5, 0}, bits[3] = {5, 6, 5};
    const uint16_t *pixel = (const uint16_t *)fb->color + at;
    row->bits = bytes ? 8 : 0;
    for (int c = 0; c < 3; c++) {
        const float step = 1.0f / (float)fgl_unorm_max(bits[c]);
        for (int i = 0; i < n; i++) {
            const uint32_t v = (uint32_t)pixel[i] >> shift[c] & fgl_unorm_max(bits[c]);
            row->integer[c][i] = fgl_unorm_resize(v, bits[c], 8);
            row->color.channel[c][i] = (float)v * step;
        }
    }
    for (int i = 0; i < n; i++) {
        row->integer[3][i] = 255;
        row->color.channel[3][i] = 1.0f;
    }
}

/* Integers to floats: OSMesa rule: v * (1 / max). */
static void fetched_to_float(struct fetched_row *row, int n)
{
    const float step = row->bits ? 1.0f / (float)fgl_unorm_max(row->bits) : 0.0f;
    for (int c = 0; row->bits && c < 4; c++)
        for (int i = 0; i < n; i++)
            row->color.channel[c][i] = (float)row->integer[c][i] * step;
    row->bits = 0;
}

/* OSMesa rule: between packed pixels, in the buffer or in memory, and other ones, but of an 8-bit buffer,
 * colours pass through 8 bits when no component of the destination has more, else through floats. `as_float`:
 * they are wanted as floats. */
static void fetch_color(const struct framebuffer *fb, int x, int y, int n, const struct pixel_type *type,
                        bool as_float, struct fetched_row *row)
{
    const size_t at = (size_t)y * (size_t)fb->stride + (size_t)x;
    const bool bytes = !as_float && type->kind != COMPONENT_SIGNED && type_bits(type, 0) <= 8;
    switch (fb->color_kind) {
    case COLOR_UNORM8: fetch_unorm8(fb, at, n, row); break;
    case COLOR_UNORM16: fetch_unorm16(fb, at, n, row); break;
    case COLOR_FLOAT: fetch_float(fb, at, n, row); break;
    case COLOR_565: fetch_565(fb, at, n, row, bytes); break;
    case COLOR_INDEX8: break; /* fetch_index */
    }
    if (as_float || (row->bits == 16 && type->kind == COMPONENT_PACKED && !bytes)) {
        fetched_to_float(row, n);
    } else if (row->bits == 16 && type->kind == COMPONENT_PACKED) {
        for (int c = 0; c < 4; c++)
            for (int i = 0; i < n; i++)
                row->integer[c][i] = fgl_unorm_resize(row->integer[c][i], 16, 8);
        row->bits = 8;
    }
}

static void fetch_index(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                        int32_t *index)
{
    const uint8_t *pixel = (const uint8_t *)fb->color + (size_t)y * (size_t)fb->stride + x;
    for (int i = 0; i < n; i++)
        index[i] = pixel[i];
    fgl_transfer_index(pack->mode, pack->maps, false, index, n);
}

/* Reading colours from a framebuffer of indexes (3.6.5 "Color Index Lookup"). */
static void fetch_index_as_color(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y,
                                 int n, struct fetched_row *row)
{
    int32_t index[PIXEL_CHUNK];
    fetch_index(pack, fb, x, y, n, index);
    fgl_transfer_index_to_color(pack->maps, index, &row->color, n);
    row->bits = 0;
}

/* GL 1.5, 4.3.2 "Conversion to L": R + G + B. OSMesa rule: the channels are clamped before, the sum after.
 * The sum takes the place of red. */
static void add_luminance(struct color_row *color, int n)
{
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            color->channel[c][i] = fgl_clamp01(color->channel[c][i]);
    for (int i = 0; i < n; i++)
        color->channel[0][i] =
                fgl_clamp01(color->channel[0][i] + color->channel[1][i] + color->channel[2][i]);
}

static void convert_color(const struct fetched_row *row, int channel, const struct pixel_type *type, int c,
                          int n, uint32_t *out)
{
    const int bits = type_bits(type, c);
    const bool half_up = type->kind == COMPONENT_PACKED && bits != 8,
               is_signed = type->kind == COMPONENT_SIGNED;
    if (type->kind == COMPONENT_FLOAT)
        for (int i = 0; i < n; i++)
            out[i] = float_bits(row->color.channel[channel][i]);
    else if (row->bits == 0)
        for (int i = 0; i < n; i++)
            out[i] = float_to_norm(row->color.channel[channel][i], fgl_unorm_max(bits), is_signed, half_up);
    else
        for (int i = 0; i < n; i++)
            out[i] = fgl_unorm_resize(row->integer[channel][i], row->bits, bits);
}

static int source_channel(const struct pixel_format *format, int c)
{
    return format->channel[c] == CHANNEL_LUMINANCE ? 0 : (int)format->channel[c];
}

static void convert_colors(const struct fetched_row *row, const struct pixel_format *format, const struct pixel_type *type, int n,
                           struct component_row *out)
{
    for (int c = 0; c < format->components; c++)
        convert_color(row, source_channel(format, c), type, c, n, out->value[c]);
}

static void pack_color(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                       struct component_row *out)
{
    const struct pixel_format *format = pack->image.format;
    const struct pixel_type *type = pack->image.type;
    const bool luminance = format->channel[0] == CHANNEL_LUMINANCE;
    const bool indexed = fb->color_kind == COLOR_INDEX8;
    const bool transfer = !indexed && fgl_transfer_color_active(pack->mode);
    /* OSMesa rule: index arithmetic, which does not concern colours, makes floats of them too. */
    const bool as_float = luminance || transfer || pack->mode->index_shift || pack->mode->index_offset;
    struct fetched_row row;

    if (indexed)
        fetch_index_as_color(pack, fb, x, y, n, &row);
    else
        fetch_color(fb, x, y, n, type, as_float || type->kind == COMPONENT_FLOAT, &row);
    if (transfer)
        fgl_transfer_color(pack->mode, pack->maps, &row.color, n);
    if (luminance)
        add_luminance(&row.color, n);
    convert_colors(&row, format, type, n, out);
}

/* ---- depth and stencil ---- */

/* OSMesa rules: GL_UNSIGNED_INT repeats the bits when nothing is to be done but that; signed types as GL 1.5,
 * table 4.7 says, c = ((2^b - 1) f - 1) / 2, each step towards zero, but GL_INT; unsigned ones are cut off,
 * but GL_UNSIGNED_SHORT is rounded. */
static uint32_t depth_to_type(float d, GLenum type)
{
    switch (type) {
    case GL_UNSIGNED_BYTE: return (uint32_t)(d * 255.0f);
    case GL_BYTE: return (uint32_t)((int32_t)(d * 255.0f - 1.0f) / 2);
    case GL_UNSIGNED_SHORT: return float_to_norm(d, 65535, false, false);
    case GL_SHORT: return (uint32_t)((int32_t)(d * 65535.0f - 1.0f) / 2);
    case GL_UNSIGNED_INT: return (uint32_t)((double)d * 4294967295.0);
    case GL_INT: return (uint32_t)((double)d * 2147483647.0);
    default: return float_bits(d);
    }
}

static void pack_depth(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                       struct component_row *out)
{
    const uint32_t *z = fb->depth + (size_t)y * (size_t)fb->stride + x;
    const GLenum type = pack->image.type->type;
    const bool transfer = fgl_transfer_depth_active(pack->mode);
    if (type == GL_UNSIGNED_INT && !transfer && !pack->image.swap_bytes) {
        for (int i = 0; i < n; i++)
            out->value[0][i] = fgl_unorm_resize(z[i], fb->depth_bits, 32);
        return;
    }
    float depth[PIXEL_CHUNK];
    if (fb->depth_bits <= 16) /* OSMesa rules */
        for (int i = 0; i < n; i++)
            depth[i] = (float)z[i] * (1.0f / (float)fb->depth_max);
    else
        fgl_row_kernels(ARITH_COMPATIBLE)->depth_to_float(z, n, fb->depth_max, depth);
    if (transfer)
        fgl_transfer_depth(pack->mode, depth, n);
    for (int i = 0; i < n; i++)
        out->value[0][i] = depth_to_type(depth[i], type);
}

/* GL 1.5, table 4.8: an index is masked with the type's largest value. */
static uint32_t index_to_type(int32_t index, const struct pixel_type *type)
{
    if (type->kind == COMPONENT_FLOAT)
        return float_bits((float)index);
    return type->kind == COMPONENT_BITMAP ? (uint32_t)index & 1
                                          : (uint32_t)index & fgl_unorm_max(type_bits(type, 0));
}

static void pack_index(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                       struct component_row *out)
{
    int32_t index[PIXEL_CHUNK];
    fetch_index(pack, fb, x, y, n, index);
    fgl_transfer_color_index(pack->mode, pack->maps, index, n);
    for (int i = 0; i < n; i++)
        out->value[0][i] = index_to_type(index[i], pack->image.type);
}

static void pack_stencil(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                         struct component_row *out)
{
    int32_t index[PIXEL_CHUNK];
    for (int i = 0; i < n; i++)
        index[i] = fb->stencil ? fb->stencil[(size_t)y * (size_t)fb->stride + (size_t)(x + i)] : 0;
    fgl_transfer_index(pack->mode, pack->maps, true, index, n);
    for (int i = 0; i < n; i++) /* OSMesa rule: what transfer gives is cut to 8 bits */
        out->value[0][i] = index_to_type(index[i] & 255, pack->image.type);
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

static void store_row(const struct pixel_image *image, int row, int column, int n,
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

void fgl_pack_row(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, int row,
                  int column)
{
    if (fgl_pack_row_plain(pack, fb, x, y, n, row, column))
        return;
    struct component_row components;
    for (int done = 0; done < n; done += PIXEL_CHUNK) {
        const int count = fgl_min(PIXEL_CHUNK, n - done);
        switch (pack->image.format->channel[0]) {
        case CHANNEL_DEPTH: pack_depth(pack, fb, x + done, y, count, &components); break;
        case CHANNEL_STENCIL: pack_stencil(pack, fb, x + done, y, count, &components); break;
        case CHANNEL_INDEX: pack_index(pack, fb, x + done, y, count, &components); break;
        default: pack_color(pack, fb, x + done, y, count, &components); break;
        }
        store_row(&pack->image, row, column + done, count, &components);
    }
}

/* Everything to integers of 8 bits. */
static void fetched_to_bytes(struct fetched_row *row, int n)
{
    for (int c = 0; row->bits != 8 && c < 4; c++)
        for (int i = 0; i < n; i++)
            row->integer[c][i] = row->bits ? fgl_unorm_resize(row->integer[c][i], row->bits, 8)
                                           : float_to_norm(row->color.channel[c][i], 255, false, false);
    row->bits = 8;
}

void fgl_pack_colors(const struct pixel_pack *pack, struct fetched_row *fetched, bool direct, int n, int row, int column)
{
    const struct pixel_format *format = pack->image.format;
    const struct pixel_type *type = pack->image.type;
    struct component_row components;
    if (type->kind == COMPONENT_FLOAT || (type->kind == COMPONENT_PACKED && type_bits(type, 0) > 8 && !direct))
        fetched_to_float(fetched, n);
    else if (type->kind == COMPONENT_PACKED && type_bits(type, 0) <= 8)
        fetched_to_bytes(fetched, n);
    convert_colors(fetched, format, type, n, &components);
    store_row(&pack->image, row, column, n, &components);
}

void fgl_pack_transferred(const struct pixel_pack *pack, struct color_row *colors, int n, int row, int column)
{
    struct fetched_row fetched = {.bits = 0};
    struct component_row components;
    if (pack->image.format->channel[0] == CHANNEL_LUMINANCE)
        add_luminance(colors, n);
    fetched.color = *colors;
    convert_colors(&fetched, pack->image.format, pack->image.type, n, &components);
    store_row(&pack->image, row, column, n, &components);
}

void fgl_pack_counts(const struct pixel_pack *pack, const uint32_t *const count[4], int n, int row, int column)
{
    const struct pixel_type *type = pack->image.type;
    struct component_row components;
    for (int c = 0; c < pack->image.format->components; c++) {
        const uint32_t *from = count[source_channel(pack->image.format, c)];
        const uint32_t max = type->kind == COMPONENT_FLOAT ? 0 : fgl_unorm_max(type_bits(type, c));
        for (int i = 0; i < n; i++)
            components.value[c][i] = type->kind == COMPONENT_FLOAT ? float_bits((float)from[i]) : from[i] < max ? from[i] : max;
    }
    store_row(&pack->image, row, column, n, &components);
}

void fgl_pack_depths(const struct pixel_pack *pack, const float *depth, int n, int row, int column)
{
    struct component_row components;
    for (int i = 0; i < n; i++)
        components.value[0][i] = depth_to_type(depth[i], pack->image.type->type);
    store_row(&pack->image, row, column, n, &components);
}
