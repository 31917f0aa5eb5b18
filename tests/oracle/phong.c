/*
 * GL_WIN_phong_shading and GL_APPLE_specular_vector against the equation (GL 1.5, 2.14.1), evaluated here in double at every
 * fragment of a triangle: normals and eye coordinates interpolated with perspective, the normal scaled to unit length.
 * Written from the specification; shares nothing with the library. compatible: within 1 of 255; exact: rounded correctly.
 * Random scenes; the seed is printed and may be given as the argument.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <GL/osmesa.h>
#include <fixedgl.h>
#include <math.h>

enum { SIZE = 64, SCENES = 150, LIGHTS = 3 };

static unsigned char picture[SIZE][SIZE][4]; /* bottom row first */
static uint64_t seed = 1;

/* ---- random scenes ---- */

static double uniform(double low, double high) /* a float */
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(float)(low + (high - low) * (double)(seed >> 40) / 0x1p24);
}

static bool chance(double p)
{
    return uniform(0, 1) < p;
}

static void fill(double *v, int n, double low, double high)
{
    for (int i = 0; i < n; i++)
        v[i] = uniform(low, high);
}

struct test_light {
    double position[4], color[3][4], spot_direction[3], spot_exponent, cutoff, k[3];
};

struct test_material {
    double color[4][4]; /* ambient, diffuse, specular, emission */
    double shininess;
};

struct test_vertex {
    double object[3], normal[3], color[4], specular[4];
    double eye[3], eye_normal[3], window[2], w;
};

struct scene {
    bool local_viewer, two_side, separate, reflection, color_material, vary_specular, fog, texture;
    int lights;
    struct test_light light[LIGHTS];
    struct test_material material[2];
    double scene_ambient[4], fog_color[4], modelview[16], projection[16];
    struct test_vertex vertex[3];
};

static const unsigned char texel[3] = {128, 64, 255};

static void make_light(struct test_light *l)
{
    fill(l->position, 3, -4, 4);
    l->position[2] = uniform(-2, 4);
    l->position[3] = chance(0.5) ? 0 : 1;
    for (int c = 0; c < 3; c++)
        fill(l->color[c], 4, 0, 0.6);
    fill(l->spot_direction, 2, -0.5, 0.5);
    l->spot_direction[2] = -1;
    l->spot_exponent = uniform(0, 30);
    l->cutoff = l->position[3] != 0 && chance(0.4) ? uniform(10, 80) : 180;
    l->k[0] = 1;
    fill(l->k + 1, 2, 0, chance(0.5) ? 0.1 : 0);
}

static void make_matrices(struct scene *s)
{
    const double a = uniform(0, 6), scale = uniform(0.5, 2), c = cos(a), d = sin(a);
    const double m[16] = {c, d, 0, 0, -d, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const double p[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.5, -1, 0, 0, -4, 0};
    for (int i = 0; i < 16; i++) {
        s->modelview[i] = (double)(float)(m[i] * (i < 12 ? scale : 1));
        s->projection[i] = p[i];
    }
    s->modelview[14] = uniform(-5, -3);
}

static void make_scene(struct scene *s)
{
    bool *flag[] = {&s->local_viewer,   &s->two_side,      &s->separate, &s->reflection,
                    &s->color_material, &s->vary_specular, &s->fog,      &s->texture};
    for (size_t i = 0; i < sizeof flag / sizeof *flag; i++)
        *flag[i] = chance(0.5);
    s->lights = 1 + (int)uniform(0, LIGHTS - 0.01);
    for (int i = 0; i < LIGHTS; i++)
        make_light(&s->light[i]);
    for (int face = 0; face < 2; face++) {
        for (int c = 0; c < 4; c++)
            fill(s->material[face].color[c], 4, 0, c == 3 ? 0.2 : 1);
        s->material[face].shininess = uniform(1, 128);
    }
    fill(s->scene_ambient, 4, 0, 0.3);
    fill(s->fog_color, 4, 0, 1);
    make_matrices(s);
    for (int i = 0; i < 3; i++) {
        static const double corner[3][2] = {{-1, -1}, {1, -0.8}, {0.1, 1}};
        struct test_vertex *v = &s->vertex[i];
        v->object[0] = corner[i][0];
        v->object[1] = corner[i][1];
        v->object[2] = uniform(-0.5, 0.5);
        fill(v->normal, 2, -0.7, 0.7);
        v->normal[2] = uniform(0.3, 1.5);
        fill(v->color, 4, 0, 1);
        fill(v->specular, 4, 0, 1);
    }
    if (chance(0.5)) { /* the other way round */
        const struct test_vertex v = s->vertex[0];
        s->vertex[0] = s->vertex[1];
        s->vertex[1] = v;
    }
}

/* ---- drawn by the library ---- */

static void floats(const double *v, float to[16], int n)
{
    for (int i = 0; i < n; i++)
        to[i] = (float)v[i];
}

static void set_light(GLenum name, const struct test_light *l)
{
    static const GLenum color[3] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR};
    float v[16];
    glEnable(name);
    floats(l->position, v, 4);
    glLightfv(name, GL_POSITION, v); /* the modelview matrix is the identity */
    floats(l->spot_direction, v, 3);
    glLightfv(name, GL_SPOT_DIRECTION, v);
    for (int c = 0; c < 3; c++) {
        floats(l->color[c], v, 4);
        glLightfv(name, color[c], v);
    }
    glLightf(name, GL_SPOT_EXPONENT, (float)l->spot_exponent);
    glLightf(name, GL_SPOT_CUTOFF, (float)l->cutoff);
    glLightf(name, GL_CONSTANT_ATTENUATION, (float)l->k[0]);
    glLightf(name, GL_LINEAR_ATTENUATION, (float)l->k[1]);
    glLightf(name, GL_QUADRATIC_ATTENUATION, (float)l->k[2]);
}

