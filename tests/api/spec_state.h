/* The state tables of the specification (GL 1.5, 6.2): each value that glGet knows, the groups of
 * glPushAttrib that it belongs to, and its initial value in a 64x64 context. Written from the specification,
 * not from the library. Values that no command can change yet have no group here. */
#ifndef TESTS_API_SPEC_STATE_H
#define TESTS_API_SPEC_STATE_H

#include "api/gl_test.h"

struct spec_value {
    const char *text;
    GLenum name;
    GLbitfield groups;
    int count;
    double initial[16];
};

#define V(name, groups, count, ...)                                                                          \
    {                                                                                                        \
#name, (name), (groups), (count),                                                                    \
        {                                                                                                    \
            __VA_ARGS__                                                                                      \
        }                                                                                                    \
    }
#define CAP(name, groups, on) V(name, (groups) | GL_ENABLE_BIT, 1, on)
#define IDENTITY 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1
#define HINT(name) V(name, GL_HINT_BIT, 1, GL_DONT_CARE)

static const struct spec_value spec_state[] = {
        V(GL_CURRENT_COLOR, GL_CURRENT_BIT, 4, 1, 1, 1, 1),
        V(GL_CURRENT_INDEX, GL_CURRENT_BIT, 1, 1),
        V(GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_BIT, 4, 0, 0, 0, 1),
        V(GL_CURRENT_NORMAL, GL_CURRENT_BIT, 3, 0, 0, 1),
        V(GL_EDGE_FLAG, GL_CURRENT_BIT, 1, GL_TRUE),
        V(GL_CURRENT_RASTER_POSITION, 0, 4, 0, 0, 0, 1),
        V(GL_CURRENT_RASTER_DISTANCE, 0, 1, 0),
        V(GL_CURRENT_RASTER_COLOR, 0, 4, 1, 1, 1, 1),
        V(GL_CURRENT_RASTER_INDEX, 0, 1, 1),
        V(GL_CURRENT_RASTER_TEXTURE_COORDS, 0, 4, 0, 0, 0, 1),
        V(GL_CURRENT_RASTER_POSITION_VALID, 0, 1, GL_TRUE),

        V(GL_VERTEX_ARRAY, 0, 1, GL_FALSE),
        V(GL_VERTEX_ARRAY_SIZE, 0, 1, 4),
        V(GL_VERTEX_ARRAY_TYPE, 0, 1, GL_FLOAT),
        V(GL_VERTEX_ARRAY_STRIDE, 0, 1, 0),
        V(GL_NORMAL_ARRAY, 0, 1, GL_FALSE),
        V(GL_NORMAL_ARRAY_TYPE, 0, 1, GL_FLOAT),
        V(GL_NORMAL_ARRAY_STRIDE, 0, 1, 0),
        V(GL_COLOR_ARRAY, 0, 1, GL_FALSE),
        V(GL_COLOR_ARRAY_SIZE, 0, 1, 4),
        V(GL_COLOR_ARRAY_TYPE, 0, 1, GL_FLOAT),
        V(GL_COLOR_ARRAY_STRIDE, 0, 1, 0),
        V(GL_INDEX_ARRAY, 0, 1, GL_FALSE),
        V(GL_INDEX_ARRAY_TYPE, 0, 1, GL_FLOAT),
        V(GL_INDEX_ARRAY_STRIDE, 0, 1, 0),
        V(GL_TEXTURE_COORD_ARRAY, 0, 1, GL_FALSE),
        V(GL_TEXTURE_COORD_ARRAY_SIZE, 0, 1, 4),
        V(GL_TEXTURE_COORD_ARRAY_TYPE, 0, 1, GL_FLOAT),
        V(GL_TEXTURE_COORD_ARRAY_STRIDE, 0, 1, 0),
        V(GL_EDGE_FLAG_ARRAY, 0, 1, GL_FALSE),
        V(GL_EDGE_FLAG_ARRAY_STRIDE, 0, 1, 0),

        V(GL_MODELVIEW_MATRIX, 0, 16, IDENTITY),
        V(GL_PROJECTION_MATRIX, 0, 16, IDENTITY),
        V(GL_TEXTURE_MATRIX, 0, 16, IDENTITY),
        V(GL_VIEWPORT, GL_VIEWPORT_BIT, 4, 0, 0, TEST_SIZE, TEST_SIZE),
        V(GL_DEPTH_RANGE, GL_VIEWPORT_BIT, 2, 0, 1),
        V(GL_MODELVIEW_STACK_DEPTH, 0, 1, 1),
        V(GL_PROJECTION_STACK_DEPTH, 0, 1, 1),
        V(GL_TEXTURE_STACK_DEPTH, 0, 1, 1),
        V(GL_MATRIX_MODE, GL_TRANSFORM_BIT, 1, GL_MODELVIEW),
        CAP(GL_NORMALIZE, GL_TRANSFORM_BIT, 0),
        CAP(GL_RESCALE_NORMAL, GL_TRANSFORM_BIT, 0),
        CAP(GL_CLIP_PLANE0, GL_TRANSFORM_BIT, 0),
        CAP(GL_CLIP_PLANE1, GL_TRANSFORM_BIT, 0),
        CAP(GL_CLIP_PLANE5, GL_TRANSFORM_BIT, 0),

        V(GL_FOG_COLOR, GL_FOG_BIT, 4, 0, 0, 0, 0),
        V(GL_FOG_INDEX, GL_FOG_BIT, 1, 0),
        V(GL_FOG_DENSITY, GL_FOG_BIT, 1, 1),
        V(GL_FOG_START, GL_FOG_BIT, 1, 0),
        V(GL_FOG_END, GL_FOG_BIT, 1, 1),
        V(GL_FOG_MODE, GL_FOG_BIT, 1, GL_EXP),
        CAP(GL_FOG, GL_FOG_BIT, 0),
        CAP(GL_COLOR_SUM, GL_FOG_BIT, 0),
        V(GL_SHADE_MODEL, GL_LIGHTING_BIT, 1, GL_SMOOTH),

        CAP(GL_LIGHTING, GL_LIGHTING_BIT, 0),
        CAP(GL_COLOR_MATERIAL, GL_LIGHTING_BIT, 0),
        V(GL_COLOR_MATERIAL_PARAMETER, GL_LIGHTING_BIT, 1, GL_AMBIENT_AND_DIFFUSE),
        V(GL_COLOR_MATERIAL_FACE, GL_LIGHTING_BIT, 1, GL_FRONT_AND_BACK),
        V(GL_LIGHT_MODEL_AMBIENT, GL_LIGHTING_BIT, 4, (double)0.2f, (double)0.2f, (double)0.2f, 1),
        V(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHTING_BIT, 1, GL_FALSE),
        V(GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHTING_BIT, 1, GL_FALSE),
        V(GL_LIGHT_MODEL_COLOR_CONTROL, GL_LIGHTING_BIT, 1, GL_SINGLE_COLOR),
        CAP(GL_LIGHT0, GL_LIGHTING_BIT, 0),
        CAP(GL_LIGHT7, GL_LIGHTING_BIT, 0),

        V(GL_POINT_SIZE, GL_POINT_BIT, 1, 1),
        CAP(GL_POINT_SMOOTH, GL_POINT_BIT, 0),
        V(GL_LINE_WIDTH, GL_LINE_BIT, 1, 1),
        CAP(GL_LINE_SMOOTH, GL_LINE_BIT, 0),
        V(GL_LINE_STIPPLE_PATTERN, GL_LINE_BIT, 1, 0xffff),
        V(GL_LINE_STIPPLE_REPEAT, GL_LINE_BIT, 1, 1),
        CAP(GL_LINE_STIPPLE, GL_LINE_BIT, 0),
        CAP(GL_CULL_FACE, GL_POLYGON_BIT, 0),
        V(GL_CULL_FACE_MODE, GL_POLYGON_BIT, 1, GL_BACK),
        V(GL_FRONT_FACE, GL_POLYGON_BIT, 1, GL_CCW),
        CAP(GL_POLYGON_SMOOTH, GL_POLYGON_BIT, 0),
        V(GL_POLYGON_MODE, GL_POLYGON_BIT, 2, GL_FILL, GL_FILL),
        V(GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_BIT, 1, 0),
        V(GL_POLYGON_OFFSET_UNITS, GL_POLYGON_BIT, 1, 0),
        CAP(GL_POLYGON_OFFSET_POINT, GL_POLYGON_BIT, 0),
        CAP(GL_POLYGON_OFFSET_LINE, GL_POLYGON_BIT, 0),
        CAP(GL_POLYGON_OFFSET_FILL, GL_POLYGON_BIT, 0),
        CAP(GL_POLYGON_STIPPLE, GL_POLYGON_BIT, 0),

        CAP(GL_TEXTURE_1D, GL_TEXTURE_BIT, 0),
        CAP(GL_TEXTURE_2D, GL_TEXTURE_BIT, 0),
        CAP(GL_TEXTURE_GEN_S, GL_TEXTURE_BIT, 0),
        CAP(GL_TEXTURE_GEN_T, GL_TEXTURE_BIT, 0),
        CAP(GL_TEXTURE_GEN_R, GL_TEXTURE_BIT, 0),
        CAP(GL_TEXTURE_GEN_Q, GL_TEXTURE_BIT, 0),

        CAP(GL_SCISSOR_TEST, GL_SCISSOR_BIT, 0),
        V(GL_SCISSOR_BOX, GL_SCISSOR_BIT, 4, 0, 0, TEST_SIZE, TEST_SIZE),
        CAP(GL_ALPHA_TEST, GL_COLOR_BUFFER_BIT, 0),
        V(GL_ALPHA_TEST_FUNC, GL_COLOR_BUFFER_BIT, 1, GL_ALWAYS),
        V(GL_ALPHA_TEST_REF, GL_COLOR_BUFFER_BIT, 1, 0),
        CAP(GL_STENCIL_TEST, GL_STENCIL_BUFFER_BIT, 0),
        V(GL_STENCIL_FUNC, GL_STENCIL_BUFFER_BIT, 1, GL_ALWAYS),
        V(GL_STENCIL_VALUE_MASK, GL_STENCIL_BUFFER_BIT, 1, 0xff),
        V(GL_STENCIL_REF, GL_STENCIL_BUFFER_BIT, 1, 0),
        V(GL_STENCIL_FAIL, GL_STENCIL_BUFFER_BIT, 1, GL_KEEP),
        V(GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_BUFFER_BIT, 1, GL_KEEP),
        V(GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_BUFFER_BIT, 1, GL_KEEP),
        CAP(GL_DEPTH_TEST, GL_DEPTH_BUFFER_BIT, 0),
        V(GL_DEPTH_FUNC, GL_DEPTH_BUFFER_BIT, 1, GL_LESS),
        CAP(GL_BLEND, GL_COLOR_BUFFER_BIT, 0),
        V(GL_BLEND_SRC, GL_COLOR_BUFFER_BIT, 1, GL_ONE),
        V(GL_BLEND_DST, GL_COLOR_BUFFER_BIT, 1, GL_ZERO),
        CAP(GL_DITHER, GL_COLOR_BUFFER_BIT, 1),
        CAP(GL_INDEX_LOGIC_OP, GL_COLOR_BUFFER_BIT, 0),
        CAP(GL_COLOR_LOGIC_OP, GL_COLOR_BUFFER_BIT, 0),
        V(GL_LOGIC_OP_MODE, GL_COLOR_BUFFER_BIT, 1, GL_COPY),

        V(GL_DRAW_BUFFER, GL_COLOR_BUFFER_BIT, 1, GL_FRONT),
        V(GL_INDEX_WRITEMASK, GL_COLOR_BUFFER_BIT, 1, -1),
        V(GL_COLOR_WRITEMASK, GL_COLOR_BUFFER_BIT, 4, 1, 1, 1, 1),
        V(GL_DEPTH_WRITEMASK, GL_DEPTH_BUFFER_BIT, 1, 1),
        V(GL_STENCIL_WRITEMASK, GL_STENCIL_BUFFER_BIT, 1, 0xff),
        V(GL_COLOR_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, 4, 0, 0, 0, 0),
        V(GL_INDEX_CLEAR_VALUE, GL_COLOR_BUFFER_BIT, 1, 0),
        V(GL_DEPTH_CLEAR_VALUE, GL_DEPTH_BUFFER_BIT, 1, 1),
        V(GL_STENCIL_CLEAR_VALUE, GL_STENCIL_BUFFER_BIT, 1, 0),
        V(GL_ACCUM_CLEAR_VALUE, 0, 4, 0, 0, 0, 0),

        V(GL_UNPACK_SWAP_BYTES, 0, 1, GL_FALSE),
        V(GL_UNPACK_LSB_FIRST, 0, 1, GL_FALSE),
        V(GL_UNPACK_IMAGE_HEIGHT, 0, 1, 0),
        V(GL_UNPACK_SKIP_IMAGES, 0, 1, 0),
        V(GL_UNPACK_ROW_LENGTH, 0, 1, 0),
        V(GL_UNPACK_SKIP_ROWS, 0, 1, 0),
        V(GL_UNPACK_SKIP_PIXELS, 0, 1, 0),
        V(GL_UNPACK_ALIGNMENT, 0, 1, 4),
        V(GL_PACK_SWAP_BYTES, 0, 1, GL_FALSE),
        V(GL_PACK_LSB_FIRST, 0, 1, GL_FALSE),
        V(GL_PACK_IMAGE_HEIGHT, 0, 1, 0),
        V(GL_PACK_SKIP_IMAGES, 0, 1, 0),
        V(GL_PACK_ROW_LENGTH, 0, 1, 0),
        V(GL_PACK_SKIP_ROWS, 0, 1, 0),
        V(GL_PACK_SKIP_PIXELS, 0, 1, 0),
        V(GL_PACK_ALIGNMENT, 0, 1, 4),
        V(GL_MAP_COLOR, 0, 1, GL_FALSE),
        V(GL_MAP_STENCIL, 0, 1, GL_FALSE),
        V(GL_INDEX_SHIFT, 0, 1, 0),
        V(GL_INDEX_OFFSET, 0, 1, 0),
        V(GL_RED_SCALE, 0, 1, 1),
        V(GL_GREEN_SCALE, 0, 1, 1),
        V(GL_BLUE_SCALE, 0, 1, 1),
        V(GL_ALPHA_SCALE, 0, 1, 1),
        V(GL_DEPTH_SCALE, 0, 1, 1),
        V(GL_RED_BIAS, 0, 1, 0),
        V(GL_GREEN_BIAS, 0, 1, 0),
        V(GL_BLUE_BIAS, 0, 1, 0),
        V(GL_ALPHA_BIAS, 0, 1, 0),
        V(GL_DEPTH_BIAS, 0, 1, 0),
        V(GL_ZOOM_X, 0, 1, 1),
        V(GL_ZOOM_Y, 0, 1, 1),
        V(GL_READ_BUFFER, GL_PIXEL_MODE_BIT, 1, GL_FRONT),

        CAP(GL_MAP1_COLOR_4, GL_EVAL_BIT, 0),
        CAP(GL_MAP1_VERTEX_4, GL_EVAL_BIT, 0),
        CAP(GL_MAP2_COLOR_4, GL_EVAL_BIT, 0),
        CAP(GL_MAP2_VERTEX_4, GL_EVAL_BIT, 0),
        CAP(GL_AUTO_NORMAL, GL_EVAL_BIT, 0),
        V(GL_MAP1_GRID_DOMAIN, GL_EVAL_BIT, 2, 0, 1),
        V(GL_MAP2_GRID_DOMAIN, GL_EVAL_BIT, 4, 0, 1, 0, 1),
        V(GL_MAP1_GRID_SEGMENTS, GL_EVAL_BIT, 1, 1),
        V(GL_MAP2_GRID_SEGMENTS, GL_EVAL_BIT, 2, 1, 1),

        HINT(GL_PERSPECTIVE_CORRECTION_HINT),
        HINT(GL_POINT_SMOOTH_HINT),
        HINT(GL_LINE_SMOOTH_HINT),
        HINT(GL_POLYGON_SMOOTH_HINT),
        HINT(GL_FOG_HINT),
        HINT(GL_GENERATE_MIPMAP_HINT),
        HINT(GL_TEXTURE_COMPRESSION_HINT),

        V(GL_MAX_LIGHTS, 0, 1, 8),
        V(GL_MAX_CLIP_PLANES, 0, 1, 8),
        V(GL_MAX_MODELVIEW_STACK_DEPTH, 0, 1, 32),
        V(GL_MAX_PROJECTION_STACK_DEPTH, 0, 1, 32),
        V(GL_MAX_TEXTURE_STACK_DEPTH, 0, 1, 10),
        V(GL_SUBPIXEL_BITS, 0, 1, 8),
        V(GL_MAX_PIXEL_MAP_TABLE, 0, 1, 256),
        V(GL_MAX_NAME_STACK_DEPTH, 0, 1, 64),
        V(GL_MAX_LIST_NESTING, 0, 1, 64),
        V(GL_MAX_EVAL_ORDER, 0, 1, 30),
        V(GL_MAX_VIEWPORT_DIMS, 0, 2, 16384, 16384),
        V(GL_MAX_ATTRIB_STACK_DEPTH, 0, 1, 16),
        V(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 0, 1, 16),
        V(GL_AUX_BUFFERS, 0, 1, 0),
        V(GL_RGBA_MODE, 0, 1, GL_TRUE),
        V(GL_INDEX_MODE, 0, 1, GL_FALSE),
        V(GL_DOUBLEBUFFER, 0, 1, GL_FALSE),
        V(GL_STEREO, 0, 1, GL_FALSE),
        V(GL_POINT_SIZE_RANGE, 0, 2, 1, 255),
        V(GL_POINT_SIZE_GRANULARITY, 0, 1, (double)0.1f),
        V(GL_LINE_WIDTH_RANGE, 0, 2, 1, 255),
        V(GL_LINE_WIDTH_GRANULARITY, 0, 1, (double)0.1f),
        V(GL_ALIASED_POINT_SIZE_RANGE, 0, 2, 1, 255),
        V(GL_ALIASED_LINE_WIDTH_RANGE, 0, 2, 1, 255),
        V(GL_RED_BITS, 0, 1, 8),
        V(GL_GREEN_BITS, 0, 1, 8),
        V(GL_BLUE_BITS, 0, 1, 8),
        V(GL_ALPHA_BITS, 0, 1, 8),
        V(GL_INDEX_BITS, 0, 1, 0),
        V(GL_DEPTH_BITS, 0, 1, 24),
        V(GL_STENCIL_BITS, 0, 1, 8),
        V(GL_ACCUM_RED_BITS, 0, 1, 16),
        V(GL_ACCUM_GREEN_BITS, 0, 1, 16),
        V(GL_ACCUM_BLUE_BITS, 0, 1, 16),
        V(GL_ACCUM_ALPHA_BITS, 0, 1, 16),

        V(GL_LIST_BASE, GL_LIST_BIT, 1, 0),
        V(GL_LIST_INDEX, 0, 1, 0),
        V(GL_LIST_MODE, 0, 1, 0),
        V(GL_RENDER_MODE, 0, 1, GL_RENDER),
        V(GL_NAME_STACK_DEPTH, 0, 1, 0),
        V(GL_SELECTION_BUFFER_SIZE, 0, 1, 0),
        V(GL_FEEDBACK_BUFFER_SIZE, 0, 1, 0),
        V(GL_FEEDBACK_BUFFER_TYPE, 0, 1, GL_2D),
        V(GL_ATTRIB_STACK_DEPTH, 0, 1, 0),
        V(GL_CLIENT_ATTRIB_STACK_DEPTH, 0, 1, 0),
};

enum { SPEC_VALUES = sizeof spec_state / sizeof *spec_state };

/* All of it, as it is now. */
struct state_snapshot {
    double value[SPEC_VALUES][16];
};

static inline void take_snapshot(struct state_snapshot *s)
{
    memset(s, 0, sizeof *s);
    for (int i = 0; i < SPEC_VALUES; i++)
        glGetDoublev(spec_state[i].name, s->value[i]);
}

static inline bool same_value(const struct state_snapshot *a, const struct state_snapshot *b, int i)
{
    return memcmp(a->value[i], b->value[i], sizeof a->value[i]) == 0;
}

#endif
