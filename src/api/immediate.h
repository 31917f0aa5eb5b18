/* Immediate mode (GL 1.5, 2.6 "Begin/End Paradigm", 2.7 "Vertex Specification"): vertices gathered between Begin and End,
 * and drawn together when the state changes, when the store is full, or at glFlush.
 *
 * Which attributes are part of a vertex here decides which of them differ by vertex in the draw: an attribute that is constant over the draw
 * reaches OSMesa's fragments exactly, one that is interpolated may be off by the last bit. So the rules by which OSMesa lets
 * attributes into its vertices are followed to the letter:
 *   - an attribute set while vertices are stored joins the vertex format; what is stored is drawn first;
 *   - outside Begin/End, with more than 8 vertices just drawn so, the format starts anew;
 *   - glBegin with attributes but no position in the format makes them current values and empties the format;
 *   - every flush of vertices for a state change makes the attributes current values and empties the format, but only if a primitive has ended with
 *     vertices in the store;
 *   - vertices wait while a list is compiled; those that it executes join them, and glEndList flushes. */
#ifndef FGL_API_IMMEDIATE_H
#define FGL_API_IMMEDIATE_H

#include "base/batch.h"
#include "pipeline/draw.h"
#include "state/context.h"

enum { IMMEDIATE_MAX_PRIMS = 64, IMMEDIATE_BYTES = 512 * 1024, IMMEDIATE_MAX_COPIED = 3 };

/* A primitive in the store. */
struct immediate_prim {
    GLenum mode;
    int first, count;
    bool begin, end; /* false: goes on from, or in, another store */
};

/* The format of a vertex: active attributes, position last. Sizes and offsets in floats. */
struct vertex_format {
    uint32_t active;
    uint8_t size[ATTR_COUNT], offset[ATTR_COUNT];
    int floats;          /* of a whole vertex */
    int before_position; /* floats before the position */
};

enum {
    VERTEX_MAX_FLOATS = 4 * ATTR_COUNT,
    STORE_SLACK = 4, /* floats behind the last vertex that may be written */
    CONTINUED_PRIMITIVE = 0xfffe /* mode of vertices in a list that stand before any Begin: a caller's primitive goes on */
};

struct immediate {
    float *store;
    float *next; /* where the next vertex goes */
    bool pending; /* attributes were set that are not yet current values */
    bool stored;  /* a state change has something to flush: a primitive ended with vertices stored, or queries made attributes current values */
    int count, max_count, capacity; /* vertices, vertices; floats */
    struct vertex_format format;
    float vertex[VERTEX_MAX_FLOATS]; /* the attributes of the next vertex, in the format */
    struct immediate_prim prim[IMMEDIATE_MAX_PRIMS];
    int prim_count;
    GLenum mode; /* of the open primitive, CONTINUED_PRIMITIVE or OUTSIDE_BEGIN_END; in a list's store, of the list alone */
    bool compiling; /* the store of a list: a flush records a node instead of drawing */
    bool of_arrays; /* while compiling: the last primitive is one of vertex arrays */
    /* While compiling: vertices 0..unset[a] came before attribute a was first given; theirs is the current value at execution. */
    int unset[ATTR_COUNT];
    float copied[IMMEDIATE_MAX_COPIED][VERTEX_MAX_FLOATS]; /* vertices that an open primitive needs again after a flush */
    int copied_count;
};

struct immediate *fgl_immediate_create(void);
void fgl_immediate_destroy(struct immediate *im);

/* Sets an attribute of the next vertices; inside and outside Begin/End. v holds `size` floats, the rest are 0, 0, 1 by position. */
void fgl_attr_set(struct context *ctx, enum fgl_attr attr, int size, const float *v);
/* A vertex: position of `size` 2..4 components. */
void fgl_vertex(struct context *ctx, int size, const float *v);

/* glBegin and glEnd without their error checks. */
void fgl_begin(struct context *ctx, GLenum mode);
void fgl_end(struct context *ctx);

/* Empties the store: its vertices are drawn, or recorded. An open primitive goes on in the next store. */
void fgl_immediate_flush(struct context *ctx, struct immediate *im);
/* Empties the format. */
void fgl_immediate_reset_format(struct immediate *im);
/* The store as a source of arrays. */
void fgl_format_source(const struct vertex_format *format, const float *store, struct vertex_source *source);
/* Makes the attributes of one vertex in the given format the current values. */
void fgl_format_to_current(struct context *ctx, const struct vertex_format *format, const float *vertex);
/* The current value of an attribute, 4 floats. */
float *fgl_current_attr(struct context *ctx, int attr);

#endif
