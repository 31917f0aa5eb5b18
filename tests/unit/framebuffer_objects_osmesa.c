/* Drawing into framebuffer objects against Mesa's OSMesa, whose rows go up there: random primitives and pixel rectangles, then colours, depths and
 * stencils read back: the same bytes. Coordinates lie on pixel centres and corners often, where it shows which edges own them. */
#include "both.h"

#include <GL/gl.h>
#include <GL/glext.h>

enum { WIDTH = 61, HEIGHT = 47, IMAGE_SIDE = 12 };

#define EACH_MORE(F)                                                                                                     \
    F(GenFramebuffers, (GLsizei, GLuint *))                                                                              \
    F(BindFramebuffer, (GLenum, GLuint))                                                                                 \
    F(GenRenderbuffers, (GLsizei, GLuint *))                                                                             \
    F(BindRenderbuffer, (GLenum, GLuint))                                                                                \
    F(RenderbufferStorage, (GLenum, GLenum, GLsizei, GLsizei))                                                           \
    F(FramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint))                                                         \
    F(Viewport, (GLint, GLint, GLsizei, GLsizei))                                                                        \
    F(Scissor, (GLint, GLint, GLsizei, GLsizei))                                                                         \
    F(CullFace, (GLenum))                                                                                                \
    F(DepthFunc, (GLenum))                                                                                               \
    F(StencilFunc, (GLenum, GLint, GLuint))                                                                              \
    F(StencilOp, (GLenum, GLenum, GLenum))                                                                               \
    F(PolygonOffset, (GLfloat, GLfloat))                                                                                 \
    F(PolygonMode, (GLenum, GLenum))                                                                                     \
    F(PolygonStipple, (const GLubyte *))                                                                                 \
    F(LineWidth, (GLfloat))                                                                                              \
    F(PointSize, (GLfloat))                                                                                              \
    F(TexCoord2f, (GLfloat, GLfloat))                                                                                    \
    F(TexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *))                         \
    F(TexParameteri, (GLenum, GLenum, GLint))                                                                            \
    F(TexEnvi, (GLenum, GLenum, GLint))                                                                                  \
    F(WindowPos3f, (GLfloat, GLfloat, GLfloat))                                                                          \
    F(PixelZoom, (GLfloat, GLfloat))                                                                                     \
    F(DrawPixels, (GLsizei, GLsizei, GLenum, GLenum, const void *))                                                      \
    F(CopyPixels, (GLint, GLint, GLsizei, GLsizei, GLenum))                                                              \
    F(Bitmap, (GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte *))                                   \
    F(BlitFramebuffer, (GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum))                     \
    F(ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                                              \
    F(PixelStorei, (GLenum, GLint))

struct more {
#define MEMBER(name, parameters) void(*name) parameters;
    EACH_MORE(MEMBER)
#undef MEMBER
};

struct picture {
    GLubyte color[WIDTH * HEIGHT * 4], stencil[WIDTH * HEIGHT];
    GLuint depth[WIDTH * HEIGHT];
};

struct scene {
    const struct gl *gl;
    struct more more;
    uint32_t seed;
};

static void fill_more(struct more *to, get_proc_fn *get_proc)
{
#define ENTRY(name, parameters) to->name = (void(*) parameters)get_proc("gl" #name);
    EACH_MORE(ENTRY)
#undef ENTRY
}

/* ---- random numbers, the same for both ---- */

static uint32_t next(struct scene *s)
{
    s->seed = s->seed * 1664525u + 1013904223u;
    return s->seed >> 8;
}

static int pick(struct scene *s, int n)
{
    return (int)(next(s) % (uint32_t)n);
}

static float within(struct scene *s, float low, float high)
{
    return low + (high - low) * (float)next(s) / 16777216.0f;
}

/* Three in four on a corner, a centre or an eighth of a pixel. */
static float coordinate(struct scene *s, int size)
{
    switch (pick(s, 4)) {
    case 0: return (float)pick(s, size);
    case 1: return (float)pick(s, size) + 0.5f;
    case 2: return (float)pick(s, 8 * size) / 8.0f;
    default: return within(s, -5.0f, (float)size + 5.0f);
    }
}

static void vertices(struct scene *s, GLenum mode, int n)
{
    s->gl->Begin(mode);
    for (int i = 0; i < n; i++) {
        const float w = pick(s, 2) ? 1.0f : within(s, 0.5f, 2.0f), x = coordinate(s, WIDTH), y = coordinate(s, HEIGHT);
        const GLfloat color[4] = {within(s, 0, 1), within(s, 0, 1), within(s, 0, 1), within(s, 0, 1)};
        const GLfloat position[4] = {x * w, y * w, within(s, -1.1f, 1.1f) * w, w};
        s->gl->Color4fv(color);
        s->more.TexCoord2f(within(s, -1, 2), within(s, -1, 2));
        s->gl->Vertex4fv(position);
    }
    s->gl->End();
}

/* ---- what is drawn ---- */

static void triangles(struct scene *s)
{
    static const GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
    vertices(s, modes[pick(s, 3)], 9);
}

static void small_triangles(struct scene *s)
{
    s->gl->Begin(GL_TRIANGLES);
    for (int i = 0; i < 60; i++) {
        const float x = coordinate(s, WIDTH), y = coordinate(s, HEIGHT);
        for (int k = 0; k < 3; k++) {
            const GLfloat position[4] = {x + (float)(pick(s, 17) - 8) / 4.0f, y + (float)(pick(s, 17) - 8) / 4.0f, within(s, -1, 1), 1};
            s->gl->Vertex4fv(position);
        }
    }
    s->gl->End();
}

static void offset_triangles(struct scene *s)
{
    s->gl->Enable(GL_POLYGON_OFFSET_FILL);
    s->more.PolygonOffset(within(s, -3, 3), within(s, -5, 5));
    triangles(s);
    s->gl->Disable(GL_POLYGON_OFFSET_FILL);
}

static void stippled_triangles(struct scene *s)
{
    GLubyte stipple[128];
    for (int i = 0; i < 128; i++)
        stipple[i] = (GLubyte)next(s);
    s->more.PolygonStipple(stipple);
    s->gl->Enable(GL_POLYGON_STIPPLE);
    triangles(s);
    s->gl->Disable(GL_POLYGON_STIPPLE);
}

static void polygon_modes(struct scene *s)
{
    s->more.PolygonMode(GL_FRONT, (GLenum)(GL_POINT + pick(s, 3)));
    s->more.PolygonMode(GL_BACK, (GLenum)(GL_POINT + pick(s, 3)));
    triangles(s);
    s->more.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

static void textured_triangles(struct scene *s)
{
    s->gl->Enable(GL_TEXTURE_2D);
    triangles(s);
    s->gl->Disable(GL_TEXTURE_2D);
}

static void lines(struct scene *s)
{
    s->more.LineWidth(pick(s, 2) ? 1.0f : within(s, 1, 6));
    vertices(s, pick(s, 2) ? GL_LINES : GL_LINE_STRIP, 8);
}

static void points(struct scene *s)
{
    s->more.PointSize(pick(s, 2) ? (float)(1 + pick(s, 6)) : within(s, 0.5f, 9));
    vertices(s, GL_POINTS, 8);
}

static void sprites(struct scene *s)
{
    s->more.PointSize(within(s, 1, 15));
    s->gl->Enable(GL_POINT_SPRITE_ARB);
    s->more.TexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 1);
    s->gl->Enable(GL_TEXTURE_2D);
    vertices(s, GL_POINTS, 5);
    s->gl->Disable(GL_TEXTURE_2D);
    s->gl->Disable(GL_POINT_SPRITE_ARB);
}

static void place_pixels(struct scene *s)
{
    static const float zooms[] = {1, -1, 0.5f, 2, 1.5f, -1.7f, 3.1f};
    const float zoom_x = zooms[pick(s, 7)], zoom_y = zooms[pick(s, 7)];
    s->more.PixelZoom(zoom_x, zoom_y);
    s->more.WindowPos3f(coordinate(s, WIDTH), coordinate(s, HEIGHT), within(s, 0, 1));
}

static void pixels(struct scene *s)
{
    GLubyte image[IMAGE_SIDE * IMAGE_SIDE * 4];
    GLfloat depths[IMAGE_SIDE * IMAGE_SIDE];
    for (int i = 0; i < IMAGE_SIDE * IMAGE_SIDE * 4; i++)
        image[i] = (GLubyte)next(s);
    for (int i = 0; i < IMAGE_SIDE * IMAGE_SIDE; i++)
        depths[i] = within(s, 0, 1);
    place_pixels(s);
    s->more.DrawPixels(IMAGE_SIDE, IMAGE_SIDE - 1, GL_RGBA, GL_UNSIGNED_BYTE, image);
    place_pixels(s);
    s->more.DrawPixels(IMAGE_SIDE, IMAGE_SIDE - 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
}

static void copies(struct scene *s)
{
    static const GLenum types[] = {GL_COLOR, GL_DEPTH, GL_STENCIL};
    const int x = pick(s, WIDTH - 20), y = pick(s, HEIGHT - 20);
    place_pixels(s);
    s->more.CopyPixels(x, y, 19, 13, types[pick(s, 3)]);
}

/* From the left half to the right one: what overlaps is undefined. */
static void blits(struct scene *s)
{
    const int x = pick(s, 15), y = pick(s, 30), to_x = 30 + pick(s, 15), to_y = pick(s, 30), turned = pick(s, 2);
    s->more.BlitFramebuffer(x, y, x + 15, y + 11, to_x, turned ? to_y + 11 : to_y, to_x + 15, turned ? to_y : to_y + 11,
                            GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
}

static void bitmaps(struct scene *s)
{
    GLubyte bits[32];
    for (int i = 0; i < 32; i++)
        bits[i] = (GLubyte)next(s);
    s->more.WindowPos3f(coordinate(s, WIDTH), coordinate(s, HEIGHT), within(s, 0, 1));
    s->more.Bitmap(16, 16, within(s, -2, 2), within(s, -2, 2), 0, 0, bits);
    s->gl->Finish(); /* OSMesa draws bitmaps late, with later state */
}

/* ---- scenes ---- */

static void choose_state(struct scene *s)
{
    static const GLenum tests[] = {GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST};
    static const int one_in[] = {2, 6, 5, 3};
    for (int i = 0; i < 4; i++)
        pick(s, one_in[i]) == 0 ? s->gl->Enable(tests[i]) : s->gl->Disable(tests[i]);
    s->more.Scissor(pick(s, 30), pick(s, 30), 10 + pick(s, 40), 10 + pick(s, 40));
    s->more.CullFace(pick(s, 2) ? GL_FRONT : GL_BACK);
    s->more.DepthFunc(pick(s, 2) ? GL_LEQUAL : GL_ALWAYS);
    s->more.StencilFunc(GL_ALWAYS, pick(s, 256), 255);
    s->more.StencilOp(GL_KEEP, GL_INCR, GL_REPLACE);
    s->gl->ShadeModel(pick(s, 4) ? GL_SMOOTH : GL_FLAT);
}

static void make_framebuffer(struct scene *s)
{
    GLuint framebuffer, renderbuffer[2];
    s->more.GenFramebuffers(1, &framebuffer);
    s->more.GenRenderbuffers(2, renderbuffer);
    s->more.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (int i = 0; i < 2; i++) {
        s->more.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer[i]);
        s->more.RenderbufferStorage(GL_RENDERBUFFER, i ? GL_DEPTH24_STENCIL8 : GL_RGBA8, WIDTH, HEIGHT);
        s->more.FramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_STENCIL_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                        renderbuffer[i]);
    }
}

static void make_texture(struct scene *s)
{
    GLubyte texels[8 * 8 * 4];
    for (int i = 0; i < 8 * 8 * 4; i++)
        texels[i] = (GLubyte)next(s);
    s->more.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    s->more.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
}

static void draw(struct scene *s, struct picture *picture)
{
    static void (*const drawn[])(struct scene *) = {triangles, small_triangles, offset_triangles, stippled_triangles, polygon_modes,
                                                    textured_triangles, lines, points, sprites, pixels, copies, blits, bitmaps};
    make_framebuffer(s);
    make_texture(s);
    s->more.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    s->more.PixelStorei(GL_PACK_ALIGNMENT, 1);
    s->more.Viewport(0, 0, WIDTH, HEIGHT);
    s->gl->MatrixMode(GL_PROJECTION);
    s->gl->Ortho(0, WIDTH, 0, HEIGHT, -1, 1);
    s->gl->ClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    s->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    for (int i = 0; i < 4; i++) {
        choose_state(s);
        drawn[pick(s, (int)(sizeof drawn / sizeof *drawn))](s);
    }
    s->more.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, picture->color);
    s->more.ReadPixels(0, 0, WIDTH, HEIGHT, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, picture->depth);
    s->more.ReadPixels(0, 0, WIDTH, HEIGHT, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, picture->stencil);
}

