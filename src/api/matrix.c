/* Matrix commands (GL 1.5, 2.11.2 "Matrices"). The arithmetic is state/matrix.c's. */
#include "api/command.h"
#include "api/errors.h"
#include "fixedgl.h"
#include "state/matrix_exact.h"

#include <string.h>

static struct matrix_stack *current_stack(struct context *ctx)
{
    switch (ctx->s.transform.matrix_mode) {
    case GL_PROJECTION: return &ctx->projection;
    case GL_TEXTURE: return &ctx->texture_matrix[ctx->s.texture.active_texture];
    case GL_COLOR: return &ctx->color_matrix;
    default: return &ctx->modelview;
    }
}

/* The matrix that a command is about to change. */
static struct matrix *change(struct context *ctx)
{
    struct matrix_stack *stack = current_stack(ctx);

    fgl_flush_vertices(ctx, stack->dirty);
    stack->changed = true;
    return fgl_matrix_top(stack);
}

void fgl_exec_MatrixMode(struct context *ctx, GLenum mode)
{
    RETURN_ERROR_IF(ctx, mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE && mode != GL_COLOR,
                    GL_INVALID_ENUM);
    ctx->s.transform.matrix_mode = mode;
}

void fgl_exec_LoadIdentity(struct context *ctx)
{
    fgl_matrix_load_identity(change(ctx));
}

/* OSMesa rule: loading the values that are there already, or multiplying by the identity, changes neither
 * matrix nor flags. */
void fgl_exec_LoadMatrixf(struct context *ctx, const GLfloat *m)
{
    const struct matrix *top = fgl_matrix_top(current_stack(ctx));
    double exact[16];

    fgl_exact_load(exact, m);
    if (memcmp(top->m, m, sizeof top->m) != 0 ||
        (ctx->accuracy == FIXEDGL_EXACT && memcmp(top->exact, exact, sizeof exact) != 0))
        fgl_matrix_load(change(ctx), m);
}

void fgl_exec_MultMatrixf(struct context *ctx, const GLfloat *m)
{
    static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    if (memcmp(m, identity, sizeof identity) != 0)
        fgl_matrix_multiply(change(ctx), m);
}

static void to_floats(float out[16], const GLdouble *in)
{
    for (int i = 0; i < 16; i++)
        out[i] = (float)in[i];
}

void GLAPIENTRY glLoadMatrixd(const GLdouble *m)
{
    float v[16];

    to_floats(v, m);
    glLoadMatrixf(v);
}

/* The commands that take rows. */
static void transpose(float out[16], const float in[16])
{
    for (int i = 0; i < 16; i++)
        out[i] = in[i % 4 * 4 + i / 4];
}

void GLAPIENTRY glLoadTransposeMatrixf(const GLfloat *m)
{
    float v[16];

    transpose(v, m);
    glLoadMatrixf(v);
}

void GLAPIENTRY glMultTransposeMatrixf(const GLfloat *m)
{
    float v[16];

    transpose(v, m);
    glMultMatrixf(v);
}

void GLAPIENTRY glLoadTransposeMatrixd(const GLdouble *m)
{
    float v[16];

    to_floats(v, m);
    glLoadTransposeMatrixf(v);
}

void GLAPIENTRY glMultTransposeMatrixd(const GLdouble *m)
{
    float v[16];

    to_floats(v, m);
    glMultTransposeMatrixf(v);
}

void GLAPIENTRY glMultMatrixd(const GLdouble *m)
{
    float v[16];

    to_floats(v, m);
    glMultMatrixf(v);
}

void fgl_exec_Rotatef(struct context *ctx, GLfloat angle, GLfloat x, GLfloat y, GLfloat z)
{
    if (angle != 0.0f)
        fgl_matrix_rotate(change(ctx), angle, x, y, z);
    else
        fgl_flush_vertices(
                ctx, 0); /* OSMesa rule: the flags do not learn of a rotation by 0, but vertices are drawn */
}

void fgl_exec_Translatef(struct context *ctx, GLfloat x, GLfloat y, GLfloat z)
{
    fgl_matrix_translate(change(ctx), x, y, z);
}

void fgl_exec_Scalef(struct context *ctx, GLfloat x, GLfloat y, GLfloat z)
{
    fgl_matrix_scale(change(ctx), x, y, z);
}

void GLAPIENTRY glRotated(GLdouble angle, GLdouble x, GLdouble y, GLdouble z)
{
    glRotatef((float)angle, (float)x, (float)y, (float)z);
}

void GLAPIENTRY glTranslated(GLdouble x, GLdouble y, GLdouble z)
{
    glTranslatef((float)x, (float)y, (float)z);
}

void GLAPIENTRY glScaled(GLdouble x, GLdouble y, GLdouble z)
{
    glScalef((float)x, (float)y, (float)z);
}

void fgl_exec_Frustum(struct context *ctx, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
                      GLdouble near_val, GLdouble far_val)
{
    RETURN_ERROR_IF(ctx, near_val <= 0 || far_val <= 0 || near_val == far_val, GL_INVALID_VALUE);
    RETURN_ERROR_IF(ctx, left == right || bottom == top, GL_INVALID_VALUE);
    fgl_matrix_frustum(change(ctx), left, right, bottom, top, near_val, far_val);
}

void fgl_exec_Ortho(struct context *ctx, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
                    GLdouble near_val, GLdouble far_val)
{
    RETURN_ERROR_IF(ctx, left == right || bottom == top || near_val == far_val, GL_INVALID_VALUE);
    fgl_matrix_ortho(change(ctx), left, right, bottom, top, near_val, far_val);
}

void fgl_exec_PushMatrix(struct context *ctx)
{
    struct matrix_stack *stack = current_stack(ctx);

    RETURN_ERROR_IF(ctx, stack->top + 1 >= stack->limit, GL_STACK_OVERFLOW);
    (void)fgl_matrix_class(fgl_matrix_top(stack)); /* OSMesa rule: a use, which classifies the matrix */
    stack->entry[stack->top + 1] = stack->entry[stack->top];
    stack->top++;
    stack->changed = false;
}

/* OSMesa rule: a pop that brings back the same matrix and flags does not end a batch of vertices. */
void fgl_exec_PopMatrix(struct context *ctx)
{
    struct matrix_stack *stack = current_stack(ctx);

    RETURN_ERROR_IF(ctx, stack->top == 0, GL_STACK_UNDERFLOW);
    const struct matrix *top = fgl_matrix_top(stack), *below = top - 1;
    const bool same = ctx->accuracy == FIXEDGL_EXACT ? fgl_matrix_exactly_equal(top, below)
                                                     : memcmp(top->m, below->m, sizeof top->m) == 0;
    if (stack->changed && (top->flags != below->flags || !same))
        fgl_flush_vertices(ctx, stack->dirty);
    stack->top--;
    stack->changed = true;
}
