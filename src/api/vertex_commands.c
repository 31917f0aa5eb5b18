/* glVertex, glNormal, glColor, glSecondaryColor, glFogCoord, glIndex, glTexCoord, glMultiTexCoord, glEdgeFlag and glRect in all their forms (GL 1.5, 2.7 "Vertex Specification", 2.10
 * "Rectangles"): conversions of table 2.9 in OSMesa's arithmetic, then the vertex store. They may be called inside and outside Begin/End. */
#include "api/convert.h"
#include "api/errors.h"
#include "api/framebuffer_object.h"
#include "api/immediate.h"
#include "api/list.h"

static inline float plain_f(GLfloat c) { return c; }
static inline float plain_d(GLdouble c) { return (float)c; }
static inline float plain_i(GLint c) { return (float)c; }
static inline float plain_s(GLshort c) { return (float)c; }
static inline float plain_ub(GLubyte c) { return (float)c; }

static FGL_NOINLINE void uncommon_vertex(struct context *ctx, int size, float x, float y, float z, float w)
{
    fgl_vertex(ctx, size, (const float[4]){x, y, z, w});
}

static FGL_NOINLINE void uncommon_attribute(struct context *ctx, enum fgl_attr attr, int size, float x, float y, float z, float w)
{
    fgl_attr_set(ctx, attr, size, (const float[4]){x, y, z, w});
}

/* The common case of fgl_vertex: the format has a position of this size. Attributes are copied one by one, as they were written
 * just before: a processor would wait for a load of several until they are all in its cache. `volatile` keeps compilers from joining them. */
static FGL_ALWAYS_INLINE void vertex(const int size, float x, float y, float z, float w)
{
    struct context *ctx = fgl_current;
    if (FGL_UNLIKELY(!ctx))
        return;
    struct immediate *im = ctx->vertices;
    if (FGL_UNLIKELY(im->format.size[ATTR_POSITION] != size || im->mode > GL_POLYGON || im->count + 1 >= im->max_count)) {
        uncommon_vertex(ctx, size, x, y, z, w);
        return;
    }
    float *to = im->next;
    const volatile float *attribute = im->vertex, *const end = attribute + im->format.before_position;
    while (attribute < end)
        *to++ = *attribute++;
    *to++ = x;
    *to++ = y;
    if (size > 2)
        *to++ = z;
    if (size > 3)
        *to++ = w;
    im->next = to;
    im->count++;
}

/* The common case of fgl_attr_set. */
static FGL_ALWAYS_INLINE void attribute(enum fgl_attr attr, const int size, float x, float y, float z, float w)
{
    struct context *ctx = fgl_current;
    if (FGL_UNLIKELY(!ctx))
        return;
    struct immediate *im = ctx->vertices;
    if (FGL_UNLIKELY(im->format.size[attr] != size || im->mode > GL_POLYGON)) {
        uncommon_attribute(ctx, attr, size, x, y, z, w);
        return;
    }
    float *to = im->vertex + im->format.offset[attr];
    to[0] = x;
    if (size > 1)
        to[1] = y;
    if (size > 2)
        to[2] = z;
    if (size > 3)
        to[3] = w;
}

#define VERTEX(T, s, f)                                                                                      \
    void GLAPIENTRY glVertex2##s(T x, T y) { vertex(2, f(x), f(y), 0, 1); }                                  \
    void GLAPIENTRY glVertex3##s(T x, T y, T z) { vertex(3, f(x), f(y), f(z), 1); }                          \
    void GLAPIENTRY glVertex4##s(T x, T y, T z, T w) { vertex(4, f(x), f(y), f(z), f(w)); }                  \
    void GLAPIENTRY glVertex2##s##v(const T *v) { vertex(2, f(v[0]), f(v[1]), 0, 1); }                       \
    void GLAPIENTRY glVertex3##s##v(const T *v) { vertex(3, f(v[0]), f(v[1]), f(v[2]), 1); }                 \
    void GLAPIENTRY glVertex4##s##v(const T *v) { vertex(4, f(v[0]), f(v[1]), f(v[2]), f(v[3])); }
VERTEX(GLfloat, f, plain_f)
VERTEX(GLdouble, d, plain_d)
VERTEX(GLint, i, plain_i)
VERTEX(GLshort, s, plain_s)

#define NORMAL(T, s, f)                                                                                      \
    void GLAPIENTRY glNormal3##s(T x, T y, T z) { attribute(ATTR_NORMAL, 3, f(x), f(y), f(z), 1); }          \
    void GLAPIENTRY glNormal3##s##v(const T *v) { attribute(ATTR_NORMAL, 3, f(v[0]), f(v[1]), f(v[2]), 1); }
