/* Textured quads over the whole window, and images that come and go: what a texel costs. */
#include "scene.h"

enum { QUADS = 20, SIZE = 256, LEVELS = 9, UPLOADS = 8, PASSES = 8 };

struct texturing {
    GLint min_filter, mag_filter;
    GLint environment;
    int units;
    float repeat; /* of the texture across the window: about 2 magnifies, 16 minifies */
};

static void make_texture(const struct texturing *t, const GLubyte *image)
{
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, t->min_filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, t->mag_filter);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, t->environment);
    for (int level = 0; level < LEVELS; level++)
        gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, SIZE >> level, SIZE >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    gl.Enable(GL_TEXTURE_2D);
}

static GLubyte *make_image(void)
{
    unsigned seed = 1;
    GLubyte *image = allocate(SIZE * SIZE, 4);
    for (int i = 0; i < SIZE * SIZE * 4; i++)
        image[i] = (GLubyte)(256 * random_float(&seed));
    return image;
}

static void open(const struct scene *scene, struct instance *instance)
{
    const struct texturing *t = scene->detail;
    instance->image = make_image();
    for (int unit = 0; unit < t->units; unit++) {
        gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        make_texture(t, instance->image);
    }
    gl.ActiveTexture(GL_TEXTURE0);
    gl.Enable(GL_DEPTH_TEST);
}

static void draw(const struct scene *scene, const struct instance *instance)
{
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const struct texturing *t = scene->detail;
    (void)instance;
    gl.Begin(GL_QUADS);
    for (int i = 0; i < QUADS; i++)
        for (int k = 0; k < 4; k++) {
            for (int unit = 0; unit < t->units; unit++)
                gl.MultiTexCoord2f(GL_TEXTURE0 + (GLenum)unit, t->repeat * corner[k][0], (t->repeat + 0.3f) * corner[k][1]);
            gl.Color4f(0.3f + 0.2f * (float)k, 0.5f, 0.8f, 1);
            gl.Vertex3f(corner[k][0], corner[k][1], 0.9f - 0.09f * (float)i);
        }
    gl.End();
}

static void upload(const struct scene *scene, const struct instance *instance)
{
    (void)scene;
    for (int i = 0; i < UPLOADS; i++)
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, instance->image);
}

static void replace_part(const struct scene *scene, const struct instance *instance)
{
    (void)scene;
    for (int i = 0; i < UPLOADS; i++)
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 16, 16, SIZE / 2, SIZE / 2, GL_RGBA, GL_UNSIGNED_BYTE, instance->image);
}

static void copy(const struct scene *scene, const struct instance *instance)
{
    (void)scene, (void)instance;
    for (int i = 0; i < UPLOADS; i++)
        gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 10, 10, SIZE, SIZE);
}

/* A texture to draw into, and a framebuffer object that does. */
static void open_target(const struct scene *scene, struct instance *instance)
{
    GLuint *name = instance->index = allocate(2, sizeof *name);
    open(scene, instance);
    gl.GenTextures(1, &name[0]);
    gl.BindTexture(GL_TEXTURE_2D, name[0]);
    make_texture(scene->detail, instance->image);
    gl.GenFramebuffers(1, &name[1]);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name[1]);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name[0], 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Disable(GL_DEPTH_TEST);
}

static void draw_quad(float size, float repeat)
{
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    gl.Begin(GL_QUADS);
    for (int k = 0; k < 4; k++) {
        gl.Color4f(0.3f + 0.2f * (float)k, 0.5f, 0.8f, 1);
        gl.MultiTexCoord2f(GL_TEXTURE0, repeat * corner[k][0], repeat * corner[k][1]);
        gl.Vertex2f(size * corner[k][0], size * corner[k][1]);
    }
    gl.End();
}

/* Each pass a quad without texture into the texture, and one with it into the window. */
static void render_to_texture(const struct scene *scene, const struct instance *instance)
{
    for (int i = 0; i < PASSES; i++) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, instance->index[1]);
        gl.Viewport(0, 0, SIZE, SIZE);
        gl.Disable(GL_TEXTURE_2D);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        draw_quad(0.9f, 0);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.Viewport(0, 0, scene->size, scene->size);
        gl.Enable(GL_TEXTURE_2D);
        draw_quad(1, 1);
    }
}

#define TEXTURED(name, min, mag, environment, units, repeat) \
    {name, 500, 4, open, draw, &(const struct texturing){min, mag, environment, units, repeat}, false}
#define IMAGES(name, draw) \
    {name, 500, 4, open, draw, &(const struct texturing){GL_LINEAR, GL_LINEAR, GL_MODULATE, 1, 1}, false}
const struct scene texture_scenes[] = {
    TEXTURED("20 quads, texture nearest", GL_NEAREST, GL_NEAREST, GL_MODULATE, 1, 2),
    TEXTURED("20 quads, texture nearest, replace", GL_NEAREST, GL_NEAREST, GL_REPLACE, 1, 2),
    TEXTURED("20 quads, texture linear", GL_LINEAR, GL_LINEAR, GL_MODULATE, 1, 2),
    TEXTURED("20 quads, texture mipmap nearest", GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, GL_MODULATE, 1, 4),
    TEXTURED("20 quads, texture trilinear", GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MODULATE, 1, 4),
    TEXTURED("20 quads, two textures", GL_LINEAR, GL_LINEAR, GL_MODULATE, 2, 2),
    IMAGES("8 texture images 256 x 256", upload),
    IMAGES("8 texture parts 128 x 128", replace_part),
    IMAGES("8 texture copies 256 x 256", copy),
    {"8 times render to texture", 500, 4, open_target, render_to_texture,
     &(const struct texturing){GL_LINEAR, GL_LINEAR, GL_MODULATE, 1, 1}, false},
    {0},
};
