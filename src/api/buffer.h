/* Buffer objects (GL 1.5, 2.9): arrays and element indexes that the library holds, shared between contexts as lists are.
 *
 * An object lives while it has a name or is bound: in a context, to an array, to pixels, or in a saved client attribute group. */
#ifndef FGL_API_BUFFER_H
#define FGL_API_BUFFER_H

#include "state/context.h"

#include <stdatomic.h>

struct buffer_object {
    atomic_int references;
    GLuint name;
    bool created; /* bound once; until then only its name is taken */
    bool mapped;
    GLenum usage, access;
    GLbitfield access_flags; /* of the mapping, */
    size_t map_offset, map_length; /* bytes */
    size_t size;
    uint8_t *data; /* NULL while size is 0 */
};

struct buffer_store *fgl_buffer_store_create(void);
void fgl_buffer_store_retain(struct buffer_store *store);
void fgl_buffer_store_release(struct buffer_store *store);

/* Makes *slot refer to the object, or to none, in place of what it referred to. */
void fgl_buffer_refer(struct buffer_object **slot, struct buffer_object *b);

/* For copies of the array state: adds, or takes away, a reference for each binding in it. */
void fgl_buffer_retain_arrays(struct client_array_state *arrays);
void fgl_buffer_release_arrays(struct client_array_state *arrays);

/* The same for those that pixels are read from and written to. */
void fgl_buffer_retain_pixels(struct client_state *client);
void fgl_buffer_release_pixels(struct client_state *client);

/* The object that is bound to a target; NULL after recording an error. */
struct buffer_object *fgl_buffer_bound(struct context *ctx, GLenum target);
void fgl_buffer_unmap(struct buffer_object *b);

/* The name of a bound object; 0 for none. */
static inline GLuint fgl_buffer_name(const struct buffer_object *b) { return b ? b->name : 0; }

#endif
