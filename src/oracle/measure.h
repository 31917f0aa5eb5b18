/* The error of a renderer in scenes of one kind. */
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
    long wrong_bytes;       /* components that differ from the truth when both are rounded to 8 bits, and not
                               because       no float lies between the truth and where the byte changes */
    long invalid;           /* NaN, infinite or outside [0,1] */
    long at_edge;           /* components left out: closer than the margin to where the equation jumps */
    struct oracle_worst worst;
};

/* Scenes to measure: number i of a stream is the same for the same seed. */
struct oracle_measurement {
    oracle_generator *generate;
    double parameter;
    uint64_t seed, stream;
    int scenes;
    double margin; /* vertices are left out whose cosine is within it of the horizon */
};

/* The scenes of a category. */
struct oracle_measurement oracle_measurement_of(int category, uint64_t seed, int scenes);

/* Draws the scenes and compares. */
struct oracle_error oracle_measure(const struct oracle_measurement *measurement, oracle_renderer *render);

/* Nanoseconds per vertex of the first scene (scene.h). */
double oracle_time(const struct oracle_measurement *measurement, oracle_renderer *render);

#endif
