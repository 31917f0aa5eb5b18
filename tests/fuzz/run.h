/* Runs scripts on one OSMesa library, loaded with dlopen. */
#ifndef FUZZ_RUN_H
#define FUZZ_RUN_H

#include "script.h"

#include <stdint.h>

enum { MAX_RECORDS = 4096, MAX_DATA = 1 << 21, MAX_PIXEL_BYTES = 16 };

/* What a script made apart from the picture: errors and what queries wrote, in order. */
struct record {
    int op;
    unsigned error;   /* GL_NO_ERROR: data */
    int offset, size; /* in result.data */
};

struct result {
    int op;        /* the one that is running; script.ops when all have run */
    bool finished; /* the worker came to the end */
    int records, data_size;
    struct record record[MAX_RECORDS];
    unsigned char data[MAX_DATA];
    int pixel_bytes;
    unsigned char color[MAX_WIDTH * MAX_HEIGHT * MAX_PIXEL_BYTES]; /* as the caller's buffer has it, lowest row first */
    uint32_t depth[MAX_WIDTH * MAX_HEIGHT];                        /* depth in the lower 24 bits, stencil in the upper 8 */
};

/* Loads the library; missing[command] tells which commands it does not have. False, with a line on stderr: it is no
 * OSMesa library. */
bool run_load(const char *path, bool missing[COMMANDS]);
/* In a new context. */
void run_script(const struct script *script, struct result *result);

#endif
