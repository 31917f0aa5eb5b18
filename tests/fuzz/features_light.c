/* Features: lights, materials, shading. */
#include "generator.h"

static void emit_light_color(struct generator *g, unsigned light)
{
    double c[4];
    random_color(g, c);
    EMIT(g, Lightfv, light, ONE_OF(g, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR), c[0], c[1], c[2], c[3]);
}

static void emit_light_position(struct generator *g, unsigned light)
{
    double v[3];
    random_normal(g, v);
    if (chance(g, 40)) {
        EMIT(g, Lightfv, light, GL_POSITION, v[0], v[1], v[2], 0);
        return;
    }
    const double size = g->space == PIXEL_SPACE ? 60.0 : 4.0;
    EMIT(g, Lightfv, light, GL_POSITION, real(g, -size, size), real(g, -size, size), real(g, 0.1, size),
         chance(g, 80) ? 1.0 : real(g, 0.5, 3.0));
}

static void emit_light_attenuation(struct generator *g, unsigned light)
{
    const double per_distance = g->space == PIXEL_SPACE ? 0.05 : 0.5;
    if (chance(g, 60))
        EMIT(g, Lightf, light, GL_CONSTANT_ATTENUATION, real(g, 0.3, 2.0));
    if (chance(g, 60))
        EMIT(g, Lightf, light, GL_LINEAR_ATTENUATION, real(g, 0.0, per_distance));
    if (chance(g, 50))
        EMIT(g, Lightf, light, GL_QUADRATIC_ATTENUATION, real(g, 0.0, per_distance * per_distance));
}

static void emit_spot(struct generator *g, unsigned light)
{
    double v[3];
    random_normal(g, v);
    EMIT(g, Lightfv, light, GL_SPOT_DIRECTION, v[0], v[1], -2.0);
    if (chance(g, 25))
        EMIT(g, Lighti, light, GL_SPOT_CUTOFF, chance(g, 20) ? 180 : integer(g, 1, 90));
    else
        EMIT(g, Lightf, light, GL_SPOT_CUTOFF, real(g, 5.0, 90.0));
    if (chance(g, 70))
        EMIT(g, Lightf, light, GL_SPOT_EXPONENT, chance(g, 30) ? integer(g, 0, 4) : real(g, 0.0, 128.0));
}

static void emit_light(struct generator *g)
{
    const unsigned light = GL_LIGHT0 + (unsigned)(chance(g, 60) ? 0 : below(g, 8));
    for (int n = integer(g, 0, 3); n > 0; n--)
        emit_light_color(g, light);
    if (chance(g, 80))
        emit_light_position(g, light);
    if (chance(g, 35) && !g->plain_lights)
        emit_light_attenuation(g, light);
    if (chance(g, 30) && !g->plain_lights)
        emit_spot(g, light);
    toggle(g, light, 90);
}

static void emit_light_model(struct generator *g)
{
    double c[4];
    switch (below(g, 4)) {
    case 0:
        random_color(g, c);
        EMIT(g, LightModelfv, GL_LIGHT_MODEL_AMBIENT, c[0], c[1], c[2], c[3]);
        break;
    case 1: EMIT(g, LightModeli, GL_LIGHT_MODEL_LOCAL_VIEWER, below(g, 2)); break;
    case 2: EMIT(g, LightModelf, GL_LIGHT_MODEL_TWO_SIDE, below(g, 2)); break;
    default:
        EMIT(g, LightModeli, GL_LIGHT_MODEL_COLOR_CONTROL, ONE_OF(g, GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR));
    }
}

void feature_lighting(struct generator *g)
{
    toggle(g, GL_LIGHTING, 85);
    for (int n = integer(g, 1, 3); n > 0; n--)
        emit_light(g);
    if (chance(g, 50))
        emit_light_model(g);
    if (chance(g, 60))
        emit_normal(g);
}

static void emit_material(struct generator *g)
{
    const bool of_vertices = g->inside || g->compiling;
    const double face = of_vertices ? g->face_of_vertices : ONE_OF(g, GL_FRONT, GL_FRONT_AND_BACK, GL_FRONT_AND_BACK, GL_BACK);
    if (chance(g, 30) && !g->without_shininess) {
        if (chance(g, 20))
            EMIT(g, Materiali, face, GL_SHININESS, integer(g, 1, (int)g->largest_shininess));
        else
            EMIT(g, Materialf, face, GL_SHININESS, real(g, 0.5, g->largest_shininess));
        return;
    }
    double c[4];
    random_color(g, c);
    const double pname = ONE_OF(g, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE);
    if (chance(g, 10))
        EMIT(g, Materialiv, face, pname, integer(g, 0, 2147483647), integer(g, 0, 2147483647), integer(g, 0, 2147483647),
             2147483647);
    else
        EMIT(g, Materialfv, face, pname, c[0], c[1], c[2], c[3]);
}

/* Not in a list that is executed, too: OSMesa draws what is before it with it. */
void feature_material(struct generator *g)
{
    if (g->executing)
        return;
    for (int n = integer(g, 1, 3); n > 0; n--)
        emit_material(g);
}

void feature_material_inside(struct generator *g)
{
    emit_material(g);
}

void feature_color_material(struct generator *g)
{
    if (chance(g, 70))
        EMIT(g, ColorMaterial, ONE_OF(g, GL_FRONT, GL_FRONT_AND_BACK),
             ONE_OF(g, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE));
    toggle(g, GL_COLOR_MATERIAL, 75);
}

void feature_shade_model(struct generator *g)
{
    EMIT(g, ShadeModel, ONE_OF(g, GL_FLAT, GL_SMOOTH));
    settle_shade_model(g);
}

void settle_shade_model(struct generator *g)
{
    if (g->enabled[FEATURE_line_smooth] || g->enabled[FEATURE_point_smooth])
        emit_unseen_point(g);
}
