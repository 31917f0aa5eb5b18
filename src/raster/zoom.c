#include "raster/zoom.h"

#include "base/arith.h"

/* OSMesa rule: window coordinates go through clip space. Origin, scale and the result in pixels. */
static float through_clip(float v, float size, float scale)
{
    const float clip = v / size * 2.0f - 1.0f;
    return fgl_fma(clip, scale, size * 0.5f);
}

/* In units of 1/256 pixel from the centre of pixel 0, half to even. */
static double snapped(float v)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: the sum's last place is 1 */
    return ((double)((v - 0.5f) * 256.0f) + magic) - magic;
}

static int clamp_to_int(double v, int limit)
{
    return v > 0.0 ? (v < limit ? (int)v : limit) : 0;
}

/* OSMesa rule: left and lower edges own the pixel centres on them. */
static struct rect coverage(const double x[2], const double y[2], int fb_width, int fb_height)
{
    const double left = fmin(x[0], x[1]), right = fmax(x[0], x[1]), top = fmin(y[0], y[1]),
                 bottom = fmax(y[0], y[1]);
    return (struct rect){clamp_to_int(ceil(left / 256.0), fb_width),
                         clamp_to_int(floor(top / 256.0) + 1.0, fb_height),
                         clamp_to_int(ceil(right / 256.0), fb_width),
                         clamp_to_int(floor(bottom / 256.0) + 1.0, fb_height)};
}

void fgl_zoom_setup(struct zoom *z, int x, int y, int width, int height, float zoom_x, float zoom_y,
                    const struct framebuffer *fb, bool top_first)
{
    const float w = (float)fb->width, h = (float)fb->height;
    const bool turned = top_first != fb->y_up;
    if (fb->y_up)
        y = fb->height - (int)((float)y + (float)height * zoom_y);
    const float x0 = through_clip((float)x, w, w * 0.5f);
    const float x1 = through_clip((float)x + (float)width * zoom_x, w, w * 0.5f);
    const float y0 = through_clip((float)y, h, -(h * 0.5f));
    const float y1 = through_clip((float)y + (float)height * zoom_y, h, -(h * 0.5f));
    const double sx[2] = {snapped(x0), snapped(x1)}, sy[2] = {snapped(y0), snapped(y1)};

    z->x[0] = (float)x;
    z->x[1] = (float)x + (float)width * zoom_x;
    z->y[0] = (float)y;
    z->y[1] = (float)y + (float)height * zoom_y;
    z->width = width;
    z->height = height;
    z->top_first = top_first;
    z->t_at[0] = turned ? 1.0f : 0.0f;
    z->t_at[1] = turned ? 0.0f : 1.0f;
    z->covered = coverage(sx, sy, fb->width, fb->height);
    z->a = sy[1] - sy[0];
    z->b = sx[0] - sx[1];
    z->c = z->a * sx[0] - z->b * sy[1] + (z->a < 0.0 || (z->a == 0.0 && z->b < 0.0) ? 1.0 : 0.0);

    /* OSMesa rule: a clockwise triangle's first two vertices are exchanged, and coordinates are anchored at
     * the first. */
    const float ooa = 1.0f / ((x1 - x0) * (y0 - y1));
    z->sx = (y0 - y1) * ooa;
    z->ty = turned ? (x1 - x0) * ooa : -((x1 - x0) * ooa);
    const bool exchanged = (zoom_x > 0.0f) == (zoom_y > 0.0f);
    z->s0 = exchanged ? 1.0f - z->sx * (x1 - 0.5f) : 0.0f - z->sx * (x0 - 0.5f);
    z->t0[0] = z->t_at[1] - z->ty * (y1 - 0.5f);
    z->t0[1] = exchanged ? z->t_at[0] - z->ty * (y0 - 0.5f) : z->t0[0];
}

static int texel(float coordinate, int size)
{
    const float at = coordinate * (float)size;
    return at > 0.0f ? fgl_min((int)at, size - 1) : 0;
}

int fgl_zoom_texel_column(const struct zoom *z, float s)
{
    return texel(s, z->width);
}

int fgl_zoom_texel_row(const struct zoom *z, float t)
{
    const int row = texel(t, z->height);
    return z->top_first ? z->height - 1 - row : row;
}

int fgl_zoom_column(const struct zoom *z, int x)
{
    return fgl_zoom_texel_column(z, fgl_fma(z->sx, (float)x, z->s0));
}

int fgl_zoom_row(const struct zoom *z, int y, int triangle)
{
    return fgl_zoom_texel_row(z, fgl_fma(z->ty, (float)y, z->t0[triangle]));
}

bool fgl_zoom_in_first(const struct zoom *z, int x, int y)
{
    return z->c - 256.0 * z->a * x + 256.0 * z->b * y > 0.0;
}
