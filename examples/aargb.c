/*
 * aargb: a fan of lines, with steps and without.
 *
 * Left, plain lines: a pixel is in or out. Right, antialiased ones: the share of each pixel that the line
 * covers multiplies its alpha, and blending mixes it with what is there.
 *
 *   r     turn
 *   + -   width
 *
 * GL 1.5, 3.4.2 "Other Line Segment Features" (antialiasing) and 4.1.8 "Blending".
 */
#include <GL/glut.h>
#include <stdio.h>

enum { LINES = 15 };

static int angle; /* degrees */
static float width = 1.5f;

static void draw_fan(void)
{
    for (int i = 0; i < LINES; i++) {
        glPushMatrix();
        glRotatef(180.0f * (float)i / LINES + (float)angle, 0, 0, 1);
        glColor3f(0.95f, 0.45f + 0.035f * (float)i, 0.30f);
        glBegin(GL_LINES);
        glVertex2f(0.12f, 0);
        glColor3f(0.35f, 0.60f, 0.95f);
        glVertex2f(0.92f, 0);
        glColor3f(0.95f, 0.45f + 0.035f * (float)i, 0.30f);
        glVertex2f(-0.12f, 0);
        glColor3f(0.35f, 0.60f, 0.95f);
        glVertex2f(-0.92f, 0);
        glEnd();
        glPopMatrix();
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(width);
    glPushMatrix();
    glTranslatef(-1, 0, 0);
    draw_fan();
    glPopMatrix();
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glPushMatrix();
    glTranslatef(1, 0, 0);
    draw_fan();
    glPopMatrix();
    glDisable(GL_BLEND);
    glDisable(GL_LINE_SMOOTH);
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

static void print_widths(void)
{
    GLfloat range[2], step;

    glGetFloatv(GL_LINE_WIDTH_RANGE, range);
    glGetFloatv(GL_LINE_WIDTH_GRANULARITY, &step);
    printf("antialiased lines are %g to %g wide, in steps of %g\n", (double)range[0], (double)range[1],
           (double)step);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 160);
    glutCreateWindow("aargb");
    glClearColor(0.07f, 0.08f, 0.11f, 1);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glHint(GL_LINE_SMOOTH_HINT, GL_NICEST);
    print_widths();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
