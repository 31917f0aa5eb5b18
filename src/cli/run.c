#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "child.h"

enum { MAX_VARIABLES = 10 };

/* The files of a run, in a folder of its own. */
struct files {
    char *folder, *out, *picture, *log;
};

static bool make_files(struct files *f, const char *suffix, struct problem *problem)
{
    f->folder = fgl_temporary_name();
    if (!mkdtemp(f->folder))
        return fgl_problem_set(problem, "cannot make %s: %s", f->folder, strerror(errno));
    f->out = fgl_format("%s/out%s", f->folder, suffix);
    f->picture = fgl_format("%s/picture.pam", f->folder);
    f->log = fgl_format("%s/log", f->folder);
    return true;
}

static void remove_files(struct files *f)
{
    char *const path[] = {f->out, f->picture, f->log};
    for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
        if (path[i])
            remove(path[i]);
        free(path[i]);
    }
    rmdir(f->folder);
    free(f->folder);
}

static char *read_file(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file)
        return NULL;
    char *text = NULL;
    size_t length = 0, got;
    do {
        text = fgl_grow(text, length + 65536, 1);
        got = fread(text + length, 1, 65536, file);
        length += got;
    } while (got > 0);
    text[length] = '\0';
    fclose(file);
    return text;
}

static bool spawn(const struct run *run, const struct files *files, struct problem *problem)
{
    char *set[MAX_VARIABLES];
    int n = 0;
    for (int i = 0; i < 3 && run->set[i]; i++) {
        const char *v = run->set[i];
        set[n++] = fgl_format("%s%s", v, v[strlen(v) - 1] == '=' ? files->out : "");
    }
    set[n++] = fgl_format("FIXEDGL_CAPTURE=%s",
                          files->picture); /* its picture is finished, and no window opens */
    set[n++] = fgl_format("FIXEDGL_FRAMES=%d", run->frames);
    if (run->events)
        set[n++] = fgl_format("FIXEDGL_EVENTS=%s", run->events);
    if (run->size)
        set[n++] = fgl_format("FIXEDGL_SIZE=%s", run->size);
    set[n] = NULL;
    const struct child child = {run->argv, (const char *const *)set, files->log, files->log, run->timeout};
    const bool good = fgl_child_run(&child, problem);
    while (n > 0)
        free(set[--n]);
    return good;
}

static bool keep_last_line(char *line, void *context, struct problem *problem)
{
    (void)problem;
    snprintf(context, 256, "%s", line);
    return true;
}

/* The problem and the last line that the program said; FixedGL's own line alone says enough. */
static void add_last_line(const char *log, struct problem *problem)
{
    const char own[] = "FixedGL: ";
    char said[256] = "";
    struct problem what = *problem, ignored;
    fgl_read_lines(log, keep_last_line, said, &ignored);
    if (strncmp(said, own, sizeof own - 1) == 0)
        fgl_problem_set(problem, "%s", said + sizeof own - 1);
    else if (said[0] != '\0')
        fgl_problem_set(problem, "%.200s: %s", what.text, said);
}

char *fgl_run(const struct run *run, struct problem *problem)
{
    struct files files = {NULL, NULL, NULL, NULL};
    char *text = NULL;
    if (!make_files(&files, run->suffix, problem)) {
        free(files.folder);
        return NULL;
    }
    if (spawn(run, &files, problem)) {
        text = read_file(files.out);
        fgl_problem_set(problem, "%s drew nothing with FixedGL", run->argv[0]);
    }
    if (!text)
        add_last_line(files.log, problem);
    remove_files(&files);
    return text;
}

bool fgl_run_option(struct run *run, int option, const char *value)
{
    char *end;
    switch (option) {
    case 'e': run->events = value; return true;
    case 's': run->size = value; return true;
    case 't': run->timeout = strtod(value, &end); return end != value && *end == '\0' && run->timeout > 0;
    case 'f': {
        const long frames = strtol(value, &end, 10);
        run->frames = (int)frames;
        return end != value && *end == '\0' && frames > 0 && frames <= 1000000;
    }
    default: return false;
    }
}