static void set_material(GLenum face, const struct test_material *m)
{
    static const GLenum color[4] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    float v[16];
    for (int c = 0; c < 4; c++) {
        floats(m->color[c], v, 4);
        glMaterialfv(face, color[c], v);
    }
    glMaterialf(face, GL_SHININESS, (float)m->shininess);
}

static void set_texture(void)
{
    glEnable(GL_TEXTURE_2D);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
}

static void set_state(const struct scene *s)
{
    float v[16];
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_LIGHTING);
    for (int i = 0; i < s->lights; i++)
        set_light(GL_LIGHT0 + (GLenum)i, &s->light[i]);
    floats(s->scene_ambient, v, 4);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, s->local_viewer);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, s->two_side);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, s->separate ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, s->reflection);
    set_material(GL_FRONT, &s->material[0]);
    set_material(GL_BACK, &s->material[1]);
    if (s->color_material)
        glEnable(GL_COLOR_MATERIAL); /* ambient and diffuse of both faces */
    if (s->fog) {
        glEnable(GL_FOG);
        glFogi(GL_FOG_MODE, GL_LINEAR);
        glFogf(GL_FOG_START, 1);
        glFogf(GL_FOG_END, 9);
        floats(s->fog_color, v, 4);
        glFogfv(GL_FOG_COLOR, v);
    }
    if (s->texture)
        set_texture();
}

static void give_vertex(const struct scene *s, const struct test_vertex *v)
{
    float f[16];
    floats(v->color, f, 4);
    glColor4fv(f);
    floats(v->specular, f, 4);
    if (s->vary_specular)
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, f);
    floats(v->normal, f, 3);
    glNormal3fv(f);
    floats(v->object, f, 3);
    glVertex3fv(f);
}

