/* Dirty bits: what a setter marks and validation (pipeline/validate.c) reads. Layer 1.
 * Each bit lists the commands that set it. A setter checks, stores, marks one bit and returns. */
#ifndef FGL_STATE_DIRTY_H
#define FGL_STATE_DIRTY_H

enum {
    DIRTY_MODELVIEW = 1 << 0,   /* any matrix command in GL_MODELVIEW mode */
    DIRTY_PROJECTION = 1 << 1,  /* any matrix command in GL_PROJECTION mode */
    DIRTY_TEXTURE_MATRIX = 1 << 2,
    DIRTY_LIGHT = 1 << 3,       /* glLight, glLightModel, glEnable(GL_LIGHTING, GL_LIGHTi), glShadeModel */
    DIRTY_MATERIAL = 1 << 4,    /* glMaterial, glColorMaterial, glEnable(GL_COLOR_MATERIAL) */
    DIRTY_CURRENT = 1 << 5,     /* the current colour, normal, ... as constants of a draw */
    DIRTY_NORMALIZE = 1 << 6,   /* glEnable(GL_NORMALIZE, GL_RESCALE_NORMAL) */
    DIRTY_CLIP_PLANE = 1 << 7,  /* glClipPlane, glEnable(GL_CLIP_PLANEi) */
    DIRTY_VIEWPORT = 1 << 8,    /* glViewport, glDepthRange */
    DIRTY_RASTER = 1 << 9,      /* glCullFace, glFrontFace, glPolygonMode, glPolygonOffset, glLineWidth, stipples, points; DIRTY_POINT besides for sizes */
    DIRTY_FRAGMENT = 1 << 10,   /* glDepthFunc, glBlendFunc, glColorMask, fog, alpha, stencil, logic op, ... */
    DIRTY_SCISSOR = 1 << 11,    /* glScissor, glEnable(GL_SCISSOR_TEST) */
    DIRTY_FRAMEBUFFER = 1 << 12, /* OSMesaMakeCurrent, glDrawBuffer */
    DIRTY_VARYING = 1 << 13,    /* which attributes differ by vertex in the next draw */
    DIRTY_FOG = 1 << 14,        /* glFog, glEnable(GL_FOG) */
    DIRTY_TEXTURE = 1 << 15,    /* glEnable(GL_TEXTURE_2D, GL_TEXTURE_GEN_S, ...), glTexEnv, glTexGen, glBindTexture,
                                   glTexParameter, images and deletions */
    DIRTY_POINT = 1 << 16,      /* glPointSize, glPointParameter: sizes by distance */
    DIRTY_PIXEL = 1 << 17,      /* glEnable of the imaging subset, matrix commands in GL_COLOR mode: no plan depends on it */
    DIRTY_ALL = (1 << 18) - 1
};

#endif
