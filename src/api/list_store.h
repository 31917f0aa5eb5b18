/* How display lists are stored, for list.c that records them and list_call.c that executes them. */
#ifndef FGL_API_LIST_STORE_H
#define FGL_API_LIST_STORE_H

#include "api/list.h"
#include "base/idmap.h"

#include <stdatomic.h>
#include <stddef.h>

struct node {
    uint32_t op, bytes; /* of the payload, a multiple of 8, which follows */
};

struct block {
    struct block *next;
    size_t used, capacity;
    max_align_t data[];
};

struct list {
    struct block *first, *last;
};

struct list_store {
    atomic_int references;
    struct idmap map; /* list number -> struct list */
};

struct list_compiler {
    GLuint name;
    struct list *list;
    struct immediate *vertices;
    int depth; /* of CallList */
};

struct attribute_node {
    int32_t attr, size;
    float v[4];
};

/* The context's compiler, made when first asked for; NULL after GL_OUT_OF_MEMORY. */
struct list_compiler *fgl_list_compiler(struct context *ctx);

#endif
