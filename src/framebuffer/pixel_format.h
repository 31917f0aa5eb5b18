/* Formats and types of pixels in the caller's memory, and where they lie there (GL 1.5, 3.6.4 "Rasterization
 * of Pixel Rectangles", 4.3.2 "Reading Pixels"). Layer 2. Packing (pixel_pack.h) and unpacking
 * (pixel_unpack.h) both read these descriptions. */
#ifndef FGL_FRAMEBUFFER_PIXEL_FORMAT_H
#define FGL_FRAMEBUFFER_PIXEL_FORMAT_H

#include "base/fgl.h"
#include "state/context.h"

enum { PIXEL_MAX_COMPONENTS = 4 };

/* What a component of a format stands for. */
enum channel {
    CHANNEL_RED,
    CHANNEL_GREEN,
    CHANNEL_BLUE,
    CHANNEL_ALPHA,     /* indexes of an RGBA vector */
    CHANNEL_LUMINANCE, /* packed: R + G + B; unpacked: all three */
    CHANNEL_DEPTH,
    CHANNEL_STENCIL,
    CHANNEL_INDEX
};

/* Table 3.6. */
struct pixel_format {
    GLenum format;
    int components;
    enum channel channel[PIXEL_MAX_COMPONENTS]; /* in memory order */
};

enum component_kind {
    COMPONENT_UNSIGNED,
    COMPONENT_SIGNED,
    COMPONENT_FLOAT,
    COMPONENT_BITMAP,
    COMPONENT_PACKED
};

/* Tables 3.5 and 3.8: an element of memory. It holds one component, or the fields of a whole pixel when
 * packed. */
struct pixel_type {
    GLenum type;
    enum component_kind kind;
    int bytes;  /* of an element; 0 for GL_BITMAP */
    int fields; /* packed: components in an element, else 0 */
    uint8_t bits[PIXEL_MAX_COMPONENTS],
            shift[PIXEL_MAX_COMPONENTS]; /* packed: of each component in the order of the format */
};

/* NULL for an enum that is none. */
const struct pixel_format *fgl_pixel_format(GLenum format);
const struct pixel_type *fgl_pixel_type(GLenum type);

/* The error that the combination raises, GL_NO_ERROR if none (3.6.4):
 *   GL_INVALID_ENUM       neither table has it; GL_BITMAP with other formats than indexes; GL_DEPTH_STENCIL with
 *                         other types than GL_UNSIGNED_INT_24_8
 *   GL_INVALID_OPERATION  a packed type whose fields are not the format's components */
GLenum fgl_pixel_check(GLenum format, GLenum type);

/* An image in the caller's memory under a pixel store state. */
struct pixel_image {
    const struct pixel_format *format;
    const struct pixel_type *type;
    uintptr_t first;  /* address of the first pixel of row 0, after the skips (bitmap: of the byte that holds
                         it) */
    size_t row_bytes; /* from a row to the next, with alignment */
    size_t pixel_bytes;
    int first_bit; /* bitmap: the first pixel's place in its byte, 0..7 */
    bool swap_bytes, lsb_first;
};

/* `width` is the image's, in pixels; format and type are checked. */
struct pixel_image fgl_pixel_image(const struct pixel_store *store, GLenum format, GLenum type, int width,
                                   const void *pixels);

/* Bytes from `pixels` to the end of the last of `height` rows, 0 for an empty image. */
size_t fgl_pixel_image_bytes(const struct pixel_store *store, GLenum format, GLenum type, int width,
                             int height);

/* One slice of a three-dimensional image, `height` rows high (GL 1.5, 3.8.1: GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT). */
static inline struct pixel_image fgl_pixel_slice(struct pixel_image image, const struct pixel_store *store, int height,
                                                 int slice)
{
    const size_t rows = (size_t)(store->image_height > 0 ? store->image_height : height);
    image.first += ((size_t)store->skip_images + (size_t)slice) * rows * image.row_bytes;
    return image;
}

/* Address of pixel 0 of a row. */
static inline uint8_t *fgl_pixel_row(const struct pixel_image *image, int row)
{
    return (uint8_t *)(image->first + (size_t)row * image->row_bytes);
}

/* Swaps the bytes of n elements of 2 or 4 bytes each, which need no alignment (GL_PACK_SWAP_BYTES,
 * GL_UNPACK_SWAP_BYTES). */
void fgl_swap_bytes(void *elements, size_t n, int bytes);

#endif
