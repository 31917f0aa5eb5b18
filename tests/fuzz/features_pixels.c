/* Features: raster positions, bitmaps, pixel rectangles, pixel transfer and maps. */
#include "generator.h"
#include "pixel_data.h"

/* ---- where ---- */

void feature_raster_pos(struct generator *g)
{
    double v[4];
    random_position(g, v);
    const double w = real(g, 0.5, 2.0);
    if (chance(g, 30))
        emit_color(g);
    /* Not lit: OSMesa measures from the object coordinates to the light, and without shininess may lose the highlight. */
    switch (g->enabled[FEATURE_lighting] ? integer(g, 3, 4) : below(g, 5)) {
    case 0: EMIT(g, RasterPos2f, v[0], v[1]); break;
    case 1: EMIT(g, RasterPos3f, v[0], v[1], v[2]); break;
    case 2: EMIT(g, RasterPos4f, (double)(float)(v[0] * w), (double)(float)(v[1] * w), (double)(float)(v[2] * w), w); break;
    case 3: EMIT(g, WindowPos2f, real(g, 0.0, g->script->width), real(g, 0.0, g->script->height)); break;
    default: EMIT(g, WindowPos3f, real(g, -5.0, g->script->width), real(g, -5.0, g->script->height), real(g, 0.0, 1.0));
    }
}

/* In the middle of the window or somewhere. */
static void emit_place(struct generator *g)
{
    if (chance(g, 50) && use(g, FEATURE_raster_pos))
        feature_raster_pos(g);
    else if (chance(g, 60))
        EMIT(g, WindowPos2f, below(g, g->script->width / 2), below(g, g->script->height / 2));
}

/* ---- transfer ---- */

void feature_pixel_transfer(struct generator *g)
{
    static const double scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE},
                        biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS};
    for (int i = 0; i < 5; i++) {
        if (chance(g, 40))
            EMIT(g, PixelTransferf, scales[i], chance(g, 40) ? 1.0 : real(g, -1.0, 2.0));
        if (chance(g, 40))
            EMIT(g, PixelTransferf, biases[i], chance(g, 40) ? 0.0 : real(g, -0.5, 0.5));
    }
}

void feature_pixel_map(struct generator *g)
{
    const int map = below(g, 10), size = map < 6 ? 1 << below(g, 7) : integer(g, 1, 40);
    EMIT(g, PixelMapfv, GL_PIXEL_MAP_I_TO_I + map, size);
    for (int i = 0; i < size; i++) {
        const double value = map < 2 ? below(g, 256) : real(g, 0.0, 1.0);
        script_extend(g->script, 1, &value);
    }
}

/* What OSMesa does not apply to every rectangle is off. */
static void emit_plain_transfer(struct generator *g)
{
    EMIT(g, PixelTransferf, GL_DEPTH_SCALE, 1.0);
    EMIT(g, PixelTransferf, GL_DEPTH_BIAS, 0.0);
}

/* ---- drawing ---- */

void feature_pixel_zoom(struct generator *g)
{
    static const double zooms[] = {1.0, 1.0, -1.0, 2.0, -2.0, 3.0, 0.5, 1.5};
    if (chance(g, 60))
        EMIT(g, PixelZoom, one_of(g, 8, zooms), one_of(g, 8, zooms));
    else
        EMIT(g, PixelZoom, real(g, -3.0, 3.0), real(g, -3.0, 3.0));
}

void emit_no_color_sum(struct generator *g)
{
    if (!g->enabled[FEATURE_color_sum] && !g->enabled[FEATURE_secondary_color_inside])
        return;
    EMIT(g, Disable, GL_COLOR_SUM);
    if (g->enabled[FEATURE_lighting])
        EMIT(g, LightModeli, GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
}

void feature_bitmap(struct generator *g)
{
    const int width = integer(g, 1, 24), height = integer(g, 1, 16);
    emit_place(g);
    emit_no_color_sum(g);
    if (use(g, FEATURE_pixel_store))
        EMIT(g, PixelStorei, GL_UNPACK_LSB_FIRST, below(g, 2));
    for (int n = integer(g, 1, 3); n > 0; n--) {
        const int count = random_unpack_store(g, width, height, 1, 1);
        EMIT(g, Bitmap, width, height, chance(g, 50) ? 0.0 : real(g, -4.0, 4.0), chance(g, 50) ? 0.0 : real(g, -4.0, 4.0),
             (double)width + real(g, 0.0, 2.0), chance(g, 70) ? 0.0 : real(g, -4.0, 4.0));
        add_random_bytes(g, count);
        /* OSMesa gathers bitmaps and draws those that overlap only once. */
        if (!g->compiling)
            EMIT0(g, Flush);
    }
    EMIT(g, PixelStorei, GL_UNPACK_LSB_FIRST, 0);
}

/* Not GL_COLOR_INDEX, of which OSMesa draws some pixels arbitrarily. */
void feature_draw_pixels(struct generator *g)
{
    const double format = ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_BGR, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,
                                 GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX);
    const bool indexes = format == GL_STENCIL_INDEX;
    const struct pixel_type *type = random_pixel_type(g, format);
    const int width = integer(g, 1, 20), height = integer(g, 1, 14);
    const int per_pixel = type->components ? 1 : components_of(format);
    if ((format == GL_DEPTH_COMPONENT && g->script->buffers.depth_bits == 0) ||
        (format == GL_STENCIL_INDEX && (g->script->buffers.stencil_bits == 0 || g->querying)))
        return; /* departure counted-stencils */
    if (textured_later(g) && !indexes)
        return;
    emit_place(g);
    const int count = random_unpack_store(g, width, height, type->bytes, per_pixel);
    if (g->arrays_set) /* after arrays were drawn the current coordinates are indeterminate (GL 1.5, 2.8) */
        EMIT(g, TexCoord4f, real(g, -1.0, 2.0), real(g, -1.0, 2.0), real(g, -1.0, 2.0), 1.0);
    EMIT(g, DrawPixels, width, height, format, type->type);
    add_random_elements(g, type, count, indexes);
}

