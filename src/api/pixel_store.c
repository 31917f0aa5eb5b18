/* Pixel storage modes, and the bitmaps that they lay out (GL 1.5, 3.6.1 "Pixel Storage Modes", 3.5.2
 * "Stippling"). */
#include "api/pixel_store.h"

#include "api/command.h"
#include "api/convert.h"
#include "api/errors.h"
#include "api/list.h"
#include "api/pixel_buffer.h"
#include "state/share.h"

#include <string.h>

static bool *find_flag(struct client_state *c, GLenum pname)
{
    switch (pname) {
    case GL_PACK_SWAP_BYTES: return &c->pack.swap_bytes;
    case GL_PACK_LSB_FIRST: return &c->pack.lsb_first;
    case GL_UNPACK_SWAP_BYTES: return &c->unpack.swap_bytes;
    case GL_UNPACK_LSB_FIRST: return &c->unpack.lsb_first;
    default: return NULL;
    }
}

static int *find_number(struct client_state *c, GLenum pname)
{
    switch (pname) {
    case GL_PACK_ROW_LENGTH: return &c->pack.row_length;
    case GL_PACK_IMAGE_HEIGHT: return &c->pack.image_height;
    case GL_PACK_SKIP_ROWS: return &c->pack.skip_rows;
    case GL_PACK_SKIP_PIXELS: return &c->pack.skip_pixels;
    case GL_PACK_SKIP_IMAGES: return &c->pack.skip_images;
    case GL_PACK_ALIGNMENT: return &c->pack.alignment;
    case GL_UNPACK_ROW_LENGTH: return &c->unpack.row_length;
    case GL_UNPACK_IMAGE_HEIGHT: return &c->unpack.image_height;
    case GL_UNPACK_SKIP_ROWS: return &c->unpack.skip_rows;
    case GL_UNPACK_SKIP_PIXELS: return &c->unpack.skip_pixels;
    case GL_UNPACK_SKIP_IMAGES: return &c->unpack.skip_images;
    case GL_UNPACK_ALIGNMENT: return &c->unpack.alignment;
    default: return NULL;
    }
}

void fgl_exec_PixelStorei(struct context *ctx, GLenum pname, GLint param)
{
    bool *flag = find_flag(&ctx->client, pname);
    if (flag) {
        *flag = param != 0;
        return;
    }
    int *number = find_number(&ctx->client, pname);
    RETURN_ERROR_IF(ctx, !number, GL_INVALID_ENUM);
    const bool alignment = pname == GL_PACK_ALIGNMENT || pname == GL_UNPACK_ALIGNMENT;
    RETURN_ERROR_IF(ctx, param < 0, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, alignment && param != 1 && param != 2 && param != 4 && param != 8, GL_INVALID_VALUE);
    *number = param;
}

void GLAPIENTRY glPixelStoref(GLenum pname, GLfloat param)
{
    glPixelStorei(pname, fgl_int_round((double)param));
}

/* ---- polygon stipple ---- */

/* Where the bit of column x of a 32x32 bitmap's row y lies in the program's memory. */
struct bit_place {
    size_t byte;
    unsigned shift;
};

static struct bit_place place_bit(const struct pixel_store *s, int x, int y)
{
    const size_t length = s->row_length > 0 ? (size_t)s->row_length : 32;
    const size_t alignment = (size_t)s->alignment;
    const size_t row_bytes = ((length + 7) / 8 + alignment - 1) / alignment * alignment;
    const size_t column = (size_t)s->skip_pixels + (size_t)x;
    const unsigned bit = (unsigned)(column % 8);

    return (struct bit_place){
            .byte = ((size_t)s->skip_rows + (size_t)y) * row_bytes + column / 8,
            .shift = s->lsb_first ? bit : 7 - bit,
    };
}

void fgl_polygon_stipple_set(struct context *ctx, const uint32_t row[32])
{
    fgl_flush_vertices(ctx, DIRTY_RASTER);
    memcpy(ctx->s.polygon_stipple.row, row, sizeof ctx->s.polygon_stipple.row);
}

static void unpack_stipple(const struct pixel_store *store, const GLubyte *mask, uint32_t row[32])
{
    memset(row, 0, 32 * sizeof *row);
    for (int y = 0; y < 32; y++) {
        for (int x = 0; x < 32; x++) {
            const struct bit_place p = place_bit(store, x, y);
            row[y] |= (uint32_t)(mask[p.byte] >> p.shift & 1) << (31 - x);
        }
    }
}

static void stipple(struct context *ctx, const void *mask)
{
    uint32_t row[32];
    if (!fgl_buffer_image(ctx, &ctx->client.unpack, GL_COLOR_INDEX, GL_BITMAP, 32, 32, &mask))
        return;
    unpack_stipple(&ctx->client.unpack, mask, row);
    if (ctx->compiling) {
        void *node = fgl_list_record(ctx, OP_POLYGON_STIPPLE, sizeof row);
        if (node)
            memcpy(node, row, sizeof row);
        if (ctx->compiling == GL_COMPILE)
            return;
    }
    fgl_polygon_stipple_set(ctx, row);
}

void GLAPIENTRY glPolygonStipple(const GLubyte *mask)
{
    struct context *ctx = fgl_current;
    if (ctx && !fgl_refused_inside(ctx))
        FGL_SHARED(ctx, stipple(ctx, mask));
}

/* OSMesa rule: the unused bits of a byte that is written to become 0. */
void fgl_exec_GetPolygonStipple(struct context *ctx, GLubyte *pixels)
{
    const struct pixel_store *store = &ctx->client.pack;
    const void *to = pixels;
    if (!fgl_buffer_image(ctx, store, GL_COLOR_INDEX, GL_BITMAP, 32, 32, &to))
        return;
    GLubyte *mask = (GLubyte *)to;

    for (int y = 0; y < 32; y++) {
        const struct bit_place first = place_bit(store, 0, y), last = place_bit(store, 31, y);
        memset(mask + first.byte, 0, last.byte - first.byte + 1);
        for (int x = 0; x < 32; x++) {
            const struct bit_place p = place_bit(store, x, y);
            mask[p.byte] |= (GLubyte)((ctx->s.polygon_stipple.row[y] >> (31 - x) & 1) << p.shift);
        }
    }
}
