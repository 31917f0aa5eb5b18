/* Query objects belong to their context (GL 1.5, 4.1.7). */
#ifndef FGL_API_QUERY_H
#define FGL_API_QUERY_H

#include "state/context.h"

void fgl_queries_destroy(struct context *ctx);

#endif
