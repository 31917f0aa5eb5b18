/* One call of a script: its values, given their types, and the memory that the command reads and writes. */
#ifndef FUZZ_CALL_H
#define FUZZ_CALL_H

#include "script.h"

#include <GL/gl.h>
#include <stddef.h>

typedef void (*function)(void);
extern function procs[COMMANDS]; /* of the library that is loaded */

struct call {
    const struct op *op;
    const double *value; /* its values */
    int next;
    unsigned char *out; /* what belongs to the result */
    size_t out_size;
};

enum { UNWRITTEN = 0xcd };

/* Forgets what earlier calls read and wrote. */
void arena_clear(void);
size_t type_size(GLenum type);

/* The next value. */
double take(struct call *call);
/* The rest of the values as `type`; followed by zeros, since a command with a wrong pname may read more. */
void *take_vector(struct call *call, GLenum type);
/* A vertex array: elements of the size, type and stride that the values before say. */
void *take_array(struct call *call);
/* Where the command writes what belongs to the result: of its usual size, or of `size`. */
void *take_out(struct call *call);
void *take_room(struct call *call, size_t size);
/* Where later commands write, as many elements of 4 bytes as the first parameter says. */
void *take_kept(struct call *call);
/* The value that a command returned, and what was kept before, become its result. */
void take_result(struct call *call, GLint value);

/* The commands whose values are passed on in other ways (own_calls.c). */
#define CALL(name, ...)
#define CALL0(name)
#define OWN(name, function, ...) void call_##name(struct call *call);
#include "commands.def"

#endif
