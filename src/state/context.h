/* The context: all state of one OpenGL context, one struct for each state table of the specification (GL 1.5, 6.2
 * "State Tables"), fields named as the enum in lower case. Layer 1: plain data; knows no algorithm.
 *
 * Each `struct *_state` below that is an attribute group is saved and restored whole by glPushAttrib and glPopAttrib.
 * Derived values never live here: they belong to the plan (pipeline/plan.h). */
#ifndef FGL_STATE_CONTEXT_H
#define FGL_STATE_CONTEXT_H

#include "base/batch.h"
#include "base/cpu.h"
#include "base/fgl.h"
#include "base/limits.h"
#include "state/dirty.h"
#include "state/matrix.h"

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1 /* gl.h declares what came after OpenGL 1.3, too */
#endif
#include "GL/gl.h"

#include <stdatomic.h>

/* Table 6.5 "Current Values and Associated Data" (GL_CURRENT_BIT). */
struct current_state {
    float attr[ATTR_MATERIAL][4]; /* by enum fgl_attr; materials live in lighting_state */
    float raster_position[4];     /* window coordinates, y up */
    float raster_distance;
    float raster_color[4];
    float raster_secondary_color[4];
    float raster_index;
    float raster_texture_coords[FGL_MAX_TEXTURE_UNITS][4];
    bool raster_position_valid;
};

struct light {
    float ambient[4], diffuse[4], specular[4];
    float position[4];       /* eye space: transformed by the modelview matrix of glLight's call */
    float spot_direction[3]; /* eye space, as transformed, not normalised */
    double exact_position[4], exact_spot_direction[4]; /* the same, never rounded to float */
    float spot_exponent, spot_cutoff; /* degrees, 0..90 or 180 */
    float constant_attenuation, linear_attenuation, quadratic_attenuation;
    bool enabled;
    bool placed_under_identity; /* the modelview matrix was the identity when the position was given; for explain */
};

/* Tables 6.9, 6.10 "Lighting" (GL_LIGHTING_BIT). */
struct lighting_state {
    bool lighting, color_material;
    GLenum shade_model, color_material_face, color_material_parameter;
    GLenum light_model_color_control;
    float light_model_ambient[4];
    bool light_model_local_viewer, light_model_two_side, light_model_specular_vector;
    float material[MAT_COUNT][2][4]; /* [parameter][0 front, 1 back]; shininess in component 0, colour indexes in 0..2 */
    struct light light[FGL_MAX_LIGHTS];
};

/* Table 6.8 "Coloring" (GL_FOG_BIT). */
struct fog_state {
    bool fog, color_sum;
    GLenum fog_mode, fog_hint_unused, fog_coord_src;
    float fog_color[4], fog_index, fog_density, fog_start, fog_end;
};

/* Table 6.7 "Transformation state": GL_TRANSFORM_BIT and GL_VIEWPORT_BIT. */
struct transform_state {
    GLenum matrix_mode;
    bool normalize, rescale_normal;
    unsigned clip_plane_enabled;                       /* bit i: GL_CLIP_PLANEi */
    float clip_plane[FGL_MAX_CLIP_PLANES][4]; /* eye space */
    double exact_clip_plane[FGL_MAX_CLIP_PLANES][4]; /* the same, never rounded to float */
};

struct viewport_state {
    int viewport[4];
    float depth_range[2]; /* stored as OSMesa does: float, clamped to [0,1] */
};

/* Table 6.11 "Rasterization". */
struct point_state {
    bool point_smooth, point_sprite, coord_replace[FGL_MAX_TEXTURE_UNITS];
    float point_size, point_size_min, point_size_max, point_fade_threshold_size, point_distance_attenuation[3];
};

/* Table 6.13 "Multisampling" (GL_MULTISAMPLE_BIT): kept; there are no multisample buffers. */
struct multisample_state {
    bool multisample, sample_alpha_to_coverage, sample_alpha_to_one, sample_coverage, sample_coverage_invert;
    float sample_coverage_value;
};

struct line_state {
    bool line_smooth, line_stipple;
    float line_width;
    int line_stipple_repeat;
    uint16_t line_stipple_pattern;
};

struct polygon_state {
    bool cull_face, polygon_smooth, polygon_stipple;
    bool polygon_offset_point, polygon_offset_line, polygon_offset_fill;
    GLenum cull_face_mode, front_face, polygon_mode[2]; /* 0 front, 1 back */
    float polygon_offset_factor, polygon_offset_units;
};

