/* Features: textures, their parameters, environments and coordinates. */
#include "generator.h"
#include "textures.h"

const double texture_targets[TEXTURE_TARGETS] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};

int random_target(struct generator *g)
{
    return chance(g, 60) ? 1 : below(g, 4);
}

int dimensions_of(int target)
{
    return target == 3 ? 2 : target + 1;
}

static void emit_bytes(struct generator *g, int count)
{
    while (count > 0) {
        double bytes[256];
        const int n = count < 256 ? count : 256;
        for (int i = 0; i < n; i++)
            bytes[i] = below(g, 256);
        script_extend(g->script, n, bytes);
        count -= n;
    }
}

static void emit_byte_image(struct generator *g, int target, double image_target, int level, double internal, const int size[3])
{
    const int bytes = 4 * size[0] * size[1] * size[2];
    switch (target) {
    case 0: EMIT(g, TexImage1D, GL_TEXTURE_1D, level, internal, size[0], 0, GL_RGBA, GL_UNSIGNED_BYTE); break;
    case 2:
        EMIT(g, TexImage3D, GL_TEXTURE_3D, level, internal, size[0], size[1], size[2], 0, GL_RGBA, GL_UNSIGNED_BYTE);
        break;
    default: EMIT(g, TexImage2D, image_target, level, internal, size[0], size[1], 0, GL_RGBA, GL_UNSIGNED_BYTE); break;
    }
    emit_bytes(g, bytes);
}

int random_size(struct generator *g, int largest)
{
    return chance(g, 70) ? 1 << below(g, largest) : integer(g, 1, 1 << (largest - 1));
}

/* All levels of a texture, or the first alone. */
static void emit_byte_images(struct generator *g, int target, bool mipmaps)
{
    const double internal = ONE_OF(g, GL_RGBA, GL_RGBA, GL_RGBA, GL_RGB, GL_RGB, GL_LUMINANCE, GL_ALPHA, GL_INTENSITY,
                                   GL_LUMINANCE_ALPHA, GL_RGB5_A1, GL_RGBA4, GL_R3_G3_B2, GL_LUMINANCE16, GL_RGBA16);
    int size[3] = {random_size(g, 5), random_size(g, 5), target == 2 ? random_size(g, 3) : 1};
    if (target == 0)
        size[1] = 1;
    if (target == 3)
        size[1] = size[0];
    for (int level = 0; level < (mipmaps ? 8 : 1); level++) {
        for (int face = 0; face < (target == 3 ? 6 : 1); face++)
            emit_byte_image(g, target, target == 3 ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : GL_TEXTURE_2D, level, internal, size);
        if (size[0] == 1 && size[1] == 1 && size[2] == 1)
            break;
        for (int i = 0; i < 3; i++)
            size[i] = size[i] > 1 ? size[i] / 2 : 1;
    }
}

static double random_wrap(struct generator *g)
{
    return ONE_OF(g, GL_REPEAT, GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT);
}

void reset_levels(struct generator *g, double target)
{
    if (!g->levels_set)
        return;
    EMIT(g, TexParameteri, target, GL_TEXTURE_BASE_LEVEL, 0);
    EMIT(g, TexParameteri, target, GL_TEXTURE_MAX_LEVEL, 1000);
}

void emit_filters(struct generator *g, int target, bool mipmaps)
{
    const double t = texture_targets[target];
    reset_levels(g, t);
    EMIT(g, TexParameteri, t, GL_TEXTURE_MAG_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    if (mipmaps)
        EMIT(g, TexParameteri, t, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                                                                GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR));
    else
        EMIT(g, TexParameteri, t, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    for (int axis = 0; axis < 3; axis++)
        if (chance(g, 50))
            EMIT(g, TexParameteri, t, axis == 2 ? GL_TEXTURE_WRAP_R : GL_TEXTURE_WRAP_S + axis, random_wrap(g));
    if (chance(g, 40)) {
        double c[4];
        random_color(g, c);
        EMIT(g, TexParameterfv, t, GL_TEXTURE_BORDER_COLOR, c[0], c[1], c[2], c[3]);
    }
    if (mipmaps && chance(g, 30))
        EMIT(g, TexParameterf, t, GL_TEXTURE_LOD_BIAS, real(g, -2.0, 2.0));
    if (mipmaps && chance(g, 20))
        EMIT(g, TexParameterf, t, GL_TEXTURE_MIN_LOD, real(g, -1.0, 2.0));
    if (mipmaps && chance(g, 20))
        EMIT(g, TexParameterf, t, GL_TEXTURE_MAX_LOD, real(g, 2.0, 4.0));
}

void emit_coordinates(struct generator *g)
{
    EMIT(g, TexCoord4f, real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), 1.0);
}

