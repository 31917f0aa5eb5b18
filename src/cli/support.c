/* Problems, strings, memory and text files for the command line tool. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

bool fgl_problem_set(struct problem *problem, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    return false;
}

int fgl_complain(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("fixedgl: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    return EXIT_USAGE;
}

static void *checked(void *memory)
{
    if (memory == NULL)
        exit(fgl_complain("out of memory"));
    return memory;
}

char *fgl_format(const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *text = checked(length < 0 ? NULL : malloc((size_t)length + 1));
    vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    va_end(arguments);
    return text;
}

void fgl_put_escaped(FILE *page, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '&': fputs("&amp;", page); break;
        case '<': fputs("&lt;", page); break;
        case '>': fputs("&gt;", page); break;
        case '"': fputs("&quot;", page); break;
        default: fputc(*text, page); break;
        }
    }
}

char *fgl_temporary_name(void)
{
    const char *folder = getenv("TMPDIR");
    return fgl_format("%s/fixedgl-XXXXXX", folder && *folder ? folder : "/tmp");
}

void *fgl_allocate(size_t count, size_t size)
{
    return checked(calloc(count > 0 ? count : 1, size));
}

void *fgl_grow(void *array, size_t count, size_t size)
{
    return checked(count < SIZE_MAX / size - 1 ? realloc(array, (count + 1) * size) : NULL);
}

char *fgl_trim(char *line)
{
    size_t length = strlen(line);
    while (length > 0 && strchr(" \t\r\n", line[length - 1]) != NULL)
        line[--length] = '\0';
    return line + strspn(line, " \t");
}

bool fgl_take_value(const char *line, const char *name, char *value, size_t room)
{
    const size_t length = strlen(name);
    if (strncmp(line, name, length) != 0 || strncmp(line + length, ": ", 2) != 0)
        return false;
    snprintf(value, room, "%s", line + length + 2);
    return true;
}

bool fgl_read_lines(const char *path, bool (*use)(char *line, void *context, struct problem *problem),
                    void *context, struct problem *problem)
{
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    char *line = NULL;
    size_t room = 0;
    bool good = true;
    for (int number = 1; good && getline(&line, &room, file) >= 0; number++) {
        char *text = fgl_trim(line);
        struct problem refused = {""};
        if (*text != '\0' && *text != '#' && !use(text, context, &refused))
            good = fgl_problem_set(problem, "%s:%d: %s", path, number, refused.text);
    }
    if (good && ferror(file))
        good = fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    free(line);
    fclose(file);
    return good;
}

bool fgl_make_folder(const char *path, struct problem *problem)
{
    char *part = fgl_format("%s", path);
    bool good = true;
    for (char *end = part; good && end != NULL;) {
        end = strchr(end + 1, '/');
        if (end != NULL)
            *end = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            good = fgl_problem_set(problem, "cannot make %s: %s", part, strerror(errno));
        if (end != NULL)
            *end = '/';
    }
    free(part);
    return good;
}
