/* Makes scripts from seeds. */
#ifndef FUZZ_GENERATOR_H
#define FUZZ_GENERATOR_H

#include "script.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <stdint.h>

enum feature {
#define FEATURE(name, kind, weight, command) FEATURE_##name,
#include "features.def"
    FEATURES
};

enum feature_kind { STATE, DRAW, QUERY, INSIDE };

struct generator;
struct feature_info {
    const char *name;
    enum feature_kind kind;
    int weight;
    enum command needs;
    void (*emit)(struct generator *g);
};
extern const struct feature_info features[FEATURES];

/* What object coordinates are. */
enum space { CLIP_SPACE, PIXEL_SPACE, EYE_SPACE };

struct generator {
    struct script *script;
    uint64_t random;        /* state of the random numbers */
    bool selected[FEATURES]; /* may be used in any script */
    bool enabled[FEATURES]; /* and in this one, now */
    bool used[FEATURES];    /* was used in this script */
    enum space space;
    double grid; /* coordinates are multiples of this; 0: of nothing */
    /* One size in a script: OSMesa keeps the alpha of a Color4 through a later Color3, when the same happened before in its
     * batch of vertices. A Color3 of anything but floats counts as Color4. */
    int color_size, tex_coord_size;
    /* Lights are plain, neither attenuated nor spots, or no shininess is 0; and lit vertices have w = 1. Else OSMesa is wrong. */
    bool plain_lights, without_shininess;
    double largest_shininess; /* 128 with normals of length 1, else OSMesa's powers overflow (departure overflowing-power) */
    /* Of materials that belong to vertices: one in a script. OSMesa gives back faces part of the front material where vertices have
     * both, one by itself (departure back-color-material). */
    double face_of_vertices;
    int depth;   /* of lists and stacks within each other */
    bool compiling, executing; /* a list is compiled, and executed */
    bool inside;               /* Begin/End */
    bool contained;  /* positions well within the volume, as long as matrices and planes leave it alone */
    bool drawing_elsewhere;           /* into a framebuffer object, or in the other context */
    bool other_begun;                 /* the other context has been current */
    enum space other_space;           /* and what its object coordinates are */
    bool levels_set; /* the base or the maximum level of some texture */
    bool querying;   /* between BeginQuery and EndQuery */
    bool pushed;     /* between PushAttrib and PopAttrib */
    bool edge_flags; /* may be set for the vertices of this primitive */
    /* All attributes of this primitive's vertices are given with the first. OSMesa loses a line of a loop if two attributes join
     * its vertices at one place, and goes wrong in several ways if one does while a list is compiled. */
    bool steady;
    unsigned vertex_lists, lists; /* lists 1... contain vertices only; FIRST_LIST... anything */
    bool arrays_set;              /* all vertex arrays that are enabled have ARRAY_VERTICES elements */
};

enum { ARRAY_VERTICES = 16, LIST_OF_ARRAYS = 50, FIRST_LIST = 100, MAX_DEPTH = 3 };

/* The script of a seed, with the features of g->selected; g->used tells which it has. */
void generate(struct generator *g, struct script *script, uint64_t seed);

/* ---- for the features ---- */

int below(struct generator *g, int n);          /* 0 ... n - 1 */
bool chance(struct generator *g, int percent);
double real(struct generator *g, double low, double high); /* a float, sometimes a round number */
int integer(struct generator *g, int low, int high);       /* both included */
double one_of(struct generator *g, int count, const double *values);
#define ONE_OF(g, ...) one_of(g, COUNT_OF(__VA_ARGS__), (const double[]){__VA_ARGS__})
#define COUNT_OF(...) ((int)(sizeof((const double[]){__VA_ARGS__}) / sizeof(double)))

/* Appends glName(values); a vector's values come last, with EMIT or, if computed, with emit_vector. */
#define EMIT(g, name, ...) script_add((g)->script, CMD_##name, COUNT_OF(__VA_ARGS__), (const double[]){__VA_ARGS__})
#define EMIT0(g, name) script_add((g)->script, CMD_##name, 0, NULL)

bool use(struct generator *g, enum feature feature); /* whether it may be used; if so, counts it */
/* Enable, with that percentage, or Disable. */
void toggle(struct generator *g, unsigned cap, int percent);
void random_state(struct generator *g); /* one random feature of STATE */
void random_draw(struct generator *g);  /* one of DRAW or QUERY */
void random_color(struct generator *g, double color[4]);
void random_normal(struct generator *g, double normal[3]);
void random_position(struct generator *g, double position[4]); /* object coordinates */
/* Nothing outside Begin/End while a list is compiled: OSMesa prefers them to later ones inside, after the list. */
void emit_color(struct generator *g);
void emit_normal(struct generator *g);
void emit_vertex(struct generator *g);
/* What comes first in every context. */
void begin_context(struct generator *g);
int random_mode(struct generator *g);
void emit_unseen_point(struct generator *g);
/* After a change of the shade model, where lines or points may be smooth: an unseen point. Once something has been clipped while they are, OSMesa draws what
 * comes first after the change in the old shade model (departure smooth-with-fill). */
void settle_shade_model(struct generator *g);
/* A number of vertices near the one given that a primitive of this mode may have. */
int vertex_count(struct generator *g, int mode, int count);
/* Whether a unit beyond the first may texture: then OSMesa draws pixel rectangles with the smallest mipmap (departure textured-pixels). */
bool textured_later(const struct generator *g);
/* Before a bitmap: OSMesa does not add the raster position's secondary color (departure raster-secondary-color). */
void emit_no_color_sum(struct generator *g);
/* Random vertex arrays of ARRAY_VERTICES elements; a mode that can be drawn from them, with stippled lines not as strips (see random_mode: here
 * the vertices are there already); a draw; and an end of each array, with that percentage. */
void emit_arrays(struct generator *g);
int array_mode(struct generator *g);
void emit_draw_arrays(struct generator *g);
void disable_arrays(struct generator *g, int percent);
/* Vertices without Begin and End. */
void emit_vertices(struct generator *g, int count);

#define FEATURE(name, kind, weight, command) void feature_##name(struct generator *g);
#include "features.def"

#endif
