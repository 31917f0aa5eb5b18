/* Translation of keys; no state. */
#include <ctype.h>
#include <GL/glut.h>
#include "glfw_table.h"
#include "keys.h"

int fgl_keys_modifiers(int mods)
{
    return (mods & GLFW_MOD_SHIFT ? GLUT_ACTIVE_SHIFT : 0) |
           (mods & GLFW_MOD_CONTROL ? GLUT_ACTIVE_CTRL : 0) | (mods & GLFW_MOD_ALT ? GLUT_ACTIVE_ALT : 0);
}

int fgl_keys_special(int key)
{
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return GLUT_KEY_F1 + key - GLFW_KEY_F1;
    switch (key) {
    case GLFW_KEY_LEFT: return GLUT_KEY_LEFT;
    case GLFW_KEY_UP: return GLUT_KEY_UP;
    case GLFW_KEY_RIGHT: return GLUT_KEY_RIGHT;
    case GLFW_KEY_DOWN: return GLUT_KEY_DOWN;
    case GLFW_KEY_PAGE_UP: return GLUT_KEY_PAGE_UP;
    case GLFW_KEY_PAGE_DOWN: return GLUT_KEY_PAGE_DOWN;
    case GLFW_KEY_HOME: return GLUT_KEY_HOME;
    case GLFW_KEY_END: return GLUT_KEY_END;
    case GLFW_KEY_INSERT: return GLUT_KEY_INSERT;
    default: return 0;
    }
}

int fgl_keys_character(int key, int mods, bool down)
{
    switch (key) {
    case GLFW_KEY_ESCAPE: return 27;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return 13;
    case GLFW_KEY_TAB: return 9;
    case GLFW_KEY_BACKSPACE: return 8;
    case GLFW_KEY_DELETE: return 127;
    default: break;
    }
    if (key < GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT)
        return 0;
    if (mods & GLFW_MOD_CONTROL)
        return key >= 'A' && key <= 'Z' ? key - 'A' + 1 : 0;
    if (down)
        return 0;
    return mods & GLFW_MOD_SHIFT ? key : tolower(key);
}
