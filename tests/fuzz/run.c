/* Runs scripts on one OSMesa library. */
#include "run.h"

#include "api/foreach.h"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

typedef void (*function)(void);

static function procs[COMMANDS];
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
        procs[i] = get(commands[i].name);
        missing[i] = !procs[i];
    }
    return true;
}

/* ---- memory that commands read: kept to the end of the script, since vertex arrays are read later ---- */

enum { ARENA = 1 << 22 };
static _Alignas(16) unsigned char arena[ARENA];
static size_t arena_used;

static void *arena_take(size_t bytes)
{
    bytes = (bytes + 15) & ~(size_t)15;
    if (arena_used + bytes > ARENA)
        arena_used = 0; /* a script that long only overwrites its own oldest data */
    void *memory = arena + arena_used;
    arena_used += bytes;
    return memory;
}

static size_t type_size(GLenum type)
{
    switch (type) {
    case GL_BYTE: case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT: case GL_UNSIGNED_SHORT: case GL_2_BYTES: return 2;
    case GL_3_BYTES: return 3;
    case GL_DOUBLE: return 8;
    default: return 4;
    }
}

static void put(unsigned char *to, GLenum type, double value)
{
    const int64_t integer = (int64_t)value;
    const GLfloat f = (GLfloat)value;
    switch (type) {
    case GL_FLOAT: memcpy(to, &f, sizeof f); break;
    case GL_DOUBLE: memcpy(to, &value, sizeof value); break;
    case GL_2_BYTES: case GL_3_BYTES: case GL_4_BYTES: /* the most significant byte first */
        for (size_t n = type_size(type), i = 0; i < n; i++)
            to[i] = (unsigned char)(integer >> (8 * (n - 1 - i)));
        break;
    default: memcpy(to, &integer, type_size(type)); /* little-endian, as the libraries are */
    }
}

/* ---- the values of one op ---- */

struct call {
    const struct op *op;
    const double *value; /* its values */
    int next;
    unsigned char *out; /* for OUT */
    size_t out_size;
};

static double take(struct call *call)
{
    return call->next < call->op->values ? call->value[call->next++] : 0.0;
}

/* The rest of the values as `type`; followed by zeros, since a command with a wrong pname may read more. */
static void *take_vector(struct call *call, GLenum type)
{
    const size_t size = type_size(type), count = (size_t)(call->op->values - call->next);
    unsigned char *memory = arena_take((count + 16) * size);
    memset(memory, 0, (count + 16) * size);
    for (size_t i = 0; i < count; i++)
        put(memory + i * size, type, take(call));
    return memory;
}

struct layout {
    int components;
    GLenum type[16];
    size_t offset[16], size;
};

static void add_components(struct layout *layout, int count, GLenum type)
{
    for (int i = 0; i < count && layout->components < 16; i++) {
        layout->type[layout->components] = type;
        layout->offset[layout->components++] = layout->size;
        layout->size += type_size(type);
    }
}

/* GL 1.5, 2.8, table 2.5: the number of texture coordinates, colors (-4: four bytes), normals, vertices. */
static void interleaved_layout(struct layout *layout, GLenum format)
{
    static const signed char counts[14][4] = {
            {0, 0, 0, 2}, {0, 0, 0, 3}, {0, -4, 0, 2}, {0, -4, 0, 3}, {0, 3, 0, 3}, {0, 0, 3, 3}, {0, 4, 3, 3},
            {2, 0, 0, 3}, {4, 0, 0, 4}, {2, -4, 0, 3}, {2, 3, 0, 3}, {2, 0, 3, 3}, {2, 4, 3, 3}, {4, 4, 3, 4}};
    const signed char *count = counts[(format - GL_V2F) % 14];
    add_components(layout, count[0], GL_FLOAT);
    add_components(layout, count[1] < 0 ? 4 : count[1], count[1] < 0 ? GL_UNSIGNED_BYTE : GL_FLOAT);
    add_components(layout, count[2] + count[3], GL_FLOAT);
}

static void *take_array(struct call *call)
{
    const double *scalar = call->value;
    struct layout layout = {0};
    size_t stride = (size_t)scalar[call->next - 1];
    switch (call->op->command) {
    case CMD_NormalPointer: add_components(&layout, 3, (GLenum)scalar[0]); break;
    case CMD_EdgeFlagPointer: add_components(&layout, 1, GL_UNSIGNED_BYTE); break;
    case CMD_InterleavedArrays: interleaved_layout(&layout, (GLenum)scalar[0]); break;
    default: add_components(&layout, (int)scalar[0], (GLenum)scalar[1]);
    }
    if (stride < layout.size)
        stride = layout.size;
    const int count = layout.components ? (call->op->values - call->next) / layout.components : 0;
    unsigned char *memory = arena_take(((size_t)count + 1) * stride);
    memset(memory, 0, ((size_t)count + 1) * stride);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < layout.components; k++)
            put(memory + (size_t)i * stride + layout.offset[k], layout.type[k], take(call));
    }
    return memory;
}

enum { UNWRITTEN = 0xcd };

static void *take_out(struct call *call)
{
    call->out_size = 256;
    if (call->op->command == CMD_ReadPixels && call->value[2] > 0.0 && call->value[3] > 0.0)
        call->out_size = (size_t)(call->value[2] + 64.0) * (size_t)(call->value[3] + 8.0) * 16;
    call->out = arena_take(call->out_size);
    memset(call->out, UNWRITTEN, call->out_size);
    return call->out;
}

static unsigned char *kept;
static size_t kept_size;

/* Of as many elements of 4 bytes as the first parameter says. */
static void *take_kept(struct call *call)
{
    kept_size = call->value[0] > 0.0 ? 4 * (size_t)call->value[0] : 0;
    kept = arena_take(kept_size);
    memset(kept, UNWRITTEN, kept_size);
    return kept;
}

static void take_result(struct call *call, GLint value)
{
    call->out_size = sizeof value + kept_size;
    call->out = arena_take(call->out_size);
    memcpy(call->out, &value, sizeof value);
    if (kept_size > 0)
        memcpy(call->out + sizeof value, kept, kept_size);
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

static void copy_depth(OSMesaContext context, struct result *result, size_t pixels)
{
    GLint width, height, bytes;
    void *depth;
    if (!library.depth_buffer(context, &width, &height, &bytes, &depth))
        return;
    if (bytes == 4)
        memcpy(result->depth, depth, pixels * 4);
    for (size_t i = 0; bytes == 2 && i < pixels; i++)
        result->depth[i] = ((const uint16_t *)depth)[i];
}

void run_script(const struct script *script, struct result *result)
{
    result->records = result->data_size = result->op = 0;
    result->finished = false;
    arena_used = kept_size = 0;
    memset(arena, 0, ARENA);
    const size_t pixels = (size_t)script->width * (size_t)script->height;
    const struct buffers *b = &script->buffers;
    result->pixel_bytes = pixel_bytes(b);
    memset(result->color, 0, pixels * MAX_PIXEL_BYTES);
    memset(result->depth, 0, pixels * 4);
    OSMesaContext context = library.create(b->format, b->depth_bits, b->stencil_bits, 16, NULL);
    if (!context || !library.make_current(context, result->color, b->type, script->width, script->height))
        abort();
    run_ops(script, result);
    library.finish();
    record_errors(result, script->ops);
    copy_depth(context, result, pixels);
    library.make_current(NULL, NULL, 0, 0, 0);
    library.destroy(context);
    result->finished = true;
}
