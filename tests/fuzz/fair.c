/* A walk over a script's primitives. */
#include "fair.h"

#include "fair_buffers.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <string.h>

struct primitive {
    bool open, steady, in_list, counted; /* counted: its vertices are all in the script */
    int mode, vertices;
    unsigned attributes; /* given so far */
};

/* The vertex attribute that a command gives: a bit; 0: none. */
static unsigned attribute_of(int command)
{
    if (command >= CMD_Normal3b && command < CMD_Color3b)
        return 1;
    if (command >= CMD_Color3b && command < CMD_TexCoord1f)
        return 2;
    if (command >= CMD_TexCoord1f && command < CMD_SecondaryColor3f)
        return 4;
    if (command >= CMD_SecondaryColor3f && command < CMD_EdgeFlag)
        return 32u << (command - CMD_SecondaryColor3f);
    if (command == CMD_EdgeFlag || command == CMD_EdgeFlagv)
        return 8;
    return command >= CMD_Materialf && command <= CMD_Materialiv ? 16 : 0;
}

static bool complete(int mode, int n)
{
    static const int least[10] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3}, step[10] = {1, 2, 1, 1, 3, 1, 1, 4, 2, 1};
    return mode < 0 || mode > GL_POLYGON || (n >= least[mode] && n % step[mode] == 0);
}

static bool fair_end(const struct primitive *p)
{
    if (!p->counted)
        return true;
    return p->vertices > 0 && !(p->mode == GL_TRIANGLES && p->vertices / 3 == 3) &&
           (!p->in_list || complete(p->mode, p->vertices));
}

/* A command between Begin and End. */
static bool fair_inside(struct primitive *p, int command)
{
    const unsigned attribute = attribute_of(command);
    if (command >= CMD_Vertex2d && command < CMD_Normal3b)
        p->vertices++;
    else if (command == CMD_ArrayElement || command == CMD_CallList || command == CMD_CallLists ||
             (command >= CMD_EvalCoord1f && command <= CMD_EvalPoint2))
        p->counted = false;
    if (p->steady && attribute && p->vertices > 0 && !(p->attributes & attribute))
        return false;
    p->attributes |= attribute;
    return true;
}

static bool is_color_sum(const struct script *s, int i, int command)
{
    return i < s->ops && s->op[i].command == command && s->value[s->op[i].first] == GL_COLOR_SUM;
}

static bool is_fog_source(const struct script *s, int i)
{
    return i < s->ops && s->op[i].command == CMD_Fogi && s->value[s->op[i].first] == GL_FOG_COORD_SRC;
}

static bool fair_pop(const struct script *s, int i)
{
    const int before = i > 0 ? s->op[i - 1].command : -1, after = i + 1 < s->ops ? s->op[i + 1].command : -1;
    bool sums = false, sources = false;
    for (int k = 0; k < i; k++) {
        sums = sums || is_color_sum(s, k, CMD_Enable);
        sources = sources || is_fog_source(s, k);
    }
    return before == CMD_End && attribute_of(after) == 2 &&
           (!sums || is_color_sum(s, i + 2, CMD_Enable) || is_color_sum(s, i + 2, CMD_Disable)) &&
           (!sources || is_fog_source(s, i + 2) || is_fog_source(s, i + 3));
}

/* Neither GL_COLOR_SUM nor GL_SEPARATE_SPECULAR_COLOR was the last of its kind before command i. */
static bool adds_no_secondary_color(const struct script *s, int i)
{
    bool sum = false, separate = false;
    for (int k = 0; k < i; k++) {
        const double *value = s->value + s->op[k].first;
        if (is_color_sum(s, k, CMD_Enable) || is_color_sum(s, k, CMD_Disable))
            sum = s->op[k].command == CMD_Enable;
        if (s->op[k].command == CMD_LightModeli && value[0] == GL_LIGHT_MODEL_COLOR_CONTROL)
            separate = value[1] == GL_SEPARATE_SPECULAR_COLOR;
    }
    return !sum && !separate;
}

