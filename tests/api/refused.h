/* A command that raises an error changes nothing (GL 1.5, 2.5 "GL Errors"). */
#ifndef TESTS_API_REFUSED_H
#define TESTS_API_REFUSED_H

#include "api/spec_state.h"

static struct state_snapshot before, after;

/* The call raises `error` and changes nothing that glGet can show. */
#define REFUSED(error, call)                                                                                 \
    do {                                                                                                     \
        take_snapshot(&before);                                                                              \
        EXPECT_ERROR((error), call);                                                                         \
        take_snapshot(&after);                                                                               \
        check_unchanged(#call, __FILE__, __LINE__);                                                          \
    } while (0)

static inline void check_unchanged(const char *call, const char *file, int line)
{
    for (int i = 0; i < SPEC_VALUES; i++) {
        if (same_value(&before, &after, i))
            continue;
        print_error("%s:%d: %s changed %s\n", file, line, call, spec_state[i].text);
        _fail(file, line);
    }
}

enum { BAD = 0x1234 }; /* no enumerant */

#endif
