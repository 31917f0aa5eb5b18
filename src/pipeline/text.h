/* Text that grows while it is printed to. Layer 4. */
#ifndef FGL_PIPELINE_TEXT_H
#define FGL_PIPELINE_TEXT_H

#include "base/fgl.h"

struct text {
    char *data; /* ends with 0; NULL while empty */
    size_t length, room;
};

#if defined(__GNUC__)
#define FGL_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define FGL_PRINTF(text, first)
#endif

/* Appends as printf does. What memory is short for is left out. */
FGL_PRINTF(2, 3) void fgl_text_add(struct text *t, const char *format, ...);
void fgl_text_end_line(struct text *t); /* a newline, without blanks before it */
void fgl_text_clear(struct text *t);    /* empties it; the memory stays */
void fgl_text_free(struct text *t);
/* Writes the whole text to a file, in place of what was there. */
bool fgl_text_write(const struct text *t, const char *path);

#endif
