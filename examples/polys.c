/*
 * polys: an etching, from patterns that lie under polygons.
 *
 * A polygon stipple is a mask of 32 by 32 pixels, fixed to the window: the polygon shows where bits are set.
 * The masks are made here: grays of 1 to 16 sixteenths from an ordered dither, and hatching.
 *
 *   + -   a darker, a lighter sky
 *
 * GL 1.5, 3.5.2 "Stippling".
 */
#include <GL/glut.h>
#include <math.h>

static int darkest = 13; /* of the sky, in sixteenths of ink */

/* A 4 by 4 threshold matrix, repeated over the mask: `ink` of each 16 bits are set. */
static void use_gray(int ink)
{
    static const int threshold[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    GLubyte mask[32][4];

    for (int y = 0; y < 32; y++) {
        unsigned bits = 0;
        for (int x = 0; x < 4; x++)
            bits = bits << 1 | (threshold[y % 4][x] < ink);
        for (int i = 0; i < 4; i++)
            mask[y][i] = (GLubyte)(bits << 4 | bits);
    }
    glPolygonStipple(&mask[0][0]);
}

/* Strokes `thick` pixels wide every eight, rising to the right or falling. */
static void use_hatching(int thick, int direction)
{
    GLubyte mask[32][4] = {{0}};

    for (int y = 0; y < 32; y++)
        for (int x = 0; x < 32; x++)
            if (((x - direction * y) & 7) < thick)
                mask[y][x / 8] = (GLubyte)(mask[y][x / 8] | 0x80 >> x % 8);
    glPolygonStipple(&mask[0][0]);
}

static void draw_sky(void)
{
    for (int i = 0; i < 16; i++) {
        use_gray(1 + (darkest - 1) * i / 15);
        glRecti(0, 90 + 10 * i, 320, 100 + 10 * i);
    }
}

static void draw_disk(float x, float y, float radius)
{
    glBegin(GL_POLYGON);
    for (int i = 0; i < 48; i++)
        glVertex2f(x + radius * cosf(0.1309f * (float)i), y + radius * sinf(0.1309f * (float)i));
    glEnd();
}

static void draw_hill(float x, float top, int thick)
{
    use_hatching(thick, 1);
    glBegin(GL_TRIANGLES);
    glVertex2f(x - 110, 90);
    glVertex2f(x + 10, 90);
    glVertex2f(x, top);
    glEnd();
    use_hatching(thick + 3, -1);
    glBegin(GL_TRIANGLES);
    glVertex2f(x + 10, 90);
    glVertex2f(x + 90, 90);
    glVertex2f(x, top);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_POLYGON_STIPPLE);
    glColor3f(0.16f, 0.18f, 0.30f);
    draw_sky();
    draw_hill(215, 170, 2);
    draw_hill(110, 150, 3);
    for (int i = 0; i < 9; i++) { /* the lake */
        use_gray(3 + i);
        glRecti(0, 80 - 10 * i, 320, 90 - 10 * i);
    }
    glDisable(GL_POLYGON_STIPPLE);
    glColor3f(0.95f, 0.90f, 0.78f);
    draw_disk(70, 195, 22);
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
    darkest += (key == '+' && darkest < 16) - (key == '-' && darkest > 1);
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("polys");
    glClearColor(0.95f, 0.90f, 0.78f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
