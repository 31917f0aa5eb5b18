/* What every file of the command line tool uses: one-line problems, formatted strings, memory, text files. */
#ifndef FGL_CLI_SUPPORT_H
#define FGL_CLI_SUPPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Exit codes of every subcommand. */
enum exit_code {
    EXIT_SAME = 0,    /* done, nothing to report */
    EXIT_DIFFERS = 1, /* done, and something differs or failed */
    EXIT_USAGE = 2    /* could not start: wrong arguments, or a file or library that is needed is missing */
};

/* One line that says what went wrong, without a newline. */
struct problem {
    char text[512];
};

/* Fills `problem` as printf does and returns false, so that a check reads `return fgl_problem_set(...)`. */
bool fgl_problem_set(struct problem *problem, const char *format, ...);

/* Prints `fixedgl: message` on stderr and returns EXIT_USAGE. */
int fgl_complain(const char *format, ...);

/* A new string, formatted as printf does; the caller frees it. */
char *fgl_format(const char *format, ...);

/* Writes text with the characters that mean something in HTML replaced. */
void fgl_put_escaped(FILE *page, const char *text);

/* A new template for mkstemp or mkdtemp in the folder that TMPDIR names, else in /tmp; the caller frees it. */
char *fgl_temporary_name(void);

/* Zeroed memory for `count` things of `size` bytes; ends the program with a message when there is none. */
void *fgl_allocate(size_t count, size_t size);

/* `array` with room for one thing more than the `count` it holds. */
void *fgl_grow(void *array, size_t count, size_t size);

/* Cuts spaces, tabs and the line end off the end of `line`, and returns its first character that is not a
 * space. */
char *fgl_trim(char *line);

/* Copies what follows `name: ` at the start of `line`; false if the line does not start so. */
bool fgl_take_value(const char *line, const char *name, char *value, size_t room);

/* Calls `use` with each line of a text file, trimmed, that is neither empty nor a # comment, until one is
 * refused. `use` says why by its `problem`; the file and line number are put before it. */
bool fgl_read_lines(const char *path, bool (*use)(char *line, void *context, struct problem *problem),
                    void *context, struct problem *problem);

/* Makes a folder and the folders above it, where they are missing. */
bool fgl_make_folder(const char *path, struct problem *problem);

#endif
