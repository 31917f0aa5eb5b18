/* Setters of the per-window callbacks, and of those for what does not exist. */
#include <GL/freeglut.h>
#include "internal.h"

#define SETTER(function, field, parameters)                                                                  \
    void function(void(*func) parameters)                                                                    \
    {                                                                                                        \
        fgl_glut_require_window(#function)->call.field = func;                                               \
    }

SETTER(glutReshapeFunc, reshape, (int, int))
SETTER(glutKeyboardFunc, keyboard, (unsigned char, int, int))
SETTER(glutKeyboardUpFunc, keyboard_up, (unsigned char, int, int))
SETTER(glutSpecialFunc, special, (int, int, int))
SETTER(glutSpecialUpFunc, special_up, (int, int, int))
SETTER(glutMouseFunc, mouse, (int, int, int, int))
SETTER(glutMotionFunc, motion, (int, int))
SETTER(glutPassiveMotionFunc, passive_motion, (int, int))
SETTER(glutMouseWheelFunc, wheel, (int, int, int, int))
SETTER(glutEntryFunc, entry, (int))
SETTER(glutVisibilityFunc, visibility, (int))
SETTER(glutWindowStatusFunc, window_status, (int))
SETTER(glutCloseFunc, close, (void))
SETTER(glutWMCloseFunc, close, (void))

void glutDisplayFunc(void (*func)(void))
{
    struct window *w = fgl_glut_require_window("glutDisplayFunc");
    if (!func)
        fgl_glut_fail(1, "glutDisplayFunc: a window needs a display callback");
    w->call.display = func;
    w->redisplay = true;
}

void glutInitContextFunc(void (*func)(void))
{
    fgl_glut_require_window("glutInitContextFunc");
    if (func)
        func();
}

void glutIdleFunc(void (*func)(void))
{
    fgl_glut_require_init("glutIdleFunc");
    fgl_glut.idle = func;
}

void glutMenuStatusFunc(void (*func)(int, int, int))
{
    fgl_glut_require_init("glutMenuStatusFunc");
    fgl_glut.menu_status = func;
}

void glutMenuStateFunc(void (*func)(int))
{
    fgl_glut_require_init("glutMenuStateFunc");
    fgl_glut.menu_state = func;
}

#define NO_DEVICE(function, parameters)                                                                      \
    void function(void(*func) parameters)                                                                    \
    {                                                                                                        \
        (void)func;                                                                                          \
        fgl_glut_require_init(#function);                                                                    \
    }

NO_DEVICE(glutOverlayDisplayFunc, (void))
NO_DEVICE(glutSpaceballMotionFunc, (int, int, int))
NO_DEVICE(glutSpaceballRotateFunc, (int, int, int))
NO_DEVICE(glutSpaceballButtonFunc, (int, int))
NO_DEVICE(glutButtonBoxFunc, (int, int))
NO_DEVICE(glutDialsFunc, (int, int))
NO_DEVICE(glutTabletMotionFunc, (int, int))
NO_DEVICE(glutTabletButtonFunc, (int, int, int, int))
NO_DEVICE(glutPositionFunc, (int, int))
NO_DEVICE(glutAppStatusFunc, (int))
NO_DEVICE(glutMultiEntryFunc, (int, int))
NO_DEVICE(glutMultiButtonFunc, (int, int, int, int, int))
NO_DEVICE(glutMultiMotionFunc, (int, int, int))
NO_DEVICE(glutMultiPassiveFunc, (int, int, int))

void glutJoystickFunc(void (*func)(unsigned int, int, int, int), int interval)
{
    (void)func;
    (void)interval;
    fgl_glut_require_init("glutJoystickFunc");
}

void glutForceJoystickFunc(void)
{
    fgl_glut_require_init("glutForceJoystickFunc");
}
