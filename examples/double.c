/*
 * double: a windmill that turns without a flicker.
 *
 * The picture is drawn in the back buffer while the front buffer is shown; glutSwapBuffers exchanges the two.
 * A timer turns the sails and asks for the next picture.
 *
 *   left button    start
 *   right button   stop
 *   s              one step
 *
 * GL 1.5, 4.2.1 "Selecting a Buffer for Writing" and 2.11.2 "Matrices".
 */
#include <GL/glut.h>

static int angle = 20; /* degrees */
static GLboolean turning;

static void draw_mill(void)
{
    glColor3f(0.30f, 0.45f, 0.30f);
    glRectf(-2, -1, 2, -0.7f);
    glBegin(GL_QUADS);
    glColor3f(0.55f, 0.36f, 0.26f);
    glVertex2f(-0.32f, -0.7f);
    glColor3f(0.36f, 0.22f, 0.18f);
    glVertex2f(0.32f, -0.7f);
    glVertex2f(0.18f, 0.3f);
    glColor3f(0.55f, 0.36f, 0.26f);
    glVertex2f(-0.18f, 0.3f);
    glEnd();
}

static void draw_sail(void)
{
    glColor3f(0.95f, 0.92f, 0.84f);
    glRectf(0.02f, 0.12f, 0.18f, 0.72f);
    glColor3f(0.25f, 0.17f, 0.13f);
    glRectf(-0.02f, 0, 0.02f, 0.75f);
    for (int i = 1; i < 8; i++)
        glRectf(0, 0.09f * (float)i, 0.18f, 0.09f * (float)i + 0.012f);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_mill();
    glPushMatrix();
    glTranslatef(0, 0.3f, 0);
    glRotatef((float)angle, 0, 0, 1);
    for (int i = 0; i < 4; i++) {
        draw_sail();
        glRotatef(90, 0, 0, 1);
    }
    glPopMatrix();
    glutSwapBuffers();
}

static void step(void)
{
    angle = (angle + 3) % 360;
    glutPostRedisplay();
}

static void tick(int value)
{
    if (!turning)
        return;
    step();
    glutTimerFunc(20, tick, value);
}

static void mouse(int button, int state, int x, int y)
{
    (void)x, (void)y;
    if (state != GLUT_DOWN)
        return;
    if (button == GLUT_LEFT_BUTTON && !turning)
        glutTimerFunc(20, tick, 0);
    turning = button == GLUT_LEFT_BUTTON;
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 's')
        step();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-(double)width / height, (double)width / height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("double");
    glClearColor(0.60f, 0.76f, 0.86f, 1);
    glDrawBuffer(GL_BACK); /* the initial value where there are two buffers */
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMouseFunc(mouse);
    glutMainLoop();
    return 0;
}
