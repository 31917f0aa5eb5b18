/* Running a user's program headless, so that FixedGL inside of it writes a file about what it drew. */
#ifndef FGL_CLI_RUN_H
#define FGL_CLI_RUN_H

#include "support.h"

struct run {
    char *const *argv;  /* the program and its arguments; NULL at the end */
    const char *events; /* FIXEDGL_EVENTS, or NULL */
    const char *size;   /* WIDTHxHEIGHT, or NULL for the program's own */
    int frames;
    double timeout;     /* seconds */
    const char *set[3]; /* further variables, "NAME=value"; NULL at the end. */
    const char *suffix; /* of the file: ".txt" or ".json" */
};

/* Runs the program; what it prints is kept from the terminal. The variable in `set` that ends with '=' gets
 * the name of a file, whose contents are returned, to be freed. NULL when the program fails or the file was
 * not written: the problem is one line. */
char *fgl_run(const struct run *run, struct problem *problem);

/* Reads options that `fixedgl explain` and `fixedgl plan` have in common. */
bool fgl_run_option(struct run *run, int option, const char *value);

#endif
