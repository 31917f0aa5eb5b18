/* Features: primitives between Begin and End, and rectangles. */
#include "generator.h"

#include <math.h>

/* The forms of a command: for every type the plain one and, behind it in the table, the vector one. */
#define FORMS(name) {CMD_##name##f, CMD_##name##d, CMD_##name##i, CMD_##name##s}
static const enum command vertex_forms[3][4] = {FORMS(Vertex2), FORMS(Vertex3), FORMS(Vertex4)};
static const enum command normal_forms[5] = {CMD_Normal3f, CMD_Normal3d, CMD_Normal3i, CMD_Normal3s, CMD_Normal3b};
#define COLOR_FORMS(n) {CMD_Color##n##f, CMD_Color##n##d, CMD_Color##n##ub, CMD_Color##n##b, CMD_Color##n##us, CMD_Color##n##s, CMD_Color##n##ui, CMD_Color##n##i}
static const enum command color_forms[2][8] = {COLOR_FORMS(3), COLOR_FORMS(4)};
static const double largest[8] = {0.0, 0.0, 255.0, 127.0, 65535.0, 32767.0, 4294967295.0, 2147483647.0};

static void emit_form(struct generator *g, enum command command, int count, const double *values)
{
    script_add(g->script, (enum command)(command + (chance(g, 30) ? 1 : 0)), count, values);
}

void emit_color(struct generator *g)
{
    double c[4];
    random_color(g, c);
    if (g->compiling && !g->inside)
        return;
    const int form = chance(g, 60) || g->color_size == 3 ? 0 : below(g, 8), size = form > 0 ? integer(g, 3, 4) : g->color_size;
    for (int i = 0; i < 4 && largest[form] > 0.0; i++)
        c[i] = floor(fmin(fmax(c[i], 0.0), 1.0) * largest[form]);
    emit_form(g, color_forms[size - 3][form], size, c);
}

void feature_color_inside(struct generator *g)
{
    emit_color(g);
}

void emit_normal(struct generator *g)
{
    static const double largest_normal[5] = {0.0, 0.0, 2147483647.0, 32767.0, 127.0};
    double n[3];
    random_normal(g, n);
    if (g->compiling && !g->inside)
        return;
    const int form = chance(g, 70) ? 0 : below(g, 5);
    for (int i = 0; i < 3 && form >= 2; i++)
        n[i] = floor(n[i] * largest_normal[form]);
    emit_form(g, normal_forms[form], 3, n);
}

void feature_normal_inside(struct generator *g)
{
    emit_normal(g);
}

/* Not in strips and fans, where OSMesa heeds edge flags against the specification. */
void feature_edge_flag(struct generator *g)
{
    const double flag = below(g, 2);
    if (!g->edge_flags || g->compiling)
        return;
    emit_form(g, CMD_EdgeFlag, 1, &flag);
}

void feature_tex_coord_inside(struct generator *g)
{
    const double v[4] = {real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, -2.0, 2.0), real(g, 0.5, 2.0)};
    static const enum command forms[4] = {CMD_TexCoord1f, CMD_TexCoord2f, CMD_TexCoord3f, CMD_TexCoord4f};
    emit_form(g, forms[g->tex_coord_size - 1], g->tex_coord_size, v);
}

void emit_vertex(struct generator *g)
{
    double v[4];
    random_position(g, v);
    const int size = chance(g, 60) || g->steady ? 3 : integer(g, 2, 4);
    int form = chance(g, 85) ? 0 : below(g, 4);
    if (form >= 2 && g->space == CLIP_SPACE)
        form = 0;
    if (size == 4 && form < 2) {
        v[3] = chance(g, 50) || g->enabled[FEATURE_lighting] ? 1.0 : real(g, 0.4, 2.0);
        for (int i = 0; i < 3; i++)
            v[i] = (double)(float)(v[i] * v[3]);
    }
    for (int i = 0; i < 3 && form >= 2; i++)
        v[i] = round(v[i]);
    emit_form(g, vertex_forms[size - 2][form], size, v);
}

/* Which of the features between Begin and End these vertices have. */
static void choose_inside(struct generator *g, bool chosen[FEATURES])
{
    for (int i = 0; i < FEATURES; i++)
        chosen[i] = features[i].kind == INSIDE && g->enabled[i] && !g->executing && chance(g, features[i].weight);
    if (g->steady)
        chosen[FEATURE_material_inside] = chosen[FEATURE_array_element] = chosen[FEATURE_list_inside] = false;
}

