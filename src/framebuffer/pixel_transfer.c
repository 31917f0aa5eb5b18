#include "framebuffer/pixel_transfer.h"

const struct pixel_mode_state fgl_no_transfer = {.scale = {1, 1, 1, 1}, .depth_scale = 1};

bool fgl_transfer_color_active(const struct pixel_mode_state *mode)
{
    bool active = mode->map_color;
    for (int c = 0; c < 4; c++)
        active |= mode->scale[c] != 1.0f || mode->bias[c] != 0.0f;
    return active;
}

/* The entry that a colour component selects: scaled to the map's size and rounded to nearest (3.6.5 "RGBA to
 * RGBA Lookup"). */
static float map_component(const struct pixel_map *map, float v)
{
    return map->value[(int)(fgl_clamp01(v) * (float)(map->size - 1) + 0.5f)];
}

void fgl_transfer_color(const struct pixel_mode_state *mode, const struct pixel_map *maps,
                        struct color_row *row, int n)
{
    for (int c = 0; c < 4; c++) {
        float *v = row->channel[c];
        const float scale = mode->scale[c], bias = mode->bias[c];
        for (int i = 0; i < n; i++)
            v[i] = v[i] * scale + bias;
        for (int i = 0; mode->map_color && i < n; i++)
            v[i] = map_component(&maps[PIXEL_MAP_R_TO_R + c], v[i]);
    }
}

bool fgl_transfer_stencil_active(const struct pixel_mode_state *mode)
{
    return mode->index_shift || mode->index_offset || mode->map_stencil;
}

bool fgl_transfer_depth_active(const struct pixel_mode_state *mode)
{
    return mode->depth_scale != 1.0f || mode->depth_bias != 0.0f;
}

void fgl_transfer_depth(const struct pixel_mode_state *mode, float *depth, int n)
{
    const float scale = mode->depth_scale, bias = mode->depth_bias; /* read once: depth could be their memory */
    for (int i = 0; i < n; i++)
        depth[i] = depth[i] * scale + bias;
    for (int i = 0; i < n; i++) {
        const float above = depth[i] > 0.0f ? depth[i] : 0.0f; /* NaN -> 0 */
        depth[i] = above < 1.0f ? above : 1.0f;
    }
}

/* 3.6.5 "Arithmetic on Components": shifted left, or right when the shift is negative. */
static int32_t shift_index(int32_t index, int shift)
{
    if (shift <= -32 || shift >= 32)
        return 0;
    return (int32_t)(shift < 0 ? (uint32_t)index >> -shift : (uint32_t)index << shift);
}

/* The index is rounded already. */
static int32_t map_index(const struct pixel_map *map, int32_t index)
{
    return fgl_index_of(map->value[index & (map->size - 1)]);
}

void fgl_transfer_index(const struct pixel_mode_state *mode, const struct pixel_map *maps, bool stencil,
                        int32_t *index, int n)
{
    for (int i = 0; (mode->index_shift || mode->index_offset) && i < n; i++)
        index[i] =
                (int32_t)((uint32_t)shift_index(index[i], mode->index_shift) + (uint32_t)mode->index_offset);
    for (int i = 0; stencil && mode->map_stencil && i < n; i++)
        index[i] = map_index(&maps[PIXEL_MAP_S_TO_S], index[i]);
}

void fgl_transfer_color_index(const struct pixel_mode_state *mode, const struct pixel_map *maps, int32_t *index,
                              int n)
{
    for (int i = 0; mode->map_color && i < n; i++)
        index[i] = map_index(&maps[PIXEL_MAP_I_TO_I], index[i]);
}

void fgl_transfer_index_to_color(const struct pixel_map *maps, const int32_t *index, struct color_row *row,
                                 int n)
{
    for (int c = 0; c < 4; c++) {
        const struct pixel_map *map = &maps[PIXEL_MAP_I_TO_R + c];
        for (int i = 0; i < n; i++)
            row->channel[c][i] = map->value[index[i] & (map->size - 1)];
    }
}
