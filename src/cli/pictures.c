/* Reading the picture list. */
#define _POSIX_C_SOURCE 200809L
#include "pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST_SIDE = 8192 };

static bool valid_name(const char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
    return name[0] != '.' && name[strspn(name, allowed)] == '\0';
}

static void free_picture(struct picture *picture)
{
    free(picture->name);
    free(picture->program);
    free(picture->events);
}

static bool append(struct picture_list *list, const char *name, const char *program, const char *events, int width, int height,
                   struct problem *problem)
{
    if (!valid_name(name))
        return fgl_problem_set(problem, "a picture cannot be named '%s'", name);
    if (fgl_pictures_find(list, name) != NULL)
        return fgl_problem_set(problem, "picture '%s' is listed twice", name);
    list->items = fgl_grow(list->items, (size_t)list->count, sizeof *list->items);
    list->items[list->count++] = (struct picture){
            .name = fgl_format("%s", name),
            .program = fgl_format("%s", program),
            .events = fgl_format("%s", events),
            .width = width,
            .height = height,
    };
    return true;
}

static bool add_picture(char *line, void *context, struct problem *problem)
{
    struct picture_list *list = context;
    char name[64], program[256];
    int width = 0, height = 0, end = 0;
    if (sscanf(line, "%63s %255s %5dx%5d%n", name, program, &width, &height, &end) < 4 ||
        (line[end] != '\0' && line[end] != ' ' && line[end] != '\t'))
        return fgl_problem_set(problem, "expected `name program WIDTHxHEIGHT [events]`");
    if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE)
        return fgl_problem_set(problem, "size %dx%d is not within 1x1 and %dx%d", width, height, LARGEST_SIDE,
                               LARGEST_SIDE);
    return append(list, name, program, fgl_trim(line + end), width, height, problem);
}

bool fgl_pictures_read(const char *path, struct picture_list *list, struct problem *problem)
{
    *list = (struct picture_list){0};
    if (!fgl_read_lines(path, add_picture, list, problem)) {
        fgl_pictures_free(list);
        return false;
    }
    return list->count > 0 || fgl_problem_set(problem, "%s lists no pictures", path);
}

bool fgl_pictures_of_programs(char *const *paths, int count, const char *events, struct picture_list *list,
                              struct problem *problem)
{
    *list = (struct picture_list){0};
    for (int i = 0; i < count; i++) {
        const char *slash = strrchr(paths[i], '/');
        if (slash == NULL)
            fgl_problem_set(problem, "'%s' is no path: pictures of the list and programs do not go together", paths[i]);
        if (slash == NULL || !append(list, slash + 1, paths[i], events, 0, 0, problem)) {
            fgl_pictures_free(list);
            return false;
        }
    }
    return true;
}

bool fgl_pictures_select(struct picture_list *list, char *const *names, int count, struct problem *problem)
{
    for (int i = 0; i < count; i++)
        if (fgl_pictures_find(list, names[i]) == NULL)
            return fgl_problem_set(problem, "there is no picture '%s'", names[i]);
    int kept = 0;
    for (int i = 0; i < list->count; i++) {
        bool wanted = false;
        for (int j = 0; j < count; j++)
            wanted = wanted || strcmp(list->items[i].name, names[j]) == 0;
        if (wanted)
            list->items[kept++] = list->items[i];
        else
            free_picture(&list->items[i]);
    }
    list->count = kept;
    return true;
}

const struct picture *fgl_pictures_find(const struct picture_list *list, const char *name)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->items[i].name, name) == 0)
            return &list->items[i];
    return NULL;
}

char *fgl_pictures_line(const struct picture *picture)
{
    return fgl_format("%s %s %dx%d%s%s", picture->name, picture->program, picture->width, picture->height,
                      picture->events[0] != '\0' ? " " : "", picture->events);
}

void fgl_pictures_free(struct picture_list *list)
{
    for (int i = 0; i < list->count; i++)
        free_picture(&list->items[i]);
    free(list->items);
    *list = (struct picture_list){0};
}
