/* Framebuffer objects made ready to draw to and to read from (GL_ARB_framebuffer_object, "Framebuffer Completeness"). */
#include "api/framebuffer_object.h"

#include "api/command.h"
#include "api/errors.h"
#include "pipeline/surface.h"

/* ---- completeness ---- */

static bool is_complete(const struct attachment *a, int point)
{
    const struct texture_image *image = fgl_attachment_image(a);
    if (!image->format || image->width == 0 || image->height == 0 || a->slice >= image->depth)
        return false;
    switch (point) {
    case ATTACHMENT_DEPTH: return image->kind == TEXELS_DEPTH && image->texels;
    case ATTACHMENT_STENCIL: return image->stencil != NULL;
    default: return fgl_texture_format_drawable(image->format);
    }
}

/* Samples of the attached image; a texture has none. */
static int samples_of(const struct attachment *a)
{
    return a->renderbuffer ? a->renderbuffer->samples : 0;
}

GLenum fgl_framebuffer_status(const struct framebuffer_object *f)
{
    const struct attachment *first = NULL;
    bool same_samples = true;
    for (int i = 0; i < ATTACHMENTS; i++) {
        const struct attachment *a = &f->attachment[i];
        if (!fgl_attachment_image(a))
            continue;
        if (!is_complete(a, i))
            return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
        first = first ? first : a;
        same_samples = same_samples && samples_of(a) == samples_of(first);
    }
    if (!first)
        return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    return same_samples ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
}

/* Images hold colours: contexts in colour index mode have their window alone. */
static GLenum status(const struct context *ctx, const struct framebuffer_object *f)
{
    return ctx->color_index ? GL_FRAMEBUFFER_UNSUPPORTED : fgl_framebuffer_status(f);
}

GLenum fgl_exec_CheckFramebufferStatus(struct context *ctx, GLenum target)
{
    bool bad;
    const struct framebuffer_object *f = fgl_framebuffer_bound(ctx, target, &bad);
    RETURN_VALUE_ERROR_IF(ctx, bad, GL_INVALID_ENUM, 0);
    return f ? status(ctx, f) : GL_FRAMEBUFFER_COMPLETE;
}

/* ---- planes ---- */

struct surfaces {
    struct surface color, depth, stencil;
};

static struct surface surface_of(const struct framebuffer_object *f, int point)
{
    const struct attachment *a = &f->attachment[point];
    return (struct surface){fgl_attachment_image(a), a->slice};
}

/* What is drawn to, or read, with this buffer of glDrawBuffer or glReadBuffer. */
static struct surfaces surfaces_of(const struct framebuffer_object *f, GLenum buffer)
{
    struct surfaces s = {.depth = surface_of(f, ATTACHMENT_DEPTH), .stencil = surface_of(f, ATTACHMENT_STENCIL)};
    if (buffer != GL_NONE)
        s.color = surface_of(f, (int)(buffer - GL_COLOR_ATTACHMENT0));
    return s;
}

/* What all attachments have is drawn to, whichever of them are. */
static void find_size(const struct framebuffer_object *f, int *width, int *height)
{
    *width = *height = FGL_MAX_TEXTURE_SIZE;
    for (int i = 0; i < ATTACHMENTS; i++) {
        const struct texture_image *image = fgl_attachment_image(&f->attachment[i]);
        *width = image ? fgl_min(*width, image->width) : *width;
        *height = image ? fgl_min(*height, image->height) : *height;
    }
}

/* NULL: incomplete, or memory is short. */
static struct framebuffer *load(struct context *ctx, const struct framebuffer_object *f, GLenum buffer, bool reading)
{
    struct framebuffer *planes = reading ? &ctx->framebuffers->read_planes : &ctx->framebuffers->drawn_planes;
    if (f == &ctx->framebuffers->window)
        return ctx->window;
    if (status(ctx, f) != GL_FRAMEBUFFER_COMPLETE)
        return NULL;
    const struct surfaces s = surfaces_of(f, buffer);
    int width, height;
    find_size(f, &width, &height);
    if (fgl_surface_load(planes, width, height, &s.color, &s.depth, &s.stencil, reading))
        return planes;
    fgl_error(ctx, GL_OUT_OF_MEMORY);
    return NULL;
}

/* Whether what is read is what is drawn to: buffers that have no colours need no planes of their own. */
static bool reads_drawn(const struct context *ctx)
{
    const struct framebuffers *fbs = ctx->framebuffers;
    const GLenum buffer = ctx->s.pixel_mode.read_buffer;
    if (fbs->read != fbs->draw)
        return false;
    if (fbs->read == &fbs->window || !ctx->framebuffer)
        return true;
    const struct texture_image *color = surfaces_of(fbs->read, buffer).color.image;
    return !color || (buffer == ctx->s.color_buffer.draw_buffer && fgl_surface_is_plain(color));
}

static void load_read(struct context *ctx)
{
    ctx->read_framebuffer = reads_drawn(ctx) ? ctx->framebuffer
                                             : load(ctx, ctx->framebuffers->read, ctx->s.pixel_mode.read_buffer, true);
}

void fgl_framebuffer_update(struct context *ctx)
{
    struct framebuffers *fbs = ctx->framebuffers;
    if (!fbs || !fbs->stale)
        return;
    fbs->stale = false;
    ctx->framebuffer = load(ctx, fbs->draw, ctx->s.color_buffer.draw_buffer, false);
    load_read(ctx);
    ctx->dirty |= DIRTY_FRAMEBUFFER;
}

