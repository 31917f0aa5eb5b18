/* The fragment stage (GL 1.5, 3.8-3.11 and 4.1): interpolate, texture, secondary colour, fog, tests, blend,
 * write. Layer 3.
 *
 * Validation fills a fragment_plan from state: only the stages that the state requires. The rasterizer then
 * hands over horizontal runs of covered pixels with the planes of their primitive. */
#ifndef FGL_FRAGMENT_FRAGMENT_H
#define FGL_FRAGMENT_FRAGMENT_H

#include "base/cpu.h"
#include "base/fgl.h"
#include "base/lit_fragments.h"
#include "fragment/texture.h"
#include "framebuffer/framebuffer.h"
#include "state/context.h"

/* The lanes of a raster vertex (raster/raster.h) and of a primitive's planes. */
enum {
    LANE_X,
    LANE_Y,
    LANE_Z,
    LANE_OOW,
    LANE_COLOR = 4,     /* r g b a; colour index mode: the index */
    LANE_SECONDARY = 8, /* r g b */
    LANE_FOG = 11,      /* |z_eye| or the fog coordinate */
    LANE_TEX0 = 12,     /* s t r q of the units whose coordinates are interpolated, one after the other; here, or earlier where
                           the lanes before are not needed: struct texture_stage */
    /* behind them, in groups of four: what lighting per fragment reads: struct lit_lanes */
    LANE_SMOOTH = LANE_TEX0 + 4 * FGL_MAX_TEXTURE_UNITS + 4 * (2 + LIT_ATTRIBUTES), /* enum smoothing: made by the rasterizer, not in vertices */
    LANE_MAX = LANE_SMOOTH + 4,
    LANE_GROUP = 4 /* planes are set up in whole groups of lanes */
};

enum color_source {
    COLOR_CONSTANT, /* the current colour: one value for the draw */
    COLOR_FLAT,     /* the provoking vertex's */
    COLOR_SMOOTH,   /* interpolated with perspective */
    COLOR_IMAGE,    /* pixel rectangles: struct pixel_inputs */
    COLOR_LIT,      /* lit at each fragment: struct lit_lanes */
    COLOR_SOURCES
};

/* Antialiasing (GL 1.5, 3.3.2 and 3.4.3): what LANE_SMOOTH holds. */
enum smoothing {
    SMOOTH_NONE,
    SMOOTH_LINE, /* across, half width, along, half length: pixels from the line's centre */
    SMOOTH_POINT, /* x, y from the centre in radii, inner radius squared, 1 */
    SMOOTH_WHOLE  /* nothing: polygons in colour index mode, whose fragments are all completely covered */
};

/* Attribute planes of one primitive: the value at integer pixel (X, Y), column and row, is fma(dady, Y, fma(dadx, X,
 * a00)). Smooth attributes other than z and 1/w hold attribute/w and are divided by the plane of 1/w. Flat
 * colours have their value in a00 and zero gradients, and are not divided. */
struct planes {
    union {
        struct {
            float a00[LANE_MAX], dadx[LANE_MAX], dady[LANE_MAX];
            float z_offset; /* polygon offset, added to z before it is clamped */
        };
        struct exact_planes { /* in their place in FIXEDGL_EXACT */
            double a00[LANE_MAX], dadx[LANE_MAX], dady[LANE_MAX];
            double z_offset;
        } exact;
    };
    enum smoothing smoothing;
    const struct polygon_stipple_state *stipple; /* NULL: none */
};

/* A value that is the same all over the primitive. */
static inline void fgl_plane_set(struct planes *p, enum fgl_arith arith, int lane, double value)
{
    if (arith == ARITH_EXACT) {
        p->exact.a00[lane] = value;
        p->exact.dadx[lane] = p->exact.dady[lane] = 0;
    } else {
        p->a00[lane] = (float)value;
        p->dadx[lane] = p->dady[lane] = 0;
    }
}

/* GL_WIN_phong_shading: where the planes have what is lit, and who lights it. */
struct lit_lanes {
    int normal;     /* x y z; the fourth lane is above 0 for back faces, else 0 */
    int eye;        /* x y z; 0: not read */
    int attributes, attribute; /* how many; lane of the first one's r g b a */
    light_fragments_fn *light;
    const void *lights;
};

/* Covered pixels of consecutive rows, all inside the buffer: row y + i has the pixels x0[i] <= x < x1[i], or
 * none. */
enum { RUNS_MAX = 64 };
struct runs {
    int y, n;
    int32_t x0[RUNS_MAX], x1[RUNS_MAX];
};

/* Pixel rectangles (GL 1.5, 3.6.4): what comes from the image instead of from planes. Arrays by window x, as
 * long as a row of the framebuffer with its padding; NULL: as for other primitives. */
struct pixel_inputs {
    const uint32_t *unorm8; /* colours as a buffer of COLOR_UNORM8 has them, or */
    const float *color[4]; /* as floats; colour index mode: the first alone */
    const float *depth;    /* [0,1] */
};

