/*
 * planet: a sun, a planet that turns and travels, and its moon.
 *
 * Matrices nest like the sky: rotate by the year, go out to the planet, rotate by the day. Push and pop
 * remember the planet's place for the moon. The light is a place too, the sun's, so day and night are where
 * they should be.
 *
 *   d, D   a part of a day forward, back
 *   y, Y   a part of a year forward, back
 *   a      animate: one step each 25 milliseconds, or stop
 *
 * GL 1.5, 2.11.2 "Matrices" (the stack), 2.14.7 "Flatshading" and 3.3 "Points".
 */
#include <GL/glut.h>

static int year = 50, day = 40; /* degrees */
static GLboolean animated;
static GLUquadric *quadric;

static void draw_stars(void)
{
    unsigned random = 1;

    glBegin(GL_POINTS);
    for (int i = 0; i < 120; i++) {
        random = random * 1664525u + 1013904223u;
        glVertex3f((float)(random >> 24) / 8 - 16, (float)(random >> 16 & 255) / 8 - 20, -15);
    }
    glEnd();
}

/* All that shines by itself, or is only a mark. */
static void draw_unlit(void)
{
    glDisable(GL_LIGHTING);
    glColor3f(0.6f, 0.6f, 0.65f);
    draw_stars();
    glColor3f(1, 0.8f, 0.35f);
    gluSphere(quadric, 0.6, 40, 30);
    glPushMatrix();
    glRotatef(90, 1, 0, 0);
    glColor3f(0.25f, 0.27f, 0.34f);
    gluDisk(quadric, 2.19, 2.21, 96, 1); /* the orbit */
    glPopMatrix();
    glEnable(GL_LIGHTING);
}

static void draw_planet_and_moon(void)
{
    glPushMatrix();
    glRotatef((float)year, 0, 1, 0);
    glTranslatef(2.2f, 0, 0);
    glPushMatrix();
    glRotatef((float)day, 0, 1, 0);
    glRotatef(-90, 1, 0, 0); /* the axis of gluSphere is z */
    glColor3f(0.20f, 0.45f, 0.85f);
    gluSphere(quadric, 0.45, 14, 9);
    glPopMatrix();
    glRotatef((float)(6 * year), 0, 1, 0);
    glTranslatef(0.75f, 0, 0);
    glColor3f(0.75f, 0.72f, 0.68f);
    gluSphere(quadric, 0.15, 14, 9);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){0, 0, 0, 1});
    draw_unlit();
    glShadeModel(GL_FLAT); /* the facets show the planet's turning */
    draw_planet_and_moon();
    glShadeModel(GL_SMOOTH);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(36, (double)width / height, 1, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 3.4, 7.5, 0, -0.1, 0, 0, 1, 0);
}

static void step(int days, int years)
{
    day = (day + 10 * days) % 360;
    year = (year + 5 * years) % 360;
    glutPostRedisplay();
}

static void tick(int years)
{
    if (!animated)
        return;
    step(1, years);
    glutTimerFunc(25, tick, years);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'd' || key == 'D')
        step(key == 'd' ? 1 : -1, 0);
    else if (key == 'y' || key == 'Y')
        step(0, key == 'y' ? 1 : -1);
    else if (key == 'a') {
        animated = !animated;
        tick(1);
    }
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("planet");
    glClearColor(0.03f, 0.03f, 0.05f, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    quadric = gluNewQuadric();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
