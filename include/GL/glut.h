/*
 * GL/glut.h - the GLUT 3.7 API (Mark J. Kilgard, "The OpenGL Utility Toolkit Programming Interface", version 3)
 * with the few additions of freeglut that programs commonly use. Constants have GLUT's values.
 *
 * Copyright (c) 2026 The FixedGL authors. MIT License, see LICENSE.
 *
 * A program runs in a window where there is a display, and headless where there is none or where one of the
 * FIXEDGL_* variables asks for a picture: docs/glut.md lists them.
 *
 * Errors: GLUT has no error codes. A call that needs glutInit or a current window and has none prints one line
 * that starts with "fixedglut:" to stderr and ends the program with status 1; a wrong id or value prints such a
 * line and changes nothing. No function here raises a GL error of its own. "The current window" is the one last
 * created or set with glutSetWindow; callbacks run with their own window current. Window coordinates have their
 * origin at the top left, y down, in pixels.
 */
#ifndef GLUT_H
#define GLUT_H

#include <stdlib.h> /* programs count on GLUT's header for exit */
#include <GL/gl.h>
#include <GL/glu.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GLUT_API_VERSION 4
#define GLUT_XLIB_IMPLEMENTATION 13
#ifndef GLUTAPIENTRY
#define GLUTAPIENTRY
#endif
#ifndef GLUTCALLBACK
#define GLUTCALLBACK
#endif
#if defined(__GNUC__)
#define GLUTAPI extern __attribute__((visibility("default")))
#else
#define GLUTAPI extern
#endif

/* Display modes of glutInitDisplayMode, to be ORed. */
#define GLUT_RGB 0
#define GLUT_RGBA GLUT_RGB
#define GLUT_INDEX 1
#define GLUT_SINGLE 0
#define GLUT_DOUBLE 2
#define GLUT_ACCUM 4
#define GLUT_ALPHA 8
#define GLUT_DEPTH 16
#define GLUT_STENCIL 32
#define GLUT_MULTISAMPLE 128
#define GLUT_STEREO 256
#define GLUT_LUMINANCE 512

/* Mouse buttons and their states. Wheel steps without a wheel callback arrive as buttons 3 (up) and 4 (down). */
#define GLUT_LEFT_BUTTON 0
#define GLUT_MIDDLE_BUTTON 1
#define GLUT_RIGHT_BUTTON 2
#define GLUT_DOWN 0
#define GLUT_UP 1

/* Keys of the special callbacks. */
#define GLUT_KEY_F1 1
#define GLUT_KEY_F2 2
#define GLUT_KEY_F3 3
#define GLUT_KEY_F4 4
#define GLUT_KEY_F5 5
#define GLUT_KEY_F6 6
#define GLUT_KEY_F7 7
#define GLUT_KEY_F8 8
#define GLUT_KEY_F9 9
#define GLUT_KEY_F10 10
#define GLUT_KEY_F11 11
#define GLUT_KEY_F12 12
#define GLUT_KEY_LEFT 100
#define GLUT_KEY_UP 101
#define GLUT_KEY_RIGHT 102
#define GLUT_KEY_DOWN 103
#define GLUT_KEY_PAGE_UP 104
#define GLUT_KEY_PAGE_DOWN 105
#define GLUT_KEY_HOME 106
#define GLUT_KEY_END 107
#define GLUT_KEY_INSERT 108

/* Values passed to the entry, menu status, visibility and window status callbacks. */
#define GLUT_LEFT 0
#define GLUT_ENTERED 1
#define GLUT_MENU_NOT_IN_USE 0
#define GLUT_MENU_IN_USE 1
#define GLUT_NOT_VISIBLE 0
#define GLUT_VISIBLE 1
#define GLUT_HIDDEN 0
#define GLUT_FULLY_RETAINED 1
#define GLUT_PARTIALLY_RETAINED 2
#define GLUT_FULLY_COVERED 3

/* Components for glutSetColor and glutGetColor; layers for glutUseLayer. */
#define GLUT_RED 0
#define GLUT_GREEN 1
#define GLUT_BLUE 2
#define GLUT_NORMAL 0
#define GLUT_OVERLAY 1

