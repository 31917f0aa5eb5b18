/* The state that can be queried by name: rows made from state_table.def. */
#ifndef FGL_API_STATE_TABLE_H
#define FGL_API_STATE_TABLE_H

#include "state/context.h"

/* What a row's field is, and how it converts (GL 1.5, 6.1.2 "Data Conversions"). */
enum state_kind {
    STATE_BOOL,
    STATE_BIT,   /* a bit of an unsigned field; its number is the row's `bit` */
    STATE_ARRAY, /* whether a vertex array is enabled */
    STATE_INT,   /* also enumerants */
    STATE_MASK,  /* unsigned */
    STATE_USHORT,
    STATE_FLOAT,   /* to integers by rounding */
    STATE_UNIT,    /* float, normalised: 1.0 is the largest integer */
    STATE_CLAMPED, /* the same, clamped to [0,1] when read */
    STATE_UNIT_DOUBLE,
    STATE_LIMIT, /* constants */
    STATE_FLOAT_LIMIT,
    STATE_COMPUTED, /* by a function, integers */
    STATE_FLOAT_COMPUTED
};

/* Which unit's value is meant: there is one, that of glActiveTexture, that of glClientActiveTexture. */
enum state_unit { UNIT_NONE, UNIT_SERVER, UNIT_CLIENT };

enum { STATE_MAX_VALUES = 16 };

struct state_row {
    enum state_kind kind;
    int count; /* values */
    int bit;
    unsigned dirty; /* what glEnable marks; 0: not for glEnable */
    size_t offset;  /* of the field in struct context; of unit 0's where there is one for each texture unit */
    enum state_unit unit;
    size_t step; /* from a unit's field to the next */
    float limit[2];
    void (*read)(const struct context *ctx, double *v);
};

/* gl.h names six clip planes. */
enum { CLIP_PLANE6 = GL_CLIP_PLANE5 + 1, CLIP_PLANE7 };

/* The row of a name, or NULL. */
const struct state_row *fgl_state_row(GLenum name);

/* Where a row's value lies now. Not for limits and computed values. */
const void *fgl_state_field(const struct state_row *row, const struct context *ctx);

/* The rows, from 0, for walking through them; NULL after the last. */
const struct state_row *fgl_state_row_at(int i);

/* The boolean of a row that glEnable or glIsEnabled accepts. */
bool fgl_state_get_flag(const struct state_row *row, const struct context *ctx);
/* The same as pushed; glEnable's only. */
bool fgl_state_saved_flag(const struct state_row *row, const struct server_state *saved,
                          const struct context *ctx);
void fgl_state_put_flag(const struct state_row *row, struct context *ctx, bool on);

#endif