/* Draws the covered pixels of one primitive. */
struct fragment_plan;
typedef void fragment_fill_fn(const struct fragment_plan *plan, const struct planes *planes,
                              const struct runs *runs);

/* Draws pixels of small triangles (fragment/planes.h), one after the other. */
struct scattered;
typedef void fragment_scatter_fn(const struct fragment_plan *plan, const struct scattered *pixels);

enum depth_kind { DEPTH_OFF, DEPTH_LESS, DEPTH_LEQUAL, DEPTH_KINDS };

/* The kernels of one instruction set (kernels.c). Every set gives the same bytes. */
struct fragment_kernels {
    /* COLOR_UNORM8 with all channels written; depth written where it is tested; no other stage, no smoothing,
     * no stipple */
    fragment_fill_fn *fused[DEPTH_KINDS][COLOR_SOURCES];
    fragment_fill_fn *staged[DEPTH_KINDS]; /* the same with any source and stages of colours: textures, colour sum, fog */
    fragment_scatter_fn *scatter[DEPTH_KINDS][COLOR_SOURCES]; /* the same; NULL where no triangle has such a colour */
    fragment_fill_fn *general; /* everything that a plan and planes can ask for */
    /* for explain: stage number `stage` at a pixel */
    void (*trace_texture)(const struct fragment_plan *plan, const struct planes *planes, int stage, int row, int x,
                          struct texture_trace *to);
    fragment_fill_fn *index;   /* the same in colour index mode: COLOR_INDEX8 */
};

struct fragment_plan {
    enum fgl_arith arith;
    fragment_fill_fn *fill;    /* a fused kernel where there is one for these stages, else the general one */
    fragment_fill_fn *general; /* for planes with smoothing or stipple */
    fragment_scatter_fn *scatter; /* does what a fused `fill` does; else NULL */

    enum color_source color_source;
    float constant_color[4];
    bool primary_interpolated; /* OSMesa rule: a constant colour is interpolated where combiners name GL_PRIMARY_COLOR, but not as GL_PREVIOUS */
    struct lit_lanes lit; /* for COLOR_LIT; set by the caller of fgl_fragment_validate */
    bool has_secondary; /* separate specular or colour sum, */
    enum color_source secondary_source; /* from LANE_SECONDARY, lit, or */
    bool flat_sum; /* OSMesa rule: flat for the sake of a secondary color that lighting does not give, but GL_COLOR_SUM asks for */
    float constant_secondary[3];
    bool keeps_color; /* colours are wanted, even if fragments do not use them: feedback */
    uint32_t texture_varying; /* bit: a unit whose texture coordinates differ by fragment */
    bool has_fog;
    GLenum fog_mode;
    float fog_index; /* colour index mode */
    struct fog_numbers { /* linear f = z*p+q, exp k = density*log2 e, exp2 k' = density*sqrt(log2 e) */
        float p, q, k;
    } fog;
    struct exact_fog_numbers {
        double p, q, k;
    } exact_fog;
    float fog_color[4];

    bool alpha_test, depth_test, depth_write, stencil_test, blend, logic_op, color_write;
    bool blend_lerp; /* OSMesa rule for images of one component: products are not rounded one by one */
    bool channel_write[4];
    uint32_t write_bits; /* the same for COLOR_UNORM8: bits of a pixel */
    struct color_buffer_state color_buffer;
    struct stencil_state stencil;
    GLenum depth_func;
    int textures; /* stages: units that draw a texture */
    bool texture_products; /* fgl_texture_products of them, and not general */
    atomic_ullong *samples_passed; /* occlusion query: counts fragments that pass all tests; NULL: none runs. Set by the
                                      caller of fgl_fragment_validate */
    const struct pixel_inputs *pixels; /* NULL but for pixel rectangles; not NULL for COLOR_IMAGE */

    int lanes; /* lanes of a raster vertex that this plan reads, a multiple of LANE_GROUP */
    struct framebuffer *fb;
    struct texture_stage texture[FGL_MAX_TEXTURE_UNITS]; /* the first `textures` of them; last, being large */
};

/* Fills *plan from state, but arith, color_source, constant_color, the secondary colour's, keeps_color and texture_varying: these depend on the
 * vertex stage, and the caller has set them before, and primary_interpolated where that may be. general: nothing specialised (FIXEDGL_PATH=general). */
void fgl_fragment_validate(struct fragment_plan *plan, const struct server_state *s, struct framebuffer *fb,
                           bool general);

/* The kernels of the processor's best instruction set, and of any that fgl_cpu_has. */
const struct fragment_kernels *fgl_fragment_kernels(enum fgl_arith arith);
const struct fragment_kernels *fgl_fragment_kernels_of(enum fgl_isa isa, enum fgl_arith arith);

#endif