/* Queries of glutGet. */
#define GLUT_WINDOW_X 100
#define GLUT_WINDOW_Y 101
#define GLUT_WINDOW_WIDTH 102
#define GLUT_WINDOW_HEIGHT 103
#define GLUT_WINDOW_BUFFER_SIZE 104
#define GLUT_WINDOW_STENCIL_SIZE 105
#define GLUT_WINDOW_DEPTH_SIZE 106
#define GLUT_WINDOW_RED_SIZE 107
#define GLUT_WINDOW_GREEN_SIZE 108
#define GLUT_WINDOW_BLUE_SIZE 109
#define GLUT_WINDOW_ALPHA_SIZE 110
#define GLUT_WINDOW_ACCUM_RED_SIZE 111
#define GLUT_WINDOW_ACCUM_GREEN_SIZE 112
#define GLUT_WINDOW_ACCUM_BLUE_SIZE 113
#define GLUT_WINDOW_ACCUM_ALPHA_SIZE 114
#define GLUT_WINDOW_DOUBLEBUFFER 115
#define GLUT_WINDOW_RGBA 116
#define GLUT_WINDOW_PARENT 117
#define GLUT_WINDOW_NUM_CHILDREN 118
#define GLUT_WINDOW_COLORMAP_SIZE 119
#define GLUT_WINDOW_NUM_SAMPLES 120
#define GLUT_WINDOW_STEREO 121
#define GLUT_WINDOW_CURSOR 122
#define GLUT_WINDOW_FORMAT_ID 123
#define GLUT_SCREEN_WIDTH 200
#define GLUT_SCREEN_HEIGHT 201
#define GLUT_SCREEN_WIDTH_MM 202
#define GLUT_SCREEN_HEIGHT_MM 203
#define GLUT_MENU_NUM_ITEMS 300
#define GLUT_DISPLAY_MODE_POSSIBLE 400
#define GLUT_INIT_WINDOW_X 500
#define GLUT_INIT_WINDOW_Y 501
#define GLUT_INIT_WINDOW_WIDTH 502
#define GLUT_INIT_WINDOW_HEIGHT 503
#define GLUT_INIT_DISPLAY_MODE 504
#define GLUT_ELAPSED_TIME 700
#define GLUT_VERSION 0x01FC /* freeglut's: 10000 major + 100 minor + patch */

/* Queries of glutDeviceGet. */
#define GLUT_HAS_KEYBOARD 600
#define GLUT_HAS_MOUSE 601
#define GLUT_HAS_SPACEBALL 602
#define GLUT_HAS_DIAL_AND_BUTTON_BOX 603
#define GLUT_HAS_TABLET 604
#define GLUT_NUM_MOUSE_BUTTONS 605
#define GLUT_NUM_SPACEBALL_BUTTONS 606
#define GLUT_NUM_BUTTON_BOX_BUTTONS 607
#define GLUT_NUM_DIALS 608
#define GLUT_NUM_TABLET_BUTTONS 609
#define GLUT_DEVICE_IGNORE_KEY_REPEAT 610
#define GLUT_DEVICE_KEY_REPEAT 611
#define GLUT_HAS_JOYSTICK 612
#define GLUT_OWNS_JOYSTICK 613
#define GLUT_JOYSTICK_BUTTONS 614
#define GLUT_JOYSTICK_AXES 615
#define GLUT_JOYSTICK_POLL_RATE 616

/* Queries of glutLayerGet and glutVideoResizeGet. */
#define GLUT_OVERLAY_POSSIBLE 800
#define GLUT_LAYER_IN_USE 801
#define GLUT_HAS_OVERLAY 802
#define GLUT_TRANSPARENT_INDEX 803
#define GLUT_NORMAL_DAMAGED 804
#define GLUT_OVERLAY_DAMAGED 805
#define GLUT_VIDEO_RESIZE_POSSIBLE 900
#define GLUT_VIDEO_RESIZE_IN_USE 901
#define GLUT_VIDEO_RESIZE_X_DELTA 902
#define GLUT_VIDEO_RESIZE_Y_DELTA 903
#define GLUT_VIDEO_RESIZE_WIDTH_DELTA 904
#define GLUT_VIDEO_RESIZE_HEIGHT_DELTA 905
#define GLUT_VIDEO_RESIZE_X 906
#define GLUT_VIDEO_RESIZE_Y 907
#define GLUT_VIDEO_RESIZE_WIDTH 908
#define GLUT_VIDEO_RESIZE_HEIGHT 909