NORMAL(GLbyte, b, fgl_norm_b)
NORMAL(GLshort, s, fgl_norm_s)
NORMAL(GLint, i, fgl_norm_i)
NORMAL(GLfloat, f, plain_f)
NORMAL(GLdouble, d, plain_d)

/* OSMesa rule: of three components only floats stay three; others are made four, which can add alpha to the vertex format. */
#define COLOR(T, s, f, three)                                                                                \
    void GLAPIENTRY glColor3##s(T r, T g, T b) { attribute(ATTR_COLOR, three, f(r), f(g), f(b), 1); }        \
    void GLAPIENTRY glColor4##s(T r, T g, T b, T a) { attribute(ATTR_COLOR, 4, f(r), f(g), f(b), f(a)); }    \
    void GLAPIENTRY glColor3##s##v(const T *v) { attribute(ATTR_COLOR, three, f(v[0]), f(v[1]), f(v[2]), 1); } \
    void GLAPIENTRY glColor4##s##v(const T *v) { attribute(ATTR_COLOR, 4, f(v[0]), f(v[1]), f(v[2]), f(v[3])); }
COLOR(GLbyte, b, fgl_norm_b, 4)
COLOR(GLshort, s, fgl_norm_s, 4)
COLOR(GLint, i, fgl_norm_i, 4)
COLOR(GLubyte, ub, fgl_norm_ub, 4)
COLOR(GLushort, us, fgl_norm_us, 4)
COLOR(GLuint, ui, fgl_norm_ui, 4)
COLOR(GLfloat, f, plain_f, 3)
COLOR(GLdouble, d, plain_d, 4)

#define SECONDARY(T, s, f, ext)                                                                              \
    void GLAPIENTRY glSecondaryColor3##s##ext(T r, T g, T b) { attribute(ATTR_SECONDARY_COLOR, 3, f(r), f(g), f(b), 1); } \
    void GLAPIENTRY glSecondaryColor3##s##v##ext(const T *v) { attribute(ATTR_SECONDARY_COLOR, 3, f(v[0]), f(v[1]), f(v[2]), 1); }
#define SECONDARY_COLOR(T, s, f) SECONDARY(T, s, f, ) SECONDARY(T, s, f, EXT)
SECONDARY_COLOR(GLbyte, b, fgl_norm_b)
SECONDARY_COLOR(GLshort, s, fgl_norm_s)
SECONDARY_COLOR(GLint, i, fgl_norm_i)
SECONDARY_COLOR(GLubyte, ub, fgl_norm_ub)
SECONDARY_COLOR(GLushort, us, fgl_norm_us)
SECONDARY_COLOR(GLuint, ui, fgl_norm_ui)
SECONDARY_COLOR(GLfloat, f, plain_f)
SECONDARY_COLOR(GLdouble, d, plain_d)

#define FOGCOORD(T, s, f, ext)                                                                               \
    void GLAPIENTRY glFogCoord##s##ext(T c) { attribute(ATTR_FOG_COORD, 1, f(c), 0, 0, 1); }                 \
    void GLAPIENTRY glFogCoord##s##v##ext(const T *c) { attribute(ATTR_FOG_COORD, 1, f(*c), 0, 0, 1); }
FOGCOORD(GLfloat, f, plain_f, )
FOGCOORD(GLdouble, d, plain_d, )
FOGCOORD(GLfloat, f, plain_f, EXT)
FOGCOORD(GLdouble, d, plain_d, EXT)

#define INDEX(T, s, f)                                                                                       \
    void GLAPIENTRY glIndex##s(T c) { attribute(ATTR_INDEX, 1, f(c), 0, 0, 1); }                             \
    void GLAPIENTRY glIndex##s##v(const T *c) { attribute(ATTR_INDEX, 1, f(*c), 0, 0, 1); }
INDEX(GLfloat, f, plain_f)
INDEX(GLdouble, d, plain_d)
INDEX(GLint, i, plain_i)
INDEX(GLshort, s, plain_s)
INDEX(GLubyte, ub, plain_ub)

void GLAPIENTRY glEdgeFlag(GLboolean flag) { attribute(ATTR_EDGE_FLAG, 1, flag ? 1.0f : 0.0f, 0, 0, 1); }
void GLAPIENTRY glEdgeFlagv(const GLboolean *flag) { glEdgeFlag(*flag); }

