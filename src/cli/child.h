/* Running a program as a child process, with a changed environment and a time limit. */
#ifndef FGL_CLI_CHILD_H
#define FGL_CLI_CHILD_H

#include "support.h"

struct child {
    char *const *argv; /* argv[0] is the program's path (or its name, to be found in PATH); NULL at the end */
    const char *const *set; /* "NAME=value" added to the inherited environment; NULL at the end */
    const char *output;     /* file that receives its stdout */
    const char *errors;     /* file that receives its stderr; may be the same as `output` */
    double timeout;         /* seconds until it is killed */
};

/* Runs the child to its end. It does not inherit what a picture must not depend on: another capture, another
 * library, or the knobs of Mesa that change the reference; FIXEDGL_PATH and the like stay.
 * True only if it exited with status 0; otherwise `problem` says that it could not be started, was killed by
 * which signal, did not end in time, or with which status it exited. */
bool fgl_child_run(const struct child *child, struct problem *problem);

#endif
