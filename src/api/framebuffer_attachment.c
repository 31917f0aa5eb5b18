/* Attaching images to framebuffer objects, and queries (GL_ARB_framebuffer_object, "Attaching Images to Framebuffer Objects"). */
#include "api/framebuffer_object.h"

#include "api/command.h"
#include "api/errors.h"
#include "api/texture_target.h"
#include "texture/mipmap.h"

/* ---- attachments ---- */

void fgl_attachment_clear(struct attachment *a)
{
    fgl_texture_release(a->texture);
    fgl_renderbuffer_refer(&a->renderbuffer, NULL);
    *a = (struct attachment){0};
}

struct texture_image *fgl_attachment_image(const struct attachment *a)
{
    if (a->texture)
        return &a->texture->image[a->face][a->level];
    return a->renderbuffer ? &a->renderbuffer->image : NULL;
}

/* Puts b, whose references are the caller's, in the place of a. */
static void attach(struct attachment *a, const struct attachment *b)
{
    const struct attachment old = *a;
    *a = *b;
    if (a->texture)
        atomic_fetch_add(&a->texture->references, 1);
    if (a->renderbuffer)
        atomic_fetch_add(&a->renderbuffer->references, 1);
    struct attachment gone = old;
    fgl_attachment_clear(&gone);
}

static void detach(struct framebuffer_object *f, const struct texture_object *texture, const struct renderbuffer *r)
{
    for (int i = 0; i < ATTACHMENTS; i++) {
        struct attachment *a = &f->attachment[i];
        if ((texture && a->texture == texture) || (r && a->renderbuffer == r))
            fgl_attachment_clear(a);
    }
}

void fgl_framebuffer_detach(struct context *ctx, const struct texture_object *texture, const struct renderbuffer *r)
{
    struct framebuffers *fbs = ctx->framebuffers;
    if (!fbs)
        return;
    fgl_framebuffer_unload(ctx);
    detach(fbs->draw, texture, r);
    detach(fbs->read, texture, r);
}

