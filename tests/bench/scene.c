#include "scene.h"

#include <stdio.h>
#include <stdlib.h>

static const struct scene *const lists[] = {sphere_scenes, primitive_scenes, fragment_scenes, texture_scenes, pixel_scenes, command_scenes};

enum { LISTS = sizeof lists / sizeof lists[0] };

const struct scene *scene_at(int index)
{
    for (int i = 0; i < LISTS; i++)
        for (const struct scene *scene = lists[i]; scene->name; scene++)
            if (index-- == 0)
                return scene;
    return NULL;
}

int scene_count(void)
{
    int n = 0;
    while (scene_at(n))
        n++;
    return n;
}

void fail(const char *what, const char *detail)
{
    fprintf(stderr, "bench: %s%s%s\n", what, detail ? ": " : "", detail ? detail : "");
    exit(1);
}

void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (memory == NULL)
        fail("out of memory", NULL);
    return memory;
}

float random_float(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / (1 << 24);
}
