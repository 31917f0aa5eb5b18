/* What the features of textures share. */
#ifndef FUZZ_TEXTURES_H
#define FUZZ_TEXTURES_H

#include "pixel_data.h"

/* Targets are numbered: 1D, 2D, 3D, cube map. */
enum { TEXTURE_TARGETS = 4 };
extern const double texture_targets[TEXTURE_TARGETS];
int random_target(struct generator *g); /* the second is by far the commonest */
int dimensions_of(int target);

struct image {
    int target, border, size[3]; /* size: without the border */
    double internal, format;
    const struct pixel_type *type;
};

int random_size(struct generator *g, int largest); /* up to 2^(largest - 1), mostly a power of two */
void random_image_size(struct generator *g, struct image *image);
/* Whether images may begin beside the pointer or have borders: with pixel transfer OSMesa does not skip (departure skipped-texels). */
bool may_skip(const struct generator *g);
/* All faces of the image, alone or with its mipmaps, of random pixels. */
void emit_images(struct generator *g, const struct image *image, bool mipmaps);
/* Filters, those of mipmaps or not, wrap modes, border color, limits of the level of detail. */
void emit_filters(struct generator *g, int target, bool mipmaps);
/* All levels from 0 on count again, where that was changed: OSMesa loses those that a new first level leaves (departure lost-levels). */
void reset_levels(struct generator *g, double target);
void emit_coordinates(struct generator *g);
double random_internal_of_copies(struct generator *g);

#endif
