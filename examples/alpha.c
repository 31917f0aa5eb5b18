/*
 * alpha: three panes of colored glass, and why their order counts.
 *
 * A pane covers as much of what is behind it as its alpha says. The last one drawn is on top: with the same
 * panes in another order the middle has another color. Added instead, light on light, order is of no matter.
 *
 *   o     next order
 *   b     blend function: over, add
 *   + -   alpha
 *
 * GL 1.5, 4.1.8 "Blending".
 */
#include <GL/glut.h>
#include <math.h>

static const float colors[3][3] = {{0.95f, 0.35f, 0.25f}, {0.30f, 0.75f, 0.40f}, {0.25f, 0.45f, 0.95f}};
static int first;
static GLboolean added;
static float alpha = 0.65f;

static void draw_backdrop(void)
{
    glDisable(GL_BLEND);
    glColor3f(0.20f, 0.22f, 0.28f);
    for (int i = -8; i < 8; i++)
        glRectf(0.2f * (float)i, -1, 0.2f * (float)i + 0.1f, 1);
    glEnable(GL_BLEND);
}

static void draw_pane(int i)
{
    const float x = 0.35f * cosf(1.5708f + 2.0944f * (float)i),
                y = 0.35f * sinf(1.5708f + 2.0944f * (float)i);

    glColor4f(colors[i][0], colors[i][1], colors[i][2], alpha);
    glBegin(GL_POLYGON);
    for (int k = 0; k < 64; k++)
        glVertex2f(x + 0.52f * cosf(0.0981748f * (float)k), y + 0.52f * sinf(0.0981748f * (float)k));
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_backdrop();
    glBlendFunc(GL_SRC_ALPHA, added ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 3; i++)
        draw_pane((first + i) % 3);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-(double)width / height, (double)width / height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case 'o': first = (first + 1) % 3; break;
    case 'b': added = !added; break;
    case '+': alpha += 0.05f; break;
    case '-': alpha -= 0.05f; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("alpha");
    glClearColor(0.12f, 0.13f, 0.17f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
