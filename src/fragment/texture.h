/* What the fragment stage must know of textures (GL 1.5, 3.8): for each unit that is enabled and complete a sampler, derived from its
 * texture object, and an environment. Made by validation; the kernels read nothing else. Layer 3. */
#ifndef FGL_FRAGMENT_TEXTURE_H
#define FGL_FRAGMENT_TEXTURE_H

#include "texture/texture.h"

enum texture_filter { FILTER_NEAREST, FILTER_LINEAR };
enum mip_filter { MIP_NONE, MIP_NEAREST, MIP_LINEAR };

struct texture_level {
    int size[3]; /* width, height, depth; 1 where the target has fewer dimensions */
    float scale[3]; /* from coordinates to texels: the size, but 1 for rectangles */
    const void *texels[TEXTURE_MAX_FACES];
};

/* Constants in place of a component (GL_EXT_texture_swizzle). */
enum { SWIZZLE_ZERO = 4, SWIZZLE_ONE };

struct sampler {
    enum texture_target target;
    enum texel_kind kind;
    int dimensions;    /* of an image: 1 to 3 */
    GLenum wrap[3];
    bool fixed_point;  /* OSMesa rule: texels of 8 bits whose wrap modes need no border are filtered in integers */
    enum texture_filter min, mag;
    enum mip_filter mip;
    bool needs_lod;    /* the level, or min in place of mag, is chosen by the scale factor rho */
    bool adjusts_lod;  /* it is biased or clamped before it is used */
    float lod_bias, min_lod, max_lod;
    float magnify_below; /* level of detail up to which mag is used (GL 1.5, 3.8.8: c) */
    GLenum compare_func; /* depth textures; 0: not compared */
    GLenum depth_mode;
    bool swizzled;
    uint8_t swizzle[4]; /* the component that each is made of, SWIZZLE_ZERO or SWIZZLE_ONE */
    int depth_bits;
    int shift[4]; /* TEXELS_UNORM8: how many bits less than 8 the format stores of each component */
    float border[4];   /* as a texel */
    int last_level;    /* level[0] is the base level */
    struct texture_level level[FGL_MAX_TEXTURE_LEVELS];
};

/* A function of GL_COMBINE, for RGB or for alpha; the other environment modes are derived from it. */
/* How the arguments are put together (texture_combine.c). */
enum combine_form {
    COMBINE_AS_WRITTEN,
    COMBINE_SECOND_FIRST, /* GL_ADD_SIGNED: 1/2 is subtracted from argument 1 */
    COMBINE_FIRST_ALONE,  /* GL_INTERPOLATE: argument 0 */
    COMBINE_BY_FIRST,     /* GL_INTERPOLATE: argument 0, which is also 1 less the weight, times the sum of the others */
    COMBINE_BY_SECOND     /* GL_INTERPOLATE: argument 1, which is also the weight, times the sum of the others */
};

struct combine {
    GLenum function, source[3], operand[3];
    float scale;
    enum combine_form form;
};

struct texture_environment {
    struct combine rgb, alpha;
    bool clamped; /* GL 1.5, 3.8.13: where the result may leave [0,1] */
    bool product; /* all that the functions of RGB [0] and alpha [1] do: the texel, times what was before, or one of them */
    bool by_texel[2], by_previous[2];
    float color[4];
    GLenum mode; /* as given, for explain */
};

/* Where a unit's coordinates come from. */
enum coordinate_source {
    COORDINATES_CONSTANT, /* the current ones: the same for the draw */
    COORDINATES_PLANES    /* interpolated: lanes of the planes */
};

struct texture_stage {
    int unit;
    enum coordinate_source source;
    float constant[4]; /* s t r q */
    int lane;          /* of s; t r q follow */
    bool across_sprite; /* GL_ARB_point_sprite: points have in these lanes where the fragment is in the point */
    struct sampler sampler;
    struct texture_environment environment;
};

/* What a stage made of one fragment, for explain. */
struct texture_trace {
    double coordinate[3]; /* s t r, divided by q */
    bool magnified;       /* the magnification filter was used, or the only one there is */
    int level;            /* counted from the base level; mixed with the next by fraction */
    double fraction;
    double texel[4];
};

struct server_state;

/* The stages of the units that are enabled and have a complete texture, in order; returns how many. Of the units in `varying` (bit: unit) the
 * coordinates are interpolated, in lanes counted from 0; the others' are constant. */
int fgl_texture_stages(struct texture_stage stage[FGL_MAX_TEXTURE_UNITS], const struct server_state *s,
                       uint32_t varying);

/* Sets the forms of the stages' combiners, each of which depends on the stages before. */
void fgl_texture_arrange(struct texture_stage *stage, int n);

/* Whether all stages are products of texels that are filtered in fixed point. */
bool fgl_texture_products(const struct texture_stage *stage, int n);

/* Whether the colour that comes out of the stages depends on the one that went in. */
bool fgl_texture_reads_primary(const struct texture_stage *stage, int n);

/* Whether a combiner names GL_PRIMARY_COLOR. */
bool fgl_texture_names_primary(const struct texture_stage *stage, int n);

#endif