/* The attachments that an enum names: *first and, of GL_DEPTH_STENCIL_ATTACHMENT, the one after it. GL_NO_ERROR or what is wrong. */
static GLenum find_point(GLenum attachment, int *first, int *count)
{
    *count = 1;
    switch (attachment) {
    case GL_DEPTH_STENCIL_ATTACHMENT: *count = 2; /* fall through */
    case GL_DEPTH_ATTACHMENT: *first = ATTACHMENT_DEPTH; return GL_NO_ERROR;
    case GL_STENCIL_ATTACHMENT: *first = ATTACHMENT_STENCIL; return GL_NO_ERROR;
    default: break;
    }
    if (attachment < GL_COLOR_ATTACHMENT0 || attachment > GL_COLOR_ATTACHMENT15)
        return GL_INVALID_ENUM;
    *first = (int)(attachment - GL_COLOR_ATTACHMENT0);
    return *first < MAX_COLOR_ATTACHMENTS ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

/* Attaches an image to a point of the bound object. */
static void attach_to(struct context *ctx, GLenum target, GLenum attachment, const struct attachment *image)
{
    bool bad;
    int first, count;
    struct framebuffer_object *f = fgl_framebuffer_bound(ctx, target, &bad);
    RETURN_ERROR_IF(ctx, bad, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !f, GL_INVALID_OPERATION);
    const GLenum error = find_point(attachment, &first, &count);
    RETURN_ERROR_IF(ctx, error, error);
    fgl_framebuffer_unload(ctx);
    for (int i = first; i < first + count; i++)
        attach(&f->attachment[i], image);
}

/* ---- textures ---- */

/* The level of a texture named by a program. dimensions: of glFramebufferTexture, or 0: any layer of a 3D texture. */
static GLenum find_image(struct context *ctx, int dimensions, GLenum textarget, GLuint name, GLint level, GLint slice,
                         struct attachment *image)
{
    struct image_target t;
    struct texture_object *texture = name ? fgl_idmap_get(&ctx->textures->map, name) : NULL;
    if (!name)
        return GL_NO_ERROR;
    if (!texture || texture == &fgl_texture_unbound)
        return GL_INVALID_OPERATION;
    if (!fgl_image_target(textarget, 0, &t) || t.proxy)
        return GL_INVALID_ENUM;
    if (!fgl_image_target(textarget, dimensions, &t) || t.target != texture->target)
        return GL_INVALID_OPERATION;
    if (level < 0 || level >= fgl_texture_levels(t.target))
        return GL_INVALID_VALUE;
    if (slice < 0 || slice >= 1 << (FGL_MAX_3D_TEXTURE_LEVELS - 1))
        return GL_INVALID_VALUE;
    *image = (struct attachment){.texture = texture, .face = t.face, .level = level, .slice = slice};
    return GL_NO_ERROR;
}

static void attach_texture(struct context *ctx, GLenum target, GLenum attachment, int dimensions, GLenum textarget, GLuint texture,
                           GLint level, GLint slice)
{
    struct attachment image = {0};
    bool bad;
    const struct framebuffer_object *f = fgl_framebuffer_bound(ctx, target, &bad);
    RETURN_ERROR_IF(ctx, bad, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !f, GL_INVALID_OPERATION);
    const GLenum error = find_image(ctx, dimensions, textarget, texture, level, slice, &image);
    RETURN_ERROR_IF(ctx, error, error);
    attach_to(ctx, target, attachment, &image);
}

void fgl_exec_FramebufferTexture1D(struct context *ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level)
{
    attach_texture(ctx, target, attachment, 1, textarget, texture, level, 0);
}

void fgl_exec_FramebufferTexture2D(struct context *ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level)
{
    attach_texture(ctx, target, attachment, 2, textarget, texture, level, 0);
}

void fgl_exec_FramebufferTexture3D(struct context *ctx, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level,
                                   GLint zoffset)
{
    attach_texture(ctx, target, attachment, 3, textarget, texture, level, zoffset);
}

void fgl_exec_FramebufferTextureLayer(struct context *ctx, GLenum target, GLenum attachment, GLuint texture, GLint level, GLint layer)
{
    attach_texture(ctx, target, attachment, 3, GL_TEXTURE_3D, texture, level, layer);
}

/* ---- renderbuffers ---- */

void fgl_exec_FramebufferRenderbuffer(struct context *ctx, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                                      GLuint renderbuffer)
{
    const struct attachment image = {.renderbuffer = fgl_renderbuffer_lookup(ctx, renderbuffer)};
    bool bad;
    (void)fgl_framebuffer_bound(ctx, target, &bad);
    RETURN_ERROR_IF(ctx, bad || renderbuffertarget != GL_RENDERBUFFER, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, renderbuffer && !image.renderbuffer, GL_INVALID_OPERATION);
    attach_to(ctx, target, attachment, &image);
}

/* ---- queries ---- */

static GLint component_bits(const struct texture_image *image, GLenum pname)
{
    if (!image || !image->format)
        return 0;
    const bool depth = image->kind == TEXELS_DEPTH;
    switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE: return depth ? image->format->bits[0] : 0;
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE: return image->stencil ? 8 : 0;
    default: return fgl_image_color_bits(image, (int)(pname - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE));
    }
}

static bool is_srgb(const struct texture_image *image)
{
    return image->format && image->format->encoding == ENCODED_SRGB;
}

/* OSMesa rule: stencil alone is an index. */
static GLint component_type(const struct texture_image *image)
{
    if (!image->format)
        return GL_NONE;
    if (!image->texels && image->stencil)
        return GL_INDEX;
    const bool snorm = image->format->encoding == ENCODED_SNORM;
    return snorm ? GL_SIGNED_NORMALIZED : fgl_texture_format_leaves_unit(image->format) ? GL_FLOAT : GL_UNSIGNED_NORMALIZED;
}

/* Properties that every attachment of an object has. */
static void get_common(struct context *ctx, const struct attachment *a, GLenum pname, GLint *params)
{
    switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE: *params = component_bits(fgl_attachment_image(a), pname); break;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING: *params = is_srgb(fgl_attachment_image(a)) ? GL_SRGB_EXT : GL_LINEAR; break;
    case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE: *params = component_type(fgl_attachment_image(a)); break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}

static void get_property(struct context *ctx, const struct attachment *a, GLenum pname, GLint *params)
{
    const bool none = !a->texture && !a->renderbuffer;
    switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE:
        *params = a->texture ? GL_TEXTURE : a->renderbuffer ? GL_RENDERBUFFER : GL_NONE;
        return;
    case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME:
        *params = (GLint)(a->texture ? a->texture->name : a->renderbuffer ? a->renderbuffer->name : 0);
        return;
    default: break;
    }
    RETURN_ERROR_IF(ctx, none, GL_INVALID_OPERATION);
    if (!a->texture) {
        get_common(ctx, a, pname, params);
        return;
    }
    const bool cube = a->texture->target == TEXTURE_CUBE_MAP;
    switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL: *params = a->level; break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE: *params = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + a->face : 0; break;
    case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER: *params = a->slice; break;
    default: get_common(ctx, a, pname, params); break;
    }
}

