/* Why a pixel has its colour: the record behind fixedglExplain (include/fixedgl.h). Layer 4.
 *
 * While a pixel is armed each draw is assembled twice: first with the rasterizer's bounds narrowed to that
 * pixel, one primitive after the other, noting what each does to it (explain_probe.c); then, the pixel put
 * back as it was, as always. Both must end in the same bytes, or `agrees` becomes false. Every value here
 * comes from the kernels that draw: a vertex's terms from fgl_vertex_trace, a fragment's stages from the
 * general fragment kernel run with one stage more each time, weights from the rasterizer's own interpolation
 * of (1,0,0), (0,1,0), (0,0,1). There is no second copy of an equation. */
#ifndef FGL_PIPELINE_EXPLAIN_H
#define FGL_PIPELINE_EXPLAIN_H

#include "pipeline/pipeline.h"
#include "pipeline/text.h"

enum { EXPLAIN_EVENTS = 64, EXPLAIN_WARNINGS = 16, EXPLAIN_WARNING_LENGTH = 240 };

/* What became of a fragment at the pixel, or what else changed it. */
enum explain_outcome {
    OUTCOME_DRAWN,
    OUTCOME_ALPHA, /* failed the test */
    OUTCOME_STENCIL,
    OUTCOME_DEPTH,
    OUTCOME_MASKED, /* passed all tests, but no channel may be written */
    OUTCOME_CLEARED,
    OUTCOME_OTHER /* changed by something that is not a draw: pixel rectangles, bitmaps, accumulation */
};

/* The pixel in the framebuffer. */
struct pixel_value {
    double color[4]; /* as stored: 0..255, 0..65535, 0..31 and 0..63, or floats */
    uint32_t depth;
    uint8_t stencil;
};

/* The colour of a fragment after each stage; stages that are off repeat the one before. Neither rounded nor
 * clamped. In colour index mode the first component is the index; after fog and coverage it is rounded. */
struct fragment_stages {
    bool covered; /* false: a stipple or the disc of a point left the pixel out */
    int textures; /* units that draw a texture */
    struct explained_texture {
        struct texture_trace trace;
        float result[4]; /* of its environment */
    } texture[FGL_MAX_TEXTURE_UNITS];
    float interpolated[4], summed[4], fogged[4], smoothed[4];
    float fog_factor;
    uint32_t depth;
    enum explain_outcome outcome;
};

struct explain_event {
    enum explain_outcome outcome;
    struct pixel_value before, after;
    /* the rest for fragments of primitives only */
    int draw;         /* counted from 1 since the pixel's colour was cleared last */
    const char *call; /* "glBegin", "glCallList", "glDrawArrays", "glDrawElements" */
    GLenum mode;
    int prim;   /* which glBegin of the draw, from 0 */
    int number; /* which triangle, quad, line, ... of that, from 0 */
    struct fragment_stages fragment;
};

struct explain_vertex {
    int number;     /* in its primitive, from 0 */
    uint32_t index; /* the array element, or the same */
    double weight;  /* perspective-correct; the weights' sum is 1 */
    float object[4], normal[3], given_color[4];
    float clip[4], window[3];     /* window y up */
    float material[MAT_COUNT][4]; /* of the face that is seen */
    float color[4], secondary[4]; /* of that face, clamped */
    struct vertex_trace trace;
};

/* Everything about the primitive that wrote the pixel last. */
struct explain_detail {
    struct vertex_plan vertex_plan;
    struct fragment_plan fragment_plan; /* .fb is not to be used */
    struct explain_event event;
    bool flat, two_sided, is_clipped;
    bool front; /* the face that is seen; points and lines: the front */
    int n;      /* vertices; the last is the provoking one */
    struct explain_vertex vertex[3];
    bool lit;                 /* GL_PHONG_WIN: not the vertices, but the pixel was lit, */
    struct explain_vertex at; /* with these materials, coordinates and terms; .trace.normal has unit length */
    int warnings;
    char warning[EXPLAIN_WARNINGS][EXPLAIN_WARNING_LENGTH];
};

/* A framebuffer of one row, which any window row falls on. */
struct scratch {
    struct framebuffer fb;
    int room;     /* pixels */
    bool indexed; /* colour index mode */
};

