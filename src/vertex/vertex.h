/* The vertex stage (GL 1.5, 2.11 "Coordinate Transformations", 2.12 "Clipping", 2.14 "Colors and Coloring").
 * Layer 3.
 *
 * Validation derives a vertex_plan: small constants, made once, that the kernels read instead of state. The
 * kernels run over a batch (base/batch.h), stage by stage, and only the stages that the plan needs. */
#ifndef FGL_VERTEX_VERTEX_H
#define FGL_VERTEX_VERTEX_H

#include "base/batch.h"
#include "base/cpu.h"
#include "base/lit_fragments.h"
#include "state/context.h"
#include "vertex/cone.h"
#include "vertex/emit.h"

enum normal_scaling { NORMAL_AS_IS, NORMAL_RESCALE, NORMAL_NORMALIZE };

/* What one light's kernel must compute: the index of its instance. */
enum light_key {
    LIGHT_POSITIONAL = 1 << 0,
    LIGHT_ATTENUATED = 1 << 1, /* by distance; only with LIGHT_POSITIONAL */
    LIGHT_SPOT = 1 << 2,
    LIGHT_SPECULAR = 1 << 3, /* the specular product is not zero */
    LIGHT_LOCAL_VIEWER =
            1 << 4,          /* only with LIGHT_SPECULAR, like the two below; not with LIGHT_ZERO_SHININESS */
    LIGHT_SEPARATE = 1 << 5, /* specular goes to the secondary colour */
    LIGHT_ZERO_SHININESS = 1 << 6, /* of every face: OSMesa takes another path then */
    LIGHT_VARYING = 1 << 7,        /* the material differs by vertex */
    LIGHT_REFLECTION = 1 << 8,     /* only with LIGHT_SPECULAR: the highlight is where the reflection vector meets the viewer */
    LIGHT_KEY_COUNT = 1 << 9
};

enum { COLOR_AMBIENT, COLOR_DIFFUSE, COLOR_SPECULAR, COLOR_COUNT }; /* in the order of MAT_AMBIENT.. */

/* One enabled light, with everything that does not differ by vertex. Directions are in the space of
 * lighting_plan.object_space. */
struct light_derived {
    int number;              /* GL_LIGHTi */
    unsigned key;            /* LIGHT_* */
    float position[3];       /* positional: eye space, divided by w */
    float direction[3];      /* directional: unit vector towards the light */
    float half[3];           /* directional, infinite viewer: unit half vector */
    float spot_direction[3]; /* unit */
    float spot_exponent, cos_cutoff;
    float k0, k1, k2;                 /* constant, linear, quadratic attenuation */
    float color[COLOR_COUNT][3];      /* the light's own */
    float product[2][COLOR_COUNT][3]; /* [face]: colour x material, when the material is constant */
};

struct lighting_plan {
    int n;
    struct light_derived light[FGL_MAX_LIGHTS]; /* those that can add anything, in index order */
    bool two_sided, local_viewer, separate_specular, object_space;
    bool specular_vector;     /* GL_APPLE_specular_vector */
    bool shininess_all_zero;  /* OSMesa takes another specular path then */
    bool varying;             /* some material parameter differs by vertex */
    int attributes, attribute[LIT_ATTRIBUTES]; /* those that give any, each once */
    int source[MAT_COUNT][2]; /* [parameter][face]: the attribute of the batch that gives it, or -1: the
                                 constant below */
    float material[MAT_COUNT][2]
                  [4]; /* constant materials; the current colour where glColorMaterial says so */
    float model_ambient[4];
    float base[2][4];        /* emission + model ambient x material ambient; alpha = diffuse alpha */
    float shininess[2];      /* clamped to +-128 */
    float view_direction[3]; /* infinite viewer's, in the lighting space: object space's (m02, m12, m22), eye
                                space's (0,0,1) */
};

/* The numbers of a light in double, with the names of those of struct light_derived. Eye space always. */
struct exact_light {
    double position[3], direction[3], half[3], spot_direction[3];
    double axis[3]; /* spot_direction as it was given */
    double spot_exponent;
    struct pair cos_square; /* of the cutoff */
    double k0, k1, k2;
    double color[COLOR_COUNT][3], product[2][COLOR_COUNT][3];
};

