/*
 * Times scenes on two OSMesa libraries, side by side.
 *
 *   bench FIXEDGL_LIB OSMESA_LIB        paths or sonames
 *
 * Each library lives in a worker process of its own, which loads it with dlopen and keeps one context per
 * scene. The driver asks the two in turn, scene by scene, so that both meet the same noise of the machine,
 * and prints the medians over the rounds. A frame is clear, draw and glFinish. Start-up is from fork to the
 * first finished frame of a fresh process. Nothing here passes or fails by time: the exit status is 1 only if
 * something does not run.
 */
#define _XOPEN_SOURCE 700
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <fixedgl.h>

enum { ROUNDS = 7, WARM_UP_FRAMES = 2, TRIANGLES = 300, LIBRARIES = 2, MAX_RENDERER = 80 };

/* The functions of GL that the scenes call; nothing is linked. */
#define FOR_EACH_FUNCTION(F)                                                                                 \
    F(void, Begin, (GLenum))                                                                                 \
    F(void, Clear, (GLbitfield))                                                                             \
    F(void, Color3fv, (const GLfloat *))                                                                     \
    F(void, CullFace, (GLenum))                                                                              \
    F(void, DrawElements, (GLenum, GLsizei, GLenum, const GLvoid *))                                         \
    F(void, Enable, (GLenum))                                                                                \
    F(void, EnableClientState, (GLenum))                                                                     \
    F(void, End, (void))                                                                                     \
    F(void, Finish, (void))                                                                                  \
    F(GLenum, GetError, (void))                                                                              \
    F(const GLubyte *, GetString, (GLenum))                                                                  \
    F(void, Lightf, (GLenum, GLenum, GLfloat))                                                               \
    F(void, Lightfv, (GLenum, GLenum, const GLfloat *))                                                      \
    F(void, LightModeli, (GLenum, GLint))                                                                    \
    F(void, Materialf, (GLenum, GLenum, GLfloat))                                                            \
    F(void, Materialfv, (GLenum, GLenum, const GLfloat *))                                                   \
    F(void, MatrixMode, (GLenum))                                                                            \
    F(void, Normal3fv, (const GLfloat *))                                                                    \
    F(void, NormalPointer, (GLenum, GLsizei, const GLvoid *))                                                \
    F(void, Ortho, (GLdouble, GLdouble, GLdouble, GLdouble, GLdouble, GLdouble))                             \
    F(void, Translatef, (GLfloat, GLfloat, GLfloat))                                                         \
    F(void, Vertex3fv, (const GLfloat *))                                                                    \
    F(void, VertexPointer, (GLint, GLenum, GLsizei, const GLvoid *))

#define DECLARE(result, name, parameters) result(*name) parameters;
static struct {
    FOR_EACH_FUNCTION(DECLARE)
    OSMesaContext (*CreateContext)(GLenum, GLint, GLint, GLint, OSMesaContext);
    GLboolean (*MakeCurrent)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
    GLenum (*Accuracy)(GLenum); /* NULL but in FixedGL */
} gl;

enum content { SPHERE, TRIANGLE_SOUP };
enum lighting { UNLIT, SHINY, DIRECTIONAL, POSITIONAL, EIGHT };

