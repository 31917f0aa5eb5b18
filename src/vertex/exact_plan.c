/* Derives the numbers that FIXEDGL_EXACT reads (GL 1.5, 2.14.1 "Lighting"), in double from the state's doubles. What
 * to compute was decided by light.c. */
#include "state/matrix_exact.h"
#include "vertex/vertex.h"

#include <math.h>
#include <string.h>

/* v scaled to unit length; the zero vector stays. */
static void normalize(double v[3])
{
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

    for (int c = 0; square > 0 && c < 3; c++)
        v[c] /= sqrt(square);
}

/* As half_vector (light_kernel.h), for the viewer along z. */
static void derive_half(double half[3], const double direction[3])
{
    const double d[3] = {direction[0] / 2, direction[1] / 2, (direction[2] - 1) / 2};
    double along = 0;

    for (int c = 0; c < 3; c++) {
        half[c] = direction[c] + (c == 2 ? 1 : 0);
        along += half[c] * d[c];
    }
    for (int c = 0; c < 3; c++)
        half[c] -= along * d[c];
    normalize(half);
}

static double number_or_zero(double x)
{
    return isnan(x) ? 0 : x;
}

static bool is_finite_point(const double v[4])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]) && isfinite(v[3]);
}

/* Directional lights are used as directions, positional ones as points divided by w: what GL 1.5, 2.14.1 calls the
 * vector from the vertex to the light. */
static void derive_geometry(struct exact_light *out, const struct light *light)
{
    const double w = light->exact_position[3];

    for (int c = 0; c < 3; c++) {
        out->position[c] = light->exact_position[c] / (w == 0 ? 1 : w);
        out->direction[c] = light->exact_position[c];
        out->spot_direction[c] = out->axis[c] = light->exact_spot_direction[c];
    }
    normalize(out->direction);
    normalize(out->spot_direction);
    derive_half(out->half, out->direction);
    out->cos_square = fgl_cone_cos_square(light->spot_cutoff);
    out->spot_exponent = (double)light->spot_exponent;
    out->k0 = (double)light->constant_attenuation;
    out->k1 = (double)light->linear_attenuation;
    out->k2 = (double)light->quadratic_attenuation;
}

static void derive_products(struct exact_light *out, const struct light_derived *light,
                            const struct lighting_plan *plan)
{
    for (int color = 0; color < COLOR_COUNT; color++)
        for (int c = 0; c < 3; c++) {
            out->color[color][c] = (double)light->color[color][c];
            for (int face = 0; face < 2; face++)
                out->product[face][color][c] =
                        (double)light->color[color][c] * (double)plan->material[MAT_AMBIENT + color][face][c];
        }
}

static void derive_base(struct exact_plan *out, const struct lighting_plan *plan)
{
    for (int face = 0; face < 2; face++)
        for (int c = 0; c < 3; c++)
            out->base[face][c] = number_or_zero((double)plan->model_ambient[c] *
                                                (double)plan->material[MAT_AMBIENT][face][c]) +
                                 number_or_zero((double)plan->material[MAT_EMISSION][face][c]);
}

/* GL 1.5, 2.11.3 "Normal Transformation". A singular matrix: GL_NORMALIZE takes the limit of the inverse's
 * direction, the cofactors; otherwise normals are 0. */
static void derive_normals(struct exact_plan *out, const struct transform_state *transform, const double m[16])
{
    double inverse[3][3];
    const bool regular = fgl_exact_inverse3(inverse, m);

    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++)
            out->normal_matrix[r][k] = regular || transform->normalize ? inverse[k][r] : 0;
    const double *third = inverse[2];
    out->rescale_factor = 1 / sqrt(third[0] * third[0] + third[1] * third[1] + third[2] * third[2]);
    out->normal_scaling = transform->normalize                    ? NORMAL_NORMALIZE
                          : transform->rescale_normal && regular ? NORMAL_RESCALE
                                                                 : NORMAL_AS_IS;
}

/* Whether float is safe for a whole plan ------------------------------------------------------------------------ */

static bool all_finite(const float *v, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(v[i]))
            return false;
    return true;
}

static float greatest3(const float v[3])
{
    return fmaxf(fmaxf(fabsf(v[0]), fabsf(v[1])), fabsf(v[2]));
}

static bool is_safe_length(float x)
{
    return x >= 1e-12f && x <= 1e12f;
}

