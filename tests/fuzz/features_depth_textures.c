/* Features: depth textures, compared and not, and the generic compressed formats. */
#include "generator.h"
#include "textures.h"

/* GL 1.5, 3.8.14: how depths are compared and what they become. Not those of one dimension (departure shadows-of-one-dimension). */
static void emit_comparison(struct generator *g, double target)
{
    EMIT(g, TexParameteri, target, GL_TEXTURE_COMPARE_MODE, chance(g, 65) && target != GL_TEXTURE_1D ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
    EMIT(g, TexParameteri, target, GL_TEXTURE_COMPARE_FUNC,
         ONE_OF(g, GL_LEQUAL, GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER));
    EMIT(g, TexParameteri, target, GL_DEPTH_TEXTURE_MODE, ONE_OF(g, GL_LUMINANCE, GL_INTENSITY, GL_ALPHA));
}

void feature_depth_texture(struct generator *g)
{
    struct image image = {.target = chance(g, 75), .format = GL_DEPTH_COMPONENT};
    image.internal = ONE_OF(g, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32);
    const double target = texture_targets[image.target];
    const bool mipmaps = chance(g, 30);
    if (!use(g, FEATURE_texture))
        return;
    image.type = random_pixel_type(g, image.format);
    random_image_size(g, &image);
    emit_images(g, &image, mipmaps);
    emit_filters(g, image.target, mipmaps);
    emit_comparison(g, target);
    if (!g->compiling)
        EMIT(g, TexCoord4f, real(g, -1.0, 2.0), real(g, -1.0, 2.0), real(g, 0.0, 1.0), 1.0);
    toggle(g, (unsigned)target, 90);
}

/* Depths of the picture. */
void feature_copy_depth_texture(struct generator *g)
{
    const int x = below(g, g->script->width - 8), y = below(g, g->script->height - 8);
    if (g->compiling || g->used[FEATURE_pixel_transfer] || g->script->buffers.depth_bits == 0 || !use(g, FEATURE_texture))
        return;
    reset_levels(g, GL_TEXTURE_2D);
    EMIT(g, CopyTexImage2D, GL_TEXTURE_2D, 0, ONE_OF(g, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24), x, y, integer(g, 1, 8),
         integer(g, 1, 8), 0);
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    emit_comparison(g, GL_TEXTURE_2D);
    toggle(g, GL_TEXTURE_2D, 90);
}

/* Only images that OSMesa, which does compress in some formats, keeps as they are: of one dimension, of alpha or intensity, or of one
 * color whose components are 0 or 1. */
void feature_compressed_texture(struct generator *g)
{
    struct image image = {.target = chance(g, 60), .format = GL_RGBA};
    image.internal = ONE_OF(g, GL_COMPRESSED_ALPHA, GL_COMPRESSED_INTENSITY, GL_COMPRESSED_LUMINANCE, GL_COMPRESSED_LUMINANCE_ALPHA,
                            GL_COMPRESSED_RGB, GL_COMPRESSED_RGBA);
    if (!use(g, FEATURE_texture))
        return;
    image.type = random_pixel_type(g, image.format);
    random_image_size(g, &image);
    if (image.target == 0 || image.internal == GL_COMPRESSED_ALPHA || image.internal == GL_COMPRESSED_INTENSITY) {
        emit_images(g, &image, false);
    } else {
        const double color[4] = {255 * below(g, 2), 255 * below(g, 2), 255 * below(g, 2), 255 * below(g, 2)};
        plain_unpack_store(g);
        EMIT(g, TexImage2D, GL_TEXTURE_2D, 0, image.internal, image.size[0], image.size[1], 0, GL_RGBA, GL_UNSIGNED_BYTE);
        for (int i = 0; i < image.size[0] * image.size[1]; i++)
            script_extend(g->script, 4, color);
    }
    emit_filters(g, image.target, false);
    if (!g->compiling)
        emit_coordinates(g);
    toggle(g, (unsigned)texture_targets[image.target], 90);
}