void feature_copy_pixels(struct generator *g)
{
    const int width = g->script->width, height = g->script->height, x = below(g, width), y = below(g, height);
    const double type = ONE_OF(g, GL_COLOR, GL_COLOR, GL_DEPTH, GL_STENCIL);
    if ((type == GL_DEPTH && g->script->buffers.depth_bits == 0) || (type == GL_STENCIL && (g->script->buffers.stencil_bits == 0 || g->querying)))
        return;
    emit_place(g);
    emit_plain_transfer(g);
    /* OSMesa does not always heed the color mask, and gives depths the current color instead of the raster position's. */
    const double write_color = type != GL_DEPTH;
    EMIT(g, ColorMask, write_color, write_color, write_color, write_color);
    if (type == GL_DEPTH)
        EMIT(g, Disable, GL_ALPHA_TEST); /* which sees that color, too (departure copied-depths) */
    EMIT(g, CopyPixels, x, y, integer(g, 1, width - x), integer(g, 1, height - y), type);
    EMIT(g, ColorMask, 1, 1, 1, 1);
}

/* ---- reading ---- */

void feature_pixel_store(struct generator *g)
{
    EMIT(g, PixelStorei, GL_PACK_ALIGNMENT, 1 << below(g, 4));
    if (chance(g, 30))
        EMIT(g, PixelStorei, GL_PACK_SKIP_PIXELS, below(g, 4));
    if (chance(g, 30))
        EMIT(g, PixelStorei, GL_PACK_SKIP_ROWS, below(g, 3));
    if (chance(g, 20))
        EMIT(g, PixelStorei, GL_PACK_SWAP_BYTES, below(g, 2));
}

void feature_read_pixels(struct generator *g)
{
    const int width = g->script->width, height = g->script->height, x = below(g, width), y = below(g, height);
    const struct buffers *b = &g->script->buffers;
    const double format = ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_BGR, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE,
                                 GL_LUMINANCE_ALPHA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX);
    if ((format == GL_DEPTH_COMPONENT && b->depth_bits == 0) || (format == GL_STENCIL_INDEX && b->stencil_bits == 0))
        return;
    /* 1.0 overflows in OSMesa where it becomes an integer of 32 bits from a float: in sums, after a transfer, from some buffers. */
    const bool overflows = format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA || b->type != GL_UNSIGNED_BYTE ||
                           g->enabled[FEATURE_pixel_transfer] || g->enabled[FEATURE_pixel_map];
    double type;
    do
        type = random_pixel_type(g, format)->type;
    while ((type == GL_UNSIGNED_INT || type == GL_INT) && format != GL_STENCIL_INDEX && overflows);
    const bool map = format != GL_DEPTH_COMPONENT && chance(g, 15) && use(g, FEATURE_pixel_map);
    if (map)
        EMIT(g, PixelTransferi, format == GL_STENCIL_INDEX ? GL_MAP_STENCIL : GL_MAP_COLOR, GL_TRUE);
    EMIT(g, ReadPixels, x, y, integer(g, 1, width - x), integer(g, 1, height - y), format, type);
    if (map)
        EMIT(g, PixelTransferi, format == GL_STENCIL_INDEX ? GL_MAP_STENCIL : GL_MAP_COLOR, GL_FALSE);
}

/* ---- accumulation ---- */

void feature_accum(struct generator *g)
{
    for (int n = integer(g, 1, 4); n > 0; n--) {
        switch (below(g, 7)) {
        case 0:
            EMIT(g, ClearAccum, real(g, -1.0, 1.0), real(g, -1.0, 1.0), real(g, -1.0, 1.0), real(g, -1.0, 1.0));
            EMIT(g, Clear, GL_ACCUM_BUFFER_BIT);
            break;
        case 1: EMIT(g, Accum, GL_LOAD, real(g, 0.0, 1.0)); break;
        case 2: EMIT(g, Accum, GL_ACCUM, real(g, 0.0, 0.5)); break;
        case 3: EMIT(g, Accum, GL_ADD, real(g, -0.5, 0.5)); break;
        case 4: EMIT(g, Accum, GL_MULT, real(g, -1.0, 1.0)); break;
        default: EMIT(g, Accum, GL_RETURN, real(g, 0.0, 2.0));
        }
    }
}
