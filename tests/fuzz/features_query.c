/* Features: errors, values of state. */
#include "generator.h"

void feature_errors(struct generator *g)
{
    switch (below(g, 16)) {
    case 0: EMIT(g, PolygonMode, GL_FRONT, GL_TRIANGLES); break;
    case 1: EMIT(g, Enable, GL_TRIANGLES + 0x9999); break;
    case 2: EMIT(g, LineWidth, ONE_OF(g, 0, -1)); break;
    case 3: EMIT(g, PointSize, ONE_OF(g, 0, -2)); break;
    case 4: EMIT(g, Viewport, 0, 0, -1, 5); break;
    case 5: EMIT(g, Lightf, ONE_OF(g, GL_LIGHT0, GL_LIGHT0 + 8), GL_SPOT_CUTOFF, ONE_OF(g, 91, -1, 200)); break;
    case 6: EMIT(g, Materialf, GL_FRONT, GL_SHININESS, ONE_OF(g, -1, 129)); break;
    case 7: EMIT(g, DepthFunc, GL_FRONT); break;
    case 8: EMIT(g, Frustum, -1, 1, -1, 1, ONE_OF(g, -1, 0), 10); break;
    case 9: EMIT(g, Ortho, 1, 1, -1, 1, -1, 1); break;
    case 10: EMIT(g, Clear, 1 << 20); break;
    case 11: EMIT(g, Scissor, 0, 0, 5, -1); break;
    case 12: EMIT(g, DrawArrays, GL_POINTS, 0, -1); break;
    case 13: EMIT(g, BlendFunc, GL_FRONT, GL_ONE); break;
    case 14: EMIT(g, CallList, 9999); break;
    default: EMIT(g, ShadeModel, GL_LINE);
    }
}

void feature_get(struct generator *g)
{
    /* The first are not asked for as integers: OSMesa takes the elements of matrices for colors, and rounds colors, normals and depths down
     * to other integers (departure integer-queries). */
    enum { REALS = 11 };
    static const double names[] = {
            GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX, GL_CURRENT_NORMAL, GL_CURRENT_COLOR, GL_DEPTH_RANGE, GL_FOG_COLOR,
            GL_LIGHT_MODEL_AMBIENT, GL_ALPHA_TEST_REF, GL_COLOR_CLEAR_VALUE, GL_DEPTH_CLEAR_VALUE, GL_CURRENT_TEXTURE_COORDS,
            GL_EDGE_FLAG, GL_VIEWPORT, GL_FOG_DENSITY, GL_FOG_MODE, GL_POINT_SIZE, GL_LINE_WIDTH, GL_LINE_STIPPLE_PATTERN, GL_LINE_STIPPLE_REPEAT, GL_POLYGON_MODE, GL_CULL_FACE_MODE, GL_FRONT_FACE,
            GL_SCISSOR_BOX, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK, GL_BLEND_SRC, GL_BLEND_DST,
            GL_LOGIC_OP_MODE, GL_COLOR_WRITEMASK, GL_STENCIL_CLEAR_VALUE, GL_DEPTH_FUNC,
            GL_DEPTH_WRITEMASK, GL_SHADE_MODEL, GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_ATTRIB_STACK_DEPTH, GL_LIST_BASE,
            GL_LIST_INDEX, GL_LIST_MODE, GL_COLOR_MATERIAL_FACE, GL_COLOR_MATERIAL_PARAMETER, GL_POLYGON_OFFSET_FACTOR, GL_DRAW_BUFFER};
    const double name = one_of(g, (int)(sizeof names / sizeof names[0]), names);
    switch (below(g, 8)) {
    case 0: case 1: EMIT(g, GetFloatv, name); break;
    case 2: EMIT(g, GetIntegerv, one_of(g, (int)(sizeof names / sizeof names[0]) - REALS, names + REALS)); break;
    case 3: EMIT(g, GetDoublev, name); break;
    case 4: EMIT(g, GetBooleanv, name); break;
    case 5:
        EMIT(g, GetLightfv, GL_LIGHT0 + below(g, 8), ONE_OF(g, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_CUTOFF));
        break;
    case 6:
        EMIT(g, GetMaterialfv, ONE_OF(g, GL_FRONT, GL_BACK), ONE_OF(g, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS));
        break;
    default: EMIT(g, GetClipPlane, GL_CLIP_PLANE0 + below(g, 6));
    }
}