static bool is_safe_factor(float k)
{
    return k == 0 || is_safe_length(fabsf(k));
}

static bool is_safe_light(const struct light *light, const struct exact_light *exact, bool positional)
{
    const float *p = light->position;
    const double *d = exact->direction;
    const double half_square = d[0] * d[0] + d[1] * d[1] + (d[2] + 1) * (d[2] + 1);

    if (!all_finite(light->ambient, 3) || !all_finite(light->diffuse, 3) || !all_finite(light->specular, 3) ||
        !all_finite(p, 4) || !all_finite(light->spot_direction, 3))
        return false;
    if (light->spot_cutoff != 180.0f && !is_safe_factor(greatest3(light->spot_direction)))
        return false;
    if (!positional)
        return is_safe_length(greatest3(p)) && half_square > 1e-4;
    const float k[3] = {light->constant_attenuation, light->linear_attenuation, light->quadratic_attenuation};
    return is_safe_length(fabsf(p[3])) && greatest3(p) <= 1e12f && greatest3(k) > 0 && is_safe_factor(k[0]) &&
           is_safe_factor(k[1]) && is_safe_factor(k[2]);
}

/* Products of colours far outside of [0,1] magnify the rounding of what they are multiplied by. */
static bool are_safe_products(const struct exact_light *light, bool two_sided)
{
    for (int face = 0; face <= two_sided; face++)
        for (int color = 0; color < COLOR_COUNT; color++)
            for (int c = 0; c < 3; c++)
                if (fabs(light->product[face][color][c]) > 4)
                    return false;
    return true;
}

/* Whether the float inverse, by the formula of the matrix's class, is one. Drift of a product of many rotations, which
 * OSMesa inverts by transposing, is no reason to leave its bits. */
static bool is_safe_inverse(const struct vertex_plan *plan, unsigned modelview_class)
{
    const double tolerance = modelview_class & ~(unsigned)(MAT_ROTATION | MAT_TRANSLATION) ? 1e-5 : 1e-4;
    double greatest = 0, difference = 0;

    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++) {
            const double exact = plan->exact.normal_matrix[r][k], given = (double)plan->normal_matrix[r][k];
            greatest = fmax(greatest, fabs(exact));
            if (!isfinite(given))
                return false;
            difference = fmax(difference, fabs(given - exact));
        }
    if (plan->exact.normal_scaling == NORMAL_RESCALE &&
        !(fabs((double)plan->rescale_factor / plan->exact.rescale_factor - 1) <= tolerance))
        return false;
    return difference <= tolerance * greatest;
}

static bool is_needed(const struct vertex_plan *plan, struct context *ctx)
{
    const struct lighting_plan *lighting = &plan->light;

    if (!all_finite(lighting->model_ambient, 3))
        return true;
    for (int m = MAT_AMBIENT; m <= MAT_EMISSION; m++)
        for (int face = 0; face <= lighting->two_sided; face++)
            if (!all_finite(lighting->material[m][face], 3))
                return true;
    for (int i = 0; i < lighting->n; i++)
        if (!is_safe_light(&ctx->s.lighting.light[lighting->light[i].number], &plan->exact.light[i],
                           lighting->light[i].key & LIGHT_POSITIONAL) ||
            !are_safe_products(&plan->exact.light[i], lighting->two_sided))
            return true;
    return plan->need_normal && !is_safe_inverse(plan, fgl_matrix_class(fgl_matrix_top(&ctx->modelview)));
}

void fgl_exact_light_validate(struct vertex_plan *plan, struct context *ctx)
{
    struct exact_plan *out = &plan->exact;

    for (int i = 0; i < plan->light.n; i++) {
        const struct light *light = &ctx->s.lighting.light[plan->light.light[i].number];
        derive_geometry(&out->light[i], light);
        derive_products(&out->light[i], &plan->light.light[i], &plan->light);
        if (!is_finite_point(light->exact_position)) /* its attenuation is no number then */
            plan->light.light[i].key |= plan->light.light[i].key & LIGHT_POSITIONAL ? LIGHT_ATTENUATED : 0u;
    }
    derive_base(out, &plan->light);
    derive_normals(out, &ctx->s.transform, out->modelview);
    out->needed = plan->arith != ARITH_EXACT && is_needed(plan, ctx);
}