static void draw_with(struct gl *gl, get_proc_fn *get_proc, uint32_t seed, struct picture *picture)
{
    struct scene s = {.gl = gl, .seed = seed};
    memset(picture, 0, sizeof *picture);
    fill_more(&s.more, get_proc);
    begin_context(gl);
    draw(&s, picture);
    end_context(gl);
}

static void pictures_are_alike(void **state)
{
    static struct picture ours, theirs;
    (void)state;
    void *library = have_osmesa ? dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL) : NULL;
    for (int seed = 1; seed <= sets(60); seed++) {
        draw_with(&fixedgl, OSMesaGetProcAddress, (uint32_t)seed * 2654435761u, &ours);
        if (!library)
            continue;
        draw_with(&osmesa, (get_proc_fn *)dlsym(library, "OSMesaGetProcAddress"), (uint32_t)seed * 2654435761u, &theirs);
        if (memcmp(ours.color, theirs.color, sizeof ours.color) != 0)
            fail_msg("seed %d: colours differ", seed);
        if (memcmp(ours.depth, theirs.depth, sizeof ours.depth) != 0)
            fail_msg("seed %d: depths differ", seed);
        if (memcmp(ours.stencil, theirs.stencil, sizeof ours.stencil) != 0)
            fail_msg("seed %d: stencils differ", seed);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_alike)};
    return cmocka_run_group_tests(tests, load_both, NULL);
}
