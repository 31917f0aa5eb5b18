/* Features: framebuffer objects, drawn into and then read, copied or used as textures; a second context that shares lists and objects. */
#include "generator.h"
#include "textures.h"

#include <stdlib.h>
#include <string.h>

enum { FRAMEBUFFERS = 2, COLOR_TEXTURE = 60, DEPTH_TEXTURE = 70, COLOR_RENDERBUFFER = 1, DEPTH_RENDERBUFFER = 5, OBJECTS = 2, MOST_BEYOND = 12 };

struct target {
    int framebuffer, width, height; /* at least as large as the window, for which coordinates are made */
    int texture;                    /* of the color; 0: a renderbuffer */
    bool depth, stencil;
};

static double random_color_format(struct generator *g)
{
    return ONE_OF(g, GL_RGBA, GL_RGBA8, GL_RGBA8, GL_RGB, GL_RGB8, GL_RGB5, GL_RGB5_A1, GL_RGBA4);
}

/* A texture without an image to begin with. */
static void emit_empty_texture(struct generator *g, int name, double internal, double format, double type, const struct target *t)
{
    EMIT(g, BindTexture, GL_TEXTURE_2D, name);
    EMIT(g, TexImage2DOffset, GL_TEXTURE_2D, 0, internal, t->width, t->height, 0, format, type, 0);
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, ONE_OF(g, GL_NEAREST, GL_LINEAR));
    EMIT(g, BindTexture, GL_TEXTURE_2D, 0);
}

static void attach_texture(struct generator *g, double attachment, int name)
{
    EMIT(g, FramebufferTexture2DEXT, GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, name, 0);
}

