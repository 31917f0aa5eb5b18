/* What came out of drawing and comparing one picture, and the verdict on it. */
#ifndef FGL_CLI_RESULT_H
#define FGL_CLI_RESULT_H

#include "compare.h"
#include "departures.h"
#include "image.h"
#include "pictures.h"
#include "support.h"

/* Best first. */
enum verdict {
    VERDICT_IDENTICAL, /* every byte and every depth value */
    VERDICT_DEPARTS,   /* differs by named departures, in exactly the number of pixels they name */
    VERDICT_UNDRAWN,   /* the reference cannot draw it: compared with nothing */
    VERDICT_DIFFERS,   /* differs otherwise, or in another number of pixels */
    VERDICT_FAILED,    /* could not be drawn or compared */
    VERDICT_COUNT
};

struct result {
    const struct picture *picture;
    enum verdict verdict;
    int width, height;            /* as FixedGL drew it; as the list has it if it failed */
    struct difference difference; /* all zero if it failed */
    bool has_depth;               /* depth and coverage were compared */
    char *departures;             /* names of the picture's departures, "" if none */
    char first[256];              /* the first differing pixel with both values, "" if none differs */
    struct problem problem;       /* why it failed, or how its departures do not add up; "" otherwise */
};

/* Compares two drawn pictures and judges them. */
void fgl_result_compare(struct result *result, const struct image *ours, const struct image *reference,
                        const struct departure_list *departures);

/* The result of a picture that the reference cannot draw. */
void fgl_result_undrawn(struct result *result, const struct image *ours, const struct departure *departure);

/* The result of a picture of which one or both drawings are missing. */
void fgl_result_fail(struct result *result, const struct problem *problem);

/* Its line of the terminal's table (and a second line, when there is more to say); the caller frees it. */
char *fgl_result_line(const struct result *result);

/* The head of that table. */
const char *fgl_result_table_head(void);

/* How many pictures got which verdict, in a line; the caller frees it. */
char *fgl_result_summary(const int verdicts[VERDICT_COUNT]);

/* The sum over all pictures: its table line and how many got which verdict. Returns how many differ or
 * failed. */
int fgl_result_print_totals(const struct result *results, int count);

const char *fgl_result_verdict_name(enum verdict verdict);

void fgl_result_free(struct result *result);

#endif
