/*
 * GL/osmesa.h - contexts that draw into the caller's memory, with the interface of Mesa's OSMesa.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 *
 * In short:
 *
 *     OSMesaContext ctx = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
 *     unsigned char *pixels = malloc((size_t)4 * width * height);
 *     if (!ctx || !OSMesaMakeCurrent(ctx, pixels, GL_UNSIGNED_BYTE, width, height))
 *         ...
 *     ... gl* calls ...
 *     glFinish();                     the picture is in pixels now, lowest row first
 *     OSMesaDestroyContext(ctx);
 *
 * A context is current in one thread at a time; several threads may draw at once, each with a context of its
 * own. The functions below raise no GL errors.
 */
#ifndef OSMESA_H
#define OSMESA_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of the interface, that of Mesa's header. */
#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* Formats of the caller's buffer: the order of the components of a pixel in memory, one byte each for
 * GL_UNSIGNED_BYTE. OSMESA_RGB_565 is one 16-bit word, red in its upper bits. OSMESA_COLOR_INDEX is
 * colour index mode: one byte a pixel, an index of 8 bits; GL_UNSIGNED_BYTE only, without accumulation buffer. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* Parameters of OSMesaPixelStore, also for OSMesaGetIntegerv. */
#define OSMESA_ROW_LENGTH 0x10
#define OSMESA_Y_UP 0x11

/* Parameters of OSMesaGetIntegerv. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* Attributes of OSMesaCreateContextAttribs, besides OSMESA_FORMAT, and the two values of OSMESA_PROFILE. */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context *OSMesaContext;

/* What OSMesaGetProcAddress returns, to be cast to the type of the function. */
typedef void (*OSMESAproc)(void);

/* Makes a context that draws pixels of format, with a 24-bit depth buffer, an 8-bit stencil buffer and no
 * accumulation buffer. It shares display lists, textures and buffer objects with sharelist unless that is
 * NULL. Returns NULL if the format is none of those above or memory is exhausted. The context is not made
 * current. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist);

/* The same with the buffers asked for. depthBits: below 16 no depth buffer, from 16 on 16 bits, from 24 on 24
 * bits; but any number above 0 gives 24 together with a stencil buffer. stencilBits above 0 give 8, accumBits
 * above 0 give 16 per component. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                                      GLint accumBits, OSMesaContext sharelist);

/* The same with a list of attributes and values, ended by 0: OSMESA_FORMAT, initially OSMESA_RGBA;
 * OSMESA_DEPTH_BITS, OSMESA_STENCIL_BITS and OSMESA_ACCUM_BITS, initially 0; OSMESA_PROFILE,
 * OSMESA_CONTEXT_MAJOR_VERSION and OSMESA_CONTEXT_MINOR_VERSION, the least version that the program needs.
 * Returns NULL for an unknown attribute or value, a negative number of bits, for OSMESA_CORE_PROFILE (it has
 * no fixed function) and for a version above 1.5. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int *attribList, OSMesaContext sharelist);

/* Frees the context and what is not shared; if it is current in the calling thread, none is afterwards. NULL
 * is allowed. The caller's buffer stays the caller's. */
GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext ctx);

/* Makes ctx current in the calling thread and buffer, height rows of width pixels, the place its picture goes
 * to. type is GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT or GL_FLOAT (RGBA order for the last two),
 * GL_UNSIGNED_SHORT_5_6_5 with OSMESA_RGB_565 and nothing else. The first call sets viewport and scissor
 * rectangle to width x height.
 *
 * Drawing goes to memory of the context, starting from zeros; buffer is written as a whole by glFlush and
 * glFinish, and never read. It must stay valid until another one, or another context, is made current. ctx
 * and buffer NULL: none is current. Returns GL_FALSE, and changes nothing, if only one of them is NULL, if
 * width or height is not in [1, OSMESA_MAX_WIDTH or _HEIGHT], if the type does not go with the format, or if
 * memory is exhausted. */
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext ctx, void *buffer, GLenum type, GLsizei width,
                                             GLsizei height);

/* Returns the context that is current in the calling thread, NULL if none is. */
GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);

/* Sets, for the current context, OSMESA_ROW_LENGTH, the pixels from one row of the buffer to the next (0,
 * initially: width), or OSMESA_Y_UP, whether the lowest row comes first (1, initially) or the highest (0).
 * They matter only when the picture is copied to the buffer. An unknown pname and a negative row length are
 * ignored. */
GLAPI void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value);

/* Writes, for the current context, OSMESA_WIDTH, OSMESA_HEIGHT, OSMESA_FORMAT, OSMESA_TYPE,
 * OSMESA_ROW_LENGTH, OSMESA_Y_UP, or the largest size, OSMESA_MAX_WIDTH and OSMESA_MAX_HEIGHT. For an unknown
 * pname nothing is written. */
GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint *value);

/* Writes the size of the depth buffer of c, the bytes of one value (2 for a 16-bit buffer, 4 for a 24-bit
 * one, the depth in the lower 24 bits and the stencil value in the upper 8) and its address: lowest row
 * first, without gaps, as it was at the last glFlush or glFinish, valid until the next OSMesaMakeCurrent.
 * Without a depth buffer it writes zeros and returns GL_FALSE. */
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext c, GLint *width, GLint *height,
                                                GLint *bytesPerValue, void **buffer);

/* Writes size, OSMESA_ format and address of the buffer that the caller bound to c. Without one it writes
 * zeros and returns GL_FALSE. */
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext c, GLint *width, GLint *height, GLint *format,
                                                void **buffer);

/* Returns the address of the gl or OSMesa function of that name, NULL if there is none. No context need be
 * current. */
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char *funcName);

/* In Mesa, sets whether fragment colors are clamped to [0,1]; its pictures do not depend on it, in a GL_FLOAT
 * buffer neither. Here it does nothing. */
GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);

/* In Mesa, switches on a filter over the finished picture before osmesa is made current. FixedGL has no such
 * filters: it does nothing. */
GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext osmesa, const char *filter, unsigned enable_value);

#ifdef __cplusplus
}
#endif

#endif
