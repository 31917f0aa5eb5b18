/* Features of OpenGL 1.2 to 1.5: secondary colors, fog coordinates, point parameters, more texture units, depth textures, copies. */
#include "generator.h"
#include "textures.h"

void feature_color_sum(struct generator *g)
{
    double c[4];
    random_color(g, c);
    toggle(g, GL_COLOR_SUM, 80);
    if (!g->compiling)
        EMIT(g, SecondaryColor3f, c[0], c[1], c[2]);
}

void feature_secondary_color_inside(struct generator *g)
{
    double c[4];
    random_color(g, c);
    EMIT(g, SecondaryColor3f, c[0], c[1], c[2]);
}

void feature_fog_coordinate(struct generator *g)
{
    EMIT(g, Fogi, GL_FOG_COORD_SRC, ONE_OF(g, GL_FOG_COORD, GL_FOG_COORD, GL_FRAGMENT_DEPTH));
    if (!g->compiling)
        EMIT(g, FogCoordf, real(g, 0.0, 1.0));
}

void feature_fog_coordinate_inside(struct generator *g)
{
    EMIT(g, FogCoordf, real(g, -0.5, g->space == EYE_SPACE ? 10.0 : 1.5));
}

void feature_point_parameter(struct generator *g)
{
    const double least = real(g, 0.0, 4.0);
    EMIT(g, PointParameterf, GL_POINT_SIZE_MIN, least);
    EMIT(g, PointParameterf, GL_POINT_SIZE_MAX, least + real(g, 0.0, 20.0));
    EMIT(g, PointParameterf, GL_POINT_FADE_THRESHOLD_SIZE, real(g, 0.0, 4.0));
    if (chance(g, 70))
        EMIT(g, PointParameterfv, GL_POINT_DISTANCE_ATTENUATION, real(g, 0.2, 2.0), real(g, 0.0, 0.5), real(g, 0.0, 0.5));
}

/* The features of textures on the second unit. */
void feature_texture_unit(struct generator *g)
{
    if (!use(g, FEATURE_texture))
        return;
    EMIT(g, ActiveTexture, GL_TEXTURE1);
    feature_texture(g);
    if (chance(g, 50))
        feature_texture_env(g);
    if (chance(g, 20) && use(g, FEATURE_texgen))
        feature_texgen(g);
    EMIT(g, ActiveTexture, GL_TEXTURE0);
    if (!g->compiling)
        EMIT(g, MultiTexCoord4f, GL_TEXTURE1, real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), 1.0);
}

void feature_multi_tex_coord_inside(struct generator *g)
{
    EMIT(g, MultiTexCoord4f, GL_TEXTURE1, real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, 0.5, 2.0));
}

double random_internal_of_copies(struct generator *g)
{
    return ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY, GL_LUMINANCE_ALPHA);
}

/* Of colors of the picture. */
void feature_copy_texture(struct generator *g)
{
    const int width = g->script->width, height = g->script->height, x = below(g, width - 8), y = below(g, height - 8);
    if (g->compiling || g->used[FEATURE_pixel_transfer] || g->used[FEATURE_pixel_map] || !use(g, FEATURE_texture))
        return; /* departure copied-images */
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    reset_levels(g, GL_TEXTURE_2D);
    EMIT(g, CopyTexImage2D, GL_TEXTURE_2D, 0, random_internal_of_copies(g), x, y, integer(g, 1, 8), integer(g, 1, 8), 0);
    toggle(g, GL_TEXTURE_2D, 90);
}
