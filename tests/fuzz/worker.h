/* Two processes, each with one of the libraries, which run the same script. A crash or a hang ends only a worker. */
#ifndef FUZZ_WORKER_H
#define FUZZ_WORKER_H

#include "run.h"

enum { OURS, REFERENCE, LIBRARIES };

enum outcome { IDENTICAL, DIFFERS_IN_COLOR, DIFFERS_IN_DEPTH, DIFFERS_IN_STENCIL, DIFFERS_IN_DATA, DIFFERS_IN_ERRORS, CRASHED,
               HUNG, REFERENCE_FAILED };

/* Where two runs of a script differ. */
struct difference {
    enum outcome outcome;
    int x, y;               /* the first differing pixel, from the lower left */
    int color_pixels, depth_pixels, stencil_pixels;
    int record;             /* the first differing record */
    int op;                 /* where the crash or the first differing record was */
};

/* Memory that the driver shares with both workers. */
struct channel {
    struct script script; /* what the workers run */
    struct result result[LIBRARIES];
    bool missing[LIBRARIES][COMMANDS];
};

/* Starts both; false if one of them cannot load its library. */
bool workers_start(struct channel *channel, const char *const path[LIBRARIES]);
void workers_stop(void);
/* Runs channel->script in both, again in new processes where one had ended. */
struct difference workers_compare(struct channel *channel);
/* The outcome in words, with values. */
void difference_print(FILE *file, const struct channel *channel, const struct difference *difference);

/* The picture in letters, top row first: where the two differ, and whether only one of them drew there. */
void difference_print_map(FILE *file, const struct channel *channel);

#endif
