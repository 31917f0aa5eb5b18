/* Pictures to files: PNG for people, PAM and the depth format for comparing values. */
#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "internal.h"

/* Copies a child's rows over its ancestor's picture of width x height; (x, y) is the child's top left corner.
 */
static void copy_over(unsigned char *picture, int width, int height, const struct window *child, int x, int y)
{
    int first = x < 0 ? -x : 0, end = x + child->width > width ? width - x : child->width;
    for (int row = 0; row < child->height && end > first; row++) {
        int top_row = y + child->height - 1 - row; /* buffers have the lowest row first */
        if (top_row < 0 || top_row >= height)
            continue;
        memcpy(picture + 4 * ((size_t)(height - 1 - top_row) * (size_t)width + (size_t)(x + first)),
               child->pixels + 4 * ((size_t)row * (size_t)child->width + (size_t)first),
               4 * (size_t)(end - first));
    }
}

static void compose_children(unsigned char *picture, struct window *top, struct window *parent, int x, int y)
{
    for (struct window *child = fgl_glut.windows; child; child = child->next) {
        if (child->parent != parent || !child->shown || child->destroyed)
            continue;
        fgl_window_finish(child);
        copy_over(picture, top->width, top->height, child, x + child->x, y + child->y);
        compose_children(picture, top, child, x + child->x, y + child->y);
    }
}

unsigned char *fgl_picture_compose(struct window *w)
{
    bool children = false;
    for (struct window *child = fgl_glut.windows; child; child = child->next)
        children = children || (child->parent == w && !child->destroyed);
    fgl_window_finish(w);
    if (!children)
        return w->pixels;
    size_t size = 4 * (size_t)w->width * (size_t)w->height;
    unsigned char *picture = malloc(size);
    if (!picture)
        fgl_glut_fail(1, "no memory for a picture of %d x %d", w->width, w->height);
    memcpy(picture, w->pixels, size);
    compose_children(picture, w, w, 0, 0);
    return picture;
}

/* Opaque RGB, top row first. libpng's simplified interface writes from the last row with a negative stride.
 */
static bool write_png(FILE *out, const unsigned char *rgba, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    unsigned char *rgb = malloc(3 * pixels);
    if (!rgb)
        return false;
    for (size_t i = 0; i < pixels; i++)
        memcpy(rgb + 3 * i, rgba + 4 * i, 3);
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)width,
                       .height = (png_uint_32)height,
                       .format = PNG_FORMAT_RGB,
                       .flags = PNG_IMAGE_FLAG_FAST};
    bool written = png_image_write_to_stdio(&image, out, 0, rgb, -3 * width, NULL) != 0;
    free(rgb);
    return written;
}

static bool write_pam(FILE *out, const unsigned char *rgba, int width, int height)
{
    size_t row = 4 * (size_t)width;
    const GLubyte *renderer = glGetString(GL_RENDERER); /* so that a picture says who drew it */
    fprintf(out, "P7\n# GL_RENDERER: %s\n", renderer ? (const char *)renderer : "none");
    fprintf(out, "WIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", width, height);
    for (int y = height - 1; y >= 0; y--)
        if (fwrite(rgba + (size_t)y * row, 1, row, out) != row)
            return false;
    return true;
}

static bool ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), tail = strlen(end);
    return length >= tail && strcmp(text + length - tail, end) == 0;
}

/* Closes the file and says what went wrong, if anything did. */
static bool finish_file(FILE *out, bool written, const char *file)
{
    if (out && fclose(out) != 0)
        written = false;
    if (!written)
        fgl_glut_warn("cannot write %s: %s", file, errno ? strerror(errno) : "no memory");
    return written;
}

bool fgl_picture_write(struct window *w, const char *file)
{
    errno = 0;
    FILE *out = fopen(file, "wb");
    if (!out)
        return finish_file(NULL, false, file);
    unsigned char *rgba = fgl_picture_compose(w);
    bool written = (ends_with(file, ".png") ? write_png : write_pam)(out, rgba, w->width, w->height);
    if (rgba != w->pixels)
        free(rgba);
    return finish_file(out, written, file);
}

/* One depth value of the OSMesa depth buffer, without the stencil bits beside it. */
static uint32_t depth_value(const unsigned char *bytes, int size, int bits)
{
    uint32_t value = 0;
    if (size == 2) {
        uint16_t half;
        memcpy(&half, bytes, sizeof half);
        value = half;
    } else {
        memcpy(&value, bytes, sizeof value);
    }
    return bits < 32 ? value & ((UINT32_C(1) << bits) - 1) : value;
}

/* Header line "FGLDEPTH width height bits", then little-endian uint32 values, top row first. */
bool fgl_picture_write_depth(struct window *w, const char *file)
{
    void *buffer;
    GLint width, height, size, bits = 0;
    errno = 0;
    fgl_window_make_current(w);
    glFinish();
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    if (!OSMesaGetDepthBuffer(w->context, &width, &height, &size, &buffer)) {
        fgl_glut_warn("cannot write %s: the context has no depth buffer", file);
        return false;
    }
    FILE *out = fopen(file, "wb");
    if (!out)
        return finish_file(NULL, false, file);
    fprintf(out, "FGLDEPTH %d %d %d\n", width, height, bits);
    for (int y = height - 1; y >= 0; y--)
        for (int x = 0; x < width; x++) {
            const unsigned char *bytes =
                    (const unsigned char *)buffer + ((size_t)y * (size_t)width + (size_t)x) * (size_t)size;
            uint32_t value = depth_value(bytes, size, bits);
            for (int shift = 0; shift < 32; shift += 8)
                putc((int)(value >> shift & 255), out);
        }
    return finish_file(out, !ferror(out), file);
}
