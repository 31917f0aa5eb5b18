/* The PNG files of the report. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare.h"
#include "pngfile.h"
#include "report.h"

enum { MAP_SIDE = 250 }; /* largest side of the small map, pixels */

/* How a pixel differs, worst last. Their colours are also those of the report's legend. */
enum kind { KIND_SAME, KIND_DEPTH, KIND_BY_1, KIND_BY_2_TO_8, KIND_BY_MORE, KIND_COVERAGE };

static const uint8_t kind_color[][3] = {
        {0, 0, 0}, {66, 133, 244}, {0, 200, 120}, {255, 196, 0}, {255, 64, 48}, {255, 80, 255},
};

static enum kind classify(struct pixel_difference pixel)
{
    if (pixel.coverage)
        return KIND_COVERAGE;
    if (pixel.channel > 8)
        return KIND_BY_MORE;
    if (pixel.channel > 1)
        return KIND_BY_2_TO_8;
    if (pixel.channel == 1)
        return KIND_BY_1;
    return pixel.depth > 0 ? KIND_DEPTH : KIND_SAME;
}

/* The worst kind in the square of `side` pixels whose top left one is (x, y). */
static enum kind worst_of(const struct image *a, const struct image *b, int x, int y, int side)
{
    enum kind worst = KIND_SAME;
    for (int row = y; row < y + side && row < a->height; row++) {
        for (int column = x; column < x + side && column < a->width; column++) {
            const size_t index = (size_t)row * (size_t)a->width + (size_t)column;
            const enum kind kind = classify(fgl_compare_pixel(a, b, index));
            worst = kind > worst ? kind : worst;
        }
    }
    return worst;
}

static bool write_map(const char *path, const struct image *a, const struct image *b, int side,
                      struct problem *problem)
{
    const int width = (a->width + side - 1) / side, height = (a->height + side - 1) / side;
    uint8_t *rgb = fgl_allocate((size_t)width * (size_t)height, 3), *out = rgb;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++, out += 3) {
            const enum kind kind = worst_of(a, b, x * side, y * side, side);
            const uint8_t *under = &b->rgba[4 * ((size_t)(y * side) * (size_t)b->width + (size_t)(x * side))];
            const uint8_t dim = (uint8_t)((under[0] + 2 * under[1] + under[2]) / 20);
            for (int i = 0; i < 3; i++)
                out[i] = kind == KIND_SAME ? dim : kind_color[kind][i];
        }
    }
    const bool good = fgl_pngfile_write(path, width, height, 3, rgb, NULL, problem);
    free(rgb);
    return good;
}

static bool write_opaque(const char *path, const struct image *image, struct problem *problem)
{
    const size_t count = fgl_image_pixels(image);
    uint8_t *rgb = fgl_allocate(count, 3);
    for (size_t i = 0; i < count; i++)
        memcpy(&rgb[3 * i], &image->rgba[4 * i], 3);
    const bool good = fgl_pngfile_write(path, image->width, image->height, 3, rgb, NULL, problem);
    free(rgb);
    return good;
}

bool fgl_report_write_images(const char *folder, const struct picture *picture, const struct image *ours,
                             const struct image *reference, struct problem *problem)
{
    static const char *const kinds[] = {"fixedgl", "reference", "difference", "map"};
    char *path[4];
    for (int i = 0; i < 4; i++) {
        path[i] = fgl_format("%s/%s.%s.png", folder, picture->name, kinds[i]);
        remove(path[i]);
    }
    bool good = (ours == NULL || write_opaque(path[0], ours, problem)) &&
                (reference == NULL || write_opaque(path[1], reference, problem));
    struct difference difference;
    struct problem incomparable;
    if (good && ours != NULL && reference != NULL &&
        fgl_compare_images(ours, reference, &difference, &incomparable) && difference.differ > 0) {
        const int longest = ours->width > ours->height ? ours->width : ours->height;
        good = write_map(path[2], ours, reference, 1, problem) &&
               write_map(path[3], ours, reference, (longest + MAP_SIDE - 1) / MAP_SIDE, problem);
    }
    for (int i = 0; i < 4; i++)
        free(path[i]);
    return good;
}
