/* Whether a script keeps to where OSMesa follows the specification, as far as the generator's promises go. */
#ifndef FUZZ_FAIR_H
#define FUZZ_FAIR_H

#include "script.h"

/* False for a script that has one of these, which OSMesa is known to draw wrongly (docs/departures.md):
 *   - an empty primitive, or GL_TRIANGLES of 9 vertices;
 *   - in a line loop or a list: an attribute that is first given after the first vertex of a primitive;
 *   - in a list: a primitive that is not complete;
 *   - in a list: an attribute after the last vertex of a primitive;
 *   - in a list: an attribute outside Begin and End or, if it is executed, inside;
 *   - a draw from arrays while there is no vertex array, or none was ever given;
 *   - a call of a list without glGetFloatv (of the current color) just before it;
 *   - drawing into buffers that were never cleared;
 *   - nothing drawn after the last glAccum;
 *   - a framebuffer object bound at the end;
 *   - a pixel rectangle after a texture of a later unit was enabled;
 *   - offsets into buffer objects without data, or client memory while one is bound;
 *   - glAccum before the buffer was cleared; meshes before a glMapGrid;
 *   - glRenderMode(GL_FEEDBACK or GL_SELECT) without a buffer given just before it;
 *   - PushAttrib within another, or PopAttrib with nothing drawn just before it, without a color after it or, in a script that
 *     changes these, without GL_COLOR_SUM and GL_FOG_COORD_SRC;
 *   - a bitmap while secondary colors are added.
 * Only such scripts are kept when a differing one is shortened, lest it turn into one of these. */
bool script_is_fair(const struct script *s);

#endif