struct polygon_stipple_state {
    uint32_t row[32]; /* row 0 is the bottom; bit 31 is the leftmost pixel */
};

/* Tables 6.19, 6.20 "Pixel Operations" and 6.21 "Framebuffer Control". */
struct scissor_state {
    bool scissor_test;
    int scissor_box[4];
};

struct depth_state { /* GL_DEPTH_BUFFER_BIT */
    bool depth_test, depth_writemask;
    GLenum depth_func;
    double depth_clear_value;
};

struct stencil_state { /* GL_STENCIL_BUFFER_BIT */
    bool stencil_test;
    GLenum stencil_func, stencil_fail, stencil_pass_depth_fail, stencil_pass_depth_pass;
    int stencil_ref, stencil_clear_value;
    unsigned stencil_value_mask, stencil_writemask;
};

struct color_buffer_state { /* GL_COLOR_BUFFER_BIT */
    bool alpha_test, blend, dither, index_logic_op, color_logic_op;
    GLenum alpha_test_func, blend_src_rgb, blend_dst_rgb, blend_src_alpha, blend_dst_alpha;
    GLenum blend_equation[2]; /* 0 of red, green and blue, 1 of alpha */
    GLenum logic_op_mode, draw_buffer;
    float alpha_test_ref, blend_color[4], color_clear_value[4], index_clear_value;
    bool color_writemask[4];
    unsigned index_writemask;
};

struct accum_state {
    float accum_clear_value[4];
};

struct hint_state {
    GLenum perspective_correction_hint, point_smooth_hint, line_smooth_hint, polygon_smooth_hint, fog_hint;
    GLenum generate_mipmap_hint, texture_compression_hint, phong_hint;
};

struct list_state {
    unsigned list_base;
};

/* Tables 6.23 and 6.24 "Pixels": what the imaging subset adds to the pixel modes. The tables, filters and counters are in
 * no attribute group: framebuffer/imaging.h. */
enum { COLOR_TABLE_FIRST, COLOR_TABLE_POST_CONVOLUTION, COLOR_TABLE_POST_COLOR_MATRIX, COLOR_TABLES };
enum { FILTER_1D, FILTER_2D, FILTER_SEPARABLE, FILTERS };

struct scale_bias {
    float scale[4], bias[4];
};

struct imaging_state {
    bool color_table[COLOR_TABLES], convolution[FILTERS], histogram, minmax; /* enabled */
    struct scale_bias color_table_transform[COLOR_TABLES], filter_transform[FILTERS]; /* of what is specified */
    GLenum border_mode[FILTERS];
    float border_color[FILTERS][4];
    struct scale_bias post_convolution, post_color_matrix;
};

struct pixel_mode_state { /* GL_PIXEL_MODE_BIT */
    bool map_color, map_stencil;
    int index_shift, index_offset;
    float scale[4], bias[4], depth_scale, depth_bias, zoom_x, zoom_y;
    GLenum read_buffer;
    struct imaging_state imaging;
};

/* Table 6.23 "Pixels": glPixelMap. In no attribute group. In the order of GL_PIXEL_MAP_I_TO_I... */
enum {
    PIXEL_MAP_I_TO_I, PIXEL_MAP_S_TO_S,
    PIXEL_MAP_I_TO_R, PIXEL_MAP_I_TO_G, PIXEL_MAP_I_TO_B, PIXEL_MAP_I_TO_A,
    PIXEL_MAP_R_TO_R, PIXEL_MAP_G_TO_G, PIXEL_MAP_B_TO_B, PIXEL_MAP_A_TO_A,
    PIXEL_MAP_COUNT
};

struct pixel_map {
    int size; /* a power of two for maps from indexes */
    float value[FGL_MAX_PIXEL_MAP];
};

/* Tables 6.14 to 6.17 "Textures" (GL_TEXTURE_BIT). Targets in order of precedence, lowest first (GL 1.5, 3.8.15
 * "Texture Application"). */
enum texture_target { TEXTURE_1D, TEXTURE_2D, TEXTURE_RECTANGLE, TEXTURE_3D, TEXTURE_CUBE_MAP, TEXTURE_TARGETS };

/* Of a texture object, by glTexParameter. wrap: s, t, r. */
struct texture_parameters {
    GLenum min_filter, mag_filter, wrap[3], compare_mode, compare_func, depth_mode;
    GLenum swizzle[4]; /* GL_EXT_texture_swizzle: what red, green, blue, alpha of a texel are made of */
    float border_color[4], priority, min_lod, max_lod, lod_bias;
    int base_level, max_level;
    bool generate_mipmap;
};

