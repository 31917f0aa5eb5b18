/* Menus are kept and can be picked from, but not drawn: a script's "menu" statement picks. */
#include <stdlib.h>
#include <string.h>
#include <GL/freeglut.h>
#include "internal.h"

struct item {
    char *label;
    int value;   /* of an entry */
    int submenu; /* id, 0 for an entry */
};

struct menu {
    int id;
    struct menu *next;
    void (*func)(int);
    void (*destroyed)(void);
    void *data; /* the program's */
    struct item *items;
    int count;
};

static struct menu *menus, *current;
static int last_id;

static struct menu *find(int id)
{
    struct menu *m = menus;
    while (m && m->id != id)
        m = m->next;
    return m;
}

static struct menu *require_menu(const char *function)
{
    fgl_glut_require_init(function);
    if (!current)
        fgl_glut_fail(1, "%s called with no current menu", function);
    return current;
}

int glutCreateMenu(void (*func)(int))
{
    fgl_glut_require_init("glutCreateMenu");
    struct menu *m = calloc(1, sizeof *m);
    if (!m)
        fgl_glut_fail(1, "no memory for a menu");
    m->id = ++last_id;
    m->func = func;
    m->next = menus;
    menus = current = m;
    return m->id;
}

void glutDestroyMenu(int id)
{
    fgl_glut_require_init("glutDestroyMenu");
    struct menu **link = &menus;
    while (*link && (*link)->id != id)
        link = &(*link)->next;
    struct menu *m = *link;
    if (!m) {
        fgl_glut_warn("glutDestroyMenu: no menu %d", id);
        return;
    }
    current = m;
    if (m->destroyed)
        m->destroyed();
    *link = m->next;
    current = NULL;
    for (struct window *w = fgl_glut.windows; w; w = w->next)
        for (int button = 0; button < BUTTONS; button++)
            if (w->menu[button] == id)
                w->menu[button] = 0;
    for (int i = 0; i < m->count; i++)
        free(m->items[i].label);
    free(m->items);
    free(m);
}

int glutGetMenu(void)
{
    fgl_glut_require_init("glutGetMenu");
    return current ? current->id : 0;
}

void glutSetMenu(int id)
{
    fgl_glut_require_init("glutSetMenu");
    struct menu *m = find(id);
    if (m)
        current = m;
    else
        fgl_glut_warn("glutSetMenu: no menu %d", id);
}

void glutMenuDestroyFunc(void (*func)(void))
{
    require_menu("glutMenuDestroyFunc")->destroyed = func;
}

void *glutGetMenuData(void)
{
    return require_menu("glutGetMenuData")->data;
}

void glutSetMenuData(void *data)
{
    require_menu("glutSetMenuData")->data = data;
}

void glutSetMenuFont(int id, void *font)
{
    (void)font;
    fgl_glut_require_init("glutSetMenuFont");
    if (!find(id))
        fgl_glut_warn("glutSetMenuFont: no menu %d", id);
}

static void set_item(struct item *item, const char *label, int value, int submenu)
{
    size_t size = strlen(label) + 1;
    char *copy = malloc(size);
    if (!copy)
        fgl_glut_fail(1, "no memory for a menu item");
    memcpy(copy, label, size);
    free(item->label);
    *item = (struct item){copy, value, submenu};
}

static void add_item(struct menu *m, const char *label, int value, int submenu)
{
    struct item *items = realloc(m->items, (size_t)(m->count + 1) * sizeof *items);
    if (!items)
        fgl_glut_fail(1, "no memory for a menu item");
    m->items = items;
    m->items[m->count] = (struct item){0};
    set_item(&m->items[m->count++], label, value, submenu);
}

/* Item number `position` from 1, or NULL with a warning. */
static struct item *find_item(const char *function, struct menu *m, int position)
{
    if (position >= 1 && position <= m->count)
        return &m->items[position - 1];
    fgl_glut_warn("%s: menu %d has no item %d", function, m->id, position);
    return NULL;
}

void glutAddMenuEntry(const char *label, int value)
{
    add_item(require_menu("glutAddMenuEntry"), label, value, 0);
}

void glutAddSubMenu(const char *label, int submenu)
{
    struct menu *m = require_menu("glutAddSubMenu");
    if (find(submenu))
        add_item(m, label, 0, submenu);
    else
        fgl_glut_warn("glutAddSubMenu: no menu %d", submenu);
}

void glutChangeToMenuEntry(int position, const char *label, int value)
{
    struct item *item = find_item("glutChangeToMenuEntry", require_menu("glutChangeToMenuEntry"), position);
    if (item)
        set_item(item, label, value, 0);
}

void glutChangeToSubMenu(int position, const char *label, int submenu)
{
    struct item *item = find_item("glutChangeToSubMenu", require_menu("glutChangeToSubMenu"), position);
    if (item && find(submenu))
        set_item(item, label, 0, submenu);
}

void glutRemoveMenuItem(int position)
{
    struct menu *m = require_menu("glutRemoveMenuItem");
    struct item *item = find_item("glutRemoveMenuItem", m, position);
    if (!item)
        return;
    free(item->label);
    memmove(item, item + 1, (size_t)(m->count - position) * sizeof *item);
    m->count--;
}

static void attach(const char *function, int button, int id)
{
    struct window *w = fgl_glut_require_window(function);
    if (button < 0 || button >= BUTTONS)
        fgl_glut_warn("%s: no button %d", function, button);
    else
        w->menu[button] = id;
}

void glutAttachMenu(int button)
{
    attach("glutAttachMenu", button, require_menu("glutAttachMenu")->id);
}

void glutDetachMenu(int button)
{
    attach("glutDetachMenu", button, 0);
}

bool fgl_menu_opens(struct window *w, int button)
{
    return button < BUTTONS && w->menu[button] != 0;
}

static void tell_status(int status, const struct window *w)
{
    if (fgl_glut.menu_status)
        fgl_glut.menu_status(status, w->pointer_x, w->pointer_y);
    if (fgl_glut.menu_state)
        fgl_glut.menu_state(status);
}

/* The menu of the right button if it has one, else of the middle or the left. */
static struct menu *attached_menu(const struct window *w)
{
    static const int order[BUTTONS] = {GLUT_RIGHT_BUTTON, GLUT_MIDDLE_BUTTON, GLUT_LEFT_BUTTON};
    for (int i = 0; i < BUTTONS; i++)
        if (w->menu[order[i]])
            return find(w->menu[order[i]]);
    return NULL;
}

bool fgl_menu_pick(struct window *w, const int *path, int levels)
{
    struct menu *m = attached_menu(w);
    for (int level = 0; m && level < levels; level++) {
        if (path[level] > m->count)
            return false;
        struct item item = m->items[path[level] - 1];
        if (item.submenu) {
            m = find(item.submenu);
            continue;
        }
        if (level + 1 < levels)
            return false;
        fgl_window_make_current(w);
        tell_status(GLUT_MENU_IN_USE, w);
        current = m;
        if (m->func)
            m->func(item.value);
        tell_status(GLUT_MENU_NOT_IN_USE, w);
        return true;
    }
    return false;
}

int fgl_menu_item_count(void)
{
    return current ? current->count : 0;
}