/* Bits of red, green, blue or alpha in the window. */
static GLint window_color_bits(const struct framebuffer *fb, int channel)
{
    static const uint8_t bits[][4] = { /* by enum color_kind */
            {8, 8, 8, 8}, {16, 16, 16, 16}, {32, 32, 32, 32}, {5, 6, 5, 0}, {0, 0, 0, 0},
    };
    return channel == 3 && !fb->has_alpha ? 0 : bits[fb->color_kind][channel];
}

/* The window's buffers have names of their own. Depth and stencil are one buffer. */
static void get_window_property(struct context *ctx, const struct framebuffer *fb, GLenum attachment, GLenum pname, GLint *params)
{
    const bool color = attachment == GL_FRONT_LEFT || attachment == GL_BACK_LEFT || attachment == GL_FRONT || attachment == GL_BACK;
    const bool other = attachment == GL_DEPTH || attachment == GL_STENCIL, none = attachment == GL_FRONT_RIGHT || attachment == GL_BACK_RIGHT;
    RETURN_ERROR_IF(ctx, !color && !other && !none, GL_INVALID_ENUM);
    const bool there = fb && (color || (other && (attachment == GL_DEPTH ? fb->depth_bits : fb->stencil_bits)));
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
        *params = there ? GL_FRAMEBUFFER_DEFAULT : GL_NONE;
        return;
    }
    RETURN_ERROR_IF(ctx, pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !there, GL_INVALID_OPERATION);
    switch (pname) {
    case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
    case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
        *params = color ? window_color_bits(fb, (int)(pname - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE)) : 0;
        break;
    case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE: *params = color ? 0 : fb->depth_bits; break;
    case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE: *params = color ? 0 : fb->stencil_bits; break;
    case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING: *params = GL_LINEAR; break;
    case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE: *params = color && fb->color_kind == COLOR_FLOAT ? GL_FLOAT : GL_UNSIGNED_NORMALIZED; break;
    default: fgl_error(ctx, GL_INVALID_ENUM); break;
    }
}

void fgl_exec_GetFramebufferAttachmentParameteriv(struct context *ctx, GLenum target, GLenum attachment, GLenum pname, GLint *params)
{
    bool bad;
    int first, count;
    const struct framebuffer_object *f = fgl_framebuffer_bound(ctx, target, &bad);
    RETURN_ERROR_IF(ctx, bad, GL_INVALID_ENUM);
    if (!f) {
        get_window_property(ctx, target == GL_READ_FRAMEBUFFER ? ctx->read_framebuffer : ctx->framebuffer, attachment, pname, params);
        return;
    }
    const GLenum error = find_point(attachment, &first, &count);
    RETURN_ERROR_IF(ctx, error, error);
    const struct attachment *a = &f->attachment[first];
    RETURN_ERROR_IF(ctx, count == 2 && fgl_attachment_image(a) != fgl_attachment_image(a + 1), GL_INVALID_OPERATION);
    get_property(ctx, a, pname, params);
}

/* ---- mipmaps ---- */

void fgl_exec_GenerateMipmap(struct context *ctx, GLenum target)
{
    enum texture_target t;
    RETURN_ERROR_IF(ctx, !fgl_texture_target(target, &t) || t == TEXTURE_RECTANGLE, GL_INVALID_ENUM);
    struct texture_object *object = fgl_bound_texture(ctx, t);
    const int base = fgl_texture_base_level(object);
    RETURN_ERROR_IF(ctx, fgl_texture_faces(t) > 1 && (base >= FGL_MAX_TEXTURE_LEVELS || object->image[0][base].width == 0),
                    GL_INVALID_OPERATION); /* not cube complete */
    for (int face = 1; face < fgl_texture_faces(t); face++)
        RETURN_ERROR_IF(ctx, object->image[face][base].width != object->image[0][base].width ||
                                     object->image[face][base].format != object->image[0][base].format,
                        GL_INVALID_OPERATION);
    fgl_texture_touch(ctx, object);
    for (int face = 0; face < fgl_texture_faces(t); face++)
        RETURN_ERROR_IF(ctx, !fgl_texture_generate_mipmaps(object, face), GL_OUT_OF_MEMORY);
}
