/* Scripts as data and as text. */
#include "script.h"

#include "api/foreach.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#define KIND_OF(type, name) FGL_CAT(KIND_, type),
const struct command_info commands[COMMANDS] = {
#define CALL(name, ...) CALL_AS(name, name, __VA_ARGS__)
#define CALL_AS(name, function, ...) {"gl" #name, "gl" #function, FGL_NARGS(__VA_ARGS__), {FGL_EACH(KIND_OF, __VA_ARGS__)}},
#define CALL0(name) {"gl" #name, "gl" #name, 0, {KIND_NONE}},
#define OWN(name, function, ...) CALL_AS(name, function, __VA_ARGS__)
#include "commands.def"
};

/* ---- data ---- */

void script_clear(struct script *s, int width, int height)
{
    s->width = width;
    s->height = height;
    s->buffers = (struct buffers){GL_RGBA, GL_UNSIGNED_BYTE, 24, 8};
    s->ops = s->values = 0;
}

void script_add(struct script *s, enum command command, int count, const double *values)
{
    if (s->ops == MAX_OPS || s->values + count > MAX_VALUES)
        return;
    s->op[s->ops++] = (struct op){(int)command, s->values, 0};
    script_extend(s, count, values);
}

void script_extend(struct script *s, int count, const double *values)
{
    if (s->ops == 0 || s->values + count > MAX_VALUES)
        return;
    if (count > 0)
        memcpy(s->value + s->values, values, (size_t)count * sizeof *values);
    s->values += count;
    s->op[s->ops - 1].values += count;
}

int script_scalars(const struct op *op)
{
    const struct command_info *info = &commands[op->command];
    int n = info->parameters;
    if (n > 0 && info->kind[n - 1] >= KIND_FIRST_VECTOR)
        n--;
    return n;
}

void script_without(struct script *out, const struct script *in, int from, int to)
{
    script_clear(out, in->width, in->height);
    out->buffers = in->buffers;
    for (int i = 0; i < in->ops; i++) {
        if (i < from || i >= to)
            script_add(out, (enum command)in->op[i].command, in->op[i].values, in->value + in->op[i].first);
    }
}

int script_range(const struct script *s, int from, int length)
{
    int begins = 0, lists = 0;
    for (int i = from; i < s->ops; i++) {
        const int command = s->op[i].command;
        begins += (command == CMD_Begin) - (command == CMD_End);
        lists += (command == CMD_NewList) - (command == CMD_EndList);
        if (begins < 0 || lists < 0)
            return -1;
        if (begins == 0 && lists == 0 && i + 1 - from >= length)
            return i + 1;
    }
    return -1;
}

/* ---- text ---- */

static const struct name {
    const char *name;
    unsigned value;
} modes[] = {
#define MODE(name) {#name, name},
#include "enums.def"
}, enums[] = {
#define ENUM(name) {#name, name},
#include "enums.def"
}, bits[] = {
#define BIT(name) {#name, name},
#include "enums.def"
};

enum { MODES = sizeof modes / sizeof modes[0], ENUMS = sizeof enums / sizeof enums[0], BITS = sizeof bits / sizeof bits[0] };

static const char *find_name(const struct name *table, int count, unsigned value)
{
    for (int i = 0; i < count; i++) {
        if (table[i].value == value)
            return table[i].name;
    }
    return NULL;
}

const char *enum_name(unsigned value, bool is_mode)
{
    const char *name = is_mode ? find_name(modes, MODES, value) : NULL;
    return name ? name : find_name(enums, ENUMS, value);
}

static void print_mask(FILE *file, unsigned value)
{
    const char *separator = "";
    for (int i = 0; i < BITS && value != GL_ALL_ATTRIB_BITS && value != GL_CLIENT_ALL_ATTRIB_BITS; i++) {
        if (value & bits[i].value) {
            fprintf(file, "%s%s", separator, bits[i].name);
            separator = " | ";
            value &= ~bits[i].value;
        }
    }
    if (value || !*separator)
        fprintf(file, "%s0x%x", separator, value);
}

/* With the fewest digits that give the same number again. */
static void print_number(FILE *file, double value)
{
    char text[40];
    if (value == (double)(long long)value && value > -1e12 && value < 1e12) {
        fprintf(file, "%lld", (long long)value);
        return;
    }
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        const double again = strtod(text, NULL);
        if (again == value || ((double)(float)value == value && (float)again == (float)value))
            break;
    }
    fputs(text, file);
}