struct texgen {
    GLenum mode;
    float object_plane[4], eye_plane[4]; /* eye space: transformed by the inverse modelview matrix of glTexGen's call */
    double exact_eye_plane[4];           /* the same, never rounded to float */
};

struct texture_env {
    GLenum mode;
    float color[4];
    GLenum combine_rgb, combine_alpha, source_rgb[3], source_alpha[3], operand_rgb[3], operand_alpha[3];
    float rgb_scale, alpha_scale, lod_bias;
};

struct texture_unit {
    unsigned enabled;    /* bit t: enum texture_target */
    bool gen_enabled[4]; /* s, t, r, q */
    struct texgen gen[4];
    struct texture_env env;
    struct sampler_object *sampler; /* texture/texture.h; NULL: none */
    struct texture_object *bound[TEXTURE_TARGETS]; /* texture/texture.h; name 0: the store's default objects, never NULL */
};

struct texture_state {
    int active_texture;
    struct texture_unit unit[FGL_MAX_TEXTURE_UNITS];
};

/* Table 6.26 "Evaluators" (GL_EVAL_BIT); the maps are in no attribute group. */
struct eval_state {
    bool auto_normal;
    unsigned map1_enabled, map2_enabled; /* bit i: GL_MAP1_COLOR_4 + i, GL_MAP2_COLOR_4 + i */
    float map1_grid_domain[2], map2_grid_domain[4];
    int map1_grid_segments, map2_grid_segments[2];
};

/* Table 6.32 "Miscellaneous": feedback and selection, in no attribute group. */
struct feedback_state {
    float *buffer;
    int size, count; /* values; count goes one beyond a full buffer */
    GLenum type;     /* GL_2D ... GL_4D_COLOR_TEXTURE */
};

struct selection_state {
    unsigned *buffer;
    int size, count; /* values; count goes one beyond a full buffer */
    int hits;        /* records */
    bool hit;        /* something was hit since the name stack last changed, */
    float min_z, max_z; /* at window depths between these */
    int name_stack_depth;
    unsigned name[FGL_MAX_NAME_DEPTH];
};

/* Everything that glPushAttrib can save. */
struct server_state {
    struct current_state current;
    struct lighting_state lighting;
    struct fog_state fog;
    struct transform_state transform;
    struct viewport_state viewport;
    struct point_state point;
    struct line_state line;
    struct polygon_state polygon;
    struct polygon_stipple_state polygon_stipple;
    struct multisample_state multisample;
    struct scissor_state scissor;
    struct depth_state depth;
    struct stencil_state stencil;
    struct color_buffer_state color_buffer;
    struct accum_state accum;
    struct hint_state hint;
    struct list_state list;
    struct pixel_mode_state pixel_mode;
    struct texture_state texture;
    struct eval_state eval;
};

/* Table 6.6 "Vertex Array Data" (GL_CLIENT_VERTEX_ARRAY_BIT). */
struct buffer_object; /* api/buffer.h */

struct vertex_array {
    const void *pointer; /* an offset from the buffer's start when there is one */
    struct buffer_object *buffer; /* NULL: client memory */
    GLenum type;
    int size;   /* components */
    int stride; /* bytes, as given: 0 means tightly packed */
    int count;  /* elements, as GL_EXT_vertex_array's commands say; else 0. Nothing depends on it. */
    bool enabled;
};

struct client_array_state {
    struct vertex_array array[ATTR_MATERIAL]; /* by enum fgl_attr */
    int client_active_texture;                /* unit */
    struct buffer_object *array_buffer, *element_array_buffer; /* NULL: none is bound */
    int lock_first, lock_count; /* GL_EXT_compiled_vertex_array; count 0: not locked */
    GLuint object; /* name of the array object whose arrays and element buffer these are now; 0: the context's own */
};

/* Table 6.22 "Pixels": glPixelStore, [0] pack, [1] unpack (GL_CLIENT_PIXEL_STORE_BIT). */
struct pixel_store {
    bool swap_bytes, lsb_first;
    int row_length, image_height, skip_rows, skip_pixels, skip_images, alignment;
    struct buffer_object *buffer; /* GL_ARB_pixel_buffer_object; NULL: none */
};

struct client_state {
    struct client_array_state arrays;
    struct pixel_store pack, unpack;
};

