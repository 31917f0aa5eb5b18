/*
 * list: a shell that is one list, called again and again.
 *
 * The list draws one chamber and then turns, shrinks and darkens for the next. A display list is commands,
 * not a picture: what it does to the matrix and the current color stays done.
 *
 *   + -   chambers
 *
 * GL 1.5, 5.4 "Display Lists".
 */
#include <GL/glut.h>
#include <math.h>

enum { CHAMBER = 1, WALL = 2 };

static const float turn = 18, shrink = 0.93f;
static int chambers = 44;

static void place(float distance, float angle)
{
    glVertex2f(distance * cosf(angle), distance * sinf(angle));
}

/* A chamber reaches from the inner to the outer whorl, its far side already as small as the next one's near.
 */
static void make_lists(void)
{
    const float next = turn * 0.0174533f, inner = 0.24f;

    glNewList(WALL, GL_COMPILE);
    glColor3f(0.35f, 0.18f, 0.12f);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i <= 8; i++)
        place(inner + (1 - inner) * (float)i / 8, 0.04f * (float)(i * (8 - i)) / 4);
    place(shrink, next);
    glEnd();
    glEndList();

    glNewList(CHAMBER, GL_COMPILE);
    glBegin(GL_QUADS);
    glColor3f(0.98f, 0.93f, 0.84f);
    place(inner, 0);
    glColor3f(0.93f, 0.62f, 0.36f);
    place(1, 0);
    glColor3f(0.80f, 0.42f, 0.24f);
    place(shrink, next);
    glColor3f(0.96f, 0.86f, 0.74f);
    place(inner * shrink, next);
    glEnd();
    glCallList(WALL); /* a list may call others */
    glRotatef(turn, 0, 0, 1);
    glScalef(shrink, shrink, 1);
    glEndList();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glPushMatrix();
    glTranslatef(-0.2f, 0.02f, 0);
    glRotatef(-40, 0, 0, 1);
    glScalef(1.2f, 1.2f, 1);
    for (int i = 0; i < chambers; i++)
        glCallList(CHAMBER);
    glPopMatrix();
    glutSwapBuffers();
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

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    chambers += 5 * ((key == '+') - (key == '-'));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("list");
    glClearColor(0.12f, 0.22f, 0.28f, 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_LINE_SMOOTH);
    glLineWidth(1.5f);
    make_lists();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
