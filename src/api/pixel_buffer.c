/* Pixels in buffer objects. See pixel_buffer.h. */
#include "api/pixel_buffer.h"

#include "api/buffer.h"
#include "api/errors.h"

/* end: bytes from the offset to the end of the last pixel; as a double it cannot overflow. */
static bool find(struct context *ctx, const struct buffer_object *b, double end, int element, const void **pixels)
{
    const uintptr_t offset = (uintptr_t)*pixels;
    const bool fits = end <= (double)b->size && offset <= b->size - (size_t)end;
    RETURN_VALUE_ERROR_IF(ctx, b->mapped || !fits || (element > 1 && offset % (uintptr_t)element), GL_INVALID_OPERATION, false);
    *pixels = b->data ? b->data + offset : NULL;
    return true;
}

bool fgl_buffer_volume(struct context *ctx, const struct pixel_store *store, GLenum format, GLenum type, int width, int height, int depth,
                       const void **pixels)
{
    if (!store->buffer)
        return true;
    const struct pixel_image image = fgl_pixel_image(store, format, type, width, NULL);
    const double row = (double)image.row_bytes, rows = store->image_height > 0 ? store->image_height : height;
    const bool empty = width <= 0 || height <= 0 || depth <= 0, sliced = depth > 1 || store->skip_images > 0;
    const double before = (store->skip_rows + (double)height - 1) * row + (sliced ? (store->skip_images + (double)depth - 1) * rows * row : 0);
    const double pixel_bits = image.type->kind == COMPONENT_BITMAP ? 1 : 8 * (double)image.pixel_bytes;
    const double last_row = ((store->skip_pixels + (double)width) * pixel_bits + 7) / 8;
    return find(ctx, store->buffer, empty ? 0 : before + (double)(uint64_t)last_row, image.type->bytes, pixels);
}

bool fgl_buffer_image(struct context *ctx, const struct pixel_store *store, GLenum format, GLenum type, int width, int height,
                      const void **pixels)
{
    struct pixel_store flat = *store; /* slices are skipped in volumes alone */
    flat.skip_images = 0;
    return fgl_buffer_volume(ctx, &flat, format, type, width, height, 1, pixels);
}

bool fgl_buffer_elements(struct context *ctx, const struct pixel_store *store, int n, int bytes, const void **pixels)
{
    return !store->buffer || find(ctx, store->buffer, (double)n * bytes, bytes, pixels);
}
