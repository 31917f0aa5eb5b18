/* Packing a row of a framebuffer: fetch, pixel transfer, convert each component to the type, store. */
#include "framebuffer/pixel_pack.h"

#include "base/unorm.h"
#include "framebuffer/pixel_components.h"
#include "framebuffer/rows.h"

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

static void fetch_float(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row)
{
    const float *pixel = (const float *)fb->color + 4 * at;
    row->bits = 0;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++)
            row->color.channel[c][i] = c == 3 && !fb->has_alpha ? 1.0f : pixel[4 * i + c];
}

/* The colours of an image of few bits as bytes. OSMesa rule: 5 bits are repeated. */
static void fetch_image_bytes(const struct framebuffer *fb, size_t at, int n, struct fetched_row *row)
{
    fetch_float(fb, at, n, row);
    row->bits = 8;
    for (int c = 0; c < 4; c++) {
        const bool repeated = fb->image_bits[c] == 5;
        for (int i = 0; i < n; i++) {
            const uint32_t v = fgl_unorm(row->color.channel[c][i], repeated ? 31.0f : 255.0f);
            row->integer[c][i] = repeated ? v << 3 | v >> 2 : v;
        }
    }
}

static bool has_few_bits(const struct framebuffer *fb)
{
    return fb->image_bits[0] && fb->image_bits[0] < 8;
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

/* OSMesa rule: between packed pixels, in the buffer or in memory, and other ones, but of an 8-bit buffer in the order red,
 * green, blue, alpha, colours pass through 8 bits when no component of the destination has more, else through floats.
 * `as_float`: they are wanted as floats. */
static void fetch_color(const struct framebuffer *fb, int x, int y, int n, const struct pixel_type *type,
                        bool as_float, struct fetched_row *row)
{
    const size_t at = (size_t)y * (size_t)fb->stride + (size_t)x;
    const bool bytes = !as_float && type->kind != COMPONENT_SIGNED && fgl_type_bits(type, 0) <= 8;
    switch (fb->color_kind) {
    case COLOR_UNORM8: fetch_unorm8(fb, at, n, row); break;
    case COLOR_UNORM16: fetch_unorm16(fb, at, n, row); break;
    case COLOR_FLOAT:
        if (bytes && has_few_bits(fb))
            fetch_image_bytes(fb, at, n, row);
        else
            fetch_float(fb, at, n, row);
        break;
    case COLOR_565: fetch_565(fb, at, n, row, bytes); break;
    case COLOR_INDEX8: break; /* fetch_index */
    }
    const bool packs = type->kind == COMPONENT_PACKED && (row->bits == 16 || (row->bits == 8 && fb->reordered));
    if (as_float || (packs && !bytes)) {
        fgl_fetched_to_float(row, n);
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
    if (pack->clamps && fb->color_kind == COLOR_FLOAT)
        fgl_clamp_colors(&row.color, n);
    if (luminance)
        fgl_add_luminance(&row.color, n);
    fgl_convert_colors(&row, format, type, n, out);
}

/* ---- depth and stencil ---- */

/* Depths as integers of the type when nothing is to be done to them but that. OSMesa rule: GL_UNSIGNED_INT repeats the bits. */
static bool pack_whole_depth(const struct pixel_pack *pack, const struct framebuffer *fb, const uint32_t *z, int n, uint32_t *out)
{
    const GLenum type = pack->image.type->type;
    const bool whole = type == GL_UNSIGNED_INT_24_8 || (type == GL_UNSIGNED_INT && !pack->image.swap_bytes);
    if (!whole || fgl_transfer_depth_active(pack->mode))
        return false;
    for (int i = 0; i < n; i++)
        out[i] = fgl_unorm_resize(z[i], fb->depth_bits, type == GL_UNSIGNED_INT ? 32 : 24);
    return true;
}

static void pack_depth(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, uint32_t *out)
{
    const uint32_t *z = fb->depth + (size_t)y * (size_t)fb->stride + x;
    float depth[PIXEL_CHUNK];
    if (pack_whole_depth(pack, fb, z, n, out))
        return;
    if (fb->depth_bits <= 16) /* OSMesa rules */
        for (int i = 0; i < n; i++)
            depth[i] = (float)z[i] * (1.0f / (float)fb->depth_max);
    else
        fgl_row_kernels(ARITH_COMPATIBLE)->depth_to_float(z, n, fb->depth_max, depth);
    if (fgl_transfer_depth_active(pack->mode))
        fgl_transfer_depth(pack->mode, depth, n);
    for (int i = 0; i < n; i++)
        out[i] = fgl_convert_depth(depth[i], pack->image.type->type);
}

static void pack_index(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n,
                       struct component_row *out)
{
    int32_t index[PIXEL_CHUNK];
    fetch_index(pack, fb, x, y, n, index);
    fgl_transfer_color_index(pack->mode, pack->maps, index, n);
    for (int i = 0; i < n; i++)
        out->value[0][i] = fgl_convert_index(index[i], pack->image.type);
}

static void pack_stencil(const struct pixel_pack *pack, const struct framebuffer *fb, int x, int y, int n, uint32_t *out)
{
    int32_t index[PIXEL_CHUNK];
    for (int i = 0; i < n; i++)
        index[i] = fb->stencil ? fb->stencil[(size_t)y * (size_t)fb->stride + (size_t)(x + i)] : 0;
    fgl_transfer_index(pack->mode, pack->maps, true, index, n);
    for (int i = 0; i < n; i++) /* OSMesa rule: what transfer gives is cut to 8 bits */
        out[i] = fgl_convert_index(index[i] & 255, pack->image.type);
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
        case CHANNEL_DEPTH:
            pack_depth(pack, fb, x + done, y, count, components.value[0]);
            if (pack->image.format->components == 2) /* GL_DEPTH_STENCIL */
                pack_stencil(pack, fb, x + done, y, count, components.value[1]);
            break;
        case CHANNEL_STENCIL: pack_stencil(pack, fb, x + done, y, count, components.value[0]); break;
        case CHANNEL_INDEX: pack_index(pack, fb, x + done, y, count, &components); break;
        default: pack_color(pack, fb, x + done, y, count, &components); break;
        }
        fgl_store_components(&pack->image, row, column + done, count, &components);
    }
}
