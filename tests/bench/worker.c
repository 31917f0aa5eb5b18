#define _XOPEN_SOURCE 700
#include "worker.h"

#include <dlfcn.h>
#include <fixedgl.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "scene.h"

enum { WARM_UP_FRAMES = 2, DEPTH_BITS = 24, STENCIL_BITS = 8, ACCUM_BITS = 16 };

struct functions gl;

double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void load(const char *path)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL)
        fail("cannot load", dlerror());
    OSMESAproc (*get)(const char *) = (OSMESAproc(*)(const char *))dlsym(library, "OSMesaGetProcAddress");
    *(void **)&gl.CreateContext = dlsym(library, "OSMesaCreateContextExt");
    *(void **)&gl.MakeCurrent = dlsym(library, "OSMesaMakeCurrent");
    *(void **)&gl.Accuracy = dlsym(library, "fixedglAccuracy");
    if (get == NULL || gl.CreateContext == NULL || gl.MakeCurrent == NULL)
        fail("not an OSMesa library", path);
#define LOAD(result, name, parameters)                                                                       \
    gl.name = (result(*) parameters)get("gl" #name);                                                         \
    if (gl.name == NULL)                                                                                     \
        fail("missing function", "gl" #name);
    FOR_EACH_FUNCTION(LOAD)
}

static void draw_frame(const struct scene *scene, const struct instance *instance)
{
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    scene->draw(scene, instance);
    gl.Finish();
}

static void make_current(const struct scene *scene, const struct instance *instance)
{
    if (!gl.MakeCurrent(instance->context, instance->pixels, GL_UNSIGNED_BYTE, scene->size, scene->size))
        fail("OSMesaMakeCurrent failed", scene->name);
}

/* Makes the context of a scene and its meshes, and draws the first frames. */
static void open_scene(const struct scene *scene, struct instance *instance, int frames)
{
    instance->pixels = allocate((size_t)scene->size * (size_t)scene->size, 4);
    instance->context = gl.CreateContext(OSMESA_RGBA, DEPTH_BITS, STENCIL_BITS, ACCUM_BITS, NULL);
    make_current(scene, instance);
    if (scene->exact && gl.Accuracy != NULL)
        gl.Accuracy(FIXEDGL_EXACT);
    scene->open(scene, instance);
    for (int i = 0; i < frames; i++)
        draw_frame(scene, instance);
}

static double time_scene(const struct scene *scene, struct instance *instance)
{
    if (instance->context == NULL)
        open_scene(scene, instance, WARM_UP_FRAMES);
    else
        make_current(scene, instance);
    const double start = now_ms();
    for (int i = 0; i < scene->frames; i++)
        draw_frame(scene, instance);
    const double elapsed = now_ms() - start;
    if (gl.GetError() != GL_NO_ERROR)
        fail("GL error in scene", scene->name);
    return elapsed / scene->frames;
}

void draw_first_frame(const char *library)
{
    static struct instance instance;
    load(library);
    open_scene(scene_at(0), &instance, 1);
}

void work(const char *library, int requests, int answers)
{
    struct instance *instances = allocate((size_t)scene_count(), sizeof *instances);
    char renderer[MAX_RENDERER] = "";
    int index;

    load(library);
    open_scene(scene_at(0), &instances[0], 1);
    snprintf(renderer, sizeof renderer, "%s", (const char *)gl.GetString(GL_RENDERER));
    if (write(answers, renderer, sizeof renderer) != sizeof renderer)
        fail("cannot answer", NULL);
    while (read(requests, &index, sizeof index) == sizeof index) {
        const double ms = time_scene(scene_at(index), &instances[index]);
        if (write(answers, &ms, sizeof ms) != sizeof ms)
            fail("cannot answer", NULL);
    }
    _exit(0);
}
