/* Reading the raw colours and depth that a headless program wrote. */
#define _POSIX_C_SOURCE 200809L
#include "image.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST_SIDE = 16384 };

size_t fgl_image_pixels(const struct image *image)
{
    return (size_t)image->width * (size_t)image->height;
}

uint32_t fgl_image_far(const struct image *image)
{
    return UINT32_MAX >> (32 - image->depth_bits);
}

static bool valid_size(int width, int height)
{
    return width > 0 && height > 0 && width <= LARGEST_SIDE && height <= LARGEST_SIDE;
}

/* Reads header lines up to ENDHDR. True if they describe an RGBA picture of bytes. */
static bool read_pam_header(FILE *file, struct image *image)
{
    char line[256];
    int channels = 0, largest = 0;
    if (fgets(line, sizeof line, file) == NULL || strcmp(line, "P7\n") != 0)
        return false;
    while (fgets(line, sizeof line, file) != NULL) {
        if (strcmp(line, "ENDHDR\n") == 0)
            return channels == 4 && largest == 255 && valid_size(image->width, image->height);
        sscanf(line, "WIDTH %d", &image->width);
        sscanf(line, "HEIGHT %d", &image->height);
        sscanf(line, "DEPTH %d", &channels);
        sscanf(line, "MAXVAL %d", &largest);
        sscanf(line, "# GL_RENDERER: %127[^\n]", image->renderer);
    }
    return false;
}

/* Reads exactly `size` bytes, after which the file must end. */
static bool read_rest(FILE *file, void *bytes, size_t size)
{
    return fread(bytes, 1, size, file) == size && fgetc(file) == EOF;
}

bool fgl_image_read_pam(const char *path, struct image *image, struct problem *problem)
{
    *image = (struct image){0};
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    bool good = read_pam_header(file, image);
    if (good) {
        image->rgba = fgl_allocate(fgl_image_pixels(image), 4);
        good = read_rest(file, image->rgba, fgl_image_pixels(image) * 4);
    }
    fclose(file);
    if (good)
        return true;
    fgl_image_free(image);
    return fgl_problem_set(problem, "%s is not a whole PAM picture of RGBA bytes", path);
}

static void decode_depth(uint32_t *depth, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint8_t bytes[4];
        memcpy(bytes, &depth[i], sizeof bytes);
        depth[i] = bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    }
}

bool fgl_image_read_depth(const char *path, struct image *image, struct problem *problem)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    char line[64];
    int width = 0, height = 0, bits = 0;
    bool good = fgets(line, sizeof line, file) != NULL &&
                sscanf(line, "FGLDEPTH %d %d %d", &width, &height, &bits) == 3 && width == image->width &&
                height == image->height && bits >= 1 && bits <= 32;
    if (good) {
        const size_t count = fgl_image_pixels(image);
        image->depth_bits = bits;
        image->depth = fgl_allocate(count, sizeof *image->depth);
        good = read_rest(file, image->depth, count * sizeof *image->depth);
        decode_depth(image->depth, count);
    }
    fclose(file);
    return good || fgl_problem_set(problem, "%s is not a whole depth buffer of %dx%d", path, image->width,
                                   image->height);
}

void fgl_image_free(struct image *image)
{
    free(image->rgba);
    free(image->depth);
    *image = (struct image){0};
}
