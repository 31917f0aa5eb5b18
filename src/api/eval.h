/* Evaluated vertices (GL 1.5, 5.1 "Evaluators"). */
#ifndef FGL_API_EVAL_H
#define FGL_API_EVAL_H

#include "state/context.h"

/* glEvalCoord and glEvalPoint from a display list. */
void fgl_eval_replay(struct context *ctx, void *payload);

#endif