/* The coordinates of one texture that differ by vertex (GL 1.5, 2.11.4). The numbers are in float or double by mode. */
struct vertex_texture {
    int unit;
    bool computed;     /* else they are given, and the batch's `in` is what is handed over */
    GLenum gen[4];     /* how each coordinate is generated; GL_NONE: given */
    bool transformed;  /* by the texture matrix */
    struct texture_numbers {
        float plane[4][4], matrix[16];
    } numbers;
};
struct exact_texture {
    double plane[4][4], matrix[16];
};

/* What the kernels of FIXEDGL_EXACT read in place of the floats: made of the state's doubles. In FIXEDGL_COMPATIBLE,
 * where they light the vertices that float cannot, it is made of the state's floats. */
struct exact_plan {
    double mvp[16], modelview[16];
    double viewport_scale[3], viewport_trans[3];
    double user_plane[FGL_MAX_CLIP_PLANES][4]; /* in eye space */
    double normal_matrix[3][3], rescale_factor;
    enum normal_scaling normal_scaling;
    bool needed; /* FIXEDGL_COMPATIBLE: no vertex can be lit in float */
    double base[2][3];
    struct exact_light light[FGL_MAX_LIGHTS]; /* as lighting_plan.light */
    struct exact_texture texture[FGL_MAX_TEXTURE_UNITS]; /* as vertex_plan.texture */
};

struct vertex_plan {
    enum fgl_arith arith;
    struct exact_plan exact;
    float mvp[16], modelview[16];
    float viewport_scale[3], viewport_trans[3];    /* window = fma(clip / w, scale, trans); y along the framebuffer's rows */
    unsigned user_planes;                          /* bit i: enabled */
    float user_plane[FGL_MAX_CLIP_PLANES][4];      /* in clip space */

    bool lighting;
    bool light_fragments; /* GL_PHONG_WIN: not colours, but what lighting reads is handed over */
    bool need_eye;    /* lighting reads eye positions: local lights or viewer */
    bool need_view;   /* lighting reads the direction of the local viewer */
    bool need_normal; /* lighting reads normals */
    bool need_fog_z;     /* fog by distance */
    bool need_fog_coord; /* fog by the fog coordinate */
    bool need_point_size; /* attenuated by distance */
    enum normal_scaling normal_scaling;
    bool normal_in_eye_space; /* else object space: normal_matrix is not used */
    float rescale_factor;
    float normal_matrix[3][3]; /* n'_r = n . normal_matrix[r]: the columns of the inverse modelview */
    struct lighting_plan light;
    float point_size, point_size_min, point_size_max, point_attenuation[3];

    bool color_index;      /* colour index mode: color[face].c[0] are indexes */
    bool index_is_varying; /* the same as below, for indexes */
    int textures; /* whose coordinates differ by vertex, in the order of their units */
    struct vertex_texture texture[FGL_MAX_TEXTURE_UNITS];
    bool texgen_eye, texgen_normal; /* some texture reads eye positions, eye space normals */

    bool secondary_is_varying; /* without lighting: colour sum with secondary colours from the batch */
    bool color_is_varying; /* without lighting: colours come from the batch, else constant (not computed) */
    bool color_is_spread; /* constant, but wanted for each vertex. Set after fgl_vertex_validate */
    uint32_t varying;      /* the attributes that differ by vertex */
    float constant[ATTR_MATERIAL][4]; /* current values of the others */
};

/* Brings the plan up to date with the state, for batches whose attributes in `varying` differ by vertex. Only
 * what ctx->dirty (and a changed `varying`) touches is derived anew: a plan must stay with its context and be
 * validated before those bits are cleared. Window y goes along the rows of fb. */
void fgl_vertex_validate(struct vertex_plan *plan, struct context *ctx, uint32_t varying,
                         const struct framebuffer *fb);

/* light.c: the part of validation that concerns lighting. */
void fgl_light_validate(struct vertex_plan *plan, struct context *ctx);

/* light.c: the normals' part alone, for textures of unlit vertices. */
void fgl_normals_validate(struct vertex_plan *plan, struct context *ctx);

/* texture_plan.c: the part that concerns texture coordinates; and whether any is generated in eye space. */
void fgl_texture_plan_validate(struct vertex_plan *plan, struct context *ctx, uint32_t varying);
bool fgl_texgen_in_eye_space(const struct server_state *s);

