/* Entry points by name, from command.def. */
#include "api/proc_address.h"
#include "api/command.h"

#include <string.h>

static const struct {
    const char *name;
    fgl_proc proc;
} table[] = {
#define CMD_HAND(name) {"gl" #name, (fgl_proc)gl##name},
#define CMD_LIST(name, ...) CMD_HAND(name)
#define CMD_LISTV(name, type, count, ...) CMD_HAND(name)
#define CMD_LIST0(name) CMD_HAND(name)
#define CMD_NOW(name, ...) CMD_HAND(name)
#define CMD_NOW0(name) CMD_HAND(name)
#define CMD_GET(ret, name, ...) CMD_HAND(name)
#define CMD_GET0(ret, name) CMD_HAND(name)
#define CMD_ALIAS(name, ...) CMD_HAND(name)
#define CMD_ALIAS0(name, ...) CMD_HAND(name)
#define CMD_ALIAS_GET(ret, name, ...) CMD_HAND(name)
#include "api/command.def"
};

fgl_proc fgl_proc_address(const char *name)
{
    for (size_t i = 0; i < FGL_COUNTOF(table); i++)
        if (strcmp(table[i].name, name) == 0)
            return table[i].proc;
    return NULL;
}
