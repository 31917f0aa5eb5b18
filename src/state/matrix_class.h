/* What matrix.c and matrix_class.c share: element names and sets of class flags. */
#ifndef FGL_STATE_MATRIX_CLASS_H
#define FGL_STATE_MATRIX_CLASS_H

#include "state/matrix.h"

#define AT(row, column) ((row) + 4 * (column))

enum {
    FLAGS_ANGLE_PRESERVING = MAT_ROTATION | MAT_TRANSLATION | MAT_UNIFORM_SCALE,
    FLAGS_AFFINE = FLAGS_ANGLE_PRESERVING | MAT_GENERAL_SCALE | MAT_GENERAL_3D,
    FLAGS_CLASS = FLAGS_AFFINE | MAT_PERSPECTIVE | MAT_GENERAL | MAT_SINGULAR
};

static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

#endif
