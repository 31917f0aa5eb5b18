/*
 * index: a ring and a ball in color index mode, lit.
 *
 * A pixel is a number between 0 and 255, and a colormap says what color that is. Lighting computes the number:
 * each material has a ramp of them, with the unlit color at the start, the fully lit one within, and the
 * highlight at the end. Another colormap makes another picture of the same numbers.
 *
 *   c          next colormap
 *   arrows     turn
 *
 * GL 1.5, 2.14.5 "Color Index Lighting".
 */
#include <GL/glut.h>

/* A ramp: from dark to the color in DIFFUSE steps, from there to white in the rest. */
enum { RAMP = 96, DIFFUSE = 72, BACKGROUND = 0, RING = 16, BALL = RING + RAMP };

static const float schemes[][3][3] = {
        /* background, ring, ball */
        {{0.07f, 0.08f, 0.11f}, {0.90f, 0.55f, 0.25f}, {0.25f, 0.60f, 0.75f}},
        {{0.12f, 0.08f, 0.10f}, {0.75f, 0.30f, 0.45f}, {0.55f, 0.70f, 0.35f}},
        {{0.05f, 0.05f, 0.05f}, {0.75f, 0.75f, 0.75f}, {0.45f, 0.45f, 0.45f}},
};
enum { SCHEMES = sizeof schemes / sizeof *schemes };

static int scheme;
static float turn_x = 35, turn_y = -30;

static void set_ramp(int first, const float color[3])
{
    for (int i = 0; i < RAMP; i++) {
        const float shade = i < DIFFUSE ? 0.10f + 0.90f * (float)i / (DIFFUSE - 1) : 1;
        const float white = i < DIFFUSE ? 0 : (float)(i - DIFFUSE + 1) / (RAMP - DIFFUSE);
        float cell[3];
        for (int c = 0; c < 3; c++)
            cell[c] = shade * color[c] + white * (1 - color[c]);
        glutSetColor(first + i, cell[0], cell[1], cell[2]);
    }
}

static void set_colormap(void)
{
    const float *background = schemes[scheme][0];
    glutSetColor(BACKGROUND, background[0], background[1], background[2]);
    set_ramp(RING, schemes[scheme][1]);
    set_ramp(BALL, schemes[scheme][2]);
}

static void set_material(int ramp)
{
    const GLint indexes[3] = {ramp, ramp + DIFFUSE - 1, ramp + RAMP - 1};
    glMaterialiv(GL_FRONT, GL_COLOR_INDEXES, indexes);
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -6);
    glRotatef(turn_x, 1, 0, 0);
    glRotatef(turn_y, 0, 1, 0);
    set_material(RING);
    glutSolidTorus(0.35, 1.5, 24, 48);
    set_material(BALL);
    glutSolidSphere(0.85, 40, 30);
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)w / h, 1, 20);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'c') {
        scheme = (scheme + 1) % SCHEMES;
        set_colormap();
        glutPostRedisplay();
    }
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    turn_y += 5 * (float)((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    turn_x += 5 * (float)((key == GLUT_KEY_DOWN) - (key == GLUT_KEY_UP));
    glutPostRedisplay();
}

static void init(void)
{
    const GLfloat position[4] = {2, 3, 2, 0}, dim[4] = {0.5f, 0.5f, 0.5f, 1}, lamp[4] = {-3, 1, -2, 1};
    set_colormap();
    glClearIndex(BACKGROUND);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHT1);
    glLightfv(GL_LIGHT1, GL_POSITION, lamp);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, dim);
    glLightfv(GL_LIGHT1, GL_SPECULAR, dim);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_INDEX | GLUT_DEPTH);
    glutInitWindowSize(400, 400);
    glutCreateWindow("index");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
