#include "framebuffer/framebuffer.h"

#include <stdlib.h>
#include <string.h>

static size_t color_bytes(enum color_kind kind)
{
    switch (kind) {
    case COLOR_UNORM16: return 8;
    case COLOR_FLOAT: return 16;
    case COLOR_565: return 2;
    case COLOR_INDEX8: return 1;
    default: return 4;
    }
}

/* `bytes` for each pixel of the padded rows, zero; a multiple of 64 bytes on a 64-byte boundary. */
static void *plane_alloc(int stride, int height, size_t bytes)
{
    const size_t size = (size_t)stride * (size_t)height * bytes; /* at most 16384^2 * 16 = 2^32: fits a 64-bit size_t */
    void *plane = aligned_alloc(64, size);
    if (plane)
        memset(plane, 0, size);
    return plane;
}

bool fgl_framebuffer_resize(struct framebuffer *fb, int width, int height, enum color_kind kind)
{
    if (fb->color && fb->width == width && fb->height == height && fb->color_kind == kind)
        return true;
    struct framebuffer n = *fb;
    n.width = width;
    n.height = height;
    n.stride = (width + FB_ALIGN - 1) / FB_ALIGN * FB_ALIGN;
    n.color_kind = kind;
    n.color = plane_alloc(n.stride, height, color_bytes(kind));
    n.depth = fb->depth_bits ? plane_alloc(n.stride, height, sizeof *n.depth) : NULL;
    n.stencil = NULL;
    n.accum = NULL;
    n.accum_waits = false;
    if (!n.color || (fb->depth_bits && !n.depth)) {
        free(n.color);
        free(n.depth);
        return false;
    }
    fgl_framebuffer_free(fb);
    *fb = n;
    return true;
}

bool fgl_framebuffer_need_stencil(struct framebuffer *fb)
{
    if (!fb->stencil && fb->stencil_bits)
        fb->stencil = plane_alloc(fb->stride, fb->height, 1);
    return fb->stencil || !fb->stencil_bits;
}

bool fgl_framebuffer_need_accum(struct framebuffer *fb)
{
    if (!fb->accum && fb->accum_bits)
        fb->accum = plane_alloc(fb->stride, fb->height, 4 * sizeof *fb->accum);
    return fb->accum || !fb->accum_bits;
}

void fgl_framebuffer_free(struct framebuffer *fb)
{
    free(fb->color);
    free(fb->depth);
    free(fb->stencil);
    free(fb->accum);
    fb->color = NULL;
    fb->depth = NULL;
    fb->stencil = NULL;
    fb->accum = NULL;
}
