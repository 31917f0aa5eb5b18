/*
 * aaindex: a wheel of lines in color index mode, with steps and without.
 *
 * Without alpha and blending, coverage is told by the index itself: its low four bits are set to how much of
 * the pixel the line covers, so that each color is a ramp of sixteen indexes out of the background. Where lines
 * cross, the last one drawn wins.
 *
 *   r     turn
 *   + -   width
 *
 * GL 1.5, 3.2 "Antialiasing" and 3.4.2 "Other Line Segment Features".
 */
#include <GL/glut.h>

enum { RAMP = 16, COLORS = 5, FIRST = 1, SPOKES = 20, BACKGROUND = 0 }; /* color n: indexes 16 n to 16 n + 15 */

static int angle; /* degrees */
static float width = 2;

static void set_colormap(void)
{
    static const float background[3] = {0.07f, 0.08f, 0.11f};
    static const float color[COLORS][3] = {
            {0.95f, 0.45f, 0.30f}, {0.95f, 0.75f, 0.30f}, {0.45f, 0.80f, 0.45f}, {0.35f, 0.60f, 0.95f}, {0.75f, 0.50f, 0.90f}};
    glutSetColor(BACKGROUND, background[0], background[1], background[2]);
    for (int n = 0; n < COLORS; n++)
        for (int i = 0; i < RAMP; i++) {
            const float t = (float)i / (RAMP - 1);
            float cell[3];
            for (int c = 0; c < 3; c++)
                cell[c] = (1 - t) * background[c] + t * color[n][c];
            glutSetColor(RAMP * (FIRST + n) + i, cell[0], cell[1], cell[2]);
        }
}

static void draw_wheel(int light)
{
    glPushMatrix();
    glRotatef((float)angle, 0, 0, 1);
    for (int i = 0; i < SPOKES; i++) {
        glIndexi(RAMP * (FIRST + i % COLORS) + light);
        glBegin(GL_LINES);
        glVertex2f(0.15f, 0);
        glVertex2f(0.9f, 0.1f);
        glEnd();
        glRotatef(360.0f / SPOKES, 0, 0, 1);
    }
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(width);
    glEnable(GL_LINE_SMOOTH);
    glPushMatrix();
    glTranslatef(1, 0, 0);
    draw_wheel(0); /* coverage takes the place of the low bits */
    glPopMatrix();
    glDisable(GL_LINE_SMOOTH);
    glPushMatrix();
    glTranslatef(-1, 0, 0);
    draw_wheel(RAMP - 1); /* all the light there is in a ramp */
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-2, 2, -2.0 * h / w, 2.0 * h / w);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'r')
        angle += 4;
    width += 0.5f * (float)((key == '+') - (key == '-'));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_INDEX);
    glutInitWindowSize(400, 200);
    glutCreateWindow("aaindex");
    set_colormap();
    glClearIndex(BACKGROUND);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