/* exact_plan.c: the same numbers in double, after fgl_light_validate. */
void fgl_exact_light_validate(struct vertex_plan *plan, struct context *ctx);

/* Runs the stages of the plan over the batch. general: without specialised kernels; the same bits. */
void fgl_vertex_run(const struct vertex_plan *plan, struct vertex_batch *batch, bool general);

/* The same in two steps: clip and window coordinates and outcodes, everything else. The second does not need the results of the
 * first. */
void fgl_vertex_positions(const struct vertex_plan *plan, struct vertex_batch *batch);
void fgl_vertex_shade(const struct vertex_plan *plan, struct vertex_batch *batch, bool general);

/* Results of FIXEDGL_EXACT rounded to the batch's floats, for those who look at a vertex or two. */
void fgl_vertex_round(const struct vertex_plan *plan, struct vertex_batch *batch);

/* What the lighting equation makes of one vertex: the kernels' own values, noted by fgl_vertex_trace and
 * never looked at by them. Vectors are in the lighting space. Terms that the plan leaves out are 0, or 1 for
 * attenuation and spot. */
struct light_terms {
    double VP[3], distance, attenuation, spot_cosine, spot; /* distance: positional lights */
    double n_dot_VP;
    double half[3], n_dot_h, shininess, highlight; /* highlight: f (n . h)^shininess. With LIGHT_REFLECTION half is
                                                      the reflection vector and n_dot_h its dot with the viewer's */
    double ambient[3], diffuse[3], specular[3];    /* what the light adds, attenuated */
};

struct face_trace {
    double base[3];                           /* emission and scene ambient */
    struct light_terms light[FGL_MAX_LIGHTS]; /* as lighting_plan.light */
    double sum[3], specular_sum[3];           /* before clamping; specular apart when separate */
};

struct vertex_trace {
    double eye[3], normal[3]; /* normal: in the lighting space, scaled; only when the plan needs normals */
    struct face_trace face[2];
};

/* Runs the stages of the plan over a batch of one vertex, with the general kernels, and notes their values.
 */
void fgl_vertex_trace(const struct vertex_plan *plan, struct vertex_batch *batch, struct vertex_trace *trace);

/* Lights fragments with the plan's lights (GL_WIN_phong_shading): a light_fragments_fn. The second form also notes the terms of the
 * first fragment. */
void fgl_vertex_light_fragments(const void *plan, struct lit_fragments *f);
void fgl_vertex_trace_fragment(const struct vertex_plan *plan, struct lit_fragments *f, struct face_trace *trace);

/* The kernels of one instruction set (kernels.c). first is a multiple of 16; n is at most VERTEX_CHUNK. */
enum { VERTEX_CHUNK = 256 };
struct vertex_kernels {
    const char *isa;
    /* run = positions and shade. run, shade, trace: true if batch->extreme is not 0 for a vertex. */
    void (*positions)(const struct vertex_plan *plan, struct vertex_batch *batch, int first, int n);
    bool (*shade)(const struct vertex_plan *plan, struct vertex_batch *batch, int first, int n, bool general);
    bool (*run)(const struct vertex_plan *plan, struct vertex_batch *batch, int first, int n, bool general);
    void (*light)(const struct vertex_plan *plan, struct vertex_batch *batch, int first, int n, bool general);
    /* trace may be NULL. Returns whether extreme is not 0 for a fragment */
    bool (*light_fragments)(const struct vertex_plan *plan, struct lit_fragments *f, struct face_trace *trace,
                            uint32_t extreme[LIT_GROUP]);
    bool (*trace)(const struct vertex_plan *plan, struct vertex_batch *batch, struct vertex_trace *trace);
    void (*emit)(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip);
    void (*emit_positions)(const struct emit_plan *plan, const struct vertex_batch *batch, void *record, void *clip);
    void (*emit_attributes)(const struct emit_plan *plan, const struct vertex_batch *batch, void *record);
};

/* The kernels that fgl_vertex_run uses for an arithmetic; and those of one set, or NULL when the build or the CPU does not
 * have it. */
const struct vertex_kernels *fgl_vertex_kernels(enum fgl_arith arith);
const struct vertex_kernels *fgl_vertex_kernels_of(enum fgl_isa isa, enum fgl_arith arith);

#endif
