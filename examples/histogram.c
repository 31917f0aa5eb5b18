/*
 * histogram: how often each brightness occurs.
 *
 * A lit scene fills the upper part of the window. Its pixels are copied into a histogram that lets none of them
 * through; below, the counts of red, green and blue stand as curves.
 *
 *   left, right   move the light
 *   + -           more or fewer counters
 *
 * GL 1.5, 3.6.3 "Histogram Table Specification", 3.6.5 "Histogram", 6.1.9 (GL_ARB_imaging).
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 360, SCENE = 220, GRAPH = 120, MOST = 256 };

static int angle = 40, counters = 64;

static void draw_scene(void)
{
    static const GLfloat clay[4] = {0.9f, 0.55f, 0.3f, 1}, sky[4] = {0.3f, 0.5f, 0.8f, 1}, white[4] = {1, 1, 1, 1};
    const float a = (float)angle * 0.0174533f;
    const GLfloat position[4] = {2 * sinf(a), 1, 2 * cosf(a), 0};
    glViewport(0, GRAPH, WIDTH, SCENE);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-1.64, 1.64, -1, 1, -2, 2);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 30);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, clay);
    glTranslatef(-0.7f, 0, 0);
    glutSolidSphere(0.75, 60, 40);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, sky);
    glTranslatef(1.5f, 0, 0);
    glRotatef(60, 1, 0, 0);
    glutSolidTorus(0.25, 0.55, 30, 50);
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
}

static void count(GLuint counts[MOST][3])
{
    glHistogram(GL_HISTOGRAM, counters, GL_RGB, GL_TRUE);
    glEnable(GL_HISTOGRAM);
    glWindowPos2i(0, 0);
    glCopyPixels(0, GRAPH, WIDTH, SCENE, GL_COLOR);
    glGetHistogram(GL_HISTOGRAM, GL_TRUE, GL_RGB, GL_UNSIGNED_INT, counts);
    glDisable(GL_HISTOGRAM);
}

/* The logarithms of the counts, which show the rare ones too. */
static void draw_counts(GLuint counts[MOST][3])
{
    glViewport(0, 0, WIDTH, GRAPH);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, counters - 1, 0, 100);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (int c = 0; c < 3; c++) {
        glColor3f(c == 0 ? 1 : 0.25f, c == 1 ? 1 : 0.3f, c == 2 ? 1 : 0.25f);
        glBegin(GL_LINE_STRIP);
        for (int i = 0; i < counters; i++)
            glVertex2f((float)i, 2 + 8.5f * logf(1 + (float)counts[i][c]));
        glEnd();
    }
}

static void display(void)
{
    static GLuint counts[MOST][3];
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_scene();
    count(counts);
    draw_counts(counts);
    glutSwapBuffers();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    angle += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    glutPostRedisplay();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    counters = key == '+' && counters < MOST ? 2 * counters : key == '-' && counters > 8 ? counters / 2 : counters;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(WIDTH, SCENE + GRAPH);
    glutCreateWindow("histogram");
    if (!glutExtensionSupported("GL_ARB_imaging")) {
        fprintf(stderr, "histogram: this OpenGL has no imaging subset\n");
        exit(1);
    }
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_LIGHT0);
    glutDisplayFunc(display);
    glutSpecialFunc(special);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
