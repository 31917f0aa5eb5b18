/*
 * bezmesh: a lit Bezier surface.
 *
 * A sail of four by four control points. glEvalMesh2 fills the grid with triangles; with GL_AUTO_NORMAL the
 * evaluator also makes the normals that lighting needs, from the partial derivatives.
 *
 *   arrows   turn the sail
 *   w        wires or filled
 *
 * GL 1.5, 5.1 "Evaluators".
 */
#include <GL/glut.h>

static const float sail[4][4][3] = {
        {{-1.5f, -1.5f, 0.4f}, {-0.6f, -1.7f, -0.9f}, {0.6f, -1.3f, 1.3f}, {1.4f, -1.6f, 0.2f}},
        {{-1.7f, -0.5f, 1.1f}, {-0.4f, -0.5f, 2.2f}, {0.5f, -0.4f, -1.9f}, {1.7f, -0.6f, 0.9f}},
        {{-1.4f, 0.5f, -0.7f}, {-0.5f, 0.6f, -1.6f}, {0.5f, 0.4f, 2.7f}, {1.5f, 0.5f, -1}},
        {{-1.6f, 1.6f, 0.3f}, {-0.5f, 1.4f, 0.6f}, {0.4f, 1.7f, -0.8f}, {1.5f, 1.5f, 0.5f}},
};
static int pitch = -55, yaw = 25; /* degrees */
static GLenum mode = GL_FILL;

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 0, 1);
    glEvalMesh2(mode, 0, 24, 0, 20);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -6.3f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'w')
        mode = mode == GL_FILL ? GL_LINE : GL_FILL;
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
    glutCreateWindow("bezmesh");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, sail[0][0]);
    glMapGrid2f(24, 0, 1, 20, 0, 1);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_AUTO_NORMAL);
    glFrontFace(GL_CW); /* as the triangles run, seen from where their normals point */
    glEnable(GL_NORMALIZE);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 3, 1});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){0.25f, 0.55f, 0.8f, 1});
    glMaterialfv(GL_BACK, GL_DIFFUSE, (float[]){0.8f, 0.5f, 0.2f, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.9f, 0.9f, 0.9f, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