/* A command outside Begin and End that may not stand there: in a list an attribute, elsewhere a call of a list without a query before. */
static bool fair_outside(const struct script *s, int i, bool in_list)
{
    const int command = s->op[i].command;
    if (in_list)
        return attribute_of(command) == 0 || attribute_of(command) == 16;
    return (command != CMD_CallList && command != CMD_CallLists) || (i > 0 && s->op[i - 1].command == CMD_GetFloatv);
}

static double last_render_mode(const struct script *s, int i)
{
    do
        i--;
    while (i >= 0 && s->op[i].command != CMD_RenderMode);
    return i < 0 ? GL_RENDER : s->value[s->op[i].first];
}

/* A buffer of feedback or selection is given just before it is used, and a point is drawn just after feedback. */
static bool fair_render_mode(const struct script *s, int i)
{
    const double mode = s->value[s->op[i].first];
    const int before = i > 0 ? s->op[i - 1].command : -1;
    if (mode == GL_RENDER && last_render_mode(s, i) == GL_FEEDBACK)
        return i + 3 < s->ops && s->op[i + 1].command == CMD_Begin && s->op[i + 3].command == CMD_End;
    return mode == GL_RENDER || before == (mode == GL_SELECT ? CMD_SelectBuffer : CMD_FeedbackBuffer);
}

/* A command that uses what another one must have given before. */
static bool fair_order(const struct script *s, int i)
{
    const int command = s->op[i].command;
    int needed;
    switch (command) {
    case CMD_Accum: needed = CMD_Clear; break;
    case CMD_EvalMesh1: case CMD_EvalPoint1: needed = CMD_MapGrid1f; break;
    case CMD_EvalMesh2: case CMD_EvalPoint2: needed = CMD_MapGrid2f; break;
    default: return true;
    }
    for (int k = 0; k < i; k++) {
        if (s->op[k].command == needed && (needed != CMD_Clear || s->value[s->op[k].first] == GL_ACCUM_BUFFER_BIT))
            return true;
    }
    return false;
}

