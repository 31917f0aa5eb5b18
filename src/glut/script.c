/* Parser of the event script. A table of statements says what each takes; words and numbers are read by the
 * letters of its pattern:  k key  s special key  b button  d wheel direction  m modifiers  n number  f file.
 * Capitals may be left out and repeat. */
#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <GL/glut.h>
#include "script.h"

struct word_value {
    const char *word;
    int value;
};

/* clang-format off: tables stand in columns */
static const struct word_value key_names[] = {{"escape", 27},     {"space", ' '},   {"enter", 13},
                                              {"tab", 9},         {"backspace", 8}, {"delete", 127},
                                              {"semicolon", ';'}, {NULL, 0}};

static const struct word_value special_names[] = {{"left", GLUT_KEY_LEFT},
                                                  {"right", GLUT_KEY_RIGHT},
                                                  {"up", GLUT_KEY_UP},
                                                  {"down", GLUT_KEY_DOWN},
                                                  {"home", GLUT_KEY_HOME},
                                                  {"end", GLUT_KEY_END},
                                                  {"insert", GLUT_KEY_INSERT},
                                                  {"pageup", GLUT_KEY_PAGE_UP},
                                                  {"pagedown", GLUT_KEY_PAGE_DOWN},
                                                  {"f1", GLUT_KEY_F1},
                                                  {"f2", GLUT_KEY_F2},
                                                  {"f3", GLUT_KEY_F3},
                                                  {"f4", GLUT_KEY_F4},
                                                  {"f5", GLUT_KEY_F5},
                                                  {"f6", GLUT_KEY_F6},
                                                  {"f7", GLUT_KEY_F7},
                                                  {"f8", GLUT_KEY_F8},
                                                  {"f9", GLUT_KEY_F9},
                                                  {"f10", GLUT_KEY_F10},
                                                  {"f11", GLUT_KEY_F11},
                                                  {"f12", GLUT_KEY_F12},
                                                  {NULL, 0}};

static const struct word_value button_names[] = {
        {"left", GLUT_LEFT_BUTTON}, {"middle", GLUT_MIDDLE_BUTTON}, {"right", GLUT_RIGHT_BUTTON}, {NULL, 0}};

static const struct word_value wheel_names[] = {{"up", 1}, {"down", -1}, {NULL, 0}};

static const struct word_value modifier_names[] = {{"shift", GLUT_ACTIVE_SHIFT},
                                                   {"ctrl", GLUT_ACTIVE_CTRL},
                                                   {"alt", GLUT_ACTIVE_ALT},
                                                   {"none", 0},
                                                   {NULL, 0}};

static const struct {
    const char *name;
    enum statement_kind kind;
    const char *pattern;
} kinds[] = {
        {"key", STATEMENT_KEY, "k"},
        {"special", STATEMENT_SPECIAL, "s"},
        {"press", STATEMENT_PRESS, "bnn"},
        {"release", STATEMENT_RELEASE, "bnn"},
        {"click", STATEMENT_CLICK, "bnnN"},
        {"drag", STATEMENT_DRAG, "bnnnn"},
        {"move", STATEMENT_MOVE, "nn"},
        {"wheel", STATEMENT_WHEEL, "dnn"},
        {"modifiers", STATEMENT_MODIFIERS, "mM"},
        {"resize", STATEMENT_RESIZE, "nn"},
        {"menu", STATEMENT_MENU, "nN"},
        {"wait", STATEMENT_WAIT, "n"},
        {"time", STATEMENT_TIME, "n"},
        {"window", STATEMENT_WINDOW, "n"},
        {"capture", STATEMENT_CAPTURE, "f"},
        {"depth", STATEMENT_DEPTH, "f"},
        {"quit", STATEMENT_QUIT, ""},
};
/* clang-format on */
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static bool find_word(const struct word_value *table, const char *word, int *value)
{
    for (; table->word; table++)
        if (strcmp(table->word, word) == 0) {
            *value = table->value;
            return true;
        }
    return false;
}

static bool read_number(const char *word, int base, int *value)
{
    char *end;
    errno = 0;
    long number = strtol(word, &end, base);
    if (end == word || *end || errno || number < INT_MIN || number > INT_MAX)
        return false;
    *value = (int)number;
    return true;
}

/* One character, a name, or a hexadecimal code in 0x01..0xff. */
static bool read_key(const char *word, int *key)
{
    if (word[1] == 0) {
        *key = (unsigned char)word[0];
        return true;
    }
    if (word[0] == '0' && word[1] == 'x')
        return read_number(word, 16, key) && *key >= 1 && *key <= 255;
    return find_word(key_names, word, key);
}

