/* Packing what is no framebuffer: texels, tables, counters. See pixel_pack.h. */
#include "framebuffer/pixel_components.h"

#include "base/arith_fma.h"
#include "base/unorm.h"

/* Everything to integers of 8 bits. */
static void fetched_to_bytes(struct fetched_row *row, int n)
{
    for (int c = 0; row->bits != 8 && c < 4; c++)
        for (int i = 0; i < n; i++)
            row->integer[c][i] = row->bits ? fgl_unorm_resize(row->integer[c][i], row->bits, 8)
                                           : fgl_float_to_norm(row->color.channel[c][i], 255);
    row->bits = 8;
}

void fgl_pack_colors(const struct pixel_pack *pack, struct fetched_row *fetched, bool direct, int n, int row, int column)
{
    const struct pixel_format *format = pack->image.format;
    const struct pixel_type *type = pack->image.type;
    struct component_row components;
    if (type->kind == COMPONENT_FLOAT || (type->kind == COMPONENT_PACKED && fgl_type_bits(type, 0) > 8 && !direct))
        fgl_fetched_to_float(fetched, n);
    else if (type->kind == COMPONENT_PACKED && fgl_type_bits(type, 0) <= 8)
        fetched_to_bytes(fetched, n);
    fgl_convert_colors(fetched, format, type, n, &components);
    fgl_store_components(&pack->image, row, column, n, &components);
}

void fgl_pack_transferred(const struct pixel_pack *pack, struct color_row *colors, int n, int row, int column)
{
    struct fetched_row fetched = {.bits = 0};
    struct component_row components;
    if (pack->image.format->channel[0] == CHANNEL_LUMINANCE)
        fgl_add_luminance(colors, n);
    fetched.color = *colors;
    fgl_convert_colors(&fetched, pack->image.format, pack->image.type, n, &components);
    fgl_store_components(&pack->image, row, column, n, &components);
}

void fgl_pack_counts(const struct pixel_pack *pack, const uint32_t *const count[4], int n, int row, int column)
{
    const struct pixel_type *type = pack->image.type;
    struct component_row components;
    for (int c = 0; c < pack->image.format->components; c++) {
        const uint32_t *from = count[fgl_component_channel(pack->image.format, c)];
        const uint32_t max = type->kind == COMPONENT_FLOAT ? 0 : fgl_unorm_max(fgl_type_bits(type, c));
        for (int i = 0; i < n; i++)
            components.value[c][i] = type->kind == COMPONENT_FLOAT ? fgl_float_bits((float)from[i]) : from[i] < max ? from[i] : max;
    }
    fgl_store_components(&pack->image, row, column, n, &components);
}

void fgl_pack_depths(const struct pixel_pack *pack, const float *depth, const uint8_t *stencil, int n, int row, int column)
{
    const bool both = pack->image.format->components == 2; /* GL_DEPTH_STENCIL: 24 bits as they are kept */
    struct component_row components;
    for (int i = 0; i < n; i++)
        components.value[0][i] = both ? (uint32_t)((double)depth[i] * 16777215.0 + 0.5) : fgl_convert_depth(depth[i], pack->image.type->type);
    for (int i = 0; both && i < n; i++)
        components.value[1][i] = stencil[i];
    fgl_store_components(&pack->image, row, column, n, &components);
}