static bool clears_first(const struct script *s)
{
    for (int i = 0; i < s->ops; i++) {
        const int command = s->op[i].command;
        if (command == CMD_Clear)
            return s->value[s->op[i].first] == (GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        if (command != CMD_ClearColor && command != CMD_ClearDepth && command != CMD_ClearStencil)
            return false;
    }
    return false;
}

/* The window is drawn into at the end. */
static bool fair_framebuffers(const struct script *s)
{
    double bound = 0.0;
    for (int i = 0; i < s->ops; i++) {
        const double *v = s->value + s->op[i].first;
        if (s->op[i].command == CMD_BindFramebufferEXT && v[0] != GL_READ_FRAMEBUFFER)
            bound = v[1];
    }
    return bound == 0.0;
}

/* A pixel rectangle after a texture of a later unit was enabled. */
static bool fair_rectangles(const struct script *s)
{
    double unit = GL_TEXTURE0;
    bool later = false;
    for (int i = 0; i < s->ops; i++) {
        const int command = s->op[i].command;
        const double *v = s->value + s->op[i].first;
        if (command == CMD_ActiveTexture)
            unit = v[0];
        later = later || (command == CMD_Enable && unit != GL_TEXTURE0 &&
                          (v[0] == GL_TEXTURE_1D || v[0] == GL_TEXTURE_2D || v[0] == GL_TEXTURE_3D || v[0] == GL_TEXTURE_CUBE_MAP));
        if (later && ((command == CMD_DrawPixels && v[2] != GL_STENCIL_INDEX) || command == CMD_DrawPixelsOffset))
            return false;
    }
    return true;
}

static bool draws_arrays(int command)
{
    return command == CMD_DrawArrays || command == CMD_DrawElements || (command >= CMD_DrawRangeElements && command <= CMD_MultiDrawElements) ||
           (command >= CMD_DrawElementsOffset && command <= CMD_MultiDrawElementsOffset);
}

/* Something drawn between the last return and the end. */
static bool fair_returns(const struct script *s)
{
    int last = s->ops - 1;
    while (last >= 0 && s->op[last].command != CMD_Accum)
        last--;
    for (int i = last + 1; i < s->ops && last >= 0; i++) {
        if (s->op[i].command == CMD_End)
            return true;
    }
    return last < 0;
}

/* ---- the walk ---- */

struct walk {
    struct primitive p;
    bool in_list, executed, arrays, pointer, saved_pointer; /* arrays: the vertex array is enabled; pointer: and was given */
    int pushed;
    struct fair_buffers buffers;
};

static void follow_arrays(struct walk *w, const struct script *s, int i)
{
    const int command = s->op[i].command;
    const bool interleaved = command == CMD_InterleavedArrays, state = command == CMD_EnableClientState || command == CMD_DisableClientState;
    if (interleaved || (state && s->value[s->op[i].first] == GL_VERTEX_ARRAY))
        w->arrays = command != CMD_DisableClientState;
    if (command == CMD_PushClientAttrib)
        w->saved_pointer = w->pointer;
    else if (command == CMD_PopClientAttrib)
        w->pointer = w->saved_pointer;
    w->pointer = w->pointer || interleaved || command == CMD_VertexPointer || command == CMD_VertexPointerOffset;
}

static void follow_list(struct walk *w, const struct script *s, int i)
{
    const int command = s->op[i].command;
    if (command == CMD_NewList)
        w->executed = s->value[s->op[i].first + 1] == GL_COMPILE_AND_EXECUTE;
    if (command == CMD_NewList || command == CMD_EndList)
        w->in_list = command == CMD_NewList;
}

static unsigned follow_primitive(struct walk *w, const struct script *s, int i)
{
    const int command = s->op[i].command;
    if (command == CMD_Begin) {
        const int mode = (int)s->value[s->op[i].first];
        const bool steady = w->in_list || mode == GL_LINE_LOOP || mode == GL_LINE_STRIP;
        w->p = (struct primitive){true, steady, w->in_list, true, mode, 0, 0};
        return 0;
    }
    if (command == CMD_End) {
        w->p.open = false;
        return fair_end(&w->p) && !(w->in_list && attribute_of(s->op[i - 1].command)) ? 0 : UNFAIR_PRIMITIVE;
    }
    if (w->p.open)
        return fair_inside(&w->p, command) && !(w->in_list && w->executed && attribute_of(command)) ? 0 : UNFAIR_ATTRIBUTE;
    return fair_outside(s, i, w->in_list) ? 0 : w->in_list ? UNFAIR_ATTRIBUTE : UNFAIR_CALL;
}

static unsigned follow(struct walk *w, const struct script *s, int i)
{
    const int command = s->op[i].command;
    unsigned unfair = 0;
    w->pushed += (command == CMD_PushAttrib) - (command == CMD_PopAttrib);
    if (w->pushed > 1 || w->pushed < 0 || (command == CMD_PopAttrib && !fair_pop(s, i)))
        unfair |= UNFAIR_STACK;
    follow_list(w, s, i);
    follow_arrays(w, s, i);
    if (draws_arrays(command) && !(w->arrays && w->pointer))
        unfair |= UNFAIR_ARRAYS;
    if (!fair_buffers_follow(&w->buffers, s, i))
        unfair |= UNFAIR_BUFFERS;
    if (!fair_order(s, i) || (command == CMD_RenderMode && !fair_render_mode(s, i)))
        unfair |= UNFAIR_ORDER;
    if ((command == CMD_Bitmap || command == CMD_BitmapOffset) && !adds_no_secondary_color(s, i))
        unfair |= UNFAIR_PIXELS;
    return unfair | follow_primitive(w, s, i);
}

unsigned script_unfair(const struct script *s)
{
    struct walk w = {.pushed = 0};
    unsigned unfair = (clears_first(s) && fair_returns(s) ? 0 : UNFAIR_CLEARS) | (fair_rectangles(s) ? 0 : UNFAIR_PIXELS) |
                      (fair_framebuffers(s) ? 0 : UNFAIR_FRAMEBUFFER);
    for (int i = 0; i < s->ops; i++)
        unfair |= follow(&w, s, i);
    return unfair;
}
