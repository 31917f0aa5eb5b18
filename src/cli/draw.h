/* Drawing one picture of the list: its program as a child process, headless, on one of the two renderers. */
#ifndef FGL_CLI_DRAW_H
#define FGL_CLI_DRAW_H

#include "image.h"
#include "pictures.h"
#include "support.h"

struct renderer {
    const char *who;     /* "FixedGL" or "reference", for messages */
    const char *file;    /* "fixedgl" or "reference", the suffix of its files */
    const char *preload; /* the library whose gl* and OSMesa* take the place of FixedGL's; NULL for FixedGL */
    const char *programs; /* folder of the example programs */
    const char *scratch;  /* folder for the raw files and the program's output */
    double timeout;       /* seconds */
};

/* Runs the picture's program and reads what it drew. False if it crashes, hangs, fails or writes no picture:
 * `problem` names the renderer and quotes the last line of the program's own output, if any. */
bool fgl_draw_picture(const struct renderer *renderer, const struct picture *picture, struct image *image,
                      struct problem *problem);

#endif
