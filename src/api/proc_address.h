#ifndef FGL_API_PROC_ADDRESS_H
#define FGL_API_PROC_ADDRESS_H

typedef void (*fgl_proc)(void);

/* The entry point of that name, "glBegin", or NULL. */
fgl_proc fgl_proc_address(const char *name);

#endif
