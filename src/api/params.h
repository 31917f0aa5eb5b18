/* The parameters that glLight, glLightModel, glMaterial, glFog, glPointParameter, glTexParameter and glTexEnv take by name. One table (param_table.def)
 * says what each holds, so that the f, i, fv, iv and glGet forms cannot disagree. */
#ifndef FGL_API_PARAMS_H
#define FGL_API_PARAMS_H

#include "state/context.h"

enum param_kind {
    PARAM_FLOAT,
    PARAM_COLOR, /* float; integers are mapped linearly to [-1,1] */
    PARAM_BOOL,
    PARAM_INT,
    PARAM_ENUM
};

struct param {
    GLenum pname;
    enum param_kind kind;
    int count;      /* components */
    float min, max; /* of the first component; outside: GL_INVALID_VALUE */
    size_t offset;  /* in the struct that the table says; 0 for materials, which are attributes */
};

/* The row of a pname, or NULL if the command does not accept it. */
const struct param *fgl_light_param(GLenum pname);
const struct param *fgl_light_model_param(GLenum pname);
const struct param *fgl_fog_param(GLenum pname);
const struct param *fgl_point_param(GLenum pname);
const struct param *fgl_material_param(GLenum pname);
const struct param *fgl_texture_param(GLenum pname);
const struct param *fgl_texture_env_param(GLenum pname);

/* True if v is in the range that the row allows. */
bool fgl_param_allows(const struct param *p, const float *v);

/* Stores a checked value in its object (see offset). */
void fgl_param_set(struct context *ctx, unsigned dirty, const struct param *p, void *object, const float *v);

/* The same with colours clamped to [0,1], as those of textures are (GL 1.5, 3.8.4, 3.8.13). */
void fgl_param_set_clamped(struct context *ctx, unsigned dirty, const struct param *p, void *object, const float *v);

/* The row's pname if it has a single value, which the scalar forms take; else, and for NULL, GL_NONE, which none takes. */
GLenum fgl_param_scalar(const struct param *p);

/* The value in its object. */
void fgl_param_get(const struct param *p, const void *object, float *v);

/* What an integer form was given, as floats; nothing is read for p == NULL. */
void fgl_param_from_ints(const struct param *p, const GLint *in, float out[4]);
void fgl_param_to_ints(const struct param *p, const float *in, GLint *out);

#endif