void emit_vertices(struct generator *g, int count)
{
    bool chosen[FEATURES];
    choose_inside(g, chosen);
    g->inside = true;
    for (int vertex = 0; vertex < count; vertex++) {
        for (int i = 0; i < FEATURES; i++) {
            if (chosen[i] && (chance(g, 65) || (g->steady && vertex == 0))) {
                g->used[i] = true;
                features[i].emit(g);
            }
        }
        emit_vertex(g);
    }
    g->inside = false;
}

/* Triangles never 9 nor, by adding up, 9 in one batch: of these OSMesa draws nothing if the third has no area. In lists all
 * primitives are complete: there OSMesa joins what is left over to the next primitive. */
int vertex_count(struct generator *g, int mode, int count)
{
    static const int least[10] = {1, 2, 2, 2, 6, 3, 3, 4, 4, 3}, step[10] = {1, 2, 1, 1, 6, 1, 1, 4, 2, 1};
    if (!g->compiling)
        return mode == GL_TRIANGLES ? 6 * (count > 8 ? 2 : 1) + count % 3 : count;
    return count < least[mode] ? least[mode] : count - count % step[mode];
}

/* OSMesa joins the strips of a list to each other and takes them apart, which shows in their edges and in their stipple. And it goes on
 * with the stipple of the primitive before where the first line of a strip is clipped away. */
int random_mode(struct generator *g)
{
    const int mode = below(g, 10);
    if (mode == GL_TRIANGLE_STRIP && g->compiling && g->enabled[FEATURE_polygon_mode])
        return GL_TRIANGLE_FAN;
    const bool may_clip = g->space == EYE_SPACE || g->used[FEATURE_matrix] || g->used[FEATURE_matrix_stack] || g->used[FEATURE_clip_plane];
    const bool line_strip = mode == GL_LINE_STRIP || mode == GL_LINE_LOOP, stippled = line_strip && g->used[FEATURE_line_stipple];
    g->contained = stippled && !may_clip && !g->compiling;
    if (mode == GL_LINE_LOOP && g->compiling)
        return GL_LINES; /* OSMesa does not close some */
    return stippled && !g->contained ? GL_LINES : mode;
}

/* At least one vertex: OSMesa loses what follows an empty primitive of the same mode. */
void feature_immediate(struct generator *g)
{
    static const int most[10] = {12, 13, 8, 9, 14, 10, 9, 14, 11, 8};
    const int mode = random_mode(g);
    const int count = chance(g, 5) ? integer(g, 1, 3) : integer(g, mode >= GL_QUADS ? 4 : 3, most[mode]);
    if (chance(g, 50))
        emit_color(g);
    if (chance(g, 25))
        emit_normal(g);
    EMIT(g, Begin, mode);
    g->steady = g->compiling || mode == GL_LINE_LOOP || (mode == GL_LINE_STRIP && g->used[FEATURE_line_stipple]);
    g->edge_flags = mode == GL_TRIANGLES || mode == GL_QUADS || mode == GL_POLYGON;
    emit_vertices(g, vertex_count(g, mode, count));
    g->contained = false;
    EMIT0(g, End);
    if (g->edge_flags && g->used[FEATURE_edge_flag] && !g->compiling)
        EMIT(g, EdgeFlag, GL_TRUE);
    g->edge_flags = g->steady = false;
}

void feature_rect(struct generator *g)
{
    double a[4], b[4];
    if (g->executing)
        return; /* its vertices have another size than those of primitives */
    random_position(g, a);
    random_position(g, b);
    if (chance(g, 60))
        emit_color(g);
    const int form = g->space == CLIP_SPACE ? below(g, 2) : below(g, 4);
    for (int i = 0; i < 2 && form >= 2; i++) {
        a[i] = round(a[i]);
        b[i] = round(b[i]);
    }
    const double v[4] = {a[0], a[1], b[0], b[1]};
    static const enum command forms[4] = {CMD_Rectf, CMD_Rectd, CMD_Recti, CMD_Rects};
    script_add(g->script, forms[form], 4, v);
}