/* Bits of glutGetModifiers. */
#define GLUT_ACTIVE_SHIFT 1
#define GLUT_ACTIVE_CTRL 2
#define GLUT_ACTIVE_ALT 4

/* Cursors of glutSetCursor. */
#define GLUT_CURSOR_RIGHT_ARROW 0
#define GLUT_CURSOR_LEFT_ARROW 1
#define GLUT_CURSOR_INFO 2
#define GLUT_CURSOR_DESTROY 3
#define GLUT_CURSOR_HELP 4
#define GLUT_CURSOR_CYCLE 5
#define GLUT_CURSOR_SPRAY 6
#define GLUT_CURSOR_WAIT 7
#define GLUT_CURSOR_TEXT 8
#define GLUT_CURSOR_CROSSHAIR 9
#define GLUT_CURSOR_UP_DOWN 10
#define GLUT_CURSOR_LEFT_RIGHT 11
#define GLUT_CURSOR_TOP_SIDE 12
#define GLUT_CURSOR_BOTTOM_SIDE 13
#define GLUT_CURSOR_LEFT_SIDE 14
#define GLUT_CURSOR_RIGHT_SIDE 15
#define GLUT_CURSOR_TOP_LEFT_CORNER 16
#define GLUT_CURSOR_TOP_RIGHT_CORNER 17
#define GLUT_CURSOR_BOTTOM_RIGHT_CORNER 18
#define GLUT_CURSOR_BOTTOM_LEFT_CORNER 19
#define GLUT_CURSOR_INHERIT 100
#define GLUT_CURSOR_NONE 101
#define GLUT_CURSOR_FULL_CROSSHAIR 102

/* Key repeat, joystick buttons and game mode queries. */
#define GLUT_KEY_REPEAT_OFF 0
#define GLUT_KEY_REPEAT_ON 1
#define GLUT_KEY_REPEAT_DEFAULT 2
#define GLUT_JOYSTICK_BUTTON_A 1
#define GLUT_JOYSTICK_BUTTON_B 2
#define GLUT_JOYSTICK_BUTTON_C 4
#define GLUT_JOYSTICK_BUTTON_D 8
#define GLUT_GAME_MODE_ACTIVE 0
#define GLUT_GAME_MODE_POSSIBLE 1
#define GLUT_GAME_MODE_WIDTH 2
#define GLUT_GAME_MODE_HEIGHT 3
#define GLUT_GAME_MODE_PIXEL_DEPTH 4
#define GLUT_GAME_MODE_REFRESH_RATE 5
#define GLUT_GAME_MODE_DISPLAY_CHANGED 6

/* freeglut: the option of glutSetOption and its values. */
#define GLUT_ACTION_ON_WINDOW_CLOSE 0x01F9
#define GLUT_ACTION_EXIT 0
#define GLUT_ACTION_GLUTMAINLOOP_RETURNS 1
#define GLUT_ACTION_CONTINUE_EXECUTION 2

/* Fonts: opaque handles. The glyphs are FixedGL's own, in GLUT's cell sizes. */
GLUTAPI void *glutStrokeRoman, *glutStrokeMonoRoman;
GLUTAPI void *glutBitmap9By15, *glutBitmap8By13, *glutBitmapTimesRoman10, *glutBitmapTimesRoman24;
GLUTAPI void *glutBitmapHelvetica10, *glutBitmapHelvetica12, *glutBitmapHelvetica18;
#define GLUT_STROKE_ROMAN ((void *)&glutStrokeRoman)
#define GLUT_STROKE_MONO_ROMAN ((void *)&glutStrokeMonoRoman)
#define GLUT_BITMAP_9_BY_15 ((void *)&glutBitmap9By15)
#define GLUT_BITMAP_8_BY_13 ((void *)&glutBitmap8By13)
#define GLUT_BITMAP_TIMES_ROMAN_10 ((void *)&glutBitmapTimesRoman10)
#define GLUT_BITMAP_TIMES_ROMAN_24 ((void *)&glutBitmapTimesRoman24)
#define GLUT_BITMAP_HELVETICA_10 ((void *)&glutBitmapHelvetica10)
#define GLUT_BITMAP_HELVETICA_12 ((void *)&glutBitmapHelvetica12)
#define GLUT_BITMAP_HELVETICA_18 ((void *)&glutBitmapHelvetica18)

