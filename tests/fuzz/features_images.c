/* Features: texture images of all internal formats from all formats and types of pixels, with borders; mipmaps made from them; parts and copies;
 * and images read back. */
#include "generator.h"
#include "pixel_data.h"
#include "textures.h"

static double random_internal(struct generator *g)
{
    return ONE_OF(g, 1, 2, 3, 4, GL_ALPHA, GL_ALPHA4, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16, GL_LUMINANCE, GL_LUMINANCE4, GL_LUMINANCE8, GL_LUMINANCE12,
                  GL_LUMINANCE16, GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_LUMINANCE6_ALPHA2, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE12_ALPHA4,
                  GL_LUMINANCE12_ALPHA12, GL_LUMINANCE16_ALPHA16, GL_INTENSITY, GL_INTENSITY4, GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16,
                  GL_RGB, GL_R3_G3_B2, GL_RGB4, GL_RGB5, GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16, GL_RGBA, GL_RGBA2, GL_RGBA4, GL_RGB5_A1,
                  GL_RGBA8, GL_RGB10_A2, GL_RGBA12, GL_RGBA16);
}

static double random_format(struct generator *g)
{
    return ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGB, GL_BGRA, GL_BGR, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RED, GL_GREEN, GL_BLUE);
}

/* The command for one image; its data are still to be added. */
static void emit_image(struct generator *g, const struct image *i, int level, double face, const int size[3])
{
    switch (i->target) {
    case 0: EMIT(g, TexImage1D, GL_TEXTURE_1D, level, i->internal, size[0], i->border, i->format, i->type->type); break;
    case 2:
        EMIT(g, TexImage3D, GL_TEXTURE_3D, level, i->internal, size[0], size[1], size[2], i->border, i->format, i->type->type);
        break;
    default: EMIT(g, TexImage2D, face, level, i->internal, size[0], size[1], i->border, i->format, i->type->type);
    }
}

/* The same size with borders, where the target has that dimension. */
static void with_border(const struct image *i, const int inner[3], int size[3])
{
    for (int k = 0; k < 3; k++)
        size[k] = inner[k] + (k < dimensions_of(i->target) ? 2 * i->border : 0);
}

bool may_skip(const struct generator *g)
{
    const enum feature transfers[] = {FEATURE_pixel_transfer, FEATURE_pixel_map};
    for (int i = 0; i < 2; i++) {
        if (g->used[transfers[i]] || (g->compiling && g->enabled[transfers[i]]))
            return false;
    }
    return true;
}

/* The number of elements that follow. */
static int image_store(struct generator *g, int width, int height, int bytes, int per_pixel)
{
    const int count = random_unpack_store(g, width, height, bytes, per_pixel);
    if (!may_skip(g))
        plain_unpack_store(g);
    return count;
}

void emit_images(struct generator *g, const struct image *image, bool mipmaps)
{
    int inner[3] = {image->size[0], image->size[1], image->size[2]}, size[3];
    const int per_pixel = image->type->components ? 1 : components_of(image->format);
    for (int level = 0; level < (mipmaps ? 8 : 1); level++) {
        with_border(image, inner, size);
        for (int face = 0; face < (image->target == 3 ? 6 : 1); face++) {
            const int count = image_store(g, size[0], size[1] * size[2], image->type->bytes, per_pixel);
            emit_image(g, image, level, image->target == 3 ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : GL_TEXTURE_2D, size);
            add_random_elements(g, image->type, count, false);
        }
        if (inner[0] == 1 && inner[1] == 1 && inner[2] == 1)
            break;
        for (int k = 0; k < 3; k++)
            inner[k] = inner[k] > 1 ? inner[k] / 2 : 1;
    }
}

void random_image_size(struct generator *g, struct image *image)
{
    for (int k = 0; k < 3; k++)
        image->size[k] = k < dimensions_of(image->target) ? random_size(g, k < 2 ? 5 : 3) : 1;
    if (image->target == 3)
        image->size[1] = image->size[0];
}

/* Not as integers of 32 bits: 1.0 overflows in OSMesa (departure reads-of-one). */
static void emit_get(struct generator *g, int target, int level)
{
    const double image = target == 3 ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + below(g, 6) : texture_targets[target], format = random_format(g);
    double type;
    do
        type = random_pixel_type(g, format)->type;
    while (type == GL_UNSIGNED_INT || type == GL_INT);
    EMIT(g, GetTexImage, image, level, format, type);
}

/* Base and maximum, of a texture that has all levels (see reset_levels). */
static void emit_levels(struct generator *g, double target)
{
    g->levels_set = true;
    EMIT(g, TexParameteri, target, GL_TEXTURE_BASE_LEVEL, below(g, 3));
    EMIT(g, TexParameteri, target, GL_TEXTURE_MAX_LEVEL, chance(g, 60) ? 1000 : below(g, 4));
}

