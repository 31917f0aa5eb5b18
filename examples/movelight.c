/*
 * movelight: a lamp that moves while everything else stands still.
 *
 * A light's position is transformed by the modelview matrix of the moment glLight is called. So the lamp
 * moves when its position is given again, each frame, under the rotation that also draws the bulb. The light
 * gets weaker with distance, as the pool of light on the table shows.
 *
 *   left button   click or drag: the lamp goes around with x, up and down with y
 *
 * GL 1.5, 2.14.1 "Lighting" (positional light, attenuation) and 2.14.2 (transformation of the position).
 */
#include <GL/glut.h>

static float azimuth = -35; /* of the lamp around the vertical axis, degrees, 0 in front */
static float height = 1;    /* of the lamp over the table */

static void draw_lamp(void)
{
    glPushMatrix();
    glRotatef(azimuth, 0, 1, 0);
    glTranslatef(0, height, 1.75f);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){0, 0, 0, 1});
    glDisable(GL_LIGHTING);
    glColor3f(1, 0.95f, 0.75f);
    glutSolidSphere(0.07, 16, 12);
    glEnable(GL_LIGHTING);
    glPopMatrix();
}

static void draw_table(void)
{
    GLUquadric *quadric = gluNewQuadric();

    glPushMatrix();
    glRotatef(-90, 1, 0, 0); /* gluDisk lies in z = 0 */
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.55f, 0.52f, 0.48f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0, 0, 0, 1});
    gluDisk(quadric, 0, 2.4, 72, 40);
    glPopMatrix();
    gluDeleteQuadric(quadric);
}

static void draw_torus(void)
{
    glPushMatrix();
    glTranslatef(0, 1, 0);
    glRotatef(25, 0, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.20f, 0.50f, 0.70f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.7f, 0.7f, 0.7f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glutSolidTorus(0.3, 0.7, 40, 64);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_lamp();
    draw_table();
    draw_torus();
    glutSwapBuffers();
}

static void reshape(int width, int window_height)
{
    glViewport(0, 0, width, window_height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(36, (double)width / window_height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 3.6, 7, 0, 0.55, 0, 0, 1, 0);
}

/* The window's width is one full turn, its height goes from 0.1 (bottom) to 2.4 (top). */
static void aim(int x, int y)
{
    azimuth = 360 * ((float)x / (float)glutGet(GLUT_WINDOW_WIDTH) - 0.5f);
    height = 2.4f - 2.3f * (float)y / (float)glutGet(GLUT_WINDOW_HEIGHT);
    glutPostRedisplay();
}

static void mouse(int button, int state, int x, int y)
{
    if (button == GLUT_LEFT_BUTTON && state == GLUT_DOWN)
        aim(x, y);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("movelight");
    glClearColor(0.06f, 0.06f, 0.08f, 1);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1f);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.08f);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMouseFunc(mouse);
    glutMotionFunc(aim);
    glutMainLoop();
    return 0;
}