/* ---- Initialization (GLUT 3, section 3). To be called before glutCreateWindow. ---- */

/* Starts the library. Removes from argv, and honors, -geometry WxH+X+Y; removes and ignores -display NAME,
 * -iconic, -indirect, -direct, -sync and -gldebug. Exits with status 2 on a FIXEDGL_* variable it cannot read. */
GLUTAPI void GLUTAPIENTRY glutInit(int *argcp, char **argv);
/* Position and size of windows created later; a size that is not positive is ignored with a warning. */
GLUTAPI void GLUTAPIENTRY glutInitWindowPosition(int x, int y);
GLUTAPI void GLUTAPIENTRY glutInitWindowSize(int width, int height);
/* Display mode of windows created later. Every window has 8-bit RGBA, 24-bit depth and 8-bit stencil buffers;
 * GLUT_ACCUM adds a 16-bit accumulation buffer. GLUT_INDEX gives an 8-bit color index buffer in place of RGBA,
 * without accumulation, and a colormap. GLUT_STEREO and GLUT_MULTISAMPLE are not available and are ignored with a
 * warning. */
GLUTAPI void GLUTAPIENTRY glutInitDisplayMode(unsigned int mode);
/* The same from words such as "rgb double depth>=16"; the comparisons are not evaluated. */
GLUTAPI void GLUTAPIENTRY glutInitDisplayString(const char *words);

/* ---- Main loop ---- */

/* Handles events until the program exits. Headless, it draws the frames and runs the events asked for, writes
 * the picture and calls exit(0). Returns only after glutLeaveMainLoop or, with
 * GLUT_ACTION_GLUTMAINLOOP_RETURNS, when a window is closed. */
GLUTAPI void GLUTAPIENTRY glutMainLoop(void);
/* freeglut: one turn of the loop; makes glutMainLoop return. Headless, a turn is one frame or one event. */
GLUTAPI void GLUTAPIENTRY glutMainLoopEvent(void);
GLUTAPI void GLUTAPIENTRY glutLeaveMainLoop(void);
/* freeglut: GLUT_ACTION_ON_WINDOW_CLOSE; anything else is ignored with a warning. */
GLUTAPI void GLUTAPIENTRY glutSetOption(GLenum option, int value);

/* ---- Windows (sections 4 and 5). Ids start at 1. ---- */

/* Creates a window, makes it current and returns its id; exits with status 1 if it cannot. */
GLUTAPI int GLUTAPIENTRY glutCreateWindow(const char *title);
/* A child with its own context, drawn over its parent at (x, y). Returns its id, or 0 for a bad parent or size. */
GLUTAPI int GLUTAPIENTRY glutCreateSubWindow(int parent, int x, int y, int width, int height);
/* Destroys a window and its children. */
GLUTAPI void GLUTAPIENTRY glutDestroyWindow(int window);
GLUTAPI void GLUTAPIENTRY glutSetWindow(int window);
/* The current window's id, 0 if there is none. */
GLUTAPI int GLUTAPIENTRY glutGetWindow(void);
GLUTAPI void GLUTAPIENTRY glutSetWindowTitle(const char *title);
GLUTAPI void GLUTAPIENTRY glutSetIconTitle(const char *title);
/* Size and position take effect when control returns to the main loop. */
GLUTAPI void GLUTAPIENTRY glutReshapeWindow(int width, int height);
GLUTAPI void GLUTAPIENTRY glutPositionWindow(int x, int y);
/* Headless, a full screen window keeps its size. */
GLUTAPI void GLUTAPIENTRY glutFullScreen(void);
GLUTAPI void GLUTAPIENTRY glutShowWindow(void);
GLUTAPI void GLUTAPIENTRY glutHideWindow(void);
GLUTAPI void GLUTAPIENTRY glutIconifyWindow(void);
/* Stacking order among sibling child windows; of no effect on others. */
GLUTAPI void GLUTAPIENTRY glutPushWindow(void);
GLUTAPI void GLUTAPIENTRY glutPopWindow(void);
/* Asks for the display callback to run; many requests make one call. */
GLUTAPI void GLUTAPIENTRY glutPostRedisplay(void);
GLUTAPI void GLUTAPIENTRY glutPostWindowRedisplay(int window);
/* Finishes drawing and shows the picture. There is one color buffer, so nothing is exchanged. */
GLUTAPI void GLUTAPIENTRY glutSwapBuffers(void);
GLUTAPI void GLUTAPIENTRY glutSetCursor(int cursor);
GLUTAPI void GLUTAPIENTRY glutWarpPointer(int x, int y);

