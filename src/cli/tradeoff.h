/* What `fixedgl tradeoff` measures: jobs, renderers, and the figures of each renderer at each job. */
#ifndef FGL_CLI_TRADEOFF_H
#define FGL_CLI_TRADEOFF_H

#include "support.h"

/* In the order of their columns. TRUTH draws spheres only. */
enum { OSMESA, PLAIN, COMPATIBLE, EXACT, MEASURED_RENDERERS, TRUTH = MEASURED_RENDERERS, RENDERERS };

struct tradeoff_renderer {
    const char *name, *file; /* file: in file names */
    const char *color;       /* of its marks in plots, CSS */
    const char *option;      /* of fixedgl-measure, or NULL */
    const char *set;         /* environment variable, or NULL */
};

extern const struct tradeoff_renderer fgl_tradeoff_renderers[RENDERERS];

enum tradeoff_kind { LIGHTING, TRIANGLES, SWEEP, SPHERE, TRADEOFF_KINDS };

/* One point of a sweep, or the only one of a category. */
struct tradeoff_figures {
    double at;                                /* where a sweep stands */
    double max, p999, mean;                   /* error of color components in [0,1] */
    long bytes;                               /* that differ from the truth */
    long invalid;                             /* NaN, infinite or outside [0,1] */
    long count;                               /* components; of TRIANGLES pixels */
    double ns;                                /* per vertex or triangle; not of sweeps */
    double depth_max, depth_p999, depth_mean; /* units of 2^-24; TRIANGLES only, as what follows */
    long coverage;                            /* pixels that are wrongly colored or not */
    long corners;                             /* the same at edges whose corners were rounded otherwise */
};

struct tradeoff_result {
    int count; /* 0: not measured */
    struct tradeoff_figures *figures;
};

struct tradeoff_job {
    enum tradeoff_kind kind;
    char name[80];
    bool logarithmic; /* the axis of a SWEEP */
    struct tradeoff_result result[RENDERERS];
};

struct tradeoff {
    const char *output; /* folder */
    const char *osmesa; /* library; NULL: left out */
    const char *only;   /* name of the only job, or NULL */
    int vertices;
    const char *seed;
    struct tradeoff_job *jobs;
    int count;
    char gl_renderer[2][128]; /* of OSMesa and FixedGL */
};

/* Asks fixedgl-measure, which must lie beside this program, for the jobs. */
bool fgl_tradeoff_list(struct tradeoff *t, struct problem *problem);

/* Runs one job on one renderer, in a process of its own. True without doing anything where the renderer does
 * not take part. A SPHERE's picture is written as PNG to the output folder. */
bool fgl_tradeoff_run(const struct tradeoff *t, struct tradeoff_job *job, int renderer,
                      struct problem *problem);

/* GL_RENDERER as fixedgl-measure finds it. */
bool fgl_tradeoff_name_renderer(struct tradeoff *t, int renderer, struct problem *problem);

/* Name of the picture of a SPHERE in the output folder; to be freed. */
char *fgl_tradeoff_picture(const struct tradeoff *t, const struct tradeoff_job *job, int renderer);

/* Prints the lines of a job that is done. */
void fgl_tradeoff_print(const struct tradeoff_job *job);

/* Prints the summary. */
void fgl_tradeoff_print_summary(const struct tradeoff *t);

/* What the summary counts. */
struct tradeoff_summary {
    int categories;
    int wrong; /* categories in which a color is off by more than 1/255 */
    long bytes, invalid, coverage, corners;
    double ns, depth; /* ns: median; depth: greatest error */
};

struct tradeoff_summary fgl_tradeoff_summarize(const struct tradeoff *t, enum tradeoff_kind kind,
                                               int renderer);

/* Writes tradeoff.csv and sweeps.csv. */
bool fgl_tradeoff_write_csv(const struct tradeoff *t, struct problem *problem);

/* Writes index.html. */
bool fgl_tradeoff_write_page(const struct tradeoff *t, struct problem *problem);

#endif
