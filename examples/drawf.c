/*
 * drawf: footprints in the snow, from two bitmaps.
 *
 * A bitmap is drawn at the raster position and then moves it, as a character does: each foot steps ahead of
 * the other. Its color is the current color of the moment the raster position was set.
 *
 *   + -   steps
 *
 * GL 1.5, 3.7 "Bitmaps" and 2.13 "Current Raster Position".
 */
#include <GL/glut.h>

enum { WIDTH = 12, HEIGHT = 16 };

/* A right foot; rows of two bytes, the lowest first. */
static const GLubyte right_foot[HEIGHT][2] = {{0x1e, 0x00}, {0x3f, 0x00}, {0x3f, 0x00}, {0x3f, 0x00},
                                              {0x1e, 0x00}, {0x1e, 0x00}, {0x1f, 0x00}, {0x3f, 0x80},
                                              {0x3f, 0xc0}, {0x7f, 0xe0}, {0x7f, 0xe0}, {0x7f, 0xc0},
                                              {0x3f, 0x00}, {0x00, 0x60}, {0x6c, 0x60}, {0x6d, 0x80}};
static GLubyte left_foot[HEIGHT][2];
static int steps = 11;

static void mirror(void)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            if (right_foot[y][x / 8] & 0x80 >> x % 8) {
                const int to = WIDTH - 1 - x;
                left_foot[y][to / 8] = (GLubyte)(left_foot[y][to / 8] | 0x80 >> to % 8);
            }
}

/* Each step goes ahead by (dx, dy) pixels. */
static void walk(int x, int y, float dx, float dy)
{
    glRasterPos2i(x, y);
    for (int i = 0; i < steps; i++)
        if (i % 2 == 0)
            glBitmap(WIDTH, HEIGHT, 14, 0, dx, dy, &left_foot[0][0]);
        else
            glBitmap(WIDTH, HEIGHT, -2, 0, dx, dy, &right_foot[0][0]);
}

static void draw_snow(void)
{
    glBegin(GL_QUADS);
    glColor3f(0.96f, 0.97f, 0.99f);
    glVertex2i(0, 0);
    glVertex2i(320, 0);
    glColor3f(0.74f, 0.81f, 0.91f);
    glVertex2i(320, 240);
    glVertex2i(0, 240);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_snow();
    glColor3f(0.42f, 0.52f, 0.70f);
    walk(60, 6, 8.5f, 20);
    glColor3f(0.55f, 0.63f, 0.78f);
    walk(290, 6, -11.25f, 20.5f);
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
    steps += (key == '+') - (key == '-');
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("drawf");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    mirror();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
