/* The book of named departures: which pictures may differ from the reference, why, and by exactly how much.
 */
#ifndef FGL_CLI_DEPARTURES_H
#define FGL_CLI_DEPARTURES_H

#include "pictures.h"
#include "support.h"

struct departure {
    char *picture;
    char *name; /* its heading in docs/departures.md */
    char *reason;
    bool undrawn; /* the reference cannot draw the picture at all */
    long pixels;  /* else: pixels of this picture that differ because of it, no more and no fewer */
};

struct departure_list {
    struct departure *items;
    int count;
};

/* Reads lines of the form
 *     picture departure pixels reason to the end of the line
 *     picture departure undrawn reason to the end of the line
 * A file that does not exist is an empty list. A picture that `pictures` does not hold is refused. */
bool fgl_departures_read(const char *path, const struct picture_list *pictures, struct departure_list *list,
                         struct problem *problem);

/* The departure because of which the reference cannot draw the picture, or NULL. */
const struct departure *fgl_departures_undrawn(const struct departure_list *list, const char *picture);

/* The number of pixels in which the picture must differ: the sum over its departures, 0 if it has none.
 * `names`, if not NULL, becomes the departures' names with ", " between; the caller frees it. */
long fgl_departures_pixels(const struct departure_list *list, const char *picture, char **names);

void fgl_departures_free(struct departure_list *list);

#endif
