/* Random pixels in memory, for images and pixel rectangles. */
#ifndef FUZZ_PIXEL_DATA_H
#define FUZZ_PIXEL_DATA_H

#include "generator.h"

struct pixel_type {
    double type;
    int bytes, components; /* components: of a packed pixel; 0: as many as the format has */
};

int components_of(double format);
/* One that the format may have. */
const struct pixel_type *random_pixel_type(struct generator *g, double format);
/* Random elements for the last command; floats that are colors, or indexes. */
void add_random_elements(struct generator *g, const struct pixel_type *type, int count, bool indexes);
void add_random_bytes(struct generator *g, int count);
/* How rows lie in memory, set for the next image; the number of elements of `bytes` that its rows then take. */
int random_unpack_store(struct generator *g, int width, int height, int bytes, int per_pixel);
/* Rows that begin at the pointer and follow each other at multiples of 4 bytes. */
void plain_unpack_store(struct generator *g);

#endif