bool fgl_draw_ready_slow(struct context *ctx)
{
    fgl_framebuffer_update(ctx);
    RETURN_VALUE_ERROR_IF(ctx, !ctx->framebuffer && !fgl_framebuffer_is_window(ctx, false), GL_INVALID_FRAMEBUFFER_OPERATION, false);
    return true;
}

bool fgl_read_ready_slow(struct context *ctx)
{
    struct framebuffers *fbs = ctx->framebuffers;
    fgl_flush_vertices(ctx, 0);
    fgl_framebuffer_update(ctx);
    if (ctx->read_framebuffer == &fbs->read_planes && ctx->framebuffer && ctx->framebuffer->drawn) { /* they may share images */
        fgl_framebuffer_unload(ctx);
        fgl_framebuffer_update(ctx);
    }
    RETURN_VALUE_ERROR_IF(ctx, !ctx->read_framebuffer && !fgl_framebuffer_is_window(ctx, true), GL_INVALID_FRAMEBUFFER_OPERATION,
                          false);
    return true;
}

bool fgl_framebuffer_reads_color(const struct context *ctx)
{
    const GLenum buffer = ctx->s.pixel_mode.read_buffer;
    if (buffer == GL_NONE)
        return false;
    return fgl_framebuffer_is_window(ctx, true) || surfaces_of(ctx->framebuffers->read, buffer).color.image;
}

int fgl_framebuffer_color_bits(const struct context *ctx, int channel)
{
    static const uint8_t bits_of[][4] = { /* by enum color_kind */
            {8, 8, 8, 8}, {16, 16, 16, 16}, {32, 32, 32, 32}, {5, 6, 5, 0}, {0, 0, 0, 0},
    };
    const struct framebuffer *fb = ctx->framebuffer;
    if (!fb || (channel == 3 && !fb->has_alpha))
        return 0;
    if (fgl_framebuffer_is_window(ctx, false))
        return bits_of[fb->color_kind][channel];
    const struct surface color = surfaces_of(ctx->framebuffers->draw, ctx->s.color_buffer.draw_buffer).color;
    return color.image ? fgl_image_color_bits(color.image, channel) : 0;
}

/* ---- storing ---- */

/* Whether no context that shares the attached images has made others of them since they were loaded. */
static bool still_fits(const struct framebuffers *fbs)
{
    const struct framebuffer *planes = &fbs->drawn_planes;
    int width, height;
    if (fgl_framebuffer_status(fbs->draw) != GL_FRAMEBUFFER_COMPLETE)
        return false;
    find_size(fbs->draw, &width, &height);
    return width == planes->width && height == planes->height;
}

void fgl_framebuffer_store(struct context *ctx)
{
    struct framebuffers *fbs = ctx->framebuffers;
    fgl_flush_vertices(ctx, 0);
    if (!fbs || fbs->stale || ctx->framebuffer != &fbs->drawn_planes || !fbs->drawn_planes.drawn)
        return;
    fbs->drawn_planes.drawn = false;
    if (!still_fits(fbs))
        return;
    const struct surfaces s = surfaces_of(fbs->draw, ctx->s.color_buffer.draw_buffer);
    fgl_surface_store(&fbs->drawn_planes, &s.color, &s.depth, &s.stencil);
    if (ctx->read_framebuffer == &fbs->read_planes) /* which may have the same images */
        fbs->stale = true;
}

void fgl_framebuffer_unload(struct context *ctx)
{
    fgl_framebuffer_store(ctx);
    if (ctx->framebuffers)
        ctx->framebuffers->stale = true;
}

static bool is_attached(const struct framebuffer_object *f, const struct texture_object *texture)
{
    for (int i = 0; i < ATTACHMENTS; i++)
        if (f->attachment[i].texture == texture)
            return true;
    return false;
}

void fgl_framebuffer_unload_texture(struct context *ctx, const struct texture_object *texture)
{
    const struct framebuffers *fbs = ctx->framebuffers;
    if (fbs && (is_attached(fbs->draw, texture) || is_attached(fbs->read, texture)))
        fgl_framebuffer_unload(ctx);
}

void fgl_framebuffer_keep_buffers(struct context *ctx, GLenum draw_buffer, GLenum read_buffer)
{
    GLenum *draw = &ctx->s.color_buffer.draw_buffer, *read = &ctx->s.pixel_mode.read_buffer;
    const GLenum new_draw = fgl_buffer_error(ctx, *draw, false) ? draw_buffer : *draw,
                 new_read = fgl_buffer_error(ctx, *read, true) ? read_buffer : *read;
    *draw = draw_buffer; /* under which pixels are stored */
    *read = read_buffer;
    if (new_draw != draw_buffer || new_read != read_buffer)
        fgl_framebuffer_unload(ctx);
    *draw = new_draw;
    *read = new_read;
}

void fgl_framebuffer_set_window(struct context *ctx, struct framebuffer *window)
{
    ctx->window = window;
    if (ctx->framebuffers)
        ctx->framebuffers->stale = true;
    if (fgl_framebuffer_is_window(ctx, false))
        ctx->framebuffer = window;
    if (fgl_framebuffer_is_window(ctx, true))
        ctx->read_framebuffer = window;
}
