/* An OSMesa context: a GL context, its framebuffer, and the caller's buffer that pictures are copied to. Layer 6. */
#ifndef FGL_OSMESA_OSMESA_H
#define FGL_OSMESA_OSMESA_H

#include "GL/osmesa.h"
#include "framebuffer/framebuffer.h"
#include "state/context.h"

struct osmesa_context {
    struct context gl;
    struct framebuffer fb;
    GLenum format; /* OSMESA_RGBA ... */
    GLenum type;   /* of the caller's buffer */
    void *buffer;  /* the caller's; NULL until the first OSMesaMakeCurrent */
    int row_length; /* pixels; 0: the width */
    bool y_up;      /* row 0 of the buffer is the bottom */
    void *depth_snapshot; /* what OSMesaGetDepthBuffer gave away; brought up to date at every flush */
};

/* copy_out.c: the picture into the caller's buffer. */
void fgl_osmesa_copy_color(struct osmesa_context *c);
/* Depth, bottom row first, in 2 or 4 bytes; stencil in the top byte of 4. */
void fgl_osmesa_copy_depth(struct osmesa_context *c);

#endif
