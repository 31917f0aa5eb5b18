/* State of the per-fragment operations, of clearing, and fog (GL 1.5, 4.1 "Per-Fragment Operations", 4.2
 * "Whole Framebuffer Operations", 3.10 "Fog"). */
#include "api/command.h"
#include "api/framebuffer_object.h"
#include "api/params.h"
#include "api/set.h"

#include <string.h>

static bool is_compare_func(GLenum func)
{
    return func - GL_NEVER <= GL_ALWAYS - GL_NEVER;
}

void fgl_exec_Scissor(struct context *ctx, GLint x, GLint y, GLsizei width, GLsizei height)
{
    RETURN_ERROR_IF(ctx, width < 0 || height < 0, GL_INVALID_VALUE);
    const int box[4] = {x, y, width, height};
    if (memcmp(ctx->s.scissor.scissor_box, box, sizeof box) == 0)
        return;
    fgl_flush_vertices(ctx, DIRTY_SCISSOR);
    memcpy(ctx->s.scissor.scissor_box, box, sizeof box);
}

void fgl_exec_AlphaFunc(struct context *ctx, GLenum func, GLfloat ref)
{
    RETURN_ERROR_IF(ctx, !is_compare_func(func), GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.alpha_test_func, func);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.alpha_test_ref, ref);
}

void fgl_exec_StencilFunc(struct context *ctx, GLenum func, GLint ref, GLuint mask)
{
    RETURN_ERROR_IF(ctx, !is_compare_func(func), GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_func, func);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_ref, ref);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_value_mask, mask);
}

static bool is_stencil_op(GLenum op)
{
    switch (op) {
    case GL_KEEP:
    case GL_ZERO:
    case GL_REPLACE:
    case GL_INCR:
    case GL_DECR:
    case GL_INVERT:
    case GL_INCR_WRAP:
    case GL_DECR_WRAP: return true;
    default: return false;
    }
}

void fgl_exec_StencilOp(struct context *ctx, GLenum fail, GLenum zfail, GLenum zpass)
{
    RETURN_ERROR_IF(ctx, !is_stencil_op(fail) || !is_stencil_op(zfail) || !is_stencil_op(zpass),
                    GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_fail, fail);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_pass_depth_fail, zfail);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_pass_depth_pass, zpass);
}

void fgl_exec_StencilMask(struct context *ctx, GLuint mask)
{
    SET(ctx, DIRTY_FRAGMENT, ctx->s.stencil.stencil_writemask, mask);
}

void fgl_exec_DepthFunc(struct context *ctx, GLenum func)
{
    RETURN_ERROR_IF(ctx, !is_compare_func(func), GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.depth.depth_func, func);
}

void fgl_exec_DepthMask(struct context *ctx, GLboolean flag)
{
    SET(ctx, DIRTY_FRAGMENT, ctx->s.depth.depth_writemask, flag != GL_FALSE);
}

/* GL 1.5, 4.1.8 "Blending": for the stored colour; the fragment's has GL_SRC_ALPHA_SATURATE besides. */
static bool is_blend_factor(GLenum factor)
{
    switch (factor) {
    case GL_ZERO:
    case GL_ONE:
    case GL_SRC_COLOR:
    case GL_ONE_MINUS_SRC_COLOR:
    case GL_DST_COLOR:
    case GL_ONE_MINUS_DST_COLOR:
    case GL_SRC_ALPHA:
    case GL_ONE_MINUS_SRC_ALPHA:
    case GL_DST_ALPHA:
    case GL_ONE_MINUS_DST_ALPHA:
    case GL_CONSTANT_COLOR:
    case GL_ONE_MINUS_CONSTANT_COLOR:
    case GL_CONSTANT_ALPHA:
    case GL_ONE_MINUS_CONSTANT_ALPHA: return true;
    default: return false;
    }
}

static bool is_source_factor(GLenum factor)
{
    return is_blend_factor(factor) || factor == GL_SRC_ALPHA_SATURATE;
}