struct saved_texture {
    unsigned name;
    struct texture_parameters parameters;
};

struct attrib_entry {
    GLbitfield mask;
    struct server_state state; /* its pointers are not to be followed: the objects may be gone */
    struct saved_texture texture[FGL_MAX_TEXTURE_UNITS][TEXTURE_TARGETS]; /* of GL_TEXTURE_BIT */
};

struct client_attrib_entry {
    GLbitfield mask;
    struct client_state state;
};

enum { OUTSIDE_BEGIN_END = 0xffff }; /* context.begin_mode outside Begin/End */

struct context {
    unsigned dirty;    /* DIRTY_* */
    GLenum error;      /* first error since glGetError */
    GLenum begin_mode; /* primitive of the open Begin, or OUTSIDE_BEGIN_END */
    GLenum compiling;  /* GL_COMPILE, GL_COMPILE_AND_EXECUTE, or 0 when no list is being compiled */
    bool viewport_set; /* the first MakeCurrent sets viewport and scissor to the buffer's size */

    struct server_state s;
    struct client_state client;
    struct matrix_stack modelview, projection, texture_matrix[FGL_MAX_TEXTURE_UNITS], color_matrix;
    struct pixel_map pixel_map[PIXEL_MAP_COUNT];

    struct attrib_entry *attrib_stack; /* FGL_MAX_ATTRIB_DEPTH entries, allocated at the first push */
    int attrib_depth;
    struct client_attrib_entry *client_attrib_stack;
    int client_attrib_depth;

    GLenum render_mode; /* GL_RENDER, GL_FEEDBACK, GL_SELECT */
    struct feedback_state feedback;
    struct selection_state selection;

    bool count_samples; /* an occlusion query runs */
    atomic_ullong samples_passed;

    bool color_index; /* colour index mode, for the life of the context; else RGBA mode */
    GLenum accuracy;  /* FIXEDGL_COMPATIBLE or FIXEDGL_EXACT: see fgl_context_arith */

    /* The layers above, each known only to its own files. */
    struct immediate *immediate;     /* api/immediate.h: vertices between Begin and End */
    struct immediate *vertices;      /* where vertex commands go now: immediate, or the list being compiled */
    struct list_compiler *list;      /* api/list.h: the list being compiled */
    struct share_group *share;       /* state/share.h: the contexts that share what follows */
    struct list_store *lists;        /* api/list.h: lists, maybe shared with other contexts */
    struct texture_store *textures;  /* texture/texture.h: texture objects, maybe shared alike */
    struct sampler_store *samplers;  /* api/sampler.h: sampler objects, shared as lists are */
    struct texture_object *proxy_texture[TEXTURE_TARGETS]; /* GL_PROXY_TEXTURE_1D...: sizes without texels */
    struct buffer_store *buffers;    /* api/buffer.h: buffer objects, shared as lists are */
    struct queries *queries;         /* api/query.h: allocated when first used */
    struct array_objects *array_objects; /* api/array_object.h: allocated when first used */
    struct eval_maps *eval_maps;     /* api/eval_map.h: allocated when first used */
    struct imaging *imaging;         /* framebuffer/imaging.h: allocated when first used */
    struct pipeline *pipeline;       /* pipeline/pipeline.h: the plan and its work space */
    struct framebuffer *window;      /* framebuffer/framebuffer.h: that of OSMesaMakeCurrent; NULL until then */
    struct framebuffer *framebuffer; /* what is drawn to: the window, or the planes of a framebuffer object; NULL: nothing */
    struct framebuffer *read_framebuffer; /* what is read from, likewise */
    struct framebuffers *framebuffers;    /* api/framebuffer_object.h: allocated when first used */
    struct renderbuffer_store *renderbuffers; /* api/renderbuffer.h: shared as lists are */
    struct osmesa_context *osmesa;   /* osmesa/osmesa.c */
    void (*present)(struct context *); /* copies the picture to the caller's buffer, at glFlush and glFinish; may be NULL */
};

/* The context that is current in the calling thread, or NULL. */
extern _Thread_local FGL_TLS_FAST struct context *fgl_current;

/* The arithmetic that its kernels use. */
enum fgl_arith fgl_context_arith(const struct context *ctx);

/* Initial values of the arrays, of which nothing is referred to. */
void fgl_state_init_arrays(struct vertex_array array[ATTR_MATERIAL]);

/* Sets every value to the initial value of the state tables. */
void fgl_state_init(struct context *ctx);

#endif
