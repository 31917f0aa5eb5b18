/* Lighting against Mesa's OSMesa: random set-ups of lights, materials, matrices and vertices, drawn by both
 * into float buffers, give the same bits in every pixel.
 *
 * Left out, because OSMesa is wrong there (docs/departures.md): powers that overflow, so transformed normals
 * are not longer than 1; and back faces whose material differs by vertex otherwise than the front's, where it
 * reads past its constants. */
#include "both.h"

struct setup {
    bool plain; /* nothing that needs eye coordinates: docs/departures.md, homogeneous-vertices and shininess-0 */
    GLenum color_material_face;
    bool two_sided, color_inside, normal_inside, material_inside;
    float position_w;
};

static void random_color(float c[4], float brightest)
{
    for (int i = 0; i < 4; i++)
        c[i] = one_of(6) ? between(0.01f, brightest) : brightest;
}

/* A modelview matrix of some class; scales shorten normals. Commands before and after others make flags
 * stick. */
static void matrix_commands(const struct gl *gl)
{
    float m[16];

    for (int k = one_of(5); k > 0; k--)
        switch (one_of(6)) {
        case 0: gl->LoadIdentity(); break;
        case 1:
            gl->Rotatef(between(-180, 180), between(-1, 1), one_of(2) ? between(-1, 1) : 0,
                        one_of(2) ? between(-1, 1) : 0);
            break;
        case 2: gl->Translatef(between(-1, 1), between(-1, 1), between(-1, 1)); break;
        case 3: gl->Scalef(1.25f, 1.25f, 1.25f); break;
        case 4: gl->Scalef(between(1, 1.5f), between(1, 1.5f), between(1, 1.5f)); break;
        default:
            for (int i = 0; i < 16; i++)
                m[i] = i % 5 == 0                ? (i == 15 ? 1 : between(1, 1.5f))
                       : i % 4 == 3 || one_of(2) ? 0
                                                 : between(-0.3f, 0.3f);
            (one_of(2) ? gl->LoadMatrixf : gl->MultMatrixf)(m);
            break;
        }
}

static void set_light(const struct gl *gl, GLenum light, bool plain, float brightest)
{
    const float w = plain || !one_of(3) ? 0 : one_of(3) ? 1 : between(-2, 2);
    const float position[4] = {between(-4, 4), between(-4, 4), between(-4, 4), w};
    const float direction[3] = {between(-1, 1), between(-1, 1), between(-1, 1)};
    static const float black[4] = {0, 0, 0, 1};
    float color[4];

    random_color(color, brightest * 0.3f);
    gl->Lightfv(light, GL_AMBIENT, one_of(3) ? color : black);
    random_color(color, brightest);
    gl->Lightfv(light, GL_DIFFUSE, one_of(8) ? color : black);
    random_color(color, brightest);
    gl->Lightfv(light, GL_SPECULAR, one_of(5) ? color : black);
    gl->Lightfv(light, GL_POSITION, position);
    gl->Lightfv(light, GL_SPOT_DIRECTION, direction);
    gl->Lightf(light, GL_SPOT_CUTOFF,
               plain || one_of(2) ? 180
               : one_of(3)        ? between(30, 90)
                                  : (float)(30 * one_of(4)));
    gl->Lightf(light, GL_SPOT_EXPONENT, one_of(3) ? between(0, 20) : one_of(2) ? 0 : between(20, 128));
    gl->Lightf(light, GL_CONSTANT_ATTENUATION, one_of(2) ? 1 : between(0.2f, 1.5f));
    gl->Lightf(light, GL_LINEAR_ATTENUATION, one_of(2) ? 0 : between(0, 0.4f));
    gl->Lightf(light, GL_QUADRATIC_ATTENUATION, one_of(2) ? 0 : between(0, 0.1f));
    gl->Enable(light);
}

static void set_lights(const struct gl *gl, struct setup *s)
{
    const int n = one_of(10) == 0 ? 0 : one_of(4) ? 1 + one_of(3) : 1 + one_of(8);
    const bool plain = s->plain = !one_of(3);
    float ambient[4];

    random_color(ambient, 0.2f);
    gl->LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    gl->LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, !plain && one_of(2));
    gl->LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                    plain || one_of(4) ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR);
    s->two_sided = one_of(2);
    gl->LightModeli(GL_LIGHT_MODEL_TWO_SIDE, s->two_sided);
    for (int i = 0; i < n; i++) {
        set_light(gl, GL_LIGHT0 + (GLenum)i, plain, n > 3 ? 0.3f : 0.6f);
        if (!one_of(3))
            matrix_commands(gl);
    }
    if (n > 2 && one_of(2))
        gl->Disable(GL_LIGHT1);
}

