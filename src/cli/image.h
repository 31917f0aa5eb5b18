/* A drawn picture in memory, and the two raw files that a program drawing headless writes. */
#ifndef FGL_CLI_IMAGE_H
#define FGL_CLI_IMAGE_H

#include <stdint.h>

#include "support.h"

struct image {
    int width, height;
    uint8_t *rgba;   /* width * height * 4 bytes, top row first */
    uint32_t *depth; /* width * height values in 0..2^depth_bits - 1, top row first; NULL without depth buffer
                      */
    int depth_bits;  /* 0 without depth buffer */
    char renderer[128]; /* GL_RENDERER of the library that drew it, "" if the file does not say */
};

/* The number of pixels. */
size_t fgl_image_pixels(const struct image *image);

/* The depth of a pixel on which nothing was drawn (glClearDepth(1), the default): 2^depth_bits - 1. */
uint32_t fgl_image_far(const struct image *image);

/* Reads colours from a PAM file (P7, DEPTH 4, MAXVAL 255). A header comment `# GL_RENDERER: text` names the
 * library that drew it. */
bool fgl_image_read_pam(const char *path, struct image *image, struct problem *problem);

/* Adds the depth of `path`: a line `FGLDEPTH width height bits`, then little-endian 32-bit values. Its size
 * must be that of the colours. */
bool fgl_image_read_depth(const char *path, struct image *image, struct problem *problem);

void fgl_image_free(struct image *image);

#endif
