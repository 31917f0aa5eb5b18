/* The event script of FIXEDGL_EVENTS: text to a list of statements. docs/glut.md has the grammar. */
#ifndef FGL_GLUT_SCRIPT_H
#define FGL_GLUT_SCRIPT_H

#include <stdbool.h>
#include <stddef.h>

enum statement_kind {
    STATEMENT_KEY,       /* value: character */
    STATEMENT_SPECIAL,   /* value: GLUT_KEY_* */
    STATEMENT_PRESS,     /* value: button; number: x y */
    STATEMENT_RELEASE,   /* likewise */
    STATEMENT_CLICK,     /* likewise; number[2]: times */
    STATEMENT_DRAG,      /* value: button; number: x0 y0 x1 y1 */
    STATEMENT_MOVE,      /* number: x y */
    STATEMENT_WHEEL,     /* value: +1 up, -1 down; number: x y */
    STATEMENT_MODIFIERS, /* value: GLUT_ACTIVE_* bits */
    STATEMENT_RESIZE,    /* number: width height */
    STATEMENT_MENU,      /* number: item positions, one per level; value: how many */
    STATEMENT_WAIT,      /* number: frames */
    STATEMENT_TIME,      /* number: milliseconds */
    STATEMENT_WINDOW,    /* number: window id */
    STATEMENT_CAPTURE,   /* text: file */
    STATEMENT_DEPTH,     /* text: file */
    STATEMENT_QUIT
};

enum { STATEMENT_NUMBERS = 4 };

struct statement {
    enum statement_kind kind;
    int value;
    int number[STATEMENT_NUMBERS];
    char *text; /* points into the script's own copy */
};

struct script {
    struct statement *statements;
    int count;
    char *copy;
};

/* Parses `text`. On a fault writes one line about it to `error` and returns false; the script is then empty.
 */
bool fgl_script_parse(const char *text, struct script *script, char *error, size_t error_size);
void fgl_script_free(struct script *script);

/* Reads "WIDTHxHEIGHT", both 1..16384, and nothing else. */
bool fgl_script_parse_size(const char *text, int *width, int *height);

#endif