static void set_material(const struct gl *gl, struct setup *s)
{
    static const GLenum face[2] = {GL_FRONT, GL_BACK};
    static const GLenum parameter[5] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                        GL_AMBIENT_AND_DIFFUSE};
    const bool dull = s->plain && !one_of(4); /* every shininess 0 */
    float color[4];

    for (int f = 0; f < 2; f++) {
        for (int p = 0; p < 4; p++) {
            random_color(color, p == 3 ? 0.1f : 1);
            gl->Materialfv(face[f], parameter[p], color);
        }
        gl->Materialf(face[f], GL_SHININESS,
                      dull        ? 0
                      : one_of(4) ? between(1, 128)
                                  : (float)(64 * (1 + one_of(2))));
    }
    s->color_material_face = one_of(3) ? 0 : s->two_sided || one_of(2) ? GL_FRONT_AND_BACK : GL_FRONT;
    if (s->color_material_face) {
        gl->ColorMaterial(s->color_material_face, parameter[one_of(5)]);
        gl->Enable(GL_COLOR_MATERIAL);
    }
}

static void draw_vertices(const struct gl *gl, const struct setup *s)
{
    float color[4], normal[3], position[4], length;

    gl->Begin(GL_TRIANGLES);
    for (int i = 0; i < 60; i++) {
        do {
            for (int c = 0; c < 3; c++)
                normal[c] = between(-1, 1);
            length = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        } while (length > 1);
        random_color(color, 1);
        if (s->color_inside)
            gl->Color4fv(color);
        if (s->normal_inside)
            gl->Normal3fv(normal);
        if (s->material_inside && one_of(2)) {
            gl->Materialfv(GL_FRONT_AND_BACK, one_of(2) ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE, color);
            gl->Materialf(GL_FRONT_AND_BACK, GL_SHININESS, between(1, 100));
        }
        for (int c = 0; c < 3; c++)
            position[c] = between(-3, 3);
        position[3] = s->position_w == 1 ? 1 : between(0.5f, 2);
        gl->Vertex4fv(position);
    }
    gl->End();
}

static void draw(struct gl *gl, int set)
{
    struct setup s;
    float color[4];
    static const float normal[3] = {0.36f, -0.48f, 0.8f};

    random_seed(set);
    begin_context(gl);
    gl->ClearColor(0.25f, 0.5f, 0.75f, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_LIGHTING);
    gl->ShadeModel(one_of(3) ? GL_SMOOTH : GL_FLAT);
    gl->MatrixMode(GL_PROJECTION);
    if (one_of(2))
        gl->Ortho(-4, 4, -4, 4, -8, 8);
    else
        gl->Frustum(-0.5, 0.5, -0.5, 0.5, 1, 20);
    gl->MatrixMode(GL_MODELVIEW);
    matrix_commands(gl);
    set_lights(gl, &s);
    set_material(gl, &s);
    gl->PushMatrix();
    matrix_commands(gl);
    switch (one_of(3)) {
    case 0: gl->Enable(GL_NORMALIZE); break;
    case 1: gl->Enable(GL_RESCALE_NORMAL); break;
    default: break;
    }
    s.color_inside = one_of(2);
    s.normal_inside = one_of(8);
    s.material_inside = !one_of(4) && !s.two_sided;
    s.position_w = (float)(!s.plain || one_of(4) != 0);
    random_color(color, 1);
    gl->Color4fv(color);
    gl->Normal3fv(normal);
    draw_vertices(gl, &s);
    if (one_of(2)) {
        gl->PopMatrix();
        draw_vertices(gl, &s);
    }
    gl->Finish();
    end_context(gl);
}

static void lit_pictures_have_the_same_bits(void **state)
{
    (void)state;
    for (int set = 0, n = sets(60); set < n; set++) {
        draw(&fixedgl, set);
        if (!have_osmesa)
            continue;
        draw(&osmesa, set);
        for (int i = 0; i < BOTH_SIZE * BOTH_SIZE * 4; i++) {
            const float a = fixedgl.pixels[i], b = osmesa.pixels[i];
            if (a != b)
                fail_msg("set %d, pixel (%d, %d) component %d: %a, OSMesa %a", set, i / 4 % BOTH_SIZE,
                         i / 4 / BOTH_SIZE, i % 4, (double)a, (double)b);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lit_pictures_have_the_same_bits)};
    return cmocka_run_group_tests(tests, load_both, NULL);
}
