/* PNG files through libpng. */
#include "pngfile.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct writing {
    FILE *file;
    int width, height, channels;
    const uint8_t *bytes;
    const struct png_fact *facts;
};

static void write_facts(png_structp png, png_infop info, const struct png_fact *facts)
{
    for (; facts != NULL && facts->key != NULL; facts++) {
        png_text text = {
                .compression = PNG_TEXT_COMPRESSION_NONE,
                .key = (char *)facts->key,
                .text = (char *)facts->value,
                .text_length = strlen(facts->value),
        };
        png_set_text(png, info, &text, 1);
    }
}

/* libpng reports errors by longjmp, so nothing in here may own memory. */
static bool encode(png_structp png, png_infop info, const struct writing *what)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, what->file);
    png_set_IHDR(png, info, (png_uint_32)what->width, (png_uint_32)what->height, 8,
                 what->channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    write_facts(png, info, what->facts);
    png_write_info(png, info);
    const size_t row = (size_t)what->width * (size_t)what->channels;
    for (int y = 0; y < what->height; y++)
        png_write_row(png, what->bytes + (size_t)y * row);
    png_write_end(png, NULL);
    return true;
}

bool fgl_pngfile_write(const char *path, int width, int height, int channels, const uint8_t *bytes,
                       const struct png_fact *facts, struct problem *problem)
{
    struct writing what = {fopen(path, "wb"), width, height, channels, bytes, facts};
    if (what.file == NULL)
        return fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    bool good = info != NULL && encode(png, info, &what);
    png_destroy_write_struct(&png, &info);
    good = fclose(what.file) == 0 && good;
    return good || fgl_problem_set(problem, "%s: cannot be written", path);
}

uint8_t *fgl_pngfile_read(const char *path, int channels, int *width, int *height, struct problem *problem)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&png, path)) {
        fgl_problem_set(problem, "%s: %s", path, png.message);
        return NULL;
    }
    /* Only a file of this very format passes through libpng's simplified reader without conversion. */
    const png_uint_32 format = channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    uint8_t *bytes = NULL;
    if (png.format != format) {
        fgl_problem_set(problem, "%s: not a PNG of %d channels of 8 bits", path, channels);
    } else {
        bytes = fgl_allocate(PNG_IMAGE_SIZE(png), 1);
        if (png_image_finish_read(&png, NULL, bytes, 0, NULL)) {
            *width = (int)png.width;
            *height = (int)png.height;
        } else {
            fgl_problem_set(problem, "%s: %s", path, png.message);
            free(bytes);
            bytes = NULL;
        }
    }
    png_image_free(&png);
    return bytes;
}
