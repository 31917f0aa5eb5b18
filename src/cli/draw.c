/* Drawing one picture of the list. */
#define _POSIX_C_SOURCE 200809L
#include "draw.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "child.h"

/* The files of one run. */
struct files {
    char *color, *depth, *log;
};

static struct files name_files(const struct renderer *renderer, const struct picture *picture)
{
    return (struct files){
            .color = fgl_format("%s/%s.%s.pam", renderer->scratch, picture->name, renderer->file),
            .depth = fgl_format("%s/%s.%s.depth", renderer->scratch, picture->name, renderer->file),
            .log = fgl_format("%s/%s.%s.log", renderer->scratch, picture->name, renderer->file),
    };
}

static void free_files(struct files *files)
{
    free(files->color);
    free(files->depth);
    free(files->log);
}

/* Fills `set` with the variables of one run, allocated, and NULL at the end. */
static void make_variables(const struct renderer *renderer, const struct picture *picture,
                           const struct files *files, char *set[8])
{
    int count = 0;
    set[count++] = fgl_format("FIXEDGL_CAPTURE=%s", files->color);
    set[count++] = fgl_format("FIXEDGL_CAPTURE_DEPTH=%s", files->depth);
    if (picture->width > 0)
        set[count++] = fgl_format("FIXEDGL_SIZE=%dx%d", picture->width, picture->height);
    if (picture->events[0] != '\0')
        set[count++] = fgl_format("FIXEDGL_EVENTS=%s", picture->events);
    if (renderer->preload != NULL) {
        set[count++] = fgl_format("LD_PRELOAD=%s", renderer->preload);
        set[count++] = fgl_format("MESA_SHADER_CACHE_DISABLE=true");
        /* In a sanitized build of the program: OSMesa comes before the sanitizer, and keeps some memory. */
        set[count++] = fgl_format("ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0");
    }
    set[count] = NULL;
}

static bool run_program(const struct renderer *renderer, const struct picture *picture,
                        const struct files *files, struct problem *problem)
{
    const bool is_path = strchr(picture->program, '/') != NULL;
    char *program =
            fgl_format("%s%s%s", is_path ? "" : renderer->programs, is_path ? "" : "/", picture->program);
    char *set[8];
    make_variables(renderer, picture, files, set);
    char *argv[] = {program, NULL};
    const struct child child = {
            .argv = argv,
            .set = (const char *const *)set,
            .output = files->log,
            .errors = files->log,
            .timeout = renderer->timeout,
    };
    const bool good = fgl_child_run(&child, problem);
    for (char **variable = set; *variable != NULL; variable++)
        free(*variable);
    free(program);
    return good;
}

static bool read_picture(const struct files *files, struct image *image, struct problem *problem)
{
    if (access(files->color, F_OK) != 0)
        return fgl_problem_set(problem, "wrote no picture");
    if (!fgl_image_read_pam(files->color, image, problem))
        return false;
    /* A program that asked for no depth buffer writes none. */
    return access(files->depth, F_OK) != 0 || fgl_image_read_depth(files->depth, image, problem);
}

static bool keep_last_line(char *line, void *context, struct problem *problem)
{
    (void)problem;
    snprintf(context, 160, "%s", line);
    return true;
}

/* Rewrites `problem` as one line that says who failed and what the program said last. */
static void explain(const struct renderer *renderer, const struct files *files, struct problem *problem)
{
    char said[160] = "";
    struct problem what = *problem, ignored;
    fgl_read_lines(files->log, keep_last_line, said, &ignored);
    fgl_problem_set(problem, "%s: %.300s%s%s", renderer->who, what.text, said[0] != '\0' ? ": " : "", said);
}

bool fgl_draw_picture(const struct renderer *renderer, const struct picture *picture, struct image *image,
                      struct problem *problem)
{
    struct files files = name_files(renderer, picture);
    *image = (struct image){0};
    remove(files.color);
    remove(files.depth);
    const bool good = run_program(renderer, picture, &files, problem) && read_picture(&files, image, problem);
    if (!good) {
        explain(renderer, &files, problem);
        fgl_image_free(image);
    }
    remove(files.color);
    remove(files.depth);
    remove(files.log);
    free_files(&files);
    return good;
}
