/*
 * accpersp: a floor of tiles to the horizon, antialiased.
 *
 * Far tiles are smaller than a pixel and would flicker. The mean of several pictures shows them gray. In
 * perspective the whole frustum moves by a fraction of a pixel: its sides by that fraction of the near
 * plane's width and height.
 *
 *   + -            twice, half as many pictures
 *   left, right    walk along
 *
 * GL 1.5, 4.2.4 "The Accumulation Buffer" and 2.11.2 "Matrices" (glFrustum).
 */
#include <GL/glut.h>

static int samples = 8, steps;

static void draw_floor(void)
{
    glBegin(GL_QUADS);
    for (int z = 0; z < 60; z++)
        for (int x = -30; x < 30; x++) {
            if ((x + z) % 2 == 0)
                glColor3f(0.92f, 0.90f, 0.82f);
            else
                glColor3f(0.25f, 0.35f, 0.45f);
            glVertex3i(x, 0, -z);
            glVertex3i(x + 1, 0, -z);
            glVertex3i(x + 1, 0, -z - 1);
            glVertex3i(x, 0, -z - 1);
        }
    glEnd();
}

static void draw_balls(void)
{
    glEnable(GL_LIGHTING);
    for (int i = 0; i < 5; i++) {
        glPushMatrix();
        glTranslatef((float)(i % 2) * 2.4f - 1.2f, 0.6f, -4 - 3 * (float)i);
        glColor3f(0.90f - 0.12f * (float)i, 0.35f + 0.08f * (float)i, 0.25f + 0.12f * (float)i);
        glutSolidSphere(0.6, 40, 30);
        glPopMatrix();
    }
    glDisable(GL_LIGHTING);
}

/* The frustum of a vertical half angle of atan 0.3, moved by (x, y) pixels. */
static void set_frustum(float x, float y)
{
    GLint viewport[4];

    glGetIntegerv(GL_VIEWPORT, viewport);
    const double pixel = 0.6 / viewport[3], right = 0.3 * viewport[2] / viewport[3];
    const double dx = pixel * (double)x, dy = pixel * (double)y;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-right - dx, right - dx, -0.3 - dy, 0.3 - dy, 1, 80);
    glMatrixMode(GL_MODELVIEW);
}

/* The i-th of n points of -1/2 to 1/2: x in equal steps, y the bits of i mirrored at the point. */
static void get_sample(int i, int n, float *x, float *y)
{
    *x = ((float)i + 0.5f) / (float)n - 0.5f;
    *y = -0.5f + 0.5f / (float)n;
    for (float half = 0.5f; i > 0; i /= 2, half /= 2)
        *y += half * (float)(i % 2);
}

static void display(void)
{
    for (int i = 0; i < samples; i++) {
        float x, y;
        get_sample(i, samples, &x, &y);
        set_frustum(x, y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glLoadIdentity();
        gluLookAt(0.25 * steps, 1.5, 2, 0.25 * steps, 0.2, -4, 0, 1, 0);
        draw_floor();
        draw_balls();
        glAccum(i == 0 ? GL_LOAD : GL_ACCUM, 1 / (float)samples);
    }
    glAccum(GL_RETURN, 1);
    glutSwapBuffers();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && samples < 64)
        samples *= 2;
    if (key == '-' && samples > 1)
        samples /= 2;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    steps += (key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT);
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_ACCUM);
    glutInitWindowSize(320, 240);
    glutCreateWindow("accpersp");
    glClearColor(0.60f, 0.74f, 0.85f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 1.5f, 0});
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
