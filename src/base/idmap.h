/* A map from object names (list numbers, texture names) to pointers: open addressing, linear probing. Name 0 is never an object. */
#ifndef FGL_BASE_IDMAP_H
#define FGL_BASE_IDMAP_H

#include "base/fgl.h"

struct idmap_slot {
    uint32_t name; /* 0: never used */
    void *value;   /* NULL with a name: was removed */
};

struct idmap {
    struct idmap_slot *slot;
    uint32_t capacity; /* power of two, or 0 */
    uint32_t used;     /* slots with a name */
    uint32_t highest;  /* largest name ever put */
};

void *fgl_idmap_get(const struct idmap *map, uint32_t name);
/* Returns false when memory is short; the map is then unchanged. value is not NULL. */
bool fgl_idmap_put(struct idmap *map, uint32_t name, void *value);
void *fgl_idmap_remove(struct idmap *map, uint32_t name);
/* Removes and destroys what has the names first, first + 1, ... first + n - 1, in no longer than it takes to look at all. */
void fgl_idmap_remove_range(struct idmap *map, uint32_t first, uint32_t n, void (*destroy)(void *value));
/* The first of `n` consecutive names that are all free, or 0. */
uint32_t fgl_idmap_find_free(const struct idmap *map, uint32_t n);
void fgl_idmap_free(struct idmap *map, void (*destroy)(void *value));

#endif
