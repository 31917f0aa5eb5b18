/* What a GL library says about itself, and what the CPU can do that the reference's pictures depend on. */
#ifndef FGL_CLI_LIBRARY_H
#define FGL_CLI_LIBRARY_H

#include "support.h"

struct library_facts {
    char path[512];     /* the file that the loader found */
    char vendor[128];   /* GL_VENDOR */
    char renderer[128]; /* GL_RENDERER */
    char version[128];  /* GL_VERSION */
    int extensions;     /* how many GL_EXTENSIONS has */
    char package[128];  /* Debian package and version that the file belongs to, "" if unknown */
};

/* Loads a library with the OSMesa API, makes a small context and prints `name: value` lines on stdout: its
 * path, fixedglVersion if it has one, GL_VENDOR, GL_RENDERER, GL_VERSION, and its extensions, each on a line
 * of its own. The library stays loaded, so this is for a process of its own: `fixedgl info LIBRARY`. */
bool fgl_library_print(const char *library, struct problem *problem);

/* Asks another process for the facts, so that no library is ever loaded into this one. False if the library
 * cannot be loaded or makes no context. */
bool fgl_library_query(const char *library, struct library_facts *facts, struct problem *problem);

/* Path of the libfixedgl.so that belongs to this program (../lib from it), else its plain name; to be freed.
 */
char *fgl_library_own(void);

/* Path of a file that belongs to this program, given from its folder; its plain name if it is not there. To be freed.
 */
char *fgl_library_beside(const char *file);

/* Whether the CPU has fused multiply-add instructions. Without them Mesa's OSMesa draws other pictures. */
bool fgl_cpu_has_fma(void);

#endif
