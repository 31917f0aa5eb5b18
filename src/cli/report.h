/* The report for a browser: index.html beside its pictures, all by relative paths, so that it opens from a
 * file. */
#ifndef FGL_CLI_REPORT_H
#define FGL_CLI_REPORT_H

#include "image.h"
#include "pictures.h"
#include "result.h"
#include "support.h"

/* Writes NAME.fixedgl.png and NAME.reference.png (opaque, as a window shows them), and if the pictures can be
 * compared NAME.difference.png (each pixel in the colour of its kind of difference, over a dim picture) and
 * NAME.map.png (the same, small: each pixel the worst of its square). NULL for a picture that is missing.
 * Files of an earlier run are removed. Thread-safe for different pictures. */
bool fgl_report_write_images(const char *folder, const struct picture *picture, const struct image *ours,
                             const struct image *reference, struct problem *problem);

/* Writes index.html, worst picture first. */
bool fgl_report_write(const char *folder, const char *reference_name, const struct result *results, int count,
                      struct problem *problem);

#endif