/* Overlays do not exist: these do nothing. */
GLUTAPI void GLUTAPIENTRY glutEstablishOverlay(void);
GLUTAPI void GLUTAPIENTRY glutRemoveOverlay(void);
GLUTAPI void GLUTAPIENTRY glutUseLayer(GLenum layer);
GLUTAPI void GLUTAPIENTRY glutPostOverlayRedisplay(void);
GLUTAPI void GLUTAPIENTRY glutPostWindowOverlayRedisplay(int window);
GLUTAPI void GLUTAPIENTRY glutShowOverlay(void);
GLUTAPI void GLUTAPIENTRY glutHideOverlay(void);

/* ---- Menus (section 6) ---- */

/* Creates a menu, makes it current and returns its id. */
GLUTAPI int GLUTAPIENTRY glutCreateMenu(void (*func)(int value));
GLUTAPI void GLUTAPIENTRY glutDestroyMenu(int menu);
GLUTAPI int GLUTAPIENTRY glutGetMenu(void);
GLUTAPI void GLUTAPIENTRY glutSetMenu(int menu);
/* Add to, change in or remove from the current menu; items count from 1. */
GLUTAPI void GLUTAPIENTRY glutAddMenuEntry(const char *label, int value);
GLUTAPI void GLUTAPIENTRY glutAddSubMenu(const char *label, int submenu);
GLUTAPI void GLUTAPIENTRY glutChangeToMenuEntry(int item, const char *label, int value);
GLUTAPI void GLUTAPIENTRY glutChangeToSubMenu(int item, const char *label, int submenu);
GLUTAPI void GLUTAPIENTRY glutRemoveMenuItem(int item);
/* Ties the current menu to a button of the current window. That button's presses then open the menu: with a
 * FIXEDGL_EVENTS script by its "menu" statement; windowed, menus are not drawn (docs/glut.md). */
GLUTAPI void GLUTAPIENTRY glutAttachMenu(int button);
GLUTAPI void GLUTAPIENTRY glutDetachMenu(int button);

/* ---- Callbacks (section 7), of the current window unless said; NULL removes one. ---- */

