/*
 * spot-attenuation: the five numbers that shape a spot light.
 *
 * A spot hangs over a floor and a ball. Exponent and cutoff shape its cone; the three attenuation factors say
 * how it fades with distance. The bars show the values, from 0 to their largest; each is a clear within a
 * scissor rectangle.
 *
 *   e, E   exponent more, less (yellow)       a, A   cutoff angle (orange)
 *   c, C   constant factor (red)              l, L   linear (green)        q, Q   quadratic (blue)
 *
 * GL 1.5, 2.14.1 "Lighting" (spot light effect, attenuation) and 4.1.2 "Scissor Test".
 */
#include <GL/glut.h>

enum { BARS = 5, CELLS = 90 };

static struct {
    char less, more; /* keys */
    GLenum name;
    float value, step, least, most;
    float color[3];
} bars[BARS] = {
        {'E', 'e', GL_SPOT_EXPONENT, 24, 8, 0, 128, {0.90f, 0.80f, 0.25f}},
        {'A', 'a', GL_SPOT_CUTOFF, 30, 5, 5, 85, {0.90f, 0.50f, 0.15f}},
        {'C', 'c', GL_CONSTANT_ATTENUATION, 0.5f, 0.25f, 0.25f, 4, {0.85f, 0.25f, 0.25f}},
        {'L', 'l', GL_LINEAR_ATTENUATION, 0, 0.125f, 0, 2, {0.30f, 0.75f, 0.35f}},
        {'Q', 'q', GL_QUADRATIC_ATTENUATION, 0.0625f, 0.0625f, 0, 1, {0.30f, 0.50f, 0.95f}},
};

/* Lighting is computed at vertices: a floor that is to show the edge of a cone needs many. */
static void draw_floor(void)
{
    const float size = 6.0f / CELLS;

    glNormal3f(0, 1, 0);
    for (int row = 0; row < CELLS; row++) {
        glBegin(GL_QUAD_STRIP);
        for (int column = 0; column <= CELLS; column++) {
            glVertex3f((float)column * size - 3, 0, (float)row * size - 3);
            glVertex3f((float)column * size - 3, 0, (float)(row + 1) * size - 3);
        }
        glEnd();
    }
}

static void draw_ball(void)
{
    glPushMatrix();
    glTranslatef(0.35f, 0.6f, 0.1f);
    glutSolidSphere(0.6, 80, 60);
    glPopMatrix();
}

static void draw_bars(int width, int height)
{
    const int line = height / 36 + 1, left = width / 30;

    glPushAttrib(GL_SCISSOR_BIT | GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < BARS; i++) {
        const float length = (float)width * 0.4f * bars[i].value / bars[i].most;
        glScissor(left, height - 2 * line * (i + 1), 2 + (int)length, line);
        glClearColor(bars[i].color[0], bars[i].color[1], bars[i].color[2], 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glPopAttrib();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1.1f, 2.7f, 1.5f, 1});
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (float[]){0.45f, -1, -0.5f});
    for (int i = 0; i < BARS; i++)
        glLightf(GL_LIGHT0, bars[i].name, bars[i].value);
    draw_floor();
    draw_ball();
    draw_bars(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(36, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 4.2, 6.2, 0, 0.35, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    for (int i = 0; i < BARS; i++) {
        if (key == bars[i].more && bars[i].value < bars[i].most)
            bars[i].value += bars[i].step;
        if (key == bars[i].less && bars[i].value > bars[i].least)
            bars[i].value -= bars[i].step;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("spot-attenuation");
    glClearColor(0.04f, 0.04f, 0.06f, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (float[]){0.25f, 0.27f, 0.35f, 1});
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (float[]){1, 0.95f, 0.85f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.6f, 0.6f, 0.6f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 48);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
