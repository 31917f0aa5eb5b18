/*
 * Draws every scene and compares colors and depth, byte for byte, with what Mesa's OSMesa draws: this program
 * again, with OSMesa in the library's place; or, where there is no OSMesa, the goldens recorded from it. A
 * missing golden is a failure in either case. Of a scene that differs, build/scenes has three pictures,
 * colors above, depth below: what was drawn, what was expected, and white pixels where they differ.
 *
 *     scenes                 a test per scene
 *     scenes --record        writes the goldens, from OSMesa only
 *     scenes --raw FILE      writes the pictures of whichever library it runs on
 *
 * Environment: OSMESA, another library than libOSMesa.so.8 for it; BUILD, another folder than build.
 */
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include <GL/osmesa.h>

#include "../../src/cli/child.h"
#include "../../src/cli/library.h"
#include "../../src/cli/pngfile.h"
#include "scenes/scene.h"

enum { PIXELS = SCENE_SIZE * SCENE_SIZE, MOST_SCENES = 256 };

static const char goldens[] = "tests/scenes/goldens";

/* As in the PNG: colors, then depth as 24 bits of red, green, blue; top row first. */
struct picture {
    uint8_t rgba[2 * PIXELS][4];
};

struct pictures {
    char version[128]; /* GL_RENDERER and GL_VERSION of who drew them */
    struct picture scene[MOST_SCENES];
};

static const struct scene *scenes[MOST_SCENES];
static int scene_count;
static struct pictures reference, drawn;

static void collect(void)
{
    static const struct scene *const groups[] = {
            scenes_of_primitives, scenes_of_clipping,  scenes_of_rasterization, scenes_of_matrices,
            scenes_of_lights,     scenes_of_materials, scenes_of_arrays,        scenes_of_lists,
            scenes_of_textures,
    };
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++)
        for (const struct scene *scene = groups[i]; scene->name != NULL && scene_count < MOST_SCENES; scene++)
            scenes[scene_count++] = scene;
}

/* ---- drawing ---- */

static void pack(OSMesaContext context, const uint8_t (*buffer)[4], struct picture *picture)
{
    GLint width = 0, height = 0, bytes = 0;
    void *depth = NULL;
    OSMesaGetDepthBuffer(context, &width, &height, &bytes, &depth);
    for (int i = 0; i < PIXELS; i++) {
        const int from = (SCENE_SIZE - 1 - i / SCENE_SIZE) * SCENE_SIZE + i % SCENE_SIZE;
        const uint32_t z = depth != NULL ? ((const uint32_t *)depth)[from] : 0;
        memcpy(picture->rgba[i], buffer[from], 4);
        const uint8_t packed[4] = {(uint8_t)(z >> 16), (uint8_t)(z >> 8), (uint8_t)z, 255};
        memcpy(picture->rgba[PIXELS + i], packed, 4);
    }
}

static bool draw(const struct scene *scene, struct picture *picture)
{
    static uint8_t buffer[PIXELS][4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, SCENE_SIZE, SCENE_SIZE))
        return false;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    scene->draw();
    glFinish();
    pack(context, (const uint8_t(*)[4])buffer, picture);
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR)
        fprintf(stderr, "%s: GL error 0x%x\n", scene->name, error);
    OSMesaDestroyContext(context);
    return error == GL_NO_ERROR;
}

