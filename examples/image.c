/*
 * image: a picture made of numbers, and a magnifier for it.
 *
 * The picture is computed, drawn as a block of pixels, and drawn again upside down through a tint. Under the
 * mouse a square of what is in the window is copied, magnified, to the right.
 *
 *   left button   drag: move the square
 *   + -           magnification
 *
 * GL 1.5, 3.6 "Pixel Rectangles" (glDrawPixels, glPixelTransfer, glPixelZoom) and 4.3.3 "Copying Pixels".
 */
#include <GL/glut.h>

enum { SIDE = 110, LENS = 160 };

static GLubyte picture[SIDE][SIDE][3];
static int mouse_x = 68, mouse_y = 196; /* window coordinates, y up */
static float zoom = 5;

static GLubyte byte(float x)
{
    return (GLubyte)(x < 0 ? 0 : x > 1 ? 255 : 255 * x);
}

/* A fractal: how long z^2 + c stays small. */
static void make_picture(void)
{
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            const float cx = 2.6f * (float)x / SIDE - 1.95f, cy = 2.6f * (float)y / SIDE - 1.3f;
            float zx = 0, zy = 0;
            int n = 0;
            for (; n < 40 && zx * zx + zy * zy < 4; n++) {
                const float t = zx * zx - zy * zy + cx;
                zy = 2 * zx * zy + cy;
                zx = t;
            }
            const float v = n == 40 ? 0 : (float)n / 14;
            picture[y][x][0] = byte(0.10f + 1.1f * v * v);
            picture[y][x][1] = byte(0.12f + 0.8f * v);
            picture[y][x][2] = byte(0.20f + 1.6f * v * (1 - 0.6f * v));
        }
}

static void draw_pictures(void)
{
    glRasterPos2i(20, 122);
    glDrawPixels(SIDE, SIDE, GL_RGB, GL_UNSIGNED_BYTE, picture);
    glRasterPos2i(20, 118);
    glPixelZoom(1, -1);
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    glPixelTransferf(GL_BLUE_BIAS, 0.25f);
    glDrawPixels(SIDE, SIDE, GL_RGB, GL_UNSIGNED_BYTE, picture);
    glPixelTransferf(GL_RED_SCALE, 1);
    glPixelTransferf(GL_BLUE_BIAS, 0);
    glPixelZoom(1, 1);
}

static void draw_lens(void)
{
    const int n = (int)(LENS / zoom);

    glRasterPos2i(145, 42);
    glPixelZoom(zoom, zoom);
    glCopyPixels(mouse_x - n / 2, mouse_y - n / 2, n, n, GL_COLOR);
    glPixelZoom(1, 1);
    glColor3f(1, 0.85f, 0.4f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRecti(mouse_x - n / 2, mouse_y - n / 2, mouse_x + n - n / 2, mouse_y + n - n / 2);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_pictures();
    draw_lens();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, width, 0, height);
}

static void motion(int x, int y)
{
    mouse_x = x;
    mouse_y = glutGet(GLUT_WINDOW_HEIGHT) - y;
    glutPostRedisplay();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    zoom += 0.5f * (float)((key == '+') - (key == '-' && zoom > 2));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("image");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); /* rows of 3 * SIDE bytes, without padding */
    make_picture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMotionFunc(motion);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
