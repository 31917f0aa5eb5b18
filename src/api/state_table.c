/* The rows of state_table.def. See state_table.h. */
#include "api/state_table.h"

#include "api/buffer.h"
#include "api/framebuffer_object.h"
#include "api/list.h"
#include "base/color_index.h"
#include "fixedgl.h"
#include "framebuffer/framebuffer.h"
#include "texture/texture.h"

/* ---- values that are not simply a field ---- */

static void copy_matrix(const struct matrix_stack *stack, double *v)
{
    for (int i = 0; i < 16; i++)
        v[i] = (double)stack->entry[stack->top].m[i];
}

static void modelview_matrix(const struct context *ctx, double *v)
{
    copy_matrix(&ctx->modelview, v);
}
static void projection_matrix(const struct context *ctx, double *v)
{
    copy_matrix(&ctx->projection, v);
}
static void texture_matrix(const struct context *ctx, double *v)
{
    copy_matrix(&ctx->texture_matrix[ctx->s.texture.active_texture], v);
}

static void color_matrix(const struct context *ctx, double *v)
{
    copy_matrix(&ctx->color_matrix, v);
}

/* The hint that asks for the arithmetic in use. */
static void lighting_accuracy_hint(const struct context *ctx, double *v)
{
    v[0] = ctx->accuracy == FIXEDGL_EXACT ? GL_NICEST : GL_DONT_CARE;
}

static void modelview_depth(const struct context *ctx, double *v)
{
    *v = ctx->modelview.top + 1;
}
static void projection_depth(const struct context *ctx, double *v)
{
    *v = ctx->projection.top + 1;
}
static void texture_depth(const struct context *ctx, double *v)
{
    *v = ctx->texture_matrix[ctx->s.texture.active_texture].top + 1;
}

static void color_matrix_depth(const struct context *ctx, double *v)
{
    *v = ctx->color_matrix.top + 1;
}

static void active_texture(const struct context *ctx, double *v)
{
    *v = GL_TEXTURE0 + ctx->s.texture.active_texture;
}
static void client_active_texture(const struct context *ctx, double *v)
{
    *v = GL_TEXTURE0 + ctx->client.arrays.client_active_texture;
}

static double texture_binding(const struct context *ctx, enum texture_target target)
{
    return ctx->s.texture.unit[ctx->s.texture.active_texture].bound[target]->name;
}
static void texture_binding_1d(const struct context *ctx, double *v)
{
    *v = texture_binding(ctx, TEXTURE_1D);
}
static void texture_binding_2d(const struct context *ctx, double *v)
{
    *v = texture_binding(ctx, TEXTURE_2D);
}
static void texture_binding_rectangle(const struct context *ctx, double *v)
{
    *v = texture_binding(ctx, TEXTURE_RECTANGLE);
}
static void sampler_binding(const struct context *ctx, double *v)
{
    const struct sampler_object *sampler = ctx->s.texture.unit[ctx->s.texture.active_texture].sampler;
    *v = sampler ? sampler->name : 0;
}
static void texture_binding_3d(const struct context *ctx, double *v)
{
    *v = texture_binding(ctx, TEXTURE_3D);
}
static void texture_binding_cube_map(const struct context *ctx, double *v)
{
    *v = texture_binding(ctx, TEXTURE_CUBE_MAP);
}

static void array_buffer_binding(const struct context *ctx, double *v)
{
    *v = fgl_buffer_name(ctx->client.arrays.array_buffer);
}
static void element_array_buffer_binding(const struct context *ctx, double *v)
{
    *v = fgl_buffer_name(ctx->client.arrays.element_array_buffer);
}

static void pixel_pack_buffer_binding(const struct context *ctx, double *v)
{
    *v = fgl_buffer_name(ctx->client.pack.buffer);
}
static void pixel_unpack_buffer_binding(const struct context *ctx, double *v)
{
    *v = fgl_buffer_name(ctx->client.unpack.buffer);
}

#define ARRAY_BUFFER(name, attr)                                                                             \
    static void name##_buffer(const struct context *ctx, double *v)                                          \
    {                                                                                                        \
        *v = fgl_buffer_name(ctx->client.arrays.array[attr].buffer);                                         \
    }
ARRAY_BUFFER(vertex, ATTR_POSITION)
ARRAY_BUFFER(normal, ATTR_NORMAL)
ARRAY_BUFFER(color, ATTR_COLOR)
ARRAY_BUFFER(secondary_color, ATTR_SECONDARY_COLOR)
ARRAY_BUFFER(fog_coord, ATTR_FOG_COORD)
ARRAY_BUFFER(index, ATTR_INDEX)
ARRAY_BUFFER(edge_flag, ATTR_EDGE_FLAG)
ARRAY_BUFFER(texture_coord, ATTR_TEX0 + ctx->client.arrays.client_active_texture)
#undef ARRAY_BUFFER

