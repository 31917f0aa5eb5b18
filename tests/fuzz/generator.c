/* The frame of every script: some scenes, each some state and then some drawing with changes of state between. */
#include "generator.h"

#include <GL/osmesa.h>
#include <math.h>
#include <string.h>

const struct feature_info features[FEATURES] = {
#define FEATURE(name, kind, weight, command) {#name, kind, weight, CMD_##command, feature_##name},
#include "features.def"
};

/* ---- random numbers: splitmix64 ---- */

static uint64_t next_random(struct generator *g)
{
    uint64_t z = g->random += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

int below(struct generator *g, int n)
{
    return n > 0 ? (int)((next_random(g) >> 33) % (unsigned)n) : 0;
}

bool chance(struct generator *g, int percent)
{
    return below(g, 100) < percent;
}

int integer(struct generator *g, int low, int high)
{
    const uint64_t n = (uint64_t)((int64_t)high - low) + 1;
    return (int)(low + (int64_t)((next_random(g) >> 33) % n));
}

double real(struct generator *g, double low, double high)
{
    static const double steps[] = {0.0, 0.0, 0.01, 0.125, 0.5};
    const double step = steps[below(g, 5)];
    double value = low + (high - low) * (double)(next_random(g) >> 11) * 0x1p-53;
    if (step > 0.0 && high - low > 4.0 * step)
        value = fmin(fmax(round(value / step) * step, low), high);
    return (double)(float)(value + 0.0); /* no -0, which some of OSMesa's paths keep and others do not */
}

double one_of(struct generator *g, int count, const double *values)
{
    return values[below(g, count)];
}

/* ---- choice of features ---- */

bool use(struct generator *g, enum feature feature)
{
    if (g->enabled[feature])
        g->used[feature] = true;
    return g->enabled[feature];
}

void toggle(struct generator *g, unsigned cap, int percent)
{
    if (chance(g, percent))
        EMIT(g, Enable, cap);
    else
        EMIT(g, Disable, cap);
}

static bool is_drawing(int feature)
{
    return features[feature].kind == DRAW || features[feature].kind == QUERY;
}

static void emit_feature(struct generator *g, int feature)
{
    g->used[feature] = true;
    features[feature].emit(g);
}

/* One of the state features or of the drawing ones, each as often as its weight says. */
static void emit_weighted(struct generator *g, bool drawing)
{
    int total = 0, i;
    for (i = 0; i < FEATURES; i++)
        total += g->enabled[i] && (drawing ? is_drawing(i) : features[i].kind == STATE) ? features[i].weight : 0;
    int at = below(g, total);
    for (i = 0; total > 0 && i < FEATURES; i++) {
        if (!g->enabled[i] || !(drawing ? is_drawing(i) : features[i].kind == STATE))
            continue;
        at -= features[i].weight;
        if (at < 0) {
            emit_feature(g, i);
            return;
        }
    }
}

void random_state(struct generator *g)
{
    emit_weighted(g, false);
}

void random_draw(struct generator *g)
{
    emit_weighted(g, true);
}

/* ---- values ---- */

void random_color(struct generator *g, double color[4])
{
    const bool beyond = chance(g, 5);
    for (int i = 0; i < 4; i++)
        color[i] = chance(g, 15) ? (double)below(g, 2) : beyond ? real(g, -0.5, 1.5) : real(g, 0.0, 1.0);
}

void random_normal(struct generator *g, double normal[3])
{
    double length;
    do {
        length = 0.0;
        for (int i = 0; i < 3; i++) {
            normal[i] = real(g, -1.0, 1.0);
            length += normal[i] * normal[i];
        }
    } while (length < 0.05);
    if (chance(g, 50)) {
        for (int i = 0; i < 3; i++)
            normal[i] = (double)(float)(normal[i] / sqrt(length));
    }
}

void random_position(struct generator *g, double position[4])
{
    const double width = g->script->width, height = g->script->height, far_out = g->contained ? 0.9 : chance(g, 6) ? 2.0 : 1.0;
    double low[3] = {-1.05 * far_out, -1.05 * far_out, -far_out}, high[3] = {-low[0], -low[1], far_out};
    if (g->space == PIXEL_SPACE) {
        low[0] = width * (0.5 - 0.52 * far_out), high[0] = width - low[0];
        low[1] = height * (0.5 - 0.52 * far_out), high[1] = height - low[1];
    } else if (g->space == EYE_SPACE) {
        low[0] = low[1] = -3.0 * far_out, high[0] = high[1] = 3.0 * far_out;
        low[2] = -7.0 * far_out, high[2] = far_out > 1.0 ? 2.0 : -2.0;
    }
    for (int i = 0; i < 3; i++) {
        position[i] = real(g, low[i], high[i]);
        if (g->grid > 0.0 && i < 2)
            position[i] = (double)(float)(round(position[i] / g->grid) * g->grid);
    }
    if (g->enabled[FEATURE_lighting] && position[0] == 0.0 && position[1] == 0.0)
        position[0] = 0.125; /* not at the viewer (departure lights-out-of-range) */
    position[3] = 1.0;
}

bool textured_later(const struct generator *g)
{
    const enum feature later[] = {FEATURE_texture_unit, FEATURE_later_unit};
    for (int i = 0; i < 2; i++) {
        if (g->used[later[i]] || (g->compiling && g->enabled[later[i]] && g->enabled[FEATURE_texture])) /* it may be called later */
            return true;
    }
    return false;
}

void emit_unseen_point(struct generator *g)
{
    EMIT(g, Begin, GL_POINTS);
    EMIT(g, Vertex3f, 9.0, 9.0, 9.0);
    EMIT0(g, End);
}

/* ---- frames ---- */

static void generate_clear(struct generator *g)
{
    double color[4];
    random_color(g, color);
    EMIT(g, ClearColor, color[0], color[1], color[2], color[3]);
    if (chance(g, 30))
        EMIT(g, ClearDepth, real(g, 0.5, 1.0));
    if (chance(g, 30))
        EMIT(g, ClearStencil, below(g, 256));
    EMIT(g, Clear, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (g->enabled[FEATURE_accum])
        EMIT(g, Clear, GL_ACCUM_BUFFER_BIT); /* in OSMesa full of what was in memory */
}

static void generate_scene(struct generator *g)
{
    for (int i = 0; i < FEATURES; i++) {
        /* Not all at once: every state needs shaders of its own in the reference. */
        if (features[i].kind == STATE && g->enabled[i] && chance(g, features[i].weight * 6 / 10))
            emit_feature(g, i);
    }
    for (int draws = integer(g, 1, 7); draws > 0; draws--) {
        if (chance(g, 25))
            random_state(g);
        random_draw(g);
    }
}

/* Features that are not used together, because OSMesa is wrong there: once it has drawn an edge or a corner of a polygon smooth, or
 * has stippled a polygon, it does the same to what follows in the batch, filled polygons and edges. */
static void choose_features(struct generator *g)
{
    memcpy(g->enabled, g->selected, sizeof g->enabled);
    g->enabled[FEATURE_lighting] = g->selected[FEATURE_lighting] && chance(g, 70);
    g->plain_lights = chance(g, 30);
    g->without_shininess = false;
    g->face_of_vertices = GL_FRONT;
    g->largest_shininess = 32.0;
    /* OSMesa gives textured bitmaps coordinates that have nothing to do with the raster position, and copies some pixels without
     * texturing them. */
    if (chance(g, 50))
        g->enabled[FEATURE_texture] = false;
    else
        g->enabled[FEATURE_bitmap] = g->enabled[FEATURE_copy_pixels] = false;
    if (chance(g, 50)) /* which OSMesa does not always heed in feedback */
        g->enabled[FEATURE_texgen] = g->enabled[FEATURE_texture_matrix] = false;
    else
        g->enabled[FEATURE_feedback] = false;
    if (chance(g, 50)) /* with which OSMesa cuts points and lines at the viewport (departure attenuated-points) */
        g->enabled[FEATURE_point_parameter] = false;
    else
        g->enabled[FEATURE_viewport] = false;
    /* OSMesa draws smooth lines and points by the first framebuffer's edge rule (departure smooth-in-framebuffers). */
    if (g->enabled[FEATURE_framebuffer_object] && chance(g, 40))
        g->enabled[FEATURE_framebuffer_object] = false;
    else if (g->enabled[FEATURE_framebuffer_object])
        g->enabled[FEATURE_line_smooth] = g->enabled[FEATURE_point_smooth] = false;
    if (!g->selected[FEATURE_polygon_mode])
        return;
    if (chance(g, 50))
        g->enabled[FEATURE_polygon_mode] = false;
    else
        g->enabled[FEATURE_line_smooth] = g->enabled[FEATURE_point_smooth] = g->enabled[FEATURE_polygon_stipple] = false;
}

/* Mostly bytes with 24 bits of depth. Not OSMESA_RGB, where OSMesa writes beside the pixels. */
static void choose_buffers(struct generator *g)
{
    static const struct buffers others[] = {{OSMESA_BGRA, GL_UNSIGNED_BYTE, 24, 8}, {OSMESA_ARGB, GL_UNSIGNED_BYTE, 24, 0},
                                            {OSMESA_RGBA, GL_UNSIGNED_BYTE, 16, 0},
                                            {OSMESA_RGBA, GL_UNSIGNED_BYTE, 32, 0}, {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, 24, 8},
                                            {OSMESA_RGBA, GL_UNSIGNED_SHORT, 24, 8}, {OSMESA_RGBA, GL_FLOAT, 24, 8}};
    if (g->selected[FEATURE_buffers] && chance(g, 25)) {
        g->used[FEATURE_buffers] = true;
        g->script->buffers = others[below(g, (int)(sizeof others / sizeof others[0]))];
    }
}

static void choose_lighting(struct generator *g)
{
    g->face_of_vertices = ONE_OF(g, GL_FRONT, GL_FRONT_AND_BACK);
    g->largest_shininess = chance(g, 50) ? 32.0 : 128.0;
    if (g->largest_shininess == 128.0) {
        EMIT(g, Enable, GL_NORMALIZE);
        g->enabled[FEATURE_normalize] = false;
    }
    /* Shininess 0 is a named departure where other materials or lights with attenuation are lit with it. */
    g->without_shininess = g->plain_lights && chance(g, 30);
    if (!g->without_shininess)
        EMIT(g, Materialf, GL_FRONT_AND_BACK, GL_SHININESS, real(g, 0.5, g->largest_shininess));
}

void begin_context(struct generator *g)
{
    generate_clear(g);
    if (g->largest_shininess == 128.0)
        EMIT(g, Enable, GL_NORMALIZE);
    if (g->enabled[FEATURE_lighting] && !g->without_shininess)
        EMIT(g, Materialf, GL_FRONT_AND_BACK, GL_SHININESS, real(g, 0.5, g->largest_shininess));
}

void feature_buffers(struct generator *g)
{
    (void)g; /* chosen with the script */
}

void generate(struct generator *g, struct script *script, uint64_t seed)
{
    g->script = script;
    g->random = seed ^ 0x5851f42d4c957f2du;
    g->random = next_random(g); /* else the numbers of a seed would be those of the seed before, moved by one */
    memset(g->used, 0, sizeof g->used);
    g->space = CLIP_SPACE;
    g->grid = 0.0;
    choose_features(g);
    g->color_size = integer(g, 3, 4);
    g->tex_coord_size = integer(g, 1, 4);
    g->depth = 0;
    g->compiling = g->contained = g->executing = g->inside = g->pushed = g->edge_flags = g->steady = g->arrays_set = g->querying =
            g->levels_set = g->drawing_elsewhere = g->other_begun = false;
    g->vertex_lists = g->lists = 0;
    script_clear(script, integer(g, 17, 96), integer(g, 13, 72));
    choose_buffers(g);
    generate_clear(g);
    if (g->enabled[FEATURE_lighting])
        choose_lighting(g);
    if (g->enabled[FEATURE_view])
        emit_feature(g, FEATURE_view);
    for (int scenes = integer(g, 1, 3); scenes > 0; scenes--)
        generate_scene(g);
    if (g->used[FEATURE_accum]) /* else OSMesa may not show what GL_RETURN drew (departure returned-pictures) */
        emit_unseen_point(g);
}
