/* Writing and reading goldens. */
#define _POSIX_C_SOURCE 200809L
#include "goldens.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "pngfile.h"

static bool use_line(char *line, void *context, struct problem *problem)
{
    struct goldens *goldens = context;
    char recorded[1024];
    (void)problem;
    fgl_take_value(line, "GL_RENDERER", goldens->renderer, sizeof goldens->renderer);
    fgl_take_value(line, "GL_VERSION", goldens->version, sizeof goldens->version);
    fgl_take_value(line, "package", goldens->package, sizeof goldens->package);
    if (fgl_take_value(line, "picture", recorded, sizeof recorded)) {
        goldens->lines = fgl_grow(goldens->lines, (size_t)goldens->count, sizeof *goldens->lines);
        goldens->lines[goldens->count++] = fgl_format("%s", recorded);
    }
    return true;
}

bool fgl_goldens_open(const char *folder, struct goldens *goldens, struct problem *problem)
{
    *goldens = (struct goldens){.folder = folder};
    char *path = fgl_format("%s/GOLDENS.txt", folder);
    const bool good = fgl_read_lines(path, use_line, goldens, problem);
    free(path);
    return good;
}

void fgl_goldens_close(struct goldens *goldens)
{
    for (int i = 0; i < goldens->count; i++)
        free(goldens->lines[i]);
    free(goldens->lines);
    *goldens = (struct goldens){0};
}

/* A golden of this name must have been recorded for this very line of the picture list. */
static bool check_recorded(const struct goldens *goldens, const struct picture *picture,
                           struct problem *problem)
{
    char *line = fgl_pictures_line(picture);
    const char *recorded = NULL;
    const size_t name = strlen(picture->name);
    for (int i = 0; i < goldens->count; i++)
        if (strncmp(goldens->lines[i], line, name) == 0 && goldens->lines[i][name] == ' ')
            recorded = goldens->lines[i];
    bool good = recorded != NULL && strcmp(recorded, line) == 0;
    if (recorded == NULL)
        fgl_problem_set(problem, "golden missing: %s/GOLDENS.txt does not name it", goldens->folder);
    else if (!good)
        fgl_problem_set(problem, "golden out of date: recorded for `%.200s`", recorded);
    free(line);
    return good;
}

/* Depth of 24 bits from the pixels of an RGB picture. */
static void unpack_depth(const uint8_t *rgb, struct image *image)
{
    const size_t count = fgl_image_pixels(image);
    image->depth_bits = 24;
    image->depth = fgl_allocate(count, sizeof *image->depth);
    for (size_t i = 0; i < count; i++, rgb += 3)
        image->depth[i] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
}

static bool load_depth(const char *path, struct image *image, struct problem *problem)
{
    if (access(path, F_OK) != 0)
        return true; /* recorded from a program without depth buffer; a lost file shows as differing depth
                        bits */
    int width, height;
    uint8_t *rgb = fgl_pngfile_read(path, 3, &width, &height, problem);
    if (rgb == NULL)
        return false;
    const bool good = width == image->width && height == image->height;
    if (good)
        unpack_depth(rgb, image);
    free(rgb);
    return good || fgl_problem_set(problem, "%s has another size than the colours", path);
}

bool fgl_goldens_load(const struct goldens *goldens, const struct picture *picture, struct image *image,
                      struct problem *problem)
{
    *image = (struct image){0};
    if (!check_recorded(goldens, picture, problem))
        return false;
    char *path = fgl_format("%s/%s.png", goldens->folder, picture->name);
    char *depth_path = fgl_format("%s/%s.depth.png", goldens->folder, picture->name);
    bool good = access(path, F_OK) == 0 || fgl_problem_set(problem, "golden missing: %s", path);
    if (good) {
        image->rgba = fgl_pngfile_read(path, 4, &image->width, &image->height, problem);
        good = image->rgba != NULL && load_depth(depth_path, image, problem);
    }
    snprintf(image->renderer, sizeof image->renderer, "%s", goldens->renderer);
    if (!good)
        fgl_image_free(image);
    free(depth_path);
    free(path);
    return good;
}

static bool write_depth(const char *path, const struct image *image, const struct png_fact *facts,
                        struct problem *problem)
{
    if (image->depth == NULL) {
        remove(path); /* an older one */
        return true;
    }
    if (image->depth_bits != 24)
        return fgl_problem_set(problem, "goldens hold 24 bits of depth, not %d", image->depth_bits);
    const size_t count = fgl_image_pixels(image);
    uint8_t *rgb = fgl_allocate(count, 3);
    for (size_t i = 0; i < count; i++) {
        rgb[3 * i] = (uint8_t)(image->depth[i] >> 16);
        rgb[3 * i + 1] = (uint8_t)(image->depth[i] >> 8 & 255);
        rgb[3 * i + 2] = (uint8_t)(image->depth[i] & 255);
    }
    const bool good = fgl_pngfile_write(path, image->width, image->height, 3, rgb, facts, problem);
    free(rgb);
    return good;
}

bool fgl_goldens_write_picture(const char *folder, const struct picture *picture, const struct image *image,
                               const struct library_facts *facts, struct problem *problem)
{
    const struct png_fact chunks[] = {
            {"GL_RENDERER", facts->renderer},      {"GL_VERSION", facts->version},
            {"package", facts->package},           {"CPU FMA", "yes"},
            {"MESA_SHADER_CACHE_DISABLE", "true"}, {NULL, NULL},
    };
    char *path = fgl_format("%s/%s.png", folder, picture->name);
    char *depth_path = fgl_format("%s/%s.depth.png", folder, picture->name);
    const bool good = fgl_pngfile_write(path, image->width, image->height, 4, image->rgba, chunks, problem) &&
                      write_depth(depth_path, image, chunks, problem);
    free(depth_path);
    free(path);
    return good;
}

bool fgl_goldens_write_index(const char *folder, const struct picture_list *pictures,
                             const struct departure_list *departures, const struct library_facts *facts, int *recorded,
                             struct problem *problem)
{
    char *path = fgl_format("%s/GOLDENS.txt", folder);
    FILE *file = fopen(path, "w");
    bool good = file != NULL;
    if (good) {
        fprintf(file, "# Pictures of the reference, written by `fixedgl diff --record`. Not to be edited.\n");
        fprintf(file, "library: %s\nGL_VENDOR: %s\nGL_RENDERER: %s\nGL_VERSION: %s\n", facts->path,
                facts->vendor, facts->renderer, facts->version);
        fprintf(file, "package: %s\n", facts->package[0] != '\0' ? facts->package : "unknown");
        fprintf(file, "CPU FMA: yes\nMESA_SHADER_CACHE_DISABLE: true\n");
        *recorded = 0;
        for (int i = 0; i < pictures->count; i++) {
            if (fgl_departures_undrawn(departures, pictures->items[i].name) != NULL)
                continue;
            ++*recorded;
            char *line = fgl_pictures_line(&pictures->items[i]);
            fprintf(file, "picture: %s\n", line);
            free(line);
        }
        good = !ferror(file);
        good = fclose(file) == 0 && good;
    }
    if (!good)
        fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    free(path);
    return good;
}
