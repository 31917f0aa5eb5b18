/*
 * dof: a row of pawns, one of them in focus.
 *
 * The eye moves over the opening of a lens, and the frustum with it so that the plane in focus stays where it
 * is: what lies before or behind it moves in the picture and blurs in the mean of all.
 *
 *   left, right   focus nearer, farther
 *   + -           wider, narrower lens
 *
 * GL 1.5, 4.2.4 "The Accumulation Buffer" and 2.11.2 "Matrices" (glFrustum).
 */
#include <GL/glut.h>
#include <math.h>

enum { SAMPLES = 16, PAWNS = 6 };

static float focus = 6.4f, lens = 0.16f; /* distance from the eye; radius */

static void draw_pawn(void)
{
    glPushMatrix();
    glRotatef(-90, 1, 0, 0);
    glutSolidTorus(0.12, 0.34, 16, 40);
    glutSolidCone(0.36, 1.15, 40, 8);
    glTranslatef(0, 0, 0.72f);
    glutSolidTorus(0.05, 0.17, 16, 40);
    glTranslatef(0, 0, 0.24f);
    glutSolidSphere(0.26, 40, 30);
    glPopMatrix();
}

static void draw_board(void)
{
    glNormal3f(0, 1, 0);
    glBegin(GL_QUADS);
    for (int z = -14; z < 6; z++)
        for (int x = -9; x < 9; x++) {
            if ((x + z) % 2 == 0)
                glColor3f(0.80f, 0.68f, 0.50f);
            else
                glColor3f(0.36f, 0.22f, 0.16f);
            glVertex3i(x, 0, z);
            glVertex3i(x, 0, z + 1);
            glVertex3i(x + 1, 0, z + 1);
            glVertex3i(x + 1, 0, z);
        }
    glEnd();
}

static void draw_scene(void)
{
    draw_board();
    for (int i = 0; i < PAWNS; i++) {
        glPushMatrix();
        glTranslatef(-1.5f + (float)i, 0.1f, 1.5f - 2 * (float)i);
        if (i % 2 == 0)
            glColor3f(0.90f, 0.84f, 0.70f);
        else
            glColor3f(0.55f, 0.16f, 0.14f);
        draw_pawn();
        glPopMatrix();
    }
}

/* The view from (x, y) beside the middle of the lens. */
static void set_view(float x, float y)
{
    GLint viewport[4];

    glGetIntegerv(GL_VIEWPORT, viewport);
    const double top = 0.3, right = top * viewport[2] / viewport[3];
    const double dx = (double)(x / focus), dy = (double)(y / focus); /* on the near plane, at distance 1 */
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-right - dx, right - dx, -top - dy, top - dy, 1, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(-x, -y, 0);
    gluLookAt(0, 2.4, 6.5, 0.2, 0.5, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 1.5f, 0});
}

/* The points of a sunflower: the golden angle apart, and the same area for each. */
static void display(void)
{
    for (int i = 0; i < SAMPLES; i++) {
        const float radius = lens * sqrtf(((float)i + 0.5f) / SAMPLES), angle = 2.399963f * (float)i;
        set_view(radius * cosf(angle), radius * sinf(angle));
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_scene();
        glAccum(i == 0 ? GL_LOAD : GL_ACCUM, 1.0f / SAMPLES);
    }
    glAccum(GL_RETURN, 1);
    glutSwapBuffers();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    lens *= key == '+' ? 1.25f : key == '-' ? 0.8f : 1;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    focus *= key == GLUT_KEY_RIGHT ? 1.25f : key == GLUT_KEY_LEFT ? 0.8f : 1;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_ACCUM);
    glutInitWindowSize(320, 240);
    glutCreateWindow("dof");
    glClearColor(0.30f, 0.34f, 0.40f, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
