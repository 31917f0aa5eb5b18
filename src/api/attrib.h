/* What of the attribute stacks ends with the context. */
#ifndef FGL_API_ATTRIB_H
#define FGL_API_ATTRIB_H

#include "state/context.h"

/* Frees the client attribute stack, and lets go of the buffer objects bound there and in the arrays. */
void fgl_client_attrib_destroy(struct context *ctx);

#endif