static const struct scene {
    const char *name;
    enum content content;
    enum lighting lighting;
    bool arrays, culled;
    int size;           /* of the square window */
    int slices, stacks; /* of the sphere */
    int frames;         /* per round */
    bool exact;         /* FixedGL in exact mode */
} scenes[] = {
        {"light: sphere 20x16, 500x500", SPHERE, SHINY, true, false, 500, 20, 16, 50, false},
        {"sphere 500x250, 1 directional, immediate", SPHERE, DIRECTIONAL, false, false, 500, 500, 250, 4, false},
        {"sphere 500x250, 1 directional, arrays", SPHERE, DIRECTIONAL, true, false, 500, 500, 250, 4, false},
        {"sphere 500x250, 1 positional, immediate", SPHERE, POSITIONAL, false, false, 500, 500, 250, 4, false},
        {"sphere 500x250, 1 positional, arrays", SPHERE, POSITIONAL, true, false, 500, 500, 250, 4, false},
        {"sphere 500x250, 8 positional, immediate", SPHERE, EIGHT, false, false, 500, 500, 250, 4, false},
        {"sphere 500x250, 8 positional, arrays", SPHERE, EIGHT, true, false, 500, 500, 250, 4, false},
        {"all culled: 1 directional, immediate", SPHERE, DIRECTIONAL, false, true, 500, 500, 250, 4, false},
        {"all culled: 1 directional, arrays", SPHERE, DIRECTIONAL, true, true, 500, 500, 250, 4, false},
        {"all culled: 1 positional, immediate", SPHERE, POSITIONAL, false, true, 500, 500, 250, 4, false},
        {"all culled: 1 positional, arrays", SPHERE, POSITIONAL, true, true, 500, 500, 250, 4, false},
        {"all culled: 8 positional, immediate", SPHERE, EIGHT, false, true, 500, 500, 250, 4, false},
        {"all culled: 8 positional, arrays", SPHERE, EIGHT, true, true, 500, 500, 250, 4, false},
        {"lit vertices, 1 light, compatible", SPHERE, SHINY, true, false, 64, 500, 250, 4, false},
        {"lit vertices, 1 light, exact", SPHERE, SHINY, true, false, 64, 500, 250, 4, true},
        {"lit vertices, 8 lights, compatible", SPHERE, EIGHT, true, false, 64, 500, 250, 4, false},
        {"lit vertices, 8 lights, exact", SPHERE, EIGHT, true, false, 64, 500, 250, 4, true},
        {"300 smooth triangles, 1024x1024", TRIANGLE_SOUP, UNLIT, false, false, 1024, 0, 0, 4, false},
        {"300 smooth triangles, 1024x1024, exact", TRIANGLE_SOUP, UNLIT, false, false, 1024, 0, 0, 4, true},
};

enum { SCENES = sizeof scenes / sizeof scenes[0], START_UP = SCENES, MEASURED };

/* What a worker keeps for a scene between rounds. */
static struct instance {
    OSMesaContext context;
    void *pixels;
    float (*position)[3]; /* of the sphere also its normals, since it is a unit sphere */
    float (*color)[3];
    GLuint *index; /* per stack one strip of 2 (slices + 1) */
} instances[SCENES];

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void fail(const char *what, const char *detail)
{
    fprintf(stderr, "bench: %s%s%s\n", what, detail ? ": " : "", detail ? detail : "");
    exit(1);
}

static void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (memory == NULL)
        fail("out of memory", NULL);
    return memory;
}

/* ---- the worker ---- */

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

static void build_sphere(const struct scene *scene, struct instance *instance)
{
    const int row = scene->slices + 1;
    int n = 0;

    instance->position = allocate((size_t)row * (size_t)(scene->stacks + 1), sizeof *instance->position);
    instance->index = allocate(2 * (size_t)row * (size_t)scene->stacks, sizeof *instance->index);
    for (int i = 0; i <= scene->stacks; i++)
        for (int j = 0; j < row; j++) {
            const double latitude = M_PI * i / scene->stacks, longitude = 2 * M_PI * j / scene->slices;
            float *p = instance->position[i * row + j];
            p[0] = (float)(sin(latitude) * cos(longitude));
            p[1] = (float)cos(latitude);
            p[2] = (float)(-sin(latitude) * sin(longitude));
        }
    for (int i = 0; i < scene->stacks; i++)
        for (int j = 0; j < row; j++) {
            instance->index[n++] = (GLuint)(i * row + j);
            instance->index[n++] = (GLuint)((i + 1) * row + j);
        }
}

static void build_triangles(struct instance *instance)
{
    unsigned random = 1;

    instance->position = allocate(3 * TRIANGLES, sizeof *instance->position);
    instance->color = allocate(3 * TRIANGLES, sizeof *instance->color);
    for (int i = 0; i < 6 * 3 * TRIANGLES; i++) {
        random = random * 1664525u + 1013904223u;
        const float value = (float)(random >> 8) / (1 << 24);
        if (i % 6 < 3)
            instance->position[i / 6][i % 6] = 3 * value - 1.5f;
        else
            instance->color[i / 6][i % 6 - 3] = value;
    }
}

