/* Matrix commands against Mesa's OSMesa: after random sequences of them, glGetFloatv gives the same bits. */
#include "both.h"

static void command(const struct gl *gl, int *depth)
{
    float m[16];
    const float x = between(-2, 2), y = between(-2, 2), z = between(-2, 2);

    switch (one_of(12)) {
    case 0: gl->LoadIdentity(); break;
    case 1:
    case 2:
        for (int i = 0; i < 16; i++)
            m[i] = i % 5 == 0 ? 1 : one_of(3) ? 0 : between(-1, 1);
        (one_of(2) ? gl->LoadMatrixf : gl->MultMatrixf)(m);
        break;
    case 3: gl->Rotatef(between(-360, 360), one_of(2) ? x : 0, one_of(2) ? y : 0, one_of(2) ? z : 0); break;
    case 4: gl->Rotatef((float)(90 * one_of(5)), x, y, z); break;
    case 5:
        gl->Rotatef(between(-1, 1), x * 1e-4f, 0, y * 1e-4f);
        break; /* around the least length of an axis */
    case 6: gl->Translatef(x, y, z); break;
    case 7: gl->Scalef(x, one_of(2) ? x : y, one_of(2) ? x : z); break;
    case 8:
        gl->Frustum((double)x - 3, (double)x + 1.1, (double)y - 2.7, (double)y + 3,
                    0.1 + (double)between(0, 1), 17.3);
        break;
    case 9:
        gl->Ortho((double)x - 3, (double)x + 1.1, (double)y - 2.7, (double)y + 3, (double)z - 5,
                  (double)z + 1);
        break;
    case 10:
        if (*depth < 8) {
            gl->PushMatrix();
            ++*depth;
        }
        break;
    default:
        if (*depth > 0) {
            gl->PopMatrix();
            --*depth;
        }
        break;
    }
}

/* Sixteen sequences, each on one of the stacks; out: the matrix after each. */
static void run(struct gl *gl, int set, float out[16][16])
{
    static const GLenum mode[3] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
    static const GLenum query[3] = {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX};
    const int stack = set % 3;
    int depth = 0;

    random_seed(set);
    begin_context(gl);
    gl->MatrixMode(mode[stack]);
    for (int i = 0; i < 16; i++) {
        for (int k = one_of(6); k >= 0; k--)
            command(gl, &depth);
        gl->GetFloatv(query[stack], out[i]);
    }
    end_context(gl);
}

static void matrices_have_the_same_bits(void **state)
{
    static float ours[16][16], theirs[16][16];
    (void)state;

    for (int set = 0, n = sets(90); set < n; set++) {
        run(&fixedgl, set, ours);
        if (!have_osmesa)
            continue;
        run(&osmesa, set, theirs);
        for (int i = 0; i < 16; i++)
            for (int e = 0; e < 16; e++) {
                const float a = ours[i][e], b = theirs[i][e];
                if (memcmp(&a, &b, sizeof a) != 0 && !(a != a && b != b))
                    fail_msg("set %d, matrix %d, element %d: %a, OSMesa %a", set, i, e, (double)a, (double)b);
            }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(matrices_have_the_same_bits)};
    return cmocka_run_group_tests(tests, load_both, NULL);
}