#define TEXCOORD(T, s, f)                                                                                    \
    void GLAPIENTRY glTexCoord1##s(T u) { attribute(ATTR_TEX0, 1, f(u), 0, 0, 1); }                          \
    void GLAPIENTRY glTexCoord2##s(T u, T v) { attribute(ATTR_TEX0, 2, f(u), f(v), 0, 1); }                  \
    void GLAPIENTRY glTexCoord3##s(T u, T v, T r) { attribute(ATTR_TEX0, 3, f(u), f(v), f(r), 1); }          \
    void GLAPIENTRY glTexCoord4##s(T u, T v, T r, T q) { attribute(ATTR_TEX0, 4, f(u), f(v), f(r), f(q)); }  \
    void GLAPIENTRY glTexCoord1##s##v(const T *v) { attribute(ATTR_TEX0, 1, f(v[0]), 0, 0, 1); }             \
    void GLAPIENTRY glTexCoord2##s##v(const T *v) { attribute(ATTR_TEX0, 2, f(v[0]), f(v[1]), 0, 1); }       \
    void GLAPIENTRY glTexCoord3##s##v(const T *v) { attribute(ATTR_TEX0, 3, f(v[0]), f(v[1]), f(v[2]), 1); } \
    void GLAPIENTRY glTexCoord4##s##v(const T *v) { attribute(ATTR_TEX0, 4, f(v[0]), f(v[1]), f(v[2]), f(v[3])); }
TEXCOORD(GLfloat, f, plain_f)
TEXCOORD(GLdouble, d, plain_d)
TEXCOORD(GLint, i, plain_i)
TEXCOORD(GLshort, s, plain_s)

/* GL 1.5, 2.7: what another target would do is not defined. */
static FGL_ALWAYS_INLINE void texcoord(GLenum target, const int size, float s, float t, float r, float q)
{
    attribute((enum fgl_attr)(ATTR_TEX0 + (target - GL_TEXTURE0) % FGL_MAX_TEXTURE_UNITS), size, s, t, r, q);
}

#define MULTI(T, s, f, arb)                                                                                  \
    void GLAPIENTRY glMultiTexCoord1##s##arb(GLenum target, T u) { texcoord(target, 1, f(u), 0, 0, 1); }     \
    void GLAPIENTRY glMultiTexCoord2##s##arb(GLenum target, T u, T v) { texcoord(target, 2, f(u), f(v), 0, 1); } \
    void GLAPIENTRY glMultiTexCoord3##s##arb(GLenum target, T u, T v, T r)                                   \
    {                                                                                                        \
        texcoord(target, 3, f(u), f(v), f(r), 1);                                                            \
    }                                                                                                        \
    void GLAPIENTRY glMultiTexCoord4##s##arb(GLenum target, T u, T v, T r, T q)                              \
    {                                                                                                        \
        texcoord(target, 4, f(u), f(v), f(r), f(q));                                                         \
    }                                                                                                        \
    void GLAPIENTRY glMultiTexCoord1##s##v##arb(GLenum target, const T *v) { texcoord(target, 1, f(v[0]), 0, 0, 1); } \
    void GLAPIENTRY glMultiTexCoord2##s##v##arb(GLenum target, const T *v) { texcoord(target, 2, f(v[0]), f(v[1]), 0, 1); } \
    void GLAPIENTRY glMultiTexCoord3##s##v##arb(GLenum target, const T *v)                                   \
    {                                                                                                        \
        texcoord(target, 3, f(v[0]), f(v[1]), f(v[2]), 1);                                                   \
    }                                                                                                        \
    void GLAPIENTRY glMultiTexCoord4##s##v##arb(GLenum target, const T *v)                                   \
    {                                                                                                        \
        texcoord(target, 4, f(v[0]), f(v[1]), f(v[2]), f(v[3]));                                             \
    }
#define MULTITEXCOORD(T, s, f) MULTI(T, s, f, ) MULTI(T, s, f, ARB)
MULTITEXCOORD(GLfloat, f, plain_f)
MULTITEXCOORD(GLdouble, d, plain_d)
MULTITEXCOORD(GLint, i, plain_i)
MULTITEXCOORD(GLshort, s, plain_s)

/* GL 1.5, 2.10: a polygon of four vertices, counter-clockwise when the second corner is right of and above the first. */
static void rect(float x1, float y1, float x2, float y2)
{
    struct context *ctx = fgl_current;
    if (!ctx)
        return;
    if (fgl_refused_inside(ctx) || (!ctx->vertices->compiling && !fgl_draw_ready(ctx)))
        return;
    fgl_begin(ctx, GL_QUADS);
    const float corner[4][2] = {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}};
    for (int i = 0; i < 4; i++)
        fgl_vertex(ctx, 2, corner[i]);
    fgl_end(ctx);
}

#define RECT(T, s, f)                                                                                        \
    void GLAPIENTRY glRect##s(T x1, T y1, T x2, T y2) { rect(f(x1), f(y1), f(x2), f(y2)); }                  \
    void GLAPIENTRY glRect##s##v(const T *v1, const T *v2) { rect(f(v1[0]), f(v1[1]), f(v2[0]), f(v2[1])); }
RECT(GLfloat, f, plain_f)
RECT(GLdouble, d, plain_d)
RECT(GLint, i, plain_i)
RECT(GLshort, s, plain_s)
