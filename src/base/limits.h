/* The implementation's limits, as OSMesa reports them (GL 1.5, table 6.31 "Implementation Dependent Values"). */
#ifndef FGL_BASE_LIMITS_H
#define FGL_BASE_LIMITS_H

enum {
    FGL_MAX_LIGHTS = 8,
    FGL_MAX_CLIP_PLANES = 8,
    FGL_MAX_TEXTURE_UNITS = 8,
    FGL_MAX_TEXTURE_LEVELS = 15,
    FGL_MAX_TEXTURE_SIZE = 1 << (FGL_MAX_TEXTURE_LEVELS - 1), /* also of cube maps */
    FGL_MAX_3D_TEXTURE_LEVELS = 12,
    FGL_MAX_3D_TEXTURE_SIZE = 1 << (FGL_MAX_3D_TEXTURE_LEVELS - 1),
    FGL_MAX_TEXTURE_LOD_BIAS = 16,
    FGL_MAX_SAMPLES = 1, /* of a renderbuffer; there is never more than one */
    FGL_MAX_MODELVIEW_DEPTH = 32,
    FGL_MAX_PROJECTION_DEPTH = 32,
    FGL_MAX_TEXTURE_DEPTH = 10,
    FGL_MAX_COLOR_MATRIX_DEPTH = 4,
    FGL_MAX_ATTRIB_DEPTH = 16,
    FGL_MAX_CLIENT_ATTRIB_DEPTH = 16,
    FGL_MAX_NAME_DEPTH = 64,
    FGL_MAX_LIST_NESTING = 64,
    FGL_MAX_EVAL_ORDER = 30,
    FGL_MAX_PIXEL_MAP = 256,
    FGL_MAX_COLOR_TABLE = 4096,
    FGL_MAX_HISTOGRAM = 4096,
    FGL_MAX_CONVOLUTION = 32, /* width and height of a filter */
    FGL_MAX_ELEMENTS = 3000, /* what glDrawRangeElements should be given at most */
    FGL_MAX_VIEWPORT = 16384,
    FGL_MAX_SHININESS = 128, /* GL 1.5, 2.14.1: also the largest spot exponent */
    FGL_MAX_POINT_SIZE = 255,
    FGL_MAX_LINE_WIDTH = 255,
    FGL_SUBPIXEL_BITS = 8
};

#endif
