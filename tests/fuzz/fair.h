/* Whether a script keeps to where OSMesa follows the specification, as far as the generator's promises go. */
#ifndef FUZZ_FAIR_H
#define FUZZ_FAIR_H

#include "script.h"

/* What a script has that OSMesa is known to draw wrongly (docs/departures.md), or that leaves values open: a bit for each kind. */
enum {
    UNFAIR_CLEARS = 1 << 0,      /* drawing into buffers that were never cleared; nothing drawn after the last glAccum */
    UNFAIR_PRIMITIVE = 1 << 1,   /* an empty primitive, or GL_TRIANGLES of 9 vertices; in a list: one that is not complete, or an attribute after
                                  * its last vertex */
    UNFAIR_ATTRIBUTE = 1 << 2,   /* in a line strip or loop or a list: an attribute that is first given after the first vertex; in a list: an
                                  * attribute outside Begin and End or, if it is executed, inside */
    UNFAIR_CALL = 1 << 3,        /* a call of a list without glGetFloatv (of the current color) just before it */
    UNFAIR_STACK = 1 << 4,       /* PushAttrib within another, PopAttrib without it, with nothing drawn just before it, without a color after it or,
                                  * in a script that changes these, without GL_COLOR_SUM and GL_FOG_COORD_SRC */
    UNFAIR_ARRAYS = 1 << 5,      /* a draw from arrays while there is no vertex array, or none was ever given */
    UNFAIR_BUFFERS = 1 << 6,     /* offsets into buffer objects without data, or client memory while one is bound */
    UNFAIR_ORDER = 1 << 7,       /* glAccum before the buffer was cleared; meshes before a glMapGrid; glRenderMode(GL_FEEDBACK or GL_SELECT) without
                                  * a buffer given just before it, GL_RENDER after feedback without a point after it */
    UNFAIR_PIXELS = 1 << 8,      /* a bitmap while secondary colors are added; a pixel rectangle after a texture of a later unit was enabled */
    UNFAIR_FRAMEBUFFER = 1 << 9, /* a framebuffer object bound at the end */
};
/* When a differing script is shortened it gets none of these that it did not have, lest it turn into one of them. */
unsigned script_unfair(const struct script *s);

#endif