static void set_lighting(enum lighting lighting)
{
    const int count = lighting == EIGHT ? 8 : 1;

    gl.Enable(GL_LIGHTING);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting == EIGHT);
    if (lighting == SHINY || lighting == EIGHT) {
        gl.Materialfv(GL_FRONT, GL_SPECULAR, (float[]){1, 1, 1, 1});
        gl.Materialf(GL_FRONT, GL_SHININESS, 50);
    }
    for (int i = 0; i < count; i++) {
        const GLenum light = GL_LIGHT0 + (GLenum)i;
        const float w = lighting == POSITIONAL || lighting == EIGHT ? 1 : 0;
        gl.Enable(light);
        gl.Lightfv(light, GL_POSITION, (float[]){1.5f - 0.4f * (float)i, 1, w == 0 ? 1 : -1.5f, w});
        if (lighting != EIGHT)
            continue;
        gl.Lightfv(light, GL_DIFFUSE, (float[]){0.2f, 0.1f + 0.02f * (float)i, 0.15f, 1});
        gl.Lightfv(light, GL_SPECULAR, (float[]){0.3f, 0.3f, 0.3f, 1});
        gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.1f);
        gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.05f);
    }
}

static void draw_sphere(const struct scene *scene, const struct instance *instance)
{
    const int length = 2 * (scene->slices + 1);

    for (int i = 0; i < scene->stacks; i++) {
        const GLuint *strip = instance->index + i * length;
        if (scene->arrays) {
            gl.DrawElements(GL_TRIANGLE_STRIP, length, GL_UNSIGNED_INT, strip);
            continue;
        }
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int j = 0; j < length; j++) {
            gl.Normal3fv(instance->position[strip[j]]);
            gl.Vertex3fv(instance->position[strip[j]]);
        }
        gl.End();
    }
}

static void draw_triangles(const struct instance *instance)
{
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        gl.Color3fv(instance->color[i]);
        gl.Vertex3fv(instance->position[i]);
    }
    gl.End();
}