static void draw(const struct scene *s, GLenum mode, int vertices)
{
    float m[16];
    set_state(s);
    glMatrixMode(GL_PROJECTION);
    floats(s->projection, m, 16);
    glLoadMatrixf(m);
    glMatrixMode(GL_MODELVIEW);
    floats(s->modelview, m, 16);
    glLoadMatrixf(m);
    glBegin(mode);
    for (int i = 0; i < vertices; i++)
        give_vertex(s, &s->vertex[i]);
    glEnd();
    glFinish();
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* ---- the equation ---- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit(double v[3])
{
    const double length = sqrt(dot(v, v));
    for (int c = 0; c < 3; c++)
        v[c] /= length;
}

/* Eye space and window. The modelview matrix is a rotation about z and a scale: the inverse's transpose is it over scale squared. */
static void transform(const struct scene *s, struct test_vertex *v)
{
    const double *m = s->modelview, *p = s->projection;
    const double determinant = m[0] * m[5] - m[1] * m[4];
    for (int r = 0; r < 3; r++)
        v->eye[r] = m[r] * v->object[0] + m[4 + r] * v->object[1] + m[8 + r] * v->object[2] + m[12 + r];
    v->eye_normal[0] = (m[5] * v->normal[0] - m[1] * v->normal[1]) / determinant;
    v->eye_normal[1] = (m[0] * v->normal[1] - m[4] * v->normal[0]) / determinant;
    v->eye_normal[2] = v->normal[2] / m[10];
    v->w = -v->eye[2];
    for (int c = 0; c < 2; c++)
        v->window[c] = (p[5 * c] * v->eye[c] / v->w + 1) * SIZE / 2;
}

/* A fragment's data, the equation's result, and whether it is so near to a jump of the equation that it proves nothing. */
struct test_fragment {
    double eye[3], normal[3], color[4], specular[4];
    double sum[3], specular_sum[3];
    bool at_jump;
};

/* The power's base: n . h, or r . p with GL_APPLE_specular_vector. */
static double highlight_base(const struct scene *s, const struct test_fragment *f, const double n[3], const double VP[3])
{
    double p[3] = {0, 0, 1}, h[3], r[3];
    for (int c = 0; c < 3 && s->local_viewer; c++)
        p[c] = -f->eye[c];
    unit(p);
    for (int c = 0; c < 3; c++) {
        h[c] = VP[c] + p[c];
        r[c] = 2 * dot(n, VP) * n[c] - VP[c];
    }
    unit(h);
    return s->reflection ? dot(r, p) : dot(n, h);
}

static void add_light(const struct scene *s, const struct test_light *l, const struct test_material *m, const double n[3],
                      struct test_fragment *f)
{
    double VP[3], factor = 1;
    for (int c = 0; c < 3; c++)
        VP[c] = l->position[c] - (l->position[3] != 0 ? f->eye[c] : 0);
    const double d = sqrt(dot(VP, VP));
    unit(VP);
    if (l->position[3] != 0)
        factor = 1 / (l->k[0] + l->k[1] * d + l->k[2] * d * d);
    if (l->cutoff != 180) {
        double axis[3] = {l->spot_direction[0], l->spot_direction[1], l->spot_direction[2]};
        unit(axis);
        const double cosine = -dot(VP, axis), edge = cos(l->cutoff * acos(-1) / 180);
        f->at_jump |= fabs(cosine - edge) < 2e-6;
        factor *= cosine >= edge ? pow(cosine, l->spot_exponent) : 0;
    }
    const double diffuse = dot(n, VP), base = highlight_base(s, f, n, VP);
    const double highlight = diffuse > 0 && base > 0 ? pow(base, m->shininess) : 0;
    f->at_jump |= fabs(diffuse) < 2e-6;
    for (int c = 0; c < 3; c++) {
        const double ambient = s->color_material ? f->color[c] : m->color[0][c];
        const double reflected = s->color_material ? f->color[c] : m->color[1][c];
        const double specular = s->vary_specular ? f->specular[c] : m->color[2][c];
        f->sum[c] += factor * (l->color[0][c] * ambient + fmax(diffuse, 0) * l->color[1][c] * reflected);
        f->specular_sum[c] += factor * highlight * l->color[2][c] * specular;
    }
}

static double clamp01(double x)
{
    return fmin(fmax(x, 0), 1);
}

/* From the interpolated data to the colour that is written. OSMesa rule: but in exact mode, the colour sum is not clamped before
 * fog. */
static void shade(const struct scene *s, bool back, bool exact, struct test_fragment *f, double color[4])
{
    const int face = s->two_side && back;
    const struct test_material *m = &s->material[face];
    double n[3] = {f->normal[0], f->normal[1], f->normal[2]};
    for (int c = 0; c < 3 && face; c++)
        n[c] = -n[c];
    for (int c = 0; c < 3; c++) {
        f->sum[c] = m->color[3][c] + s->scene_ambient[c] * (s->color_material ? f->color[c] : m->color[0][c]);
        f->specular_sum[c] = 0;
    }
    for (int i = 0; i < s->lights; i++)
        add_light(s, &s->light[i], m, n, f);
    for (int c = 0; c < 3; c++) {
        color[c] = clamp01(f->sum[c] + (s->separate ? 0 : f->specular_sum[c]));
        if (s->texture)
            color[c] *= texel[c] / 255.0;
        if (s->separate)
            color[c] = color[c] + clamp01(f->specular_sum[c]);
        if (exact)
            color[c] = clamp01(color[c]);
        if (s->fog) {
            const double keep = clamp01((9 + f->eye[2]) / 8);
            color[c] = keep * color[c] + (1 - keep) * s->fog_color[c];
        }
    }
    color[3] = clamp01(s->color_material ? f->color[3] : m->color[1][3]);
}

/* The fragment at window x, y, data of the vertices weighted with perspective; false near and outside of the edges. */
static bool interpolate(const struct scene *s, double x, double y, struct test_fragment *f, bool *back)
{
    const struct test_vertex *v = s->vertex;
    const double area = (v[1].window[0] - v[0].window[0]) * (v[2].window[1] - v[0].window[1]) -
                        (v[2].window[0] - v[0].window[0]) * (v[1].window[1] - v[0].window[1]);
    double weight[3], total = 0;
    memset(f, 0, sizeof *f);
    *back = area < 0;
    for (int i = 0; i < 3; i++) {
        const double *a = v[(i + 1) % 3].window, *b = v[(i + 2) % 3].window;
        const double share = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
        if (share < 0.01)
            return false;
        total += weight[i] = share / v[i].w;
    }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 4; c++) {
            if (c < 3) {
                f->eye[c] += weight[i] / total * v[i].eye[c];
                f->normal[c] += weight[i] / total * v[i].eye_normal[c];
            }
            f->color[c] += weight[i] / total * v[i].color[c];
            f->specular[c] += weight[i] / total * v[i].specular[c];
        }
    unit(f->normal);
    return true;
}

