/* Framebuffer objects (GL_ARB_framebuffer_object, GL_EXT_framebuffer_object): what a context draws to and reads from in place of the window.
 *
 * They belong to one context, as GL_ARB_framebuffer_object says; renderbuffers and textures are shared. A bound object's attachments
 * are loaded into the planes of a framebuffer (pipeline/surface.h) before the next command that draws or reads, and stored again before
 * anything else can look at them or change them. */
#ifndef FGL_API_FRAMEBUFFER_OBJECT_H
#define FGL_API_FRAMEBUFFER_OBJECT_H

#include "api/renderbuffer.h"
#include "base/idmap.h"
#include "framebuffer/framebuffer.h"

enum {
    MAX_COLOR_ATTACHMENTS = 8,
    ATTACHMENT_DEPTH = MAX_COLOR_ATTACHMENTS,
    ATTACHMENT_STENCIL,
    ATTACHMENTS
};

/* A slice of a texture's level, a renderbuffer, or nothing. */
struct attachment {
    struct texture_object *texture;
    struct renderbuffer *renderbuffer;
    int face, level, slice;
};

struct framebuffer_object {
    GLuint name;
    bool created; /* bound once; until then only its name is taken */
    GLenum draw_buffer, read_buffer; /* while it is not bound; else those of the context's state count */
    struct attachment attachment[ATTACHMENTS];
};

struct framebuffers {
    struct idmap map;                       /* name -> struct framebuffer_object */
    struct framebuffer_object window;       /* name 0 */
    struct framebuffer_object *draw, *read; /* bound */
    struct renderbuffer *renderbuffer;      /* bound; NULL: none */
    struct framebuffer drawn_planes, read_planes;
    bool stale; /* context.framebuffer and read_framebuffer are to be made anew before they are used */
};

/* ---- framebuffer_object.c: names and bindings ---- */

/* The context's framebuffer objects, made at the first call; NULL after recording GL_OUT_OF_MEMORY. */
struct framebuffers *fgl_framebuffers(struct context *ctx);
void fgl_framebuffers_destroy(struct context *ctx);
/* The object bound to a target of glBindFramebuffer; *bad: there is no such target. NULL: the window. */
struct framebuffer_object *fgl_framebuffer_bound(struct context *ctx, GLenum target, bool *bad);
bool fgl_framebuffer_is_window(const struct context *ctx, bool reading);

/* fragment_state.c: the error of a buffer given to glDrawBuffer, or glReadBuffer. */
GLenum fgl_buffer_error(const struct context *ctx, GLenum buffer, bool reading);

/* ---- framebuffer_attachment.c ---- */

void fgl_attachment_clear(struct attachment *a);
/* The attached image; NULL: none. */
struct texture_image *fgl_attachment_image(const struct attachment *a);
/* A deleted texture or renderbuffer is detached from the bound objects. */
void fgl_framebuffer_detach(struct context *ctx, const struct texture_object *texture, const struct renderbuffer *r);

/* ---- framebuffer_ready.c ---- */

/* GL_FRAMEBUFFER_COMPLETE or what is missing. */
GLenum fgl_framebuffer_status(const struct framebuffer_object *f);

/* Brings context.framebuffer and read_framebuffer up to date; either is NULL when it is not complete. */
void fgl_framebuffer_update(struct context *ctx);

/* To be called by every command that draws, or reads, before it looks at context.framebuffer or read_framebuffer. False after recording
 * GL_INVALID_FRAMEBUFFER_OPERATION. */
bool fgl_draw_ready_slow(struct context *ctx);
bool fgl_read_ready_slow(struct context *ctx);
static inline bool fgl_draw_ready(struct context *ctx) { return !ctx->framebuffers || fgl_draw_ready_slow(ctx); }
static inline bool fgl_read_ready(struct context *ctx) { return !ctx->framebuffers || fgl_read_ready_slow(ctx); }

/* Whether there are colours to be read; for a context that is ready. */
bool fgl_framebuffer_reads_color(const struct context *ctx);

/* Bits of red, green, blue or alpha of what is drawn to; for a context that is ready. */
int fgl_framebuffer_color_bits(const struct context *ctx, int channel);

/* Draws what waits and stores what was drawn into its attachments; for others to see. */
void fgl_framebuffer_store(struct context *ctx);
/* The same before bindings or attachments change: they will be loaded again. */
void fgl_framebuffer_unload(struct context *ctx);
/* The same if the texture is attached: before its images are read or changed. */
void fgl_framebuffer_unload_texture(struct context *ctx, const struct texture_object *texture);
/* After glPopAttrib, with the draw and read buffers from before: those that came back may belong to another framebuffer object. */
void fgl_framebuffer_keep_buffers(struct context *ctx, GLenum draw_buffer, GLenum read_buffer);
/* The window is another: at OSMesaMakeCurrent. */
void fgl_framebuffer_set_window(struct context *ctx, struct framebuffer *window);

#endif
