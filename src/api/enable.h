/* glEnable for other files of the api. */
#ifndef FGL_API_ENABLE_H
#define FGL_API_ENABLE_H

#include "api/state_table.h"

/* Turns a capability on or off. */
void fgl_enable_set(struct context *ctx, const struct state_row *row, bool on);

#endif
