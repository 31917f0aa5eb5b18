#include "pipeline/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static bool make_room(struct text *t, size_t more)
{
    if (t->length + more + 1 <= t->room)
        return true;
    const size_t room = 2 * (t->length + more + 1);
    char *bigger = realloc(t->data, room);
    if (!bigger)
        return false;
    t->data = bigger;
    t->room = room;
    return true;
}

void fgl_text_add(struct text *t, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int n = vsnprintf(NULL, 0, format, arguments);
    if (n > 0 && make_room(t, (size_t)n)) {
        vsnprintf(t->data + t->length, (size_t)n + 1, format, again);
        t->length += (size_t)n;
    }
    va_end(again);
    va_end(arguments);
}

void fgl_text_end_line(struct text *t)
{
    while (t->length > 0 && t->data[t->length - 1] == ' ')
        t->length--;
    fgl_text_add(t, "\n");
}

void fgl_text_clear(struct text *t)
{
    t->length = 0;
    if (t->data)
        t->data[0] = '\0';
}

void fgl_text_free(struct text *t)
{
    free(t->data);
    *t = (struct text){0};
}

bool fgl_text_write(const struct text *t, const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    const bool good = fwrite(t->data ? t->data : "", 1, t->length, file) == t->length;
    return fclose(file) == 0 && good;
}