static void transpose(double *v)
{
    for (int c = 0; c < 4; c++)
        for (int r = 0; r < c; r++) {
            const double t = v[4 * c + r];
            v[4 * c + r] = v[4 * r + c];
            v[4 * r + c] = t;
        }
}

static void transpose_modelview_matrix(const struct context *ctx, double *v)
{
    modelview_matrix(ctx, v);
    transpose(v);
}
static void transpose_projection_matrix(const struct context *ctx, double *v)
{
    projection_matrix(ctx, v);
    transpose(v);
}
static void transpose_texture_matrix(const struct context *ctx, double *v)
{
    texture_matrix(ctx, v);
    transpose(v);
}

static void transpose_color_matrix(const struct context *ctx, double *v)
{
    color_matrix(ctx, v);
    transpose(v);
}

static void list_index(const struct context *ctx, double *v)
{
    *v = fgl_list_index(ctx);
}

static void red_bits(const struct context *ctx, double *v)
{
    *v = fgl_framebuffer_color_bits(ctx, 0);
}

static void green_bits(const struct context *ctx, double *v)
{
    *v = fgl_framebuffer_color_bits(ctx, 1);
}

static void blue_bits(const struct context *ctx, double *v)
{
    *v = fgl_framebuffer_color_bits(ctx, 2);
}

static void alpha_bits(const struct context *ctx, double *v)
{
    *v = fgl_framebuffer_color_bits(ctx, 3);
}

static void draw_framebuffer_binding(const struct context *ctx, double *v)
{
    *v = ctx->framebuffers ? ctx->framebuffers->draw->name : 0;
}

static void read_framebuffer_binding(const struct context *ctx, double *v)
{
    *v = ctx->framebuffers ? ctx->framebuffers->read->name : 0;
}

static void renderbuffer_binding(const struct context *ctx, double *v)
{
    *v = ctx->framebuffers && ctx->framebuffers->renderbuffer ? ctx->framebuffers->renderbuffer->name : 0;
}

static void rgba_mode(const struct context *ctx, double *v)
{
    *v = !ctx->color_index;
}

static void index_mode(const struct context *ctx, double *v)
{
    *v = ctx->color_index;
}

static void index_bits(const struct context *ctx, double *v)
{
    *v = ctx->color_index ? FGL_INDEX_BITS : 0;
}

static void depth_bits(const struct context *ctx, double *v)
{
    *v = ctx->framebuffer ? ctx->framebuffer->depth_bits : 0;
}
static void stencil_bits(const struct context *ctx, double *v)
{
    *v = ctx->framebuffer ? ctx->framebuffer->stencil_bits : 0;
}
static void accum_bits(const struct context *ctx, double *v)
{
    *v = ctx->framebuffer ? ctx->framebuffer->accum_bits : 0;
}

/* GL 1.5, 4.1.5 "Stencil Test": clamped to what the stencil buffer holds. */
static void stencil_ref(const struct context *ctx, double *v)
{
    const int bits = ctx->framebuffer ? ctx->framebuffer->stencil_bits : 0;
    *v = fgl_clamp(ctx->s.stencil.stencil_ref, 0, (1 << bits) - 1);
}

/* ---- the rows ---- */

enum {
#define CAP(name, ...) ROW_##name,
#define CAP_BIT(name, ...) ROW_##name,
#define UNIT_CAP(name, ...) ROW_##name,
#define UNIT_CAP_BIT(name, ...) ROW_##name,
#define ARRAY(name, ...) ROW_##name,
#define VALUE(name, ...) ROW_##name,
#define UNIT_VALUE(name, ...) ROW_##name,
#define CLIENT_UNIT_VALUE(name, ...) ROW_##name,
#define CLIENT_UNIT_ARRAY(name, ...) ROW_##name,
#define LIMIT(name, ...) ROW_##name,
#define FLOAT_LIMIT(name, ...) ROW_##name,
#define COMPUTED(name, ...) ROW_##name,
#define FLOAT_COMPUTED(name, ...) ROW_##name,
#include "api/state_table.def"
    ROW_COUNT
};

#define AT(field) .offset = offsetof(struct context, field)

