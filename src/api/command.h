/* What command.def declares: the implementation of each command, and the opcodes of display lists. */
#ifndef FGL_API_COMMAND_H
#define FGL_API_COMMAND_H

#include "api/foreach.h"
#include "state/context.h"

/* Elements that a pname's vector holds; 0 for a pname that the command does not accept. */
int fgl_count_light(GLenum pname);
int fgl_count_light_model(GLenum pname);
int fgl_count_fog(GLenum pname);
int fgl_count_point(GLenum pname);
int fgl_count_texture(GLenum pname);
int fgl_count_sampler(GLenum pname);
int fgl_count_texture_env(GLenum pname);
int fgl_count_texgen(GLenum pname);
int fgl_count_color_table(GLenum pname);
int fgl_count_convolution(GLenum pname);

#define CMD_LIST(name, ...) void fgl_exec_##name(struct context *ctx, FGL_LIST(FGL_PARAM, __VA_ARGS__));
#define CMD_LISTV(name, type, count, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_LIST0(name) void fgl_exec_##name(struct context *ctx);
#define CMD_NOW(name, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_NOW0(name) CMD_LIST0(name)
#define CMD_GET(ret, name, ...) ret fgl_exec_##name(struct context *ctx, FGL_LIST(FGL_PARAM, __VA_ARGS__));
#define CMD_GET0(ret, name) ret fgl_exec_##name(struct context *ctx);
#define CMD_HAND(name)
#define CMD_ALIAS(name, ...)
#define CMD_ALIAS0(name, ...)
#define CMD_ALIAS_GET(ret, name, ...)
#include "api/command.def"

enum fgl_opcode {
    OP_END_OF_LIST,
    OP_CONTINUE,  /* the list goes on in the next block */
    OP_VERTICES,  /* vertices between Begin and End, compiled */
    OP_ATTRIBUTE, /* a current value set outside Begin/End */
    OP_MATERIAL,
    OP_CALL_LIST,
    OP_CALL_LISTS,
    OP_POLYGON_STIPPLE,
    OP_PIXEL_MAP,
    OP_RECT,
    OP_BITMAP,
    OP_DRAW_PIXELS,
    OP_TEXTURE_IMAGE,
    OP_IMAGING_IMAGE, /* glColorTable, glConvolutionFilter1D, ... */
    OP_HISTOGRAM,
    OP_PRIORITIZE_TEXTURE,
    OP_MAP,  /* glMap */
    OP_EVAL, /* glEvalCoord, glEvalPoint */
    OP_ERROR, /* an error that the command would raise when executed */
#define CMD_LIST(name, ...) OP_##name,
#define CMD_LISTV(name, type, count, ...) OP_##name,
#define CMD_LIST0(name) OP_##name,
#define CMD_NOW(name, ...)
#define CMD_NOW0(name)
#define CMD_GET(ret, name, ...)
#define CMD_GET0(ret, name)
#define CMD_HAND(name)
#define CMD_ALIAS(name, ...)
#define CMD_ALIAS0(name, ...)
#define CMD_ALIAS_GET(ret, name, ...)
#include "api/command.def"
    OP_COUNT
};

/* The payload of each generated opcode. A CMD_LISTV's vector follows the struct, at FGL_ALIGN8(sizeof struct). */
#define FGL_ALIGN8(n) (((n) + 7u) & ~(size_t)7u)
#define CMD_LIST(name, ...)                                                                                  \
    struct node_##name {                                                                                     \
        FGL_EACH(FGL_FIELD, __VA_ARGS__)                                                                     \
    };
#define CMD_LISTV(name, type, count, ...) CMD_LIST(name, __VA_ARGS__)
#define CMD_LIST0(name)
#define CMD_NOW(name, ...)
#define CMD_NOW0(name)
#define CMD_GET(ret, name, ...)
#define CMD_GET0(ret, name)
#define CMD_HAND(name)
#define CMD_ALIAS(name, ...)
#define CMD_ALIAS0(name, ...)
#define CMD_ALIAS_GET(ret, name, ...)
#include "api/command.def"

#endif
