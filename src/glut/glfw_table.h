/* The functions of GLFW 3 that are used, found with dlsym when the first window opens. GLFW is not linked: a
 * headless program needs neither it nor X. */
#ifndef FGL_GLUT_GLFW_TABLE_H
#define FGL_GLUT_GLFW_TABLE_H

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

/* clang-format off: tables stand in columns */
/* F(result, name without "glfw", parameters) */
#define FGL_GLFW_FUNCTIONS(F)                                                                                \
    F(int, Init, (void))                                                                                     \
    F(GLFWerrorfun, SetErrorCallback, (GLFWerrorfun))                                                        \
    F(void, WindowHint, (int, int))                                                                          \
    F(GLFWwindow *, CreateWindow, (int, int, const char *, GLFWmonitor *, GLFWwindow *))                     \
    F(void, DestroyWindow, (GLFWwindow *))                                                                   \
    F(void, SetWindowUserPointer, (GLFWwindow *, void *))                                                    \
    F(void *, GetWindowUserPointer, (GLFWwindow *))                                                          \
    F(void, SetWindowTitle, (GLFWwindow *, const char *))                                                    \
    F(void, SetWindowSize, (GLFWwindow *, int, int))                                                         \
    F(void, GetWindowSize, (GLFWwindow *, int *, int *))                                                     \
    F(void, GetFramebufferSize, (GLFWwindow *, int *, int *))                                                \
    F(void, SetWindowPos, (GLFWwindow *, int, int))                                                          \
    F(void, GetWindowPos, (GLFWwindow *, int *, int *))                                                      \
    F(void, ShowWindow, (GLFWwindow *))                                                                      \
    F(void, HideWindow, (GLFWwindow *))                                                                      \
    F(void, IconifyWindow, (GLFWwindow *))                                                                   \
    F(void, SetWindowMonitor, (GLFWwindow *, GLFWmonitor *, int, int, int, int, int))                        \
    F(GLFWmonitor *, GetWindowMonitor, (GLFWwindow *))                                                       \
    F(GLFWmonitor *, GetPrimaryMonitor, (void))                                                              \
    F(const GLFWvidmode *, GetVideoMode, (GLFWmonitor *))                                                    \
    F(GLFWcursor *, CreateStandardCursor, (int))                                                             \
    F(void, SetCursor, (GLFWwindow *, GLFWcursor *))                                                         \
    F(void, SetInputMode, (GLFWwindow *, int, int))                                                          \
    F(void, SetCursorPos, (GLFWwindow *, double, double))                                                    \
    F(void, GetCursorPos, (GLFWwindow *, double *, double *))                                                \
    F(void, MakeContextCurrent, (GLFWwindow *))                                                              \
    F(void, SwapInterval, (int))                                                                             \
    F(void, SwapBuffers, (GLFWwindow *))                                                                     \
    F(GLFWglproc, GetProcAddress, (const char *))                                                            \
    F(void, PollEvents, (void))                                                                              \
    F(void, WaitEvents, (void))                                                                              \
    F(void, WaitEventsTimeout, (double))                                                                     \
    F(GLFWkeyfun, SetKeyCallback, (GLFWwindow *, GLFWkeyfun))                                                \
    F(GLFWcharfun, SetCharCallback, (GLFWwindow *, GLFWcharfun))                                             \
    F(GLFWmousebuttonfun, SetMouseButtonCallback, (GLFWwindow *, GLFWmousebuttonfun))                        \
    F(GLFWcursorposfun, SetCursorPosCallback, (GLFWwindow *, GLFWcursorposfun))                              \
    F(GLFWcursorenterfun, SetCursorEnterCallback, (GLFWwindow *, GLFWcursorenterfun))                        \
    F(GLFWscrollfun, SetScrollCallback, (GLFWwindow *, GLFWscrollfun))                                       \
    F(GLFWframebuffersizefun, SetFramebufferSizeCallback, (GLFWwindow *, GLFWframebuffersizefun))            \
    F(GLFWwindowposfun, SetWindowPosCallback, (GLFWwindow *, GLFWwindowposfun))                              \
    F(GLFWwindowrefreshfun, SetWindowRefreshCallback, (GLFWwindow *, GLFWwindowrefreshfun))                  \
    F(GLFWwindowclosefun, SetWindowCloseCallback, (GLFWwindow *, GLFWwindowclosefun))                        \
    F(GLFWwindowiconifyfun, SetWindowIconifyCallback, (GLFWwindow *, GLFWwindowiconifyfun))
/* clang-format on */

struct glfw {
#define F(result, name, parameters) result(*name) parameters;
    FGL_GLFW_FUNCTIONS(F)
#undef F
};

/* Loads GLFW and initializes it, once; prints a line and exits with status 1 if it cannot. */
const struct glfw *fgl_glfw(void);

#endif
