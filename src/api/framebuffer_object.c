/* Framebuffer objects: names and bindings (GL_ARB_framebuffer_object). */
#include "api/framebuffer_object.h"

#include "api/command.h"
#include "api/errors.h"

#include <stdlib.h>

struct framebuffers *fgl_framebuffers(struct context *ctx)
{
    if (ctx->framebuffers)
        return ctx->framebuffers;
    struct framebuffers *f = calloc(1, sizeof *f);
    RETURN_VALUE_ERROR_IF(ctx, !f, GL_OUT_OF_MEMORY, NULL);
    f->draw = f->read = &f->window;
    f->window.created = true;
    return ctx->framebuffers = f;
}

static void destroy(void *value)
{
    struct framebuffer_object *f = value;
    for (int i = 0; i < ATTACHMENTS; i++)
        fgl_attachment_clear(&f->attachment[i]);
    free(f);
}

void fgl_framebuffers_destroy(struct context *ctx)
{
    struct framebuffers *f = ctx->framebuffers;
    if (!f)
        return;
    fgl_idmap_free(&f->map, destroy);
    fgl_renderbuffer_refer(&f->renderbuffer, NULL);
    fgl_framebuffer_free(&f->drawn_planes);
    fgl_framebuffer_free(&f->read_planes);
    free(f);
    ctx->framebuffers = NULL;
}

/* ---- names ---- */

static struct framebuffer_object *add(struct context *ctx, struct framebuffers *fbs, GLuint name)
{
    struct framebuffer_object *f = calloc(1, sizeof *f);
    if (!f || !fgl_idmap_put(&fbs->map, name, f)) {
        free(f);
        fgl_error(ctx, GL_OUT_OF_MEMORY);
        return NULL;
    }
    f->name = name;
    f->draw_buffer = f->read_buffer = GL_COLOR_ATTACHMENT0;
    return f;
}

void fgl_exec_GenFramebuffers(struct context *ctx, GLsizei n, GLuint *framebuffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    struct framebuffers *fbs = fgl_framebuffers(ctx);
    const GLuint first = fbs && n ? fgl_idmap_find_free(&fbs->map, (uint32_t)n) : 0;
    for (GLuint i = 0; first && i < (GLuint)n; i++) {
        if (!add(ctx, fbs, first + i))
            return;
        framebuffers[i] = first + i;
    }
}

GLboolean fgl_exec_IsFramebuffer(struct context *ctx, GLuint framebuffer)
{
    const struct framebuffer_object *f = ctx->framebuffers ? fgl_idmap_get(&ctx->framebuffers->map, framebuffer) : NULL;
    return f && f->created ? GL_TRUE : GL_FALSE;
}

/* ---- bindings ---- */

static void bind_draw(struct context *ctx, struct framebuffer_object *f)
{
    struct framebuffers *fbs = ctx->framebuffers;
    fbs->draw->draw_buffer = ctx->s.color_buffer.draw_buffer;
    fbs->draw = f;
    ctx->s.color_buffer.draw_buffer = f->draw_buffer;
}

static void bind_read(struct context *ctx, struct framebuffer_object *f)
{
    struct framebuffers *fbs = ctx->framebuffers;
    fbs->read->read_buffer = ctx->s.pixel_mode.read_buffer;
    fbs->read = f;
    ctx->s.pixel_mode.read_buffer = f->read_buffer;
}

/* OSMesa rule: as in GL_EXT_framebuffer_object a program may choose names. */
void fgl_exec_BindFramebuffer(struct context *ctx, GLenum target, GLuint name)
{
    const bool draw = target != GL_READ_FRAMEBUFFER, read = target != GL_DRAW_FRAMEBUFFER;
    RETURN_ERROR_IF(ctx, target != GL_FRAMEBUFFER && draw && read, GL_INVALID_ENUM);
    struct framebuffers *fbs = fgl_framebuffers(ctx);
    if (!fbs)
        return;
    struct framebuffer_object *f = name ? fgl_idmap_get(&fbs->map, name) : &fbs->window;
    if (!f && !(f = add(ctx, fbs, name)))
        return;
    f->created = true;
    if ((!draw || f == fbs->draw) && (!read || f == fbs->read))
        return;
    fgl_framebuffer_unload(ctx);
    if (draw)
        bind_draw(ctx, f);
    if (read)
        bind_read(ctx, f);
}

/* Where a deleted object is bound, the window takes its place. */
void fgl_exec_DeleteFramebuffers(struct context *ctx, GLsizei n, const GLuint *framebuffers)
{
    RETURN_ERROR_IF(ctx, n < 0, GL_INVALID_VALUE);
    struct framebuffers *fbs = ctx->framebuffers;
    for (GLsizei i = 0; fbs && i < n; i++) {
        struct framebuffer_object *f = fgl_idmap_get(&fbs->map, framebuffers[i]);
        if (!f)
            continue;
        if (f == fbs->draw || f == fbs->read)
            fgl_framebuffer_unload(ctx);
        if (f == fbs->draw)
            bind_draw(ctx, &fbs->window);
        if (f == fbs->read)
            bind_read(ctx, &fbs->window);
        destroy(fgl_idmap_remove(&fbs->map, framebuffers[i]));
    }
}

struct framebuffer_object *fgl_framebuffer_bound(struct context *ctx, GLenum target, bool *bad)
{
    struct framebuffers *fbs = ctx->framebuffers;
    *bad = target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER;
    if (!fbs || *bad)
        return NULL;
    struct framebuffer_object *f = target == GL_READ_FRAMEBUFFER ? fbs->read : fbs->draw;
    return f == &fbs->window ? NULL : f;
}

bool fgl_framebuffer_is_window(const struct context *ctx, bool reading)
{
    const struct framebuffers *fbs = ctx->framebuffers;
    return !fbs || (reading ? fbs->read : fbs->draw) == &fbs->window;
}