void feature_texture_format(struct generator *g)
{
    struct image image = {.target = random_target(g), .internal = random_internal(g), .format = random_format(g)};
    const double target = texture_targets[image.target];
    const int mipmaps = below(g, 4); /* none, given, made by a parameter, made by a command */
    if (!use(g, FEATURE_texture))
        return;
    image.type = random_pixel_type(g, image.format);
    image.border = chance(g, 25) && may_skip(g) && use(g, FEATURE_texture_border);
    random_image_size(g, &image);
    if (mipmaps == 2 || chance(g, 20))
        EMIT(g, TexParameteri, target, GL_GENERATE_MIPMAP, mipmaps == 2);
    emit_images(g, &image, mipmaps == 1);
    if (mipmaps == 3 && !g->compiling && use(g, FEATURE_generate_mipmap))
        EMIT(g, GenerateMipmap, target);
    emit_filters(g, image.target, mipmaps > 0);
    if (mipmaps > 0 && chance(g, 30))
        emit_levels(g, target);
    if (mipmaps > 0 && chance(g, 15) && use(g, FEATURE_get_texture) && !g->compiling)
        emit_get(g, image.target, below(g, 3));
    if (!g->compiling)
        emit_coordinates(g);
    toggle(g, (unsigned)target, 90);
}

void feature_texture_border(struct generator *g)
{
    struct image image = {.target = random_target(g), .border = 1, .internal = random_internal(g), .format = GL_RGBA};
    if (!may_skip(g) || !use(g, FEATURE_texture))
        return;
    image.type = random_pixel_type(g, image.format);
    random_image_size(g, &image);
    const bool mipmaps = chance(g, 30);
    emit_images(g, &image, mipmaps);
    emit_filters(g, image.target, mipmaps);
    for (int axis = 0; axis < dimensions_of(image.target); axis++)
        EMIT(g, TexParameteri, texture_targets[image.target], axis == 2 ? GL_TEXTURE_WRAP_R : GL_TEXTURE_WRAP_S + axis,
             ONE_OF(g, GL_CLAMP_TO_BORDER, GL_CLAMP, GL_CLAMP_TO_EDGE));
    if (!g->compiling)
        emit_coordinates(g);
    toggle(g, (unsigned)texture_targets[image.target], 90);
}

/* Not of a target without an image: OSMesa raises an error (departure mipmaps-of-nothing). */
void feature_generate_mipmap(struct generator *g)
{
    struct image image = {.target = random_target(g), .internal = random_internal(g), .format = GL_RGBA};
    if (g->compiling || !use(g, FEATURE_texture))
        return;
    image.type = random_pixel_type(g, image.format);
    random_image_size(g, &image);
    emit_images(g, &image, false);
    emit_filters(g, image.target, true);
    EMIT(g, GenerateMipmap, texture_targets[image.target]);
}

/* ---- parts ---- */

void feature_texture_part(struct generator *g)
{
    const int target = random_target(g), x = below(g, 4), y = below(g, 4), z = below(g, 2), width = integer(g, 1, 4), height = integer(g, 1, 4),
              level = chance(g, 80) ? 0 : 1;
    const double format = random_format(g);
    const struct pixel_type *type = random_pixel_type(g, format);
    if (!use(g, FEATURE_texture))
        return;
    const int count = image_store(g, width, height, type->bytes, type->components ? 1 : components_of(format));
    switch (target) {
    case 0: EMIT(g, TexSubImage1D, GL_TEXTURE_1D, level, x, width, format, type->type); break;
    case 2: EMIT(g, TexSubImage3D, GL_TEXTURE_3D, level, x, y, z, width, height, 1, format, type->type); break;
    default:
        EMIT(g, TexSubImage2D, target == 1 ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_POSITIVE_X + below(g, 6), level, x, y, width, height, format,
             type->type);
    }
    add_random_elements(g, type, count, false);
}

/* Of colors; not with pixel transfer (departure copied-images). */
void feature_copy_texture_part(struct generator *g)
{
    const int x = below(g, g->script->width - 8), y = below(g, g->script->height - 8), width = integer(g, 1, 8), height = integer(g, 1, 8);
    if (g->compiling || g->used[FEATURE_pixel_transfer] || g->used[FEATURE_pixel_map] || !use(g, FEATURE_texture))
        return;
    for (int target = 0; target < 3; target++)
        reset_levels(g, texture_targets[target]);
    switch (below(g, 5)) {
    case 0: EMIT(g, CopyTexImage1D, GL_TEXTURE_1D, 0, random_internal_of_copies(g), x, y, width, 0); break;
    case 1: EMIT(g, CopyTexSubImage1D, GL_TEXTURE_1D, 0, below(g, 4), x, y, width); break;
    case 2: EMIT(g, CopyTexSubImage3D, GL_TEXTURE_3D, 0, below(g, 3), below(g, 3), below(g, 2), x, y, width, height); break;
    case 3: EMIT(g, CopyTexImage2D, GL_TEXTURE_2D, 0, random_internal_of_copies(g), x, y, width, height, 0); break;
    default: EMIT(g, CopyTexSubImage2D, GL_TEXTURE_2D, 0, below(g, 4), below(g, 4), x, y, width, height);
    }
}

/* Of the first level: OSMesa loses others when it is given anew (departure lost-levels). */
void feature_get_texture(struct generator *g)
{
    const int target = random_target(g);
    if (g->compiling || !use(g, FEATURE_texture))
        return;
    if (chance(g, 70)) {
        emit_get(g, target, 0);
        return;
    }
    if (g->used[FEATURE_compressed_texture]) /* of which OSMesa has other sizes */
        return;
    EMIT(g, GetTexLevelParameteriv, target == 3 ? GL_TEXTURE_CUBE_MAP_NEGATIVE_X : texture_targets[target], below(g, 3),
         ONE_OF(g, GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER, GL_TEXTURE_RED_SIZE, GL_TEXTURE_ALPHA_SIZE,
                GL_TEXTURE_LUMINANCE_SIZE));
}