static void draw_frame(const struct scene *scene, const struct instance *instance)
{
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (scene->content == SPHERE)
        draw_sphere(scene, instance);
    else
        draw_triangles(instance);
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
    instance->context = gl.CreateContext(OSMESA_RGBA, 24, 8, 0, NULL);
    make_current(scene, instance);
    if (scene->exact && gl.Accuracy != NULL)
        gl.Accuracy(FIXEDGL_EXACT);
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(-1.5, 1.5, -1.5, 1.5, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    if (scene->lighting != UNLIT)
        set_lighting(scene->lighting); /* in eye space */
    gl.Translatef(0, 0, -4);
    gl.Enable(GL_DEPTH_TEST);
    gl.CullFace(GL_FRONT_AND_BACK);
    if (scene->culled)
        gl.Enable(GL_CULL_FACE);
    if (scene->content == SPHERE)
        build_sphere(scene, instance);
    else
        build_triangles(instance);
    if (scene->arrays) {
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.EnableClientState(GL_NORMAL_ARRAY);
        gl.VertexPointer(3, GL_FLOAT, 0, instance->position);
        gl.NormalPointer(GL_FLOAT, 0, instance->position);
    }
    for (int i = 0; i < frames; i++)
        draw_frame(scene, instance);
}

/* Milliseconds per frame. */
static double time_scene(int index)
{
    const struct scene *scene = &scenes[index];
    struct instance *instance = &instances[index];

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

/* Sends the renderer's name, then for each index that is asked the time of that scene. */
static void work(const char *path, int requests, int answers)
{
    char renderer[MAX_RENDERER] = "";
    int index;

    load(path);
    open_scene(&scenes[0], &instances[0], 1);
    snprintf(renderer, sizeof renderer, "%s", (const char *)gl.GetString(GL_RENDERER));
    if (write(answers, renderer, sizeof renderer) != sizeof renderer)
        fail("cannot answer", NULL);
    while (read(requests, &index, sizeof index) == sizeof index) {
        const double ms = time_scene(index);
        if (write(answers, &ms, sizeof ms) != sizeof ms)
            fail("cannot answer", NULL);
    }
    _exit(0);
}

/* ---- the driver ---- */

static struct library {
    const char *label, *path;
    char renderer[MAX_RENDERER];
    int requests, answers; /* pipes to and from its worker */
    double ms[MEASURED][ROUNDS];
} libraries[LIBRARIES] = {{.label = "FixedGL"}, {.label = "OSMesa"}};

static void start_worker(struct library *library)
{
    int down[2], up[2];

    if (pipe(down) != 0 || pipe(up) != 0)
        fail("cannot make a pipe", NULL);
    const pid_t child = fork();
    if (child < 0)
        fail("cannot fork", NULL);
    if (child == 0) {
        close(down[1]);
        close(up[0]);
        work(library->path, down[0], up[1]);
    }
    close(down[0]);
    close(up[1]);
    library->requests = down[1];
    library->answers = up[0];
    if (read(library->answers, library->renderer, MAX_RENDERER) != MAX_RENDERER)
        fail("no picture from", library->path);
}

static double ask_worker(const struct library *library, int index)
{
    double ms = 0;
    if (write(library->requests, &index, sizeof index) != sizeof index ||
        read(library->answers, &ms, sizeof ms) != sizeof ms)
        fail(scenes[index].name, library->path);
    return ms;
}

/* A fresh process draws one frame of the first scene and then writes one byte to its standard output. */
static double time_start_up(const struct library *library, const char *program)
{
    int up[2];
    char byte;

    if (pipe(up) != 0)
        fail("cannot make a pipe", NULL);
    const double start = now_ms();
    const pid_t child = fork();
    if (child == 0) {
        dup2(up[1], STDOUT_FILENO);
        execlp(program, program, "--first-frame", library->path, (char *)NULL);
        _exit(1);
    }
    close(up[1]);
    if (child < 0 || read(up[0], &byte, 1) != 1)
        fail("no first frame from", library->path);
    const double elapsed = now_ms() - start;
    close(up[0]);
    waitpid(child, NULL, 0);
    return elapsed;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double values[ROUNDS])
{
    double sorted[ROUNDS];
    memcpy(sorted, values, sizeof sorted);
    qsort(sorted, ROUNDS, sizeof sorted[0], compare_doubles);
    return sorted[ROUNDS / 2];
}

static void measure(const char *program)
{
    const bool terminal = isatty(STDERR_FILENO);

    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < MEASURED; i++) {
            if (terminal)
                fprintf(stderr, "\rround %d of %d, scene %2d of %d", round + 1, ROUNDS, i + 1, MEASURED);
            else if (i == 0)
                fprintf(stderr, "round %d of %d\n", round + 1, ROUNDS);
            for (int k = 0; k < LIBRARIES; k++) {
                struct library *library = &libraries[(round + k) % LIBRARIES];
                library->ms[i][round] =
                        i == START_UP ? time_start_up(library, program) : ask_worker(library, i);
            }
        }
    if (terminal)
        fprintf(stderr, "\r%40s\r", "");
}

static void print_table(void)
{
    for (int k = 0; k < LIBRARIES; k++)
        printf("%-8s %s (%s)\n", libraries[k].label, libraries[k].path, libraries[k].renderer);
    printf("\nmilliseconds per frame, medians of %d rounds\n", ROUNDS);
    printf("%-44s %9s %9s %7s\n", "", "FixedGL", "OSMesa", "ratio");
    for (int i = 0; i < MEASURED; i++) {
        double ratio[ROUNDS];
        for (int round = 0; round < ROUNDS; round++)
            ratio[round] = libraries[0].ms[i][round] / libraries[1].ms[i][round];
        printf("%-44s %9.3f %9.3f %7.2f\n", i == START_UP ? "start-up to the first frame" : scenes[i].name,
               median(libraries[0].ms[i]), median(libraries[1].ms[i]), median(ratio));
    }
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "--first-frame") == 0) {
        load(argv[2]);
        open_scene(&scenes[0], &instances[0], 1);
        return write(STDOUT_FILENO, "", 1) != 1;
    }
    if (argc != 3)
        fail("usage", "bench FIXEDGL_LIB OSMESA_LIB");
    for (int k = 0; k < LIBRARIES; k++) {
        libraries[k].path = argv[k + 1];
        start_worker(&libraries[k]);
    }
    measure(argv[0]);
    print_table();
    return 0;
}
