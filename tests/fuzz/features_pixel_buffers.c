/* Features: pixel rectangles, images and stipples taken from buffer objects, and reads into them (GL_ARB_pixel_buffer_object). */
#include "generator.h"
#include "textures.h"

enum { UNPACK_BUFFER = 20, PACK_BUFFER = 21, SIZE = 4096, LARGEST_OFFSET = 64 };

static void bind_unpack(struct generator *g)
{
    EMIT(g, BindBuffer, GL_PIXEL_UNPACK_BUFFER, UNPACK_BUFFER);
    EMIT(g, BufferData, GL_PIXEL_UNPACK_BUFFER, ONE_OF(g, GL_STREAM_DRAW, GL_STATIC_DRAW, GL_DYNAMIC_COPY), GL_UNSIGNED_BYTE);
    add_random_bytes(g, SIZE);
}

/* A multiple of the type's size. */
static int offset_for(struct generator *g, const struct pixel_type *type)
{
    return type->bytes * below(g, LARGEST_OFFSET / type->bytes);
}

static double random_format(struct generator *g)
{
    return ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_LUMINANCE, GL_ALPHA, GL_LUMINANCE_ALPHA);
}

/* Not of floats, which the random bytes are not. */
static const struct pixel_type *integer_type(struct generator *g, double format)
{
    const struct pixel_type *type;
    do
        type = random_pixel_type(g, format);
    while (type->type == GL_FLOAT);
    return type;
}

static void emit_image(struct generator *g)
{
    const double format = random_format(g);
    const struct pixel_type *type = integer_type(g, format);
    if (!use(g, FEATURE_texture))
        return;
    reset_levels(g, GL_TEXTURE_2D);
    EMIT(g, TexImage2DOffset, GL_TEXTURE_2D, 0, ONE_OF(g, GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA), 8, 8, 0, format, type->type, offset_for(g, type));
    if (chance(g, 40))
        EMIT(g, TexSubImage2DOffset, GL_TEXTURE_2D, 0, below(g, 4), below(g, 4), integer(g, 1, 4), integer(g, 1, 4), format, type->type,
             offset_for(g, type));
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    toggle(g, GL_TEXTURE_2D, 90);
}

static void emit_rectangle(struct generator *g)
{
    const double format = random_format(g);
    const struct pixel_type *type = integer_type(g, format);
    if (!use(g, FEATURE_draw_pixels) || textured_later(g))
        return;
    if (chance(g, 50) && use(g, FEATURE_raster_pos))
        feature_raster_pos(g);
    if (g->arrays_set)
        EMIT(g, TexCoord4f, real(g, -1.0, 2.0), real(g, -1.0, 2.0), real(g, -1.0, 2.0), 1.0);
    EMIT(g, DrawPixelsOffset, integer(g, 1, 12), integer(g, 1, 12), format, type->type, offset_for(g, type));
}

static void emit_bitmap(struct generator *g)
{
    if (!use(g, FEATURE_bitmap))
        return;
    emit_no_color_sum(g);
    EMIT(g, BitmapOffset, integer(g, 1, 24), integer(g, 1, 16), 0.0, 0.0, real(g, 0.0, 20.0), 0.0, below(g, LARGEST_OFFSET));
    EMIT0(g, Flush);
}

void feature_pixel_unpack_buffer(struct generator *g)
{
    if (g->compiling)
        return;
    plain_unpack_store(g);
    bind_unpack(g);
    switch (below(g, 4)) {
    case 0: emit_bitmap(g); break;
    case 1: emit_image(g); break;
    case 2: EMIT(g, PolygonStippleOffset, below(g, LARGEST_OFFSET)); break;
    default: emit_rectangle(g);
    }
    EMIT(g, BindBuffer, GL_PIXEL_UNPACK_BUFFER, 0);
}

/* A read into a buffer; then its bytes are asked for or drawn. */
void feature_pixel_pack_buffer(struct generator *g)
{
    const int width = integer(g, 1, 12), height = integer(g, 1, 12), x = below(g, g->script->width - width),
              y = below(g, g->script->height - height);
    const double format = ONE_OF(g, GL_RGBA, GL_BGRA, GL_RGB, GL_DEPTH_COMPONENT, GL_ALPHA);
    if (g->compiling || (format == GL_DEPTH_COMPONENT && g->script->buffers.depth_bits == 0))
        return;
    const double type = format == GL_DEPTH_COMPONENT ? GL_UNSIGNED_SHORT : ONE_OF(g, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_FLOAT);
    EMIT(g, BindBuffer, GL_PIXEL_PACK_BUFFER, PACK_BUFFER);
    EMIT(g, BufferData, GL_PIXEL_PACK_BUFFER, ONE_OF(g, GL_STREAM_READ, GL_STREAM_COPY, GL_STATIC_READ), GL_UNSIGNED_BYTE);
    for (int i = 0; i < SIZE; i++) {
        const double zero = 0.0;
        script_extend(g->script, 1, &zero);
    }
    EMIT(g, ReadPixelsOffset, x, y, width, height, format, type, 4 * below(g, 8));
    if (chance(g, 50))
        EMIT(g, GetBufferSubData, GL_PIXEL_PACK_BUFFER, 0, SIZE);
    else
        EMIT(g, ReadMapped, GL_PIXEL_PACK_BUFFER, GL_READ_ONLY, SIZE);
    EMIT(g, BindBuffer, GL_PIXEL_PACK_BUFFER, 0);
}
