/* Eye planes (GL 1.5, 2.12 "Clipping", 2.11.4 "Generating Texture Coordinates"). */
#include "api/plane.h"

#include "api/set.h"
#include "state/matrix_exact.h"

#include <string.h>

/* The plane in double, after that in float: where only they differ, nothing but FIXEDGL_EXACT sees it. */
static void set_exact(struct context *ctx, unsigned dirty, double field[4], const double plane[4])
{
    const struct matrix *modelview = fgl_matrix_top(&ctx->modelview);
    const bool exact = fgl_context_arith(ctx) == ARITH_EXACT;
    double m[16], eye[4];

    fgl_exact_load(m, modelview->m);
    fgl_exact_transform_plane(eye, exact ? modelview->exact : m, plane);
    if (exact && memcmp(field, eye, sizeof eye) != 0)
        fgl_flush_vertices(ctx, dirty);
    memcpy(field, eye, sizeof eye);
}

/* Floats, summed left to right. */
void fgl_set_plane(struct context *ctx, unsigned dirty, float field[4], double exact_field[4], const double plane[4])
{
    const float *inv = fgl_matrix_inverse(fgl_matrix_top(&ctx->modelview));
    const float p[4] = {(float)plane[0], (float)plane[1], (float)plane[2], (float)plane[3]};
    float eye[4];
    for (int c = 0; c < 4; c++)
        eye[c] = p[0] * inv[4 * c] + p[1] * inv[4 * c + 1] + p[2] * inv[4 * c + 2] + p[3] * inv[4 * c + 3];
    fgl_set_floats(ctx, dirty, field, eye, 4);
    set_exact(ctx, dirty, exact_field, plane);
}