void fgl_exec_BlendFuncSeparate(struct context *ctx, GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha,
                                GLenum dfactorAlpha)
{
    struct color_buffer_state *s = &ctx->s.color_buffer;

    RETURN_ERROR_IF(ctx, !is_source_factor(sfactorRGB) || !is_source_factor(sfactorAlpha), GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !is_blend_factor(dfactorRGB) || !is_blend_factor(dfactorAlpha), GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, s->blend_src_rgb, sfactorRGB);
    SET(ctx, DIRTY_FRAGMENT, s->blend_dst_rgb, dfactorRGB);
    SET(ctx, DIRTY_FRAGMENT, s->blend_src_alpha, sfactorAlpha);
    SET(ctx, DIRTY_FRAGMENT, s->blend_dst_alpha, dfactorAlpha);
}

void fgl_exec_BlendFunc(struct context *ctx, GLenum sfactor, GLenum dfactor)
{
    fgl_exec_BlendFuncSeparate(ctx, sfactor, dfactor, sfactor, dfactor);
}

static bool is_blend_equation(GLenum mode)
{
    switch (mode) {
    case GL_FUNC_ADD:
    case GL_FUNC_SUBTRACT:
    case GL_FUNC_REVERSE_SUBTRACT:
    case GL_MIN:
    case GL_MAX: return true;
    default: return false;
    }
}

void fgl_exec_BlendEquationSeparateEXT(struct context *ctx, GLenum modeRGB, GLenum modeAlpha)
{
    RETURN_ERROR_IF(ctx, !is_blend_equation(modeRGB) || !is_blend_equation(modeAlpha), GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.blend_equation[0], modeRGB);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.blend_equation[1], modeAlpha);
}

void fgl_exec_BlendEquation(struct context *ctx, GLenum mode)
{
    fgl_exec_BlendEquationSeparateEXT(ctx, mode, mode);
}

void fgl_exec_BlendColor(struct context *ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    const float color[4] = {red, green, blue, alpha};

    fgl_set_floats(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.blend_color, color, 4);
}

/* GL 1.5, 4.1.3. */
void fgl_exec_SampleCoverage(struct context *ctx, GLfloat value, GLboolean invert)
{
    SET(ctx, DIRTY_RASTER, ctx->s.multisample.sample_coverage_value, fgl_clamp01(value));
    SET(ctx, DIRTY_RASTER, ctx->s.multisample.sample_coverage_invert, invert != GL_FALSE);
}

void fgl_exec_LogicOp(struct context *ctx, GLenum opcode)
{
    RETURN_ERROR_IF(ctx, opcode - GL_CLEAR > GL_SET - GL_CLEAR, GL_INVALID_ENUM);
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.logic_op_mode, opcode);
}

/* OSMesa rule: there is one colour buffer, and the names of the left, the front and the back one are all
 * names of it. */
static GLenum window_buffer_error(GLenum buffer)
{
    if (buffer - GL_COLOR_ATTACHMENT0 <= GL_COLOR_ATTACHMENT15 - GL_COLOR_ATTACHMENT0)
        return GL_INVALID_OPERATION;
    switch (buffer) {
    case GL_NONE:
    case GL_FRONT_LEFT:
    case GL_BACK_LEFT:
    case GL_FRONT:
    case GL_BACK:
    case GL_LEFT:
    case GL_FRONT_AND_BACK: return GL_NO_ERROR;
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT:
    case GL_RIGHT:
    case GL_AUX0:
    case GL_AUX1:
    case GL_AUX2:
    case GL_AUX3: return GL_INVALID_OPERATION;
    default: return GL_INVALID_ENUM;
    }
}