GLUTAPI void GLUTAPIENTRY glutDisplayFunc(void (*func)(void));
/* Without one, a new size calls glViewport(0, 0, width, height). */
GLUTAPI void GLUTAPIENTRY glutReshapeFunc(void (*func)(int width, int height));
GLUTAPI void GLUTAPIENTRY glutKeyboardFunc(void (*func)(unsigned char key, int x, int y));
GLUTAPI void GLUTAPIENTRY glutKeyboardUpFunc(void (*func)(unsigned char key, int x, int y));
GLUTAPI void GLUTAPIENTRY glutSpecialFunc(void (*func)(int key, int x, int y));
GLUTAPI void GLUTAPIENTRY glutSpecialUpFunc(void (*func)(int key, int x, int y));
GLUTAPI void GLUTAPIENTRY glutMouseFunc(void (*func)(int button, int state, int x, int y));
/* Motion with a button held, and without. */
GLUTAPI void GLUTAPIENTRY glutMotionFunc(void (*func)(int x, int y));
GLUTAPI void GLUTAPIENTRY glutPassiveMotionFunc(void (*func)(int x, int y));
/* freeglut: a wheel step, direction +1 or -1. */
GLUTAPI void GLUTAPIENTRY glutMouseWheelFunc(void (*func)(int wheel, int direction, int x, int y));
GLUTAPI void GLUTAPIENTRY glutEntryFunc(void (*func)(int state));
GLUTAPI void GLUTAPIENTRY glutVisibilityFunc(void (*func)(int state));
GLUTAPI void GLUTAPIENTRY glutWindowStatusFunc(void (*func)(int state));
/* freeglut: the window is about to be destroyed. */
GLUTAPI void GLUTAPIENTRY glutCloseFunc(void (*func)(void));
/* Of the program: called whenever there is nothing else to do; headless, once per frame after the first. */
GLUTAPI void GLUTAPIENTRY glutIdleFunc(void (*func)(void));
/* Of the program: calls func(value) once, `milliseconds` from now or later. Cannot be cancelled. */
GLUTAPI void GLUTAPIENTRY glutTimerFunc(unsigned int milliseconds, void (*func)(int value), int value);
/* Of the program: a menu is opened or closed. */
GLUTAPI void GLUTAPIENTRY glutMenuStatusFunc(void (*func)(int status, int x, int y));
GLUTAPI void GLUTAPIENTRY glutMenuStateFunc(void (*func)(int status));
/* Devices that do not exist: accepted, never called. */
GLUTAPI void GLUTAPIENTRY glutOverlayDisplayFunc(void (*func)(void));
GLUTAPI void GLUTAPIENTRY glutSpaceballMotionFunc(void (*func)(int x, int y, int z));
GLUTAPI void GLUTAPIENTRY glutSpaceballRotateFunc(void (*func)(int x, int y, int z));
GLUTAPI void GLUTAPIENTRY glutSpaceballButtonFunc(void (*func)(int button, int state));
GLUTAPI void GLUTAPIENTRY glutButtonBoxFunc(void (*func)(int button, int state));
GLUTAPI void GLUTAPIENTRY glutDialsFunc(void (*func)(int dial, int value));
GLUTAPI void GLUTAPIENTRY glutTabletMotionFunc(void (*func)(int x, int y));
GLUTAPI void GLUTAPIENTRY glutTabletButtonFunc(void (*func)(int button, int state, int x, int y));
GLUTAPI void GLUTAPIENTRY glutJoystickFunc(void (*func)(unsigned int buttons, int x, int y, int z), int interval);
GLUTAPI void GLUTAPIENTRY glutForceJoystickFunc(void);

/* ---- State (section 9) ---- */

/* -1 with a warning for an unknown query. GLUT_ELAPSED_TIME is in milliseconds since glutInit; headless, it is
 * the virtual clock. */
GLUTAPI int GLUTAPIENTRY glutGet(GLenum query);
GLUTAPI int GLUTAPIENTRY glutDeviceGet(GLenum query);
GLUTAPI int GLUTAPIENTRY glutLayerGet(GLenum query);
/* The modifier keys held during the present keyboard, special or mouse callback. */
GLUTAPI int GLUTAPIENTRY glutGetModifiers(void);
/* 1 if the word `extension` is in the current context's GL_EXTENSIONS. */
GLUTAPI int GLUTAPIENTRY glutExtensionSupported(const char *extension);
/* Prints and clears the pending GL errors. */
GLUTAPI void GLUTAPIENTRY glutReportErrors(void);
GLUTAPI void GLUTAPIENTRY glutIgnoreKeyRepeat(int ignore);
GLUTAPI void GLUTAPIENTRY glutSetKeyRepeat(int mode);

/* ---- Colormaps of GLUT_INDEX windows (section 8): 256 cells, black at first, looked up when a picture is shown. ---- */

/* Sets a cell of the current window's colormap, each value clamped to [0,1]. A window without colormap or a cell that
 * does not exist is ignored with a warning. */
GLUTAPI void GLUTAPIENTRY glutSetColor(int cell, GLfloat red, GLfloat green, GLfloat blue);
/* GLUT_RED, GLUT_GREEN or GLUT_BLUE of a cell; -1 for anything that does not exist. */
GLUTAPI GLfloat GLUTAPIENTRY glutGetColor(int cell, int component);
/* The current window's colormap becomes a copy of that of `window`; ignored with a warning if either has none. */
GLUTAPI void GLUTAPIENTRY glutCopyColormap(int window);

/* ---- Fonts (section 10). An unknown font prints a warning; characters without a glyph draw nothing. ---- */

