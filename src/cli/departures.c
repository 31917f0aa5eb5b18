/* Reading the book of named departures. */
#define _POSIX_C_SOURCE 200809L
#include "departures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct reading {
    const struct picture_list *pictures;
    struct departure_list *list;
};

static bool add_departure(char *line, void *context, struct problem *problem)
{
    struct reading *reading = context;
    struct departure_list *list = reading->list;
    char picture[64], name[128], what[16], *rest = what;
    int end = 0;
    if (sscanf(line, "%63s %127s %15s %n", picture, name, what, &end) < 3 || line[end] == '\0')
        return fgl_problem_set(problem, "expected `picture departure pixels reason`");
    const bool undrawn = strcmp(what, "undrawn") == 0;
    const long pixels = undrawn ? 0 : strtol(what, &rest, 10);
    if (!undrawn && (pixels < 1 || pixels > 999999999 || *rest != '\0'))
        return fgl_problem_set(problem, "a departure changes a number of pixels, or the picture is `undrawn`");
    if (fgl_pictures_find(reading->pictures, picture) == NULL)
        return fgl_problem_set(problem, "there is no picture '%s'", picture);
    if (fgl_departures_undrawn(list, picture) != NULL ||
        (undrawn && fgl_departures_pixels(list, picture, NULL) > 0))
        return fgl_problem_set(problem, "picture '%s' cannot both be undrawn and have another departure", picture);
    list->items = fgl_grow(list->items, (size_t)list->count, sizeof *list->items);
    list->items[list->count++] = (struct departure){
            .picture = fgl_format("%s", picture),
            .name = fgl_format("%s", name),
            .reason = fgl_format("%s", line + end),
            .undrawn = undrawn,
            .pixels = pixels,
    };
    return true;
}

bool fgl_departures_read(const char *path, const struct picture_list *pictures, struct departure_list *list,
                         struct problem *problem)
{
    *list = (struct departure_list){0};
    if (access(path, F_OK) != 0)
        return true;
    struct reading reading = {pictures, list};
    if (fgl_read_lines(path, add_departure, &reading, problem))
        return true;
    fgl_departures_free(list);
    return false;
}

const struct departure *fgl_departures_undrawn(const struct departure_list *list, const char *picture)
{
    for (int i = 0; i < list->count; i++)
        if (list->items[i].undrawn && strcmp(list->items[i].picture, picture) == 0)
            return &list->items[i];
    return NULL;
}

long fgl_departures_pixels(const struct departure_list *list, const char *picture, char **names)
{
    long pixels = 0;
    char *joined = fgl_format("%s", "");
    for (int i = 0; i < list->count; i++) {
        const struct departure *departure = &list->items[i];
        if (strcmp(departure->picture, picture) != 0)
            continue;
        char *longer = fgl_format("%s%s%s", joined, pixels > 0 ? ", " : "", departure->name);
        free(joined);
        joined = longer;
        pixels += departure->pixels;
    }
    if (names != NULL)
        *names = joined;
    else
        free(joined);
    return pixels;
}

void fgl_departures_free(struct departure_list *list)
{
    for (int i = 0; i < list->count; i++) {
        free(list->items[i].picture);
        free(list->items[i].name);
        free(list->items[i].reason);
    }
    free(list->items);
    *list = (struct departure_list){0};
}
