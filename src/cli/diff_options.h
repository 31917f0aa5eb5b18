/* The command line of `fixedgl diff`. */
#ifndef FGL_CLI_DIFF_OPTIONS_H
#define FGL_CLI_DIFF_OPTIONS_H

#include "support.h"

enum reference_choice { REFERENCE_AUTO, REFERENCE_OSMESA, REFERENCE_GOLDENS };

struct diff_options {
    const char *pictures;   /* the picture list */
    const char *programs;   /* folder of the example programs */
    const char *departures; /* the book of named departures */
    const char *osmesa;     /* the reference library, as the loader finds it */
    const char *goldens;    /* folder of goldens */
    const char *output;     /* folder of the report */
    const char *events;     /* input for programs that are given by path; NULL for none */
    const char *record;     /* folder to record goldens into instead of comparing; NULL to compare */
    enum reference_choice reference;
    int jobs;
    double timeout;     /* seconds for one program */
    char *const *names; /* pictures to draw, or paths of programs; all pictures if there are none */
    int name_count;
    bool by_path;      /* they are paths */
};

/* True if the options are good and there is work to do; otherwise `*exit_code` is what to return: help has
 * been printed, or a complaint. */
bool fgl_diff_options_read(int argc, char **argv, struct diff_options *options, int *exit_code);

#endif
