#include "base/idmap.h"

#include <stdlib.h>

static uint32_t hash(uint32_t name) { return name * 2654435769u; }

/* The slot that holds `name`, or the free one where it would go. capacity is not 0. */
static struct idmap_slot *find(const struct idmap *map, uint32_t name)
{
    uint32_t i = hash(name) & (map->capacity - 1);
    while (map->slot[i].name && map->slot[i].name != name)
        i = (i + 1) & (map->capacity - 1);
    return &map->slot[i];
}

void *fgl_idmap_get(const struct idmap *map, uint32_t name)
{
    return map->capacity && name ? find(map, name)->value : NULL;
}

static uint32_t live(const struct idmap *map)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < map->capacity; i++)
        n += map->slot[i].value != NULL;
    return n;
}

/* Forgets removed names, and makes room unless there was enough without them. */
static bool grow(struct idmap *map)
{
    const uint32_t doubled = map->capacity ? map->capacity * 2 : 16;
    struct idmap bigger = {.capacity = live(map) * 2 < map->capacity ? map->capacity : doubled, .highest = map->highest};
    bigger.slot = calloc(bigger.capacity, sizeof *bigger.slot);
    if (!bigger.slot)
        return false;
    for (uint32_t i = 0; i < map->capacity; i++) {
        if (!map->slot[i].value)
            continue;
        *find(&bigger, map->slot[i].name) = map->slot[i];
        bigger.used++;
    }
    free(map->slot);
    *map = bigger;
    return true;
}

bool fgl_idmap_put(struct idmap *map, uint32_t name, void *value)
{
    if (map->used * 4 >= map->capacity * 3 && !grow(map))
        return false;
    struct idmap_slot *slot = find(map, name);
    if (!slot->name)
        map->used++;
    *slot = (struct idmap_slot){name, value};
    if (name > map->highest)
        map->highest = name;
    return true;
}

void *fgl_idmap_remove(struct idmap *map, uint32_t name)
{
    if (!map->capacity || !name)
        return NULL;
    struct idmap_slot *slot = find(map, name);
    void *value = slot->value;
    slot->value = NULL;
    return value;
}

void fgl_idmap_remove_range(struct idmap *map, uint32_t first, uint32_t n, void (*destroy)(void *value))
{
    if (n > map->capacity) {
        for (uint32_t i = 0; i < map->capacity; i++) {
            struct idmap_slot *slot = &map->slot[i];
            if (!slot->value || slot->name < first || slot->name - first >= n)
                continue;
            destroy(slot->value);
            slot->value = NULL;
        }
        return;
    }
    for (uint32_t i = 0; i < n && first + i >= first; i++) {
        void *value = fgl_idmap_remove(map, first + i);
        if (value)
            destroy(value);
    }
}

uint32_t fgl_idmap_find_free(const struct idmap *map, uint32_t n)
{
    if (n <= UINT32_MAX - map->highest)
        return map->highest + 1;
    uint32_t run = 0;
    for (uint32_t name = 1; name != 0; name++) {
        run = fgl_idmap_get(map, name) ? 0 : run + 1;
        if (run == n)
            return name - n + 1;
    }
    return 0;
}

void fgl_idmap_free(struct idmap *map, void (*destroy)(void *value))
{
    for (uint32_t i = 0; i < map->capacity; i++)
        if (map->slot[i].value)
            destroy(map->slot[i].value);
    free(map->slot);
    *map = (struct idmap){0};
}