static void attach_renderbuffer(struct generator *g, double attachment, int name)
{
    EMIT(g, FramebufferRenderbufferEXT, GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
}

static void emit_renderbuffer(struct generator *g, int name, double internal, const struct target *t)
{
    EMIT(g, BindRenderbufferEXT, GL_RENDERBUFFER, name);
    EMIT(g, RenderbufferStorageEXT, GL_RENDERBUFFER, internal, t->width, t->height);
}

static void attach_color(struct generator *g, struct target *t)
{
    const int object = below(g, OBJECTS);
    const double internal = random_color_format(g);
    t->texture = chance(g, 60) && g->enabled[FEATURE_texture] ? COLOR_TEXTURE + object : 0;
    if (t->texture) {
        emit_empty_texture(g, t->texture, internal, GL_RGBA, GL_UNSIGNED_BYTE, t);
        attach_texture(g, GL_COLOR_ATTACHMENT0, t->texture);
    } else {
        emit_renderbuffer(g, COLOR_RENDERBUFFER + object, internal, t);
        attach_renderbuffer(g, GL_COLOR_ATTACHMENT0, COLOR_RENDERBUFFER + object);
    }
}

/* Of depth, of both, or none. */
static void attach_depth(struct generator *g, struct target *t)
{
    const int kind = below(g, 5);
    t->depth = kind > 0;
    t->stencil = kind > 2;
    switch (kind) {
    case 0: attach_renderbuffer(g, GL_DEPTH_ATTACHMENT, 0); break;
    case 1:
        emit_renderbuffer(g, DEPTH_RENDERBUFFER, ONE_OF(g, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24), t);
        attach_renderbuffer(g, GL_DEPTH_ATTACHMENT, DEPTH_RENDERBUFFER);
        break;
    case 2: /* not from GL_UNSIGNED_INT, where OSMesa keeps 32 bits: FixedGL draws with 24 */
        emit_empty_texture(g, DEPTH_TEXTURE, ONE_OF(g, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT24), GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, t);
        attach_texture(g, GL_DEPTH_ATTACHMENT, DEPTH_TEXTURE);
        break;
    case 3:
        emit_renderbuffer(g, DEPTH_RENDERBUFFER + 1, GL_DEPTH24_STENCIL8, t);
        attach_renderbuffer(g, GL_DEPTH_ATTACHMENT, DEPTH_RENDERBUFFER + 1);
        break;
    default:
        emit_empty_texture(g, DEPTH_TEXTURE + 1, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, t);
        attach_texture(g, GL_DEPTH_ATTACHMENT, DEPTH_TEXTURE + 1);
    }
    if (kind == 3)
        attach_renderbuffer(g, GL_STENCIL_ATTACHMENT, DEPTH_RENDERBUFFER + 1);
    else if (kind == 4)
        attach_texture(g, GL_STENCIL_ATTACHMENT, DEPTH_TEXTURE + 1);
    else
        attach_renderbuffer(g, GL_STENCIL_ATTACHMENT, 0);
}

static void emit_drawing(struct generator *g)
{
    for (int n = integer(g, 1, 4); n > 0; n--) {
        if (chance(g, 30))
            random_state(g);
        random_draw(g);
    }
}

static void read_back(struct generator *g, const struct target *t)
{
    EMIT(g, ReadPixels, 0, 0, t->width, t->height, GL_RGBA, GL_UNSIGNED_BYTE);
    if (t->depth && chance(g, 50))
        EMIT(g, ReadPixels, 0, 0, t->width, t->height, GL_DEPTH_COMPONENT, ONE_OF(g, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT));
    if (t->stencil && chance(g, 50))
        EMIT(g, ReadPixels, 0, 0, t->width, t->height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
}

/* Whether the centers of some of d pixels fall between two of s, where rounding decides. */
static bool falls_between(int s, int d)
{
    int a = abs(s), b = abs(d);
    while (b != 0) {
        const int rest = a % b;
        a = b;
        b = rest;
    }
    return a > 0 && s / a % 2 == 0 && d / a % 2 != 0;
}

/* To the window: as it is, turned or scaled. */
static void blit_to_window(struct generator *g, const struct target *t)
{
    const int width = g->script->width, height = g->script->height;
    int from[4] = {below(g, width / 2), below(g, height / 2), integer(g, width / 2, t->width), integer(g, height / 2, t->height)};
    int to[4] = {from[0], from[1], from[2], from[3]};
    EMIT(g, BindFramebufferEXT, GL_READ_FRAMEBUFFER, t->framebuffer);
    EMIT(g, BindFramebufferEXT, GL_DRAW_FRAMEBUFFER, 0);
    if (chance(g, 50)) {
        to[0] = integer(g, -5, width), to[2] = integer(g, -5, width + 5);
        to[1] = integer(g, -5, height), to[3] = integer(g, -5, height + 5);
    }
    if (falls_between(from[2] - from[0], to[2] - to[0]) || falls_between(from[3] - from[1], to[3] - to[1]))
        memcpy(to, from, sizeof to);
    EMIT(g, BlitFramebuffer, from[0], from[1], from[2], from[3], to[0], to[1], to[2], to[3], GL_COLOR_BUFFER_BIT, ONE_OF(g, GL_NEAREST, GL_NEAREST, GL_LINEAR));
}

/* The picture as a texture. */
static void texture_with(struct generator *g, const struct target *t)
{
    EMIT(g, BindTexture, GL_TEXTURE_2D, t->texture);
    if (chance(g, 40)) {
        EMIT(g, GenerateMipmap, GL_TEXTURE_2D);
        EMIT(g, TexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
             ONE_OF(g, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR));
    }
    EMIT(g, Enable, GL_TEXTURE_2D);
    emit_coordinates(g);
    feature_immediate(g);
    EMIT(g, BindTexture, GL_TEXTURE_2D, 0);
}

/* OSMesa turns the stipple over only when it is set (departure turned-stipples). */
static void emit_no_stipple(struct generator *g)
{
    if (g->enabled[FEATURE_polygon_stipple])
        EMIT(g, Disable, GL_POLYGON_STIPPLE);
}

void feature_framebuffer_object(struct generator *g)
{
    if (g->compiling || g->pushed || g->drawing_elsewhere)
        return;
    struct target t = {.framebuffer = 1 + below(g, FRAMEBUFFERS), .width = g->script->width, .height = g->script->height};
    if (chance(g, 50)) {
        t.width += below(g, MOST_BEYOND);
        t.height += below(g, MOST_BEYOND);
    }
    EMIT(g, BindFramebufferEXT, GL_FRAMEBUFFER, t.framebuffer);
    attach_color(g, &t);
    attach_depth(g, &t);
    EMIT(g, CheckFramebufferStatusEXT, GL_FRAMEBUFFER);
    emit_no_stipple(g);
    if (chance(g, 50))
        EMIT(g, Viewport, 0, 0, t.width, t.height);
    EMIT(g, Disable, GL_SCISSOR_TEST);
    EMIT(g, ColorMask, 1, 1, 1, 1);
    EMIT(g, DepthMask, 1);
    EMIT(g, StencilMask, 255);
    EMIT(g, Clear, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    g->drawing_elsewhere = true;
    emit_drawing(g);
    g->drawing_elsewhere = false;
    read_back(g, &t);
    if (chance(g, 50))
        blit_to_window(g, &t);
    EMIT(g, BindFramebufferEXT, GL_FRAMEBUFFER, 0);
    emit_no_stipple(g);
    EMIT(g, Viewport, 0, 0, g->script->width, g->script->height);
    if (t.texture && use(g, FEATURE_texture) && chance(g, 60))
        texture_with(g, &t);
}

/* ---- the other context ---- */

void feature_other_context(struct generator *g)
{
    if (g->compiling || g->pushed || g->drawing_elsewhere || g->querying)
        return;
    const enum space space = g->space;
    const double grid = g->grid;
    const bool arrays_set = g->arrays_set;
    EMIT(g, OtherContext, 1);
    if (!g->other_begun)
        begin_context(g);
    g->space = g->other_begun ? g->other_space : CLIP_SPACE;
    g->grid = 0.0;
    g->arrays_set = false;
    g->drawing_elsewhere = true;
    if (chance(g, 50) && use(g, FEATURE_view))
        feature_view(g);
    emit_drawing(g);
    g->drawing_elsewhere = false;
    g->other_begun = true;
    g->other_space = g->space;
    disable_arrays(g, 100);
    g->space = space;
    g->grid = grid;
    g->arrays_set = arrays_set;
    EMIT(g, OtherContext, 0);
}