static void print_value(FILE *file, enum kind kind, double value)
{
    const char *name = NULL;
    if (kind == KIND_ENUM || kind == KIND_MODE)
        name = enum_name((unsigned)value, kind == KIND_MODE);
    if (name)
        fputs(name, file);
    else if (kind == KIND_ENUM || kind == KIND_MODE)
        fprintf(file, "0x%x", (unsigned)value);
    else if (kind == KIND_MASK)
        print_mask(file, (unsigned)value);
    else
        print_number(file, value);
}

void script_print_op(FILE *file, const struct script *s, int i)
{
    const struct op *op = &s->op[i];
    const struct command_info *info = &commands[op->command];
    const int scalars = script_scalars(op);
    fprintf(file, "%s(", info->name);
    for (int k = 0; k < scalars; k++) {
        fputs(k ? ", " : "", file);
        print_value(file, info->kind[k], s->value[op->first + k]);
    }
    if (scalars < info->parameters) {
        fputs(scalars ? ", {" : "{", file);
        for (int k = scalars; k < op->values; k++) {
            fputs(k > scalars ? ", " : "", file);
            print_number(file, s->value[op->first + k]);
        }
        fputs("}", file);
    }
    fputs(");\n", file);
}

void script_print(FILE *file, const struct script *s)
{
    fprintf(file, "size %d %d\n", s->width, s->height);
    fprintf(file, "buffers 0x%x 0x%x %d %d\n", s->buffers.format, s->buffers.type, s->buffers.depth_bits, s->buffers.stencil_bits);
    for (int i = 0; i < s->ops; i++)
        script_print_op(file, s, i);
}

static bool find_value(const char *word, double *value)
{
    const struct name *tables[] = {modes, enums, bits};
    const int counts[] = {MODES, ENUMS, BITS};
    for (int t = 0; t < 3; t++) {
        for (int i = 0; i < counts[t]; i++) {
            if (strcmp(tables[t][i].name, word) == 0) {
                *value = tables[t][i].value;
                return true;
            }
        }
    }
    return false;
}

/* A number or a name; moves on behind it. */
static bool read_value(const char **at, double *value)
{
    if (!isalpha((unsigned char)**at)) {
        char *end;
        *value = strncmp(*at, "0x", 2) == 0 ? (double)strtoul(*at, &end, 16) : strtod(*at, &end);
        const bool ok = end != *at;
        *at = end;
        return ok;
    }
    const size_t length = strspn(*at, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789");
    char word[80];
    snprintf(word, sizeof word, "%.*s", (int)length, *at);
    *at += length;
    return find_value(word, value);
}

static bool read_op(struct script *s, const char *line)
{
    int command = 0;
    const size_t length = strcspn(line, "(");
    while (command < COMMANDS && (strlen(commands[command].name) != length || strncmp(commands[command].name, line, length)))
        command++;
    if (command == COMMANDS)
        return false;
    script_add(s, (enum command)command, 0, NULL);
    unsigned mask = 0;
    bool in_mask = false;
    for (const char *at = line + length + 1;;) {
        at += strspn(at, " ,{}");
        if (*at == ')')
            break;
        double value;
        if (!read_value(&at, &value))
            return false;
        at += strspn(at, " ");
        in_mask = in_mask || *at == '|';
        if (in_mask)
            value = mask |= (unsigned)value;
        if (*at == '|') {
            at += strspn(at, "| ");
            continue;
        }
        script_extend(s, 1, &value);
    }
    const struct op *op = &s->op[s->ops - 1];
    return op->values >= script_scalars(op);
}

bool script_read(FILE *file, struct script *s)
{
    static char line[1 << 20];
    script_clear(s, 64, 48);
    for (int number = 1; fgets(line, sizeof line, file); number++) {
        const char *at = line + strspn(line, " \t\r\n");
        struct buffers *b = &s->buffers;
        if (*at == '\0' || *at == '#' || sscanf(at, "size %d %d", &s->width, &s->height) == 2 ||
            sscanf(at, "buffers %x %x %d %d", &b->format, &b->type, &b->depth_bits, &b->stencil_bits) == 4)
            continue;
        if (!read_op(s, at)) {
            fprintf(stderr, "fuzz_diff: line %d: cannot read %s", number, line);
            return false;
        }
    }
    return s->width > 0 && s->width <= MAX_WIDTH && s->height > 0 && s->height <= MAX_HEIGHT;
}
