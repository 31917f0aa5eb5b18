/* Strings and pointers (GL 1.5, 6.1.11 "Pointer and String Queries"). */
#include "api/command.h"
#include "api/errors.h"
#include "base/cpu.h"

#include "fixedgl.h"

/* Only what works: extensions.def. */
static const char extensions[] =
#define EXTENSION(name) #name " "
#include "api/extensions.def"
        ;

/* By enum fgl_isa. */
static const char *const renderers[FGL_ISA_COUNT] = {"FixedGL software", "FixedGL software (AVX2)",
                                                     "FixedGL software (AVX-512)"};

const GLubyte *fgl_exec_GetString(struct context *ctx, GLenum name)
{
    const char *s = NULL;

    switch (name) {
    case GL_VENDOR: s = "FixedGL"; break;
    case GL_RENDERER: s = renderers[fgl_cpu_isa()]; break;
    case GL_VERSION: s = "1.5 FixedGL " FIXEDGL_VERSION; break;
    case GL_EXTENSIONS: s = extensions; break;
    default: fgl_error(ctx, GL_INVALID_ENUM);
    }
    return (const GLubyte *)s;
}

void fgl_exec_GetPointerv(struct context *ctx, GLenum pname, GLvoid **params)
{
    static const struct {
        GLenum pname;
        enum fgl_attr attr;
    } arrays[] = {
            {GL_VERTEX_ARRAY_POINTER, ATTR_POSITION},    {GL_NORMAL_ARRAY_POINTER, ATTR_NORMAL},
            {GL_COLOR_ARRAY_POINTER, ATTR_COLOR},        {GL_INDEX_ARRAY_POINTER, ATTR_INDEX},
            {GL_EDGE_FLAG_ARRAY_POINTER, ATTR_EDGE_FLAG},    {GL_FOG_COORD_ARRAY_POINTER, ATTR_FOG_COORD},
            {GL_SECONDARY_COLOR_ARRAY_POINTER, ATTR_SECONDARY_COLOR},
    };

    for (size_t i = 0; i < FGL_COUNTOF(arrays); i++) {
        if (arrays[i].pname == pname) {
            *params = (GLvoid *)(uintptr_t)ctx->client.arrays.array[arrays[i].attr].pointer;
            return;
        }
    }
    const struct client_array_state *c = &ctx->client.arrays;
    switch (pname) {
    case GL_TEXTURE_COORD_ARRAY_POINTER:
        *params = (GLvoid *)(uintptr_t)c->array[ATTR_TEX0 + c->client_active_texture].pointer;
        break;
    case GL_FEEDBACK_BUFFER_POINTER: *params = ctx->feedback.buffer; break;
    case GL_SELECTION_BUFFER_POINTER: *params = ctx->selection.buffer; break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}
