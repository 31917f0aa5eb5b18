/* Comparing two pictures of one scene, byte by byte. */
#ifndef FGL_CLI_COMPARE_H
#define FGL_CLI_COMPARE_H

#include "image.h"
#include "support.h"

/* How one pixel differs. All zero: it does not. */
struct pixel_difference {
    int channel;    /* largest difference of its four bytes, 0..255 */
    uint32_t depth; /* difference of the depth values */
    bool coverage;  /* one picture drew on it, the other did not (its depth is still the far value) */
};

/* How two pictures differ, in numbers of pixels. */
struct difference {
    long pixels;                   /* in the picture */
    long differ;                   /* in colour or in depth: the figure that departures account for */
    long by_1, by_2_to_8, by_more; /* in colour, by the largest of the four byte differences */
    long coverage;                 /* drawn on in one picture only */
    long depth;                    /* in depth */
    int largest_channel;
    uint32_t largest_depth;
    int first_x, first_y; /* the first that differs, rows from the top; -1 if none */
};

/* How pixel `index` differs, in pictures of the same size and depth bits. */
struct pixel_difference fgl_compare_pixel(const struct image *a, const struct image *b, size_t index);

/* Compares every byte of colour and every depth value. False if the pictures cannot be compared: their sizes
 * or depth bits differ. */
bool fgl_compare_images(const struct image *a, const struct image *b, struct difference *difference,
                        struct problem *problem);

#endif
