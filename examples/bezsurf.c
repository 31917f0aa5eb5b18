/*
 * bezsurf: a Bezier surface as curves on it.
 *
 * One call of glEvalCoord2f gives one vertex, wherever on the surface it is wanted: here along six curves in
 * each direction, finely, in colors that come from an evaluator of their own. The control net stands around
 * the surface in gray.
 *
 *   arrows   turn the surface
 *   n        control net on and off
 *
 * GL 1.5, 5.1 "Evaluators".
 */
#include <GL/glut.h>

enum { CURVES = 6, STEPS = 40 };

/* A saddle with one corner drawn up: order 3 in u, 4 in v. */
static const float net[4][3][3] = {
        {{-1.5f, 0.9f, -1.5f}, {0, -0.6f, -1.8f}, {1.5f, 1.9f, -1.5f}},
        {{-1.7f, -0.7f, -0.5f}, {0, 0.3f, -0.5f}, {1.7f, -0.9f, -0.5f}},
        {{-1.6f, -0.6f, 0.5f}, {0, 1.1f, 0.6f}, {1.6f, -0.8f, 0.5f}},
        {{-1.5f, 1, 1.5f}, {0, -1.2f, 1.6f}, {1.5f, 0.8f, 1.5f}},
};
static const float colors[2][2][4] = {
        {{0.95f, 0.3f, 0.25f, 1}, {0.95f, 0.85f, 0.3f, 1}},
        {{0.3f, 0.4f, 0.95f, 1}, {0.3f, 0.95f, 0.6f, 1}},
};
static int pitch = 30, yaw = 35; /* degrees */
static GLboolean show_net = GL_TRUE;

static void draw_curves(void)
{
    for (int i = 0; i < CURVES; i++) {
        const float at = (float)i / (CURVES - 1);
        glBegin(GL_LINE_STRIP);
        for (int j = 0; j <= STEPS; j++)
            glEvalCoord2f((float)j / STEPS, at);
        glEnd();
        glBegin(GL_LINE_STRIP);
        for (int j = 0; j <= STEPS; j++)
            glEvalCoord2f(at, (float)j / STEPS);
        glEnd();
    }
}

static void draw_net(void)
{
    glColor3f(0.45f, 0.47f, 0.52f);
    for (int i = 0; i < 4; i++) {
        glBegin(GL_LINE_STRIP);
        for (int j = 0; j < 3; j++)
            glVertex3fv(net[i][j]);
        glEnd();
    }
    for (int j = 0; j < 3; j++) {
        glBegin(GL_LINE_STRIP);
        for (int i = 0; i < 4; i++)
            glVertex3fv(net[i][j]);
        glEnd();
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 1, 0);
    if (show_net)
        draw_net();
    draw_curves();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(38, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, -0.3f, -7.6f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'n')
        show_net = !show_net;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case GLUT_KEY_LEFT: yaw -= 10; break;
    case GLUT_KEY_RIGHT: yaw += 10; break;
    case GLUT_KEY_UP: pitch -= 10; break;
    case GLUT_KEY_DOWN: pitch += 10; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("bezsurf");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 4, net[0][0]);
    glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, colors[0][0]);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_MAP2_COLOR_4);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
