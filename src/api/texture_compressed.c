/* The compressed image commands (GL 1.5, 3.8.3 "Compressed Texture Images"). No specific compressed format is supported
 * (GL_NUM_COMPRESSED_TEXTURE_FORMATS is 0), the generic ones are not for these commands, and no image is ever compressed: all
 * that is left are the errors. */
#include "api/command.h"
#include "api/errors.h"
#include "api/list.h"
#include "api/texture_image.h"

/* No format is accepted. */
static void refuse_image(void)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (fgl_refused_inside(ctx))
        return;
    fgl_command_error(ctx, GL_INVALID_ENUM);
}

void GLAPIENTRY glCompressedTexImage1D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLint border,
                                       GLsizei imageSize, const GLvoid *data)
{
    (void)target, (void)level, (void)internalformat, (void)width, (void)border, (void)imageSize, (void)data;
    refuse_image();
}

void GLAPIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height,
                                       GLint border, GLsizei imageSize, const GLvoid *data)
{
    (void)target, (void)level, (void)internalformat, (void)width, (void)height, (void)border, (void)imageSize, (void)data;
    refuse_image();
}

void GLAPIENTRY glCompressedTexImage3D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height,
                                       GLsizei depth, GLint border, GLsizei imageSize, const GLvoid *data)
{
    (void)target, (void)level, (void)internalformat, (void)width, (void)height, (void)depth, (void)border, (void)imageSize;
    (void)data;
    refuse_image();
}

void GLAPIENTRY glCompressedTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                                          GLsizei imageSize, const GLvoid *data)
{
    (void)target, (void)level, (void)xoffset, (void)width, (void)format, (void)imageSize, (void)data;
    refuse_image();
}

void GLAPIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                                          GLsizei height, GLenum format, GLsizei imageSize, const GLvoid *data)
{
    (void)target, (void)level, (void)xoffset, (void)yoffset, (void)width, (void)height, (void)format, (void)imageSize;
    (void)data;
    refuse_image();
}

void GLAPIENTRY glCompressedTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                                          GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize,
                                          const GLvoid *data)
{
    (void)target, (void)level, (void)xoffset, (void)yoffset, (void)zoffset, (void)width, (void)height, (void)depth;
    (void)format, (void)imageSize, (void)data;
    refuse_image();
}

void fgl_exec_GetCompressedTexImage(struct context *ctx, GLenum target, GLint level, GLvoid *img)
{
    struct image_target t;
    (void)img;
    RETURN_ERROR_IF(ctx, !fgl_image_target(target, 0, &t) || t.proxy, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, level < 0 || level >= fgl_texture_levels(t.target), GL_INVALID_VALUE);
    fgl_error(ctx, GL_INVALID_OPERATION);
}
