/* PNG files through libpng: bytes in, the same bytes out. */
#ifndef FGL_CLI_PNGFILE_H
#define FGL_CLI_PNGFILE_H

#include <stdint.h>

#include "support.h"

/* A text chunk; lists of facts end with a NULL key. */
struct png_fact {
    const char *key; /* at most 79 characters */
    const char *value;
};

/* Writes width * height pixels of 3 (RGB) or 4 (RGBA) bytes, top row first. `facts` may be NULL. The same
 * bytes and facts give the same file. */
bool fgl_pngfile_write(const char *path, int width, int height, int channels, const uint8_t *bytes,
                       const struct png_fact *facts, struct problem *problem);

/* Reads a PNG as pixels of `channels` bytes, top row first; the caller frees them. NULL if it cannot be read
 * or has not exactly these channels, 8 bits each. */
uint8_t *fgl_pngfile_read(const char *path, int channels, int *width, int *height, struct problem *problem);

#endif
