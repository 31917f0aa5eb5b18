/* The error of a renderer in a category of scenes. */
#ifndef ORACLE_MEASURE_H
#define ORACLE_MEASURE_H

#include "oracle/categories.h"

/* Where the error is greatest. */
struct oracle_worst {
    int scene, vertex, component;
    double truth, drawn;
};

/* Over color components in [0,1]. One that is NaN, infinite or outside [0,1], and each of a vertex drawn that
 * should not be or the reverse, counts as an error of 1. */
struct oracle_error {
    long components;
    double max, mean, p999; /* the greatest, the mean, the 99.9th percentile */
    double ulps;            /* the greatest, in units of the last place of the truth as a float */
    long wrong_bytes;       /* components that differ from the truth when both are rounded to 8 bits */
    long invalid;           /* NaN, infinite or outside [0,1] */
    long at_edge;           /* components left out: closer than the margin to where the equation jumps */
    struct oracle_worst worst;
};

/* Draws so many scenes of the category and compares. Scene number i of a category is the same for the same
 * seed. margin: vertices are left out whose cosine is within it of the horizon. */
struct oracle_error oracle_measure(int category, uint64_t seed, int scenes, double margin);

#endif