/* Draws with glBitmap at the raster position, which moves by the character's width. */
GLUTAPI void GLUTAPIENTRY glutBitmapCharacter(void *font, int character);
GLUTAPI int GLUTAPIENTRY glutBitmapWidth(void *font, int character);
GLUTAPI int GLUTAPIENTRY glutBitmapLength(void *font, const unsigned char *string);
/* Draws line strips in object space and translates the modelview by the width; capitals are 100 units high. */
GLUTAPI void GLUTAPIENTRY glutStrokeCharacter(void *font, int character);
GLUTAPI int GLUTAPIENTRY glutStrokeWidth(void *font, int character);
GLUTAPI int GLUTAPIENTRY glutStrokeLength(void *font, const unsigned char *string);

/* ---- Shapes (section 11), with freeglut's tessellation: equal vertices, normals and primitives. Each draws
 *      from client arrays and leaves the vertex and normal arrays disabled. Counts that cannot make a surface
 *      draw nothing. ---- */

/* Around the origin, poles on the z axis; slices >= 1, stacks >= 2. */
GLUTAPI void GLUTAPIENTRY glutWireSphere(double radius, GLint slices, GLint stacks);
GLUTAPI void GLUTAPIENTRY glutSolidSphere(double radius, GLint slices, GLint stacks);
/* Base at z = 0, apex at z = height; slices >= 1, stacks >= 1. */
GLUTAPI void GLUTAPIENTRY glutWireCone(double base, double height, GLint slices, GLint stacks);
GLUTAPI void GLUTAPIENTRY glutSolidCone(double base, double height, GLint slices, GLint stacks);
/* Around the z axis; sides >= 2 around the tube of radius `inner`, rings >= 2 along the circle `outer`. */
GLUTAPI void GLUTAPIENTRY glutWireTorus(double inner, double outer, GLint sides, GLint rings);
GLUTAPI void GLUTAPIENTRY glutSolidTorus(double inner, double outer, GLint sides, GLint rings);
/* An edge of length `size`. */
GLUTAPI void GLUTAPIENTRY glutWireCube(double size);
GLUTAPI void GLUTAPIENTRY glutSolidCube(double size);
/* Vertices at distance 1, for the dodecahedron sqrt(3). The icosahedron's normals are 0.957 long, as freeglut's. */
GLUTAPI void GLUTAPIENTRY glutWireTetrahedron(void);
GLUTAPI void GLUTAPIENTRY glutSolidTetrahedron(void);
GLUTAPI void GLUTAPIENTRY glutWireOctahedron(void);
GLUTAPI void GLUTAPIENTRY glutSolidOctahedron(void);
GLUTAPI void GLUTAPIENTRY glutWireDodecahedron(void);
GLUTAPI void GLUTAPIENTRY glutSolidDodecahedron(void);
GLUTAPI void GLUTAPIENTRY glutWireIcosahedron(void);
GLUTAPI void GLUTAPIENTRY glutSolidIcosahedron(void);
/* Newell's teapot, front faces clockwise as GLUT has always drawn it. The solid one has texture coordinates. */
GLUTAPI void GLUTAPIENTRY glutWireTeapot(double size);
GLUTAPI void GLUTAPIENTRY glutSolidTeapot(double size);

/* ---- Game mode and video resizing ---- */

/* Takes the size from "WxH:depth@rate"; the rest is ignored. */
GLUTAPI void GLUTAPIENTRY glutGameModeString(const char *mode);
/* Opens an ordinary window of that size; returns its id. Leave destroys it. */
GLUTAPI int GLUTAPIENTRY glutEnterGameMode(void);
GLUTAPI void GLUTAPIENTRY glutLeaveGameMode(void);
GLUTAPI int GLUTAPIENTRY glutGameModeGet(GLenum query);
/* Not available: 0 for GLUT_VIDEO_RESIZE_POSSIBLE, -1 otherwise; the others do nothing. */
GLUTAPI int GLUTAPIENTRY glutVideoResizeGet(GLenum query);
GLUTAPI void GLUTAPIENTRY glutSetupVideoResizing(void);
GLUTAPI void GLUTAPIENTRY glutStopVideoResizing(void);
GLUTAPI void GLUTAPIENTRY glutVideoResize(int x, int y, int width, int height);
GLUTAPI void GLUTAPIENTRY glutVideoPan(int x, int y, int width, int height);

#ifdef __cplusplus
}
#endif

#endif
