/* Features: points, lines, polygons, hints. */
#include "generator.h"

void feature_cull(struct generator *g)
{
    toggle(g, GL_CULL_FACE, 70);
    if (chance(g, 60))
        EMIT(g, CullFace, ONE_OF(g, GL_FRONT, GL_BACK, GL_BACK, GL_FRONT_AND_BACK));
    if (chance(g, 60))
        EMIT(g, FrontFace, ONE_OF(g, GL_CW, GL_CCW));
}

void feature_polygon_mode(struct generator *g)
{
    EMIT(g, PolygonMode, ONE_OF(g, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK), ONE_OF(g, GL_POINT, GL_LINE, GL_LINE, GL_FILL));
}

/* That of filled polygons always with the others: OSMesa offsets them, too, when only lines or points are to be offset; and with
 * polygon modes all or none: it decides for all triangles of a batch by the mode of the first. */
void feature_polygon_offset(struct generator *g)
{
    static const unsigned caps[3] = {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT};
    const int enabled = g->enabled[FEATURE_polygon_mode] ? 3 * below(g, 2) : below(g, 4);
    for (int i = 0; i < 3; i++) {
        if (i < enabled)
            EMIT(g, Enable, caps[i]);
        else
            EMIT(g, Disable, caps[i]);
    }
    EMIT(g, PolygonOffset, real(g, -2.0, 2.0), chance(g, 70) ? real(g, -4.0, 4.0) : real(g, -100000.0, 100000.0));
}

void feature_polygon_stipple(struct generator *g)
{
    double mask[128];
    const int step = 1 + below(g, 4);
    for (int i = 0; i < 128; i++)
        mask[i] = i >= 4 * step ? mask[i - 4 * step] : below(g, 256);
    script_add(g->script, CMD_PolygonStipple, 128, mask);
    toggle(g, GL_POLYGON_STIPPLE, 75);
}

void feature_point_size(struct generator *g)
{
    EMIT(g, PointSize, chance(g, 50) ? integer(g, 1, 9) : chance(g, 90) ? real(g, 0.1, 12.0) : real(g, 12.0, 70.0));
}

void feature_point_smooth(struct generator *g)
{
    toggle(g, GL_POINT_SMOOTH, 70);
}

void feature_line_width(struct generator *g)
{
    EMIT(g, LineWidth, chance(g, 50) ? integer(g, 1, 6) : chance(g, 95) ? real(g, 0.1, 8.0) : real(g, 8.0, 40.0));
}

void feature_line_stipple(struct generator *g)
{
    static const double patterns[] = {0x0f0f, 0x5555, 0x00ff, 0x1c47, 0xffff};
    EMIT(g, LineStipple, chance(g, 60) ? integer(g, 1, 4) : integer(g, -2, 300),
         chance(g, 60) ? one_of(g, 5, patterns) : below(g, 65536));
    toggle(g, GL_LINE_STIPPLE, 80);
}

void feature_line_smooth(struct generator *g)
{
    toggle(g, GL_LINE_SMOOTH, 70);
}

void feature_hint(struct generator *g)
{
    EMIT(g, Hint, ONE_OF(g, GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT),
         ONE_OF(g, GL_FASTEST, GL_NICEST, GL_DONT_CARE));
    if (chance(g, 30))
        toggle(g, GL_POLYGON_SMOOTH, 50);
}
