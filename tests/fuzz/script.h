/* A script: a list of GL commands with their values, kept as plain data (no pointers), so that it can be made from a
 * seed, given to another process, shortened, printed as C-like calls and read back. */
#ifndef FUZZ_SCRIPT_H
#define FUZZ_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { MAX_OPS = 8192, MAX_VALUES = 1 << 17, MAX_PARAMETERS = 11, MAX_WIDTH = 128, MAX_HEIGHT = 128 };

/* How a parameter is printed and what a vector holds. */
enum kind {
    KIND_NONE,
    KIND_INTEGER,
    KIND_REAL,
    KIND_ENUM,
    KIND_MODE,
    KIND_MASK,
    KIND_FIRST_VECTOR, /* from here on: the values to the end of the op */
    KIND_VECTOR = KIND_FIRST_VECTOR,
    KIND_OUT, /* no values */
    KIND_KEPT
};

#define KIND_GLenum KIND_ENUM
#define KIND_GLbyte KIND_INTEGER
#define KIND_GLubyte KIND_INTEGER
#define KIND_GLboolean KIND_INTEGER
#define KIND_GLshort KIND_INTEGER
#define KIND_GLushort KIND_INTEGER
#define KIND_GLint KIND_INTEGER
#define KIND_GLsizei KIND_INTEGER
#define KIND_GLuint KIND_INTEGER
#define KIND_GLfloat KIND_REAL
#define KIND_GLdouble KIND_REAL
#define KIND_BYTES KIND_VECTOR
#define KIND_UBYTES KIND_VECTOR
#define KIND_SHORTS KIND_VECTOR
#define KIND_USHORTS KIND_VECTOR
#define KIND_INTS KIND_VECTOR
#define KIND_UINTS KIND_VECTOR
#define KIND_FLOATS KIND_VECTOR
#define KIND_DOUBLES KIND_VECTOR
#define KIND_ARRAY KIND_VECTOR
#define KIND_INDICES KIND_VECTOR
#define KIND_BYTES_IN KIND_VECTOR
#define KIND_OFFSET KIND_INTEGER
#define KIND_GLintptr KIND_INTEGER
#define KIND_GLsizeiptr KIND_INTEGER

enum command {
#define CALL(name, ...) CMD_##name,
#define CALL0(name) CMD_##name,
#include "commands.def"
    COMMANDS
};

struct command_info {
    const char *name, *function; /* with gl: in scripts; of the library */
    int parameters;
    enum kind kind[MAX_PARAMETERS];
};
extern const struct command_info commands[COMMANDS];

struct op {
    int command;       /* enum command */
    int first, values; /* its part of script.value */
};

/* What the context is made with and the caller's buffer holds. */
struct buffers {
    unsigned format, type; /* OSMESA_RGBA, ...; GL_UNSIGNED_BYTE, ... */
    int depth_bits, stencil_bits;
};

struct script {
    int width, height; /* of the framebuffer */
    struct buffers buffers;
    int ops, values;
    struct op op[MAX_OPS];
    double value[MAX_VALUES]; /* each is a value of the parameter's type, so that no library sees another one */
};

/* Empty, with RGBA bytes, 24 bits of depth and 8 of stencil. */
void script_clear(struct script *s, int width, int height);
/* Appends a command; values beyond the capacity are not added and the command is dropped. */
void script_add(struct script *s, enum command command, int count, const double *values);
/* Appends values, the vector, to the last command. */
void script_extend(struct script *s, int count, const double *values);
/* Number of values before the vector. */
int script_scalars(const struct op *op);
/* Copies all ops but [from, to). */
void script_without(struct script *out, const struct script *in, int from, int to);
/* The end of the shortest range that begins at op `from`, has at least `length` ops and can be taken out whole: with
 * every Begin its End and with every NewList its EndList. -1: there is none. */
int script_range(const struct script *s, int from, int length);

void script_print_op(FILE *file, const struct script *s, int op);
void script_print(FILE *file, const struct script *s);
/* Reads what script_print wrote; says on stderr what it cannot read. */
bool script_read(FILE *file, struct script *s);

/* The enumerant's name or NULL. */
const char *enum_name(unsigned value, bool is_mode);

#endif