static const struct state_row rows[ROW_COUNT] = {
#define CAP(name, dirty_bit, field) {.kind = STATE_BOOL, .count = 1, .dirty = (dirty_bit), AT(field)},
#define CAP_BIT(name, dirty_bit, bit_number, field)                                                          \
    {.kind = STATE_BIT, .count = 1, .bit = (bit_number), .dirty = (dirty_bit), AT(field)},
#define UNIT_CAP(name, dirty_bit, field)                                                                     \
    {.kind = STATE_BOOL,                                                                                     \
     .count = 1,                                                                                             \
     .dirty = (dirty_bit),                                                                                   \
     .unit = UNIT_SERVER,                                                                                    \
     .step = sizeof(struct texture_unit),                                                                    \
     AT(s.texture.unit[0].field)},
#define UNIT_CAP_BIT(name, dirty_bit, bit_number, field)                                                     \
    {.kind = STATE_BIT,                                                                                      \
     .count = 1,                                                                                             \
     .bit = (bit_number),                                                                                    \
     .dirty = (dirty_bit),                                                                                   \
     .unit = UNIT_SERVER,                                                                                    \
     .step = sizeof(struct texture_unit),                                                                    \
     AT(s.texture.unit[0].field)},
#define ARRAY(name, attr) {.kind = STATE_ARRAY, .count = 1, AT(client.arrays.array[attr].enabled)},
#define VALUE(name, value_kind, n, field) {.kind = STATE_##value_kind, .count = (n), AT(field)},
#define UNIT_VALUE(name, value_kind, n, field, bytes)                                                        \
    {.kind = STATE_##value_kind, .count = (n), .unit = UNIT_SERVER, .step = (bytes), AT(field)},
#define CLIENT_UNIT_VALUE(name, value_kind, n, field, bytes)                                                 \
    {.kind = STATE_##value_kind, .count = (n), .unit = UNIT_CLIENT, .step = (bytes), AT(field)},
#define CLIENT_UNIT_ARRAY(name, attr)                                                                        \
    {.kind = STATE_ARRAY,                                                                                    \
     .count = 1,                                                                                             \
     .unit = UNIT_CLIENT,                                                                                    \
     .step = sizeof(struct vertex_array),                                                                    \
     AT(client.arrays.array[attr].enabled)},
#define LIMIT(name, n, v0, v1) {.kind = STATE_LIMIT, .count = (n), .limit = {(v0), (v1)}},
#define FLOAT_LIMIT(name, n, v0, v1) {.kind = STATE_FLOAT_LIMIT, .count = (n), .limit = {(v0), (v1)}},
#define COMPUTED(name, n, function) {.kind = STATE_COMPUTED, .count = (n), .read = function},
#define FLOAT_COMPUTED(name, n, function) {.kind = STATE_FLOAT_COMPUTED, .count = (n), .read = function},
#include "api/state_table.def"
};

const struct state_row *fgl_state_row(GLenum name)
{
    switch (name) {
/* clang-format off */
#define CAP(name, ...) case name: return &rows[ROW_##name];
#define CAP_BIT(name, ...) case name: return &rows[ROW_##name];
#define UNIT_CAP(name, ...) case name: return &rows[ROW_##name];
#define UNIT_CAP_BIT(name, ...) case name: return &rows[ROW_##name];
#define ARRAY(name, ...) case name: return &rows[ROW_##name];
#define VALUE(name, ...) case name: return &rows[ROW_##name];
#define UNIT_VALUE(name, ...) case name: return &rows[ROW_##name];
#define CLIENT_UNIT_VALUE(name, ...) case name: return &rows[ROW_##name];
#define CLIENT_UNIT_ARRAY(name, ...) case name: return &rows[ROW_##name];
#define LIMIT(name, ...) case name: return &rows[ROW_##name];
#define FLOAT_LIMIT(name, ...) case name: return &rows[ROW_##name];
#define COMPUTED(name, ...) case name: return &rows[ROW_##name];
#define FLOAT_COMPUTED(name, ...) case name: return &rows[ROW_##name];
#include "api/state_table.def"
    /* clang-format on */
    default: return NULL;
    }
}

const struct state_row *fgl_state_row_at(int i)
{
    return i < ROW_COUNT ? &rows[i] : NULL;
}

static bool read_flag(const struct state_row *row, const char *field)
{
    if (row->kind == STATE_BIT)
        return *(const unsigned *)(const void *)field >> row->bit & 1;
    return *(const bool *)(const void *)field;
}

static size_t field_offset(const struct state_row *row, const struct context *ctx)
{
    const int unit = row->unit == UNIT_SERVER   ? ctx->s.texture.active_texture
                     : row->unit == UNIT_CLIENT ? ctx->client.arrays.client_active_texture
                                                : 0;
    return row->offset + (size_t)unit * row->step;
}

const void *fgl_state_field(const struct state_row *row, const struct context *ctx)
{
    return (const char *)ctx + field_offset(row, ctx);
}

bool fgl_state_get_flag(const struct state_row *row, const struct context *ctx)
{
    return read_flag(row, fgl_state_field(row, ctx));
}

bool fgl_state_saved_flag(const struct state_row *row, const struct server_state *saved,
                          const struct context *ctx)
{
    return read_flag(row, (const char *)saved + (field_offset(row, ctx) - offsetof(struct context, s)));
}

void fgl_state_put_flag(const struct state_row *row, struct context *ctx, bool on)
{
    char *field = (char *)ctx + field_offset(row, ctx);

    if (row->kind != STATE_BIT) {
        *(bool *)(void *)field = on;
        return;
    }
    unsigned *bits = (unsigned *)(void *)field;
    *bits = (*bits & ~(1u << row->bit)) | (unsigned)on << row->bit;
}
