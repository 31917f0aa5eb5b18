/* Random pixels in memory. */
#include "pixel_data.h"

#include <string.h>

static const struct pixel_type types[] = {
        {GL_UNSIGNED_BYTE, 1, 0}, {GL_BYTE, 1, 0}, {GL_UNSIGNED_SHORT, 2, 0}, {GL_SHORT, 2, 0}, {GL_UNSIGNED_INT, 4, 0},
        {GL_INT, 4, 0}, {GL_FLOAT, 4, 0}, {GL_UNSIGNED_BYTE_3_3_2, 1, 3}, {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3},
        {GL_UNSIGNED_SHORT_5_6_5, 2, 3}, {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3}, {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4},
        {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4}, {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4}, {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4},
        {GL_UNSIGNED_INT_8_8_8_8, 4, 4}, {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4}, {GL_UNSIGNED_INT_10_10_10_2, 4, 4},
        {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4}};
enum { TYPES = sizeof types / sizeof types[0] };

int components_of(double format)
{
    if (format == GL_RGBA || format == GL_BGRA)
        return 4;
    if (format == GL_RGB || format == GL_BGR)
        return 3;
    return format == GL_LUMINANCE_ALPHA ? 2 : 1;
}

const struct pixel_type *random_pixel_type(struct generator *g, double format)
{
    for (;;) {
        const struct pixel_type *type = &types[chance(g, 40) ? 0 : below(g, TYPES)];
        if (type->components == 0 || (type->components == 3 ? format == GL_RGB : components_of(format) == 4))
            return type;
    }
}

static void add_bytes(struct generator *g, const void *element, int bytes)
{
    const unsigned char *p = element;
    for (int i = 0; i < bytes; i++) {
        const double value = p[i];
        script_extend(g->script, 1, &value);
    }
}

void add_random_elements(struct generator *g, const struct pixel_type *type, int count, bool indexes)
{
    for (int i = 0; i < count; i++) {
        uint32_t bits = (uint32_t)below(g, 1 << 16) << 16 | (uint32_t)below(g, 1 << 16);
        if (chance(g, 10))
            bits = chance(g, 50) ? 0 : 0xffffffffu;
        if (type->type == GL_FLOAT) {
            const float f = (float)(indexes ? below(g, 256) : chance(g, 10) ? below(g, 2) : real(g, 0.0, 1.0));
            memcpy(&bits, &f, sizeof bits);
        }
        add_bytes(g, &bits, type->bytes);
    }
}

int random_unpack_store(struct generator *g, int width, int height, int bytes, int per_pixel)
{
    const int row_length = chance(g, 15) ? width + below(g, 5) : 0, skip_pixels = chance(g, 15) ? below(g, 4) : 0,
              skip_rows = chance(g, 15) ? below(g, 3) : 0, alignment = chance(g, 30) ? 1 << below(g, 4) : 4;
    if (use(g, FEATURE_pixel_store)) {
        EMIT(g, PixelStorei, GL_UNPACK_ROW_LENGTH, row_length);
        EMIT(g, PixelStorei, GL_UNPACK_SKIP_PIXELS, skip_pixels);
        EMIT(g, PixelStorei, GL_UNPACK_SKIP_ROWS, skip_rows);
        EMIT(g, PixelStorei, GL_UNPACK_ALIGNMENT, alignment);
    }
    const int row = ((width + 8) * per_pixel * bytes + 8) / bytes;
    return row * (height + 3);
}

void add_random_bytes(struct generator *g, int count)
{
    add_random_elements(g, &types[0], count, false);
}

void plain_unpack_store(struct generator *g)
{
    EMIT(g, PixelStorei, GL_UNPACK_ROW_LENGTH, 0);
    EMIT(g, PixelStorei, GL_UNPACK_SKIP_ROWS, 0);
    EMIT(g, PixelStorei, GL_UNPACK_SKIP_PIXELS, 0);
}