static char *next_word(char **cursor)
{
    char *word = *cursor + strspn(*cursor, " \t\r\n");
    if (!*word)
        return NULL;
    char *end = word + strcspn(word, " \t\r\n");
    *cursor = *end ? end + 1 : end;
    *end = 0;
    return word;
}

static bool read_argument(char letter, char *word, struct statement *s, int *numbers)
{
    int bit;
    switch (letter) {
    case 'k': return read_key(word, &s->value);
    case 's': return find_word(special_names, word, &s->value);
    case 'b': return find_word(button_names, word, &s->value);
    case 'd': return find_word(wheel_names, word, &s->value);
    case 'm':
    case 'M':
        if (!find_word(modifier_names, word, &bit))
            return false;
        s->value |= bit;
        return true;
    case 'n':
    case 'N': return *numbers < STATEMENT_NUMBERS && read_number(word, 10, &s->number[(*numbers)++]);
    default: s->text = word; return true;
    }
}

/* Ranges that hold whatever program runs. */
static bool in_range(const struct statement *s, int numbers)
{
    switch (s->kind) {
    case STATEMENT_CLICK: return numbers == 2 || (numbers == 3 && s->number[2] >= 1);
    case STATEMENT_RESIZE:
        return s->number[0] >= 1 && s->number[1] >= 1 && s->number[0] <= 16384 && s->number[1] <= 16384;
    case STATEMENT_MENU:
        for (int i = 0; i < numbers; i++)
            if (s->number[i] < 1)
                return false;
        return true;
    case STATEMENT_WAIT:
    case STATEMENT_TIME: return s->number[0] >= 0;
    default: return true;
    }
}

/* Returns NULL, or what is wrong. */
static const char *parse_arguments(const char *pattern, char *cursor, struct statement *s)
{
    int numbers = 0;
    char *word;
    while ((word = next_word(&cursor)) != NULL) {
        if (!*pattern)
            return "has too many arguments";
        if (!read_argument(*pattern, word, s, &numbers))
            return "has an argument it cannot read";
        if (islower((unsigned char)*pattern))
            pattern++;
    }
    if (islower((unsigned char)*pattern))
        return "has too few arguments";
    if (s->kind == STATEMENT_MENU)
        s->value = numbers;
    if (!in_range(s, numbers))
        return "has an argument out of range";
    if (s->kind == STATEMENT_CLICK && numbers == 2)
        s->number[2] = 1;
    return NULL;
}

static const char *parse_statement(char *text, struct statement *s)
{
    char *name = next_word(&text);
    for (int i = 0; i < KINDS; i++)
        if (strcmp(kinds[i].name, name) == 0) {
            s->kind = kinds[i].kind;
            return parse_arguments(kinds[i].pattern, text, s);
        }
    return "is not a statement";
}

static int count_statements(const char *text)
{
    int count = 1;
    for (; *text; text++)
        count += *text == ';';
    return count;
}

bool fgl_script_parse(const char *text, struct script *script, char *error, size_t error_size)
{
    size_t length = strlen(text) + 1;
    *script = (struct script){.copy = malloc(length),
                              .statements = calloc((size_t)count_statements(text), sizeof(struct statement))};
    if (!script->copy || !script->statements) {
        snprintf(error, error_size, "no memory for the script");
        fgl_script_free(script);
        return false;
    }
    memcpy(script->copy, text, length);
    char *cursor = script->copy;
    for (int number = 1; cursor; number++) {
        char *start = cursor, *end = strchr(cursor, ';');
        cursor = end ? end + 1 : NULL;
        if (end)
            *end = 0;
        if (start[strspn(start, " \t\r\n")] == 0)
            continue;
        int shown = (int)(end ? end - start : (ptrdiff_t)strlen(start));
        const char *fault = parse_statement(start, &script->statements[script->count++]);
        if (fault) {
            snprintf(error, error_size, "statement %d, \"%.*s\", %s", number, shown,
                     text + (start - script->copy), fault);
            fgl_script_free(script);
            return false;
        }
    }
    return true;
}

void fgl_script_free(struct script *script)
{
    free(script->statements);
    free(script->copy);
    *script = (struct script){0};
}

bool fgl_script_parse_size(const char *text, int *width, int *height)
{
    int used = 0;
    if (!isdigit((unsigned char)text[0]) || sscanf(text, "%5dx%5d%n", width, height, &used) != 2 ||
        text[used])
        return false;
    return *width >= 1 && *height >= 1 && *width <= 16384 && *height <= 16384;
}
