/* Runs scripts on one OSMesa library. */
#include "run.h"

#include "call.h"

#include "api/foreach.h"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

function procs[COMMANDS];
static struct {
    OSMesaContext (*create)(GLenum, GLint, GLint, GLint, OSMesaContext);
    GLboolean (*make_current)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
    GLboolean (*depth_buffer)(OSMesaContext, GLint *, GLint *, GLint *, void **);
    void (*destroy)(OSMesaContext);
    GLenum (*get_error)(void);
    void (*finish)(void);
} library;

bool run_load(const char *path, bool missing[COMMANDS])
{
    void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
        fprintf(stderr, "fuzz_diff: %s\n", dlerror());
        return false;
    }
    function (*get)(const char *);
    *(void **)&get = dlsym(handle, "OSMesaGetProcAddress");
    *(void **)&library.create = dlsym(handle, "OSMesaCreateContextExt");
    *(void **)&library.make_current = dlsym(handle, "OSMesaMakeCurrent");
    *(void **)&library.depth_buffer = dlsym(handle, "OSMesaGetDepthBuffer");
    *(void **)&library.destroy = dlsym(handle, "OSMesaDestroyContext");
    if (!get || !library.create || !library.make_current || !library.depth_buffer || !library.destroy) {
        fprintf(stderr, "fuzz_diff: %s is not an OSMesa library\n", path);
        return false;
    }
    library.get_error = (GLenum(*)(void))get("glGetError");
    library.finish = get("glFinish");
    for (int i = 0; i < COMMANDS; i++) {
        procs[i] = get(commands[i].function);
        missing[i] = !procs[i];
    }
    return true;
}

/* ---- one function for each command, which gives the values their types ---- */

typedef GLenum MODE;
typedef GLbitfield MASK;
typedef const GLbyte *BYTES;
typedef const GLubyte *UBYTES;
typedef const GLshort *SHORTS;
typedef const GLushort *USHORTS;
typedef const GLint *INTS;
typedef const GLuint *UINTS;
typedef const GLfloat *FLOATS;
typedef const GLdouble *DOUBLES;
typedef const GLvoid *ARRAY, *INDICES, *BYTES_IN;
typedef const GLvoid *OFFSET;
typedef GLvoid *OUT, *KEPT;

#define TAKE_INTEGER (int64_t) take(call)
#define TAKE_GLenum TAKE_INTEGER
#define TAKE_MODE TAKE_INTEGER
#define TAKE_MASK TAKE_INTEGER
#define TAKE_GLbyte TAKE_INTEGER
#define TAKE_GLubyte TAKE_INTEGER
#define TAKE_GLboolean TAKE_INTEGER
#define TAKE_GLshort TAKE_INTEGER
#define TAKE_GLushort TAKE_INTEGER
#define TAKE_GLint TAKE_INTEGER
#define TAKE_GLsizei TAKE_INTEGER
#define TAKE_GLuint TAKE_INTEGER
#define TAKE_GLfloat take(call)
#define TAKE_GLdouble take(call)
#define TAKE_BYTES take_vector(call, GL_BYTE)
#define TAKE_UBYTES take_vector(call, GL_UNSIGNED_BYTE)
#define TAKE_SHORTS take_vector(call, GL_SHORT)
#define TAKE_USHORTS take_vector(call, GL_UNSIGNED_SHORT)
#define TAKE_INTS take_vector(call, GL_INT)
#define TAKE_UINTS take_vector(call, GL_UNSIGNED_INT)
#define TAKE_FLOATS take_vector(call, GL_FLOAT)
#define TAKE_DOUBLES take_vector(call, GL_DOUBLE)
#define TAKE_INDICES take_vector(call, (GLenum)call->value[call->next - 1])
#define TAKE_BYTES_IN take_vector(call, GL_UNSIGNED_BYTE)
#define TAKE_ARRAY take_array(call)
#define TAKE_OFFSET (intptr_t)TAKE_INTEGER
#define TAKE_GLintptr TAKE_INTEGER
#define TAKE_GLsizeiptr TAKE_INTEGER
#define TAKE_OUT take_out(call)
#define TAKE_KEPT take_kept(call)