/* ---- comparing ---- */

struct score {
    int compared, differ, wrong;
    double worst; /* distance from the truth, in 255ths */
};

static void compare(const double color[4], const unsigned char drawn[4], bool exact, struct score *score)
{
    for (int c = 0; c < 4; c++) {
        const double truth = clamp01(color[c]) * 255;
        if (fabs(truth - floor(truth) - 0.5) < 1e-7)
            continue;
        const int nearest = (int)floor(truth + 0.5), off = abs(drawn[c] - nearest);
        score->compared++;
        score->differ += off != 0;
        score->wrong += off > (exact ? 0 : 1);
        score->worst = fmax(score->worst, fabs(drawn[c] - truth));
    }
}

static void compare_triangle(struct scene *s, bool exact, struct score *score)
{
    for (int i = 0; i < 3; i++)
        transform(s, &s->vertex[i]);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            struct test_fragment f;
            double color[4];
            bool back;
            if (!interpolate(s, x + 0.5, y + 0.5, &f, &back))
                continue;
            shade(s, back, exact, &f, color);
            if (!f.at_jump)
                compare(color, picture[y][x], exact, score);
        }
}

static OSMesaContext begin(int accuracy, GLenum shade_model)
{
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    assert_true(context && OSMesaMakeCurrent(context, picture, GL_UNSIGNED_BYTE, SIZE, SIZE));
    fixedglAccuracy(accuracy);
    glShadeModel(shade_model);
    return context;
}

static void report(const char *what, const struct score *score)
{
    print_message("%s: %d values, %d differ from the rounded truth, at worst %.3f of 255 off\n", what, score->compared,
                  score->differ, score->worst);
    assert_true(score->compared > 1000);
    assert_int_equal(score->wrong, 0);
}

static void triangles(int accuracy, const char *what)
{
    struct score score = {0};
    for (int i = 0; i < SCENES; i++) {
        struct scene s;
        OSMesaContext context = begin(accuracy, GL_PHONG_WIN);
        make_scene(&s);
        draw(&s, GL_TRIANGLES, 3);
        compare_triangle(&s, accuracy == FIXEDGL_EXACT, &score);
        OSMesaDestroyContext(context);
    }
    report(what, &score);
}

static void every_fragment_compatible(void **state)
{
    (void)state;
    triangles(FIXEDGL_COMPATIBLE, "compatible");
}

static void every_fragment_exact(void **state)
{
    (void)state;
    triangles(FIXEDGL_EXACT, "exact");
}

/* A vertex, lit as such: a point that covers the picture. */
static void vertices(int accuracy, const char *what)
{
    struct score score = {0};
    for (int i = 0; i < 4 * SCENES; i++) {
        struct scene s;
        struct test_fragment f;
        double color[4];
        OSMesaContext context = begin(accuracy, GL_SMOOTH);
        make_scene(&s);
        s.reflection = true;
        s.fog = false;
        memset(&f, 0, sizeof f);
        s.vertex[0].object[0] = s.vertex[0].object[1] = 0;
        glPointSize(SIZE);
        glEnable(GL_NORMALIZE);
        draw(&s, GL_POINTS, 1);
        transform(&s, &s.vertex[0]);
        memcpy(f.eye, s.vertex[0].eye, sizeof f.eye);
        memcpy(f.normal, s.vertex[0].eye_normal, sizeof f.normal);
        memcpy(f.color, s.vertex[0].color, sizeof f.color);
        memcpy(f.specular, s.vertex[0].specular, sizeof f.specular);
        unit(f.normal);
        shade(&s, false, true, &f, color); /* without fog */
        if (!f.at_jump)
            compare(color, picture[SIZE / 2][SIZE / 2], accuracy == FIXEDGL_EXACT, &score);
        OSMesaDestroyContext(context);
    }
    report(what, &score);
}

static void specular_vector(void **state)
{
    (void)state;
    vertices(FIXEDGL_COMPATIBLE, "specular vector at vertices, compatible");
    vertices(FIXEDGL_EXACT, "specular vector at vertices, exact");
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
            cmocka_unit_test(every_fragment_compatible),
            cmocka_unit_test(every_fragment_exact),
            cmocka_unit_test(specular_vector),
    };
    if (argc > 1)
        seed = strtoull(argv[1], NULL, 10);
    print_message("seed %llu\n", (unsigned long long)seed);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
