/* The categories of scenes that accuracy is promised and measured for. */
#ifndef ORACLE_CATEGORIES_H
#define ORACLE_CATEGORIES_H

#include "oracle/random.h"
#include "oracle/scene.h"

/* The greatest error allowed of a color component in [0,1]; 0: measured only. exact: in units of the last
 * place. */
struct oracle_bounds {
    double exact, compatible;
};

/* Fills a scene that was all zero. */
typedef void oracle_generator(struct random *random, struct oracle_scene *scene, double parameter);

struct oracle_category {
    const char *name;
    oracle_generator *generate;
    double parameter; /* what it is, the generator says */
    struct oracle_bounds bounds;
};

extern const struct oracle_category oracle_categories[];
extern const int oracle_category_count;

#endif
