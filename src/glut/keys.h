/* GLFW's key codes and modifiers to GLUT's. */
#ifndef FGL_GLUT_KEYS_H
#define FGL_GLUT_KEYS_H

#include <stdbool.h>

int fgl_keys_modifiers(int glfw_mods);
/* GLUT_KEY_*, or 0 if it is not a special key. */
int fgl_keys_special(int glfw_key);
/* The character of a key whose press makes no printable one: control keys and Ctrl with a letter; on release,
 * also the character printed on the key, as on a US keyboard. 0 for none. */
int fgl_keys_character(int glfw_key, int glfw_mods, bool down);

#endif
