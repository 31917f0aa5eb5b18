/*
 * light: the smallest lit scene, one light on one sphere.
 *
 * The light has w = 0, so it is a direction and not a place: every point of the sphere sees it from the upper
 * left. The highlight is where the normal comes near the half vector between light and viewer; the shininess
 * says how near.
 *
 *   + and -   double or halve the shininess (1 to 128)
 *
 * GL 1.5, 2.14.1 "Lighting" and 2.14.2 "Lighting Parameter Specification".
 */
#include <GL/glut.h>

static float shininess = 32;

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMaterialf(GL_FRONT, GL_SHININESS, shininess);
    glutSolidSphere(1, 64, 48);
    glFlush();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(30, (double)width / height, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && shininess < 128)
        shininess *= 2;
    else if (key == '-' && shininess > 1)
        shininess /= 2;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1, 1, 0}); /* modelview is the identity: eye space */
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.85f, 0.30f, 0.20f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.8f, 0.8f, 0.7f, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("light");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
