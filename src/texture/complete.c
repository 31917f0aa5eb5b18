/* GL 1.5, 3.8.10 "Texture Completeness". */
#include "texture/texture.h"

static bool mipmaps(const struct texture_parameters *p)
{
    return p->min_filter != GL_NEAREST && p->min_filter != GL_LINEAR;
}

/* floor(log2) of the largest dimension of the base level. */
static int levels_above(const struct texture_image *base)
{
    int size = fgl_max(fgl_max(base->width, base->height), base->depth), levels = 0;
    while (size >>= 1)
        levels++;
    return levels;
}

int fgl_texture_last_level(const struct texture_object *object)
{
    const int base = fgl_texture_base_level(object);
    return fgl_min(fgl_min(base + levels_above(&object->image[0][base]), fgl_texture_max_level(object)),
                   FGL_MAX_TEXTURE_LEVELS - 1);
}

static bool same(const struct texture_image *a, const struct texture_image *b, int width, int height, int depth)
{
    return b->texels && b->width == width && b->height == height && b->depth == depth &&
           b->internal_format == a->internal_format;
}

/* All levels that mipmapping needs, of one face. */
static bool face_complete(const struct texture_object *object, int face, bool mipmapped)
{
    const int first = fgl_texture_base_level(object);
    const int last = mipmapped ? fgl_texture_last_level(object) : first;
    const struct texture_image *base = &object->image[0][first];
    for (int level = first; level <= last; level++) {
        const int shift = level - first;
        if (!same(base, &object->image[face][level], fgl_max(base->width >> shift, 1),
                  fgl_max(base->height >> shift, 1), fgl_max(base->depth >> shift, 1)))
            return false;
    }
    return true;
}

static bool find_complete(const struct texture_object *object, bool mipmapped)
{
    const int first = fgl_texture_base_level(object);
    if (first >= FGL_MAX_TEXTURE_LEVELS || !object->image[0][first].texels)
        return false;
    if (mipmapped && first > fgl_texture_max_level(object))
        return false;
    const struct texture_image *base = &object->image[0][first];
    if (object->target == TEXTURE_CUBE_MAP && base->width != base->height)
        return false;
    for (int face = 0; face < fgl_texture_faces(object->target); face++)
        if (!face_complete(object, face, mipmapped))
            return false;
    return true;
}

bool fgl_texture_complete(struct texture_object *object, bool mipmapped)
{
    if (!object->complete_known[mipmapped]) {
        object->complete[mipmapped] = find_complete(object, mipmapped);
        object->complete_known[mipmapped] = true;
    }
    return object->complete[mipmapped];
}

/* A sampler object may ask of a rectangle texture what the texture may not: to be repeated, or mipmapped. Nothing is drawn then. */
static bool suits_rectangles(const struct texture_parameters *p)
{
    for (int i = 0; i < 2; i++)
        if (p->wrap[i] == GL_REPEAT || p->wrap[i] == GL_MIRRORED_REPEAT)
            return false;
    return !mipmaps(p);
}

static bool can_draw(const struct texture_unit *unit, struct texture_object *object)
{
    const struct texture_parameters *p = fgl_texture_sampling(unit, object);
    const bool suits = !unit->sampler || object->target != TEXTURE_RECTANGLE || suits_rectangles(p);
    return suits && fgl_texture_complete(object, mipmaps(p));
}

struct texture_object *fgl_texture_current(const struct texture_unit *unit)
{
    for (int t = TEXTURE_TARGETS - 1; t >= 0; t--)
        if ((unit->enabled >> t & 1) && can_draw(unit, unit->bound[t]))
            return unit->bound[t];
    return NULL;
}