GLenum fgl_buffer_error(const struct context *ctx, GLenum buffer, bool reading)
{
    const GLenum error = window_buffer_error(buffer);
    if (buffer == GL_NONE || error == GL_INVALID_ENUM || fgl_framebuffer_is_window(ctx, reading))
        return error;
    return buffer - GL_COLOR_ATTACHMENT0 < MAX_COLOR_ATTACHMENTS ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

/* OSMesa rule: stored vertices are drawn even when the call changes nothing. */
static bool accept_buffer(struct context *ctx, GLenum buffer, bool reading)
{
    const GLenum error = fgl_buffer_error(ctx, buffer, reading);

    fgl_flush_vertices(ctx, 0);
    RETURN_VALUE_ERROR_IF(ctx, error, error, false);
    if (!fgl_framebuffer_is_window(ctx, reading))
        fgl_framebuffer_unload(ctx);
    return true;
}

void fgl_exec_DrawBuffer(struct context *ctx, GLenum buf)
{
    if (accept_buffer(ctx, buf, false))
        SET(ctx, DIRTY_FRAMEBUFFER, ctx->s.color_buffer.draw_buffer, buf);
}

void fgl_exec_ReadBuffer(struct context *ctx, GLenum src)
{
    if (accept_buffer(ctx, src, true))
        ctx->s.pixel_mode.read_buffer = src;
}

void fgl_exec_IndexMask(struct context *ctx, GLuint mask)
{
    SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.index_writemask, mask);
}

void fgl_exec_ColorMask(struct context *ctx, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha)
{
    const bool mask[4] = {red != GL_FALSE, green != GL_FALSE, blue != GL_FALSE, alpha != GL_FALSE};

    for (int i = 0; i < 4; i++)
        SET(ctx, DIRTY_FRAGMENT, ctx->s.color_buffer.color_writemask[i], mask[i]);
}

/* Clear values matter to glClear alone, which draws stored vertices itself. */

void fgl_exec_ClearColor(struct context *ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    const float color[4] = {red, green, blue, alpha};

    memcpy(ctx->s.color_buffer.color_clear_value, color, sizeof color);
}

void fgl_exec_ClearIndex(struct context *ctx, GLfloat c)
{
    ctx->s.color_buffer.index_clear_value = c;
}

void fgl_exec_ClearDepth(struct context *ctx, GLdouble depth)
{
    ctx->s.depth.depth_clear_value = depth > 0 ? (depth < 1 ? depth : 1) : 0; /* NaN is 0 */
}

void fgl_exec_ClearStencil(struct context *ctx, GLint s)
{
    ctx->s.stencil.stencil_clear_value = s;
}

void fgl_exec_Fogfv(struct context *ctx, GLenum pname, const GLfloat *params)
{
    const struct param *p = fgl_fog_param(pname);
    RETURN_ERROR_IF(ctx, !p, GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx,
                    pname == GL_FOG_MODE && params[0] != (float)GL_LINEAR && params[0] != (float)GL_EXP &&
                            params[0] != (float)GL_EXP2,
                    GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx,
                    pname == GL_FOG_COORD_SRC && params[0] != (float)GL_FOG_COORD &&
                            params[0] != (float)GL_FRAGMENT_DEPTH,
                    GL_INVALID_ENUM);
    RETURN_ERROR_IF(ctx, !fgl_param_allows(p, params), GL_INVALID_VALUE);

    fgl_param_set(ctx, DIRTY_FOG, p, &ctx->s.fog, params);
}

void GLAPIENTRY glFogiv(GLenum pname, const GLint *params)
{
    float v[4];

    fgl_param_from_ints(fgl_fog_param(pname), params, v);
    glFogfv(pname, v);
}

static GLenum scalar_fog(GLenum pname)
{
    return fgl_count_fog(pname) == 1 ? pname : GL_NONE;
}

void GLAPIENTRY glFogf(GLenum pname, GLfloat param)
{
    glFogfv(scalar_fog(pname), &param);
}
void GLAPIENTRY glFogi(GLenum pname, GLint param)
{
    glFogiv(scalar_fog(pname), &param);
}
