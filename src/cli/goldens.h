/* Goldens: the reference's pictures as PNG files, for machines on which the reference is not installed.
 *
 * A folder of goldens holds, for each picture, NAME.png (the RGBA bytes) and NAME.depth.png (24-bit depth,
 * high byte in red), and GOLDENS.txt: what they were recorded from, and the line of the picture list each was
 * recorded for, so that a golden of another scene is never taken for this one. */
#ifndef FGL_CLI_GOLDENS_H
#define FGL_CLI_GOLDENS_H

#include "departures.h"
#include "image.h"
#include "library.h"
#include "pictures.h"
#include "support.h"

struct goldens {
    const char *folder;
    char **lines; /* of the picture list, as recorded */
    int count;
    char renderer[128], version[128], package[128];
};

/* Reads GOLDENS.txt of the folder. */
bool fgl_goldens_open(const char *folder, struct goldens *goldens, struct problem *problem);

/* Reads one golden. False if it is missing or was recorded for another program, size or event script. */
bool fgl_goldens_load(const struct goldens *goldens, const struct picture *picture, struct image *image,
                      struct problem *problem);

void fgl_goldens_close(struct goldens *goldens);

/* Writes one golden. Depth must have 24 bits or be absent. */
bool fgl_goldens_write_picture(const char *folder, const struct picture *picture, const struct image *image,
                               const struct library_facts *facts, struct problem *problem);

/* Writes GOLDENS.txt: all pictures but those that the reference cannot draw. *recorded: how many. */
bool fgl_goldens_write_index(const char *folder, const struct picture_list *pictures,
                             const struct departure_list *departures, const struct library_facts *facts, int *recorded,
                             struct problem *problem);

#endif
