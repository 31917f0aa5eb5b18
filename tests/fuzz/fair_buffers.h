/* Which buffer objects a script has bound, and whether its offsets and pointers fit to that. */
#ifndef FUZZ_FAIR_BUFFERS_H
#define FUZZ_FAIR_BUFFERS_H

#include "script.h"

enum { FAIR_TARGETS = 4, FAIR_BUFFERS = 32 };

struct fair_buffers {
    int bound[FAIR_TARGETS];   /* the buffer's name */
    bool filled[FAIR_BUFFERS]; /* has all the data that its offsets go into */
};

/* Follows the script by one command; false if it takes an offset into a buffer that has no data, or client memory while a buffer is bound. */
bool fair_buffers_follow(struct fair_buffers *b, const struct script *s, int i);

#endif