/* Asks once a context is current. */
static void name_library(char version[128])
{
    uint8_t pixel[4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (context && OSMesaMakeCurrent(context, pixel, GL_UNSIGNED_BYTE, 1, 1))
        snprintf(version, 128, "%s, %s", (const char *)glGetString(GL_RENDERER),
                 (const char *)glGetString(GL_VERSION));
    OSMesaDestroyContext(context);
}

static int write_raw(const char *path)
{
    name_library(drawn.version);
    for (int i = 0; i < scene_count; i++)
        if (!draw(scenes[i], &drawn.scene[i]))
            return 1;
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        return 1;
    const bool good = fwrite(&drawn, sizeof drawn, 1, file) == 1;
    return fclose(file) == 0 && good ? 0 : 1;
}

/* ---- the reference ---- */

static const char *build_folder(void)
{
    const char *folder = getenv("BUILD");
    return folder != NULL ? folder : "build";
}

static bool read_raw(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return false;
    const bool good = fread(&reference, sizeof reference, 1, file) == 1;
    fclose(file);
    return good && strstr(reference.version, "Mesa") != NULL; /* else the loader found no OSMesa */
}

/* Lets OSMesa draw all scenes. False if there is none, or where it would draw other pictures than elsewhere.
 */
static bool ask_osmesa(char *program, struct problem *problem)
{
    if (!fgl_cpu_has_fma())
        return fgl_problem_set(problem, "this CPU has no FMA");
    char *folder = fgl_format("%s/scenes", build_folder()), *raw = fgl_format("%s/osmesa.raw", folder),
         *log = fgl_format("%s/osmesa.log", folder);
    const char *osmesa = getenv("OSMESA") != NULL ? getenv("OSMESA") : "libOSMesa.so.8";
    char *preload = fgl_format("LD_PRELOAD=%s", osmesa);
    const char *const set[] = {preload, "MESA_SHADER_CACHE_DISABLE=true",
                               "ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0", NULL};
    char *argv[] = {program, "--raw", raw, NULL};
    const struct child child = {argv, set, log, log, 60};
    const bool good = fgl_make_folder(folder, problem) && fgl_child_run(&child, problem) &&
                      (read_raw(raw) || fgl_problem_set(problem, "there is no %s", osmesa));
    free(preload);
    free(folder);
    free(raw);
    free(log);
    return good;
}

static char *golden_path(int scene)
{
    return fgl_format("%s/%s.png", goldens, scenes[scene]->name);
}

static bool read_golden(int scene, struct picture *picture)
{
    struct problem problem;
    char *path = golden_path(scene);
    int width = 0, height = 0;
    uint8_t *bytes = fgl_pngfile_read(path, 4, &width, &height, &problem);
    free(path);
    const bool good = bytes != NULL && width == SCENE_SIZE && height == 2 * SCENE_SIZE;
    if (good)
        memcpy(picture->rgba, bytes, sizeof picture->rgba);
    else
        print_error("golden missing: %s\n", bytes != NULL ? "of another size" : problem.text);
    free(bytes);
    return good;
}

static int record(char *program)
{
    struct problem problem;
    bool good = ask_osmesa(program, &problem) && fgl_make_folder(goldens, &problem);
    const struct png_fact facts[] = {{"Recorded from", reference.version}, {NULL, NULL}};
    for (int i = 0; good && i < scene_count; i++) {
        char *path = golden_path(i);
        good = fgl_pngfile_write(path, SCENE_SIZE, 2 * SCENE_SIZE, 4, reference.scene[i].rgba[0], facts,
                                 &problem);
        free(path);
    }
    if (!good)
        return fgl_complain("%s", problem.text);
    printf("%d goldens recorded from %s\n", scene_count, reference.version);
    return 0;
}

/* ---- comparing ---- */

static void write_picture(const char *scene, const char *what, const struct picture *picture)
{
    struct problem problem;
    char *folder = fgl_format("%s/scenes", build_folder());
    char *path = fgl_format("%s/%s.%s.png", folder, scene, what);
    if (!fgl_make_folder(folder, &problem) ||
        !fgl_pngfile_write(path, SCENE_SIZE, 2 * SCENE_SIZE, 4, picture->rgba[0], NULL, &problem))
        print_error("%s\n", problem.text);
    free(path);
    free(folder);
}

static void report(const char *scene, const struct picture *actual, const struct picture *expected)
{
    static struct picture difference;
    int first = -1, count[2] = {0, 0};
    for (int i = 0; i < 2 * PIXELS; i++) {
        const bool differs = memcmp(actual->rgba[i], expected->rgba[i], 4) != 0;
        memset(difference.rgba[i], differs ? 255 : 0, 3);
        difference.rgba[i][3] = 255;
        count[i >= PIXELS] += differs;
        if (differs && first < 0)
            first = i;
    }
    const uint8_t *a = actual->rgba[first], *e = expected->rgba[first];
    const int y = SCENE_SIZE - 1 - first % PIXELS / SCENE_SIZE;
    print_error("%d pixels differ in color, %d in depth; the first in %s at (%d, %d), y up: "
                "%02x%02x%02x%02x instead of %02x%02x%02x%02x\n",
                count[0], count[1], first < PIXELS ? "color" : "depth", first % SCENE_SIZE, y, a[0], a[1],
                a[2], a[3], e[0], e[1], e[2], e[3]);
    write_picture(scene, "actual", actual);
    write_picture(scene, "expected", expected);
    write_picture(scene, "difference", &difference);
}

static void test_scene(void **state)
{
    const int i = *(const int *)*state;
    struct picture golden;
    assert_true(read_golden(i, &golden));
    assert_true(draw(scenes[i], &drawn.scene[i]));
    const struct picture *expected = reference.version[0] != '\0' ? &reference.scene[i] : &golden;
    if (memcmp(&drawn.scene[i], expected, sizeof *expected) != 0) {
        report(scenes[i]->name, &drawn.scene[i], expected);
        fail();
    }
}

static int test_all(char *program)
{
    static int number[MOST_SCENES];
    static struct CMUnitTest tests[MOST_SCENES];
    struct problem problem;
    if (!ask_osmesa(program, &problem)) {
        memset(&reference, 0, sizeof reference);
        printf("compared with goldens: %s\n", problem.text);
    } else {
        printf("compared with %s\n", reference.version);
    }
    for (int i = 0; i < scene_count; i++) {
        number[i] = i;
        tests[i] = (struct CMUnitTest){scenes[i]->name, test_scene, NULL, NULL, &number[i]};
    }
    return _cmocka_run_group_tests("scenes", tests, (size_t)scene_count, NULL, NULL);
}

int main(int argc, char **argv)
{
    collect();
    if (argc == 3 && strcmp(argv[1], "--raw") == 0)
        return write_raw(argv[2]);
    if (argc == 2 && strcmp(argv[1], "--record") == 0)
        return record(argv[0]);
    if (argc > 1)
        return fgl_complain("usage: %s [--record | --raw FILE]", argv[0]);
    return test_all(argv[0]);
}