struct explain {
    int x, y;          /* window, y up, as glReadPixels */
    int width, height; /* of the framebuffer when last looked at */
    int draws;
    int events; /* all since the last clear; the first EXPLAIN_EVENTS - 1 of them and the last are kept */
    struct explain_event event[EXPLAIN_EVENTS];
    struct pixel_value value; /* after the last event */
    bool seen;                /* value is valid */
    bool agrees;
    bool has_detail;
    struct explain_detail detail;
    struct scratch scratch;
    struct text text;
    const char *out; /* FIXEDGL_EXPLAIN_OUT or NULL */
    int out_vertex;
};

/* Arms window pixel x, y, or disarms with x < 0. False when memory is short. */
bool fgl_explain_start(struct pipeline *p, int x, int y);
void fgl_explain_stop(struct pipeline *p);
/* FIXEDGL_EXPLAIN=x,y[,vertex] arms the first context of the process. */
void fgl_explain_from_environment(struct pipeline *p);

/* A glClear of the pixels in r was done. */
void fgl_explain_clear(struct context *ctx, GLbitfield mask, struct rect r);
/* Looks at the pixel for changes made by other commands. False when it lies outside of the framebuffer. */
bool fgl_explain_look(struct context *ctx);
/* Writes the explanation to FIXEDGL_EXPLAIN_OUT, if that is set: JSON when the name ends so, else text. */
void fgl_explain_write(struct context *ctx);

/* The last event of all that wrote colour, cleared or changed the pixel; NULL when there is none. */
const struct explain_event *fgl_explain_last(const struct explain *e);

/* A new event at the end; when there are too many the last one kept gives way. */
struct explain_event *fgl_explain_add(struct explain *e, enum explain_outcome outcome);

/* explain_probe.c: draws, with the vertices in the cache, and notes what happens at the pixel. */
void fgl_explain_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims,
                      int n, const uint32_t *elements, uint32_t base);

/* explain_elements.c: the cache with its n vertices in the order of the elements, so that a vertex's number there is its number
 * in the draw. False when memory is short; *to is to be freed in either case. */
bool fgl_explain_gather(const struct pipeline *p, struct vertex_cache *to, const uint32_t *elements, int n, uint32_t base);
void fgl_explain_free_gathered(struct vertex_cache *c);

/* explain_fragment.c */
struct pixel_value fgl_explain_pixel(const struct framebuffer *fb, int row, int x);
void fgl_explain_put_pixel(const struct framebuffer *fb, int row, int x, const struct pixel_value *v);
bool fgl_explain_same(const struct pixel_value *a, const struct pixel_value *b);
bool fgl_explain_scratch(struct scratch *s, const struct framebuffer *fb);
/* The stages of the fragment of these planes at the pixel; fb is plan->fb, only looked at. */
void fgl_explain_stages(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes,
                        int row, int x, struct fragment_stages *stages);
/* COLOR_LIT: the terms of the fragment itself. Its normal has unit length. */
void fgl_explain_lit(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes, int row, int x,
                     struct vertex_trace *trace);
/* The smooth colour that the planes have at the pixel, whatever the plan does with it. */
void fgl_explain_color(struct scratch *s, const struct fragment_plan *plan, const struct planes *planes,
                       int row, int x, float color[4]);

/* explain_vertex.c: fills the vertices of *d, given their indexes, the plan's copies, and which face is seen.
 */
void fgl_explain_vertices(struct context *ctx, const struct vertex_source *source, struct explain_detail *d);
/* The terms of a vertex made of the primitive's, weighted: as if the pixel itself were lit. b: to work in. */
void fgl_explain_middle(struct vertex_batch *b, const struct vertex_source *source,
                        const struct explain_detail *d, struct vertex_trace *trace);

/* explain_warnings.c: what a teacher would say. */
void fgl_explain_warn(struct context *ctx, const struct vertex_source *source, struct explain_detail *d);

/* explain_text.c, explain_json.c: into e->text. vertex: 0..2, or -1 for all. */
void fgl_explain_text(struct explain *e, const struct framebuffer *fb, int vertex);
void fgl_explain_json(struct explain *e, const struct framebuffer *fb, int vertex);
/* explain_text_fragment.c, for explain_text.c */
void fgl_explain_text_pixel(struct text *t, const struct pixel_value *v, const struct framebuffer *fb);
void fgl_explain_text_fragment(struct text *t, const struct explain_detail *d, const struct framebuffer *fb);
const char *fgl_explain_outcome_name(enum explain_outcome outcome);
const char *fgl_explain_mode_name(GLenum mode);

#endif
