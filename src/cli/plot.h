/* Plots as inline SVG. */
#ifndef FGL_CLI_PLOT_H
#define FGL_CLI_PLOT_H

#include <stdbool.h>
#include <stdio.h>

/* Numbers outside of the range are drawn at its ends. */
struct plot_axis {
    const char *title;
    double low, high;
    bool logarithmic;
};

struct plot_series {
    const char *name, *color; /* of CSS */
    bool line;                /* joined, else dots */
    int count;
    const double *x, *y;
    const char *const *label; /* what a dot is, shown when the pointer is on it; or NULL */
};

/* Writes one <svg> element. Later series are drawn over earlier ones. */
void fgl_plot_write(FILE *page, const struct plot_axis *x, const struct plot_axis *y,
                    const struct plot_series *series, int count);

#endif
