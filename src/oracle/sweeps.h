/* Extremes as axes: scenes in which one thing goes from one end of its range to the other. */
#ifndef ORACLE_SWEEPS_H
#define ORACLE_SWEEPS_H

#include <stdbool.h>

#include "oracle/categories.h"

struct oracle_sweep {
    const char *name;
    oracle_generator *generate;
    double from, to;
    bool logarithmic;
    int steps; /* points from `from` to `to`, both included */
};

extern const struct oracle_sweep oracle_sweeps[];
extern const int oracle_sweep_count;

/* The parameter at a step. */
double oracle_sweep_at(const struct oracle_sweep *sweep, int step);

#endif
