/* Comparing two pictures. */
#include "compare.h"

#include <stdlib.h>

struct pixel_difference fgl_compare_pixel(const struct image *a, const struct image *b, size_t index)
{
    struct pixel_difference pixel = {0};
    for (size_t i = 4 * index; i < 4 * index + 4; i++) {
        const int channel = abs(a->rgba[i] - b->rgba[i]);
        if (channel > pixel.channel)
            pixel.channel = channel;
    }
    if (a->depth != NULL && a->depth[index] != b->depth[index]) {
        const uint32_t far = fgl_image_far(a), da = a->depth[index], db = b->depth[index];
        pixel.depth = da > db ? da - db : db - da;
        pixel.coverage = da == far || db == far;
    }
    return pixel;
}

static void count_pixel(struct difference *difference, struct pixel_difference pixel)
{
    difference->differ += pixel.channel > 0 || pixel.depth > 0;
    difference->by_1 += pixel.channel == 1;
    difference->by_2_to_8 += pixel.channel >= 2 && pixel.channel <= 8;
    difference->by_more += pixel.channel > 8;
    difference->coverage += pixel.coverage;
    difference->depth += pixel.depth > 0;
    if (pixel.channel > difference->largest_channel)
        difference->largest_channel = pixel.channel;
    if (pixel.depth > difference->largest_depth)
        difference->largest_depth = pixel.depth;
}

bool fgl_compare_images(const struct image *a, const struct image *b, struct difference *difference,
                        struct problem *problem)
{
    *difference = (struct difference){.first_x = -1, .first_y = -1};
    if (a->width != b->width || a->height != b->height)
        return fgl_problem_set(problem, "FixedGL drew %dx%d, the reference %dx%d", a->width, a->height,
                               b->width, b->height);
    if (a->depth_bits != b->depth_bits)
        return fgl_problem_set(problem, "FixedGL has %d bits of depth, the reference %d", a->depth_bits,
                               b->depth_bits);
    difference->pixels = (long)fgl_image_pixels(a);
    for (long i = 0; i < difference->pixels; i++) {
        count_pixel(difference, fgl_compare_pixel(a, b, (size_t)i));
        if (difference->differ > 0 && difference->first_x < 0) {
            difference->first_x = (int)(i % a->width);
            difference->first_y = (int)(i / a->width);
        }
    }
    return true;
}