void feature_texture(struct generator *g)
{
    const int target = random_target(g);
    const bool mipmaps = chance(g, 50);
    plain_unpack_store(g);
    emit_byte_images(g, target, mipmaps);
    emit_filters(g, target, mipmaps);
    if (!g->compiling)
        emit_coordinates(g);
    toggle(g, (unsigned)texture_targets[target], 90);
}

static void emit_combiner(struct generator *g)
{
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_COMBINE_RGB, ONE_OF(g, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                                                            GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA));
    EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_COMBINE_ALPHA,
         ONE_OF(g, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT));
    for (int k = 0; k < 3; k++) {
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_SOURCE0_RGB + k, ONE_OF(g, GL_TEXTURE, GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + k, ONE_OF(g, GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_OPERAND0_RGB + k,
             ONE_OF(g, GL_SRC_COLOR, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + k, ONE_OF(g, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    }
    if (chance(g, 30))
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_RGB_SCALE, ONE_OF(g, 1, 2, 4));
    if (chance(g, 30))
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_ALPHA_SCALE, ONE_OF(g, 1, 2, 4));
}

void feature_texture_env(struct generator *g)
{
    double c[4];
    random_color(g, c);
    EMIT(g, TexEnvfv, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c[0], c[1], c[2], c[3]);
    if (chance(g, 30))
        emit_combiner(g);
    else
        EMIT(g, TexEnvi, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, ONE_OF(g, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD));
}

void feature_texgen(struct generator *g)
{
    for (int k = 0; k < 4; k++) {
        if (chance(g, 50))
            continue;
        const double mode = k < 2   ? ONE_OF(g, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP)
                            : k < 3 ? ONE_OF(g, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_REFLECTION_MAP, GL_NORMAL_MAP)
                                    : ONE_OF(g, GL_OBJECT_LINEAR, GL_EYE_LINEAR);
        EMIT(g, TexGeni, GL_S + k, GL_TEXTURE_GEN_MODE, mode);
        if (mode == GL_OBJECT_LINEAR || mode == GL_EYE_LINEAR) /* q well away from 0 */
            EMIT(g, TexGenfv, GL_S + k, mode == GL_OBJECT_LINEAR ? GL_OBJECT_PLANE : GL_EYE_PLANE, real(g, -1.0, 1.0) / (k < 3 ? 1 : 64),
                 real(g, -1.0, 1.0) / (k < 3 ? 1 : 64), real(g, -1.0, 1.0) / (k < 3 ? 1 : 64), real(g, 0.5, 1.0) * (k < 3 ? 1 : 4));
        toggle(g, GL_TEXTURE_GEN_S + (unsigned)k, 80);
    }
}

void feature_texture_matrix(struct generator *g)
{
    EMIT(g, MatrixMode, GL_TEXTURE);
    if (chance(g, 30))
        EMIT0(g, LoadIdentity);
    if (chance(g, 60))
        EMIT(g, Scalef, real(g, 0.2, 3.0), real(g, 0.2, 3.0), 1.0);
    if (chance(g, 60))
        EMIT(g, Rotatef, real(g, -180.0, 180.0), 0.0, 0.0, 1.0);
    if (chance(g, 60))
        EMIT(g, Translatef, real(g, -1.0, 1.0), real(g, -1.0, 1.0), 0.0);
    EMIT(g, MatrixMode, GL_MODELVIEW);
}
