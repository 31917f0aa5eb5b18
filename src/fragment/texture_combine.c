/* How OSMesa's compiler rearranges the functions of combiners (GL 1.5, table 3.24). What they give is the same but for the last bit. */
#include "fragment/texture.h"

/* What is a product as it leaves a stage, RGB and alpha: there OSMesa adds the 1/2 of GL_ADD_SIGNED elsewhere. */
struct products {
    bool of[2];
};

static bool complements(GLenum operand)
{
    return operand == GL_ONE_MINUS_SRC_COLOR || operand == GL_ONE_MINUS_SRC_ALPHA;
}

static bool takes_alpha(GLenum operand)
{
    return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
}

/* A source by one name: the first stage's previous color is the primary one, a unit's own texture is GL_TEXTURE. */
static GLenum source_of(const struct combine *combine, int k, int stage, int unit)
{
    const GLenum source = combine->source[k];
    if (source == GL_PREVIOUS && stage == 0)
        return GL_PRIMARY_COLOR;
    return source == GL_TEXTURE0 + (GLenum)unit ? GL_TEXTURE : source;
}

static bool same_argument(const struct combine *combine, int i, int k, int stage, int unit)
{
    return source_of(combine, i, stage, unit) == source_of(combine, k, stage, unit) &&
           takes_alpha(combine->operand[i]) == takes_alpha(combine->operand[k]);
}

/* Argument k is a product. */
static bool is_product(const struct combine *combine, int k, int where, const struct products *before)
{
    const GLenum operand = combine->operand[k];
    return combine->source[k] == GL_PREVIOUS && !complements(operand) && before->of[where || takes_alpha(operand)];
}

/* OSMesa rules: x mixed with x is x; a factor that both terms of a mixture share is drawn out of them; and -1/2 is added to argument 1 where
 * argument 0 alone is a product. */
static enum combine_form form_of(const struct combine *combine, int where, const struct products *before, int stage, int unit)
{
    const GLenum *operand = combine->operand;
    if (combine->function == GL_ADD_SIGNED)
        return is_product(combine, 0, where, before) && !is_product(combine, 1, where, before) ? COMBINE_SECOND_FIRST : COMBINE_AS_WRITTEN;
    if (combine->function != GL_INTERPOLATE)
        return COMBINE_AS_WRITTEN;
    if (same_argument(combine, 0, 1, stage, unit) && operand[0] == operand[1])
        return COMBINE_FIRST_ALONE;
    if (same_argument(combine, 0, 2, stage, unit) && operand[0] != operand[2])
        return COMBINE_BY_FIRST;
    if (same_argument(combine, 1, 2, stage, unit) && operand[1] == operand[2])
        return COMBINE_BY_SECOND;
    return COMBINE_AS_WRITTEN;
}

static bool gives_product(const struct combine *combine, int where, const struct products *before)
{
    switch (combine->function) {
    case GL_MODULATE: return true;
    case GL_INTERPOLATE:
        return combine->form == COMBINE_BY_FIRST || combine->form == COMBINE_BY_SECOND ||
               (combine->form == COMBINE_FIRST_ALONE && is_product(combine, 0, where, before));
    case GL_REPLACE: return is_product(combine, 0, where, before);
    default: return false;
    }
}

void fgl_texture_arrange(struct texture_stage *stage, int n)
{
    struct products before = {{false, false}};
    for (int i = 0; i < n; i++) {
        struct texture_environment *e = &stage[i].environment;
        struct combine *const combine[2] = {&e->rgb, &e->alpha};
        struct products after;
        for (int where = 0; where < 2; where++) {
            combine[where]->form = form_of(combine[where], where, &before, i, stage[i].unit);
            after.of[where] = !e->clamped && gives_product(combine[where], where, &before);
        }
        before = after;
    }
}
