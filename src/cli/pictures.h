/* The picture list: which programs are drawn, how large, after which input. */
#ifndef FGL_CLI_PICTURES_H
#define FGL_CLI_PICTURES_H

#include "support.h"

struct picture {
    char *name;    /* unique; letters, digits, - _ . only, since files are named after it */
    char *program; /* a program's name, or a path if it holds a '/' */
    char *events;  /* input script in the form of FIXEDGL_EVENTS; "" for none */
    int width, height; /* 0: the program's own */
};

struct picture_list {
    struct picture *items;
    int count;
};

/* Reads lines of the form
 *     name program WIDTHxHEIGHT [event script to the end of the line]
 * where # begins a comment line. A malformed line, a name used twice, or a list without pictures is refused.
 */
bool fgl_pictures_read(const char *path, struct picture_list *list, struct problem *problem);

/* A list of programs that are in none: pictures named as their files, all after the same input. Refused: a path without '/', a name
 * that cannot be a picture's, a name used twice. */
bool fgl_pictures_of_programs(char *const *paths, int count, const char *events, struct picture_list *list,
                              struct problem *problem);

/* Keeps only the named pictures, in the order of the list. A name that is not in the list is refused. */
bool fgl_pictures_select(struct picture_list *list, char *const *names, int count, struct problem *problem);

/* The picture of this name, or NULL. */
const struct picture *fgl_pictures_find(const struct picture_list *list, const char *name);

/* The picture as one line of a list, with single spaces; the caller frees it. */
char *fgl_pictures_line(const struct picture *picture);

void fgl_pictures_free(struct picture_list *list);

#endif
