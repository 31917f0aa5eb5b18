/*
 * lines: widths, and patterns that run along them.
 *
 * Above, lines of growing width. In the middle the stipple patterns, each bit one pixel and then `factor`
 * pixels long. Below, the same zigzag twice: as separate lines, where each starts the pattern anew, and as
 * one strip, where the pattern runs on around the corners.
 *
 *   + -   the factor of the patterns
 *   s     antialiased lines on and off
 *
 * GL 1.5, 3.4 "Line Segments" (3.4.2 stipple and width).
 */
#include <GL/glut.h>

static const GLushort patterns[] = {0x5555, 0x3333, 0x00ff, 0x0f1f, 0x1c47, 0xfe10};
static int factor = 2;

static void draw_line(int x0, int y0, int x1, int y1)
{
    glBegin(GL_LINES);
    glVertex2i(x0, y0);
    glVertex2i(x1, y1);
    glEnd();
}

static void draw_widths(void)
{
    glColor3f(0.95f, 0.80f, 0.40f);
    for (int i = 0; i < 9; i++) {
        glLineWidth(1 + 0.75f * (float)i);
        draw_line(20 + 32 * i, 190, 44 + 32 * i, 225);
    }
    glLineWidth(1);
}

static void draw_patterns(void)
{
    glColor3f(0.55f, 0.85f, 0.75f);
    for (int i = 0; i < 6; i++) {
        glLineStipple(1, patterns[i]);
        draw_line(20, 170 - 14 * i, 150, 170 - 14 * i);
        glLineStipple(factor, patterns[i]);
        draw_line(170, 170 - 14 * i, 300, 170 - 14 * i);
    }
}

static void draw_zigzag(GLenum mode, int y)
{
    glLineWidth(2);
    glLineStipple(factor, 0x18ff);
    glBegin(mode);
    for (int i = 0; i <= 14; i++) {
        glVertex2i(20 + 20 * i, y + 16 * (i % 2));
        if (mode == GL_LINES && i > 0 && i < 14)
            glVertex2i(20 + 20 * i, y + 16 * (i % 2)); /* the next line starts where this one ends */
    }
    glEnd();
    glLineWidth(1);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_widths();
    glEnable(GL_LINE_STIPPLE);
    draw_patterns();
    glColor3f(0.90f, 0.50f, 0.45f);
    draw_zigzag(GL_LINES, 52);
    glColor3f(0.60f, 0.65f, 0.95f);
    draw_zigzag(GL_LINE_STRIP, 18);
    glDisable(GL_LINE_STIPPLE);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, 320, 0, 240);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    factor += (key == '+') - (key == '-' && factor > 1);
    if (key == 's' && glIsEnabled(GL_LINE_SMOOTH))
        glDisable(GL_LINE_SMOOTH);
    else if (key == 's')
        glEnable(GL_LINE_SMOOTH);
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("lines");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_BLEND); /* the coverage of antialiased lines is their alpha */
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
