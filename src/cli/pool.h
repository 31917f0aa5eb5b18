/* Several threads that work through one numbered list, and the lines they print as they go. */
#ifndef FGL_CLI_POOL_H
#define FGL_CLI_POOL_H

/* Calls work(context, index, &line) once for each index below `count`, from `jobs` threads; `line` is what to
 * print when the item is finished, allocated. Lines come out whole, in the order in which the items are
 * finished. On a terminal a counter shows how far the work is. */
void fgl_pool_run(int count, int jobs, void (*work)(void *context, int index, char **line), void *context);

#endif
