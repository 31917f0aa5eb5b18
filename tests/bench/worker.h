/* A process that has loaded one of the two libraries, and draws with it. */
#ifndef BENCH_WORKER_H
#define BENCH_WORKER_H

enum { MAX_RENDERER = 80 };

double now_ms(void);

/* Sends the renderer's name, MAX_RENDERER characters; then for each scene's index that is asked, an int, its milliseconds per frame, a
 * double. Does not return. */
void work(const char *library, int requests, int answers);

/* Loads the library and draws the first frame of the first scene. */
void draw_first_frame(const char *library);

#endif