#define TAKE(type, name) const type name = (type)TAKE_##type;
#define TYPE(type, name) type
#define CALL(name, ...)                                                                                      \
    static void call_##name(struct call *call)                                                               \
    {                                                                                                        \
        FGL_EACH(TAKE, __VA_ARGS__)                                                                          \
        ((void (*)(FGL_LIST(TYPE, __VA_ARGS__)))procs[CMD_##name])(FGL_LIST(FGL_NAME, __VA_ARGS__));         \
    }
#define RESULT(name, type, ...)                                                                              \
    static void call_##name(struct call *call)                                                               \
    {                                                                                                        \
        FGL_EACH(TAKE, __VA_ARGS__)                                                                          \
        take_result(call, ((type(*)(FGL_LIST(TYPE, __VA_ARGS__)))procs[CMD_##name])(FGL_LIST(FGL_NAME, __VA_ARGS__))); \
    }
#define CALL0(name)                                                                                          \
    static void call_##name(struct call *call)                                                               \
    {                                                                                                        \
        (void)call;                                                                                          \
        procs[CMD_##name]();                                                                                 \
    }
#define OWN(name, function, ...)
#include "commands.def"

static void (*const callers[COMMANDS])(struct call *call) = {
#define CALL(name, ...) call_##name,
#define CALL0(name) call_##name,
#include "commands.def"
};

/* ---- a whole script ---- */

static struct record *add_record(struct result *result, int op)
{
    if (result->records == MAX_RECORDS)
        return NULL;
    struct record *record = &result->record[result->records++];
    *record = (struct record){.op = op, .offset = result->data_size};
    return record;
}

static void record_errors(struct result *result, int op)
{
    for (int i = 0; i < 8; i++) {
        const GLenum error = library.get_error();
        struct record *record = error ? add_record(result, op) : NULL;
        if (!record)
            break;
        record->error = error;
    }
}

static void record_data(struct result *result, int op, const struct call *call)
{
    size_t size = call->out_size;
    while (size > 0 && call->out[size - 1] == UNWRITTEN)
        size--;
    struct record *record = size <= (size_t)(MAX_DATA - result->data_size) ? add_record(result, op) : NULL;
    if (!record)
        return;
    record->size = (int)size;
    memcpy(result->data + result->data_size, call->out, size);
    result->data_size += (int)size;
}

static void run_ops(const struct script *script, struct result *result)
{
    int begins = 0;
    for (int i = 0; i < script->ops; i++) {
        const struct op *op = &script->op[i];
        struct call call = {.op = op, .value = script->value + op->first};
        result->op = i;
        if (!procs[op->command])
            continue;
        callers[op->command](&call);
        begins += (op->command == CMD_Begin) - (op->command == CMD_End);
        if (call.out)
            record_data(result, i, &call);
        if (begins == 0)
            record_errors(result, i);
    }
    result->op = script->ops;
}

static int pixel_bytes(const struct buffers *b)
{
    if (b->format == OSMESA_RGB_565)
        return 2;
    return (b->format == OSMESA_RGB ? 3 : 4) * (int)type_size(b->type);
}

/* ---- the contexts of a script: the second shares its lists and objects with the first, and has a buffer of RGBA bytes ---- */

enum { CONTEXTS = 2 };
static struct {
    OSMesaContext context[CONTEXTS];
    int current;
    unsigned char color[MAX_WIDTH * MAX_HEIGHT * 4]; /* of the second */
    const struct script *script;
    struct result *result;
} run;

static void switch_to(int i)
{
    const struct script *s = run.script;
    const struct buffers *b = &s->buffers;
    run.current = i;
    if (!run.context[i])
        run.context[i] = i == 0 ? library.create(b->format, b->depth_bits, b->stencil_bits, 16, NULL)
                                : library.create(OSMESA_RGBA, 24, 8, 0, run.context[0]);
    if (!run.context[i] || !library.make_current(run.context[i], i == 0 ? run.result->color : run.color, i == 0 ? b->type : GL_UNSIGNED_BYTE,
                                                 s->width, s->height))
        abort();
}

void call_OtherContext(struct call *call)
{
    const int i = (int)take(call);
    if (i < 0 || i >= CONTEXTS || i == run.current)
        return;
    library.finish();
    if (i == 0) {
        const size_t size = (size_t)run.script->width * (size_t)run.script->height * 4;
        memcpy(take_room(call, size), run.color, size);
    }
    switch_to(i);
}

static void copy_depth(struct result *result, size_t pixels)
{
    GLint width, height, bytes;
    void *depth;
    if (!library.depth_buffer(run.context[0], &width, &height, &bytes, &depth))
        return;
    if (bytes == 4)
        memcpy(result->depth, depth, pixels * 4);
    for (size_t i = 0; bytes == 2 && i < pixels; i++)
        result->depth[i] = ((const uint16_t *)depth)[i];
}

void run_script(const struct script *script, struct result *result)
{
    const size_t pixels = (size_t)script->width * (size_t)script->height;
    result->records = result->data_size = result->op = 0;
    result->finished = false;
    arena_clear();
    result->pixel_bytes = pixel_bytes(&script->buffers);
    memset(result->color, 0, pixels * MAX_PIXEL_BYTES);
    memset(result->depth, 0, pixels * 4);
    memset(&run, 0, sizeof run);
    run.script = script;
    run.result = result;
    switch_to(0);
    run_ops(script, result);
    if (run.current != 0)
        switch_to(0);
    library.finish();
    record_errors(result, script->ops);
    copy_depth(result, pixels);
    library.make_current(NULL, NULL, 0, 0, 0);
    for (int i = 0; i < CONTEXTS; i++) {
        if (run.context[i])
            library.destroy(run.context[i]);
    }
    result->finished = true;
}
