/* Scenes in which normals, matrices or the viewer are out of the ordinary. */
#include "oracle/generators.h"

#include <math.h>
#include <string.h>

#include "oracle/ordinary.h"

/* ---- normals and matrices ---- */

/* parameter: the length of the normals; below 0: lengths from 0.2 to 5 */
void generate_normals(struct random *r, struct oracle_scene *s, double length)
{
    oracle_ordinary(r, s, 2);
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].normal, 3, length < 0 ? random_between(r, 0.2f, 5) : (float)length);
}

void generate_normalized_normals(struct random *r, struct oracle_scene *s, double length)
{
    generate_normals(r, s, length);
    s->state.normalize = true;
}

/* Multiplies the modelview matrix by one that scales object space. */
static void scale_modelview(struct oracle_scene *s, float x, float y, float z)
{
    oracle_multiply(s->state.modelview, 4, x);
    oracle_multiply(s->state.modelview + 4, 4, y);
    oracle_multiply(s->state.modelview + 8, 4, z);
}

static float safe_inverse(float x)
{
    return x == 0 ? 1 : 1 / x;
}

/* Scales the vertices back, so that they stay where they were in eye space, and the normals with the matrix.
 */
static void scale_scene(struct oracle_scene *s, float x, float y, float z)
{
    const float scale[3] = {x, y, z};
    scale_modelview(s, x, y, z);
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < 3; k++) {
            s->vertex[i].position[k] *= safe_inverse(scale[k]);
            if (s->state.normalize)
                s->vertex[i].normal[k] *= scale[k];
        }
}

/* parameter: the uniform scale of the modelview matrix; 0: one from 0.1 to 10 */
void generate_rescaled(struct random *r, struct oracle_scene *s, double scale)
{
    oracle_ordinary(r, s, 2);
    s->state.rescale_normal = true;
    const float u = scale == 0 ? random_magnitude(r, 0.1f, 10) : (float)scale;
    scale_scene(s, u, u, u);
}

void generate_uniform_scale(struct random *r, struct oracle_scene *s, double scale)
{
    generate_every_kind(r, s, 2);
    s->state.normalize = true;
    scale_scene(s, (float)scale, (float)scale, (float)scale);
}

/* parameter: the least scale of an axis; below 0: mirrored too */
void generate_scaled(struct random *r, struct oracle_scene *s, double least)
{
    generate_every_kind(r, s, 2);
    s->state.normalize = true;
    const float low = (float)fabs(least);
    scale_scene(s, least < 0 ? -1.0f : random_magnitude(r, low, 1), random_magnitude(r, low, 1),
                random_magnitude(r, low, 1));
}

/* parameter: how much of one axis is left when it is sheared onto another; 0: none, the matrix is singular */
void generate_sheared(struct random *r, struct oracle_scene *s, double left)
{
    generate_every_kind(r, s, 2);
    s->state.normalize = random_below(r, 4) != 0;
    float *m = s->state.modelview;
    const int to = random_below(r, 3), from = (to + 1) % 3;
    for (int k = 0; k < 3; k++)
        m[4 * to + k] = m[4 * from + k] + (float)left * m[4 * to + k];
}

void generate_condition(struct random *r, struct oracle_scene *s, double condition)
{
    generate_sheared(r, s, 1 / condition);
}

/* parameter: how many axes are scaled by 0 */
void generate_collapsed(struct random *r, struct oracle_scene *s, double axes)
{
    generate_every_kind(r, s, 2);
    s->state.normalize = random_below(r, 4) != 0;
    scale_modelview(s, 0, axes > 1 ? 0.0f : 1.0f, axes > 2 ? 0.0f : 1.0f);
}

/* parameter: how far the world is from the origin of object space */
void generate_large_world(struct random *r, struct oracle_scene *s, double offset)
{
    oracle_ordinary(r, s, 2);
    for (int i = 0; i < 2; i++)
        oracle_point_light(r, &s->state.light[i]);
    oracle_aim_normals(r, s);
    float to[3], *m = s->state.modelview;
    for (int k = 0; k < 3; k++)
        to[k] = (float)floor(offset * (double)random_between(r, -1, 1));
    for (int row = 0; row < 3; row++)
        m[12 + row] -= (float)((double)m[row] * (double)to[0] + (double)m[4 + row] * (double)to[1] +
                               (double)m[8 + row] * (double)to[2]);
    memcpy(s->state.light_modelview, m, sizeof s->state.modelview);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < s->count; i++)
            s->vertex[i].position[k] += to[k];
        for (int i = 0; i < 2; i++)
            s->state.light[i].position[k] += to[k];
    }
}

/* ---- viewer ---- */

/* parameter: the distance of the vertices from the viewer */
void generate_viewer_distance(struct random *r, struct oracle_scene *s, double d)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    s->state.local_viewer = true;
    oracle_aim_normals(r, s);
    for (int i = 0; i < s->count; i++)
        oracle_multiply(s->vertex[i].position, 3, (float)(d / 2));
}

/* parameter: how far off the light is from being right behind the vertex, seen from the viewer. The half
 * vector is as long as that. */
void generate_half_vector(struct random *r, struct oracle_scene *s, double length)
{
    oracle_ordinary_in_eye_space(r, s, 1);
    struct oracle_light *light = &s->state.light[0];
    s->state.local_viewer = random_below(r, 2);
    s->state.front.shininess = (float)(random_below(r, 2) * random_below(r, 40));
    light->position[3] = 0;
    light->position[0] = (float)length;
    light->position[1] = 0;
    light->position[2] = -1;
    for (int i = 0; i < s->count; i++) {
        struct oracle_vertex *vertex = &s->vertex[i];
        vertex->position[0] = vertex->position[1] = 0;
        vertex->position[2] = -(float)(1 + i % 8);
        if (i % 2 && vertex->normal[2] > 0)
            oracle_multiply(vertex->normal, 3, -1);
    }
}
