/*
 * GL/freeglut.h - what freeglut 3.4 adds to GLUT (the header freeglut_ext.h of its users), but for the teacup, the
 * teaspoon and shapes in vertex attributes, which need what OpenGL 1.5 does not have. Constants have freeglut's values.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 *
 * Errors are those of GL/glut.h. glutMainLoopEvent, glutLeaveMainLoop, glutSetOption, glutCloseFunc and
 * glutMouseWheelFunc are declared there.
 */
#ifndef FREEGLUT_H
#define FREEGLUT_H

#include <stdarg.h>
#include <GL/glut.h>

#ifdef __cplusplus
extern "C" {
#endif

/* More keys of the special callbacks, and a bit of glutGetModifiers. */
#define GLUT_KEY_NUM_LOCK 0x006D
#define GLUT_KEY_BEGIN 0x006E
#define GLUT_KEY_DELETE 0x006F
#define GLUT_KEY_SHIFT_L 0x0070
#define GLUT_KEY_SHIFT_R 0x0071
#define GLUT_KEY_CTRL_L 0x0072
#define GLUT_KEY_CTRL_R 0x0073
#define GLUT_KEY_ALT_L 0x0074
#define GLUT_KEY_ALT_R 0x0075
#define GLUT_KEY_SUPER_L 0x0076
#define GLUT_KEY_SUPER_R 0x0077
#define GLUT_ACTIVE_SUPER 0x0008

/* More queries of glutGet; those that glutSetOption takes are marked. */
#define GLUT_INIT_STATE 0x007C
#define GLUT_WINDOW_SRGB 0x007D
#define GLUT_WINDOW_BORDER_WIDTH 0x01FA
#define GLUT_WINDOW_BORDER_HEIGHT 0x01FB
#define GLUT_WINDOW_HEADER_HEIGHT 0x01FB
#define GLUT_RENDERING_CONTEXT 0x01FD /* option; every window has a context of its own */
#define GLUT_DIRECT_RENDERING 0x01FE  /* option */
#define GLUT_FULL_SCREEN 0x01FF
#define GLUT_INIT_MAJOR_VERSION 0x0200
#define GLUT_INIT_MINOR_VERSION 0x0201
#define GLUT_INIT_FLAGS 0x0202
#define GLUT_INIT_PROFILE 0x0203
#define GLUT_SKIP_STALE_MOTION_EVENTS 0x0204       /* option */
#define GLUT_GEOMETRY_VISUALIZE_NORMALS 0x0205     /* option */
#define GLUT_STROKE_FONT_DRAW_JOIN_DOTS 0x0206     /* option */
#define GLUT_ALLOW_NEGATIVE_WINDOW_POSITION 0x0207 /* option */
#define GLUT_CREATE_NEW_CONTEXT 0
#define GLUT_USE_CURRENT_CONTEXT 1
#define GLUT_FORCE_INDIRECT_CONTEXT 0
#define GLUT_ALLOW_DIRECT_CONTEXT 1
#define GLUT_TRY_DIRECT_CONTEXT 2
#define GLUT_FORCE_DIRECT_CONTEXT 3

/* More display modes. GLUT_AUX* and GLUT_SRGB are not available and are ignored. */
#define GLUT_CAPTIONLESS 0x0400
#define GLUT_BORDERLESS 0x0800
#define GLUT_SRGB 0x1000
#define GLUT_AUX 0x1000
#define GLUT_AUX1 0x1000
#define GLUT_AUX2 0x2000
#define GLUT_AUX3 0x4000
#define GLUT_AUX4 0x8000

/* glutInitContextFlags, glutInitContextProfile, glutAppStatusFunc. */
#define GLUT_DEBUG 0x0001
#define GLUT_FORWARD_COMPATIBLE 0x0002
#define GLUT_CORE_PROFILE 0x0001
#define GLUT_COMPATIBILITY_PROFILE 0x0002
#define GLUT_APPSTATUS_PAUSE 0x0001
#define GLUT_APPSTATUS_RESUME 0x0002
#define GLUT_HAS_MULTI 1

typedef void (*GLUTproc)(void);

/* ---- Initialization and end ---- */

/* The version asked for; contexts are of OpenGL 1.5, and a higher one is answered with a warning. */
GLUTAPI void GLUTAPIENTRY glutInitContextVersion(int major, int minor);
/* Kept for glutGet, and of no effect. */
GLUTAPI void GLUTAPIENTRY glutInitContextFlags(int flags);
GLUTAPI void GLUTAPIENTRY glutInitContextProfile(int profile);
/* Called in place of printing: errors, after which the program ends even if it returns, and warnings. */
GLUTAPI void GLUTAPIENTRY glutInitErrorFunc(void (*func)(const char *format, va_list arguments));
GLUTAPI void GLUTAPIENTRY glutInitWarningFunc(void (*func)(const char *format, va_list arguments));
/* Destroys all windows and forgets glutInit; to be called outside of the main loop. Does nothing before glutInit. */
GLUTAPI void GLUTAPIENTRY glutExit(void);
/* The values that a display mode can have: `*size` of them, NULL for none. */
GLUTAPI int *GLUTAPIENTRY glutGetModeValues(GLenum mode, int *size);
/* A gl* function of this name, else NULL. */
GLUTAPI GLUTproc GLUTAPIENTRY glutGetProcAddress(const char *name);

/* ---- Windows and menus ---- */

GLUTAPI void GLUTAPIENTRY glutFullScreenToggle(void);
GLUTAPI void GLUTAPIENTRY glutLeaveFullScreen(void);
/* A pointer of the program's, kept with the current window or menu; NULL at first. */
GLUTAPI void *GLUTAPIENTRY glutGetWindowData(void);
GLUTAPI void GLUTAPIENTRY glutSetWindowData(void *data);
GLUTAPI void *GLUTAPIENTRY glutGetMenuData(void);
GLUTAPI void GLUTAPIENTRY glutSetMenuData(void *data);
/* Of no effect: menus are not drawn. */
GLUTAPI void GLUTAPIENTRY glutSetMenuFont(int menu, void *font);

/* ---- Callbacks ---- */

/* glutCloseFunc under its newer name. */
GLUTAPI void GLUTAPIENTRY glutWMCloseFunc(void (*func)(void));
/* Of the current menu: it is about to be destroyed. */
GLUTAPI void GLUTAPIENTRY glutMenuDestroyFunc(void (*func)(void));
/* Called at once, as every window here has its context when it is created. Of the current window. */
GLUTAPI void GLUTAPIENTRY glutInitContextFunc(void (*func)(void));
/* Accepted, never called: windows are not told where they are, and there are no other pointers than the mouse. */
GLUTAPI void GLUTAPIENTRY glutPositionFunc(void (*func)(int x, int y));
GLUTAPI void GLUTAPIENTRY glutAppStatusFunc(void (*func)(int status));
GLUTAPI void GLUTAPIENTRY glutMultiEntryFunc(void (*func)(int id, int state));
GLUTAPI void GLUTAPIENTRY glutMultiButtonFunc(void (*func)(int id, int x, int y, int button, int state));
GLUTAPI void GLUTAPIENTRY glutMultiMotionFunc(void (*func)(int id, int x, int y));
GLUTAPI void GLUTAPIENTRY glutMultiPassiveFunc(void (*func)(int id, int x, int y));

/* ---- Fonts ---- */

/* Height of a line of text: pixels, or object units. */
GLUTAPI int GLUTAPIENTRY glutBitmapHeight(void *font);
GLUTAPI GLfloat GLUTAPIENTRY glutStrokeHeight(void *font);
/* Draws each character; '\n' goes back to where the string began and one line down. */
GLUTAPI void GLUTAPIENTRY glutBitmapString(void *font, const unsigned char *string);
GLUTAPI void GLUTAPIENTRY glutStrokeString(void *font, const unsigned char *string);
/* glutStrokeWidth and glutStrokeLength without rounding. */
GLUTAPI GLfloat GLUTAPIENTRY glutStrokeWidthf(void *font, int character);
GLUTAPI GLfloat GLUTAPIENTRY glutStrokeLengthf(void *font, const unsigned char *string);

/* ---- Shapes, freeglut's vertices, normals and primitives ---- */

/* Base at z = 0, top at z = height; slices >= 1, stacks >= 1. */
GLUTAPI void GLUTAPIENTRY glutWireCylinder(double radius, double height, GLint slices, GLint stacks);
GLUTAPI void GLUTAPIENTRY glutSolidCylinder(double radius, double height, GLint slices, GLint stacks);
/* 12 faces, 2 high; the slanted ones' normals are sqrt(1/2) long, as freeglut's. */
GLUTAPI void GLUTAPIENTRY glutWireRhombicDodecahedron(void);
GLUTAPI void GLUTAPIENTRY glutSolidRhombicDodecahedron(void);
/* 4^levels tetrahedra about `offset`, levels 0 to 10. */
GLUTAPI void GLUTAPIENTRY glutWireSierpinskiSponge(int levels, double offset[3], double scale);
GLUTAPI void GLUTAPIENTRY glutSolidSierpinskiSponge(int levels, double offset[3], double scale);

#ifdef __cplusplus
}
#endif

#endif
