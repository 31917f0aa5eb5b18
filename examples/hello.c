/*
 * hello: the least that a program needs.
 *
 * A window, a function that draws it, and the loop that calls the function. There is no matrix but the
 * identity: coordinates run from -1 to 1 in both directions.
 *
 * GL 1.5, 2.6 "Begin/End Paradigm" and 4.2.3 "Clearing the Buffers".
 */
#include <GL/glut.h>

static void draw_sky(void)
{
    glBegin(GL_QUADS);
    glColor3f(0.98f, 0.70f, 0.42f);
    glVertex2f(-1, -0.3f);
    glVertex2f(1, -0.3f);
    glColor3f(0.20f, 0.28f, 0.52f);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
}

static void draw_pyramid(float x, float height)
{
    glBegin(GL_TRIANGLES);
    glColor3f(0.92f, 0.62f, 0.30f); /* the side in the sun */
    glVertex2f(x - height, -0.3f);
    glVertex2f(x + 0.3f * height, -0.3f);
    glVertex2f(x, height - 0.3f);
    glColor3f(0.45f, 0.26f, 0.24f); /* and the other */
    glVertex2f(x + 0.3f * height, -0.3f);
    glVertex2f(x + height, -0.3f);
    glVertex2f(x, height - 0.3f);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_sky();
    draw_pyramid(0.45f, 0.45f);
    draw_pyramid(-0.2f, 0.75f);
    glFlush();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("hello");
    glClearColor(0.62f, 0.44f, 0.28f, 1); /* the sand */
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
