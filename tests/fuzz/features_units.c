/* Features: more texture units, combiners of the textures of several units, point sprites, texture objects. */
#include "generator.h"
#include "textures.h"

enum { FIRST_UNIT = 2, UNITS = 8, FIRST_OBJECT = 1, OBJECTS = 4 };

/* Another object of each target: what is set from now on is its own. */
void feature_texture_object(struct generator *g)
{
    if (!use(g, FEATURE_texture))
        return;
    const int target = random_target(g);
    EMIT(g, BindTexture, texture_targets[target], chance(g, 20) ? 0 : FIRST_OBJECT + 10 * target + below(g, OBJECTS));
}

/* A texture on a unit beyond the second; units have objects of their own, so that several are complete. */
void feature_later_unit(struct generator *g)
{
    if (!use(g, FEATURE_texture))
        return;
    const int unit = chance(g, 60) ? FIRST_UNIT : integer(g, FIRST_UNIT, UNITS - 1);
    EMIT(g, ActiveTexture, GL_TEXTURE0 + unit);
    feature_texture_object(g);
    feature_texture(g);
    if (chance(g, 60))
        feature_texture_env(g);
    if (chance(g, 20) && use(g, FEATURE_texgen))
        feature_texgen(g);
    EMIT(g, ActiveTexture, GL_TEXTURE0);
    if (!g->compiling)
        EMIT(g, MultiTexCoord4f, GL_TEXTURE0 + unit, real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), 1.0);
}

void feature_later_coord_inside(struct generator *g)
{
    const int unit = FIRST_UNIT + below(g, g->steady ? 1 : 2); /* the same for all vertices that must have the same attributes */
    EMIT(g, MultiTexCoord4f, GL_TEXTURE0 + unit, real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, 0.5, 2.0));
}

/* ---- GL_ARB_texture_env_crossbar ---- */

enum { CROSSED_UNITS = 3, CROSSED_OBJECT = 50 };

/* A complete texture, alone on its unit: what a unit without one gives to others is undefined (GL 1.5, 3.8.13). */
static void emit_crossed_texture(struct generator *g, int unit)
{
    EMIT(g, ActiveTexture, GL_TEXTURE0 + unit);
    EMIT(g, Disable, GL_TEXTURE_3D);
    EMIT(g, Disable, GL_TEXTURE_CUBE_MAP);
    EMIT(g, BindTexture, GL_TEXTURE_2D, CROSSED_OBJECT + unit);
    plain_unpack_store(g);
    EMIT(g, TexImage2D, GL_TEXTURE_2D, 0, ONE_OF(g, GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RGBA16), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    add_random_bytes(g, 4 * 4 * 4);
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    EMIT(g, Enable, GL_TEXTURE_2D);
}

static double random_source(struct generator *g)
{
    return chance(g, 40) ? GL_TEXTURE0 + below(g, CROSSED_UNITS) : ONE_OF(g, GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS);
}

static void emit_crossed_combiner(struct generator *g, int unit)
{
    double c[4];
    random_color(g, c);
    EMIT(g, ActiveTexture, GL_TEXTURE0 + unit);
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    EMIT(g, TexEnvfv, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c[0], c[1], c[2], c[3]);
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_COMBINE_RGB, ONE_OF(g, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT,
                                                            GL_DOT3_RGB, GL_DOT3_RGB, GL_DOT3_RGBA, GL_DOT3_RGBA));
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_COMBINE_ALPHA, ONE_OF(g, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT));
    for (int k = 0; k < 3; k++) {
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_SOURCE0_RGB + k, random_source(g));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + k, random_source(g));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_OPERAND0_RGB + k, ONE_OF(g, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + k, ONE_OF(g, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    }
    EMIT(g, TexEnvf, GL_TEXTURE_ENV, GL_RGB_SCALE, ONE_OF(g, 1, 1, 2, 4));
    EMIT(g, TexEnvf, GL_TEXTURE_ENV, GL_ALPHA_SCALE, ONE_OF(g, 1, 1, 2, 4));
}

void feature_crossbar(struct generator *g)
{
    if (!use(g, FEATURE_texture))
        return;
    for (int unit = 0; unit < CROSSED_UNITS; unit++) {
        emit_crossed_texture(g, unit);
        if (chance(g, 50))
            emit_crossed_combiner(g, unit);
        else
            EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, ONE_OF(g, GL_MODULATE, GL_MODULATE, GL_ADD, GL_BLEND, GL_DECAL));
    }
    EMIT(g, ActiveTexture, GL_TEXTURE0);
    feature_immediate(g);
    for (int unit = CROSSED_UNITS - 1; unit >= 0; unit--) {
        EMIT(g, ActiveTexture, GL_TEXTURE0 + unit);
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        EMIT(g, BindTexture, GL_TEXTURE_2D, 0);
        EMIT(g, Disable, GL_TEXTURE_2D);
    }
}

/* Of a texture's level of detail on its unit, added to the texture's own (GL 1.5, 3.8.13). */
void feature_unit_lod_bias(struct generator *g)
{
    EMIT(g, TexEnvf, GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, chance(g, 20) ? 0.0 : real(g, -2.0, 2.0));
}

/* Points alone are drawn with them: OSMesa replaces the coordinates of lines and triangles, too (departure replaced-coordinates), and
 * draws a row below the scissor box and the window (departure sprites-below). */
void feature_point_sprite(struct generator *g)
{
    if (g->querying)
        return;
    EMIT(g, Disable, GL_SCISSOR_TEST);
    EMIT(g, Enable, GL_POINT_SPRITE_ARB);
    for (int unit = 0; unit < 3; unit++) {
        if (chance(g, 40))
            continue;
        EMIT(g, ActiveTexture, GL_TEXTURE0 + unit);
        EMIT(g, TexEnvi, GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, chance(g, 75));
    }
    EMIT(g, ActiveTexture, GL_TEXTURE0);
    EMIT(g, PointSize, real(g, 1.0, 20.0));
    EMIT(g, Begin, GL_POINTS);
    g->steady = g->compiling;
    emit_vertices(g, integer(g, 1, 8));
    g->steady = false;
    EMIT0(g, End);
    EMIT(g, Disable, GL_POINT_SPRITE_ARB);
}
